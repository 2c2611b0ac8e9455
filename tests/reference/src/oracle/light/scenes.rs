//! Random rows of lights for the tests: most of them overlap the band of the view, some pass the horizon.

use super::Scratch;
use super::vectors::{Vector, add_scaled, cross, direction, frame};
use crate::generate::random::Random;
use std::f64::consts::{PI, TAU};

/// The integral over the whole plane.
pub fn plane(row: &[f64]) -> f64 {
    let scratch = Scratch::new(row).unwrap();
    PI.sqrt() / scratch.beta * PI / scratch.half_wave
}

/// Scratch, view, and a direction to a light near the band of the view; some directions are below the horizon.
pub fn scratch_and_direction(random: &mut Random) -> (Vec<f64>, Vector) {
    let (radius, turn) = (random.uniform(0.0, 1.0).sqrt(), random.uniform(0.0, TAU));
    let (x, y) = (radius * turn.cos(), radius * turn.sin());
    let row = vec![
        random.log_uniform(10.0, 60.0),
        random.uniform(0.36, 0.83),
        random.log_uniform(0.5, 20.0),
        x,
        y,
    ];
    let beta = Scratch::new(&row).unwrap().beta;
    let off = random.pick(&[0.0, 1.0, 3.0, 6.0]) / beta + random.pick(&[0.0, 0.0, 0.3]);
    let x = (random.uniform(-off, off) - x).clamp(-0.999, 0.999);
    let rest = (1.0 - x * x).sqrt();
    let rise = if random.chance(0.2) {
        random.uniform(-0.2, 0.2)
    } else {
        random.uniform(0.0, PI)
    };
    (row, [x, rest * rise.cos(), rest * rise.sin()])
}

/// A row of a sphere, 0.03 to 60 degrees in radius.
pub fn sphere_scene(random: &mut Random) -> Vec<f64> {
    let (mut row, toward) = scratch_and_direction(random);
    let distance = random.log_uniform(0.5, 20.0);
    let angle = random.log_uniform(0.03, 60.0).to_radians();
    row.extend(toward.map(|x| distance * x));
    row.push(distance * angle.sin());
    row
}

/// Star-shaped about its middle, so simple; sometimes thin, sometimes edge-on.
pub fn polygon_scene(random: &mut Random) -> Vec<f64> {
    let (mut row, toward) = scratch_and_direction(random);
    let distance = random.log_uniform(0.5, 20.0);
    let size = distance * random.log_uniform(0.01, 75.0).to_radians().tan();
    let thinness = if random.chance(0.2) {
        random.log_uniform(1e-4, 1.0)
    } else {
        1.0
    };
    let tilt = random.uniform(0.0, 1.2);
    let [right, up] = frame(toward);
    let normal = direction(add_scaled(toward, tilt, right)).unwrap();
    let first = direction(cross(normal, up)).unwrap();
    let turn = random.uniform(0.0, TAU);
    let second = cross(normal, first);
    let axes = [
        add_scaled(first.map(|x| x * turn.cos()), turn.sin(), second),
        add_scaled(first.map(|x| -x * turn.sin()), turn.cos(), second),
    ];
    let count = random.integer(3, 12);
    let concave = random.chance(0.5);
    for k in 0..count {
        let angle = TAU * (k as f64 + random.uniform(0.0, 0.8)) / count as f64;
        let radius = size * if concave { random.uniform(0.2, 1.0) } else { 1.0 };
        let middle = toward.map(|x| distance * x);
        let across = add_scaled(middle, radius * angle.cos(), axes[0]);
        row.extend(add_scaled(across, radius * thinness * angle.sin(), axes[1]));
    }
    row
}

/// A generator of rows.
pub type Scene = fn(&mut Random) -> Vec<f64>;

/// Rows that depend on nothing but the seed.
pub fn scenes(scene: Scene, seed: u64, count: usize) -> Vec<Vec<f64>> {
    let mut random = Random::new(seed);
    (0..count).map(|_| scene(&mut random)).collect()
}
