//! Area lights: symmetries and parts, places where a single chord fails, the oracle, chords by brute force, and what lies
//! outside the domain.

use iridescence::diffraction::Coherence;
use iridescence::geometry::{Arc, Cone, cone_chords, cone_outline, polygon_crossings, polygon_outline};
use iridescence::light::{
    LightIntegral, ScratchLobe, Sphere, polygon_light, polygon_light_chords, polygon_light_within, sphere_light,
    sphere_light_chords, sphere_light_within,
};
use reference::gauss::gauss;
use reference::generate::lights;
use reference::generate::random::Random;
use reference::oracle::light as oracle;
use std::f64::consts::{PI, TAU};

type Vector = [f64; 3];

/// Relative error of the exact value of a light that is seen.
const EXACT: f64 = 1e-9;
/// Absolute error by the roundings of directions.
const ROUNDING: f64 = 1e-15;

fn lobe(view: [f64; 2]) -> ScratchLobe {
    ScratchLobe {
        coherence: Coherence {
            radius: 30.0,
            wavelength: 0.55,
        },
        width: 2.5,
        view,
    }
}

fn lobe_of(row: &[f64]) -> ScratchLobe {
    ScratchLobe {
        coherence: Coherence {
            radius: row[0],
            wavelength: row[1],
        },
        width: row[2],
        view: [row[3], row[4]],
    }
}

fn sphere_of(row: &[f64]) -> Sphere {
    Sphere {
        centre: [row[5], row[6], row[7]],
        radius: row[8],
    }
}

fn vertices_of(row: &[f64]) -> Vec<Vector> {
    row[5..].chunks_exact(3).map(|v| [v[0], v[1], v[2]]).collect()
}

fn row_of(lobe: ScratchLobe, rest: impl IntoIterator<Item = f64>) -> Vec<f64> {
    let Coherence { radius, wavelength } = lobe.coherence;
    let mut row = vec![radius, wavelength, lobe.width, lobe.view[0], lobe.view[1]];
    row.extend(rest);
    row
}

fn sphere_row(lobe: ScratchLobe, sphere: Sphere) -> Vec<f64> {
    row_of(lobe, sphere.centre.into_iter().chain([sphere.radius]))
}

fn polygon_row(lobe: ScratchLobe, vertices: &[Vector]) -> Vec<f64> {
    row_of(lobe, vertices.iter().flatten().copied())
}

/// Both are equal but for a relative error and the roundings of directions.
#[track_caller]
fn agree(value: f64, due: f64, relative: f64) {
    assert!(
        (value - due).abs() <= relative * due.abs() + ROUNDING,
        "{value:e} is not {due:e}"
    );
}

#[track_caller]
fn sphere_is_the_oracles(lobe: ScratchLobe, sphere: Sphere) {
    let truth = oracle::sphere_light(&sphere_row(lobe, sphere)).value;
    agree(sphere_light(lobe, sphere), truth, EXACT);
    assert!((sphere_light_within(lobe, sphere, 1e-3).value - truth).abs() <= 1e-3 * truth + ROUNDING);
}

#[track_caller]
fn polygon_is_the_oracles(lobe: ScratchLobe, vertices: &[Vector]) {
    let truth = oracle::polygon_light(&polygon_row(lobe, vertices)).value;
    agree(polygon_light(lobe, vertices), truth, EXACT);
    assert!((polygon_light_within(lobe, vertices, 1e-3).value - truth).abs() <= 1e-3 * truth + ROUNDING);
}

fn polygon(random: &mut Random) -> (ScratchLobe, Vec<Vector>) {
    let count = random.integer(3, 8) as usize;
    let row = lights::polygon(random, count);
    (lobe_of(&row), vertices_of(&row))
}

fn quad(x: [f64; 2], y: [f64; 2], z: f64) -> [Vector; 4] {
    [[x[0], y[0], z], [x[1], y[0], z], [x[1], y[1], z], [x[0], y[1], z]]
}

fn dot(a: Vector, b: Vector) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn mixed(a: Vector, b: Vector, share: f64) -> Vector {
    std::array::from_fn(|k| a[k] + share * (b[k] - a[k]))
}

/// A sphere of a direction and an angle.
fn cap(axis: Vector, angle: f64) -> Sphere {
    Sphere {
        centre: axis,
        radius: dot(axis, axis).sqrt() * angle.sin(),
    }
}

#[test]
fn random_lights_have_the_oracles_value() {
    let mut random = Random::new(601);
    for _ in 0..400 {
        let row = lights::sphere(&mut random);
        let lobe = lobe_of(&row);
        let floor = 1e-6 * lobe.whole_plane();
        let (value, truth) = (sphere_light(lobe, sphere_of(&row)), oracle::sphere_light(&row).value);
        assert!(
            (value - truth).abs() <= EXACT * truth.max(floor),
            "{value:e} {truth:e} {row:?}"
        );
        let (lobe, vertices) = polygon(&mut random);
        let floor = 1e-6 * lobe.whole_plane();
        let row = polygon_row(lobe, &vertices);
        let (value, truth) = (polygon_light(lobe, &vertices), oracle::polygon_light(&row).value);
        assert!(
            (value - truth).abs() <= EXACT * truth.max(floor),
            "{value:e} {truth:e} {row:?}"
        );
    }
}

#[test]
fn every_tolerance_is_held_and_the_error_stated_is_a_bound() {
    let mut random = Random::new(602);
    let hold = |exact: f64, found: LightIntegral, tolerance: f64, text: &dyn Fn() -> String| {
        let apart = (found.value - exact).abs();
        assert!(
            found.value >= 0.0 && found.error >= 0.0 && found.chords >= 0.5,
            "{}",
            text()
        );
        assert!(
            apart <= tolerance * exact && apart <= found.error + EXACT * exact,
            "{found:?} {exact:e} {}",
            text()
        );
    };
    for _ in 0..3000 {
        let row = lights::sphere(&mut random);
        let (lobe, sphere) = (lobe_of(&row), sphere_of(&row));
        let tolerance = random.log_uniform(1e-5, 1e-1);
        let exact = sphere_light(lobe, sphere);
        if exact > 1e-6 * lobe.whole_plane() {
            hold(exact, sphere_light_within(lobe, sphere, tolerance), tolerance, &|| {
                format!("{row:?}")
            });
        }
        let (lobe, vertices) = polygon(&mut random);
        let exact = polygon_light(lobe, &vertices);
        if exact > 1e-6 * lobe.whole_plane() {
            let found = polygon_light_within(lobe, &vertices, tolerance);
            hold(exact, found, tolerance, &|| format!("{lobe:?} {vertices:?}"));
        }
    }
}

#[test]
fn a_small_sphere_far_out_in_the_lobe_holds_its_tolerance() {
    // There sinc^2 reaches 1/q^2, twice what its wave alone does.
    let row = [
        17.501772733623053,
        0.6706807645878535,
        2.830413951292065,
        -0.003186879935095856,
        -0.05238747002936851,
        0.0010589830185569978,
        -0.17412522464832053,
        0.009123897506420934,
        0.0006052026638436427,
    ];
    let found = sphere_light_within(lobe_of(&row), sphere_of(&row), 1e-2);
    let apart = (found.value - oracle::sphere_light(&row).value).abs();
    assert!(
        apart <= 1e-2 * found.value && apart <= found.error,
        "{found:?} {apart:e}"
    );
}

#[test]
fn the_corner_of_a_setting_sphere_that_reaches_the_band_keeps_its_digits() {
    // The rest of the outline is far from the corner.
    let row = [
        35.37949626681417,
        0.617075500972371,
        1.5799440304258132,
        0.4476989732092199,
        0.49517489216155125,
        -10.172324317572464,
        -6.053262018981012,
        -1.5153610298956335,
        6.742701137465101,
    ];
    let (value, truth) = (
        sphere_light(lobe_of(&row), sphere_of(&row)),
        oracle::sphere_light(&row).value,
    );
    assert!((value - truth).abs() < 3e-10 * truth, "{value:e} {truth:e}");
}

#[test]
fn a_sphere_tangent_to_the_line_gives_what_reaches_into_the_band() {
    for view in [[0.0, 0.1], [-0.4, 0.2]] {
        for angle in [1e-3, 0.05, 0.6] {
            for side in [-1.0, 1.0] {
                let turn = f64::acos(-view[0]) + side * angle;
                let sphere = cap([turn.cos(), 0.3 * turn.sin(), 0.91f64.sqrt() * turn.sin()], angle);
                sphere_is_the_oracles(lobe(view), sphere);
                let value = sphere_light(lobe(view), sphere);
                let [less, more] =
                    [-1e-9, 1e-9].map(|change| sphere_light(lobe(view), cap(sphere.centre, angle + change)));
                assert!(less < value && value < more, "{less:e} {value:e} {more:e}");
                assert!(value > 1e-6 * lobe(view).whole_plane());
            }
        }
    }
}

#[test]
fn a_sphere_of_three_hundredths_of_a_degree_is_right_on_the_line_and_beside_it() {
    for x in [0.0, 1e-3, -3e-3, 5e-3] {
        for z in [1.0, 0.3, 1e-3] {
            sphere_is_the_oracles(lobe([0.0, -0.1]), cap([x, 0.4, z], 0.03f64.to_radians()));
        }
    }
}

#[test]
fn a_tiny_sphere_is_its_projected_area_times_the_lobe() {
    let (angle, lobe) = (1e-7f64, lobe([0.02, -0.1]));
    let axis = [-0.021, 0.3, (1.0 - 0.021 * 0.021 - 0.09f64).sqrt()];
    let k = TAU / 0.55;
    let (t, q) = (30.0 * k * (axis[0] + 0.02), 1.25 * k * (axis[1] - 0.1));
    let due = PI * angle.sin().powi(2) * axis[2] * (-t * t).exp() * (q.sin() / q).powi(2);
    let value = sphere_light(lobe, cap(axis, angle));
    assert!((value / due - 1.0).abs() < 1e-7, "{value:e} {due:e}");
}

#[test]
fn a_light_with_an_edge_along_the_line_is_half_of_its_double() {
    for far in [1e-3, 0.01, 0.5] {
        let half = polygon_light(lobe([0.0, 0.1]), &quad([0.0, far], [-0.3, 0.6], 1.0));
        let other = polygon_light(lobe([0.0, 0.1]), &quad([-far, 0.0], [-0.3, 0.6], 1.0));
        let double = polygon_light(lobe([0.0, 0.1]), &quad([-far, far], [-0.3, 0.6], 1.0));
        agree(half, 0.5 * double, 1e-13);
        agree(other, 0.5 * double, 1e-13);
        let quick = polygon_light_within(lobe([0.0, 0.1]), &quad([0.0, far], [-0.3, 0.6], 1.0), 1e-4);
        agree(quick.value, half, 1e-4);
    }
}

#[test]
fn a_thin_quadrilateral_is_as_bright_as_it_is_wide() {
    let lobe = lobe([0.01, 0.1]);
    for (x, y) in [(-0.01, 0.3), (-0.012, 0.0), (0.3, -0.1)] {
        let slim = |width: f64| {
            // Upright and across: sides along y, along x, aslant.
            [
                [
                    [x, y, 1.0],
                    [x + width, y, 1.0],
                    [x + width, y + 0.4, 1.0],
                    [x, y + 0.4, 1.0],
                ],
                [
                    [x, y, 1.0],
                    [x - 0.4, y, 1.0],
                    [x - 0.4, y + width, 1.0],
                    [x, y + width, 1.0],
                ],
                [
                    [x, y, 1.0],
                    [x + 0.3, y + 0.3, 1.0],
                    [x + 0.3, y + 0.3 + width, 1.0],
                    [x, y + width, 1.0],
                ],
            ]
        };
        for (wide, narrow) in slim(1e-6).iter().zip(slim(1e-10)) {
            let (wide, narrow) = (polygon_light(lobe, wide) / 1e-6, polygon_light(lobe, &narrow) / 1e-10);
            let scale = wide + 1e-6 * lobe.whole_plane();
            assert!((wide - narrow).abs() < 3e-4 * scale, "{wide:e} {narrow:e}");
        }
    }
}

#[test]
fn a_light_seen_edge_on_is_dark_and_an_edge_seen_end_on_is_a_vertex() {
    let lobe = lobe([0.0, 0.1]);
    let (a, b, c) = ([0.2, 0.1, 1.0], [-0.3, 0.2, 0.8], [0.1, -0.6, 0.9]);
    let edge_on = [a, mixed(a, b, 0.7), b, mixed(a, b, 0.2).map(|x| 2.0 * x)];
    assert!(polygon_light(lobe, &edge_on) < ROUNDING);
    assert!(polygon_light(lobe, &[a, a.map(|x| 3.0 * x), b]) < ROUNDING);
    let triangle = polygon_light(lobe, &[a, b, c]);
    agree(polygon_light(lobe, &[a, a.map(|x| 2.0 * x), b, c]), triangle, 1e-13);
    agree(polygon_light(lobe, &[a, b, b.map(|x| 0.25 * x), c]), triangle, 1e-13);
    assert!(triangle > 0.0);
}

#[test]
fn a_light_that_goes_down_at_both_ends_of_a_line_has_two_chords_on_it() {
    let mut random = Random::new(603);
    let mut found = 0;
    for _ in 0..40_000 {
        let axis = [
            random.uniform(-1.0, 1.0),
            random.uniform(-0.3, 0.3),
            random.uniform(-0.8, -0.01),
        ];
        let sphere = cap(axis, random.uniform(0.8, 1.5));
        let x = random.uniform(-0.9, 0.9);
        let cone = Cone::of_sphere(sphere.centre, sphere.radius).expect("outside");
        if let [Some(low), Some(high)] = cone_chords(cone, x) {
            assert!(
                low[0] < low[1] && low[1] < high[0] && high[0] < high[1],
                "{low:?} {high:?}"
            );
            found += 1;
            if found <= 40 {
                let lobe = lobe([-x, random.uniform(-0.3, 0.3)]);
                sphere_is_the_oracles(lobe, sphere);
                let due = oracle::sphere_light_chord(&sphere_row(lobe, sphere));
                agree(sphere_light_chords(lobe, sphere, 1), due, 1e-10);
            }
        }
    }
    assert!(found > 200, "{found}");
}

#[test]
fn a_light_that_wraps_below_the_horizon_at_both_ends_is_the_oracles() {
    // A strip of the sky from one horizon to the other, across the line and along it.
    let across = |[a, b]: [f64; 2]| {
        let side = |x: f64| [[x, -3.0, -1.0], [x, 0.0, 1.0], [x, 3.0, -1.0]];
        let ([a0, a1, a2], [b0, b1, b2]) = (side(a), side(b));
        [a0, a1, a2, b2, b1, b0]
    };
    let along = |ends| across(ends).map(|[x, y, z]| [y, x, z]);
    for ends in [[0.5, 0.1], [0.2, 0.18], [-0.1, -0.6]] {
        for view in [-0.4, -0.19, -0.1, 0.09, 0.3] {
            polygon_is_the_oracles(lobe([view, 0.1]), &across(ends));
            polygon_is_the_oracles(lobe([view, -0.3]), &along(ends));
        }
    }
    // With the zenith inside the oracle has no side to look from; the parts have.
    for [a, b] in [[0.3, -0.02], [0.01, -0.01], [0.001, -0.4]] {
        for turned in [false, true] {
            let strip = |ends| if turned { along(ends) } else { across(ends) };
            let value = |ends| polygon_light(lobe([0.0, 0.1]), &strip(ends));
            agree(value([a, 0.5 * a]) + value([0.5 * a, b]), value([a, b]), 1e-12);
            agree(value([a, 0.0]) + value([0.0, b]), value([a, b]), 1e-12);
        }
    }
}

#[test]
fn first_vertex_direction_and_repeated_vertices_do_not_matter() {
    let mut random = Random::new(604);
    for _ in 0..1000 {
        let (lobe, mut vertices) = polygon(&mut random);
        let value = polygon_light(lobe, &vertices);
        let again = |vertices: &[Vector]| agree(polygon_light(lobe, vertices), value, 1e-10);
        vertices.rotate_left(1);
        again(&vertices);
        vertices.reverse();
        again(&vertices);
        let quick = polygon_light_within(lobe, &vertices, 1e-3).value;
        assert!(quick >= 0.0);
        let place = random.integer(0, vertices.len() as i64 - 1) as usize;
        vertices.insert(place, vertices[place]);
        again(&vertices);
        vertices.insert(place, vertices[place]);
        again(&vertices);
    }
}

#[test]
fn a_polygon_is_the_sum_of_its_parts() {
    let mut random = Random::new(605);
    for _ in 0..1000 {
        let row = lights::polygon(&mut random, 3);
        let lobe = lobe_of(&row);
        let [a, b, c] = [0, 1, 2].map(|i| vertices_of(&row)[i]);
        let value = |vertices: &[Vector]| polygon_light(lobe, vertices);
        let whole = value(&[a, b, c]);
        // Cut by a line, and by a point within.
        let on = mixed(a, b, random.uniform(0.0, 1.0));
        agree(value(&[a, on, c]) + value(&[on, b, c]), whole, 1e-10);
        agree(value(&[a, on, b, c]), whole, 1e-10);
        let within = mixed(on, c, random.uniform(0.0, 1.0));
        let parts = value(&[a, b, within]) + value(&[b, c, within]) + value(&[c, a, within]);
        agree(parts, whole, 1e-10);
        // A dent is what is left of the whole without a triangle.
        agree(value(&[a, b, c, within]), whole - value(&[c, a, within]), 1e-9);
    }
}

#[test]
fn a_quadrilateral_is_the_sum_of_two_triangles() {
    let mut random = Random::new(606);
    for _ in 0..500 {
        let row = lights::polygon(&mut random, 4);
        let lobe = lobe_of(&row);
        let v = vertices_of(&row);
        let side = |a: Vector, b: Vector, c: Vector| {
            let [p, q] = [b, c].map(|x| [x[0] - a[0], x[1] - a[1], x[2] - a[2]]);
            [
                p[1] * q[2] - p[2] * q[1],
                p[2] * q[0] - p[0] * q[2],
                p[0] * q[1] - p[1] * q[0],
            ]
        };
        if dot(side(v[0], v[1], v[2]), side(v[0], v[2], v[3])) > 0.0 {
            let parts = polygon_light(lobe, &[v[0], v[1], v[2]]) + polygon_light(lobe, &[v[0], v[2], v[3]]);
            agree(polygon_light(lobe, &v), parts, 1e-10);
        }
    }
}

#[test]
fn a_mirrored_scene_has_the_same_value() {
    let mut random = Random::new(607);
    for _ in 0..1000 {
        for signs in [[-1.0, 1.0], [1.0, -1.0], [-1.0, -1.0]] {
            let mirror = |v: Vector| [signs[0] * v[0], signs[1] * v[1], v[2]];
            let seen = |lobe: ScratchLobe| ScratchLobe {
                view: [signs[0] * lobe.view[0], signs[1] * lobe.view[1]],
                ..lobe
            };
            let (lobe, vertices) = polygon(&mut random);
            let other: Vec<Vector> = vertices.iter().map(|&v| mirror(v)).collect();
            agree(polygon_light(seen(lobe), &other), polygon_light(lobe, &vertices), 1e-10);
            let row = lights::sphere(&mut random);
            let (lobe, sphere) = (lobe_of(&row), sphere_of(&row));
            let other = Sphere {
                centre: mirror(sphere.centre),
                ..sphere
            };
            agree(sphere_light(seen(lobe), other), sphere_light(lobe, sphere), 1e-10);
        }
    }
}

#[test]
fn a_sphere_lies_between_the_polygons_in_and_about_its_circle() {
    let mut random = Random::new(608);
    let mut seen = 0;
    for _ in 0..60 {
        let row = lights::sphere(&mut random);
        let (lobe, sphere) = (lobe_of(&row), sphere_of(&row));
        let cone = Cone::of_sphere(sphere.centre, sphere.radius).expect("outside");
        let [x, y, z] = cone.axis;
        let size = x.hypot(y);
        let (u, v) = ([-y / size, x / size, 0.0], [-z * x / size, -z * y / size, size]);
        let around = |count: u32, stretch: f64| {
            let reach = stretch * cone.sine / cone.cosine;
            let vertices: Vec<Vector> = (0..count)
                .map(|i| {
                    let (sine, cosine) = (TAU * f64::from(i) / f64::from(count)).sin_cos();
                    std::array::from_fn(|k| cone.axis[k] + reach * (cosine * u[k] + sine * v[k]))
                })
                .collect();
            polygon_light(lobe, &vertices)
        };
        let [inner, outer] = [1.0, 1.0 / (PI / 512.0).cos()].map(|stretch| around(512, stretch));
        let value = sphere_light(lobe, sphere);
        if value > 1e-6 * lobe.whole_plane() {
            assert!(inner < value && value < outer, "{inner:e} {value:e} {outer:e} {row:?}");
            // By area 512 sides are 1 - 2 pi^2/(3 n^2) and 1 + pi^2/(3 n^2) of the circle.
            let mean = (inner + 2.0 * outer) / 3.0;
            assert!((mean - value).abs() < 1e-4 * value, "{mean:e} {value:e} {row:?}");
            seen += 1;
        }
    }
    assert!(seen > 20, "{seen}");
}

#[test]
fn the_whole_sky_is_the_integral_over_the_disc() {
    for view in [[0.0, 0.0], [0.3, -0.2], [-0.6, 0.5]] {
        let lobe = lobe(view);
        let along = TAU / 0.55 * 30.0;
        let across = PI / 0.55 * 2.5;
        let strip = |x: f64| {
            let edge = (1.0 - x * x).sqrt();
            let sinc = |y: f64| {
                let q = across * (y + view[1]);
                if q == 0.0 { 1.0 } else { (q.sin() / q).powi(2) }
            };
            (-(along * (x + view[0])).powi(2)).exp() * gauss(sinc, [-edge, edge], 40)
        };
        let due = gauss(strip, [-view[0] - 7.0 / along, -view[0] + 7.0 / along], 20);
        let axes = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [-1.0, 0.0, 0.0], [0.0, -1.0, 0.0]];
        agree(polygon_light(lobe, &axes), due, 1e-11);
        let turned = axes.map(|[x, y, _]| [0.6 * x - 0.8 * y, 0.8 * x + 0.6 * y, -0.0]);
        agree(polygon_light(lobe, &turned), due, 1e-11);
        agree(polygon_light(lobe, &axes.map(|[x, y, _]| [x, y, 1e-12])), due, 1e-10);
        agree(
            polygon_light(lobe, &axes.map(|[x, y, _]| [1e9 * x, 1e9 * y, 1.0])),
            due,
            1e-8,
        );
        let all = Sphere {
            centre: [0.0, 0.0, 1.0],
            radius: 1.0 - 1e-15,
        };
        agree(sphere_light(lobe, all), due, 1e-6);
        assert_eq!(polygon_light(lobe, &axes.map(|[x, y, _]| [x, y, -1e-12])), 0.0);
        assert_eq!(sphere_light(lobe, cap([0.0, 0.0, -1.0], 1.5)), 0.0);
    }
}

#[test]
fn a_vertex_on_the_horizon_and_the_next_just_below_it_add_nothing() {
    let lobe = ScratchLobe {
        coherence: Coherence {
            radius: 6.669671062759954,
            wavelength: 0.7436819083995333,
        },
        width: 0.49855954251271134,
        view: [0.5586604321468334, 0.0],
    };
    let light = |z: f64| {
        [
            [-0.01677301772018347, -0.11909403640508665, 0.7398902094387229],
            [-1.166809698705181, -0.011227832565464835, 0.0],
            [-0.6917219097737861, -0.890723484303534, z],
        ]
    };
    let due = polygon_light(lobe, &light(0.0));
    for z in [-0.0, -1e-300, -1e-17, -1e-15, -1e-12, 1e-300, 1e-17, 1e-15] {
        agree(polygon_light(lobe, &light(z)), due, 1e-10);
        agree(polygon_light_within(lobe, &light(z), 1e-3).value, due, 1e-3);
        polygon_is_the_oracles(lobe, &light(z));
    }
}

#[test]
fn a_setting_sphere_whose_circle_meets_the_end_of_the_x_axis_is_seen() {
    let lobe = ScratchLobe {
        coherence: Coherence {
            radius: 13.997837112683037,
            wavelength: 0.46862260717961685,
        },
        width: 1.137136734530704,
        view: [1.0, 0.0],
    };
    for change in [-1e-12, -1e-15, 0.0, 1e-15, 1e-12] {
        let sphere = Sphere {
            centre: [-0.9999941917540782, -0.0020449755301337365, -0.002726634040178316],
            radius: 0.003408292550223082 + change,
        };
        let (value, truth) = (
            sphere_light(lobe, sphere),
            oracle::sphere_light(&sphere_row(lobe, sphere)).value,
        );
        assert!((value - truth).abs() < 1e-6 * truth, "{value:e} {truth:e}");
    }
}

#[test]
fn a_chord_that_begins_in_a_vertex_on_the_horizon_has_its_length() {
    // The line goes through the first vertex, which rounding puts on either side of it as the edge goes down.
    let lobe = ScratchLobe {
        coherence: Coherence {
            radius: 39.332839746431205,
            wavelength: 0.7748552557807427,
        },
        width: 1.2037716426669818,
        view: [0.6959297275956737, -0.5260222080729394],
    };
    let vertices = [
        [-0.6959297275956737, 0.7181098900924644, 0.0],
        [-2.186233027993401, 0.31691131109213183, -0.47711722878898927],
        [-0.25859341642091455, -0.3108494889994512, 2.103148587457545],
        [1.3664865612466373, 1.2357517744281619, 0.7246027158641686],
    ];
    let chord = polygon_light_chords(lobe, &vertices, 1);
    let beside = |step: f64| {
        let view = [lobe.view[0] + step, lobe.view[1]];
        polygon_light_chords(ScratchLobe { view, ..lobe }, &vertices, 1)
    };
    let [less, more] = [-1e-9, 1e-9].map(beside);
    assert!(
        (less - more).abs() < 1e-4 * less && (chord - less).abs() < 1e-4 * less,
        "{less:e} {chord:e} {more:e}"
    );
    assert!(chord <= lobe.whole_plane());
}

#[test]
fn crossings_of_a_polygon_go_up_and_down_in_turn_and_stay_on_the_sphere() {
    let mut random = Random::new(609);
    let mut met = 0;
    for i in 0..1_000_000 {
        let count = random.integer(3, 7) as usize;
        let [cx, cy, cz] = [0; 3].map(|_| random.uniform(-1.0, 1.0));
        let mut vertices = [[0.0; 3]; 7];
        for v in &mut vertices[..count] {
            *v = [cx, cy, cz].map(|c| c + 0.7 * random.uniform(-1.0, 1.0));
            if i % 5 == 0 {
                v[2] = random.pick(&[0.0, -0.0, 1e-17, -1e-17, 0.5, -0.5]);
            }
        }
        let light = &vertices[..count];
        // Half of the lines pass through a vertex.
        let x = if random.chance(0.5) {
            light[0][0] / dot(light[0], light[0]).sqrt()
        } else {
            random.uniform(-1.0, 1.0)
        };
        let (mut number, mut last) = (0, None);
        let edge = ((1.0 - x) * (1.0 + x)).sqrt();
        assert!(polygon_crossings(light, x, |crossing| {
            assert_ne!(last, Some(crossing.upward), "{x} {light:?}");
            assert!(crossing.y.abs() <= edge + 1e-7, "{crossing:?} {x} {light:?}");
            last = Some(crossing.upward);
            number += 1;
        }));
        assert_eq!(number % 2, 0, "{x} {light:?}");
        met += u32::from(number > 0);
    }
    assert!(met > 200_000, "{met}");
}

#[test]
fn chords_of_a_cone_are_where_directions_belong_to_it() {
    let mut random = Random::new(610);
    let mut met = 0;
    for _ in 0..2000 {
        let axis = [0; 3].map(|_| random.uniform(-1.0, 1.0));
        let sphere = cap(axis, random.uniform(0.01, 1.55));
        let cone = Cone::of_sphere(sphere.centre, sphere.radius).expect("outside");
        let x = random.uniform(-1.0, 1.0);
        let edge = ((1.0 - x) * (1.0 + x)).sqrt();
        // In the angle along the half circle, where no end is steep.
        let inside = |turn: f64| dot(cone.axis, [x, -edge * turn.cos(), edge * turn.sin()]) >= cone.cosine;
        let mut ends = Vec::new();
        const STEPS: u32 = 400;
        let at = |i: u32| PI * (f64::from(i) + 0.5) / f64::from(STEPS);
        if inside(at(0)) {
            ends.push(-edge);
        }
        for i in 1..STEPS {
            let (mut low, mut high) = (at(i - 1), at(i));
            if inside(low) != inside(high) {
                for _ in 0..50 {
                    let middle = 0.5 * (low + high);
                    if inside(middle) == inside(low) {
                        low = middle
                    } else {
                        high = middle
                    }
                }
                ends.push(-edge * low.cos());
            }
        }
        if inside(at(STEPS - 1)) {
            ends.push(edge);
        }
        let chords: Vec<f64> = cone_chords(cone, x).into_iter().flatten().flatten().collect();
        // What the steps miss is shorter than two of them.
        let long = |ends: &[f64]| ends.chunks_exact(2).filter(|e| e[1] - e[0] > 0.02).count();
        if chords.len() == ends.len() {
            for (a, b) in chords.iter().zip(&ends) {
                assert!((a - b).abs() < 1e-4, "{cone:?} {x}: {chords:?} {ends:?}");
            }
            met += usize::from(!ends.is_empty());
        } else {
            assert!(
                long(&chords) <= long(&ends) + 1 && chords.len().abs_diff(ends.len()) <= 2,
                "{cone:?} {x}: {chords:?} {ends:?}"
            );
            let total = |ends: &[f64]| ends.chunks_exact(2).map(|e| e[1] - e[0]).sum::<f64>();
            assert!(
                (total(&chords) - total(&ends)).abs() < 0.02,
                "{cone:?} {x}: {chords:?} {ends:?}"
            );
        }
    }
    assert!(met > 700, "{met}");
    let cone = Cone::of_sphere([0.0, 0.0, 1.0], 0.5).expect("outside");
    assert_eq!(cone_chords(cone, 1.5), [None, None]);
    assert_eq!(cone_chords(cone, f64::NAN), [None, None]);
}

#[test]
fn chords_on_the_line_are_the_oracles() {
    let mut random = Random::new(611);
    for _ in 0..1500 {
        let row = lights::sphere(&mut random);
        let lobe = lobe_of(&row);
        let allowed = |due: f64| 1e-9 * due + 1e-9 * lobe.whole_plane();
        let (value, due) = (
            sphere_light_chords(lobe, sphere_of(&row), 1),
            oracle::sphere_light_chord(&row),
        );
        assert!((value - due).abs() <= allowed(due), "{value:e} {due:e} {row:?}");
        let (lobe, vertices) = polygon(&mut random);
        let row = polygon_row(lobe, &vertices);
        let allowed = |due: f64| 1e-9 * due + 1e-9 * lobe.whole_plane();
        let (value, due) = (
            polygon_light_chords(lobe, &vertices, 1),
            oracle::polygon_light_chord(&row),
        );
        assert!((value - due).abs() <= allowed(due), "{value:e} {due:e} {row:?}");
    }
}

#[test]
fn where_a_light_covers_the_band_more_chords_are_better() {
    let (lobe, sphere) = (lobe([0.1, -0.2]), cap([-0.12, 0.1, 0.9], 0.2));
    let exact = sphere_light(lobe, sphere);
    let errors = [1, 2, 3, 4, 5].map(|count| (sphere_light_chords(lobe, sphere, count) / exact - 1.0).abs());
    assert!(
        errors[0] < 1e-3 && errors[2] < 1e-2 * errors[0] && errors[4] < 1e-2 * errors[2],
        "{errors:?}"
    );
    let light = quad([-0.5, 0.3], [0.1, 0.4], 1.0);
    let exact = polygon_light(lobe, &light);
    let errors = [1, 2, 3, 4, 5].map(|count| (polygon_light_chords(lobe, &light, count) / exact - 1.0).abs());
    assert!(
        errors[0] < 1e-3 && errors[2] < 1e-2 * errors[0] && errors[4] < 1e-9,
        "{errors:?}"
    );
    for count in [0, 6, usize::MAX] {
        assert!(
            sphere_light_chords(lobe, sphere, count).is_nan() && polygon_light_chords(lobe, &light, count).is_nan()
        );
    }
}

#[test]
fn an_arc_of_no_length_has_no_piece_and_a_turn_at_its_end_ends_it() {
    let arc = |from: [f64; 2], to: [f64; 2]| Arc {
        centre: [0.0; 2],
        reach: 1.0,
        across: [0.0, 1.0],
        from,
        to,
        reflex: false,
    };
    let length = |arc: Arc| {
        let mut sum = 0.0;
        arc.monotone_pieces(|[from, to]| sum += f64::abs(to[0] - from[0]));
        sum
    };
    // Neighbours of rounding in either order, all round the circle.
    for i in 0..1000 {
        let (s, c) = (TAU * f64::from(i) / 1000.0).sin_cos();
        for [a, b] in [
            [1.0, 1.0],
            [1.0, -1.0],
            [-1.0, 1.0],
            [-1.0, -1.0],
            [1.0, 0.0],
            [0.0, 1.0],
        ] {
            let near = [c * (1.0 + a * f64::EPSILON), s * (1.0 + b * f64::EPSILON)];
            assert!(
                length(arc([c, s], near)) < 1e-8 && length(arc(near, [c, s])) < 1e-8,
                "{c} {s} {near:?}"
            );
        }
    }
    for beyond in [-1.0, -1.0 - f64::EPSILON, -1.0 + f64::EPSILON] {
        for s in [-1e-13, 0.0, 1e-13] {
            assert!(
                (length(arc([0.0, 1.0], [beyond, s])) - 1.0).abs() < 1e-12,
                "{beyond} {s}"
            );
            assert!(
                (length(arc([beyond, s], [0.0, -1.0])) - 1.0).abs() < 1e-12,
                "{beyond} {s}"
            );
        }
    }
}

#[test]
fn outlines_close() {
    let mut random = Random::new(612);
    let closes = |points: &[[[f64; 2]; 2]], text: &dyn Fn() -> String| {
        for (i, [_, to]) in points.iter().enumerate() {
            let [from, _] = points[(i + 1) % points.len()];
            let gap = (to[0] - from[0]).hypot(to[1] - from[1]);
            assert!(gap < 1e-7, "{gap:e}: {points:?} {}", text());
        }
    };
    for _ in 0..20_000 {
        let (_, vertices) = polygon(&mut random);
        let mut points = Vec::new();
        assert!(polygon_outline(&vertices, |arc| points.push([arc.point(arc.from), arc.point(arc.to)])));
        closes(&points, &|| format!("{vertices:?}"));
        let sphere = sphere_of(&lights::sphere(&mut random));
        let cone = Cone::of_sphere(sphere.centre, sphere.radius).expect("outside");
        let mut points = Vec::new();
        cone_outline(cone, |arc| points.push([arc.point(arc.from), arc.point(arc.to)]));
        closes(&points, &|| format!("{sphere:?}"));
    }
}

#[test]
fn the_unit_of_length_does_not_matter_nor_the_distance_of_the_vertices_of_a_triangle() {
    let mut random = Random::new(613);
    for _ in 0..500 {
        let row = lights::sphere(&mut random);
        let (lobe, sphere) = (lobe_of(&row), sphere_of(&row));
        let unit = 2f64.powi(random.integer(-900, 900) as i32);
        let scaled = Sphere {
            centre: sphere.centre.map(|x| x * unit),
            radius: sphere.radius * unit,
        };
        assert_eq!(
            sphere_light(lobe, scaled),
            sphere_light(lobe, sphere),
            "{row:?} {unit:e}"
        );
        let (lobe, vertices) = polygon(&mut random);
        let scaled: Vec<Vector> = vertices.iter().map(|v| v.map(|x| x * unit)).collect();
        assert_eq!(
            polygon_light(lobe, &scaled),
            polygon_light(lobe, &vertices),
            "{vertices:?} {unit:e}"
        );
        let row = lights::polygon(&mut random, 3);
        let (lobe, vertices) = (lobe_of(&row), vertices_of(&row));
        let value = polygon_light(lobe, &vertices);
        let far: Vec<Vector> = vertices
            .iter()
            .map(|v| {
                let stretch = 10f64.powi(random.pick(&[-150, -40, -3, 0, 3, 40, 150]));
                v.map(|x| x * stretch)
            })
            .collect();
        let stretched = polygon_light(lobe, &far);
        // Near vertices lose the digits of their difference.
        assert!(
            (stretched - value).abs() <= 1e-9 * value + 1e-13,
            "{value:e} {stretched:e} {far:?}"
        );
    }
}

#[test]
fn nan_in_any_place_gives_nan() {
    let sphere = [30.0, 0.55, 2.5, 0.1, 0.2, -0.1, 0.1, 0.9, 0.2];
    let polygon = [30.0, 0.55, 2.5, 0.1, 0.2, -0.3, 0.0, 0.9, 0.3, 0.1, 1.0, 0.0, 0.5, 0.8];
    let dark = |row: &[f64]| {
        let lobe = lobe_of(row);
        if row.len() == 9 {
            let found = sphere_light_within(lobe, sphere_of(row), 1e-2);
            [
                sphere_light(lobe, sphere_of(row)),
                sphere_light_chords(lobe, sphere_of(row), 1),
                found.value,
                found.error,
            ]
        } else {
            let vertices = vertices_of(row);
            let found = polygon_light_within(lobe, &vertices, 1e-2);
            [
                polygon_light(lobe, &vertices),
                polygon_light_chords(lobe, &vertices, 1),
                found.value,
                found.error,
            ]
        }
    };
    for row in [sphere.as_slice(), &polygon] {
        assert!(dark(row)[..3].iter().all(|&x| x > 0.0));
        for i in 0..row.len() {
            for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
                let mut spoilt = row.to_vec();
                spoilt[i] = bad;
                assert!(
                    dark(&spoilt).iter().all(|x| x.is_nan()),
                    "{i} {bad}: {:?}",
                    dark(&spoilt)
                );
            }
        }
        for (i, bad) in [
            (0, 0.0),
            (0, -1.0),
            (1, 0.0),
            (1, -0.5),
            (2, 0.0),
            (2, -1.0),
            (3, 1.1),
            (4, -1.01),
        ] {
            let mut spoilt = row.to_vec();
            spoilt[i] = bad;
            assert!(
                dark(&spoilt).iter().all(|x| x.is_nan()),
                "{i} {bad}: {:?}",
                dark(&spoilt)
            );
            assert!(i > 2 || lobe_of(&spoilt).whole_plane().is_nan());
        }
    }
    // Inside the sphere, on it, a negative radius, no centre; a vertex at the point.
    for (i, bad) in [(8, 2.0), (8, -0.1)] {
        let mut spoilt = sphere;
        spoilt[i] = bad;
        assert!(dark(&spoilt).iter().all(|x| x.is_nan()));
    }
    let at_the_point = [30.0, 0.55, 2.5, 0.1, 0.2, 0.0, 0.0, 1.0, 1.0];
    assert!(dark(&at_the_point).iter().all(|x| x.is_nan()));
    let mut centre = at_the_point;
    centre[7] = 0.0;
    assert!(dark(&centre).iter().all(|x| x.is_nan()));
    let mut vertex = polygon;
    vertex[5..8].fill(0.0);
    assert!(dark(&vertex).iter().all(|x| x.is_nan()));
}

#[test]
fn nothing_is_seen_of_points_lines_and_what_is_below_the_horizon() {
    let lobe = lobe([0.0, 0.0]);
    let point = Sphere {
        centre: [0.0, 0.0, 1.0],
        radius: 0.0,
    };
    assert_eq!(sphere_light(lobe, point), 0.0);
    assert_eq!(sphere_light_within(lobe, point, 1e-2).value, 0.0);
    assert_eq!(sphere_light_chords(lobe, point, 1), 0.0);
    for vertices in [&[][..], &[[0.0, 0.0, 1.0]], &[[-0.1, 0.0, 1.0], [0.1, 0.0, 1.0]]] {
        assert_eq!(polygon_light(lobe, vertices), 0.0);
        assert_eq!(polygon_light_within(lobe, vertices, 1e-2).value, 0.0);
        assert_eq!(polygon_light_chords(lobe, vertices, 1), 0.0);
    }
    let same = [[0.0, 0.1, 1.0]; 4];
    assert_eq!(polygon_light(lobe, &same), 0.0);
    let below = quad([-0.5, 0.5], [-0.5, 0.5], -1e-3);
    assert_eq!(polygon_light(lobe, &below), 0.0);
    assert_eq!(
        polygon_light_within(lobe, &below, 1e-2),
        polygon_light_within(lobe, &[], 1e-2)
    );
    assert_eq!(polygon_light_chords(lobe, &below, 1), 0.0);
    assert_eq!(sphere_light(lobe, cap([0.0, 0.3, -0.3], 0.7)), 0.0);
    assert!(sphere_light(lobe, cap([0.0, 0.3, -0.3], 0.8)) > 0.0);
}

#[test]
fn no_tolerance_gives_a_value_that_is_not_finite() {
    let mut random = Random::new(614);
    for _ in 0..300 {
        let row = lights::sphere(&mut random);
        let (lobe, sphere) = (lobe_of(&row), sphere_of(&row));
        let (other, vertices) = polygon(&mut random);
        let within = |tolerance: f64| {
            [
                sphere_light_within(lobe, sphere, tolerance),
                polygon_light_within(other, &vertices, tolerance),
            ]
        };
        let exact = [sphere_light(lobe, sphere), polygon_light(other, &vertices)];
        for tolerance in [0.0, 5e-324, 1e-12] {
            assert_eq!(within(tolerance).map(|found| found.value), exact, "{tolerance:e}");
        }
        for tolerance in [0.5, 1.0, 10.0, 1e300, f64::INFINITY] {
            for (found, exact) in within(tolerance).into_iter().zip(exact) {
                assert!(found.value >= 0.0 && found.error >= 0.0, "{found:?}");
                assert!(
                    found.value <= 4.0 * exact + 1e-12 && found.chords < 1e4,
                    "{found:?} {exact:e}"
                );
            }
        }
        for tolerance in [f64::NAN, -1.0, -1e-300, f64::NEG_INFINITY] {
            assert!(
                within(tolerance).iter().all(|found| found.value.is_nan()),
                "{tolerance}"
            );
        }
    }
}

#[test]
fn a_tiny_sphere_half_below_the_horizon_is_not_negative() {
    let lobe = ScratchLobe {
        coherence: Coherence {
            radius: 43.49372474793465,
            wavelength: 0.6646795883396173,
        },
        width: 31.089886148029866,
        view: [-0.47641968162560666, -0.7635602706792409],
    };
    let sphere = Sphere {
        centre: [0.47714935269426967, 0.878822220487989, 0.0],
        radius: 2.138014372917423e-9,
    };
    for tolerance in [0.0, 1e-3, 1e-2] {
        assert!(sphere_light_within(lobe, sphere, tolerance).value >= 0.0);
    }
}
