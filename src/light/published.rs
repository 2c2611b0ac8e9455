//! Area lights by one chord: the method of VWH18 3.4, kept to compare with.
//!
//! # Definition
//!
//! ```math
//! I \approx \frac{\sqrt\pi}{\sigma k} \sum_{\text{chords at } \xi_1 = 0}
//! \int_{q_0}^{q_1} \mathrm{sinc}^2 \frac{k W \xi_2}{2}\, d\xi_2
//! ```
//!
//! VWH18 Eq. 27 with the fit of Eq. 29, over the chords of the light on the line on which the lobe is brightest. A
//! sphere is the disc through its centre (Eq. 31), tan alpha = r/d; a polygon is itself above the horizon (Eq. 36).
//!
//! # Domain
//!
//! That of [`sphere_light`](super::sphere_light()) and [`polygon_light`](super::polygon_light()); NaN outside.
//!
//! # Methods
//!
//! As published, but for what is a misprint: the two roots of Eqs. 35 and 40 are two different quotients, sgn(0) is 1,
//! and N of Eq. 27 has its limit 0 at q = 0. The chords come from [`cone_chords`] and [`polygon_crossings`], which find
//! the roots that the paper means. A polygon's crossings go up and down in turn, so that no root is sorted: each counts
//! with the sign of its direction, the highest one positive.
//!
//! # Where it fails
//!
//! - A light with an edge inside the band, |xi1| < 3/(sqrt2 sigma k): one chord stands for all of it. A light that the
//!   line misses gives 0, one that ends inside the band counts whole.
//! - A light away from the specular direction: the fit of Si leaves a wrong and often negative difference.
//! - A large sphere: its disc is smaller than its cone.
//!
//! tests/errata_vwh18_lights.rs measures how often, with each of these mended in turn.
//!
//! # Errata
//!
//! VWH18 Eqs. 35 and 40: the power of plus or minus 1. Eq. 22 needs the two-argument arctangent; Eq. 41 cannot tell a
//! crossing from a touch.

use super::scratch_lobe::{Scales, ScratchLobe};
use super::sphere::Sphere;
use crate::geometry::{Cone, cone_chords, polygon_crossings};
use crate::special::sinc_squared_integral_vwh18;

impl Scales {
    /// Eq. 27 between two bitangent cosines of light: N(q1) - N(q0).
    fn segment_vwh18(&self, ends: [f64; 2]) -> f64 {
        let arc = sinc_squared_integral_vwh18(ends.map(|y| self.across * (y + self.view[1])));
        self.band() * (arc / self.across)
    }
}

/// Returns the integral of a scratch's lobe over a sphere by the published method, dimensionless; negative for some.
///
/// The sphere as for [`sphere_light`](super::sphere_light()), which is accurate; NaN where that is. It lacks the
/// light's extent along the tangent, the tangent cone and an accurate Si. VWH18 Eqs. 27, 29 and 31 to 37.
///
/// ```
/// use iridescence::diffraction::Coherence;
/// use iridescence::light::{ScratchLobe, Sphere, sphere_light, sphere_light_vwh18};
///
/// let lobe = ScratchLobe { coherence: Coherence { radius: 30.0, wavelength: 0.55 }, width: 2.0, view: [0.0, 0.3] };
/// let sphere = Sphere { centre: [0.0, -0.6, 2.0], radius: 0.4 };
/// let ratio = sphere_light_vwh18(lobe, sphere) / sphere_light(lobe, sphere);
/// assert!((0.9..1.1).contains(&ratio));
/// ```
#[must_use]
pub fn sphere_light_vwh18(lobe: ScratchLobe, sphere: Sphere) -> f64 {
    let (Some(scales), Some(cone)) = (lobe.scales(), Cone::of_sphere(sphere.centre, sphere.radius)) else {
        return f64::NAN;
    };
    // The disc's tangent is the cone's sine.
    let secant = libm::sqrt(1.0 + cone.sine * cone.sine);
    let disc = Cone {
        axis: cone.axis,
        sine: cone.sine / secant,
        cosine: 1.0 / secant,
    };
    let chords = cone_chords(disc, -scales.view[0]);
    chords
        .into_iter()
        .flatten()
        .map(|ends| scales.segment_vwh18(ends))
        .sum()
}

/// Returns the integral of a scratch's lobe over a polygon by the published method, dimensionless; negative for some.
///
/// The vertices as for [`polygon_light`](super::polygon_light()), which is accurate; NaN where that is. It lacks the
/// light's extent along the tangent and an accurate Si. VWH18 Eqs. 27, 29 and 36 to 40.
#[must_use]
pub fn polygon_light_vwh18(lobe: ScratchLobe, vertices: &[[f64; 3]]) -> f64 {
    let Some(scales) = lobe.scales() else {
        return f64::NAN;
    };
    let mut sum = 0.0;
    let mut highest = f64::NEG_INFINITY;
    let mut orientation = 1.0;
    let directed = polygon_crossings(vertices, -scales.view[0], |crossing| {
        let sign = if crossing.upward { -1.0 } else { 1.0 };
        sum += sign * scales.segment_vwh18([-scales.view[1], crossing.y]);
        if crossing.y > highest {
            (highest, orientation) = (crossing.y, sign);
        }
    });
    if directed { orientation * sum } else { f64::NAN }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::diffraction::Coherence;
    use crate::light::{polygon_light, sphere_light};

    fn lobe(view: [f64; 2]) -> ScratchLobe {
        let coherence = Coherence {
            radius: 20.0,
            wavelength: 0.5,
        };
        ScratchLobe {
            coherence,
            width: 2.0,
            view,
        }
    }

    const QUAD: [[f64; 3]; 4] = [[-0.5, -0.4, 1.0], [0.5, -0.4, 1.0], [0.5, 0.4, 1.0], [-0.5, 0.4, 1.0]];

    #[test]
    fn a_polygon_gives_the_same_either_way_round_and_from_any_vertex() {
        for view in [[0.0, 0.0], [0.1, -0.3], [-0.2, 0.25]] {
            let value = polygon_light_vwh18(lobe(view), &QUAD);
            assert!(value != 0.0);
            let mut turned = QUAD;
            turned.rotate_left(1);
            let mut reversed = QUAD;
            reversed.reverse();
            for other in [turned, reversed] {
                let other = polygon_light_vwh18(lobe(view), &other);
                assert!(
                    (other - value).abs() <= 1e-15 * lobe(view).whole_plane(),
                    "{other} {value}"
                );
            }
        }
    }

    #[test]
    fn a_light_over_the_whole_peak_is_within_a_tenth() {
        let sphere = Sphere {
            centre: [0.0, 0.0, 3.0],
            radius: 1.5,
        };
        let pairs = [
            (
                sphere_light_vwh18(lobe([0.0; 2]), sphere),
                sphere_light(lobe([0.0; 2]), sphere),
            ),
            (
                polygon_light_vwh18(lobe([0.0; 2]), &QUAD),
                polygon_light(lobe([0.0; 2]), &QUAD),
            ),
        ];
        for (published, accurate) in pairs {
            let error = published / accurate - 1.0;
            assert!(error.abs() < 0.1 && error.abs() > 1e-4, "{published} {accurate}");
        }
    }

    #[test]
    fn a_light_beside_the_line_gives_0_and_nonsense_gives_nan() {
        let beside = Sphere {
            centre: [1.0, 0.0, 1.0],
            radius: 0.1,
        };
        let below = Sphere {
            centre: [0.0, 0.1, -1.0],
            radius: 0.1,
        };
        let around = Sphere {
            centre: [0.0, 0.0, 0.5],
            radius: 1.0,
        };
        assert_eq!(sphere_light_vwh18(lobe([0.0; 2]), beside), 0.0);
        assert_eq!(sphere_light_vwh18(lobe([0.0; 2]), below), 0.0);
        assert!(sphere_light_vwh18(lobe([0.0; 2]), around).is_nan());
        assert!(sphere_light_vwh18(lobe([1.0, 1.0]), beside).is_nan());
        assert!(sphere_light_vwh18(lobe([f64::NAN, 0.0]), beside).is_nan());
        assert_eq!(
            polygon_light_vwh18(lobe([0.0; 2]), &QUAD.map(|v| [v[0] + 2.0, v[1], v[2]])),
            0.0
        );
        assert_eq!(polygon_light_vwh18(lobe([0.0; 2]), &QUAD[..2]), 0.0);
        assert!(polygon_light_vwh18(lobe([0.0; 2]), &[QUAD[0], QUAD[1], [0.0; 3]]).is_nan());
        assert!(polygon_light_vwh18(lobe([0.0, f64::NAN]), &QUAD).is_nan());
    }
}
