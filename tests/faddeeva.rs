//! The Faddeeva function, its tiers and its derivative: limits, symmetry, certified digits, worst inputs, borders of the
//! regions, and random points of each half plane against the oracle.

use iridescence::Complex;
use iridescence::special::{
    erfcx, faddeeva_w, faddeeva_w_coarse, faddeeva_w_derivative, faddeeva_w_fine, faddeeva_w_medium,
};
use proptest::prelude::*;
use reference::generate::complex_points::{self as points, far_from_zeros};
use reference::generate::random::{Random, neighbour};
use reference::generate::worst;
use reference::golden;
use reference::metrics::complex::{absolute_error, eps_error, ulp_error};
use reference::metrics::{MISMATCH, Reference};
use reference::oracle::{self, zeros};
use reference::registry::Precision::F64;
use std::f64::consts::{FRAC_2_SQRT_PI, FRAC_PI_2, PI};

/// Largest norm-wise error in eps above the real axis, below it, and in the discs about the first zeros.
const ABOVE: f64 = 2.0;
const BELOW: f64 = 16.0;
const BESIDE_A_ZERO: f64 = 64.0;
/// Largest error of each component in units of its own last place, above the real axis.
const COMPONENT: f64 = 8.0;
/// Largest norm-wise error of the derivative in eps of the larger of |w'(z)| and |w'(-z)|.
const DERIVATIVE: f64 = 48.0;

type Function = fn(Complex<f64>) -> Complex<f64>;
type Pair = [Reference; 2];

/// The tiers and their relative errors.
const TIERS: [(&str, Function, f64); 3] = [
    ("fine", faddeeva_w_fine, 1e-10),
    ("medium", faddeeva_w_medium, 4e-7),
    ("coarse", faddeeva_w_coarse, 5e-5),
];
/// All that have the domain and the limits of w.
const ALL: [Function; 4] = [faddeeva_w, faddeeva_w_fine, faddeeva_w_medium, faddeeva_w_coarse];

fn at(function: Function, [x, y]: [f64; 2]) -> [f64; 2] {
    let value = function(Complex::new(x, y));
    [value.re, value.im]
}

fn bits(z: [f64; 2]) -> [u64; 2] {
    z.map(f64::to_bits)
}

fn is_finite(truth: &Pair) -> bool {
    truth.iter().all(|part| part.value().is_finite())
}

/// Modulus of a truth; smaller ones count as the smallest normal number.
fn size(truth: &Pair) -> f64 {
    truth[0].value().hypot(truth[1].value()).max(f64::MIN_POSITIVE)
}

/// Whether the two terms of w = 2 exp(-z^2) - w(-z) differ by e^3 in size.
fn nothing_cancels([x, y]: [f64; 2]) -> bool {
    let (x, y) = (x.abs(), y.abs());
    let ratio = (y - x) * (y + x) + (2.0 * PI.sqrt() * x.hypot(y)).ln();
    x.hypot(y) > 4.0 && ratio.abs() > 3.0
}

/// The norm-wise bound at z; none beside zeros beyond the first eight.
fn bound(z: [f64; 2]) -> Option<f64> {
    let beside = |zero: &[[f64; 3]; 2]| (z[0].abs() - zero[0][0]).hypot(z[1] - zero[1][0]) < 0.2;
    if z[1] >= 0.0 {
        Some(ABOVE)
    } else if far_from_zeros(z) || nothing_cancels(z) {
        Some(BELOW)
    } else {
        zeros::W.iter().any(beside).then_some(BESIDE_A_ZERO)
    }
}

/// Why w(z) breaks its bounds, if it does. Where the truth overflows, the class and the sign of each component decide.
fn fault(z: [f64; 2], truth: &Pair) -> Option<String> {
    let value = at(faddeeva_w, z);
    let error = if is_finite(truth) {
        eps_error(value, truth, F64)
    } else {
        let due = |k: usize| match truth[k].value() {
            part if part.is_finite() => value[k].is_finite(),
            part => value[k].to_bits() == part.to_bits(),
        };
        if due(0) && due(1) { 0.0 } else { MISMATCH }
    };
    if error > bound(z)? {
        return Some(format!("{z:?}: {error} eps, {value:?} for {truth:?}"));
    }
    let units = ulp_error(value, truth, F64);
    (z[1] >= 0.0 && units > COMPONENT).then(|| format!("{z:?}: {units} ulp, {value:?} for {truth:?}"))
}

fn hold(z: [f64; 2]) {
    if let Some(fault) = fault(z, &oracle::faddeeva_w(z[0], z[1])) {
        panic!("{fault}");
    }
}

#[test]
fn the_limits_at_infinity_and_for_nan_are_those_of_the_documentation() {
    let inf = f64::INFINITY;
    for function in ALL {
        for x in [0.0, 1e-300, 0.7, 30.0, f64::MAX] {
            for y in [0.0, -0.0, 2.0, -2.0, f64::MAX, -f64::MAX, inf] {
                assert_eq!(bits(at(function, [inf, y])), bits([0.0, 0.0]), "{y}");
                assert_eq!(bits(at(function, [-inf, y])), bits([0.0, -0.0]), "{y}");
            }
            assert_eq!(bits(at(function, [x, inf])), bits([0.0, 0.0]), "{x}");
            assert_eq!(bits(at(function, [-x, inf])), bits([0.0, -0.0]), "{x}");
            let below = at(function, [x, -inf]);
            if x == 0.0 {
                assert_eq!(bits(below), bits([inf, 0.0]));
                assert_eq!(bits(at(function, [-x, -inf])), bits([inf, -0.0]));
            } else {
                assert!(below[0].is_nan() && below[1].is_nan(), "{x}");
            }
        }
        assert!(at(function, [inf, -inf]).iter().all(|part| part.is_nan()));
    }
    for z in points::non_finite() {
        let (w, derivative) = (
            oracle::faddeeva_w(z[0], z[1]),
            oracle::faddeeva_w_derivative(z[0], z[1]),
        );
        for function in ALL {
            assert_eq!(ulp_error(at(function, z), &w, F64), 0.0, "{z:?}");
        }
        assert_eq!(ulp_error(at(faddeeva_w_derivative, z), &derivative, F64), 0.0, "{z:?}");
        if z[0].is_nan() || z[1].is_nan() {
            for function in ALL.into_iter().chain([faddeeva_w_derivative as Function]) {
                assert!(at(function, z).iter().all(|part| part.is_nan()), "{z:?}");
            }
        }
    }
}

#[test]
fn the_value_at_zero_is_one_and_that_on_the_imaginary_axis_is_erfcx() {
    assert_eq!(bits(at(faddeeva_w, [0.0, 0.0])), bits([1.0, 0.0]));
    assert_eq!(at(faddeeva_w_derivative, [0.0, 0.0]), [0.0, FRAC_2_SQRT_PI]);
    for y in (points::ERFCX_LINE.rows)(5, 3000) {
        let due = erfcx(y);
        assert_eq!(bits(at(faddeeva_w, [0.0, y])), bits([due, 0.0]), "{y:e}");
        assert_eq!(bits(at(faddeeva_w, [-0.0, y])), bits([due, -0.0]), "{y:e}");
    }
}

#[test]
fn certified_digits_are_met() {
    let rows = golden::faddeeva_w();
    assert!(rows.len() > 400);
    for row in rows {
        let fault = fault([row.inputs[0], row.inputs[1]], &row.truth);
        assert!(fault.is_none(), "{}", fault.unwrap_or_default());
    }
}

#[test]
fn recorded_worst_inputs_and_edges_of_both_half_planes_keep_the_bounds() {
    let recorded = worst::recorded_for(&["faddeeva_w"]).into_iter().map(|z| [z[0], z[1]]);
    for [x, y] in recorded.chain(points::edges()) {
        hold([x, y]);
        hold([x, -y]);
    }
}

/// Points on the borders of the regions and some units and parts beside them.
fn borders(seed: u64, count: usize) -> Vec<[f64; 2]> {
    let mut random = Random::new(seed);
    let mut found = Vec::new();
    while found.len() < count {
        let angle = random.pick(&[
            random.clone().uniform(0.0, FRAC_PI_2),
            random.clone().log_uniform(1e-18, 1.5),
        ]);
        let (sine, cosine) = angle.sin_cos();
        let (low, cell) = (random.uniform(0.0, 0.35), random.integer(0, 112) as f64);
        let far = random.log_uniform(1e-9, 1e150);
        let z = match random.integer(0, 8) {
            0 => [7.0 * cosine, 7.0 * sine],
            1 => [2.5 * cosine, 2.5 * sine],
            2 => [1.4 / 1.25f64.sqrt() * cosine, 1.4 * sine],
            3 => [random.uniform(0.7, 7.1), 0.5],
            4 => [0.75, low],
            5 => [0.25 * cell + 0.125, low],
            6 => [
                random.uniform(6.9, 28.1),
                random.pick(&[2f64.powi(-10), 2f64.powi(-30)]),
            ],
            7 => [random.pick(&[8.0, 28.0]), random.log_uniform(1e-12, 0.1)],
            _ => [random.pick(&[2f64.powi(500), 2f64.powi(26), 2f64.powi(-27)]), far],
        };
        let [x, y] = if random.chance(0.3) { [z[1], z[0]] } else { z };
        let beside = |random: &mut Random, x: f64| match random.integer(0, 2) {
            0 => x * (1.0 + random.uniform(-1e-6, 1e-6)),
            _ => neighbour(x, random.integer(-3, 3)),
        };
        found.push([beside(&mut random, x), beside(&mut random, y)]);
    }
    found
}

#[test]
fn neighbours_of_every_border_of_regions_keep_the_bounds() {
    for [x, y] in borders(1, 12_000) {
        hold([x, y]);
        hold([-x, -y]);
    }
}

#[test]
fn every_kind_of_point_keeps_the_bounds() {
    for domain in [
        points::UPPER_HALF_PLANE,
        points::NEAR_REAL_AXIS,
        points::NEAR_IMAGINARY_AXIS,
        points::UPPER_TAIL,
        points::RING,
        points::REAL_LINE,
        points::LOWER_HALF_PLANE,
        points::ZEROS_OF_W,
    ] {
        for z in (domain.rows)(31, 4000).chunks(2) {
            hold([z[0], z[1]]);
        }
    }
}

#[test]
fn the_diagonal_below_the_axis_keeps_the_bound_far_out() {
    let mut random = Random::new(9);
    for _ in 0..2000 {
        let x = random.log_uniform(10.0, 1e12);
        let y = (x * (1.0 + random.uniform(5.0, 650.0) / (2.0 * x * x))).max(x);
        hold([random.signed(x), -y]);
    }
}

#[test]
fn a_component_that_overflows_below_the_axis_is_infinite_with_its_sign() {
    let mut random = Random::new(8);
    let mut infinite = [0; 2];
    for _ in 0..4000 {
        let x = random.log_uniform(1e-300, 1e160);
        let beyond = random.log_uniform(1.0, 1e6);
        let y = if x < 1e4 {
            (x * x + 700.0 + beyond).sqrt()
        } else {
            x * 1.5
        };
        let z = [random.signed(x), -y];
        let truth = oracle::faddeeva_w(z[0], z[1]);
        for (k, count) in infinite.iter_mut().enumerate() {
            *count += u32::from(truth[k].value().is_infinite());
        }
        hold(z);
    }
    assert!(infinite.iter().all(|&count| count > 2000), "{infinite:?}");
}

#[test]
fn the_tiers_keep_their_errors() {
    let below = points::LOWER_HALF_PLANE;
    for domain in [
        points::UPPER_HALF_PLANE,
        points::NEAR_REAL_AXIS,
        points::RING,
        below,
        points::ZEROS_OF_W,
    ] {
        for z in (domain.rows)(32, 3000).chunks(2) {
            let (truth, opposite) = (oracle::faddeeva_w(z[0], z[1]), oracle::faddeeva_w(-z[0], -z[1]));
            if !is_finite(&truth) {
                continue;
            }
            let scale = if z[1] < 0.0 {
                size(&truth).max(size(&opposite))
            } else {
                size(&truth)
            };
            for (name, tier, bound) in TIERS {
                let error = absolute_error(at(tier, [z[0], z[1]]), &truth) / scale;
                assert!(error <= bound, "{name} at {z:?}: {error:e}");
            }
        }
    }
}

/// Error of the derivative in eps of the larger of |w'(z)| and |w'(-z)|.
fn derivative_error(z: [f64; 2], truth: &Pair) -> f64 {
    let opposite = oracle::faddeeva_w_derivative(-z[0], -z[1]);
    absolute_error(at(faddeeva_w_derivative, z), truth) / size(truth).max(size(&opposite)) / f64::EPSILON
}

#[test]
fn the_derivative_keeps_its_bound() {
    let mut held: Vec<([f64; 2], Pair)> = Vec::new();
    for row in golden::faddeeva_w_derivative() {
        held.push(([row.inputs[0], row.inputs[1]], row.truth));
    }
    let domains = [points::UPPER_HALF_PLANE, points::LOWER_HALF_PLANE, points::RING];
    let rows: Vec<f64> = domains.iter().flat_map(|domain| (domain.rows)(33, 3000)).collect();
    let recorded = worst::recorded_for(&["faddeeva_w_derivative"])
        .into_iter()
        .map(|z| [z[0], z[1]]);
    for z in rows
        .chunks(2)
        .map(|z| [z[0], z[1]])
        .chain(borders(2, 3000))
        .chain(recorded)
    {
        held.push((z, oracle::faddeeva_w_derivative(z[0], z[1])));
    }
    for (z, truth) in held {
        if is_finite(&truth) {
            let error = derivative_error(z, &truth);
            assert!(error <= DERIVATIVE, "{z:?}: {error} eps, {truth:?}");
        }
    }
}

#[test]
fn the_derivative_is_that_of_the_differential_equation() {
    for z in (points::UPPER_HALF_PLANE.rows)(34, 6000).chunks(2) {
        let z = Complex::new(z[0], z[1]);
        let (w, derivative) = (faddeeva_w(z), faddeeva_w_derivative(z));
        let due = Complex::new(0.0, FRAC_2_SQRT_PI) - 2.0 * z * w;
        let slack =
            DERIVATIVE * f64::EPSILON * derivative.norm() + 4.0 * f64::EPSILON * (1.0 + 2.0 * z.norm() * w.norm());
        assert!((derivative - due).norm() <= slack, "{z:?}: {derivative:?}, {due:?}");
    }
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, cases: 6000, ..ProptestConfig::default() })]

    #[test]
    fn the_mirror_image_has_the_conjugate_value_bit_for_bit(pattern in any::<[u64; 2]>(), moderate in -30.0..30.0f64) {
        let [x, y] = pattern.map(f64::from_bits);
        for y in [y, moderate] {
            for x in [x, moderate] {
                for (k, function) in ALL.into_iter().chain([faddeeva_w_derivative as Function]).enumerate() {
                    let ([re, im], mirrored) = (at(function, [x, y]), at(function, [-x, y]));
                    if re.is_nan() || im.is_nan() {
                        prop_assert!(mirrored.iter().all(|part| part.is_nan()) && re.is_nan() && im.is_nan());
                    } else if k < ALL.len() {
                        prop_assert_eq!(bits(mirrored), bits([re, -im]), "{} {:e} {:e}", k, x, y);
                    } else {
                        prop_assert_eq!(mirrored, [-re, im], "{:e} {:e}", x, y);
                    }
                }
            }
        }
    }

    #[test]
    fn the_error_keeps_the_bounds(
        x in prop_oneof![-12.0..12.0f64, -3.0..3.0f64, (-320.0..150.0f64).prop_map(|e| 10f64.powf(e))],
        y in prop_oneof![-6.0..12.0f64, 0.0..1.0f64, (-320.0..150.0f64).prop_map(|e| 10f64.powf(e))],
    ) {
        let fault = fault([x, y], &oracle::faddeeva_w(x, y));
        prop_assert!(fault.is_none(), "{}", fault.unwrap_or_default());
    }
}
