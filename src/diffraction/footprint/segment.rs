//! The mean over the footprint for a segment: chords along the scratch in closed form, nodes in the angle across it.
//!
//! # Definition
//!
//! ```math
//! \frac{1}{A_P} \int_P e^{-s_b^2/\sigma^2}\, \tfrac12 \left[\mathrm{erf}\frac{s_t + l_2}{\sigma} -
//! \mathrm{erf}\frac{s_t + l_1}{\sigma}\right] dx
//! ```
//!
//! with (s_t, s_b) from x to the segment's origin. The bracket is the share of the energy of |eta|^2 over all directions
//! that the window takes from the part of the line between the ends, exp(-t^2/sigma^2)/(sqrt(pi) sigma) integrated over
//! it (Parseval). [`footprint_segment_mean_hard`] counts it as 1 between the ends and 0 outside.
//!
//! # Domain
//!
//! l1 <= l2, infinite ends allowed; otherwise NaN, like a footprint or radius outside the domain of
//! [`footprint_mean`](super::footprint_mean()). Ends at -inf and inf give that mean. A footprint of no size gives the value
//! at its centre, one of no width the mean along it. cos_phi > 0 means that the first axis lies between the tangent and
//! the bitangent.
//!
//! # Methods
//!
//! Over a chord along the tangent, the mean of erf is a difference of x erf x + exp(-x^2)/sqrt(pi). Chords are weighted at
//! midpoints in the angle, as many as the run of the chord's centre across the window asks for; between the hard ends the
//! chords' overlap has kinks, which the same rule meets with more nodes.
//!
//! # Where it fails
//!
//! Ellipses that are long, slanted and cut by an end need one node for a quarter of a radius of the run, and the count
//! stops at 4096: beyond runs of a thousand radii digits are lost.
//!
//! # Errata
//!
//! VWH18 3.2 counts the length that the ellipse contains and lets the window end at hard ends.

use super::accurate::gaussian;
use super::{Footprint, footprint_half_width, footprint_mean, inverse_radius};
use crate::diffraction::Segment;
use crate::numeric::gauss::EIGHT_POINTS;
use crate::special::{erf, erfcx};
use core::f64::consts::{FRAC_1_PI, PI};

/// exp(-x^2) is next to nothing from here on.
const REACH: f64 = 6.0;
/// 1/sqrt(pi).
const INVERSE_ROOT_PI: f64 = 0.5641895835477563;
/// Shorter means of erf come from nodes.
const SHORT: f64 = 0.5;
const LEAST_NODES: f64 = 40.0;
const MOST_NODES: f64 = 4096.0;

/// Returns the mean over the ellipse of exp(-s_b^2/sigma^2) times the share of the window's energy within the ends of a
/// segment; `position` is (s_t, s_b) of the segment's origin from the centre, `ends` along the tangent. Lengths in um.
///
/// NaN for l1 > l2. See [`segment`](self) for the domain and the nodes. VWH18 3.2 has hard ends; no paper has
/// these.
#[must_use]
pub fn footprint_segment_mean(footprint: Footprint, segment: Segment, radius: f64) -> f64 {
    let inverse = inverse_radius(radius);
    let mean =
        |from: f64, to: f64| 0.5 * (mean_erf(segment, inverse, 1, from, to) - mean_erf(segment, inverse, 0, from, to));
    over_chords(footprint, segment, radius, 4.0, mean)
}

/// Returns the mean over the ellipse of exp(-s_b^2/sigma^2) where the nearest point of the line lies between the ends of the
/// segment, 0 elsewhere: hard ends. Arguments as for [`footprint_segment_mean`]. VWH18 3.2.
#[must_use]
pub fn footprint_segment_mean_hard(footprint: Footprint, segment: Segment, radius: f64) -> f64 {
    let mean = |from: f64, to: f64| {
        let inside = |position: f64| 0.0 < position + segment.ends[1] && position + segment.ends[0] < 0.0;
        if from == to {
            return if inside(from) { 1.0 } else { 0.0 };
        }
        let low = if from > -segment.ends[1] {
            from
        } else {
            -segment.ends[1]
        };
        let high = if to < -segment.ends[0] { to } else { -segment.ends[0] };
        if high > low { (high - low) / (to - from) } else { 0.0 }
    };
    over_chords(footprint, segment, radius, 16.0, mean)
}

/// Returns the mean over the ellipse of exp(-s_b^2/sigma^2) times `mean` of each chord, from its lowest s_t to the highest.
fn over_chords(
    footprint: Footprint,
    segment: Segment,
    radius: f64,
    density: f64,
    mean: impl Fn(f64, f64) -> f64,
) -> f64 {
    let half_width = footprint_half_width(footprint);
    let inverse = inverse_radius(radius);
    let [along, across] = segment.position;
    let [first, last] = segment.ends;
    if !(first <= last && half_width * inverse >= 0.0) || along.is_nan() {
        return f64::NAN;
    }
    if first == f64::NEG_INFINITY && last == f64::INFINITY {
        return footprint_mean(footprint, across, radius);
    }
    let [a1, a2] = footprint.axes;
    let cosine = footprint.cos_phi;
    let sine = libm::sqrt((1.0 - cosine) * (1.0 + cosine));
    // At t h across, the chord is centred at slant t along, and reaches length sqrt(1 - t^2) to either side.
    let (slant, length) = if half_width > 0.0 {
        (
            (a1 - a2) * ((a1 + a2) * (sine * cosine / half_width)),
            a1 * (a2 / half_width),
        )
    } else {
        (0.0, libm::hypot(a1 * cosine, a2 * sine))
    };
    let (h, c) = (half_width * inverse, across * inverse);
    // The angles whose points the window reaches.
    let (low, high) = if h > 0.0 {
        ((c - REACH) / h, (c + REACH) / h)
    } else {
        (-1.0, 1.0)
    };
    if low >= 1.0 || high <= -1.0 || c.is_nan() {
        return if c.is_nan() { c } else { 0.0 };
    }
    let (low, high) = (low.clamp(-1.0, 1.0), high.clamp(-1.0, 1.0));
    let (middle, reach) = (0.5 * (low + high), 0.5 * (high - low));
    let run = reach * (slant.abs() + length) * inverse;
    let nodes = (LEAST_NODES + density * run).clamp(LEAST_NODES, MOST_NODES) as u32;
    let step = PI / f64::from(nodes);
    let mut sum = 0.0;
    for j in 0..nodes {
        let angle = (f64::from(j) + 0.5) * step;
        let (sine, cosine) = (libm::sin(angle), libm::cos(angle));
        let t = middle + reach * cosine;
        let root = libm::sqrt((1.0 - t) * (1.0 + t));
        let (centre, half) = (along - slant * t, length * root);
        sum += sine * root * gaussian(h * t - c) * mean(centre - half, centre + half);
    }
    2.0 * FRAC_1_PI * reach * step * sum
}

/// Returns the mean of erf((s + l)/sigma) over s from `from` to `to`, l one of the ends.
fn mean_erf(segment: Segment, inverse: f64, end: usize, from: f64, to: f64) -> f64 {
    let end = segment.ends[end];
    let (low, high) = ((from + end) * inverse, (to + end) * inverse);
    if low == high || end.is_infinite() {
        return erf(low);
    }
    let width = high - low;
    if width < SHORT {
        let (middle, half) = (0.5 * (low + high), 0.5 * width);
        let pair = |[x, weight]: [f64; 2]| weight * (erf(middle - half * x) + erf(middle + half * x));
        return 0.5 * EIGHT_POINTS.iter().map(|&node| pair(node)).sum::<f64>();
    }
    // x erf x + exp(-x^2)/sqrt(pi) = |x| + tail(|x|).
    ((high.abs() - low.abs()) + (tail(high.abs()) - tail(low.abs()))) / width
}

/// Returns exp(-x^2)/sqrt(pi) - x erfc(x) for x >= 0.
fn tail(x: f64) -> f64 {
    if x > REACH {
        return 0.0;
    }
    gaussian(x) * (INVERSE_ROOT_PI - x * erfcx(x))
}
