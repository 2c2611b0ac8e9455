//! The f32 area lights: their distance from the f64 ones, one chord where one is enough, forms that are the same, and
//! lights that are not there.
#![cfg(feature = "shader")]

use iridescence::diffraction::Coherence;
use iridescence::light::{ScratchLobe, Sphere, polygon_light, polygon_light_chords, sphere_light, sphere_light_chords};
use iridescence::shader;
use reference::generate::lights;
use reference::generate::random::Random;

/// Largest error of the f32 forms in some thousand scenes, relative to the value or to a thousandth of the whole plane, and
/// its median.
const LARGEST: f64 = 2e-2;
const MEDIAN: f64 = 3e-5;
/// The error that one scene in a thousand has.
const RARE: f64 = 2e-3;
/// The largest error in a million scenes of each kind: of needles and corners whose long arcs cancel.
const LARGEST_OF_MANY: f64 = 1e-1;
/// The same as a share of the whole plane.
const PLANE: f32 = 3e-5;
/// Error of a chord that 1 % of the scenes have.
const CHORD: f64 = 1e-4;

fn lobe_of(row: &[f32]) -> ScratchLobe {
    ScratchLobe {
        coherence: Coherence {
            radius: row[0].into(),
            wavelength: row[1].into(),
        },
        width: row[2].into(),
        view: [row[3].into(), row[4].into()],
    }
}

fn sphere_of(row: &[f32]) -> Sphere {
    Sphere {
        centre: [row[5].into(), row[6].into(), row[7].into()],
        radius: row[8].into(),
    }
}

fn vertices_of(row: &[f32]) -> Vec<[f64; 3]> {
    let vertices = row[5..].chunks_exact(3);
    vertices.map(|v| [v[0].into(), v[1].into(), v[2].into()]).collect()
}

fn single(row: &[f64]) -> Vec<f32> {
    row.iter().map(|&x| x as f32).collect()
}

/// Calls an f32 function of nine numbers.
fn of_sphere(f: fn(f32, f32, f32, f32, f32, f32, f32, f32, f32) -> f32, row: &[f32]) -> f32 {
    let &[a, b, c, d, e, x, y, z, r] = row else {
        panic!("{row:?}")
    };
    f(a, b, c, d, e, x, y, z, r)
}

/// Calls the f32 function of as many vertices.
macro_rules! call {
    ($function:path, $row:expr, [$($index:literal)*]) => { $function($($row[$index]),*) };
}

fn triangle(row: &[f32]) -> f32 {
    call!(shader::triangle_light, row, [0 1 2 3 4 5 6 7 8 9 10 11 12 13])
}

fn triangle_chord(row: &[f32]) -> f32 {
    call!(shader::triangle_light_chord, row, [0 1 2 3 4 5 6 7 8 9 10 11 12 13])
}

fn quad(row: &[f32]) -> f32 {
    call!(shader::quad_light, row, [0 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16])
}

fn quad_chord(row: &[f32]) -> f32 {
    call!(shader::quad_light_chord, row, [0 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16])
}

/// The row with the count of vertices in front of them and these numbers for those that are not read.
fn counted(row: &[f32], rest: f32) -> Vec<f32> {
    let mut counted = row[..5].to_vec();
    counted.push(((row.len() - 5) / 3) as f32);
    counted.extend(&row[5..]);
    counted.resize(30, rest);
    counted
}

fn polygon_with(row: &[f32], rest: f32) -> f32 {
    let row = counted(row, rest);
    call!(shader::polygon_light, row, [0 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17 18 19 20 21 22 23 24 25 26 27 28 29])
}

fn polygon_chord_with(row: &[f32], rest: f32) -> f32 {
    let row = counted(row, rest);
    call!(shader::polygon_light_chord, row, [0 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17 18 19 20 21 22 23 24 25 26 27 28 29])
}

fn polygon(row: &[f32]) -> f32 {
    polygon_with(row, f32::NAN)
}

fn polygon_chord(row: &[f32]) -> f32 {
    polygon_chord_with(row, f32::NAN)
}

/// A kind of light with its f32 forms.
struct Kind {
    name: &'static str,
    row: fn(&mut Random) -> Vec<f64>,
    value: fn(&[f32]) -> f32,
    chord: fn(&[f32]) -> f32,
}

const KINDS: [Kind; 4] = [
    Kind {
        name: "sphere",
        row: |random| lights::sphere(random).to_vec(),
        value: |row| of_sphere(shader::sphere_light, row),
        chord: |row| of_sphere(shader::sphere_light_chord, row),
    },
    Kind {
        name: "triangle",
        row: |random| lights::polygon(random, 3),
        value: triangle,
        chord: triangle_chord,
    },
    Kind {
        name: "quadrilateral",
        row: |random| lights::polygon(random, 4),
        value: quad,
        chord: quad_chord,
    },
    Kind {
        name: "polygon",
        row: |random| {
            let count = random.integer(3, 8) as usize;
            lights::polygon(random, count)
        },
        value: polygon,
        chord: polygon_chord,
    },
];

impl Kind {
    fn exact(&self, row: &[f32]) -> f64 {
        if self.name == "sphere" {
            sphere_light(lobe_of(row), sphere_of(row))
        } else {
            polygon_light(lobe_of(row), &vertices_of(row))
        }
    }

    fn exact_chord(&self, row: &[f32]) -> f64 {
        if self.name == "sphere" {
            sphere_light_chords(lobe_of(row), sphere_of(row), 1)
        } else {
            polygon_light_chords(lobe_of(row), &vertices_of(row), 1)
        }
    }
}

/// The numbers of a list at these shares of it.
fn quantiles<const N: usize>(mut list: Vec<f64>, shares: [f64; N]) -> [f64; N] {
    list.sort_by(f64::total_cmp);
    shares.map(|share| list[((list.len() - 1) as f64 * share) as usize])
}

fn near_the_f64_values(seed: u64, count: usize, most: f64) {
    for kind in KINDS {
        let mut random = Random::new(seed);
        let (mut errors, mut worst) = (Vec::new(), (0.0, Vec::new()));
        let mut chords = Vec::new();
        for _ in 0..count {
            let mut row = single(&(kind.row)(&mut random));
            // A view at the very horizon may round beyond it.
            row[3..5].iter_mut().for_each(|x| *x *= 1.0 - 1e-6);
            let plane = lobe_of(&row).whole_plane();
            let (value, truth) = (f64::from((kind.value)(&row)), kind.exact(&row));
            let error = (value - truth).abs() / truth.max(1e-3 * plane);
            assert!(
                value >= 0.0 && error.is_finite(),
                "{} {value:e} {truth:e} {row:?}",
                kind.name
            );
            if error > worst.0 {
                worst = (error, row.clone());
            }
            errors.push(error);
            let (chord, due) = (f64::from((kind.chord)(&row)), kind.exact_chord(&row));
            assert!(
                chord >= 0.0 && chord.is_finite(),
                "{} {chord:e} {due:e} {row:?}",
                kind.name
            );
            if truth > 1e-3 * plane && (due / truth - 1.0).abs() < 0.1 {
                chords.push((chord / due - 1.0).abs());
            }
        }
        let used = chords.len();
        let [median, rare, largest] = quantiles(errors, [0.5, 0.999, 1.0]);
        let [middle, seldom, farthest] = quantiles(chords, [0.5, 0.99, 1.0]);
        println!(
            "{}: median {median:.1e}, p99.9 {rare:.1e}, largest {largest:.1e}; chord of {used}: median {middle:.1e}, \
             p99 {seldom:.1e}, largest {farthest:.1e}; worst {:?}",
            kind.name, worst.1
        );
        assert!(used > count / 30, "{used} of {count}");
        assert!(rare <= RARE, "{}: {rare:e}", kind.name);
        assert!(median <= MEDIAN, "{}: {median:e}", kind.name);
        assert!(largest <= most, "{}: {largest:e} {:?}", kind.name, worst.1);
        assert!(seldom <= CHORD, "{}: {seldom:e}", kind.name);
    }
}

#[test]
fn f32_lights_are_near_the_f64_ones() {
    near_the_f64_values(701, 6_000, LARGEST);
}

#[test]
#[ignore = "1.2e6 scenes: in release only"]
fn a_million_f32_lights_are_near_the_f64_ones() {
    near_the_f64_values(702, 300_000, LARGEST_OF_MANY);
}

#[test]
fn a_polygon_of_three_or_four_vertices_is_the_triangle_or_the_quadrilateral() {
    let mut random = Random::new(703);
    for _ in 0..20_000 {
        let row = single(&lights::polygon(&mut random, 3));
        // Phi counts from another place: its roundings are of the size of the plane.
        let near = |a: f32, b: f32, row: &[f32]| (a - b).abs() <= 1e-3 * b + PLANE * lobe_of(row).whole_plane() as f32;
        for rest in [0.0, f32::NAN] {
            assert!(near(polygon_with(&row, rest), triangle(&row), &row), "{row:?}");
            assert_eq!(polygon_chord_with(&row, rest), triangle_chord(&row), "{row:?}");
        }
        let row = single(&lights::polygon(&mut random, 4));
        for rest in [0.0, f32::NAN] {
            assert!(near(polygon_with(&row, rest), quad(&row), &row), "{row:?}");
            assert_eq!(polygon_chord_with(&row, rest), quad_chord(&row), "{row:?}");
        }
    }
}

#[test]
fn either_way_round_and_any_first_vertex_is_the_same_light() {
    let mut random = Random::new(704);
    for _ in 0..5_000 {
        let count = random.integer(3, 8) as usize;
        let row = single(&lights::polygon(&mut random, count));
        let floor = PLANE * lobe_of(&row).whole_plane() as f32;
        let mut vertices: Vec<[f32; 3]> = row[5..].chunks_exact(3).map(|v| [v[0], v[1], v[2]]).collect();
        for turn in 0..2 {
            if turn == 0 {
                vertices.rotate_left(1)
            } else {
                vertices.reverse()
            }
            let other: Vec<f32> = row[..5].iter().chain(vertices.iter().flatten()).copied().collect();
            let (a, b) = (polygon(&row), polygon(&other));
            assert!((a - b).abs() <= 1e-3 * b + floor, "{a:e} {b:e} {row:?}");
            let (a, b) = (polygon_chord(&row), polygon_chord(&other));
            assert!((a - b).abs() <= 1e-3 * b + floor, "{a:e} {b:e} {row:?}");
        }
    }
}

#[test]
fn a_light_far_off_the_line_is_exactly_nothing() {
    let mut random = Random::new(705);
    for _ in 0..100_000 {
        // Thin, of any direction, on one side of the line.
        let count = random.integer(3, 8) as usize;
        let side = random.signed(1.0);
        let mut row = vec![30.0f32, 0.55, 2.5, 0.0, 0.1];
        let (along, thin) = (random.uniform(-2.0, 2.0), random.log_uniform(1e-7, 1e-2));
        for _ in 0..count {
            let step = random.uniform(-1.0, 1.0);
            row.push((side * random.uniform(0.6, 0.6 + thin)) as f32);
            row.push((along * step + thin * random.uniform(-1.0, 1.0)) as f32);
            row.push((0.3 + 0.5 * step + thin * random.uniform(-1.0, 1.0)) as f32);
        }
        assert_eq!(polygon(&row), 0.0, "{row:?}");
        assert_eq!(polygon_chord(&row), 0.0, "{row:?}");
        if count == 3 {
            assert_eq!([triangle(&row), triangle_chord(&row)], [0.0; 2], "{row:?}");
        }
        if count == 4 {
            assert_eq!([quad(&row), quad_chord(&row)], [0.0; 2], "{row:?}");
        }
        let far = [30.0, 0.55, 2.5, 0.0, 0.1, row[5], row[6], row[7].abs(), 0.2];
        assert_eq!(of_sphere(shader::sphere_light, &far), 0.0);
        assert_eq!(of_sphere(shader::sphere_light_chord, &far), 0.0);
    }
}

#[test]
fn what_is_below_the_horizon_is_exactly_nothing() {
    let mut random = Random::new(706);
    for _ in 0..20_000 {
        let count = random.integer(3, 8) as usize;
        let mut row = single(&lights::polygon(&mut random, count));
        for z in row[5..].iter_mut().skip(2).step_by(3) {
            *z = -z.abs() - 1e-6;
        }
        assert_eq!([polygon(&row), polygon_chord(&row)], [0.0; 2], "{row:?}");
        let mut row = single(&lights::sphere(&mut random));
        let distance = (row[5] * row[5] + row[6] * row[6] + row[7] * row[7]).sqrt();
        row[7] = -row[7].abs();
        row[8] = row[8].min(0.999 * row[7].abs()).max(1e-6 * distance);
        if row[8] < row[7].abs() {
            assert_eq!(of_sphere(shader::sphere_light, &row), 0.0, "{row:?}");
            assert_eq!(of_sphere(shader::sphere_light_chord, &row), 0.0, "{row:?}");
        }
    }
}

#[test]
fn a_vertex_on_the_horizon_and_the_next_just_below_it_add_nothing() {
    let mut random = Random::new(707);
    for _ in 0..100_000 {
        let mut row = single(&lights::polygon(&mut random, 3));
        (row[10], row[13]) = (0.0, -random.pick(&[1e-8, 1e-9, 1e-12, 1e-20]) as f32);
        row[7] = row[7].abs() + 0.01;
        let truth = polygon_light(lobe_of(&row), &vertices_of(&row));
        let plane = lobe_of(&row).whole_plane();
        let error = (f64::from(triangle(&row)) - truth).abs();
        assert!(
            error <= LARGEST * truth.max(1e-2 * plane),
            "{error:e} {truth:e} {row:?}"
        );
        // The chord may begin on either side of such a vertex, but is never longer than the lobe.
        assert!(f64::from(triangle_chord(&row)) <= 1.001 * plane, "{row:?}");
    }
}

#[test]
fn hostile_f32_lights_are_neither_negative_nor_nan_nor_brighter_than_the_lobe() {
    let mut random = Random::new(708);
    for _ in 0..200_000 {
        let view_t = random.pick(&[0.0, 0.5, -0.25, 0.96, 1.0, -1.0]);
        let view_b = random.pick(&[0.0, 0.28, -0.5, 1.0]) * f64::sqrt(1.0 - view_t * view_t);
        let mut row = single(&[
            random.log_uniform(5.0, 100.0),
            0.55,
            random.log_uniform(0.2, 20.0),
            view_t,
            view_b,
        ]);
        let most = 1.01 * lobe_of(&[row[0], row[1], row[2], 0.0, 0.0]).whole_plane();
        let grid = [-1.0f32, -0.5, -0.25, 0.0, 0.25, 0.5, 1.0];
        let mut sphere = row.clone();
        // Vertices and centres on a grid: on the line, on the horizon, coincident, collinear, edge on.
        for i in 0..12 {
            let mut x = random.pick(&grid);
            if i % 3 == 0 && random.chance(0.3) {
                x = -view_t as f32;
            }
            row.push(x);
        }
        let direct = row[5..].chunks_exact(3).all(|v| v.iter().any(|&x| x != 0.0));
        let half_space = row[5..].chunks_exact(3).all(|v| v[2] > 0.0);
        if direct {
            for value in [
                quad(&row),
                quad_chord(&row),
                polygon(&row),
                polygon_chord(&row),
                triangle(&row),
                triangle_chord(&row),
            ] {
                assert!(value >= 0.0 && value.is_finite(), "{value:e} {row:?}");
            }
            // A quadrilateral that crosses itself may count a part twice.
            assert!(!half_space || f64::from(triangle(&row)) <= most, "{row:?}");
            assert!(!half_space || f64::from(triangle_chord(&row)) <= most, "{row:?}");
        }
        sphere.extend(&row[5..8]);
        let distance = (row[5] * row[5] + row[6] * row[6] + row[7] * row[7]).sqrt();
        sphere.push(distance * random.pick(&[1e-6, 0.01, 0.25, 0.5, 0.6, 0.99, 0.999_999]));
        if distance > 0.0 {
            for value in [
                of_sphere(shader::sphere_light, &sphere),
                of_sphere(shader::sphere_light_chord, &sphere),
            ] {
                assert!(value >= 0.0 && f64::from(value) <= most, "{value:e} {sphere:?}");
            }
        }
    }
}
