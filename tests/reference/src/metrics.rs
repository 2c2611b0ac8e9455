//! Error of a result against a truth that is known beyond f64.
//!
//! Rules, the same for every metric:
//! - truth NaN: NaN scores 0, anything else [`MISMATCH`]; a NaN result for any other truth scores [`MISMATCH`];
//! - truth infinite: the same infinity scores 0, anything else [`MISMATCH`];
//! - result infinite, truth finite: [`MISMATCH`];
//! - truth zero: a zero scores 0; the sign of zeros is not an error of size but of sign ([`wrong_sign`]);
//! - relative errors are taken against max(|truth|, smallest normal number), units in the last place against the unit of
//!   the truth's binade or of the subnormals, so both stay finite down to zero.

pub mod complex;

use crate::oracle::double_double::{Dd, two_sum};
use crate::registry::Precision;

/// Score of a result of the wrong class (NaN or infinity where a number is due, or the reverse). Finite, so that maxima
/// and charts stay finite.
pub const MISMATCH: f64 = 1e308;

/// A true value, (hi + lo) 2^exponent, with `hi` a normal number or zero, infinite or NaN. The exponent is 0 except for
/// results so small that hi + lo would leave the range of f64.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Reference {
    /// Leading part.
    pub hi: f64,
    /// Remainder, at most half a unit in the last place of `hi`.
    pub lo: f64,
    /// Power of two.
    pub exponent: i32,
}

impl From<Dd> for Reference {
    fn from(x: Dd) -> Reference {
        Reference {
            hi: x.hi,
            lo: x.lo,
            exponent: 0,
        }
    }
}

impl std::ops::Neg for Reference {
    type Output = Reference;
    fn neg(self) -> Reference {
        Reference {
            hi: -self.hi,
            lo: -self.lo,
            exponent: self.exponent,
        }
    }
}

impl Reference {
    /// A truth that is an f64.
    pub const fn exact(value: f64) -> Reference {
        Reference {
            hi: value,
            lo: 0.0,
            exponent: 0,
        }
    }

    /// The truth rounded to f64 (to nearest, but for a double rounding among the subnormals).
    pub fn value(&self) -> f64 {
        scaled(self.hi, self.exponent)
    }

    /// |a - b| / |b|, to about three digits.
    pub fn relative_difference(&self, b: &Reference) -> f64 {
        let moved = scaled(1.0, self.exponent - b.exponent);
        let difference = Dd::new(self.hi * moved, self.lo * moved) - Dd::new(b.hi, b.lo);
        if difference.hi == 0.0 {
            0.0
        } else {
            (difference.hi / b.hi).abs()
        }
    }

    /// Binary exponent of |truth|: 2^e <= |truth| < 2^(e+1). Zero gives the smallest.
    fn binade(&self) -> i32 {
        if self.hi == 0.0 {
            return -2000;
        }
        let mut hi = self.hi.abs();
        let mut shift = self.exponent;
        if hi < f64::MIN_POSITIVE {
            hi *= 2f64.powi(100);
            shift -= 100;
        }
        let bits = hi.to_bits();
        let exponent = (bits >> 52) as i32 - 1023;
        let just_below = bits << 12 == 0 && self.lo * self.hi.signum() < 0.0;
        exponent + shift - i32::from(just_below)
    }
}

/// A true value: of a real function, or of a complex one as real and imaginary part.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Truth {
    /// One number.
    Real(Reference),
    /// Real and imaginary part.
    Complex([Reference; 2]),
}

/// x 2^n without intermediate overflow or rounding (but for a subnormal result).
fn scaled(x: f64, n: i32) -> f64 {
    let step = |n: i32| f64::from_bits(((n + 1023) as u64) << 52);
    let mut x = x;
    let mut n = n;
    while n > 1000 {
        x *= step(1000);
        n -= 1000;
    }
    while n < -1000 {
        x *= step(-1000);
        n += 1000;
    }
    x * step(n)
}

/// Smallest normal exponent and number of fraction bits.
fn format(precision: Precision) -> (i32, i32) {
    match precision {
        Precision::F64 => (-1022, 52),
        Precision::F32 => (-126, 23),
    }
}

/// Score where the result or the truth is not finite.
fn class_error(result: f64, truth: &Reference) -> Option<f64> {
    if truth.hi.is_finite() && result.is_finite() {
        return None;
    }
    let same = if truth.hi.is_nan() {
        result.is_nan()
    } else {
        result == truth.hi
    };
    Some(if same { 0.0 } else { MISMATCH })
}

/// |result - truth| / 2^k.
fn scaled_difference(result: f64, truth: &Reference, k: i32) -> f64 {
    let shift = truth.exponent - k;
    let (hi, lo) = (scaled(truth.hi, shift), scaled(truth.lo, shift));
    let difference = two_sum(scaled(result, -k), -hi);
    let error = (difference.hi + (difference.lo - lo)).abs();
    if error < MISMATCH { error } else { MISMATCH }
}

/// Error in units of the last place of the truth, fractions kept; 0.5 is the best a rounded result can promise.
pub fn ulp_error(result: f64, truth: &Reference, precision: Precision) -> f64 {
    if let Some(score) = class_error(result, truth) {
        return score;
    }
    let (smallest, fraction_bits) = format(precision);
    scaled_difference(result, truth, truth.binade().max(smallest) - fraction_bits)
}

/// Relative error; the denominator is never below the smallest normal number of the precision.
pub fn relative_error(result: f64, truth: &Reference, precision: Precision) -> f64 {
    if let Some(score) = class_error(result, truth) {
        return score;
    }
    let k = truth.binade().max(format(precision).0);
    let size = scaled(truth.hi.abs(), truth.exponent - k).max(1.0);
    scaled_difference(result, truth, k) / size
}

/// Relative error in units of epsilon: 2^-52 or 2^-23.
pub fn eps_error(result: f64, truth: &Reference, precision: Precision) -> f64 {
    (relative_error(result, truth, precision) * 2f64.powi(format(precision).1)).min(MISMATCH)
}

/// Absolute error.
pub fn absolute_error(result: f64, truth: &Reference) -> f64 {
    class_error(result, truth).unwrap_or_else(|| scaled_difference(result, truth, 0))
}

/// Whether the result has the other sign than the truth. A zero of either sign is no wrong sign for a number, but for a
/// truth of zero the signs of the two zeros are compared, and any number other than zero is wrong.
pub fn wrong_sign(result: f64, truth: &Reference) -> bool {
    if result.is_nan() || truth.hi.is_nan() {
        return false;
    }
    if truth.hi == 0.0 {
        return result != 0.0 || result.is_sign_negative() != truth.hi.is_sign_negative();
    }
    result != 0.0 && (result < 0.0) != (truth.hi < 0.0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use Precision::{F32, F64};

    #[test]
    fn half_a_unit_is_half_a_unit_on_both_sides_of_a_power_of_two() {
        let above = Reference {
            hi: 1.0,
            lo: 2f64.powi(-53),
            exponent: 0,
        };
        assert_eq!(ulp_error(1.0, &above, F64), 0.5);
        let below = Reference {
            hi: 1.0,
            lo: -2f64.powi(-55),
            exponent: 0,
        };
        assert_eq!(ulp_error(1.0, &below, F64), 0.25);
        assert_eq!(ulp_error(1.0 + 2f64.powi(-23), &Reference::exact(1.0), F32), 1.0);
    }

    #[test]
    fn subnormal_truths_are_measured_in_the_smallest_subnormal() {
        let truth = Reference {
            hi: 1.25,
            lo: 0.0,
            exponent: -1074,
        };
        assert_eq!(ulp_error(f64::from_bits(1), &truth, F64), 0.25);
        assert_eq!(ulp_error(0.0, &truth, F64), 1.25);
        assert_eq!(ulp_error(0.0, &Reference::exact(f64::from_bits(3)), F64), 3.0);
        assert_eq!(ulp_error(2f64.powi(-149), &Reference::exact(2f64.powi(-148)), F32), 1.0);
        assert_eq!(eps_error(0.0, &Reference::exact(f64::from_bits(1)), F64), 1.0);
    }

    #[test]
    fn the_wrong_class_scores_the_mismatch_and_the_right_one_nothing() {
        for metric in [ulp_error, relative_error, eps_error] {
            let nan = Reference::exact(f64::NAN);
            let infinite = Reference::exact(f64::INFINITY);
            assert_eq!(metric(f64::NAN, &nan, F64), 0.0);
            assert_eq!(metric(0.0, &nan, F64), MISMATCH);
            assert_eq!(metric(f64::NAN, &Reference::exact(1.0), F64), MISMATCH);
            assert_eq!(metric(f64::INFINITY, &infinite, F64), 0.0);
            assert_eq!(metric(f64::NEG_INFINITY, &infinite, F64), MISMATCH);
            assert_eq!(metric(f64::INFINITY, &Reference::exact(1.0), F64), MISMATCH);
        }
        assert_eq!(ulp_error(1e300, &Reference::exact(1e-300), F64), MISMATCH);
    }

    #[test]
    fn signs_of_zeros_and_of_numbers_are_told_apart() {
        let zero = Reference::exact(-0.0);
        assert!(!wrong_sign(-0.0, &zero) && wrong_sign(0.0, &zero) && wrong_sign(-1e-9, &zero));
        let small = Reference::exact(1e-9);
        assert!(wrong_sign(-1e-9, &small) && !wrong_sign(0.0, &small) && !wrong_sign(2.0, &small));
        assert_eq!(ulp_error(0.0, &zero, F64), 0.0);
    }

    #[test]
    fn relative_and_absolute_errors_are_those_of_the_definition() {
        let truth = Reference {
            hi: 3.0,
            lo: 1e-17,
            exponent: 0,
        };
        assert!((relative_error(3.3, &truth, F64) - 0.1).abs() < 1e-15);
        assert!((absolute_error(3.0, &truth) - 1e-17).abs() < 1e-30);
        assert_eq!(eps_error(4.0 + 8.0 * f64::EPSILON, &Reference::exact(4.0), F64), 2.0);
    }
}
