//! The exponential function times a number, without overflow or underflow on the way.

use super::ROUND;
use super::polynomial::Powers;

/// 1/ln 2.
const INVERSE_LN_2: f64 = core::f64::consts::LOG2_E;
/// ln 2 in 42 bits, whose products with integers below 2^11 are exact, and the rest.
const LN_2: [f64; 2] = [0.6931471805598903, 5.497923018708371e-14];
/// Beyond, the exponential times any f64 is infinite or zero.
const LARGEST: f64 = 1500.0;

/// e^(high + low) as (m, n), its value being m 2^n, 0.7 <= m <= 1.5, for |low| below 1, exact beside `high` or not.
///
/// Relative error of m at most 2^-53 from the last addition and 2^-56 or so from all else.
#[inline(always)]
fn parts(high: f64, low: f64) -> (f64, i64) {
    let rounded = (high + low) * INVERSE_LN_2 + ROUND;
    let n = rounded - ROUND;
    // The products with the 42 bits of ln 2 and the first difference are exact.
    let r = (high - n * LN_2[0]) - (n * LN_2[1] - low);
    let powers = Powers::of(r);
    // 1/2!, 1/3!, ... 1/13!: the series is cut below an ulp's thousandth on |r| <= ln 2/2.
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
    let last = powers.four([1.0 / 3628800.0, 1.0 / 39916800.0, 1.0 / 479001600.0, 1.0 / 6227020800.0]);
    let square = r * r;
    let fourth = square * square;
    let m = 1.0 + (r + square * (first + (fourth * fourth) * last));
    (m, (rounded.to_bits() as i64).wrapping_sub(ROUND.to_bits() as i64))
}

/// 2^n for -1022 <= n <= 1023.
#[inline(always)]
pub(super) fn power_of_two(n: i64) -> f64 {
    f64::from_bits((n.wrapping_add(1023) as u64) << 52)
}

/// Returns each factor times e^(high + low), without overflow or underflow on the way; zero where the factor is zero.
///
/// Overflow gives an infinity of the factor's sign, underflow a zero or a subnormal number.
#[inline]
pub(crate) fn times_exponential<const N: usize>(factors: [f64; N], high: f64, low: f64) -> [f64; N] {
    let low = if high.abs() < LARGEST { low } else { 0.0 };
    let (m, n) = parts(high.clamp(-LARGEST, LARGEST), low);
    // |n| is at most 2165. In three steps no power leaves the range, and only the last one can leave the normal numbers.
    let third = n / 3;
    let (step, last) = (power_of_two(third), power_of_two(n - 2 * third));
    factors.map(|factor| factor * m * step * step * last)
}

/// Returns e^(high + low) for -700 <= high + low <= 700, in straight line.
#[inline(always)]
pub(crate) fn exponential_in_range(high: f64, low: f64) -> f64 {
    let (m, n) = parts(high, low);
    m * power_of_two(n)
}

/// Returns e^(high + low), zero below the subnormals and infinite beyond the largest number.
#[inline]
pub(crate) fn exponential(high: f64, low: f64) -> f64 {
    let [value] = times_exponential([1.0], high, low);
    value
}
