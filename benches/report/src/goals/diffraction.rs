//! The figures asked of scratches: the spatial phase, the profiles, the mean over a footprint, energy and sampling. Those
//! that tests hold stand in docs/README.md with their commands.

use super::Precision::{F32, F64};
use super::{Goal, Ledger, at_most};
use crate::integrals;
use crate::ledger::Entry;

const PHASE: &str = "spatial_phase";
const RECTANGLE: &str = "profile_rectangle";
const TRIANGLE: &str = "profile_triangle";
const FOOTPRINT: &str = "footprint_mean";

/// The tiers of the footprint: method, largest error and time asked, both in words.
const TIERS: [(&str, f64, f64, [&str; 2]); 3] = [
    (
        "coarse",
        1e-3,
        1.2,
        [
            "1e-3 tier: at most 1e-3 of the mean at the centre",
            "1e-3 tier: at most 1.2 x the time of the published blend",
        ],
    ),
    (
        "medium",
        1e-6,
        4.0,
        [
            "1e-6 tier: at most 1e-6 of the mean at the centre",
            "1e-6 tier: at most 4 x the time of the published blend",
        ],
    ),
    (
        "accurate",
        1e-12,
        7.0,
        [
            "1e-12 tier: at most 1e-12 of the mean at the centre",
            "1e-12 tier: at most 7 x the time of the published blend",
        ],
    ),
];

/// The figures, in order.
pub(super) fn goals(l: &Ledger) -> Vec<Goal> {
    let goal = |function, asked, measured| Goal {
        function,
        asked,
        measured,
    };
    let most = |function, precision| {
        let rows = l.rows(function, "accurate", precision, "scalar");
        rows.map(|e| e.max_peak).reduce(f64::max)
    };
    let non_finite = |function| {
        let rows: Vec<&Entry> = l.rows(function, "accurate", F64, "scalar").collect();
        let count: u64 = rows.iter().map(|e| e.non_finite).sum();
        let points: u64 = rows.iter().map(|e| e.points).sum();
        (!rows.is_empty()).then(|| (format!("{count} of {points} rows"), count == 0))
    };
    let mut all = vec![
        goal(
            PHASE,
            "f64: at most 1e-13 of sqrt(2 pi) sigma",
            most(PHASE, F64).map(|e| at_most(e, 1e-13, "")),
        ),
        goal(PHASE, "f64: no result that is not finite", non_finite(PHASE)),
        goal(
            PHASE,
            "f32: at most 1e-5 of sqrt(2 pi) sigma",
            most(PHASE, F32).map(|e| at_most(e, 1e-5, "")),
        ),
    ];
    for function in [RECTANGLE, TRIANGLE] {
        let (double, single) = (most(function, F64), most(function, F32));
        let asked = if function == TRIANGLE {
            "f64, at and beside the poles included: at most 1e-14 of the width"
        } else {
            "f64: at most 1e-14 of the width"
        };
        all.push(goal(function, asked, double.map(|e| at_most(e, 1e-14, ""))));
        let asked = "f32: at most 1e-6 of the width";
        all.push(goal(function, asked, single.map(|e| at_most(e, 1e-6, ""))));
    }
    let blend = l.published(FOOTPRINT, F64, "scalar");
    for (method, bound, times, asked) in TIERS {
        let own = l.find(FOOTPRINT, method, F64, "scalar");
        let ratio = own.zip(blend).map(|(own, blend)| own.ns / blend.ns);
        all.push(goal(FOOTPRINT, asked[0], own.map(|e| at_most(e.max_peak, bound, ""))));
        all.push(goal(FOOTPRINT, asked[1], ratio.map(|r| at_most(r, times, " x"))));
    }
    let cone = "von_mises_fisher_pdf";
    all.extend([
        goal(
            "energy_blend",
            "f64: energies of base and scratches within 1e-12 of the transfer function's",
            Some(at_most(integrals::energy_defect(), 1e-12, "")),
        ),
        goal(
            cone,
            "f64, concentrations 1e-12 to 1e6: no result that is not finite",
            non_finite(cone),
        ),
        goal(
            cone,
            "f64, concentrations 1e-12 to 1e6: integral over the sphere within 1e-12 of 1",
            Some(at_most(integrals::von_mises_fisher_defect(), 1e-12, "")),
        ),
    ]);
    all
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ledger::sample;
    use reference::registry::Origin;

    #[test]
    fn a_tier_is_judged_by_its_error_and_by_its_time_against_the_blend() {
        let row = |method, origin, ns, max_peak| Entry {
            function: FOOTPRINT.to_string(),
            max_peak,
            ..sample(method, origin, F64, ns, 1e-3)
        };
        let mut entries = vec![
            row("coarse", Origin::Ours, 11.0, 9e-4),
            row("vwh18", Origin::Published, 10.0, 5.0),
        ];
        let of = |entries: &[Entry], asked: &str| {
            let found = goals(&Ledger(entries)).into_iter().find(|g| g.asked == asked);
            found.expect("asked").measured.map(|m| m.1)
        };
        let [error, time] = TIERS[0].3;
        assert_eq!((of(&entries, error), of(&entries, time)), (Some(true), Some(true)));
        entries[0].max_peak = 1.1e-3;
        entries[0].ns = 12.1;
        assert_eq!((of(&entries, error), of(&entries, time)), (Some(false), Some(false)));
        assert_eq!(of(&entries, TIERS[1].3[0]), None);
    }

    #[test]
    fn the_largest_error_of_all_domains_of_a_function_counts() {
        let row = |max_peak, non_finite| Entry {
            function: PHASE.to_string(),
            max_peak,
            non_finite,
            ..sample("accurate", Origin::Ours, F64, 1.0, 1e-16)
        };
        let found = goals(&Ledger(&[row(1e-16, 0), row(2e-13, 1)]));
        let states: Vec<_> = found.iter().take(2).map(|g| g.measured.as_ref().map(|m| m.1)).collect();
        assert_eq!(states, [Some(false), Some(false)]);
    }
}
