//! The adaptive values against sums over grids, Monte Carlo, another rule, and integrals along the outline.

use super::adaptive::{Grading, Rule};
use super::scenes::{Scene, plane, polygon_scene, scenes, scratch_and_direction, sphere_scene};
use super::vectors::{Vector, add_scaled, cross, dot, frame, length};
use super::*;
use crate::gauss::gauss;
use crate::generate::random::Random;
use std::f64::consts::PI;

/// Another rule, grading and inner quadrature.
const OTHER: Rule = Rule {
    points: 21,
    tolerance: 1e-13,
    grading: Grading::Cubic,
    panels: Some(12),
};

/// Above the horizon by so much.
fn lowest(row: &[f64]) -> f64 {
    let vertices = vertices_of(row);
    vertices.iter().map(|v| v[2] / length(*v)).fold(1.0, f64::min)
}

fn assert_agree(a: LightValue, b: LightValue, what: &dyn std::fmt::Debug) {
    assert!((a.value - b.value).abs() <= a.error + b.error, "{a:?} {b:?}: {what:?}");
}

/// int sinc^2 over a chord by a plain rule.
fn chord(scratch: &Scratch, [low, high]: [f64; 2]) -> f64 {
    let pieces = (scratch.half_wave * (high - low).abs()).ceil().max(1.0);
    let f = |y: f64| scratch.integrand([-scratch.view[0], y]);
    gauss(f, [low, high], pieces as usize)
}

fn gaussian(scratch: &Scratch, x: f64) -> f64 {
    scratch.integrand([x, -scratch.view[1]])
}

/// The sphere by the angle along its outline, which turns the square roots of its chords into a sine; of the row of a
/// sphere above the horizon. Positive throughout.
fn sphere_by_its_outline(row: &[f64]) -> f64 {
    let scratch = Scratch::new(row).unwrap();
    let cone = Cone::new(sphere_of(row).0, row[8]).unwrap();
    let [x, y, z] = cone.axis;
    let (sine, cosine) = cone.angle.sin_cos();
    // Towards larger x on the outline, and square to it, without x.
    let rho = y.hypot(z);
    let (up, across) = ([rho, -x * y / rho, -x * z / rho], [0.0, -z / rho, y / rho]);
    let f = |psi: f64| {
        let x = x * cosine + up[0] * sine * psi.cos();
        let weight = gaussian(&scratch, x) * up[0] * sine * psi.sin();
        if weight == 0.0 {
            return 0.0;
        }
        let y = |psi: f64| y * cosine + sine * (up[1] * psi.cos() + across[1] * psi.sin());
        weight * chord(&scratch, [y(psi), y(-psi)])
    };
    gauss(f, [0.0, PI], 4000)
}

/// The polygon by Green's theorem along its edges; of the row of a polygon above the horizon. Loses what cancels.
fn polygon_by_its_outline(row: &[f64]) -> f64 {
    let scratch = Scratch::new(row).unwrap();
    let vertices: Vec<Vector> = vertices_of(row).iter().map(|v| v.map(|x| x / length(*v))).collect();
    // Any line of constant y does; one through the light costs least.
    let base = vertices.iter().map(|v| v[1]).sum::<f64>() / vertices.len() as f64;
    let mut sum = 0.0;
    for (i, &from) in vertices.iter().enumerate() {
        let along = add_scaled(vertices[(i + 1) % vertices.len()], -1.0, from);
        let f = |t: f64| {
            let q = add_scaled(from, t, along);
            let size = length(q);
            let [x, y, _] = q.map(|x| x / size);
            let advance = dot(q, along) / size;
            let weight = gaussian(&scratch, x) * (along[0] - x * advance) / size;
            if weight.abs() < 1e-25 {
                0.0
            } else {
                weight * chord(&scratch, [base, y])
            }
        };
        sum += gauss(f, [0.0, 1.0], 2500);
    }
    sum.abs()
}

#[test]
fn another_rule_gives_the_same_within_the_stated_errors_and_eleven_digits() {
    for (scene, value) in [
        (
            sphere_scene as Scene,
            sphere_light_by as fn(&[f64], &Rule) -> LightValue,
        ),
        (polygon_scene, polygon_light_by),
    ] {
        for row in scenes(scene, 1, 300) {
            let (a, b) = (value(&row, &ACCURATE), value(&row, &OTHER));
            assert_agree(a, b, &row);
            assert!(a.value >= 0.0, "{a:?}: {row:?}");
            if a.value > 1e-12 * plane(&row) {
                assert!((a.value - b.value).abs() < 1e-11 * a.value, "{a:?} {b:?}: {row:?}");
            }
            if a.value > 1e-6 * plane(&row) {
                assert!(a.error < 1e-10 * a.value, "{a:?}: {row:?}");
            }
        }
    }
}

#[test]
fn grids_agree_within_their_own_spread() {
    for (scene, value, brute) in [
        (
            sphere_scene as Scene,
            sphere_light as fn(&[f64]) -> LightValue,
            sphere_light_brute as fn(&[f64], usize) -> f64,
        ),
        (polygon_scene, polygon_light, polygon_light_brute),
    ] {
        let (mut sharp, mut seen) = (0, 0);
        for row in scenes(scene, 2, 300) {
            let truth = value(&row).value;
            let sums = [211, 256, 307].map(|n| brute(&row, n));
            let (low, high) = (
                sums.iter().fold(1.0, |a, b| b.min(a)),
                sums.iter().fold(0.0, |a, b| b.max(a)),
            );
            let spread = high - low + 2e-4 * truth + 1e-16 * plane(&row);
            assert!((sums[2] - truth).abs() < 6.0 * spread, "{truth:e} {sums:?}: {row:?}");
            if truth > 1e-12 * plane(&row) {
                seen += 1;
                sharp += usize::from(spread < 4e-3 * truth);
            }
        }
        assert!(seen > 150 && sharp * 3 > seen * 2, "{sharp} of {seen}");
    }
}

#[test]
fn monte_carlo_agrees_within_its_standard_error() {
    type Estimator = fn(&[f64], usize, u64) -> MonteCarlo;
    for (scene, value, estimators) in [
        (
            sphere_scene as Scene,
            sphere_light as fn(&[f64]) -> LightValue,
            [sphere_light_monte_carlo as Estimator, sphere_light_importance],
        ),
        (
            polygon_scene,
            polygon_light,
            [polygon_light_monte_carlo, polygon_light_importance],
        ),
    ] {
        let mut useful = [0, 0];
        for (seed, row) in scenes(scene, 3, 300).iter().enumerate() {
            let truth = value(row).value;
            for (estimator, useful) in estimators.iter().zip(&mut useful) {
                let MonteCarlo { mean, standard_error } = estimator(row, 20_000, seed as u64);
                // With fewer hits the error itself is too uncertain, and far down its squares underflow.
                if standard_error < 0.05 * mean && mean > 1e-100 {
                    *useful += 1;
                    let apart = (mean - truth).abs();
                    assert!(
                        apart < 4.5 * standard_error,
                        "{truth:e} {mean:e} {standard_error:e}: {row:?}"
                    );
                }
            }
        }
        assert!(useful[0] > 120 && useful[1] > 120, "{useful:?}");
    }
}

#[test]
fn a_sphere_of_thirty_degrees_at_the_zenith_is_a_disc_of_half_the_radius() {
    for view in [[0.1, 0.2], [-0.3, 0.0], [0.5, -0.1], [0.52, 0.3]] {
        let row = [20.0, 0.55, 8.0, view[0], view[1], 0.0, 0.0, 2.0, 1.0];
        let scratch = Scratch::new(&row).unwrap();
        // x = sin(alpha)/2.
        let f = |alpha: f64| {
            let (sine, cosine) = alpha.sin_cos();
            let half = 0.5 * cosine;
            let weight = gaussian(&scratch, 0.5 * sine) * half;
            if weight == 0.0 {
                0.0
            } else {
                weight * chord(&scratch, [-half, half])
            }
        };
        let truth = gauss(f, [-0.5 * PI, 0.5 * PI], 3000);
        let result = sphere_light(&row);
        assert!(
            (result.value - truth).abs() < 1e-12 * truth,
            "{view:?}: {result:?} {truth:e}"
        );
    }
}

#[test]
fn spheres_agree_with_an_integral_along_their_outline_far_down_the_gaussian() {
    let (mut seen, mut small) = (0, 0);
    for row in scenes(sphere_scene, 4, 200) {
        let cone = Cone::new(sphere_of(&row).0, row[8]).unwrap();
        let result = sphere_light(&row);
        if cone.axis[2].asin() > cone.angle && result.value > 1e-40 * plane(&row) {
            let truth = sphere_by_its_outline(&row);
            assert!(
                (result.value - truth).abs() < 1e-11 * truth,
                "{result:?} {truth:e}: {row:?}"
            );
            seen += 1;
            small += usize::from(truth < 1e-8 * plane(&row));
        }
    }
    assert!(seen > 70 && small > 10, "{seen} {small}");
}

#[test]
fn polygons_agree_with_an_integral_along_their_outline() {
    let mut seen = 0;
    for row in scenes(polygon_scene, 5, 50) {
        let result = polygon_light(&row);
        if lowest(&row) > 0.0 && result.value > 0.0 {
            let truth = polygon_by_its_outline(&row);
            let error = (result.value - truth).abs();
            assert!(
                error < 1e-13 * plane(&row) + 1e-12 * truth,
                "{result:?} {truth:e}: {row:?}"
            );
            seen += 1;
        }
    }
    assert!(seen > 20, "{seen}");
}

#[test]
fn edges_that_turn_back_in_x_agree_with_an_integral_along_the_outline() {
    let mut random = Random::new(9);
    for _ in 0..20 {
        let [right, back, front] = [0.2, 0.1, 0.1].map(|least| random.uniform(least, 2.0));
        // The band at the largest x of the right edge, (right, 0, 1) turned a little.
        let off = random.uniform(-0.01, 0.01);
        let mut row = vec![15.0, 0.5, 4.0, off - right / right.hypot(1.0), 0.1];
        let skew = random.uniform(-0.05, 0.05);
        row.extend([
            right,
            -back,
            1.0,
            right + skew,
            front,
            1.0,
            -0.5,
            front,
            1.0,
            -0.5,
            -back,
            1.0,
        ]);
        let (result, truth) = (polygon_light(&row), polygon_by_its_outline(&row));
        let error = (result.value - truth).abs();
        assert!(
            error < 1e-13 * plane(&row) + 1e-12 * truth,
            "{result:?} {truth:e}: {row:?}"
        );
    }
}

#[test]
fn a_sphere_with_its_centre_on_the_horizon_is_a_segment_of_the_disc() {
    for (turn, angle, off) in [
        (0.3f64, 0.2f64, 0.02),
        (1.2, 0.5, -0.1),
        (2.9, 0.4, 0.0),
        (0.1, 1.0, 0.3),
    ] {
        let (sine, cosine) = turn.sin_cos();
        let mut row = vec![15.0, 0.5, 4.0, off - cosine, 0.1 - sine];
        row.extend([3.0 * cosine, 3.0 * sine, 0.0, 3.0 * angle.sin()]);
        let scratch = Scratch::new(&row).unwrap();
        // x = cos(psi), cut where the straight side meets the rim.
        let f = |psi: f64| {
            let (s, x) = psi.sin_cos();
            let side = (angle.cos() - x * cosine) / sine;
            let weight = gaussian(&scratch, x) * s;
            if weight == 0.0 || side > s {
                0.0
            } else {
                weight * chord(&scratch, [side.max(-s), s])
            }
        };
        let mut cuts = [0.0, (turn - angle).abs(), turn, (turn + angle).min(PI), PI];
        cuts.sort_by(f64::total_cmp);
        let truth: f64 = cuts.windows(2).map(|cut| gauss(f, [cut[0], cut[1]], 2000)).sum();
        let result = sphere_light(&row);
        assert!(
            (result.value - truth).abs() < 1e-11 * truth,
            "{turn} {angle}: {result:?} {truth:e}"
        );
    }
}

#[test]
fn wide_spheres_about_the_end_of_the_scratch_agree_with_grids() {
    let mut random = Random::new(10);
    for _ in 0..25 {
        let side = random.signed(1.0);
        let mut row = vec![
            12.0,
            0.7,
            3.0,
            -side * random.uniform(0.8, 1.0),
            random.uniform(-0.2, 0.2),
        ];
        let toward = [side, random.uniform(-0.4, 0.4), random.uniform(-0.7, 0.2)];
        row.extend(toward.map(|x| 2.0 * x));
        row.push(2.0 * length(toward) * random.uniform(0.3, 1.2f64).sin());
        let (result, sum) = (sphere_light(&row).value, sphere_light_brute(&row, 800));
        assert!(
            (result - sum).abs() < 1e-2 * sum + 1e-6 * plane(&row),
            "{result:e} {sum:e}: {row:?}"
        );
    }
}

#[test]
fn octants_are_quarters_of_the_disc_and_keep_their_digits_beside_the_band() {
    for (view, signs) in [
        ([0.02, 0.3], [1.0, 1.0]),
        ([0.004, 0.1], [-1.0, 1.0]),
        ([-0.2, 0.4], [1.0, -1.0]),
    ] {
        let mut row = vec![20.0, 0.55, 8.0, view[0], view[1]];
        row.extend([signs[0], 0.0, 0.0, 0.0, signs[1], 0.0, 0.0, 0.0, 1.0]);
        let scratch = Scratch::new(&row).unwrap();
        let f = |alpha: f64| {
            let (sine, cosine) = alpha.sin_cos();
            let weight = gaussian(&scratch, signs[0] * sine) * cosine;
            if weight == 0.0 {
                0.0
            } else {
                weight * chord(&scratch, [0.0, signs[1] * cosine]) * signs[1]
            }
        };
        let truth = gauss(f, [0.0, 0.5 * PI], 4000);
        let result = polygon_light(&row);
        assert!(
            (result.value - truth).abs() < 1e-12 * truth,
            "{view:?}: {result:?} {truth:e}"
        );
    }
}

#[test]
fn parts_cut_along_a_diagonal_add_up() {
    let mut cut = 0;
    for row in scenes(polygon_scene, 6, 200) {
        let vertices = vertices_of(&row);
        let n = vertices.len();
        let convex = (0..n).all(|i| {
            let at = |k: usize| vertices[(i + k) % n];
            let turn = cross(add_scaled(at(1), -1.0, at(0)), add_scaled(at(2), -1.0, at(1)));
            dot(turn, super::polygon::normal(&vertices)) > 0.0
        });
        if n == 3 || !convex {
            continue;
        }
        let some = |vertices: &[Vector]| {
            let mut part = row[..5].to_vec();
            part.extend(vertices.iter().flatten());
            polygon_light(&part)
        };
        let k = 2 + cut % (n - 3);
        let mut rest = vertices[k..].to_vec();
        rest.push(vertices[0]);
        let (one, two, whole) = (some(&vertices[..=k]), some(&rest), polygon_light(&row));
        let sum = LightValue {
            value: one.value + two.value,
            error: one.error + two.error,
        };
        assert_agree(sum, whole, &row);
        cut += 1;
    }
    assert!(cut > 50, "{cut}");
}

#[test]
fn neither_first_vertex_nor_orientation_nor_mirrors_matter() {
    for row in scenes(polygon_scene, 7, 200) {
        let whole = polygon_light(&row);
        let mut vertices = vertices_of(&row);
        let turned = |vertices: &[Vector], [x, y]: [f64; 2]| {
            let mut other = row[..5].to_vec();
            other[3] *= x;
            other[4] *= y;
            other.extend(vertices.iter().flat_map(|v| [v[0] * x, v[1] * y, v[2]]));
            polygon_light(&other)
        };
        assert_agree(turned(&vertices, [-1.0, 1.0]), whole, &row);
        assert_agree(turned(&vertices, [1.0, -1.0]), whole, &row);
        let first = 1 + vertices.len() / 3;
        vertices.rotate_left(first);
        assert_agree(turned(&vertices, [1.0, 1.0]), whole, &row);
        vertices.reverse();
        assert_agree(turned(&vertices, [1.0, 1.0]), whole, &row);
    }
    for row in scenes(sphere_scene, 7, 200) {
        let mirrored = |k: usize| {
            let mut other = row.clone();
            other[3 + k] *= -1.0;
            other[5 + k] *= -1.0;
            sphere_light(&other)
        };
        assert_agree(mirrored(0), sphere_light(&row), &row);
        assert_agree(mirrored(1), sphere_light(&row), &row);
    }
}

#[test]
fn a_small_light_is_its_projected_area_times_the_integrand() {
    let mut random = Random::new(8);
    for _ in 0..50 {
        let (mut row, toward) = scratch_and_direction(&mut random);
        if toward[2] < 0.1 {
            continue;
        }
        row[3] = 0.002 - toward[0];
        let middle = toward.map(|x| 3.0 * x);
        let [right, up] = frame(toward);
        let size = 3e-8;
        let corners = [
            add_scaled(middle, size, right),
            add_scaled(add_scaled(middle, -size, right), -size, up),
            add_scaled(middle, size, up),
        ];
        row.extend(corners.iter().flatten());
        let exact = vertices_of(&row);
        let centroid = exact.iter().fold([0.0; 3], |sum, &v| add_scaled(sum, 1.0 / 3.0, v));
        let distance = length(centroid);
        // Half the triple product is the area as seen, times the distance; another z of the projection.
        let sides = [1, 2].map(|k| add_scaled(exact[k], -1.0, exact[0]));
        let seen = 0.5 * dot(cross(sides[0], sides[1]), centroid).abs() / distance.powi(3);
        let scratch = Scratch::new(&row).unwrap();
        let omega = centroid.map(|x| x / distance);
        let expected = seen * omega[2] * scratch.integrand([omega[0], omega[1]]);
        let result = polygon_light(&row);
        assert!(
            (result.value - expected).abs() < 1e-9 * expected,
            "{result:?} {expected:e}: {row:?}"
        );
    }
}

#[test]
fn outside_the_domain_there_is_no_value_and_below_the_horizon_no_light() {
    let sphere = [20.0, 0.55, 8.0, 0.1, 0.2, 0.3, 0.1, 1.0, 0.2];
    let polygon = [20.0, 0.55, 8.0, 0.1, 0.2, 0.0, 0.0, 1.0, 1.0, 0.0, 1.0, 0.0, 1.0, 1.0];
    for k in 0..3 {
        for bad in [0.0, -1.0, f64::NAN, f64::INFINITY] {
            let spoilt = |row: &[f64]| {
                let mut row = row.to_vec();
                row[k] = bad;
                row
            };
            assert!(sphere_light(&spoilt(&sphere)).value.is_nan());
            assert!(polygon_light(&spoilt(&polygon)).value.is_nan());
        }
    }
    let mut around = sphere;
    around[8] = 1.2;
    assert!(sphere_light(&around).error.is_nan());
    let mut below = sphere;
    below[7] = -1.0;
    assert_eq!(sphere_light(&below), LightValue { value: 0.0, error: 0.0 });
    let mut below = polygon;
    for k in [7, 10, 13] {
        below[k] = -1.0;
    }
    assert_eq!(polygon_light(&below), LightValue { value: 0.0, error: 0.0 });
}
