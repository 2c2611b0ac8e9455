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
//! <!-- report:begin accuracy -->
//!
//! | function | method | what it is | precision | max abs. error | max rel. error | 99.9 % rel. error | max ulp | wrong sign | promise | time / baseline | worst input |
//! |---|---|---|---|---|---|---|---|---|---|---|---|
//! | `sine_integral` | `accurate` | iridescence f64 (ours) | f64 | 1.5e-16 | 1.2e-16 | 1.1e-16 | 0.67 | none | 0.75 ulp | 0.36 (cephes) | 1.316264e0 |
//! | `sine_integral` | `vwh18` | VWH18 Eq. 29 (published) | f64 | 0.051 | 0.030 | 0.030 | 2.3e14 | none | 0.051 abs. | 0.95 (cephes) | 3.560005e0 |
//! | `sine_integral` | `accurate`, slice | iridescence f64 slices (ours) | f64 | 1.5e-16 | 1.2e-16 | 1.1e-16 | 0.67 | none | 0.75 ulp | 0.18 (cephes) | 1.316264e0 |
//! | `sine_integral` | `accurate` | iridescence f32 (ours) | f32 | 2.3e-7 | 1.4e-7 | 1.0e-7 | 1.9 | none | 2 ulp | 0.71 (vwh18) | 2.967260e0 |
//! | `sine_integral` | `medium` | iridescence f32 1e-5 tier (ours) | f32 | 7.0e-6 | 4.3e-6 | 4.2e-6 | 59 | none | 1e-5 abs. | 0.54 (vwh18) | 8.462726e0 |
//! | `sine_integral` | `coarse` | iridescence f32 4e-4 tier (ours) | f32 | 3.5e-4 | 2.3e-4 | 2.3e-4 | 3.0e3 | none | 4e-4 abs. | 0.42 (vwh18) | 4.200013e0 |
//! | `sine_integral` | `vwh18` | VWH18 Eq. 29 f32 (published) | f32 | 0.051 | 1.6 | 1.6 | 2.6e7 | 6.1 % | 0.051 abs. | 1.00 (vwh18) | 3.560005e0 |
//! | `sine_integral` | `accurate`, slice | iridescence f32 slices (ours) | f32 | 2.3e-7 | 1.4e-7 | 1.0e-7 | 1.9 | none | 2 ulp | 0.81 (vwh18) | 2.967260e0 |
//! | `sine_integral` | `medium`, slice | iridescence f32 1e-5 slices (ours) | f32 | 7.0e-6 | 4.3e-6 | 4.2e-6 | 59 | none | 1e-5 abs. | 0.62 (vwh18) | 8.462726e0 |
//! | `sine_integral` | `coarse`, slice | iridescence f32 4e-4 slices (ours) | f32 | 3.5e-4 | 2.3e-4 | 2.3e-4 | 3.0e3 | none | 4e-4 abs. | 0.55 (vwh18) | 4.200013e0 |
//! | `sine_integral` | `vwh18`, slice | VWH18 Eq. 29 f32 slices (published) | f32 | 0.051 | 1.6 | 1.6 | 2.6e7 | 6.1 % | 0.051 abs. | 1.00 (vwh18) | 3.560005e0 |
//! | `sine_integral` | `cephes` | Cephes, Si and Ci (spec_math 0.1.6) (peer) | f64 | 7.9e-16 | 4.3e-16 | 2.9e-16 | 3.5 | 1.0e-4 % | none | 1.00 (cephes) | -3.212373e0 |
//! | `sine_integral` | `galsim` | Pade of Rowe et al. 2015 (GalSim) (peer) | f64 | 8.4e-16 | 4.6e-16 | 2.9e-16 | 3.8 | none | none | 1.12 (cephes) | 3.516967e0 |
//! | `sine_integral` | `cephes_rounded` | Cephes f64, Si and Ci, rounded to f32 (peer) | f32 | 6.0e-8 | 6.0e-8 | 5.8e-8 | 0.50 | 1.0e-4 % | none | 1.70 (vwh18) | 1.078683e-1 |
//! | `sine_integral` | `galsim` | Pade of Rowe et al. 2015 in f32 (peer) | f32 | 4.2e-7 | 2.3e-7 | 1.5e-7 | 3.5 | none | none | 1.14 (vwh18) | 3.237510e0 |
//! | `sine_integral` | `gsl` | GSL (Debian libgsl) (peer) | f64 | 4.5e-16 | 2.7e-16 | 2.0e-16 | 2.0 | none | none | 4.40 (cephes) | -1.044854e0 |
//! | `sinc_squared_integral` | `accurate` | iridescence f64 (ours) | f64 | 1.3e-15 | 2.0e-15 | 8.9e-16 | 14 | none | 16 eps | 0.25 (cephes_antiderivative) | 8.040728e6 8.040727e6 |
//! | `sinc_squared_integral` | `vwh18` | VWH18 Eq. 27 with Eq. 29 (published) | f64 | 0.10 | 5.5e9 | 1.0e4 | 4.9e25 | 9.5 % | 0.103 abs. | 0.70 (cephes_antiderivative) | -1.765594e0 1.789724e0 |
//! | `sinc_squared_integral` | `accurate` | iridescence f32 (ours) | f32 | 4.5e-7 | 8.8e-5 | 6.0e-7 | 1.5e3 | none | 6e-7 abs. | 0.83 (vwh18) | 5.396753e-4 8.672025e-1 |
//! | `sinc_squared_integral` | `medium` | iridescence f32 1e-5 tier (ours) | f32 | 3.4e-6 | 8.8e-5 | 3.7e-6 | 1.5e3 | none | 5e-6 abs. | 0.76 (vwh18) | 2.380013e-4 9.942443e-1 |
//! | `sinc_squared_integral` | `coarse` | iridescence f32 4e-4 tier (ours) | f32 | 2.9e-4 | 6.3e-4 | 3.6e-4 | 9.3e3 | none | 4e-4 abs. | 0.62 (vwh18) | -1.166797e0 -1.674347e-1 |
//! | `sinc_squared_integral` | `vwh18` | VWH18 Eq. 27 f32 (published) | f32 | 0.10 | 1.2e8 | 2.4e4 | 1.4e15 | 6.7 % | 0.103 abs. | 1.00 (vwh18) | -1.765594e0 1.789724e0 |
//! | `sinc_squared_integral` | `accurate`, slice | iridescence f32 slices (ours) | f32 | 4.5e-7 | 8.8e-5 | 6.0e-7 | 1.5e3 | none | 6e-7 abs. | 1.02 (vwh18) | 5.396753e-4 8.672025e-1 |
//! | `sinc_squared_integral` | `medium`, slice | iridescence f32 1e-5 slices (ours) | f32 | 3.4e-6 | 8.8e-5 | 3.7e-6 | 1.5e3 | none | 5e-6 abs. | 0.88 (vwh18) | 2.380013e-4 9.942443e-1 |
//! | `sinc_squared_integral` | `coarse`, slice | iridescence f32 4e-4 slices (ours) | f32 | 2.9e-4 | 6.3e-4 | 3.6e-4 | 9.3e3 | none | 4e-4 abs. | 0.69 (vwh18) | -1.166797e0 -1.674347e-1 |
//! | `sinc_squared_integral` | `vwh18`, slice | VWH18 Eq. 27 f32 slices (published) | f32 | 0.10 | 1.2e8 | 2.4e4 | 1.4e15 | 6.7 % | 0.103 abs. | 1.00 (vwh18) | -1.765594e0 1.789724e0 |
//! | `sinc_squared_integral` | `cephes_antiderivative` | Eq. 27 with Cephes Si (peer) | f64 | 1.3e-15 | 2.1e3 | 7.0e-4 | 1.8e19 | 3.0e-4 % | none | 1.00 (cephes_antiderivative) | -1.130974e2 -1.130973e2 |
//! | `sinc_squared_integral` | `galsim_antiderivative` | Eq. 27 with GalSim Si (peer) | f64 | 1.4e-15 | 2.1e3 | 7.0e-4 | 1.8e19 | 3.0e-4 % | none | 1.11 (cephes_antiderivative) | -1.130974e2 -1.130973e2 |
//! | `sinc_squared_integral` | `quadrature` | double exponential (quadrature 0.1.2) (peer) | f64 | 9.2 | 2.9 | 1.0 | 2.1e16 | none | none | 14.06 (cephes_antiderivative) | -4.990000e2 4.990000e2 |
//! | `sinc_squared_integral` | `rounded_antiderivative` | Eq. 27 with Si rounded to f32 (peer) | f32 | 4.1e-7 | 8.9e6 | 3.0e4 | 1.4e14 | 2.9 % | none | 1.96 (vwh18) | 2.827451e2 2.827454e2 |
//! | `sinc_squared_integral` | `gsl_antiderivative` | Eq. 27 with GSL Si (peer) | f64 | 9.2e-16 | 2.1e3 | 7.0e-4 | 1.8e19 | 3.0e-4 % | none | 3.77 (cephes_antiderivative) | -1.130974e2 -1.130973e2 |
//! | `sinc` | `accurate` | iridescence f64 (ours) | f64 | 1.7e-16 | 2.2e-16 | 1.7e-16 | 1.6 | none | 1.75 ulp | 1.00 (accurate) | 5.260492e-1 |
//! | `sinc_squared_integral_turns` | `accurate` | iridescence f32 (ours) | f32 | 5.3e-7 | 1.5e-4 | 6.0e-7 | 1.7e3 | none | 6e-7 abs. | 1.00 (accurate) | 1.307306e-1 -1.916698e0 -4.963361e-3 |
//! | `sine` | `accurate` | iridescence f32 (ours) | f32 | 1.5e-7 | 0.78 | 4.2e-3 | 7.4e6 | none | 2e-7 abs. | 1.00 (accurate) | 9.839992e3 |
//! | `cosine` | `accurate` | iridescence f32 (ours) | f32 | 2.5e-7 | 27 | 11 | 2.6e8 | 0.12 % | 2.5e-7 abs. | 1.00 (accurate) | 9.932197e3 |
//! | `exponential` | `accurate` | iridescence f32 (ours) | f32 | 2.0e31 | 9.8e-8 | 7.8e-8 | 1.2 | none | 2 ulp | 1.00 (accurate) | -5.862429e0 |
//!
//! <!-- report:end accuracy -->
//!
//! # Where it fails
//!
//! Phases of arguments beyond 1e4 lose digits in proportion; from about 1e7 they mean nothing. The sine integral stays
//! within its bound, since the term that carries the phase has died out. An arc shorter than a lobe is nothing but its
//! phase: its relative error grows with |q|. A scratch that knows W/lambda and xi apart keeps its phase:
//! [`sinc_squared_integral_turns`].

#![allow(
    clippy::approx_constant,
    clippy::excessive_precision,
    reason = "constants are written with the digits that the generated text carries"
)]

mod coefficients;
mod elementary;
mod gpu;
mod sinc_squared_integral;
mod sine_integral;

pub use elementary::{SineCosine, exponential, sine_cosine, sine_cosine_turns};
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
