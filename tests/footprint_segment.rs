//! The mean over a footprint for a segment: quadrature along the scratch, cuts, the point, slanted ellipses, bad input.

use iridescence::diffraction::*;
use iridescence::special::erf;
use reference::gauss::gauss;
use reference::generate::random::Random;
use std::f64::consts::{FRAC_2_PI, PI};

/// Largest errors of the mean with soft ends, and with hard ones.
const SOFT: f64 = 1e-13;
const HARD: f64 = 5e-4;

/// The mean over the ellipse of exp(-s_b^2) times a function of s_t, integrated along the scratch last: at t the ellipse
/// is cut across, where the window has a closed mean. `from..to` is the part of the ellipse along t that counts.
fn along_the_scratch(
    footprint: Footprint,
    position: [f64; 2],
    [from, to]: [f64; 2],
    value: impl Fn(f64) -> f64,
) -> f64 {
    let [a1, a2] = footprint.axes;
    let (c, s) = (footprint.cos_phi, (1.0 - footprint.cos_phi * footprint.cos_phi).sqrt());
    let width = (a1 * a1 * c * c + a2 * a2 * s * s).sqrt();
    let (slope, length) = ((a1 * a1 - a2 * a2) * s * c / (width * width), a1 * a2 / width);
    // t = width sin(angle): no roots at the ends.
    let strip = |angle: f64| {
        let (t, root) = (width * angle.sin(), angle.cos());
        let (low, high) = (slope * t - length * root, slope * t + length * root);
        let across = 0.5 * PI.sqrt() * (erf(position[1] - low) - erf(position[1] - high));
        across * value(position[0] - t) * width * root
    };
    let ends = [from, to].map(|t| (t / width).clamp(-1.0, 1.0).asin());
    gauss(strip, ends, 60 + 8 * (width * (1.0 + slope.abs())) as usize) / (PI * a1 * a2)
}

fn soft(footprint: Footprint, position: [f64; 2], [l1, l2]: [f64; 2]) -> f64 {
    let reach = f64::INFINITY;
    along_the_scratch(footprint, position, [-reach, reach], |t| {
        0.5 * (erf(t + l2) - erf(t + l1))
    })
}

fn hard(footprint: Footprint, position: [f64; 2], [l1, l2]: [f64; 2]) -> f64 {
    along_the_scratch(footprint, position, [position[0] + l1, position[0] + l2], |_| 1.0)
}

#[test]
fn a_segment_agrees_with_quadrature_along_the_scratch() {
    let mut random = Random::new(5);
    let (mut worst_soft, mut worst_hard) = (0.0f64, 0.0f64);
    for _ in 0..400 {
        let footprint = Footprint {
            axes: [random.log_uniform(0.2, 12.0), random.log_uniform(0.2, 12.0)],
            cos_phi: random.uniform(-1.0, 1.0),
        };
        let reach = footprint.axes[0].max(footprint.axes[1]) + 1.0;
        let (l1, length) = (random.uniform(-reach, reach), random.log_uniform(0.2, 20.0));
        let (position, ends) = (
            [random.uniform(-3.0, 3.0), random.uniform(-2.0, 2.0)],
            [l1, l1 + length],
        );
        let segment = Segment { position, ends };
        let error = (footprint_segment_mean(footprint, segment, 1.0) - soft(footprint, position, ends)).abs();
        worst_soft = worst_soft.max(error);
        let error = (footprint_segment_mean_hard(footprint, segment, 1.0) - hard(footprint, position, ends)).abs();
        worst_hard = worst_hard.max(error);
    }
    println!("{worst_soft:e} {worst_hard:e}");
    assert!(worst_soft < SOFT, "{worst_soft:e}");
    assert!(worst_hard < HARD, "{worst_hard:e}");
}

#[test]
fn twice_the_length_cut_in_two_gives_the_same_sum() {
    let mut random = Random::new(6);
    for _ in 0..300 {
        let footprint = Footprint {
            axes: [random.log_uniform(0.01, 100.0), random.log_uniform(0.01, 100.0)],
            cos_phi: random.uniform(-1.0, 1.0),
        };
        let position = [random.uniform(-50.0, 50.0), random.uniform(-5.0, 5.0)];
        let cut = random.uniform(-40.0, 40.0);
        let part = |ends| footprint_segment_mean(footprint, Segment { position, ends }, 1.0);
        let sum = part([f64::NEG_INFINITY, cut]) + part([cut, f64::INFINITY]);
        let whole = footprint_mean(footprint, position[1], 1.0);
        assert!(
            (sum - whole).abs() < 1e-9,
            "{footprint:?} {position:?} {cut}: {sum} {whole}"
        );
        assert_eq!(part([f64::NEG_INFINITY, f64::INFINITY]), whole);
        assert_eq!(part([cut, cut]), 0.0);
        assert!(part([cut, cut - 1.0]).is_nan());
    }
}

#[test]
fn a_segment_seen_from_a_point_is_the_window_between_its_ends() {
    let point = Footprint {
        axes: [0.0, 0.0],
        cos_phi: 0.4,
    };
    let segment = Segment {
        position: [0.4, 0.7],
        ends: [-1.0, 2.5],
    };
    let truth = (-(0.35f64 * 0.35)).exp() * 0.5 * (erf(1.45) - erf(-0.3));
    assert!((footprint_segment_mean(point, segment, 2.0) - truth).abs() < 1e-13);
    let truth = (-(0.35f64 * 0.35)).exp();
    assert!((footprint_segment_mean_hard(point, segment, 2.0) - truth).abs() < 1e-13);
    let beside = Segment {
        ends: [0.0, 2.5],
        ..segment
    };
    assert_eq!(footprint_segment_mean_hard(point, beside, 2.0), 0.0);
}

#[test]
fn nodes_in_the_angle_follow_long_slanted_ellipses() {
    let footprint = Footprint {
        axes: [500.0, 1.0],
        cos_phi: 0.7,
    };
    for cut in [-200.0, -3.0, 0.0, 77.0] {
        let part = |ends| {
            footprint_segment_mean(
                footprint,
                Segment {
                    position: [1.0, 2.0],
                    ends,
                },
                1.0,
            )
        };
        let ends = part([cut - 1.0, cut]) + part([cut, cut + 1.0]);
        let whole = part([cut - 1.0, cut + 1.0]);
        assert!((ends - whole).abs() < 1e-12 * FRAC_2_PI, "{cut}");
        let truth = soft(footprint, [1.0, 2.0], [cut - 1.0, cut + 1.0]);
        assert!((whole - truth).abs() < 1e-10, "{cut}: {whole:e} {truth:e}");
    }
}

#[test]
fn outside_the_domain_and_for_nan_the_mean_is_nan() {
    let good = Footprint {
        axes: [3.0, 5.0],
        cos_phi: 0.5,
    };
    let segment = Segment {
        position: [0.0, 0.0],
        ends: [-1.0, 1.0],
    };
    for mean in [footprint_segment_mean, footprint_segment_mean_hard] {
        assert!(!mean(good, segment, 1.0).is_nan());
        for cos_phi in [1.0000000001, -1.5, f64::NAN] {
            assert!(mean(Footprint { cos_phi, ..good }, segment, 1.0).is_nan(), "{cos_phi}");
        }
        for axes in [[-1.0, 5.0], [3.0, -1e-9], [f64::NAN, 5.0], [3.0, f64::NAN]] {
            assert!(mean(Footprint { axes, ..good }, segment, 1.0).is_nan(), "{axes:?}");
        }
        for radius in [0.0, -1.0, f64::NAN] {
            assert!(mean(good, segment, radius).is_nan(), "{radius}");
        }
        for ends in [[1.0, -1.0], [f64::NAN, 1.0], [-1.0, f64::NAN]] {
            assert!(mean(good, Segment { ends, ..segment }, 1.0).is_nan(), "{ends:?}");
        }
        for position in [[f64::NAN, 0.0], [0.0, f64::NAN]] {
            assert!(
                mean(good, Segment { position, ..segment }, 1.0).is_nan(),
                "{position:?}"
            );
        }
    }
}
