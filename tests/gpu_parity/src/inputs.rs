//! Rows of inputs: uniform, logarithmic, around region borders, and the edges of the format.

mod scenes;

use std::f32::consts::FRAC_PI_2;
use std::f64::consts::{PI, TAU};

/// Number of rows of the uniform and of the logarithmic part.
pub const ROWS: usize = 65_536;

/// Points in [0, 1) that fill it evenly, by multiples of the golden section; `stream` shifts them.
fn fraction(i: usize, stream: u64) -> f64 {
    let step = 0x9e37_79b9_7f4a_7c15u64.rotate_left(u32::try_from(stream % 64).unwrap_or(0) * 2) | 1;
    let bits = (i as u64 + 1).wrapping_mul(step).wrapping_add(stream << 57);
    (bits >> 11) as f64 / (1u64 << 53) as f64
}

fn logarithmic(i: usize, stream: u64, low: f64, high: f64) -> f32 {
    let size = low * (high / low).powf(fraction(i, stream));
    (if i.is_multiple_of(2) { size } else { -size }) as f32
}

/// Numbers around which a kernel may change its formula: small integers, their eighths and multiples of pi/2, each
/// with the neighbours up to 3 ulp.
fn borders() -> Vec<f32> {
    let centres = (1..=128)
        .map(|n| n as f32 * 0.125)
        .chain((1..=256).map(|n| n as f32 * FRAC_PI_2))
        .chain((17..=64).map(|n| n as f32))
        .chain([100.0, 1e3, 1e4]);
    centres
        .flat_map(|centre| (-3..=3i32).map(move |d| f32::from_bits(centre.to_bits().wrapping_add_signed(d))))
        .flat_map(|x| [x, -x])
        .collect()
}

/// Zeros, subnormals, powers of two through all exponents, the largest numbers, infinities and NaN.
fn edges() -> Vec<f32> {
    let powers = (0..255u32).flat_map(|exponent| [exponent << 23, (exponent << 23) | 1, (exponent << 23) | 0x7f_ffff]);
    powers
        .chain([f32::INFINITY.to_bits(), f32::NAN.to_bits()])
        .map(f32::from_bits)
        .flat_map(|x| [x, -x])
        .collect()
}

/// Rows for a function of one argument.
pub fn single() -> Vec<f32> {
    let uniform = (0..ROWS).map(|i| (fraction(i, 1) * 120.0 - 60.0) as f32);
    let logs = (0..ROWS).map(|i| logarithmic(i, 2, 1e-6, 1e4));
    uniform.chain(logs).chain(borders()).chain(edges()).collect()
}

/// Rows for a function of an interval, two to a row: arcs of every length, near and far, forwards and backwards.
pub fn pairs() -> Vec<f32> {
    let uniform = (0..ROWS).map(|i| {
        [
            (fraction(i, 3) * 120.0 - 60.0) as f32,
            (fraction(i, 4) * 120.0 - 60.0) as f32,
        ]
    });
    let logs = (0..ROWS).map(|i| {
        let start = logarithmic(i, 5, 1e-4, 1e3);
        [start, start + logarithmic(i / 2, 6, 1e-6, 1e2)]
    });
    let borders = borders();
    let near = borders
        .iter()
        .enumerate()
        .map(|(i, &q)| [q, q + logarithmic(i, 7, 1e-3, 10.0)]);
    let across = borders.iter().zip(borders.iter().rev()).map(|(&a, &b)| [a, b]);
    let edges = edges();
    let extreme = edges
        .iter()
        .zip(edges.iter().rev())
        .flat_map(|(&a, &b)| [[a, b], [a, a], [a, 1.0], [-2.0, a]]);
    uniform
        .chain(logs)
        .chain(near)
        .chain(across)
        .chain(extreme)
        .flatten()
        .collect()
}

/// A number between -2 and 2.
fn between(i: usize, stream: u64) -> f32 {
    (4.0 * fraction(i, stream) - 2.0) as f32
}

/// Rows of W/lambda and two direction cosines: wide and narrow intervals, either order, either sign, equal ends.
fn scratches() -> Vec<f32> {
    (0..ROWS)
        .flat_map(|i| {
            let width = if i % 97 == 0 {
                0.0
            } else {
                logarithmic(i, 20, 0.1, 256.0).abs()
            };
            let first = between(i, 21);
            let last = match i % 4 {
                0 => between(i, 22),
                1 => first + logarithmic(i, 23, 1e-7, 1e-2),
                2 => -first,
                _ => (first + logarithmic(i, 24, 1e-4, 1.0)).clamp(-2.0, 2.0),
            };
            [width, first, last]
        })
        .collect()
}

/// Points of the complex plane, two numbers to a row: about the origin, beside the axes, around the circle |z| = 2, far.
fn plane() -> Vec<f32> {
    let square = (0..ROWS / 2).map(|i| [3.0 * between(i, 30), 3.0 * between(i, 31)]);
    let beside = (0..ROWS / 4).map(|i| {
        let point = [6.0 * between(i, 32), logarithmic(i, 33, 1e-12, 1.0)];
        if i % 4 < 2 { point } else { [point[1], point[0]] }
    });
    let polar = (0..ROWS / 4).map(|i| {
        let size = if i % 2 == 0 {
            2.0 + 1e-6 * f64::from(between(i, 34))
        } else {
            f64::from(logarithmic(i, 35, 1e-6, 1e18).abs())
        };
        let (sine, cosine) = (TAU * fraction(i, 36)).sin_cos();
        [(size * cosine) as f32, (size * sine) as f32]
    });
    square.chain(beside).chain(polar).flatten().collect()
}

/// Segments a_from, a_to on a line at height b: long and short, in either order, over the origin, to where nothing is left.
fn segments() -> impl Iterator<Item = [f32; 3]> {
    (0..ROWS).map(|i| {
        let from = 2.0 * between(i, 40);
        let to = match i % 8 {
            0 | 1 => 2.0 * between(i, 41),
            2 => -from,
            3 if i % 5 == 0 => from,
            4 if i % 7 == 0 => 30.0,
            _ => from + logarithmic(i / 8, 42, 1e-5, 1.0),
        };
        let height = logarithmic(i / 2, 43, 1e-2, 1e3);
        [from, to, if i % 2 == 0 { height } else { -height }]
    })
}

/// The same with the turns of both ends, whole turns taken off.
fn segments_in_turns() -> Vec<f32> {
    let turns = |a: f32, b: f32| {
        let turns = f64::from(a) * f64::from(b) / PI;
        (turns - turns.round()) as f32
    };
    segments()
        .flat_map(|[from, to, b]| [from, to, b, turns(from, b), turns(to, b)])
        .collect()
}

/// Rows for the function of a name and a number of arguments: of its scene if it has one, of its number otherwise.
pub fn rows_for(name: &str, arguments: usize) -> Vec<f32> {
    scenes::rows(name).unwrap_or_else(|| rows(arguments))
}

/// Rows for a function of `arguments` arguments.
pub fn rows(arguments: usize) -> Vec<f32> {
    match arguments {
        1 => single(),
        2 => pairs().into_iter().chain(plane()).collect(),
        3 => scratches().into_iter().chain(segments().flatten()).collect(),
        5 => segments_in_turns(),
        n => (0..ROWS * n)
            .map(|i| logarithmic(i / n, 8 + (i % n) as u64, 1e-3, 1e3))
            .collect(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rows_are_whole_and_reach_every_part() {
        let rows = single();
        assert!(rows.len() > 2 * ROWS);
        assert!(rows.iter().any(|x| x.is_nan()) && rows.iter().any(|x| x.is_infinite()));
        assert!(rows.iter().any(|x| x.is_subnormal()) && rows.contains(&4.0) && rows.contains(&f32::MAX));
        assert!(rows.iter().any(|x| x.to_bits() == (-0.0f32).to_bits()));
        assert_eq!(pairs().len() % 2, 0);
        let short = pairs()
            .chunks_exact(2)
            .filter(|q| (q[1] - q[0]).abs() < 1e-3 && q[0].abs() > 1.0)
            .count();
        assert!(short > 1000, "only {short} short arcs far out");
    }

    #[test]
    fn uniform_rows_fill_their_interval() {
        let mut bins = [0usize; 12];
        for x in &single()[..ROWS] {
            bins[((x + 60.0) / 10.0) as usize % 12] += 1;
        }
        assert!(bins.iter().all(|&n| n > ROWS / 13 && n < ROWS / 11), "{bins:?}");
    }
}
