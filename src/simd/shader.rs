//! Slices of the f32 kernels of [`shader`].

mod lights;
mod scratches;
mod sums;

pub use lights::*;
pub use scratches::*;
pub use sums::*;

use super::BLOCK;
use crate::shader;
use fearless_simd::{Simd, dispatch};
use num_complex::Complex;

/// A result of the kernels as a complex number.
#[inline(always)]
pub(super) fn complex(z: shader::Complex) -> Complex<f32> {
    Complex { re: z.re, im: z.im }
}

/// Evaluates a function of the plane at a block; without its lower half where no point lies there.
#[inline(always)]
fn plane_block(z: &[Complex<f32>; BLOCK], value: impl Fn(f32, f32) -> Complex<f32>) -> [Complex<f32>; BLOCK] {
    let (mut re, mut im) = ([0.0; BLOCK], [0.0; BLOCK]);
    let mut below = 0;
    for ((re, im), z) in re.iter_mut().zip(&mut im).zip(z) {
        (*re, *im) = (z.re, z.im);
        below |= u32::from(z.im < 0.0);
    }
    let (mut out_re, mut out_im) = ([0.0; BLOCK], [0.0; BLOCK]);
    if below == 0 {
        for k in 0..BLOCK {
            let value = value(re[k], im[k].abs());
            (out_re[k], out_im[k]) = (value.re, value.im);
        }
    } else {
        for k in 0..BLOCK {
            let value = value(re[k], im[k]);
            (out_re[k], out_im[k]) = (value.re, value.im);
        }
    }
    joined(&out_re, &out_im)
}

/// Evaluates a complex function of rows at a block.
#[inline(always)]
pub(super) fn complex_rows<const N: usize>(
    rows: &[[f32; N]; BLOCK],
    value: impl Fn([f32; N]) -> shader::Complex,
) -> [Complex<f32>; BLOCK] {
    let (mut re, mut im) = ([0.0; BLOCK], [0.0; BLOCK]);
    for k in 0..BLOCK {
        let value = value(rows[k]);
        (re[k], im[k]) = (value.re, value.im);
    }
    joined(&re, &im)
}

/// Evaluates a function of rows at a block.
#[inline(always)]
pub(super) fn rows<const N: usize>(rows: &[[f32; N]; BLOCK], value: impl Fn([f32; N]) -> f32) -> [f32; BLOCK] {
    let mut out = [0.0; BLOCK];
    for (k, out) in out.iter_mut().enumerate() {
        *out = value(rows[k]);
    }
    out
}

/// Real and imaginary parts side by side.
#[inline(always)]
fn joined(re: &[f32; BLOCK], im: &[f32; BLOCK]) -> [Complex<f32>; BLOCK] {
    let mut out = [Complex { re: 0.0, im: 0.0 }; BLOCK];
    for ((out, re), im) in out.iter_mut().zip(re).zip(im) {
        *out = Complex { re: *re, im: *im };
    }
    out
}

slice_function! {
    /// Writes [`shader::faddeeva_w`] of each z.
    faddeeva_w, faddeeva_w_at, Complex<f32> => Complex<f32>,
    |block| plane_block(
        block,
        #[inline(always)]
        |re, im| complex(shader::faddeeva_w(re, im)),
    ),
    |z| complex(shader::faddeeva_w(z.re, z.im))
}
slice_function! {
    /// Writes [`shader::faddeeva_w_coarse`] of each z.
    faddeeva_w_coarse, faddeeva_w_coarse_at, Complex<f32> => Complex<f32>,
    |block| plane_block(
        block,
        #[inline(always)]
        |re, im| complex(shader::faddeeva_w_coarse(re, im)),
    ),
    |z| complex(shader::faddeeva_w_coarse(z.re, z.im))
}
slice_function! {
    /// Writes [`shader::erf_difference_scaled`] of each row a_from, a_to, b.
    erf_difference_scaled, erf_difference_scaled_at, [f32; 3] => Complex<f32>,
    |block| complex_rows(
        block,
        #[inline(always)]
        |[from, to, b]| shader::erf_difference_scaled(from, to, b),
    ),
    |row| complex(shader::erf_difference_scaled(row[0], row[1], row[2]))
}
slice_function! {
    /// Writes [`shader::bessel_i0_scaled`] of each `x`.
    bessel_i0_scaled, bessel_i0_scaled_at, f32 => f32, x => shader::bessel_i0_scaled(x)
}
slice_function! {
    /// Writes [`shader::sine_integral`] of each `x`.
    sine_integral, sine_integral_at, f32 => f32, x => shader::sine_integral(x)
}
slice_function! {
    /// Writes [`shader::sine_integral_medium`] of each `x`.
    sine_integral_medium, sine_integral_medium_at, f32 => f32, x => shader::sine_integral_medium(x)
}
slice_function! {
    /// Writes [`shader::sine_integral_coarse`] of each `x`.
    sine_integral_coarse, sine_integral_coarse_at, f32 => f32, x => shader::sine_integral_coarse(x)
}
slice_function! {
    /// Writes [`shader::sine_integral_velinov`] of each `x`.
    sine_integral_velinov, sine_integral_velinov_at, f32 => f32, x => shader::sine_integral_velinov(x)
}
slice_function! {
    /// Writes [`shader::sinc_squared_integral`] of each pair of bounds.
    sinc_squared_integral, sinc_squared_integral_at, [f32; 2] => f32,
    q => shader::sinc_squared_integral(q[0], q[1])
}
slice_function! {
    /// Writes [`shader::sinc_squared_integral_medium`] of each pair of bounds.
    sinc_squared_integral_medium, sinc_squared_integral_medium_at, [f32; 2] => f32,
    q => shader::sinc_squared_integral_medium(q[0], q[1])
}
slice_function! {
    /// Writes [`shader::sinc_squared_integral_coarse`] of each pair of bounds.
    sinc_squared_integral_coarse, sinc_squared_integral_coarse_at, [f32; 2] => f32,
    q => shader::sinc_squared_integral_coarse(q[0], q[1])
}
slice_function! {
    /// Writes [`shader::sinc_squared_integral_velinov`] of each pair of bounds.
    sinc_squared_integral_velinov, sinc_squared_integral_velinov_at, [f32; 2] => f32,
    q => shader::sinc_squared_integral_velinov(q[0], q[1])
}
