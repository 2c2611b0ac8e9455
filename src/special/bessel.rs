//! The modified Bessel function I0, scaled; its logarithm, and the ratio I1/I0.
//!
//! # Definition
//!
//! ```math
//! e^{-|x|} I_0(x) = \frac{1}{\pi} \int_0^\pi e^{-|x| + x \cos t}\,dt
//! ```
//!
//! DLMF 10.32.1. The normalising factor of distributions on circles and spheres, among them the von Mises-Fisher lobe
//! of a cone (d'Eon 2011, used by WVJH17). The derivative of ln I0 is I1/I0.
//!
//! # Domain
//!
//! Every f64; NaN gives NaN. [`bessel_i0_scaled`] and [`log_bessel_i0`] are even exactly, [`bessel_i1_i0_ratio`] is odd
//! exactly.
//!
//! | function | at 0 | at ±inf |
//! |---|---|---|
//! | [`bessel_i0_scaled`] | 1 | 0 |
//! | [`log_bessel_i0`] | 0 | inf |
//! | [`bessel_i1_i0_ratio`] | ±0 | ±1 |
//!
//! # Methods
//!
//! Below |x| = 62 the scaled function and the ratio read a cell of a table: the value at the cell's centre and a
//! polynomial of degree 9 in the distance from it, so that the final addition is the only rounding that counts. The cells
//! are even in ln(1 + |x|), of which the function is smooth everywhere. Beyond, 1/sqrt(2 pi x) comes from cells of the
//! same table, with the power of 4 in x taken out, and is multiplied by a polynomial in 1/x: no root is taken.
//! The logarithm is that of 1 + (I0 - 1) below 4 and x + ln(e^-x I0) from there on.
//!
//! <!-- report:begin bessel_i0_scaled -->
//!
//! | method | what it is | precision | largest error | promise | time / baseline |
//! |---|---|---|---|---|---|
//! | `accurate` | iridescence f64 | f64 | 0.56 ulp | 1 ulp | 0.22 (cephes) |
//! | `accurate`, slice | iridescence f64 slices | f64 | 0.56 ulp | 1 ulp | 0.14 (cephes) |
//! | `accurate` | iridescence f32 | f32 | 0.94 ulp | 1 ulp | 2.80 (pxfm) |
//! | `accurate`, slice | iridescence f32 slices | f32 | 0.94 ulp | 1 ulp | 0.09 (accurate, scalar) |
//!
//! <!-- report:end bessel_i0_scaled -->
//!
//! <!-- report:begin log_bessel_i0 -->
//!
//! | method | what it is | precision | largest error | promise | time / baseline |
//! |---|---|---|---|---|---|
//! | `accurate` | iridescence f64 | f64 | 1.7 ulp | 2 ulp | 0.34 (cephes) |
//! | `accurate` | iridescence f32 | f32 | 1.9 ulp | 2 ulp | 1.00 (accurate) |
//!
//! <!-- report:end log_bessel_i0 -->
//!
//! <!-- report:begin bessel_i1_i0_ratio -->
//!
//! | method | what it is | precision | largest error | promise | time / baseline |
//! |---|---|---|---|---|---|
//! | `accurate` | iridescence f64 | f64 | 0.62 ulp | 0.75 ulp | 0.09 (cephes) |
//! | `accurate` | iridescence f32 | f32 | 1.4 ulp | 2 ulp | 1.00 (accurate) |
//!
//! <!-- report:end bessel_i1_i0_ratio -->
//!
//! # Where it fails
//!
//! Nowhere known. I0 itself overflows beyond |x| = 713; the product e^-x I0(x) formed from its factors is 0 times
//! infinity there.
//!
//! # Errata
//!
//! The cone form of the von Mises-Fisher lobe is printed with the unscaled I0 (d'Eon 2011), which overflows long before
//! the concentrations that the lobes of a scratch need.

use super::bessel_tables::{LINEAR_ROWS, NEAR_ROWS, RATIO, RATIO_TAIL, SCALED, SCALED_TAIL, SERIES, TAIL};
use crate::numeric::phase::two_product;
use crate::numeric::polynomial::Powers;

/// The fraction of an f64 below its 4 leading bits.
const BELOW_CELL: u64 = (1 << 48) - 1;
/// Half of the last of those 4 bits: adding it rounds to nearest.
const HALF_CELL: u64 = 1 << 47;
/// The exponent field of 1 and the 4 leading bits of its fraction.
const ONE: u64 = 1023 << 4;
/// From here on ln I0(x) is x + ln(e^-x I0(x)).
const LOG_BORDER: f64 = 4.0;

/// Returns exp(-|x|) I0(x), dimensionless.
///
/// Any f64; even exactly; 1 at 0, ±inf gives 0, NaN gives NaN. It falls as 1/sqrt(2 pi |x|). DLMF 10.25.2.
///
/// ```
/// use iridescence::special::bessel_i0_scaled;
///
/// assert_eq!(bessel_i0_scaled(1.0), 0.46575960759364043);
/// // I0 overflows from 714 on; scaled, it does not.
/// assert_eq!(bessel_i0_scaled(41_000.0), 0.0019702414954347993);
/// ```
#[doc(alias = "i0e")]
#[doc(alias = "ive")]
#[must_use]
#[inline]
pub fn bessel_i0_scaled(x: f64) -> f64 {
    let magnitude = x.abs();
    if magnitude < TAIL {
        scaled_near(magnitude)
    } else {
        scaled_far(magnitude)
    }
}

/// The bits of [`bessel_i0_scaled`] for each element, in loops without a branch.
///
/// A block on one side of the border of cells and tail is spared the other evaluation.
#[cfg(feature = "simd")]
#[inline(always)]
pub(crate) fn bessel_i0_scaled_block<const N: usize>(x: &[f64; N]) -> [f64; N] {
    let cells: usize = x.iter().map(|x| usize::from(x.abs() < TAIL)).sum();
    let mut values = [0.0; N];
    let pairs = values.iter_mut().zip(x);
    if cells == N {
        for (value, x) in pairs {
            *value = scaled_near(x.abs());
        }
    } else if cells == 0 {
        for (value, x) in pairs {
            *value = scaled_far(x.abs());
        }
    } else {
        for (value, x) in pairs {
            let magnitude = x.abs();
            let is_near = magnitude < TAIL;
            let (near, far) = (near_cell(magnitude), far_cell(magnitude));
            let (row, d) = if is_near { near } else { (far.0, far.1) };
            let (base, rest) = scaled_cell(row, d);
            let grown = grow(magnitude, far.2, base, rest);
            *value = if is_near { base + rest } else { grown };
        }
    }
    values
}

/// Returns ln I0(x), dimensionless.
///
/// Any f64; even exactly; x^2/4 near 0 and |x| - ln(2 pi |x|)/2 far from it; 0 at 0, ±inf gives inf, NaN gives NaN.
///
/// ```
/// use iridescence::special::log_bessel_i0;
///
/// assert_eq!(log_bessel_i0(1e-100), 2.5e-201);
/// ```
#[must_use]
pub fn log_bessel_i0(x: f64) -> f64 {
    let magnitude = x.abs();
    if magnitude < LOG_BORDER {
        // I0 - 1 = u/4 + u^2 S(u), the rounding error of u carried along.
        let (u, lost) = two_product(magnitude, magnitude);
        let [first, rest @ ..] = SERIES;
        let series = first + Powers::of(u).nine_from_first(rest);
        libm::log1p(0.25 * u + (0.25 * lost + u * (u * series)))
    } else if magnitude <= f64::MAX {
        magnitude + libm::log(scaled(magnitude))
    } else {
        magnitude
    }
}

/// Returns I1(x)/I0(x), the derivative of [`log_bessel_i0`], dimensionless.
///
/// Any f64; odd exactly; x/2 near 0, 1 - 1/(2x) far from it; ±0 at ±0, ±inf gives ±1, NaN gives NaN. It is the mean of
/// the cosine over the von Mises distribution of concentration x.
///
/// ```
/// use iridescence::special::bessel_i1_i0_ratio;
///
/// assert_eq!(bessel_i1_i0_ratio(1e-100), 5e-101);
/// assert_eq!(bessel_i1_i0_ratio(f64::INFINITY), 1.0);
/// ```
#[must_use]
#[inline]
pub fn bessel_i1_i0_ratio(x: f64) -> f64 {
    let magnitude = x.abs();
    let value = if magnitude < TAIL {
        ratio_near(magnitude)
    } else {
        let v = 1.0 / magnitude;
        1.0 - v * Powers::of(v).eight(RATIO_TAIL)
    };
    value.copysign(x)
}

/// Returns the row of the cell to which 1 + x belongs, and the distance of x from its centre, for 0 <= x < TAIL.
#[inline(always)]
fn near_cell(x: f64) -> (u64, f64) {
    let rounded = (1.0 + x).to_bits().wrapping_add(HALF_CELL);
    let centre = f64::from_bits(rounded & !BELOW_CELL) - 1.0;
    ((rounded >> 48).wrapping_sub(ONE), x - centre)
}

#[inline(always)]
fn scaled(x: f64) -> f64 {
    if x < TAIL { scaled_near(x) } else { scaled_far(x) }
}

#[inline(always)]
fn scaled_near(x: f64) -> f64 {
    let (row, d) = near_cell(x);
    let (base, rest) = scaled_cell(row, d);
    base + rest
}

#[inline(always)]
fn scaled_far(x: f64) -> f64 {
    let (row, d, power) = far_cell(x);
    let (base, rest) = scaled_cell(row, d);
    grow(x, power, base, rest)
}

/// Returns the two parts, the larger one first, of what the row of `SCALED` gives at the distance d from its centre.
#[inline(always)]
fn scaled_cell(row: u64, d: f64) -> (f64, f64) {
    let [base, constant, slope @ ..] = SCALED[(row & 127) as usize];
    (base, constant + Powers::of(d).nine_from_first(slope))
}

/// Returns (row, d, 2^-k) with x = 4^(k+1) m and m at the distance d from the centre of the row's cell in [1, 4].
#[inline(always)]
fn far_cell(x: f64) -> (u64, f64, f64) {
    // The quotient does not round, and the sum below does not reach infinity.
    let quarter = 0.25 * x;
    let rounded = quarter.to_bits().wrapping_add(HALF_CELL) & !BELOW_CELL;
    let leading = (rounded >> 48).wrapping_add(16);
    let row = NEAR_ROWS + (leading & 31);
    let k = (leading >> 5).wrapping_sub(512);
    let power = f64::from_bits(1023u64.wrapping_sub(k) << 52);
    let d = ((quarter - f64::from_bits(rounded)) * power) * power;
    (row, d, power)
}

/// Returns e^-x I0(x) for x >= TAIL from 1/sqrt(2 pi x) = power (base + rest).
#[inline(always)]
fn grow(x: f64, power: f64, base: f64, rest: f64) -> f64 {
    let v = 1.0 / x;
    let growth = v * Powers::of(v).eight(SCALED_TAIL);
    let value = power * (base + (rest + (base + rest) * growth));
    // The limit at infinity is 0; a NaN stays one.
    if x <= f64::MAX { value } else { v }
}

#[inline(always)]
fn ratio_near(x: f64) -> f64 {
    let (row, d) = near_cell(x);
    let [tabulated, constant, slope @ ..] = RATIO[row.min(NEAR_ROWS - 1) as usize];
    let base = if row < LINEAR_ROWS { 0.5 * x } else { tabulated };
    base + (constant + Powers::of(d).nine_from_first(slope))
}
