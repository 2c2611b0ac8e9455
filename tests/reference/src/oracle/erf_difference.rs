//! exp(-b^2) [erf(a2 + ib) - erf(a1 + ib)], to about 25 digits of its modulus.
//!
//! With w(-b + ia) = m exp(a^2 - b^2 + 2iab) + i(-b) A + a B: exp(-b^2) erfc(a + ib) = m exp(-b^2) + R(a),
//! R = exp(-a^2 - 2iab) (a B - i b A). The multiples m are integers, so the terms exp(-b^2) cancel exactly. Short
//! segments: the Taylor series of the integrand about the midpoint. Where the two ends cancel: [`arbitrary`].

use super::arbitrary;
use super::complex::Complex;
use super::double_double::{Dd, two_product, two_sum};
use super::faddeeva::{parts, phase_overflows, references};
use super::scaled::{Scaled, TWO_OVER_ROOT_PI, exponential, sin_cos, sine_quotient_and_cosine};
use crate::metrics::Reference;

/// A difference that is smaller than its terms by more bits than these is taken from the slow oracle.
const LOST_BITS: i64 = 16;
/// Ends below this have a midpoint that is no normal number.
const TINY: f64 = 1e-250;

/// exp(-b^2) [erf(a2 + ib) - erf(a1 + ib)]. NaN where an input is NaN; 0 for infinite b.
pub fn erf_difference_scaled(a1: f64, a2: f64, b: f64) -> [Reference; 2] {
    if a1.is_nan() || a2.is_nan() || b.is_nan() {
        return [Reference::exact(f64::NAN); 2];
    }
    if a1 == a2 || b.is_infinite() {
        return [Reference::exact(0.0); 2];
    }
    if a1 > a2 {
        return erf_difference_scaled(a2, a1, b).map(|part| -part);
    }
    if b < 0.0 {
        let [re, im] = erf_difference_scaled(a1, a2, -b);
        return [re, -im];
    }
    if a2 <= 0.0 {
        let [re, im] = erf_difference_scaled(-a2, -a1, b);
        return [re, -im];
    }
    match ordered(a1, a2, b) {
        Some(value) => references(value, [0.0, 0.0]),
        None => arbitrary::erf_difference::erf_difference_scaled(a1, a2, b),
    }
}

/// a1 < a2, a2 > 0, b >= 0.
fn ordered(a1: f64, a2: f64, b: f64) -> Option<[Scaled; 2]> {
    if a1.is_finite() && a2.is_finite() {
        let half = 0.5 * a2 - 0.5 * a1;
        let middle = (0.5 * a1 + 0.5 * a2).hypot(b);
        if half <= 0.5 && half * middle <= 1.0 {
            if a1.abs().max(a2) < TINY {
                return None;
            }
            return short(a1, a2, b);
        }
    }
    let (m2, [re2, im2]) = end(a2, b)?;
    let (count, [re1, im1]) = if a1 >= 0.0 {
        let (m1, r1) = end(a1, b)?;
        (m1 - m2, r1)
    } else {
        let (m1, [re, im]) = end(-a1, b)?;
        (2.0 - m1 - m2, [-re, im])
    };
    let gaussian = exponential(-two_product(b, b)) * count.into();
    let gaussian = if b > 1e6 { Scaled::ZERO } else { gaussian };
    let sum = [gaussian + re1 + -re2, im1 + -im2];
    let terms = [gaussian, re1, re2, im1, im2];
    let size = if sum[0].size() > sum[1].size() { sum[0] } else { sum[1] };
    (!size.has_lost(LOST_BITS, &terms)).then_some(sum)
}

/// m and R at one end a >= 0.
fn end(a: f64, b: f64) -> Option<(f64, [Scaled; 2])> {
    // Beyond, exp(-a^2) is below every other term or, in a difference of two such ends, below 2^-1000000.
    if a > 1e4 {
        return Some((0.0, [Scaled::ZERO; 2]));
    }
    if phase_overflows(a, b) {
        return None;
    }
    let parts = parts(b, a);
    let m = if parts.apart { 1.0 } else { 0.0 };
    let (quotient, cosine) = sine_quotient_and_cosine(a, b);
    let size = exponential(-two_product(a, a));
    let (re, im) = (size * cosine.into(), -(size * quotient * a.into() * b.into()));
    let (ab, ba) = (parts.along_y * a.into(), -(parts.along_x * b.into()));
    // (re + i im)(ab + i ba).
    Some((m, [re * ab + -(im * ba), re * ba + im * ab]))
}

/// (2/sqrt pi) exp(-m^2 - 2ibm) int_{-delta}^{delta} exp(-s^2 - 2(m + ib)s) ds.
fn short(a1: f64, a2: f64, b: f64) -> Option<[Scaled; 2]> {
    let middle = two_sum(0.5 * a2, 0.5 * a1);
    let delta = two_sum(0.5 * a2, -0.5 * a1);
    if phase_overflows(middle.hi, b) {
        return None;
    }
    let slope = Complex {
        re: middle * delta,
        im: delta * b,
    }
    .scale(-2.0);
    let curvature = delta.square().scale(-2.0);
    let one = Complex {
        re: Dd::ONE,
        im: Dd::ZERO,
    };
    let (mut before, mut term, mut sum) = (one, slope, one);
    for n in 1..60 {
        // `term` is the coefficient of (s/delta)^n.
        if n % 2 == 0 {
            sum = sum + term / f64::from(n + 1);
        }
        let pushed = Complex {
            re: before.re * curvature,
            im: before.im * curvature,
        };
        (before, term) = (term, (slope * term + pushed) / f64::from(n + 1));
    }
    let (first, second) = (two_product(2.0 * b, middle.hi), two_product(2.0 * b, middle.lo));
    let (sine, cosine) = sin_cos(&[first.hi, first.lo, second.hi, second.lo]);
    let size = exponential(-middle.square()) * (delta.scale(2.0) * TWO_OVER_ROOT_PI).into();
    let phased = Complex { re: cosine, im: -sine } * sum;
    Some([size * phased.re.into(), size * phased.im.into()])
}
