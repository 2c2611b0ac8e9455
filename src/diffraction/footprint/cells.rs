//! M(H, C) to 1e-6 and to 1e-3: cells of a table near the origin, elsewhere a few terms of the accurate forms.

use super::edge::{edge_cell, scaled, series};
use super::{outside, vast};
use crate::diffraction::footprint_tables::{
    CELLS, CELLS_IN_UNIT, CELLS_REACH, COARSE_CELLS, COARSE_CELLS_IN_UNIT, COARSE_CELLS_REACH, HERMITE_6,
};
use crate::numeric::ROUND;
use crate::numeric::polynomial::Powers;
use core::f64::consts::{FRAC_2_PI, FRAC_2_SQRT_PI};

/// The line lies farther inside the edge than this: the window does not see the edge.
const INTERIOR: f64 = 4.0;
/// Farther outside the edge M does not count against its peak.
const BEYOND: f64 = 4.5;
/// As above for 1e-3.
const COARSE_INTERIOR: f64 = 2.8;
/// As above for 1e-3.
const COARSE_BEYOND: f64 = 3.25;
/// The cells cover H + C below this.
const CELLS_END: f64 = CELLS_REACH as f64 / CELLS_IN_UNIT;
/// The same for 1e-3.
const COARSE_CELLS_END: f64 = COARSE_CELLS_REACH as f64 / COARSE_CELLS_IN_UNIT;
/// From here on five terms of the series do.
const SHORT_SERIES: f64 = 9.0;

/// Returns M(H, C) to 1e-6 from H, C >= 0 and H - C.
#[inline]
pub(super) fn medium(half_width: f64, offset: f64, edge: f64) -> f64 {
    let far = half_width + offset;
    if edge >= INTERIOR {
        if half_width < super::VAST {
            super::accurate::interior(half_width, far, edge, &HERMITE_6)
        } else {
            vast(half_width, offset)
        }
    } else if edge < -BEYOND || half_width < 0.0 {
        outside(half_width, offset)
    } else if far < CELLS_END {
        let (c, x, y) = cell::<_, CELLS_REACH>(&CELLS, CELLS_IN_UNIT, half_width, offset);
        let powers = Powers::of(x);
        let value = Powers::of(y).eight([
            powers.eight([c[0], c[1], c[2], c[3], c[4], c[5], c[6], c[7]]),
            powers.eight([c[8], c[9], c[10], c[11], c[12], c[13], c[14], 0.0]),
            powers.eight([c[15], c[16], c[17], c[18], c[19], c[20], 0.0, 0.0]),
            powers.eight([c[21], c[22], c[23], c[24], c[25], 0.0, 0.0, 0.0]),
            powers.four([c[26], c[27], c[28], c[29]]),
            powers.four([c[30], c[31], c[32], 0.0]),
            c[33] + c[34] * x,
            c[35],
        ]);
        share(value)
    } else if far >= CELLS_END {
        let (cell, d) = edge_cell(edge);
        let powers = Powers::of(d);
        let [k, j] = cell.map(|[c0, c1, c2, c3, c4, c5, c6, c7, ..]| powers.eight([c0, c1, c2, c3, c4, c5, c6, c7]));
        let sum = if far >= SHORT_SERIES {
            series::<5>(k, j, edge, far)
        } else {
            series::<8>(k, j, edge, far)
        };
        scaled(half_width, far, sum)
    } else {
        f64::NAN
    }
}

/// Returns M(H, C) to 1e-3 from H^2 and C >= 0.
#[inline]
pub(super) fn coarse(squared: f64, offset: f64) -> f64 {
    let inner = offset + COARSE_INTERIOR;
    if squared >= inner * inner {
        if squared > super::VAST {
            return vast(libm::sqrt(squared), offset);
        }
        // The mean over the window of sqrt(1 - 2 C b x - b x^2), to the fourth power of x.
        let product = squared - offset * offset;
        let inverse = 1.0 / (squared * product);
        let (b, inverse) = (squared * inverse, product * inverse);
        let slant = (offset * offset) * b;
        let fourth = 0.09375 + slant * (0.5625 + 0.46875 * slant);
        let share = 1.0 - b * (0.25 + 0.25 * slant + b * fourth);
        return (FRAC_2_SQRT_PI * libm::sqrt(product)) * (inverse * share);
    }
    let half_width = libm::sqrt(squared);
    let (edge, far) = (half_width - offset, half_width + offset);
    if far < COARSE_CELLS_END {
        let (c, x, y) = cell::<_, COARSE_CELLS_REACH>(&COARSE_CELLS, COARSE_CELLS_IN_UNIT, half_width, offset);
        share((c[0] + x * (c[1] + c[2] * x)) + y * ((c[3] + c[4] * x) + c[5] * y))
    } else if edge >= -COARSE_BEYOND {
        let (cell, x) = edge_cell(edge);
        let square = x * x;
        let [k, j] = cell.map(|c| (c[0] + c[1] * x) + square * ((c[2] + c[3] * x) + square * c[4]));
        // K_1 = J/4 and K_2 = (3 K - d J)/4.
        let u = 1.0 / far;
        let sum = k - u * (0.125 * j + (0.03125 * u) * (3.0 * k - edge * j));
        share(FRAC_2_PI * libm::sqrt(far) / squared * sum)
    } else {
        outside(squared, offset)
    }
}

/// Returns the coefficients of a cell and the distances of C and H from its centre, for H, C >= 0 and H + C below the
/// reach of the cells.
#[inline(always)]
fn cell<const N: usize, const REACH: usize>(
    cells: &[[f64; N]],
    in_unit: f64,
    half_width: f64,
    offset: f64,
) -> (&[f64; N], f64, f64) {
    // The nearest centre, counted in cells.
    let rounded = |x: f64| (x * in_unit - 0.5) + ROUND;
    let (y, x) = (rounded(half_width), rounded(offset));
    let count = |rounded: f64| rounded.to_bits().wrapping_sub(ROUND.to_bits()) as usize;
    let (row, column) = (count(y), count(x));
    // Rows 0, 1, 2 ... have REACH cells, one less, two less ...
    let index = (row.wrapping_mul((2 * REACH + 1).wrapping_sub(row)) >> 1).wrapping_add(column);
    let centre = |rounded: f64| ((rounded - ROUND) + 0.5) * (1.0 / in_unit);
    (
        &cells[index.min(cells.len() - 1)],
        offset - centre(x),
        half_width - centre(y),
    )
}

/// A mean is no less than 0 and no more than 1, whatever the fit leaves.
#[inline(always)]
fn share(value: f64) -> f64 {
    let value = if value > 0.0 { value } else { 0.0 };
    if value < 1.0 { value } else { 1.0 }
}
