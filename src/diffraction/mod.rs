//! Diffraction by scratches: profiles, spatial phase, coherence, footprint, area density, reflectance, predictors
//! (VWH18 3.1 to 3.3, WVJH17).
//!
//! Vectors stand in the frame of a scratch: tangent t, bitangent b, normal n. The scattering vector is omega_i + omega_o,
//! both pointing away from the surface: components (xi1, xi2, gamma_i + gamma_o). Lengths are in micrometres, the time
//! factor is e^{-i omega t}, depths are positive below the surface.
//!
//! A scratch responds with S = profile times spatial phase, both of them Fourier integrals: the profile's across the
//! scratch, the coherence window's along it. The surface without scratches responds with B. The reflectance is
//! |B - S_1 - S_2 - ...|^2/(A_C lambda^2), or the sum of squares where the interference averages out.
//!
//! | function | what it returns | page |
//! |---|---|---|
//! | [`coherence_window()`], [`coherence_area`], [`coherence_degree`] | the window exp(-r^2/(2 sigma^2)), its area pi sigma^2, the degree of coherence at a separation | [`mod@coherence`] |
//! | [`coherence_radius`], [`angular_diameter`] | sigma from the light's angular diameter, and back | [`mod@coherence`] |
//! | [`base_response`] | B, the response of the bare surface | [`mod@coherence`] |
//! | [`width_term`] | W sinc, the transform of the mask | [`mod@profile`] |
//! | [`depth_term`], [`depth_term_squared`], [`depth_term_near_normal`], [`depth_term_near_normal_squared`] | 1 - exp(ip) and its squared modulus, exact and near normal | [`mod@profile`] |
//! | [`profile_rectangle`], [`response_rectangle_windowed`] | the response of a rectangle, and the same with the window across it | [`mod@profile`] |
//! | [`profile_triangle`], [`response_triangle`] | the transform of a triangular groove, and its response | [`mod@triangle`] |
//! | [`spatial_phase()`], [`windowed_transform`] | eta of a finite scratch, and its integral along the line | [`mod@spatial_phase`] |
//! | [`spatial_phase_infinite`], [`spatial_phase_infinite_squared`] | eta of an infinite scratch | [`mod@spatial_phase`] |
//! | [`spatial_phase_varying`], [`response_rectangle_varying`] | the same for a depth that varies along the scratch | [`mod@depth_variation`] |
//! | [`segment_energy()`] | the energy of a segment over the whole plane | [`mod@segment_energy`] |
//! | [`footprint_mean()`], [`footprint_mean_medium`], [`footprint_mean_coarse`], [`footprint_mean_vwh18`] | the mean of exp(-s_b^2/sigma^2) over the ellipse of a pixel | [`mod@footprint`] |
//! | [`footprint_mean_reduced`], [`footprint_mean_reduced_medium`], [`footprint_mean_reduced_coarse`] | the same in radii | [`mod@footprint`] |
//! | [`footprint_half_width`], [`footprint_segment_mean`] | the ellipse across the scratch; the mean for a finite segment | [`mod@footprint`] |
//! | [`area_density()`], [`area_density_footprint`], [`area_density_union`] | the share of the surface that scratches cover | [`mod@area_density`] |
//! | [`reflectance_coherent`], [`reflectance_incoherent`], [`scratch_squared`] | reflectances, and one scratch's share of the incoherent one | [`mod@reflectance`] |
//! | [`base_interference`], [`crossing_response`], [`energy_blend`], [`energy_blend_depths`] | interference with the base, crossings, the blend that keeps energy | [`mod@reflectance`] |
//! | [`infinite_scratch_is_enough`], [`window_reach`], [`footprint_method`], [`incoherent_sum_is_enough`], [`base_interference_matters`], [`near_normal_depth_is_enough`] and their bounds | how much of all this a scene needs | [`mod@predictor`] |
//!
//! # Example
//!
//! The colours of one scratch under the sun: its reflectance at three wavelengths, seen in the plane across it.
//!
//! ```
//! use iridescence::diffraction::*;
//!
//! let scratch = Profile { width: 2.5, depth: 0.2 };
//! let colours = [0.45, 0.55, 0.65].map(|wavelength| {
//!     let light = Coherence { radius: coherence_radius(0.53_f64.to_radians(), wavelength), wavelength };
//!     let scattering = [0.0, 0.3, 1.9];
//!     reflectance_incoherent(light, scratch_squared(light, scratch, scattering, 1.0))
//! });
//! // Green: its first side lobe points there.
//! assert!(colours[1] > 2.5 * colours[0] && colours[1] > 2.5 * colours[2]);
//! ```

pub mod area_density;
pub mod coherence;
pub mod depth_variation;
pub mod footprint;
mod footprint_tables;
mod limits;
pub mod predictor;
pub mod profile;
pub mod reflectance;
pub mod segment_energy;
pub mod spatial_phase;
pub mod triangle;

#[doc(inline)]
pub use area_density::{AreaKernel, area_density, area_density_footprint, area_density_union};
#[doc(inline)]
pub use coherence::{
    Coherence, angular_diameter, base_response, coherence_area, coherence_degree, coherence_radius, coherence_window,
};
#[doc(inline)]
pub use depth_variation::{DepthAlong, response_rectangle_varying, spatial_phase_varying};
#[doc(inline)]
pub use footprint::{
    Footprint, footprint_half_width, footprint_mean, footprint_mean_coarse, footprint_mean_medium,
    footprint_mean_reduced, footprint_mean_reduced_coarse, footprint_mean_reduced_medium, footprint_mean_vwh18,
    footprint_segment_mean, footprint_segment_mean_hard,
};
#[doc(inline)]
pub use predictor::{
    FootprintMethod, base_interference_bound, base_interference_matters, footprint_method, incoherent_sum_is_enough,
    infinite_scratch_error, infinite_scratch_is_enough, interference_bound, interference_bound_set,
    interference_separation, near_normal_depth_amplitude_error, near_normal_depth_error, near_normal_depth_is_enough,
    scratch_half_length, window_reach,
};
#[doc(inline)]
pub use profile::{
    Profile, depth_term, depth_term_near_normal, depth_term_near_normal_squared, depth_term_squared, profile_rectangle,
    response_rectangle_windowed, width_term,
};
#[doc(inline)]
pub use reflectance::{
    EnergyBlend, base_interference, crossing_response, energy_blend, energy_blend_depths, reflectance_coherent,
    reflectance_incoherent, scratch_squared,
};
#[doc(inline)]
pub use segment_energy::segment_energy;
#[doc(inline)]
pub use spatial_phase::{
    Segment, spatial_phase, spatial_phase_infinite, spatial_phase_infinite_squared, windowed_transform,
};
#[doc(inline)]
pub use triangle::{profile_triangle, response_triangle};
