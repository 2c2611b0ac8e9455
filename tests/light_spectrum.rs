//! Area lights with the depth term inside, at several wavelengths, and averaged over a channel, against quadrature of their
//! definitions on top of the accurate chord, and against each other.

use iridescence::diffraction::{Coherence, depth_term_squared};
use iridescence::light::*;
use reference::gauss::gauss;
use reference::generate::lights;
use reference::generate::random::Random;
use reference::oracle;

fn scene(random: &mut Random) -> (ScratchLobe, Sphere) {
    let row = lights::sphere(random);
    let coherence = Coherence {
        radius: row[0],
        wavelength: row[1],
    };
    let lobe = ScratchLobe {
        coherence,
        width: row[2],
        view: [row[3], row[4]],
    };
    let sphere = Sphere {
        centre: [row[5], row[6], row[7]],
        radius: row[8],
    };
    (lobe, sphere)
}

/// The integral with the depth term by its definition: panels in x over chords found by membership, panels along each.
fn depth_by_definition(lobe: ScratchLobe, depth: f64, sphere: Sphere) -> f64 {
    let Coherence { radius, wavelength } = lobe.coherence;
    let k = std::f64::consts::TAU / wavelength;
    let distance = sphere.centre.iter().map(|x| x * x).sum::<f64>().sqrt();
    let axis = sphere.centre.map(|x| x / distance);
    let alpha = (sphere.radius / distance).asin();
    let gamma = (1.0 - lobe.view[0].powi(2) - lobe.view[1].powi(2)).max(0.0).sqrt();
    // On a zenith light above the horizon the cap is a disc about the axis: polar coordinates about it.
    let side = [1.0, 0.0, -axis[0] / axis[2]];
    let length = side.iter().map(|x| x * x).sum::<f64>().sqrt();
    let u = side.map(|x| x / length);
    let v = [
        axis[1] * u[2] - axis[2] * u[1],
        axis[2] * u[0] - axis[0] * u[2],
        axis[0] * u[1] - axis[1] * u[0],
    ];
    gauss(
        |theta: f64| {
            let (s, c) = theta.sin_cos();
            s * gauss(
                |phi: f64| {
                    let (sp, cp) = phi.sin_cos();
                    let [x, y, z] = std::array::from_fn(|i| c * axis[i] + s * (cp * u[i] + sp * v[i]));
                    let t = radius * k * (x + lobe.view[0]);
                    let q = 0.5 * k * lobe.width * (y + lobe.view[1]);
                    let sinc = if q == 0.0 { 1.0 } else { q.sin() / q };
                    z * (-t * t).exp() * sinc * sinc * depth_term_squared(depth, z + gamma, wavelength)
                },
                [0.0, std::f64::consts::TAU],
                300,
            )
        },
        [0.0, alpha],
        80,
    )
}

fn zenith(radius: f64, tilt: f64) -> (ScratchLobe, Sphere) {
    let coherence = Coherence {
        radius: 12.0,
        wavelength: 0.6,
    };
    let lobe = ScratchLobe {
        coherence,
        width: 1.5,
        view: [0.02, -0.1],
    };
    let sphere = Sphere {
        centre: [tilt, 0.3, 1.0],
        radius,
    };
    (lobe, sphere)
}

#[test]
fn the_depth_inside_is_the_integral_it_stands_for() {
    for (radius, tilt) in [(0.05, 0.0), (0.2, 0.0), (0.2, 0.18), (0.6, 0.1)] {
        for depth in [0.05, 0.3, 1.0] {
            let (lobe, sphere) = zenith(radius, tilt);
            let (found, due) = (
                sphere_light_depth(lobe, depth, sphere),
                depth_by_definition(lobe, depth, sphere),
            );
            assert!(
                (found / due - 1.0).abs() < 1e-9,
                "{radius} {tilt} {depth}: {found:e} {due:e}"
            );
        }
    }
}

#[test]
fn a_polygon_with_depth_inside_comes_to_the_sphere_as_its_corners_do() {
    let (lobe, sphere) = zenith(0.2, 0.1);
    let distance = sphere.centre.iter().map(|x| x * x).sum::<f64>().sqrt();
    let axis = sphere.centre.map(|x| x / distance);
    let sine = sphere.radius / distance;
    let cosine = (1.0 - sine * sine).sqrt();
    let side = [1.0, 0.0, -axis[0] / axis[2]];
    let length = side.iter().map(|x| x * x).sum::<f64>().sqrt();
    let u = side.map(|x| x / length);
    let v = [
        axis[1] * u[2] - axis[2] * u[1],
        axis[2] * u[0] - axis[0] * u[2],
        axis[0] * u[1] - axis[1] * u[0],
    ];
    let corners: Vec<[f64; 3]> = (0..256)
        .map(|i| {
            let (s, c) = (std::f64::consts::TAU * f64::from(i) / 256.0).sin_cos();
            std::array::from_fn(|k| cosine * axis[k] + sine * (c * u[k] + s * v[k]))
        })
        .collect();
    let (round, cornered) = (
        sphere_light_depth(lobe, 0.3, sphere),
        polygon_light_depth(lobe, 0.3, &corners),
    );
    // The inscribed polygon lacks 1e-4 of the area, and no more of the light.
    let lacking = 1.0 - cornered / round;
    assert!(lacking > 0.0 && lacking < 3e-4, "{lacking:e}");
    let reversed: Vec<[f64; 3]> = corners.iter().rev().copied().collect();
    assert!((polygon_light_depth(lobe, 0.3, &reversed) / cornered - 1.0).abs() < 1e-12);
}

/// One chord with the depth term of each of its directions, by panels.
fn chord_by_definition(lobe: ScratchLobe, depth: f64, sphere: Sphere) -> f64 {
    use iridescence::geometry::{Cone, cone_chords};
    let Coherence { radius, wavelength } = lobe.coherence;
    let k = std::f64::consts::TAU / wavelength;
    let gamma = (1.0 - lobe.view[0].powi(2) - lobe.view[1].powi(2)).max(0.0).sqrt();
    let cone = Cone::of_sphere(sphere.centre, sphere.radius).expect("outside");
    let x = -lobe.view[0];
    let chords = cone_chords(cone, x);
    let integral: f64 = chords
        .into_iter()
        .flatten()
        .map(|ends| {
            gauss(
                |y: f64| {
                    let q = 0.5 * k * lobe.width * (y + lobe.view[1]);
                    let sinc = if q == 0.0 { 1.0 } else { q.sin() / q };
                    let z = (1.0 - x * x - y * y).max(0.0).sqrt();
                    sinc * sinc * depth_term_squared(depth, z + gamma, wavelength)
                },
                ends,
                400,
            )
        })
        .sum();
    std::f64::consts::PI.sqrt() / (radius * k) * integral
}

#[test]
fn the_closed_chord_with_depth_errs_by_what_gamma_bends_along_it() {
    for (radius, bound) in [(0.01, 1e-4), (0.05, 2.5e-3), (0.2, 4e-2)] {
        for depth in [0.05, 0.15, 0.4] {
            let (lobe, sphere) = zenith(radius, -0.02);
            let (found, due) = (
                sphere_light_depth_chord(lobe, depth, sphere),
                chord_by_definition(lobe, depth, sphere),
            );
            // Four times the integral without depth is the largest there is.
            let error = (found - due).abs() / (4.0 * sphere_light_chords(lobe, sphere, 1));
            println!("{radius} {depth}: {error:.1e}");
            assert!(error < bound, "{radius} {depth}: {found:e} {due:e} {error:e}");
            assert!(found >= 0.0);
        }
    }
    // Where gamma is constant nothing is approximated: the light as wide as the lobe, no depth but at one angle.
    let (lobe, sphere) = zenith(1e-4, -0.020885);
    let found = sphere_light_depth_chord(lobe, 0.2, sphere) / chord_by_definition(lobe, 0.2, sphere);
    assert!((found - 1.0).abs() < 1e-6, "{found}");
}

#[test]
fn several_wavelengths_at_once_are_each_alone() {
    let mut random = Random::new(3);
    for _ in 0..200 {
        let (lobe, sphere) = scene(&mut random);
        let light = [0.45, 0.55, 0.65].map(|wavelength| Coherence {
            radius: 20.0,
            wavelength,
        });
        let row = lights::polygon(&mut random, 5);
        let vertices: Vec<[f64; 3]> = row[5..].chunks_exact(3).map(|v| [v[0], v[1], v[2]]).collect();
        let spheres = sphere_light_wavelengths(lobe, light, sphere, 1e-3);
        let polygons = polygon_light_wavelengths(lobe, light, &vertices, 1e-3);
        for (i, coherence) in light.into_iter().enumerate() {
            let alone = ScratchLobe { coherence, ..lobe };
            assert_eq!(spheres[i], sphere_light_within(alone, sphere, 1e-3));
            assert_eq!(polygons[i], polygon_light_within(alone, &vertices, 1e-3));
        }
    }
}

#[test]
fn the_mean_over_a_channel_is_the_mean_of_its_chords() {
    let mut random = Random::new(5);
    let mut tried = 0;
    while tried < 200 {
        let (lobe, sphere) = scene(&mut random);
        if sphere_light_chords(lobe, sphere, 1) < 1e-6 * lobe.whole_plane() {
            continue;
        }
        tried += 1;
        let ends = [0.48, 0.58];
        let [low, high] = ends.map(|wavelength| 1.0 / wavelength);
        let at = |wavelength| {
            let coherence = Coherence {
                wavelength,
                ..lobe.coherence
            };
            ScratchLobe { coherence, ..lobe }
        };
        let due = gauss(|k: f64| sphere_light_chords(at(1.0 / k), sphere, 1), [low, high], 40) / (high - low);
        let found = sphere_light_channel(lobe, ends, sphere);
        assert!((found - due).abs() < 1e-12 * lobe.whole_plane(), "{found:e} {due:e}");
        let [swapped, alone] = [[0.58, 0.48], [0.52, 0.52]].map(|ends| sphere_light_channel(lobe, ends, sphere));
        assert!((swapped - found).abs() < 1e-12 * lobe.whole_plane());
        assert_eq!(alone, sphere_light_chords(at(0.52), sphere, 1));
    }
    // A polygon's chords are those of the sphere that it stands for.
    let (lobe, _) = zenith(0.2, 0.0);
    let square = [[-0.3, -0.2, 1.0], [0.3, -0.2, 1.0], [0.3, 0.4, 1.0], [-0.3, 0.4, 1.0]];
    let due = gauss(
        |k: f64| {
            let coherence = Coherence {
                wavelength: 1.0 / k,
                ..lobe.coherence
            };
            polygon_light_chords(ScratchLobe { coherence, ..lobe }, &square, 1)
        },
        [1.0 / 0.7, 1.0 / 0.4],
        60,
    ) / (1.0 / 0.4 - 1.0 / 0.7);
    let found = polygon_light_channel(lobe, [0.4, 0.7], &square);
    assert!((found / due - 1.0).abs() < 1e-12, "{found:e} {due:e}");
}

#[test]
fn outside_the_domain_nothing_is_a_number() {
    let (lobe, sphere) = zenith(0.2, 0.0);
    let inside = Sphere { radius: 2.0, ..sphere };
    assert!(sphere_light_depth(lobe, f64::NAN, sphere).is_nan() && sphere_light_depth(lobe, 0.1, inside).is_nan());
    assert!(sphere_light_depth_chord(lobe, f64::INFINITY, sphere).is_nan());
    assert!(polygon_light_depth(lobe, 0.1, &[[0.0; 3]; 3]).is_nan());
    assert!(polygon_light_depth_chord(lobe, 0.1, &[[0.0; 3]; 3]).is_nan());
    assert!(sphere_light_channel(lobe, [0.5, -0.6], sphere).is_nan());
    assert!(polygon_light_channel(lobe, [0.5, 0.6], &[[0.0; 3]; 3]).is_nan());
    assert!(
        sphere_light_wavelengths(lobe, [lobe.coherence], inside, 1e-3)[0]
            .value
            .is_nan()
    );
    assert_eq!(sphere_light_depth(lobe, 0.0, sphere), 0.0);
    assert!(oracle::light::sphere_light(&[12.0, 0.6, 1.5, 0.02, -0.1, 0.0, 0.3, 1.0, 0.2]).value > 0.0);
}
