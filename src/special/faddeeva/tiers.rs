//! Cheaper tiers of w: one minimax polynomial each for the whole upper half plane.

use super::super::faddeeva_tables::{COARSE, COARSE_POLE, FINE, FINE_POLE, MEDIUM, MEDIUM_POLE};
use super::quadrant::{HUGE, asymptotic};
use super::{at_infinity, mirrored, reflected};
use crate::numeric::complex_polynomial::{Pair, in_four, product};
use num_complex::Complex;

/// P(v)/(zeta + L) with zeta = y - i x and v = (L - zeta)/(L + zeta), for finite x >= 0, y >= 0.
#[inline(always)]
pub(super) fn upper<const N: usize>(coefficients: &[f64; N], pole: f64, x: f64, y: f64) -> Pair {
    let d = y + pole;
    let inverse = 1.0 / (d * d + x * x);
    let q = (d * inverse, x * inverse);
    let v = (2.0 * pole * q.0 - 1.0, 2.0 * pole * q.1);
    product(q, in_four(coefficients, v))
}

/// A tier in the whole plane.
#[inline(always)]
fn in_the_plane<const N: usize>(coefficients: &[f64; N], pole: f64, z: Complex<f64>) -> Complex<f64> {
    let (x, y) = (z.re.abs(), z.im.abs());
    if !(x < f64::INFINITY && y < f64::INFINITY) {
        return at_infinity(z);
    }
    let above = if x.max(y) < HUGE {
        upper(coefficients, pole, x, y)
    } else {
        asymptotic(x, y)
    };
    let value = if z.im < 0.0 { reflected(x, y, above) } else { above };
    mirrored(value, z.re)
}

/// Returns w(z) within 1e-10 |w(z)| in the upper half plane.
///
/// The domain, limits and symmetry of [`faddeeva_w`](super::faddeeva_w). In the lower half plane the error is relative to
/// the larger of |w(z)| and |w(-z)|: the zeros there are not treated apart.
#[must_use]
#[inline]
pub fn faddeeva_w_fine(z: Complex<f64>) -> Complex<f64> {
    in_the_plane(&FINE, FINE_POLE, z)
}

/// Returns w(z) within 4e-7 |w(z)| in the upper half plane.
///
/// The domain, limits and symmetry of [`faddeeva_w`](super::faddeeva_w). In the lower half plane the error is relative to
/// the larger of |w(z)| and |w(-z)|: the zeros there are not treated apart.
#[must_use]
#[inline]
pub fn faddeeva_w_medium(z: Complex<f64>) -> Complex<f64> {
    in_the_plane(&MEDIUM, MEDIUM_POLE, z)
}

/// Returns w(z) within 5e-5 |w(z)| in the upper half plane.
///
/// The domain, limits and symmetry of [`faddeeva_w`](super::faddeeva_w). In the lower half plane the error is relative to
/// the larger of |w(z)| and |w(-z)|: the zeros there are not treated apart.
#[must_use]
#[inline]
pub fn faddeeva_w_coarse(z: Complex<f64>) -> Complex<f64> {
    in_the_plane(&COARSE, COARSE_POLE, z)
}
