//! The form factor of an elliptic cone: what a linear map makes of a sphere's.

use super::vectors::{across, add, both_signs, rotated, times, unit};
use crate::geometry::vector::{cross, dot};
use crate::numeric::gauss::{EIGHT_POINTS, SIXTEEN_POINTS};
use core::f64::consts::PI;

/// Largest square of the ratio of an elliptic cone's section to its distance that is integrated over its area.
const NARROW: f64 = 0.0625;

/// The form factor of the cone of directions p0 + p1 x + p2 y, x^2 + y^2 <= 1.
pub(super) fn elliptic_cone([p0, p1, p2]: [[f64; 3]; 3]) -> f64 {
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
