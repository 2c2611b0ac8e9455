//! Form factors of polygons and spheres, clipped at the horizon, for a cosine lobe and for a linearly transformed one.
//!
//! # Definition
//!
//! ```math
//! F = \frac{1}{\pi} \int_{\Omega,\ z \ge 0} \cos\theta\, d\omega
//!   = \frac{1}{2\pi} \oint \frac{n \cdot (p \times dp)}{|p|^2}
//! ```
//!
//! The share of a hemisphere of light that the light Omega gives (Lambert 1760, Baum et al. 1989 Eq. 2); the contour runs
//! round the visible part, along the horizon where that cuts it. A linearly transformed cosine (Heitz et al. 2016 Eq. 1)
//! is the cosine lobe after a linear map M of directions; its integral over a light is F of the light under
//! M^-1, and what lies below z = 0 there is clipped:
//!
//! ```math
//! D(\omega) = \frac{\max(p_z, 0)}{\pi\,|p|^4}\, |\det M^{-1}|, \qquad p = M^{-1} \omega
//! ```
//!
//! # Domain
//!
//! Positions are relative to the shaded point, z along the surface normal, in any one unit of length and any size: only
//! their ratios count, which may reach 1e300. A number that is not finite gives NaN. A light in a plane through the
//! shaded point covers no solid angle: 0.
//!
//! # Methods
//!
//! Polygon: each edge adds theta m_z/2, with theta its angle and m the unit normal of its plane. That sum cancels for
//! a small light. Here an edge is cut in the chord between its unit vectors and the rest, (theta - sin theta) m_z/2. The
//! chords enclose a plane polygon, whose area comes from differences against one visible vertex, formed from
//! differences of positions; below 45 degrees their component along the height comes from the length 1 of the vectors.
//! The clip at the horizon is a stream. The horizon's arc is one more edge, from the exit to the entry: of a plane
//! polygon both lie on one straight line, so the arc is the shorter one.
//!
//! Sphere: with S, C the sine and cosine of the cone's half angle and c the cosine of its axis with the normal, the
//! contour integral gives, where the horizon cuts it,
//!
//! ```math
//! \pi F = T(\psi) + c\, S^2\, T(\phi), \qquad T(x) = x - \sin x \cos x, \qquad
//! \psi = \operatorname{atan2}(q, C),\ \phi = \operatorname{atan2}(q, -cC),\ q^2 = S^2 - c^2
//! ```
//!
//! which are the segments of the horizon and of the projected outline on either side of their chord; equal to the forms
//! of Snyder 1996 and of Lagarde and de Rousiers 2014, which cancel for small lights. Below the horizon (c < 0) the two
//! terms cancel: a power series in sin^2 phi, or a difference of angles, takes their place.
//!
//! Sphere under M^-1: the cone becomes an elliptic one. In the frame of its axes the contour integral is elementary,
//! over the whole outline and over any arc; the axis is the positive root of a secular equation. Cones of less than
//! about 14 degrees are integrated over their area instead, by 16 x 8 Gauss nodes: a sum of positive numbers.
//!
//! # Where it fails
//!
//! The absolute error is a few eps of the light's size everywhere. A relative error grows without bound for a polygon seen
//! from its own plane (eps over the angle with the plane), and for a long light of which a strip of height h clears
//! the horizon (eps/h^2). The transformed sphere loses eps over the visible share of its outline, squared, when it has
//! nearly set in the lobe's space. A polygon that is not plane, or crosses itself, has no one answer
//! at the horizon.
//!
//! # Errata
//!
//! Heitz et al. 2016 clip in the lobe's space only, and so does this: a lobe that reaches below the surface also collects
//! light from there. The form factor of the clipless shortcut (Hill and Heitz 2016) is exact for spheres alone.

mod elliptic_cone;
mod outline;
mod vectors;

use crate::geometry::vector::{cross, dot, length};
use core::f64::consts::PI;
use elliptic_cone::elliptic_cone;
use outline::mapped_polygon;
use vectors::{across, add, determinant, scale_to_one, scaled, sum_of_products, times, transform, unit};

/// sin^2 phi up to which the series of a setting sphere is used, and its terms: 1/4^28 is below eps.
const SETTING: f64 = 0.25;
const SETTING_TERMS: i32 = 28;
/// A linearly transformed cosine: a lobe, and the integral of the whole lobe.
///
/// `matrix` is M^-1 of Heitz et al. 2016, by rows: it takes a world direction w to the lobe's space, p_i = sum_j
/// `matrix[i][j]` w_j, where the lobe is max(p_z, 0)/pi of the unit vector. Its scale and the sign of its determinant
/// do not count; a singular matrix has no lobe. The world is that of the lights, z along the normal; a table that is
/// made for a frame with the outgoing direction in the xz plane needs its rotation multiplied from the right.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LinearCosine {
    /// Rows of M^-1, world to lobe.
    #[doc(alias = "Minv")]
    pub matrix: [[f64; 3]; 3],
    /// Integral of the lobe over all directions: its albedo.
    pub amplitude: f64,
}

impl LinearCosine {
    /// The lobe with the largest entry of its matrix in [1, 2); none where an entry is not finite.
    fn scaled(self) -> Option<[[f64; 3]; 3]> {
        let scale = scale_to_one(self.matrix.as_flattened())?;
        Some(self.matrix.map(|row| scaled(scale, row)))
    }
}

/// Returns the share, 0 to 1, of a hemisphere of light that a uniform polygon gives.
///
/// `vertices` in order, either way round, closed by the edge from the last to the first; the polygon is plane, convex or
/// not. 0 for fewer than three vertices and for a polygon below the horizon. Lambert 1760; Baum et al. 1989 Eq. 2.
///
/// ```
/// use iridescence::light::polygon_form_factor;
///
/// // A square above the point, as wide as its height.
/// let square = [[-0.5, -0.5, 1.0], [0.5, -0.5, 1.0], [0.5, 0.5, 1.0], [-0.5, 0.5, 1.0]];
/// let tangent = 0.5 / 1.25_f64.sqrt();
/// let exact = 4.0 / std::f64::consts::PI * tangent * tangent.atan();
/// assert!((polygon_form_factor(&square) - exact).abs() < 1e-15);
/// ```
#[doc(alias("Lambert", "irradiance", "view factor"))]
#[must_use]
pub fn polygon_form_factor(vertices: &[[f64; 3]]) -> f64 {
    mapped_polygon(vertices, |v| v)
}

/// Returns the form factor of the sphere that has the polygon's unclipped vector form factor, 0 to 1.
///
/// The shortcut of engines for [`polygon_form_factor`], without a clip: exact above the horizon, wrong across it. On
/// random parallelograms that cross, the median relative error is 16 to 20 percent, and a tenth of them get 0 (held
/// by tests/form_factor.rs). The sphere itself is cut exactly here; the rational fit that web engines put
/// in its place has a median of 40 to 50 percent. Arguments as there. Hill and Heitz 2016.
#[must_use]
pub fn polygon_form_factor_clipless(vertices: &[[f64; 3]]) -> f64 {
    let Some(scale) = scale_to_one(vertices.as_flattened()) else {
        return f64::NAN;
    };
    let vertex = |i: usize| scaled(scale, vertices[i % vertices.len()]);
    let (mut sum, mut volume) = ([0.0; 3], 0.0);
    for i in 0..vertices.len() {
        let (a, b) = (vertex(i), vertex(i + 1));
        volume += dot(vertex(0), cross(a, b));
        let (Some((a, _)), Some((b, _))) = (unit(a), unit(b)) else {
            return 0.0;
        };
        let normal = cross(a, b);
        let sine = length(normal);
        if sine > 0.0 {
            sum = add(sum, times(libm::atan2(sine, dot(a, b)) / sine, normal));
        }
    }
    let toward = if volume < 0.0 { -0.5 / PI } else { 0.5 / PI };
    let Some((axis, length)) = unit(times(toward, sum)) else {
        return 0.0;
    };
    if volume == 0.0 {
        return 0.0;
    }
    sphere_form_factor(axis, libm::sqrt(length.min(1.0 - 8.0 * f64::EPSILON)))
}

/// Returns the share, 0 to 1, of a hemisphere of light that a uniform sphere gives.
///
/// `centre` and `radius` in one unit. NaN where the shaded point is inside or on the sphere, and for a negative radius; 0
/// for radius 0 and below the horizon. Snyder 1996; Lagarde and de Rousiers 2014.
///
/// ```
/// use iridescence::light::sphere_form_factor;
///
/// assert_eq!(sphere_form_factor([0.0, 0.0, 2.0], 1.0), 0.25);
/// // Half of it has set.
/// assert!((sphere_form_factor([2.0, 0.0, 0.0], 2.0_f64.sqrt()) - (0.25 - 0.5 / std::f64::consts::PI)).abs() < 1e-15);
/// ```
#[doc(alias("irradiance", "view factor"))]
#[must_use]
pub fn sphere_form_factor(centre: [f64; 3], radius: f64) -> f64 {
    let Some(cone) = Cone::of_sphere(centre, radius) else {
        return f64::NAN;
    };
    let ([x, y, z], r) = (cone.centre, cone.radius);
    if z <= -r {
        return 0.0;
    }
    let (sine, cosine, axis) = (cone.sine, cone.cosine, z / cone.distance);
    if z >= r {
        return sine * sine * axis;
    }
    let across = libm::hypot(x, y) / cone.distance;
    let q = libm::sqrt(r - z) * libm::sqrt(r + z) / cone.distance;
    let psi = libm::atan2(q, cosine);
    let phi = libm::atan2(q, -axis * cosine);
    let square = sine * sine;
    let value = if axis >= 0.0 {
        segment(psi) + axis * square * segment(phi)
    } else {
        let y = q / (sine * across);
        if y * y <= SETTING {
            square * y * y * y * setting(y * y, sine, cosine, axis, across)
        } else if square <= 0.5 {
            segment(psi) + axis * square * segment(phi)
        } else {
            // 1 + axis square, and T(phi) - T(psi) by the angle between them.
            let rest = across * across / (1.0 - axis) - axis * cosine * cosine;
            let sine_between = q * cosine / (sine * (1.0 - axis));
            let middle = libm::sin(0.5 * (phi + psi));
            rest * segment(phi)
                - arc_less_chord(libm::asin(sine_between.min(1.0)))
                - 2.0 * sine_between * middle * middle
        }
    };
    (value / PI).clamp(0.0, 1.0)
}

/// Returns the lobe's density at a unit direction of the world, in 1/sr.
///
/// 0 where the lobe's space has it below its horizon. Heitz et al. 2016 Eq. 1.
#[must_use]
pub fn linear_cosine_density(lobe: LinearCosine, direction: [f64; 3]) -> f64 {
    let Some(matrix) = lobe.scaled() else {
        return f64::NAN;
    };
    let p = transform(&matrix, direction);
    let square = dot(p, p);
    if p[2].is_nan() || p[2] > 0.0 {
        lobe.amplitude * (determinant(matrix).abs() * p[2] / (PI * square * square))
    } else {
        lobe.amplitude * 0.0
    }
}

/// Returns the integral of the lobe over a polygon, dimensionless: the amplitude times 0 to 1.
///
/// `vertices` as in [`polygon_form_factor`], in the world. The clip is at the horizon of the lobe's space. Heitz et al. 2016.
#[doc(alias("LTC", "linearly transformed cosine"))]
#[must_use]
pub fn polygon_linear_cosine(lobe: LinearCosine, vertices: &[[f64; 3]]) -> f64 {
    let Some(matrix) = lobe.scaled() else {
        return f64::NAN;
    };
    lobe.amplitude * mapped_polygon(vertices, |v| transform(&matrix, v))
}

/// Returns the integral of the lobe over a sphere, dimensionless: the amplitude times 0 to 1.
///
/// `centre` and `radius` as in [`sphere_form_factor`], in the world. The clip is at the horizon of the lobe's space. The
/// cone is the true elliptic one, not a sphere put in its place.
#[doc(alias("LTC", "linearly transformed cosine"))]
#[must_use]
pub fn sphere_linear_cosine(lobe: LinearCosine, centre: [f64; 3], radius: f64) -> f64 {
    let (Some(matrix), Some(cone)) = (lobe.scaled(), Cone::of_sphere(centre, radius)) else {
        return f64::NAN;
    };
    let (e1, e2) = across(times(1.0 / cone.distance, cone.centre));
    let [p0, p1, p2] = [cone.centre, e1, e2].map(|v| transform(&matrix, v));
    let (along, aside) = (cone.cosine / cone.distance, cone.sine);
    lobe.amplitude * elliptic_cone([times(along, p0), times(aside, p1), times(aside, p2)])
}

/// The cone from the shaded point about a sphere, with the sphere in a unit in which its largest number is about 1.
struct Cone {
    centre: [f64; 3],
    radius: f64,
    distance: f64,
    /// Of the half angle.
    sine: f64,
    cosine: f64,
}

impl Cone {
    /// None where a number is not finite, the radius negative, or the shaded point not outside.
    fn of_sphere(centre: [f64; 3], radius: f64) -> Option<Self> {
        let [x, y, z] = centre;
        let scale = scale_to_one(&[x, y, z, radius])?;
        let ([x, y, z], r) = (scaled(scale, centre), radius * scale);
        let distance = length([x, y, z]);
        // Distance^2 - radius^2, which cancels beside the sphere.
        let tangent = sum_of_products([x, y, z, -r], [x, y, z, r]);
        let outside = radius >= 0.0 && (tangent > 0.0 || (radius == 0.0 && distance > 0.0));
        outside.then(|| Self {
            centre: [x, y, z],
            radius: r,
            distance,
            sine: r / distance,
            cosine: libm::sqrt(tangent) / distance,
        })
    }
}

/// Returns (T(psi) + axis sine^2 T(phi))/(sine^2 y^3) for axis < 0 and w = y^2 = sin^2 phi small, by the powers of w of T
/// at sines y and sine y. The first two terms, which are equal, are left out.
fn setting(w: f64, sine: f64, cosine: f64, axis: f64, across: f64) -> f64 {
    let square = sine * sine;
    let first = square * across * across / (sine - axis);
    let second = sine * cosine * cosine;
    // Coefficients of T: binomial(2k, k)/4^k 4k/(4k^2 - 1); partial sums of the powers of sine^2.
    let coefficient = |half: f64, k: f64| half * (4.0 * k / (4.0 * k * k - 1.0));
    let (mut half, mut power, mut partial, mut sum) = (0.5, w, 1.0, 0.0);
    for k in 1..=SETTING_TERMS {
        let k = f64::from(k);
        let next = half * (2.0 * k + 1.0) / (2.0 * k + 2.0);
        sum += power * (first * coefficient(half, k) - second * coefficient(next, k + 1.0) * partial);
        (half, power, partial) = (next, power * w, 1.0 + square * partial);
    }
    sum
}

/// Returns x - sin x for 0 <= x <= 2 pi, to a few eps of itself.
fn arc_less_chord(x: f64) -> f64 {
    if x > 1.0 {
        return x - libm::sin(x);
    }
    let u = x * x;
    let mut sum = 1.0;
    // The ratios of the series x^3/6 - x^5/120 + ..., from its end.
    for k in (2..=8).rev() {
        let k = f64::from(2 * k);
        sum = 1.0 - u / (k * (k + 1.0)) * sum;
    }
    x * u / 6.0 * sum
}

/// Returns T(x) = x - sin x cos x, the area of two circular segments of half angle x.
fn segment(x: f64) -> f64 {
    0.5 * arc_less_chord(2.0 * x)
}
