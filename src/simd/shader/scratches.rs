//! Slices of scratches and their footprints.

use super::{complex, complex_rows, rows};
use crate::shader;
use crate::simd::BLOCK;
use fearless_simd::{Simd, dispatch};
use num_complex::Complex;

slice_function! {
    /// Writes [`shader::profile_rectangle`] of each row width, depth, xi_b, gamma_sum, wavelength.
    profile_rectangle, profile_rectangle_at, [f32; 5] => Complex<f32>,
    |block| complex_rows(
        block,
        #[inline(always)]
        |[width, depth, xi, gamma, wavelength]| shader::profile_rectangle(width, depth, xi, gamma, wavelength),
    ),
    |[width, depth, xi, gamma, wavelength]| complex(shader::profile_rectangle(width, depth, xi, gamma, wavelength))
}
slice_function! {
    /// Writes [`shader::profile_triangle`] of each row width, depth, xi_b, gamma_sum, wavelength.
    profile_triangle, profile_triangle_at, [f32; 5] => Complex<f32>,
    |block| complex_rows(
        block,
        #[inline(always)]
        |[width, depth, xi, gamma, wavelength]| shader::profile_triangle(width, depth, xi, gamma, wavelength),
    ),
    |[width, depth, xi, gamma, wavelength]| complex(shader::profile_triangle(width, depth, xi, gamma, wavelength))
}
slice_function! {
    /// Writes [`shader::spatial_phase`] of each row radius, wavelength, xi_t, xi_b, s_t, s_b, l_from, l_to.
    spatial_phase, spatial_phase_at, [f32; 8] => Complex<f32>,
    |block| complex_rows(
        block,
        #[inline(always)]
        |[radius, wavelength, xi_t, xi_b, s_t, s_b, from, to]| shader::spatial_phase(radius, wavelength, xi_t, xi_b, s_t, s_b, from, to),
    ),
    |[radius, wavelength, xi_t, xi_b, s_t, s_b, from, to]| complex(shader::spatial_phase(radius, wavelength, xi_t, xi_b, s_t, s_b, from, to))
}
slice_function! {
    /// Writes [`shader::scratch_squared`] of each row radius, wavelength, width, depth, xi_t, xi_b, gamma_sum, mean.
    scratch_squared, scratch_squared_at, [f32; 8] => f32,
    |block| rows(
        block,
        #[inline(always)]
        |[radius, wavelength, width, depth, xi_t, xi_b, gamma, mean]| shader::scratch_squared(radius, wavelength, width, depth, xi_t, xi_b, gamma, mean),
    ),
    |[radius, wavelength, width, depth, xi_t, xi_b, gamma, mean]| shader::scratch_squared(radius, wavelength, width, depth, xi_t, xi_b, gamma, mean)
}
slice_function! {
    /// Writes [`shader::footprint_mean_reduced`] of each row half width, edge.
    footprint_mean_reduced, footprint_mean_reduced_at, [f32; 2] => f32,
    row => shader::footprint_mean_reduced(row[0], row[1])
}
slice_function! {
    /// Writes [`shader::footprint_mean_reduced_coarse`] of each row half width, edge.
    footprint_mean_reduced_coarse, footprint_mean_reduced_coarse_at, [f32; 2] => f32,
    row => shader::footprint_mean_reduced_coarse(row[0], row[1])
}
slice_function! {
    /// Writes [`shader::response_triangle`] of each row width, depth, xi_b, gamma_sum, wavelength.
    response_triangle, response_triangle_at, [f32; 5] => Complex<f32>,
    |block| complex_rows(
        block,
        #[inline(always)]
        |[width, depth, xi, gamma, wavelength]| shader::response_triangle(width, depth, xi, gamma, wavelength),
    ),
    |[width, depth, xi, gamma, wavelength]| complex(shader::response_triangle(width, depth, xi, gamma, wavelength))
}
slice_function! {
    /// Writes [`shader::spatial_phase_infinite`] of each row radius, wavelength, xi_t, xi_b, s_b.
    spatial_phase_infinite, spatial_phase_infinite_at, [f32; 5] => Complex<f32>,
    |block| complex_rows(
        block,
        #[inline(always)]
        |[radius, wavelength, xi_t, xi_b, s_b]| shader::spatial_phase_infinite(radius, wavelength, xi_t, xi_b, s_b),
    ),
    |[radius, wavelength, xi_t, xi_b, s_b]| complex(shader::spatial_phase_infinite(radius, wavelength, xi_t, xi_b, s_b))
}
