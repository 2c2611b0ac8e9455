//! The error function of a real argument: limits, symmetry, order, certified digits, worst inputs, and random ones
//! against the oracle.

use iridescence::special::{erf, erf_complex};
use num_complex::Complex;
use proptest::prelude::*;
use reference::generate::points;
use reference::generate::random::neighbour;
use reference::generate::worst;
use reference::golden;
use reference::metrics::{Reference, ulp_error};
use reference::oracle;
use reference::registry::Precision::F64;
use std::f64::consts::FRAC_2_SQRT_PI;

/// Largest error in units of the last place.
const BOUND: f64 = 0.501;
/// Cells in a unit of x.
const PER_UNIT: f64 = 32.0;
/// Where the arguments begin that are scaled.
const TINY: f64 = f64::from_bits((1023 - 1000) << 52);
/// Where the polynomial of the cell at 0 begins.
const STRAIGHT: f64 = f64::from_bits((1023 - 40) << 52);

fn truth(x: f64) -> Reference {
    oracle::erf_complex(x, 0.0)[0]
}

fn error(x: f64) -> f64 {
    ulp_error(erf(x), &truth(x), F64)
}

fn hold(x: f64) {
    assert!(error(x) <= BOUND, "erf({x:e}): {}", error(x));
}

/// Borders of cells, centres of cells, and the places where the method changes.
fn borders() -> Vec<f64> {
    let halves = (1..=384).map(|k| f64::from(k) / (2.0 * PER_UNIT));
    // The smallest number whose erf is normal, and where erf reaches 1.
    let subnormal = f64::MIN_POSITIVE / FRAC_2_SQRT_PI;
    let others = [TINY, STRAIGHT, f64::MIN_POSITIVE, subnormal, 5.921587195794507];
    halves.chain(others).collect()
}

#[test]
fn the_limits_are_exact() {
    for zero in [0.0, -0.0f64] {
        assert_eq!(erf(zero).to_bits(), zero.to_bits());
    }
    for infinite in [f64::INFINITY, f64::NEG_INFINITY] {
        assert_eq!(erf(infinite), infinite.signum());
    }
    for nan in [f64::NAN, -f64::NAN] {
        assert!(erf(nan).is_nan());
    }
    for x in [5.921587195794507, 5.93, 5.9375, 6.0, 8.0, 1e3, 1e17, f64::MAX] {
        assert_eq!(erf(x), 1.0, "{x:e}");
    }
    assert_eq!(erf(5.9215871957945065), 1.0 - f64::EPSILON / 2.0);
    assert_eq!(erf(5e-324), 5e-324);
}

#[test]
fn certified_digits_are_met() {
    let rows = golden::erf_complex();
    let real: Vec<_> = rows.iter().filter(|row| row.inputs[1] == 0.0).collect();
    assert!(real.len() > 10, "{} rows", real.len());
    for row in real {
        let x = row.inputs[0];
        let error = ulp_error(erf(x), &row.truth[0], F64);
        assert!(error <= BOUND, "erf({x:e}): {error}");
    }
}

#[test]
fn recorded_worst_inputs_and_edges_keep_the_bound() {
    let recorded = worst::recorded_for(&["erf"]);
    assert!(recorded.len() > 3);
    let recorded = recorded.into_iter().flatten();
    recorded
        .chain(points::edges())
        .chain(points::non_finite())
        .for_each(hold);
}

#[test]
fn neighbours_of_every_border_keep_the_bound() {
    for border in borders() {
        (-20..=20).for_each(|steps| hold(neighbour(border, steps)));
    }
}

#[test]
fn the_value_never_falls_from_one_number_to_the_next() {
    for border in borders() {
        let mut below = erf(neighbour(border, -300));
        for steps in -299..=300 {
            let x = neighbour(border, steps);
            assert!(below <= erf(x), "erf({x:e}) < {below:e}");
            below = erf(x);
        }
    }
}

#[test]
fn the_complex_function_has_the_same_real_line() {
    for k in 0..20_000 {
        let x = f64::from(k - 10_000) / 1600.0;
        let along = erf_complex(Complex::new(x, 0.0)).re;
        assert!((along - erf(x)).abs() <= 8.0 * f64::EPSILON * erf(x).abs(), "{x}");
    }
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, cases: 20_000, ..ProptestConfig::default() })]

    #[test]
    fn the_values_are_odd_bit_for_bit(bits in any::<u64>()) {
        let x = f64::from_bits(bits);
        if x.is_nan() {
            prop_assert!(erf(x).is_nan() && erf(-x).is_nan());
        } else {
            prop_assert_eq!(erf(-x).to_bits(), (-erf(x)).to_bits());
        }
    }

    #[test]
    fn the_error_keeps_the_bound(
        x in prop_oneof![
            any::<f64>(),
            -6.0..6.0f64,
            -0.1..0.1f64,
            (-324.0..1.5f64).prop_map(|e| 10f64.powf(e)),
        ]
    ) {
        prop_assert!(error(x) <= BOUND, "erf({:e}): {}", x, error(x));
    }

    #[test]
    fn the_subnormal_values_are_rounded_to_nearest(bits in 0..f64::MIN_POSITIVE.to_bits()) {
        let x = f64::from_bits(bits);
        prop_assert!(error(x) <= 0.5, "erf({:e}): {}", x, error(x));
    }
}
