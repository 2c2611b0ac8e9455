//! The published lobe of a scratch: a von Mises-Fisher lobe about the mirrored cone around the tangent.
//!
//! # Definition
//!
//! ```math
//! p(\omega_o) = 2\,\frac{\kappa}{4\pi\sinh\kappa}\, e^{-\kappa c_i c_o} I_0(\kappa s_i s_o)
//! ```
//!
//! c and s are the cosine and sine of the angle to the tangent. WVJH17 section 5, after d'Eon et al. 2011: a ray is
//! mirrored by an ideal cylinder along the tangent into any azimuth and then perturbed by a von Mises-Fisher offset;
//! what would enter the surface is mirrored at it, which doubles the density above.
//!
//! # Domain
//!
//! 0 <= concentration < inf; 0 is uniform, 1/(2 pi) above the surface. NaN and no sample elsewhere: an infinite
//! concentration is a Dirac lobe. A direction below the surface has the density 0.
//!
//! # Methods
//!
//! The three growing factors are one falling exponential and the scaled Bessel function:
//!
//! ```math
//! p = \frac{\kappa}{\pi (1 - e^{-2\kappa})}\, e^{-\frac{\kappa}{2}\left[(c_i + c_o)^2 + (s_i - s_o)^2\right]}\, e^{-z} I_0(z), \qquad z = \kappa s_i s_o
//! ```
//!
//! The exponent is a sum of squares: 1 + c_i c_o - s_i s_o would cancel on the lobe.
//!
//! # Where it fails
//!
//! As a lobe for scratches: its azimuth is uniform, while the light of a scratch lies in the lobe of sinc^2;
//! [`scratch_lobe`](super::scratch_lobe) follows that. As a function: nowhere known.
//!
//! # Errata
//!
//! The printed form is right. In floating point sinh and I0 overflow from a concentration of about 710 on.

use super::Sample;
use super::direction::{is_sampled, reach_of, settled};
use crate::special::bessel_i0_scaled;
use core::f64::consts::{PI, TAU};

/// Returns kappa/(1 - e^(-2 kappa)), 1/2 at 0; NaN outside the domain.
#[inline]
fn amplitude(concentration: f64) -> f64 {
    if concentration == 0.0 {
        0.5
    } else if concentration > 0.0 && concentration < f64::INFINITY {
        concentration / -libm::expm1(-2.0 * concentration)
    } else {
        f64::NAN
    }
}

/// Returns kappa/(4 pi sinh kappa) exp(kappa cos), the von Mises-Fisher density on the sphere, in 1/sr.
///
/// `concentration` >= 0 and finite, `cosine` of the angle to the lobe's axis. 1/(4 pi) at concentration 0.
///
/// ```
/// use iridescence::sampling::von_mises_fisher_pdf;
/// assert_eq!(von_mises_fisher_pdf(0.0, 0.3), 0.25 / core::f64::consts::PI);
/// assert_eq!(von_mises_fisher_pdf(1e6, 1.0), 1e6 / core::f64::consts::TAU);
/// ```
#[must_use]
pub fn von_mises_fisher_pdf(concentration: f64, cosine: f64) -> f64 {
    if (-1.0..=1.0).contains(&cosine) {
        amplitude(concentration) / TAU * libm::exp(-concentration * (1.0 - cosine))
    } else {
        f64::NAN
    }
}

/// Returns the density of `outgoing` given `incident` on the upper hemisphere, in 1/sr; even in the bitangent.
///
/// Unit vectors in the scratch frame, away from the surface. WVJH17 section 5.
#[must_use]
pub fn scratch_cone_pdf(concentration: f64, incident: [f64; 3], outgoing: [f64; 3]) -> f64 {
    let amplitude = amplitude(concentration);
    if amplitude.is_nan() {
        return amplitude;
    }
    if let Some(value) = settled(incident, outgoing) {
        return value;
    }
    let (s_i, s_o) = (reach_of(incident), reach_of(outgoing));
    let (sum, difference) = (incident[0] + outgoing[0], s_i - s_o);
    let decay = 0.5 * concentration * (sum * sum + difference * difference);
    amplitude / PI * libm::exp(-decay) * bessel_i0_scaled(concentration * s_i * s_o)
}

/// Returns a direction on the upper hemisphere and its density; none outside the domain.
///
/// `random`: three uniform numbers of \[0, 1): the offset's size, its azimuth, the azimuth around the tangent.
#[must_use]
pub fn scratch_cone_sample(concentration: f64, incident: [f64; 3], random: [f64; 3]) -> Option<Sample> {
    if !is_sampled(incident, &random) || !(0.0..f64::INFINITY).contains(&concentration) {
        return None;
    }
    // 1 - cos of the offset.
    let versine = if concentration == 0.0 {
        2.0 * random[0]
    } else {
        -libm::log1p(random[0] * libm::expm1(-2.0 * concentration)) / concentration
    };
    let versine = versine.min(2.0);
    let (cosine, sine) = (1.0 - versine, libm::sqrt(versine * (2.0 - versine)));
    let (turn_sine, turn_cosine) = libm::sincos(TAU * random[1]);
    let (c, s) = (-incident[0], reach_of(incident));
    // The offset direction: along the tangent, along the mirrored ray's own part across it, and beside both.
    let along = c * cosine - s * (sine * turn_cosine);
    let across = s * cosine + c * (sine * turn_cosine);
    let beside = sine * turn_sine;
    let radius = libm::sqrt(across * across + beside * beside);
    // All azimuths are alike, so that of the offset need not be added.
    let (height, side) = libm::sincos(PI * random[2]);
    let direction = [along, radius * side, radius * height];
    let pdf = scratch_cone_pdf(concentration, incident, direction);
    // Also false for a NaN.
    (pdf >= 0.0).then_some(Sample { direction, pdf })
}
