//! The cardinal sine and its derivative: limits, symmetries, and both against the oracles.

use iridescence::special::{sinc, sinc_derivative};
use proptest::prelude::*;
use reference::generate::{points, worst};
use reference::metrics::{Reference, ulp_error};
use reference::oracle::{self, double_double::Dd};
use reference::registry::Precision::F64;

/// Largest error of sinc in units of the last place.
const BOUND: f64 = 1.75;

#[test]
fn the_limits_are_exact() {
    for x in [0.0, -0.0, 5e-324, -5e-324, f64::MIN_POSITIVE, 1e-9] {
        assert_eq!(sinc(x), 1.0, "{x:e}");
    }
    for x in [f64::INFINITY, f64::NEG_INFINITY] {
        assert_eq!(sinc(x), 0.0);
        assert_eq!(sinc_derivative(x), 0.0);
    }
    assert!(sinc(f64::NAN).is_nan() && sinc_derivative(f64::NAN).is_nan());
    assert_eq!(sinc_derivative(0.0), 0.0);
    assert_eq!(sinc_derivative(-5e-324), 0.0);
}

#[test]
fn recorded_worst_inputs_and_edges_keep_the_bound() {
    let recorded = worst::recorded(1).into_iter().flatten();
    for x in recorded.chain(points::edges()) {
        assert!(ulp_error(sinc(x), &oracle::sinc(x), F64) <= BOUND, "{x:e}");
    }
}

/// Si'(x) by a difference quotient of the fourth order over exact steps; its error is far below an eps.
fn slope_of_sine_integral(x: f64) -> f64 {
    const STEP: f64 = 1.0 / 16384.0;
    let si = |x: f64| {
        let r = oracle::sine_integral(x);
        Dd::new(r.hi, r.lo).scale(2f64.powi(r.exponent))
    };
    let central = |h: f64| (si(x + h) - si(x - h)) / (2.0 * h);
    ((central(STEP) * 4.0 - central(2.0 * STEP)) / 3.0).hi
}

#[test]
fn sinc_is_the_slope_of_the_sine_integral() {
    for k in 1..4000 {
        let x = f64::from(k) * (60.0 / 4096.0);
        let error = (sinc(x) - slope_of_sine_integral(x)).abs();
        assert!(error <= 2.0 * f64::EPSILON * sinc(x).abs() + 1e-18, "{x}: {error:e}");
    }
}

/// (cos x - sinc x)/x, by the series where the quotient cancels.
fn derivative(x: f64) -> Dd {
    if x.abs() < 1e-3 {
        let square = Dd::from(x) * x;
        let series = Dd::ONE / -3.0 + square * (Dd::ONE / 30.0 + square * (Dd::ONE / -840.0 + square / 45360.0));
        return series * x;
    }
    let number = |r: Reference| Dd::new(r.hi, r.lo).scale(2f64.powi(r.exponent));
    (number(oracle::cosine(x)) - number(oracle::sinc(x))) / x
}

/// The error of the derivative in units of eps times the size of its envelope, min(|x|/3, 1/|x|).
fn derivative_error(x: f64) -> f64 {
    let error = (derivative(x) - Dd::from(sinc_derivative(x))).hi.abs();
    error / (f64::EPSILON * (x.abs() / 3.0).min(1.0 / x.abs()))
}

#[test]
fn the_derivative_holds_on_both_sides_of_the_border_of_its_series() {
    let one = 1f64.to_bits();
    for steps in 0..4000 {
        for x in [f64::from_bits(one - steps), f64::from_bits(one + steps)] {
            assert!(derivative_error(x) <= 4.0, "{x}: {}", derivative_error(x));
        }
    }
    // The first zeros of the derivative, the solutions of tan x = x, and its largest slope.
    for x in [
        4.493409457909064,
        7.725251836937707,
        2.081575977818101,
        0.999999999,
        1.000000001,
    ] {
        assert!(derivative_error(x) <= 4.0, "{x}: {}", derivative_error(x));
    }
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, cases: 4000, ..ProptestConfig::default() })]

    #[test]
    fn sinc_is_even_and_its_derivative_odd_bit_for_bit(bits in any::<u64>()) {
        let x = f64::from_bits(bits & !(1 << 63));
        prop_assume!(!x.is_nan());
        prop_assert_eq!(sinc(-x).to_bits(), sinc(x).to_bits());
        if x != 0.0 && x.is_finite() {
            prop_assert_eq!(sinc_derivative(-x).to_bits(), (-sinc_derivative(x)).to_bits());
        }
    }

    #[test]
    fn sinc_keeps_its_bound(x in prop_oneof![any::<f64>(), -60.0..60.0f64, (-9.0..9.0f64).prop_map(|e| 10f64.powf(e))]) {
        prop_assert!(ulp_error(sinc(x), &oracle::sinc(x), F64) <= BOUND, "{:e}", x);
    }

    #[test]
    fn the_derivative_is_within_4_eps_of_its_envelope(
        x in prop_oneof![-60.0..60.0f64, -2.0..2.0f64, (-150.0..6.0f64).prop_map(|e| 10f64.powf(e))]
    ) {
        prop_assert!(derivative_error(x) <= 4.0, "{:e}: {}", x, derivative_error(x));
    }
}
