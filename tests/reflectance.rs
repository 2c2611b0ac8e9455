//! Reflectances: squares and interference, and crossings by quadrature over the overlap.

use iridescence::Complex;
use iridescence::diffraction::{
    Coherence, Profile, base_interference, base_response, coherence_area, coherence_window, crossing_response,
    depth_term, profile_rectangle, reflectance_coherent, reflectance_incoherent, scratch_squared,
    spatial_phase_infinite,
};
use reference::generate::random::Random;
use std::f64::consts::PI;

const LIGHT: Coherence = Coherence {
    radius: 25.0,
    wavelength: 0.55,
};

fn complex(random: &mut Random) -> Complex<f64> {
    Complex::new(random.uniform(-1e3, 1e3), random.uniform(-1e3, 1e3))
}

#[test]
fn the_coherent_reflectance_is_the_incoherent_one_and_the_interference() {
    let mut random = Random::new(901);
    for _ in 0..2_000 {
        let (base, scratches) = (random.uniform(0.0, 1e3), complex(&mut random));
        let apart = base * base + scratches.norm_sqr() + base_interference(base, scratches);
        let coherent = reflectance_coherent(LIGHT, base, scratches);
        let scale = base * base + scratches.norm_sqr();
        let unit = coherence_area(25.0) * 0.55 * 0.55;
        assert!((coherent * unit - apart).abs() <= 8.0 * f64::EPSILON * scale);
        let incoherent = reflectance_incoherent(LIGHT, scale);
        assert!((incoherent * unit / scale - 1.0).abs() <= 4.0 * f64::EPSILON);
    }
    assert_eq!(base_interference(3.0, Complex::new(2.0, 7.0)), -12.0);
}

#[test]
fn the_bare_surface_reflects_all_the_energy() {
    // int |B|^2/(A_C lambda^2) dxi1 dxi2 = 1, by the trapezoid rule in either direction.
    let step = 0.2 * 0.55 / (2.0 * PI * 25.0);
    let mut sum = 0.0;
    for i in -40..=40 {
        for j in -40..=40 {
            let base = base_response(LIGHT, [f64::from(i) * step, f64::from(j) * step]);
            sum += reflectance_coherent(LIGHT, base, Complex::new(0.0, 0.0));
        }
    }
    assert!((sum * step * step - 1.0).abs() < 1e-13, "{sum}");
}

#[test]
fn one_scratch_at_a_point_has_its_squared_response() {
    let mut random = Random::new(902);
    for _ in 0..4_000 {
        let profile = Profile {
            width: random.uniform(0.3, 9.0),
            depth: random.uniform(0.0, 2.0),
        };
        let offset = random.uniform(-3.0, 3.0) * 25.0;
        let scattering = [
            random.uniform(-0.01, 0.01),
            random.uniform(-2.0, 2.0),
            random.uniform(0.0, 2.0),
        ];
        let field = profile_rectangle(profile, scattering, 0.55)
            * spatial_phase_infinite(LIGHT, offset, [scattering[0], scattering[1]]);
        let squared = scratch_squared(LIGHT, profile, scattering, coherence_window(offset, 25.0).powi(2));
        let due = field.norm_sqr();
        assert!((squared - due).abs() <= 1e-13 * due, "{profile:?} {scattering:?}");
    }
}

/// The integral of the window and the wave over the points within half a width of both lines.
fn overlap(
    profiles: [Profile; 2],
    tangents: [[f64; 2]; 2],
    crossing: [f64; 2],
    xi: [f64; 2],
    window: bool,
) -> Complex<f64> {
    // Coordinates along the two tangents; the Jacobian is the sine between them.
    let [t1, t2] = tangents;
    let sine = (t1[0] * t2[1] - t1[1] * t2[0]).abs();
    // Along t1 only the distance from the second line changes.
    let reach = [profiles[1].width / sine, profiles[0].width / sine];
    let count = 300;
    let mut sum = Complex::new(0.0, 0.0);
    for i in 0..count {
        for j in 0..count {
            let [u, v] =
                [(i, reach[0]), (j, reach[1])].map(|(k, r)| r * ((f64::from(k) + 0.5) / f64::from(count) - 0.5));
            let at = [0, 1].map(|c| crossing[c] + u * t1[c] + v * t2[c]);
            let decay = if window {
                coherence_window(at[0].hypot(at[1]), LIGHT.radius)
            } else {
                coherence_window(crossing[0].hypot(crossing[1]), LIGHT.radius)
            };
            sum += Complex::from_polar(decay, -2.0 * PI / LIGHT.wavelength * (xi[0] * at[0] + xi[1] * at[1]));
        }
    }
    sum * (reach[0] * reach[1] * sine / f64::from(count * count))
}

fn crossing_scene(random: &mut Random) -> ([Profile; 2], [[f64; 2]; 2], [f64; 2], [f64; 3]) {
    let profiles = [0; 2].map(|_| Profile {
        width: random.uniform(0.2, 2.0),
        depth: random.uniform(0.0, 1.0),
    });
    let first = random.uniform(0.0, 2.0 * PI);
    let turn = random.uniform(0.3, PI - 0.3);
    let second = first + random.signed(turn);
    let tangents = [first, second].map(|angle| [angle.cos(), angle.sin()]);
    let crossing = [random.uniform(-30.0, 30.0), random.uniform(-30.0, 30.0)];
    let scattering = [
        random.uniform(-0.4, 0.4),
        random.uniform(-0.4, 0.4),
        random.uniform(0.5, 2.0),
    ];
    (profiles, tangents, crossing, scattering)
}

#[test]
fn the_crossing_is_the_integral_over_the_overlap() {
    let mut random = Random::new(903);
    for _ in 0..25 {
        let (profiles, tangents, crossing, scattering) = crossing_scene(&mut random);
        let value = crossing_response(LIGHT, profiles, tangents, crossing, scattering);
        let [xi1, xi2, gamma] = scattering;
        let depth = depth_term(profiles[0].depth, gamma, 0.55) * depth_term(profiles[1].depth, gamma, 0.55);
        let area = overlap(profiles, tangents, crossing, [0.0, 0.0], false).norm();
        let constant = overlap(profiles, tangents, crossing, [xi1, xi2], false) * depth;
        // The midpoint rule has an error of the square of its step.
        assert!(
            (value - constant).norm() <= 2e-3 * area,
            "{profiles:?} {tangents:?}: {value} {constant}"
        );
        // A window that varies over the overlap changes no more of it than its slope, r/sigma^2, over half the reach.
        let windowed = overlap(profiles, tangents, crossing, [xi1, xi2], true) * depth;
        let sine = tangents[0][0] * tangents[1][1] - tangents[0][1] * tangents[1][0];
        let reach = 0.5 * (profiles[0].width + profiles[1].width) / sine.abs();
        let slope = (crossing[0].hypot(crossing[1]) + reach) / LIGHT.radius.powi(2);
        assert!(
            (value - windowed).norm() <= 4.0 * area * slope * reach + 2e-3 * area,
            "{value} {windowed}"
        );
    }
}

#[test]
fn the_crossing_does_not_depend_on_order_or_sense_of_the_tangents() {
    let mut random = Random::new(904);
    for _ in 0..4_000 {
        let (profiles, tangents, crossing, scattering) = crossing_scene(&mut random);
        let value = crossing_response(LIGHT, profiles, tangents, crossing, scattering);
        let [p1, p2] = profiles;
        let [t1, t2] = tangents;
        let scale = 1e-13 * p1.width * p2.width / (t1[0] * t2[1] - t1[1] * t2[0]).abs() * 4.0;
        let same = |other: Complex<f64>| (other - value).norm() <= scale;
        assert!(same(crossing_response(LIGHT, [p2, p1], [t2, t1], crossing, scattering)));
        assert!(same(crossing_response(
            LIGHT,
            profiles,
            [t1.map(|x| -x), t2],
            crossing,
            scattering
        )));
    }
}

#[test]
fn with_the_crossing_the_overlap_keeps_the_unit_modulus_of_the_transfer_function() {
    // At xi = 0 the transform counts areas: 1 - D1 - D2 + D1 D2 on the overlap, which is a product of two phases.
    let profiles = [
        Profile {
            width: 1.0,
            depth: 0.1375,
        },
        Profile {
            width: 2.0,
            depth: 0.1375,
        },
    ];
    let scattering = [0.0, 0.0, 2.0];
    let value = crossing_response(LIGHT, profiles, [[1.0, 0.0], [0.0, 1.0]], [0.0, 0.0], scattering);
    let depth = depth_term(0.1375, 2.0, 0.55);
    let one = Complex::new(1.0, 0.0);
    let complete = (one - depth - depth) + value / 2.0;
    assert!((complete.norm() - 1.0).abs() < 1e-14, "{complete}");
    assert!(((one - depth - depth).norm() - 3.0).abs() < 1e-14);
}

#[test]
fn parallel_scratches_and_bad_input_give_nan() {
    let profiles = [Profile { width: 1.0, depth: 0.1 }; 2];
    let (x, y) = ([1.0, 0.0], [0.0, 1.0]);
    let crossing = |profiles, tangents, at, scattering| crossing_response(LIGHT, profiles, tangents, at, scattering).re;
    assert!(crossing(profiles, [x, x], [1.0, 2.0], [0.1, 0.2, 1.0]).is_nan());
    assert!(crossing(profiles, [x, [-1.0, 0.0]], [1.0, 2.0], [0.1, 0.2, 1.0]).is_nan());
    assert!(crossing(profiles, [x, y], [1.0, f64::NAN], [0.1, 0.2, 1.0]).is_nan());
    assert!(crossing(profiles, [x, y], [1.0, 2.0], [0.1, 0.2, f64::NAN]).is_nan());
    assert!(crossing(profiles, [[f64::NAN, 0.0], y], [1.0, 2.0], [0.1, 0.2, 1.0]).is_nan());
    let bad = [
        Profile {
            width: -1.0,
            depth: 0.1,
        },
        profiles[1],
    ];
    assert!(crossing(bad, [x, y], [1.0, 2.0], [0.1, 0.2, 1.0]).is_nan());
    assert_eq!(crossing(profiles, [x, y], [f64::INFINITY, 2.0], [0.1, 0.2, 1.0]), 0.0);
    let narrow = [Profile { width: 0.0, depth: 0.1 }, profiles[1]];
    assert_eq!(crossing(narrow, [x, y], [1.0, 2.0], [0.1, 0.2, 1.0]), 0.0);
    for (radius, wavelength) in [
        (0.0, 0.5),
        (-1.0, 0.5),
        (1.0, 0.0),
        (1.0, -0.5),
        (f64::NAN, 0.5),
        (1.0, f64::NAN),
    ] {
        let light = Coherence { radius, wavelength };
        assert!(reflectance_incoherent(light, 1.0).is_nan(), "{radius} {wavelength}");
        assert!(
            reflectance_coherent(light, 1.0, Complex::new(0.0, 0.0)).is_nan(),
            "{radius} {wavelength}"
        );
        if radius != 0.0 {
            assert!(
                scratch_squared(light, profiles[0], [0.0, 0.1, 1.0], 1.0).is_nan(),
                "{radius} {wavelength}"
            );
        }
    }
    assert!(scratch_squared(LIGHT, profiles[0], [0.0, 0.1, 1.0], f64::NAN).is_nan());
    assert_eq!(
        scratch_squared(Coherence { radius: 0.0, ..LIGHT }, profiles[0], [0.0, 0.1, 1.0], 1.0),
        0.0
    );
}
