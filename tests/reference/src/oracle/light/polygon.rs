//! The chords of a polygon: where the directions along its edges in space have a given x.
//!
//! Directions are kept as differences D from that of the first vertex, r. Along an edge the vector q = r + D + tE runs
//! over the great arc between two vertices, and q/|q| - r = p/|q| - r (|q|^2 - 1)/(|q| (|q| + 1)) with p = D + tE,
//! which loses nothing when the light is small. An edge is cut where its x turns back and at the horizon, so each part
//! crosses a line of constant x at most once. Which of the gaps between crossings belong to the light is asked once for
//! each piece: even-odd of the middle of the widest gap, among the vertices as seen from the origin on a plane.

use super::adaptive::{Chord, Light};
use super::root::bracketed_root;
use super::vectors::{Vector, add_scaled, cross, direction, dot, even_odd, frame, length};

/// A circular cone that holds the vertices of a polygon, and with them its edges.
pub struct Enclosure {
    /// Unit vector.
    pub axis: Vector,
    /// Cosine of the angle; positive.
    pub cosine: f64,
}

impl Enclosure {
    /// A narrow, not quite the narrowest, cone; None where the directions lie in no open half space.
    pub fn new(vertices: &[Vector]) -> Option<Enclosure> {
        let directions: Vec<Vector> = vertices.iter().map(|&v| direction(v)).collect::<Option<_>>()?;
        let farthest = |axis: Vector| {
            let cosines = directions.iter().map(|&v| (dot(v, axis), v));
            cosines.fold((f64::INFINITY, axis), |a, b| if b.0 < a.0 { b } else { a })
        };
        // Steps towards the farthest vertex, ever smaller (Badoiu and Clarkson 2003).
        let mut centre = directions.iter().fold([0.0; 3], |sum, &v| add_scaled(sum, 1.0, v));
        centre = centre.map(|x| x / directions.len() as f64);
        for step in 2..200 {
            let (_, v) = farthest(centre);
            centre = add_scaled(centre, 1.0 / f64::from(step), add_scaled(v, -1.0, centre));
        }
        let normal = normal(vertices);
        let candidates = [centre, normal, normal.map(|x| -x)].into_iter().filter_map(direction);
        let best = candidates
            .map(|axis| (farthest(axis).0, axis))
            .max_by(|a, b| a.0.total_cmp(&b.0))?;
        (best.0 > 0.0).then_some(Enclosure {
            axis: best.1,
            cosine: best.0,
        })
    }
}

/// Twice the vector area.
pub fn normal(vertices: &[Vector]) -> Vector {
    let sides: Vec<Vector> = vertices.iter().map(|&v| add_scaled(v, -1.0, vertices[0])).collect();
    sides
        .windows(2)
        .fold([0.0; 3], |sum, pair| add_scaled(sum, 1.0, cross(pair[0], pair[1])))
}

/// An edge, or a part of one that crosses a line of constant x at most once.
struct Part {
    /// D of the vertex it starts at.
    start: Vector,
    /// E.
    along: Vector,
    /// t at the least and at the largest u.
    t: [f64; 2],
    /// The least and the largest u.
    u: [f64; 2],
}

/// A point of an edge.
struct Crossing {
    /// y less that of the anchor.
    y: f64,
    /// Uncertainty of y in units of f64::EPSILON of the light's span.
    doubt: f64,
}

/// The polygon seen from the origin.
pub struct Polygon {
    anchor: Vector,
    /// Largest difference from the anchor.
    span: f64,
    parts: Vec<Part>,
    enclosure: Enclosure,
    frame: [Vector; 2],
    outline: Vec<[f64; 2]>,
}

/// What is known between two break points.
pub struct Piece {
    /// The parts that cross.
    parts: Vec<usize>,
    /// Whether the lowest gap, from the horizon up, belongs to the light.
    lowest_inside: bool,
}

/// v/|v| - w/|w|, relative to its own size.
fn difference(v: Vector, w: Vector) -> Vector {
    let apart = add_scaled(v, -1.0, w);
    let (size, other) = (length(v), length(w));
    if length(apart) > 0.5 * other {
        return std::array::from_fn(|k| v[k] / size - w[k] / other);
    }
    // |v| - |w| = (v - w).(v + w)/(|v| + |w|).
    let longer = dot(apart, add_scaled(v, 1.0, w)) / (size + other);
    std::array::from_fn(|k| (apart[k] - w[k] / other * longer) / size)
}

impl Polygon {
    /// None where a vertex is the origin or the vertices lie in no open half space.
    pub fn new(vertices: &[Vector]) -> Option<Polygon> {
        let enclosure = Enclosure::new(vertices)?;
        let frame = frame(enclosure.axis);
        let flat = |v: Vector| frame.map(|across| dot(v, across) / dot(v, enclosure.axis));
        let outline = vertices.iter().map(|&v| flat(v)).collect();
        let anchor = direction(vertices[0])?;
        let offsets: Vec<Vector> = vertices.iter().map(|&v| difference(v, vertices[0])).collect();
        let mut polygon = Polygon {
            anchor,
            span: offsets.iter().map(|&d| length(d)).fold(0.0, f64::max),
            parts: vec![],
            enclosure,
            frame,
            outline,
        };
        let heights: Vec<f64> = vertices.iter().map(|&v| v[2] / length(v)).collect();
        for i in 0..vertices.len() {
            let j = (i + 1) % vertices.len();
            polygon.cut([offsets[i], offsets[j]], [heights[i], heights[j]]);
        }
        Some(polygon)
    }

    /// Adds the parts of an edge, given by its ends' differences from the anchor and heights over the horizon.
    fn cut(&mut self, [start, end]: [Vector; 2], [low, high]: [f64; 2]) {
        let along = add_scaled(end, -1.0, start);
        let from = add_scaled(self.anchor, 1.0, start);
        // x/|q| is stationary where E_x |q|^2 = q_x (q.E), linear in t.
        let advance = dot(from, along);
        let turn = (along[0] - from[0] * advance) / (from[0] * dot(along, along) - along[0] * advance);
        let mut cuts = vec![turn, low / (low - high)];
        cuts.retain(|t| *t > 0.0 && *t < 1.0);
        cuts.extend([0.0, 1.0]);
        cuts.sort_by(f64::total_cmp);
        for pair in cuts.windows(2) {
            let middle = 0.5 * (pair[0] + pair[1]);
            if low + middle * (high - low) <= 0.0 {
                continue;
            }
            // The ends of edges as the neighbours have them, so that no line slips between.
            let u = |t: f64| match t {
                0.0 => start[0],
                1.0 => end[0],
                _ => self.along(start, along, t)[0][0],
            };
            let (t, u) = ([pair[0], pair[1]], [u(pair[0]), u(pair[1])]);
            let rising = u[0] <= u[1];
            self.parts.push(Part {
                start,
                along,
                t: if rising { t } else { [t[1], t[0]] },
                u: if rising { u } else { [u[1], u[0]] },
            });
        }
    }

    /// q/|q| less the anchor, and its derivative, at t on an edge.
    fn along(&self, start: Vector, along: Vector, t: f64) -> [Vector; 2] {
        let p = add_scaled(start, t, along);
        let excess = 2.0 * dot(self.anchor, p) + dot(p, p);
        let size = (1.0 + excess).sqrt();
        let back = excess / (size * (1.0 + size));
        let offset: Vector = std::array::from_fn(|k| p[k] / size - self.anchor[k] * back);
        let unit = add_scaled(self.anchor, 1.0, offset);
        let advance = dot(unit, along);
        [offset, std::array::from_fn(|k| (along[k] - unit[k] * advance) / size)]
    }

    /// Whether a direction belongs to the light.
    fn holds(&self, omega: Vector) -> bool {
        let depth = dot(omega, self.enclosure.axis);
        depth > 0.0 && even_odd(&self.outline, self.frame.map(|across| dot(omega, across) / depth))
    }

    /// Where some parts cross the line u, upwards.
    fn crossings(&self, parts: &[usize], u: f64) -> Vec<Crossing> {
        let cross = |&index: &usize| {
            let Part {
                start,
                along,
                t,
                u: ends,
            } = &self.parts[index];
            let f = |t: f64| {
                let [offset, slope] = self.along(*start, *along, t);
                [offset[0] - u, slope[0]]
            };
            // As if the edge turned back at its flatter end.
            let share = (u - ends[0]) / (ends[1] - ends[0]);
            let flat = t.map(|t| f(t)[1].abs());
            let share = if 4.0 * flat[0] < flat[1] {
                share.sqrt()
            } else if 4.0 * flat[1] < flat[0] {
                1.0 - (1.0 - share).sqrt()
            } else {
                share
            };
            let root = bracketed_root(f, *t, t[0] + share * (t[1] - t[0]), 1e-17 * self.span);
            let [offset, slope] = self.along(*start, *along, root);
            Crossing {
                y: offset[1],
                // That of x along the slope, and where the chord between far vertices passes near the origin the more.
                doubt: 2.0 * (1.0 + (slope[1] / slope[0]).abs())
                    / length(add_scaled(add_scaled(self.anchor, 1.0, *start), root, *along)),
            }
        };
        let mut all: Vec<Crossing> = parts.iter().map(cross).collect();
        all.sort_by(|a, b| a.y.total_cmp(&b.y));
        all
    }

    /// Half length of the line u, and y of the anchor.
    fn line(&self, u: f64) -> f64 {
        let x = self.anchor[0] + u;
        ((1.0 - x) * (1.0 + x)).max(0.0).sqrt()
    }

    /// The piece between two break points; None without chords.
    fn piece(&self, [a, b]: [f64; 2]) -> Option<Piece> {
        let middle = 0.5 * (a + b);
        let crosses = |part: &Part| part.u[0] <= a && part.u[1] >= b;
        let parts: Vec<usize> = (0..self.parts.len()).filter(|&i| crosses(&self.parts[i])).collect();
        let s = self.line(middle);
        let mut marks = vec![-s];
        marks.extend(self.crossings(&parts, middle).iter().map(|c| self.anchor[1] + c.y));
        marks.push(s);
        let widest = (0..marks.len() - 1).max_by(|&i, &j| {
            let width = |i: usize| marks[i + 1] - marks[i];
            width(i).total_cmp(&width(j))
        })?;
        let y = 0.5 * (marks[widest] + marks[widest + 1]);
        let z = ((s - y) * (s + y)).max(0.0).sqrt();
        let inside = self.holds([self.anchor[0] + middle, y, z]);
        let lowest_inside = inside ^ (widest % 2 == 1);
        (lowest_inside || !parts.is_empty()).then_some(Piece { parts, lowest_inside })
    }
}

impl Light for Polygon {
    type Piece = Piece;

    fn anchor(&self) -> f64 {
        self.anchor[0]
    }

    fn pieces(&self) -> Vec<([f64; 2], Piece)> {
        let ends = [-1.0, 1.0].map(|x| x - self.anchor[0]);
        let mut breaks: Vec<f64> = self.parts.iter().flat_map(|part| part.u).chain(ends).collect();
        breaks.iter_mut().for_each(|u| *u = u.clamp(ends[0], ends[1]));
        breaks.sort_by(f64::total_cmp);
        let pairs = breaks.windows(2).map(|pair| [pair[0], pair[1]]);
        pairs
            .filter(|[a, b]| b > a)
            .filter_map(|piece| Some((piece, self.piece(piece)?)))
            .collect()
    }

    fn chords(&self, piece: &Piece, u: f64) -> Vec<Chord> {
        let s = self.line(u);
        let [low, high] = [-s - self.anchor[1], s - self.anchor[1]];
        let end = |y| Crossing { y, doubt: 1.0 };
        let mut marks = vec![end(low)];
        marks.extend(self.crossings(&piece.parts, u));
        marks.push(end(high));
        let first = usize::from(!piece.lowest_inside);
        let mut chords = vec![];
        for pair in marks[first..].chunks_exact(2) {
            let [start, end] = [&pair[0], &pair[1]].map(|c| c.y.clamp(low, high));
            if end > start {
                chords.push(Chord {
                    start: self.anchor[1] + start,
                    length: end - start,
                    doubt: self.span * (pair[0].doubt + pair[1].doubt),
                });
            }
        }
        chords
    }
}
