//! Sine, cosine and exponential of the f32 kernels.
//!
//! WGSL promises 2^-11 absolute for its own sine and cosine, and nothing beyond a half turn; these give the same bits
//! on every machine that neither fuses nor reorders.

use super::coefficients::*;
use super::gpu::{abs, bits_of, from_bits, max, min, round, select};

/// 1/pi.
pub(super) const INVERSE_PI: f32 = 0.31830987;
/// pi in 8 bits: its products with integers below 65536 are exact.
pub(super) const PI_HIGH: f32 = 3.140625;
/// What [`PI_HIGH`] left out.
pub(super) const PI_LOW: f32 = 0.0009676536;
/// A little more than pi/2: what the rounding of a phase may leave, and where the kernels still hold.
pub(super) const REST_LIMIT: f32 = 1.75;
/// 2 pi.
pub(super) const TWO_PI: f32 = 6.2831855;
/// From here on no phase of an f32 is known to better than a radian.
pub(super) const PHASE_LIMIT: f32 = 33554432.0;
/// 2^23 + 127.
pub(super) const EXPONENT_BIAS: f32 = 8388735.0;
/// log2 e.
pub(super) const LOG_TWO_E: f32 = 1.442695;
/// ln 2 in 10 bits.
pub(super) const LN_TWO_HIGH: f32 = 0.693359375;
/// What [`LN_TWO_HIGH`] left out.
pub(super) const LN_TWO_LOW: f32 = -0.00021219444;

/// The sine and the cosine of one angle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SineCosine {
    /// The sine.
    pub sine: f32,
    /// The cosine.
    pub cosine: f32,
}

/// An angle reduced by half turns: x = n pi + r.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct HalfTurns {
    /// r, within a quarter turn of 0, in radians.
    pub(super) rest: f32,
    /// 1 for an even n, -1 for an odd one.
    pub(super) parity: f32,
}

/// Returns the value of an odd function at x from its `value` at |x|, the sign of a zero included.
#[inline(always)]
pub(super) fn odd_continuation(x: f32, value: f32) -> f32 {
    from_bits(bits_of(value) ^ (bits_of(x) & 0x80000000u32))
}

/// Returns x reduced by half turns, for x in radians.
///
/// The error of the rest is at most 1e-7 for |x| to 1e4, and 2^-24 |x| beyond.
#[inline(always)]
pub(super) fn reduce_half_turns(x: f32) -> HalfTurns {
    let n = round(x * INVERSE_PI);
    let rest = (x - n * PI_HIGH) - n * PI_LOW;
    let pairs = n * 0.5;
    let parity = 1.0 - 4.0 * abs(pairs - round(pairs));
    HalfTurns { rest, parity }
}

/// Returns the sine and cosine of r for r within a quarter turn of 0, to 1e-7; the sine keeps its relative accuracy.
#[inline(always)]
pub(super) fn sine_cosine_near(r: f32) -> SineCosine {
    let u = r * r;
    let s = SINE_A + u * (SINE_B + u * (SINE_C + u * SINE_D));
    let c = COSINE_A + u * (COSINE_B + u * (COSINE_C + u * COSINE_D));
    SineCosine {
        sine: r + r * (u * s),
        cosine: 1.0 - u * (0.5 - u * c),
    }
}

/// Returns the sine and cosine of r for r within a quarter turn of 0, to 5e-6.
#[inline(always)]
pub(super) fn sine_cosine_near_medium(r: f32) -> SineCosine {
    let u = r * r;
    let s = SINE_MEDIUM_A + u * (SINE_MEDIUM_B + u * SINE_MEDIUM_C);
    let c = COSINE_MEDIUM_A + u * (COSINE_MEDIUM_B + u * COSINE_MEDIUM_C);
    SineCosine {
        sine: r + r * (u * s),
        cosine: 1.0 - u * (0.5 - u * c),
    }
}

/// Returns the sine and cosine of r for r within a quarter turn of 0, to 6e-4.
#[inline(always)]
pub(super) fn sine_cosine_near_coarse(r: f32) -> SineCosine {
    let u = r * r;
    let s = SINE_COARSE_A + u * SINE_COARSE_B;
    let c = COSINE_COARSE_A + u * COSINE_COARSE_B;
    SineCosine {
        sine: r + r * (u * s),
        cosine: 1.0 - u * (0.5 - u * c),
    }
}

/// Returns the sine and cosine of x in radians, to 2.5e-7 for |x| to 1e4.
///
/// Beyond, the phase loses digits in proportion; both stay within 1 for any finite x.
#[inline(always)]
#[must_use]
pub fn sine_cosine(x: f32) -> SineCosine {
    let turns = reduce_half_turns(x);
    let near = sine_cosine_near(min(max(turns.rest, -REST_LIMIT), REST_LIMIT));
    SineCosine {
        sine: select(turns.parity * near.sine, x, x == 0.0),
        cosine: turns.parity * near.cosine,
    }
}

/// Returns the sine and cosine of a whole number of turns and a part: of 2 pi `turns`.
///
/// Exact reduction for |turns| to 1.7e38: a caller that knows its phase in turns loses nothing to the size of the phase.
#[inline(always)]
#[must_use]
pub fn sine_cosine_turns(turns: f32) -> SineCosine {
    let whole = round(turns + turns);
    let pairs = whole * 0.5;
    let near = sine_cosine_near(TWO_PI * (turns - pairs));
    let parity = 1.0 - 4.0 * abs(pairs - round(pairs));
    SineCosine {
        sine: parity * near.sine,
        cosine: parity * near.cosine,
    }
}

/// Returns e to the x, to 2 units of the last place for x from -87 to 88.
///
/// Below, the result falls to 0 by way of subnormal numbers, which a GPU may flush; above 88.7 it stays at e^88.7.
#[inline(always)]
#[must_use]
pub fn exponential(x: f32) -> f32 {
    let bounded = min(max(x, -104.0), 88.7);
    let n = round(bounded * LOG_TWO_E);
    let r = (bounded - n * LN_TWO_HIGH) - n * LN_TWO_LOW;
    let e = EXPONENTIAL_A + r * (EXPONENTIAL_B + r * (EXPONENTIAL_C + r * (EXPONENTIAL_D + r * EXPONENTIAL_E)));
    let value = 1.0 + r * (1.0 + r * e);
    let halved = round(n * 0.5);
    // The low bits of 2^23 + 127 + n are the exponent field of 2^n.
    let first = from_bits(bits_of(halved + EXPONENT_BIAS) << 23u32);
    let second = from_bits(bits_of((n - halved) + EXPONENT_BIAS) << 23u32);
    value * first * second
}
