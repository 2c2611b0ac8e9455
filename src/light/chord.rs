//! Lights that cover the band: one chord, or a few under Gauss-Hermite.
//!
//! # Definition
//!
//! Where a light reaches on both sides beyond the band of the Gaussian and its outline does not turn or bend there, the
//! integral is a Gaussian mean of chords C,
//!
//! ```math
//! I = \frac{\sqrt\pi}{\sigma k}\,\frac{1}{\sqrt\pi}\int e^{-t^2}\,C\!\left(\frac{t}{\sigma k}\right)dt,
//! \qquad C(\xi_1) = \int_{\text{chord}} \mathrm{sinc}^2\frac{kW\xi_2}{2}\,d\xi_2
//! ```
//!
//! and n chords at the zeros of a Hermite polynomial integrate it. VWH18 takes one, at xi1 = 0 (Eq. 27).
//!
//! # Domain
//!
//! 1 to 5 chords; any other number gives NaN, as do a lobe or a light outside theirs.
//!
//! # Methods
//!
//! Chords are algebraic, [`cone_chords`] and [`polygon_crossings`]; each is one integral of sinc^2.
//!
//! # Where it fails
//!
//! Where an edge, a vertex or a silhouette lies in the band, more chords do not help: their number is no tolerance. Use
//! [`sphere_light_within`](super::sphere_light_within) and [`polygon_light_within`](super::polygon_light_within), which
//! are told one and need no more chords where these rules hold.

use super::scratch_lobe::{Scales, ScratchLobe};
use super::sphere::Sphere;
use crate::geometry::{Cone, cone_chords, polygon_crossings};

/// Gauss-Hermite nodes from 0 on and their weights over sqrt(pi) (DLMF 3.5(v)); the rule of n nodes has (n + 1)/2 rows.
const HERMITE: [&[[f64; 2]]; 5] = [
    &[[0.0, 1.0]],
    &[[core::f64::consts::FRAC_1_SQRT_2, 0.5]],
    &[[0.0, 0.6666666666666666], [1.224744871391589, 0.16666666666666666]],
    &[
        [0.5246476232752903, 0.4541241452319315],
        [1.6506801238857846, 0.04587585476806849],
    ],
    &[
        [0.0, 0.5333333333333333],
        [0.9585724646138185, 0.2220759220056126],
        [2.0201828704560856, 0.01125741132772069],
    ],
];

/// The mean of chords, times the band; `chord` gives k W/2 times that at a tangent cosine of the light.
fn hermite(scales: &Scales, count: usize, chord: impl Fn(f64) -> f64) -> f64 {
    let Some(rule) = count.checked_sub(1).and_then(|i| HERMITE.get(i)) else {
        return f64::NAN;
    };
    let mut sum = 0.0;
    for [node, weight] in *rule {
        let step = node / scales.along;
        let pair = if *node == 0.0 {
            chord(-scales.view[0])
        } else {
            chord(-scales.view[0] - step) + chord(-scales.view[0] + step)
        };
        sum += weight * pair;
    }
    scales.band() * sum / scales.across
}

/// Returns the integral of a scratch's lobe over the visible part of a sphere that covers the band, by `count` chords,
/// dimensionless.
///
/// The sphere's tangent cone; 0 where every chord misses it. VWH18 Eq. 27 with one chord.
///
/// ```
/// use iridescence::diffraction::Coherence;
/// use iridescence::light::{ScratchLobe, Sphere, sphere_light, sphere_light_chords};
///
/// let coherence = Coherence { radius: 60.0, wavelength: 0.55 };
/// let lobe = ScratchLobe { coherence, width: 2.5, view: [0.0, -0.2] };
/// let sphere = Sphere { centre: [0.0, 0.0, 4.0], radius: 1.0 };
/// let (one, all) = (sphere_light_chords(lobe, sphere, 1), sphere_light(lobe, sphere));
/// assert!((one / all - 1.0).abs() < 1e-4);
/// ```
#[must_use]
pub fn sphere_light_chords(lobe: ScratchLobe, sphere: Sphere, count: usize) -> f64 {
    let (Some(scales), Some(cone)) = (lobe.scales(), Cone::of_sphere(sphere.centre, sphere.radius)) else {
        return f64::NAN;
    };
    hermite(&scales, count, |x| {
        let [first, second] = cone_chords(cone, x).map(|ends| ends.map_or(0.0, |ends| scales.chord(ends)));
        first + second
    })
}

/// Returns the integral of a scratch's lobe over the visible part of a polygon that covers the band, by `count` chords,
/// dimensionless.
///
/// Vertices relative to the shaded point, in order, either way round, convex or not; 0 where every chord misses it.
/// VWH18 Eq. 27 with one chord.
#[must_use]
pub fn polygon_light_chords(lobe: ScratchLobe, vertices: &[[f64; 3]], count: usize) -> f64 {
    let Some(scales) = lobe.scales() else {
        return f64::NAN;
    };
    if !polygon_crossings(vertices, 2.0, |_| {}) {
        return f64::NAN;
    }
    hermite(&scales, count, |x| {
        // Crossings alternate: every second one ends a chord.
        let (mut sum, mut begin) = (0.0, None);
        polygon_crossings(vertices, x, |crossing| match begin.take() {
            None => begin = Some(crossing.y),
            Some(y) => sum += scales.chord([y, crossing.y]) * if crossing.upward { 1.0 } else { -1.0 },
        });
        f64::abs(sum)
    })
}
