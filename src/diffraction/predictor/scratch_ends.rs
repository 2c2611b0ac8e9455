//! Is a finite scratch as good as an infinite one, and how far does a scratch reach.

use super::{gaussian_reach, in_units};
use crate::diffraction::coherence::Coherence;
use crate::special::erfcx;
use core::f64::consts::{FRAC_1_SQRT_2, PI, SQRT_2};

/// 1/sqrt(pi): the supremum of |z w(z)| over Im z >= |Re z|.
const STEEP: f64 = 0.564189583547757;
/// The supremum of |z w(z)| over the upper half plane, 0.7488717..., reached on the real axis at 1.33233711; rounded up.
const ANYWHERE: f64 = 0.748872;
/// Half, with a margin for the rounding of what it multiplies.
const HALF: f64 = 0.5 * (1.0 + 1e-12);
/// Margins for the rounding of the ends and of the height.
const SHRINK: f64 = 1.0 - 8.0 * f64::EPSILON;
const GROW: f64 = 1.0 + 8.0 * f64::EPSILON;

/// Returns the ends over sqrt2 sigma.
fn reduced_ends([from, to]: [f64; 2], radius: f64) -> [f64; 2] {
    let scale = SQRT_2 * radius;
    [in_units(from, scale), in_units(to, scale)]
}

/// Returns the largest |eta_finite - eta_infinite| over all xi1, as a share of |eta_infinite| at xi1 = 0; dimensionless.
///
/// `span` runs from t1 = s_t + l1 to t2 = s_t + l2 in um, in any order; infinite ends are allowed, and a radius of 0 is
/// the limit. The value is (erfc(u2) + erfc(-u1))/2, u = t/(sqrt2 sigma), reached at xi1 = 0: 0 for an infinite scratch,
/// 1 for one of no length. A bound for one scratch and for the means of many.
///
/// ```
/// use iridescence::diffraction::infinite_scratch_error;
///
/// // 1.96 standard deviations to each side leave out 5 %.
/// assert!((infinite_scratch_error(10.0, [-19.6, 19.6]) - 0.05).abs() < 1e-4);
/// ```
#[must_use]
pub fn infinite_scratch_error(radius: f64, span: [f64; 2]) -> f64 {
    let [first, last] = reduced_ends(span, radius);
    0.5 * (libm::erfc(last) + libm::erfc(-first))
}

/// Returns how far a scratch must run to both sides of the shaded point for [`infinite_scratch_error`] to keep a
/// tolerance, in coherence radii.
///
/// The least such length up to its rounding, which is outwards: 0 from tolerance 1 on, infinity for tolerance 0, NaN
/// below.
///
/// ```
/// use iridescence::diffraction::{infinite_scratch_error, scratch_half_length};
///
/// let half = 60.0 * scratch_half_length(1e-3);
/// assert!(half > 197.0 && half < 198.0);
/// assert!(infinite_scratch_error(60.0, [-half, half]) <= 1e-3);
/// ```
#[must_use]
pub fn scratch_half_length(tolerance: f64) -> f64 {
    if tolerance.is_nan() || tolerance < 0.0 {
        return f64::NAN;
    }
    if tolerance >= 1.0 {
        return 0.0;
    }
    if tolerance == 0.0 {
        return f64::INFINITY;
    }
    // Newton on ln erfc(u) = ln(tolerance), a concave function: from erfc(u) <= exp(-u^2), above the root, it stays above.
    let target = libm::log(tolerance);
    let mut u = libm::sqrt(-target);
    for _ in 0..8 {
        let scaled = erfcx(u);
        u += 0.5 * libm::sqrt(PI) * scaled * (libm::log(scaled) - u * u - target);
    }
    SQRT_2 * (u + 8.0 * f64::EPSILON * (1.0 + u))
}

/// Returns whether |eta_finite - eta_infinite| <= `tolerance` |eta_infinite| at this xi1: never true where it does not
/// hold.
///
/// `span` runs from t1 = s_t + l1 to t2 = s_t + l2 in um, t1 <= t2. False where the shaded point lies beyond an end, and
/// where an argument is NaN. The ends lose against exp(-(sigma k xi1)^2/2) as xi1 grows: the same scratch is infinite
/// along its mirror direction and finite beside it.
///
/// ```
/// use iridescence::diffraction::{Coherence, infinite_scratch_is_enough};
///
/// let light = Coherence { radius: 10.0, wavelength: 0.55 };
/// assert!(infinite_scratch_is_enough(light, [-60.0, 60.0], 0.01, 1e-3));
/// assert!(!infinite_scratch_is_enough(light, [-60.0, 60.0], 0.1, 1e-3));
/// ```
#[must_use]
pub fn infinite_scratch_is_enough(coherence: Coherence, span: [f64; 2], xi1: f64, tolerance: f64) -> bool {
    let [first, last] = reduced_ends(span, coherence.radius);
    let inside = first <= 0.0 && last >= 0.0;
    let height = FRAC_1_SQRT_2 * coherence.reduced(xi1).abs();
    if !inside || height.is_nan() || !coherence.is_valid() {
        return false;
    }
    let (near, far) = if -first <= last { (-first, last) } else { (last, -first) };
    if near == f64::INFINITY {
        return tolerance >= 0.0;
    }
    let nearest = HALF * end_share(near, height);
    if nearest > tolerance {
        return false;
    }
    2.0 * nearest <= tolerance || nearest + HALF * end_share(far, height) <= tolerance
}

/// Returns a bound on exp(v^2 - u^2) |w(v + i u)|, u >= 0, v >= 0: twice what a scratch lacks beyond an end, as a share.
fn end_share(end: f64, height: f64) -> f64 {
    let (low, high) = (end * SHRINK, height * GROW);
    let power = libm::exp((high - low) * (high + low));
    let supremum = if end >= height { STEEP } else { ANYWHERE };
    let modulus = supremum / libm::sqrt(end * end + height * height);
    power * if modulus < 1.0 { modulus } else { 1.0 }
}

/// Returns the distance beyond which a scratch's amplitude is at most `tolerance` of its peak, in coherence radii:
/// sqrt(2 ln(1/tolerance)).
///
/// Holds for the distance from the shaded point to any segment, finite or not, at any xi. 0 from tolerance 1 on, infinity
/// for tolerance 0, NaN below. The rule of WVJH17, 3 sigma, is that of the tolerance 1.1e-2.
///
/// ```
/// use iridescence::diffraction::window_reach;
///
/// assert!((window_reach((-4.5_f64).exp()) - 3.0).abs() < 1e-14);
/// ```
#[must_use]
pub fn window_reach(tolerance: f64) -> f64 {
    gaussian_reach(2.0, tolerance)
}
