//! The f32 kernels, in the small subset of Rust that translates to WGSL, GLSL and HLSL.
//!
//! # Definition
//!
//! Every function here is the f32 form of a function of [`special`](crate::special), [`diffraction`](crate::diffraction)
//! or [`sampling`](crate::sampling), or an elementary function that it stands on. One source serves three machines:
//! scalars here, slices in `simd`, and shaders through the generated text [`WGSL`], [`WGSL_BEVY`], [`GLSL`] and [`HLSL`],
//! in which every function has the name it has here.
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
//! | `sine_integral` | 0.67 of 0.75 ulp | 0.38, slices 0.19 (cephes) | 1.9 of 2 ulp | 0.58, slices 0.054 (galsim) |
//! | `sinc_squared_integral` | 9.2 of 16 eps | 0.30 (cephes_antiderivative) | 4.5e-7 of 6e-7 abs. | 0.44, slices 0.047 (rounded_antiderivative) |
//! | `sinc` | 1.6 of 1.75 ulp | | | |
//! | `sinc_squared_integral_turns` | | | 5.3e-7 of 6e-7 abs. | |
//! | `sine` | | | 1.5e-7 of 2e-7 abs. | |
//! | `cosine` | | | 2.5e-7 of 2.5e-7 abs. | |
//! | `exponential` | | | 1.2 of 2 ulp | |
//! | `faddeeva_w` | 1.9 of 2 eps | 0.33, slices 0.081 (libcerf) | 2.5 of 4 eps | 0.25, slices 0.019 (errorfunctions_rounded) |
//! | `erf_complex` | 8.7 of 12 eps | no peer is finite | | |
//! | `erf_difference_scaled` | 3.9 of 6 eps of peak | 0.75 (errorfunctions_w) | 5.3e-7 of 1.4e-6 of peak | |
//! | `bessel_i0_scaled` | 0.56 of 1 ulp | 0.22, slices 0.14 (cephes) | 0.94 of 1 ulp | 2.8, slices 0.26 (pxfm) |
//! | `erf` | 0.50 of 0.501 ulp | 0.43, slices 0.23 (cephes) | | |
//! | `erfc_complex` | 4.5 of 8 eps | no peer is finite | | |
//! | `erfcx` | 2.4 of 3 ulp | 4.8 (puruspe) | | |
//! | `faddeeva_w_derivative` | 24 of 48 eps | 0.29 (libcerf) | | |
//! | `log_bessel_i0` | 1.7 of 2 ulp | 0.34 (cephes) | 1.9 of 2 ulp | |
//! | `bessel_i1_i0_ratio` | 0.62 of 0.75 ulp | 0.086 (cephes) | 1.4 of 2 ulp | |
//! | `spatial_phase` | 5.3e-16 of 1e-15 of peak | no peer is finite | 2.7e-6 of 3.5e-6 of peak | |
//! | `profile_rectangle` | 1.6e-15 of 3e-15 of peak | | 5.3e-7 of 1e-6 of peak | |
//! | `profile_triangle` | 3.9e-16 of 8e-16 of peak | | 2.9e-7 of 6e-7 of peak | |
//! | `footprint_mean` | 2.3e-13 of 5e-13 of peak | 0.43 (quadrature_9) | 7.1e-7 of 2e-6 of peak | |
//! | `footprint_mean_reduced` | 2.3e-13 of 5e-13 of peak | | | |
//! | `footprint_mean_reduced_edge` | | | 6.4e-7 of 1e-6 of peak | |
//! | `segment_energy` | 2.2e-15 of 4e-15 of peak | | | |
//! | `sinc_squared_inverse` | 5.8e-13 of 1.2e-12 rel. | | | |
//! | `spatial_phase_infinite` | 5.7e-16 of 1e-15 of peak | | 2.5e-7 of 5e-7 of peak | |
//! | `depth_term` | 2.8 of 6 eps | | 6.0e-7 of 1e-6 abs. | |
//! | `response_triangle` | 5.5e-16 of 1.2e-15 of peak | | 3.0e-7 of 5e-7 of peak | |
//! | `response_rectangle_windowed` | 1.5e-16 of 4e-16 of peak | | | |
//! | `base_response` | 3.2e-16 of 1e-15 of peak | | 1.8e-7 of 5e-7 of peak | |
//! | `scratch_squared` | 9.2e-16 of 2e-15 of peak | | 3.7e-7 of 1e-6 of peak | |
//! | `area_density` | 3.2e-16 of 1e-15 of peak | | 2.0e-7 of 5e-7 of peak | |
//! | `gaussian_inverse` | 2.9 of 6 ulp | | 8.5e-7 of 1.5e-6 abs. | |
//! | `von_mises_fisher_pdf` | 4.1e-16 of 1e-15 of peak | | | |
//! | `sphere_light` | 8.1e-12 of 2.5e-11 of peak | 5.5 (importance_16) | 1.7e-3 of 4e-3 of peak | |
//! | `polygon_light` | 2.7e-11 of 6e-11 of peak | 1.4 (importance_16) | 0.016 of 0.03 of peak | |
//! | `sphere_light_chord` | 3.4e-15 of 1e-14 of peak | | 8.3e-6 of 3e-5 of peak | 0.049, slices 7.4e-3 (monte_carlo_64) |
//! | `quad_light_chord` | 4.6e-14 of 1e-13 of peak | | 1.4e-5 of 4e-5 of peak | |
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

mod area_light;
mod bessel;
mod bessel_coefficients;
mod coefficients;
mod elementary;
mod erf_difference;
mod faddeeva;
mod faddeeva_coefficients;
mod footprint;
mod footprint_coefficients;
mod gpu;
mod interference;
mod inverse;
mod light;
mod profile;
mod reflectance;
mod sampling;
mod sinc_squared_integral;
mod sine_integral;
mod spatial_phase;
mod turns;

pub use area_light::{polygon_light, quad_light, sphere_light, triangle_light};
pub use bessel::{bessel_i0_scaled, bessel_ratio, log_bessel_izero};
pub use elementary::{SineCosine, exponential, sine_cosine, sine_cosine_turns};
pub use erf_difference::{erf_difference_scaled, erf_difference_scaled_turns};
pub use faddeeva::{Complex, faddeeva_w, faddeeva_w_coarse};
pub use footprint::{
    footprint_half_width, footprint_mean, footprint_mean_coarse, footprint_mean_reduced, footprint_mean_reduced_coarse,
};
pub use interference::{base_interference, crossing_response};
pub use light::{polygon_light_chord, quad_light_chord, sphere_light_chord, triangle_light_chord};
pub use profile::{depth_term, depth_term_squared, profile_rectangle, profile_triangle, response_triangle, width_term};
pub use reflectance::{
    area_density, energy_blend_base, energy_blend_scattered, energy_blend_scratches, reflectance_coherent,
    reflectance_incoherent, scratch_squared,
};
pub use sampling::{
    SampledDirection, balance_weight, base_lobe_pdf, base_lobe_sample, gaussian_inverse, scratch_cone_pdf,
    scratch_cone_sample, scratch_lobe_pdf, scratch_lobe_sample,
};
pub use sinc_squared_integral::{
    sinc_squared_integral, sinc_squared_integral_coarse, sinc_squared_integral_medium, sinc_squared_integral_turns,
    sinc_squared_integral_velinov,
};
pub use sine_integral::{sine_integral, sine_integral_coarse, sine_integral_medium, sine_integral_velinov};
pub use spatial_phase::{
    area_density_amplitude, base_response, coherence_window, spatial_phase, spatial_phase_infinite,
    spatial_phase_infinite_squared,
};

/// The kernels as WGSL: functions and constants only, to be put before a shader's own text.
pub const WGSL: &str = include_str!("wgsl/iridescence.wgsl");
/// [`WGSL`] as an importable module for bevy, `#import iridescence`.
pub const WGSL_BEVY: &str = include_str!("wgsl/iridescence_bevy.wgsl");
/// The kernels as a GLSL include, for version 330, 300 es or later.
pub const GLSL: &str = include_str!("glsl/iridescence.glsl");
/// The kernels as an HLSL include.
pub const HLSL: &str = include_str!("hlsl/iridescence.hlsl");
