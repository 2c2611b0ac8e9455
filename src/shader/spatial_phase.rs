//! The spatial phase eta of a scratch, the coherence window and the base response, in f32.
//!
//! The f32 forms of [`diffraction::spatial_phase`](crate::diffraction::spatial_phase()) and
//! [`diffraction::coherence`](crate::diffraction::coherence). Lengths share one unit; radii from 0, at which eta is 0;
//! finite cosines. The phases of the ends and of the offset are reduced in turns before they are rounded: the place of a
//! scratch costs no digits until the phase of its origin passes 4096 turns; beyond, it costs them in proportion.
//! `tests/diffraction_shader/spatial_phase.rs` holds the errors on either side.

use super::elementary::*;
use super::erf_difference::erf_difference_scaled_turns;
use super::faddeeva::Complex;
use super::gpu::select;
use super::turns::ratio_turns;

/// 1/sqrt(2).
pub(super) const INVERSE_ROOT_TWO: f32 = 0.70710677;
/// sqrt(2) pi.
pub(super) const ROOT_TWO_TIMES_PI: f32 = 4.442883;
/// 1/sqrt(2 pi).
pub(super) const INVERSE_ROOT_TWO_PI: f32 = 0.3989423;
/// sqrt(pi/2).
pub(super) const ROOT_HALF_PI: f32 = 1.2533141;
/// sqrt(2 pi).
pub(super) const ROOT_TWO_PI: f32 = 2.5066283;

/// Returns a place over a radius, 0 of 0.
#[inline(always)]
pub(super) fn in_radii(place: f32, radius: f32) -> f32 {
    select(place / radius, place, place == 0.0)
}

/// Returns exp(-r^2/(2 sigma^2)), the coherence window at a distance (WVJH17 Eq. 13).
#[inline(always)]
#[must_use]
pub fn coherence_window(offset: f32, radius: f32) -> f32 {
    let r = in_radii(offset, radius);
    exponential(-0.5 * (r * r))
}

/// Returns the share of the window's amplitude on one infinite scratch at a distance: 1 for a full coverage (VWH18 Eq. 17,
/// normalised). [`area_density`](super::area_density) is the share of its energy.
#[inline(always)]
#[must_use]
pub fn area_density_amplitude(width: f32, offset: f32, radius: f32) -> f32 {
    let r = offset / radius;
    (INVERSE_ROOT_TWO_PI * (width / radius)) * exponential(-0.5 * (r * r))
}

/// Returns sigma k xi, the direction cosine in widths of the transformed window.
#[inline(always)]
pub(super) fn window_cosine(radius: f32, wavelength: f32, xi: f32) -> f32 {
    (TWO_PI * radius) * (xi / wavelength)
}

/// Returns a modulus times exp(-2 pi i a b/c), 0 where the modulus is 0.
#[inline(always)]
pub(super) fn turned_back(modulus: f32, a: f32, b: f32, c: f32) -> Complex {
    let phase = sine_cosine_turns(select(ratio_turns(a, b, c).rest, 0.0, modulus == 0.0));
    Complex {
        re: modulus * phase.cosine,
        im: -(modulus * phase.sine),
    }
}

/// Returns eta of a finite scratch, in the unit of the lengths (VWH18 Eq. 5).
///
/// `radius` is sigma, `s_t` and `s_b` the scratch's origin along and across it from the shaded point, `l_from` and `l_to`
/// its ends from the origin, infinite ones allowed; `xi_t` and `xi_b` the scattering vector along and across.
#[inline(always)]
#[must_use]
#[allow(clippy::too_many_arguments)]
pub fn spatial_phase(
    radius: f32,
    wavelength: f32,
    xi_t: f32,
    xi_b: f32,
    s_t: f32,
    s_b: f32,
    l_from: f32,
    l_to: f32,
) -> Complex {
    let height = (ROOT_TWO_TIMES_PI * radius) * (xi_t / wavelength);
    let origin = ratio_turns(s_t, xi_t, wavelength).rest;
    let along = erf_difference_scaled_turns(
        INVERSE_ROOT_TWO * in_radii(s_t + l_from, radius),
        INVERSE_ROOT_TWO * in_radii(s_t + l_to, radius),
        height,
        origin + ratio_turns(l_from, xi_t, wavelength).rest,
        origin + ratio_turns(l_to, xi_t, wavelength).rest,
    );
    let across = turned_back(
        (ROOT_HALF_PI * radius) * coherence_window(s_b, radius),
        s_b,
        xi_b,
        wavelength,
    );
    Complex {
        re: along.re * across.re - along.im * across.im,
        im: along.re * across.im + along.im * across.re,
    }
}

/// Returns eta of an infinite scratch at the distance `s_b` (VWH18 Eq. 8).
#[inline(always)]
#[must_use]
pub fn spatial_phase_infinite(radius: f32, wavelength: f32, xi_t: f32, xi_b: f32, s_b: f32) -> Complex {
    let r = in_radii(s_b, radius);
    let q = window_cosine(radius, wavelength, xi_t);
    let modulus = (ROOT_TWO_PI * radius) * exponential(-0.5 * (r * r + q * q));
    turned_back(modulus, s_b, xi_b, wavelength)
}

/// Returns |eta|^2 of an infinite scratch at the distance `s_b` (VWH18 Eq. 9).
#[inline(always)]
#[must_use]
pub fn spatial_phase_infinite_squared(radius: f32, wavelength: f32, xi_t: f32, s_b: f32) -> f32 {
    let r = in_radii(s_b, radius);
    let q = window_cosine(radius, wavelength, xi_t);
    ((TWO_PI * radius) * radius) * exponential(-(r * r + q * q))
}

/// Returns 2 pi sigma^2 exp(-(sigma k |xi|)^2/2), the transform of the window (WVJH17 Eq. 16).
#[inline(always)]
#[must_use]
pub fn base_response(radius: f32, wavelength: f32, xi_t: f32, xi_b: f32) -> f32 {
    let along = window_cosine(radius, wavelength, xi_t);
    let across = window_cosine(radius, wavelength, xi_b);
    ((TWO_PI * radius) * radius) * exponential(-0.5 * (along * along + across * across))
}
