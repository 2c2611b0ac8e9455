//! A lobe for one scratch: a Gaussian along it and a Lorentzian across.
//!
//! # Definition
//!
//! ```math
//! p(\omega_o) = \frac{k\sigma}{\sqrt\pi}\, e^{-(k\sigma\xi_1)^2} \cdot \frac{c}{\vartheta(\alpha_o)}\,\frac{1}{1 + x^2} \cdot \gamma_o, \qquad x = c\,\xi_2,\quad c = \frac{\pi W}{\lambda}
//! ```
//!
//! The energy of a scratch is exp(-(k sigma xi1)^2) sinc^2 x (VWH18 Eqs. 3 and 9). The Gaussian is drawn exactly; the
//! Lorentzian 1/(1 + x^2) stays above sinc^2 x divided by 1.478. It is cut to the directions that exist: beside the drawn
//! component along the tangent, |beta_o| < sqrt(1 - alpha_o^2), and theta is the Lorentzian's angle over that interval,
//! atan x1 - atan x0.
//!
//! # Domain
//!
//! 0 <= radius < inf, 0 <= width < inf, 0 < wavelength; unit vectors in the scratch frame. NaN and no sample elsewhere.
//! At width 0 the lobe across is uniform in beta_o. A direction below the surface has the density 0.
//!
//! # Methods
//!
//! The component along the tangent comes from [`gaussian_inverse`](super::gaussian_inverse()), the one across from one
//! tangent. Only a draw whose component along the tangent leaves \[-1, 1\] is evanescent. The weight of a draw,
//! exp(-(k sigma xi1)^2) sinc^2 x gamma_o / p, is (sqrt(pi)/(k sigma)) (theta/c) (1 + x^2) sinc^2 x: at most 1.478 times
//! sqrt(pi) theta/(k sigma c), and theta is at most pi and at most twice c.
//!
//! Cutting the Lorentzian costs one arctangent for the density. Without it a draw is wasted with the probability
//! 1 - theta/pi, which is most of them for scratches narrower than the wavelength and at grazing angles, and there is no
//! limit for width 0.
//!
//! # Where it fails
//!
//! xi2 is the sum of two cosines: beyond W/lambda of about 1e12 its rounding reaches the lobe's width.
//! Towards grazing incidence across the scratch the published cone loses less, and the lobe's gain over it falls
//! (`tests/sampling_furnace.rs`).
//!
//! # Errata
//!
//! None: the lobe is not in the papers. WVJH17 draws the azimuth around the tangent uniformly
//! ([`scratch_cone`](super::scratch_cone)) and names a better lobe as future work.

use super::Sample;
use super::direction::{NARROW, is_sampled, reach, reduced_radius, reduced_width, scratch_pdf};
use super::gaussian_inverse;
use crate::diffraction::Coherence;

/// The Lorentzian's angle from x = c (beta - g) to c (beta + g).
#[inline]
fn angle(c: f64, beta: f64, g: f64) -> f64 {
    let (low, high) = (c * (beta - g), c * (beta + g));
    libm::atan2(2.0 * c * g, 1.0 + low * high)
}

/// Returns the density of `outgoing` given `incident`, in 1/sr; the width of the scratch in um.
///
/// Unit vectors in the scratch frame, away from the surface. It integrates to the share of draws that propagate.
///
/// ```
/// use iridescence::diffraction::Coherence;
/// use iridescence::sampling::{scratch_lobe_pdf, scratch_lobe_sample};
///
/// let light = Coherence { radius: 10.0, wavelength: 0.55 };
/// let incident = [0.6, 0.0, 0.8];
/// let sample = scratch_lobe_sample(light, 1.1, incident, [0.3, 0.7]).unwrap();
/// assert_eq!(sample.pdf, scratch_lobe_pdf(light, 1.1, incident, sample.direction));
/// ```
#[must_use]
pub fn scratch_lobe_pdf(coherence: Coherence, width: f64, incident: [f64; 3], outgoing: [f64; 3]) -> f64 {
    scratch_pdf(coherence, width, [incident, outgoing], |c, [beta_i, beta_o], g| {
        let x = c * (beta_i + beta_o);
        c / (angle(c, beta_i, g) * (1.0 + x * x))
    })
}

/// Returns a direction and its density; none for an evanescent draw, which counts as zero.
///
/// `random`: two uniform numbers of \[0, 1), for the components along and across the scratch.
#[must_use]
pub fn scratch_lobe_sample(coherence: Coherence, width: f64, incident: [f64; 3], random: [f64; 2]) -> Option<Sample> {
    let (q, c) = (reduced_radius(coherence), reduced_width(width, coherence.wavelength));
    if !is_sampled(incident, &random) {
        return None;
    }
    let along = gaussian_inverse(random[0]) / q - incident[0];
    let g = reach(along)?;
    // From the end that lies farther from the specular direction, where no difference below cancels.
    let beta = incident[1].abs();
    let u = if incident[1] < 0.0 { random[1] } else { 1.0 - random[1] };
    let from_end = if c < NARROW {
        2.0 * g * u
    } else {
        let far = c * (beta + g);
        let t = libm::tan(u * angle(c, beta, g));
        t / c * (1.0 + far * far) / (1.0 + far * t)
    };
    let square = from_end * (2.0 * g - from_end);
    // Also false for a NaN.
    if square > 0.0 {
        let beta = g - from_end;
        let direction = [along, if incident[1] < 0.0 { -beta } else { beta }, libm::sqrt(square)];
        let pdf = scratch_lobe_pdf(coherence, width, incident, direction);
        Some(Sample { direction, pdf })
    } else {
        None
    }
}
