//! Area lights over the lobe of a scratch, and over the base: spheres and polygons in closed form, with as many chords as
//! the light needs (VWH18 3.4).
//!
//! Seen from one direction, an infinite scratch reflects in proportion to
//! exp(-(sigma k xi1)^2) sinc^2(k W xi2/2), xi1 and xi2 the sums of the direction cosines of light and view along and across
//! it. A light of uniform radiance L adds L times the integral of this over its projection on the surface; what stands before
//! the lobe (depth, footprint, area) is in [`diffraction`](crate::diffraction). Directions and positions stand in the
//! frame of the scratch, relative to the shaded point; the light's length unit is free.
//!
//! | function | what it returns | page |
//! |---|---|---|
//! | [`sphere_light()`], [`polygon_light()`] | the integral, to 1e-9 and better | [`mod@sphere`], [`mod@polygon`] |
//! | [`sphere_light_within`], [`polygon_light_within`] | the integral to a tolerance, its error and its price in chords | [`mod@sphere`] |
//! | [`sphere_light_chords`], [`polygon_light_chords`] | one to five chords, for a light that covers the band | [`mod@chord`] |
//! | [`sphere_light_wavelengths`], [`polygon_light_wavelengths`] | several wavelengths at once | [`mod@spectrum`] |
//! | [`sphere_light_channel`], [`polygon_light_channel`] | the mean of one chord over a channel | [`mod@spectrum`] |
//! | [`sphere_light_depth`], [`polygon_light_depth`], [`sphere_light_depth_chord`], [`polygon_light_depth_chord`] | the integral with the depth term of each direction inside; one chord of it in closed form | [`mod@depth`] |
//! | [`sphere_light_vwh18`], [`polygon_light_vwh18`] | the published method, its roots mended | [`mod@published`] |
//! | [`sphere_form_factor`], [`polygon_form_factor`], [`LinearCosine`] and its functions | the light on a diffuse base, and on one described by a linearly transformed cosine | [`mod@form_factor`] |
//!
//! # Example
//!
//! ```
//! use iridescence::diffraction::Coherence;
//! use iridescence::light::*;
//!
//! let lobe = ScratchLobe {
//!     coherence: Coherence { radius: 60.0, wavelength: 0.55 },
//!     width: 2.5,
//!     view: [0.1, -0.2],
//! };
//! // A lamp that ends inside the band: one chord misses it.
//! let lamp = Sphere { centre: [0.02, 0.3, 1.0], radius: 0.12 };
//! let exact = sphere_light(lobe, lamp);
//! let found = sphere_light_within(lobe, lamp, 1e-3);
//! assert!((found.value / exact - 1.0).abs() < 1e-3 && found.chords < 20.0);
//! assert_eq!(sphere_light_chords(lobe, lamp, 1), 0.0);
//! ```

mod band;
pub mod chord;
pub mod depth;
pub mod form_factor;
mod gauss_rule;
mod outline_integral;
pub mod polygon;
pub mod published;
pub mod scratch_lobe;
pub mod spectrum;
pub mod sphere;
mod wave;

#[doc(inline)]
pub use chord::{polygon_light_chords, sphere_light_chords};
#[doc(inline)]
pub use depth::{polygon_light_depth, polygon_light_depth_chord, sphere_light_depth, sphere_light_depth_chord};
#[doc(inline)]
pub use form_factor::{
    LinearCosine, linear_cosine_density, polygon_form_factor, polygon_form_factor_clipless, polygon_linear_cosine,
    sphere_form_factor, sphere_linear_cosine,
};
pub use outline_integral::LightIntegral;
#[doc(inline)]
pub use polygon::{polygon_light, polygon_light_within};
#[doc(inline)]
pub use published::{polygon_light_vwh18, sphere_light_vwh18};
#[doc(inline)]
pub use scratch_lobe::ScratchLobe;
#[doc(inline)]
pub use spectrum::{polygon_light_channel, polygon_light_wavelengths, sphere_light_channel, sphere_light_wavelengths};
#[doc(inline)]
pub use sphere::{Sphere, sphere_light, sphere_light_within};
