//! The difference of two complex error functions on a horizontal line, scaled, in f32.
//!
//! G = exp(-b^2) (erf(c + i b) - erf(a + i b)) is the Fourier integral of a Gaussian over the segment from a to c: |G| is
//! at most its value at b = 0. Written with P(a) = exp(-a^2) exp(-2 i a b) w(-b + i a) for a >= 0, in which exp(b^2) has
//! cancelled and w is taken in the upper half plane only, and P(-a) = conj P(a): each end gives P or 2 exp(-b^2) - P.
//! Short segments, where two ends would cancel, are the value at the middle times a series in the length.
//!
//! Phases are products a b: they are kept in turns, from exact partial products or from the caller.

use super::elementary::*;
use super::faddeeva::*;
use super::gpu::{abs, max, min, round, select};

/// Nothing is left of exp(-a^2) from here on.
pub(super) const ERF_END_LARGEST: f32 = 12.0;
/// Half lengths up to this are short, if the next bound holds too.
pub(super) const ERF_SHORT: f32 = 0.5;
/// Largest square of the half length times the distance of the middle from 0, of short segments.
pub(super) const ERF_SHORT_SQUARE: f32 = 0.0625;
/// 2/sqrt(pi).
pub(super) const TWO_INVERSE_ROOT_PI: f32 = 1.1283792;

/// Returns exp(-a^2 - rest) for a from 0 to 12, or what is left of it.
#[inline(always)]
pub(super) fn erf_gaussian(a: f32, rest: f32) -> f32 {
    let high = leading_bits(a);
    let square = high * high;
    let low = (a - high) * (a + high) + rest;
    let power = power_of_e(
        max(-square, EXPONENT_LOWEST),
        select(-low, 0.0, square > -EXPONENT_LOWEST),
    );
    (power.mantissa * power.first) * power.second
}

/// Returns P(a), for a >= 0, and its conjugate continuation for a < 0.
#[inline(always)]
pub(super) fn erf_end(a: f32, b: f32, turns: f32) -> Complex {
    let size = abs(a);
    let height = abs(b);
    let nothing = size > ERF_END_LARGEST || height > INFINITE_LIMIT;
    let phase = sine_cosine_turns(select(turns, 0.0, nothing));
    let gaussian = erf_gaussian(min(size, ERF_END_LARGEST), 0.0);
    let w = faddeeva_quadrant(height, size);
    let im = select(-w.im, w.im, (a < 0.0) != (b < 0.0));
    Complex {
        re: gaussian * (w.re * phase.cosine + im * phase.sine),
        im: gaussian * (im * phase.cosine - w.re * phase.sine),
    }
}

/// Returns the integral of exp(-s^2 - 2 (m + i b) s) over |s| <= d as a multiple of 2 d, for short segments.
///
/// The Taylor series in q = (m + i b)^2 d^2 and d^2.
#[inline(always)]
pub(super) fn erf_short_series(middle: f32, b: f32, halved: f32) -> Complex {
    let d = halved * halved;
    let across = halved * middle;
    let along = halved * b;
    let q_re = (across - along) * (across + along);
    let q_im = (across + across) * along;
    let k = 1.0 + d * (-0.33333334 + d * (0.1 + d * (-0.023809524 + d * (0.0046296297 - d * 0.00075757576))));
    let l = 0.6666667 + d * (-0.4 + d * (0.14285715 + d * (-0.037037037 + d * 0.007575758)));
    let m = 0.13333334 + d * (-0.0952381 + d * 0.037037037);
    let n = 0.012698413 - d * 0.009876543;
    let first_re = m + q_re * n;
    let first_im = q_im * n;
    let second_re = l + (q_re * first_re - q_im * first_im);
    let second_im = q_re * first_im + q_im * first_re;
    Complex {
        re: k + (q_re * second_re - q_im * second_im),
        im: q_re * second_im + q_im * second_re,
    }
}

/// Returns exp(-b^2) (erf(`a_to` + i b) - erf(`a_from` + i b)) with the phases a b/pi given apart, in turns.
///
/// `turns_from` and `turns_to` are `a_from` b/pi and `a_to` b/pi, whole turns taken off or not: a scene that knows its
/// lengths in wavelengths loses nothing to the size of the phase. All five are dimensionless. Errors are 1e-5 of the
/// value at b = 0 at most, as long as that is a normal number. An infinite end takes any turns; an infinite b gives 0;
/// equal ends give 0; swapped ends negate exactly. VWH18 Eq. 5.
#[inline(always)]
#[must_use]
pub fn erf_difference_scaled_turns(a_from: f32, a_to: f32, b: f32, turns_from: f32, turns_to: f32) -> Complex {
    let extent = a_to - a_from;
    let halved = 0.5 * extent;
    // The short form begins at the end nearer to 0.
    let nearer_to = abs(a_to) < abs(a_from);
    let base = select(a_from, a_to, nearer_to);
    let stride = select(halved, -halved, nearer_to);
    let middle = base + stride;
    let across = halved * middle;
    let along = halved * b;
    let is_short = abs(halved) <= ERF_SHORT && across * across + along * along <= ERF_SHORT_SQUARE;
    let apart = select(turns_to - turns_from, turns_from - turns_to, nearer_to);
    let turns = select(turns_from, turns_to, nearer_to) + 0.5 * (apart - round(apart));
    let phase = sine_cosine_turns(turns);
    let rest = stride * ((base + base) + stride);
    let scale = (TWO_INVERSE_ROOT_PI * extent) * erf_gaussian(min(abs(base), ERF_END_LARGEST), rest);
    let series = erf_short_series(middle, b, halved);
    let short_re = scale * (series.re * phase.cosine + series.im * phase.sine);
    let short_im = scale * (series.im * phase.cosine - series.re * phase.sine);

    let first = erf_end(a_from, b, turns_from);
    let last = erf_end(a_to, b, turns_to);
    let side_from = select(1.0, -1.0, a_from < 0.0);
    let side_to = select(1.0, -1.0, a_to < 0.0);
    let between = (side_to - side_from) * erf_gaussian(min(abs(b), ERF_END_LARGEST), 0.0);
    let long_re = between + (side_from * first.re - side_to * last.re);
    let long_im = side_from * first.im - side_to * last.im;

    let is_empty = a_from == a_to && abs(b) >= 0.0;
    Complex {
        re: select(select(long_re, short_re, is_short), 0.0, is_empty),
        im: select(select(long_im, short_im, is_short), 0.0, is_empty),
    }
}

/// Returns exp(-b^2) (erf(`a_to` + i b) - erf(`a_from` + i b)), the three dimensionless.
///
/// As [`erf_difference_scaled_turns`], with the phases formed from exact partial products: they hold to 1e-6 for |a b| to
/// 1e4, and lose digits in proportion beyond.
#[inline(always)]
#[must_use]
pub fn erf_difference_scaled(a_from: f32, a_to: f32, b: f32) -> Complex {
    erf_difference_scaled_turns(a_from, a_to, b, product_turns(a_from, b), product_turns(a_to, b))
}
