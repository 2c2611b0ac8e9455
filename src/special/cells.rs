//! The two evaluations that Si and H share: a table of cells near the origin, auxiliary functions beyond it.

use super::tables::{Cells, LINEAR_ROWS, ROWS, TAIL_F, TAIL_G, WIDTH};
use crate::numeric::ROUND;
use crate::numeric::polynomial::Powers;

/// pi/2, and what its rounding left out.
pub(super) const HALF_PI: [f64; 2] = [core::f64::consts::FRAC_PI_2, 6.123233995736766e-17];

/// Returns (base, constant, rest), whose sum is the tabulated function at 0 <= x < TAIL, each smaller than the one before.
///
/// In the first rows the base is `slope * x`, which keeps the relative accuracy down to the smallest numbers, and the
/// constant is what the function's value at the cell's centre has beside it; in the others base and constant are that
/// value and what its rounding left out. Any other x gives three numbers of no meaning.
#[inline(always)]
pub(super) fn cell(table: &Cells, slope: f64, x: f64) -> (f64, f64, f64) {
    let rounded = x * (1.0 / WIDTH) + ROUND;
    let row = rounded.to_bits() & (ROWS as u64 - 1);
    let d = x - (rounded - ROUND) * WIDTH;
    let r = row as usize;
    let [c0, c1, c2, c3, c4, c5, c6, c7, c8, c9] = &table.coefficients;
    let rest = Powers::of(d).nine_from_first([c1[r], c2[r], c3[r], c4[r], c5[r], c6[r], c7[r], c8[r], c9[r]]);
    let tabulated = table.base[r];
    let base = if row < LINEAR_ROWS { slope * x } else { tabulated };
    (base, c0[r], rest)
}

/// Returns (1 - x f(x)) x^2 and (1 - x^2 g(x)) x^2 from `w` = 1/x^2, for x >= TAIL_LOW.
///
/// f and g are the auxiliary functions of the sine integral, DLMF 6.2.17 and 6.2.18.
#[inline(always)]
pub(super) fn auxiliary(w: f64) -> (f64, f64) {
    let powers = Powers::of(w);
    (powers.eight(TAIL_F), powers.eight(TAIL_G))
}
