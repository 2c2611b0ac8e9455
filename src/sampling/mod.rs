//! Sampling of the lobes of a scratched surface: base, scratch, the published cone, and how to weigh them together.
//!
//! Directions are unit vectors in the frame of a scratch (tangent, bitangent, normal), away from the surface; densities
//! are per steradian; random numbers are uniform in \[0, 1). A density of a direction below the surface is 0.
//!
//! | strategy | density and sample | follows |
//! |---|---|---|
//! | [`mod@base_lobe`] | [`base_lobe_pdf`], [`base_lobe_sample`] | \|B\|^2 of the bare surface |
//! | [`mod@scratch_lobe`] | [`scratch_lobe_pdf`], [`scratch_lobe_sample`] | the lobe of a scratch for all wavelengths at once |
//! | [`mod@sinc_lobe`] | [`scratch_sinc_pdf`], [`scratch_sinc_sample`] | the lobe of a scratch at one wavelength |
//! | [`mod@scratch_cone`] | [`scratch_cone_pdf`], [`scratch_cone_sample`] | the lobe that WVJH17 publishes |
//!
//! [`mod@weight`] joins several.

pub mod base_lobe;
mod direction;
pub mod gaussian;
pub mod scratch_cone;
pub mod scratch_lobe;
pub mod sinc_lobe;
pub mod sinc_squared;
pub mod weight;

#[doc(inline)]
pub use base_lobe::{base_lobe_pdf, base_lobe_sample};
#[doc(inline)]
pub use gaussian::gaussian_inverse;
#[doc(inline)]
pub use scratch_cone::{scratch_cone_pdf, scratch_cone_sample, von_mises_fisher_pdf};
#[doc(inline)]
pub use scratch_lobe::{scratch_lobe_pdf, scratch_lobe_sample};
#[doc(inline)]
pub use sinc_lobe::{scratch_sinc_pdf, scratch_sinc_sample};
#[doc(inline)]
pub use sinc_squared::{sinc_squared_cdf, sinc_squared_inverse};
#[doc(inline)]
pub use weight::{Choice, Strategy, balance_weight, choose_strategy, mixture_pdf, power_weight};

/// A sampled direction.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sample {
    /// The direction, a unit vector away from the surface.
    pub direction: [f64; 3],
    /// Its density, in 1/sr.
    pub pdf: f64,
}
