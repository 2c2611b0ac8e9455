//! The lobe of the bare surface, |B|^2: a Gaussian of direction cosines.
//!
//! # Definition
//!
//! ```math
//! p(\omega_o) = \frac{(k\sigma)^2}{\pi}\, e^{-(k\sigma)^2 |\xi|^2}\, \gamma_o, \qquad \xi = (\alpha_i + \alpha_o,\ \beta_i + \beta_o)
//! ```
//!
//! WVJH17 section 5: both components of xi are normal with the standard deviation lambda/(sqrt(8) pi sigma), and gamma_o
//! takes the density of the direction cosines to the sphere.
//!
//! # Domain
//!
//! 0 <= radius < inf, 0 < wavelength; incident and outgoing are unit vectors. NaN and no sample elsewhere: an infinite
//! radius is a Dirac lobe, which has no density. At radius 0 the lobe is infinitely wide: the density is 0 and no draw
//! propagates. A direction below the surface has the density 0.
//!
//! # Methods
//!
//! The two normal numbers are a length and an angle (Box and Muller 1958). A draw that leaves the unit disc is
//! evanescent: it gives no direction and counts as zero in the mean. The density is that of all draws, so it integrates
//! to the share of those that propagate. Drawing again instead would raise the density by a factor that depends on the
//! incident direction.
//!
//! # Where it fails
//!
//! xi is the sum of two cosines: beyond sigma/lambda of about 1e12 its rounding reaches the lobe's width.
//!
//! # Errata
//!
//! WVJH17 Eq. 21 prints the standard deviation in 1/length, in the place of the sample; multiplied by lambda it is one of
//! direction cosines, which Eq. 22 needs. In Eq. 22 xi is the sum of both directions, as in VWH18 and here.

use super::Sample;
use super::direction::{is_sampled, reduced_radius, settled};
use crate::diffraction::Coherence;
use core::f64::consts::{PI, TAU};

/// Returns the density of `outgoing` given `incident`, in 1/sr.
///
/// Unit vectors away from the surface, in any frame with the normal as its third axis. WVJH17 section 5.
///
/// ```
/// use iridescence::diffraction::Coherence;
/// use iridescence::sampling::{base_lobe_pdf, base_lobe_sample};
///
/// let light = Coherence { radius: 10.0, wavelength: 0.55 };
/// let incident = [0.6, 0.0, 0.8];
/// let sample = base_lobe_sample(light, incident, [0.3, 0.7]).unwrap();
/// assert_eq!(sample.pdf, base_lobe_pdf(light, incident, sample.direction));
/// ```
#[must_use]
pub fn base_lobe_pdf(coherence: Coherence, incident: [f64; 3], outgoing: [f64; 3]) -> f64 {
    let q = reduced_radius(coherence);
    if q.is_nan() {
        return q;
    }
    if let Some(value) = settled(incident, outgoing) {
        return value;
    }
    let (x, y) = (q * (incident[0] + outgoing[0]), q * (incident[1] + outgoing[1]));
    q * q / PI * libm::exp(-(x * x + y * y)) * outgoing[2]
}

/// Returns a direction and its density; none for an evanescent draw, which counts as zero.
///
/// `random`: two uniform numbers of \[0, 1). WVJH17 Eqs. 21 and 22.
#[must_use]
pub fn base_lobe_sample(coherence: Coherence, incident: [f64; 3], random: [f64; 2]) -> Option<Sample> {
    let q = reduced_radius(coherence);
    if !is_sampled(incident, &random) {
        return None;
    }
    let length = libm::sqrt(-libm::log1p(-random[0])) / q;
    let (sine, cosine) = libm::sincos(TAU * random[1]);
    let (x, y) = (length * cosine - incident[0], length * sine - incident[1]);
    let square = (1.0 - x) * (1.0 + x) - y * y;
    // Also false for a NaN.
    if square > 0.0 {
        let direction = [x, y, libm::sqrt(square)];
        let pdf = base_lobe_pdf(coherence, incident, direction);
        Some(Sample { direction, pdf })
    } else {
        None
    }
}
