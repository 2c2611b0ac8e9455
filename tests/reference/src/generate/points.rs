//! Points on the real line: generators with one column.

use super::random::{Random, neighbour, neighbour_f32};
use super::{Generator, fill, worst};
use std::f64::consts::FRAC_PI_2;

/// Every finite f64: a mixture of all generators below, with the fixed edges, borders and recorded worst inputs.
pub const REAL_F64: Generator = Generator {
    name: "real_f64",
    domain: "all finite x: edges, region borders, near k pi/2, results beside powers of two, uniform, log-uniform, random bits",
    columns: 1,
    rows: |seed, n| mixture(seed, n, false),
};

/// The same mixture at f32 values.
pub const REAL_F32: Generator = Generator {
    name: "real_f32",
    domain: "all finite f32 x: edges, region borders, near k pi/2, results beside powers of two, uniform, log-uniform, random bits",
    columns: 1,
    rows: |seed, n| mixture(seed, n, true),
};

/// Uniform in [-60, 60]: the range of the ulp plots and of the scalar timings.
pub const UNIFORM_60: Generator = Generator {
    name: "uniform_60",
    domain: "x uniform in [-60, 60]",
    columns: 1,
    rows: |seed, n| sampled(seed, n, |r| r.uniform(-60.0, 60.0)),
};

/// Uniform in [-60, 60] at f32 values.
pub const UNIFORM_60_F32: Generator = Generator {
    name: "uniform_60_f32",
    domain: "f32 x uniform in [-60, 60]",
    columns: 1,
    rows: |seed, n| sampled(seed, n, |r| f64::from(r.uniform(-60.0, 60.0) as f32)),
};

/// Angles at f32 values to 1e4: the range in which the f32 kernels promise a phase.
pub const ANGLES_F32: Generator = Generator {
    name: "angles_f32",
    domain: "f32 |x| <= 1e4: uniform, log-uniform from 1e-6, within 4 ulp of k pi/2, edges",
    columns: 1,
    rows: angles,
};

/// Exponents at f32 values whose power is a normal f32.
pub const EXPONENTS_F32: Generator = Generator {
    name: "exponents_f32",
    domain: "f32 x in [-87, 88.7]: uniform, log-uniform sizes from 1e-9, within 4 ulp of (k/2) ln 2, edges",
    columns: 1,
    rows: exponents,
};

/// Log-uniform sizes from 1e-6 to 1e6, both signs.
pub const LOG_UNIFORM: Generator = Generator {
    name: "log_uniform",
    domain: "|x| log-uniform in [1e-6, 1e6]",
    columns: 1,
    rows: |seed, n| sampled(seed, n, |r| log_uniform(r, 1e-6, 1e6)),
};

/// Within a few neighbours of k pi/2: zeros and extrema of sine and cosine.
pub const NEAR_ZEROS: Generator = Generator {
    name: "near_zeros",
    domain: "within 4 ulp of k pi/2, k log-uniform to 1e9",
    columns: 1,
    rows: |seed, n| sampled(seed, n, near_zeros),
};

/// Within a few neighbours of the places where kernels change method.
pub const NEAR_BORDERS: Generator = Generator {
    name: "near_borders",
    domain: "within 4 ulp of the multiples of 1/8 to 17 and of powers of two",
    columns: 1,
    rows: |seed, n| sampled(seed, n, near_borders),
};

/// Random bit patterns of finite f64.
pub const BIT_PATTERNS: Generator = Generator {
    name: "bit_patterns",
    domain: "random bits of finite f64",
    columns: 1,
    rows: |seed, n| sampled(seed, n, bit_patterns),
};

/// The range of the Bessel functions of a scene.
pub const BESSEL_LINE: Generator = Generator {
    name: "bessel_line",
    domain: "half uniform in (0, 30), half log-uniform in 1e-3..1e5",
    columns: 1,
    rows: |seed, n| sampled(seed, n, bessel),
};

/// The same at f32 values: the inputs of the timings.
pub const BESSEL_LINE_F32: Generator = Generator {
    name: "bessel_line_f32",
    domain: "f32, half uniform in (0, 30), half log-uniform in 1e-3..1e5",
    columns: 1,
    rows: |seed, n| sampled(seed, n, |r| neighbour_f32(bessel(r), 0)),
};

/// Infinities and NaN, for the tests of limits.
pub fn non_finite() -> Vec<f64> {
    vec![f64::INFINITY, f64::NEG_INFINITY, f64::NAN, -f64::NAN]
}

/// Zeros, subnormals, extremes and round numbers of f64.
pub fn edges() -> Vec<f64> {
    let sizes = [
        0.0,
        5e-324,
        1e-323,
        1e-310,
        2.225073858507201e-308,
        f64::MIN_POSITIVE,
        1e-300,
        1e-200,
        1e-160,
        1e-100,
        1e-50,
        1e-38,
        1e-30,
        1e-20,
        1e-16,
        f64::EPSILON,
        1e-12,
        1.4901161193847656e-8,
        1e-8,
        1e-6,
        1e-4,
        1e-3,
        0.1,
        0.5,
        1.0,
        2.0,
        3.0,
        10.0,
        100.0,
        1e3,
        1e4,
        1e5,
        1e6,
        1e8,
        1e9,
        1e10,
        1e15,
        9007199254740991.0,
        9007199254740992.0,
        1e16,
        1e17,
        1e20,
        1e22,
        1e30,
        1e50,
        1e100,
        1e154,
        1.4e154,
        1e200,
        1e300,
        8.98846567431158e307,
        f64::MAX,
        6381956970095103.0 * 2f64.powi(797),
    ];
    sizes.iter().flat_map(|&x| [x, -x]).collect()
}

/// The same for f32.
pub fn edges_f32() -> Vec<f64> {
    let bits = [
        0,
        1,
        2,
        0x7F_FFFF,
        0x80_0000,
        0x80_0001,
        0x3400_0000,
        0x3F80_0000,
        0x3F80_0001,
        0x4B80_0000,
        0x7F7F_FFFF,
    ];
    let exact = bits.iter().map(|&b| f64::from(f32::from_bits(b)));
    let rounded = edges().into_iter().filter(|x| x.abs() > 1e-37 && x.abs() < 3e38);
    exact
        .chain(rounded.map(|x| f64::from(x as f32)))
        .flat_map(|x| [x, -x])
        .collect()
}

/// Places where kernels change method: multiples of 1/8 to 17, of pi/4 to 8 pi, powers of two, and limits of formats.
fn borders() -> Vec<f64> {
    let eighths = (1..=136).map(|k| f64::from(k) / 8.0);
    let quarters = (1..=32).map(|k| f64::from(k) * FRAC_PI_2 / 2.0);
    let powers = (-30..=60).map(|k| 2f64.powi(k));
    let others = [
        15.875, 1e-5, 1e-4, 1e-3, 1e3, 1e4, 1e5, 20.0, 24.0, 32.0, 40.0, 48.0, 50.0, 80.0, 100.0,
    ];
    eighths.chain(quarters).chain(powers).chain(others).collect()
}

/// A number within four neighbours of a border, for use in arcs too.
pub(super) fn near_borders(random: &mut Random) -> f64 {
    let (x, steps) = border_and_steps(random);
    neighbour(x, steps)
}

fn border_and_steps(random: &mut Random) -> (f64, i64) {
    thread_local!(static BORDERS: Vec<f64> = borders());
    let x = BORDERS.with(|list| random.pick(list));
    (random.signed(x), random.integer(-4, 4))
}

fn zero_and_steps(random: &mut Random) -> (f64, i64) {
    let k = random.log_uniform(1.0, 1e9).floor();
    (random.signed(k * FRAC_PI_2), random.integer(-4, 4))
}

fn near_zeros(random: &mut Random) -> f64 {
    let (x, steps) = zero_and_steps(random);
    neighbour(x, steps)
}

fn log_uniform(random: &mut Random, lo: f64, hi: f64) -> f64 {
    let x = random.log_uniform(lo, hi);
    random.signed(x)
}

fn bessel(random: &mut Random) -> f64 {
    if random.chance(0.5) {
        random.uniform(0.0, 30.0)
    } else {
        random.log_uniform(1e-3, 1e5)
    }
}

fn bit_patterns(random: &mut Random) -> f64 {
    loop {
        let x = f64::from_bits(random.bits());
        if x.is_finite() {
            return x;
        }
    }
}

fn bit_patterns_f32(random: &mut Random) -> f64 {
    loop {
        let x = f32::from_bits(random.bits() as u32);
        if x.is_finite() {
            return f64::from(x);
        }
    }
}

fn sampled(seed: u64, n: usize, sample: fn(&mut Random) -> f64) -> Vec<f64> {
    let mut random = Random::new(seed);
    (0..n).map(|_| sample(&mut random)).collect()
}

/// Edges and recorded worst inputs at f32 values between two numbers.
fn fixed_f32(lo: f64, hi: f64) -> Vec<f64> {
    let recorded = worst::recorded(1).into_iter().flatten();
    let all = edges_f32()
        .into_iter()
        .chain([neighbour_f32(lo, 0), neighbour_f32(hi, 0)])
        .chain(recorded);
    all.filter(|&x| lo <= x && x <= hi && f64::from(x as f32) == x)
        .collect()
}

fn angles(seed: u64, n: usize) -> Vec<f64> {
    const LARGEST: f64 = 1e4;
    fill(seed, n, 1, fixed_f32(-LARGEST, LARGEST), |random, row| {
        row.push(match random.integer(0, 2) {
            0 => neighbour_f32(random.uniform(-LARGEST, LARGEST), 0),
            1 => neighbour_f32(log_uniform(random, 1e-6, LARGEST), 0),
            _ => {
                let k = random.log_uniform(1.0, LARGEST / FRAC_PI_2 - 1.0).floor();
                neighbour_f32(random.signed(k * FRAC_PI_2), random.integer(-4, 4))
            }
        });
    })
}

fn exponents(seed: u64, n: usize) -> Vec<f64> {
    const LOWEST: f64 = -87.0;
    const HIGHEST: f64 = 88.69999694824219;
    fill(seed, n, 1, fixed_f32(LOWEST, HIGHEST), |random, row| {
        let x = match random.integer(0, 2) {
            0 => neighbour_f32(random.uniform(LOWEST, HIGHEST), 0),
            1 => neighbour_f32(log_uniform(random, 1e-9, HIGHEST), 0),
            _ => {
                let halves = random.integer(-250, 255) as f64;
                neighbour_f32(0.5 * halves * std::f64::consts::LN_2, random.integer(-4, 4))
            }
        };
        row.push(x.clamp(LOWEST, HIGHEST));
    })
}

/// Fixed points first, then equal shares of every kind.
fn mixture(seed: u64, n: usize, single: bool) -> Vec<f64> {
    let mut fixed = if single { edges_f32() } else { edges() };
    fixed.extend(
        borders()
            .into_iter()
            .map(|x| if single { f64::from(x as f32) } else { x }),
    );
    let recorded = worst::recorded(1).into_iter().flatten();
    fixed.extend(recorded.filter(|&x| x.is_finite() && (!single || f64::from(x as f32) == x)));
    let step = if single { neighbour_f32 } else { neighbour };
    fill(seed, n, 1, fixed, |random, row| {
        row.push(match random.integer(0, 6) {
            0 => step(random.uniform(-60.0, 60.0), 0),
            1 => step(random.uniform(-1000.0, 1000.0), 0),
            2 => step(log_uniform(random, 1e-6, 1e6), 0),
            3 => {
                let (x, steps) = zero_and_steps(random);
                step(x, steps)
            }
            4 => {
                let (x, steps) = border_and_steps(random);
                step(x, steps)
            }
            5 => step(beside_power_of_two(random), 0),
            _ if single => bit_patterns_f32(random),
            _ => bit_patterns(random),
        });
    })
}

/// An x whose Si or whose sine lies beside a power of two, where the last place of the result changes its size.
fn beside_power_of_two(random: &mut Random) -> f64 {
    let size = random.uniform(0.0, 12.0).floor().exp2().recip();
    let inverse = if random.chance(0.5) {
        // Si^-1(1) is 1.0648..; below, Si(x) = s is near x = s + s^3/18.
        size + size.powi(3) / 18.0 + 0.0092 * size.powi(5)
    } else {
        size.min(0.5).asin()
    };
    (inverse * (1.0 + random.uniform(-0.03, 0.03))).copysign(random.uniform(-1.0, 1.0))
}
