//! Rows of the integrals over area lights. The columns are those of the oracles.

use super::random::Random;
use super::scratches::{kept, recorded, single};
use super::{Generator, fill};
use std::f64::consts::{PI, TAU};

/// sigma, lambda, width, wo_x, wo_y, px, py, pz, radius.
pub const SPHERE: Generator = Generator {
    name: "sphere_light",
    domain: "spheres of .03 to 60 degrees aimed at the band: over it, at its edge, beside it, at the horizon; sigma 10..60 um, lambda 0.38..0.78 um, width 0.5..10 um, any view",
    columns: 9,
    rows: |seed, n| fill(seed, n, 9, sphere_rows(false), |r, rows| rows.extend(sphere(r))),
};

/// The same at f32 values.
pub const SPHERE_F32: Generator = Generator {
    name: "sphere_light_f32",
    domain: "f32: spheres of .03 to 60 degrees aimed at the band: over it, at its edge, beside it, at the horizon; sigma 10..60 um, lambda 0.38..0.78 um, width 0.5..10 um, any view",
    columns: 9,
    rows: |seed, n| {
        fill(seed, n, 9, sphere_rows(true), |r, rows| {
            rows.extend(sphere(r).map(single));
        })
    },
};

/// sigma, lambda, width, wo_x, wo_y, four vertices.
pub const QUAD: Generator = Generator {
    name: "quad_light",
    domain: "quadrilaterals of .03 to 60 degrees, convex or not, at any slant, aimed at the band: over it, an edge or a vertex in it, beside it, at the horizon; scratches as of the spheres",
    columns: 17,
    rows: |seed, n| fill(seed, n, 17, quad_rows(false), |r, rows| rows.extend(quad(r))),
};

/// Without the fixed rows of the quadrilaterals: some have an edge on the line xi1 = 0, where a chord is either of two numbers.
pub const QUAD_CHORD: Generator = Generator {
    name: "quad_light_chord",
    domain: "random quadrilaterals of .03 to 60 degrees, convex or not, at any slant, aimed at the band; scratches as of the spheres",
    columns: 17,
    rows: |seed, n| fill(seed, n, 17, chord_rows(false), |r, rows| rows.extend(quad(r))),
};

/// The same at f32 values.
pub const QUAD_CHORD_F32: Generator = Generator {
    name: "quad_light_chord_f32",
    domain: "f32: random quadrilaterals of .03 to 60 degrees, convex or not, at any slant, aimed at the band; scratches as of the spheres",
    columns: 17,
    rows: |seed, n| {
        fill(seed, n, 17, chord_rows(true), |r, rows| {
            rows.extend(quad(r).map(single));
        })
    },
};

/// The same at f32 values.
pub const QUAD_F32: Generator = Generator {
    name: "quad_light_f32",
    domain: "f32: quadrilaterals of .03 to 60 degrees, convex or not, at any slant, aimed at the band: over it, an edge or a vertex in it, beside it, at the horizon; scratches as of the spheres",
    columns: 17,
    rows: |seed, n| {
        fill(seed, n, 17, quad_rows(true), |r, rows| {
            rows.extend(quad(r).map(single));
        })
    },
};

/// sigma, lambda, width, wo_x, wo_y.
fn scratch(random: &mut Random) -> [f64; 5] {
    let (size, angle) = (random.uniform(0.0, 1.0).sqrt(), random.uniform(0.0, TAU));
    [
        random.log_uniform(10.0, 60.0),
        random.uniform(0.38, 0.78),
        random.log_uniform(0.5, 10.0),
        size * angle.cos(),
        size * angle.sin(),
    ]
}

/// A direction towards a light of this size whose projection lies near the line xi1 = 0, a little below the horizon at
/// times.
fn aimed(random: &mut Random, [sigma, lambda, _, view, _]: [f64; 5], size: f64) -> [f64; 3] {
    let spread = 3.0 * lambda / (TAU * sigma) + size;
    loop {
        let x = spread.mul_add(random.uniform(-1.0, 1.0), -view);
        if x.abs() < 1.0 {
            let (rest, angle) = ((1.0 - x * x).sqrt(), random.uniform(-0.3, PI + 0.3));
            return [x, rest * angle.cos(), rest * angle.sin()];
        }
    }
}

/// A scratch and a sphere.
pub fn sphere(random: &mut Random) -> [f64; 9] {
    let scratch = scratch(random);
    let angle = random.log_uniform(0.03, 60.0).to_radians();
    let distance = random.log_uniform(0.1, 1000.0);
    let [x, y, z] = aimed(random, scratch, angle.sin()).map(|c| distance * c);
    let [sigma, lambda, width, view_t, view_b] = scratch;
    [sigma, lambda, width, view_t, view_b, x, y, z, distance * angle.sin()]
}

/// A scratch and a polygon of so many vertices: at any slant, a star one time in three.
pub fn polygon(random: &mut Random, count: usize) -> Vec<f64> {
    let scratch = scratch(random);
    let size = random.log_uniform(0.03, 60.0).to_radians().tan();
    let centre = aimed(random, scratch, size.min(0.9));
    let axes = [0; 2].map(|_| [0; 3].map(|_| random.uniform(-1.0, 1.0)));
    let distance = random.log_uniform(0.1, 1000.0);
    let star = random.chance(0.3);
    let mut row = scratch.to_vec();
    for i in 0..count {
        let angle = TAU * (i as f64 + 0.6 * random.uniform(0.0, 1.0)) / count as f64;
        let reach = size * if star { random.uniform(0.3, 1.0) } else { 1.0 };
        let (sine, cosine) = angle.sin_cos();
        row.extend((0..3).map(|k| distance * (centre[k] + reach * (axes[0][k] * cosine + axes[1][k] * sine))));
    }
    row
}

fn quad(random: &mut Random) -> [f64; 17] {
    let row = polygon(random, 4);
    std::array::from_fn(|i| row[i])
}

/// The recorded ones.
fn chord_rows(f32_only: bool) -> Vec<f64> {
    kept(recorded("quad_light_chord", f32_only), f32_only)
}

/// Spheres overhead, at the horizon, over the whole band, inside it, beside it, tangent to the line.
fn sphere_rows(f32_only: bool) -> Vec<f64> {
    let mut rows = recorded("sphere_light", f32_only);
    for view in [[0.0, 0.0], [0.5, 0.25], [-0.75, 0.5]] {
        for centre in [
            [-view[0], -view[1], 0.75],
            [-view[0], 0.5, 0.0],
            [-view[0], -0.5, -0.0625],
            [-view[0] + 0.0625, 0.25, 0.5],
            [0.0, 0.0, 1.0],
        ] {
            for radius in [1e-4, 0.0625, 0.25] {
                let [x, y, z] = centre;
                rows.push(vec![30.0, 0.5, 2.5, view[0], view[1], x, y, z, radius]);
            }
        }
    }
    kept(rows, f32_only)
}

/// Quadrilaterals overhead with an edge on the line, a vertex on it, edge on, thin, and down to the horizon.
fn quad_rows(f32_only: bool) -> Vec<f64> {
    let mut rows = recorded("polygon_light", f32_only);
    for [low, high] in [[0.0, 0.25], [-0.125, 0.25], [-0.001, 0.001], [0.03125, 0.25]] {
        for [left, right] in [[-0.25, 0.25], [0.25, 0.2501], [-2.0, -0.5]] {
            for height in [1.0, 0.25, 1e-4] {
                let flat = [[low, left], [high, left], [high, right], [low, right]].map(|[x, y]| [x, y, height]);
                let upright = [[low, -0.5], [high, -0.5], [high, height], [low, height]].map(|[x, z]| [x, right, z]);
                for corners in [flat, upright] {
                    let mut row = vec![30.0, 0.5, 2.5, 0.0, 0.125];
                    row.extend(corners.concat());
                    rows.push(row);
                }
            }
        }
    }
    kept(rows, f32_only)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn half_of_the_lights_reach_the_band_and_some_stand_at_the_horizon() {
        let rows = (SPHERE.rows)(1, 5000);
        let mut reached = 0;
        let mut setting = 0;
        for row in rows.chunks_exact(9) {
            let distance = row[5].hypot(row[6]).hypot(row[7]);
            reached += usize::from((row[5] / distance + row[3]).abs() < row[8] / distance);
            setting += usize::from(row[7].abs() < row[8]);
        }
        assert!(reached > 2000 && setting > 500, "{reached} {setting}");
        assert_eq!(polygon(&mut Random::new(1), 7).len(), 26);
    }
}
