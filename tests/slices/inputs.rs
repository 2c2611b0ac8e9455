//! Rows of every kind: of a scene, far from it, limits, random bits.

use iridescence::Complex;
use reference::generate::random::Random;

/// Numbers of one kind: near the origin, far from it, both, with limits strewn in, random bits.
pub fn numbers(kind: usize, length: usize) -> Vec<f64> {
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
pub fn some_tiny(kind: usize, length: usize) -> Vec<f64> {
    let shrink = |(i, x): (usize, f64)| match kind {
        2 | 3 if i % 3 == 0 => x * f64::MIN_POSITIVE,
        _ => x,
    };
    numbers(kind, length).into_iter().enumerate().map(shrink).collect()
}

/// The same as [`numbers`] for f32, with patterns of its own for random bits.
pub fn singles(kind: usize, length: usize) -> Vec<f32> {
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

pub fn pairs(kind: usize, length: usize) -> Vec<[f32; 2]> {
    let ends = singles(kind, 2 * length);
    ends.as_chunks::<2>().0.to_vec()
}

/// Points of the plane: of the upper half plane, of all of it, with limits strewn in, random bits. In the half plane
/// around the origin every border between two regions is crossed.
pub fn points(kind: usize, length: usize) -> Vec<Complex<f64>> {
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

pub fn single_points(kind: usize, length: usize) -> Vec<Complex<f32>> {
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
pub fn single_rows(kind: usize, length: usize) -> Vec<[f32; 3]> {
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

/// Half widths and edges: centres within the ellipse and outside, numbers of every kind strewn in.
pub fn footprint_rows(kind: usize, length: usize) -> Vec<[f32; 2]> {
    let mut random = Random::new(19 + kind as u64 + 100 * length as u64);
    let strewn = pairs(kind, length);
    let rows = strewn.into_iter().map(|strange| {
        let half_width = random.log_uniform(1e-3, 1e4);
        let edge = random.uniform(-6.0, half_width + 1.0);
        if kind < 2 || (kind < 4 && random.chance(0.8)) {
            [half_width, edge].map(|x| x as f32)
        } else {
            strange
        }
    });
    rows.collect()
}

/// Rows of a scratch: lengths of a scene, with numbers of every kind strewn in.
pub fn scratch_rows<const N: usize>(kind: usize, length: usize) -> Vec<[f32; N]> {
    let mut random = Random::new(17 + kind as u64 + 100 * length as u64);
    let strewn = singles(kind, N * length);
    let rows = strewn.as_chunks::<N>().0.iter().map(|&strange| {
        let mut row = strange;
        for (k, x) in row.iter_mut().enumerate() {
            let size = random.log_uniform(1e-3, 60.0);
            let scene = [
                size,
                random.uniform(0.36, 0.83),
                random.uniform(-2.0, 2.0),
                random.signed(size),
            ];
            let usual = scene[if N == 8 {
                [0, 1, 2, 2, 3, 3, 3, 3][k]
            } else {
                [0, 3, 2, 2, 1][k]
            }] as f32;
            if kind < 2 || (kind < 4 && random.chance(0.9)) {
                *x = usual;
            }
        }
        row
    });
    rows.collect()
}

/// Rows of an infinite scratch: radius, wavelength, xi_t within the core, xi_b, s_b.
pub fn infinite_rows(kind: usize, length: usize) -> Vec<[f32; 5]> {
    let mut random = Random::new(23 + kind as u64 + 100 * length as u64);
    let strewn = singles(kind, 5 * length);
    let rows = strewn.as_chunks::<5>().0.iter().map(|&strange| {
        let scene = [
            random.uniform(5.0, 60.0),
            random.uniform(0.36, 0.83),
            random.uniform(-0.02, 0.02),
            random.uniform(-2.0, 2.0),
            random.uniform(-100.0, 100.0),
        ];
        core::array::from_fn(|k| {
            if kind < 2 || (kind < 4 && random.chance(0.9)) {
                scene[k] as f32
            } else {
                strange[k]
            }
        })
    });
    rows.collect()
}
