//! Outer quadrature over x of the chords of a light: Gauss-Legendre segments, the worst halved until the sum of what
//! halving changes is small.
//!
//! Each smooth piece runs over tau in \[0, 1\] with dx vanishing at both ends, so that a square root there is as good
//! as smooth. Only |t| <= T counts, T^2 = 60 + the least t^2 on the light, t = beta (x + o_x).

use super::{LightValue, Scratch, legendre, sinc_squared};
use std::collections::BinaryHeap;

/// exp(-60) is 9e-27: nothing, even where the light is wider by ten powers of ten.
const REACH: f64 = 60.0;
/// Halvings at most.
const LIMIT: usize = 1500;

/// Part of a line of constant x in a light.
pub struct Chord {
    /// y of the lower end.
    pub start: f64,
    /// Length in y.
    pub length: f64,
    /// Uncertainty of the length in units of f64::EPSILON.
    pub doubt: f64,
}

/// A light by its chords. Lines of constant x are named by their distance u = x - x_0 from an anchor.
pub trait Light {
    /// What is known of a piece between two break points.
    type Piece;

    /// x_0.
    fn anchor(&self) -> f64;

    /// The pieces \[u, u\] over which the chords vary smoothly; those without chords may be left out.
    fn pieces(&self) -> Vec<([f64; 2], Self::Piece)>;

    /// The chords at u inside a piece.
    fn chords(&self, piece: &Self::Piece, u: f64) -> Vec<Chord>;
}

/// How x runs over a piece as tau runs over \[0, 1\].
#[derive(Clone, Copy, Debug)]
pub enum Grading {
    /// sin^2(pi tau/2).
    Sine,
    /// tau^2 (3 - 2 tau), for a second opinion.
    #[cfg(test)]
    Cubic,
}

/// The settings of the quadrature.
#[derive(Clone, Copy, Debug)]
pub struct Rule {
    /// Points a segment.
    pub points: usize,
    /// Change by halving, relative to the value, at which to stop.
    pub tolerance: f64,
    /// Map of each piece.
    pub grading: Grading,
    /// Points of direct panels for the chords; None for the table.
    pub panels: Option<usize>,
}

/// The setting of the public functions.
pub const ACCURATE: Rule = Rule {
    points: 16,
    tolerance: 1e-12,
    grading: Grading::Sine,
    panels: None,
};

/// Value and sensitivity to roundings of a part of the integral.
#[derive(Clone, Copy)]
struct Estimate {
    value: f64,
    rounding: f64,
}

/// tau range of a piece, its two halves, and what halving changed.
struct Segment {
    piece: usize,
    range: [f64; 2],
    halves: [Estimate; 2],
    change: f64,
}

impl Segment {
    fn value(&self) -> f64 {
        self.halves[0].value + self.halves[1].value
    }

    /// As far as rounding explains it a change is no reason to halve.
    fn excess(&self) -> f64 {
        let rounding = f64::EPSILON * (self.halves[0].rounding + self.halves[1].rounding);
        if self.change > rounding { self.change } else { 0.0 }
    }
}

impl PartialEq for Segment {
    fn eq(&self, other: &Segment) -> bool {
        self.cmp(other).is_eq()
    }
}

impl Eq for Segment {}

impl PartialOrd for Segment {
    fn partial_cmp(&self, other: &Segment) -> Option<std::cmp::Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Segment {
    fn cmp(&self, other: &Segment) -> std::cmp::Ordering {
        self.excess().total_cmp(&other.excess())
    }
}

/// u and du/dtau in the piece from `a` to `b`.
fn graded(grading: Grading, [a, b]: [f64; 2], tau: f64) -> [f64; 2] {
    let rise = |s: f64| match grading {
        Grading::Sine => (std::f64::consts::FRAC_PI_2 * s).sin().powi(2),
        #[cfg(test)]
        Grading::Cubic => s * s * (3.0 - 2.0 * s),
    };
    let slope = match grading {
        Grading::Sine => std::f64::consts::FRAC_PI_2 * (std::f64::consts::PI * tau).sin(),
        #[cfg(test)]
        Grading::Cubic => 6.0 * tau * (1.0 - tau),
    };
    let u = if tau < 0.5 {
        a + (b - a) * rise(tau)
    } else {
        b - (b - a) * rise(1.0 - tau)
    };
    [u, (b - a) * slope]
}

struct Quadrature<'a, L: Light> {
    light: &'a L,
    scratch: &'a Scratch,
    grading: Grading,
    nodes: Vec<[f64; 2]>,
    panel_nodes: Option<Vec<[f64; 2]>>,
    pieces: Vec<([f64; 2], L::Piece)>,
    /// x_0 + o_x.
    shift: f64,
}

impl<L: Light> Quadrature<'_, L> {
    /// Integrand of the outer integral at u.
    fn line(&self, piece: &L::Piece, u: f64) -> Estimate {
        let t = self.scratch.beta * (self.shift + u);
        let height = (-t * t).exp();
        let wave = self.scratch.half_wave;
        let mut sum = Estimate {
            value: 0.0,
            rounding: 0.0,
        };
        if height == 0.0 {
            return sum;
        }
        for Chord { start, length, doubt } in self.light.chords(piece, u) {
            let low = wave * (start + self.scratch.view[1]);
            let span = wave * length;
            let value = match &self.panel_nodes {
                None => sinc_squared::integral(low, span),
                Some(nodes) => sinc_squared::integral_by_panels(low, span, nodes),
            } / wave;
            let ends = [low, low + span].map(sinc_squared::sinc_squared);
            // The value's own roundings, those of x in the Gaussian and of y in the sine, a shift of the chord, its
            // length.
            sum.value += height * value;
            sum.rounding += height
                * (value
                    * (4.0
                        + 2.0 * t * t
                        + 2.0 * self.scratch.beta * t.abs()
                        + 0.5 * low.abs().max((low + span).abs()))
                    + 3.0 * (ends[1] - ends[0]).abs()
                    + doubt * ends[0].max(ends[1]));
        }
        sum
    }

    /// The rule over a part of a piece.
    fn estimate(&self, piece: usize, [from, to]: [f64; 2]) -> Estimate {
        let (ends, ref known) = self.pieces[piece];
        let mut sum = Estimate {
            value: 0.0,
            rounding: 0.0,
        };
        for [node, weight] in &self.nodes {
            let [u, slope] = graded(self.grading, ends, from + (to - from) * node);
            let line = self.line(known, u);
            sum.value += weight * slope * line.value;
            sum.rounding += weight * slope * line.rounding;
        }
        Estimate {
            value: (to - from) * sum.value,
            rounding: (to - from) * sum.rounding,
        }
    }

    fn segment(&self, piece: usize, range: [f64; 2], whole: f64) -> Segment {
        let middle = 0.5 * (range[0] + range[1]);
        let halves = [[range[0], middle], [middle, range[1]]].map(|half| self.estimate(piece, half));
        Segment {
            piece,
            range,
            halves,
            change: (whole - halves[0].value - halves[1].value).abs(),
        }
    }
}

/// The pieces cut to where the Gaussian counts.
fn near_the_band<P>(pieces: Vec<([f64; 2], P)>, beta: f64, shift: f64) -> Vec<([f64; 2], P)> {
    let nearest = pieces
        .iter()
        .map(|([a, b], _)| (shift + (-shift).clamp(*a, *b)).abs())
        .fold(f64::INFINITY, f64::min);
    let reach = (nearest * nearest + REACH / (beta * beta)).sqrt();
    let cut = |[a, b]: [f64; 2]| [a.max(-shift - reach), b.min(-shift + reach)];
    let pieces = pieces.into_iter().map(|(ends, piece)| (cut(ends), piece));
    pieces.filter(|([a, b], _)| b > a).collect()
}

/// The integral over a light.
pub fn integrate<L: Light>(light: &L, scratch: &Scratch, rule: &Rule) -> LightValue {
    let shift = light.anchor() + scratch.view[0];
    let quadrature = Quadrature {
        light,
        scratch,
        grading: rule.grading,
        nodes: legendre::rule(rule.points),
        panel_nodes: rule.panels.map(legendre::rule),
        pieces: near_the_band(light.pieces(), scratch.beta, shift),
        shift,
    };
    let mut segments: BinaryHeap<Segment> = (0..quadrature.pieces.len())
        .map(|piece| {
            let whole = quadrature.estimate(piece, [0.0, 1.0]);
            quadrature.segment(piece, [0.0, 1.0], whole.value)
        })
        .collect();
    for round in 0..LIMIT {
        // All sums anew: running ones would keep the roundings of large early changes. Seldom, as they cost.
        if round < 16 || round % 8 == 0 {
            let value: f64 = segments.iter().map(Segment::value).sum();
            let excess: f64 = segments.iter().map(Segment::excess).sum();
            if excess <= rule.tolerance * value {
                break;
            }
        }
        let Some(Segment {
            piece, range, halves, ..
        }) = segments.pop()
        else {
            break;
        };
        let middle = 0.5 * (range[0] + range[1]);
        segments.push(quadrature.segment(piece, [range[0], middle], halves[0].value));
        segments.push(quadrature.segment(piece, [middle, range[1]], halves[1].value));
    }
    let underflow = if segments.is_empty() { 0.0 } else { f64::MIN_POSITIVE };
    let mut values: Vec<f64> = segments.iter().map(Segment::value).collect();
    values.sort_by(f64::total_cmp);
    let rounding: f64 = segments
        .iter()
        .map(|s| s.halves[0].rounding + s.halves[1].rounding)
        .sum();
    let change: f64 = segments.iter().map(|s| s.change).sum();
    LightValue {
        // An empty sum is -0.
        value: values.iter().sum::<f64>() + 0.0,
        error: change + f64::EPSILON * rounding + underflow,
    }
}

/// The integral of sinc^2 along the line xi1 = 0 times that of the Gaussian: what one chord says of a light.
pub fn chord<L: Light>(light: &L, scratch: &Scratch) -> f64 {
    let shift = light.anchor() + scratch.view[0];
    let piece = light
        .pieces()
        .into_iter()
        .find(|([a, b], _)| (*a..=*b).contains(&-shift));
    let wave = scratch.half_wave;
    let integral = piece.map_or(0.0, |(_, known)| {
        let chords = light.chords(&known, -shift);
        let each = chords
            .iter()
            .map(|chord| sinc_squared::integral(wave * (chord.start + scratch.view[1]), wave * chord.length) / wave);
        each.sum::<f64>() + 0.0
    });
    std::f64::consts::PI.sqrt() / scratch.beta * integral
}
