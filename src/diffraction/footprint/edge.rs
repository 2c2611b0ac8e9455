//! M(H, C) as a series from the near edge, exact but for the far one.
//!
//! With d = H - C, e = H + C and s the distance of a point of the ellipse from its near edge,
//! M = (2/pi) H^-2 int sqrt(s) sqrt(e - (s - d)) exp(-(s - d)^2) ds. The second root is a series in (s - d)/e; its terms are
//! K_k = int sqrt(s) (s - d)^k exp(-(s - d)^2) ds, which follow from K_0 and J_0, the same with 1/sqrt(s), by integration by
//! parts: J_k = K_{k-1} - d J_{k-1}, K_k = (k - 1)/2 K_{k-2} + J_{k-1}/4.

use crate::diffraction::footprint_tables::{EDGE, EDGE_CELLS, EDGE_LOW, SERIES};
use crate::numeric::ROUND;
use core::f64::consts::FRAC_2_PI;

/// Returns the coefficients of K_0 and J_0 in the cell of d, and the distance of d from its centre.
#[inline(always)]
pub(super) fn edge_cell(edge: f64) -> (&'static [[f64; 10]; 2], f64) {
    let rounded = (edge - EDGE_LOW) * EDGE_CELLS + ROUND;
    let row = rounded.to_bits().wrapping_sub(ROUND.to_bits()) as usize;
    let centre = EDGE_LOW + (rounded - ROUND) * (1.0 / EDGE_CELLS);
    (&EDGE[row.min(EDGE.len() - 1)], edge - centre)
}

/// Returns the sum of N terms of the series, over sqrt(e).
#[inline(always)]
pub(super) fn series<const N: usize>(k: f64, j: f64, edge: f64, far: f64) -> f64 {
    // K_k/e^k and J_k/e^k.
    let u = 1.0 / far;
    let (w, v, quarter) = (edge * u, 0.5 * u * u, 0.25 * u);
    let (mut before, mut last, mut root) = (0.0, k, j);
    let mut sum = k;
    #[allow(clippy::needless_range_loop, reason = "a counted loop is unrolled")]
    for n in 1..N {
        let next = (n - 1) as f64 * v * before + quarter * root;
        root = u * last - w * root;
        sum += SERIES[n] * next;
        (before, last) = (last, next);
    }
    sum
}

/// Returns M from the sum of the series; never negative.
#[inline(always)]
pub(super) fn scaled(half_width: f64, far: f64, sum: f64) -> f64 {
    let inverse = 1.0 / half_width;
    let value = FRAC_2_PI * inverse * libm::sqrt((far * inverse) * inverse) * sum;
    if value > 0.0 { value } else { 0.0 }
}
