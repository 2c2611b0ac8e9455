//! The error function erf of a real argument.
//!
//! # Definition
//!
//! ```math
//! \mathrm{erf}(x) = \frac{2}{\sqrt{\pi}} \int_0^x e^{-t^2}\,dt
//! ```
//!
//! DLMF 7.2.1. Its derivative is 2/sqrt(pi) exp(-x^2). For complex arguments see
//! [`erf_complex`](super::erf_complex()), for differences
//! [`erf_difference_scaled`](super::erf_difference_scaled()).
//!
//! # Domain
//!
//! Every f64. Odd exactly; erf(±0) = ±0, erf(±inf) = ±1, NaN gives NaN.
//!
//! # Methods
//!
//! [`erf()`] reads a cell of a table: the value at the cell's centre in two parts, the slope there, and a polynomial
//! of the distance d from the centre. The slope is cut to 26 bits, so that its products with both halves of d are
//! exact, and the leading one is added to the value without loss. What is left is small against the result: the error
//! is that of the last addition, which rounds to nearest, and little more. In the cell at 0 value and centre vanish,
//! and the same sum is x times 2/sqrt(pi) in two parts and a polynomial. From 5.9375 on erf rounds to 1. Arguments
//! whose products would be subnormal are scaled first, and the sum is rounded once to the spacing of the result.
//!
//! <!-- report:begin erf -->
//!
//! | method | what it is | precision | largest error | promise | time / baseline |
//! |---|---|---|---|---|---|
//! | `accurate` | iridescence f64 | f64 | 0.50 ulp | 0.501 ulp | 0.43 (cephes) |
//! | `accurate`, slice | iridescence f64 slices | f64 | 0.50 ulp | 0.501 ulp | 0.23 (cephes) |
//! | `complex` | iridescence f64, complex erf at z = x | f64 | 4.6 ulp | 8 ulp | 4.33 (cephes) |
//!
//! <!-- report:end erf -->
//!
//! # Where it fails
//!
//! Nowhere known.
//!
//! # Errata
//!
//! None known in the definition.

use super::erf_tables::{CELLS, END, PER_UNIT};
use crate::numeric::polynomial::Powers;

/// 3 times 2^51 in units of a cell: adding it rounds to the centre of a cell and leaves the row in the last bits.
const CENTRES: f64 = 6755399441055744.0 / PER_UNIT;
/// The last row.
const LAST: u64 = CELLS.len() as u64 - 1;
/// The fraction of an f64 below its 26 leading bits.
const BELOW_HALF: u64 = (1 << 27) - 1;
/// 2^-40: below, erf rounds to 2x/sqrt(pi).
const STRAIGHT: f64 = f64::from_bits((1023 - 40) << 52);
/// 2^-1000: below, products of parts of x become subnormal.
const TINY: f64 = f64::from_bits((1023 - 1000) << 52);
/// 2^1000.
const SCALE: f64 = f64::from_bits((1023 + 1000) << 52);
/// 2^-22, the smallest normal number scaled: adding it to less rounds to the spacing of the subnormals.
const SMALLEST_NORMAL: f64 = f64::MIN_POSITIVE * SCALE;

/// Returns erf(x), dimensionless.
///
/// Any f64; odd exactly; 2x/sqrt(pi) near 0; ±0 gives ±0, ±inf gives ±1, NaN gives NaN. DLMF 7.2.1.
///
/// ```
/// assert_eq!(iridescence::special::erf(1.0), 0.8427007929497149);
/// // The probability that a normal variate lies within one standard deviation.
/// assert_eq!(iridescence::special::erf(core::f64::consts::FRAC_1_SQRT_2), 0.682689492137086);
/// ```
#[must_use]
#[inline]
pub fn erf(x: f64) -> f64 {
    let magnitude = x.abs();
    let value = if magnitude < TINY {
        tiny(magnitude)
    } else {
        cell(magnitude)
    };
    value.copysign(x)
}

/// The bits of [`erf()`] for each element, in a loop without a branch; tiny elements are renewed afterwards.
#[cfg(feature = "simd")]
#[inline(always)]
pub(crate) fn erf_block<const N: usize>(x: &[f64; N]) -> [f64; N] {
    let mut values = [0.0; N];
    for (value, x) in values.iter_mut().zip(x) {
        *value = cell(x.abs()).copysign(*x);
    }
    if x.iter().any(|x| x.abs() < TINY) {
        for (value, x) in values.iter_mut().zip(x) {
            *value = erf(*x);
        }
    }
    values
}

/// Returns erf(x) for x >= TINY, and NaN for NaN.
#[inline(always)]
fn cell(x: f64) -> f64 {
    let x = if x > END { END } else { x };
    let rounded = x + CENTRES;
    let d = x - (rounded - CENTRES);
    let row = (rounded.to_bits() & 255).min(LAST);
    let [high, low, slope, rest, curvature, c3, c4, c5, c6, c7, c8] = CELLS[row as usize];
    let (rise, below) = line(slope, d);
    // Powers of less change nothing, and would underflow, which is slow.
    let bend = if x < STRAIGHT { 0.0 } else { d };
    let square = bend * bend;
    let cubic = Powers::of(bend).four([c3, c4, c5, c6]) + (square * square) * (c7 + c8 * bend);
    // No bit is lost: the value at the centre is larger than the rise, or 0.
    let sum = high + rise;
    let lost = (high - sum) + rise;
    // The term of the curvature leads what is left, and is added last.
    let small = ((lost + low) + below) + d * (rest + square * cubic);
    sum + (small + curvature * square)
}

/// Returns `slope` times d in two parts, both exact for a slope of 26 bits.
#[inline(always)]
fn line(slope: f64, d: f64) -> (f64, f64) {
    let leading = f64::from_bits(d.to_bits() & !BELOW_HALF);
    (slope * leading, slope * (d - leading))
}

/// Returns erf(x) = 2x/sqrt(pi), rounded to nearest, for 0 <= x < TINY.
#[cold]
fn tiny(x: f64) -> f64 {
    let [_, _, slope, rest, ..] = CELLS[0];
    let scaled = x * SCALE;
    let (rise, below) = line(slope, scaled);
    let low = below + rest * scaled;
    let mut value = rise + low;
    if value < SMALLEST_NORMAL {
        let sum = SMALLEST_NORMAL + rise;
        let lost = rise - (sum - SMALLEST_NORMAL);
        value = (sum + (lost + low)) - SMALLEST_NORMAL;
    }
    value * TINY
}
