//! Double-doubles with an exponent of their own, for results far outside the range of f64, and the elementary functions
//! that make them.

use super::double_double::{Dd, HALF_PI, two_product, two_sum};
use super::reduction::{INVERSE_FACTORIAL, Reduced, reduce};
use crate::metrics::Reference;
use std::ops::{Add, Div, Mul, Neg};

/// 1/sqrt(pi).
pub const ONE_OVER_ROOT_PI: Dd = Dd::new(0.5641895835477563, 7.66772980658294e-18);
/// 2/sqrt(pi).
pub const TWO_OVER_ROOT_PI: Dd = Dd::new(std::f64::consts::FRAC_2_SQRT_PI, 1.533545961316588e-17);
/// ln 2.
const LN_TWO: Dd = Dd::new(std::f64::consts::LN_2, 2.3190468138462996e-17);
/// Exponents beyond this stand for zero and infinity: no product of two results comes back from there.
const FAR: f64 = 1e6;

/// part 2^exponent, 1 <= |part| < 2 or zero.
#[derive(Clone, Copy, Debug)]
pub struct Scaled {
    part: Dd,
    exponent: i64,
}

fn power_of_two(n: i64) -> f64 {
    f64::from_bits(((n + 1023) as u64) << 52)
}

impl Scaled {
    /// Zero.
    pub const ZERO: Scaled = Scaled {
        part: Dd::ZERO,
        exponent: 0,
    };

    /// `part` 2^`exponent`. A pair with a low part must be a normal number of moderate size.
    pub fn new(part: Dd, exponent: i64) -> Scaled {
        if part.hi == 0.0 {
            return Scaled::ZERO;
        }
        if part.hi.abs() < 1e-290 {
            return Scaled::new(part.scale(power_of_two(600)), exponent - 600);
        }
        let n = ((part.hi.to_bits() >> 52) & 0x7FF) as i64 - 1023;
        // In two steps, because 2^-1023 is no normal number.
        let half = n / 2;
        Scaled {
            part: part.scale(power_of_two(-half)).scale(power_of_two(half - n)),
            exponent: exponent + n,
        }
    }

    /// The number times 2^`n`.
    pub fn shift(self, n: i64) -> Scaled {
        Scaled {
            exponent: self.exponent + n,
            ..self
        }
    }

    /// Whether the sum of numbers with these exponents has lost more than `bits` of the largest.
    pub fn has_lost(self, bits: i64, terms: &[Scaled]) -> bool {
        let largest = terms.iter().map(|t| t.size()).max().unwrap_or(i64::MIN);
        largest > i64::MIN && self.size() < largest - bits
    }

    /// Binary exponent; the least for zero.
    pub fn size(self) -> i64 {
        if self.part.hi == 0.0 { i64::MIN } else { self.exponent }
    }

    /// The number as a double-double; it must lie in the range of f64.
    pub fn value(self) -> Dd {
        self.part.scale(power_of_two(self.exponent.clamp(-1022, 1023)))
    }

    /// The number as a truth: an infinity beyond the range of f64.
    pub fn reference(self) -> Reference {
        let Dd { hi, lo } = self.part;
        if (-600..1023).contains(&self.exponent) {
            let scale = power_of_two(self.exponent);
            return Dd::new(hi * scale, lo * scale).into();
        }
        if self.exponent >= 1023 {
            let scale = power_of_two(1023);
            let (hi, lo) = (hi * scale, lo * scale);
            let beyond = self.exponent > 1023 || hi.is_infinite();
            return if beyond {
                Reference::exact(f64::INFINITY.copysign(hi))
            } else {
                Dd::new(hi, lo).into()
            };
        }
        Reference {
            hi,
            lo,
            exponent: self.exponent.max(-4_000_000) as i32,
        }
    }
}

impl From<f64> for Scaled {
    fn from(x: f64) -> Scaled {
        Scaled::new(x.into(), 0)
    }
}

impl From<Dd> for Scaled {
    fn from(x: Dd) -> Scaled {
        Scaled::new(x, 0)
    }
}

impl Neg for Scaled {
    type Output = Scaled;
    fn neg(self) -> Scaled {
        Scaled {
            part: -self.part,
            ..self
        }
    }
}

impl Add for Scaled {
    type Output = Scaled;
    fn add(self, b: Scaled) -> Scaled {
        if self.size() < b.size() {
            return b + self;
        }
        if b.part.hi == 0.0 || self.exponent - b.exponent > 300 {
            return self;
        }
        let moved = b.part.scale(power_of_two(b.exponent - self.exponent));
        Scaled::new(self.part + moved, self.exponent)
    }
}

impl Mul for Scaled {
    type Output = Scaled;
    fn mul(self, b: Scaled) -> Scaled {
        Scaled::new(self.part * b.part, self.exponent + b.exponent)
    }
}

impl Div for Scaled {
    type Output = Scaled;
    fn div(self, b: Scaled) -> Scaled {
        Scaled::new(self.part / b.part, self.exponent - b.exponent)
    }
}

/// e to the `x`.
pub fn exponential(x: Dd) -> Scaled {
    if x.hi.abs() > FAR {
        let exponent = if x.hi > 0.0 { 2e6 } else { -2e6 };
        return Scaled {
            part: Dd::ONE,
            exponent: exponent as i64,
        };
    }
    let n = (x.hi / std::f64::consts::LN_2).round();
    let r = x - LN_TWO * n;
    let mut sum = INVERSE_FACTORIAL[27];
    for k in (0..27).rev() {
        sum = sum * r + INVERSE_FACTORIAL[k];
    }
    Scaled::new(sum, n as i64)
}

/// Sine and cosine of the sum of `parts`, each reduced exactly.
pub fn sin_cos(parts: &[f64]) -> (Dd, Dd) {
    let mut total = Reduced {
        quadrant: 0,
        remainder: Dd::ZERO,
    };
    for &part in parts {
        let reduced = reduce(part);
        let remainder = total.remainder + reduced.remainder;
        let quarters = (remainder.hi * std::f64::consts::FRAC_2_PI).round();
        total = Reduced {
            quadrant: (total.quadrant + reduced.quadrant).wrapping_add(quarters as i32 as u32) & 3,
            remainder: if quarters == 0.0 {
                remainder
            } else {
                remainder - HALF_PI * quarters
            },
        };
    }
    total.sin_cos()
}

/// sin(2xy)/(xy) and cos(2xy); the product must not overflow.
pub fn sine_quotient_and_cosine(x: f64, y: f64) -> (Scaled, Dd) {
    let product = two_product(2.0 * x, y);
    let (sine, cosine) = sin_cos(&[product.hi, product.lo]);
    if product.hi.abs() < 1e-10 {
        let sixth = product.square() / 6.0;
        return ((Dd::ONE - sixth).scale(2.0).into(), cosine);
    }
    (Scaled::from(sine) / product.scale(0.5).into(), cosine)
}

/// (y - x)(y + x), the real part of -(x + iy)^2.
pub fn minus_real_square(x: f64, y: f64) -> Dd {
    if x.abs().max(y.abs()) > 1e150 {
        // Only its sign counts there, unless |x| and |y| are neighbours.
        let (s, d) = (two_sum(0.5 * y, 0.5 * x), two_sum(0.5 * y, -0.5 * x));
        let crude = s.hi * (d.hi * 4.0);
        if crude.abs() > 1e100 {
            return crude.clamp(-1e100, 1e100).into();
        }
        return s * d.scale(4.0);
    }
    two_sum(y, x) * two_sum(y, -x)
}
