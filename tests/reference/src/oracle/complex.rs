//! Complex numbers whose parts are double-doubles. A small part keeps its own relative accuracy in sums and products
//! that do not cancel.

use super::double_double::Dd;
use std::ops::{Add, Div, Mul};

/// re + i im.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Complex {
    /// Real part.
    pub re: Dd,
    /// Imaginary part.
    pub im: Dd,
}

impl Complex {
    /// Zero.
    pub const ZERO: Complex = Complex {
        re: Dd::ZERO,
        im: Dd::ZERO,
    };

    /// Product with a power of two.
    pub fn scale(self, power_of_two: f64) -> Complex {
        Complex {
            re: self.re.scale(power_of_two),
            im: self.im.scale(power_of_two),
        }
    }
}

impl Add for Complex {
    type Output = Complex;
    fn add(self, b: Complex) -> Complex {
        Complex {
            re: self.re + b.re,
            im: self.im + b.im,
        }
    }
}

impl Mul for Complex {
    type Output = Complex;
    fn mul(self, b: Complex) -> Complex {
        Complex {
            re: self.re * b.re - self.im * b.im,
            im: self.re * b.im + self.im * b.re,
        }
    }
}

impl Mul<f64> for Complex {
    type Output = Complex;
    fn mul(self, b: f64) -> Complex {
        Complex {
            re: self.re * b,
            im: self.im * b,
        }
    }
}

impl Div<f64> for Complex {
    type Output = Complex;
    fn div(self, b: f64) -> Complex {
        Complex {
            re: self.re / b,
            im: self.im / b,
        }
    }
}
