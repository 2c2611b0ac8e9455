//! The light of a polygon over the lobe of a scratch.
//!
//! # Definition
//!
//! The integral of [`sphere`](mod@super::sphere) over the directions of a polygon's points above the horizon.
//!
//! # Domain
//!
//! Any simple polygon, convex or not, either way round, of any number of vertices, in any unit of length; 0 for fewer than
//! three, below the horizon, or seen edge on. NaN where a vertex is the shaded point or not finite, and as for the sphere.
//!
//! # Methods
//!
//! The contour integral of the sphere, along great circles and, where the polygon goes below it, the horizon. Edges are
//! taken as they come: no list, no order, no convexity.
//!
//! <!-- report:begin polygon_light -->
//!
//! | method | what it is | precision | largest error | promise | time / baseline |
//! |---|---|---|---|---|---|
//! | `accurate` | iridescence f64 | f64 | 2.7e-11 of peak | 6e-11 of peak | 15.95 (chord) |
//! | `within_1e-2` | iridescence f64 to 1e-2 | f64 | 2.0e-3 of peak | 7e-3 of peak | 9.88 (chord) |
//! | `within_1e-3` | iridescence f64 to 1e-3 | f64 | 3.4e-4 of peak | 1e-3 of peak | 10.92 (chord) |
//! | `within_1e-4` | iridescence f64 to 1e-4 | f64 | 2.5e-5 of peak | 8e-5 of peak | 13.24 (chord) |
//! | `accurate` | iridescence f32 | f32 | 0.016 of peak | 0.03 of peak | 1.00 (accurate) |
//! | `chord` | VWH18, exact chords | f64 | 29 rel. | none | 1.00 (chord) |
//! | `chords_3` | VWH18, exact chords on three lines | f64 | 20 rel. | none | 2.15 (chord) |
//! | `vwh18` | VWH18 3.4.2, roots mended | f64 | 2.1e3 rel. | none | 0.80 (chord) |
//! | `as_printed` | VWH18 3.4.2 | f64 | not finite rel. | none | 0.98 (chord) |
//!
//! <!-- report:end polygon_light -->
//!
//! # Where it fails
//!
//! A polygon that is not plane has no one answer where it crosses the horizon; one that crosses itself counts its parts
//! with their orientation. Slivers keep digits in proportion to their width.
//!
//! # Errata
//!
//! See [`published`](mod@super::published) and [`polygon`](mod@crate::geometry::polygon).

use super::outline_integral::{self, LightIntegral};
use super::scratch_lobe::ScratchLobe;
use crate::geometry::polygon_outline;

/// Returns the integral of a scratch's lobe over the visible part of a polygon, dimensionless, at least 0.
///
/// Vertices relative to the shaded point, in the frame of the scratch: tangent, bitangent, normal. Relative error 1e-9 at
/// most down to 1e-6 of [`ScratchLobe::whole_plane`]. NaN outside the domain. VWH18 Eqs. 24, 25.
///
/// ```
/// use iridescence::diffraction::Coherence;
/// use iridescence::light::{ScratchLobe, polygon_light};
///
/// let coherence = Coherence { radius: 60.0, wavelength: 0.55 };
/// let lobe = ScratchLobe { coherence, width: 2.5, view: [0.0, 0.0] };
/// let window = [[-1.0, -1.0, 2.0], [1.0, -1.0, 2.0], [1.0, 1.0, 2.0], [-1.0, 1.0, 2.0]];
/// assert!(polygon_light(lobe, &window) > 0.8 * lobe.whole_plane());
/// ```
#[doc(alias = "area light")]
#[must_use]
pub fn polygon_light(lobe: ScratchLobe, vertices: &[[f64; 3]]) -> f64 {
    let directed = polygon_outline(vertices, |_| {});
    let (Some(scales), true) = (lobe.scales(), directed) else {
        return f64::NAN;
    };
    let integral = outline_integral::exact(scales, |visit| {
        polygon_outline(vertices, visit);
    });
    integral.value.abs()
}

/// Returns the integral of a scratch's lobe over the visible part of a polygon with a relative error of at most `tolerance`,
/// and what it cost.
///
/// Vertices as for [`polygon_light`]. A tolerance below 1e-6 gives the exact rule, a negative one or NaN gives NaN.
#[must_use]
pub fn polygon_light_within(lobe: ScratchLobe, vertices: &[[f64; 3]], tolerance: f64) -> LightIntegral {
    let directed = polygon_outline(vertices, |_| {});
    let (Some(scales), true) = (lobe.scales(), directed) else {
        return LightIntegral::NAN;
    };
    let found = outline_integral::within(scales, tolerance, |visit| {
        polygon_outline(vertices, visit);
    });
    LightIntegral {
        value: found.value.abs(),
        ..found
    }
}
