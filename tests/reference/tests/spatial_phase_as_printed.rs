//! VWH18 Eq. 5 and WVJH17 Eqs. 23 and 24, the spatial phase of a finite scratch, as printed: right as formulas, and where
//! their floating point overflows.

use errorfunctions::ComplexErrorFunctions;
use iridescence::shader;
use iridescence::special::erf_difference_scaled;
use num_complex::Complex;
use reference::as_printed::{Segment, erf_difference, erf_difference_f32, spatial_phase_vwh18_5};
use reference::generate::random::Random;
use reference::oracle;
use std::f64::consts::{PI, SQRT_2, TAU};

/// Wavelength in micrometres.
const WAVELENGTH: f64 = 0.55;

/// A scratch near its window, and the direction cosine along it for which b has this square.
fn scene(random: &mut Random, sigma: f64, square: f64) -> (Segment, f64) {
    let length = random.log_uniform(0.1, 4.0) * sigma;
    let start = random.uniform(-1.5, 0.5) * sigma;
    let segment = Segment {
        sigma,
        offset: random.uniform(-0.5, 0.5) * sigma,
        ends: [start, start + length],
    };
    (segment, square.sqrt() * SQRT_2 * WAVELENGTH / (sigma * TAU))
}

/// The factor d of VWH18 Eq. 5 with s_b = 0.
fn factor_vwh18(sigma: f64, k: f64, xi1: f64) -> f64 {
    (PI / 2.0).sqrt() * sigma * (-sigma.powi(2) / 2.0 * k.powi(2) * xi1.powi(2)).exp()
}

/// eta by ours: sqrt(pi/2) sigma times the scaled difference.
fn ours(segment: &Segment, k: f64, xi1: f64) -> Complex<f64> {
    let [a1, a2, b] = segment.arguments(k, xi1);
    (PI / 2.0).sqrt() * segment.sigma * erf_difference_scaled(a1, a2, b)
}

/// eta by its definition, the integral of window times wave over the scratch (WVJH17 Eq. 23, first line); Simpson's rule.
fn by_definition(segment: &Segment, k: f64, xi1: f64) -> Complex<f64> {
    let [from, to] = segment.ends.map(|l| segment.offset + l);
    let count = 40_000;
    let step = (to - from) / f64::from(count);
    let value = |i: i32| {
        let t = from + f64::from(i) * step;
        Complex::from_polar((-t * t / (2.0 * segment.sigma.powi(2))).exp(), -k * t * xi1)
    };
    let weight = |i: i32| {
        if i == 0 || i == count {
            1.0
        } else {
            f64::from(2 + 2 * (i % 2))
        }
    };
    (0..=count).map(|i| weight(i) * value(i)).sum::<Complex<f64>>() * (step / 3.0)
}

/// WVJH17 Eqs. 23 and 24 as printed, for a scratch of length `length` about the middle `r0` on the tangent; xi1 over the
/// wavelength.
fn eta_wvjh17_23(sigma: f64, r0: f64, length: f64, xi1: f64) -> Complex<f64> {
    let a0 = Complex::new(r0 / sigma, 2.0 * PI * sigma * xi1);
    let h = -r0.powi(2) / (2.0 * sigma.powi(2)) - 2.0 * PI.powi(2) * sigma.powi(2) * xi1.powi(2)
        + r0.powi(2) / (2.0 * sigma.powi(2));
    let f = 2.0 * PI * xi1 * r0 - 2.0 * PI * (r0 * xi1);
    let c0 = (PI / 2.0).sqrt() * sigma * Complex::new(h, f).exp();
    let erf = |x: Complex<f64>| ComplexErrorFunctions::erf(x / SQRT_2);
    c0 * (erf(a0 + length / (2.0 * sigma)) - erf(a0 - length / (2.0 * sigma)))
}

#[test]
fn equation_5_and_equation_23_are_the_integral_they_stand_for() {
    let mut random = Random::new(5);
    let k = TAU / WAVELENGTH;
    for sigma in [10.0, 60.0] {
        for square in [0.0, 0.01, 1.0, 9.0, 40.0, 300.0] {
            let (segment, xi1) = scene(&mut random, sigma, square);
            let truth = by_definition(&segment, k, xi1);
            let peak = by_definition(&segment, k, 0.0).norm();
            let printed = factor_vwh18(sigma, k, xi1) * spatial_phase_vwh18_5(&segment, k, xi1);
            let [l1, l2] = segment.ends;
            let middle = segment.offset + 0.5 * (l1 + l2);
            let earlier = eta_wvjh17_23(sigma, middle, l2 - l1, xi1 / WAVELENGTH);
            for eta in [printed, earlier, ours(&segment, k, xi1)] {
                assert!(
                    (eta - truth).norm() <= 1e-10 * peak,
                    "{segment:?} {square}: {eta} {truth}"
                );
            }
        }
    }
}

#[test]
fn equation_5_as_printed_equals_ours_where_it_is_finite() {
    let mut random = Random::new(23);
    let k = TAU / WAVELENGTH;
    for _ in 0..2000 {
        let square = random.uniform(0.0, 650.0);
        let (segment, xi1) = scene(&mut random, 60.0, square);
        let printed = factor_vwh18(60.0, k, xi1) * spatial_phase_vwh18_5(&segment, k, xi1);
        let ours = ours(&segment, k, xi1);
        // The printed form rounds b^2 before its exponential, which magnifies that by b^2.
        assert!(
            (printed - ours).norm() <= 2e-12 * 60.0,
            "{segment:?} {square}: {printed} {ours}"
        );
    }
}

#[test]
fn equation_5_as_printed_is_not_finite_beyond_the_range_of_the_exponential_and_ours_is_right_there() {
    let mut random = Random::new(745);
    let k = TAU / WAVELENGTH;
    let largest = (60.0 * k / SQRT_2).powi(2);
    for _ in 0..2000 {
        let square = random.log_uniform(746.0, largest);
        let (segment, xi1) = scene(&mut random, 60.0, square);
        let [a1, a2, b] = segment.arguments(k, xi1);
        let printed = factor_vwh18(60.0, k, xi1) * spatial_phase_vwh18_5(&segment, k, xi1);
        let factored = erf_difference([a1, a2, b]);
        for value in [printed, factored] {
            assert!(
                !value.re.is_finite() || !value.im.is_finite(),
                "{segment:?} {square}: {value}"
            );
        }
        let found = erf_difference_scaled(a1, a2, b);
        let [re, im] = oracle::erf_difference_scaled(a1, a2, b).map(|part| part.value());
        let peak = oracle::erf_difference_scaled(a1, a2, 0.0)[0].value().abs();
        assert!(
            (found - Complex::new(re, im)).norm() <= 6.0 * f64::EPSILON * peak,
            "{a1} {a2} {b}: {found} {re} {im}"
        );
    }
    for _ in 0..2000 {
        let [a1, b] = [random.uniform(-2.0, 1.5), random.log_uniform(105.0, largest).sqrt()];
        let row = [a1, a1 + random.log_uniform(1e-3, 0.5), b].map(|x| x as f32);
        let value = erf_difference_f32(row);
        assert!(!value.re.is_finite() || !value.im.is_finite(), "{row:?}: {value}");
    }
}

/// Share of the directions of a uniform hemisphere, the light at its pole, for which a result is not finite.
fn share_lost(sigma: f64, lost: impl Fn([f64; 3]) -> bool) -> f64 {
    let mut random = Random::new(18);
    let count = 4000;
    let gone = (0..count).filter(|_| {
        let (height, turn) = (random.uniform(0.0, 1.0), random.uniform(0.0, TAU));
        let xi1 = (1.0 - height * height).sqrt() * turn.cos();
        let length = random.log_uniform(1.0, 1e3);
        let segment = Segment {
            sigma,
            offset: 0.0,
            ends: [-0.25 * length, 0.75 * length],
        };
        lost(segment.arguments(TAU / WAVELENGTH, xi1))
    });
    gone.count() as f64 / f64::from(count)
}

#[test]
fn equation_5_as_printed_loses_most_of_the_hemisphere_and_ours_nothing() {
    let finite = |value: Complex<f64>| value.re.is_finite() && value.im.is_finite();
    let printed = |row: [f64; 3]| !finite(erf_difference(row));
    let printed_f32 = |row: [f64; 3]| {
        let value = erf_difference_f32(row.map(|x| x as f32));
        !(value.re.is_finite() && value.im.is_finite())
    };
    let ours = |row: [f64; 3]| !finite(erf_difference_scaled(row[0], row[1], row[2]));
    let shares = [60.0, 10.0].map(|sigma| [share_lost(sigma, printed), share_lost(sigma, printed_f32)]);
    println!("lost at 60 um and at 10 um, each in f64 and in f32: {shares:?}");
    assert!(shares[0].iter().all(|share| *share > 0.9), "{shares:?}");
    assert!(shares[1].iter().all(|share| *share > 0.5), "{shares:?}");
    assert!(
        (0..2).all(|i| shares[0][i] > shares[1][i] && shares[i][1] > shares[i][0]),
        "{shares:?}"
    );
    let ours_f32 = |row: [f64; 3]| {
        let [a1, a2, b] = row.map(|x| x as f32);
        let value = shader::erf_difference_scaled(a1, a2, b);
        !(value.re.is_finite() && value.im.is_finite())
    };
    for sigma in [60.0, 10.0] {
        assert_eq!([share_lost(sigma, ours), share_lost(sigma, ours_f32)], [0.0; 2]);
    }
}
