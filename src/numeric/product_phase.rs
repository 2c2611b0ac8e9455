//! The phase 2 a b, reduced by half turns from the exact product, whatever its size.

use super::ROUND;
use super::exponential::power_of_two;
use super::phase::{FEW_HALF_TURNS, PI_PARTS, sine_cosine, two_product};
use super::tables::INVERSE_PI_PLACES;

/// 1/pi.
const INVERSE_PI: f64 = core::f64::consts::FRAC_1_PI;
/// 2^-600.
const SHRINK: f64 = f64::from_bits((1023 - 600) << 52);

/// Returns (sin 2ab, cos 2ab) for finite a, b >= 0, each within about 2^-52; the sine keeps its relative accuracy at 0.
#[inline(always)]
pub(crate) fn sine_cosine_of_twice_product(a: f64, b: f64) -> (f64, f64) {
    let (r, odd) = reduce_twice_product(a, b);
    let (sine, cosine) = sine_cosine(r);
    (
        f64::from_bits(sine.to_bits() ^ odd),
        f64::from_bits(cosine.to_bits() ^ odd),
    )
}

/// Returns (r, sign bit) with 2 a b = n pi + r, |r| <= pi/2 (1 + eps), the sign bit set when n is odd, for finite
/// a, b >= 0. The error of r is a few eps of r, or 2^-80.
#[inline(always)]
pub(crate) fn reduce_twice_product(a: f64, b: f64) -> (f64, u64) {
    let twice = 2.0 * (a * b);
    if twice >= FEW_HALF_TURNS {
        return reduce_large(a, b);
    }
    // One of them may still be so large that it cannot be split.
    let (a, b) = if a >= FEW_HALF_TURNS {
        (a * SHRINK, b / SHRINK)
    } else {
        (a, b)
    };
    let (a, b) = if b >= FEW_HALF_TURNS {
        (a / SHRINK, b * SHRINK)
    } else {
        (a, b)
    };
    let (product, rest) = two_product(2.0 * a, b);
    let rounded = product * INVERSE_PI + ROUND;
    let n = rounded - ROUND;
    let r = ((product - n * PI_PARTS[0]) - n * PI_PARTS[1]) - (n * PI_PARTS[2] - rest);
    (r, rounded.to_bits() << 63)
}

/// [`reduce_twice_product`] of any size, from the integer product of the fractions and the places of 1/pi that count.
#[cold]
fn reduce_large(a: f64, b: f64) -> (f64, u64) {
    let (Some((fraction_a, exponent_a)), Some((fraction_b, exponent_b))) = (integer(a), integer(b)) else {
        return (a * b, 0);
    };
    let product = u128::from(fraction_a) * u128::from(fraction_b);
    // a b / pi = half of the number of half turns: its fraction tells 2 a b from whole turns.
    let turns = fraction_of_product(product, exponent_a + exponent_b);
    // The nearest quarter of 2^128 is half a turn or none: n is its parity, the rest is what remains.
    let n = (turns[0] >> 62).wrapping_add(1) >> 1;
    let high = (u128::from(turns[0]) << 64 | u128::from(turns[1])).wrapping_sub(u128::from(n) << 127) as i128;
    // `high` is now a signed fraction of a turn in [-1/4, 1/4].
    let (negative, magnitude) = (high < 0, high.unsigned_abs());
    let shift = magnitude.leading_zeros();
    let top = (magnitude << shift >> 64) as u64;
    let leading = (top >> 11) as f64 * power_of_two(-53 - i64::from(shift));
    let following = (top & 0x7ff) as f64 * power_of_two(-64 - i64::from(shift));
    let r = leading * (2.0 * PI_PARTS[0]) + (leading * (2.0 * PI_PARTS[1]) + following * (2.0 * PI_PARTS[0]));
    (if negative { -r } else { r }, n << 63)
}

/// x = m 2^e with an integer m below 2^53, for finite x > 0; none otherwise.
pub(super) fn integer(x: f64) -> Option<(u64, i32)> {
    if !(x > 0.0 && x < f64::INFINITY) {
        return None;
    }
    let bits = x.to_bits();
    let exponent = (bits >> 52) as i32;
    let fraction = bits & 0x000f_ffff_ffff_ffff;
    Some(if exponent == 0 {
        (fraction, -1074)
    } else {
        (fraction | 1 << 52, exponent - 1075)
    })
}

/// The first 128 places of the fraction of m 2^e/pi.
fn fraction_of_product(m: u128, e: i32) -> [u64; 2] {
    // 2^e/pi to 2^-320, without the places that make whole numbers.
    let window: [u64; 5] = core::array::from_fn(|k| places(e + 64 * k as i32));
    // The product with m, modulo 1: limbs from the last to the first.
    let (low, high) = (m as u64, (m >> 64) as u64);
    let mut limbs = [0u64; 5];
    let mut carry = 0u128;
    for k in (0..5).rev() {
        let mut sum = carry & u128::from(u64::MAX);
        let mut over = carry >> 64;
        for term in [
            u128::from(low) * u128::from(window[k]),
            if k < 4 {
                u128::from(high) * u128::from(window[k + 1])
            } else {
                0
            },
        ] {
            sum += term & u128::from(u64::MAX);
            over += term >> 64;
        }
        limbs[k] = sum as u64;
        carry = over + (sum >> 64);
    }
    [limbs[0], limbs[1]]
}

/// The 64 binary places of 1/pi from place `start` (0 is the first after the point; before it stand zeros).
fn places(start: i32) -> u64 {
    let word = |n: i32| {
        usize::try_from(n)
            .ok()
            .and_then(|n| INVERSE_PI_PLACES.get(n))
            .copied()
            .unwrap_or(0)
    };
    let (index, shift) = (start.div_euclid(64), start.rem_euclid(64));
    if shift == 0 {
        word(index)
    } else {
        word(index) << shift | word(index + 1) >> (64 - shift)
    }
}
