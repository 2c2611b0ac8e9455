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
//! <!-- report:end accuracy -->
//!
//! # Where it fails
//!
//! Phases of arguments beyond 1e4 lose digits in proportion; from about 1e7 they mean nothing, while the results stay
//! within their bounds, since the terms that carry a phase have died out. A scratch that knows W/lambda and xi apart
//! keeps its phase: [`sinc_squared_integral_turns`].

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
