//! Sine and cosine after an exact reduction by half turns.
//!
//! The crate has its own so that scalars, slices and every machine give the same bits.

use super::polynomial::Powers;
use super::tables::{COSINE, SINE};

/// 1/pi, and what its rounding left out.
const INVERSE_PI: [f64; 2] = [core::f64::consts::FRAC_1_PI, -1.9678676675182486e-17];
/// pi in 26 bits, so that its product with 26 further bits is exact, and the rest.
const PI_SPLIT: [f64; 2] = [3.1415926218032837, 3.178650954705639e-08];
/// pi, and what its rounding left out.
const PI: [f64; 2] = [core::f64::consts::PI, 1.2246467991473532e-16];
/// pi in 26 and 26 bits, whose products with integers below 2^26 are exact, and the rest.
pub(super) const PI_PARTS: [f64; 3] = [3.1415926218032837, 3.1786509424591713e-08, 1.2246467991473532e-16];
/// 2^26: below, x/pi rounds to an integer of at most 26 bits.
pub(super) const FEW_HALF_TURNS: f64 = 67108864.0;
/// 2^52: adding it rounds a number in [0, 2^52) to an integer.
const INTEGERS: f64 = 4503599627370496.0;
/// 2^27 + 1, Veltkamp's splitter.
const SPLITTER: f64 = 134217729.0;

/// Returns (sin r, cos r) for |r| <= pi/2, each within 2^-52 absolute; sin r keeps its relative accuracy at 0.
#[inline(always)]
pub(crate) fn sine_cosine(r: f64) -> (f64, f64) {
    let u = r * r;
    let powers = Powers::of(u);
    let sine = r + r * (u * powers.eight(SINE));
    let cosine = 1.0 - u * (0.5 - u * powers.eight(COSINE));
    (sine, cosine)
}

/// Returns (r, sign bit) with x = n pi + r, the sign bit set when n is odd, for 0 <= x <= 2^54.
///
/// The error of r is at most 2^-53 + 2^-79 x. Beyond 2^53 the rounding of n leaves |r| up to 2 pi, where
/// [`sine_cosine`] still has two digits: enough for a term that is divided by x.
#[inline(always)]
pub(crate) fn reduce_half_turns(x: f64) -> (f64, u64) {
    let rounded = x * INVERSE_PI[0] + INTEGERS;
    let n = rounded - INTEGERS;
    let odd = if rounded < 2.0 * INTEGERS {
        rounded.to_bits() << 63
    } else {
        0
    };
    let high = f64::from_bits(n.to_bits() & !0x07ff_ffff);
    let low = n - high;
    let r = ((x - high * PI_SPLIT[0]) - low * PI_SPLIT[0]) - n * PI_SPLIT[1];
    (r, odd)
}

/// Returns the distance r of x from the nearest multiple of pi, |r| <= pi/2 (1 + eps), for 0 <= x < 2^110.
///
/// Relative error a few eps, also beside the multiples of pi, until the absolute error reaches 2^-103 x:
/// less than eps times the distance of x to the next number.
#[inline]
pub(crate) fn distance_to_half_turn(x: f64) -> f64 {
    if x < FEW_HALF_TURNS {
        let n = (x * INVERSE_PI[0] + INTEGERS) - INTEGERS;
        ((x - n * PI_PARTS[0]) - n * PI_PARTS[1]) - n * PI_PARTS[2]
    } else {
        distance_of_many_half_turns(x)
    }
}

/// [`distance_to_half_turn`] from the fraction of x/pi in twice the working precision.
#[cold]
fn distance_of_many_half_turns(x: f64) -> f64 {
    let (product, rest) = two_product(x, INVERSE_PI[0]);
    let (fraction, carry) = (product - libm::rint(product), rest - libm::rint(rest));
    let (high, low) = two_sum(fraction, carry);
    let small = x * INVERSE_PI[1];
    let (high, lower) = two_sum(high, small - libm::rint(small));
    let low = low + lower;
    let (high, low) = two_sum(high - libm::rint(high), low);
    let turn = high - libm::rint(high);
    turn * PI[0] + (turn * PI[1] + low * PI[0])
}

/// Returns (s, e) with s + e = a + b exactly and s = fl(a + b).
#[inline(always)]
pub(crate) fn two_sum(a: f64, b: f64) -> (f64, f64) {
    let sum = a + b;
    let part = sum - a;
    (sum, (a - (sum - part)) + (b - part))
}

/// Returns (p, e) with p + e = a b exactly and p = fl(a b), for |a|, |b| < 2^996 and no underflow.
#[inline(always)]
pub(crate) fn two_product(a: f64, b: f64) -> (f64, f64) {
    let (ah, al) = split(a);
    let (bh, bl) = split(b);
    let product = a * b;
    (product, ((ah * bh - product) + ah * bl + al * bh) + al * bl)
}

#[inline(always)]
fn split(a: f64) -> (f64, f64) {
    let c = SPLITTER * a;
    let high = c - (c - a);
    (high, a - high)
}
