//! The outline of a polygon above the horizon, and its crossings with a line of constant x.
//!
//! # Definition
//!
//! A polygon is the list of its vertices relative to the shaded point, in any unit of length; what is seen of it are the
//! directions of its points. Its edges are arcs of great circles. What lies below the horizon is cut off: an edge ends where
//! it goes down, and the outline goes on along the horizon to where the next edge comes up.
//!
//! # Domain
//!
//! Any simple polygon, convex or not, either way round. Fewer than three vertices have no outline; a vertex at the shaded
//! point or a number that is not finite gives no outline and `false`. Where an edge's line passes through the shaded point
//! the edge has no direction of its own and is left out: the polygon is seen edge on.
//!
//! # Methods
//!
//! Each vertex is compared with the line once and the answer is shared by the two edges that meet in it, so that a closed
//! outline crosses the line as often up as down, whatever is rounded. An edge whose ends lie on one side crosses
//! twice if its farthest point, told by the signs of the motion at both ends, lies on the other.
//!
//! # Errata
//!
//! VWH18 Eq. 40 has a power of plus or minus 1 where the two roots are two different quotients, and its Eq. 41 cannot tell
//! a crossing from a touch; the sign of the motion in x can.

use super::arc::Arc;
use super::vector::{cross, difference, dot, largest_exponent, length, near_one, scale_by_exponent};

/// The visible part of an edge: its ends, and the normal of its great circle, of any length.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Edge {
    /// First end, of any length between 2^-101 and 2.
    pub(crate) from: [f64; 3],
    /// Second end.
    pub(crate) to: [f64; 3],
    /// A normal of the plane through both ends and the shaded point, a x b up to a positive factor.
    pub(crate) normal: [f64; 3],
}

/// The normal of the great circle from a to b. From the smaller vector and the difference, which is exact for near ends.
#[inline]
fn normal(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    if (largest_exponent(a) - largest_exponent(b)).abs() > 2 {
        return cross(near_one(a), near_one(b));
    }
    let small = if dot(a, a) <= dot(b, b) { a } else { b };
    cross(small, difference(b, a))
}

/// The point of the segment from a to b at the horizon, where their heights have opposite signs.
#[inline]
fn horizon_point(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    let (a, b) = (near_one(a), near_one(b));
    // Any combination by positive weights that has no height points the same way.
    let (wa, wb) = (b[2].abs(), a[2].abs());
    near_one([a[0] * wa + b[0] * wb, a[1] * wa + b[1] * wb, 0.0])
}

/// Calls `visit` for the visible part of each edge in order, the pieces along the horizon included; false if a vertex has
/// no direction.
pub(crate) fn visible_edges(vertices: &[[f64; 3]], mut visit: impl FnMut(Edge)) -> bool {
    let directed = |v: &[f64; 3]| v.iter().all(|x| x.is_finite()) && v.iter().any(|&x| x != 0.0);
    if !vertices.iter().all(directed) {
        return false;
    }
    if vertices.len() < 3 {
        return true;
    }
    let mut first_rise = None;
    let mut last_set = None;
    let along_horizon = |set: [f64; 3], rise: [f64; 3]| Edge {
        from: set,
        to: rise,
        normal: [0.0, 0.0, set[0] * rise[1] - set[1] * rise[0]],
    };
    // One power of two for all, so that neighbours keep their exact difference; far smaller ones have their own.
    let largest = vertices.iter().map(|&v| largest_exponent(v)).fold(-1023, i32::max);
    let scaled = |v: [f64; 3]| {
        let own = largest_exponent(v);
        scale_by_exponent(v, if largest - own < 100 { -largest } else { -own })
    };
    let mut a = scaled(vertices[vertices.len() - 1]);
    for b in vertices.iter().map(|&v| scaled(v)) {
        let (up, stays) = (a[2] >= 0.0, b[2] >= 0.0);
        let normal = normal(a, b);
        if up && stays {
            visit(Edge { from: a, to: b, normal });
        } else if up {
            let set = horizon_point(a, b);
            visit(Edge {
                from: a,
                to: set,
                normal,
            });
            last_set = Some(set);
        } else if stays {
            let rise = horizon_point(a, b);
            match last_set.take() {
                Some(set) => visit(along_horizon(set, rise)),
                None => first_rise = Some(rise),
            }
            visit(Edge {
                from: rise,
                to: b,
                normal,
            });
        }
        a = b;
    }
    if let (Some(set), Some(rise)) = (last_set, first_rise) {
        visit(along_horizon(set, rise));
    }
    true
}

/// The arc of the visible part of an edge; none where it has no plane or does not move in x.
#[inline]
fn arc(edge: &Edge) -> Option<Arc> {
    let w = near_one(edge.normal);
    let size = length(w);
    let tilt = libm::sqrt(w[1] * w[1] + w[2] * w[2]);
    if tilt == 0.0 || tilt.is_nan() {
        return None;
    }
    // The companion of the direction of largest x has no x.
    let angle = |p: [f64; 3]| {
        let (c, s) = (p[0] * size, w[2] * p[1] - w[1] * p[2]);
        let length = libm::sqrt(c * c + s * s);
        [c / length, s / length]
    };
    Some(Arc {
        centre: [0.0; 2],
        reach: tilt / size,
        across: [-w[0] * w[1] / (tilt * size), w[2] / tilt],
        from: angle(edge.from),
        to: angle(edge.to),
        reflex: false,
    })
}

/// Calls `visit` for each arc of the outline of a polygon above the horizon, in the order of the vertices; false, without an
/// outline, where a vertex has no direction.
///
/// Vertices relative to the shaded point, in any unit of length. The arcs close; they run counterclockwise or clockwise as
/// the vertices do.
#[inline]
pub fn polygon_outline(vertices: &[[f64; 3]], mut visit: impl FnMut(&Arc)) -> bool {
    visible_edges(vertices, |edge| {
        if let Some(arc) = arc(&edge) {
            visit(&arc);
        }
    })
}

/// A crossing of an outline with a line of constant x.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Crossing {
    /// Where it crosses.
    pub y: f64,
    /// Whether x grows along the outline there.
    pub upward: bool,
}

/// Calls `visit` for each crossing of the outline of a polygon above the horizon with the line of constant x; false where a
/// vertex has no direction.
///
/// Vertices relative to the shaded point, in any unit of length. Crossings go up and down in turn, as often up as down. A function F of y
/// differs over the chords by the sum of F at the downward crossings less that at the upward ones, for a polygon
/// seen counterclockwise; for the other way round it has the other sign.
pub fn polygon_crossings(vertices: &[[f64; 3]], x: f64, mut visit: impl FnMut(Crossing)) -> bool {
    // The side of a point is a function of the point alone: the two edges that meet there agree.
    let beyond = |p: [f64; 3]| p[0] - x * length(p) >= 0.0;
    let rest = (1.0 - x) * (1.0 + x);
    visible_edges(vertices, |edge| {
        let (first, last) = (beyond(edge.from), beyond(edge.to));
        let w = near_one(edge.normal);
        let tilt_squared = w[1] * w[1] + w[2] * w[2];
        let discriminant = tilt_squared * rest - (x * w[0]) * (x * w[0]);
        // The motion in x at the ends.
        let [start, end] = [edge.from, edge.to].map(|p| w[1] * p[2] - w[2] * p[1]);
        let (up, down) = if first != last {
            (last, first)
        } else {
            // Towards the line at the first, away from it at the second.
            let side = if first { -1.0 } else { 1.0 };
            let twice = discriminant > 0.0 && side * start > 0.0 && side * end < 0.0;
            (twice, twice)
        };
        if !(up || down) {
            return;
        }
        // Ends that rounding alone puts on two sides, and their arc crosses the wrong way: it has no root to offer.
        let against = first != last && start * end > 0.0 && (start > 0.0) != last;
        let root = libm::sqrt(discriminant.max(0.0));
        let at = |sign: f64| {
            if tilt_squared > 0.0 && !against {
                (sign * (w[2] * root) - x * w[0] * w[1]) / tilt_squared
            } else {
                edge.from[1] / length(edge.from)
            }
        };
        // Crossings alternate: an edge that crosses twice leaves its side first.
        for upward in [!first, first] {
            if if upward { up } else { down } {
                visit(Crossing {
                    y: at(if upward { -1.0 } else { 1.0 }),
                    upward,
                });
            }
        }
    })
}
