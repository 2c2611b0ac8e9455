//! A depth that varies along the scratch: the limits without slope and curvature, quadrature, symmetries, bad input and
//! finite values for any numbers.

use iridescence::Complex;
use iridescence::diffraction::{
    Coherence, DepthAlong, Profile, Segment, profile_rectangle, response_rectangle_varying, spatial_phase,
    spatial_phase_varying, windowed_transform,
};
use reference::gauss::gauss;
use reference::generate::random::Random;
use std::f64::consts::PI;

/// Largest error in eps of sqrt(2 pi) sigma sqrt(1 + |B|), B = k gamma curvature sigma^2.
const BOUND: f64 = 16.0;
const SQRT_2_PI: f64 = 2.5066282746310007;
const INFINITY: f64 = f64::INFINITY;

#[derive(Clone, Copy, Debug)]
struct Scene {
    light: Coherence,
    segment: Segment,
    depth: DepthAlong,
    scattering: [f64; 3],
}

impl Scene {
    fn value(&self) -> Complex<f64> {
        spatial_phase_varying(self.light, self.segment, self.depth, self.scattering)
    }

    /// sqrt(2 pi) sigma sqrt(1 + |B|) eps.
    fn unit(&self) -> f64 {
        let Coherence { radius, wavelength } = self.light;
        let b = 2.0 * PI / wavelength * self.scattering[2] * self.depth.curvature * radius * radius;
        SQRT_2_PI * radius * (1.0 + b.abs()).sqrt() * f64::EPSILON
    }
}

/// Curvatures from none that is felt to several hundred turns at sigma.
fn scene(random: &mut Random) -> Scene {
    let radius = random.pick(&[10.0, 25.2, 60.0]);
    let length = random.log_uniform(1.0, 1e3);
    let along = -length * random.uniform(-0.2, 1.2);
    let curvature = random.log_uniform(1e-9, 1e-1);
    let slope = random.log_uniform(1e-6, 0.1);
    Scene {
        light: Coherence {
            radius,
            wavelength: random.uniform(0.38, 0.78),
        },
        segment: Segment {
            position: [random.uniform(-2.0, 2.0) * radius, random.uniform(-2.0, 2.0) * radius],
            ends: [along, along + length],
        },
        depth: DepthAlong {
            depth: random.uniform(-0.5, 2.0),
            slope: random.signed(slope),
            curvature: random.signed(curvature),
        },
        scattering: [
            random.uniform(-2.0, 2.0) * random.pick(&[1.0, 0.01]),
            random.uniform(-2.0, 2.0),
            random.uniform(0.0, 2.0),
        ],
    }
}

/// The definition by the Gauss rule over short pieces, the window cut at 9 radii.
fn by_quadrature(scene: &Scene) -> Complex<f64> {
    let Scene {
        light: Coherence { radius, wavelength },
        segment,
        depth,
        scattering: [xi1, xi2, gamma],
    } = *scene;
    let [s_t, s_b] = segment.position;
    let [from, to] = segment.ends.map(|end| (s_t + end).clamp(-9.0 * radius, 9.0 * radius));
    let k = 2.0 * PI / wavelength;
    let steepest = xi1.abs() + gamma * (depth.slope.abs() + depth.curvature.abs() * 9.0 * radius);
    let pieces = 4 + (2.0 * (to - from) * (steepest / wavelength + 1.0 / radius)) as usize;
    let wave = |t: f64| {
        let bottom = depth.depth + depth.slope * t + 0.5 * depth.curvature * t * t;
        let window = (-0.5 * (t * t + s_b * s_b) / (radius * radius)).exp();
        Complex::from_polar(window, k * (gamma * bottom - xi1 * t - xi2 * s_b))
    };
    gauss(wave, [from, to], pieces)
}

#[test]
fn the_integral_by_brute_force_is_the_same() {
    let mut random = Random::new(601);
    for _ in 0..1_500 {
        let scene = scene(&mut random);
        let (value, due) = (scene.value(), by_quadrature(&scene));
        let Coherence { radius, wavelength } = scene.light;
        // The phases of the quadrature, k (xi t + gamma D), are rounded.
        let reach = 9.0 * radius;
        let path = 2.0 + reach * (2.0 + 0.2) + scene.depth.curvature.abs() * reach * reach;
        let rounding = 4.0 * f64::EPSILON * 2.0 * PI / wavelength * path * radius;
        assert!(
            (value - due).norm() <= 64.0 * scene.unit() + rounding,
            "{scene:?}: {value} {due}"
        );
    }
}

#[test]
fn without_curvature_the_slope_shifts_the_direction_and_the_depth_turns_the_phase() {
    let mut random = Random::new(602);
    for _ in 0..5_000 {
        let mut scene = scene(&mut random);
        scene.depth.curvature = 0.0;
        let [xi1, xi2, gamma] = scene.scattering;
        let turned = Complex::from_polar(1.0, 2.0 * PI * gamma * scene.depth.depth / scene.light.wavelength);
        let shifted = spatial_phase(scene.light, scene.segment, [xi1 - gamma * scene.depth.slope, xi2]);
        let value = scene.value();
        assert!((value - shifted * turned).norm() <= 64.0 * scene.unit(), "{scene:?}");
        scene.depth = DepthAlong {
            depth: 0.0,
            slope: 0.0,
            curvature: 0.0,
        };
        let plain = spatial_phase(scene.light, scene.segment, [xi1, xi2]);
        assert!((scene.value() - plain).norm() <= BOUND * scene.unit(), "{scene:?}");
    }
}

#[test]
fn a_vanishing_curvature_meets_the_form_without_one() {
    let mut random = Random::new(603);
    for _ in 0..5_000 {
        let mut scene = scene(&mut random);
        scene.depth.curvature = random.pick(&[1e-30, -1e-30, 1e-120, 5e-324, -1e-22]);
        let bent = scene.value();
        scene.depth.curvature = 0.0;
        let straight = scene.value();
        assert!(
            (bent - straight).norm() <= BOUND * scene.unit(),
            "{scene:?}: {bent} {straight}"
        );
    }
}

#[test]
fn adjoining_segments_add_up_whatever_side_of_the_stationary_point_they_lie_on() {
    let mut random = Random::new(604);
    for _ in 0..10_000 {
        let mut scene = scene(&mut random);
        scene.depth.curvature *= random.log_uniform(1.0, 1e4);
        let [from, to] = scene.segment.ends;
        let inner = from + (to - from) * random.uniform(0.0, 1.0);
        let over = |ends| {
            let mut part = scene;
            part.segment.ends = ends;
            part.value()
        };
        let rest = over([from, inner]) + over([inner, to]) - over([from, to]);
        assert!(rest.norm() <= 2.0 * BOUND * scene.unit(), "{scene:?}: {rest}");
        assert_eq!(over([to, from]), -over([from, to]));
        assert_eq!(over([from, from]).norm(), 0.0);
    }
}

#[test]
fn an_infinite_scratch_has_the_gaussian_of_the_complex_radius() {
    let mut random = Random::new(605);
    for _ in 0..5_000 {
        let mut scene = scene(&mut random);
        scene.segment.position = [0.0, 0.0];
        scene.segment.ends = [-INFINITY, INFINITY];
        scene.depth.depth = 0.0;
        scene.depth.slope = 0.0;
        let Coherence { radius, wavelength } = scene.light;
        let [xi1, _, gamma] = scene.scattering;
        let kappa = 2.0 * PI / wavelength * xi1 * radius;
        let inverse = Complex::new(
            1.0,
            -2.0 * PI / wavelength * gamma * scene.depth.curvature * radius * radius,
        );
        // sqrt(2 pi) s exp(-kappa^2 s^2/2).
        let due = (inverse.inv() * (-0.5 * kappa * kappa)).exp() / inverse.sqrt() * (SQRT_2_PI * radius);
        let conditioning = 1.0 + kappa * kappa / inverse.norm();
        let error = (scene.value() - due).norm();
        let allowed = BOUND * scene.unit() + 8.0 * f64::EPSILON * due.norm() * conditioning;
        assert!(error <= allowed, "{scene:?}: {} {due}", scene.value());
    }
}

#[test]
fn the_opposite_curvature_of_the_mirrored_direction_conjugates_bit_for_bit() {
    let mut random = Random::new(606);
    for _ in 0..5_000 {
        let scene = scene(&mut random);
        let mut mirrored = scene;
        let DepthAlong {
            depth,
            slope,
            curvature,
        } = scene.depth;
        mirrored.depth = DepthAlong {
            depth: -depth,
            slope: -slope,
            curvature: -curvature,
        };
        mirrored.scattering = [-scene.scattering[0], -scene.scattering[1], scene.scattering[2]];
        assert_eq!(mirrored.value(), scene.value().conj(), "{scene:?}");
    }
}

#[test]
fn the_response_is_that_of_the_rectangle_where_the_depth_is_constant() {
    let mut random = Random::new(607);
    for _ in 0..3_000 {
        let mut scene = scene(&mut random);
        (scene.depth.slope, scene.depth.curvature) = (0.0, 0.0);
        let width = random.uniform(0.5, 9.0);
        let value = response_rectangle_varying(scene.light, width, scene.segment, scene.depth, scene.scattering);
        let profile = Profile {
            width,
            depth: scene.depth.depth,
        };
        let [xi1, xi2, _] = scene.scattering;
        let due = profile_rectangle(profile, scene.scattering, scene.light.wavelength)
            * spatial_phase(scene.light, scene.segment, [xi1, xi2]);
        assert!(
            (value - due).norm() <= BOUND * width * scene.unit(),
            "{scene:?}: {value} {due}"
        );
    }
}

#[test]
fn a_description_from_another_point_of_the_line_is_the_same_groove() {
    let mut random = Random::new(608);
    for _ in 0..1_000 {
        let depth = scene(&mut random).depth;
        let (shift, t) = (random.uniform(-50.0, 50.0), random.uniform(-50.0, 50.0));
        let at = |d: DepthAlong, t: f64| d.depth + d.slope * t + 0.5 * d.curvature * t * t;
        let scale = depth.depth.abs() + depth.slope.abs() * 100.0 + depth.curvature.abs() * 1e4;
        let moved = depth.shifted(shift);
        assert!((at(moved, t - shift) - at(depth, t)).abs() <= 8.0 * f64::EPSILON * scale);
    }
}

#[test]
fn limits_and_bad_input_have_their_values() {
    let mut random = Random::new(609);
    let scene = scene(&mut random);
    let is_nan = |z: Complex<f64>| z.re.is_nan() && z.im.is_nan();
    let with = |change: &dyn Fn(&mut Scene)| {
        let mut changed = scene;
        change(&mut changed);
        changed.value()
    };
    let zero = Complex::new(0.0, 0.0);
    assert_eq!(with(&|s| s.light.radius = 0.0), zero);
    assert_eq!(with(&|s| s.segment.position[1] = INFINITY), zero);
    assert_eq!(with(&|s| s.segment.position[0] = INFINITY), zero);
    assert_eq!(with(&|s| s.scattering[0] = INFINITY), zero);
    assert_eq!(with(&|s| s.depth.curvature = 1e160), zero);
    for value in [f64::NAN, INFINITY] {
        assert!(is_nan(with(&|s| s.depth.depth = value)));
        assert!(is_nan(with(&|s| s.depth.curvature = value)));
        assert!(is_nan(with(&|s| s.scattering[2] = value)));
        assert!(is_nan(with(&|s| s.light.radius = value)));
    }
    assert!(is_nan(with(&|s| s.depth.slope = f64::NAN)));
    assert!(is_nan(with(&|s| s.light.radius = -1.0)));
    assert!(is_nan(with(&|s| s.light.wavelength = 0.0)));
    assert!(is_nan(with(&|s| s.light.wavelength = -0.5)));
    assert!(is_nan(with(&|s| s.light.wavelength = f64::NAN)));
    for index in 0..2 {
        assert!(is_nan(with(&|s| s.segment.position[index] = f64::NAN)));
        assert!(is_nan(with(&|s| s.segment.ends[index] = f64::NAN)));
        assert!(is_nan(with(&|s| s.scattering[index] = f64::NAN)));
    }
    let width = |width| response_rectangle_varying(scene.light, width, scene.segment, scene.depth, scene.scattering);
    assert_eq!(width(0.0), zero);
    assert!(is_nan(width(-1.0)) && is_nan(width(f64::NAN)));
    // With the window constant and no curvature the plain integral is left.
    let light = Coherence {
        radius: INFINITY,
        ..scene.light
    };
    let flat = windowed_transform(light, [0.0, 5.0], 0.1);
    let depth = DepthAlong {
        depth: 0.0,
        slope: 0.0,
        curvature: 0.0,
    };
    let segment = Segment {
        position: [0.0, 0.0],
        ends: [0.0, 5.0],
    };
    assert_eq!(spatial_phase_varying(light, segment, depth, [0.1, 0.0, 1.0]), flat);
}

#[test]
fn no_finite_numbers_of_any_magnitude_give_a_value_that_is_not_finite_or_beyond_the_peak() {
    finite_and_within_the_peak(610, 100_000);
}

#[test]
#[ignore = "1e7 scenes: in release only"]
fn ten_million_scenes_of_any_magnitude_give_no_value_that_is_not_finite_or_beyond_the_peak() {
    finite_and_within_the_peak(620, 10_000_000);
}

fn finite_and_within_the_peak(seed: u64, count: usize) {
    let mut random = Random::new(seed);
    for k in 0..count {
        let x: [f64; 12] = std::array::from_fn(|index| {
            let any = f64::from_bits(random.bits());
            let any = if any.is_finite() { any } else { 1e-300 };
            match (k + index) % 3 {
                0 if any.abs() < 1e150 => any,
                1 => 10f64.powf(random.uniform(-12.0, 12.0)).copysign(any),
                _ => random.uniform(-2.0, 2.0),
            }
        });
        let scene = Scene {
            light: Coherence {
                radius: x[0].abs().max(5e-324),
                wavelength: x[1].abs().max(5e-324),
            },
            segment: Segment {
                position: [x[2], x[3]],
                ends: [x[4], x[5]],
            },
            depth: DepthAlong {
                depth: x[6],
                slope: x[7],
                curvature: x[8],
            },
            scattering: [x[9], x[10], x[11]],
        };
        let value = scene.value();
        // Twice: where the phases have no digits left the parts add as they come.
        let peak = 3.0 * SQRT_2_PI * scene.light.radius;
        assert!(value.re.hypot(value.im) <= peak, "{scene:?}: {value}");
    }
}
