//! The same truths by arbitrary precision: the power series of Si and its asymptotic counterpart, and the arc as a plain
//! difference of antiderivatives with enough bits that the cancellation does not matter. Slow (up to milliseconds). The
//! complex functions and the Bessel functions have modules of their own.

pub mod bessel;
pub mod erf_difference;
pub mod faddeeva;

use crate::metrics::Reference;
use dashu_float::{FBig, round::mode::HalfEven};

type Big = FBig<HalfEven, 2>;

/// Bits kept in every result. An arc one ulp long at a zero of the integrand is 2^-160 of the antiderivative.
const BITS: usize = 400;
/// Argument of Si from which the asymptotic series is used; its smallest term there is e^-400, about 2^-577.
const ASYMPTOTIC_START: f64 = 400.0;
/// Bits that the series of Si needs at most.
const MOST_BITS: usize = BITS + 20 + (1.5 * ASYMPTOTIC_START) as usize;

fn big(x: f64, bits: usize) -> Big {
    Big::try_from(x).expect("finite").with_precision(bits).value()
}

fn reference(x: &Big) -> Reference {
    let rounded = x.to_f64().value();
    if rounded == 0.0 && is_zero(x) {
        return Reference::exact(0.0);
    }
    let exponent = if rounded.abs() < 1e-200 { -600 } else { 0 };
    let x = x.clone() << (-exponent);
    let hi = x.to_f64().value();
    let lo = (x - big(hi, BITS)).to_f64().value();
    Reference {
        hi,
        lo,
        exponent: exponent as i32,
    }
}

/// Si(x) for finite x >= 0.
fn sine_integral_big(x: f64) -> Big {
    sine_integral_of(&big(x, MOST_BITS))
}

/// Si(x) for x >= 0 of any precision.
fn sine_integral_of(x: &Big) -> Big {
    let size = x.to_f64().value();
    if size >= ASYMPTOTIC_START {
        let half_pi = Big::pi(BITS) / big(2.0, BITS);
        return half_pi - sine_integral_tail(x);
    }
    // The largest term is about e^x/x^2: that many bits more.
    let bits = BITS + 20 + (1.5 * size) as usize;
    let x = x.clone().with_precision(bits).value();
    let square = x.sqr();
    let mut power = x.clone();
    let mut sum = x.clone();
    let mut n = 1u32;
    loop {
        let factor = big(f64::from(2 * n) * f64::from(2 * n + 1), bits);
        power = -(power * &square / factor);
        let term = &power / big(f64::from(2 * n + 1), bits);
        if is_zero(&term) || magnitude(&term) < magnitude(&sum) - bits as isize {
            return sum;
        }
        sum += term;
        n += 1;
    }
}

fn is_zero(x: &Big) -> bool {
    x.repr().digits() == 0 || x.repr().significand() == &dashu_int::IBig::ZERO
}

/// Binary exponent of a number other than zero.
fn magnitude(x: &Big) -> isize {
    x.repr().exponent() + x.repr().digits() as isize
}

/// pi/2 - Si(x) = f cos x + g sin x for large finite x, to 2^-BITS of 1/x.
fn sine_integral_tail(x: &Big) -> Big {
    let x = x.clone().with_precision(BITS).value();
    let (sine, cosine) = x.sin_cos();
    let inverse = big(1.0, BITS) / x;
    // Terms k!/x^(k+1) with signs + + - - for cos, sin, cos, sin.
    let mut term = inverse.clone();
    let mut total = big(0.0, BITS);
    for k in 0..400u32 {
        let part = &term * (if k % 2 == 0 { &cosine } else { &sine });
        total = if k % 4 < 2 { total + part } else { total - part };
        term = term * &inverse * big(f64::from(k + 1), BITS);
        if magnitude(&term) < magnitude(&inverse) - BITS as isize {
            break;
        }
    }
    total
}

/// Si(x) for any f64.
pub fn sine_integral(x: f64) -> Reference {
    if x.is_nan() || x == 0.0 {
        return Reference::exact(x);
    }
    let value = if x.is_infinite() {
        reference(&(Big::pi(BITS) / big(2.0, BITS)))
    } else {
        reference(&sine_integral_big(x.abs()))
    };
    if x < 0.0 { -value } else { value }
}

/// The integral of sinc^2 from 0 to finite q >= 0: Si(2q) - sin^2(q)/q.
fn antiderivative(q: f64) -> Big {
    antiderivative_of(&big(q, MOST_BITS))
}

/// The same for q >= 0 of any precision.
fn antiderivative_of(q: &Big) -> Big {
    if is_zero(q) {
        return big(0.0, BITS);
    }
    let exact = q.clone().with_precision(2 * BITS).value();
    sine_integral_of(&(q.clone() << 1)).with_precision(BITS + 20).value() - exact.sin().sqr() / exact
}

/// The integral of sinc^2 from q >= 200 to infinity, q halved once where 2q would overflow.
fn tail(q: f64) -> Big {
    if q.is_infinite() {
        return big(0.0, BITS);
    }
    let exact = big(q, BITS);
    if q > 1e200 {
        // The oscillating parts are below 2^-600 of the leading term.
        return big(0.5, BITS) / exact;
    }
    sine_integral_tail(&big(2.0 * q, BITS)) + exact.sin().sqr() / exact
}

/// The integral of sinc^2 from `q0` to `q1`, any f64.
pub fn sinc_squared_integral(q0: f64, q1: f64) -> Reference {
    if q0.is_nan() || q1.is_nan() {
        return Reference::exact(f64::NAN);
    }
    if q0 == q1 {
        return Reference::exact(0.0);
    }
    if q1 < q0 {
        return -sinc_squared_integral(q1, q0);
    }
    if q0 < 0.0 && q1 <= 0.0 {
        return sinc_squared_integral(-q1, -q0);
    }
    const TAIL_START: f64 = ASYMPTOTIC_START / 2.0;
    let from_zero = |q: f64| {
        if q >= TAIL_START {
            Big::pi(BITS) / big(2.0, BITS) - tail(q)
        } else {
            antiderivative(q)
        }
    };
    if q0 < 0.0 {
        return reference(&(from_zero(-q0) + from_zero(q1)));
    }
    if q0 >= TAIL_START {
        return reference(&(tail(q0) - tail(q1)));
    }
    reference(&(from_zero(q1) - from_zero(q0)))
}

/// sin x/x for any f64.
pub fn sinc(x: f64) -> Reference {
    if x.is_nan() {
        return Reference::exact(x);
    }
    if x == 0.0 {
        return Reference::exact(1.0);
    }
    if x.is_infinite() {
        return Reference::exact(0.0);
    }
    let exact = big(x.abs(), BITS);
    reference(&(exact.sin() / exact))
}

/// The integral of sinc^2 from pi `width` `xi0` to pi `width` `xi1`, for finite numbers of which none is so large or so
/// small that a product leaves the range of f64.
pub fn sinc_squared_integral_turns(width: f64, xi0: f64, xi1: f64) -> Reference {
    let from_zero = |xi: f64| {
        let q = Big::pi(MOST_BITS) * big(width, MOST_BITS) * big(xi.abs(), MOST_BITS);
        let arc = antiderivative_of(&q);
        if xi < 0.0 { -arc } else { arc }
    };
    reference(&(from_zero(xi1) - from_zero(xi0)))
}

/// sin x for finite x.
pub fn sine(x: f64) -> Reference {
    if x == 0.0 {
        return Reference::exact(x);
    }
    reference(&big(x, BITS).sin())
}

/// cos x for finite x.
pub fn cosine(x: f64) -> Reference {
    reference(&big(x, BITS).cos())
}

/// e to the x for |x| up to some hundreds.
pub fn exponential(x: f64) -> Reference {
    reference(&big(x, BITS).exp())
}
