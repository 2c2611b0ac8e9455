//! Sine and cosine in double-double, with exact reduction of any finite f64.
//!
//! The reduction multiplies the 53-bit significand with a 384-bit window of 2/pi (Payne and Hanek 1983), so the
//! remainder keeps a relative accuracy of 2^-102 even for the f64 nearest to a multiple of pi/2.

use super::double_double::{Dd, HALF_PI, two_sum};
use std::sync::LazyLock;

/// An angle as a multiple of pi/2 and a remainder in [-pi/4, pi/4].
#[derive(Clone, Copy, Debug)]
pub struct Reduced {
    /// Multiple of pi/2, modulo 4.
    pub quadrant: u32,
    /// Remainder in radians.
    pub remainder: Dd,
}

/// The finite angle `x` in radians, reduced exactly.
pub fn reduce(x: f64) -> Reduced {
    if x.abs() < 0.75 {
        return Reduced {
            quadrant: 0,
            remainder: x.into(),
        };
    }
    let bits = x.abs().to_bits();
    let significand = (bits & ((1 << 52) - 1)) | (1 << 52);
    let exponent = (bits >> 52) as i32 - 1075;
    // Bits of 2/pi whose weight times 2^exponent is a multiple of 4 only add whole turns.
    let skipped = (exponent - 2).max(0);
    let product = product_with_window(significand, skipped as usize);
    // Binary point of the product stands at bit 384 - (exponent - skipped); move it to bit 446 of 448.
    let mut fraction = shift_left(product, (62 + exponent - skipped) as u32);
    let mut quadrant = (fraction[0] >> 62) as u32;
    fraction[0] <<= 2;
    fraction[0] >>= 2;
    let negative = fraction[0] >> 61 == 1;
    if negative {
        quadrant += 1;
        fraction = negated(fraction);
        fraction[0] &= (1 << 62) - 1;
    }
    let mut remainder = to_double_double(fraction) * HALF_PI;
    if negative {
        remainder = -remainder;
    }
    if x < 0.0 {
        quadrant = 4 - (quadrant & 3);
        remainder = -remainder;
    }
    Reduced {
        quadrant: quadrant & 3,
        remainder,
    }
}

impl Reduced {
    /// Sine and cosine of the angle.
    pub fn sin_cos(self) -> (Dd, Dd) {
        let (s, c) = (sine_kernel(self.remainder), cosine_kernel(self.remainder));
        match self.quadrant {
            0 => (s, c),
            1 => (c, -s),
            2 => (-s, -c),
            _ => (-c, s),
        }
    }

    /// Sine of the angle plus a small `offset` (some turns at most). Keeps relative accuracy where the remainder and the
    /// offset do not nearly cancel each other.
    pub fn sin_offset(self, offset: Dd) -> Dd {
        let angle = self.remainder + offset;
        let turns = (angle.hi * std::f64::consts::FRAC_2_PI).round();
        let remainder = angle - HALF_PI * turns;
        match (self.quadrant as i32 + turns as i32).rem_euclid(4) {
            0 => sine_kernel(remainder),
            1 => cosine_kernel(remainder),
            2 => -sine_kernel(remainder),
            _ => -cosine_kernel(remainder),
        }
    }
}

/// Sine and cosine of a finite `x` in radians.
pub fn sin_cos(x: f64) -> (Dd, Dd) {
    reduce(x).sin_cos()
}

/// 1/n! for n = 0..=31.
pub static INVERSE_FACTORIAL: LazyLock<[Dd; 32]> = LazyLock::new(|| {
    let mut table = [Dd::ONE; 32];
    for n in 1..32 {
        table[n] = table[n - 1] / n as f64;
    }
    table
});

/// Sine for |r| <= 0.8 by its Taylor series.
fn sine_kernel(r: Dd) -> Dd {
    if r.hi.abs() < 1e-40 {
        return r;
    }
    r * alternating_series(r.square(), 1, 29)
}

/// Cosine for |r| <= 0.8 by its Taylor series.
fn cosine_kernel(r: Dd) -> Dd {
    if r.hi.abs() < 1e-40 {
        return Dd::ONE;
    }
    alternating_series(r.square(), 0, 28)
}

/// Sum of (-z)^k / (first + 2k)! up to `last`; terms below 2^-53 of the sum need only f64.
fn alternating_series(z: Dd, first: usize, last: usize) -> Dd {
    let table = &*INVERSE_FACTORIAL;
    let split = if z.hi < 0.04 { first + 12 } else { first + 18 };
    let mut tail = 0.0;
    let mut n = last;
    while n > split {
        tail = table[n].hi - z.hi * tail;
        n -= 2;
    }
    let mut sum = table[n] - z * tail;
    while n > first {
        n -= 2;
        sum = table[n] - z * sum;
    }
    sum
}

/// The 53-bit significand times 384 bits of 2/pi that start after `skipped` bits, most significant limb first.
fn product_with_window(significand: u64, skipped: usize) -> [u64; 7] {
    let (limb, shift) = (skipped / 64, skipped % 64);
    let mut product = [0u64; 7];
    let mut carry = 0u128;
    for i in (0..6).rev() {
        let word = if shift == 0 {
            TWO_OVER_PI[limb + i]
        } else {
            TWO_OVER_PI[limb + i] << shift | TWO_OVER_PI[limb + i + 1] >> (64 - shift)
        };
        let t = u128::from(significand) * u128::from(word) + carry;
        product[i + 1] = t as u64;
        carry = t >> 64;
    }
    product[0] = carry as u64;
    product
}

/// The 448-bit number times 2^shift, modulo 2^448, for shift <= 64.
fn shift_left(x: [u64; 7], shift: u32) -> [u64; 7] {
    std::array::from_fn(|i| {
        let next = if i < 6 { x[i + 1] } else { 0 };
        match shift {
            0 => x[i],
            64 => next,
            _ => x[i] << shift | next >> (64 - shift),
        }
    })
}

/// Two's complement of a 448-bit number.
fn negated(x: [u64; 7]) -> [u64; 7] {
    let mut carry = true;
    let mut y = [0; 7];
    for i in (0..7).rev() {
        (y[i], carry) = (!x[i]).overflowing_add(u64::from(carry));
    }
    y
}

/// A fraction of 446 bits as a double-double, to full relative accuracy.
fn to_double_double(fraction: [u64; 7]) -> Dd {
    let Some(first) = fraction.iter().position(|&limb| limb != 0) else {
        return Dd::ZERO;
    };
    let mut sum = Dd::ZERO;
    // Four limbs hold at least 193 significant bits. Smallest first.
    for i in (first..(first + 4).min(7)).rev() {
        let weight = f64::from_bits((1023 + 2 - 64 * (i as u64 + 1)) << 52);
        let (high, low) = (fraction[i] >> 32, fraction[i] & 0xFFFF_FFFF);
        sum = sum + two_sum(high as f64 * 4294967296.0 * weight, low as f64 * weight);
    }
    sum
}

/// 2/pi: 1472 bits after the binary point, most significant first. Remade from pi in a test below.
const TWO_OVER_PI: [u64; 23] = [
    0xA2F9836E4E441529,
    0xFC2757D1F534DDC0,
    0xDB6295993C439041,
    0xFE5163ABDEBBC561,
    0xB7246E3A424DD2E0,
    0x06492EEA09D1921C,
    0xFE1DEB1CB129A73E,
    0xE88235F52EBB4484,
    0xE99C7026B45F7E41,
    0x3991D639835339F4,
    0x9C845F8BBDF9283B,
    0x1FF897FFDE05980F,
    0xEF2F118B5A0A6D1F,
    0x6D367ECF27CB09B7,
    0x4F463F669E5FEA2D,
    0x7527BAC7EBE5F17B,
    0x3D0739F78A5292EA,
    0x6BFB5FB11F8D5D08,
    0x56033046FC7B6BAB,
    0xF0CFBC209AF4361D,
    0xA9E391615EE61B08,
    0x6599855F14A06840,
    0x8DFFD8804D732731,
];

#[cfg(test)]
mod tests {
    use super::*;
    use dashu_float::{FBig, round::mode::HalfEven};

    #[test]
    fn the_limbs_are_those_of_two_over_pi() {
        let pi = FBig::<HalfEven, 2>::pi(1700);
        let mut ratio: FBig<HalfEven, 2> = FBig::from(2).with_precision(1700).value() / pi;
        for (i, &limb) in TWO_OVER_PI.iter().enumerate() {
            ratio <<= 64;
            let whole = ratio.floor();
            assert_eq!(whole.to_int().value(), dashu_int::IBig::from(limb), "limb {i}");
            ratio -= whole;
        }
    }

    #[test]
    fn the_double_nearest_to_a_multiple_of_half_pi_keeps_its_remainder() {
        // Kahan's example: 6381956970095103 * 2^797 lies 4.69e-19 from an odd multiple of pi/2.
        let x = 6381956970095103.0 * 2f64.powi(797);
        let r = reduce(x);
        assert_eq!(r.quadrant % 2, 1);
        assert!(
            (r.remainder.hi.abs() - 4.687165924254624e-19).abs() < 1e-33,
            "{:?}",
            r.remainder
        );
    }

    #[test]
    fn sine_and_cosine_square_to_one() {
        for k in 0..2000 {
            let x = 1.37f64.powi(k % 2000 - 700) * 0.7;
            if x.is_finite() {
                let (s, c) = sin_cos(x);
                assert!((s.square() + c.square() - Dd::ONE).hi.abs() < 1e-30, "{x:e}");
                assert!((s.hi - x.sin()).abs() < 3e-16, "{x:e}");
            }
        }
    }
}
