//! Intervals [q0, q1]: generators with two columns, and with a width before them. One row in ten has its ends swapped.

use super::random::{Random, neighbour, neighbour_f32};
use super::{Generator, fill, points, worst};
use std::f64::consts::PI;

/// Largest end of an arc in a generator.
const FARTHEST: f64 = 1e300;

/// Every kind of arc with finite ends, in equal shares.
pub const ARC_F64: Generator = Generator {
    name: "arc_f64",
    domain: "arcs with |q| <= 1e300: wide, 1 ulp to 3 long, at zeros n pi, far tail, across the peak, borders, tiny",
    columns: 2,
    rows: mixture,
};

/// Arcs with both ends uniform in [-60, 60]: the inputs of the scalar timings.
pub const ARC_UNIFORM_60: Generator = Generator {
    name: "arc_uniform_60",
    domain: "q0, q1 uniform in [-60, 60]",
    columns: 2,
    rows: |seed, n| {
        sampled(seed, n, |r| {
            let ends = [r.uniform(-60.0, 60.0), r.uniform(-60.0, 60.0)];
            [ends[0].min(ends[1]), ends[0].max(ends[1])]
        })
    },
};

/// Arcs between points of any size.
pub const ARC_WIDE: Generator = Generator {
    name: "arc_wide",
    domain: "both ends uniform in [-60, 60] or log-uniform in 1e-6..1e6, either sign",
    columns: 2,
    rows: |seed, n| sampled(seed, n, wide),
};

/// Arcs from one ulp to 3 long.
pub const ARC_SHORT: Generator = Generator {
    name: "arc_short",
    domain: "length log-uniform from 1 ulp to 3, |q0| log-uniform in 1e-3..1e6",
    columns: 2,
    rows: |seed, n| sampled(seed, n, short),
};

/// Arcs that begin, end or straddle at a zero of the integrand.
pub const ARC_AT_ZEROS: Generator = Generator {
    name: "arc_at_zeros",
    domain: "beginning, ending or straddling at n pi, length log-uniform from 1 ulp to 1",
    columns: 2,
    rows: |seed, n| sampled(seed, n, at_zeros),
};

/// Arcs far out on one side.
pub const ARC_TAIL: Generator = Generator {
    name: "arc_tail",
    domain: "one side, |q0| log-uniform in 40..1e300, relative length log-uniform in 1e-15..1e6",
    columns: 2,
    rows: |seed, n| sampled(seed, n, tail),
};

/// Arcs across the peak.
pub const ARC_STRADDLING: Generator = Generator {
    name: "arc_straddling",
    domain: "q0 < 0 < q1, sizes log-uniform in 1e-12..1e6",
    columns: 2,
    rows: |seed, n| sampled(seed, n, straddling),
};

/// The range of a scratch: k W xi to 1e3.
pub const SCRATCH_F32: Generator = Generator {
    name: "scratch_f32",
    domain: "f32, |q| <= 500 uniform or log-uniform, arc length log-uniform in 1e-6..1e3",
    columns: 2,
    rows: scratch,
};

/// A width in wavelengths and two direction cosines: t = pi (W/lambda) xi reaches 1600.
pub const SCRATCH_TURNS_F32: Generator = Generator {
    name: "scratch_turns_f32",
    domain: "f32, W/lambda log-uniform in 0.1..256, |xi| <= 2 uniform or log-uniform from 1e-6, or xi1 - xi0 log-uniform in 1e-7..4",
    columns: 3,
    rows: scratch_turns,
};

/// f32 arcs with both ends uniform in [-60, 60]: the inputs of the timings.
pub const SCRATCH_UNIFORM_F32: Generator = Generator {
    name: "scratch_uniform_f32",
    domain: "f32 q0, q1 uniform in [-60, 60]",
    columns: 2,
    rows: |seed, n| {
        sampled(seed, n, |r| {
            let ends = [r.uniform(-60.0, 60.0) as f32, r.uniform(-60.0, 60.0) as f32];
            [f64::from(ends[0].min(ends[1])), f64::from(ends[0].max(ends[1]))]
        })
    },
};

/// Finite arcs beyond the domain of [`ARC_F64`], where 2q or q1 - q0 overflows: only our own methods are held to these.
pub fn extreme() -> Vec<[f64; 2]> {
    let max = f64::MAX;
    vec![
        [-max, max],
        [max, -max],
        [1e300, max],
        [0.0, max],
        [-max, 1.0],
        [1e308, 1.7e308],
        [neighbour(max, -1), max],
        [-max, -1.6e308],
        [8.98846567431158e307, 8.98846567431159e307],
        [1.0, 1.0000000001e308],
        [-1e308, 1e-308],
    ]
}

/// Arcs with an infinite end or a NaN, for the tests of limits.
pub fn non_finite() -> Vec<[f64; 2]> {
    let inf = f64::INFINITY;
    let mut rows = vec![
        [-inf, inf],
        [inf, -inf],
        [inf, inf],
        [-inf, -inf],
        [f64::NAN, 1.0],
        [1.0, f64::NAN],
    ];
    for q in [
        0.0,
        -0.0,
        1e-300,
        0.1,
        1.0,
        PI,
        39.9,
        40.1,
        1e3,
        1e8,
        1e16,
        1e155,
        1e300,
        f64::MAX,
    ] {
        rows.extend([[q, inf], [-q, inf], [-inf, q], [-inf, -q], [inf, q]]);
    }
    rows
}

fn sampled(seed: u64, n: usize, sample: fn(&mut Random) -> [f64; 2]) -> Vec<f64> {
    let mut random = Random::new(seed);
    (0..n).flat_map(|_| sample(&mut random)).collect()
}

fn ordered([a, b]: [f64; 2]) -> [f64; 2] {
    [a.min(b), a.max(b)]
}

/// The mirrored arc, half of the time.
fn mirrored(random: &mut Random, [q0, q1]: [f64; 2]) -> [f64; 2] {
    if random.chance(0.5) { [q0, q1] } else { [-q1, -q0] }
}

fn wide(random: &mut Random) -> [f64; 2] {
    let mut end = || {
        let x = if random.chance(0.5) {
            random.uniform(0.0, 60.0)
        } else {
            random.log_uniform(1e-6, 1e6)
        };
        random.signed(x)
    };
    ordered([end(), end()])
}

/// q0 and an end that lies beyond it by a length between one ulp and `longest`.
fn with_length(random: &mut Random, q0: f64, longest: f64) -> [f64; 2] {
    let shortest = (neighbour(q0, 1) - q0).abs().min(longest);
    let length = random.log_uniform(shortest, longest);
    let q1 = q0 + length;
    [q0, if q1 > q0 { q1 } else { neighbour(q0, 1) }]
}

fn short(random: &mut Random) -> [f64; 2] {
    let q0 = random.log_uniform(1e-3, 1e6);
    let arc = with_length(random, q0, 3.0);
    mirrored(random, arc)
}

fn at_zeros(random: &mut Random) -> [f64; 2] {
    let largest = if random.chance(0.8) { 1e4 } else { 1e9 };
    let n = random.log_uniform(1.0, largest).floor();
    let zero = neighbour(n * PI, random.integer(-1, 1));
    let [_, end] = with_length(random, zero, 1.0);
    let length = end - zero;
    let arc = match random.integer(0, 3) {
        // The shortest arcs that are no longer summed by a Gauss rule, about a zero.
        3 => {
            let half = random.uniform(0.49, 0.6);
            [zero - half, zero + half]
        }
        0 => [zero, end],
        1 => [zero - length, zero],
        _ => [zero - random.uniform(0.0, 1.0) * length, end],
    };
    mirrored(random, arc)
}

fn tail(random: &mut Random) -> [f64; 2] {
    let farthest = if random.chance(0.7) { 1e8 } else { 1e300 };
    let q0 = random.log_uniform(40.0, farthest);
    let q1 = (q0 * (1.0 + random.log_uniform(1e-15, 1e6))).min(FARTHEST);
    let q0 = q0.min(neighbour(FARTHEST, -1));
    mirrored(random, [q0, if q1 > q0 { q1 } else { neighbour(q0, 1) }])
}

fn straddling(random: &mut Random) -> [f64; 2] {
    [-random.log_uniform(1e-12, 1e6), random.log_uniform(1e-12, 1e6)]
}

fn borders(random: &mut Random) -> [f64; 2] {
    let q0 = points::near_borders(random);
    if random.chance(0.5) {
        with_length(random, q0, 5.0)
    } else {
        ordered([q0, points::near_borders(random)])
    }
}

fn tiny(random: &mut Random) -> [f64; 2] {
    let mut end = || {
        let x = random.log_uniform(1e-307, 1e-3);
        random.signed(if x < 1e-306 { x * 1e-12 } else { x })
    };
    ordered([end(), end()])
}

/// Rows that every mixture begins with.
fn fixed() -> Vec<f64> {
    let mut rows = vec![[0.0, 0.0], [1.0, 1.0], [0.0, 5e-324], [-1e300, 1e300], [0.0, 1e300]];
    for q in points::edges().into_iter().filter(|q| q.abs() <= FARTHEST) {
        rows.extend([[0.0, q], [q, 1.0], [q, (2.0 * q).clamp(-FARTHEST, FARTHEST)]]);
        if q.abs() < 1e16 {
            rows.extend([[q, q + 1e-6], [q, q + 2.5], [q, neighbour(q, 1)]]);
        }
    }
    for n in 1..60 {
        let zero = f64::from(n) * PI;
        rows.extend([
            [zero, neighbour(zero, 1)],
            [neighbour(zero, -1), zero],
            [zero, zero + 1e-6],
            [zero, zero + PI],
        ]);
    }
    let recorded = worst::recorded(2).into_iter().map(|row| [row[0], row[1]]);
    rows.extend(recorded.filter(|row| row.iter().all(|q| q.abs() <= FARTHEST)));
    rows.into_iter().flatten().collect()
}

fn mixture(seed: u64, n: usize) -> Vec<f64> {
    fill(seed, n, 2, fixed(), |random, rows| {
        let kinds = [wide, short, at_zeros, tail, straddling, borders, tiny];
        let [q0, q1] = random.pick(&kinds)(random);
        rows.extend(if random.chance(0.1) { [q1, q0] } else { [q0, q1] });
    })
}

fn scratch(seed: u64, n: usize) -> Vec<f64> {
    let recorded = worst::recorded(2).into_iter().flatten().collect::<Vec<_>>();
    let in_range = |q: &[f64]| q.iter().all(|&x| x.abs() <= 500.0 && f64::from(x as f32) == x);
    let mut rows: Vec<f64> = recorded.chunks(2).filter(|q| in_range(q)).flatten().copied().collect();
    for q in [0.0, 1e-6, 0.25, 1.0, 2.0, 4.0, 8.0, 16.0, 100.0, 499.0] {
        for length in [1e-6, 1e-3, 0.1, 1.0, 3.0, 10.0] {
            let q0 = neighbour_f32(q, 0);
            rows.extend([q0, neighbour_f32((q + length).min(500.0), 0), -q0, q0]);
        }
    }
    fill(seed, n, 2, rows, |random, rows| {
        let q0 = if random.chance(0.5) {
            random.uniform(0.0, 500.0)
        } else {
            random.log_uniform(1e-4, 500.0)
        };
        let q0 = neighbour_f32(random.signed(q0), 0);
        let q1 = neighbour_f32((q0 + random.log_uniform(1e-6, 1e3)).min(500.0), 0);
        rows.extend(if random.chance(0.1) { [q1, q0] } else { [q0, q1] });
    })
}

fn direction_cosine(random: &mut Random) -> f64 {
    let xi = if random.chance(0.5) {
        random.uniform(0.0, 2.0)
    } else {
        random.log_uniform(1e-6, 2.0)
    };
    neighbour_f32(random.signed(xi), 0)
}

fn scratch_turns(seed: u64, n: usize) -> Vec<f64> {
    let recorded = worst::recorded(3).into_iter().flatten();
    let mut rows: Vec<f64> = recorded.collect();
    for width in [0.1, 0.5, 1.0, 2.5, 31.0, 100.0, 255.0] {
        let width = neighbour_f32(width, 0);
        for [xi0, xi1] in [
            [-2.0, 2.0],
            [0.0, 2.0],
            [0.5, 1.0],
            [1.0, 1.5],
            [1.5, 2.0],
            [-1.0, -0.75],
        ] {
            rows.extend([width, xi0, xi1]);
        }
        for k in 1..8 {
            let xi = 0.25 * f64::from(k);
            rows.extend([width, xi, neighbour_f32(xi, 1), width, xi, neighbour_f32(xi, 1000)]);
        }
    }
    fill(seed, n, 3, rows, |random, rows| {
        let width = neighbour_f32(random.log_uniform(0.1, 255.9), 0);
        let xi0 = direction_cosine(random);
        let xi1 = if random.chance(0.5) {
            direction_cosine(random)
        } else {
            neighbour_f32((xi0 + random.log_uniform(1e-7, 4.0)).min(2.0), 0)
        };
        rows.extend(if xi1 < xi0 && random.chance(0.8) {
            [width, xi1, xi0]
        } else {
            [width, xi0, xi1]
        });
    })
}
