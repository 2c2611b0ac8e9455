//! Slice functions: the scalar sources in loops that the compiler vectorises, at the widest level of the machine.
//!
//! Each function exists once for the machine's own [`Level`] and once, with `_at`, for a level given by the caller.
//! The results have the bits of the scalar functions at every level: multiplications and additions stay unfused.
//! When the two slices differ in length, the shorter one counts.

pub use fearless_simd::Level;
use fearless_simd::{Simd, dispatch};

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
    /// Writes [`special::sine_integral`](crate::special::sine_integral()) of each `x`.
    sine_integral, sine_integral_at, f64 => f64,
    |block| crate::special::sine_integral_block(block), |x| crate::special::sine_integral(x)
}

/// Slices of the f32 kernels of [`shader`](crate::shader).
pub mod shader {
    use super::BLOCK;
    use crate::shader;
    use fearless_simd::{Simd, dispatch};

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
