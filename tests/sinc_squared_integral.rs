//! The arc integral of sinc squared: limits, symmetries, certified digits, worst arcs, additivity, order, gradient.

use iridescence::special::{
    sinc_squared_integral as arc, sinc_squared_integral_gradient as gradient, sinc_squared_integral_vwh18 as arc_vwh18,
};
use proptest::prelude::*;
use reference::as_printed::sinc_squared_integral_vwh18_27;
use reference::generate::random::Random;
use reference::generate::{arcs, worst};
use reference::golden;
use reference::metrics::{eps_error, wrong_sign};
use reference::oracle;
use reference::oracle::double_double::Dd;
use reference::registry::Precision::F64;
use std::f64::consts::{FRAC_PI_2, PI};

/// Largest relative error in eps.
const BOUND: f64 = 16.0;

/// A subnormal arc is known to this much.
const SMALLEST: f64 = 8.0 * 5e-324;

fn oracle_is_tiny([q0, q1]: [f64; 2]) -> bool {
    oracle::sinc_squared_integral(q0, q1).value() <= SMALLEST
}

fn error([q0, q1]: [f64; 2]) -> f64 {
    eps_error(arc([q0, q1]), &oracle::sinc_squared_integral(q0, q1), F64)
}

#[test]
fn the_limits_are_exact() {
    let inf = f64::INFINITY;
    assert_eq!(arc([-inf, inf]), PI);
    assert_eq!(arc([inf, -inf]), -PI);
    assert_eq!(arc([0.0, inf]), FRAC_PI_2);
    assert_eq!(arc([-inf, -0.0]), FRAC_PI_2);
    for q in [0.0, -0.0, 5e-324, 1.0, -PI, 1e6, f64::MAX, inf, -inf] {
        assert_eq!(arc([q, q]).to_bits(), 0, "equal bounds {q:e}");
        for bounds in [[f64::NAN, q], [q, f64::NAN]] {
            assert!(arc(bounds).is_nan(), "{bounds:?}");
        }
    }
    assert_eq!(arc([-0.0, 0.0]), 0.0);
    for q in [5e-324, 1e-310, f64::MIN_POSITIVE, 1e-100, 1e-12] {
        assert_eq!(arc([0.0, q]), q, "the integrand is 1 at the peak: {q:e}");
        assert_eq!(arc([-q, q]), 2.0 * q, "{q:e}");
    }
}

#[test]
fn certified_digits_are_met() {
    let rows = golden::sinc_squared_integral();
    assert!(rows.len() > 300);
    for row in rows {
        let (q, digits) = ([row.inputs[0], row.inputs[1]], row.digits);
        assert!(eps_error(arc(q), &row.truth, F64) <= BOUND, "{q:?}: {digits}");
        assert!(!wrong_sign(arc(q), &row.truth), "{q:?}: {digits}");
    }
}

#[test]
fn recorded_worst_and_extreme_arcs_keep_the_bound() {
    let recorded = worst::recorded(2).into_iter().map(|q| [q[0], q[1]]);
    for q in recorded.chain(arcs::extreme()).chain(arcs::non_finite()) {
        assert!(error(q) <= BOUND, "{q:?}: {}", error(q));
    }
}

/// Arcs of every kind, ordered, with a third number beyond them.
fn triples(seed: u64, count: usize) -> impl Iterator<Item = [f64; 3]> {
    let mut random = Random::new(seed);
    let rows = (arcs::ARC_F64.rows)(seed, count);
    let pairs: Vec<[f64; 2]> = rows.chunks_exact(2).map(|q| [q[0].min(q[1]), q[0].max(q[1])]).collect();
    pairs.into_iter().map(move |[a, b]| {
        let step = if random.chance(0.5) {
            random.log_uniform(1e-15, 10.0)
        } else {
            random.uniform(0.0, 60.0)
        };
        [a, b, b + step * if random.chance(0.5) { b.abs() } else { 1.0 }]
    })
}

#[test]
fn arcs_add_up_to_twice_the_bound() {
    for [a, b, c] in triples(3, 60_000) {
        let (first, second, whole) = (arc([a, b]), arc([b, c]), arc([a, c]));
        let slack = BOUND * f64::EPSILON * (first + second + whole) + SMALLEST;
        assert!(
            (first + second - whole).abs() <= slack,
            "{a:e} {b:e} {c:e}: {first:e} + {second:e}, {whole:e}"
        );
    }
}

#[test]
fn no_arc_is_negative_and_none_shrinks_beyond_the_bound_when_an_end_moves_out() {
    for [a, b, c] in triples(4, 120_000) {
        for [a, b, c] in [[a, b, c], [-c, -b, -a]] {
            let (first, second, whole) = (arc([a, b]), arc([b, c]), arc([a, c]));
            assert!(first >= 0.0 && second >= 0.0 && whole >= 0.0, "{a:e} {b:e} {c:e}");
            assert!(first > 0.0 || oracle_is_tiny([a, b]), "{a:e} {b:e}");
            let least = 1.0 - 2.0 * BOUND * f64::EPSILON;
            let whole = whole + SMALLEST;
            assert!(whole >= first * least && whole >= second * least, "{a:e} {b:e} {c:e}");
        }
    }
}

#[test]
fn an_end_that_moves_out_by_a_thousandth_never_shrinks_an_arc() {
    let mut random = Random::new(5);
    for _ in 0..300_000 {
        let (a, b) = (random.uniform(-100.0, 100.0), random.uniform(-100.0, 100.0));
        let (a, b) = (a.min(b), a.max(b));
        let gap = random.log_uniform(1e-3, 10.0);
        let value = arc([a, b]);
        assert!(arc([a, b + gap]) > value, "{a} {b} {gap}");
        assert!(arc([a - gap, b]) > value, "{a} {b} {gap}");
    }
    // The same where the integrand has its zeros, which is where an error would show first.
    for n in -30..=30 {
        for k in -4..=4 {
            let end = f64::from(n) * PI + f64::from(k) * 2.5e-4;
            assert!(arc([-101.0, end + 1e-3]) > arc([-101.0, end]), "{n} {k}");
            assert!(arc([end, 101.0]) > arc([end + 1e-3, 101.0]), "{n} {k}");
        }
    }
}

/// d/dq of the arc from 0 by a difference quotient of the fourth order of the oracle.
fn slope(q: f64) -> f64 {
    const STEP: f64 = 1.0 / 16384.0;
    let central = |h: f64| {
        let r = oracle::sinc_squared_integral(q - h, q + h);
        Dd::new(r.hi, r.lo) / (2.0 * h)
    };
    ((central(STEP) * 4.0 - central(2.0 * STEP)) / 3.0).hi
}

#[test]
fn the_gradient_is_the_slope_of_the_arc_in_each_bound() {
    for k in 0..3000 {
        let q = f64::from(k) * (60.0 / 4096.0) - 20.0;
        let [first, last] = gradient([q, q + 1.5]);
        assert!(
            (first + slope(q)).abs() <= 4.0 * f64::EPSILON * first.abs() + 1e-17,
            "{q}: {first:e}"
        );
        assert!(
            (last - slope(q + 1.5)).abs() <= 4.0 * f64::EPSILON * last.abs() + 1e-17,
            "{q}: {last:e}"
        );
    }
    assert_eq!(gradient([0.0, f64::INFINITY]), [-1.0, 0.0]);
    assert!(gradient([f64::NAN, 1.0])[0].is_nan());
}

#[test]
fn the_published_formula_is_the_printed_one_and_turns_negative() {
    let mut random = Random::new(6);
    let mut negative = 0;
    for _ in 0..20_000 {
        let start = random.uniform(1.0, 60.0);
        let q = [start, start * (1.0 + random.log_uniform(1e-3, 0.1))];
        let (fit, printed) = (arc_vwh18(q), sinc_squared_integral_vwh18_27(q));
        assert!((fit - printed).abs() <= 1e-14, "{q:?}: {fit:e} {printed:e}");
        assert!(arc(q) > 0.0, "{q:?}");
        negative += u32::from(fit < 0.0);
    }
    assert!(negative > 3000, "{negative} of 20000");
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, cases: 4000, ..ProptestConfig::default() })]

    #[test]
    fn swapped_bounds_change_the_sign_and_mirrored_ones_nothing(bits in any::<[u64; 2]>()) {
        let [a, b] = bits.map(f64::from_bits);
        let value = arc([a, b]);
        if a.is_nan() || b.is_nan() {
            prop_assert!(value.is_nan());
        } else if a != b {
            prop_assert_eq!(arc([b, a]).to_bits(), (-value).to_bits());
            prop_assert_eq!(arc([-b, -a]).to_bits(), value.to_bits());
        }
    }

    #[test]
    fn the_error_is_at_most_16_eps(
        start in prop_oneof![-60.0..60.0f64, (-12.0..12.0f64).prop_map(|e| 10f64.powf(e))],
        length in (-14.0..4.0f64).prop_map(|e| 10f64.powf(e)),
    ) {
        let q = [start, start + length];
        prop_assert!(error(q) <= BOUND, "{:?}: {}", q, error(q));
    }

    #[test]
    fn the_error_is_at_most_16_eps_for_any_two_numbers_of_moderate_size(bits in any::<[u64; 2]>()) {
        let q = bits.map(f64::from_bits);
        prop_assume!(q.iter().all(|q| q.abs() <= 1e300));
        prop_assert!(error(q) <= BOUND, "{:?}: {}", q, error(q));
    }
}
