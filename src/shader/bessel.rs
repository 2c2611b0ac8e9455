//! The scaled modified Bessel function I0 in f32, its logarithm, and the ratio I1/I0.
//!
//! Below a border e^-x I0(x) is a value at a centre and a polynomial in the distance from it, beyond it 1/sqrt(2 pi x)
//! from the bits of x, times a polynomial in 1/(2 pi x): neither a division nor a root, and the last addition is the
//! only rounding of a large term.

use super::bessel_coefficients::*;
use super::elementary::odd_continuation;
use super::gpu::{abs, bits_of, from_bits, max, min, select};

/// ln(2)/2.
pub(super) const BESSEL_HALF_LN_TWO: f32 = 0.34657359;

/// A positive number as c (1 + t) 2^e, for one of two c between 1 and 2.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct BesselPowers {
    /// t, within 0.172 of 0.
    pub(super) rest: f32,
    /// Whether c is the one above the square root of 2.
    pub(super) high: bool,
    /// e + 127.
    pub(super) exponent: u32,
}

/// Returns x >= 1 taken apart.
#[inline(always)]
pub(super) fn bessel_powers(x: f32) -> BesselPowers {
    let bits = bits_of(x);
    let mantissa = from_bits((bits & 0x007fffffu32) | 0x3f800000u32);
    let high = mantissa >= BESSEL_SPLIT;
    let centre = select(BESSEL_LOW_CENTRE, BESSEL_HIGH_CENTRE, high);
    let inverse = select(BESSEL_LOW_INVERSE, BESSEL_HIGH_INVERSE, high);
    BesselPowers {
        rest: (mantissa - centre) * inverse,
        high,
        exponent: (bits >> 23u32) & 0xffu32,
    }
}

/// Returns e to the -|x| times I0(x), to 1 unit of the last place.
///
/// Any x; even; 1 at 0, falls as 1/sqrt(2 pi |x|), 0 at infinity.
#[inline(always)]
#[must_use]
pub fn bessel_i0_scaled(x: f32) -> f32 {
    let y = abs(x);
    // Near: four pieces, each a value and a polynomial in the distance from where it is taken.
    let near_y = min(y, BESSEL_FOURTH_END);
    let second = near_y >= BESSEL_FIRST_END;
    let third = near_y >= BESSEL_SECOND_END;
    let fourth = near_y >= BESSEL_THIRD_END;
    let centre_low = select(BESSEL_FIRST_CENTRE, BESSEL_SECOND_CENTRE, second);
    let centre_high = select(BESSEL_THIRD_CENTRE, BESSEL_FOURTH_CENTRE, fourth);
    let centre = select(centre_low, centre_high, third);
    let value_low = select(BESSEL_FIRST_VALUE, BESSEL_SECOND_VALUE, second);
    let value_high = select(BESSEL_THIRD_VALUE, BESSEL_FOURTH_VALUE, fourth);
    let value = select(value_low, value_high, third);
    let pa_low = select(BESSEL_FIRST_A, BESSEL_SECOND_A, second);
    let pa_high = select(BESSEL_THIRD_A, BESSEL_FOURTH_A, fourth);
    let pa = select(pa_low, pa_high, third);
    let pb_low = select(BESSEL_FIRST_B, BESSEL_SECOND_B, second);
    let pb_high = select(BESSEL_THIRD_B, BESSEL_FOURTH_B, fourth);
    let pb = select(pb_low, pb_high, third);
    let pc_low = select(BESSEL_FIRST_C, BESSEL_SECOND_C, second);
    let pc_high = select(BESSEL_THIRD_C, BESSEL_FOURTH_C, fourth);
    let pc = select(pc_low, pc_high, third);
    let pd_low = select(BESSEL_FIRST_D, BESSEL_SECOND_D, second);
    let pd_high = select(BESSEL_THIRD_D, BESSEL_FOURTH_D, fourth);
    let pd = select(pd_low, pd_high, third);
    let pe_low = select(BESSEL_FIRST_E, BESSEL_SECOND_E, second);
    let pe_high = select(BESSEL_THIRD_E, BESSEL_FOURTH_E, fourth);
    let pe = select(pe_low, pe_high, third);
    let pf_low = select(BESSEL_FIRST_F, BESSEL_SECOND_F, second);
    let pf_high = select(BESSEL_THIRD_F, BESSEL_FOURTH_F, fourth);
    let pf = select(pf_low, pf_high, third);
    let pg_low = select(BESSEL_FIRST_G, BESSEL_SECOND_G, second);
    let pg_high = select(BESSEL_THIRD_G, BESSEL_FOURTH_G, fourth);
    let pg = select(pg_low, pg_high, third);
    let ph = select(0.0, BESSEL_FOURTH_H, fourth);
    let pi = select(0.0, BESSEL_FOURTH_I, fourth);
    let d = near_y - centre;
    let upper = pd + d * (pe + d * (pf + d * (pg + d * (ph + d * pi))));
    let near = value + d * (pa + d * (pb + d * (pc + d * upper)));
    // Far: 1/sqrt(2 pi x) = root (1 + q), and 1 + g times it.
    let powers = bessel_powers(max(y, BESSEL_FOURTH_END));
    let odd = (powers.exponent & 1u32) == 0u32;
    let low_root = select(BESSEL_LOW_EVEN, BESSEL_LOW_ODD, odd);
    let high_root = select(BESSEL_HIGH_EVEN, BESSEL_HIGH_ODD, odd);
    // 2^-k, k the integer part of e/2.
    let scale = from_bits((191u32 - ((powers.exponent + 1u32) >> 1u32)) << 23u32);
    let root = select(low_root, high_root, powers.high) * scale;
    let t = powers.rest;
    let upper_root = BESSEL_ROOT_E + t * (BESSEL_ROOT_F + t * BESSEL_ROOT_G);
    let bend = BESSEL_ROOT_A + t * (BESSEL_ROOT_B + t * (BESSEL_ROOT_C + t * (BESSEL_ROOT_D + t * upper_root)));
    let q = t * bend;
    let whole_root = root + root * q;
    let v = whole_root * whole_root;
    let tail = y >= BESSEL_OUTER_END;
    let w = v - select(BESSEL_OUTER_CENTRE, 0.0, tail);
    let ga = select(BESSEL_OUTER_A, 0.0, tail);
    let gb = select(BESSEL_OUTER_B, BESSEL_TAIL_A, tail);
    let gc = select(BESSEL_OUTER_C, BESSEL_TAIL_B, tail);
    let gd = select(BESSEL_OUTER_D, BESSEL_TAIL_C, tail);
    let ge = select(BESSEL_OUTER_E, BESSEL_TAIL_D, tail);
    let gf = select(BESSEL_OUTER_F, BESSEL_TAIL_E, tail);
    let gg = select(BESSEL_OUTER_G, BESSEL_TAIL_F, tail);
    let gh = select(BESSEL_OUTER_H, BESSEL_TAIL_G, tail);
    let gi = select(BESSEL_OUTER_I, BESSEL_TAIL_H, tail);
    let upper_growth = ge + w * (gf + w * (gg + w * (gh + w * gi)));
    let growth = ga + w * (gb + w * (gc + w * (gd + w * upper_growth)));
    let far = root + root * (q + (growth + q * growth));
    let finite = select(near, far, y >= BESSEL_FOURTH_END);
    select(finite, 0.0, bits_of(y) == 0x7f800000u32)
}

/// Returns ln I0(x), to 2 units of the last place.
///
/// Any x; even; x^2/4 near 0, |x| - ln(2 pi |x|)/2 far from it.
#[inline(always)]
#[must_use]
pub fn log_bessel_izero(x: f32) -> f32 {
    let y = abs(x);
    // Head: the leading term is the larger one.
    let bounded = min(y, BESSEL_HEAD_END);
    let u = bounded * bounded;
    let bend = BESSEL_LOG_HEAD_A
        + u * (BESSEL_LOG_HEAD_B + u * (BESSEL_LOG_HEAD_C + u * (BESSEL_LOG_HEAD_D + u * BESSEL_LOG_HEAD_E)));
    let head = u * (0.25 + u * bend);
    // Middle: three pieces.
    let middle_y = min(y, BESSEL_BORDER);
    let second = middle_y >= BESSEL_LOG_FIRST_END;
    let third = middle_y >= BESSEL_LOG_SECOND_END;
    let centre_low = select(BESSEL_LOG_FIRST_CENTRE, BESSEL_LOG_SECOND_CENTRE, second);
    let centre = select(centre_low, BESSEL_LOG_THIRD_CENTRE, third);
    let value_low = select(BESSEL_LOG_FIRST_VALUE, BESSEL_LOG_SECOND_VALUE, second);
    let value = select(value_low, BESSEL_LOG_THIRD_VALUE, third);
    let pa_low = select(BESSEL_LOG_FIRST_A, BESSEL_LOG_SECOND_A, second);
    let pa = select(pa_low, BESSEL_LOG_THIRD_A, third);
    let pb_low = select(BESSEL_LOG_FIRST_B, BESSEL_LOG_SECOND_B, second);
    let pb = select(pb_low, BESSEL_LOG_THIRD_B, third);
    let pc_low = select(BESSEL_LOG_FIRST_C, BESSEL_LOG_SECOND_C, second);
    let pc = select(pc_low, BESSEL_LOG_THIRD_C, third);
    let pd_low = select(BESSEL_LOG_FIRST_D, BESSEL_LOG_SECOND_D, second);
    let pd = select(pd_low, BESSEL_LOG_THIRD_D, third);
    let pe_low = select(BESSEL_LOG_FIRST_E, BESSEL_LOG_SECOND_E, second);
    let pe = select(pe_low, BESSEL_LOG_THIRD_E, third);
    let pf_low = select(BESSEL_LOG_FIRST_F, BESSEL_LOG_SECOND_F, second);
    let pf = select(pf_low, BESSEL_LOG_THIRD_F, third);
    let pg_high = select(BESSEL_LOG_SECOND_G, BESSEL_LOG_THIRD_G, third);
    let pg = select(0.0, pg_high, second);
    let d = middle_y - centre;
    let upper = pd + d * (pe + d * (pf + d * pg));
    let middle = value + d * (pa + d * (pb + d * (pc + d * upper)));
    // Tail.
    let powers = bessel_powers(max(y, BESSEL_BORDER));
    let t = powers.rest;
    let upper_log = BESSEL_LN_E + t * (BESSEL_LN_F + t * BESSEL_LN_G);
    let logarithm = t * (BESSEL_LN_A + t * (BESSEL_LN_B + t * (BESSEL_LN_C + t * (BESSEL_LN_D + t * upper_log))));
    let v = 1.0 / max(y, BESSEL_BORDER);
    let upper_growth = BESSEL_LOG_TAIL_E + v * (BESSEL_LOG_TAIL_F + v * (BESSEL_LOG_TAIL_G + v * BESSEL_LOG_TAIL_H));
    let lower_growth = BESSEL_LOG_TAIL_B + v * (BESSEL_LOG_TAIL_C + v * (BESSEL_LOG_TAIL_D + v * upper_growth));
    let growth = v * (BESSEL_LOG_TAIL_A + v * lower_growth);
    let constant = select(BESSEL_LOW_LOG, BESSEL_HIGH_LOG, powers.high);
    let exponent = (powers.exponent - 127u32) as f32;
    let half_log = exponent * BESSEL_HALF_LN_TWO + (constant + (logarithm - growth));
    let near = select(head, middle, y >= BESSEL_HEAD_END);
    select(near, y - half_log, y >= BESSEL_BORDER)
}

/// Returns I1(x)/I0(x), to 2 units of the last place.
///
/// Any x; odd; x/2 near 0, 1 - 1/(2x) far from it. The derivative of [`log_bessel_izero`].
#[inline(always)]
#[must_use]
pub fn bessel_ratio(x: f32) -> f32 {
    let y = abs(x);
    // Head: the leading term is the larger one.
    let bounded = min(y, BESSEL_HEAD_END);
    let u = bounded * bounded;
    let bend = BESSEL_RATIO_HEAD_A
        + u * (BESSEL_RATIO_HEAD_B + u * (BESSEL_RATIO_HEAD_C + u * (BESSEL_RATIO_HEAD_D + u * BESSEL_RATIO_HEAD_E)));
    let head = bounded * (0.5 + u * bend);
    // Middle: two pieces.
    let middle_y = min(y, BESSEL_BORDER);
    let second = middle_y >= BESSEL_RATIO_FIRST_END;
    let centre = select(BESSEL_RATIO_FIRST_CENTRE, BESSEL_RATIO_SECOND_CENTRE, second);
    let value = select(BESSEL_RATIO_FIRST_VALUE, BESSEL_RATIO_SECOND_VALUE, second);
    let pa = select(BESSEL_RATIO_FIRST_A, BESSEL_RATIO_SECOND_A, second);
    let pb = select(BESSEL_RATIO_FIRST_B, BESSEL_RATIO_SECOND_B, second);
    let pc = select(BESSEL_RATIO_FIRST_C, BESSEL_RATIO_SECOND_C, second);
    let pd = select(BESSEL_RATIO_FIRST_D, BESSEL_RATIO_SECOND_D, second);
    let pe = select(BESSEL_RATIO_FIRST_E, BESSEL_RATIO_SECOND_E, second);
    let pf = select(BESSEL_RATIO_FIRST_F, BESSEL_RATIO_SECOND_F, second);
    let pg = select(BESSEL_RATIO_FIRST_G, BESSEL_RATIO_SECOND_G, second);
    let ph = select(0.0, BESSEL_RATIO_SECOND_H, second);
    let d = middle_y - centre;
    let upper = pd + d * (pe + d * (pf + d * (pg + d * ph)));
    let middle = value + d * (pa + d * (pb + d * (pc + d * upper)));
    // Tail.
    let v = 1.0 / max(y, BESSEL_BORDER);
    let top = BESSEL_RATIO_TAIL_H + v * (BESSEL_RATIO_TAIL_I + v * BESSEL_RATIO_TAIL_J);
    let upper_tail = BESSEL_RATIO_TAIL_E + v * (BESSEL_RATIO_TAIL_F + v * (BESSEL_RATIO_TAIL_G + v * top));
    let lower_tail = BESSEL_RATIO_TAIL_B + v * (BESSEL_RATIO_TAIL_C + v * (BESSEL_RATIO_TAIL_D + v * upper_tail));
    let tail = 1.0 - v * (BESSEL_RATIO_TAIL_A + v * lower_tail);
    let near = select(head, middle, y >= BESSEL_HEAD_END);
    odd_continuation(x, select(near, tail, y >= BESSEL_BORDER))
}
