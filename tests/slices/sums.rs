//! Sums over scratches: their order, their bits at every level, the scalars that they add.

use crate::check::{Bits, levels};
use iridescence::simd::shader::{scratch_squared_sums, scratch_squared_sums_at, scratch_sums, scratch_sums_at};
use iridescence::{Complex, shader};
use reference::generate::random::Random;

const RADIUS: f32 = 30.0;
const WAVELENGTHS: [f32; 3] = [0.46, 0.54, 0.61];

/// Rows width, depth, xi_t, xi_b, gamma_sum, then the mean over a footprint or the offset.
fn scratches(random: &mut Random, length: usize, last: [f64; 2]) -> Vec<[f32; 6]> {
    let row = |_| {
        [
            random.log_uniform(0.1, 10.0),
            random.uniform(-1.0, 1.0),
            random.uniform(-0.01, 0.01),
            random.uniform(-2.0, 2.0),
            random.uniform(0.0, 2.0),
            random.uniform(last[0], last[1]),
        ]
        .map(|x| x as f32)
    };
    (0..length).map(row).collect()
}

/// Row k into the partial sum k mod 16, the partial sums in pairs.
fn in_order(terms: &[f32]) -> f32 {
    let mut lanes = [0.0f32; 16];
    for (k, term) in terms.iter().enumerate() {
        lanes[k % 16] += term;
    }
    for half in [8, 4, 2, 1] {
        for k in 0..half {
            lanes[k] += lanes[k + half];
        }
    }
    lanes[0]
}

fn squared([width, depth, xi_t, xi_b, gamma, mean]: [f32; 6], wavelength: f32) -> f32 {
    shader::scratch_squared(RADIUS, wavelength, width, depth, xi_t, xi_b, gamma, mean)
}

fn response([width, depth, xi_t, xi_b, gamma, s_b]: [f32; 6], wavelength: f32) -> [f32; 2] {
    let profile = shader::profile_rectangle(width, depth, xi_b, gamma, wavelength);
    let eta = shader::spatial_phase_infinite(RADIUS, wavelength, xi_t, xi_b, s_b);
    [
        profile.re * eta.re - profile.im * eta.im,
        profile.re * eta.im + profile.im * eta.re,
    ]
}

#[test]
fn both_sums_have_the_bits_of_the_scalars_added_in_the_stated_order_at_every_level() {
    let mut random = Random::new(61);
    for length in [0, 1, 15, 16, 17, 31, 33, 64, 100, 1000] {
        let squares = scratches(&mut random, length, [0.0, 1.0]);
        let fields = scratches(&mut random, length, [-80.0, 80.0]);
        let due = WAVELENGTHS.map(|l| {
            let terms: Vec<f32> = squares.iter().map(|&row| squared(row, l)).collect();
            in_order(&terms)
        });
        let due_fields = WAVELENGTHS.map(|l| {
            let terms: Vec<[f32; 2]> = fields.iter().map(|&row| response(row, l)).collect();
            let part = |k: usize| in_order(&terms.iter().map(|t| t[k]).collect::<Vec<_>>());
            Complex::new(part(0), part(1))
        });
        let hold = |found: [f32; 3], found_fields: [Complex<f32>; 3], level: &str| {
            assert_eq!(found.map(Bits::pattern), due.map(Bits::pattern), "{length} at {level}");
            assert_eq!(
                found_fields.map(Bits::pattern),
                due_fields.map(Bits::pattern),
                "{length} fields at {level}"
            );
        };
        hold(
            scratch_squared_sums(RADIUS, &squares, WAVELENGTHS),
            scratch_sums(RADIUS, &fields, WAVELENGTHS),
            "the plain call",
        );
        for level in levels() {
            hold(
                scratch_squared_sums_at(level, RADIUS, &squares, WAVELENGTHS),
                scratch_sums_at(level, RADIUS, &fields, WAVELENGTHS),
                &format!("{level:?}"),
            );
        }
        if length > 0 {
            assert!(due[0] > 0.0 && due_fields[0].norm() > 0.0);
        }
    }
}

#[test]
fn a_row_that_is_not_a_number_makes_every_sum_nan() {
    let mut random = Random::new(62);
    for place in [0, 15, 16, 36] {
        let mut rows = scratches(&mut random, 37, [0.0, 1.0]);
        rows[place][1] = f32::NAN;
        assert!(
            scratch_squared_sums(RADIUS, &rows, WAVELENGTHS)
                .iter()
                .all(|x| x.is_nan())
        );
        let sums = scratch_sums(RADIUS, &rows, WAVELENGTHS);
        assert!(sums.iter().all(|z| z.re.is_nan() && z.im.is_nan()));
    }
}

#[test]
fn the_coherent_sum_of_one_scratch_is_the_incoherent_one_squared() {
    let mut random = Random::new(63);
    for _ in 0..1000 {
        let mut row = scratches(&mut random, 1, [-40.0, 40.0]);
        let field = scratch_sums(RADIUS, &row, WAVELENGTHS);
        row[0][5] = (-(row[0][5] / RADIUS).powi(2)).exp();
        let squared = scratch_squared_sums(RADIUS, &row, WAVELENGTHS);
        let peak = 8.0 * std::f32::consts::PI * (row[0][0] * RADIUS).powi(2);
        for (z, s) in field.iter().zip(squared) {
            assert!((z.norm_sqr() - s).abs() <= 3e-6 * peak, "{row:?}: {z} {s}");
        }
    }
}
