//! Phases as ratios of lengths: a b/c in turns, whole turns apart, in f32.
//!
//! A phase of a scratch is a length over a wavelength times a direction cosine: thousands of turns, of which only the
//! fraction counts. The nearest integer k is found first, then a b - k c from partial products that are exact, so that
//! nothing is lost to the size of the phase.

use super::elementary::*;
use super::faddeeva::leading_bits;
use super::gpu::{abs, max, min, round, select};

/// Up to this many turns a sinc is 1 in f32.
pub(super) const SINC_TURNS_LIMIT: f32 = 0.00001;

/// A number of turns in two parts, whose sum it is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Turns {
    /// Whole turns.
    pub(super) whole: f32,
    /// What is left of them, half a turn at most but for rounding.
    pub(super) rest: f32,
}

/// Returns a b/c in turns.
///
/// The partial products are exact for |a b/c| to 4096; beyond, the error of the rest grows as 2^-35 |a b/c|.
#[inline(always)]
pub(super) fn ratio_turns(a: f32, b: f32, c: f32) -> Turns {
    let whole = round(a * b / c);
    let a_high = leading_bits(a);
    let b_high = leading_bits(b);
    let c_high = leading_bits(c);
    let whole_high = leading_bits(whole);
    // The bounds change nothing; they keep a compiler that reorders sums from joining the large terms to the small.
    let leading = min(max(a_high * b_high - whole_high * c_high, -PHASE_LIMIT), PHASE_LIMIT);
    let given = a_high * (b - b_high) + (a - a_high) * b;
    let taken = whole_high * (c - c_high) + (whole - whole_high) * c;
    Turns {
        whole,
        rest: (leading + (given - taken)) / c,
    }
}

/// Returns sin(2 pi t)/(2 pi t) from t and from its sine.
#[inline(always)]
pub(super) fn sinc_turns(turns: Turns, sine: f32) -> f32 {
    let total = turns.whole + turns.rest;
    select(sine / (TWO_PI * total), 1.0, abs(total) < SINC_TURNS_LIMIT)
}
