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

use super::band::{Band, Piece, Stretch};
use super::depth::Depth;
use super::gauss_rule::{self, Measure};
use super::scratch_lobe::Scales;
use super::wave::{Derivatives, Wave};
use crate::geometry::Arc;
use crate::numeric::phase::{reduce_half_turns, sine_cosine};
use crate::special::{sinc, sinc_derivative};

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

/// The largest bend of x over a step of t on a stretch that counts as straight.
const STRAIGHT: f64 = 0.03;

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

impl Band {
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
