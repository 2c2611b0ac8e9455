//! The energy of a segment: its oracle, the integral of |eta|^2 over the plane, limits, positivity and bad input.

use iridescence::Complex;
use iridescence::diffraction::{Coherence, Segment, segment_energy, spatial_phase, spatial_phase_infinite_squared};
use iridescence::special::faddeeva_w_derivative;
use proptest::prelude::*;
use reference::generate::random::Random;
use reference::metrics::absolute_error;
use reference::oracle;
use std::f64::consts::PI;

/// Largest error in eps of 2 pi^{3/2} sigma^3 (L exp(-q^2) + sigma |w'(q)|).
const BOUND: f64 = 64.0;
/// Largest relative error, in eps, of a short and slowly turning segment.
const SHORT_BOUND: f64 = 24.0;

/// sigma lambda xi1 length.
type Row = [f64; 4];

fn energy([radius, wavelength, xi1, length]: Row) -> f64 {
    segment_energy(Coherence { radius, wavelength }, length, xi1)
}

fn reduced([radius, wavelength, xi1, length]: Row) -> (f64, f64) {
    (2.0 * PI * radius * xi1 / wavelength, 0.5 * length / radius)
}

fn hold(row: Row) {
    let (q, half) = reduced(row);
    let error = absolute_error(energy(row), &oracle::segment_energy(&row));
    let slope = faddeeva_w_derivative(Complex::new(q, 0.0)).norm();
    let scale = 2.0 * PI.powf(1.5) * row[0].powi(3) * (row[3] * (-q * q).exp() + row[0] * slope);
    let eps = error / (scale * f64::EPSILON);
    assert!(eps <= BOUND, "{row:?}: {eps} eps of the envelope, {}", energy(row));
    if half < 0.4999 && (q * half).abs() < 0.9999 {
        let truth = oracle::segment_energy(&row).value();
        let relative = error / (truth * f64::EPSILON);
        assert!(relative <= SHORT_BOUND, "{row:?}: {relative} eps");
    }
}

fn scratch(random: &mut Random) -> Row {
    let xi1 = random.log_uniform(1e-7, 2.0);
    [
        random.pick(&[10.0, 25.2, 60.0]),
        random.uniform(0.38, 0.78),
        random.signed(xi1),
        random.log_uniform(1e-3, 1e5),
    ]
}

#[test]
fn segments_of_any_length_and_direction_keep_the_bounds() {
    let mut random = Random::new(701);
    for _ in 0..10_000 {
        hold(scratch(&mut random));
        // Both sides of the switches at L = sigma and q L/(2 sigma) = 1.
        let mut row = scratch(&mut random);
        let beside = 1.0 + random.pick(&[1e-15, -1e-15, 1e-3, -1e-3]);
        row[3] = row[0] * beside;
        row[2] = random.log_uniform(1e-9, 1e-2);
        hold(row);
        row[3] = row[0] * random.log_uniform(1e-9, 1.0);
        row[2] = row[1] / (PI * row[3]) * beside;
        hold(row);
        row[3] = 56.0 * row[0] * beside;
        row[2] = random.uniform(0.0, 0.02);
        hold(row);
    }
}

#[test]
fn it_is_the_integral_of_eta_squared_over_the_places_of_the_window() {
    let mut random = Random::new(702);
    for _ in 0..40 {
        let [radius, wavelength, ..] = scratch(&mut random);
        let length = random.log_uniform(0.1, 20.0) * radius;
        let xi1 = random.uniform(-3.0, 3.0) * wavelength / (2.0 * PI * radius);
        let light = Coherence { radius, wavelength };
        // The trapezoid rule over analytic integrands that vanish at both ends: exact once the steps resolve them.
        let steps = [0.25 * radius, 0.4 * radius];
        let along = ((0.5 * length + 9.0 * radius) / steps[0]) as i32;
        let mut sum = 0.0;
        for across in -22..=22 {
            for place in -along..=along {
                let segment = Segment {
                    position: [f64::from(place) * steps[0], f64::from(across) * steps[1]],
                    ends: [-0.5 * length, 0.5 * length],
                };
                sum += spatial_phase(light, segment, [xi1, 0.3]).norm_sqr();
            }
        }
        let due = sum * steps[0] * steps[1];
        let value = segment_energy(light, length, xi1);
        assert!(
            (value - due).abs() <= 1e-11 * segment_energy(light, length, 0.0),
            "{radius} {length} {xi1}"
        );
    }
}

#[test]
fn a_long_segment_has_the_rate_of_the_infinite_scratch() {
    let light = Coherence {
        radius: 20.0,
        wavelength: 0.5,
    };
    for xi1 in [0.0, 1e-3, 4e-3, 1e-2] {
        // The integral over s_b of |eta|^2, per length.
        let rate = spatial_phase_infinite_squared(light, 0.0, xi1) * PI.sqrt() * 20.0;
        let difference = segment_energy(light, 3e5, xi1) - segment_energy(light, 2e5, xi1);
        let noise = 1e-13 * segment_energy(light, 3e5, xi1);
        assert!(
            (difference - 1e5 * rate).abs() <= 1e-12 * 1e5 * rate + noise,
            "{xi1}: {difference} {rate}"
        );
    }
}

#[test]
fn limits_and_bad_input_have_their_values() {
    let infinity = f64::INFINITY;
    assert_eq!(energy([10.0, 0.5, 0.1, 0.0]), 0.0);
    assert_eq!(energy([0.0, 0.5, 0.1, 3.0]), 0.0);
    assert_eq!(energy([10.0, 0.5, infinity, 3.0]), 0.0);
    assert_eq!(energy([10.0, 0.5, 0.1, infinity]), infinity);
    assert_eq!(energy([infinity, 0.5, 0.1, 3.0]), infinity);
    for bad in [
        [-1.0, 0.5, 0.1, 3.0],
        [10.0, 0.0, 0.1, 3.0],
        [10.0, -0.5, 0.1, 3.0],
        [10.0, 0.5, 0.1, -3.0],
        [f64::NAN, 0.5, 0.1, 3.0],
        [10.0, f64::NAN, 0.1, 3.0],
        [10.0, 0.5, f64::NAN, 3.0],
        [10.0, 0.5, 0.1, f64::NAN],
        [10.0, 0.5, infinity, infinity],
    ] {
        assert!(energy(bad).is_nan(), "{bad:?}");
    }
    // A segment much shorter than the radius: pi sigma^2 L^2.
    let due = PI * 100.0 * 1e-12;
    assert!((energy([10.0, 0.5, 0.1, 1e-6]) / due - 1.0).abs() < 1e-9);
}

#[test]
fn no_numbers_give_a_negative_energy_or_none() {
    never_negative(703, 100_000);
}

#[test]
#[ignore = "1e7 rows: in release only"]
fn ten_million_rows_give_no_negative_energy_nor_none() {
    never_negative(713, 10_000_000);
}

fn never_negative(seed: u64, count: usize) {
    let mut random = Random::new(seed);
    for k in 0..count {
        let row: Row = std::array::from_fn(|index| {
            let any = f64::from_bits(random.bits() >> 1);
            let x = match (k + index) % 2 {
                0 if any.is_finite() => any,
                _ => random.log_uniform(1e-9, 1e9),
            };
            x.max(5e-324)
        });
        let value = energy(row);
        assert!(value >= 0.0, "{row:?}: {value}");
    }
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, cases: 2000, ..ProptestConfig::default() })]

    #[test]
    fn it_is_even_in_xi1_and_largest_at_zero(
        radius in 1.0..100.0f64,
        xi1 in -2.0..2.0f64,
        length in (-6.0..6.0f64).prop_map(|e| 10f64.powf(e)),
    ) {
        let value = energy([radius, 0.55, xi1, length]);
        prop_assert_eq!(value, energy([radius, 0.55, -xi1, length]));
        prop_assert!(value <= energy([radius, 0.55, 0.0, length]) * (1.0 + 1e-14));
    }
}
