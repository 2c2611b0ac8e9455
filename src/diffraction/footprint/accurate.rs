//! M(H, C) to 1e-12: nodes in the angle, nodes about the line, or a series from the near edge.

use super::edge::{edge_cell, series};
use super::{outside, vast};
use crate::diffraction::footprint_tables::{
    CIRCLE_4, CIRCLE_8, CIRCLE_12, CIRCLE_20, CIRCLE_38, HERMITE_6, HERMITE_12,
};
use crate::numeric::ROUND;
use crate::numeric::polynomial::Powers;
use core::f64::consts::{FRAC_2_SQRT_PI, LN_2, LOG2_E};

/// The line lies farther inside the edge than this: the window does not see the edge.
const INTERIOR: f64 = 5.5;
/// Half as many nodes do from here on.
const FAR_INTERIOR: f64 = 21.0;
/// Farther outside the edge M does not count against its peak.
const BEYOND: f64 = 6.0;
/// Below this half width nodes in the angle keep the relative accuracy outside the edge as well.
const NARROW: f64 = 2.3;
/// Nearer than this the far edge spoils the series from the near one.
const NEAR_EDGE: f64 = 7.0;
/// Distances of the far edge from which a shorter series does.
const SERIES_ENDS: [f64; 2] = [10.0, 30.0];
/// Half widths up to which each of the rules in the angle is enough; `footprint.rs` of the tests holds the borders.
const CIRCLE_ENDS: [f64; 4] = [0.075, 0.6, 1.4, 2.95];
/// A narrow ellipse sees nothing of a line that far outside.
const VANISHED: f64 = 26.5;

/// Returns M(H, C) from H, C >= 0 and H - C.
#[inline]
pub(super) fn mean(half_width: f64, offset: f64, edge: f64) -> f64 {
    let far = half_width + offset;
    if edge >= FAR_INTERIOR {
        if half_width < super::VAST {
            interior(half_width, far, edge, &HERMITE_6)
        } else {
            vast(half_width, offset)
        }
    } else if edge >= INTERIOR {
        interior(half_width, far, edge, &HERMITE_12)
    } else if half_width < NARROW || far < NEAR_EDGE {
        angles(half_width, offset, edge)
    } else if edge >= -BEYOND {
        let (cell, d) = edge_cell(edge);
        let powers = Powers::of(d);
        let [k, j] = cell.map(|[c0, slope @ ..]| c0 + powers.nine_from_first(slope));
        let sum = if far >= SERIES_ENDS[1] {
            series::<8>(k, j, edge, far)
        } else if far >= SERIES_ENDS[0] {
            series::<13>(k, j, edge, far)
        } else {
            series::<18>(k, j, edge, far)
        };
        super::edge::scaled(half_width, far, sum)
    } else {
        outside(half_width, offset)
    }
}

/// The rules in the angle, for H below 6.25.
#[inline]
fn angles(half_width: f64, offset: f64, edge: f64) -> f64 {
    if edge < -VANISHED {
        outside(half_width, offset)
    } else if half_width > CIRCLE_ENDS[3] {
        angle_rule(half_width, offset, &CIRCLE_38)
    } else if half_width > CIRCLE_ENDS[2] {
        angle_rule(half_width, offset, &CIRCLE_20)
    } else if half_width > CIRCLE_ENDS[1] {
        angle_rule(half_width, offset, &CIRCLE_12)
    } else if half_width > CIRCLE_ENDS[0] {
        angle_rule(half_width, offset, &CIRCLE_8)
    } else if half_width > 0.0 {
        angle_rule(half_width, offset, &CIRCLE_4)
    } else if half_width == 0.0 {
        gaussian(offset)
    } else {
        f64::NAN
    }
}

/// The Gauss rule of weight sqrt(1 - t^2): nodes t and -t, and their weight.
#[inline(always)]
fn angle_rule<const N: usize>(half_width: f64, offset: f64, rule: &[[f64; 2]; N]) -> f64 {
    let (mut near, mut far) = (0.0, 0.0);
    for &[node, weight] in rule {
        let x = half_width * node;
        near += weight * gaussian(x - offset);
        far += weight * gaussian(x + offset);
    }
    near + far
}

/// Returns exp(-x^2) for |x| below 26.6, without branches and without the two parts of [`crate::numeric::exponential`].
#[inline(always)]
pub(super) fn gaussian(x: f64) -> f64 {
    let y = x * x;
    let y = if y > 708.0 { 708.0 } else { y };
    let rounded = ROUND - y * LOG2_E;
    let r = (ROUND - rounded) * LN_2 - y;
    let powers = Powers::of(r);
    let first = powers.eight([
        1.0 / 2.0,
        1.0 / 6.0,
        1.0 / 24.0,
        1.0 / 120.0,
        1.0 / 720.0,
        1.0 / 5040.0,
        1.0 / 40320.0,
        1.0 / 362880.0,
    ]);
    let square = r * r;
    let fourth = square * square;
    let last = 1.0 / 3628800.0 + r * (1.0 / 39916800.0);
    let m = 1.0 + (r + square * (first + (fourth * fourth) * last));
    m * f64::from_bits((rounded.to_bits().wrapping_sub(ROUND.to_bits()).wrapping_add(1023)) << 52)
}

/// Gauss-Hermite nodes about the line: no edge within reach.
#[inline(always)]
pub(super) fn interior<const N: usize>(half_width: f64, far: f64, edge: f64, rule: &[[f64; 2]; N]) -> f64 {
    // sqrt((d - x)(e + x)) = sqrt(d e) sqrt((1 - x/d)(1 + x/e)).
    let (p, q) = (1.0 / edge, 1.0 / far);
    let mut sum = 0.0;
    for &[x, weight] in rule {
        let (u, v) = (x * p, x * q);
        let low = root((1.0 - u) * (1.0 + v));
        let high = root((1.0 + u) * (1.0 - v));
        sum += weight * (low + high);
    }
    let inverse = 1.0 / half_width;
    FRAC_2_SQRT_PI * inverse * libm::sqrt((edge * inverse) * (far * inverse)) * sum
}

/// Returns the square root of 0.2 <= x <= 2, in straight line that vectorises.
#[inline(always)]
fn root(x: f64) -> f64 {
    // A guess of 1/sqrt x to 3 %, and twice a step of third order.
    let guess = 2.6326 + x * (-3.4217 + x * (2.3566 - x * 0.5842));
    let rest = 1.0 - x * (guess * guess);
    let y = guess + guess * rest * (0.5 + rest * (0.375 + rest * 0.3125));
    let rest = 1.0 - x * (y * y);
    let y = y + y * rest * (0.5 + rest * 0.375);
    x * y
}
