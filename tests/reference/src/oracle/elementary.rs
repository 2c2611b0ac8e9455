//! Sine, cosine and exponential in double-double.

use super::double_double::Dd;
use super::reduction::{INVERSE_FACTORIAL, sin_cos};
use crate::metrics::Reference;

/// ln 2.
const LN_TWO: Dd = Dd::new(std::f64::consts::LN_2, 2.3190468138462996e-17);
/// Last power of the series of the exponential: (ln 2 / 2)^26 / 26! is below 2^-126.
const LAST: usize = 26;

/// sin x; the sign of a zero kept, NaN at the infinities.
pub fn sine(x: f64) -> Reference {
    if !x.is_finite() {
        return Reference::exact(f64::NAN);
    }
    // Below, x itself is the sine to 2^-106, and its square would underflow.
    if x.abs() < 1e-16 {
        return Reference::exact(x);
    }
    sin_cos(x).0.into()
}

/// cos x; NaN at the infinities.
pub fn cosine(x: f64) -> Reference {
    if !x.is_finite() {
        return Reference::exact(f64::NAN);
    }
    sin_cos(x).1.into()
}

/// e to the x: 2^n times the Taylor series of what is left of x without n ln 2.
pub fn exponential(x: f64) -> Reference {
    if x.is_nan() || x == f64::INFINITY {
        return Reference::exact(x);
    }
    if x == f64::NEG_INFINITY {
        return Reference::exact(0.0);
    }
    // Far beyond the range of every format, so that n stays a small integer.
    let x = x.clamp(-1e6, 1e6);
    let n = (x / std::f64::consts::LN_2).round();
    let r = Dd::from(x) - LN_TWO * n;
    let mut sum = INVERSE_FACTORIAL[LAST];
    for k in (0..LAST).rev() {
        sum = sum * r + INVERSE_FACTORIAL[k];
    }
    Reference {
        hi: sum.hi,
        lo: sum.lo,
        exponent: n as i32,
    }
}
