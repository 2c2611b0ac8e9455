//! The spatial phase eta of a scratch: the Fourier integral of the coherence window along its line.
//!
//! # Definition
//!
//! ```math
//! \eta = e^{-s_b^2/2\sigma^2 - ik\xi_2 s_b} \int_{s_t+l_1}^{s_t+l_2} e^{-t^2/2\sigma^2 - ik\xi_1 t}\,dt
//! ```
//!
//! VWH18 Eq. 5, WVJH17 Eqs. 23 and 24. k = 2 pi/lambda; t runs along the scratch, from the foot of the perpendicular
//! that the shaded point drops on its line; (s_t, s_b) is the scratch's origin from the shaded point, l_1 and l_2 its ends
//! from the origin. The integral is a multiple of
//! [`erf_difference_scaled`](crate::special::erf_difference_scaled()) with a = t/(sqrt2 sigma) at the ends and
//! b = sigma k xi_1/sqrt2. An infinite scratch (VWH18 Eq. 8) has
//!
//! ```math
//! \eta_\infty = \sqrt{2 \pi}\,\sigma\,e^{-s_b^2/2\sigma^2 - (\sigma k \xi_1)^2/2 - ik\xi_2 s_b}
//! ```
//!
//! # Domain
//!
//! Radius >= 0 and wavelength > 0, in micrometres; outside NaN, and NaN for NaN. Any finite position, ends and xi; ends in
//! exchanged order negate. Limits: infinite ends, infinite offset (0), infinite xi_1 (0), radius 0 (0), infinite wavelength
//! (no phases), infinite radius (the plain Fourier integral of finite ends). An infinite scratch under an infinite radius
//! and an infinite xi_2 off the line have no limit and give NaN.
//!
//! # Methods
//!
//! The error is a few eps of the largest modulus, sqrt(2 pi) sigma, at any place of the hemisphere: the phase across is
//! reduced from an exact product, and the error function's difference carries its own. Where the window is constant to
//! the last bit along the whole segment (a large radius, or none of the light's decay), the integral is the length times
//! sinc, with every digit of the length.
//!
//! <!-- report:begin spatial_phase -->
//!
//! | method | what it is | precision | largest error | promise | time / baseline |
//! |---|---|---|---|---|---|
//! | `accurate` | iridescence f64 | f64 | 5.3e-16 of peak | 1e-15 of peak | 0.82 (as_printed) |
//! | `accurate` | iridescence f32 | f32 | 2.7e-6 of peak | 3.5e-6 of peak | 1.00 (accurate) |
//! | `accurate`, slice | iridescence f32 slices | f32 | 2.7e-6 of peak | 3.5e-6 of peak | 0.14 (accurate, scalar) |
//! | `as_printed` | WVJH17 Eqs. 23 and 24, erf of errorfunctions 0.2.0 | f64 | not finite rel. | none | 1.00 (as_printed) |
//!
//! <!-- report:end spatial_phase -->
//!
//! # Where it fails
//!
//! A segment much shorter than its distance s_t loses digits of its length where s_t + l_1 and s_t + l_2 are formed: the
//! error stays a few eps of sqrt(2 pi) sigma. Give the origin at the shaded point's foot if the length itself counts.
//!
//! # Errata
//!
//! WVJH17 Eq. 24 has |r_0|^2 - (t.r_0)^2 in its exponent, which cancels in f32 far from the origin; it is s_b^2. WVJH17
//! Eq. 22 lacks lambda and has the opposite sign of xi_1. Both papers print the product of a vanishing exponential and
//! an infinite error function, see [`erf_difference`](mod@crate::special::erf_difference).

use super::coherence::{Coherence, coherence_window};
use super::limits::{FLAT, NAN, ZERO};
use crate::numeric::turns::{ratio, sine_cosine_of_turns, turns_of_ratio};
use crate::special::erf_difference_scaled;
use core::f64::consts::{FRAC_1_SQRT_2, PI};
use num_complex::Complex;

/// sqrt(2 pi).
const SQRT_2_PI: f64 = 2.5066282746310007;
/// sqrt(pi/2).
const SQRT_HALF_PI: f64 = 1.2533141373155003;

/// A straight scratch relative to the shaded point, in the scratch's own frame. Lengths in micrometres.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Segment {
    /// Where the scratch's origin lies: s_t along the tangent, s_b along the bitangent.
    #[doc(alias = "s_t")]
    #[doc(alias = "s_b")]
    pub position: [f64; 2],
    /// The ends l1 and l2 along the tangent, from the origin; infinite ends are allowed.
    pub ends: [f64; 2],
}

impl Segment {
    /// The ends along the tangent from the foot of the perpendicular.
    #[inline(always)]
    pub(super) fn span(self) -> [f64; 2] {
        self.ends.map(|end| self.position[0] + end)
    }
}

/// Returns int_{t1}^{t2} exp(-t^2/(2 sigma^2)) exp(-i k xi t) dt, in um: the one integral of all windowed scratches.
///
/// `span` is (t1, t2) in um, either or both infinite; `xi` a direction cosine or any number. Exchanged ends negate
/// exactly, -xi conjugates exactly. The module's page states domain, limits and errors. The integral behind VWH18 Eq. 5.
#[must_use]
#[inline]
pub fn windowed_transform(coherence: Coherence, span: [f64; 2], xi: f64) -> Complex<f64> {
    let (share, scale) = transform_of_scale(coherence, span, xi);
    share * scale
}

/// [`windowed_transform`] as a share of its scale, and the scale: their product alone can leave the range.
#[inline(always)]
fn transform_of_scale(coherence: Coherence, span: [f64; 2], xi: f64) -> (Complex<f64>, f64) {
    let Coherence { radius, wavelength } = coherence;
    let [from, to] = span;
    let far = from.abs().max(to.abs());
    // The negation lets NaN through to the cold way.
    if !(radius > 0.0 && wavelength > 0.0 && far > FLAT * radius) {
        return (constant_window(coherence, span, xi), 1.0);
    }
    let [from, to] = span.map(|t| t / radius * FRAC_1_SQRT_2);
    let height = coherence.reduced(xi) * FRAC_1_SQRT_2;
    (erf_difference_scaled(from, to, height) * SQRT_HALF_PI, radius)
}

/// [`windowed_transform`] where the window is 1 along the segment, and where there is none.
#[cold]
fn constant_window(coherence: Coherence, [from, to]: [f64; 2], xi: f64) -> Complex<f64> {
    let Coherence { radius, wavelength } = coherence;
    if !coherence.is_valid() || from.is_nan() || to.is_nan() || xi.is_nan() {
        return NAN;
    }
    if radius == 0.0 || from == to && from.is_finite() {
        return ZERO;
    }
    // A segment shorter than the wave's phase can tell apart: length times sinc times the phase of its middle. Halves, lest
    // the ends' sum or difference overflow.
    let (length, sum) = (0.5 * to - 0.5 * from, 0.5 * to + 0.5 * from);
    if !length.is_finite() {
        return NAN;
    }
    if xi.is_infinite() {
        return ZERO;
    }
    // sin(k xi L/2)/(k xi/2), and 1 where the phase is small.
    let (sine, _) = sine_cosine_of_turns(turns_of_ratio(xi, length, wavelength));
    let angle = 2.0 * PI * ratio(xi, length, wavelength);
    let sinc = if angle.abs() < FLAT { 1.0 } else { sine / angle };
    let (sine, cosine) = sine_cosine_of_turns(turns_of_ratio(xi, sum, wavelength));
    Complex::new(cosine, -sine) * (2.0 * length * sinc)
}

/// Returns the phase exp(-i k xi s), 1 where the window has no weight left.
#[inline(always)]
pub(super) fn phase_across(offset: f64, xi: f64, wavelength: f64, window: f64) -> Complex<f64> {
    if window == 0.0 && !xi.is_nan() {
        return Complex::new(1.0, 0.0);
    }
    let (sine, cosine) = sine_cosine_of_turns(turns_of_ratio(offset, xi, wavelength));
    Complex::new(cosine, -sine)
}

/// Returns eta of a finite, semi-infinite or infinite scratch, in um; xi = (xi1, xi2), direction cosines.
///
/// |eta| <= sqrt(2 pi) sigma. The module's page states domain, limits and errors. VWH18 Eq. 5, WVJH17 Eqs. 23 and 24.
///
/// ```
/// use iridescence::diffraction::{Coherence, Segment, spatial_phase, spatial_phase_infinite};
///
/// let light = Coherence { radius: 60.0, wavelength: 0.55 };
/// // A scratch of 100 um whose middle lies 20 um along and 5 um across from the shaded point.
/// let segment = Segment { position: [20.0, 5.0], ends: [-50.0, 50.0] };
/// let eta = spatial_phase(light, segment, [0.001, 0.3]);
/// // As long as the window sees no end, the infinite scratch is the same.
/// let long = Segment { ends: [-500.0, 500.0], ..segment };
/// let infinite = spatial_phase_infinite(light, 5.0, [0.001, 0.3]);
/// assert!((spatial_phase(light, long, [0.001, 0.3]) - infinite).norm() < 1e-11);
/// assert!((eta - infinite).norm() > 10.0);
/// ```
#[doc(alias = "eta")]
#[doc(alias = "η")]
#[must_use]
#[inline]
pub fn spatial_phase(coherence: Coherence, segment: Segment, xi: [f64; 2]) -> Complex<f64> {
    let across = segment.position[1];
    let window = coherence_window(across, coherence.radius);
    let phase = phase_across(across, xi[1], coherence.wavelength, window);
    let (share, scale) = transform_of_scale(coherence, segment.span(), xi[0]);
    share * (phase * window) * scale
}

/// Returns eta of an infinite scratch at the bitangential distance `offset` = s_b, in um; xi = (xi1, xi2).
///
/// The limit of [`spatial_phase`] for ends at -inf and inf, for a finite radius. VWH18 Eq. 8.
#[must_use]
#[inline]
pub fn spatial_phase_infinite(coherence: Coherence, offset: f64, xi: [f64; 2]) -> Complex<f64> {
    let decay = decay(coherence, offset, xi[0], 0.5);
    phase_across(offset, xi[1], coherence.wavelength, decay) * (SQRT_2_PI * coherence.radius * decay)
}

/// Returns |eta|^2 of an infinite scratch, 2 pi sigma^2 exp(-(s_b/sigma)^2 - (sigma k xi1)^2), in um^2.
///
/// No phase is left: the incoherent sum of scratches needs nothing else. VWH18 Eq. 9.
#[must_use]
#[inline]
pub fn spatial_phase_infinite_squared(coherence: Coherence, offset: f64, xi1: f64) -> f64 {
    let decay = decay(coherence, offset, xi1, 1.0);
    2.0 * PI * coherence.radius * (coherence.radius * decay)
}

/// exp(-share ((s_b/sigma)^2 + (sigma k xi1)^2)).
#[inline(always)]
fn decay(coherence: Coherence, offset: f64, xi1: f64, share: f64) -> f64 {
    if !(coherence.radius > 0.0 && coherence.wavelength > 0.0) {
        // A radius of 0 leaves nothing; anything else is outside the domain.
        let nothing = coherence.is_valid() && !offset.is_nan() && !xi1.is_nan();
        return if nothing { 0.0 } else { f64::NAN };
    }
    let (r, q) = (offset / coherence.radius, coherence.reduced(xi1));
    libm::exp(-share * (r * r + q * q))
}
