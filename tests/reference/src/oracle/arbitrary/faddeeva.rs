//! w, w', erf and erfc by the Taylor series of Dawson's integral at 0 with as many bits as cancel, and far out by the
//! asymptotic series. Slow (milliseconds).

use super::{Big, big, is_zero, magnitude};
use crate::metrics::Reference;
use std::ops::{Add, Mul, Sub};

/// Bits that a component keeps.
pub(super) const KEPT: usize = 300;
/// |z| from which the asymptotic series is used; its smallest term there is e^-156.
const FAR: f64 = 12.5;
/// Exponents of exp beyond this give zero or infinity.
const LARGEST: f64 = 1e6;

/// re + i im.
#[derive(Clone)]
pub(super) struct BigComplex {
    pub re: Big,
    pub im: Big,
}

impl BigComplex {
    pub fn new(re: Big, im: Big) -> BigComplex {
        BigComplex { re, im }
    }

    pub fn scaled(&self, factor: &Big) -> BigComplex {
        BigComplex::new(&self.re * factor, &self.im * factor)
    }

    fn divided(&self, divisor: &Big) -> BigComplex {
        BigComplex::new(&self.re / divisor, &self.im / divisor)
    }
}

impl Add for &BigComplex {
    type Output = BigComplex;
    fn add(self, b: &BigComplex) -> BigComplex {
        BigComplex::new(&self.re + &b.re, &self.im + &b.im)
    }
}

impl Sub for &BigComplex {
    type Output = BigComplex;
    fn sub(self, b: &BigComplex) -> BigComplex {
        BigComplex::new(&self.re - &b.re, &self.im - &b.im)
    }
}

impl Mul for &BigComplex {
    type Output = BigComplex;
    fn mul(self, b: &BigComplex) -> BigComplex {
        BigComplex::new(&self.re * &b.re - &self.im * &b.im, &self.re * &b.im + &self.im * &b.re)
    }
}

/// A truth with an exponent of its own where it leaves the range of f64; an infinity above it.
pub(super) fn reference(x: &Big) -> Reference {
    if is_zero(x) {
        return Reference::exact(0.0);
    }
    let size = magnitude(x);
    if size > 1025 {
        let sign = if x.clone() < big(0.0, 10) { -1.0 } else { 1.0 };
        return Reference::exact(sign * f64::INFINITY);
    }
    let exponent = if size < -598 { size - 1 } else { 0 };
    let x = x.clone() << (-exponent);
    let hi = x.to_f64().value();
    if hi.is_infinite() {
        return Reference::exact(hi);
    }
    let rest = x.with_precision(KEPT).value() - big(hi, KEPT);
    Reference {
        hi,
        lo: rest.to_f64().value(),
        exponent: exponent as i32,
    }
}

pub(super) fn references(z: &BigComplex) -> [Reference; 2] {
    [reference(&z.re), reference(&z.im)]
}

/// The sum of two numbers, the smaller left out where it cannot count: the shift that aligns them stays small.
pub(super) fn sum(a: &Big, b: &Big) -> Big {
    if is_zero(a) || is_zero(b) {
        return if is_zero(a) { b.clone() } else { a.clone() };
    }
    let distance = magnitude(a) - magnitude(b);
    match distance {
        4000.. => a.clone(),
        ..=-4000 => b.clone(),
        _ => a + b,
    }
}

pub(super) fn sum_of(a: &BigComplex, b: &BigComplex) -> BigComplex {
    BigComplex::new(sum(&a.re, &b.re), sum(&a.im, &b.im))
}

/// exp(-z^2); zero where its size is below e^-1000000, none where it is above e^1000000.
fn gaussian(x: f64, y: f64, bits: usize) -> Option<BigComplex> {
    let rough = (y - x) * (y + x);
    if rough < -LARGEST {
        return Some(BigComplex::new(big(0.0, bits), big(0.0, bits)));
    }
    let bits = bits + 100;
    let wide = 2200;
    let (bx, by) = (big(x, wide), big(y, wide));
    let exponent = (&by - &bx) * (&by + &bx);
    if exponent > big(LARGEST, wide) {
        return None;
    }
    let size = exponent.with_precision(bits).value().exp();
    let phase = (bx * by) << 1;
    if is_zero(&phase) {
        return Some(BigComplex::new(size, big(0.0, bits)));
    }
    // A phase of 2^2000 needs as many bits before it is reduced.
    let needed = bits + magnitude(&phase).max(0) as usize;
    let (sine, cosine) = phase.with_precision(needed).value().sin_cos();
    let cut = |x: Big| x.with_precision(bits).value();
    Some(BigComplex::new(&size * cut(cosine), -(&size * cut(sine))))
}

/// 2/sqrt(pi).
pub(super) fn two_over_root_pi(bits: usize) -> Big {
    big(2.0, bits) / Big::pi(bits).sqrt()
}

/// Bits of work for z: what cancels and what is kept. Near 0 twice |z|^2 in powers of e cancels; far out, on the
/// diagonals, z^-2 beside z^-4.
pub(super) fn work_bits(x: f64, y: f64) -> usize {
    let size = x.hypot(y);
    let cancelling = if size < FAR {
        2.9 * size * size
    } else {
        4.0 * x.abs().max(y.abs()).log2()
    };
    KEPT + 40 + cancelling as usize
}

/// Whether the asymptotic series is used, and whether exp(-z^2) is apart from it.
fn is_far(x: f64, y: f64) -> bool {
    x.hypot(y) >= FAR
}

fn stands_apart(x: f64, y: f64) -> bool {
    !is_far(x, y) || y.abs() < 1e-10
}

/// w without its multiple of exp(-z^2): 2i/sqrt(pi) times Dawson's integral, or the asymptotic series.
pub(super) fn remainder(x: f64, y: f64, bits: usize) -> BigComplex {
    let z = BigComplex::new(big(x, bits), big(y, bits));
    if is_far(x, y) {
        return far(&z, bits, |_| 1.0);
    }
    let square = (&z * &z).scaled(&big(-2.0, bits));
    let mut term = z.scaled(&two_over_root_pi(bits));
    let mut total = term.clone();
    for n in 1..4000u32 {
        term = (&term * &square).divided(&big(f64::from(2 * n + 1), bits));
        total = sum_of(&total, &term);
        let small = |t: &Big, s: &Big| is_zero(t) || magnitude(t) < magnitude(s) - bits as isize;
        if small(&term.re, &total.re) && small(&term.im, &total.im) {
            break;
        }
    }
    BigComplex::new(-total.im, total.re)
}

/// i/(sqrt(pi) z) sum_n (2n - 1)!!/(2 z^2)^n weight(n).
fn far(z: &BigComplex, bits: usize, weight: fn(u32) -> f64) -> BigComplex {
    let norm = z.re.sqr() + z.im.sqr();
    let inverse = BigComplex::new(&z.re / &norm, -(&z.im / &norm));
    let square = &inverse * &inverse;
    let mut term = BigComplex::new(big(1.0, bits), big(0.0, bits));
    let mut total = term.clone();
    for n in 0..150u32 {
        term = (&term * &square).scaled(&big(f64::from(n) + 0.5, bits));
        if magnitude(&term.re).max(magnitude(&term.im)) < -(bits as isize) {
            // A component of z may be smaller than the other by far more than this.
            if n > 3 {
                break;
            }
        }
        total = sum_of(&total, &term.scaled(&big(weight(n + 1), bits)));
    }
    let value = (&inverse * &total).scaled(&(two_over_root_pi(bits) >> 1));
    BigComplex::new(-value.im, value.re)
}

pub(super) fn multiple(x: f64, y: f64) -> f64 {
    match (stands_apart(x, y), y < 0.0) {
        (true, _) => 1.0,
        (false, true) => 2.0,
        (false, false) => 0.0,
    }
}

/// w(re + i im) for finite numbers.
pub fn faddeeva_w(re: f64, im: f64) -> [Reference; 2] {
    let bits = work_bits(re, im);
    let tail = remainder(re, im, bits);
    let m = multiple(re, im);
    if m == 0.0 {
        return references(&tail);
    }
    match gaussian(re, im, bits) {
        Some(g) => references(&sum_of(&g.scaled(&big(m, bits)), &tail)),
        None => overflowing(re, im, [1.0, 0.0], 0.0),
    }
}

/// Infinities with the signs of the components of exp(-z^2) times a number of the argument of `direction`, and `rest` for
/// a real part that has no share of it.
fn overflowing(x: f64, y: f64, direction: [f64; 2], rest: f64) -> [Reference; 2] {
    let phase = (big(x, 2200) * big(y, 2200)) << 1;
    let bits = KEPT
        + if is_zero(&phase) {
            0
        } else {
            magnitude(&phase).max(0) as usize
        };
    let (sine, cosine) = if is_zero(&phase) {
        (phase, big(1.0, bits))
    } else {
        phase.with_precision(bits).value().sin_cos()
    };
    let [u, v] = direction.map(|part| big(part, bits));
    let infinity = |x: &Big, rest: f64| {
        if is_zero(x) {
            Reference::exact(rest)
        } else if *x < big(0.0, 10) {
            Reference::exact(f64::NEG_INFINITY)
        } else {
            Reference::exact(f64::INFINITY)
        }
    };
    let re = sum(&(&cosine * &u), &(&sine * &v));
    let im = sum(&(cosine * v), &-(sine * u));
    [infinity(&re, rest), infinity(&im, 0.0)]
}

/// w'(re + i im) for finite numbers.
pub fn faddeeva_w_derivative(re: f64, im: f64) -> [Reference; 2] {
    let bits = work_bits(re, im) + 40;
    let z = BigComplex::new(big(re, bits), big(im, bits));
    let minus_two_z = z.scaled(&big(-2.0, bits));
    let tail = if is_far(re, im) {
        // S' = -(1/z) i/(sqrt(pi) z) sum (2n + 1) ..., over z.
        let norm = z.re.sqr() + z.im.sqr();
        let inverse = BigComplex::new(-(&z.re / &norm), &z.im / &norm);
        &inverse * &far(&z, bits, |n| f64::from(2 * n + 1))
    } else {
        let rest = remainder(re, im, bits);
        let product = &minus_two_z * &rest;
        BigComplex::new(product.re, product.im + two_over_root_pi(bits))
    };
    let m = multiple(re, im);
    if m == 0.0 {
        return references(&tail);
    }
    match gaussian(re, im, bits) {
        Some(g) => references(&sum_of(&(&minus_two_z * &g.scaled(&big(m, bits))), &tail)),
        None => overflowing(re, im, [-re, -im], 0.0),
    }
}

/// m and exp(-z^2) times the remainder of w(iz), so that erfc(z) = m + that; none where it overflows.
fn complement(x: f64, y: f64) -> Option<(f64, BigComplex)> {
    let bits = work_bits(x, y);
    let rest = remainder(-y, x, bits);
    Some((multiple(-y, x), &gaussian(x, y, bits)? * &rest))
}

/// erfc(re + i im) for finite numbers.
pub fn erfc_complex(re: f64, im: f64) -> [Reference; 2] {
    match complement(re, im) {
        Some((m, value)) => references(&BigComplex::new(sum(&big(m, KEPT), &value.re), value.im)),
        None => overflowing(re, im, [re, -im], 1.0),
    }
}

/// erf(re + i im) for finite numbers.
pub fn erf_complex(re: f64, im: f64) -> [Reference; 2] {
    match complement(re, im) {
        Some((m, value)) => references(&BigComplex::new(sum(&big(1.0 - m, KEPT), &-value.re), -value.im)),
        None => overflowing(re, im, [-re, im], 0.0),
    }
}
