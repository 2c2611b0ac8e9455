//! Complex numbers whose parts carry exponents of their own.

use super::double_double::Dd;
use super::faddeeva::references;
use super::scaled::{Scaled, exponential, sin_cos};
use crate::metrics::Reference;
use std::ops::{Add, Mul, Neg};

/// re + i im.
#[derive(Clone, Copy, Debug)]
pub struct ScaledComplex {
    /// Real part.
    pub re: Scaled,
    /// Imaginary part.
    pub im: Scaled,
}

impl ScaledComplex {
    /// Zero.
    pub const ZERO: ScaledComplex = ScaledComplex {
        re: Scaled::ZERO,
        im: Scaled::ZERO,
    };

    /// A number from two double-doubles.
    pub fn new(re: Dd, im: Dd) -> ScaledComplex {
        ScaledComplex {
            re: re.into(),
            im: im.into(),
        }
    }

    /// A number from two truths.
    pub fn from_references(parts: [Reference; 2]) -> ScaledComplex {
        let [re, im] = parts.map(|part| Scaled::new(Dd::new(part.hi, part.lo), i64::from(part.exponent)));
        ScaledComplex { re, im }
    }

    /// exp(-i phase), the phase the sum of two numbers.
    pub fn rotation(phase: Dd) -> ScaledComplex {
        let (sine, cosine) = sin_cos(&[phase.hi, phase.lo]);
        ScaledComplex::new(cosine, -sine)
    }

    /// The number times the exponential of `x`.
    pub fn times_exponential(self, x: Dd) -> ScaledComplex {
        self * exponential(x)
    }

    /// The number times i.
    pub fn times_i(self) -> ScaledComplex {
        ScaledComplex {
            re: -self.im,
            im: self.re,
        }
    }

    /// Both parts as truths; zeros are positive.
    pub fn references(self) -> [Reference; 2] {
        references([self.re, self.im], [0.0, 0.0])
    }
}

impl Add for ScaledComplex {
    type Output = ScaledComplex;
    fn add(self, b: ScaledComplex) -> ScaledComplex {
        ScaledComplex {
            re: self.re + b.re,
            im: self.im + b.im,
        }
    }
}

impl Neg for ScaledComplex {
    type Output = ScaledComplex;
    fn neg(self) -> ScaledComplex {
        ScaledComplex {
            re: -self.re,
            im: -self.im,
        }
    }
}

impl Mul for ScaledComplex {
    type Output = ScaledComplex;
    fn mul(self, b: ScaledComplex) -> ScaledComplex {
        ScaledComplex {
            re: self.re * b.re + -(self.im * b.im),
            im: self.re * b.im + self.im * b.re,
        }
    }
}

impl Mul<Scaled> for ScaledComplex {
    type Output = ScaledComplex;
    fn mul(self, b: Scaled) -> ScaledComplex {
        ScaledComplex {
            re: self.re * b,
            im: self.im * b,
        }
    }
}

impl Mul<Dd> for ScaledComplex {
    type Output = ScaledComplex;
    fn mul(self, b: Dd) -> ScaledComplex {
        self * Scaled::from(b)
    }
}
