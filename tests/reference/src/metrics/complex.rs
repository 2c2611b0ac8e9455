//! Errors of a complex result: norm-wise in size, by component in units of the last place.
//!
//! The rules of [`crate::metrics`] hold for each component; a component of the wrong class makes the whole result one.

use super::{MISMATCH, Reference, class_error, format, scaled, scaled_difference};
use crate::registry::Precision;

/// The score of a result whose class decides, where either component of result or truth is not finite.
fn class(result: [f64; 2], truth: &[Reference; 2]) -> Option<f64> {
    let scores = [0, 1].map(|i| class_error(result[i], &truth[i]));
    let finite = scores.iter().all(Option::is_none);
    (!finite).then(|| scores.into_iter().flatten().fold(0.0, f64::max))
}

/// Exponent of the larger component, not below the smallest normal one.
fn binade(truth: &[Reference; 2], precision: Precision) -> i32 {
    truth[0].binade().max(truth[1].binade()).max(format(precision).0)
}

fn norm(x: [f64; 2]) -> f64 {
    x[0].hypot(x[1]).min(MISMATCH)
}

/// |result - truth|.
pub fn absolute_error(result: [f64; 2], truth: &[Reference; 2]) -> f64 {
    class(result, truth).unwrap_or_else(|| norm([0, 1].map(|i| scaled_difference(result[i], &truth[i], 0))))
}

/// |result - truth| / |truth|; the denominator is never below the smallest normal number of the precision.
pub fn relative_error(result: [f64; 2], truth: &[Reference; 2], precision: Precision) -> f64 {
    class(result, truth).unwrap_or_else(|| {
        let k = binade(truth, precision);
        let size = norm(truth.map(|t| scaled(t.hi, t.exponent - k))).max(1.0);
        norm([0, 1].map(|i| scaled_difference(result[i], &truth[i], k))) / size
    })
}

/// Norm-wise relative error in units of epsilon: 2^-52 or 2^-23.
pub fn eps_error(result: [f64; 2], truth: &[Reference; 2], precision: Precision) -> f64 {
    (relative_error(result, truth, precision) * 2f64.powi(format(precision).1)).min(MISMATCH)
}

/// The larger of the components' errors in units of their own last place.
pub fn ulp_error(result: [f64; 2], truth: &[Reference; 2], precision: Precision) -> f64 {
    super::ulp_error(result[0], &truth[0], precision).max(super::ulp_error(result[1], &truth[1], precision))
}

/// Whether the result points away from the truth: more than a right angle between them.
pub fn wrong_sign(result: [f64; 2], truth: &[Reference; 2]) -> bool {
    if class(result, truth).is_some() {
        return false;
    }
    let k = binade(truth, Precision::F64);
    let along = [0, 1].map(|i| scaled(result[i], -k) * scaled(truth[i].hi, truth[i].exponent - k));
    along[0] + along[1] < 0.0
}

#[cfg(test)]
mod tests {
    use super::*;
    use Precision::F64;

    fn exact(re: f64, im: f64) -> [Reference; 2] {
        [Reference::exact(re), Reference::exact(im)]
    }

    #[test]
    fn the_norm_counts_relative_errors_and_each_component_its_own_units() {
        let truth = exact(3.0, 4e-20);
        let result = [3.0, 5e-20];
        assert!((relative_error(result, &truth, F64) * 3e20 - 1.0).abs() < 1e-12);
        assert!((absolute_error(result, &truth) * 1e20 - 1.0).abs() < 1e-12);
        assert!(ulp_error(result, &truth, F64) > 1e15);
        assert_eq!(ulp_error([3.0 + 2.0 * f64::EPSILON, 4e-20], &truth, F64), 1.0);
        assert_eq!(eps_error([3.0, 4.0 + 20.0 * f64::EPSILON], &exact(3.0, 4.0), F64), 4.0);
    }

    #[test]
    fn sizes_beyond_the_range_of_f64_are_compared_all_the_same() {
        let tiny = [1.0, -1.0].map(|hi| Reference {
            hi,
            lo: 0.0,
            exponent: -1060,
        });
        let unit = 2f64.powi(-1060);
        assert_eq!(relative_error([unit, -unit], &tiny, F64), 0.0);
        assert!(!wrong_sign([unit, -unit], &tiny) && wrong_sign([-unit, unit], &tiny));
        let huge = exact(1e300, 1e300);
        assert!((relative_error([1e300, 2e300], &huge, F64) - 0.5f64.sqrt()).abs() < 1e-12);
        assert!(!wrong_sign([1e300, 1e300], &huge) && wrong_sign([1e300, -1.1e300], &huge));
    }

    #[test]
    fn a_component_of_the_wrong_class_makes_the_result_a_mismatch() {
        let truth = exact(1.0, 0.0);
        for result in [[f64::NAN, 0.0], [1.0, f64::NAN], [f64::INFINITY, 0.0]] {
            assert_eq!(relative_error(result, &truth, F64), MISMATCH);
            assert_eq!(absolute_error(result, &truth), MISMATCH);
            assert_eq!(ulp_error(result, &truth, F64), MISMATCH);
        }
        assert_eq!(relative_error([f64::NAN; 2], &exact(f64::NAN, f64::NAN), F64), 0.0);
        assert_eq!(
            relative_error([f64::NAN, 1.0], &exact(f64::NAN, f64::NAN), F64),
            MISMATCH
        );
    }
}
