//! Rows of the functions of one scratch: its spatial phase, its profiles, its energy. The columns are those of the oracles.

use super::random::{Random, neighbour, neighbour_f32};
use super::{Generator, fill, worst};
use std::f64::consts::PI;

pub use super::footprints::{FOOTPRINT, FOOTPRINT_REDUCED, FOOTPRINT_REDUCED_F32};

/// sigma, lambda, xi1, xi2, s_t, s_b, l1, l2.
pub const SPATIAL_PHASE: Generator = Generator {
    name: "spatial_phase",
    domain: "sigma 10, 60 or log-uniform in 1..100 um, lambda 0.38..0.78 um, |xi| <= 2, length log-uniform in 1e-3..1e6 um, one in five with an infinite end, the window over the segment, beside it or far away",
    columns: 8,
    rows: |seed, n| fill(seed, n, 8, phase_rows(false), |r, rows| rows.extend(phase(r))),
};

/// The same at f32 values.
pub const SPATIAL_PHASE_F32: Generator = Generator {
    name: "spatial_phase_f32",
    domain: "f32: sigma 10, 60 or log-uniform in 1..100 um, lambda 0.38..0.78 um, |xi| <= 2, length log-uniform in 1e-3..1e6 um, one in five with an infinite end, the window over the segment, beside it or far away",
    columns: 8,
    rows: |seed, n| {
        fill(seed, n, 8, phase_rows(true), |r, rows| {
            rows.extend(phase(r).map(single));
        })
    },
};

/// width, depth, xi2, gamma_sum, lambda.
pub const PROFILE: Generator = Generator {
    name: "profile",
    domain: "width log-uniform in 0.1..100 um, depth 0..20 um, |xi2| <= 2, gamma_sum 0..2, lambda 0.38..0.78 um",
    columns: 5,
    rows: |seed, n| fill(seed, n, 5, profile_rows(false), |r, rows| rows.extend(profile(r))),
};

/// The same at f32 values.
pub const PROFILE_F32: Generator = Generator {
    name: "profile_f32",
    domain: "f32: width log-uniform in 0.1..100 um, depth 0..20 um, |xi2| <= 2, gamma_sum 0..2, lambda 0.38..0.78 um",
    columns: 5,
    rows: |seed, n| {
        fill(seed, n, 5, profile_rows(true), |r, rows| {
            rows.extend(profile(r).map(single));
        })
    },
};

/// width, depth, xi2, gamma_sum, lambda.
pub const TRIANGLE_POLES: Generator = Generator {
    name: "triangle_poles",
    domain: "profiles at the poles xi2 = +-2 D gamma/W of WVJH17 (29) and within 1e-16..1e-2 of them",
    columns: 5,
    rows: |seed, n| fill(seed, n, 5, Vec::new(), |r, rows| rows.extend(pole(r))),
};

/// sigma, lambda, xi1, length.
pub const SEGMENT_ENERGY: Generator = Generator {
    name: "segment_energy",
    domain: "sigma 10, 60 or log-uniform in 1..100 um, lambda 0.38..0.78 um, |xi1| <= 2, length log-uniform in 1e-3..1e6 um",
    columns: 4,
    rows: |seed, n| fill(seed, n, 4, energy_rows(), |r, rows| rows.extend(energy(r))),
};

/// The nearest f32 number; infinities stay.
pub(super) fn single(x: f64) -> f64 {
    if x.is_infinite() { x } else { neighbour_f32(x, 0) }
}

/// The rows one after the other, at f32 values if `f32_only`.
pub(super) fn kept(rows: impl IntoIterator<Item = Vec<f64>>, f32_only: bool) -> Vec<f64> {
    let rows = rows.into_iter().map(|row| {
        if f32_only {
            row.into_iter().map(single).collect()
        } else {
            row
        }
    });
    rows.flatten().collect()
}

/// The worst rows of a function found so far, of f32 numbers if `f32_only`.
pub(super) fn recorded(function: &str, f32_only: bool) -> Vec<Vec<f64>> {
    let mut rows = worst::recorded_for(&[function]);
    rows.retain(|row| row.iter().all(|&x| !f32_only || f64::from(x as f32) == x));
    rows
}

pub(super) fn radius(random: &mut Random) -> f64 {
    let other = random.log_uniform(1.0, 100.0);
    random.pick(&[10.0, 60.0, other])
}

pub(super) fn wavelength(random: &mut Random) -> f64 {
    random.uniform(0.38, 0.78)
}

/// Half over the disc |xi| <= 2, the rest along the lobe: xi1 zero, or log-uniform down to 1e-9.
pub(super) fn direction(random: &mut Random) -> [f64; 2] {
    let (size, angle) = (2.0 * random.uniform(0.0, 1.0).sqrt(), random.uniform(0.0, 2.0 * PI));
    let xi2 = random.uniform(-2.0, 2.0);
    match random.integer(0, 7) {
        0 => [0.0, xi2],
        1..=3 => {
            let xi1 = random.log_uniform(1e-9, 2.0).min((4.0 - xi2 * xi2).sqrt());
            [random.signed(xi1), xi2]
        }
        _ => [size * angle.cos(), size * angle.sin()],
    }
}

pub(super) fn phase(random: &mut Random) -> [f64; 8] {
    let sigma = radius(random);
    let lambda = wavelength(random);
    let [xi1, xi2] = direction(random);
    let length = random.log_uniform(1e-3, 1e6);
    // Where the segment begins, seen from the window's centre.
    let start = match random.integer(0, 5) {
        0 => -0.5 * length,
        1 => random.uniform(-6.0, 6.0) * sigma,
        2 => random.uniform(-6.0, 6.0) * sigma - length,
        3 => {
            let far = random.log_uniform(1e-3, 1e6);
            random.signed(far)
        }
        _ => random.uniform(-3.0 * sigma - length, 3.0 * sigma),
    };
    // The origin of the segment lies anywhere along it.
    let l1 = match random.integer(0, 2) {
        0 => 0.0,
        1 => -0.5 * length,
        _ => random.uniform(-length, 0.0),
    };
    let s_t = start - l1;
    let s_b = match random.integer(0, 5) {
        0 => 0.0,
        1 => random.uniform(-40.0, 40.0) * sigma,
        2 => {
            let near = random.log_uniform(1e-6, 1.0) * sigma;
            random.signed(near)
        }
        _ => random.uniform(-5.0, 5.0) * sigma,
    };
    let (first, last) = match random.integer(0, 14) {
        0 => (f64::NEG_INFINITY, l1 + length),
        1 => (l1, f64::INFINITY),
        2 => (f64::NEG_INFINITY, f64::INFINITY),
        _ => (l1, l1 + length),
    };
    [sigma, lambda, xi1, xi2, s_t, s_b, first, last]
}

fn phase_rows(f32_only: bool) -> Vec<f64> {
    let inf = f64::INFINITY;
    let mut rows = recorded("spatial_phase", f32_only);
    for sigma in [10.0, 60.0] {
        for xi1 in [0.0, -0.0, 1e-30, 1e-4, 0.01, 0.3, 1.0, -1.9] {
            for [s_t, l1, l2] in [
                [0.0, -50.0, 50.0],
                [0.0, 0.0, 0.0],
                [0.0, 0.0, 1e-3],
                [5.0, -inf, inf],
                [0.0, 0.0, inf],
                [0.0, -inf, -3.0 * sigma],
                [1e6, -1e6 - sigma, -1e6 + sigma],
                [-8.0 * sigma, 0.0, 1.0],
                [0.0, 20.0, -20.0],
            ] {
                rows.push(vec![sigma, 0.55, xi1, 0.0, s_t, 0.0, l1, l2]);
                rows.push(vec![sigma, 0.55, xi1, 0.25, s_t, -1.5 * sigma, l1, l2]);
            }
        }
    }
    kept(rows, f32_only)
}

pub(super) fn profile(random: &mut Random) -> [f64; 5] {
    let width = random.log_uniform(0.1, 100.0);
    let small = random.log_uniform(1e-6, 20.0);
    let depths = [0.0, random.uniform(0.0, 2.0), random.uniform(0.0, 20.0), small];
    let depth = random.pick(&depths);
    let lambda = wavelength(random);
    let near = random.log_uniform(1e-8, 2.0);
    // A zero of the rectangle's transform, or beside it.
    let order = random.integer(1, 1 + (2.0 * width / lambda) as i64) as f64;
    let zero = (order * lambda / width).min(2.0) * (1.0 - random.log_uniform(1e-16, 1e-2));
    let across = [random.uniform(0.0, 2.0), random.uniform(0.0, 2.0), near, zero];
    let xi2 = random.pick(&across);
    let gamma_sum = random.uniform(0.0, 2.0);
    [width, depth, random.signed(xi2), gamma_sum, lambda]
}

fn profile_rows(f32_only: bool) -> Vec<f64> {
    let mut rows = recorded("profile_rectangle", f32_only);
    rows.extend(recorded("profile_triangle", f32_only));
    rows.extend(recorded("response_triangle", f32_only));
    for width in [0.0, 0.1, 6.0, 100.0] {
        for depth in [0.0, 1e-30, 0.275, 0.55, 20.0] {
            for xi2 in [0.0, -0.0, 1e-30, 0.55 / 6.0, 1.1 / 6.0, -2.0, 2.0] {
                rows.push(vec![width, depth, xi2, 0.0, 0.55]);
                rows.push(vec![width, depth, xi2, 2.0, 0.55]);
            }
        }
    }
    kept(rows, f32_only)
}

fn pole(random: &mut Random) -> [f64; 5] {
    let (width, lambda) = (random.log_uniform(0.1, 100.0), wavelength(random));
    let depth = random.log_uniform(1e-3, 20.0_f64.min(width));
    let gamma_sum = random.uniform(0.0, 2.0);
    let pole = 2.0 * depth * gamma_sum / width;
    let away = random.log_uniform(1e-16, 1e-2);
    let xi2 = match random.integer(0, 4) {
        0 => pole,
        1 => neighbour(pole, random.integer(-3, 3)),
        _ => pole * (1.0 + random.signed(away)),
    };
    [width, depth, random.signed(xi2), gamma_sum, lambda]
}

pub(super) fn energy(random: &mut Random) -> [f64; 4] {
    let (sigma, lambda) = (radius(random), wavelength(random));
    [sigma, lambda, direction(random)[0], random.log_uniform(1e-3, 1e6)]
}

fn energy_rows() -> Vec<f64> {
    let mut rows = recorded("segment_energy", false);
    for sigma in [10.0, 60.0] {
        for xi1 in [0.0, -0.0, 1e-30, 1e-3, -0.02, 2.0] {
            for length in [0.0, 1e-30, 1e-3, 2.0 * sigma, 1e6] {
                rows.push(vec![sigma, 0.55, xi1, length]);
            }
        }
    }
    kept(rows, false)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn scenes_hold_every_kind_of_scratch_and_stay_in_the_hemisphere() {
        let rows = (SPATIAL_PHASE.rows)(1, 20_000);
        let share =
            |condition: fn(&[f64]) -> bool| rows.chunks_exact(8).filter(|row| condition(row)).count() as f64 / 20_000.0;
        assert_eq!(share(|r| r[2].hypot(r[3]) > 2.0 + 1e-12), 0.0);
        assert_eq!(
            share(|r| !(r[6] <= r[7] || r[6] == 20.0) || !r[..6].iter().all(|x| x.is_finite())),
            0.0
        );
        assert!(share(|r| r[6].is_infinite() && r[7].is_finite()) > 0.05);
        assert!(share(|r| r[6].is_finite() && r[7].is_infinite()) > 0.05);
        assert!(share(|r| r[6].is_infinite() && r[7].is_infinite()) > 0.05);
        assert!(share(|r| r[2] == 0.0) > 0.05 && share(|r| r[2] != 0.0 && r[2].abs() < 1e-5) > 0.05);
        assert!(share(|r| r[7] - r[6] < 0.1) > 0.1 && share(|r| r[7] - r[6] > 1e5 && r[7] < f64::INFINITY) > 0.05);
        // The light falls on something in most scenes.
        assert!(share(|r| r[5].abs() < 3.0 * r[0] && r[4] + r[6] < 3.0 * r[0] && r[4] + r[7] > -3.0 * r[0]) > 0.3);
    }

    #[test]
    fn poles_are_met_and_approached_from_both_sides() {
        let rows = (TRIANGLE_POLES.rows)(1, 5000);
        let distances: Vec<f64> = rows
            .chunks_exact(5)
            .map(|r| r[2].abs() * r[0] / (2.0 * r[1] * r[3]) - 1.0)
            .collect();
        assert!(distances.iter().all(|d| d.abs() < 0.0101));
        assert!(distances.iter().filter(|d| d.abs() < 1e-15).count() > 500);
        for side in [-1.0, 1.0] {
            assert!(
                distances
                    .iter()
                    .filter(|d| (1e-9..1e-6).contains(&(side * **d)))
                    .count()
                    > 200
            );
        }
    }
}
