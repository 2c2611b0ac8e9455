//! Inverse elementary functions of the f32 kernels: logarithms, and the angle of a point.

use super::coefficients::*;
use super::elementary::*;
use super::gpu::{abs, bits_of, from_bits, max, min, select};
use super::sinc_squared_integral::ARC_PI;
use super::sine_integral::HALF_PI;
use super::spatial_phase::INVERSE_ROOT_TWO;

/// pi/4.
pub(super) const QUARTER_PI: f32 = 0.7853982;
/// tan(pi/8).
pub(super) const TANGENT_SPLIT: f32 = 0.41421357;
/// The smallest random number that counts, 2^-25.
pub(super) const SHARE_SMALLEST_LIMIT: f32 = 2.9802322e-8;

/// Returns 2 artanh s, for |s| <= 0.172, to f32 grade.
#[inline(always)]
pub(super) fn artanh_twice(s: f32) -> f32 {
    let u = s * s;
    let series = u * (ARTANH_A + u * (ARTANH_B + u * ARTANH_C));
    (s + s) + s * series
}

/// Returns ln x for a normal x > 0, to f32 grade.
#[inline(always)]
pub(super) fn natural_log(x: f32) -> f32 {
    let bits = bits_of(x);
    let fraction = from_bits((bits & 0x007fffffu32) | 0x3f000000u32);
    let small = fraction < INVERSE_ROOT_TWO;
    let m = select(fraction, fraction + fraction, small);
    let e = (bits >> 23u32) as f32 - select(126.0, 127.0, small);
    e * LN_TWO_HIGH + (e * LN_TWO_LOW + artanh_twice((m - 1.0) / (m + 1.0)))
}

/// Returns ln(1 - a) for 0 <= a < 1, to f32 grade also for the smallest a.
#[inline(always)]
pub(super) fn log_one_minus(a: f32) -> f32 {
    let bounded = min(a, 0.29);
    let near = artanh_twice(-bounded / (2.0 - bounded));
    select(natural_log(max(1.0 - a, SHARE_SMALLEST_LIMIT)), near, a < 0.29)
}

/// Returns the angle of (x, y) from the first axis, for y >= 0: from 0 to pi, to f32 grade.
#[inline(always)]
pub(super) fn angle_from_axis(x: f32, y: f32) -> f32 {
    let size = abs(x);
    let low = min(size, y);
    let high = max(size, y);
    let split = low > TANGENT_SPLIT * high;
    let t = select(low, low - high, split) / select(high, low + high, split);
    let u = t * t;
    let series = u * (ARCTANGENT_A + u * (ARCTANGENT_B + u * (ARCTANGENT_C + u * ARCTANGENT_D)));
    let eighth = (t - t * series) + select(0.0, QUARTER_PI, split);
    let quarter = select(eighth, HALF_PI - eighth, y > size);
    select(quarter, ARC_PI - quarter, x < 0.0)
}
