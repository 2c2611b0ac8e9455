//! Published formulas exactly as printed, with the platform's mathematics: what a reader gets who types them in.
//!
//! VWH18: Velinov, Werner, Hullin, Real-Time Rendering of Wave-Optical Effects on Scratched Surfaces, 2018.
//! WVJH17: Werner, Velinov, Jakob, Hullin, Scratch Iridescence: Wave-Optical Rendering of Diffractive Surface Structure, 2017.

pub mod footprint;
pub mod lights;
pub mod scratches;
pub mod special;

pub use footprint::*;
pub use lights::*;
pub use scratches::*;
pub use special::*;
