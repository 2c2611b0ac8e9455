//! The spatial phase eta of a scratch (VWH18 Eq. 5), to about 25 digits of its modulus.
//!
//! eta = sqrt(pi/2) sigma exp(-s_b^2/(2 sigma^2)) exp(-2 pi i s_b xi2/lambda) E(a1, a2, b) with
//! E = exp(-b^2) [erf(a2 + ib) - erf(a1 + ib)], a = (s_t + l)/(sqrt2 sigma), b = sqrt2 pi sigma xi1/lambda. The arguments
//! are no f64: E at the nearest f64 by [`erf_difference_scaled`], and the rest by its Taylor series to the second order.

use super::double_double::{Dd, two_product, two_sum};
use super::erf_difference::erf_difference_scaled;
use super::scaled::TWO_OVER_ROOT_PI;
use super::scaled_complex::ScaledComplex;
use super::turn_fraction::{sin_cos_of_turns, turn_fraction};
use crate::metrics::Reference;

/// 1/sqrt 2.
const ONE_OVER_ROOT_TWO: Dd = Dd::new(std::f64::consts::FRAC_1_SQRT_2, -4.833646656726457e-17);
/// sqrt 2 pi.
const ROOT_TWO_PI: Dd = Dd::new(4.442882938158366, 1.452273931226085e-16);
/// sqrt(pi/2).
const ROOT_HALF_PI: Dd = Dd::new(1.2533141373155003, -9.164289990229583e-17);
/// |a| from which exp(-a^2) counts as nothing.
const NOTHING: f64 = 1e3;

/// (2/sqrt pi) exp(-a^2 - 2iab), the integrand of E at a.
fn integrand(a: f64, b: f64) -> ScaledComplex {
    if a.abs() > NOTHING {
        return ScaledComplex::ZERO;
    }
    let rotation = ScaledComplex::rotation(two_product(2.0 * a, b));
    rotation.times_exponential(-two_product(a, a)) * TWO_OVER_ROOT_PI
}

/// exp(-b^2) [erf(a2 + ib) - erf(a1 + ib)] for finite b; `a1` and `a2` may be infinite.
pub fn erf_difference(a1: Dd, a2: Dd, b: Dd) -> ScaledComplex {
    let at = ScaledComplex::from_references(erf_difference_scaled(a1.hi, a2.hi, b.hi));
    if a1.lo == 0.0 && a2.lo == 0.0 && b.lo == 0.0 {
        return at;
    }
    let real = |x: f64| Dd::from(x);
    // The share of one end: the integrand g times d (1 - (a + ib) d), and the mixed derivative -2iag d e, e the rest of b.
    let end = |a: Dd| {
        let (g, d) = (integrand(a.hi, b.hi), a.lo);
        if a.hi.abs() > NOTHING || d == 0.0 {
            return (g, ScaledComplex::ZERO);
        }
        let factor = ScaledComplex::new(
            Dd::ONE - two_product(a.hi, d),
            -two_product(b.hi, d) - two_product(a.hi, b.lo).scale(2.0),
        );
        (g, g * factor * real(d))
    };
    let ((g1, moved1), (g2, moved2)) = (end(a1), end(a2));
    let mut total = at + moved2 + -moved1;
    if b.lo != 0.0 {
        let step = g2 + -g1;
        // The integrals of t g and t^2 g, from g' = -2 (t + ib) g.
        let first = -(step * real(0.5)) + -(at.times_i() * real(b.hi));
        let weighted = |a: Dd, g: ScaledComplex| {
            if a.hi.abs() > NOTHING {
                ScaledComplex::ZERO
            } else {
                g * real(a.hi)
            }
        };
        let boundary = weighted(a2, g2) + -weighted(a1, g1);
        let second = (at + -boundary + -(first.times_i() * real(2.0 * b.hi))) * real(0.5);
        total = total + -(first.times_i() * real(2.0 * b.lo)) + -(second * two_product(b.lo, b.lo).scale(2.0));
    }
    total
}

/// An end of the scratch from the window's centre, over sqrt2 sigma.
fn end(s_t: f64, l: f64, sigma: f64) -> Dd {
    let distance = s_t + l;
    if distance.is_infinite() {
        return distance.into();
    }
    two_sum(s_t, l) * ONE_OVER_ROOT_TWO / sigma
}

/// eta of the row sigma, lambda, xi1, xi2, s_t, s_b, l1, l2: infinite ends allowed, NaN for NaN, for other infinities, and
/// unless sigma and lambda are positive.
pub fn spatial_phase(row: &[f64]) -> [Reference; 2] {
    let &[sigma, lambda, xi1, xi2, s_t, s_b, l1, l2] = row else {
        panic!("a row of 8: {row:?}")
    };
    let finite = row[..6].iter().all(|x| x.is_finite());
    if !finite || l1.is_nan() || l2.is_nan() || sigma <= 0.0 || lambda <= 0.0 {
        return [Reference::exact(f64::NAN); 2];
    }
    let b = two_product(sigma, xi1) * ROOT_TWO_PI / lambda;
    let difference = erf_difference(end(s_t, l1, sigma), end(s_t, l2, sigma), b);
    let (sine, cosine) = sin_cos_of_turns(turn_fraction(two_product(s_b, xi2), lambda));
    let away = Dd::from(s_b) / sigma;
    let window = -away.square().scale(0.5);
    let value = difference * ScaledComplex::new(cosine, -sine) * (ROOT_HALF_PI * sigma);
    value.times_exponential(window).references()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::oracle::turn_fraction::PI;

    #[test]
    fn the_constants_are_what_their_names_say() {
        let two = ONE_OVER_ROOT_TWO.square().scale(2.0);
        assert!((two - Dd::ONE).hi.abs() < 1e-31, "{two:?}");
        assert!((ROOT_TWO_PI * ONE_OVER_ROOT_TWO - PI).hi.abs() < 1e-31);
        assert!((ROOT_HALF_PI.square().scale(2.0) - PI).hi.abs() < 1e-31);
    }
}
