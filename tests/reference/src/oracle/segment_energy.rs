//! The energy of a segment: the integral of |eta|^2 over all places of the window, to about 22 digits.
//!
//! 2 pi sigma^2 int_0^L (L - u) exp(-u^2/(4 sigma^2)) cos(2 pi u xi1/lambda) du. With u = 2 sigma t, T = L/(2 sigma) and
//! beta = 2 pi sigma xi1/lambda it is 4 pi sigma^4 K(T, beta), K = Re{sqrt(pi) (T + i beta) E(0, T, beta) - 1 +
//! exp(-T^2 - 2 i beta T)}, E the scaled erf difference. Short segments: Gauss-Legendre on
//! K = 2 T^2 int_0^1 (1 - s) exp(-T^2 s^2) cos(2 beta T s) ds.

use super::arc::gauss_legendre;
use super::double_double::{Dd, two_product};
use super::scaled::{Scaled, TWO_OVER_ROOT_PI, exponential, sin_cos};
use super::spatial_phase::erf_difference;
use super::turn_fraction::{PI, sin_cos_of_turns, turn_fraction};
use crate::metrics::Reference;
use std::sync::LazyLock;

/// T and beta T up to which the Gauss rule is used.
const SHORT: f64 = 2.0;
static RULE: LazyLock<Vec<(Dd, Dd)>> = LazyLock::new(|| gauss_legendre(36));

/// The energy of the row sigma, lambda, xi1, length; infinite for an infinite length. NaN for NaN, for other infinities,
/// for a negative length and unless sigma and lambda are positive.
pub fn segment_energy(row: &[f64]) -> Reference {
    let &[sigma, lambda, xi1, length] = row else {
        panic!("a row of 4: {row:?}")
    };
    let finite = row[..3].iter().all(|x| x.is_finite());
    if !finite || sigma <= 0.0 || lambda <= 0.0 || length.is_nan() || length < 0.0 {
        return Reference::exact(f64::NAN);
    }
    if length == 0.0 || length.is_infinite() {
        return Reference::exact(length);
    }
    let t = Scaled::from(length) * Scaled::from(Dd::ONE / sigma).shift(-1);
    let beta = two_product(sigma, xi1) * PI.scale(2.0) / lambda;
    let kernel = if t.size() < -900 || (t.value().hi <= SHORT && (beta.hi * t.value().hi).abs() <= SHORT) {
        short(t, beta)
    } else {
        long(t.value(), beta, turn_fraction(two_product(length, xi1), lambda))
    };
    let square = Scaled::from(two_product(sigma, sigma));
    (kernel * square * square * Scaled::from(PI).shift(2)).reference()
}

fn short(t: Scaled, beta: Dd) -> Scaled {
    // Below 2^-900 the integrand is 1 - s.
    let length = if t.size() < -900 { Dd::ZERO } else { t.value() };
    let (square, phase) = (length.square(), (beta * length).scale(2.0));
    let mut sum = Dd::ZERO;
    for &(node, weight) in RULE.iter() {
        let angle = phase * node;
        let (_, cosine) = sin_cos(&[angle.hi, angle.lo]);
        let window = exponential(-(square * node.square())).value();
        sum = sum + weight * (Dd::ONE - node) * window * cosine;
    }
    t * t * Scaled::from(sum).shift(1)
}

/// `turns` is beta T/pi without its whole parts.
fn long(t: Dd, beta: Dd, turns: Dd) -> Scaled {
    let difference = erf_difference(Dd::ZERO, t, beta);
    let root_pi = PI * TWO_OVER_ROOT_PI.scale(0.5);
    let (_, cosine) = sin_cos_of_turns(turns);
    let part = difference.re * t.into() + -(difference.im * beta.into());
    part * root_pi.into() + exponential(-t.square()) * cosine.into() + Scaled::from(-1.0)
}
