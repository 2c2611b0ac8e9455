//! Promises against measurements: a bound is kept where measured <= bound, and tight where bound <= 4 x measured.

use crate::budget_text::{budget_text, metric};
use crate::ledger::{Entry, error_text};
use reference::registry::{Budget, Metric, Precision};

/// How many times looser than the measurement a bound may be.
pub const LOOSEST: f64 = 4.0;

/// Largest value of any function's scale, [`reference::registry::Function::peak`].
const LARGEST_PEAK: f64 = 2.0;

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

/// The bound `e` of a budget such that |error| <= e max(1, |truth|): absolute bounds and relative bounds both
/// imply it. One ulp is at most one epsilon of a normal result; of a complex one |error| and |truth| are norms, and an ulp
/// of each component is at most sqrt(2) epsilon of the norm.
pub fn bound_on_error(budget: Budget, precision: Precision) -> f64 {
    let epsilon = match precision {
        Precision::F64 => f64::EPSILON,
        Precision::F32 => f64::from(f32::EPSILON),
    };
    match budget.metric {
        Metric::Ulp | Metric::Eps => budget.bound * epsilon,
        Metric::Absolute | Metric::Relative => budget.bound,
        Metric::Peak => LARGEST_PEAK * budget.bound,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ledger::sample;
    use reference::registry::Origin;

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
