//! The area that a polygon's outline encloses in projection, walked edge by edge and cut at the horizon.

use super::arc_less_chord;
use super::vectors::{add, scale_to_one, scaled, times, unit};
use crate::geometry::vector::{cross, dot, length};
use core::f64::consts::PI;

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
        let (sine, cosine) = (length(normal), 1.0 - 0.5 * dot(chord, chord));
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
pub(super) fn mapped_polygon(vertices: &[[f64; 3]], map: impl Fn([f64; 3]) -> [f64; 3]) -> f64 {
    let Some(scale) = scale_to_one(vertices.as_flattened()) else {
        return f64::NAN;
    };
    if vertices.len() < 3 {
        return 0.0;
    }
    visible_area(vertices, scale, map).map_or(0.0, |twice| (twice.abs() / (2.0 * PI)).min(1.0))
}

/// Twice the projected area of the visible part, signed by the orientation; none for a light without solid angle.
pub(super) fn visible_area(vertices: &[[f64; 3]], scale: f64, map: impl Fn([f64; 3]) -> [f64; 3]) -> Option<f64> {
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
