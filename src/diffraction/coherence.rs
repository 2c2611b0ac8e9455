//! The coherence window of the light, its area and radius, and the response of the bare surface under it.
//!
//! # Definition
//!
//! ```math
//! G(r) = e^{-r^2/2\sigma^2}, \qquad A_C = \pi \sigma^2, \qquad
//! B(\xi) = \int G(r)\, e^{-ik\xi \cdot r}\,d^2r = 2 \pi \sigma^2 e^{-(\sigma k |\xi|)^2/2}
//! ```
//!
//! WVJH17 Eqs. 6 and 16. Waves from two points of the surface interfere as far as the light is coherent there; the
//! window about the shaded point stands for that. Averaged over the window's place, two points at a separation d keep
//! the degree of coherence exp(-d^2/(4 sigma^2)).
//!
//! A light of uniform radiance that a point sees as a disc of angular diameter theta has the degree of coherence
//! 2 J1(x)/x, x = k d sin(theta/2) (van Cittert and Zernike). [`coherence_radius`] is the sigma whose Gaussian degree falls
//! to 1/2 at the same separation:
//!
//! ```math
//! \sigma = \frac{x_{1/2}}{4 \pi \sqrt{\ln 2}}\,\frac{\lambda}{\sin(\theta/2)}, \qquad
//! \frac{2 J_1(x_{1/2})}{x_{1/2}} = \frac{1}{2}
//! ```
//!
//! A renderer that integrates over the light as well as using its sigma counts the light's extent twice.
//!
//! # Domain
//!
//! Radius >= 0, wavelength > 0, in micrometres; outside NaN. A radius of 0 has the limits: window 1 at distance 0 and 0
//! elsewhere, response 0. An infinite wavelength gives xi no weight. An infinite distance under an infinite radius has no
//! limit: NaN.
//!
//! # Methods
//!
//! One exponential of an argument that is formed without overflow: distance over radius, and sigma k xi from the quotient
//! of three numbers at once. The constants x_{1/2} and 2 sqrt(ln 2) carry all digits of f64.
//!
//! # Where it fails
//!
//! A disc's degree of coherence is no Gaussian: it has rings of either sign beyond the first zero, which the window leaves
//! out. sigma is matched at one separation, half the degree, and for light that comes from around the normal: a disc at
//! grazing incidence has a longer window along the plane of incidence, and the window here is round.
//!
//! # Errata
//!
//! VWH18 uses sigma = 60 um. WVJH17 writes 6 sigma = 60 um, which is 10 um: 36 times less in A_C. Sunlight at 0.55 um has
//! 25 um. VWH18 Fig. 11 says 10 nm and means 10 um.
//! WVJH17 culls scratches beyond 3 sigma (a window 6 sigma wide), where the amplitude is still 1.1e-2; an amplitude of 1e-3
//! is reached at 3.72 sigma, see [`window_reach`](super::window_reach).

use crate::numeric::turns::ratio;
use core::f64::consts::PI;

/// The x at which 2 J1(x)/x = 1/2.
const HALF_DISC: f64 = 2.2150893677242326;
/// 2 sqrt(ln 2): the separation in radii at which exp(-d^2/4) = 1/2.
const HALF_WINDOW: f64 = 1.6651092223153954;

/// The light at one wavelength, as a scratch sees it. Lengths in micrometres.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Coherence {
    /// Standard deviation sigma of the coherence window exp(-r^2/(2 sigma^2)).
    pub radius: f64,
    /// Wavelength lambda.
    pub wavelength: f64,
}

impl Coherence {
    /// Whether the radius is at least 0 and the wavelength above 0.
    pub(super) fn is_valid(self) -> bool {
        self.radius >= 0.0 && self.wavelength > 0.0
    }

    /// Returns sigma k xi, dimensionless.
    #[inline(always)]
    pub(super) fn reduced(self, xi: f64) -> f64 {
        2.0 * PI * ratio(self.radius, xi, self.wavelength)
    }
}

/// Returns the amplitude exp(-r^2/(2 sigma^2)) of the window at a distance r, both in um; dimensionless.
///
/// Radius 0 gives 1 at distance 0 and 0 elsewhere, a negative radius NaN. WVJH17 Eq. 6.
#[doc(alias = "G")]
#[must_use]
#[inline]
pub fn coherence_window(distance: f64, radius: f64) -> f64 {
    if radius > 0.0 {
        let r = distance / radius;
        return libm::exp(-0.5 * r * r);
    }
    at_radius_zero(distance, radius)
}

/// A window of radius 0; NaN for less, and for NaN.
#[cold]
fn at_radius_zero(distance: f64, radius: f64) -> f64 {
    if radius != 0.0 || distance.is_nan() {
        f64::NAN
    } else if distance == 0.0 {
        1.0
    } else {
        0.0
    }
}

/// Returns the coherence area pi sigma^2, in um^2; NaN for a negative radius.
///
/// VWH18 Eq. 1, WVJH17 Eq. 15.
#[doc(alias = "A_C")]
#[must_use]
#[inline]
pub fn coherence_area(radius: f64) -> f64 {
    if radius >= 0.0 { PI * radius * radius } else { f64::NAN }
}

/// Returns exp(-d^2/(4 sigma^2)), the degree of coherence of two points at a separation d, averaged over the window's
/// place; both in um, dimensionless.
///
/// The interference of two parallel scratches under a wide footprint carries this factor. From the window of WVJH17 Eq. 6;
/// the two papers leave the interference out (VWH18 Eq. 7) and have no measure of it.
#[must_use]
pub fn coherence_degree(separation: f64, radius: f64) -> f64 {
    if radius > 0.0 {
        let r = separation / radius;
        return libm::exp(-0.25 * r * r);
    }
    at_radius_zero(separation, radius)
}

/// Returns the radius sigma of the window that a disc of uniform light gives, in um.
///
/// `angular_diameter` in radians, from 0 (infinite radius) to pi (a whole hemisphere); `wavelength` in um. NaN outside.
/// The Gaussian and the disc agree at half the degree of coherence; the disc's rings beyond are left out.
///
/// ```
/// use iridescence::diffraction::coherence_radius;
///
/// // The sun.
/// let sigma = coherence_radius(0.53_f64.to_radians(), 0.55);
/// assert!((sigma - 25.1773289608).abs() < 1e-9);
/// ```
#[doc(alias = "van Cittert-Zernike")]
#[must_use]
pub fn coherence_radius(angular_diameter: f64, wavelength: f64) -> f64 {
    if !((0.0..=PI).contains(&angular_diameter) && wavelength > 0.0) {
        return f64::NAN;
    }
    HALF_DISC / (2.0 * PI * HALF_WINDOW) * (wavelength / libm::sin(0.5 * angular_diameter))
}

/// Returns the angular diameter, in radians, of the disc of uniform light whose window has this radius: the inverse of
/// [`coherence_radius`].
///
/// NaN for a radius below that of a hemisphere of light, 0.212 lambda, and outside the domain; 0 for an infinite radius.
#[must_use]
pub fn angular_diameter(radius: f64, wavelength: f64) -> f64 {
    if !(radius > 0.0 && wavelength > 0.0) {
        return f64::NAN;
    }
    2.0 * libm::asin(HALF_DISC / (2.0 * PI * HALF_WINDOW) * (wavelength / radius))
}

/// Returns the response of the bare surface, 2 pi sigma^2 exp(-(sigma k |xi|)^2/2), in um^2; xi = (xi1, xi2).
///
/// 0 for radius 0 and for an infinite xi, NaN for an infinite radius, whose lobe has no width. The exponent keeps its value
/// where sigma or xi squared leave the range. WVJH17 Eq. 16.
#[must_use]
pub fn base_response(coherence: Coherence, xi: [f64; 2]) -> f64 {
    if !coherence.is_valid() {
        return f64::NAN;
    }
    if xi[0].is_nan() || xi[1].is_nan() || coherence.radius == f64::INFINITY {
        return f64::NAN;
    }
    let radius = coherence.radius;
    if radius == 0.0 || xi[0].is_infinite() || xi[1].is_infinite() {
        return 0.0;
    }
    let [q1, q2] = xi.map(|xi| coherence.reduced(xi));
    let decay = libm::exp(-0.5 * (q1 * q1 + q2 * q2));
    // Where nothing is left of the lobe, no size of the window brings it back.
    if decay == 0.0 {
        return 0.0;
    }
    2.0 * PI * (radius * (radius * decay))
}
