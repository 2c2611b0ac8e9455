//! The f32 kernels, in the small subset of Rust that translates to WGSL, GLSL and HLSL.
//!
//! # Definition
//!
//! Every function here is the f32 form of a function of [`special`](crate::special), or an elementary function that it
//! stands on. One source serves three machines: scalars here, slices in `simd`, and shaders through the generated text
//! [`WGSL`], [`WGSL_BEVY`], [`GLSL`] and [`HLSL`], in which every function has the name it has here.
//!
//! # Domain
//!
//! Any finite f32 unless a function says otherwise; phases are reduced to 1e-7 for arguments to 1e4. NaN gives NaN on
//! the CPU. A GPU may assume that neither NaN nor infinity occurs, may flush subnormal numbers, fuse and reorder.
//!
//! # Methods
//!
//! A plain name is f32 grade. `_medium` and `_coarse` are cheaper and coarser; `_velinov` is the fit of VWH18 (the
//! text's identifiers may not end in a digit).
//!
//! <!-- report:begin summary -->
//!
//! | function | f64: largest error of the promised | f64: time / best peer | f32: largest error of the promised | f32: time / best peer |
//! |---|---|---|---|---|
//! | `sine_integral` | 0.67 of 0.75 ulp | 0.36, slices 0.18 (cephes) | 1.9 of 2 ulp | 0.62, slices 0.056 (galsim) |
//! | `sinc_squared_integral` | 9.2 of 16 eps | 0.25 (cephes_antiderivative) | 4.5e-7 of 6e-7 abs. | 0.43, slices 0.050 (rounded_antiderivative) |
//! | `sinc` | 1.6 of 1.75 ulp | | | |
//! | `sinc_squared_integral_turns` | | | 5.3e-7 of 6e-7 abs. | |
//! | `sine` | | | 1.5e-7 of 2e-7 abs. | |
//! | `cosine` | | | 2.5e-7 of 2.5e-7 abs. | |
//! | `exponential` | | | 1.2 of 2 ulp | |
//! | `faddeeva_w` | 1.9 of 2 eps | 0.31, slices 0.081 (libcerf) | 2.5 of 4 eps | 0.24, slices 0.020 (errorfunctions_rounded) |
//! | `erf_complex` | 8.7 of 12 eps | 0.45 (libcerf) | | |
//! | `erf_difference_scaled` | 3.9 of 6 eps of peak | 0.72 (errorfunctions_w) | 5.3e-7 of 1.4e-6 of peak | |
//! | `bessel_i0_scaled` | 0.56 of 1 ulp | 0.21, slices 0.15 (cephes) | 0.94 of 1 ulp | 2.1, slices 0.23 (pxfm) |
//! | `erf` | 0.50 of 0.501 ulp | 0.45, slices 0.26 (cephes) | | |
//! | `erfc_complex` | 4.5 of 8 eps | 0.44 (libcerf) | | |
//! | `erfcx` | 2.4 of 3 ulp | 3.5 (puruspe) | | |
//! | `faddeeva_w_derivative` | 24 of 48 eps | 0.26 (libcerf) | | |
//! | `log_bessel_i0` | 1.7 of 2 ulp | 0.33 (cephes) | 1.9 of 2 ulp | |
//! | `bessel_i1_i0_ratio` | 0.62 of 0.75 ulp | 0.099 (cephes) | 1.4 of 2 ulp | |
//!
//! <!-- report:end summary -->
//!
//! # Where it fails
//!
//! Phases of arguments beyond 1e4 lose digits in proportion; from about 1e7 they mean nothing. The sine integral stays
//! within its bound, since the term that carries the phase has died out. An arc shorter than a lobe is nothing but its
//! phase: its relative error grows with |q|. A scratch that knows W/lambda and xi apart keeps its phase:
//! [`sinc_squared_integral_turns`].
//! The same holds for the ends of a segment: [`erf_difference_scaled_turns`].
//!
//! Below the real axis w is a difference of two terms: beside its zeros the error counts against the terms, not against
//! w. The page of [`special::faddeeva_w`](crate::special::faddeeva_w()) has the measured figures of every tier.

#![allow(
    clippy::approx_constant,
    clippy::excessive_precision,
    reason = "constants are written with the digits that the generated text carries"
)]

mod bessel;
mod bessel_coefficients;
mod coefficients;
mod elementary;
mod erf_difference;
mod faddeeva;
mod faddeeva_coefficients;
mod gpu;
mod sinc_squared_integral;
mod sine_integral;

pub use bessel::{bessel_i0_scaled, bessel_ratio, log_bessel_izero};
pub use elementary::{SineCosine, exponential, sine_cosine, sine_cosine_turns};
pub use erf_difference::{erf_difference_scaled, erf_difference_scaled_turns};
pub use faddeeva::{Complex, faddeeva_w, faddeeva_w_coarse};
pub use sinc_squared_integral::{
    sinc_squared_integral, sinc_squared_integral_coarse, sinc_squared_integral_medium, sinc_squared_integral_turns,
    sinc_squared_integral_velinov,
};
pub use sine_integral::{sine_integral, sine_integral_coarse, sine_integral_medium, sine_integral_velinov};

/// The kernels as WGSL: functions and constants only, to be put before a shader's own text.
pub const WGSL: &str = include_str!("wgsl/iridescence.wgsl");
/// [`WGSL`] as an importable module for bevy, `#import iridescence`.
pub const WGSL_BEVY: &str = include_str!("wgsl/iridescence_bevy.wgsl");
/// The kernels as a GLSL include, for version 330, 300 es or later.
pub const GLSL: &str = include_str!("glsl/iridescence.glsl");
/// The kernels as an HLSL include.
pub const HLSL: &str = include_str!("hlsl/iridescence.hlsl");
