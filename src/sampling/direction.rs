//! Directions of the hemisphere above the surface, random numbers and the reduced scales of the lobes.

use crate::diffraction::Coherence;
use core::f64::consts::{PI, TAU};

/// The density that needs no lobe: NaN where a component is NaN, 0 where a direction is below the surface.
#[inline]
pub(super) fn settled(incident: [f64; 3], outgoing: [f64; 3]) -> Option<f64> {
    if incident.iter().chain(&outgoing).any(|x| x.is_nan()) {
        Some(f64::NAN)
    } else if incident[2] < 0.0 || outgoing[2] < 0.0 {
        Some(0.0)
    } else {
        None
    }
}

/// Whether a draw is possible: the incident direction is above the surface and every number is in \[0, 1).
#[inline]
pub(super) fn is_sampled(incident: [f64; 3], random: &[f64]) -> bool {
    incident[2] >= 0.0 && random.iter().all(|u| (0.0..1.0).contains(u))
}

/// k sigma, the inverse of the reach of the window's lobe in direction cosines; NaN outside its domain.
#[inline]
pub(super) fn reduced_radius(coherence: Coherence) -> f64 {
    let Coherence { radius, wavelength } = coherence;
    let q = TAU * (radius / wavelength);
    if radius >= 0.0 && wavelength > 0.0 && q < f64::INFINITY {
        q
    } else {
        f64::NAN
    }
}

/// pi W/lambda, by which xi2 becomes the argument of sinc; NaN outside its domain.
#[inline]
pub(super) fn reduced_width(width: f64, wavelength: f64) -> f64 {
    let c = PI * (width / wavelength);
    if width >= 0.0 && wavelength > 0.0 && c < f64::INFINITY {
        c
    } else {
        f64::NAN
    }
}

/// sqrt(1 - x^2): how far the other direction cosines reach beside a given one; none where it leaves no room.
#[inline]
pub(super) fn reach(x: f64) -> Option<f64> {
    let square = (1.0 - x) * (1.0 + x);
    (square > 0.0).then(|| libm::sqrt(square))
}

/// The reach beside the tangent's component, from the two others.
#[inline]
pub(super) fn reach_of([_, y, z]: [f64; 3]) -> f64 {
    libm::sqrt(y * y + z * z)
}

/// The Gaussian along a scratch, q/sqrt(pi) exp(-(q xi1)^2): a density in direction cosines.
#[inline]
pub(super) fn gaussian(q: f64, xi1: f64) -> f64 {
    let y = q * xi1;
    q * libm::exp(-y * y) / libm::sqrt(PI)
}

/// pi W/lambda below which the lobe across a scratch is flat and squares of it vanish.
pub(super) const NARROW: f64 = 1e-100;

/// The density of a lobe that is the Gaussian along a scratch and `across`, of pi W/lambda, beta_i, beta_o and the reach
/// beside the tangent's component, a density of direction cosines, across it.
#[inline]
pub(super) fn scratch_pdf(
    coherence: Coherence,
    width: f64,
    [incident, outgoing]: [[f64; 3]; 2],
    across: impl Fn(f64, [f64; 2], f64) -> f64,
) -> f64 {
    let (q, c) = (reduced_radius(coherence), reduced_width(width, coherence.wavelength));
    if q.is_nan() || c.is_nan() {
        return f64::NAN;
    }
    if let Some(value) = settled(incident, outgoing) {
        return value;
    }
    let g = reach_of(outgoing);
    if g == 0.0 {
        return 0.0;
    }
    let density = if c < NARROW {
        0.5 / g
    } else {
        across(c, [incident[1], outgoing[1]], g)
    };
    gaussian(q, incident[0] + outgoing[0]) * density * outgoing[2]
}
