//! From the responses of scratches to a reflectance, in f32: coherent, incoherent, blended with the base.
//!
//! The f32 forms of [`diffraction::reflectance`](crate::diffraction::reflectance) and of
//! [`diffraction::area_density`](crate::diffraction::area_density()) with the kernel of the energy.

use super::elementary::*;
use super::faddeeva::INVERSE_ROOT_PI;
use super::gpu::*;
use super::profile::{depth_term_squared, width_term};
use super::sinc_squared_integral::ARC_PI;
use super::spatial_phase::window_cosine;

/// Returns the share of the window's energy on one infinite scratch at a distance: 1 for a full coverage.
#[inline(always)]
#[must_use]
pub fn area_density(width: f32, offset: f32, radius: f32) -> f32 {
    let r = offset / radius;
    (INVERSE_ROOT_PI * (width / radius)) * exponential(-(r * r))
}

/// Returns 1 - rho, the factor of the scratches' incoherent reflectance; a density above 1 counts as 1.
#[inline(always)]
#[must_use]
pub fn energy_blend_scratches(density: f32) -> f32 {
    select(1.0 - density, 0.0, density > 1.0)
}

/// Returns rho (1 - rho) times the squared depth term, the energy that scratches of an area density rho scatter: no factor.
///
/// A density above 1 counts as 1.
#[inline(always)]
#[must_use]
pub fn energy_blend_scattered(density: f32, depth_squared: f32) -> f32 {
    (density * energy_blend_scratches(density)) * depth_squared
}

/// Returns 1 - rho (1 - rho) times the squared depth term of the mirror direction, the factor of the base's reflectance.
#[inline(always)]
#[must_use]
pub fn energy_blend_base(density: f32, depth_squared: f32) -> f32 {
    1.0 - energy_blend_scattered(density, depth_squared)
}

/// Returns the sum of |S|^2 over A_C lambda^2, in 1/sr (VWH18 Eqs. 6 and 7).
#[inline(always)]
#[must_use]
pub fn reflectance_incoherent(radius: f32, wavelength: f32, squared_sum: f32) -> f32 {
    let size = radius * wavelength;
    squared_sum / (ARC_PI * (size * size))
}

/// Returns |B - S|^2/(A_C lambda^2), in 1/sr (VWH18 Eq. 1; Fresnel factor apart).
#[inline(always)]
#[must_use]
pub fn reflectance_coherent(radius: f32, wavelength: f32, base: f32, scratches_re: f32, scratches_im: f32) -> f32 {
    let re = base - scratches_re;
    reflectance_incoherent(radius, wavelength, re * re + scratches_im * scratches_im)
}

/// Returns the mean |S|^2 of an infinite rectangular scratch over a footprint, in the fourth power of the lengths' unit.
///
/// `mean` is that of the footprint, `footprint_mean`, or exp(-s_b^2/sigma^2) at a point (VWH18 Eqs. 9 and 16).
#[inline(always)]
#[must_use]
#[allow(clippy::too_many_arguments)]
pub fn scratch_squared(
    radius: f32,
    wavelength: f32,
    width: f32,
    depth: f32,
    xi_t: f32,
    xi_b: f32,
    gamma_sum: f32,
    mean: f32,
) -> f32 {
    let across = width_term(width, xi_b, wavelength);
    let deep = depth_term_squared(depth, gamma_sum, wavelength);
    let q = window_cosine(radius, wavelength, xi_t);
    let along = ((TWO_PI * radius) * radius) * exponential(-(q * q));
    ((across * across) * deep) * (along * mean)
}
