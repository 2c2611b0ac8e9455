//! Slices of area lights.

use super::rows;
use crate::shader;
use crate::simd::BLOCK;
use fearless_simd::{Simd, dispatch};

slice_function! {
    /// Writes [`shader::sphere_light_chord`] of each row radius, wavelength, width, view_t, view_b, x, y, z, sphere radius.
    sphere_light_chord, sphere_light_chord_at, [f32; 9] => f32,
    |block| rows(
        block,
        #[inline(always)]
        |[radius, wavelength, width, view_t, view_b, x, y, z, r]| shader::sphere_light_chord(radius, wavelength, width, view_t, view_b, x, y, z, r),
    ),
    |[radius, wavelength, width, view_t, view_b, x, y, z, r]| shader::sphere_light_chord(radius, wavelength, width, view_t, view_b, x, y, z, r)
}
slice_function! {
    /// Writes [`shader::quad_light_chord`] of each row radius, wavelength, width, view_t, view_b and four vertices.
    quad_light_chord, quad_light_chord_at, [f32; 17] => f32,
    |block| rows(
        block,
        #[inline(always)]
        |x| shader::quad_light_chord(x[0], x[1], x[2], x[3], x[4], x[5], x[6], x[7], x[8], x[9], x[10], x[11], x[12], x[13], x[14], x[15], x[16]),
    ),
    |x| shader::quad_light_chord(x[0], x[1], x[2], x[3], x[4], x[5], x[6], x[7], x[8], x[9], x[10], x[11], x[12], x[13], x[14], x[15], x[16])
}
