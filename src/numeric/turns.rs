//! Phases in turns: a b/c, and (a b + d e)/c, without the whole turns, from exact products.
//!
//! The common case costs two divisions at most. Numbers of extreme size, and quotients beyond 2^51, take the integers
//! that the numbers are made of: whatever its size, the phase of finite numbers is reduced without loss.

use super::ROUND;
use super::phase::{sine_cosine, two_product, two_sum};
use super::product_phase::integer;
use core::f64::consts::PI;

/// 2^450: below, no product and no part of one overflows.
const LARGEST: f64 = f64::from_bits((1023 + 450) << 52);
/// 2^-900: from here on the rounding error of a product is a normal number.
const SMALLEST: f64 = f64::from_bits((1023 - 900) << 52);
/// 2^51: below, a quotient rounds to the nearest integer by adding [`ROUND`].
const MANY_TURNS: f64 = f64::from_bits((1023 + 51) << 52);

/// Returns a b/c for c > 0 without overflow or underflow on the way.
#[inline(always)]
pub(crate) fn ratio(a: f64, b: f64, c: f64) -> f64 {
    let product = a * b;
    if product.abs() < LARGEST && product.abs() > SMALLEST {
        product / c
    } else {
        a / c * b
    }
}

/// Returns a b/c less its nearest integer, odd in each number, from the exact product; NaN unless all are numbers, a and
/// b finite and c other than 0.
///
/// The error is a few eps of the result.
#[inline]
pub(crate) fn turns_of_ratio(a: f64, b: f64, c: f64) -> f64 {
    let product = a * b;
    let size = product.abs();
    let common = size > SMALLEST
        && c.abs() > SMALLEST
        && size < MANY_TURNS * c.abs()
        && a.abs().max(b.abs()).max(c.abs()) < LARGEST;
    if common {
        fraction(two_product(a, b), c).1
    } else {
        turns_of_any_ratio(a, b, c)
    }
}

/// Returns (q, sin(pi q)) of q = a b/c for c > 0, the sine with a relative error of a few eps beside its zeros too.
#[inline]
pub(crate) fn sine_of_half_turns(a: f64, b: f64, c: f64) -> (f64, f64) {
    let quotient = ratio(a, b, c);
    let rest = turns_of_ratio(a, b, c);
    let (sine, _) = sine_cosine_of_turns(0.5 * rest);
    // The whole number that the turns left out, for its parity.
    let whole = if quotient.abs() < MANY_TURNS {
        (quotient - rest) + ROUND
    } else {
        (2.0 * turns_of_ratio(0.5 * a, b, c) - rest) + ROUND
    };
    (quotient, f64::from_bits(sine.to_bits() ^ whole.to_bits() << 63))
}

/// Returns (n/c, its turns) of n = a b + d e, the first of relative error eps whatever cancels in n, and the second n/c
/// less its nearest integer; c > 0.
#[inline]
pub(crate) fn turns_of_sum([a, b]: [f64; 2], [d, e]: [f64; 2], c: f64) -> (f64, f64) {
    let fits = |x: f64, y: f64| {
        let size = (x * y).abs();
        (size > SMALLEST || x == 0.0 || y == 0.0) && size < MANY_TURNS * c && x.abs().max(y.abs()) < LARGEST
    };
    if !(fits(a, b) && fits(d, e) && c > SMALLEST && c < LARGEST) {
        return turns_of_any_sum([a, b], [d, e], c);
    }
    let ((first, first_rest), (second, second_rest)) = (two_product(a, b), two_product(d, e));
    let (sum, rest) = two_sum(first, second);
    let (small, smaller) = two_sum(first_rest, second_rest);
    let (sum, rest) = two_sum(sum, rest + small);
    fraction((sum, rest + smaller), c)
}

/// The quotient of a number in two parts by c, and the same less its nearest integer.
#[inline(always)]
fn fraction((high, low): (f64, f64), c: f64) -> (f64, f64) {
    let inverse = 1.0 / c;
    let quotient = high * inverse;
    let whole = (quotient + ROUND) - ROUND;
    // What is left of the number after the whole turns is exact but for its last place.
    let (taken, taken_rest) = two_product(whole, c);
    let turns = ((high - taken) + (low - taken_rest)) * inverse;
    (quotient, turns - ((turns + ROUND) - ROUND))
}

/// [`turns_of_ratio`] of any numbers.
#[cold]
fn turns_of_any_ratio(a: f64, b: f64, c: f64) -> f64 {
    if (a == 0.0 && b.is_finite() || b == 0.0 && a.is_finite()) && !(c.is_nan() || c == 0.0) {
        return 0.0;
    }
    if c.is_infinite() && a.is_finite() && b.is_finite() {
        return 0.0;
    }
    let (Some(a_parts), Some(b_parts), Some(c_parts)) = (integer(a.abs()), integer(b.abs()), integer(c.abs())) else {
        return f64::NAN;
    };
    let turns = fraction_of_integers(a_parts, b_parts, c_parts);
    let negative = (a < 0.0) ^ (b < 0.0) ^ (c < 0.0);
    if negative { -turns } else { turns }
}

/// a b/c less its nearest integer for positive numbers m 2^e.
fn fraction_of_integers((a, ea): (u64, i32), (b, eb): (u64, i32), (c, ec): (u64, i32)) -> f64 {
    let product = u128::from(a) * u128::from(b);
    let exponent = ea + eb - ec;
    if exponent >= 0 {
        let modulus = u128::from(c);
        let rest = (product % modulus) * power_of_two_modulo(exponent, modulus) % modulus;
        return nearest(rest, modulus);
    }
    let shift = exponent.unsigned_abs();
    // The product is below 2^106.
    if shift + (64 - c.leading_zeros()) > 126 {
        return libm::scalbn(product as f64 / c as f64, exponent);
    }
    let modulus = u128::from(c) << shift;
    nearest(product % modulus, modulus)
}

/// rest/modulus, less 1 beyond 1/2.
fn nearest(rest: u128, modulus: u128) -> f64 {
    if rest > modulus / 2 {
        -((modulus - rest) as f64 / modulus as f64)
    } else {
        rest as f64 / modulus as f64
    }
}

/// 2^n modulo a number below 2^53.
fn power_of_two_modulo(n: i32, modulus: u128) -> u128 {
    let mut power = 1 % modulus;
    for bit in (0..16).rev() {
        power = power * power % modulus;
        if n >> bit & 1 == 1 {
            power = 2 * power % modulus;
        }
    }
    power
}

/// [`turns_of_sum`] of any numbers.
#[cold]
fn turns_of_any_sum([a, b]: [f64; 2], [d, e]: [f64; 2], c: f64) -> (f64, f64) {
    let turns = turns_of_ratio(a, b, c) + turns_of_ratio(d, e, c);
    if turns.is_nan() {
        return (turns, turns);
    }
    if c.is_infinite() {
        return (0.0, 0.0);
    }
    // The quotient from the fractions, at the scale of the larger product.
    let product = |x: f64, y: f64| {
        let ((x, n), (y, m)) = (libm::frexp(x), libm::frexp(y));
        (two_product(x, y), if x == 0.0 || y == 0.0 { -10000 } else { n + m })
    };
    let (((first, first_rest), n), ((second, second_rest), m)) = (product(a, b), product(d, e));
    let (c, k) = libm::frexp(c);
    let top = n.max(m);
    let (high, low) = two_sum(libm::scalbn(first, n - top), libm::scalbn(second, m - top));
    let rest = libm::scalbn(first_rest, n - top) + libm::scalbn(second_rest, m - top);
    let quotient = libm::scalbn((high + (low + rest)) / c, top - k);
    let turns = if quotient.abs() < 0.5 {
        quotient
    } else {
        turns - libm::rint(turns)
    };
    (quotient, turns)
}

/// Returns (sin, cos) of a number of turns, |turns| at most 2^50; the sine keeps its relative accuracy at 0.
#[inline(always)]
pub(crate) fn sine_cosine_of_turns(turns: f64) -> (f64, f64) {
    let half_turns = 2.0 * turns;
    let rounded = half_turns + ROUND;
    let (sine, cosine) = sine_cosine(PI * (half_turns - (rounded - ROUND)));
    let odd = rounded.to_bits() << 63;
    (
        f64::from_bits(sine.to_bits() ^ odd),
        f64::from_bits(cosine.to_bits() ^ odd),
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Random bits (splitmix64).
    fn bits(state: &mut u64) -> u64 {
        *state = state.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let z = (*state ^ (*state >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        z ^ (z >> 31)
    }

    /// A number of 53 random bits between 2^low and 2^high.
    fn number(state: &mut u64, low: i64, high: i64) -> f64 {
        let exponent = low + (bits(state) % (high - low) as u64) as i64;
        f64::from_bits(((exponent + 1023) as u64) << 52 | bits(state) >> 12)
    }

    /// The distance of two numbers of turns on the circle.
    fn apart(a: f64, b: f64) -> f64 {
        let d = (a - b).abs();
        d.min((1.0 - d).abs())
    }

    #[test]
    fn the_common_way_and_the_way_by_integers_agree() {
        let mut state = 1;
        for _ in 0..200_000 {
            let (a, b, c) = (
                number(&mut state, -60, 60),
                number(&mut state, -60, 10),
                number(&mut state, -10, 10),
            );
            if a * b >= MANY_TURNS * c {
                continue;
            }
            let (value, truth) = (turns_of_ratio(a, b, c), turns_of_any_ratio(a, b, c));
            assert!(
                apart(value, truth) <= 4.0 * f64::EPSILON * truth.abs(),
                "{a:e} {b:e} {c:e}: {value:e} {truth:e}"
            );
            assert_eq!(turns_of_ratio(-a, b, c), -value);
        }
    }

    #[test]
    fn integers_give_their_remainder_whatever_the_power_of_two() {
        // 2^n modulo 3 is 1 or 2, modulo 5 it runs through 1 2 4 3.
        for n in 0..1900 {
            let (half, rest) = (n / 2, n - n / 2);
            let (a, b) = (libm::exp2(f64::from(half)), libm::exp2(f64::from(rest)));
            let third = if n % 2 == 0 { 1.0 / 3.0 } else { -1.0 / 3.0 };
            assert_eq!(turns_of_ratio(a, b, 3.0), third, "{n}");
            let fifth = [0.2, 0.4, -0.2, -0.4][n as usize % 4];
            assert_eq!(turns_of_ratio(a, -b, 5.0), -fifth, "{n}");
        }
        assert_eq!(
            turns_of_ratio(f64::MAX, f64::MAX, 5e-324).abs(),
            0.0,
            "a multiple of the smallest number"
        );
        assert_eq!(turns_of_ratio(5e-324, 5e-324, 5e-324), 5e-324);
        assert_eq!(turns_of_ratio(5e-324, 0.75, 5e-324), -0.25);
        assert_eq!(turns_of_ratio(f64::MAX, 5e-324, 3e-324), 0.0);
        assert_eq!(turns_of_ratio(1e300, 1e-300, f64::MAX), 1e300 * 1e-300 / f64::MAX);
    }

    #[test]
    fn zeros_infinities_and_nan_have_their_limits() {
        assert_eq!(turns_of_ratio(0.0, 3.0, 2.0), 0.0);
        assert_eq!(turns_of_ratio(7.0, 3.0, f64::INFINITY), 0.0);
        for [a, b, c] in [
            [f64::INFINITY, 1.0, 1.0],
            [f64::INFINITY, 0.0, 1.0],
            [1.0, f64::NAN, 1.0],
            [1.0, 1.0, 0.0],
            [0.0, 1.0, 0.0],
            [0.0, 1.0, f64::NAN],
        ] {
            assert!(turns_of_ratio(a, b, c).is_nan(), "{a} {b} {c}");
        }
    }

    #[test]
    fn the_sum_of_two_products_keeps_its_digits_where_it_cancels() {
        let mut state = 2;
        for k in 0..100_000 {
            let (a, b, c) = (
                number(&mut state, -4, 4),
                number(&mut state, 0, 20),
                number(&mut state, -3, 3),
            );
            // d e = -(a b) (1 + t) to working precision.
            let d = number(&mut state, -4, 4);
            let e = -(a * b / d) * (1.0 + if k % 2 == 0 { 0.0 } else { number(&mut state, -50, -1) });
            let (quotient, turns) = turns_of_sum([a, b], [d, e], c);
            let ((p, pr), (q, qr)) = (two_product(a, b), two_product(d, e));
            // Both products have the same size: their difference is exact, or nearly.
            let truth = ((p + q) + (pr + qr)) / c;
            assert!(
                (quotient - truth).abs() <= 4.0 * f64::EPSILON * truth.abs(),
                "{a} {b} {d} {e} {c}: {quotient:e} {truth:e}"
            );
            assert!(
                apart(turns, truth - libm::rint(truth)) <= 4.0 * f64::EPSILON * (1.0 + truth.abs()),
                "{a} {b} {d} {e} {c}: {turns:e} {truth:e}"
            );
            let slow = turns_of_any_sum([a, b], [d, e], c);
            assert!(
                (slow.0 - quotient).abs() <= 4.0 * f64::EPSILON * quotient.abs()
                    && apart(slow.1, turns) <= 8.0 * f64::EPSILON,
                "{a} {b} {d} {e} {c}: {slow:?} {quotient:e} {turns:e}"
            );
        }
    }

    #[test]
    fn the_sine_of_half_turns_keeps_its_digits_beside_its_zeros_and_its_sign_everywhere() {
        let mut state = 3;
        for _ in 0..100_000 {
            let (a, c) = (number(&mut state, -9, 9), number(&mut state, -9, 9));
            let n = (bits(&mut state) % 1000) as f64 + 1.0;
            let b = n * c / a;
            // a b - n c, exact for numbers as close as these.
            let ((p, pr), (q, qr)) = (two_product(a, b), two_product(n, c));
            let rest = ((p - q) + (pr - qr)) / c;
            let due = PI * rest * if n % 2.0 == 0.0 { 1.0 } else { -1.0 };
            let (_, sine) = sine_of_half_turns(a, b, c);
            assert!(
                (sine - due).abs() <= 4.0 * f64::EPSILON * due.abs(),
                "{a} {b} {c}: {sine:e} {due:e}"
            );
            let b = number(&mut state, -20, 9);
            let (quotient, sine) = sine_of_half_turns(a, b, c);
            let (due, _) = sine_cosine_of_turns(turns_of_ratio(0.5 * a, b, c));
            assert!((sine - due).abs() <= 4.0 * f64::EPSILON, "{a} {b} {c}: {sine} {due}");
            assert!((quotient - a * b / c).abs() <= 2.0 * f64::EPSILON * quotient);
        }
        // Beyond 2^51 the parity comes from the integers: 2^60/3 = 384307168202282325 + 1/3.
        let (_, sine) = sine_of_half_turns(libm::exp2(30.0), libm::exp2(30.0), 3.0);
        assert!((sine + libm::sin(PI / 3.0)).abs() < 1e-15, "{sine}");
    }

    #[test]
    fn quarter_turns_are_exact_and_half_turns_change_the_sign() {
        for n in -9..=9 {
            let whole = f64::from(n);
            assert_eq!(sine_cosine_of_turns(whole).0.abs(), 0.0);
            assert_eq!(sine_cosine_of_turns(whole).1, 1.0);
            assert_eq!(sine_cosine_of_turns(whole + 0.5).1, -1.0);
            assert_eq!(sine_cosine_of_turns(whole + 0.25).0, 1.0);
            let (sine, cosine) = sine_cosine_of_turns(whole + 0.125);
            assert!((sine - cosine).abs() < 2e-16 && (sine * sine - 0.5).abs() < 1e-15);
        }
    }
}
