//! The energy of a finite scratch: |eta|^2 over all places of the window.
//!
//! # Definition
//!
//! ```math
//! E(\xi_1) = \iint |\eta|^2\,ds_t\,ds_b
//! = 2 \pi \sigma^2 \int_0^L (L - \tau)\,e^{-\tau^2/4\sigma^2} \cos(k \xi_1 \tau)\,d\tau
//! ```
//!
//! for a segment of length L: what a scratch sends along xi_1 to all the points around it together. E(0) is its largest
//! value; a long scratch has E = 2 pi^{3/2} sigma^3 L exp(-(sigma k xi_1)^2), L times the rate of the infinite one.
//!
//! # Domain
//!
//! Radius >= 0, wavelength > 0, length >= 0, in micrometres; outside NaN, and NaN for NaN. Length 0 and radius 0 give 0, an
//! infinite length or radius infinity (the integral grows without end), an infinite xi_1 gives 0.
//!
//! # Methods
//!
//! With q = sigma k xi_1 and Lambda = L/(2 sigma) partial integration leaves the derivative of the Faddeeva function
//!
//! ```math
//! E = 2 \pi^{3/2} \sigma^3 \left\{ L e^{-q^2} - \sigma\,\mathrm{Im}\left[ w'(-q)
//! - e^{-\Lambda^2 - 2iq\Lambda}\,w'(-q + i\Lambda) \right] \right\}
//! ```
//!
//! in the upper half plane, where w' is bounded; the phase 2 q Lambda = k xi_1 L comes from an exact product. Where the two
//! terms cancel, Lambda <= 1/2 and q Lambda <= 1, a 16-point Gauss rule of the definition takes their place. The error is
//! some tens of eps of 2 pi^{3/2} sigma^3 (L exp(-q^2) + sigma |w'(q)|), and of E itself by the Gauss rule. E is not negative.
//!
//! <!-- report:begin segment_energy -->
//!
//! | method | what it is | precision | largest error | promise | time / baseline |
//! |---|---|---|---|---|---|
//! | `accurate` | iridescence f64 | f64 | 2.2e-15 of peak | 4e-15 of peak | 1.00 (accurate) |
//!
//! <!-- report:end segment_energy -->
//!
//! # Where it fails
//!
//! Off the mirror direction, where E(xi_1) has fallen far below the two ends' share, E keeps its digits against
//! sigma |w'(q)| only. It is the energy over the whole plane: what a pixel sees of it is
//! [`footprint_segment_mean`](super::footprint_segment_mean).
//!
//! # Errata
//!
//! None: no paper has it.

use super::coherence::Coherence;
use crate::numeric::gauss::EIGHT_POINTS;
use crate::numeric::turns::{sine_cosine_of_turns, turns_of_ratio};
use crate::special::faddeeva_w_derivative;
use core::f64::consts::PI;
use num_complex::Complex;

/// Lambda up to which the Gauss rule is used.
const SHORT: f64 = 0.5;
/// q Lambda up to which the Gauss rule is used.
const SLOW: f64 = 1.0;
/// Lambda from which exp(-Lambda^2) is zero.
const LONG: f64 = 28.0;
/// 2 pi^{3/2}.
const TWO_PI_SQRT_PI: f64 = 11.136655993663416;

/// Returns the integral of |eta|^2 over the plane of window positions, for a segment of a length, in um^4.
///
/// `length` in um, `xi1` a direction cosine. Domain and errors: the module's page. No paper has it.
///
/// ```
/// use iridescence::diffraction::{Coherence, segment_energy};
///
/// let light = Coherence { radius: 10.0, wavelength: 0.55 };
/// // A long scratch: proportional to its length, but for its two ends.
/// let [first, second] = [4000.0, 8000.0].map(|length| segment_energy(light, length, 0.0));
/// assert!((second / first - 2.0).abs() < 0.01);
/// ```
#[must_use]
pub fn segment_energy(coherence: Coherence, length: f64, xi1: f64) -> f64 {
    let Coherence { radius, wavelength } = coherence;
    if !(coherence.is_valid() && length >= 0.0) || xi1.is_nan() {
        return f64::NAN;
    }
    let q = coherence.reduced(xi1).abs();
    if length == 0.0 || radius == 0.0 || q == f64::INFINITY && length.max(radius) < f64::INFINITY {
        return 0.0;
    }
    if length == f64::INFINITY || radius == f64::INFINITY {
        return if xi1.is_infinite() { f64::NAN } else { f64::INFINITY };
    }
    let reduced = 0.5 * (length / radius);
    let phase = q * reduced;
    if reduced <= SHORT && phase <= SLOW {
        return short(coherence, length, reduced, phase);
    }
    let [near, far] = [0.0, reduced.min(LONG)].map(|height| faddeeva_w_derivative(Complex::new(-q, height)));
    // exp(-Lambda^2 - 2 i q Lambda), in turns xi1 L/lambda.
    let (sine, cosine) = sine_cosine_of_turns(turns_of_ratio(xi1.abs(), length, wavelength));
    let decay = if reduced < LONG {
        libm::exp(-reduced * reduced)
    } else {
        0.0
    };
    let ends = near.im - decay * (cosine * far.im - sine * far.re);
    let inner = length * libm::exp(-q * q) - radius * ends;
    // Before the product: a radius whose multiple overflows times nothing is nothing.
    if inner <= 0.0 {
        return 0.0;
    }
    TWO_PI_SQRT_PI * radius * (radius * (radius * inner))
}

/// 2 pi sigma^2 L^2 int_0^1 (1 - u) exp(-Lambda^2 u^2) cos(2 q Lambda u) du, the rule on either half of the interval.
fn short(coherence: Coherence, length: f64, reduced: f64, phase: f64) -> f64 {
    let mut sum = 0.0;
    for [node, weight] in EIGHT_POINTS {
        for u in [
            0.25 - 0.25 * node,
            0.25 + 0.25 * node,
            0.75 - 0.25 * node,
            0.75 + 0.25 * node,
        ] {
            let along = reduced * u;
            sum += 0.25 * weight * (1.0 - u) * libm::exp(-along * along) * libm::cos(2.0 * phase * u);
        }
    }
    let side = coherence.radius * length;
    2.0 * PI * side * side * sum
}
