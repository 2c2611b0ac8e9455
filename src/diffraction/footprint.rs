//! The mean of the window's square over the footprint of a pixel: an ellipse on the surface.
//!
//! # Definition
//!
//! An infinite scratch sends the same light everywhere along its line, and exp(-s_b^2/sigma^2) of it at the distance s_b.
//! A pixel sees the mean over its footprint (VWH18 Eq. 13). With h the half width of the ellipse across the scratch,
//! H = h/sigma and C = offset/sigma it depends on these two alone:
//!
//! ```math
//! M(H, C) = \frac{2}{\pi} \int_{-1}^{1} \sqrt{1 - t^2}\, e^{-(Ht - C)^2}\,dt, \qquad
//! h^2 = a_1^2 \sin^2\phi + a_2^2 \cos^2\phi
//! ```
//!
//! The paper's |eta_P|^2 is 2 A_C M, A_C = pi sigma^2.
//!
//! # Domain
//!
//! H >= 0 and any C; even in C exactly; in \[0, 1\]. Half axes >= 0 and a radius above 0, the squares of all and of their
//! inverses within the range of f64, |cos phi| <= 1; a negative or missing number gives NaN, as NaN does.
//!
//! | limit | M |
//! |---|---|
//! | H = 0 | exp(-C^2) |
//! | C = 0 | exp(-H^2/2) (I0(H^2/2) + I1(H^2/2)) |
//! | H to inf | 2/(sqrt(pi) H) sqrt(1 - C^2/H^2), 0 for H = inf |
//! | C far beyond H | 0 |
//!
//! Errors count as a share of the largest value M(H, 0). [`footprint_mean()`] takes the distance of the line from the edge
//! before it divides; with H and C given, the edge of a wide ellipse is known to a rounding of H.
//!
//! # Methods
//!
//! [`footprint_mean_reduced`] knows three cases, with d = H - C the distance to the near edge and e = H + C to the far one.
//! Well inside, the window sees no edge, and Gauss-Hermite nodes about the line take the mean of the chord's length. Beside
//! an edge of a wide ellipse, the other edge enters as a series in 1/e whose terms follow from two parabolic cylinder
//! functions of d. Elsewhere the ellipse is narrow, and the Gauss rule of weight sqrt(1 - t^2) does.
//! [`footprint_mean_reduced_medium`] and [`footprint_mean_reduced_coarse`] take fewer nodes and terms, and read the narrow case from
//! cells of a table. [`footprint_mean_vwh18`] is the published blend of the two limits, with the factor pi restored.
//! [`segment`] is the mean for a scratch that ends.
//!
//! <!-- report:begin footprint_mean -->
//!
//! | method | what it is | precision | largest error | promise | time / baseline |
//! |---|---|---|---|---|---|
//! | `accurate` | iridescence f64 | f64 | 2.3e-13 of peak | 5e-13 of peak | 3.03 (vwh18) |
//! | `medium` | iridescence f64 1e-6 tier | f64 | 2.8e-7 of peak | 1e-6 of peak | 2.30 (vwh18) |
//! | `coarse` | iridescence f64 1e-3 tier | f64 | 6.0e-4 of peak | 1e-3 of peak | 1.32 (vwh18) |
//! | `accurate` | iridescence f32 | f32 | 7.1e-7 of peak | 2e-6 of peak | 1.00 (accurate) |
//! | `coarse` | iridescence f32 1e-3 tier | f32 | 6.1e-4 of peak | 1e-3 of peak | 0.44 (accurate) |
//! | `vwh18` | VWH18 Eq. 16 with its factor pi | f64 | 8.9e3 rel. | none | 1.00 (vwh18) |
//! | `as_printed` | VWH18 Eq. 16 | f64 | not finite rel. | none | 1.23 (vwh18) |
//!
//! <!-- report:end footprint_mean -->
//!
//! <!-- report:begin footprint_mean_reduced -->
//!
//! | method | what it is | precision | largest error | promise | time / baseline |
//! |---|---|---|---|---|---|
//! | `accurate` | iridescence f64 | f64 | 2.3e-13 of peak | 5e-13 of peak | 1.00 (accurate) |
//! | `medium` | iridescence f64 1e-6 tier | f64 | 2.8e-7 of peak | 1e-6 of peak | 0.58 (accurate) |
//! | `coarse` | iridescence f64 1e-3 tier | f64 | 6.1e-4 of peak | 1e-3 of peak | 0.25 (accurate) |
//!
//! <!-- report:end footprint_mean_reduced -->
//!
//! # Where it fails
//!
//! A half width of more than about 1e7 radii is known to 1e-9 radii only, and so is the place of its edge: there the
//! accurate tier has the error of its argument. Far outside the edge the value falls below the error and then to 0. The
//! blend chooses between its limits by the area of the ellipse, where the half width across the scratch decides: it is
//! several times too large for an ellipse that is long along the scratch.
//!
//! # Errata
//!
//! The second term of VWH18 Eq. 16 lacks a factor pi: as A_P tends to 0, |eta_P|^2 must tend to 2 A_C exp(-s_b^2/sigma^2).
//! The middle member of Eq. 15 lacks 1/A_P.

mod accurate;
mod cells;
mod edge;
pub mod segment;

use crate::numeric::exponential::exponential;
use core::f64::consts::FRAC_2_SQRT_PI;

pub use segment::{footprint_segment_mean, footprint_segment_mean_hard};

/// From here on M is its limit at infinity.
const VAST: f64 = 1e100;

/// The footprint of a pixel: an ellipse on the surface. Lengths in micrometres.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Footprint {
    /// Half axes a1 and a2.
    pub axes: [f64; 2],
    /// Cosine of the angle between the first axis and the tangent of the scratch.
    pub cos_phi: f64,
}

/// Returns h^2, and NaN outside the domain.
#[inline(always)]
fn half_width_squared(footprint: Footprint) -> f64 {
    let Footprint {
        axes: [a1, a2],
        cos_phi,
    } = footprint;
    let sine_squared = (1.0 - cos_phi) * (1.0 + cos_phi);
    if a1 >= 0.0 && a2 >= 0.0 && sine_squared >= 0.0 {
        a1 * a1 * sine_squared + a2 * a2 * (cos_phi * cos_phi)
    } else {
        f64::NAN
    }
}

/// Returns the half width of the ellipse across the scratch, h = sqrt(a1^2 sin^2 phi + a2^2 cos^2 phi), in um.
///
/// NaN for a negative half axis or |cos phi| > 1. The reach of the mean that VWH18 Eqs. 12 and 13 take over the ellipse.
#[must_use]
#[inline]
pub fn footprint_half_width(footprint: Footprint) -> f64 {
    libm::sqrt(half_width_squared(footprint))
}

/// Returns M(H, C) = (2/pi) int_{-1}^{1} sqrt(1 - t^2) exp(-(H t - C)^2) dt to 1e-12: half width and offset in radii.
///
/// NaN for H < 0; see [`footprint`](self) for limits and errors. VWH18 Eq. 13.
///
/// ```
/// use iridescence::diffraction::footprint_mean_reduced;
///
/// // A pixel of no size sees the window's square.
/// assert!((footprint_mean_reduced(0.0, 1.0) - (-1.0_f64).exp()).abs() < 1e-15);
/// assert!((footprint_mean_reduced(1.0, 0.0) - 0.801456).abs() < 1e-6);
/// ```
#[must_use]
#[inline]
pub fn footprint_mean_reduced(half_width: f64, offset: f64) -> f64 {
    let offset = offset.abs();
    accurate::mean(half_width, offset, half_width - offset)
}

/// Returns [`footprint_mean_reduced`] to 1e-6.
#[must_use]
#[inline]
pub fn footprint_mean_reduced_medium(half_width: f64, offset: f64) -> f64 {
    let offset = offset.abs();
    cells::medium(half_width, offset, half_width - offset)
}

/// Returns [`footprint_mean_reduced`] to 1e-3.
#[must_use]
#[inline]
pub fn footprint_mean_reduced_coarse(half_width: f64, offset: f64) -> f64 {
    let offset = offset.abs();
    if (0.0..VAST).contains(&half_width) {
        cells::coarse(half_width * half_width, offset)
    } else if half_width < 0.0 {
        f64::NAN
    } else {
        vast(half_width, offset)
    }
}

/// Returns 1/radius, and NaN for a radius that is not positive.
#[inline(always)]
fn inverse_radius(radius: f64) -> f64 {
    if radius > 0.0 { 1.0 / radius } else { f64::NAN }
}

/// Returns the mean over the ellipse of exp(-s_b^2/sigma^2) for an infinite scratch at the offset, to 1e-12.
///
/// Offset of the line from the centre of the ellipse, of either sign, and the coherence radius sigma, in um.
#[must_use]
#[inline]
pub fn footprint_mean(footprint: Footprint, offset: f64, radius: f64) -> f64 {
    let (half_width, offset, inverse) = (footprint_half_width(footprint), offset.abs(), inverse_radius(radius));
    accurate::mean(half_width * inverse, offset * inverse, (half_width - offset) * inverse)
}

/// Returns [`footprint_mean`] to 1e-6.
#[must_use]
#[inline]
pub fn footprint_mean_medium(footprint: Footprint, offset: f64, radius: f64) -> f64 {
    let (half_width, offset, inverse) = (footprint_half_width(footprint), offset.abs(), inverse_radius(radius));
    cells::medium(half_width * inverse, offset * inverse, (half_width - offset) * inverse)
}

/// Returns [`footprint_mean`] to 1e-3.
#[must_use]
#[inline]
pub fn footprint_mean_coarse(footprint: Footprint, offset: f64, radius: f64) -> f64 {
    let inverse = inverse_radius(radius);
    cells::coarse(
        half_width_squared(footprint) * (inverse * inverse),
        offset.abs() * inverse,
    )
}

/// Returns the published blend of two limits, with the factor pi that VWH18 Eq. 16 lacks.
///
/// Kept to compare with. Arguments as for [`footprint_mean`](footprint_mean()).
#[must_use]
#[inline]
pub fn footprint_mean_vwh18(footprint: Footprint, offset: f64, radius: f64) -> f64 {
    let [a1, a2] = footprint.axes;
    let inverse = inverse_radius(radius);
    let squared = half_width_squared(footprint);
    // A_P/(2 A_C), at most 1.
    let ratio = 0.5 * (a1 * a2) * (inverse * inverse);
    let alpha = if ratio > 1.0 { 1.0 } else { ratio };
    let r = offset * inverse;
    let point = exponential(-(r * r), 0.0);
    // Half the chord over a1 a2/h.
    let inside = squared - offset * offset;
    let inside = if inside < 0.0 { 0.0 } else { inside };
    let chord = FRAC_2_SQRT_PI * radius * libm::sqrt(inside) / squared;
    if squared == 0.0 || ratio == 0.0 {
        return point;
    }
    alpha * chord + (1.0 - alpha) * point
}

/// M where the line lies far outside the edge, or a number is NaN or infinite.
fn outside(half_width: f64, offset: f64) -> f64 {
    if half_width.is_nan() || half_width < 0.0 || offset.is_nan() {
        f64::NAN
    } else {
        0.0
    }
}

/// The limit of M at infinity.
fn vast(half_width: f64, offset: f64) -> f64 {
    if half_width == f64::INFINITY || offset.is_nan() || offset >= half_width {
        return outside(half_width, offset);
    }
    let ratio = offset / half_width;
    FRAC_2_SQRT_PI * libm::sqrt((1.0 - ratio) * (1.0 + ratio)) / half_width
}
