//! The part of a light's outline that the Gaussian of a lobe leaves: the band, and the pieces of outline in it.

use super::scratch_lobe::Scales;
use crate::geometry::Arc;
use crate::numeric::exponential::exponential_in_range;
use crate::numeric::gauss::SIXTEEN_POINTS;
use crate::numeric::phase::sine_cosine;
use crate::special::sinc_squared_integral;

/// The part of the lobe that a light can see.
#[derive(Clone, Copy)]
pub(super) struct Band {
    pub(super) scales: Scales,
    /// Smallest |beta xi1| on the light.
    pub(super) nearest: f64,
    /// Largest |beta xi1| that counts.
    pub(super) farthest: f64,
    /// kappa xi2 of the reference from which Phi counts.
    pub(super) reference: f64,
    /// Phi from 0 to the reference.
    pub(super) base: f64,
    /// kappa xi2 at the edges of a box about the light.
    pub(super) sides: [f64; 2],
}

/// A part of an arc on which x is monotone: the angles of its ends, and sigma k xi1 there.
#[derive(Clone, Copy)]
pub(super) struct Stretch {
    pub(super) arc: Arc,
    pub(super) ends: [[f64; 2]; 2],
    pub(super) t: [f64; 2],
}

/// A piece of an arc inside the band, x monotone on it.
#[derive(Clone, Copy)]
pub(super) struct Piece {
    pub(super) centre: [f64; 2],
    pub(super) reach: f64,
    pub(super) across: [f64; 2],
    /// Cosine and sine of the middle angle.
    pub(super) middle: [f64; 2],
    /// Half the angle.
    pub(super) half: f64,
    /// Largest |sine| of its angles.
    pub(super) steepest: f64,
}

impl Piece {
    /// The piece of an arc between two angles of one half turn.
    #[inline]
    pub(super) fn new(arc: &Arc, from: [f64; 2], to: [f64; 2]) -> Piece {
        let sum = [from[0] + to[0], from[1] + to[1]];
        let way = [to[0] - from[0], to[1] - from[1]];
        let [long, wide] = [sum, way].map(|v| libm::sqrt(v[0] * v[0] + v[1] * v[1]));
        let middle = if long > wide {
            [sum[0] / long, sum[1] / long]
        } else {
            [way[1] / wide, -way[0] / wide]
        };
        Piece {
            centre: arc.centre,
            reach: arc.reach,
            across: arc.across,
            middle,
            half: libm::atan2(wide, long),
            steepest: if from[0] * to[0] < 0.0 {
                1.0
            } else {
                from[1].abs().max(to[1].abs())
            },
        }
    }

    /// Cosine and sine of an angle counted from the middle, |step| <= pi/2.
    #[inline(always)]
    pub(super) fn turned(&self, step: f64) -> [f64; 2] {
        let (sine, cosine) = sine_cosine(step);
        let [c, s] = self.middle;
        [c * cosine - s * sine, s * cosine + c * sine]
    }

    /// The amplitude of y.
    #[inline(always)]
    pub(super) fn swing(&self) -> f64 {
        let [a, b] = self.across;
        libm::sqrt(a * a + b * b)
    }
}

impl Band {
    /// The band of a light with this outline, down to `reach` nepers below its brightest part; none for an empty outline.
    pub(super) fn of(scales: Scales, reach: f64, outline: &impl Fn(&mut dyn FnMut(&Arc))) -> Option<Band> {
        let mut extent = [[f64::INFINITY, f64::NEG_INFINITY]; 2];
        // The mean y where the outline is nearest to the middle of the band: chords that begin there have no long differences.
        let (mut near, mut sum, mut count) = (f64::INFINITY, 0.0, 0.0);
        let mut widen = |coordinate: usize, x: f64| {
            let [low, high] = &mut extent[coordinate];
            (*low, *high) = (low.min(x), high.max(x));
        };
        outline(&mut |arc| {
            let [a, b] = arc.across;
            let swing = libm::sqrt(a * a + b * b);
            arc.monotone_pieces(|[from, to]| {
                // An arc leaves its chord by at most the swing times 1 - cos of half the angle.
                let cosine = libm::sqrt((0.5 + 0.5 * (from[0] * to[0] + from[1] * to[1])).clamp(0.0, 1.0));
                let offsets = [from, to].map(|end| {
                    let [x, y] = arc.point(end);
                    widen(0, x);
                    widen(1, y + swing * (1.0 - cosine));
                    widen(1, y - swing * (1.0 - cosine));
                    (x + scales.view[0], y)
                });
                let [(first, _), (last, _)] = offsets;
                let (distance, y) = if first * last < 0.0 {
                    let cosine = (-(arc.centre[0] + scales.view[0]) / arc.reach).clamp(-1.0, 1.0);
                    let sine = libm::sqrt((1.0 - cosine) * (1.0 + cosine));
                    (0.0, arc.point([cosine, if last < first { sine } else { -sine }])[1])
                } else if first.abs() <= last.abs() {
                    (first.abs(), offsets[0].1)
                } else {
                    (last.abs(), offsets[1].1)
                };
                if distance < near {
                    (near, sum, count) = (distance, 0.0, 0.0);
                }
                if distance == near {
                    sum += y;
                    count += 1.0;
                }
            });
        });
        if count == 0.0 {
            return None;
        }
        let [low, high] = extent[0].map(|x| scales.along * (x + scales.view[0]));
        let nearest = low.max(-high).max(0.0);
        let across = |y: f64| scales.across * (y.clamp(-1.0, 1.0) + scales.view[1]);
        let reference = across(sum / count);
        Some(Band {
            scales,
            nearest,
            farthest: libm::sqrt(nearest * nearest + reach),
            reference,
            base: sinc_squared_integral([0.0, reference]),
            sides: extent[1].map(across),
        })
    }

    /// A bound on what lies beyond the band: the Gaussian's tail on either side times a chord across the whole light.
    pub(super) fn beyond(&self) -> f64 {
        let largest = sinc_squared_integral(self.sides);
        let t = self.farthest;
        let depth = (t - self.nearest) * (t + self.nearest);
        2.0 * largest * libm::exp(-depth) / (self.scales.along * (t + libm::sqrt(t * t + 4.0 / core::f64::consts::PI)))
    }

    /// The factor that the weights leave out, exp(-nearest^2) over k W/2.
    pub(super) fn factor(&self) -> f64 {
        libm::exp(-self.nearest * self.nearest) / self.scales.across
    }

    /// Phi at kappa xi2 = q, from the reference: near ones without a difference.
    #[inline]
    pub(super) fn phi(&self, q: f64) -> f64 {
        if (q - self.reference).abs() < 1.0 {
            sinc_squared_integral([self.reference, q])
        } else {
            sinc_squared_integral([0.0, q]) - self.base
        }
    }

    /// beta xi1 from the cosine of an angle on an arc.
    #[inline(always)]
    pub(super) fn along(&self, centre: f64, reach: f64, cosine: f64) -> f64 {
        self.scales.along * ((centre + self.scales.view[0]) + reach * cosine)
    }

    /// kappa xi2 at a step from the middle of a piece.
    #[inline(always)]
    pub(super) fn lobe(&self, piece: &Piece, [cosine, sine]: [f64; 2]) -> f64 {
        let [a, b] = piece.across;
        self.scales.across * ((piece.centre[1] + self.scales.view[1]) + (a * cosine + b * sine))
    }

    /// Calls `visit` for each piece of an arc inside the band.
    #[inline]
    pub(super) fn pieces(&self, arc: &Arc, mut visit: impl FnMut(Piece)) {
        self.stretches(arc, |stretch| visit(self.piece(&stretch)));
    }

    /// Calls `visit` for each stretch of an arc, x monotone on it, that meets the band.
    #[inline]
    pub(super) fn stretches(&self, arc: &Arc, mut visit: impl FnMut(Stretch)) {
        arc.monotone_pieces(|ends| {
            let t = ends.map(|angle| self.along(arc.centre[0], arc.reach, angle[0]));
            if t[0].min(t[1]) < self.farthest && t[0].max(t[1]) > -self.farthest {
                visit(Stretch { arc: *arc, ends, t });
            }
        });
    }

    /// What of a stretch is inside the band.
    pub(super) fn piece(&self, stretch: &Stretch) -> Piece {
        let Stretch { arc, ends, t } = stretch;
        let falling = t[1] < t[0];
        let cut = |angle: [f64; 2], t: f64| {
            if t.abs() <= self.farthest {
                return angle;
            }
            let at = self.farthest.copysign(t) / self.scales.along;
            let cosine = ((at - (arc.centre[0] + self.scales.view[0])) / arc.reach).clamp(-1.0, 1.0);
            let sine = libm::sqrt((1.0 - cosine) * (1.0 + cosine));
            [cosine, if falling { sine } else { -sine }]
        };
        Piece::new(arc, cut(ends[0], t[0]), cut(ends[1], t[1]))
    }

    /// How far the Gaussian, and the lobe, vary over a piece: panels of 16 nodes per unit of their sum.
    pub(super) fn extent(&self, piece: &Piece) -> [f64; 2] {
        let angle = 2.0 * piece.half;
        let [a, b] = piece.across;
        let [c, s] = piece.middle;
        let swing = piece.swing();
        let slope = swing.min((b * c - a * s).abs() + swing * piece.half);
        [
            (self.nearest + 1.5) * self.scales.along * piece.reach * piece.steepest * angle,
            0.5 * self.scales.across * slope * angle,
        ]
    }

    /// The weight of a node of the 16-point rule at a step from the middle of a piece, without the rule's own weight.
    #[inline(always)]
    pub(super) fn weight(&self, piece: &Piece, [cosine, sine]: [f64; 2]) -> f64 {
        let t = self.along(piece.centre[0], piece.reach, cosine);
        // The band's end may round outwards; beyond it nothing counts.
        let depth = ((t - self.nearest) * (t + self.nearest)).clamp(0.0, 600.0);
        piece.reach * sine * exponential_in_range(-depth, 0.0)
    }

    /// The integral of -exp(nearest^2 - t^2) Phi dx over a piece by panels of 16 nodes; `phi` of a projected direction.
    pub(super) fn composite(&self, piece: &Piece, panels: f64, phi: impl Fn([f64; 2]) -> f64) -> f64 {
        let half = piece.half / panels;
        let mut sum = 0.0;
        for i in 0..panels as u32 {
            let middle = (f64::from(2 * i + 1) - panels) * half;
            for [node, weight] in SIXTEEN_POINTS {
                for step in [middle + half * node, middle - half * node] {
                    let turn = piece.turned(step);
                    sum += (weight * half) * self.weight(piece, turn) * phi(turn);
                }
            }
        }
        sum
    }
}
