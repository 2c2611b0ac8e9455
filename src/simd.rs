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
     |$block:ident| $values:expr, |$x:pat_param| $value:expr) => {
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

pub mod shader;
