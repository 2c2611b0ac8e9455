//! Interference of base and scratches.

use super::{FEW, INF, LIGHT, MANY, Tally, holds_to, light};
use iridescence::Complex;
use iridescence::diffraction::{
    Coherence, Profile, Segment, base_interference_bound, base_interference_matters, base_response, profile_rectangle,
    spatial_phase,
};
use reference::generate::random::Random;
use std::f64::consts::{PI, TAU};

#[test]
fn the_base_interferes_in_full_with_equal_scratches_in_phase() {
    for (xi, one, count) in [([0.0, 0.0], 30.0, 1), ([0.01, 0.02], 2.0, 7), ([0.05, 0.0], 1e-3, 100)] {
        let base = base_response(LIGHT, xi);
        let number = count as f64;
        let share = 2.0 * base * number * one / (number * one * one);
        let bound = base_interference_bound(LIGHT, xi, number * one * one, count);
        holds_to(bound, share, 1e-14);
        assert!(!base_interference_matters(
            LIGHT,
            xi,
            number * one * one,
            count,
            share * (1.0 + 1e-9)
        ));
        assert!(base_interference_matters(
            LIGHT,
            xi,
            number * one * one,
            count,
            share * (1.0 - 1e-9)
        ));
    }
    assert_eq!(base_interference_bound(LIGHT, [0.0, 0.0], 0.0, 3), INF);
    assert_eq!(base_interference_bound(LIGHT, [2.0, 0.0], 0.0, 3), 0.0);
    assert_eq!(base_interference_bound(LIGHT, [0.0, 0.0], 0.0, 0), 0.0);
    assert!(!base_interference_matters(LIGHT, [0.0, 0.0], 0.0, 0, 0.0));
}

fn bases_and_scratches(scenes: u64) {
    let mut random = Random::new(45);
    let mut tally = Tally::default();
    for _ in 0..scenes {
        let light = light(&mut random);
        let Coherence { radius, wavelength } = light;
        let count = random.log_uniform(1.0, 40.0) as usize;
        let tolerance = random.log_uniform(1e-4, 0.5);
        let size = random.log_uniform(1e-4, 1.5);
        let (sine, cosine) = random.uniform(0.0, TAU).sin_cos();
        let xi = [size * cosine, size * sine];
        // Brushed or random: tangents around one direction, or any.
        let spread = random.log_uniform(1e-3, PI);
        let phase = random.uniform(-PI, PI);
        // Some scratches are bundles of equal ones, which add up in phase.
        let bundle = random.chance(0.3);
        let spread = if bundle { 1e-3 } else { spread };
        let equal = Profile {
            width: random.log_uniform(0.3, 10.0),
            depth: random.uniform(0.02, 1.0),
        };
        let equal_half = radius * random.log_uniform(0.3, 30.0);
        let place = [random.uniform(-1.0, 1.0), random.uniform(-3.0, 3.0)];
        let (mut sum, mut squared_sum) = (Complex::new(0.0, 0.0), 0.0);
        for _ in 0..count {
            let (s, c) = (phase + spread * random.uniform(-1.0, 1.0)).sin_cos();
            let turned = [c * xi[0] + s * xi[1], c * xi[1] - s * xi[0]];
            let mut profile = Profile {
                width: random.log_uniform(0.3, 10.0),
                depth: random.uniform(0.02, 1.0),
            };
            let mut half = radius * random.log_uniform(0.3, 30.0);
            let mut position = [random.uniform(-half, half), random.uniform(-3.0, 3.0) * radius];
            if bundle {
                (profile, half) = (equal, equal_half);
                position = [place[0] * half, (place[1] + random.uniform(-0.03, 0.03)) * radius];
            }
            let segment = Segment {
                position,
                ends: [-half, half],
            };
            let gamma = 2.0 * (1.0 - 0.25 * size * size).max(0.0).sqrt();
            let one = spatial_phase(light, segment, turned)
                * profile_rectangle(profile, [turned[0], turned[1], gamma], wavelength);
            sum += one;
            squared_sum += one.norm_sqr();
        }
        let base = base_response(light, xi);
        // The worst over the phase, which a light sweeps.
        let term = 2.0 * base * sum.norm();
        let says = !base_interference_matters(light, xi, squared_sum, count, tolerance);
        tally.count(says, term <= tolerance * squared_sum, || {
            format!("{light:?} {xi:?} {squared_sum} {count} {tolerance}: {term}")
        });
    }
    tally.hold("base_interference_matters");
}

#[test]
fn the_base_does_not_interfere_where_the_rule_says_so() {
    bases_and_scratches(FEW / 4);
}

#[test]
#[ignore = "1e6 scenes: in release only"]
fn the_base_does_not_interfere_where_the_rule_says_so_in_a_million_scenes() {
    bases_and_scratches(MANY);
}
