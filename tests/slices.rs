//! Slice functions give the bits of their scalars, at every level that the machine has.
#![cfg(feature = "simd")]

use iridescence::simd::{self, Level};
use iridescence::{Complex, shader, special};
use reference::generate::random::Random;

/// The machine's level and all that it includes.
fn levels() -> Vec<Level> {
    let best = Level::new();
    #[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
    let lower = [
        best.as_sse2().map(Level::Sse2),
        best.as_sse4_2().map(Level::Sse4_2),
        best.as_avx2().map(Level::Avx2),
        best.as_avx512().map(Level::Avx512),
    ];
    #[cfg(not(any(target_arch = "x86", target_arch = "x86_64")))]
    let lower: [Option<Level>; 0] = [];
    let levels: Vec<Level> = lower.into_iter().flatten().chain([Level::baseline(), best]).collect();
    println!("levels: {levels:?}");
    levels
}

const LENGTHS: [usize; 10] = [0, 1, 17, 63, 64, 65, 129, 511, 513, 1000];

/// Numbers of one kind: near the origin, far from it, both, with limits strewn in, random bits.
fn numbers(kind: usize, length: usize) -> Vec<f64> {
    let limits = [
        0.0,
        -0.0,
        f64::NAN,
        f64::INFINITY,
        f64::NEG_INFINITY,
        5e-324,
        f64::MAX,
        47.75,
        62.0,
        -1e17,
    ];
    let mut random = Random::new(kind as u64 + 100 * length as u64);
    (0..length)
        .map(|_| {
            let near = random.uniform(-47.0, 47.0);
            let size = random.log_uniform(48.0, 1e6);
            let far = random.signed(size);
            let limit = random.pick(&limits);
            match kind {
                0 => near,
                1 => far,
                2 => random.pick(&[near, far]),
                3 => random.pick(&[near, far, limit]),
                _ => f64::from_bits(random.bits()),
            }
        })
        .collect()
}

/// The same; of the mixed kinds every third number is as small as the least normal ones.
fn some_tiny(kind: usize, length: usize) -> Vec<f64> {
    let shrink = |(i, x): (usize, f64)| match kind {
        2 | 3 if i % 3 == 0 => x * f64::MIN_POSITIVE,
        _ => x,
    };
    numbers(kind, length).into_iter().enumerate().map(shrink).collect()
}

/// The same as [`numbers`] for f32, with patterns of its own for random bits.
fn singles(kind: usize, length: usize) -> Vec<f32> {
    let mut random = Random::new(7 + kind as u64 + 100 * length as u64);
    let wide = numbers(kind, length);
    wide.into_iter()
        .map(|x| {
            if kind == 4 {
                f32::from_bits(random.bits() as u32)
            } else {
                x as f32
            }
        })
        .collect()
}

fn pairs(kind: usize, length: usize) -> Vec<[f32; 2]> {
    let ends = singles(kind, 2 * length);
    ends.as_chunks::<2>().0.to_vec()
}

/// Points of the plane: of the upper half plane, of all of it, with limits strewn in, random bits. In the half plane
/// around the origin every border between two regions is crossed.
fn points(kind: usize, length: usize) -> Vec<Complex<f64>> {
    let mut random = Random::new(11 + kind as u64 + 100 * length as u64);
    let coordinates = numbers(kind, 2 * length);
    let strewn = coordinates.as_chunks::<2>().0.iter().map(|&[x, y]| {
        let size = random.log_uniform(1e-3, 1e3);
        let (sine, cosine) = random.uniform(0.0, std::f64::consts::PI).sin_cos();
        let above = [
            size * cosine,
            random.pick(&[size * sine, 1e-3 * sine, 1e-12 * sine, 0.0]),
        ];
        let near = [above[0], random.signed(above[1])];
        let [x, y] = match kind {
            0 => above,
            1 => random.pick(&[above, [x, y.abs()]]),
            2 => random.pick(&[near, near, [above[0], 1e200 * (above[1] + 1e-3)]]),
            3 => random.pick(&[near, above, [x, y], [x, above[1]], [above[0], y]]),
            _ => random.pick(&[[x, y], [x, y.abs()]]),
        };
        Complex::new(x, y)
    });
    strewn.collect()
}

fn single_points(kind: usize, length: usize) -> Vec<Complex<f32>> {
    if kind == 4 {
        let parts = singles(kind, 2 * length);
        return parts
            .as_chunks::<2>()
            .0
            .iter()
            .map(|&[x, y]| Complex::new(x, y))
            .collect();
    }
    points(kind, length)
        .into_iter()
        .map(|z| Complex::new(z.re as f32, z.im as f32))
        .collect()
}

/// Rows of two ends and b: ends near the origin, segments short and long.
fn single_rows(kind: usize, length: usize) -> Vec<[f32; 3]> {
    let mut random = Random::new(13 + kind as u64 + 100 * length as u64);
    let numbers = singles(kind, 3 * length);
    let rows = numbers.as_chunks::<3>().0.iter().map(|&row| {
        let start = random.uniform(-5.0, 5.0);
        let end = start + random.log_uniform(1e-6, 10.0);
        let b = random.log_uniform(1e-3, 1e3);
        let near = [start, end, random.signed(b)].map(|x| x as f32);
        if kind < 2 {
            near
        } else {
            random.pick(&[near, row, [row[0], near[1], near[2]]])
        }
    });
    rows.collect()
}

/// Bits of a result, one pattern for every NaN: no operation promises the bits of a NaN.
trait Bits: Copy {
    fn pattern(self) -> [u64; 2];
    const FILLED: Self;
}

impl Bits for f64 {
    fn pattern(self) -> [u64; 2] {
        [if self.is_nan() { u64::MAX } else { self.to_bits() }, 0]
    }
    const FILLED: f64 = -77.0;
}

impl Bits for f32 {
    fn pattern(self) -> [u64; 2] {
        let bits = if self.is_nan() {
            u64::MAX
        } else {
            u64::from(self.to_bits())
        };
        [bits, 0]
    }
    const FILLED: f32 = -77.0;
}

impl<T: Bits> Bits for Complex<T> {
    fn pattern(self) -> [u64; 2] {
        [self.re.pattern()[0], self.im.pattern()[0]]
    }
    const FILLED: Complex<T> = Complex {
        re: T::FILLED,
        im: T::FILLED,
    };
}

/// Holds a slice function to its scalar at every level, with slices of equal and of unequal length.
fn check<X: Copy + std::fmt::Debug, Y: Bits>(
    name: &str,
    inputs: fn(usize, usize) -> Vec<X>,
    scalar: impl Fn(X) -> Y,
    plain: fn(&[X], &mut [Y]),
    at: fn(Level, &[X], &mut [Y]),
) {
    let levels = levels();
    for length in LENGTHS {
        for kind in 0..5 {
            let x = inputs(kind, length);
            let expected: Vec<[u64; 2]> = x.iter().map(|&x| scalar(x).pattern()).collect();
            for room in [length, length / 2, length + 70] {
                let counted = length.min(room);
                let hold = |out: &[Y], level: &str| {
                    for (i, y) in out.iter().enumerate() {
                        let due = if i < counted { expected[i] } else { Y::FILLED.pattern() };
                        assert_eq!(
                            y.pattern(),
                            due,
                            "{name} at {level}, kind {kind}, {i} of {length} ({room})"
                        );
                    }
                };
                let mut out = vec![Y::FILLED; room];
                plain(&x, &mut out);
                hold(&out, "the plain call");
                for &level in &levels {
                    let mut out = vec![Y::FILLED; room];
                    at(level, &x, &mut out);
                    hold(&out, &format!("{level:?}"));
                }
            }
        }
    }
}

#[test]
fn the_f64_sine_integral_has_the_bits_of_its_scalar_at_every_level() {
    check(
        "sine_integral",
        numbers,
        special::sine_integral,
        simd::sine_integral,
        simd::sine_integral_at,
    );
}

#[test]
fn erf_has_the_bits_of_its_scalar_at_every_level() {
    check("erf", some_tiny, special::erf, simd::erf, simd::erf_at);
}

#[test]
fn the_f64_faddeeva_functions_have_the_bits_of_their_scalars_at_every_level() {
    use simd::*;
    check("faddeeva_w", points, special::faddeeva_w, faddeeva_w, faddeeva_w_at);
    check(
        "fine",
        points,
        special::faddeeva_w_fine,
        faddeeva_w_fine,
        faddeeva_w_fine_at,
    );
    check(
        "medium",
        points,
        special::faddeeva_w_medium,
        faddeeva_w_medium,
        faddeeva_w_medium_at,
    );
    check(
        "coarse",
        points,
        special::faddeeva_w_coarse,
        faddeeva_w_coarse,
        faddeeva_w_coarse_at,
    );
}

#[test]
fn the_f32_complex_functions_have_the_bits_of_their_scalars_at_every_level() {
    use simd::shader::*;
    let complex = |z: shader::Complex| Complex::new(z.re, z.im);
    check(
        "faddeeva_w",
        single_points,
        |z| complex(shader::faddeeva_w(z.re, z.im)),
        faddeeva_w,
        faddeeva_w_at,
    );
    check(
        "coarse",
        single_points,
        |z| complex(shader::faddeeva_w_coarse(z.re, z.im)),
        faddeeva_w_coarse,
        faddeeva_w_coarse_at,
    );
    check(
        "erf_difference_scaled",
        single_rows,
        |[from, to, b]| complex(shader::erf_difference_scaled(from, to, b)),
        erf_difference_scaled,
        erf_difference_scaled_at,
    );
}

#[test]
fn the_scaled_bessel_functions_have_the_bits_of_their_scalars_at_every_level() {
    check(
        "bessel_i0_scaled",
        numbers,
        special::bessel_i0_scaled,
        simd::bessel_i0_scaled,
        simd::bessel_i0_scaled_at,
    );
    check(
        "bessel_i0_scaled",
        singles,
        shader::bessel_i0_scaled,
        simd::shader::bessel_i0_scaled,
        simd::shader::bessel_i0_scaled_at,
    );
}

#[test]
fn the_f32_sine_integrals_have_the_bits_of_their_scalars_at_every_level() {
    use simd::shader::*;
    check(
        "sine_integral",
        singles,
        shader::sine_integral,
        sine_integral,
        sine_integral_at,
    );
    check(
        "medium",
        singles,
        shader::sine_integral_medium,
        sine_integral_medium,
        sine_integral_medium_at,
    );
    check(
        "coarse",
        singles,
        shader::sine_integral_coarse,
        sine_integral_coarse,
        sine_integral_coarse_at,
    );
    check(
        "velinov",
        singles,
        shader::sine_integral_velinov,
        sine_integral_velinov,
        sine_integral_velinov_at,
    );
}

#[test]
fn the_f32_arcs_have_the_bits_of_their_scalars_at_every_level() {
    use shader::{
        sinc_squared_integral as accurate, sinc_squared_integral_coarse as coarse,
        sinc_squared_integral_medium as medium, sinc_squared_integral_velinov as velinov,
    };
    use simd::shader::*;
    check(
        "accurate",
        pairs,
        |[a, b]| accurate(a, b),
        sinc_squared_integral,
        sinc_squared_integral_at,
    );
    check(
        "medium",
        pairs,
        |[a, b]| medium(a, b),
        sinc_squared_integral_medium,
        sinc_squared_integral_medium_at,
    );
    check(
        "coarse",
        pairs,
        |[a, b]| coarse(a, b),
        sinc_squared_integral_coarse,
        sinc_squared_integral_coarse_at,
    );
    check(
        "velinov",
        pairs,
        |[a, b]| velinov(a, b),
        sinc_squared_integral_velinov,
        sinc_squared_integral_velinov_at,
    );
}

#[test]
fn every_slice_function_of_the_source_is_held_here() {
    let source = include_str!("../src/simd.rs");
    let defined =
        source.matches("slice_function! {\n    ///").count() + source.matches("slice_function! {\n        ///").count();
    let text: String = include_str!("slices.rs")
        .chars()
        .filter(|c| !c.is_whitespace())
        .collect();
    let held = text.matches("check(\"").count();
    assert_eq!(defined, held);
}
