//! Slice functions: the scalar sources in loops that the compiler vectorises, at the widest level of the machine.
//!
//! Each function exists once for the machine's own [`Level`] and once, with `_at`, for a level given by the caller.
//! The results have the bits of the scalar functions at every level: multiplications and additions stay unfused.
//! When the two slices differ in length, the shorter one counts.

pub use fearless_simd::Level;
use fearless_simd::{Simd, dispatch};
use num_complex::Complex;

/// Elements evaluated between two copies: a buffer of its own lets the compiler see that nothing aliases.
const BLOCK: usize = 64;

/// Defines a slice function and its form at a given level: from an expression of one element, or from a function of a
/// block and one of an element.
macro_rules! slice_function {
    ($(#[$doc:meta])* $name:ident, $at:ident, $input:ty => $output:ty, $x:ident => $value:expr) => {
        slice_function! {
            $(#[$doc])* $name, $at, $input => $output,
            |block| {
                let mut buffer = [0.0; BLOCK];
                for (value, &$x) in buffer.iter_mut().zip(block) {
                    *value = $value;
                }
                buffer
            },
            |$x| $value
        }
    };
    ($(#[$doc:meta])* $name:ident, $at:ident, $input:ty => $output:ty,
     |$block:ident| $values:expr, |$x:ident| $value:expr) => {
        $(#[$doc])*
        pub fn $name(x: &[$input], out: &mut [$output]) {
            $at($crate::simd::Level::new(), x, out);
        }

        #[doc = concat!("[`", stringify!($name), "`] at a given level.")]
        pub fn $at(level: $crate::simd::Level, x: &[$input], out: &mut [$output]) {
            #[inline(always)]
            fn evaluate<S: Simd>(_: S, x: &[$input], out: &mut [$output]) {
                let length = x.len().min(out.len());
                let (blocks, rest) = x[..length].as_chunks::<BLOCK>();
                let (out_blocks, out_rest) = out[..length].as_chunks_mut::<BLOCK>();
                for ($block, out_block) in blocks.iter().zip(out_blocks) {
                    *out_block = $values;
                }
                for (value, &$x) in out_rest.iter_mut().zip(rest) {
                    *value = $value;
                }
            }
            dispatch!(level, simd => evaluate(simd, x, out));
        }
    };
}

slice_function! {
    /// Writes [`special::bessel_i0_scaled`](crate::special::bessel_i0_scaled()) of each `x`.
    bessel_i0_scaled, bessel_i0_scaled_at, f64 => f64,
    |block| crate::special::bessel_i0_scaled_block(block), |x| crate::special::bessel_i0_scaled(x)
}

slice_function! {
    /// Writes [`special::erf`](crate::special::erf()) of each `x`.
    erf, erf_at, f64 => f64,
    |block| crate::special::erf_block(block), |x| crate::special::erf(x)
}

slice_function! {
    /// Writes [`special::sine_integral`](crate::special::sine_integral()) of each `x`.
    sine_integral, sine_integral_at, f64 => f64,
    |block| crate::special::sine_integral_block(block), |x| crate::special::sine_integral(x)
}

/// Defines a slice function from a function of slices.
macro_rules! complex_slice_function {
    ($(#[$doc:meta])* $name:ident, $at:ident, $input:ty, $slice:path) => {
        $(#[$doc])*
        pub fn $name(x: &[$input], out: &mut [Complex<f64>]) {
            $at(Level::new(), x, out);
        }

        #[doc = concat!("[`", stringify!($name), "`] at a given level.")]
        pub fn $at(level: Level, x: &[$input], out: &mut [Complex<f64>]) {
            #[inline(always)]
            fn evaluate<S: Simd>(_: S, x: &[$input], out: &mut [Complex<f64>]) {
                $slice(x, out);
            }
            dispatch!(level, simd => evaluate(simd, x, out));
        }
    };
}

complex_slice_function! {
    /// Writes [`special::faddeeva_w`](crate::special::faddeeva_w()) of each z.
    faddeeva_w, faddeeva_w_at, Complex<f64>, crate::special::faddeeva_slices::faddeeva_w_slice
}
complex_slice_function! {
    /// Writes [`special::faddeeva_w_fine`](crate::special::faddeeva_w_fine) of each z.
    faddeeva_w_fine, faddeeva_w_fine_at, Complex<f64>, crate::special::faddeeva_slices::faddeeva_w_fine_slice
}
complex_slice_function! {
    /// Writes [`special::faddeeva_w_medium`](crate::special::faddeeva_w_medium) of each z.
    faddeeva_w_medium, faddeeva_w_medium_at, Complex<f64>, crate::special::faddeeva_slices::faddeeva_w_medium_slice
}
complex_slice_function! {
    /// Writes [`special::faddeeva_w_coarse`](crate::special::faddeeva_w_coarse) of each z.
    faddeeva_w_coarse, faddeeva_w_coarse_at, Complex<f64>, crate::special::faddeeva_slices::faddeeva_w_coarse_slice
}

/// Slices of the f32 kernels of [`shader`](crate::shader).
pub mod shader {
    use super::BLOCK;
    use crate::shader;
    use fearless_simd::{Simd, dispatch};
    use num_complex::Complex;

    /// A result of the kernels as a complex number.
    #[inline(always)]
    fn complex(z: shader::Complex) -> Complex<f32> {
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

    /// Evaluates the scaled erf difference at a block.
    #[inline(always)]
    fn erf_difference_block(rows: &[[f32; 3]; BLOCK]) -> [Complex<f32>; BLOCK] {
        let (mut from, mut to, mut b) = ([0.0; BLOCK], [0.0; BLOCK], [0.0; BLOCK]);
        for (k, row) in rows.iter().enumerate() {
            [from[k], to[k], b[k]] = *row;
        }
        let (mut re, mut im) = ([0.0; BLOCK], [0.0; BLOCK]);
        for k in 0..BLOCK {
            let value = shader::erf_difference_scaled(from[k], to[k], b[k]);
            (re[k], im[k]) = (value.re, value.im);
        }
        joined(&re, &im)
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
        |block| erf_difference_block(block), |row| complex(shader::erf_difference_scaled(row[0], row[1], row[2]))
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
}
