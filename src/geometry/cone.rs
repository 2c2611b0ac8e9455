//! The tangent cone of a sphere, its outline on the surface and its chords.
//!
//! # Definition
//!
//! A sphere of radius r at a distance d covers the directions within the angle alpha, sin alpha = r/d, of its centre's: a
//! circle on the unit sphere, an ellipse in projection. The part below the horizon is cut off, and where the circle passes
//! under the horizon its outline goes on along it.
//!
//! # Domain
//!
//! A sphere that contains the shaded point, or touches it, has no cone: `None`, as for a negative radius or numbers that
//! are not finite. A radius of 0 has an empty outline.
//!
//! # Methods
//!
//! The chord on the line x = s solves two linear conditions on the circle y^2 + z^2 = 1 - s^2, by one square root and no
//! trigonometry. Its discriminant is a product of a sum and a difference, which keeps the digits of tiny lights.
//!
//! # Errata
//!
//! VWH18 Eq. 31 takes the disc through the sphere's centre in place of the tangent cone: tan alpha = r/d. A cone of 30
//! degrees becomes one of 26.6, of 60 one of 40.9. Its Eq. 35 has a power of plus or minus 1 where the two roots are two
//! different quotients.

use super::arc::Arc;
use super::vector::{largest_exponent, length, scale_by_exponent};

/// The directions within an angle of an axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cone {
    /// The axis, a unit vector.
    pub axis: [f64; 3],
    /// Sine of half the opening.
    pub sine: f64,
    /// Cosine of half the opening, from 0 to 1.
    pub cosine: f64,
}

impl Cone {
    /// Returns the tangent cone of a sphere; its centre is relative to the shaded point, both in the same unit of length.
    ///
    /// ```
    /// use iridescence::geometry::Cone;
    ///
    /// let cone = Cone::of_sphere([0.0, 0.0, 2.0], 1.0).unwrap();
    /// assert_eq!(cone.sine, 0.5);
    /// assert!(Cone::of_sphere([0.0, 0.0, 1.0], 1.0).is_none());
    /// ```
    #[must_use]
    pub fn of_sphere(centre: [f64; 3], radius: f64) -> Option<Cone> {
        if !centre.iter().all(|x| x.is_finite()) || !radius.is_finite() || radius < 0.0 {
            return None;
        }
        let exponent = -largest_exponent(centre);
        let [x, y, z] = scale_by_exponent(centre, exponent);
        let [radius, ..] = scale_by_exponent([radius, 0.0, 0.0], exponent);
        let distance = length([x, y, z]);
        let sine = radius / distance;
        (sine < 1.0).then(|| Cone {
            axis: [x / distance, y / distance, z / distance],
            sine,
            cosine: libm::sqrt((1.0 - sine) * (1.0 + sine)),
        })
    }
}

/// Calls `visit` for each arc of the outline of a cone above the horizon, counterclockwise about the cone.
///
/// Two arcs at most: the halves of the cone's circle, or what of it is above the horizon and the piece of the horizon
/// that closes it. A cone below the horizon has none.
#[inline]
pub fn cone_outline(cone: Cone, mut visit: impl FnMut(&Arc)) {
    let Cone { axis, sine, cosine } = cone;
    let [x, y, z] = axis;
    let tilt = libm::sqrt(y * y + z * z);
    // The direction at right angles to the axis that has the largest x, and its companion with none.
    let (u, v) = if tilt > 0.0 {
        ([tilt, -x * y / tilt, -x * z / tilt], [0.0, z / tilt, -y / tilt])
    } else {
        ([0.0, x, 0.0], [0.0, 0.0, 1.0])
    };
    let circle = |from, to, reflex| Arc {
        centre: [cosine * x, cosine * y],
        reach: sine * u[0],
        across: [sine * u[1], sine * v[1]],
        from,
        to,
        reflex,
    };
    let level = libm::sqrt(x * x + y * y);
    // The sines of the elevations of the circle's highest and lowest point.
    let (highest, lowest) = (sine * level + cosine * z, cosine * z - sine * level);
    if lowest >= 0.0 {
        visit(&circle([1.0, 0.0], [-1.0, 0.0], false));
        visit(&circle([-1.0, 0.0], [1.0, 0.0], false));
    } else if highest > 0.0 {
        let root = libm::sqrt(-lowest * highest);
        // From the highest point and from the azimuth of the axis to the points at the horizon, either way.
        let turned = |[c, s]: [f64; 2], [along, aside]: [f64; 2]| {
            let size = libm::sqrt((c * c + s * s) * (along * along + aside * aside));
            [(c * along - s * aside) / size, (s * along + c * aside) / size]
        };
        let top = [u[2], v[2]];
        let below = -cosine * z;
        visit(&circle(
            turned(top, [below, -root]),
            turned(top, [below, root]),
            below < 0.0,
        ));
        visit(&Arc {
            centre: [0.0; 2],
            reach: 1.0,
            across: [0.0, 1.0],
            from: turned([x, y], [cosine, -root]),
            to: turned([x, y], [cosine, root]),
            reflex: false,
        });
    }
}

/// Returns the chords of a cone above the horizon on the line of constant x, as ranges \[lower y, upper y\]: none, one, or
/// two where the light goes down at both ends.
///
/// Empty for |x| > 1.
#[must_use]
pub fn cone_chords(cone: Cone, x: f64) -> [Option<[f64; 2]>; 2] {
    let Cone { axis, sine, cosine } = cone;
    let [cx, cy, cz] = axis;
    let rest = (1.0 - x) * (1.0 + x);
    if rest < 0.0 || rest.is_nan() {
        return [None; 2];
    }
    let edge = libm::sqrt(rest);
    let tilt_squared = cy * cy + cz * cz;
    let tilt = libm::sqrt(tilt_squared);
    let p = x - cosine * cx;
    // The condition cy y + cz z >= level on the circle y^2 + z^2 = rest.
    let level = cosine * tilt_squared - p * cx;
    let discriminant = (sine * tilt - p) * (sine * tilt + p);
    if discriminant <= 0.0 || discriminant.is_nan() {
        return [(level < 0.0).then_some([-edge, edge]), None];
    }
    let root = libm::sqrt(discriminant);
    let (right, right_z) = ((cy * level + cz * root) / tilt_squared, cz * level - cy * root);
    let (left, left_z) = ((cy * level - cz * root) / tilt_squared, cz * level + cy * root);
    let inside = |y: f64| y.clamp(-edge, edge);
    match (right_z >= 0.0, left_z >= 0.0) {
        (true, true) if left <= right => [Some([inside(left), inside(right)]), None],
        (true, true) => [Some([-edge, inside(right)]), Some([inside(left), edge])],
        (false, true) => [Some([inside(left), edge]), None],
        (true, false) => [Some([-edge, inside(right)]), None],
        (false, false) => [(level <= -cy.abs() * edge).then_some([-edge, edge]), None],
    }
}
