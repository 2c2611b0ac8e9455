//! Profiles across a scratch: the depth term, and the Fourier transform of a rectangular groove.
//!
//! # Definition
//!
//! Light that meets a groove of depth D(b) instead of the surface comes back with the phase
//! exp(i k (gamma_i + gamma_o) D(b)). The mask, the groove and what the groove changes, the response, have the transforms
//!
//! ```math
//! M = \int_{-W/2}^{W/2} e^{-ik\xi_2 b}\,db = W\,\mathrm{sinc}\frac{\pi W \xi_2}{\lambda}, \qquad
//! F = \int_{-W/2}^{W/2} e^{ip(b) - ik\xi_2 b}\,db, \qquad M - F
//! ```
//!
//! with p(b) = 2 pi (gamma_i + gamma_o) D(b)/lambda and k = 2 pi/lambda. A rectangle has D(b) = D and the response
//! M (1 - exp(ip)) ([`profile_rectangle`]; VWH18 Eqs. 3 and 4, WVJH17 Eq. 20). The triangle has a page of its own,
//! [`triangle`](mod@super::triangle).
//!
//! # Domain
//!
//! Width >= 0 and wavelength > 0, in micrometres; any depth (negative: a ridge), any xi_2 and gamma_i + gamma_o. Outside
//! NaN, and NaN for NaN. Width 0 gives 0, depth 0 no response; an infinite xi_2 gives 0; an infinite wavelength leaves no
//! phase. Infinite width, depth or gamma_i + gamma_o have no limit: NaN.
//!
//! # Methods
//!
//! Phases are reduced from exact products, so that depths and widths of many wavelengths lose nothing.
//! [`response_rectangle_windowed`] has the coherence window across the width as well, by a second difference of error
//! functions: the window is separable, and so is the rectangle.
//!
//! <!-- report:begin profile_rectangle -->
//!
//! | method | what it is | precision | largest error | promise | time / baseline |
//! |---|---|---|---|---|---|
//! | `accurate` | iridescence f64 | f64 | 1.6e-15 of peak | 3e-15 of peak | 1.27 (as_printed) |
//! | `accurate` | iridescence f32 | f32 | 5.3e-7 of peak | 1e-6 of peak | 1.00 (accurate) |
//! | `accurate`, slice | iridescence f32 slices | f32 | 5.3e-7 of peak | 1e-6 of peak | 0.05 (accurate, scalar) |
//! | `as_printed` | VWH18 Eq. 3, depth of WVJH17 Eq. 20 | f64 | 2.2e294 rel. | none | 1.00 (as_printed) |
//! | `as_printed_near_normal` | VWH18 Eqs. 3 and 4: the depth near normal | f64 | not finite rel. | none | 0.97 (as_printed) |
//!
//! <!-- report:end profile_rectangle -->
//!
//! # Where it fails
//!
//! The product of profile and spatial phase takes the window to be constant across the width. That costs a share of
//! about (W/sigma)^2/24 on the line, and W s_b/sigma^2 times the slope of the lobe beside it, where
//! [`response_rectangle_windowed`] is exact.
//!
//! # Errata
//!
//! - VWH18 Eq. 4 has the phase 4 pi D/lambda. That is the exact 2 pi (gamma_i + gamma_o) D/lambda at normal incidence and
//!   observation only: [`depth_term_near_normal`].
//! - WVJH17 Eq. 19 divides by lambda twice. Its Eq. 20 and Eqs. 25 and 28 have opposite signs of the depth's phase; Eq. 20 is
//!   the one that goes with exp(-i omega t) and positive depths below the surface. The sign counts in |B - S|^2 alone.

use super::coherence::Coherence;
use super::limits::{FLAT, NAN};
use super::spatial_phase::{Segment, windowed_transform};
use crate::numeric::turns::{sine_cosine_of_turns, sine_of_half_turns, turns_of_ratio};
use core::f64::consts::PI;
use num_complex::Complex;

/// The cross-section of a scratch. Lengths in micrometres.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Profile {
    /// Width W, at least 0.
    #[doc(alias = "W")]
    pub width: f64,
    /// Depth D, positive below the surface.
    #[doc(alias = "D")]
    pub depth: f64,
}

/// sin(pi u)/(pi u) from u and sin(pi u).
#[inline(always)]
pub(super) fn sinc_of_half_turns(u: f64, sine: f64) -> f64 {
    if u.abs() < FLAT { 1.0 } else { sine / (PI * u) }
}

/// Returns W sinc(pi W xi2/lambda), in um: the transform of the width, which is that of the mask.
///
/// Width and wavelength in um. Relative error a few eps, also beside the zeros. VWH18 Eq. 3, WVJH17 Eqs. 14 and 26.
#[doc(alias = "mask")]
#[must_use]
#[inline]
pub fn width_term(width: f64, xi2: f64, wavelength: f64) -> f64 {
    if !((0.0..f64::INFINITY).contains(&width) && wavelength > 0.0) {
        return f64::NAN;
    }
    let (half_turns, sine) = sine_of_half_turns(width, xi2, wavelength);
    if half_turns.is_infinite() || (width == 0.0 && xi2.is_infinite()) {
        return 0.0;
    }
    width * sinc_of_half_turns(half_turns, sine)
}

/// Returns the depth term 1 - exp(2 pi i (gamma_i + gamma_o) D/lambda), dimensionless.
///
/// Relative error a few eps whatever the depth: 1 is never subtracted. WVJH17 Eq. 20.
///
/// ```
/// use iridescence::diffraction::depth_term;
///
/// // A quarter of the wavelength, seen and lit from above: the groove is dark against its surroundings.
/// assert_eq!(depth_term(0.125, 2.0, 0.5).norm_sqr(), 4.0);
/// ```
#[must_use]
#[inline]
pub fn depth_term(depth: f64, gamma_sum: f64, wavelength: f64) -> Complex<f64> {
    let (sine, cosine) = half_phase(depth, gamma_sum, wavelength);
    // -2 i sin(phi/2) exp(i phi/2).
    Complex::new(2.0 * (sine * sine), -2.0 * (sine * cosine))
}

/// Sine and cosine of pi gamma D/lambda, up to a common sign.
#[inline(always)]
fn half_phase(depth: f64, gamma_sum: f64, wavelength: f64) -> (f64, f64) {
    if wavelength.is_nan() || wavelength <= 0.0 {
        return (f64::NAN, f64::NAN);
    }
    sine_cosine_of_turns(0.5 * turns_of_ratio(gamma_sum, depth, wavelength))
}

/// Returns |1 - exp(2 pi i (gamma_i + gamma_o) D/lambda)|^2 = 4 sin^2(pi (gamma_i + gamma_o) D/lambda), from 0 to 4.
///
/// The squared modulus of [`depth_term`]: WVJH17 Eq. 20, squared; VWH18 Eq. 11 is its value at gamma_i + gamma_o = 2.
#[must_use]
#[inline]
pub fn depth_term_squared(depth: f64, gamma_sum: f64, wavelength: f64) -> f64 {
    let (sine, _) = half_phase(depth, gamma_sum, wavelength);
    // The sine may round beyond 1.
    let squared = 4.0 * (sine * sine);
    if squared > 4.0 { 4.0 } else { squared }
}

/// Returns 1 - exp(4 pi i D/lambda), the depth term at normal incidence and observation.
///
/// [`near_normal_depth_error`](super::near_normal_depth_error) bounds what it costs elsewhere. VWH18 Eq. 4.
#[must_use]
#[inline]
pub fn depth_term_near_normal(depth: f64, wavelength: f64) -> Complex<f64> {
    depth_term(depth, 2.0, wavelength)
}

/// Returns 2 - 2 cos(4 pi D/lambda), the square of [`depth_term_near_normal`]. VWH18 Eq. 11.
#[must_use]
#[inline]
pub fn depth_term_near_normal_squared(depth: f64, wavelength: f64) -> f64 {
    depth_term_squared(depth, 2.0, wavelength)
}

/// Returns W sinc(pi W xi2/lambda) (1 - exp(2 pi i (gamma_i + gamma_o) D/lambda)), in um: the response of a rectangle,
/// mask less scratch.
///
/// `scattering` is (xi1, xi2, gamma_i + gamma_o). Relative error a few eps, also beside the zeros. VWH18 Eqs. 3 and 4.
///
/// ```
/// use iridescence::diffraction::{Profile, profile_rectangle};
///
/// let scratch = Profile { width: 2.0, depth: 0.1 };
/// // The lobe is as wide as lambda/W.
/// let centre = profile_rectangle(scratch, [0.0, 0.0, 1.9], 0.5).norm();
/// let edge = profile_rectangle(scratch, [0.0, 0.25, 1.9], 0.5).norm();
/// assert!(centre > 1.8 && edge == 0.0);
/// ```
#[must_use]
#[inline]
pub fn profile_rectangle(profile: Profile, scattering: [f64; 3], wavelength: f64) -> Complex<f64> {
    depth_term(profile.depth, scattering[2], wavelength) * width_term(profile.width, scattering[1], wavelength)
}

/// Returns the response of a rectangular scratch with the window across its width as well, in um^2: no separability of
/// profile and window assumed.
///
/// The exact transform, under the window, of what the scratch changes:
///
/// ```math
/// \left(1 - e^{ip}\right) \int_{s_t+l_1}^{s_t+l_2} e^{-t^2/2\sigma^2 - ik\xi_1 t}\,dt
/// \int_{s_b-W/2}^{s_b+W/2} e^{-b^2/2\sigma^2 - ik\xi_2 b}\,db
/// ```
///
/// [`profile_rectangle`] times [`spatial_phase`](super::spatial_phase()) replaces the second integral by its integrand's
/// window and phase at s_b times W sinc(pi W xi2/lambda): the limit for W much less than sigma. Error a few eps
/// of the largest modulus, that of the whole plane 2 pi sigma^2; s_b ± W/2 are rounded, so that a width keeps its digits down
/// to a rounding of s_b. NaN for a negative width; an infinite one is the whole plane. No paper has it; WVJH17 4.2
/// neglects it.
#[must_use]
pub fn response_rectangle_windowed(
    coherence: Coherence,
    profile: Profile,
    segment: Segment,
    scattering: [f64; 3],
) -> Complex<f64> {
    if profile.width.is_nan() || profile.width < 0.0 {
        return NAN;
    }
    let across = segment.position[1];
    let half = 0.5 * profile.width;
    windowed_transform(coherence, segment.span(), scattering[0])
        * windowed_transform(coherence, [across - half, across + half], scattering[1])
        * depth_term(profile.depth, scattering[2], coherence.wavelength)
}
