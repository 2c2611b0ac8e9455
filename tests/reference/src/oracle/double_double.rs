//! Double-double arithmetic: a number as the unevaluated sum of two f64, about 106 bits.
//!
//! Every operation keeps `|lo| <= ulp(hi)/2` and a relative error below 2^-102, as long as no intermediate leaves the
//! range of normal numbers. Callers scale by powers of two where it could (see [`crate::metrics::Reference`]).
//! Error-free transformations: Dekker 1971, Knuth TAOCP 2, 4.2.2; products by fused multiply-add.

use std::ops::{Add, Div, Mul, Neg, Sub};

/// An unevaluated sum `hi + lo`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Dd {
    /// The sum rounded to f64.
    pub hi: f64,
    /// What `hi` lacks.
    pub lo: f64,
}

/// pi/2.
pub const HALF_PI: Dd = Dd::new(std::f64::consts::FRAC_PI_2, 6.123233995736766e-17);

/// Sum and rounding error of two numbers in any order.
#[inline(always)]
pub fn two_sum(a: f64, b: f64) -> Dd {
    let s = a + b;
    let t = s - a;
    Dd::new(s, (a - (s - t)) + (b - t))
}

/// Sum and rounding error where `|a| >= |b|` or `a` is zero.
#[inline(always)]
fn quick_two_sum(a: f64, b: f64) -> Dd {
    let s = a + b;
    Dd::new(s, b - (s - a))
}

/// Product and its rounding error.
#[inline(always)]
pub fn two_product(a: f64, b: f64) -> Dd {
    let p = a * b;
    Dd::new(p, a.mul_add(b, -p))
}

impl Dd {
    /// Zero.
    pub const ZERO: Dd = Dd::new(0.0, 0.0);
    /// One.
    pub const ONE: Dd = Dd::new(1.0, 0.0);

    /// The pair as given; `lo` must not exceed half a unit in the last place of `hi`.
    #[inline(always)]
    pub const fn new(hi: f64, lo: f64) -> Dd {
        Dd { hi, lo }
    }

    /// Square.
    #[inline(always)]
    pub fn square(self) -> Dd {
        self * self
    }

    /// Product with a power of two, exact barring underflow.
    #[inline(always)]
    pub fn scale(self, power_of_two: f64) -> Dd {
        Dd::new(self.hi * power_of_two, self.lo * power_of_two)
    }
}

impl From<f64> for Dd {
    #[inline(always)]
    fn from(x: f64) -> Dd {
        Dd::new(x, 0.0)
    }
}

impl Neg for Dd {
    type Output = Dd;
    #[inline(always)]
    fn neg(self) -> Dd {
        Dd::new(-self.hi, -self.lo)
    }
}

impl Add for Dd {
    type Output = Dd;
    #[inline(always)]
    fn add(self, b: Dd) -> Dd {
        let s = two_sum(self.hi, b.hi);
        let t = two_sum(self.lo, b.lo);
        let s = quick_two_sum(s.hi, s.lo + t.hi);
        quick_two_sum(s.hi, s.lo + t.lo)
    }
}

impl Add<f64> for Dd {
    type Output = Dd;
    #[inline(always)]
    fn add(self, b: f64) -> Dd {
        let s = two_sum(self.hi, b);
        quick_two_sum(s.hi, s.lo + self.lo)
    }
}

impl Sub for Dd {
    type Output = Dd;
    #[inline(always)]
    fn sub(self, b: Dd) -> Dd {
        self + -b
    }
}

impl Mul for Dd {
    type Output = Dd;
    #[inline(always)]
    fn mul(self, b: Dd) -> Dd {
        let p = two_product(self.hi, b.hi);
        quick_two_sum(p.hi, p.lo + (self.hi * b.lo + self.lo * b.hi))
    }
}

impl Mul<f64> for Dd {
    type Output = Dd;
    #[inline(always)]
    fn mul(self, b: f64) -> Dd {
        let p = two_product(self.hi, b);
        quick_two_sum(p.hi, p.lo + self.lo * b)
    }
}

impl Div for Dd {
    type Output = Dd;
    #[inline(always)]
    fn div(self, b: Dd) -> Dd {
        let q0 = self.hi / b.hi;
        let r = self - b * q0;
        let q1 = r.hi / b.hi;
        let r = r - b * q1;
        let q2 = r.hi / b.hi;
        quick_two_sum(q0, q1) + q2
    }
}

impl Div<f64> for Dd {
    type Output = Dd;
    #[inline(always)]
    fn div(self, b: f64) -> Dd {
        self / Dd::from(b)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_quotient_times_its_divisor_gives_the_dividend_back() {
        for k in 1..200 {
            let a = Dd::ONE / f64::from(k) + 1e-20;
            let b = HALF_PI * f64::from(k);
            let error = (a / b) * b - a;
            assert!(error.hi.abs() <= 2f64.powi(-102) * a.hi, "{k}: {error:?}");
        }
    }

    #[test]
    fn one_third_three_times_is_one() {
        let third = Dd::ONE / 3.0;
        assert!((third + third + third - Dd::ONE).hi.abs() < 1e-31);
        assert!(third.lo != 0.0);
    }
}
