//! Scratch diffraction in f32 against the f64 functions at the same inputs: bounds, limits, symmetries.
#![cfg(feature = "shader")]

mod interference;
mod limits;
mod profiles;
mod reflectance;
mod scenes;
mod spatial_phase;
mod worst;
