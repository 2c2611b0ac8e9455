//! The scaled modified Bessel function I0, its logarithm and the ratio I1/I0: limits, symmetry, certified digits, worst
//! inputs, and random ones against the oracle.

use iridescence::special::{bessel_i0_scaled, bessel_i1_i0_ratio, log_bessel_i0};
use proptest::prelude::*;
use reference::generate::points;
use reference::generate::worst;
use reference::golden;
use reference::metrics::{Reference, ulp_error};
use reference::oracle;
use reference::registry::Precision::F64;
use std::f64::consts::TAU;

/// A function, its oracle, its certified values and its largest error in units of the last place.
struct Held {
    name: &'static str,
    value: fn(f64) -> f64,
    truth: fn(f64) -> Reference,
    golden: fn() -> Vec<golden::Row>,
    bound: f64,
    /// The sign of the value at a negative argument.
    mirror: f64,
}

const HELD: [Held; 3] = [
    Held {
        name: "bessel_i0_scaled",
        value: bessel_i0_scaled,
        truth: oracle::bessel_i0_scaled,
        golden: golden::bessel_i0_scaled,
        bound: 0.6,
        mirror: 1.0,
    },
    Held {
        name: "log_bessel_i0",
        value: log_bessel_i0,
        truth: oracle::log_bessel_i0,
        golden: golden::log_bessel_i0,
        bound: 2.0,
        mirror: 1.0,
    },
    Held {
        name: "bessel_i1_i0_ratio",
        value: bessel_i1_i0_ratio,
        truth: oracle::bessel_i1_i0_ratio,
        golden: golden::bessel_i1_i0_ratio,
        bound: 0.75,
        mirror: -1.0,
    },
];

impl Held {
    fn error(&self, x: f64) -> f64 {
        ulp_error((self.value)(x), &(self.truth)(x), F64)
    }

    fn hold(&self, x: f64) {
        let error = self.error(x);
        assert!(error <= self.bound, "{} of {x:e}: {error}", self.name);
    }
}

/// The number `steps` steps away, for a positive one.
fn neighbour(x: f64, steps: i64) -> f64 {
    f64::from_bits(x.to_bits().wrapping_add_signed(steps))
}

/// Every border of two cells of 1 + x, the border of the tail, and borders of the cells of the square root behind it.
fn borders() -> Vec<f64> {
    let octaves = (0..6).map(|j| f64::from(1 << j));
    let near = octaves.flat_map(|octave| (0..32).map(move |i| octave * (1.0 + f64::from(i) / 32.0) - 1.0));
    let far = [64.0, 128.0, 4096.0, 1e100, f64::MAX / 4.0];
    let far = far
        .into_iter()
        .flat_map(|start: f64| (0..32).map(move |i| start * (1.0 + f64::from(i) / 32.0)));
    near.chain(far).chain([62.0, 4.0]).filter(|&x| x > 0.0).collect()
}

#[test]
fn the_limits_are_exact() {
    for zero in [0.0, -0.0f64] {
        assert_eq!(bessel_i0_scaled(zero), 1.0);
        assert_eq!(log_bessel_i0(zero).to_bits(), 0f64.to_bits());
        assert_eq!(bessel_i1_i0_ratio(zero).to_bits(), zero.to_bits());
    }
    for infinite in [f64::INFINITY, f64::NEG_INFINITY] {
        assert_eq!(bessel_i0_scaled(infinite).to_bits(), 0f64.to_bits());
        assert_eq!(log_bessel_i0(infinite), f64::INFINITY);
        assert_eq!(bessel_i1_i0_ratio(infinite), infinite.signum());
    }
    for nan in [f64::NAN, -f64::NAN] {
        assert!(HELD.iter().all(|held| (held.value)(nan).is_nan()));
    }
    for x in [5e-324, 1e-310, f64::MIN_POSITIVE, 1e-200, 1e-20] {
        assert_eq!(bessel_i0_scaled(x), 1.0, "{x:e}");
        assert_eq!(bessel_i1_i0_ratio(x), x / 2.0, "{x:e}");
        assert_eq!(log_bessel_i0(x), x * x / 4.0, "{x:e}");
    }
    for x in [1e20, 1e100, 1e300, f64::MAX] {
        assert_eq!(log_bessel_i0(x), x, "{x:e}");
        assert_eq!(bessel_i1_i0_ratio(x), 1.0, "{x:e}");
        let leading = 1.0 / (TAU.sqrt() * x.sqrt());
        assert!(
            (bessel_i0_scaled(x) / leading - 1.0).abs() <= 4.0 * f64::EPSILON,
            "{x:e}"
        );
    }
}

#[test]
fn certified_digits_are_met() {
    for held in &HELD {
        let rows = (held.golden)();
        assert!(rows.len() > 100, "{}: {} rows", held.name, rows.len());
        for row in rows {
            let x = row.inputs[0];
            let error = ulp_error((held.value)(x), &row.truth, F64);
            assert!(
                error <= held.bound,
                "{} of {x:e}: {error} from {}",
                held.name,
                row.digits
            );
        }
    }
}

#[test]
fn recorded_worst_inputs_and_edges_keep_the_bound() {
    for held in &HELD {
        let recorded = worst::recorded_for(&[held.name]).into_iter().flatten();
        for x in recorded.chain(points::edges()).chain(points::non_finite()) {
            held.hold(x);
        }
    }
}

#[test]
fn neighbours_of_every_border_of_cells_and_of_the_tail_keep_the_bound() {
    let borders = borders();
    assert!(borders.len() > 300);
    for held in &HELD {
        for border in &borders {
            for steps in -3..=3 {
                held.hold(neighbour(*border, steps));
            }
        }
    }
}

#[test]
fn the_scaled_function_falls_and_the_others_rise() {
    // From number to number by 2^-40 relative at borders, by 2^-8 between them.
    let mut steps: Vec<f64> = (-1000..20_000).map(|k| (f64::from(k) / 256.0).exp2()).collect();
    for border in borders() {
        steps.extend((-4..=4).map(|k| border * (1.0 + f64::from(k) * 2f64.powi(-40))));
    }
    steps.retain(|x| x.is_finite());
    steps.sort_by(f64::total_cmp);
    steps.dedup();
    for pair in steps.windows(2) {
        let [low, high] = [pair[0], pair[1]];
        assert!(bessel_i0_scaled(low) > bessel_i0_scaled(high), "{low:e} {high:e}");
        assert!(log_bessel_i0(low) < log_bessel_i0(high), "{low:e} {high:e}");
        let (a, b) = (bessel_i1_i0_ratio(low), bessel_i1_i0_ratio(high));
        assert!(if low < 1e3 { a < b } else { a <= b }, "{low:e} {high:e}");
    }
}

#[test]
fn the_ratio_is_the_slope_of_the_logarithm() {
    for k in 1..4000 {
        let x = f64::from(k) * 0.02;
        let h = 1e-3;
        let at = |n: f64| log_bessel_i0(x + n * h);
        let slope = (8.0 * (at(1.0) - at(-1.0)) - (at(2.0) - at(-2.0))) / (12.0 * h);
        let error = (slope - bessel_i1_i0_ratio(x)).abs();
        assert!(error <= 1e-12 + 4e-13 * x, "{x}: {error:e}");
    }
}

#[test]
fn the_logarithm_is_that_of_the_scaled_function() {
    for k in 1..4000 {
        let x = f64::from(k) * 0.05;
        let due = x + bessel_i0_scaled(x).ln();
        assert!((log_bessel_i0(x) - due).abs() <= 4.0 * f64::EPSILON * x.max(1.0), "{x}");
    }
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, cases: 6000, ..ProptestConfig::default() })]

    #[test]
    fn the_values_are_even_or_odd_bit_for_bit(bits in any::<u64>()) {
        let x = f64::from_bits(bits);
        for held in &HELD {
            let (value, mirrored) = ((held.value)(x), (held.value)(-x));
            if x.is_nan() {
                prop_assert!(value.is_nan() && mirrored.is_nan());
            } else {
                prop_assert_eq!(mirrored.to_bits(), (held.mirror * value).to_bits(), "{} of {:e}", held.name, x);
            }
        }
    }

    #[test]
    fn the_error_keeps_the_bound(
        x in prop_oneof![
            any::<f64>(),
            -64.0..64.0f64,
            -4.5..4.5f64,
            -1.0..1.0f64,
            (-320.0..308.0f64).prop_map(|e| 10f64.powf(e)),
        ]
    ) {
        for held in &HELD {
            let error = held.error(x);
            prop_assert!(error <= held.bound, "{} of {:e}: {}", held.name, x, error);
        }
    }
}
