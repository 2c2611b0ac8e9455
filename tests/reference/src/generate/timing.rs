//! Inputs of all timings, in `report` and in the criterion benches: real ones, all f32 numbers, so that both precisions
//! see the same values.

use super::random::Random;
use super::{Generator, complex_points, erf_differences, points};

/// Number of rows: small enough to stay in the first-level cache, large enough to defeat a branch predictor's memory.
pub const ROWS: usize = 4096;

const SEED: u64 = 0x5eed;

/// The rows on which methods of a domain are timed. One column: half uniform in (0, 60), half log-uniform in 1e-3..1e5,
/// in random order. Two columns: scratch arcs, a start in -500..500 and a log-uniform length in 1e-6..1e3 that ends
/// within 500. More columns: finite rows of the domain itself, of moderate size. Complex points, erf differences and the
/// Bessel line have timing sets of their own.
pub fn rows(domain: &Generator) -> Vec<f64> {
    let own = [
        ("complex_", complex_points::TIMING),
        ("erf_difference_", erf_differences::SCRATCH_F32),
        ("bessel_", points::BESSEL_LINE_F32),
    ];
    if let Some((_, set)) = own.iter().find(|(prefix, _)| domain.name.starts_with(prefix)) {
        return (set.rows)(SEED, ROWS);
    }
    let mut random = Random::new(SEED);
    let single = |x: f64| f64::from(x as f32);
    let mut rows = Vec::with_capacity(ROWS * domain.columns);
    match domain.columns {
        1 => rows.extend((0..ROWS).map(|_| {
            let wide = random.chance(0.5);
            single(if wide {
                random.log_uniform(1e-3, 1e5)
            } else {
                random.uniform(0.0, 60.0)
            })
        })),
        2 => {
            while rows.len() < 2 * ROWS {
                let start = random.uniform(-500.0, 500.0);
                let end = start + random.log_uniform(1e-6, 1e3);
                if end <= 500.0 {
                    rows.extend([single(start), single(end)]);
                }
            }
        }
        columns => {
            let moderate = |row: &&[f64]| row.iter().all(|x| x.is_finite() && x.abs() < 1e30);
            let drawn = (domain.rows)(SEED, 4 * ROWS);
            rows.extend(
                drawn
                    .chunks_exact(columns)
                    .filter(moderate)
                    .take(ROWS)
                    .flatten()
                    .map(|&x| single(x)),
            );
        }
    }
    rows
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::generate::arcs;

    #[test]
    fn inputs_are_f32_numbers_inside_their_ranges() {
        let one = rows(&points::REAL_F64);
        assert_eq!(one.len(), ROWS);
        assert!(
            one.iter()
                .all(|&x| (0.0..=1e5).contains(&x) && f64::from(x as f32) == x)
        );
        assert!(one.iter().any(|&x| x > 60.0) && one.iter().any(|&x| x < 0.01));
        let two = rows(&arcs::ARC_F64);
        assert_eq!(two.len(), 2 * ROWS);
        assert!(
            two.chunks_exact(2)
                .all(|r| r[0] <= r[1] && r[0] >= -500.0 && r[1] <= 500.0)
        );
        let complex = rows(&complex_points::ZEROS_OF_W);
        assert_eq!(complex.len(), 2 * ROWS);
        assert!(complex.iter().all(|&x| x.abs() <= 1e3 && f64::from(x as f32) == x));
        assert!(complex.chunks_exact(2).all(|z| z[1] >= 0.0));
        let differences = rows(&erf_differences::ANY);
        assert_eq!(differences.len(), 3 * ROWS);
        assert!(differences.chunks_exact(3).all(|r| r[0] <= r[1] && r[2].abs() < 1400.0));
        let bessel = rows(&points::BESSEL_LINE);
        assert_eq!(bessel.len(), ROWS);
        assert!(bessel.iter().all(|&x| (0.0..=1e5).contains(&x)) && bessel.iter().any(|&x| x > 60.0));
    }
}
