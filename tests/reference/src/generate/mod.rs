//! Input generators: deterministic in their seed, rows of f64 in row-major order.
//!
//! A generator for an f32 method gives f32 values. Every mixture begins with its fixed rows (edges, borders and the worst
//! inputs recorded in `data/worst`), as long as at least as many random rows follow.

pub mod arcs;
pub mod complex_points;
pub mod erf_differences;
pub mod footprints;
pub mod lights;
pub mod points;
pub mod random;
pub mod scratches;
pub mod surfaces;
pub mod timing;
pub mod worst;

use random::Random;

/// A named set of inputs.
#[derive(Clone, Copy)]
pub struct Generator {
    /// Short name.
    pub name: &'static str,
    /// The domain in words, for the ledger.
    pub domain: &'static str,
    /// Numbers in a row.
    pub columns: usize,
    /// `n` rows for a seed, row after row.
    pub rows: fn(seed: u64, n: usize) -> Vec<f64>,
}

/// All generators. Those of the spatial phase give infinite ends, all others finite numbers.
pub fn all() -> &'static [Generator] {
    &[
        points::REAL_F64,
        points::REAL_F32,
        points::UNIFORM_60,
        points::UNIFORM_60_F32,
        points::ANGLES_F32,
        points::EXPONENTS_F32,
        points::LOG_UNIFORM,
        points::NEAR_ZEROS,
        points::NEAR_BORDERS,
        points::BIT_PATTERNS,
        arcs::ARC_F64,
        arcs::ARC_UNIFORM_60,
        arcs::ARC_WIDE,
        arcs::ARC_SHORT,
        arcs::ARC_AT_ZEROS,
        arcs::ARC_TAIL,
        arcs::ARC_STRADDLING,
        arcs::SCRATCH_F32,
        arcs::SCRATCH_UNIFORM_F32,
        arcs::SCRATCH_TURNS_F32,
        points::BESSEL_LINE,
        points::BESSEL_LINE_F32,
        complex_points::UPPER_HALF_PLANE,
        complex_points::UPPER_HALF_PLANE_F32,
        complex_points::LOWER_HALF_PLANE,
        complex_points::LOWER_HALF_PLANE_F32,
        complex_points::WHOLE_PLANE,
        complex_points::ZEROS_OF_W,
        complex_points::ZEROS_OF_ERF,
        complex_points::FIRST_QUADRANT,
        complex_points::NEAR_REAL_AXIS,
        complex_points::NEAR_IMAGINARY_AXIS,
        complex_points::UPPER_TAIL,
        complex_points::RING,
        complex_points::REAL_LINE,
        complex_points::ERFCX_LINE,
        complex_points::TIMING,
        erf_differences::SCRATCH,
        erf_differences::SCRATCH_F32,
        erf_differences::ANY,
        erf_differences::SHORT,
        scratches::SPATIAL_PHASE,
        scratches::SPATIAL_PHASE_F32,
        scratches::PROFILE,
        scratches::PROFILE_F32,
        scratches::TRIANGLE_POLES,
        scratches::SEGMENT_ENERGY,
        footprints::FOOTPRINT,
        footprints::FOOTPRINT_REDUCED,
        footprints::FOOTPRINT_REDUCED_F32,
        surfaces::INFINITE_PHASE,
        surfaces::INFINITE_PHASE_F32,
        surfaces::DEPTH,
        surfaces::DEPTH_F32,
        surfaces::BASE,
        surfaces::BASE_F32,
        surfaces::SCRATCH,
        surfaces::SCRATCH_F32,
        surfaces::WINDOWED,
        surfaces::DENSITY,
        surfaces::DENSITY_F32,
        surfaces::CONE,
        surfaces::GAUSSIAN_U,
        surfaces::GAUSSIAN_U_F32,
        lights::SPHERE,
        lights::SPHERE_F32,
        lights::QUAD,
        lights::QUAD_F32,
        lights::QUAD_CHORD,
        lights::QUAD_CHORD_F32,
    ]
}

/// `n` rows: the fixed ones (a random half share of them where n is small), then sampled ones.
fn fill(
    seed: u64,
    n: usize,
    columns: usize,
    fixed: Vec<f64>,
    mut sample: impl FnMut(&mut Random, &mut Vec<f64>),
) -> Vec<f64> {
    let mut random = Random::new(seed);
    let mut rows = Vec::with_capacity(n * columns);
    let count = fixed.len() / columns;
    if 2 * count <= n {
        rows.extend_from_slice(&fixed);
    } else {
        for _ in 0..n / 2 {
            let k = random.integer(0, count as i64 - 1) as usize;
            rows.extend_from_slice(&fixed[k * columns..(k + 1) * columns]);
        }
    }
    while rows.len() < n * columns {
        sample(&mut random, &mut rows);
    }
    rows
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_generator_gives_the_rows_asked_for_and_repeats_itself() {
        for generator in all() {
            for n in [0, 1, 7, 5000] {
                let rows = (generator.rows)(3, n);
                assert_eq!(rows.len(), n * generator.columns, "{}", generator.name);
                let ends = ["spatial_phase", "spatial_phase_f32"].contains(&generator.name);
                assert!(
                    rows.iter().all(|x| x.is_finite() || ends && x.is_infinite()),
                    "{}",
                    generator.name
                );
                let again: Vec<u64> = (generator.rows)(3, n).iter().map(|x| x.to_bits()).collect();
                assert!(rows.iter().map(|x| x.to_bits()).eq(again), "{}", generator.name);
            }
            assert_ne!(
                (generator.rows)(3, 5000),
                (generator.rows)(4, 5000),
                "{}",
                generator.name
            );
        }
    }

    #[test]
    fn f32_generators_give_f32_values() {
        for generator in all().iter().filter(|g| g.name.ends_with("f32")) {
            let rows = (generator.rows)(5, 20_000);
            assert!(rows.iter().all(|&x| f64::from(x as f32) == x), "{}", generator.name);
        }
    }

    #[test]
    fn the_mixtures_hold_signed_zeros_subnormals_and_the_largest_number() {
        let rows = (points::REAL_F64.rows)(1, 2000);
        for x in [0.0, -0.0, 5e-324, f64::MAX, -f64::MAX, f64::MIN_POSITIVE] {
            assert!(rows.iter().any(|y| y.to_bits() == x.to_bits()), "{x:e}");
        }
        let rows = (points::REAL_F32.rows)(1, 2000);
        for x in [f32::MAX, f32::from_bits(1), f32::MIN_POSITIVE, -0.0] {
            assert!(rows.iter().any(|y| y.to_bits() == f64::from(x).to_bits()), "{x:e}");
        }
    }
}
