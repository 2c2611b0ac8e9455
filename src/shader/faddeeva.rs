//! The Faddeeva function w in f32, for the whole plane.
//!
//! With zeta = -i z = y - i x, w is real on the real zeta axis: polynomials with real coefficients by the two-term
//! recurrence, in v = (zeta - a)/(zeta + b), one set of coefficients for |z| < 2 and one beyond. Near, w = w(2i) +
//! (zeta - a) P(v); far, w = (y + i x)(1 + f)/(sqrt(pi) |z|^2) with f = P(v)/(zeta + b)^2, whose errors fade with f. The
//! numerator of v is taken in real and imaginary part, so that nothing cancels at zeta = a.
//!
//! Below the real axis w(z) = 2 exp(-z^2) - w(-z). The exponent y^2 - x^2 is a difference of exact squares and a small
//! rest, the phase 2xy is reduced in turns from exact partial products.

use super::coefficients::*;
use super::elementary::*;
use super::faddeeva_coefficients::*;
use super::gpu::{abs, bits_of, from_bits, max, min, round, select};

/// From 2^60 on coordinates are scaled, so that their squares stay finite.
pub(super) const FADDEEVA_SQUARE_LIMIT: f32 = 1152921504606846976.0;
/// 2^-66.
pub(super) const FADDEEVA_SHRINK: f32 = 1.3552527e-20;
/// A larger number counts as infinite.
pub(super) const INFINITE_LIMIT: f32 = 3.0e38;
/// 1/sqrt(pi).
pub(super) const INVERSE_ROOT_PI: f32 = 0.5641896;
/// An exponent that leaves nothing.
pub(super) const EXPONENT_LOWEST: f32 = -110.0;
/// An exponent whose power is beyond the range of f32, times 1e-30 too.
pub(super) const EXPONENT_HIGHEST: f32 = 176.0;
/// Up to here squares are split on a common grid.
pub(super) const GRID_UPPER_LIMIT: f32 = 512.0;
/// The finest grid is that of this number.
pub(super) const GRID_LOWER_LIMIT: f32 = 0.0001;

/// A complex number.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Complex {
    /// The real part.
    pub re: f32,
    /// The imaginary part.
    pub im: f32,
}

/// A power of e as a product that is formed last, so that a factor can come between.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct PowerOfE {
    /// A number near 1.
    pub(super) mantissa: f32,
    /// A power of two.
    pub(super) first: f32,
    /// Another one.
    pub(super) second: f32,
}

/// Returns e to the sum of a leading part from -110 to 176 and a small rest.
///
/// The leading part may carry all its digits: it is reduced before the rest is added.
#[inline(always)]
pub(super) fn power_of_e(leading: f32, rest: f32) -> PowerOfE {
    let n = round((leading + rest) * LOG_TWO_E);
    let r = (leading - n * LN_TWO_HIGH) + (rest - n * LN_TWO_LOW);
    let e = EXPONENTIAL_A + r * (EXPONENTIAL_B + r * (EXPONENTIAL_C + r * (EXPONENTIAL_D + r * EXPONENTIAL_E)));
    let halved = round(n * 0.5);
    PowerOfE {
        mantissa: 1.0 + r * (1.0 + r * e),
        first: from_bits(bits_of(halved + EXPONENT_BIAS) << 23u32),
        second: from_bits(bits_of((n - halved) + EXPONENT_BIAS) << 23u32),
    }
}

/// Returns the twelve leading bits of x: the product of two such numbers is exact.
#[inline(always)]
pub(super) fn leading_bits(x: f32) -> f32 {
    from_bits(bits_of(x) & 0xfffff000u32)
}

/// Returns x y/pi less the nearest integer, for x y in radians.
#[inline(always)]
pub(super) fn product_turns(x: f32, y: f32) -> f32 {
    let x_high = leading_bits(x);
    let y_high = leading_bits(y);
    let leading = min(max(x_high * y_high, -PHASE_LIMIT), PHASE_LIMIT);
    let rest = x_high * (y - y_high) + (x - x_high) * y;
    let bounded = min(max(rest, -PHASE_LIMIT), PHASE_LIMIT);
    let n = round(leading * INVERSE_PI);
    let turns = ((leading - n * PI_HIGH) - n * PI_LOW) * INVERSE_PI;
    let small = bounded * INVERSE_PI;
    let sum = turns + (small - round(small));
    sum - round(sum)
}

/// Returns the polynomial of the near or of the far fit at v, in the upper half plane.
#[inline(always)]
pub(super) fn faddeeva_polynomial(v: Complex, near: bool) -> Complex {
    let s = v.re + v.re;
    let t = v.re * v.re + v.im * v.im;
    let p_o = select(FADDEEVA_FAR_O, FADDEEVA_NEAR_O, near);
    let p_n = select(FADDEEVA_FAR_N, FADDEEVA_NEAR_N, near) + s * p_o;
    let p_m = (select(FADDEEVA_FAR_M, FADDEEVA_NEAR_M, near) - t * p_o) + s * p_n;
    let p_l = (select(FADDEEVA_FAR_L, FADDEEVA_NEAR_L, near) - t * p_n) + s * p_m;
    let p_k = (select(FADDEEVA_FAR_K, FADDEEVA_NEAR_K, near) - t * p_m) + s * p_l;
    let p_j = (select(FADDEEVA_FAR_J, FADDEEVA_NEAR_J, near) - t * p_l) + s * p_k;
    let p_i = (select(FADDEEVA_FAR_I, FADDEEVA_NEAR_I, near) - t * p_k) + s * p_j;
    let p_h = (select(FADDEEVA_FAR_H, FADDEEVA_NEAR_H, near) - t * p_j) + s * p_i;
    let p_g = (select(FADDEEVA_FAR_G, FADDEEVA_NEAR_G, near) - t * p_i) + s * p_h;
    let p_f = (select(FADDEEVA_FAR_F, FADDEEVA_NEAR_F, near) - t * p_h) + s * p_g;
    let p_e = (select(FADDEEVA_FAR_E, FADDEEVA_NEAR_E, near) - t * p_g) + s * p_f;
    let p_d = (select(FADDEEVA_FAR_D, FADDEEVA_NEAR_D, near) - t * p_f) + s * p_e;
    let p_c = (select(FADDEEVA_FAR_C, FADDEEVA_NEAR_C, near) - t * p_e) + s * p_d;
    let p_b = (select(FADDEEVA_FAR_B, FADDEEVA_NEAR_B, near) - t * p_d) + s * p_c;
    let re = (select(FADDEEVA_FAR_A, FADDEEVA_NEAR_A, near) - t * p_c) + v.re * p_b;
    let im = v.im * p_b;
    Complex { re, im }
}

/// Returns w(x + i y) for x >= 0 and y >= 0.
#[inline(always)]
pub(super) fn faddeeva_quadrant(x: f32, y: f32) -> Complex {
    let largest = max(x, y);
    let huge = largest > FADDEEVA_SQUARE_LIMIT;
    let scale = select(1.0, FADDEEVA_SHRINK, huge);
    let xs = min(x, INFINITE_LIMIT) * scale;
    let ys = min(y, INFINITE_LIMIT) * scale;
    let square = xs * xs;
    let size = square + ys * ys;
    let near = size < select(FADDEEVA_BORDER, 0.0, huge);
    let pole = select(FADDEEVA_FAR_POLE, FADDEEVA_NEAR_POLE, near);
    let across = ys + pole;
    let inverse = 1.0 / (across * across + square);
    let along = ys - FADDEEVA_CENTRE;
    let v = Complex {
        re: (along * across + square) * inverse,
        im: -((pole + FADDEEVA_CENTRE) * (xs * inverse)),
    };
    let p = faddeeva_polynomial(v, near);
    let near_re = FADDEEVA_AT_CENTRE + (along * p.re + xs * p.im);
    let near_im = along * p.im - xs * p.re;
    let inverse_square = inverse * inverse;
    let q_square = ((across - xs) * (across + xs)) * inverse_square;
    let q_twice = ((across + across) * xs) * inverse_square;
    // Where the coordinates are scaled f is nothing.
    let f_re = select(q_square * p.re - q_twice * p.im, 0.0, huge);
    let f_im = select(q_square * p.im + q_twice * p.re, 0.0, huge);
    let shrink = INVERSE_ROOT_PI / size;
    let far_re = (ys + (ys * f_re - xs * f_im)) * shrink;
    let far_im = (xs + (xs * f_re + ys * f_im)) * shrink;
    let unscale = select(scale, 0.0, largest > INFINITE_LIMIT);
    Complex {
        re: select(far_re, near_re, near) * unscale,
        im: select(far_im, near_im, near) * unscale,
    }
}

/// Returns 2 exp(-z^2) at z = x - i y for x >= 0 and y > 0.
#[inline(always)]
pub(super) fn faddeeva_gaussian(x: f32, y: f32) -> Complex {
    let halved = (y - x) * (0.5 * y + 0.5 * x);
    let rough = halved + halved;
    let largest = max(x, y);
    let bits = bits_of(max(min(largest, GRID_UPPER_LIMIT), GRID_LOWER_LIMIT)) & 0x7f800000u32;
    // 2^e and 2^(1 - e) for the power of two 2^e at or below the larger coordinate.
    let grid = from_bits(bits) * 0.00048828125;
    let inverse_grid = from_bits(bits ^ 0x7f800000u32) * 1024.0;
    let x_high = round(x * inverse_grid) * grid;
    let y_high = round(y * inverse_grid) * grid;
    let exact = y_high * y_high - x_high * x_high;
    let small = (y - y_high) * (y + y_high) - (x - x_high) * (x + x_high);
    let plain = largest > GRID_UPPER_LIMIT || abs(rough) > 104.0;
    let bounded = min(max(rough, EXPONENT_LOWEST), EXPONENT_HIGHEST);
    let power = power_of_e(select(exact, bounded, plain), select(small, 0.0, plain));
    // An infinite y has no phase: 0 y is then NaN. On the imaginary axis the phase is 0 all the same.
    let nothing = x == 0.0 || rough < EXPONENT_LOWEST;
    let phase = sine_cosine_turns(select(product_turns(x, y) + 0.0 * y, 0.0, nothing));
    let re = (power.mantissa * phase.cosine) * power.first;
    let im = (power.mantissa * phase.sine) * power.first;
    Complex {
        re: (re + re) * power.second,
        im: (im + im) * power.second,
    }
}

/// Returns w(re + i im) from its value at |re| + i |im|, by w(z) = 2 exp(-z^2) - w(-z) below the real axis.
#[inline(always)]
pub(super) fn faddeeva_in_plane(re: f32, im: f32, above: Complex) -> Complex {
    let mut w_re = above.re;
    let mut w_im = above.im;
    if im < 0.0 {
        let gaussian = faddeeva_gaussian(abs(re), abs(im));
        w_re = gaussian.re - above.re;
        w_im = gaussian.im + above.im;
    }
    Complex {
        re: w_re,
        im: odd_continuation(re, w_im),
    }
}

/// Returns w(z) = exp(-z^2) erfc(-i z) at z = re + i im, to f32 grade in the upper half plane.
///
/// The error counts against |w(z)| above the real axis and on it, and against |2 exp(-z^2)| + |w(-z)| below, where
/// exponent and phase keep their digits for |z| to 100. w(-conj z) = conj w(z) holds exactly. An infinite z gives 0 in
/// the upper half plane and on horizontal lines below it; straight down w tends to infinity.
#[inline(always)]
#[must_use]
pub fn faddeeva_w(re: f32, im: f32) -> Complex {
    faddeeva_in_plane(re, im, faddeeva_quadrant(abs(re), abs(im)))
}

/// Returns the polynomial of the coarse tier at v.
#[inline(always)]
pub(super) fn faddeeva_polynomial_coarse(v: Complex) -> Complex {
    let s = v.re + v.re;
    let t = v.re * v.re + v.im * v.im;
    let p_k = FADDEEVA_COARSE_K;
    let p_j = FADDEEVA_COARSE_J + s * p_k;
    let p_i = (FADDEEVA_COARSE_I - t * p_k) + s * p_j;
    let p_h = (FADDEEVA_COARSE_H - t * p_j) + s * p_i;
    let p_g = (FADDEEVA_COARSE_G - t * p_i) + s * p_h;
    let p_f = (FADDEEVA_COARSE_F - t * p_h) + s * p_g;
    let p_e = (FADDEEVA_COARSE_E - t * p_g) + s * p_f;
    let p_d = (FADDEEVA_COARSE_D - t * p_f) + s * p_e;
    let p_c = (FADDEEVA_COARSE_C - t * p_e) + s * p_d;
    let p_b = (FADDEEVA_COARSE_B - t * p_d) + s * p_c;
    let re = (FADDEEVA_COARSE_A - t * p_c) + v.re * p_b;
    let im = v.im * p_b;
    Complex { re, im }
}

/// Returns w(x + i y) for x >= 0 and y >= 0, to 5e-5.
#[inline(always)]
pub(super) fn faddeeva_quadrant_coarse(x: f32, y: f32) -> Complex {
    let largest = max(x, y);
    let huge = largest > FADDEEVA_SQUARE_LIMIT;
    let scale = select(1.0, FADDEEVA_SHRINK, huge);
    let xs = min(x, INFINITE_LIMIT) * scale;
    let across = min(y, INFINITE_LIMIT) * scale + select(FADDEEVA_COARSE_POLE, 0.0, huge);
    let inverse = 1.0 / (across * across + xs * xs);
    let q_re = across * inverse;
    let q_im = xs * inverse;
    let double_pole = select(FADDEEVA_COARSE_POLE + FADDEEVA_COARSE_POLE, 0.0, huge);
    let v = Complex {
        re: double_pole * q_re - 1.0,
        im: double_pole * q_im,
    };
    let p = faddeeva_polynomial_coarse(v);
    let unscale = select(scale, 0.0, largest > INFINITE_LIMIT);
    Complex {
        re: (q_re * p.re - q_im * p.im) * unscale,
        im: (q_re * p.im + q_im * p.re) * unscale,
    }
}

/// Returns w(z) of [`faddeeva_w`] to 5e-5.
#[inline(always)]
#[must_use]
pub fn faddeeva_w_coarse(re: f32, im: f32) -> Complex {
    faddeeva_in_plane(re, im, faddeeva_quadrant_coarse(abs(re), abs(im)))
}
