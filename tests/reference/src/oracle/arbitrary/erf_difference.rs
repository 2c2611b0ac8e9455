//! The scaled erf difference by plain subtraction of its two ends, with enough bits that no cancellation matters; where
//! the ends lie so close that the asymptotic series cannot tell them apart, by the Taylor series of the integrand.

use super::faddeeva::{BigComplex, KEPT, multiple, reference, remainder, sum_of, two_over_root_pi};
use super::{Big, big, is_zero, magnitude};
use crate::metrics::Reference;

/// Bits of work.
const BITS: usize = 900;
/// Bits in which ends and midpoints are exact: from 2^-1074 to 2^1024.
const EXACT: usize = 2200;
/// Half length times |m + ib| up to which the integrand's series is used.
const SHORT: f64 = 0.25;
/// |a| from which exp(-a^2) counts as zero.
const NOTHING: f64 = 2000.0;

/// m and R of exp(-b^2) erfc(a + ib) = m exp(-b^2) + R at a >= 0.
fn end(a: f64, b: f64) -> (f64, BigComplex) {
    let zero = || BigComplex::new(big(0.0, BITS), big(0.0, BITS));
    if a > NOTHING {
        return (0.0, zero());
    }
    let rest = remainder(-b, a, BITS);
    let exact = big(a, BITS);
    let size = (-exact.sqr()).exp();
    let turned = turned(&rest, &(exact * big(b, BITS)));
    (multiple(-b, a), turned.scaled(&size))
}

/// z exp(-2i phase).
fn turned(z: &BigComplex, phase: &Big) -> BigComplex {
    if is_zero(phase) {
        return z.clone();
    }
    let needed = BITS + magnitude(phase).max(0) as usize + 1;
    let (sine, cosine) = (phase.clone().with_precision(needed).value() << 1).sin_cos();
    let cut = |x: Big| x.with_precision(BITS).value();
    z * &BigComplex::new(cut(cosine), -cut(sine))
}

/// (2/sqrt pi) exp(-m^2 - 2ibm) times the integral of exp(-s^2 - 2(m + ib)s) over [-d, d].
fn short(a1: f64, a2: f64, b: f64) -> BigComplex {
    let (e1, e2, eb) = (big(a1, EXACT), big(a2, EXACT), big(b, EXACT));
    let middle = (&e1 + &e2) >> 1;
    let half = (&e2 - &e1) >> 1;
    if middle.to_f64().value().abs() > NOTHING {
        return BigComplex::new(big(0.0, BITS), big(0.0, BITS));
    }
    let cut = |x: Big| x.with_precision(BITS).value();
    // Over u = s/d: int_{-1}^{1} exp(-d^2 u^2) cosh(2(m + ib) d u) du, a double series in d^2 and (2(m + ib)d)^2.
    let (square, slope) = (cut(half.sqr()), BigComplex::new(cut(&middle * &half), cut(&eb * &half)));
    let slope = (&slope * &slope).scaled(&big(4.0, BITS));
    let mut total = BigComplex::new(big(0.0, BITS), big(0.0, BITS));
    let mut outer = big(1.0, BITS);
    for j in 0..300u32 {
        let mut term = BigComplex::new(outer.clone(), big(0.0, BITS));
        for k in 0..300u32 {
            total = sum_of(
                &total,
                &term.scaled(&(big(2.0, BITS) / big(f64::from(2 * (j + k) + 1), BITS))),
            );
            let steps = f64::from(2 * k + 1) * f64::from(2 * k + 2);
            term = (&term * &slope).scaled(&(big(1.0, BITS) / big(steps, BITS)));
            let size = [&term.re, &term.im].map(|x| if is_zero(x) { isize::MIN } else { magnitude(x) });
            if size[0].max(size[1]) < -(BITS as isize) {
                break;
            }
        }
        outer = -(outer * &square) / big(f64::from(j + 1), BITS);
        if is_zero(&outer) || magnitude(&outer) < -(BITS as isize) {
            break;
        }
    }
    let size = cut(-middle.sqr()).exp() * cut(half) * two_over_root_pi(BITS);
    turned(&total, &(middle * eb)).scaled(&size)
}

/// exp(-b^2) [erf(a2 + ib) - erf(a1 + ib)] for finite b and ends that are no NaN.
pub fn erf_difference_scaled(a1: f64, a2: f64, b: f64) -> [Reference; 2] {
    if a1 == a2 {
        return [Reference::exact(0.0); 2];
    }
    let half = 0.5 * a2 - 0.5 * a1;
    if half.is_finite() && half.abs() < 1.0 && half.abs() * (0.5 * a1 + 0.5 * a2).hypot(b) < SHORT {
        let value = short(a1, a2, b);
        return [value.re, value.im].map(|x| reference(&x.with_precision(KEPT).value()));
    }
    // exp(-b^2) erfc(-a + ib) = 2 exp(-b^2) - conj of that at a.
    let signed = |a: f64| {
        let (m, rest) = end(a.abs(), b);
        if a < 0.0 {
            (2.0 - m, BigComplex::new(-rest.re, rest.im))
        } else {
            (m, rest)
        }
    };
    let ((m1, r1), (m2, r2)) = (signed(a1), signed(a2));
    let count = m1 - m2;
    let mut value = &r1 - &r2;
    if count != 0.0 && b.abs() < NOTHING {
        let gaussian = (-big(b, BITS).sqr()).exp() * big(count, BITS);
        value = sum_of(&value, &BigComplex::new(gaussian, big(0.0, BITS)));
    }
    let cut = |x: Big| x.with_precision(KEPT).value();
    [reference(&cut(value.re)), reference(&cut(value.im))]
}
