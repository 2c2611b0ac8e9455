//! The scaled difference of error functions, the integral of a Gaussian times a wave over a segment.
//!
//! # Definition
//!
//! ```math
//! G(a_1, a_2, b) = \frac{2}{\sqrt{\pi}} \int_{a_1}^{a_2} e^{-t^2 - 2ibt}\,dt
//! = e^{-b^2} \left[\mathrm{erf}(a_2 + ib) - \mathrm{erf}(a_1 + ib)\right]
//! ```
//!
//! The spatial phase of a scratch (VWH18 Eq. 5, WVJH17 Eqs. 23 and 24) is a multiple of it, with a = (s + l)/(sqrt2 sigma)
//! at the ends and b = sigma k xi/sqrt2. |G| <= 2.
//!
//! # Domain
//!
//! Every f64, infinite ends included. Equal ends give exactly 0, exchanged ends exactly the negative, and G(a1, a2, -b) is
//! exactly the conjugate of G(a1, a2, b). b = ±inf gives 0. NaN in any argument gives NaN in both components.
//!
//! # Methods
//!
//! With P(a, b) = exp(-b^2) erfc(a + i b) = exp(-a^2) exp(-2 i a b) w(-b + i a), a >= 0, the factor exp(-b^2) is gone: the
//! Faddeeva function [`w`](mod@super::faddeeva) is taken in the upper half plane alone, where it is bounded. Ends on
//! one side give P(a1) - P(a2), ends on both sides 2 exp(-b^2) - P(a2) - conj P(-a1). The phases come from exact products.
//!
//! A segment so short that the two would cancel (half its length times |m + i b| at most 1/4, m its middle) is a series
//! in the squares of that product, with the moments of exp(-t^2) over the segment as coefficients.
//!
//! <!-- report:begin erf_difference_scaled -->
//!
//! | method | what it is | precision | largest error | promise | time / baseline |
//! |---|---|---|---|---|---|
//! | `accurate` | iridescence f64 | f64 | 8.7e-16 of peak | 6 eps of peak | 0.76 (as_printed) |
//! | `accurate` | the same, by another measure | f64 | 103 eps | 150 eps | not timed |
//! | `accurate` | the same on finite a1, a2, b: scratches, segments from one ulp, far ends, \|b\| from 1e-300 to 1e308, subnormals, equal and opposite ends | f64 | 8.7e-16 of peak | 6 eps of peak | not timed |
//! | `accurate` | iridescence f32 | f32 | 5.3e-7 of peak | 1.4e-6 of peak | 0.95 (as_printed) |
//! | `turns` | iridescence f32, phases given in turns | f32 | 4.7e-7 of peak | 1.4e-6 of peak | 0.89 (as_printed) |
//! | `accurate`, slice | iridescence f32 slices | f32 | 5.3e-7 of peak | 1.4e-6 of peak | 0.17 (accurate, scalar) |
//! | `as_printed` | VWH18 Eq. 5, erf of errorfunctions 0.2.0 | f64 | not finite rel. | none | 1.00 (as_printed) |
//! | `as_printed` | VWH18 Eq. 5 in f32 | f32 | not finite rel. | none | 1.00 (as_printed) |
//!
//! <!-- report:end erf_difference_scaled -->
//!
//! # Where it fails
//!
//! Between its lobes G has zeros along curves; beside them the error stays a few eps of the neighbouring lobes.
//!
//! # Errata
//!
//! Both papers print exp(-b^2) times the difference, right as a formula. In floating point it is 0 times infinity as soon
//! as b^2 exceeds 745 (f64) or 104 (f32), over most of the hemisphere; see the failure map of the spatial phase.

use super::faddeeva::quadrant::{quadrant, square_parts};
use crate::numeric::complex_polynomial::{Pair, in_two, product};
use crate::numeric::exponential::times_exponential;
use crate::numeric::phase::{sine_cosine, two_sum};
use crate::numeric::product_phase::sine_cosine_of_twice_product;
use num_complex::Complex;

/// From here on exp(-a^2) is zero.
const FAR: f64 = 28.0;
/// Half the longest segment of the series.
const LONGEST: f64 = 0.5;
/// Bound of half the length times |m + i b|.
const SHORT: f64 = 0.25;
/// 2/sqrt(pi).
const TWO_INVERSE_SQRT_PI: f64 = core::f64::consts::FRAC_2_SQRT_PI;

/// Returns exp(-b^2) \[erf(a2 + i b) - erf(a1 + i b)\], dimensionless, |G| <= 2.
///
/// Any f64, infinite ends included; the exact symmetries and the limits stand in the module's page, with the errors.
/// VWH18 Eq. 5, WVJH17 Eqs. 23 and 24.
///
/// ```
/// use iridescence::special::erf_difference_scaled;
///
/// // A whole Gaussian: 2 exp(-b^2).
/// let whole = erf_difference_scaled(f64::NEG_INFINITY, f64::INFINITY, 1.0);
/// assert_eq!(whole.re, 2.0 * (-1.0_f64).exp());
/// // A segment of a scratch far out in the hemisphere: exp(-b^2) alone is 0 here, erf infinite.
/// let part = erf_difference_scaled(-1.0, 0.5, 700.0);
/// assert!(part.norm_sqr() > 1e-8 && part.norm_sqr() < 1e-6);
/// ```
#[must_use]
pub fn erf_difference_scaled(a1: f64, a2: f64, b: f64) -> Complex<f64> {
    if a1.is_nan() || a2.is_nan() || b.is_nan() {
        return Complex::new(f64::NAN, f64::NAN);
    }
    if a1 == a2 || b.abs() == f64::INFINITY {
        return Complex::new(0.0, 0.0);
    }
    let (low, high, exchanged) = if a1 < a2 { (a1, a2, false) } else { (a2, a1, true) };
    // Reflection: the segment from -high to -low has the conjugate value.
    let reflected = high <= 0.0 || (low < 0.0 && -low > high);
    let (low, high) = if reflected { (-high, -low) } else { (low, high) };
    let (re, im) = ordered(low, high, b.abs());
    let im = if reflected != b.is_sign_negative() { -im } else { im };
    if exchanged {
        Complex::new(0.0 - re, 0.0 - im)
    } else {
        Complex::new(0.0 + re, 0.0 + im)
    }
}

/// The value for low < high, high >= |low|, finite b >= 0.
fn ordered(low: f64, high: f64, b: f64) -> Pair {
    let (length, length_rest) = two_sum(high, -low);
    let half = 0.5 * length;
    if half <= LONGEST {
        let (twice_middle, rest) = two_sum(high, low);
        let middle = 0.5 * twice_middle;
        let (u, v) = (half * middle, half * b);
        if u * u + v * v <= SHORT * SHORT {
            return short([middle, 0.5 * rest], [half, 0.5 * length_rest], b);
        }
    }
    let far = complement(high, b);
    if low >= 0.0 {
        let near = complement(low, b);
        return (near.0 - far.0, near.1 - far.1);
    }
    let near = complement(-low, b);
    let (square, square_rest) = square_parts(b.min(FAR));
    let [whole] = times_exponential([2.0], -square, -square_rest);
    (whole - (far.0 + near.0), near.1 - far.1)
}

/// P(a, b) = exp(-b^2) erfc(a + i b) for a >= 0 and finite b >= 0.
fn complement(a: f64, b: f64) -> Pair {
    if a >= FAR {
        return (0.0, 0.0);
    }
    let (re, im) = quadrant(b, a);
    let (sine, cosine) = sine_cosine_of_twice_product(a, b);
    // w(-b + i a) is the conjugate of w(b + i a).
    let (re, im) = product((cosine, -sine), (re, -im));
    let (square, rest) = square_parts(a);
    let [re, im] = times_exponential([re, im], -square, -rest);
    (re, im)
}

/// A short segment: middle and half length in two parts each.
fn short([middle, middle_rest]: [f64; 2], [half, half_rest]: [f64; 2], b: f64) -> Pair {
    // G = (2/sqrt pi) exp(-m^2 - 2 i b m) h int_{-1}^{1} exp(-h^2 t^2) cosh(2 h (m + i b) t) dt.
    let p = half * half;
    let (u, v) = (2.0 * half * middle, 2.0 * half * b);
    let sum = moments_series(p, ((u - v) * (u + v), 2.0 * (u * v)));
    // The phase 2 b m, its first part reduced from the exact product, and the rest by the angle sum.
    let (sine, cosine) = sine_cosine_of_twice_product(middle.abs(), b);
    let sine = if middle < 0.0 { -sine } else { sine };
    let (rest_sine, rest_cosine) = sine_cosine(b * (2.0 * middle_rest));
    let phase = (
        cosine * rest_cosine - sine * rest_sine,
        -(sine * rest_cosine + cosine * rest_sine),
    );
    let (re, im) = product(sum, phase);
    let (square, square_rest) = square_parts(middle);
    let scale = 2.0 * TWO_INVERSE_SQRT_PI * (half + half_rest);
    let [re, im] = times_exponential(
        [scale * re, scale * im],
        -square,
        -square_rest - 2.0 * middle * middle_rest,
    );
    (re, im)
}

/// int_0^1 exp(-p t^2) cosh(sqrt(q) t) dt for 0 <= p <= 1/4 and |q| <= 1/4.
fn moments_series(p: f64, q: Pair) -> Pair {
    /// Moments in use: the next term is 1e-19 of the first.
    const TERMS: usize = 8;
    /// Where the recurrence starts, far enough that the moment left out does not count.
    const START: usize = 20;
    /// 1/(2 k)!.
    const INVERSE_FACTORIALS: [f64; TERMS] = [
        1.0,
        1.0 / 2.0,
        1.0 / 24.0,
        1.0 / 720.0,
        1.0 / 40320.0,
        1.0 / 3628800.0,
        1.0 / 479001600.0,
        1.0 / 87178291200.0,
    ];
    let [end] = times_exponential([1.0], -p, 0.0);
    // The moments of t^2k by partial integration, downwards: all terms are positive.
    let mut moment = 0.0;
    let mut coefficients = [0.0; TERMS];
    for k in (0..START).rev() {
        moment = (end + 2.0 * p * moment) / (2 * k + 1) as f64;
        if k < TERMS {
            coefficients[k] = moment * INVERSE_FACTORIALS[k];
        }
    }
    in_two::<TERMS>(|k| coefficients[k], q)
}
