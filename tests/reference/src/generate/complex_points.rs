//! Points of the complex plane: generators with two columns, the real and the imaginary part.

use super::random::{Random, neighbour, neighbour_f32};
use super::{Generator, fill, points, worst};
use crate::oracle::zeros;
use std::f64::consts::{FRAC_PI_2, PI};

/// Functions whose recorded worst inputs belong to these mixtures.
const FUNCTIONS: [&str; 4] = ["faddeeva_w", "faddeeva_w_derivative", "erf_complex", "erfc_complex"];
/// Largest |z|.
const FARTHEST: f64 = 1e150;

/// Every kind of point above the real axis and on it.
pub const UPPER_HALF_PLANE: Generator = Generator {
    name: "complex_upper_half_plane",
    domain: "y >= 0: [-12, 12] x [0, 12], |z| log-uniform in 1e-300..1e150, near both axes to 1e-300, 5 <= |z| <= 9, axes, zeros, subnormals",
    columns: 2,
    rows: |seed, n| upper_mixture(seed, n, false),
};

/// The same at f32 values.
pub const UPPER_HALF_PLANE_F32: Generator = Generator {
    name: "complex_upper_half_plane_f32",
    domain: "f32 y >= 0: [-12, 12] x [0, 12], |z| log-uniform in 1e-37..1e18, near both axes to 1e-37, 5 <= |z| <= 9, axes, zeros, subnormals",
    columns: 2,
    rows: |seed, n| upper_mixture(seed, n, true),
};

/// The mirror image, without the neighbourhood of the zeros of w, where exp(-z^2) is finite.
pub const LOWER_HALF_PLANE: Generator = Generator {
    name: "complex_lower_half_plane",
    domain: "y < 0, more than 0.1 from every zero of w: the mirror image of the upper half plane, y^2 - x^2 <= 700",
    columns: 2,
    rows: |seed, n| lower_mixture(seed, n, false),
};

/// The same at f32 values, y^2 - x^2 <= 85.
pub const LOWER_HALF_PLANE_F32: Generator = Generator {
    name: "complex_lower_half_plane_f32",
    domain: "f32 y < 0, more than 0.1 from every zero of w: the mirror image of the upper half plane, y^2 - x^2 <= 85",
    columns: 2,
    rows: |seed, n| lower_mixture(seed, n, true),
};

/// Both halves, zeros included.
pub const WHOLE_PLANE: Generator = Generator {
    name: "complex_whole_plane",
    domain: "the mixture of the upper half plane turned by a random multiple of a quarter turn, |Re z^2| <= 700 for most",
    columns: 2,
    rows: whole_plane,
};

/// Within 0.1 of the first zeros of w.
pub const ZEROS_OF_W: Generator = Generator {
    name: "complex_zeros_of_w",
    domain: "within 0.1 of the first 8 zeros of w and their mirror images, distance log-uniform from 1e-16",
    columns: 2,
    rows: |seed, n| sampled(seed, n, |r| beside_zero(r, &zeros::W, false)),
};

/// Within 0.1 of the first zeros of erf.
pub const ZEROS_OF_ERF: Generator = Generator {
    name: "complex_zeros_of_erf",
    domain: "within 0.1 of the first 8 zeros of erf and their images in all quadrants, distance log-uniform from 1e-16",
    columns: 2,
    rows: |seed, n| sampled(seed, n, |r| beside_zero(r, &zeros::ERF, true)),
};

/// The first quadrant to 12: the domain of the published comparisons.
pub const FIRST_QUADRANT: Generator = Generator {
    name: "complex_first_quadrant",
    domain: "x, y uniform in [0, 12]",
    columns: 2,
    rows: |seed, n| sampled(seed, n, |r| [r.uniform(0.0, 12.0), r.uniform(0.0, 12.0)]),
};

/// Beside the real axis.
pub const NEAR_REAL_AXIS: Generator = Generator {
    name: "complex_near_real_axis",
    domain: "x uniform in [0, 30], y log-uniform in 1e-300..1",
    columns: 2,
    rows: |seed, n| sampled(seed, n, near_real_axis),
};

/// Beside the imaginary axis.
pub const NEAR_IMAGINARY_AXIS: Generator = Generator {
    name: "complex_near_imaginary_axis",
    domain: "y uniform in [0, 30], x log-uniform in 1e-300..1",
    columns: 2,
    rows: |seed, n| sampled(seed, n, |r| swapped(near_real_axis(r))),
};

/// Far from the origin in the upper half plane.
pub const UPPER_TAIL: Generator = Generator {
    name: "complex_upper_tail",
    domain: "|z| log-uniform in 10..1e150, any angle in [0, pi]; half of them with y or x log-uniform down to 1e-300",
    columns: 2,
    rows: |seed, n| sampled(seed, n, upper_tail),
};

/// Where implementations change their method.
pub const RING: Generator = Generator {
    name: "complex_ring",
    domain: "|z| uniform in [5, 9], any angle in [0, pi]",
    columns: 2,
    rows: |seed, n| sampled(seed, n, |r| ring(r, 5.0, 9.0)),
};

/// The real axis as complex numbers.
pub const REAL_LINE: Generator = Generator {
    name: "complex_real_line",
    domain: "y = +0 or -0, x uniform in [-30, 30] or log-uniform in 1e-300..1e150, either sign",
    columns: 2,
    rows: |seed, n| sampled(seed, n, real_line),
};

/// Arguments of the scaled complementary error function.
pub const ERFCX_LINE: Generator = Generator {
    name: "erfcx_line",
    domain: "x uniform in [-26, 30], log-uniform sizes in 1e-300..1e300 (to 26 below zero), edges",
    columns: 1,
    rows: erfcx_line,
};

/// Inputs of the timings of w: f32 numbers.
pub const TIMING: Generator = Generator {
    name: "complex_timing_f32",
    domain: "half uniform in [-6, 6] x [0, 6], a quarter |z| log-uniform in 1e-3..1e3, a quarter x in [0, 12] and y log-uniform in 1e-6..1",
    columns: 2,
    rows: |seed, n| sampled(seed, n, timing),
};

/// Infinities and NaN, for the tests of limits.
pub fn non_finite() -> Vec<[f64; 2]> {
    let inf = f64::INFINITY;
    let finite = [0.0, 1e-300, 0.3, 1.0, 7.5, 1e3, 1e150, f64::MAX];
    let mut rows = vec![[f64::NAN, f64::NAN]];
    for x in finite.into_iter().chain([inf]).flat_map(|x| [x, -x]) {
        rows.extend([[f64::NAN, x], [x, f64::NAN]]);
        for infinity in [inf, -inf] {
            rows.push([infinity, x]);
            if x.is_finite() {
                rows.push([x, infinity]);
            }
        }
    }
    rows
}

/// Exact zeros, subnormals, axes and round sizes, in all quadrants.
pub fn edges() -> Vec<[f64; 2]> {
    let sizes = [
        0.0,
        5e-324,
        1e-310,
        f64::MIN_POSITIVE,
        1e-300,
        1e-160,
        1e-30,
        1e-16,
        1e-8,
        1e-3,
    ];
    let large = [
        0.5, 1.0, 2.0, 5.0, 6.0, 7.0, 8.0, 9.0, 12.0, 26.0, 27.3, 1e3, 1e8, 7.2355e7, 1e16, 1e77, 1e150,
    ];
    let all: Vec<f64> = sizes.into_iter().chain(large).collect();
    let mut rows = Vec::new();
    for &x in &all {
        for &y in &all {
            if x == 0.0 || y == 0.0 || x == y || (x < 1e-7) != (y < 1e-7) {
                rows.extend([[x, y], [-x, y]]);
            }
        }
    }
    rows.extend([[7.2355e7, 0.48], [-0.0, -0.0], [5e-324, -0.0]]);
    rows
}

fn sampled(seed: u64, n: usize, sample: fn(&mut Random) -> [f64; 2]) -> Vec<f64> {
    let mut random = Random::new(seed);
    (0..n).flat_map(|_| sample(&mut random)).collect()
}

fn swapped([x, y]: [f64; 2]) -> [f64; 2] {
    [y, x]
}

fn polar(size: f64, angle: f64) -> [f64; 2] {
    let (sine, cosine) = angle.sin_cos();
    [size * cosine, size * sine.abs()]
}

fn ring(random: &mut Random, lo: f64, hi: f64) -> [f64; 2] {
    polar(random.uniform(lo, hi), random.uniform(0.0, PI))
}

fn near_real_axis(random: &mut Random) -> [f64; 2] {
    [random.uniform(0.0, 30.0), random.log_uniform(1e-300, 1.0)]
}

fn upper_tail(random: &mut Random) -> [f64; 2] {
    let size = random.log_uniform(10.0, FARTHEST);
    let small = random.log_uniform(1e-300, size);
    match random.integer(0, 3) {
        0 => [random.signed(size), small],
        1 => [random.signed(small), size],
        _ => polar(size, random.uniform(0.0, PI)),
    }
}

fn real_line(random: &mut Random) -> [f64; 2] {
    let x = if random.chance(0.5) {
        random.uniform(0.0, 30.0)
    } else {
        random.log_uniform(1e-300, FARTHEST)
    };
    [random.signed(x), random.signed(0.0)]
}

/// One point above the real axis; `least` and `most` are the bounds of log-uniform sizes.
fn upper(random: &mut Random, least: f64, most: f64) -> [f64; 2] {
    match random.integer(0, 7) {
        0 | 1 => [random.uniform(-12.0, 12.0), random.uniform(0.0, 12.0)],
        2 => polar(random.log_uniform(least, most), random.uniform(0.0, PI)),
        3 => {
            let x = random.uniform(0.0, 30.0);
            [random.signed(x), random.log_uniform(least, 1.0)]
        }
        4 => {
            let x = random.log_uniform(least, 1.0);
            [random.signed(x), random.uniform(0.0, 30.0)]
        }
        5 => ring(random, 5.0, 9.0),
        6 => {
            let (size, small) = (random.log_uniform(1.0, most), random.log_uniform(least, 1.0));
            if random.chance(0.5) {
                [random.signed(size), small]
            } else {
                [random.signed(small), size]
            }
        }
        _ => {
            let size = random.log_uniform(least, most.min(1e3));
            if random.chance(0.5) {
                [random.signed(size), 0.0]
            } else {
                [random.signed(0.0), size]
            }
        }
    }
}

fn upper_point(random: &mut Random, single: bool) -> [f64; 2] {
    if single {
        upper(random, 1e-37, 1e18).map(|x| neighbour_f32(x, 0))
    } else {
        upper(random, 1e-300, FARTHEST)
    }
}

/// Edges and recorded worst inputs that satisfy a condition, as rows.
fn fixed(single: bool, condition: impl Fn(&[f64; 2]) -> bool) -> Vec<f64> {
    let recorded = worst::recorded_for(&FUNCTIONS).into_iter().map(|row| [row[0], row[1]]);
    let all = edges().into_iter().chain(recorded);
    let rounded = all.map(|z| if single { z.map(|x| f64::from(x as f32)) } else { z });
    rounded
        .filter(|z| z.iter().all(|x| x.is_finite()) && condition(z))
        .flatten()
        .collect()
}

fn upper_mixture(seed: u64, n: usize, single: bool) -> Vec<f64> {
    let rows = fixed(single, |z| z[1] >= 0.0);
    fill(seed, n, 2, rows, |random, rows| {
        rows.extend(upper_point(random, single))
    })
}

fn lower_mixture(seed: u64, n: usize, single: bool) -> Vec<f64> {
    let largest: f64 = if single { 85.0 } else { 700.0 };
    // Where exp(-z^2) is finite, with room for the factor 2.
    let stays_finite = |[x, y]: [f64; 2]| (y.abs() - x.abs()) * (y.abs() + x.abs()) <= largest;
    let fits = |z: [f64; 2]| z[1] < 0.0 && stays_finite(z) && far_from_zeros(z);
    let below = fixed(single, |z| fits(*z));
    let mirrored = fixed(single, |z| fits([z[0], -z[1]]));
    let mirrored = mirrored.chunks(2).flat_map(|z| [z[0], -z[1]]);
    let rows = below.into_iter().chain(mirrored).collect();
    fill(seed, n, 2, rows, |random, rows| {
        loop {
            let [x, y] = upper_point(random, single);
            let y = if stays_finite([x, y]) {
                y
            } else {
                (x * x + random.uniform(0.0, largest)).sqrt()
            };
            let z = [x, -if single { neighbour_f32(y, 0) } else { y }];
            if fits(z) {
                rows.extend(z);
                return;
            }
        }
    })
}

fn whole_plane(seed: u64, n: usize) -> Vec<f64> {
    let rows = fixed(false, |_| true);
    fill(seed, n, 2, rows, |random, rows| {
        let [x, y] = upper(random, 1e-300, FARTHEST);
        let [x, y] = match random.integer(0, 3) {
            0 => [x, y],
            1 => [-y, x],
            2 => [-x, -y],
            _ => [y, -x],
        };
        let excess = x * x - y * y;
        if excess.abs() < 700.0 || random.chance(0.3) {
            rows.extend([x, y]);
        } else {
            let size = (x.abs().min(y.abs()).powi(2) + random.uniform(0.0, 700.0)).sqrt();
            rows.extend(if excess > 0.0 {
                [size.copysign(x), y]
            } else {
                [x, size.copysign(y)]
            });
        }
    })
}

/// Whether `z` below the real axis is more than about 0.1 from every zero of w. The zeros are those of log rho = 2 pi i k
/// with rho = 2 exp(-z^2)/w(-z), whose slope is about -2z.
pub fn far_from_zeros(z: [f64; 2]) -> bool {
    let [x, y] = [z[0].abs(), -z[1]];
    let size = x.hypot(y);
    if y <= 0.0 || size < 1.5 || x < 0.5 * y || y < 0.05 * x {
        return true;
    }
    if size > 1e8 {
        return (y / x - 1.0).abs() > 1e-6;
    }
    // w(-z) by five steps of Laplace's continued fraction, zeta = -z = -x + iy.
    let mut tail = [-x, y];
    for k in (1..=4).rev() {
        let scale = 0.5 * f64::from(k) / (tail[0] * tail[0] + tail[1] * tail[1]);
        tail = [-x - scale * tail[0], y + scale * tail[1]];
    }
    // w = (i/sqrt pi)/tail.
    let log_size = std::f64::consts::LN_2 + (y - x) * (y + x) + 0.5 * PI.ln() + tail[0].hypot(tail[1]).ln();
    let angle = 2.0 * x * y - FRAC_PI_2 + tail[1].atan2(tail[0]);
    let turns = angle / (2.0 * PI);
    let angle = 2.0 * PI * (turns - turns.round());
    log_size.hypot(angle) > 2.0 * size * 0.12
}

fn beside_zero(random: &mut Random, table: &[[[f64; 3]; 2]; 8], all_quadrants: bool) -> [f64; 2] {
    let [re, im] = random.pick(table).map(|part| part[0]);
    let (re, im) = (random.signed(re), if all_quadrants { random.signed(im) } else { im });
    let distance = random.log_uniform(1e-16, 0.1);
    let [dx, dy] = polar(distance, random.uniform(0.0, PI));
    let steps = random.integer(-1, 1);
    [
        neighbour(re + dx, steps),
        neighbour(im + random.signed(dy), random.integer(-1, 1)),
    ]
}

fn erfcx_line(seed: u64, n: usize) -> Vec<f64> {
    let recorded = worst::recorded_for(&["erfcx"]).into_iter().flatten();
    let rows = points::edges()
        .into_iter()
        .chain(recorded)
        .filter(|&x| x >= -26.0)
        .collect();
    fill(seed, n, 1, rows, |random, rows| {
        rows.push(match random.integer(0, 2) {
            0 => random.uniform(-26.0, 30.0),
            1 => random.log_uniform(1e-300, 1e300),
            _ => -random.log_uniform(1e-300, 26.0),
        });
    })
}

fn timing(random: &mut Random) -> [f64; 2] {
    let z = match random.integer(0, 3) {
        0 | 1 => [random.uniform(-6.0, 6.0), random.uniform(0.0, 6.0)],
        2 => polar(random.log_uniform(1e-3, 1e3), random.uniform(0.0, PI)),
        _ => [random.uniform(0.0, 12.0), random.log_uniform(1e-6, 1.0)],
    };
    z.map(|x| neighbour_f32(x, 0))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_lower_half_plane_leaves_out_the_zeros_of_w_and_little_else() {
        for zero in zeros::W {
            let [x, y] = zero.map(|part| part[0]);
            for k in 0..16 {
                let (sine, cosine) = (f64::from(k) * PI / 8.0).sin_cos();
                let around = |r: f64| [-x + r * cosine, y + r * sine];
                assert!(!far_from_zeros(around(0.08)), "{x} {y}");
                assert!(far_from_zeros(around(0.17)), "{x} {y}");
            }
        }
        assert!(
            (LOWER_HALF_PLANE.rows)(1, 4000)
                .chunks(2)
                .all(|z| z[1] < 0.0 && far_from_zeros([z[0], z[1]]))
        );
    }
}
