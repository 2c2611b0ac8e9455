//! The depth term near normal.

use super::{FEW, MANY, Tally, holds_to};
use iridescence::diffraction::{
    depth_term_near_normal_squared, depth_term_squared, near_normal_depth_amplitude_error, near_normal_depth_error,
    near_normal_depth_is_enough,
};
use reference::generate::random::Random;
use std::f64::consts::PI;

#[test]
fn the_error_of_the_depth_near_normal_is_the_largest_over_the_range() {
    let wavelength = 0.5;
    for depth in [0.03, 0.1, 0.125, 0.2, 0.25, 0.7, -0.3] {
        for range in [[1.9, 2.0], [1.0, 2.0], [0.0, 2.0], [0.3, 0.31], [2.0, 1.2]] {
            let (mut squared, mut amplitude) = (0.0_f64, 0.0_f64);
            for n in 0..=40_000 {
                let gamma = range[0] + (range[1] - range[0]) * f64::from(n) / 40_000.0;
                let near = depth_term_near_normal_squared(depth, wavelength);
                squared = squared.max((depth_term_squared(depth, gamma, wavelength) - near).abs());
                amplitude = amplitude.max(2.0 * (PI * (2.0 - gamma) * depth / wavelength).sin().abs());
            }
            let error = near_normal_depth_error(depth, range, wavelength);
            assert!(
                error >= squared - 2e-15 && error <= squared + 1e-7,
                "{depth} {range:?}: {error} {squared}"
            );
            let error = near_normal_depth_amplitude_error(depth, range, wavelength);
            assert!(
                error >= amplitude - 2e-15 && error <= amplitude + 1e-7,
                "{depth} {range:?}: {error} {amplitude}"
            );
        }
    }
}

#[test]
fn the_depth_near_normal_is_exact_at_normal_incidence_and_without_depth() {
    for depth in [0.0, 1e-300, 0.1, 7.0] {
        assert_eq!(near_normal_depth_error(depth, [2.0, 2.0], 0.55), 0.0);
        assert_eq!(near_normal_depth_amplitude_error(depth, [2.0, 2.0], 0.55), 0.0);
        assert!(near_normal_depth_is_enough(depth, [2.0, 2.0], 0.55, 0.0));
    }
    assert_eq!(near_normal_depth_error(0.0, [0.0, 2.0], 0.55), 0.0);
    // Quadratic in a small range at an extremum, linear elsewhere: no digits are lost.
    let gamma = 2.0 - 1e-9;
    let phase = 4.0 * PI * 0.1 / 0.5;
    holds_to(
        near_normal_depth_error(0.1, [gamma, 2.0], 0.5),
        2.0 * phase.sin() * (0.5 * phase * (2.0 - gamma)),
        1e-7,
    );
}

fn depths(scenes: u64) {
    let mut random = Random::new(46);
    let mut tally = Tally::default();
    for _ in 0..scenes {
        let depth = random.log_uniform(1e-3, 5.0);
        let wavelength = random.uniform(0.38, 0.78);
        let tolerance = random.log_uniform(1e-4, 3.0);
        let middle = 2.0 - random.log_uniform(1e-4, 2.0);
        let half = random.log_uniform(1e-4, 1.0);
        let range = [(middle - half).max(0.0), (middle + half).min(2.0)];
        let says = near_normal_depth_is_enough(depth, range, wavelength, tolerance);
        let bound = near_normal_depth_error(depth, range, wavelength);
        let near = depth_term_squared(depth, 2.0, wavelength);
        let mut largest = 0.0_f64;
        for n in 0..=24 {
            let gamma = range[0] + (range[1] - range[0]) * f64::from(n) / 24.0;
            largest = largest.max((depth_term_squared(depth, gamma, wavelength) - near).abs());
        }
        let scene = || format!("{depth} {range:?} {wavelength} {tolerance}: {largest} {bound}");
        assert!(largest <= bound + 1e-13, "{}", scene());
        tally.count(says, largest <= tolerance + 1e-13, scene);
    }
    tally.hold("near_normal_depth_is_enough");
}

#[test]
fn the_near_normal_depth_is_enough_where_the_rule_says_so() {
    depths(FEW);
}

#[test]
#[ignore = "1e6 scenes: in release only"]
fn the_near_normal_depth_is_enough_where_the_rule_says_so_in_a_million_scenes() {
    depths(MANY);
}
