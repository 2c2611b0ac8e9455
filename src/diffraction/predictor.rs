//! How much of the scratch model a scene needs.
//!
//! # Definition
//!
//! A rule answers "is the cheaper form enough for this tolerance?" from bounds that hold for every scene. "Enough" is a
//! theorem; the proofs stand in `docs/predictors.md`. "Not enough" may be wrong: then a scene pays for more than it needs.
//!
//! | question | function | cost |
//! |---|---|---|
//! | is the infinite scratch enough at every xi1 | [`infinite_scratch_error`], [`scratch_half_length`] | two erfc; once a tolerance |
//! | is it enough at this xi1, relative to the infinite scratch | [`infinite_scratch_is_enough`] | one exp, seldom two |
//! | how far does a scratch reach | [`window_reach`] | once a tolerance |
//! | which footprint mean | [`footprint_method`] | no exp, one square root |
//! | does the interference of scratches matter | [`interference_bound`], [`interference_bound_set`], [`interference_separation`], [`incoherent_sum_is_enough`] | one exp, two for a set; none against the separation |
//! | does the interference of base and scratches matter | [`base_interference_bound`], [`base_interference_matters`] | one exp |
//! | is the depth term near normal enough | [`near_normal_depth_error`], [`near_normal_depth_amplitude_error`], [`near_normal_depth_is_enough`] | two to five sines |
//!
//! # Domain
//!
//! Radii, wavelengths and tolerances from 0 on. NaN in any argument gives NaN, no method, "not enough" or "matters": a
//! scene that is not understood gets the full model. Each function states its limits.
//!
//! # Methods
//!
//! All are closed forms. Where a comparison with the tolerance could fall to either side by rounding, the bound is
//! widened first.
//!
//! # Where it fails
//!
//! The bounds know moduli, not phases: terms that cancel by their phases are counted in full. The interference of
//! scratches is bounded as a share of their sum in the mean over the plane, and as a share of the peak at a point; as a
//! share of the sum at a point there is no bound, since half way between two scratches both are equally weak.
//!
//! # Errata
//!
//! WVJH17 culls scratches farther than 3 sigma from the shaded point. The amplitude there is exp(-9/2), over 1 %;
//! [`window_reach`] gives the distance for a tolerance.

mod footprint_choice;
mod interference;
mod near_normal;
mod scratch_ends;

pub use footprint_choice::{FootprintMethod, footprint_method};
pub use interference::{
    base_interference_bound, base_interference_matters, incoherent_sum_is_enough, interference_bound,
    interference_bound_set, interference_separation,
};
pub use near_normal::{near_normal_depth_amplitude_error, near_normal_depth_error, near_normal_depth_is_enough};
pub use scratch_ends::{infinite_scratch_error, infinite_scratch_is_enough, scratch_half_length, window_reach};

/// Returns a length over a scale from 0 on, with the limits: 0 over anything is 0, infinity infinite.
fn in_units(length: f64, scale: f64) -> f64 {
    if scale < 0.0 || scale.is_nan() {
        f64::NAN
    } else if length == 0.0 || length.is_infinite() {
        length
    } else {
        length / scale
    }
}

/// Returns sqrt(`factor` ln(1/tolerance)): where exp(-r^2/factor) falls to the tolerance.
fn gaussian_reach(factor: f64, tolerance: f64) -> f64 {
    if tolerance < 0.0 {
        f64::NAN
    } else if tolerance >= 1.0 {
        0.0
    } else {
        // The rounding of the root, outwards.
        libm::sqrt(-factor * libm::log(tolerance)) * (1.0 + 4.0 * f64::EPSILON)
    }
}
