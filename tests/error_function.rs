//! erf and erfc of a complex argument and erfcx: limits, symmetries, certified digits, worst inputs, the real line, and
//! random points against the oracle.

use iridescence::Complex;
use iridescence::special::{erf_complex, erfc_complex, erfcx};
use proptest::prelude::*;
use reference::generate::complex_points as points;
use reference::generate::random::{Random, neighbour};
use reference::generate::worst;
use reference::golden::{self, ComplexRow};
use reference::metrics::complex::{eps_error, ulp_error};
use reference::metrics::{self, MISMATCH, Reference};
use reference::oracle::{self, zeros};
use reference::registry::Precision::F64;

/// Largest norm-wise error in eps, and that in the discs about the first zeros.
const BOUND: f64 = 4.0;
const BESIDE_A_ZERO: f64 = 64.0;
/// Largest error of erfcx in units of the last place.
const ERFCX: f64 = 3.0;

type Pair = [Reference; 2];

/// One of the two functions.
struct Held {
    name: &'static str,
    value: fn(Complex<f64>) -> Complex<f64>,
    truth: fn(f64, f64) -> Pair,
    golden: fn() -> Vec<ComplexRow>,
    /// Distance of z to the nearest of the first eight zeros.
    distance: fn([f64; 2]) -> f64,
    /// Whether z is farther than about 0.1 from every zero.
    plain: fn([f64; 2]) -> bool,
}

const HELD: [Held; 2] = [
    Held {
        name: "erf_complex",
        value: erf_complex,
        truth: oracle::erf_complex,
        golden: golden::erf_complex,
        distance: |z| nearest(&zeros::ERF, [z[0].abs(), z[1].abs()]),
        plain: |z| is_away_from(1.0, z),
    },
    Held {
        name: "erfc_complex",
        value: erfc_complex,
        truth: oracle::erfc_complex,
        golden: golden::erfc_complex,
        distance: |z| nearest(&zeros::W, [z[1].abs(), z[0]]),
        plain: |z| z[0] >= 0.0 || is_away_from(2.0, z),
    },
];

fn nearest(table: &[[[f64; 3]; 2]; 8], z: [f64; 2]) -> f64 {
    let distances = table.iter().map(|zero| (z[0] - zero[0][0]).hypot(z[1] - zero[1][0]));
    distances.fold(f64::INFINITY, f64::min)
}

/// Whether |exp(-z^2)/(sqrt(pi) z)|, the size of erfc(z) for Re z >= 0, is so far from `size` that no zero lies within
/// about 0.1, or that nothing cancels: its logarithm grows by 2 |z| for a unit of distance.
fn is_away_from(size: f64, [x, y]: [f64; 2]) -> bool {
    let (x, y, radius) = (x.abs(), y.abs(), x.hypot(y));
    let excess = (y - x) * (y + x) - (std::f64::consts::PI.sqrt() * radius * size).ln();
    radius < 1.4 || excess.abs() > (2.0 * radius * 0.12).min(3.0)
}

impl Held {
    fn at(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        let value = (self.value)(Complex::new(x, y));
        [value.re, value.im]
    }

    /// Error in eps; where the truth overflows, the class and the sign of each component decide.
    fn error(&self, z: [f64; 2], truth: &Pair) -> f64 {
        let value = self.at(z);
        if truth.iter().all(|part| part.value().is_finite()) {
            return eps_error(value, truth, F64);
        }
        let due = |k: usize| match truth[k].value() {
            part if part.is_finite() => value[k].is_finite(),
            part => value[k].to_bits() == part.to_bits(),
        };
        if due(0) && due(1) { 0.0 } else { MISMATCH }
    }

    /// The bound at z; none beside the zeros beyond the first eight.
    fn bound(&self, z: [f64; 2]) -> Option<f64> {
        if (self.distance)(z) < 0.2 {
            Some(BESIDE_A_ZERO)
        } else {
            (self.plain)(z).then_some(BOUND)
        }
    }

    fn hold_to(&self, z: [f64; 2], truth: &Pair) {
        let error = self.error(z, truth);
        if let Some(bound) = self.bound(z) {
            assert!(
                error <= bound,
                "{} of {z:?}: {error} eps, {:?} for {truth:?}",
                self.name,
                self.at(z)
            );
        }
    }

    fn hold(&self, z: [f64; 2]) {
        self.hold_to(z, &(self.truth)(z[0], z[1]));
    }
}

#[test]
fn the_limits_at_infinity_and_for_nan_are_those_of_the_documentation() {
    let inf = f64::INFINITY;
    for y in [0.0, -0.0, 1e-300, 3.0, -3.0, f64::MAX, -f64::MAX] {
        assert_eq!(HELD[0].at([inf, y]), [1.0, 0.0]);
        assert_eq!(HELD[0].at([-inf, y]), [-1.0, 0.0]);
        assert_eq!(HELD[1].at([inf, y]), [0.0, 0.0]);
        assert_eq!(HELD[1].at([-inf, y]), [2.0, 0.0]);
        for (k, x) in [inf, -inf].into_iter().enumerate() {
            let without_limit = [[y, x], [inf, x], [-inf, x]];
            for (held, z) in HELD
                .iter()
                .zip([without_limit[k]; 2])
                .chain(HELD.iter().zip([without_limit[0]; 2]))
            {
                assert!(held.at(z).iter().all(|part| part.is_nan()), "{} of {z:?}", held.name);
            }
        }
    }
    for held in &HELD {
        for z in points::non_finite() {
            let truth = (held.truth)(z[0], z[1]);
            let value = held.at(z);
            assert_eq!(ulp_error(value, &truth, F64), 0.0, "{} of {z:?}: {value:?}", held.name);
            if z[0].is_nan() || z[1].is_nan() {
                assert!(value.iter().all(|part| part.is_nan()), "{} of {z:?}", held.name);
            }
        }
    }
    assert_eq!(erfcx(inf).to_bits(), 0f64.to_bits());
    assert_eq!(erfcx(-inf), inf);
    assert_eq!(erfcx(-27.0), inf);
    assert!(erfcx(f64::NAN).is_nan());
    assert_eq!([erfcx(0.0), erfcx(-0.0), erfcx(5e-324)], [1.0; 3]);
    assert_eq!(bits(HELD[0].at([0.0, -0.0])), bits([0.0, -0.0]));
    assert_eq!(HELD[1].at([0.0, 0.0]), [1.0, 0.0]);
}

fn bits(z: [f64; 2]) -> [u64; 2] {
    z.map(f64::to_bits)
}

#[test]
fn certified_digits_are_met() {
    for held in &HELD {
        let rows = (held.golden)();
        assert!(rows.len() > 400, "{}", held.name);
        for row in rows {
            held.hold_to([row.inputs[0], row.inputs[1]], &row.truth);
        }
    }
}

#[test]
fn recorded_worst_inputs_and_edges_of_all_quadrants_keep_the_bounds() {
    for held in &HELD {
        let recorded = worst::recorded_for(&[held.name]).into_iter().map(|z| [z[0], z[1]]);
        for [x, y] in recorded.chain(points::edges()) {
            hold_in_all_quadrants(held, [x, y]);
        }
    }
}

fn hold_in_all_quadrants(held: &Held, [x, y]: [f64; 2]) {
    for z in [[x, y], [-x, y], [x, -y], [-x, -y]] {
        held.hold(z);
    }
}

#[test]
fn every_kind_of_point_keeps_the_bounds() {
    for domain in [
        points::WHOLE_PLANE,
        points::ZEROS_OF_ERF,
        points::ZEROS_OF_W,
        points::NEAR_REAL_AXIS,
        points::NEAR_IMAGINARY_AXIS,
        points::FIRST_QUADRANT,
        points::REAL_LINE,
    ] {
        for z in (domain.rows)(41, 900).chunks(2) {
            HELD[0].hold([z[0], z[1]]);
            // The zeros of erfc are those of w turned by a quarter.
            HELD[1].hold([z[1], -z[0]]);
            HELD[1].hold([-z[0], z[1]]);
        }
    }
}

#[test]
fn neighbours_of_every_border_of_regions_and_discs_keep_the_bounds() {
    let mut random = Random::new(42);
    for _ in 0..4000 {
        let angle = random.uniform(0.0, std::f64::consts::FRAC_PI_2);
        let (sine, cosine) = angle.sin_cos();
        let height = random.uniform(0.0, 10.0);
        for radius in [1.25, 2.75, 7.0] {
            let z = [radius * cosine, radius * sine].map(|part| neighbour(part, random.integer(-3, 3)));
            HELD.iter().for_each(|held| hold_in_all_quadrants(held, z));
        }
        for edge in [0.5, 0.75] {
            let edge = neighbour(edge, random.integer(-3, 3));
            HELD.iter().for_each(|held| hold_in_all_quadrants(held, [edge, height]));
        }
        let (sine, cosine) = (4.0 * angle).sin_cos();
        let disc = 0.125 * (1.0 + random.uniform(-1e-3, 1e-3));
        let [re, im] = random.pick(&zeros::ERF).map(|part| part[0]);
        HELD[0].hold([re + disc * cosine, im + disc * sine]);
        let [re, im] = random.pick(&zeros::W).map(|part| part[0]);
        HELD[1].hold([im + disc * cosine, re + disc * sine]);
    }
}

#[test]
fn erf_vanishes_at_no_f64_beside_its_zeros_and_changes_by_its_slope() {
    for zero in zeros::ERF {
        let [re, im] = zero.map(|part| part[0]);
        let value = HELD[0].at([re, im]);
        // |erf'| = 2/sqrt(pi) exp(y^2 - x^2) times the distance of the f64 from the zero.
        let slope = std::f64::consts::FRAC_2_SQRT_PI * ((im - re) * (im + re)).exp();
        let due = slope * zero[0][1].hypot(zero[1][1]);
        assert!(
            (value[0].hypot(value[1]) / due - 1.0).abs() < 1e-12,
            "{re} {im}: {value:?}"
        );
    }
}

#[test]
fn the_real_line_is_that_of_the_real_functions() {
    for k in -4000..=4000 {
        let x = f64::from(k) / 128.0;
        for y in [0.0, -0.0] {
            let (erf, erfc) = (HELD[0].at([x, y]), HELD[1].at([x, y]));
            assert!(
                (erf[0] - libm::erf(x)).abs() <= 2.0 * f64::EPSILON * erf[0].abs(),
                "{x}"
            );
            // libm's erfc is subnormal or zero from 26.5 on.
            let least = 4.0 * f64::EPSILON * erfc[0] + 5e-324;
            assert!(
                (erfc[0] - libm::erfc(x)).abs() <= least,
                "{x}: {erfc:?} {}",
                libm::erfc(x)
            );
            assert_eq!(bits([erf[1], erfc[1]]), bits([y, -y]), "{x}");
        }
    }
}

#[test]
fn erfcx_keeps_its_bound_and_falls() {
    let recorded = worst::recorded_for(&["erfcx"]).into_iter().flatten();
    let borders = [0.5, 1.0, 1.4, 2.5, 7.0, 26.0, 2f64.powi(26), 2f64.powi(500)];
    let beside = borders.into_iter().flat_map(|x| (-4..=4).map(move |k| neighbour(x, k)));
    let near_overflow = (0..4000).map(|k| -26.7 + f64::from(k) * 1e-5);
    let sampled = (points::ERFCX_LINE.rows)(43, 12_000).into_iter();
    for x in sampled.chain(recorded).chain(beside).chain(near_overflow) {
        let error = metrics::ulp_error(erfcx(x), &oracle::erfcx(x), F64);
        assert!(error <= ERFCX, "{x:e}: {error}");
    }
    let samples: Vec<f64> = (-2600..6000).map(|k| erfcx(f64::from(k) / 100.0)).collect();
    assert!(samples.windows(2).all(|pair| pair[0] > pair[1] && pair[1] > 0.0));
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, cases: 6000, ..ProptestConfig::default() })]

    #[test]
    fn the_symmetries_hold_bit_for_bit(pattern in any::<[u64; 2]>(), moderate in any::<[i32; 2]>()) {
        let moderate = moderate.map(|k| f64::from(k) / 2f64.powi(27));
        for [x, y] in [pattern.map(f64::from_bits), moderate] {
            for (k, held) in HELD.iter().enumerate() {
                let [re, im] = held.at([x, y]);
                let (conjugate, negated) = (held.at([x, -y]), held.at([-x, -y]));
                if re.is_nan() || im.is_nan() {
                    prop_assert!(re.is_nan() && im.is_nan() && conjugate[0].is_nan() && negated[1].is_nan());
                    continue;
                }
                prop_assert_eq!(conjugate, [re, -im], "{} {:e} {:e}", held.name, x, y);
                if k == 0 {
                    prop_assert_eq!(bits(negated), bits([-re, -im]), "{:e} {:e}", x, y);
                    prop_assert_eq!(bits(conjugate), bits([re, -im]), "{:e} {:e}", x, y);
                }
            }
        }
    }

    #[test]
    fn erf_and_erfc_add_up_to_one(x in -8.0..8.0f64, y in -8.0..8.0f64) {
        let (erf, erfc) = (HELD[0].at([x, y]), HELD[1].at([x, y]));
        let size = erf[0].hypot(erf[1]) + erfc[0].hypot(erfc[1]);
        let rest = (erf[0] + erfc[0] - 1.0).hypot(erf[1] + erfc[1]);
        prop_assert!(rest <= BOUND * f64::EPSILON * size, "{} {}: {:?} {:?}", x, y, erf, erfc);
    }

    #[test]
    fn the_errors_keep_the_bounds(
        x in prop_oneof![-6.0..6.0f64, -0.4..0.4f64, (-320.0..3.0f64).prop_map(|e| 10f64.powf(e))],
        y in prop_oneof![-6.0..6.0f64, -27.0..27.0f64, (-320.0..3.0f64).prop_map(|e| 10f64.powf(e))],
    ) {
        for held in &HELD {
            held.hold([x, y]);
        }
    }
}
