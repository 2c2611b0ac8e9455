//! The same integrals from nothing but a test whether a direction belongs to the light: sums over a grid, and Monte
//! Carlo. They share no chord, no break point and no outline with the adaptive rule; of a polygon they know the plane.

use super::cone::Cone;
use super::polygon::{Enclosure, normal};
use super::vectors::{Vector, add_scaled, dot, even_odd, frame};
use super::{Scratch, sphere_of, vertices_of};
use crate::generate::random::Random;
use std::f64::consts::{PI, TAU};

/// Mean of random samples and its standard error.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MonteCarlo {
    /// Estimate of the integral.
    pub mean: f64,
    /// Its standard error, from the spread of the samples.
    pub standard_error: f64,
}

/// A light as something to ask, within a circular cone.
struct Target {
    axis: Vector,
    /// 1 - cos of the cone's angle.
    height: f64,
    belongs: Box<dyn Fn(Vector) -> bool>,
}

impl Target {
    fn sphere(row: &[f64]) -> Option<Target> {
        let (centre, radius) = sphere_of(row);
        let cone = Cone::new(centre, radius)?;
        let (axis, cosine) = (cone.axis, cone.angle.cos());
        Some(Target {
            axis,
            height: 2.0 * (0.5 * cone.angle).sin().powi(2),
            belongs: Box::new(move |omega| dot(omega, axis) >= cosine),
        })
    }

    fn polygon(row: &[f64]) -> Option<Target> {
        let vertices = vertices_of(row);
        let Enclosure { axis, cosine } = Enclosure::new(&vertices)?;
        // The plane through the mean of the vertices, without the coordinate along which it is steepest.
        let normal = normal(&vertices);
        let count = vertices.len() as f64;
        let level = vertices.iter().map(|&v| dot(v, normal)).sum::<f64>() / count;
        let dropped = (0..3).fold(0, |k, j| if normal[j].abs() > normal[k].abs() { j } else { k });
        let flat = move |v: Vector| [v[(dropped + 1) % 3], v[(dropped + 2) % 3]];
        let outline: Vec<[f64; 2]> = vertices.iter().map(|&v| flat(v)).collect();
        Some(Target {
            axis,
            height: (1.0 - cosine) * (1.0 + 1e-9) + 1e-15,
            belongs: Box::new(move |omega| {
                let distance = level / dot(omega, normal);
                distance > 0.0 && distance.is_finite() && even_odd(&outline, flat(omega.map(|x| distance * x)))
            }),
        })
    }

    /// Least and largest of a coordinate among the directions: within twice the sine of half the cone's angle.
    fn bounds(&self, coordinate: usize) -> [f64; 2] {
        let reach = (2.0 * self.height).sqrt();
        let centre = self.axis[coordinate];
        [(centre - reach).max(-1.0), (centre + reach).min(1.0)]
    }

    /// The integrand at a projected direction, 0 outside the light.
    fn at(&self, scratch: &Scratch, [x, y]: [f64; 2]) -> f64 {
        let rest = 1.0 - x * x - y * y;
        if rest >= 0.0 && (self.belongs)([x, y, rest.sqrt()]) {
            scratch.integrand([x, y])
        } else {
            0.0
        }
    }

    fn grid(&self, scratch: &Scratch, n: usize) -> f64 {
        let band = 6.0 / scratch.beta;
        let [left, right] = self.bounds(0);
        let (left, right) = (left.max(-scratch.view[0] - band), right.min(-scratch.view[0] + band));
        let [low, high] = self.bounds(1);
        if left >= right {
            return 0.0;
        }
        let (dx, dy) = ((right - left) / n as f64, (high - low) / n as f64);
        let column = |i: usize| {
            let x = left + (i as f64 + 0.5) * dx;
            (0..n)
                .map(|j| self.at(scratch, [x, low + (j as f64 + 0.5) * dy]))
                .sum::<f64>()
        };
        dx * dy * (0..n).map(column).sum::<f64>()
    }

    /// Directions uniform in the cone; dx dy is z times the solid angle.
    fn uniform(&self, scratch: &Scratch, random: &mut Random) -> f64 {
        let down = self.height * random.uniform(0.0, 1.0);
        let (sine, cosine) = (TAU * random.uniform(0.0, 1.0)).sin_cos();
        let radius = (down * (2.0 - down)).sqrt();
        let [right, up] = frame(self.axis);
        let along = self.axis.map(|x| x * (1.0 - down));
        let omega = add_scaled(add_scaled(along, radius * cosine, right), radius * sine, up);
        if omega[2] < 0.0 || !(self.belongs)(omega) {
            return 0.0;
        }
        TAU * self.height * omega[2] * scratch.integrand([omega[0], omega[1]])
    }

    /// x from the Gaussian, y uniform between the light's bounds.
    fn important(&self, scratch: &Scratch, random: &mut Random) -> f64 {
        // Box and Muller 1958; the second number is left.
        let radius = (-2.0 * (1.0 - random.uniform(0.0, 1.0)).ln()).sqrt();
        let normal = radius * (TAU * random.uniform(0.0, 1.0)).cos();
        let t = normal * std::f64::consts::FRAC_1_SQRT_2;
        let [low, high] = self.bounds(1);
        let x = t / scratch.beta - scratch.view[0];
        let y = random.uniform(low, high);
        // The Gaussian is in the density; at the chosen t it is never 0.
        PI.sqrt() / scratch.beta * (high - low) * self.at(scratch, [x, y]) * (t * t).exp()
    }

    fn mean(samples: usize, mut sample: impl FnMut() -> f64) -> MonteCarlo {
        let (mut mean, mut squares) = (0.0, 0.0);
        for n in 0..samples {
            // Running mean and sum of squares about it (Welford 1962).
            let value = sample();
            let apart = value - mean;
            mean += apart / (n + 1) as f64;
            squares += apart * (value - mean);
        }
        let n = samples as f64;
        MonteCarlo {
            mean,
            standard_error: (squares / (n * (n - 1.0))).sqrt(),
        }
    }
}

const NOTHING: MonteCarlo = MonteCarlo {
    mean: f64::NAN,
    standard_error: f64::NAN,
};

fn brute(row: &[f64], target: Option<Target>, n: usize) -> f64 {
    match (Scratch::new(row), target) {
        (Some(scratch), Some(target)) => target.grid(&scratch, n),
        _ => f64::NAN,
    }
}

type Sample = fn(&Target, &Scratch, &mut Random) -> f64;

fn monte_carlo(row: &[f64], target: Option<Target>, samples: usize, seed: u64, sample: Sample) -> MonteCarlo {
    match (Scratch::new(row), target) {
        (Some(scratch), Some(target)) => {
            let mut random = Random::new(seed);
            Target::mean(samples, || sample(&target, &scratch, &mut random))
        }
        _ => NOTHING,
    }
}

/// The midpoint sum for a row of [`sphere_light`](super::sphere_light) over `n` by `n` points of the square in x and y
/// that can hold the light, within |t| <= 6.
pub fn sphere_light_brute(row: &[f64], n: usize) -> f64 {
    brute(row, Target::sphere(row), n)
}

/// The midpoint sum for a row of [`polygon_light`](super::polygon_light), as [`sphere_light_brute`].
pub fn polygon_light_brute(row: &[f64], n: usize) -> f64 {
    brute(row, Target::polygon(row), n)
}

/// Mean over directions uniform in the cone of a sphere, for a row of [`sphere_light`](super::sphere_light).
pub fn sphere_light_monte_carlo(row: &[f64], samples: usize, seed: u64) -> MonteCarlo {
    monte_carlo(row, Target::sphere(row), samples, seed, Target::uniform)
}

/// Mean over directions uniform in a cone about a polygon, 0 where they miss it, for a row of
/// [`polygon_light`](super::polygon_light).
pub fn polygon_light_monte_carlo(row: &[f64], samples: usize, seed: u64) -> MonteCarlo {
    monte_carlo(row, Target::polygon(row), samples, seed, Target::uniform)
}

/// Mean over x drawn from the Gaussian and y uniform between bounds of the light, 0 where they miss it, for a row of
/// [`sphere_light`](super::sphere_light).
pub fn sphere_light_importance(row: &[f64], samples: usize, seed: u64) -> MonteCarlo {
    monte_carlo(row, Target::sphere(row), samples, seed, Target::important)
}

/// Mean over x drawn from the Gaussian and y uniform between bounds of the light, 0 where they miss it, for a row of
/// [`polygon_light`](super::polygon_light).
pub fn polygon_light_importance(row: &[f64], samples: usize, seed: u64) -> MonteCarlo {
    monte_carlo(row, Target::polygon(row), samples, seed, Target::important)
}
