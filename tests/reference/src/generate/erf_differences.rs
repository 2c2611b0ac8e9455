//! Rows a1, a2, b of the scaled erf difference: generators with three columns.

use super::random::{Random, neighbour, neighbour_f32};
use super::{Generator, fill, worst};
use std::f64::consts::{PI, SQRT_2};

/// Scenes of scratches, the coherence radius 10 or 60 um.
pub const SCRATCH: Generator = Generator {
    name: "erf_difference_scratch",
    domain: "scratches: a = (s + l)/(sqrt2 sigma), b = sigma k xi/sqrt2, sigma 10 or 60 um, lambda 0.4..0.7 um, |xi| <= 2, length log-uniform in 1..1e4 um",
    columns: 3,
    rows: |seed, n| {
        fill(seed, n, 3, recorded(false, scene_sized), |r, rows| {
            rows.extend(scratch(r))
        })
    },
};

/// The same at f32 values.
pub const SCRATCH_F32: Generator = Generator {
    name: "erf_difference_scratch_f32",
    domain: "f32 scratches: a = (s + l)/(sqrt2 sigma), b = sigma k xi/sqrt2, sigma 10 or 60 um, lambda 0.4..0.7 um, |xi| <= 2, length log-uniform in 1..1e4 um",
    columns: 3,
    rows: |seed, n| {
        fill(seed, n, 3, recorded(true, scene_sized), |r, rows| {
            rows.extend(scratch(r).map(|x| neighbour_f32(x, 0)));
        })
    },
};

/// Any finite input.
pub const ANY: Generator = Generator {
    name: "erf_difference_any",
    domain: "finite a1, a2, b: scratches, segments from one ulp, far ends, |b| from 1e-300 to 1e308, subnormals, equal and opposite ends",
    columns: 3,
    rows: any,
};

/// Short segments.
pub const SHORT: Generator = Generator {
    name: "erf_difference_short",
    domain: "a2 - a1 log-uniform from one ulp to 1, |a1| <= 6, |b| log-uniform in 1e-3..1e4",
    columns: 3,
    rows: |seed, n| fill(seed, n, 3, Vec::new(), |r, rows| rows.extend(short(r))),
};

/// Rows with an infinite end or a NaN, for the tests of limits.
pub fn non_finite() -> Vec<[f64; 3]> {
    let (inf, nan) = (f64::INFINITY, f64::NAN);
    let mut rows = vec![[nan, 1.0, 1.0], [1.0, nan, 1.0], [1.0, 2.0, nan], [nan, nan, inf]];
    for b in [0.0, 1e-300, 0.3, 2.0, 30.0, 1e3, 1e155, 1e308] {
        for b in [b, -b] {
            rows.extend([[-inf, inf, b], [inf, -inf, b], [inf, inf, b], [-inf, -inf, b]]);
            for a in [0.0, 1e-300, 0.4, 3.0, 20.0, 1e5, 1e300] {
                rows.extend([[a, inf, b], [-a, inf, b], [-inf, a, b], [inf, a, b]]);
            }
        }
    }
    for b in [inf, -inf] {
        rows.extend([[0.1, 0.2, b], [-inf, inf, b], [1.0, 1.0, b], [-3.0, inf, b]]);
    }
    rows
}

fn scene_sized(row: &[f64]) -> bool {
    row.iter().all(|x| x.abs() <= 2000.0)
}

fn recorded(single: bool, condition: fn(&[f64]) -> bool) -> Vec<f64> {
    let rows = worst::recorded_for(&["erf_difference_scaled"]).into_iter();
    let representable = |row: &Vec<f64>| {
        row.iter()
            .all(|&x| x.is_finite() && (!single || f64::from(x as f32) == x))
    };
    rows.filter(|row| representable(row) && condition(row))
        .flatten()
        .collect()
}

/// One row of a scene: the footprint's centre within three coherence radii of the segment, or over it.
pub(super) fn scratch(random: &mut Random) -> [f64; 3] {
    let sigma = random.pick(&[10.0, 60.0]);
    let length = random.log_uniform(1.0, 1e4);
    let start = random.uniform(-3.0 * sigma - length, 3.0 * sigma);
    let wave_number = 2.0 * PI / random.uniform(0.4, 0.7);
    let xi = if random.chance(0.5) {
        random.uniform(0.0, 2.0)
    } else {
        random.log_uniform(1e-5, 2.0)
    };
    let b = sigma * wave_number * xi / SQRT_2;
    let scale = SQRT_2 * sigma;
    [start / scale, (start + length) / scale, random.signed(b)]
}

fn short(random: &mut Random) -> [f64; 3] {
    let a = random.uniform(-6.0, 6.0);
    let b = random.log_uniform(1e-3, 1e4);
    segment(random, a, 1.0, b)
}

fn segment(random: &mut Random, a: f64, longest: f64, b: f64) -> [f64; 3] {
    let shortest = (neighbour(a, 1) - a).abs();
    let end = a + random.log_uniform(shortest.max(5e-324), longest.max(shortest));
    [
        a,
        if end > a {
            end
        } else {
            neighbour(a, if a < 0.0 { -1 } else { 1 })
        },
        random.signed(b),
    ]
}

fn adversarial(random: &mut Random) -> [f64; 3] {
    let b = random.log_uniform(1e-300, 1e308);
    let moderate = random.log_uniform(1e-3, 1e3);
    match random.integer(0, 7) {
        0 => scratch(random),
        1 => short(random),
        2 => {
            let a = random.log_uniform(1e-300, 30.0);
            let a = random.signed(a);
            let longest = random.log_uniform(1e-16, 30.0);
            segment(random, a, longest, b)
        }
        3 => [random.uniform(-8.0, 8.0), random.uniform(-8.0, 8.0), b],
        4 => {
            let (a1, a2) = (random.log_uniform(1e-300, 1e300), random.log_uniform(1e-300, 1e300));
            [random.signed(a1), random.signed(a2), moderate]
        }
        5 => {
            let a = random.log_uniform(1e-8, 20.0);
            [-a, neighbour(a, random.integer(-3, 3)), moderate]
        }
        6 => {
            // The ends a multiple of pi/b apart about the origin: the zeros of the real part's envelope.
            let half = PI / moderate * f64::from(random.integer(1, 9) as i32) / 2.0;
            let middle = random.log_uniform(1e-12, 1.0);
            [middle - half, middle + half, moderate]
        }
        _ => {
            let b = random.log_uniform(1e2, 1e16);
            let longest = 1.0 / b;
            let a = random.uniform(-5.0, 5.0);
            segment(random, a, longest, b)
        }
    }
}

fn any(seed: u64, n: usize) -> Vec<f64> {
    let mut rows = recorded(false, |_| true);
    for b in [
        0.0, 5e-324, 1e-300, 1e-8, 0.5, 1.0, 5.0, 26.0, 27.3, 40.0, 1500.0, 1e5, 1e16, 1e150, 1e155, 1e308,
    ] {
        for [a1, a2] in [
            [0.0, 0.0],
            [1.5, 1.5],
            [0.0, 5e-324],
            [-5e-324, 5e-324],
            [-0.0, 1e-310],
            [0.0, 1e-16],
            [0.0, 1.0],
            [-1.0, 1.0],
            [1.0, neighbour(1.0, 1)],
            [-3.0, neighbour(-3.0, -1)],
            [5.0, 6.0],
            [26.0, 28.0],
            [-40.0, 40.0],
            [1e10, 1e300],
            [-1e300, 1e300],
            [1e154, 1e155],
            [-1e308, 1e308],
        ] {
            rows.extend([a1, a2, b]);
        }
    }
    fill(seed, n, 3, rows, |random, rows| {
        let [a1, a2, b] = adversarial(random);
        let b = random.signed(b);
        rows.extend(if random.chance(0.1) { [a2, a1, b] } else { [a1, a2, b] });
    })
}
