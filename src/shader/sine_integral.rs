//! The sine integral in f32, in four grades.
//!
//! Si of VWH18 Eq. 28. A polynomial below a border, pi/2 - f cos x - g sin x above it, with the auxiliary functions
//! f and g (DLMF 6.2.17-18) as one rational function, so that a call costs one division.

use super::coefficients::*;
use super::elementary::*;
use super::gpu::{abs, min, select};

/// pi/2 as an f32.
pub(super) const HALF_PI: f32 = 1.5707964;
/// Squares beyond this change nothing in the ratio of two polynomials.
pub(super) const SQUARE_LIMIT: f32 = 16777216.0;

/// Returns Si(x), the integral of sin t / t from 0 to x (radians), to f32 grade.
///
/// Any x; odd. VWH18 Eq. 28.
#[inline(always)]
#[must_use]
pub fn sine_integral(x: f32) -> f32 {
    let y = abs(x);
    let u = y * y;
    let q = SI_HEAD_A + u * (SI_HEAD_B + u * (SI_HEAD_C + u * (SI_HEAD_D + u * (SI_HEAD_E + u * SI_HEAD_F))));
    let head = y + y * (u * q);
    let bounded = min(y, PHASE_LIMIT);
    let turns = reduce_half_turns(bounded);
    let near = sine_cosine_near(turns.rest);
    let s = min(u, SQUARE_LIMIT);
    let n = s * (s * (s * (s + SI_F_A) + SI_F_B) + SI_F_C) + SI_F_D;
    let d = s * (s * (s * (s + SI_D_A) + SI_D_B) + SI_D_C) + SI_D_D;
    let m = s * (s * (s + SI_G_A) + SI_G_B) + SI_G_C;
    let wave = (near.cosine * n + (near.sine * bounded) * m) / (bounded * d);
    let tail = HALF_PI - turns.parity * wave;
    let value = select(tail, head, y < SI_BORDER);
    let finite = select(value, HALF_PI, y >= PHASE_LIMIT);
    odd_continuation(x, finite)
}

/// Returns Si(x) to 1e-5 absolute. Any x; odd. VWH18 Eq. 28.
#[inline(always)]
#[must_use]
pub fn sine_integral_medium(x: f32) -> f32 {
    let y = abs(x);
    let u = y * y;
    let q = SI_MEDIUM_HEAD_A
        + u * (SI_MEDIUM_HEAD_B + u * (SI_MEDIUM_HEAD_C + u * (SI_MEDIUM_HEAD_D + u * SI_MEDIUM_HEAD_E)));
    let head = y + y * (u * q);
    let bounded = min(y, PHASE_LIMIT);
    let turns = reduce_half_turns(bounded);
    let near = sine_cosine_near_medium(turns.rest);
    let s = min(u, SQUARE_LIMIT);
    let n = s * (s + SI_MEDIUM_F_A) + SI_MEDIUM_F_B;
    let d = s * (s + SI_MEDIUM_D_A) + SI_MEDIUM_D_B;
    let m = s + SI_MEDIUM_G_A;
    let wave = (near.cosine * n + (near.sine * bounded) * m) / (bounded * d);
    let tail = HALF_PI - turns.parity * wave;
    let value = select(tail, head, y < SI_MEDIUM_BORDER);
    odd_continuation(x, value)
}

/// Returns Si(x) to 4e-4 absolute. Any x; odd. VWH18 Eq. 28.
#[inline(always)]
#[must_use]
pub fn sine_integral_coarse(x: f32) -> f32 {
    let y = abs(x);
    let u = y * y;
    let q = SI_COARSE_HEAD_A + u * (SI_COARSE_HEAD_B + u * (SI_COARSE_HEAD_C + u * SI_COARSE_HEAD_D));
    let head = y + y * (u * q);
    let bounded = min(y, PHASE_LIMIT);
    let turns = reduce_half_turns(bounded);
    let near = sine_cosine_near_coarse(turns.rest);
    let s = min(u, SQUARE_LIMIT);
    let wave = (near.cosine * (s + SI_COARSE_F_A) + near.sine * bounded) / (bounded * (s + SI_COARSE_D_A));
    let tail = HALF_PI - turns.parity * wave;
    let value = select(tail, head, y < SI_COARSE_BORDER);
    odd_continuation(x, value)
}

/// VWH18, below Eq. 29.
pub(super) const VELINOV_BUMP: f32 = 0.66142739;
/// VWH18, below Eq. 29.
pub(super) const VELINOV_OFFSET: f32 = 0.38272292;

/// Returns Si(x) by the fit that VWH18 publishes, Eq. 29, to 0.051 absolute.
///
/// Kept to compare with: its differences have the wrong sign over a quarter of the axis.
#[inline(always)]
#[must_use]
pub fn sine_integral_velinov(x: f32) -> f32 {
    let y = abs(x);
    let wave = sine_cosine(min(y, PHASE_LIMIT));
    let sigmoid = 1.0 - 2.0 / (exponential(2.0 * min(y, 20.0)) + 1.0);
    let offset = y - VELINOV_OFFSET;
    let value = HALF_PI * sigmoid - (VELINOV_BUMP * y) / (1.0 + offset * offset) + (1.0 - wave.cosine) / (1.0 + y);
    odd_continuation(x, value)
}
