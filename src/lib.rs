//! Closed-form wave optics for renderers.
#![no_std]
#![forbid(unsafe_code)]

mod numeric;
#[cfg(feature = "shader")]
pub mod shader;
#[cfg(feature = "simd")]
pub mod simd;
pub mod special;
