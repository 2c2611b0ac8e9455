//! A depth that varies along the scratch: linear and quadratic terms keep the spatial phase in closed form.
//!
//! # Definition
//!
//! A groove's bottom at the depth D(t) = depth + slope t + curvature t^2/2 turns the light's phase along the scratch:
//!
//! ```math
//! \eta_D = e^{-s_b^2/2\sigma^2 - ik\xi_2 s_b}
//! \int_{s_t+l_1}^{s_t+l_2} e^{-t^2/2\sigma^2 - ik\xi_1 t + ik\gamma D(t)}\,dt, \qquad \gamma = \gamma_i + \gamma_o
//! ```
//!
//! t is measured along the tangent from the foot of the perpendicular that the shaded point drops on the scratch's line, as
//! in [`spatial_phase`](mod@super::spatial_phase). No paper has it; with slope and curvature 0 it is eta times
//! exp(i k gamma depth).
//!
//! # Domain
//!
//! That of [`spatial_phase`](mod@super::spatial_phase), for a positive finite radius; finite depth, slope, curvature and
//! gamma. A radius of 0 gives 0; an infinite radius NaN unless the curvature is 0.
//!
//! # Methods
//!
//! The slope shifts the direction, xi = xi_1 - gamma slope. The curvature makes the radius complex,
//! 1/s^2 = 1/sigma^2 - i k gamma curvature. With kappa = k xi, alpha = 1/(sqrt2 s) and z(t) = alpha t + i kappa/(2 alpha)
//!
//! ```math
//! \int_{t_1}^{t_2} e^{-\alpha^2 t^2 - i\kappa t}\,dt = \frac{\sqrt{\pi}}{2 \alpha} \left[T(t_1) - T(t_2)\right], \qquad
//! T(t) = e^{-\kappa^2/4\alpha^2}\,\mathrm{erfc}\,z(t)
//! ```
//!
//! T(t) = exp(-alpha^2 t^2 - i kappa t) w(i z) for Re z >= 0, and 2 exp(-kappa^2/(4 alpha^2)) less that of -z for
//! Re z < 0. Every exponential has a real part of at most 0 in its exponent and w stays in the upper half plane, so that
//! nothing overflows. With beta = k gamma curvature sigma^2, the phase that the curvature makes at sigma, times 2, the error
//! is a few eps of sqrt(2 pi) sigma times sqrt(1 + |beta|): as much as a last digit of the curvature is worth. From
//! |beta| = 1e150 on the value is 0.
//!
//! Without curvature the integral is [`windowed_transform`].
//!
//! # Where it fails
//!
//! The depth is a parabola along the whole segment: a third derivative needs shorter segments. Slopes are
//! small against 1: neither the larger area of a tilted bottom nor the shadow of the ends is counted, and gamma slope is
//! rounded once, which a window of thousands of wavelengths sees where the slope is of order 1.
//!
//! # Errata
//!
//! None: no paper has it.

use super::coherence::{Coherence, coherence_window};
use super::limits::{NAN, ZERO};
use super::profile::width_term;
use super::spatial_phase::{Segment, phase_across, spatial_phase, windowed_transform};
use crate::numeric::turns::{sine_cosine_of_turns, turns_of_ratio};
use crate::special::faddeeva_w;
use core::f64::consts::PI;
use num_complex::Complex;

/// Radii beyond which the window is 0.
const FAR: f64 = 40.0;
/// beta from which the value is taken for 0.
const STEEP: f64 = 1e150;
/// sqrt(pi).
const SQRT_PI: f64 = 1.772453850905516;

/// The depth along a scratch: `depth + slope t + curvature t^2/2`, t along the tangent from the foot of the perpendicular
/// from the shaded point (not from the scratch's origin), lengths in micrometres.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DepthAlong {
    /// Depth at t = 0, positive below the surface.
    pub depth: f64,
    /// First derivative, dimensionless.
    pub slope: f64,
    /// Second derivative, in 1/um.
    pub curvature: f64,
}

impl DepthAlong {
    /// Returns the same depth for t measured from another point of the line, `shift` um along the tangent from the old one.
    ///
    /// With `shift` = -s_t a description from the scratch's origin becomes one from the foot of the perpendicular.
    #[must_use]
    pub fn shifted(self, shift: f64) -> DepthAlong {
        let slope = self.slope + self.curvature * shift;
        DepthAlong {
            depth: self.depth + 0.5 * shift * (self.slope + slope),
            slope,
            curvature: self.curvature,
        }
    }
}

/// Returns eta of the groove's bottom with the phase of its depth in it, exp(2 pi i gamma D(t)/lambda), in um.
///
/// `scattering` is (xi1, xi2, gamma_i + gamma_o). Domain and errors: the module's page.
///
/// ```
/// use iridescence::diffraction::{Coherence, DepthAlong, Segment, spatial_phase_varying};
///
/// let light = Coherence { radius: 60.0, wavelength: 0.55 };
/// let segment = Segment { position: [0.0, 0.0], ends: [-300.0, 300.0] };
/// // A groove that sinks by 1 um in 100 um mirrors the light into another direction.
/// let depth = DepthAlong { depth: 0.2, slope: 0.01, curvature: 0.0 };
/// let [mirror, tilted] = [0.0, 0.02].map(|xi1| spatial_phase_varying(light, segment, depth, [xi1, 0.0, 2.0]).norm());
/// assert!(tilted > 150.0 && mirror < 0.1);
/// ```
#[must_use]
pub fn spatial_phase_varying(
    coherence: Coherence,
    segment: Segment,
    depth: DepthAlong,
    scattering: [f64; 3],
) -> Complex<f64> {
    let Coherence { radius, wavelength } = coherence;
    let [xi1, xi2, gamma] = scattering;
    let bend = gamma * depth.curvature;
    let xi = xi1 - gamma * depth.slope;
    let along = if bend == 0.0 {
        windowed_transform(coherence, segment.span(), xi)
    } else {
        bent_transform(coherence, segment.span(), xi, bend)
    };
    let (sine, cosine) = sine_cosine_of_turns(turns_of_ratio(gamma, depth.depth, wavelength));
    let across = segment.position[1];
    let window = coherence_window(across, radius);
    along * Complex::new(cosine, sine) * (phase_across(across, xi2, wavelength, window) * window)
}

/// Returns the response of a rectangular scratch of varying depth, mask less scratch, in um^2.
///
/// W sinc(pi W xi2/lambda) times the difference of [`spatial_phase`](super::spatial_phase()) and
/// [`spatial_phase_varying`]. Error a few eps of W sigma sqrt(1 + |beta|).
#[must_use]
pub fn response_rectangle_varying(
    coherence: Coherence,
    width: f64,
    segment: Segment,
    depth: DepthAlong,
    scattering: [f64; 3],
) -> Complex<f64> {
    let [xi1, xi2, _] = scattering;
    let mask = spatial_phase(coherence, segment, [xi1, xi2]);
    let scratch = spatial_phase_varying(coherence, segment, depth, scattering);
    (mask - scratch) * width_term(width, xi2, coherence.wavelength)
}

/// What the two ends share, lengths in radii: exp(-t^2/2 - i kappa t + i beta t^2/2) is integrated.
struct Bent {
    /// sqrt((1 - i beta)/2).
    alpha: Complex<f64>,
    /// i kappa/(2 alpha).
    shift: Complex<f64>,
    /// Direction cosine and bend of the phases.
    xi: f64,
    bend: f64,
}

/// int exp(-t^2/(2 sigma^2) - i k xi t + i k bend t^2/2) dt over the span, for bend other than 0.
fn bent_transform(coherence: Coherence, span: [f64; 2], xi: f64, bend: f64) -> Complex<f64> {
    let radius = coherence.radius;
    let broken = span[0].is_nan() || span[1].is_nan() || xi.is_nan() || !bend.is_finite();
    if broken || !coherence.is_valid() || radius == f64::INFINITY {
        return NAN;
    }
    let kappa = coherence.reduced(xi);
    let b = coherence.reduced(bend) * radius;
    if radius == 0.0 || span[0] == span[1] || kappa.is_infinite() || b.abs() > STEEP {
        return ZERO;
    }
    // The integral for -bend at -xi is the conjugate.
    if b < 0.0 {
        bulged(coherence, span, [-xi, -bend], -kappa, -b).conj()
    } else {
        bulged(coherence, span, [xi, bend], kappa, b)
    }
}

/// [`bent_transform`] for a finite kappa and 0 <= beta <= 1e150.
fn bulged(coherence: Coherence, span: [f64; 2], [xi, bend]: [f64; 2], kappa: f64, b: f64) -> Complex<f64> {
    // 1 - i beta has the modulus m.
    let m = libm::hypot(1.0, b);
    let re = 0.5 * libm::sqrt(m + 1.0);
    let alpha = Complex::new(re, -0.25 * b / re);
    let slow = kappa / m;
    let bent = Bent {
        alpha,
        // i kappa conj(alpha)/(2 |alpha|^2), |alpha|^2 = m/2.
        shift: Complex::new(slow * alpha.im, slow * alpha.re),
        xi,
        bend,
    };
    // 2 exp(-kappa^2/(4 alpha^2)), the exponent being -kappa^2 (1 + i beta)/(2 m^2).
    let whole = wave(slow * slow * b / (-4.0 * PI), -0.5 * slow * slow) * 2.0;
    let [(first, first_beyond), (second, second_beyond)] = span.map(|t| end(&bent, coherence, t));
    let difference = match (first_beyond, second_beyond) {
        (true, true) => first - second,
        (false, false) => second - first,
        (false, true) => whole - (first + second),
        (true, false) => (first + second) - whole,
    };
    difference * alpha.conj() * (SQRT_PI / m) * coherence.radius
}

/// Returns T(t) and true where Re z(t) >= 0, else 2 exp(-kappa^2/(4 alpha^2)) - T(t) and false.
fn end(bent: &Bent, coherence: Coherence, t: f64) -> (Complex<f64>, bool) {
    let reduced = t / coherence.radius;
    if reduced.abs() > FAR {
        return (ZERO, reduced > 0.0);
    }
    let z = bent.alpha * reduced + bent.shift;
    // w is taken at i z or at -i z.
    let beyond = z.re >= 0.0;
    let argument = if beyond {
        Complex::new(-z.im, z.re)
    } else {
        Complex::new(z.im, -z.re)
    };
    // -kappa t + beta t^2/2 in turns.
    let wavelength = coherence.wavelength;
    let turns = turns_of_ratio(0.5 * bent.bend * t, t, wavelength) - turns_of_ratio(bent.xi, t, wavelength);
    (wave(turns, -0.5 * reduced * reduced) * faddeeva_w(argument), beyond)
}

/// exp(2 pi i turns + decay); 0 far down, whatever the turns.
fn wave(turns: f64, decay: f64) -> Complex<f64> {
    let scale = libm::exp(decay);
    if scale == 0.0 {
        return ZERO;
    }
    let (sine, cosine) = sine_cosine_of_turns(turns - libm::rint(turns));
    Complex::new(cosine * scale, sine * scale)
}
