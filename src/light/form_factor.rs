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

use crate::numeric::gauss::EIGHT_POINTS;
use crate::numeric::phase::{two_product, two_sum};
use core::f64::consts::PI;

/// The 16-point Gauss-Legendre rule (DLMF 3.5(v)), positive nodes.
const SIXTEEN_POINTS: [[f64; 2]; 8] = [
    [0.09501250983763744, 0.1894506104550685],
    [0.2816035507792589, 0.18260341504492358],
    [0.45801677765722737, 0.16915651939500254],
    [0.6178762444026438, 0.1495959888165767],
    [0.755404408355003, 0.12462897125553388],
    [0.8656312023878318, 0.09515851168249279],
    [0.9445750230732326, 0.062253523938647894],
    [0.9894009349916499, 0.027152459411754096],
];
/// sin^2 phi up to which the series of a setting sphere is used, and its terms: 1/4^28 is below eps.
const SETTING: f64 = 0.25;
const SETTING_TERMS: i32 = 28;
/// Largest square of the ratio of an elliptic cone's section to its distance that is integrated over its area.
const NARROW: f64 = 0.0625;

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
        let sine = norm(normal);
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
        let distance = norm([x, y, z]);
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

/// A direction of the outline.
#[derive(Clone, Copy)]
struct Direction {
    unit: [f64; 3],
    /// The unit vector less that of the reference vertex.
    chord: [f64; 3],
    /// The horizontal part of the chord, in a frame of the reference.
    plan: [f64; 2],
}

/// The area that an outline of directions encloses, seen along z, as it is walked.
struct Outline {
    reference: [f64; 3],
    /// Of the reference vertex.
    length: f64,
    last: Direction,
    /// Twice the area of the chords' polygon.
    flat: f64,
    /// Twice the area between chords and arcs.
    round: f64,
}

impl Outline {
    /// None for a vertex at the shaded point.
    fn from(vertex: [f64; 3]) -> Option<Self> {
        let (reference, length) = unit(vertex)?;
        let last = Direction {
            unit: reference,
            chord: [0.0; 3],
            plan: [0.0; 2],
        };
        Some(Self {
            reference,
            length,
            last,
            flat: 0.0,
            round: 0.0,
        })
    }

    /// The direction of a point; none at the shaded point.
    fn direction(&self, position: [f64; 3], offset: [f64; 3]) -> Option<Direction> {
        let (unit, length) = unit(position)?;
        let reference = self.reference;
        let chord = if 2.0 * length >= self.length {
            let ratio = self.length / length;
            let longer = dot(offset, add(unit, times(ratio, reference))) / (1.0 + ratio);
            times(1.0 / length, add(offset, times(-longer, reference)))
        } else {
            add(unit, times(-1.0, reference))
        };
        let [x, y, height] = reference;
        let across = libm::sqrt(x * x + y * y);
        let plan = if height > across {
            [chord[0], chord[1]]
        } else {
            // Both vectors have length 1, which gives the part of the chord along the reference's azimuth.
            let along = -(2.0 * height * chord[2] + dot(chord, chord)) / (2.0 * across);
            [along, (x * chord[1] - y * chord[0]) / across]
        };
        Some(Direction { unit, chord, plan })
    }

    /// Walks to the next point, given by its position and its offset from the reference vertex; none if the edge goes
    /// through the shaded point.
    fn walk(&mut self, position: [f64; 3], offset: [f64; 3]) -> Option<()> {
        let next = self.direction(position, offset)?;
        let last = self.last;
        let chord = add(next.chord, times(-1.0, last.chord));
        let normal = cross(last.unit, chord);
        let (sine, cosine) = (norm(normal), 1.0 - 0.5 * dot(chord, chord));
        if sine > 0.0 {
            self.round += arc_less_chord(libm::atan2(sine, cosine)) * (normal[2] / sine);
        } else if cosine < 0.0 {
            return None;
        }
        self.flat += last.plan[0] * next.plan[1] - last.plan[1] * next.plan[0];
        self.last = next;
        Some(())
    }
}

/// A vertex in the world; in the mapped space; and there from the reference vertex, by the map of the difference.
#[derive(Clone, Copy)]
struct Vertex {
    world: [f64; 3],
    position: [f64; 3],
    offset: [f64; 3],
}

/// The form factor of a polygon under a linear map.
fn mapped_polygon(vertices: &[[f64; 3]], map: impl Fn([f64; 3]) -> [f64; 3]) -> f64 {
    let Some(scale) = scale_to_one(vertices.as_flattened()) else {
        return f64::NAN;
    };
    if vertices.len() < 3 {
        return 0.0;
    }
    visible_area(vertices, scale, map).map_or(0.0, |twice| (twice.abs() / (2.0 * PI)).min(1.0))
}

/// Twice the projected area of the visible part, signed by the orientation; none for a light without solid angle.
fn visible_area(vertices: &[[f64; 3]], scale: f64, map: impl Fn([f64; 3]) -> [f64; 3]) -> Option<f64> {
    let vertex = |i: usize| scaled(scale, vertices[i % vertices.len()]);
    let start = (0..vertices.len()).find(|&i| map(vertex(i))[2] > 0.0)?;
    let origin = vertex(start);
    let mapped = map(origin);
    let mut outline = Outline::from(mapped)?;
    let place = |world: [f64; 3]| Vertex {
        world,
        position: map(world),
        offset: map(add(world, times(-1.0, origin))),
    };
    let crossing = |above: Vertex, below: Vertex| {
        let share = above.position[2] / (above.position[2] - below.position[2]);
        let step = times(share, map(add(below.world, times(-1.0, above.world))));
        let (position, offset) = (add(above.position, step), add(above.offset, step));
        ([position[0], position[1], 0.0], [offset[0], offset[1], -mapped[2]])
    };
    let mut last = place(origin);
    for i in 1..=vertices.len() {
        let next = place(vertex(start + i));
        match (last.position[2] > 0.0, next.position[2] > 0.0) {
            (true, true) => outline.walk(next.position, next.offset)?,
            (true, false) => {
                let (position, offset) = crossing(last, next);
                outline.walk(position, offset)?;
            }
            (false, true) => {
                // The arc along the horizon, then the edge.
                let (position, offset) = crossing(next, last);
                outline.walk(position, offset)?;
                outline.walk(next.position, next.offset)?;
            }
            (false, false) => {}
        }
        last = next;
    }
    Some(outline.flat + outline.round)
}

/// The form factor of the cone of directions p0 + p1 x + p2 y, x^2 + y^2 <= 1.
fn elliptic_cone([p0, p1, p2]: [[f64; 3]; 3]) -> f64 {
    // The diameters of the section that are orthogonal: p1 the longer.
    let (long, short) = (dot(p1, p1), dot(p2, p2));
    let turn = 0.5 * libm::atan2(2.0 * dot(p1, p2), long - short);
    let (q1, q2) = rotated(p1, p2, turn);
    let (Some((f1, a)), Some((_, b)), Some((f3, _)), Some((_, distance))) =
        (unit(q1), unit(q2), unit(cross(q1, q2)), unit(p0))
    else {
        return 0.0;
    };
    if a * a + b * b <= NARROW * distance * distance {
        return narrow_cone([p0, p1, p2]);
    }
    let f3 = if dot(p0, f3) < 0.0 { times(-1.0, f3) } else { f3 };
    let f2 = cross(f3, f1);
    // The axes of the cone: eigenvectors of p0 p0^T - diag(a^2, b^2, 0) in the frame f. The positive eigenvalue is the
    // root of a convex function, which Newton's method reaches from above.
    let m = [dot(p0, f1), dot(p0, f2), dot(p0, f3)];
    let d = [a * a, b * b, 0.0];
    let mut root = dot(m, m);
    for _ in 0..100 {
        let share = [0, 1].map(|i| m[i] * m[i] / (d[i] + root));
        let value = root - m[2] * m[2] - root * (share[0] + share[1]);
        let slope = 1.0 - share[0] * d[0] / (d[0] + root) - share[1] * d[1] / (d[1] + root);
        let next = root - value / slope;
        if !(next < root && next > 0.0) {
            break;
        }
        root = next;
    }
    let Some((axis, _)) = unit([m[0] * root / (d[0] + root), m[1] * root / (d[1] + root), m[2]]) else {
        return 0.0;
    };
    let (g1, g2) = across(axis);
    let form = |u: [f64; 3], v: [f64; 3]| d[0] * u[0] * v[0] + d[1] * u[1] * v[1] - dot(m, u) * dot(m, v);
    let (g11, g12, g22) = (form(g1, g1), form(g1, g2), form(g2, g2));
    let (x, y) = rotated(g1, g2, 0.5 * libm::atan2(2.0 * g12, g11 - g22));
    let longest = libm::sqrt(0.5 * (g11 + g22) + libm::hypot(0.5 * (g11 - g22), g12));
    let height = libm::sqrt(root);
    // The three eigenvalues multiply to (a b m3)^2.
    let shortest = (a * b * m[2] / (longest * height)).min(longest);
    let normal = [f1[2], f2[2], f3[2]];
    upright_cone(
        [longest, shortest, height],
        [dot(normal, x), dot(normal, y), dot(normal, axis)],
    )
}

/// The form factor of the cone (a cos t, b sin t, c), a >= b, to the normal n.
fn upright_cone([a, b, c]: [f64; 3], n: [f64; 3]) -> f64 {
    let slope = libm::hypot(n[0] * a, n[1] * b);
    let level = n[2] * c;
    let (wide, slim) = (libm::hypot(c, a), libm::hypot(c, b));
    if level <= -slope {
        return 0.0;
    }
    if level >= slope {
        return n[2] * (a / wide) * (b / slim);
    }
    let eccentric = libm::sqrt((a - b) * (a + b));
    // Visible from one end to the other, about the direction of steepest rise.
    let (rise_cosine, rise_sine) = (n[0] * a / slope, n[1] * b / slope);
    let half = 2.0 * libm::atan2(libm::sqrt(slope + level), libm::sqrt(slope - level));
    let half_sine = libm::sin(half);
    let rise = libm::atan2(rise_sine, rise_cosine);
    // Integrals of 1, cos t and sin t over |p|^2.
    let part = |t: f64| {
        let (sine, cosine) = libm::sincos(t);
        let square = c * c + a * a * cosine * cosine + b * b * sine * sine;
        let length = libm::sqrt(square);
        let turn = libm::atan2(
            (wide - slim) * sine * cosine,
            wide * cosine * cosine + slim * sine * sine,
        );
        let (even, odd) = if eccentric > 0.0 {
            (
                libm::asinh(eccentric * sine / length) / eccentric,
                -libm::asin((eccentric * cosine / length).clamp(-1.0, 1.0)) / eccentric,
            )
        } else {
            (sine / length, -cosine / length)
        };
        [(t - turn) / (wide * slim), even / wide, odd / slim]
    };
    let (start, end) = (part(rise - half), part(rise + half));
    let [one, cosine, sine] = [0, 1, 2].map(|i| end[i] - start[i]);
    let arc = n[2] * a * b * one - n[0] * b * c * cosine - n[1] * a * c * sine;
    // Between the two ends, along the horizon.
    let ends = c * c
        + a * a * (rise_cosine - half_sine) * (rise_cosine + half_sine)
        + b * b * (rise_sine - half_sine) * (rise_sine + half_sine);
    let horizon = libm::atan2(2.0 * half_sine * a * b * c / slope, ends);
    ((arc + horizon) / (2.0 * PI)).clamp(0.0, 1.0)
}

/// The form factor of a narrow cone, by quadrature over its section.
fn narrow_cone([p0, p1, p2]: [[f64; 3]; 3]) -> f64 {
    let volume = dot(p0, cross(p1, p2)).abs();
    let level = p0[2];
    let slope = libm::hypot(p1[2], p2[2]);
    if level <= -slope || volume == 0.0 {
        return 0.0;
    }
    // The first diameter rises, the second is level.
    let (q1, q2) = if slope > 0.0 {
        let (c, s) = (p1[2] / slope, p2[2] / slope);
        (add(times(c, p1), times(s, p2)), add(times(c, p2), times(-s, p1)))
    } else {
        (p1, p2)
    };
    let end = if level >= slope {
        PI
    } else {
        2.0 * libm::atan2(libm::sqrt(slope + level), libm::sqrt(slope - level))
    };
    let mut sum = 0.0;
    for [node, weight] in both_signs(&SIXTEEN_POINTS) {
        let t = 0.5 * end * (1.0 + node);
        let (sine, cosine) = libm::sincos(t);
        let height = if level >= slope {
            level + slope * cosine
        } else {
            2.0 * slope * libm::sin(0.5 * (end + t)) * libm::sin(0.5 * (end - t))
        };
        let middle = add(p0, times(cosine, q1));
        let mut line = 0.0;
        for [node, weight] in both_signs(&EIGHT_POINTS) {
            let p = add(middle, times(sine * node, q2));
            let square = dot(p, p);
            line += weight / (square * square);
        }
        sum += weight * (sine * sine * height * line);
    }
    (0.5 * end * volume * sum / PI).clamp(0.0, 1.0)
}

/// The nodes and weights of a rule that is given by its positive half.
fn both_signs(rule: &[[f64; 2]]) -> impl Iterator<Item = [f64; 2]> {
    rule.iter()
        .flat_map(|&[node, weight]| [[-node, weight], [node, weight]])
}

/// Returns the power of two that brings the largest of the numbers to [1, 2), as far as there is one; 1 for zeros, none
/// where a number is not finite.
fn scale_to_one(numbers: &[f64]) -> Option<f64> {
    let mut largest = 0.0_f64;
    for &number in numbers {
        if !number.is_finite() {
            return None;
        }
        largest = largest.max(number.abs());
    }
    // The exponent field e of 2^(e - 1023); subnormal numbers have 0.
    let field = largest.to_bits() >> 52;
    let inverse = 2046_u64.saturating_sub(field).clamp(1, 2046);
    Some(if largest == 0.0 {
        1.0
    } else {
        f64::from_bits(inverse << 52)
    })
}

/// Returns a unit vector and the length; none for the zero vector.
fn unit(v: [f64; 3]) -> Option<([f64; 3], f64)> {
    let scale = scale_to_one(&v)?;
    let near = scaled(scale, v);
    let length = norm(near);
    (length > 0.0).then(|| (near.map(|x| x / length), length / scale))
}

/// Two unit vectors that complete a unit vector to a right-handed frame.
fn across(axis: [f64; 3]) -> ([f64; 3], [f64; 3]) {
    let [x, y, z] = axis;
    let level = if z.abs() <= 0.7 { [-y, x, 0.0] } else { [0.0, -z, y] };
    let first = times(1.0 / norm(level), level);
    (first, cross(axis, first))
}

/// Turns a pair of vectors in their plane.
fn rotated(u: [f64; 3], v: [f64; 3], angle: f64) -> ([f64; 3], [f64; 3]) {
    let (sine, cosine) = libm::sincos(angle);
    (
        add(times(cosine, u), times(sine, v)),
        add(times(cosine, v), times(-sine, u)),
    )
}

/// Applies a matrix, each coordinate to its own precision: a height above the horizon keeps its digits.
fn transform(matrix: &[[f64; 3]; 3], v: [f64; 3]) -> [f64; 3] {
    matrix.map(|row| sum_of_products(row, v))
}

/// Returns a sum of products in twice the working precision, rounded (Ogita, Rump and Oishi 2005).
fn sum_of_products<const N: usize>(a: [f64; N], b: [f64; N]) -> f64 {
    let (mut sum, mut rest) = (0.0, 0.0);
    for i in 0..N {
        let (product, low) = two_product(a[i], b[i]);
        let (next, lost) = two_sum(sum, product);
        sum = next;
        rest += low + lost;
    }
    sum + rest
}

fn determinant(matrix: [[f64; 3]; 3]) -> f64 {
    dot(matrix[0], cross(matrix[1], matrix[2]))
}

fn scaled(scale: f64, v: [f64; 3]) -> [f64; 3] {
    v.map(|x| x * scale)
}

fn times(factor: f64, v: [f64; 3]) -> [f64; 3] {
    v.map(|x| factor * x)
}

fn add(u: [f64; 3], v: [f64; 3]) -> [f64; 3] {
    [u[0] + v[0], u[1] + v[1], u[2] + v[2]]
}

fn dot(u: [f64; 3], v: [f64; 3]) -> f64 {
    u[0] * v[0] + u[1] * v[1] + u[2] * v[2]
}

fn cross(u: [f64; 3], v: [f64; 3]) -> [f64; 3] {
    [
        u[1] * v[2] - u[2] * v[1],
        u[2] * v[0] - u[0] * v[2],
        u[0] * v[1] - u[1] * v[0],
    ]
}

fn norm(v: [f64; 3]) -> f64 {
    libm::sqrt(dot(v, v))
}
