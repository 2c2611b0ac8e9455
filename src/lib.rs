//! Closed-form wave optics for renderers.
//!
//! A scratch or a thin film has a colour because light waves meet themselves. The papers that render this leave a few
//! special functions and integrals to evaluate; here they are, in f64 to the last digits and in f32 for shaders, each
//! with an error bound that a test holds. On them stand the scratch models: [`diffraction`] gives the reflectance of a
//! scratched surface, coherent or not, near or far, with the rules that say how much of it a scene needs, [`light`]
//! integrates it over spheres and polygons, and [`sampling`] draws from its lobes.
//!
//! Every method of the sine integral, error against time, the peers among them:
//!
#![cfg_attr(doc, doc = include_str!("../docs/charts/sine_integral_error_time.svg"))]
//!
//! # Example
//!
//! The share of a scratch's lobe that falls on a light: a scratch 2.5 um wide, a wavelength of 0.52 um, a light that
//! covers the direction cosines 0.45 to 0.47 across the scratch (VWH18 Eqs. 25 and 27).
//!
//! ```
//! use core::f64::consts::PI;
//! use iridescence::special;
//!
//! let light = [0.45, 0.47].map(|xi| PI * 2.5 * xi / 0.52);
//! let share = special::sinc_squared_integral(light) / PI;
//! assert!(share > 0.0);
//! // The fit that the paper publishes for shaders gives this light less than nothing.
//! assert!(special::sinc_squared_integral_vwh18(light) < 0.0);
//! ```
//!
//! # Modules
//!
//! | module | what it holds | precision | feature |
//! |---|---|---|---|
//! | [`diffraction`] | scratches: profiles, spatial phase, coherence, footprint, area density, reflectance, predictors | f64 | |
//! | [`geometry`] | cones and polygons as a surface sees them: outlines, chords, crossings | f64 | |
//! | [`light`] | area lights over a scratch and over the base: spheres, polygons, form factors | f64 | |
//! | [`sampling`] | the lobes of a scratched surface: densities, samples and weights | f64 | |
//! | [`special`] | sinc, the sine integral, the arc of sinc squared; the Faddeeva function, erf, the scaled erf difference; Bessel I0 | f64 | |
#![cfg_attr(
    feature = "shader",
    doc = "| [`shader`] | `special`, `diffraction`, `light` and `sampling` in f32, in cheaper tiers as well, with their WGSL, GLSL and HLSL text | f32 | `shader` |"
)]
#![cfg_attr(
    feature = "simd",
    doc = "| [`simd`] | slice functions over the same sources, at the widest vector level of the machine | f64, f32 | `simd` |"
)]
//!
//! # Conventions
//!
//! Lengths are in micrometres, directions are cosines, phases are in radians unless a name says turns. The wave number
//! is 2 pi/lambda, the time factor e^{-i omega t}, and sinc x = sin x/x. NaN in gives NaN out; nothing panics. The
//! accurate function has the plain name; any other method is named after it, `sine_integral_vwh18`. A Cargo feature
//! adds functions and never changes a number.
#![no_std]
#![forbid(unsafe_code)]

pub mod diffraction;
pub mod geometry;
pub mod light;
mod numeric;
pub mod sampling;
#[cfg(feature = "shader")]
pub mod shader;
#[cfg(feature = "simd")]
pub mod simd;
pub mod special;

pub use num_complex::Complex;

/// The examples of README.md, as tests.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
pub struct Readme;
