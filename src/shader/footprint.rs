//! The mean of the window's square over the footprint of a pixel, in f32.
//!
//! Accurate: midpoints in the angle over the part of the ellipse that the window reaches, in pairs. Distances are taken
//! from the edges, so that a wide ellipse loses nothing beside one. Coarse: one exponential and one root, of three forms.

use super::elementary::{EXPONENT_BIAS, exponential};
use super::footprint_coefficients::*;
use super::gpu::{abs, bits_of, from_bits, max, min, round, select, sqrt};

/// Half widths below are next to none.
pub(super) const FOOTPRINT_LEAST_LIMIT: f32 = 0.00048828125;
/// Half widths above see nothing.
pub(super) const FOOTPRINT_MOST_LIMIT: f32 = 1e18;
/// Where the window ends, in radii.
pub(super) const FOOTPRINT_REACH: f32 = 3.95;
/// 1 over the nodes.
pub(super) const FOOTPRINT_SHARE: f32 = 0.055555556;
/// sqrt(log2 e): squares of lengths in this unit are powers of 2.
pub(super) const FOOTPRINT_BINARY: f32 = 1.2011224;
/// Half widths from here on see one edge at a time.
pub(super) const FOOTPRINT_WIDE_LIMIT: f32 = 3.0;
/// So far inside the edge the window does not see it.
pub(super) const FOOTPRINT_INTERIOR_LIMIT: f32 = 2.5;
/// Farther outside the edge the coarse form is 0.
pub(super) const FOOTPRINT_OUTSIDE_LIMIT: f32 = -3.0;

/// The part of the ellipse that the window reaches.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct FootprintWindow {
    /// From the near edge of the ellipse, over H.
    pub(super) near: f32,
    /// From the far edge of the ellipse, over H.
    pub(super) far: f32,
    /// The beginning, from the line, in units of [`FOOTPRINT_BINARY`].
    pub(super) start: f32,
    /// The length, in the same unit.
    pub(super) span: f32,
    /// The length over H.
    pub(super) share: f32,
}

/// Returns the part of the ellipse within reach of the line.
#[inline(always)]
pub(super) fn footprint_window(half_width: f32, edge: f32) -> FootprintWindow {
    let width = min(max(half_width, FOOTPRINT_LEAST_LIMIT), FOOTPRINT_MOST_LIMIT);
    let near_edge = edge + (width - half_width);
    let far_edge = (width - near_edge) + width;
    let inverse = 1.0 / width;
    let start = max(-near_edge, -FOOTPRINT_REACH);
    // A narrow ellipse beside the line is known by its width, not by the difference of its edges.
    let whole = max(near_edge, far_edge) <= FOOTPRINT_REACH;
    let seen = max(min(far_edge, FOOTPRINT_REACH) - start, 0.0);
    let span = select(seen, width + width, whole);
    FootprintWindow {
        near: max(near_edge - FOOTPRINT_REACH, 0.0) * inverse,
        far: max(far_edge - FOOTPRINT_REACH, 0.0) * inverse,
        start: FOOTPRINT_BINARY * start,
        span: FOOTPRINT_BINARY * span,
        share: span * inverse,
    }
}

/// Returns 2^(-x^2), to f32 grade of 1, for |x| up to 11.
#[inline(always)]
pub(super) fn halving_square(x: f32) -> f32 {
    let y = x * x;
    let n = round(y);
    let r = n - y;
    let series = HALVING_A + r * (HALVING_B + r * (HALVING_C + r * (HALVING_D + r * HALVING_E)));
    // The low bits of 2^23 + 127 - n are the exponent field of 2^-n.
    (1.0 + r * series) * from_bits(bits_of(EXPONENT_BIAS - n) << 23u32)
}

/// Returns two nodes of the rule, mirror images within the window.
#[inline(always)]
pub(super) fn footprint_pair(window: FootprintWindow, part: f32, sine: f32) -> f32 {
    let rest = 1.0 - part;
    let low = window.start + window.span * part;
    let high = window.start + window.span * rest;
    let lesser = window.share * part;
    let greater = window.share * rest;
    let first = sqrt((window.near + lesser) * (window.far + greater)) * halving_square(low);
    let second = sqrt((window.near + greater) * (window.far + lesser)) * halving_square(high);
    sine * (first + second)
}

/// Returns the half width of an ellipse across the tangent; half axes, cosine of the angle from the first to the tangent.
///
/// For |cos_phi| up to 1.
#[inline(always)]
#[must_use]
pub fn footprint_half_width(a_first: f32, a_second: f32, cos_phi: f32) -> f32 {
    let sine_squared = max((1.0 - cos_phi) * (1.0 + cos_phi), 0.0);
    let along = a_second * cos_phi;
    sqrt((a_first * a_first) * sine_squared + along * along)
}

/// Returns the mean over an ellipse of exp(-s_b^2/sigma^2) for an infinite scratch, to f32 grade of its largest value.
///
/// Half width H of the ellipse across the scratch and `edge` = H - |C| with C the scratch's offset from the centre, both
/// over sigma: the caller may know the edge better than the difference of two rounded numbers. Any H >= 0.
#[inline(always)]
#[must_use]
pub fn footprint_mean_reduced(half_width: f32, edge: f32) -> f32 {
    let window = footprint_window(half_width, edge);
    let a = footprint_pair(window, FOOTPRINT_NODE_A, FOOTPRINT_NODE_SINE_A);
    let b = footprint_pair(window, FOOTPRINT_NODE_B, FOOTPRINT_NODE_SINE_B);
    let c = footprint_pair(window, FOOTPRINT_NODE_C, FOOTPRINT_NODE_SINE_C);
    let d = footprint_pair(window, FOOTPRINT_NODE_D, FOOTPRINT_NODE_SINE_D);
    let e = footprint_pair(window, FOOTPRINT_NODE_E, FOOTPRINT_NODE_SINE_E);
    let f = footprint_pair(window, FOOTPRINT_NODE_F, FOOTPRINT_NODE_SINE_F);
    let g = footprint_pair(window, FOOTPRINT_NODE_G, FOOTPRINT_NODE_SINE_G);
    let h = footprint_pair(window, FOOTPRINT_NODE_H, FOOTPRINT_NODE_SINE_H);
    let i = footprint_pair(window, FOOTPRINT_NODE_I, FOOTPRINT_NODE_SINE_I);
    let outer = (a + b) + (c + d);
    let inner = ((i + h) + (g + f)) + e;
    (window.share * FOOTPRINT_SHARE) * (outer + inner)
}

/// Returns a polynomial of degree 5.
#[inline(always)]
pub(super) fn footprint_quintic(w: f32, a: f32, b: f32, c: f32, d: f32, e: f32, f: f32) -> f32 {
    let upper = c + w * (d + w * (e + w * f));
    a + w * (b + w * upper)
}

/// Returns [`footprint_mean_reduced`] to 1e-3.
///
/// One exponential and one root: of a narrow ellipse, of one edge, or of the middle of a wide ellipse.
#[inline(always)]
#[must_use]
pub fn footprint_mean_reduced_coarse(half_width: f32, edge: f32) -> f32 {
    let d = max(edge, -3.05);
    let is_narrow = half_width < FOOTPRINT_WIDE_LIMIT;
    let is_interior = edge >= FOOTPRINT_INTERIOR_LIMIT;
    // A narrow ellipse: a Gaussian of its variance, and its excess.
    let narrow = min(half_width, FOOTPRINT_WIDE_LIMIT);
    let offset = narrow - d;
    let spread = 2.0 / (2.0 + narrow * narrow);
    let v = 0.5 * ((narrow * narrow) * spread);
    let u = v * v;
    let w = 2.0 * ((offset * offset) * spread);
    let second = footprint_quintic(
        w,
        FOOTPRINT_NARROW_A,
        FOOTPRINT_NARROW_B,
        FOOTPRINT_NARROW_C,
        FOOTPRINT_NARROW_D,
        FOOTPRINT_NARROW_E,
        FOOTPRINT_NARROW_F,
    );
    let fourth = footprint_quintic(
        w,
        FOOTPRINT_NARROW_G,
        FOOTPRINT_NARROW_H,
        FOOTPRINT_NARROW_I,
        FOOTPRINT_NARROW_J,
        FOOTPRINT_NARROW_K,
        FOOTPRINT_NARROW_L,
    );
    let sixth = footprint_quintic(
        w,
        FOOTPRINT_NARROW_M,
        FOOTPRINT_NARROW_N,
        FOOTPRINT_NARROW_O,
        FOOTPRINT_NARROW_P,
        FOOTPRINT_NARROW_Q,
        FOOTPRINT_NARROW_R,
    );
    let excess = 0.5 * w + u * (second + u * (fourth + u * sixth));
    // A wide one: its edges in half widths.
    let wide = min(max(half_width, FOOTPRINT_WIDE_LIMIT), FOOTPRINT_MOST_LIMIT);
    let inverse = 1.0 / wide;
    let far = ((wide - d) + wide) * inverse;
    let near = d * inverse;
    let t = min(d, FOOTPRINT_INTERIOR_LIMIT);
    let upper = FOOTPRINT_EDGE_C + t * (FOOTPRINT_EDGE_D + t * (FOOTPRINT_EDGE_E + t * FOOTPRINT_EDGE_F));
    let decay = FOOTPRINT_EDGE_A + t * (FOOTPRINT_EDGE_B + t * upper);
    let slope = FOOTPRINT_EDGE_SLOPE_A + t * (FOOTPRINT_EDGE_SLOPE_B + t * FOOTPRINT_EDGE_SLOPE_C);
    let edged = decay + slope * (inverse / far);
    let exponent = select(select(edged, 0.0, is_interior), excess, is_narrow);
    let under_root = select(select(far * inverse, near * far, is_interior), spread, is_narrow);
    // What the root's curvature takes from the middle.
    let bend = 1.0 / (d * far);
    let z = bend * bend;
    let middle = inverse * (1.1283792 - z * (0.2820948 + 0.1410474 * z));
    let height = select(select(inverse, middle, is_interior), 1.0, is_narrow);
    let value = (sqrt(under_root) * height) * exponential(-exponent);
    select(value, 0.0, edge < FOOTPRINT_OUTSIDE_LIMIT)
}

/// Returns the mean over an ellipse of exp(-s_b^2/sigma^2) for an infinite scratch at an offset; lengths in one unit.
///
/// Half axes and angle as in [`footprint_half_width`]. Wide ellipses lose what the rounding of the half width costs the
/// distance of the edge.
#[inline(always)]
#[must_use]
pub fn footprint_mean(a_first: f32, a_second: f32, cos_phi: f32, offset: f32, radius: f32) -> f32 {
    let half_width = footprint_half_width(a_first, a_second, cos_phi);
    let inverse = 1.0 / radius;
    footprint_mean_reduced(half_width * inverse, (half_width - abs(offset)) * inverse)
}

/// Returns [`footprint_mean`] to 1e-3.
#[inline(always)]
#[must_use]
pub fn footprint_mean_coarse(a_first: f32, a_second: f32, cos_phi: f32, offset: f32, radius: f32) -> f32 {
    let half_width = footprint_half_width(a_first, a_second, cos_phi);
    let inverse = 1.0 / radius;
    footprint_mean_reduced_coarse(half_width * inverse, (half_width - abs(offset)) * inverse)
}
