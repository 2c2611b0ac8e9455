//! The triangular groove: its Fourier transform without poles, and its response without cancellation.
//!
//! # Definition
//!
//! A groove of the depth D(b) = D (1 - 2|b|/W) has, in the symbols of [`profile`](mod@super::profile), the transform F
//! ([`profile_triangle`]; WVJH17 Eq. 29) and the response M - F, mask less groove ([`response_triangle`]; WVJH17 Eq. 9):
//!
//! ```math
//! F = \int_{-W/2}^{W/2} e^{ip(1 - 2|b|/W) - ik\xi_2 b}\,db, \qquad
//! M = W\,\mathrm{sinc}\frac{\pi W \xi_2}{\lambda}, \qquad p = \frac{2 \pi (\gamma_i + \gamma_o) D}{\lambda}
//! ```
//!
//! # Domain
//!
//! Width >= 0 and wavelength > 0, in micrometres; any depth (negative: a ridge), any xi_2 and gamma_i + gamma_o. Outside
//! NaN, and NaN for NaN. Width 0 gives 0, depth 0 no response; an infinite xi_2 over a finite depth gives 0; an infinite
//! wavelength leaves no phase. Infinite width, depth or gamma_i + gamma_o have no limit: NaN.
//!
//! # Methods
//!
//! With w = pi W xi_2/lambda, A = (p + w)/2 and B = (p - w)/2 the triangle is
//!
//! ```math
//! F = \tfrac{W}{2} \left[ e^{iB}\,\mathrm{sinc}\,A + e^{iA}\,\mathrm{sinc}\,B \right], \qquad
//! M - F = \frac{W p}{2 w} \left[ e^{iB}\,\mathrm{sinc}\,A - e^{iA}\,\mathrm{sinc}\,B \right]
//! ```
//!
//! which has no pole. A and B are formed in twice the working precision, so that nothing is lost beside the places where
//! the published form has its poles, A = 0 and B = 0. The response takes its own form where |p| <= |w|, the difference M - F
//! where |p| > |w|, and where both are small, |p| + |w| <= 2, an 8-point Gauss rule for
//!
//! ```math
//! M - F = W \int_0^1 \left(1 - e^{ip(1-u)}\right) \cos(wu)\,du
//! ```
//!
//! so that a shallow groove keeps its digits.
//!
//! <!-- report:begin profile_triangle -->
//!
//! | method | what it is | precision | largest error | promise | time / baseline |
//! |---|---|---|---|---|---|
//! | `accurate` | iridescence f64 | f64 | 3.9e-16 of peak | 8e-16 of peak | 0.90 (as_printed) |
//! | `accurate` | the same on profiles at the poles xi2 = +-2 D gamma/W of WVJH17 (29) and within 1e-16..1e-2 of them | f64 | 4.6e-16 of peak | 8e-16 of peak | not timed |
//! | `accurate` | iridescence f32 | f32 | 2.9e-7 of peak | 6e-7 of peak | 1.00 (accurate) |
//! | `accurate`, slice | iridescence f32 slices | f32 | 2.9e-7 of peak | 6e-7 of peak | 0.15 (accurate, scalar) |
//! | `as_printed` | WVJH17 Eqs. 29 to 31 | f64 | not finite rel. | none | 1.00 (as_printed) |
//! | `as_printed` | the same on profiles at the poles xi2 = +-2 D gamma/W of WVJH17 (29) and within 1e-16..1e-2 of them | f64 | not finite rel. | none | not timed |
//! | `as_printed_mended` | WVJH17 Eqs. 29 to 31 without their two misprints | f64 | not finite rel. | none | 0.92 (as_printed) |
//! | `as_printed_mended` | the same on profiles at the poles xi2 = +-2 D gamma/W of WVJH17 (29) and within 1e-16..1e-2 of them | f64 | not finite rel. | none | not timed |
//!
//! <!-- report:end profile_triangle -->
//!
//! # Where it fails
//!
//! The product with the spatial phase takes the window to be constant across the width, as for the rectangle. A triangle
//! under the window has no closed form here.
//!
//! # Errata
//!
//! WVJH17 Eqs. 29 to 31: the first exponential lacks a factor W on xi_2, and Phi_D has the wrong sign. As printed the result
//! also is not a number on the poles xi_2 = ±2 D (gamma_i + gamma_o)/W, and loses digits beside them.

use super::limits::{NAN, ZERO};
use super::profile::{Profile, sinc_of_half_turns, width_term};
use crate::numeric::gauss::EIGHT_POINTS;
use crate::numeric::turns::{ratio, sine_cosine_of_turns, turns_of_sum};
use core::f64::consts::PI;
use num_complex::Complex;

/// Bound of |p| + |w| for the Gauss rule.
const SHALLOW: f64 = 2.0;

/// sinc and exp(i .) of the two phases A = (p + w)/2 and B = (p - w)/2 of a triangle.
struct Flanks {
    sinc: [f64; 2],
    phase: [Complex<f64>; 2],
}

/// None outside the domain.
#[inline(always)]
fn flanks(Profile { width, depth }: Profile, [_, xi2, gamma]: [f64; 3], wavelength: f64) -> Option<Flanks> {
    if !((0.0..f64::INFINITY).contains(&width) && wavelength > 0.0) {
        return None;
    }
    // In turns: A/(2 pi) = (gamma D + W xi2/2)/(2 lambda).
    let (deep, wide) = ([0.5 * gamma, depth], 0.25 * width);
    let both = [wide, -wide].map(|wide| turns_of_sum(deep, [wide, xi2], wavelength));
    let waves = both.map(|(_, turns)| sine_cosine_of_turns(turns));
    Some(Flanks {
        sinc: [0, 1].map(|i| sinc_of_half_turns(2.0 * both[i].0, waves[i].0)),
        phase: waves.map(|(sine, cosine)| Complex::new(cosine, sine)),
    })
}

/// Whether the triangle's lobe has gone: an infinite xi2 over a finite depth.
#[inline(always)]
fn is_vanishing(profile: Profile, [_, xi2, gamma]: [f64; 3], wavelength: f64) -> bool {
    xi2.is_infinite() && profile.depth.is_finite() && gamma.is_finite() && wavelength.is_finite()
}

/// Returns the transform of a triangular groove alone, in um: the scratch, without its mask.
///
/// `scattering` is (xi1, xi2, gamma_i + gamma_o). Error a few eps of W, at and beside the poles of the published form too.
/// WVJH17 Eqs. 29 to 31, corrected.
///
/// ```
/// use iridescence::diffraction::{Profile, profile_triangle};
///
/// // At normal incidence and on the pole xi2 = 2 D gamma/W of the published form.
/// let value = profile_triangle(Profile { width: 4.0, depth: 0.5 }, [0.0, 0.5, 2.0], 0.5);
/// assert!((value.re - 2.0).abs() < 1e-14 && value.im.abs() < 1e-14);
/// ```
#[must_use]
#[inline]
pub fn profile_triangle(profile: Profile, scattering: [f64; 3], wavelength: f64) -> Complex<f64> {
    let Some(Flanks { sinc, phase }) = flanks(profile, scattering, wavelength) else {
        return NAN;
    };
    if is_vanishing(profile, scattering, wavelength) {
        return ZERO;
    }
    (phase[1] * sinc[0] + phase[0] * sinc[1]) * (0.5 * profile.width)
}

/// Returns the response of a triangular groove, mask less scratch, in um: W sinc(pi W xi2/lambda) less
/// [`profile_triangle`], without the cancellation of the two in a shallow groove.
///
/// `scattering` is (xi1, xi2, gamma_i + gamma_o). Error a few eps of W min(1, |p|), p = 2 pi (gamma_i + gamma_o) D/lambda.
/// WVJH17 Eq. 9, with the groove of Eq. 29.
#[must_use]
pub fn response_triangle(profile: Profile, scattering: [f64; 3], wavelength: f64) -> Complex<f64> {
    let Some(flanks) = flanks(profile, scattering, wavelength) else {
        return NAN;
    };
    if is_vanishing(profile, scattering, wavelength) {
        return ZERO;
    }
    let Profile { width, depth } = profile;
    let [_, xi2, gamma] = scattering;
    // p/pi and w/pi.
    let (deep, wide) = (2.0 * ratio(gamma, depth, wavelength), ratio(width, xi2, wavelength));
    let Flanks { sinc, phase } = &flanks;
    if PI * (deep.abs() + wide.abs()) <= SHALLOW {
        shallow(PI * deep, PI * wide) * width
    } else if deep.abs() <= wide.abs() && wide.is_finite() {
        (phase[1] * sinc[0] - phase[0] * sinc[1]) * (0.5 * width * (deep / wide))
    } else {
        let mask = width_term(width, xi2, wavelength);
        Complex::new(mask, 0.0) - (phase[1] * sinc[0] + phase[0] * sinc[1]) * (0.5 * width)
    }
}

/// int_0^1 (1 - exp(ip(1 - u))) cos(w u) du for small p and w.
fn shallow(p: f64, w: f64) -> Complex<f64> {
    let mut sum = ZERO;
    for [node, weight] in EIGHT_POINTS {
        for node in [node, -node] {
            let u = 0.5 + 0.5 * node;
            let half = 0.5 * p * (1.0 - u);
            let (sine, cosine) = (libm::sin(half), libm::cos(half));
            sum += Complex::new(2.0 * sine * sine, -2.0 * sine * cosine) * (0.5 * weight * libm::cos(w * u));
        }
    }
    sum
}
