//! Area lights over the lobe of a scratch: VWH18 section 3.4, Eqs. 21 to 23, 27 and 30 to 41.

use super::special::{band_antiderivative_vwh18_27, sine_integral_vwh18_29};
use iridescence::special::sinc_squared_integral;
use std::f64::consts::{PI, TAU};

type Vector = [f64; 3];

fn dot(a: Vector, b: Vector) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn combine<const N: usize>(terms: [(f64, Vector); N]) -> Vector {
    [0, 1, 2].map(|i| terms.iter().map(|(factor, v)| factor * v[i]).sum())
}

fn unit(a: Vector) -> Vector {
    combine([(1.0 / dot(a, a).sqrt(), a)])
}

/// What is mended of VWH18 3.4; the default is as printed.
#[derive(Clone, Copy, Debug, Default)]
pub struct LightRepairs {
    /// The two roots of a quadratic are two different quotients, and sgn(0) is 1 (Eqs. 35 and 40).
    pub roots: bool,
    /// The exact sine integral in place of Eq. 29.
    pub sine_integral: bool,
    /// The tangent cone of a sphere in place of the disc through its centre (Eq. 31).
    pub cone: bool,
}

/// VWH18 Eqs. 21 and 22: altitude and azimuth of the direction of light, from xi and the projected direction of view.
pub fn direction_angles_vwh18_21(xi: [f64; 2], view: [f64; 2]) -> [f64; 2] {
    let [x, y] = [xi[0] - view[0], xi[1] - view[1]];
    [x.hypot(y).asin(), (y / x).atan()]
}

/// VWH18 Eq. 23, the middle member: the determinant of the printed matrix.
pub fn jacobian_vwh18_23(xi: [f64; 2], view: [f64; 2]) -> f64 {
    let [x, y] = [xi[0] - view[0], xi[1] - view[1]];
    let theta = direction_angles_vwh18_21(xi, view)[0];
    let (sine, cosine) = theta.sin_cos();
    let square = x * x + y * y;
    x / (cosine * sine) * (x / square) - y / (cosine * sine) * (-y / square)
}

/// Duff et al. 2017: two unit vectors at right angles to a unit vector and to each other.
pub fn basis_duff(n: Vector) -> [Vector; 2] {
    let sign = 1f64.copysign(n[2]);
    let a = -1.0 / (sign + n[2]);
    let b = n[0] * n[1] * a;
    [
        [1.0 + sign * n[0] * n[0] * a, sign * b, -sign * n[0]],
        [b, sign + n[1] * n[1] * a, -n[1]],
    ]
}

/// The circle that Eq. 31 projects: the numerator's three vectors and the denominator.
#[derive(Clone, Copy, Debug)]
pub struct Disc {
    /// p.
    pub centre: Vector,
    /// t r and b r.
    pub axes: [Vector; 2],
    /// sqrt(r^2 + |p|^2).
    pub distance: f64,
}

impl Disc {
    /// VWH18 Eq. 31: the disc through the centre of a sphere, at right angles to its direction.
    pub fn vwh18_31(centre: Vector, radius: f64) -> Disc {
        let [t, b] = basis_duff(unit(centre)).map(|axis| combine([(radius, axis)]));
        Disc {
            centre,
            axes: [t, b],
            distance: (radius * radius + dot(centre, centre)).sqrt(),
        }
    }

    /// G_S at an angle given by its cosine and sine.
    pub fn direction(&self, [cosine, sine]: [f64; 2]) -> Vector {
        let sum = combine([(1.0, self.centre), (cosine, self.axes[0]), (sine, self.axes[1])]);
        sum.map(|x| x / self.distance)
    }
}

/// VWH18 Eqs. 34 and 35, and 39 and 40: the roots nu = tan(gamma/2) of A cos gamma + B sin gamma + C = 0, for
/// `[A, B, C]`; none where the discriminant is negative.
///
/// Printed are a quotient and its power -1, with sgn(0) = 0. Eq. 40 prints sgn(b), a letter that section 3.4.2 does not
/// have; read as the coefficient B of its own equation, Gamma-hat, as b is in Eq. 35.
pub fn half_angle_roots_vwh18_35([a, b, c]: [f64; 3], mended: bool) -> Option<[f64; 2]> {
    let discriminant = b * b - (c * c - a * a);
    if discriminant.is_nan() || discriminant < 0.0 {
        return None;
    }
    let sign = if b == 0.0 {
        f64::from(u8::from(mended))
    } else {
        b.signum()
    };
    let q = -(b + sign * discriminant.sqrt());
    let first = q / (c - a);
    Some([first, if mended { (c + a) / q } else { 1.0 / first }])
}

/// VWH18 Eq. 33: cosine and sine of gamma from nu.
pub fn back_substituted_vwh18_33(nu: f64) -> [f64; 2] {
    [(1.0 - nu * nu) / (1.0 + nu * nu), 2.0 * nu / (1.0 + nu * nu)]
}

/// An edge on the sphere as VWH18 Eq. 36 has it.
#[derive(Clone, Copy, Debug)]
pub struct EdgeArc {
    /// U.
    pub start: Vector,
    /// Gamma.
    pub across: Vector,
    /// Gamma-hat.
    pub across_unit: Vector,
    /// acos(U . U'), the last angle.
    pub last: f64,
}

impl EdgeArc {
    /// VWH18 Eq. 36 from two vertices.
    pub fn vwh18_36(from: Vector, to: Vector) -> EdgeArc {
        let (start, end) = (unit(from), unit(to));
        let cosine = dot(start, end);
        let across = combine([(1.0, end), (-cosine, start)]);
        EdgeArc {
            start,
            across,
            across_unit: unit(across),
            last: cosine.acos(),
        }
    }

    /// C at an angle given by its cosine and sine.
    pub fn point(&self, [cosine, sine]: [f64; 2]) -> Vector {
        combine([(cosine, self.start), (sine, self.across_unit)])
    }

    /// VWH18 Eq. 41: the slope of the edge, with Gamma as printed or with Gamma-hat.
    pub fn slope_vwh18_41(&self, [cosine, sine]: [f64; 2], hat: bool) -> f64 {
        let gamma = if hat { self.across_unit } else { self.across };
        (-self.start[1] * sine + gamma[1] * cosine) / (-self.start[0] * sine + gamma[0] * cosine)
    }

    /// Where the edge meets the plane x = -`view_x` by VWH18 Eqs. 38 to 40: cosine and sine of the angle, from 0 to the
    /// last one.
    pub fn crossings(&self, view_x: f64, mended: bool) -> impl Iterator<Item = [f64; 2]> {
        let last = self.last;
        let roots = half_angle_roots_vwh18_35([self.start[0], self.across_unit[0], view_x], mended);
        let on_edge = move |nu: &f64| (0.0..=last).contains(&(2.0 * nu.atan()));
        roots
            .into_iter()
            .flatten()
            .filter(on_edge)
            .map(back_substituted_vwh18_33)
    }
}

/// Scratch and view of a row.
#[derive(Clone, Copy)]
struct Lobe {
    sigma: f64,
    k: f64,
    width: f64,
    view: [f64; 2],
}

impl Lobe {
    fn new(row: &[f64]) -> Lobe {
        Lobe {
            sigma: row[0],
            k: TAU / row[1],
            width: row[2],
            view: [row[3], row[4]],
        }
    }

    /// N(q1) - N(q0) of Eq. 27.
    fn segment(&self, [q0, q1]: [f64; 2], repairs: LightRepairs) -> f64 {
        if repairs.sine_integral {
            let half = 0.5 * self.k * self.width;
            return PI.sqrt() / (self.sigma * self.k) / half * sinc_squared_integral([half * q0, half * q1]);
        }
        let n = |q: f64| band_antiderivative_vwh18_27(self.sigma, self.k, self.width, q, sine_integral_vwh18_29);
        n(q1) - n(q0)
    }
}

/// VWH18 3.4.1: the light of a sphere. A row is sigma lambda width wo_x wo_y px py pz radius.
///
/// One segment, from the lower to the higher root; 0 where the line misses the disc's circle.
pub fn sphere_light_vwh18(row: &[f64], repairs: LightRepairs) -> f64 {
    let lobe = Lobe::new(row);
    let centre = [row[5], row[6], row[7]];
    let radius = row[8];
    // "Further than one radius under the horizon".
    if centre[2] < -radius {
        return 0.0;
    }
    let disc = if repairs.cone {
        // The disc of the contact circle's directions: tan alpha = r/sqrt(d^2 - r^2).
        let square = dot(centre, centre);
        Disc::vwh18_31(centre, radius * (square / (square - radius * radius)).sqrt())
    } else {
        Disc::vwh18_31(centre, radius)
    };
    let [t, b] = disc.axes;
    let line = [t[0], b[0], centre[0] + lobe.view[0] * disc.distance];
    let Some(roots) = half_angle_roots_vwh18_35(line, repairs.roots) else {
        return 0.0;
    };
    let mut ends = [0.0; 2];
    for (end, nu) in ends.iter_mut().zip(roots) {
        let [_, y, z] = disc.direction(back_substituted_vwh18_33(nu));
        *end = lobe.view[1] + y;
        if z < 0.0 {
            // No circle at the horizon: all of it is below.
            let Some(y) = snapped(&disc, lobe.view[0], y, repairs) else {
                return 0.0;
            };
            *end = lobe.view[1] + y;
        }
    }
    // The paper does not say which root is q0: the one for which the segment is positive.
    let [q0, q1] = ends;
    lobe.segment([q0.min(q1) + 0.0 * (q0 + q1), q0.max(q1)], repairs)
}

/// The bitangent cosine to which an end below the surface, at `y`, is moved: where the line meets the arc of the
/// horizon between the two roots of Eq. 37, the nearer place of two. The corner case of a disc seen edge on needs
/// nothing of its own in f64.
fn snapped(disc: &Disc, view_x: f64, y: f64, repairs: LightRepairs) -> Option<f64> {
    let [t, b] = disc.axes;
    let roots = half_angle_roots_vwh18_35([t[2], b[2], disc.centre[2]], repairs.roots)?;
    let ends = roots.map(|nu| disc.direction(back_substituted_vwh18_33(nu)));
    let arc = EdgeArc::vwh18_36(ends[0], ends[1]);
    let met = arc.crossings(view_x, repairs.roots).map(|gamma| arc.point(gamma)[1]);
    // The printed roots rarely meet it; then its end nearer to the line is the better guess.
    let off = |end: &Vector| (end[0] + view_x).abs();
    let nearer = if off(&ends[0]) <= off(&ends[1]) {
        ends[0]
    } else {
        ends[1]
    };
    let best = met.min_by(|a, b| (a - y).abs().total_cmp(&(b - y).abs()));
    Some(best.unwrap_or(nearer[1]))
}

/// A polygon clipped by z >= 0, edge by edge; parts that hang together only along the horizon stay one polygon.
fn clipped(vertices: &[Vector]) -> Vec<Vector> {
    let mut kept = Vec::new();
    for (i, &b) in vertices.iter().enumerate() {
        let a = vertices[(i + vertices.len() - 1) % vertices.len()];
        if (a[2] >= 0.0) != (b[2] >= 0.0) {
            let share = a[2] / (a[2] - b[2]);
            let [x, y, _] = combine([(1.0 - share, a), (share, b)]);
            kept.push([x, y, 0.0]);
        }
        if b[2] >= 0.0 {
            kept.push(b);
        }
    }
    kept
}

/// VWH18 3.4.2: the light of a polygon. A row is sigma lambda width wo_x wo_y x1 y1 z1 x2 y2 z2 ...
///
/// All roots are sorted and taken in pairs from below; of an odd number, the last is left.
pub fn polygon_light_vwh18(row: &[f64], repairs: LightRepairs) -> f64 {
    let lobe = Lobe::new(row);
    let vertices: Vec<Vector> = row[5..].chunks_exact(3).map(|v| [v[0], v[1], v[2]]).collect();
    let vertices = clipped(&vertices);
    // Where an edge is met, and its slope there.
    let mut roots: Vec<[f64; 2]> = Vec::new();
    for (i, &from) in vertices.iter().enumerate() {
        let to = vertices[(i + 1) % vertices.len()];
        let arc = EdgeArc::vwh18_36(from, to);
        for gamma in arc.crossings(lobe.view[0], repairs.roots) {
            let found = [
                lobe.view[1] + arc.point(gamma)[1],
                arc.slope_vwh18_41(gamma, repairs.roots),
            ];
            // "When a point lies on two arcs", Eq. 41 decides "if there is a difference of the derivatives". Read so:
            // slopes of one sign make it one crossing, slopes of two signs a touch, which is a pair of its own.
            let twice = |other: &[f64; 2]| (other[0] - found[0]).abs() < 1e-12 && other[1] * found[1] > 0.0;
            if !roots.iter().any(twice) {
                roots.push(found);
            }
        }
    }
    roots.sort_by(|a, b| a[0].total_cmp(&b[0]));
    let pairs = roots.chunks_exact(2);
    pairs.map(|pair| lobe.segment([pair[0][0], pair[1][0]], repairs)).sum()
}
