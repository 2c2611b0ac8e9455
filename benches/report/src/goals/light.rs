//! The figures asked of area lights. Those that the release sweeps hold stand in docs/README.md with their commands.

use super::Precision::{F32, F64};
use super::{Goal, Ledger, at_least, at_most};
use crate::light_figures::{Kind, TOLERANCES, chord_error, tiers};
use crate::render::light_times;
use reference::registry::lights::{PORTABLE_SAMPLES, SAMPLES};

const SPHERE: &str = "sphere_light";
const POLYGON: &str = "polygon_light";

/// What is asked of a tolerance: the 99.9th percentile, the largest error, in words.
const KEPT: [[&str; 2]; 3] = [
    [
        "tolerance 1e-2: 99.9 % of relative errors at most 1 x the tolerance",
        "tolerance 1e-2: every error at most 10 x the tolerance",
    ],
    [
        "tolerance 1e-3: 99.9 % of relative errors at most 1 x the tolerance",
        "tolerance 1e-3: every error at most 10 x the tolerance",
    ],
    [
        "tolerance 1e-4: 99.9 % of relative errors at most 1 x the tolerance",
        "tolerance 1e-4: every error at most 10 x the tolerance",
    ],
];

/// The figures, in order.
pub(super) fn goals(l: &Ledger) -> Vec<Goal> {
    let goal = |function, asked, measured| Goal {
        function,
        asked,
        measured,
    };
    let mut all = Vec::new();
    for (function, kind) in [(SPHERE, Kind::Sphere), (POLYGON, Kind::Polygon)] {
        let exact = l.find(function, "accurate", F64, "scalar");
        all.push(goal(
            function,
            "exact: at most 1e-9 of the value, or of a thousandth of the whole plane's",
            exact.map(|e| at_most(e.max_peak, 1e-9, "")),
        ));
        // Without the light in the ledger nothing of it is measured.
        let found = exact.map(|_| tiers(kind));
        for i in 0..TOLERANCES.len() {
            let tier = found.map(|tiers| tiers[i]);
            let [most, worst] = KEPT[i];
            all.push(goal(function, most, tier.map(|t| at_most(t.errors[0], 1.0, " x"))));
            all.push(goal(function, worst, tier.map(|t| at_most(t.errors[1], 10.0, " x"))));
        }
        let fine = found.map(|tiers| tiers[1]);
        let (asked, chords) = match kind {
            Kind::Sphere => ("tolerance 1e-3: at most 2.5 chords in the mean", 2.5),
            Kind::Polygon => ("tolerance 1e-3: at most 5 chords in the mean", 5.0),
        };
        all.push(goal(
            function,
            asked,
            fine.map(|t| at_most(t.chords, chords, " chords")),
        ));
        all.push(goal(
            function,
            "tolerance 1e-3: one chord is wrong at most .1 % of the time",
            fine.map(|t| at_most(t.wrong, 0.1, " %")),
        ));
        all.push(goal(
            function,
            "f32, one chord: 99 % of relative errors at most 1e-4",
            exact.map(|_| at_most(chord_error(kind), 1e-4, "")),
        ));
    }
    let sample = |method: &str| l.peers("sphere_light_chord", F32).find(|e| e.method == method);
    for (function, method, asked, bound) in [
        (
            "sphere_light_chord",
            PORTABLE_SAMPLES,
            "f32: at most 2.2 x the time of one Monte Carlo sample in the same kernels",
            2.2,
        ),
        (
            "quad_light_chord",
            PORTABLE_SAMPLES,
            "f32: at most 3.0 x the time of one Monte Carlo sample in the same kernels",
            3.0,
        ),
        (
            "sphere_light_chord",
            SAMPLES,
            "f32: at most 2.2 x the time of one Monte Carlo sample on the platform's maths",
            2.2,
        ),
        (
            "quad_light_chord",
            SAMPLES,
            "f32: at most 3.0 x the time of one Monte Carlo sample on the platform's maths",
            3.0,
        ),
    ] {
        let own = l.find(function, "accurate", F32, "scalar");
        let ratio = own
            .zip(sample(method))
            .map(|(own, samples)| own.ns / (samples.ns / 64.0));
        all.push(goal(function, asked, ratio.map(|r| at_most(r, bound, " x"))));
    }
    let medians = light_times(l.0).map(|[cone, gaussian, ours]| {
        let found = crate::light_figures::committed();
        let median = |of: fn(&crate::light_figures::Size) -> f64| {
            let mut all: Vec<f64> = found.iter().map(of).collect();
            all.sort_by(f64::total_cmp);
            all.get(all.len() / 2).copied().unwrap_or(f64::NAN)
        };
        [
            median(|s| s.cone[1]) * cone / ours,
            median(|s| s.gaussian[1]) * gaussian / ours,
        ]
    });
    all.push(goal(
        SPHERE,
        "1 % error: at least 1e5 x faster than uniform sampling of the cone, median over sizes",
        medians.map(|[cone, _]| at_least(cone, 1e5, " x")),
    ));
    all.push(goal(
        SPHERE,
        "1 % error: at least 5e3 x faster than importance sampling, median over sizes",
        medians.map(|[_, gaussian]| at_least(gaussian, 5e3, " x")),
    ));
    all
}
