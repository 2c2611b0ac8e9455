//! The entire cosine integral Cin.
//!
//! # Definition
//!
//! Cin(x) = int_0^x (1 - cos t)/t dt = gamma + ln x - Ci(x) (DLMF 6.2.12): what the odd half of a wave under sinc^2 needs,
//! as Si is what the even half does.
//!
//! # Methods
//!
//! The cells of the sine integral, which hold Cin(x)/x, and its auxiliary functions beyond. For the lights of
//! [`light`](crate::light), without a promise of its own: the test below holds its digits.

use super::cells::{auxiliary, cell};
use super::tables::{CIN, TAIL};
use crate::numeric::phase::{reduce_half_turns, sine_cosine};

/// Euler's constant.
const EULER: f64 = 0.5772156649015329;

/// Returns Cin(x), even in x; NaN for NaN.
#[inline]
pub(crate) fn cosine_integral_entire(x: f64) -> f64 {
    let x = x.abs();
    if x < TAIL {
        let (base, constant, rest) = cell(&CIN, 0.25, x);
        return x * (base + (constant + rest));
    }
    let (r, odd) = reduce_half_turns(x);
    let (sine, cosine) = sine_cosine(r);
    let w = 1.0 / (x * x);
    let (a, b) = auxiliary(w);
    let wave = (1.0 - w * a) / x * sine - w * (1.0 - w * b) * cosine;
    EULER + libm::log(x) - f64::from_bits(wave.to_bits() ^ odd)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numeric::gauss::SIXTEEN_POINTS;

    /// By panels of a quarter of a turn.
    fn quadrature(x: f64) -> f64 {
        let count = libm::ceil(x / core::f64::consts::FRAC_PI_2) as usize;
        let half = 0.5 * x / count as f64;
        let mut sum = 0.0;
        for i in 0..count {
            for [node, weight] in SIXTEEN_POINTS {
                for s in [node, -node] {
                    let t = (2 * i + 1) as f64 * half + half * s;
                    let sine = libm::sin(0.5 * t);
                    sum += weight * half * 2.0 * sine * sine / t;
                }
            }
        }
        sum
    }

    #[test]
    fn it_is_the_integral_it_stands_for_below_and_above_the_border() {
        for x in [1e-9, 1e-3, 0.2, 0.7, 1.3, 3.0, 12.5, 47.0, 47.749, 47.751, 60.0, 211.7] {
            let (found, due) = (cosine_integral_entire(x), quadrature(x));
            assert!((found - due).abs() <= 2e-15 * due.max(1e-300), "{x}: {found:e} {due:e}");
            assert_eq!(cosine_integral_entire(-x), found);
        }
        // DLMF 6.12.3: gamma + ln x - Ci(x), Ci of 10.
        assert!((cosine_integral_entire(10.0) - 2.925_257_190_900_034).abs() < 2e-15);
        assert_eq!(cosine_integral_entire(0.0), 0.0);
        assert!(cosine_integral_entire(f64::NAN).is_nan());
    }
}
