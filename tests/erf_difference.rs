//! The scaled erf difference: exact symmetries and limits, certified digits, worst inputs, additivity, finite values for
//! any bits, and random segments against the oracle.

use iridescence::Complex;
use iridescence::special::erf_difference_scaled as difference;
use proptest::prelude::*;
use reference::generate::random::{Random, neighbour};
use reference::generate::{erf_differences as rows, worst};
use reference::golden;
use reference::metrics::Reference;
use reference::metrics::complex::{absolute_error, eps_error};
use reference::oracle;
use reference::registry::Precision::F64;
use std::f64::consts::{FRAC_2_SQRT_PI, PI};

/// Largest error in eps of the value at b = 0.
const BOUND: f64 = 6.0;
/// Largest error in eps of the lobe: the sum of the moduli of the terms that are subtracted.
const LOBE: f64 = 6.0;
/// Largest relative error in eps where the value is at least the lobe over `SHARE`.
const RELATIVE: f64 = 64.0;
const SHARE: f64 = 8.0;

type Pair = [Reference; 2];

fn at([a1, a2, b]: [f64; 3]) -> [f64; 2] {
    let value = difference(a1, a2, b);
    [value.re, value.im]
}

fn bits(z: [f64; 2]) -> [u64; 2] {
    z.map(f64::to_bits)
}

fn is_finite(z: [f64; 2]) -> bool {
    z[0].is_finite() && z[1].is_finite()
}

fn size(truth: &Pair) -> f64 {
    truth[0].value().hypot(truth[1].value())
}

/// |G(a1, a2, 0)|, the largest modulus over b.
fn peak([a1, a2, _]: [f64; 3]) -> f64 {
    size(&oracle::erf_difference_scaled(a1, a2, 0.0)).max(f64::MIN_POSITIVE)
}

/// The moduli of the terms whose sum G is: exp(-a^2) |w(b + i |a|)| at each end, and 2 exp(-b^2) between ends on both
/// sides of 0. At most the peak.
fn lobe([a1, a2, b]: [f64; 3]) -> f64 {
    let end = |a: f64| {
        if a.abs() > 30.0 {
            0.0
        } else {
            (-a * a).exp() * size(&oracle::faddeeva_w(b, a.abs()))
        }
    };
    let between = if (a1 < 0.0) == (a2 < 0.0) {
        0.0
    } else {
        2.0 * (-b * b).exp()
    };
    (end(a1) + end(a2) + between)
        .min(peak([a1, a2, b]))
        .max(f64::MIN_POSITIVE)
}

/// Holds the value at a row to its truth: against the peak, against the lobe, and relative where the value is no small
/// share of its lobe.
fn hold_to(row: [f64; 3], truth: &Pair) {
    let value = at(row);
    assert!(is_finite(value), "{row:?}: {value:?}");
    let error = absolute_error(value, truth) / f64::EPSILON;
    assert!(
        error <= BOUND * peak(row),
        "{row:?}: {} eps of the peak",
        error / peak(row)
    );
    let lobe = lobe(row);
    assert!(error <= LOBE * lobe, "{row:?}: {} eps of the lobe", error / lobe);
    if size(truth) >= (lobe / SHARE).max(f64::MIN_POSITIVE) {
        let relative = eps_error(value, truth, F64);
        assert!(relative <= RELATIVE, "{row:?}: {relative} eps");
    }
}

fn hold(row: [f64; 3]) {
    hold_to(row, &oracle::erf_difference_scaled(row[0], row[1], row[2]));
}

#[test]
fn equal_ends_and_an_infinite_b_give_exactly_zero() {
    let numbers = [0.0, 5e-324, 1e-300, 0.4, 1.0, 27.9, 1e5, 1e300, f64::MAX, f64::INFINITY];
    for b in numbers {
        for a in numbers.into_iter().flat_map(|a| [a, -a]) {
            for b in [b, -b] {
                assert_eq!(bits(at([a, a, b])), [0, 0], "{a:e} {b:e}");
            }
            assert_eq!(bits(at([a, 0.7, f64::INFINITY])), [0, 0], "{a:e}");
            assert_eq!(bits(at([a, -0.7, f64::NEG_INFINITY])), [0, 0], "{a:e}");
        }
        assert_eq!(bits(at([-0.0, 0.0, b])), [0, 0], "{b:e}");
    }
}

#[test]
fn nan_in_any_argument_gives_nan_in_both_components() {
    for other in [0.0, 1.0, -3.0, f64::INFINITY, f64::NEG_INFINITY, f64::NAN] {
        for another in [0.0, 2.5, f64::INFINITY, f64::NAN] {
            let nan = f64::NAN;
            for row in [[nan, other, another], [other, nan, another], [other, another, nan]] {
                assert!(at(row).iter().all(|part| part.is_nan()), "{row:?}");
            }
        }
    }
}

#[test]
fn infinite_ends_are_limits() {
    let (inf, far) = (f64::INFINITY, 40.0);
    for b in [0.0, 1e-300, 0.3, 2.0, 5.0, 26.0, 30.0, 1e3, 1e155, f64::MAX] {
        let [re, im] = at([-inf, inf, b]);
        let whole = 2.0 * (-b * b).exp();
        assert!(
            (re - whole).abs() <= 4.0 * f64::EPSILON * whole && im == 0.0,
            "{b}: {re:e}"
        );
        for a in [0.0, 0.4, 3.0, -1.5] {
            assert_eq!(bits(at([a, inf, b])), bits(at([a, far, b])), "{a} {b}");
            assert_eq!(bits(at([-inf, a, b])), bits(at([-far, a, b])), "{a} {b}");
        }
    }
    for row in rows::non_finite() {
        let truth = oracle::erf_difference_scaled(row[0], row[1], row[2]);
        if truth[0].hi.is_nan() {
            assert!(at(row).iter().all(|part| part.is_nan()), "{row:?}");
        } else {
            hold_to(row, &truth);
        }
    }
}

#[test]
fn at_b_zero_the_value_is_the_difference_of_real_error_functions() {
    for k in -120..=120 {
        let a = f64::from(k) / 32.0;
        for end in [a + 1.0, 0.0, 6.0, f64::INFINITY, -f64::INFINITY] {
            let [re, im] = at([a, end, 0.0]);
            let due = libm::erf(end) - libm::erf(a);
            assert!(
                (re - due).abs() <= 4.0 * f64::EPSILON && im == 0.0,
                "{a} {end}: {re} {due}"
            );
        }
    }
}

#[test]
fn certified_digits_are_met() {
    let rows = golden::erf_difference_scaled();
    assert!(rows.len() > 400);
    for row in rows {
        hold_to([row.inputs[0], row.inputs[1], row.inputs[2]], &row.truth);
    }
}

#[test]
fn recorded_worst_rows_keep_the_bounds() {
    for row in worst::recorded_for(&["erf_difference_scaled"]) {
        hold([row[0], row[1], row[2]]);
    }
}

#[test]
fn segments_of_every_kind_keep_the_bounds() {
    for domain in [rows::SCRATCH, rows::SHORT, rows::ANY] {
        for row in (domain.rows)(51, 4000).chunks(3) {
            hold([row[0], row[1], row[2]]);
        }
    }
}

#[test]
fn segments_on_both_sides_of_every_switch_keep_the_bounds() {
    let mut random = Random::new(52);
    for _ in 0..3000 {
        let (m, b) = (random.uniform(-6.0, 6.0), random.log_uniform(1e-2, 1e8));
        let beside = 1.0 + random.pick(&[1e-15, -1e-15, 1e-3, -1e-3]);
        // The series ends at half |m + i b| = 1/4 and half = 1/2; exp(-a^2) at a = 28; the half turn between the ends
        // is where a lobe ends.
        let half = 0.25 / m.hypot(b) * beside;
        hold([m - half, m + half, random.signed(b)]);
        hold([-0.5 * beside + 1e-9 * m, 0.5, 0.01 * m]);
        hold([28.0 * beside - 0.5, 28.0 * beside, m]);
        hold([m, neighbour(m, 1), b]);
        let lobe = PI / b;
        hold([m, m + lobe * f64::from(random.integer(1, 4) as i32) * beside, b]);
    }
}

#[test]
fn a_segment_of_one_unit_has_its_length_times_the_integrand() {
    let mut random = Random::new(53);
    for _ in 0..3000 {
        let (a, b) = (random.uniform(0.01, 5.0), random.uniform(0.0, 20.0));
        let end = neighbour(a, 1);
        let value = difference(a, end, b);
        let due = FRAC_2_SQRT_PI * (end - a) * (-a * a).exp();
        assert!((value.norm() / due - 1.0).abs() <= 1e-14, "{a} {b}: {value} {due:e}");
        let turned = Complex::new(0.0, -2.0 * a * b).exp();
        assert!((value / due - turned).norm() <= 1e-13, "{a} {b}: {value}");
    }
}

#[test]
fn huge_b_and_huge_phases_keep_the_bounds() {
    let mut random = Random::new(54);
    for _ in 0..3000 {
        let b = random.log_uniform(1e6, 1e300);
        let (a1, a2) = (random.uniform(-8.0, 8.0), random.uniform(-8.0, 8.0));
        hold([a1, a2, random.signed(b)]);
        let tiny = random.log_uniform(1e-3, 1e6) / b;
        hold([tiny, 2.5 * tiny, b]);
        hold([-tiny, 3.0, b]);
        hold([a1, a1 + tiny, b]);
    }
}

#[test]
fn adjoining_segments_add_up_to_the_whole() {
    let mut random = Random::new(55);
    for row in (rows::ANY.rows)(56, 6000).chunks(3) {
        let [a, c, b] = [row[0].min(row[1]), row[0].max(row[1]), row[2]];
        let inner = a + (c - a) * random.uniform(0.0, 1.0);
        if !(inner >= a && inner <= c) {
            continue;
        }
        let (first, second, whole) = (difference(a, inner, b), difference(inner, c, b), difference(a, c, b));
        let scale = lobe([a, inner, b]) + lobe([inner, c, b]) + lobe([a, c, b]);
        let rest = (first + second - whole).norm();
        assert!(
            rest <= LOBE * f64::EPSILON * scale,
            "{a:e} {inner:e} {c:e} {b:e}: {rest:e} of {scale:e}"
        );
    }
}

#[test]
fn no_bits_of_three_numbers_give_a_value_that_is_not_finite_or_beyond_two() {
    let count = if cfg!(debug_assertions) { 100_000 } else { 1_000_000 };
    let mut random = Random::new(57);
    let moderate = |random: &mut Random| {
        let x = random.log_uniform(1e-10, 1e10);
        random.signed(x)
    };
    for k in 0..count {
        let row = [0; 3].map(|_| {
            let any = f64::from_bits(random.bits());
            let limit = random.pick(&[f64::INFINITY, f64::NEG_INFINITY, f64::MAX, 5e-324, 0.0, -0.0]);
            match random.integer(0, 7) {
                0 => limit,
                1..4 if k % 2 == 0 => moderate(&mut random),
                _ if any.is_nan() => limit,
                _ => any,
            }
        });
        let value = difference(row[0], row[1], row[2]);
        let modulus = value.norm();
        assert!(modulus <= 2.0 * (1.0 + BOUND * f64::EPSILON), "{row:?}: {value:?}");
    }
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, cases: 6000, ..ProptestConfig::default() })]

    #[test]
    fn exchanged_ends_negate_and_a_negative_b_conjugates_bit_for_bit(
        pattern in any::<[u64; 3]>(),
        moderate in [-9.0..9.0f64, -9.0..9.0f64, -40.0..40.0f64],
        length in (-16.0..1.0f64).prop_map(|e| 10f64.powf(e)),
    ) {
        let short = [moderate[0], moderate[0] + length, moderate[2]];
        for [a1, a2, b] in [pattern.map(f64::from_bits), moderate, short] {
            let [re, im] = at([a1, a2, b]);
            if re.is_nan() {
                prop_assert!(a1.is_nan() || a2.is_nan() || b.is_nan());
                continue;
            }
            // Zeros have no sign of their own.
            prop_assert_eq!(at([a2, a1, b]), [-re, -im], "{:e} {:e} {:e}", a1, a2, b);
            prop_assert_eq!(at([a1, a2, -b]), [re, -im], "{:e} {:e} {:e}", a1, a2, b);
            prop_assert_eq!(at([-a2, -a1, b]), [re, -im], "{:e} {:e} {:e}", a1, a2, b);
        }
    }

    #[test]
    fn the_errors_keep_the_bounds(
        a1 in -6.0..6.0f64,
        length in (-15.0..1.2f64).prop_map(|e| 10f64.powf(e)),
        b in prop_oneof![-10.0..10.0f64, (-3.0..6.0f64).prop_map(|e| 10f64.powf(e))],
    ) {
        hold([a1, a1 + length, b]);
    }
}
