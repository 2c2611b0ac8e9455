//! w in the quadrant x >= 0, y >= 0: five regions, each of one formula with real coefficients.
//!
//! With zeta = -i z = y - i x, w(z) = erfcx(zeta) is real on the real zeta axis. f stands for sqrt(pi) zeta w - 1, which
//! is small far out, so that w = (y + i x)(1 + f)/(sqrt(pi) |z|^2) has almost the error of its factors alone.

use super::super::faddeeva_tables::{
    DAWSON, DAWSON_CELLS, DAWSON_LOW, INNER, MIDDLE, MIDDLE_MAP, OUTER, OUTER_MAP, TAIL, W_OF_I,
};
use crate::numeric::ROUND;
use crate::numeric::complex_polynomial::{Pair, chain, in_four, in_two, product, square, sum};
use crate::numeric::exponential::{exponential, exponential_in_range};
use crate::numeric::phase::{sine_cosine, two_sum};

/// Below this height beside the real axis w is exp(-z^2) plus a multiple of Dawson's integral.
pub(crate) const EDGE: f64 = 0.5;
/// x below which w is expanded about i, beside the real axis too.
pub(crate) const START: f64 = 0.75;
/// |z|^2 from which the asymptotic form holds.
pub(crate) const FAR: f64 = 49.0;
/// |z|^2 where the two rings meet.
pub(crate) const MIDDLE_END: f64 = 6.25;
/// x^2 + y^2 + x^2/4 below which w is expanded about i.
pub(crate) const NEAR: f64 = 1.96;
/// Height from which exp(-x^2) is lost beside the real part of the asymptotic form.
const HIGH: f64 = 1.0 / 1024.0;
/// The same from x = 8 on.
const LOW: f64 = 1.0 / 1073741824.0;
/// x from which exp(-x^2) is zero.
const AXIS_END: f64 = 28.0;
/// 1/sqrt(pi), and what its rounding left out as a share of it.
const INVERSE_SQRT_PI: [f64; 2] = [0.5641895835477563, 1.3590697223380941e-17];
/// sqrt(pi).
const SQRT_PI: f64 = 1.772453850905516;
/// 2^500: from here on squares are taken of numbers 2^540 times smaller.
pub(crate) const HUGE: f64 = f64::from_bits((1023 + 500) << 52);
/// 2^-540.
const SHRINK: f64 = f64::from_bits((1023 - 540) << 52);

/// Returns w(x + i y) for finite x >= 0, y >= 0.
#[inline]
pub(crate) fn quadrant(x: f64, y: f64) -> Pair {
    let size = x * x + y * y;
    if size >= FAR {
        far(x, y)
    } else if y < EDGE && x >= START {
        beside_the_axis(x, y)
    } else if size + 0.25 * (x * x) < NEAR {
        inner(x, y)
    } else if size < MIDDLE_END {
        middle(x, y)
    } else {
        outer(x, y)
    }
}

/// The square of x in two parts.
#[inline(always)]
pub(crate) fn square_parts(x: f64) -> (f64, f64) {
    let high = f64::from_bits(x.to_bits() & !0x07ff_ffff);
    (high * high, (x - high) * (x + high))
}

/// Returns 1/(sqrt(pi) |z|^2) without the rounding of |z|^2.
#[inline(always)]
fn inverse_size(x: f64, y: f64) -> f64 {
    let ((x_high, x_low), (y_high, y_low)) = (square_parts(x), square_parts(y));
    let (high, low) = two_sum(x_high, y_high);
    let low = low + (x_low + y_low);
    let size = high + low;
    let low = (high - size) + low;
    let inverse = INVERSE_SQRT_PI[0] / size;
    inverse + inverse * (INVERSE_SQRT_PI[1] - low * inverse * SQRT_PI)
}

/// Returns (y + i x)(1 + f) times 1/(sqrt(pi) |z|^2), which is `inverse`.
#[inline(always)]
fn from_deviation(x: f64, y: f64, f: Pair, inverse: f64) -> Pair {
    ((y + (y * f.0 - x * f.1)) * inverse, (x + (x * f.0 + y * f.1)) * inverse)
}

/// f for |z| >= 7, less the jump of exp(-z^2) at the real axis, by a polynomial in u = 1/z^2.
#[inline(always)]
fn far_deviation(x: f64, y: f64) -> Pair {
    let inverse = 1.0 / (x * x + y * y);
    let (p, q) = (x * inverse, y * inverse);
    let u = ((p - q) * (p + q), -2.0 * (p * q));
    product(u, in_two::<{ TAIL.len() }>(|k| TAIL[k], u))
}

/// The asymptotic form, for |z| >= 7, less exp(-z^2) near the real axis.
#[inline(always)]
pub(crate) fn asymptotic(x: f64, y: f64) -> Pair {
    let scale = if x.max(y) >= HUGE { SHRINK } else { 1.0 };
    let (x, y) = (x * scale, y * scale);
    let f = if scale < 1.0 { (0.0, 0.0) } else { far_deviation(x, y) };
    let (re, im) = from_deviation(x, y, f, inverse_size(x, y));
    (re * scale, im * scale)
}

/// w for |z| >= 7.
#[inline(always)]
pub(crate) fn far(x: f64, y: f64) -> Pair {
    let (re, im) = asymptotic(x, y);
    (re + axis_remainder(x, y), im)
}

/// exp(-x^2) where it counts beside the real part of the asymptotic form.
#[inline(always)]
pub(crate) fn axis_remainder(x: f64, y: f64) -> f64 {
    if y < HIGH && x < AXIS_END && (x < 8.0 || y < LOW) {
        let (high, low) = square_parts(x);
        exponential(-high, -low)
    } else {
        0.0
    }
}

/// (2/sqrt pi) D(z) with Dawson's integral D, for y < 1/2 and |z| < 7.
#[inline(always)]
pub(crate) fn dawson_cell(x: f64, y: f64) -> Pair {
    let rounded = 4.0 * x + ROUND;
    let cell = (rounded.to_bits() & (DAWSON_CELLS as u64 - 1)) as usize;
    let d = (x - (rounded - ROUND) * 0.25, y);
    let d2 = square(d);
    // The even powers from the second on, and the odd ones.
    let c = |k: usize| DAWSON[k][cell];
    let even = product(d2, chain::<{ DAWSON.len() }, 2, 2>(c, d2));
    let odd = product(d, chain::<{ DAWSON.len() }, 1, 2>(c, d2));
    let rest = sum(even, odd);
    (DAWSON[0][cell] + (DAWSON_LOW[cell] + rest.0), rest.1)
}

/// exp(-z^2) for y < 1/2 and x < 7, its phase right where its size counts beside w.
#[inline(always)]
fn gaussian(x: f64, y: f64) -> Pair {
    let (high, low) = square_parts(x);
    let size = exponential_in_range(-high, y * y - low);
    // The half angle stays below pi/2 as long as the size counts.
    let (sine, cosine) = sine_cosine(x * y);
    (size - size * (2.0 * (sine * sine)), -size * (2.0 * (sine * cosine)))
}

/// w for y < 1/2 and |z| < 7.
#[inline(always)]
pub(crate) fn beside_the_axis(x: f64, y: f64) -> Pair {
    let (re, im) = dawson_cell(x, y);
    let gaussian = gaussian(x, y);
    (gaussian.0 - im, gaussian.1 + re)
}

/// w for 5/4 x^2 + y^2 < 1.96, and y >= 1/2 or x < 3/4.
#[inline(always)]
pub(crate) fn inner(x: f64, y: f64) -> Pair {
    let d = y + 5.0;
    let inverse = 1.0 / (d * d + x * x);
    let v = (((y - 1.0) * d + x * x) * inverse, -(6.0 * x) * inverse);
    let (re, im) = product((y - 1.0, -x), in_two::<{ INNER.len() }>(|k| INNER[k], v));
    (W_OF_I[0] + (W_OF_I[1] + re), im)
}

/// f in a ring, of coefficients and map.
#[inline(always)]
fn ring_deviation<const N: usize>(coefficients: &[f64; N], [centre, pole]: [f64; 2], x: f64, y: f64) -> Pair {
    let d = y + pole;
    let inverse = 1.0 / (d * d + x * x);
    let q = (d * inverse, x * inverse);
    let v = (((y - centre) * d + x * x) * inverse, -(centre + pole) * q.1);
    product(in_four(coefficients, v), square(q))
}

/// w for 1.16 <= |z| < 2.5 and y >= 1/2.
#[inline(always)]
pub(crate) fn middle(x: f64, y: f64) -> Pair {
    from_deviation(x, y, ring_deviation(&MIDDLE, MIDDLE_MAP, x, y), inverse_size(x, y))
}

/// w for 2.5 <= |z| < 7 and y >= 1/2.
#[inline(always)]
pub(crate) fn outer(x: f64, y: f64) -> Pair {
    from_deviation(x, y, ring_deviation(&OUTER, OUTER_MAP, x, y), inverse_size(x, y))
}

/// (2/sqrt pi) D(z) with Dawson's integral D, for y < 1/2.
#[inline]
pub(crate) fn dawson(x: f64, y: f64) -> Pair {
    if x * x + y * y < FAR {
        dawson_cell(x, y)
    } else {
        let (re, im) = asymptotic(x, y);
        // D = (i sqrt(pi)/2)(exp(-z^2) - w), and the asymptotic form leaves the exponential out.
        (im, -re)
    }
}

/// f = sqrt(pi) zeta w - 1 for |z| >= 1.16.
#[inline]
pub(crate) fn deviation(x: f64, y: f64) -> Pair {
    let size = x * x + y * y;
    if size < MIDDLE_END {
        return ring_deviation(&MIDDLE, MIDDLE_MAP, x, y);
    }
    if size < FAR {
        return ring_deviation(&OUTER, OUTER_MAP, x, y);
    }
    if x.max(y) >= HUGE {
        // 1/(2 z^2), of a number 2^540 times smaller.
        let (x, y) = (x * SHRINK, y * SHRINK);
        let inverse = SHRINK / (x * x + y * y);
        let (p, q) = (x * inverse, y * inverse);
        return (0.5 * ((p - q) * (p + q)), -(p * q));
    }
    let f = far_deviation(x, y);
    // sqrt(pi) zeta exp(-x^2)
    let remainder = SQRT_PI * axis_remainder(x, y);
    sum(f, (y * remainder, -x * remainder))
}
