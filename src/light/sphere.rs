//! The light of a sphere over the lobe of a scratch.
//!
//! # Definition
//!
//! ```math
//! I = \iint_{\text{light}} e^{-(\sigma k \xi_1)^2}\,\mathrm{sinc}^2\frac{kW\xi_2}{2}\,d\xi_1\,d\xi_2
//! ```
//!
//! over the projection of the sphere's visible part: the directions within its tangent cone and above the horizon, xi the sum of
//! the projected directions of light and view. VWH18 Eqs. 24 and 25; its 3.4.1 takes one chord of a disc.
//!
//! # Domain
//!
//! Any sphere that does not contain the shaded point, in any unit of length; radius 0 gives 0, and so does a sphere below the
//! horizon. Coherence radius, wavelength and width positive, in um; the view's projection no longer than 1. NaN elsewhere.
//!
//! # Methods
//!
//! Green's theorem makes a contour integral of it, with the arc of sinc squared as the antiderivative across the scratch:
//!
//! ```math
//! I = -\frac{2}{kW} \oint e^{-(\sigma k \xi_1)^2}\,\Phi\!\left(\frac{kW\xi_2}{2}\right) d\xi_1
//! ```
//!
//! The outline is made of arcs of circles, on which both coordinates are entire functions of the angle. So one rule covers
//! lights over the band, inside it, at its edge and at the horizon: no kink at a vertex, no root at a silhouette.
//! [`sphere_light`] sums it by Gauss-Legendre panels. [`sphere_light_within`] first asks the measure
//! exp(-t^2) |dt| of each piece of outline in the band, without a value of Phi, for its own Gauss rule, and bounds
//! the error of a rule by the derivatives that the spectrum of sinc^2 allows: one node with its curvature
//! where that is enough, up to eight, else the panels.
//!
//! <!-- report:begin sphere_light -->
//!
//! | method | what it is | precision | largest error | promise | time / baseline |
//! |---|---|---|---|---|---|
//! | `accurate` | iridescence f64 | f64 | 8.1e-12 of peak | 2.5e-11 of peak | 58.89 (chord) |
//! | `within_1e-2` | iridescence f64 to 1e-2 | f64 | 5.1e-3 of peak | 0.01 of peak | 32.01 (chord) |
//! | `within_1e-3` | iridescence f64 to 1e-3 | f64 | 3.7e-4 of peak | 1e-3 of peak | 40.90 (chord) |
//! | `within_1e-4` | iridescence f64 to 1e-4 | f64 | 3.7e-5 of peak | 1e-4 of peak | 51.36 (chord) |
//! | `accurate` | iridescence f32 | f32 | 1.7e-3 of peak | 4e-3 of peak | 1.00 (accurate) |
//! | `chord` | VWH18, exact chord | f64 | 29 rel. | none | 1.00 (chord) |
//! | `chords_3` | VWH18, three exact chords | f64 | 19 rel. | none | 1.64 (chord) |
//! | `vwh18` | VWH18 3.4.1, roots mended | f64 | 1.4e14 rel. | none | 1.34 (chord) |
//! | `as_printed` | VWH18 3.4.1 | f64 | not finite rel. | none | 1.08 (chord) |
//!
//! <!-- report:end sphere_light -->
//!
//! # Where it fails
//!
//! Relative digits fade below 1e-12 of the whole plane's integral, and for slivers in proportion to eps over their width. A
//! scratch wider than some 10 mm has more lobes than the panels resolve.
//!
//! # Errata
//!
//! See [`published`](mod@super::published) and [`cone`](mod@crate::geometry::cone).

use super::outline_integral::{self, LightIntegral};
use super::scratch_lobe::ScratchLobe;
use crate::geometry::{Cone, cone_outline};

/// A sphere: its centre relative to the shaded point, and its radius, in one unit of length.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sphere {
    /// Centre in the frame of the scratch: tangent, bitangent, normal.
    pub centre: [f64; 3],
    /// Radius.
    pub radius: f64,
}

/// Returns the integral of a scratch's lobe over the visible part of a sphere, dimensionless, at least 0.
///
/// Relative error 1e-9 at most down to 1e-6 of [`ScratchLobe::whole_plane`]. NaN outside the domain. VWH18 Eqs. 24, 25.
#[doc(alias = "area light")]
#[must_use]
pub fn sphere_light(lobe: ScratchLobe, sphere: Sphere) -> f64 {
    let (Some(scales), Some(cone)) = (lobe.scales(), Cone::of_sphere(sphere.centre, sphere.radius)) else {
        return f64::NAN;
    };
    let integral: LightIntegral = outline_integral::exact(scales, |visit| cone_outline(cone, visit));
    integral.value.max(0.0)
}

/// Returns the integral of a scratch's lobe over the visible part of a sphere with a relative error of at most `tolerance`,
/// and what it cost.
///
/// A tolerance below 1e-6 gives the exact rule, a negative one or NaN gives NaN.
#[must_use]
pub fn sphere_light_within(lobe: ScratchLobe, sphere: Sphere, tolerance: f64) -> LightIntegral {
    let (Some(scales), Some(cone)) = (lobe.scales(), Cone::of_sphere(sphere.centre, sphere.radius)) else {
        return LightIntegral::NAN;
    };
    let found = outline_integral::within(scales, tolerance, |visit| cone_outline(cone, visit));
    LightIntegral {
        value: if found.value < 0.0 { 0.0 } else { found.value },
        ..found
    }
}
