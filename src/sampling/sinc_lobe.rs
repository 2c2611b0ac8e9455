//! The exact lobe of a rectangular scratch: a Gaussian along it and sinc^2 across.
//!
//! # Definition
//!
//! ```math
//! p(\omega_o) = \frac{k\sigma}{\sqrt\pi}\, e^{-(k\sigma\xi_1)^2} \cdot \frac{c}{m(\alpha_o)}\,\mathrm{sinc}^2(c\,\xi_2) \cdot \gamma_o, \qquad c = \frac{\pi W}{\lambda}
//! ```
//!
//! m is the integral of sinc^2 over the interval of x = c xi2 that propagates beside the drawn component along the
//! tangent, |beta_o| < sqrt(1 - alpha_o^2).
//!
//! # Domain
//!
//! As [`scratch_lobe`](super::scratch_lobe). At width 0 the lobe across is uniform in beta_o.
//!
//! # Methods
//!
//! The distribution function of the cut lobe is [`sinc_squared_integral()`] from its lower end; its inverse is that of
//! [`sinc_squared_inverse`](super::sinc_squared_inverse()), from the centre or from the tail, whichever keeps the digits.
//!
//! # Where it fails
//!
//! The density has zeros. At the width and wavelength of the draw the weight of the scratch's energy is constant but for
//! m; at any other width or wavelength it is unbounded. Use it for one wavelength and one width, or beside
//! [`scratch_lobe`](super::scratch_lobe) in a mixture.
//!
//! # Errata
//!
//! None: the lobe is not in the papers.

use super::Sample;
use super::direction::{NARROW, is_sampled, reach, reduced_radius, reduced_width, scratch_pdf};
use super::gaussian_inverse;
use super::sinc_squared::{inverse_from_centre, inverse_from_tail};
use crate::diffraction::Coherence;
use crate::special::{sinc, sinc_squared_integral};

/// Half the interval that propagates over the distance of its middle from the lobe's, up to which the lobe is even.
const EVEN: f64 = 1e-8;

/// Returns the density of `outgoing` given `incident`, in 1/sr; the width of the scratch in um.
///
/// Unit vectors in the scratch frame, away from the surface. It integrates to the share of draws that propagate.
#[must_use]
pub fn scratch_sinc_pdf(coherence: Coherence, width: f64, incident: [f64; 3], outgoing: [f64; 3]) -> f64 {
    scratch_pdf(coherence, width, [incident, outgoing], |c, [beta_i, beta_o], g| {
        if is_flat(c, beta_i, g) {
            return 0.5 / g;
        }
        let height = sinc(c * (beta_i + beta_o));
        c * height * height / sinc_squared_integral([c * (beta_i - g), c * (beta_i + g)])
    })
}

/// Returns a direction and its density; none for an evanescent draw, which counts as zero.
///
/// `random`: two uniform numbers of \[0, 1), for the components along and across the scratch.
#[must_use]
pub fn scratch_sinc_sample(coherence: Coherence, width: f64, incident: [f64; 3], random: [f64; 2]) -> Option<Sample> {
    let (q, c) = (reduced_radius(coherence), reduced_width(width, coherence.wavelength));
    if !is_sampled(incident, &random) {
        return None;
    }
    let along = gaussian_inverse(random[0]) / q - incident[0];
    let g = reach(along)?;
    let beta = if c < NARROW || is_flat(c, incident[1], g) {
        g * (2.0 * random[1] - 1.0)
    } else {
        inverse_between([c * (incident[1] - g), c * (incident[1] + g)], random[1]) / c - incident[1]
    };
    let square = (g - beta) * (g + beta);
    // Also false for a NaN.
    if square > 0.0 {
        let direction = [along, beta, libm::sqrt(square)];
        let pdf = scratch_sinc_pdf(coherence, width, incident, direction);
        Some(Sample { direction, pdf })
    } else {
        None
    }
}

/// Whether the interval that propagates is so short that the lobe is even over it, and its ends would round to one.
#[inline]
fn is_flat(c: f64, beta: f64, g: f64) -> bool {
    c * g <= EVEN * (1.0 + (c * beta).abs())
}

/// The x below which the share u of the integral from `low` to `high` lies.
fn inverse_between([low, high]: [f64; 2], u: f64) -> f64 {
    let mass = sinc_squared_integral([low, high]);
    if low >= 1.0 {
        inverse_from_tail(sinc_squared_integral([high, f64::INFINITY]) + (1.0 - u) * mass)
    } else if high <= -1.0 {
        -inverse_from_tail(sinc_squared_integral([f64::NEG_INFINITY, low]) + u * mass)
    } else {
        let v = sinc_squared_integral([0.0, low]) + u * mass;
        inverse_from_centre(v.abs()).copysign(v)
    }
}
