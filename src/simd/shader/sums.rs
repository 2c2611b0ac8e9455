//! Sums over scratches, for a few wavelengths at once.
//!
//! The rows are read and turned into columns once for all wavelengths. A sum has its terms in a fixed order, whatever the
//! level: row k belongs to the partial sum k mod 16, and the partial sums are added in pairs. The sum over no scratches
//! is 0.

use crate::shader;
use crate::simd::Level;
use fearless_simd::{Simd, dispatch};
use num_complex::Complex;

/// Partial sums.
const LANES: usize = 16;

/// The partial sums' sum, in pairs.
#[inline(always)]
fn folded(mut lanes: [f32; LANES]) -> f32 {
    let mut half = LANES / 2;
    while half > 0 {
        for k in 0..half {
            lanes[k] += lanes[k + half];
        }
        half /= 2;
    }
    lanes[0]
}

/// Returns the sum of a complex function of row and wavelength over all rows, for each wavelength.
#[inline(always)]
fn sums<const N: usize, const C: usize>(
    scratches: &[[f32; C]],
    wavelengths: [f32; N],
    value: impl Fn([f32; C], f32) -> [f32; 2],
) -> [[f32; 2]; N] {
    let (mut re, mut im) = ([[0.0; LANES]; N], [[0.0; LANES]; N]);
    let (blocks, rest) = scratches.as_chunks::<LANES>();
    // Columns, so that a column is a vector.
    let mut add = |columns: &[[f32; LANES]; C], count: usize| {
        let (mut block_re, mut block_im) = ([[0.0; LANES]; N], [[0.0; LANES]; N]);
        // One wavelength at a time: a loop over rows alone becomes vectors.
        for n in 0..N {
            for k in 0..LANES {
                let row: [f32; C] = core::array::from_fn(
                    #[inline(always)]
                    |c| columns[c][k],
                );
                [block_re[n][k], block_im[n][k]] = value(row, wavelengths[n]);
            }
        }
        for n in 0..N {
            for k in 0..count {
                re[n][k] += block_re[n][k];
                im[n][k] += block_im[n][k];
            }
        }
    };
    let mut columns = [[0.0; LANES]; C];
    for block in blocks {
        for (k, row) in block.iter().enumerate() {
            for c in 0..C {
                columns[c][k] = row[c];
            }
        }
        add(&columns, LANES);
    }
    if !rest.is_empty() {
        for (k, row) in rest.iter().enumerate() {
            for c in 0..C {
                columns[c][k] = row[c];
            }
        }
        add(&columns, rest.len());
    }
    core::array::from_fn(
        #[inline(always)]
        |n| [folded(re[n]), folded(im[n])],
    )
}

/// Returns the sum of [`shader::scratch_squared`] over scratches for each wavelength: the incoherent sum.
///
/// Radius of the coherence window; rows width, depth, xi_t, xi_b, gamma_sum, mean; up to about four wavelengths, in the
/// unit of the lengths. A row that is not a number makes every sum NaN.
#[must_use]
pub fn scratch_squared_sums<const N: usize>(radius: f32, scratches: &[[f32; 6]], wavelengths: [f32; N]) -> [f32; N] {
    scratch_squared_sums_at(Level::new(), radius, scratches, wavelengths)
}

/// [`scratch_squared_sums`] at a given level.
#[must_use]
pub fn scratch_squared_sums_at<const N: usize>(
    level: Level,
    radius: f32,
    scratches: &[[f32; 6]],
    wavelengths: [f32; N],
) -> [f32; N] {
    #[inline(always)]
    fn evaluate<S: Simd, const N: usize>(_: S, radius: f32, scratches: &[[f32; 6]], wavelengths: [f32; N]) -> [f32; N] {
        sums(
            scratches,
            wavelengths,
            #[inline(always)]
            |[width, depth, xi_t, xi_b, gamma, mean], wavelength| {
                [
                    shader::scratch_squared(radius, wavelength, width, depth, xi_t, xi_b, gamma, mean),
                    0.0,
                ]
            },
        )
        .map(|[re, _]| re)
    }
    dispatch!(level, simd => evaluate(simd, radius, scratches, wavelengths))
}

/// Returns the sum of S = [`shader::profile_rectangle`] times [`shader::spatial_phase_infinite`] over scratches for each
/// wavelength: the coherent sum.
///
/// Radius of the coherence window; rows width, depth, xi_t, xi_b, gamma_sum, s_b, in each scratch's own frame; up to about
/// four wavelengths, in the unit of the lengths. A row that is not a number makes every sum NaN.
#[must_use]
pub fn scratch_sums<const N: usize>(radius: f32, scratches: &[[f32; 6]], wavelengths: [f32; N]) -> [Complex<f32>; N] {
    scratch_sums_at(Level::new(), radius, scratches, wavelengths)
}

/// [`scratch_sums`] at a given level.
#[must_use]
pub fn scratch_sums_at<const N: usize>(
    level: Level,
    radius: f32,
    scratches: &[[f32; 6]],
    wavelengths: [f32; N],
) -> [Complex<f32>; N] {
    #[inline(always)]
    fn evaluate<S: Simd, const N: usize>(
        _: S,
        radius: f32,
        scratches: &[[f32; 6]],
        wavelengths: [f32; N],
    ) -> [Complex<f32>; N] {
        sums(
            scratches,
            wavelengths,
            #[inline(always)]
            |[width, depth, xi_t, xi_b, gamma, s_b], wavelength| {
                let profile = shader::profile_rectangle(width, depth, xi_b, gamma, wavelength);
                let eta = shader::spatial_phase_infinite(radius, wavelength, xi_t, xi_b, s_b);
                [
                    profile.re * eta.re - profile.im * eta.im,
                    profile.re * eta.im + profile.im * eta.re,
                ]
            },
        )
        .map(|[re, im]| Complex { re, im })
    }
    dispatch!(level, simd => evaluate(simd, radius, scratches, wavelengths))
}
