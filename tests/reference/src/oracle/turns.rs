//! The integral of sinc squared between pi w xi0 and pi w xi1, with the products formed in three parts.
//!
//! The arc between the leading parts, and what the lower parts add: three terms of the Taylor series of the integrand
//! at each end. The third term and the third part of pi count where an arc begins at a double zero of the integrand.

use super::double_double::{Dd, two_product, two_sum};
use super::reduction::sin_cos;
use super::sinc_squared_integral;
use crate::metrics::Reference;

/// pi in three parts.
const PI: [f64; 3] = [std::f64::consts::PI, 1.2246467991473532e-16, -2.9947698097183397e-33];

/// pi w xi as a leading part and what it lacks.
fn end(width: f64, xi: f64) -> (f64, Dd) {
    let product = two_product(width, xi);
    let first = two_product(PI[0], product.hi);
    let second = two_product(PI[1], product.hi);
    let third = second.lo + PI[2] * product.hi;
    let rest = two_sum(first.lo, second.hi) + third + two_product(PI[0], product.lo) + PI[1] * product.lo;
    (first.hi, rest)
}

/// The integral of sinc squared from `q` to `q` + `rest`, to the third order in the rest.
pub(super) fn beyond((q, rest): (f64, Dd)) -> Dd {
    if q.abs() < 1e-12 {
        // The integrand is 1 to more digits than the rest has.
        return rest;
    }
    let (sine, cosine) = sin_cos(q);
    let sinc = sine / q;
    let slope = (cosine - sinc) / q;
    let curvature = -sinc - slope / q * 2.0;
    let third = (slope.square() + sinc * curvature) / 3.0;
    rest * (sinc.square() + rest * (sinc * slope + rest * third))
}

/// The integral of sinc squared from pi `width` `xi0` to pi `width` `xi1`; NaN where a product is NaN.
pub fn sinc_squared_integral_turns(width: f64, xi0: f64, xi1: f64) -> Reference {
    if width * xi0 == width * xi1 {
        return Reference::exact(0.0);
    }
    let (end0, end1) = (end(width, xi0), end(width, xi1));
    let arc = sinc_squared_integral(end0.0, end1.0);
    let ordinary = |q: f64| q == 0.0 || (1e-150..1e150).contains(&q.abs());
    if !ordinary(end0.0) || !ordinary(end1.0) || arc.exponent != 0 {
        return arc;
    }
    (Dd::new(arc.hi, arc.lo) + (beyond(end1) - beyond(end0))).into()
}
