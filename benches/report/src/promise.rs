//! Promises against measurements: a bound is kept where measured <= bound, and tight where bound <= 4 x measured.

use crate::budget_text::{budget_text, metric};
use crate::ledger::{Entry, error_text};
use reference::registry::{Method, Metric, Precision, function};

/// How many times looser than the measurement a bound may be.
pub const LOOSEST: f64 = 4.0;

/// What a measurement says about a promise.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// Kept, and not too loose.
    Kept,
    /// The measured error is larger than the bound.
    Broken,
    /// The bound is more than four times the measured error.
    TooLoose,
}

/// Judges a bound by a measured error. A measurement that is not a number breaks any promise.
pub fn judge(bound: f64, measured: f64) -> Verdict {
    if measured.is_nan() || measured > bound {
        Verdict::Broken
    } else if bound > LOOSEST * measured {
        Verdict::TooLoose
    } else {
        Verdict::Kept
    }
}

/// Judges a row of the ledger; `None` where it promises nothing.
pub fn verdict(entry: &Entry) -> Option<Verdict> {
    entry.budget.map(|b| judge(b.bound, entry.measured(b.metric)))
}

/// The complaint about a row whose promise is broken or too loose.
pub fn complaint(entry: &Entry) -> Option<String> {
    let budget = entry.budget?;
    let found = match verdict(entry)? {
        Verdict::Kept => return None,
        Verdict::Broken => "is broken",
        Verdict::TooLoose => "is more than four times too loose",
    };
    Some(format!(
        "{} / {} ({}, {}): the budget of {} {found}: measured {} {}, worst at {:?}",
        entry.function,
        entry.method,
        crate::names::precision(entry.precision),
        entry.call,
        budget_text(entry.budget),
        error_text(entry.measured(budget.metric)),
        metric(budget.metric),
        entry.worst
    ))
}

/// The bound `e` of a method's budget such that |error| <= e max(1, |truth|): absolute bounds and relative bounds both
/// imply it. One ulp is at most one epsilon of a normal result; of a complex one |error| and |truth| are norms, and an ulp
/// of each component is at most sqrt(2) epsilon of the norm.
///
/// Where the function's scale has a unit and no largest value ([`unit()`]), the bound is |error| <= e max(scale, |truth|),
/// and an absolute bound implies nothing.
pub fn bound_on_error(method: &Method) -> f64 {
    let Some(budget) = method.budget else {
        return f64::INFINITY;
    };
    let peak = function(method.function).and_then(|f| f.peak);
    let epsilon = match method.precision {
        Precision::F64 => f64::EPSILON,
        Precision::F32 => f64::from(f32::EPSILON),
    };
    match budget.metric {
        Metric::Ulp | Metric::Eps => budget.bound * epsilon,
        Metric::Absolute if unit(method.function).is_some() => f64::INFINITY,
        Metric::Absolute | Metric::Relative => budget.bound,
        Metric::Peak => peak.and_then(|p| p.largest).unwrap_or(1.0) * budget.bound,
    }
}

/// The scale in which a tolerance for a function counts, in words, where it is not 1.
pub fn unit(name: &str) -> Option<&'static str> {
    let peak = function(name).and_then(|f| f.peak)?;
    peak.largest.is_none().then_some(peak.words)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ledger::sample;
    use reference::registry::{Budget, Origin, methods};

    #[test]
    fn a_bound_is_broken_from_below_and_too_loose_from_above() {
        assert_eq!(judge(1.0, 1.0), Verdict::Kept);
        assert_eq!(judge(1.0, 0.25), Verdict::Kept);
        assert_eq!(judge(1.0, 1.000001), Verdict::Broken);
        assert_eq!(judge(1.0, 0.2499), Verdict::TooLoose);
        assert_eq!(judge(1.0, f64::NAN), Verdict::Broken);
        assert_eq!(judge(1.0, 0.0), Verdict::TooLoose);
    }

    #[test]
    fn a_tolerance_counts_in_the_scale_of_functions_that_have_a_unit_and_in_numbers_elsewhere() {
        let bound = |function: &str, metric, bound| {
            let m = methods().iter().find(|m| m.function == function && m.budget.is_some());
            let m = m.expect("registered");
            bound_on_error(&Method {
                budget: Some(Budget { metric, bound }),
                regions: Vec::new(),
                ..*m
            })
        };
        assert_eq!(bound("sine_integral", Metric::Absolute, 1e-3), 1e-3);
        assert_eq!(bound("sine_integral", Metric::Ulp, 2.0), 2.0 * f64::EPSILON);
        // |erf(a2) - erf(a1)| is at most 2.
        assert_eq!(bound("erf_difference_scaled", Metric::Peak, 1e-3), 2e-3);
        assert_eq!(unit("erf_difference_scaled"), None);
    }

    #[test]
    fn a_complaint_names_method_budget_and_measurement() {
        let mut entry = sample("accurate", Origin::Ours, Precision::F64, 1.0, 1e-3);
        assert_eq!(complaint(&entry), None);
        entry.budget = Some(Budget {
            metric: Metric::Relative,
            bound: 5e-3,
        });
        let text = complaint(&entry).expect("five times too loose");
        assert!(
            text.contains("accurate") && text.contains("0.005 relative") && text.contains("1.0000e-3"),
            "{text}"
        );
        entry.budget = Some(Budget {
            metric: Metric::Absolute,
            bound: 5e-4,
        });
        assert!(complaint(&entry).expect("broken").contains("is broken"));
    }
}
