//! The rules that say how little of the scratch model is enough: exact values, limits, the constants of their proofs, NaN,
//! and random scenes: never "enough" where it is not, and seldom "not enough" where it is.
//!
//! The release sweep takes 1e6 scenes a rule and prints the rates:
//! `cargo test --release -p iridescence --test predictor -- --ignored --nocapture`

mod base;
mod depths;
mod ends;
mod footprints;
mod interference;

use iridescence::diffraction::{
    Coherence, Footprint, base_interference_matters, footprint_method, incoherent_sum_is_enough,
    infinite_scratch_is_enough, near_normal_depth_amplitude_error, near_normal_depth_is_enough,
};
use reference::generate::random::Random;

const LIGHT: Coherence = Coherence {
    radius: 10.0,
    wavelength: 0.55,
};

const INF: f64 = f64::INFINITY;

const NAN: f64 = f64::NAN;

/// Tolerances from one ulp below 1 to the smallest subnormal.
const TOLERANCES: [f64; 12] = [
    1.0 - f64::EPSILON,
    1.0 - 1e-10,
    0.9,
    0.5,
    1e-1,
    1e-3,
    1e-6,
    1e-12,
    1e-16,
    1e-100,
    1e-300,
    5e-324,
];

/// Scenes of a run of the tests, and of the release sweep.
const FEW: u64 = 20_000;

const MANY: u64 = 1_000_000;

/// The largest share of "not enough" among the scenes where the cheaper form is enough.
const REFUSED: f64 = 0.05;

fn holds_to(value: f64, due: f64, share: f64) {
    assert!((value - due).abs() <= share * due.abs(), "{value:e} for {due:e}");
}

/// The values at a tolerance of 1, 0, below and NaN.
fn has_the_limits_of_a_reach(reach: fn(f64) -> f64) {
    assert_eq!([1.0, 1.5, INF].map(reach), [0.0; 3]);
    assert_eq!([0.0, -0.0].map(reach), [INF; 2]);
    assert!([-1e-300, -INF, NAN].map(reach).iter().all(|r| r.is_nan()));
}

/// What a rule said over many scenes.
#[derive(Default)]
struct Tally {
    scenes: u64,
    /// The cheaper form is enough.
    enough: u64,
    /// It is, and the rule said that it is not.
    refused: u64,
}

impl Tally {
    /// Counts a scene; a false "enough" fails with the scene's words.
    fn count(&mut self, says: bool, holds: bool, scene: impl Fn() -> String) {
        assert!(!says || holds, "false \"enough\": {}", scene());
        self.scenes += 1;
        self.enough += u64::from(holds);
        self.refused += u64::from(holds && !says);
    }

    /// Both answers must be due in a tenth of the scenes, and few refusals wrong.
    fn hold(&self, rule: &str) {
        self.refuses_seldom(rule);
        let tenth = self.scenes / 10;
        assert!(self.enough > tenth && self.enough < self.scenes - tenth, "{rule}");
    }

    /// False refusals stay below their share of the scenes where "enough" is.
    fn refuses_seldom(&self, rule: &str) {
        let share = self.refused as f64 / self.enough as f64;
        println!(
            "{rule}: {} scenes, {} enough, 0 false \"enough\", {} false \"not enough\" ({:.3} % of those)",
            self.scenes,
            self.enough,
            self.refused,
            100.0 * share
        );
        assert!(share <= REFUSED, "{rule}: {share}");
    }
}

fn light(random: &mut Random) -> Coherence {
    Coherence {
        radius: random.log_uniform(3.0, 100.0),
        wavelength: random.uniform(0.38, 0.78),
    }
}

#[test]
fn nan_is_never_enough() {
    let nowhere = Coherence { radius: NAN, ..LIGHT };
    let colourless = Coherence {
        wavelength: NAN,
        ..LIGHT
    };
    let backwards = Coherence {
        wavelength: -0.55,
        ..LIGHT
    };
    let wide = [-1e4, 1e4];
    assert!(infinite_scratch_is_enough(LIGHT, wide, 0.0, 1e-3));
    for (light, span, xi1, tolerance) in [
        (nowhere, wide, 0.0, 1e-3),
        (colourless, wide, 0.0, 1e-3),
        (backwards, wide, 0.0, 1e-3),
        (LIGHT, [NAN, 1e4], 0.0, 1e-3),
        (LIGHT, [-1e4, NAN], 0.0, 1e-3),
        (LIGHT, wide, NAN, 1e-3),
        (LIGHT, wide, 0.0, NAN),
        (LIGHT, [-INF, INF], NAN, 1e-3),
        (LIGHT, [-INF, INF], 0.0, NAN),
    ] {
        assert!(
            !infinite_scratch_is_enough(light, span, xi1, tolerance),
            "{span:?} {xi1} {tolerance}"
        );
    }
    for (separation, radius, tolerance) in [(NAN, 1.0, 0.5), (99.0, NAN, 0.5), (99.0, 1.0, NAN), (99.0, -1.0, 0.5)] {
        assert!(!incoherent_sum_is_enough(separation, radius, tolerance));
    }
    for (light, xi, squared_sum, tolerance) in [
        (nowhere, [1.0, 0.0], 1.0, 0.5),
        (LIGHT, [NAN, 0.0], 1.0, 0.5),
        (LIGHT, [1.0, NAN], 1.0, 0.5),
        (LIGHT, [1.0, 0.0], NAN, 0.5),
        (LIGHT, [1.0, 0.0], -1.0, 0.5),
        (LIGHT, [1.0, 0.0], 1.0, NAN),
    ] {
        assert!(base_interference_matters(light, xi, squared_sum, 2, tolerance));
    }
    for (depth, range, wavelength, tolerance) in [
        (NAN, [2.0, 2.0], 0.5, 4.0),
        (0.1, [NAN, 2.0], 0.5, 4.0),
        (0.1, [2.0, NAN], 0.5, 4.0),
        (0.1, [2.0, 2.0], NAN, 4.0),
        (0.1, [2.0, 2.0], 0.0, 4.0),
        (0.1, [2.0, 2.0], -0.5, 4.0),
        (INF, [2.0, 2.0], 0.5, 4.0),
        (0.1, [2.0, 2.0], 0.5, NAN),
    ] {
        assert!(
            !near_normal_depth_is_enough(depth, range, wavelength, tolerance),
            "{depth} {range:?}"
        );
        let amplitude = near_normal_depth_amplitude_error(depth, range, wavelength);
        assert!(amplitude.is_nan() || tolerance.is_nan(), "{depth} {range:?}");
    }
    let pixel = Footprint {
        axes: [1.0, 1.0],
        cos_phi: 0.5,
    };
    assert_eq!(footprint_method(pixel, NAN, 0.1), None);
    assert_eq!(footprint_method(pixel, -1.0, 0.1), None);
    assert_eq!(footprint_method(pixel, 1.0, NAN), None);
    assert_eq!(footprint_method(Footprint { cos_phi: NAN, ..pixel }, 1.0, 0.1), None);
}
