//! The sine integral: limits, symmetry, certified digits, worst inputs, and random ones against the oracle.

use iridescence::special::{sine_integral, sine_integral_vwh18};
use proptest::prelude::*;
use reference::as_printed::sine_integral_vwh18_29;
use reference::generate::{points, worst};
use reference::golden;
use reference::metrics::ulp_error;
use reference::oracle;
use reference::registry::Precision::F64;
use std::f64::consts::{FRAC_PI_2, PI};

/// Largest error in units of the last place.
const BOUND: f64 = 0.75;

fn error(x: f64) -> f64 {
    ulp_error(sine_integral(x), &oracle::sine_integral(x), F64)
}

#[test]
fn the_limits_are_exact() {
    assert_eq!(sine_integral(0.0).to_bits(), 0f64.to_bits());
    assert_eq!(sine_integral(-0.0).to_bits(), (-0f64).to_bits());
    assert_eq!(sine_integral(f64::INFINITY), FRAC_PI_2);
    assert_eq!(sine_integral(f64::NEG_INFINITY), -FRAC_PI_2);
    assert!(sine_integral(f64::NAN).is_nan() && sine_integral(-f64::NAN).is_nan());
    for x in [5e-324, 1e-310, f64::MIN_POSITIVE, 1e-200, 1e-20, 1e-9] {
        assert_eq!(sine_integral(x), x, "Si(x) = x to within half a unit of {x:e}");
    }
    for x in [1e17, 1e100, 1e300, f64::MAX] {
        assert_eq!(sine_integral(x), FRAC_PI_2, "{x:e}");
    }
}

#[test]
fn certified_digits_are_met() {
    let rows = golden::sine_integral();
    assert!(rows.len() > 300);
    for row in rows {
        let x = row.inputs[0];
        assert!(
            ulp_error(sine_integral(x), &row.truth, F64) <= BOUND,
            "{x:e}: {}",
            row.digits
        );
    }
}

#[test]
fn recorded_worst_inputs_and_edges_keep_the_bound() {
    let recorded = worst::recorded(1).into_iter().flatten();
    for x in recorded.chain(points::edges()).chain(points::non_finite()) {
        assert!(error(x) <= BOUND, "{x:e}: {}", error(x));
    }
}

#[test]
fn neighbours_of_every_cell_border_and_of_the_tail_keep_the_bound() {
    for row in 0..=128 {
        let border = (f64::from(row) + 0.5) * 0.375;
        for x in [border, 47.75, 47.75 + f64::from(row)] {
            for steps in -3..=3i64 {
                let x = f64::from_bits((x.to_bits() as i64 + steps) as u64);
                assert!(error(x) <= BOUND, "{x}: {}", error(x));
            }
        }
    }
}

#[test]
fn the_value_rises_and_falls_between_the_zeros_of_the_sine() {
    // The Wilbraham-Gibbs constant, 1.85193705198246617..., is the largest value.
    let largest = sine_integral(PI);
    assert!((largest - 1.8519370519824662).abs() <= f64::EPSILON, "{largest:e}");
    for n in 0..2000 {
        let rising = n % 2 == 0;
        let samples: Vec<f64> = (0..=64)
            .map(|k| sine_integral(PI * (f64::from(n) + f64::from(k) / 64.0)))
            .collect();
        for pair in samples.windows(2) {
            assert_eq!(pair[0] < pair[1], rising, "between {n} pi and {} pi: {pair:?}", n + 1);
        }
        assert!(samples.iter().all(|&si| (0.0..=largest).contains(&si)));
    }
}

#[test]
fn the_published_fit_is_the_printed_one_and_keeps_its_distance() {
    let mut largest = 0.0f64;
    for k in -30_000..=30_000 {
        let x = f64::from(k) * 0.002;
        let fit = sine_integral_vwh18(x);
        assert!(
            (fit - sine_integral_vwh18_29(x)).abs() <= 4.0 * f64::EPSILON * fit.abs(),
            "{x}"
        );
        assert_eq!(sine_integral_vwh18(-x).to_bits(), (-fit).to_bits(), "{x}");
        largest = largest.max((fit - sine_integral(x)).abs());
    }
    assert!((0.0505..0.0515).contains(&largest), "{largest}");
    assert!(sine_integral_vwh18(f64::INFINITY).is_nan() && sine_integral_vwh18(f64::NAN).is_nan());
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, cases: 6000, ..ProptestConfig::default() })]

    #[test]
    fn the_value_is_odd_bit_for_bit(bits in any::<u64>()) {
        let x = f64::from_bits(bits);
        let (value, mirrored) = (sine_integral(x), sine_integral(-x));
        if x.is_nan() {
            prop_assert!(value.is_nan() && mirrored.is_nan());
        } else {
            prop_assert_eq!(mirrored.to_bits(), (-value).to_bits());
        }
    }

    #[test]
    fn the_error_is_at_most_three_quarters_of_a_unit(
        x in prop_oneof![
            any::<f64>(),
            -60.0..60.0f64,
            -2.0..2.0f64,
            (-320.0..18.0f64).prop_map(|e| 10f64.powf(e)),
            (1u32..1_000_000).prop_map(|k| f64::from(k) * FRAC_PI_2),
        ]
    ) {
        prop_assert!(error(x) <= BOUND, "{:e}: {}", x, error(x));
    }
}
