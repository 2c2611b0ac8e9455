//! Which mean over the footprint keeps a tolerance.

use crate::diffraction::footprint::{Footprint, footprint_half_width};

/// Ways to the mean over a footprint, cheapest first.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum FootprintMethod {
    /// exp(-C^2), the value at the centre.
    Point,
    /// [`footprint_mean_coarse`](crate::diffraction::footprint_mean_coarse).
    Coarse,
    /// [`footprint_mean_medium`](crate::diffraction::footprint_mean_medium).
    Medium,
    /// [`footprint_mean`](crate::diffraction::footprint_mean()).
    Accurate,
}

/// The largest error of a tier as a share of M(H, 0): steps for narrow ellipses, then a law. There the window sees one edge,
/// M(H, 0) falls as 1/H and the chords at the edge as H^(-3/2): their share falls as H^(-1/2).
struct Bound {
    /// A half width in radii and the largest share below it, in rising order of half widths.
    steps: &'static [[f64; 2]],
    /// The share times the root of the half width, beyond the steps.
    wide: f64,
}

/// Somewhat above the largest errors at half widths from 1e-5 to 1e4; `tests/predictor/footprints.rs` holds them.
const COARSE: Bound = Bound {
    steps: &[
        [0.02, 5.7e-4],
        [0.2, 4.15e-4],
        [1.4, 6.3e-4],
        [2.0, 5.8e-4],
        [3.0, 5.1e-4],
        [4.0, 2.75e-4],
        [5.0, 1.65e-4],
    ],
    wide: 3.12e-4,
};
const MEDIUM: Bound = Bound {
    steps: &[
        [0.01, 1.6e-7],
        [0.35, 1e-7],
        [1.4, 1.8e-7],
        [6.0, 3.1e-7],
        [7.0, 2.1e-7],
        [8.0, 1e-7],
        [10.0, 3.6e-8],
    ],
    wide: 6.1e-8,
};
const ACCURATE: Bound = Bound {
    steps: &[[20.0, 3e-13]],
    wide: 2e-13,
};

impl Bound {
    fn share(&self, half_width: f64) -> f64 {
        if let Some([_, share]) = self.steps.iter().find(|[below, _]| half_width < *below) {
            return *share;
        }
        let root = libm::sqrt(half_width);
        // The rounding of the half width moves the edge of a wide ellipse; the chord there grows as the root of the way.
        self.wide / root + f64::min(4.0 * f64::EPSILON * root, EDGE)
    }
}

/// sqrt(8 eps), the most that a moved edge counts.
const EDGE: f64 = 4.2146848510894035e-8;

/// Returns the cheapest way to the footprint's mean within a tolerance, for every offset of the scratch.
///
/// The tolerance is a share of the mean's largest value M(H, 0), H the half width across the scratch in radii. The value
/// at the centre errs by at most H^2/4 of it, whatever H; the other ways err less as the ellipse grows, until the rounding of
/// its half width decides. None where no way keeps the tolerance, for NaN, and for a radius that is not positive.
///
/// ```
/// use iridescence::diffraction::{Footprint, FootprintMethod, footprint_method};
///
/// let pixel = Footprint { axes: [0.5, 0.3], cos_phi: 1.0 };
/// assert_eq!(footprint_method(pixel, 60.0, 1e-3), Some(FootprintMethod::Point));
/// let pixel = Footprint { axes: [300.0, 100.0], cos_phi: 0.5 };
/// assert_eq!(footprint_method(pixel, 60.0, 1e-3), Some(FootprintMethod::Coarse));
/// assert_eq!(footprint_method(pixel, 60.0, 1e-13), None);
/// ```
#[must_use]
pub fn footprint_method(footprint: Footprint, radius: f64, tolerance: f64) -> Option<FootprintMethod> {
    let half_width = footprint_half_width(footprint) / radius;
    if half_width.is_nan() || radius <= 0.0 {
        return None;
    }
    // The rounding of the half width, outwards.
    if 0.25 * (1.0 + 16.0 * f64::EPSILON) * (half_width * half_width) <= tolerance {
        return Some(FootprintMethod::Point);
    }
    if tolerance >= COARSE.share(half_width) {
        Some(FootprintMethod::Coarse)
    } else if tolerance >= MEDIUM.share(half_width) {
        Some(FootprintMethod::Medium)
    } else if tolerance >= ACCURATE.share(half_width) {
        Some(FootprintMethod::Accurate)
    } else {
        None
    }
}
