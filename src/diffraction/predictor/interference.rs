//! Does interference matter: between scratches, and between base and scratches.

use super::{gaussian_reach, in_units};
use crate::diffraction::coherence::{Coherence, base_response, coherence_degree};
use core::f64::consts::PI;

/// Returns exp(-d^2/(4 sigma^2)): what two scratches at a separation d gain or lose by interference, as a share.
///
/// Of the incoherent sum |S1|^2 + |S2|^2, for parallel scratches in the mean over the plane (a wide footprint), whatever
/// their strengths and xi; reached for equal strengths where cos(k xi2 d) = ±1. Of 2 peak^2 (of 2 A_C M(H, 0) a scratch,
/// for equal strengths), for any two segments d apart at any one point (for infinite ones, in the mean over any
/// footprint). It is [`coherence_degree`](crate::diffraction::coherence_degree). A radius of 0 gives 0, or 1 for d = 0. NaN
/// for a negative radius and for an infinite separation under an infinite radius.
///
/// ```
/// use iridescence::diffraction::interference_bound;
///
/// // Scratches 4 radii apart: 2 % of their sum at most.
/// assert!(interference_bound(40.0, 10.0) < 0.02);
/// ```
#[must_use]
pub fn interference_bound(separation: f64, radius: f64) -> f64 {
    coherence_degree(separation, radius)
}

/// Returns a bound on what `count` parallel scratches gain or lose by interference, as a share of their incoherent sum, in
/// the mean over the plane; neighbours are at least `separation` apart.
///
/// The smaller of (count - 1) q and 2 (q + q^4 + q^9 + ...), q = exp(-d^2/(4 sigma^2)). Any strengths, any xi. 0 for one
/// scratch or none. NaN for a negative radius.
///
/// ```
/// use iridescence::diffraction::interference_bound_set;
///
/// // A grating of 6 radii is incoherent to 1e-3.
/// assert!(interference_bound_set(60.0, 10.0, 1000) < 1e-3);
/// ```
#[must_use]
pub fn interference_bound_set(separation: f64, radius: f64, count: usize) -> f64 {
    let (reduced, pair) = (in_units(separation, radius), interference_bound(separation, radius));
    if pair.is_nan() {
        return f64::NAN;
    }
    let pairs = count.saturating_sub(1) as f64 * pair;
    let x = 0.25 * (reduced * reduced);
    // Twice the sum of exp(-n^2 x) over n >= 1; for small x from its Poisson sum, the tail rounded up.
    let neighbours = if x >= 1.0 {
        let q = libm::exp(-x);
        let fourth = (q * q) * (q * q);
        let ninth = (fourth * fourth) * q;
        let sixteenth = (fourth * fourth) * (fourth * fourth);
        2.0 * (q + fourth + ninth + 1.001 * sixteenth)
    } else {
        libm::sqrt(PI / x) * (1.0 + 2.001 * libm::exp(-PI * PI / x)) - 1.0
    };
    if pairs <= neighbours { pairs } else { neighbours }
}

/// Returns the separation from which on [`interference_bound`] keeps a tolerance, in coherence radii:
/// 2 sqrt(ln(1/tolerance)).
///
/// 0 from tolerance 1 on, infinity for tolerance 0, NaN below.
///
/// ```
/// use iridescence::diffraction::interference_separation;
///
/// assert!((interference_separation(1e-2) - 4.29).abs() < 1e-2);
/// ```
#[must_use]
pub fn interference_separation(tolerance: f64) -> f64 {
    gaussian_reach(4.0, tolerance)
}

/// Returns whether |S1|^2 + |S2|^2 stands for |S1 + S2|^2 within `tolerance`, as [`interference_bound`] has it.
///
/// In the mean over the plane, for parallel scratches, `tolerance` is a share of |S1|^2 + |S2|^2. At a point, or under a
/// footprint of a radius or less, it is a share of the peak, not of the sum: half way between two scratches both are
/// equally weak, and their interference is as large as their sum.
///
/// False where an argument is NaN. For many pairs against one tolerance compare separations with
/// [`interference_separation`].
#[must_use]
pub fn incoherent_sum_is_enough(separation: f64, radius: f64, tolerance: f64) -> bool {
    // Wider than the rounding of any exponent that leaves a bound above 0.
    interference_bound(separation, radius) * (1.0 + 1e-12) <= tolerance
}

/// Returns a bound on |2 Re(B S)| over the sum of |S_j|^2, for `count` scratches with S = S_1 + ... + S_count:
/// 2 B sqrt(count/sum).
///
/// `xi` holds two components of the scattering vector in the plane, `squared_sum` is the sum of |S_j|^2 in um^4, each S_j
/// with its profile and spatial phase, as in [`scratch_squared`](crate::diffraction::scratch_squared). It bounds the last
/// term of VWH18 Eq. 6, first member, against the sum of Eq. 7. Reached when all
/// S_j are equal and in phase with the base. 0 without scratches; a sum of 0 gives infinity, or 0 where the base's
/// response is 0. NaN for a negative sum.
///
/// ```
/// use iridescence::diffraction::{Coherence, base_interference_bound};
///
/// let light = Coherence { radius: 10.0, wavelength: 0.55 };
/// // Five degrees beside the mirror direction the base's amplitude has fallen by exp(-50).
/// assert!(base_interference_bound(light, [0.087, 0.0], 1.0, 100) < 1e-17);
/// ```
#[must_use]
pub fn base_interference_bound(coherence: Coherence, xi: [f64; 2], squared_sum: f64, count: usize) -> f64 {
    let base = base_response(coherence, xi);
    if squared_sum.is_nan() || squared_sum < 0.0 || base.is_nan() {
        return f64::NAN;
    }
    if count == 0 || base == 0.0 {
        return 0.0;
    }
    2.0 * base * (libm::sqrt(count as f64) / libm::sqrt(squared_sum))
}

/// Returns whether 2 Re(B S) may exceed `tolerance` of the sum of |S_j|^2: never false where it does.
///
/// Arguments as in [`base_interference_bound`]. True where an argument is NaN.
///
/// ```
/// use iridescence::diffraction::{Coherence, base_interference_matters};
///
/// let light = Coherence { radius: 10.0, wavelength: 0.55 };
/// assert!(base_interference_matters(light, [0.01, 0.02], 1.0, 3, 1e-2));
/// assert!(!base_interference_matters(light, [0.1, 0.2], 1.0, 3, 1e-2));
/// ```
#[must_use]
pub fn base_interference_matters(
    coherence: Coherence,
    xi: [f64; 2],
    squared_sum: f64,
    count: usize,
    tolerance: f64,
) -> bool {
    let kept = base_interference_bound(coherence, xi, squared_sum, count) * (1.0 + 1e-11) <= tolerance;
    !kept
}
