//! The integral of a lobe over a light, as an integral along the light's outline.
//!
//! By Green's theorem, with beta = sigma k,
//!
//! int int exp(-(beta x1)^2) h(x2) dx1 dx2 = - oint exp(-(beta x1)^2) Phi(x2) dx1,  Phi' = h,
//!
//! counterclockwise. On an arc both coordinates are entire functions of the angle, so that nothing is special about a
//! vertex, or where the outline turns back: those are only ends of pieces. The Gaussian leaves a band of the outline. Each
//! piece in the band is a positive measure exp(-t^2) |dx|, whose moments cost no Phi, and Phi along it is a wave of bounded
//! derivatives. So the Gauss rule of the measure itself needs few Phi, and its error is known beforehand:
//!
//! - one node at the mean, with the curvature of Phi there;
//! - the Gauss rule of 2 to 8 nodes;
//! - else, and where exactness is asked for, every node of a composite Gauss-Legendre rule.

use super::depth::Depth;
use super::gauss_rule::{self, Measure};
use super::scratch_lobe::Scales;
use super::wave::{Derivatives, Wave};
use crate::geometry::Arc;
use crate::numeric::exponential::exponential_in_range;
use crate::numeric::gauss::SIXTEEN_POINTS;
use crate::numeric::phase::{reduce_half_turns, sine_cosine};
use crate::special::{sinc, sinc_derivative, sinc_squared_integral};

/// What an area light gives, and at what price.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LightIntegral {
    /// The integral of exp(-(sigma k xi1)^2) sinc^2(k W xi2/2) over the light's projection, dimensionless, at least 0.
    pub value: f64,
    /// What the value may be off by, by the bounds of the rules used.
    pub error: f64,
    /// Chords evaluated: an integral of sinc^2 up to one end of a chord counts half.
    pub chords: f64,
}

impl LightIntegral {
    /// Outside the domain.
    pub(super) const NAN: LightIntegral = LightIntegral {
        value: f64::NAN,
        error: f64::NAN,
        chords: 0.0,
    };
    /// Of a light below the horizon.
    const NOTHING: LightIntegral = LightIntegral {
        value: 0.0,
        error: 0.0,
        chords: 0.0,
    };

    fn times(self, factor: f64) -> LightIntegral {
        LightIntegral {
            value: self.value * factor,
            error: self.error * factor,
            chords: self.chords,
        }
    }
}

/// The band ends where the Gaussian is e^-39 of its largest value on the light, below half an eps.
const EXACT_REACH: f64 = 39.0;
/// Largest measure of a panel of 16 nodes in the exact rule.
const EXACT_PANEL: f64 = 4.0;
/// The same where an error of 1e-7 is as good as none.
const PANEL: f64 = 7.0;
/// Below, a tolerance asks for the exact rule.
const SMALLEST_TOLERANCE: f64 = 1e-6;
/// Share of a piece that rounding takes; of pieces that cancel, as of a sliver's sides, it is more than the tolerance.
const ROUNDING: f64 = 1e-13;
/// Most panels of a piece: enough for scratches of 10 mm.
const MOST_PANELS: f64 = 65536.0;
/// Most pieces that the adaptive rule keeps; an outline with more in the band is integrated exactly.
const MOST_PIECES: usize = 16;
/// Share of the tolerance for what lies beyond the band.
const BEYOND: f64 = 0.1;
/// Share of the tolerance that the pieces are given, and what remains of it after a try that missed.
const SHARES: [f64; 3] = [0.8, 0.2, 0.05];

/// The part of the lobe that a light can see.
#[derive(Clone, Copy)]
pub(super) struct Band {
    scales: Scales,
    /// Smallest |beta xi1| on the light.
    nearest: f64,
    /// Largest |beta xi1| that counts.
    farthest: f64,
    /// kappa xi2 of the reference from which Phi counts.
    reference: f64,
    /// Phi from 0 to the reference.
    base: f64,
    /// kappa xi2 at the edges of a box about the light.
    sides: [f64; 2],
}

/// The largest bend of x over a step of t on a stretch that counts as straight.
const STRAIGHT: f64 = 0.03;

/// A part of an arc on which x is monotone: the angles of its ends, and sigma k xi1 there.
#[derive(Clone, Copy)]
struct Stretch {
    arc: Arc,
    ends: [[f64; 2]; 2],
    t: [f64; 2],
}

/// sinc^2 and its derivative.
struct SincSquared {
    value: f64,
    slope: f64,
}

impl SincSquared {
    #[inline]
    fn at(q: f64) -> SincSquared {
        let size = q.abs();
        let (lobe, rest) = if (0.5..1e6).contains(&size) {
            let (r, odd) = reduce_half_turns(size);
            let (sine, cosine) = sine_cosine(r);
            let inverse = 1.0 / size;
            let [sine, cosine] = [sine, cosine].map(|x| f64::from_bits(x.to_bits() ^ odd));
            let lobe = sine * inverse;
            (lobe, ((cosine - lobe) * inverse).copysign((cosine - lobe) * q))
        } else {
            (sinc(q), sinc_derivative(q))
        };
        SincSquared {
            value: lobe * lobe,
            slope: 2.0 * lobe * rest,
        }
    }
}

/// A piece of an arc inside the band, x monotone on it.
#[derive(Clone, Copy)]
pub(super) struct Piece {
    centre: [f64; 2],
    reach: f64,
    across: [f64; 2],
    /// Cosine and sine of the middle angle.
    middle: [f64; 2],
    /// Half the angle.
    half: f64,
    /// Largest |sine| of its angles.
    steepest: f64,
}

impl Piece {
    /// The piece of an arc between two angles of one half turn.
    #[inline]
    fn new(arc: &Arc, from: [f64; 2], to: [f64; 2]) -> Piece {
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
    fn turned(&self, step: f64) -> [f64; 2] {
        let (sine, cosine) = sine_cosine(step);
        let [c, s] = self.middle;
        [c * cosine - s * sine, s * cosine + c * sine]
    }

    /// The amplitude of y.
    #[inline(always)]
    fn swing(&self) -> f64 {
        let [a, b] = self.across;
        libm::sqrt(a * a + b * b)
    }
}

impl Band {
    /// The band of a light with this outline, down to `reach` nepers below its brightest part; none for an empty outline.
    fn of(scales: Scales, reach: f64, outline: &impl Fn(&mut dyn FnMut(&Arc))) -> Option<Band> {
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
    fn beyond(&self) -> f64 {
        let largest = sinc_squared_integral(self.sides);
        let t = self.farthest;
        let depth = (t - self.nearest) * (t + self.nearest);
        2.0 * largest * libm::exp(-depth) / (self.scales.along * (t + libm::sqrt(t * t + 4.0 / core::f64::consts::PI)))
    }

    /// The factor that the weights leave out, exp(-nearest^2) over k W/2.
    fn factor(&self) -> f64 {
        libm::exp(-self.nearest * self.nearest) / self.scales.across
    }

    /// Phi at kappa xi2 = q, from the reference: near ones without a difference.
    #[inline]
    fn phi(&self, q: f64) -> f64 {
        if (q - self.reference).abs() < 1.0 {
            sinc_squared_integral([self.reference, q])
        } else {
            sinc_squared_integral([0.0, q]) - self.base
        }
    }

    /// beta xi1 from the cosine of an angle on an arc.
    #[inline(always)]
    fn along(&self, centre: f64, reach: f64, cosine: f64) -> f64 {
        self.scales.along * ((centre + self.scales.view[0]) + reach * cosine)
    }

    /// kappa xi2 at a step from the middle of a piece.
    #[inline(always)]
    fn lobe(&self, piece: &Piece, [cosine, sine]: [f64; 2]) -> f64 {
        let [a, b] = piece.across;
        self.scales.across * ((piece.centre[1] + self.scales.view[1]) + (a * cosine + b * sine))
    }

    /// Calls `visit` for each piece of an arc inside the band.
    #[inline]
    fn pieces(&self, arc: &Arc, mut visit: impl FnMut(Piece)) {
        self.stretches(arc, |stretch| visit(self.piece(&stretch)));
    }

    /// Calls `visit` for each stretch of an arc, x monotone on it, that meets the band.
    #[inline]
    fn stretches(&self, arc: &Arc, mut visit: impl FnMut(Stretch)) {
        arc.monotone_pieces(|ends| {
            let t = ends.map(|angle| self.along(arc.centre[0], arc.reach, angle[0]));
            if t[0].min(t[1]) < self.farthest && t[0].max(t[1]) > -self.farthest {
                visit(Stretch { arc: *arc, ends, t });
            }
        });
    }

    /// What of a stretch is inside the band.
    fn piece(&self, stretch: &Stretch) -> Piece {
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

    /// One node on a stretch that crosses the whole band almost straight; none if it does not.
    ///
    /// Its measure is a Gaussian of the angle but for the bend of x: the moments are known, and the error that the bend
    /// adds to each is counted.
    #[inline]
    fn crossing(&self, stretch: &Stretch) -> Option<LightIntegral> {
        let Stretch { arc, t, .. } = stretch;
        if t[0] * t[1] >= 0.0 || t[0].abs().min(t[1].abs()) < self.farthest {
            return None;
        }
        let cosine = -(arc.centre[0] + self.scales.view[0]) / arc.reach;
        let sine_squared = (1.0 - cosine) * (1.0 + cosine);
        // The angle that t turns by 1, and the bend of x over it.
        let per_reach = 1.0 / (self.scales.along * arc.reach);
        if per_reach >= STRAIGHT * sine_squared || sine_squared.is_nan() {
            return None;
        }
        let falling = t[1] < t[0];
        let size = libm::sqrt(sine_squared);
        let sine = if falling { size } else { -size };
        let step = per_reach / size;
        let bend = step * (cosine / sine).abs();
        let at = [cosine, sine];
        let [a, b] = arc.across;
        let kappa = self.scales.across;
        let q = kappa * ((arc.centre[1] + self.scales.view[1]) + (a * cosine + b * sine));
        let slope = kappa * (b * at[0] - a * at[1]);
        let turn = -kappa * (a * at[0] + b * at[1]);
        let lobe = SincSquared::at(q);
        let swing = kappa * libm::sqrt(a * a + b * b);
        let total = self.scales.band();
        let second = 0.5 * (step * step);
        let mean = -0.25 * (step * step) * (cosine / sine);
        let curvature = lobe.slope * (slope * slope) + lobe.value * turn;
        let value = total * (self.phi(q) + mean * (lobe.value * slope) + 0.5 * second * curvature);
        let spread = 3.0 * step;
        let steepest = swing.min(slope.abs() + swing * spread);
        let wave = Wave {
            slope: steepest,
            bend: swing,
            nearest: (q.abs() - steepest * spread).max(0.0),
        };
        let cube = step * step * step;
        let error = 0.25 * (cube * step) * (0.125 * wave.fourth())
            + cube * bend * wave.third()
            + (bend * bend + step * step) * (second * 4.0 * curvature.abs() + step * (lobe.value * slope).abs());
        let sign = if falling { 1.0 } else { -1.0 };
        Some(LightIntegral {
            value: sign * value,
            error: total * error,
            chords: 0.5,
        })
    }

    /// How far the Gaussian, and the lobe, vary over a piece: panels of 16 nodes per unit of their sum.
    fn extent(&self, piece: &Piece) -> [f64; 2] {
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
    fn weight(&self, piece: &Piece, [cosine, sine]: [f64; 2]) -> f64 {
        let t = self.along(piece.centre[0], piece.reach, cosine);
        // The band's end may round outwards; beyond it nothing counts.
        let depth = ((t - self.nearest) * (t + self.nearest)).clamp(0.0, 600.0);
        piece.reach * sine * exponential_in_range(-depth, 0.0)
    }

    /// The integral of -exp(nearest^2 - t^2) Phi dx over a piece by panels of 16 nodes; `phi` of a projected direction.
    fn composite(&self, piece: &Piece, panels: f64, phi: impl Fn([f64; 2]) -> f64) -> f64 {
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

    /// The exact rule over an outline.
    fn exact(&self, outline: &impl Fn(&mut dyn FnMut(&Arc))) -> LightIntegral {
        let (mut value, mut size, mut nodes) = (0.0, 0.0, 0.0);
        outline(&mut |arc| {
            self.pieces(arc, |piece| {
                let [gauss, lobe] = self.extent(&piece);
                let panels = libm::ceil((gauss + lobe) / EXACT_PANEL).clamp(1.0, MOST_PANELS);
                let part = self.composite(&piece, panels, |turn| self.phi(self.lobe(&piece, turn)));
                value += part;
                size += part.abs();
                nodes += 16.0 * panels;
            });
        });
        let found = LightIntegral {
            value,
            error: ROUNDING * size,
            chords: 0.5 * nodes,
        };
        found.times(self.factor())
    }

    /// The weight of a piece as a discrete measure over its angle; none where it varies too much for that.
    fn measure(&self, piece: &Piece) -> Option<Measure> {
        let [gauss, _] = self.extent(piece);
        let panels = libm::ceil(gauss / PANEL).max(1.0);
        if panels > gauss_rule::MOST_PANELS as f64 {
            return None;
        }
        Some(Measure::of(panels as usize, piece.half, |step| {
            self.weight(piece, piece.turned(step))
        }))
    }

    /// The cheapest rule whose error is at most `allowed`; the one-node rule whatever it errs where that is infinite.
    fn part(&self, piece: &Piece, allowed: f64) -> LightIntegral {
        if let Some(measure) = self.measure(piece) {
            let wave = self.wave(piece, &measure);
            let once = self.once(piece, &measure, wave);
            if once.error <= allowed {
                return once;
            }
            let mut derivatives = Derivatives::of(wave);
            let found = measure.gauss_rule(
                |order, norm| norm * derivatives.over_factorial(2 * order),
                allowed,
                |step| self.phi(self.lobe(piece, piece.turned(step))),
            );
            if let Some((value, error, order)) = found {
                return LightIntegral {
                    value,
                    error,
                    chords: 0.5 * order as f64,
                };
            }
        }
        let [gauss, lobe] = self.extent(piece);
        let panels = libm::ceil((gauss + lobe) / PANEL).clamp(1.0, MOST_PANELS);
        let value = self.composite(piece, panels, |turn| self.phi(self.lobe(piece, turn)));
        LightIntegral {
            value,
            error: 1e-7 * value.abs(),
            chords: 8.0 * panels,
        }
    }

    /// One node at the mean of a piece, with the curvature of Phi.
    fn once(&self, piece: &Piece, measure: &Measure, wave: Wave) -> LightIntegral {
        let turn = piece.turned(measure.mean);
        let q = self.lobe(piece, turn);
        let [a, b] = piece.across;
        let slope = self.scales.across * (b * turn[0] - a * turn[1]);
        let bend = -self.scales.across * (a * turn[0] + b * turn[1]);
        let lobe = SincSquared::at(q);
        let curvature = lobe.slope * (slope * slope) + lobe.value * bend;
        let [second, third, fourth] = measure.central;
        LightIntegral {
            value: measure.total * self.phi(q) + 0.5 * second * curvature,
            error: third.abs() / 6.0 * wave.third() + fourth / 24.0 * wave.fourth(),
            chords: 0.5,
        }
    }

    /// Phi along a piece as a wave.
    fn wave(&self, piece: &Piece, measure: &Measure) -> Wave {
        let [a, b] = piece.across;
        let turn = piece.turned(measure.mean);
        let q = self.lobe(piece, turn);
        let bend = self.scales.across * piece.swing();
        // The part of the piece that the measure sees.
        let spread = (3.0 * measure.deviation()).min(2.0 * piece.half);
        let slope = bend.min(self.scales.across * (b * turn[0] - a * turn[1]).abs() + bend * spread);
        Wave {
            slope,
            bend,
            nearest: (q.abs() - slope * spread).max(0.0),
        }
    }

    /// The integral with an error of at most `tolerance` times its value.
    fn within(&self, tolerance: f64, outline: &impl Fn(&mut dyn FnMut(&Arc))) -> Option<LightIntegral> {
        let mut kept = [const { None::<(Stretch, LightIntegral)> }; MOST_PIECES];
        let mut count = 0;
        outline(&mut |arc| {
            self.stretches(arc, |stretch| {
                if count < MOST_PIECES {
                    let part = self
                        .crossing(&stretch)
                        .unwrap_or_else(|| self.part(&self.piece(&stretch), f64::INFINITY));
                    kept[count] = Some((stretch, part));
                }
                count += 1;
            });
        });
        let kept = kept.get_mut(..count)?;
        let sum = |kept: &[Option<(Stretch, LightIntegral)>]| {
            let parts = kept.iter().flatten();
            parts.fold(LightIntegral::NOTHING, |sum, (_, part)| LightIntegral {
                value: sum.value + part.value,
                error: sum.error + (part.error + ROUNDING * part.value.abs()),
                chords: sum.chords + part.chords,
            })
        };
        let mut found = sum(kept);
        for share in SHARES {
            let allowed = (1.0 - BEYOND) * tolerance * found.value.abs();
            if found.error <= allowed {
                return Some(found);
            }
            for (stretch, part) in kept.iter_mut().flatten() {
                if part.error > share * allowed / count as f64 {
                    *part = self.part(&self.piece(stretch), share * allowed / count as f64);
                }
            }
            found = sum(kept);
        }
        (found.error <= (1.0 - BEYOND) * tolerance * found.value.abs()).then_some(found)
    }
}

/// The exact integral over a light with the depth term inside, of the sign of its orientation.
pub(super) fn exact_with_depth(scales: Scales, depth: Depth, outline: impl Fn(&mut dyn FnMut(&Arc))) -> f64 {
    let Some(band) = Band::of(scales, EXACT_REACH, &outline) else {
        return 0.0;
    };
    let reference = band.reference / scales.across - scales.view[1];
    let mut sum = 0.0;
    outline(&mut |arc| {
        band.pieces(arc, |piece| {
            let [gauss, lobe] = band.extent(&piece);
            let panels =
                libm::ceil((gauss + lobe * (1.0 + depth.share(&scales))) / EXACT_PANEL).clamp(1.0, MOST_PANELS);
            sum += band.composite(&piece, panels, |[cosine, sine]| {
                let x = piece.centre[0] + piece.reach * cosine;
                let y = piece.centre[1] + (piece.across[0] * cosine + piece.across[1] * sine);
                // Any function of x closes along the outline: chords count from the reference, or from the disc's edge.
                let edge = libm::sqrt(((1.0 - x) * (1.0 + x)).max(0.0));
                depth.chord(&scales, x, [reference.clamp(-edge, edge), y])
            });
        });
    });
    sum * band.factor()
}

/// The exact integral over a light, of the sign of its orientation.
pub(super) fn exact(scales: Scales, outline: impl Fn(&mut dyn FnMut(&Arc))) -> LightIntegral {
    Band::of(scales, EXACT_REACH, &outline).map_or(LightIntegral::NOTHING, |band| band.exact(&outline))
}

/// The integral over a light, of the sign of its orientation, with an error of at most `tolerance` times its value.
pub(super) fn within(scales: Scales, tolerance: f64, outline: impl Fn(&mut dyn FnMut(&Arc))) -> LightIntegral {
    if tolerance.is_nan() || tolerance < 0.0 {
        return LightIntegral::NAN;
    }
    if tolerance < SMALLEST_TOLERANCE {
        return exact(scales, outline);
    }
    let tolerance = tolerance.min(1.0);
    let mut reach = 4.0 - libm::log(tolerance);
    for _ in 0..2 {
        let Some(band) = Band::of(scales, reach, &outline) else {
            return LightIntegral::NOTHING;
        };
        let Some(found) = band.within(tolerance, &outline) else {
            break;
        };
        let (beyond, allowed) = (band.beyond(), BEYOND * tolerance * found.value.abs());
        if beyond <= allowed {
            return LightIntegral {
                error: found.error + beyond,
                ..found
            }
            .times(band.factor());
        }
        // Wide enough for a value that is half as large.
        reach += libm::log(beyond / allowed) + 0.7;
        if reach >= EXACT_REACH || reach.is_nan() {
            break;
        }
    }
    exact(scales, outline)
}
