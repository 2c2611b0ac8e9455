//! The Faddeeva function w, the complex error function scaled to stay finite in the upper half plane.
//!
//! # Definition
//!
//! ```math
//! w(z) = e^{-z^2}\,\mathrm{erfc}(-iz) = \frac{i}{\pi} \int_{-\infty}^{\infty} \frac{e^{-t^2}}{z - t}\,dt
//! \quad (\mathrm{Im}\, z > 0)
//! ```
//!
//! DLMF 7.2.3 and 7.7.2. Its real part on the upper half plane is the Voigt profile. The spatial phase of a scratch
//! (VWH18 Eq. 5) reduces to it, see [`erf_difference`](mod@super::erf_difference). w' = -2 z w + 2 i/sqrt(pi).
//!
//! # Domain
//!
//! Every complex number; infinite and NaN components as [`faddeeva_w`] states. w(-conj z) = conj w(z) exactly.
//!
//! # Methods
//!
//! In the quadrant x >= 0, y >= 0, with zeta = -i z = y - i x, w is erfcx(zeta), real for real zeta. Five regions have one
//! polynomial each, of real coefficients, minimax over the region, evaluated by the two-term recurrence that keeps the
//! imaginary part a multiple of the argument's:
//!
//! - |z| >= 7: w = (y + i x)(1 + f)/(sqrt(pi) |z|^2) with f a polynomial in 1/z^2, and exp(-x^2) beside the real axis;
//! - two rings below 7: the same with f = P(v)/(zeta + b)^2, v = (zeta - a)/(zeta + b). f is small, and with it its errors;
//! - about the origin: w(i) + (zeta - 1) P(v);
//! - y < 1/2 beside the real axis: exp(-z^2) plus a multiple of Dawson's integral from a table of cells, so that the small
//!   real part is a sum of small terms.
//!
//! In the lower half plane w(z) = 2 exp(-z^2) - w(-z), exponent and phase from exact products, whatever their size; within
//! 1/8 of the first twelve zeros a Taylor series about the zero. The tiers [`faddeeva_w_fine`], [`faddeeva_w_medium`] and
//! [`faddeeva_w_coarse`] are one polynomial for the whole upper half plane, w = P(v)/(zeta + L), v = (L - zeta)/(L + zeta)
//! (Weideman's form, SIAM J. Numer. Anal. 31, 1994, refitted for the largest relative error).
//!
//! <!-- report:begin faddeeva_w -->
//!
//! | method | what it is | precision | largest error | promise | time / baseline |
//! |---|---|---|---|---|---|
//! | `accurate` | iridescence f64 | f64 | 1.9 eps | 2 eps | 0.30 (errorfunctions) |
//! | `accurate` | the same, by another measure | f64 | 4.8 ulp | 8 ulp | not timed |
//! | `accurate` | the same on y < 0, more than 0.1 from every zero of w: the mirror image of the upper half plane, y^2 - x^2 <= 700 | f64 | 3.0 eps | 8 eps | not timed |
//! | `accurate` | the same on within 0.1 of the first 8 zeros of w and their mirror images, distance log-uniform from 1e-16 | f64 | 1.7 eps | 5 eps | not timed |
//! | `fine` | iridescence f64 1e-10 tier | f64 | 3.9e-11 rel. | 1e-10 rel. | 0.23 (errorfunctions) |
//! | `medium` | iridescence f64 4e-7 tier | f64 | 1.2e-7 rel. | 4e-7 rel. | 0.19 (errorfunctions) |
//! | `coarse` | iridescence f64 5e-5 tier | f64 | 2.4e-5 rel. | 5e-5 rel. | 0.14 (errorfunctions) |
//! | `accurate`, slice | iridescence f64 slices | f64 | 1.9 eps | 2 eps | 0.07 (errorfunctions) |
//! | `accurate`, slice | the same, by another measure | f64 | 4.8 ulp | 8 ulp | not timed |
//! | `accurate`, slice | the same on y < 0, more than 0.1 from every zero of w: the mirror image of the upper half plane, y^2 - x^2 <= 700 | f64 | 3.0 eps | 8 eps | not timed |
//! | `accurate`, slice | the same on within 0.1 of the first 8 zeros of w and their mirror images, distance log-uniform from 1e-16 | f64 | 1.7 eps | 5 eps | not timed |
//! | `fine`, slice | iridescence f64 1e-10 slices | f64 | 3.9e-11 rel. | 1e-10 rel. | 0.04 (errorfunctions) |
//! | `medium`, slice | iridescence f64 4e-7 slices | f64 | 1.2e-7 rel. | 4e-7 rel. | 0.03 (errorfunctions) |
//! | `coarse`, slice | iridescence f64 5e-5 slices | f64 | 2.4e-5 rel. | 5e-5 rel. | 0.03 (errorfunctions) |
//! | `accurate` | iridescence f32 | f32 | 2.5 eps | 4 eps | 0.25 (errorfunctions_rounded) |
//! | `accurate` | the same on f32 y < 0, more than 0.1 from every zero of w: the mirror image of the upper half plane, y^2 - x^2 <= 85 | f32 | 31 eps | 64 eps | not timed |
//! | `coarse` | iridescence f32 5e-5 tier | f32 | 2.5e-5 rel. | 5e-5 rel. | 0.13 (errorfunctions_rounded) |
//! | `accurate`, slice | iridescence f32 slices | f32 | 2.5 eps | 4 eps | 0.08 (accurate, scalar) |
//! | `accurate`, slice | the same on f32 y < 0, more than 0.1 from every zero of w: the mirror image of the upper half plane, y^2 - x^2 <= 85 | f32 | 31 eps | 64 eps | not timed |
//! | `coarse`, slice | iridescence f32 5e-5 slices | f32 | 2.5e-5 rel. | 5e-5 rel. | 0.09 (coarse, scalar) |
//!
//! <!-- report:end faddeeva_w -->
//!
//! <!-- report:begin faddeeva_w_derivative -->
//!
//! | method | what it is | precision | largest error | promise | time / baseline |
//! |---|---|---|---|---|---|
//! | `accurate` | iridescence f64 | f64 | 24 eps | 48 eps | 0.27 (errorfunctions) |
//!
//! <!-- report:end faddeeva_w_derivative -->
//!
//! # Where it fails
//!
//! Beside the zeros of w farther out than the first twelve the relative error grows as the inverse of the distance. The
//! tiers are accurate by norm: near the real axis a real part much smaller than |w| has no correct digit, and may be
//! negative by the tier's error.
//!
//! # Errata
//!
//! None known in the definition. Other implementations: see the failure map docs/failures/faddeeva_w.svg.

use super::faddeeva_tables::{W_ZEROS, Zero};
use crate::numeric::complex_polynomial::{Pair, product};
use crate::numeric::exponential::times_exponential;
use crate::numeric::phase::{two_product, two_sum};
use crate::numeric::product_phase::sine_cosine_of_twice_product;
use num_complex::Complex;
use quadrant::{HUGE, NEAR, deviation, quadrant};

pub(super) mod quadrant;
#[cfg(feature = "simd")]
pub(crate) mod slices;
mod tiers;

pub use tiers::{faddeeva_w_coarse, faddeeva_w_fine, faddeeva_w_medium};

/// 2/sqrt(pi).
const TWO_INVERSE_SQRT_PI: f64 = core::f64::consts::FRAC_2_SQRT_PI;
/// Distance from a zero within which its Taylor series is used.
const DISC: f64 = 0.125;

/// Returns w(z) = exp(-z^2) erfc(-i z), dimensionless, for any z.
///
/// Errors: the table above. w(-conj z) = conj w(z) holds exactly. NaN in either component gives NaN in both. Where z
/// tends to infinity in the upper half plane or along a horizontal line, w tends to 0; along the negative imaginary axis
/// to +infinity; elsewhere in the lower half plane an infinite z has no limit and gives NaN. A component beyond the range
/// of f64 is infinite. DLMF 7.2.3.
///
/// ```
/// use iridescence::{Complex, special};
///
/// let w = special::faddeeva_w(Complex::new(0.0, 1.0));
/// assert_eq!(w, Complex::new(0.427583576155807, 0.0)); // e erfc(1)
/// ```
#[doc(alias = "wofz")]
#[doc(alias = "w_of_z")]
#[doc(alias = "plasma dispersion function")]
#[must_use]
#[inline]
pub fn faddeeva_w(z: Complex<f64>) -> Complex<f64> {
    let (x, y) = (z.re.abs(), z.im.abs());
    if !(x < f64::INFINITY && y < f64::INFINITY) {
        return at_infinity(z);
    }
    let value = if z.im < 0.0 { lower(x, y) } else { quadrant(x, y) };
    mirrored(value, z.re)
}

/// Returns w'(z) = -2 z w(z) + 2 i/sqrt(pi), dimensionless, for any z, without the cancellation of the two far out.
///
/// w'(-conj z) = -conj w'(z) holds exactly. NaN in either component gives NaN in both; an infinite z gives the limit as
/// far as there is one: 0 where w tends to 0, else NaN. DLMF 7.10.2.
#[must_use]
pub fn faddeeva_w_derivative(z: Complex<f64>) -> Complex<f64> {
    let (x, y) = (z.re.abs(), z.im.abs());
    if !(x < f64::INFINITY && y < f64::INFINITY) {
        let limit = at_infinity(z);
        return if limit.re == 0.0 {
            limit
        } else {
            Complex::new(f64::NAN, f64::NAN)
        };
    }
    let above = derivative_in_quadrant(x, y);
    let (re, im) = if z.im < 0.0 {
        // w'(z) = -4 z exp(-z^2) + w'(-z).
        let [re, im] = gaussian_below(x, y, 4.0, (-x, y));
        (re - above.0, im + above.1)
    } else {
        above
    };
    let re = if z.re.is_sign_negative() { -re } else { re };
    Complex { re, im }
}

/// The value at -conj z where `sign` is negative, from the value at z.
#[inline(always)]
fn mirrored((re, im): Pair, sign: f64) -> Complex<f64> {
    let im = if sign.is_sign_negative() { -im } else { im };
    Complex { re, im }
}

/// w where a component of z is not finite.
#[cold]
fn at_infinity(z: Complex<f64>) -> Complex<f64> {
    let (x, y) = (z.re, z.im);
    let zero = f64::copysign(0.0, x);
    if x.is_nan() || y.is_nan() {
        Complex::new(f64::NAN, f64::NAN)
    } else if y > f64::NEG_INFINITY {
        Complex::new(0.0, zero)
    } else if x == 0.0 {
        Complex::new(f64::INFINITY, zero)
    } else {
        Complex::new(f64::NAN, f64::NAN)
    }
}

/// w(x - i y) for finite x >= 0, y > 0.
#[cold]
fn lower(x: f64, y: f64) -> Pair {
    if let Some(value) = near_a_zero(&W_ZEROS, x, -y) {
        return value;
    }
    reflected(x, y, quadrant(x, y))
}

/// w(x - i y) = 2 exp(-z^2) - w(-z) from w(x + i y), which is `above`.
fn reflected(x: f64, y: f64, above: Pair) -> Pair {
    let [re, im] = gaussian_below(x, y, 2.0, (1.0, 0.0));
    (re - above.0, im + above.1)
}

/// scale factor exp(-z^2) at z = x - i y, without overflow on the way.
#[inline]
fn gaussian_below(x: f64, y: f64, scale: f64, factor: Pair) -> [f64; 2] {
    let (high, low) = difference_of_squares(y, x);
    let (sine, cosine) = sine_cosine_of_twice_product(x, y);
    let (re, im) = product(factor, (cosine, sine));
    times_exponential([scale * re, scale * im], high, low)
}

/// a^2 - b^2 in two parts, beyond the exponential's range infinite.
#[inline(always)]
pub(super) fn difference_of_squares(a: f64, b: f64) -> (f64, f64) {
    if a.max(b) >= HUGE {
        return ((a - b) * HUGE, 0.0);
    }
    let ((sum, sum_rest), (gap, gap_rest)) = (two_sum(a, b), two_sum(a, -b));
    let (high, low) = two_product(gap, sum);
    two_sum(high, low + (gap * sum_rest + gap_rest * sum))
}

/// The function at x + i y from its Taylor series about a zero, if one is near.
#[inline]
pub(super) fn near_a_zero(zeros: &[Zero], x: f64, y: f64) -> Option<Pair> {
    // All lie near the diagonal, at most this far out.
    let reach = zeros.last().map_or(0.0, |zero| zero.re[0] + DISC);
    if !(x < reach && (x - y.abs()).abs() < 1.0) {
        return None;
    }
    let zero = zeros.iter().find(|zero| {
        let (dx, dy) = (x - zero.re[0], y - zero.im[0]);
        dx * dx + dy * dy < DISC * DISC
    })?;
    let d = ((x - zero.re[0]) - zero.re[1], (y - zero.im[0]) - zero.im[1]);
    let mut sum = (0.0, 0.0);
    for &[re, im] in zero.taylor.iter().rev() {
        sum = product(d, sum);
        sum = (sum.0 + re, sum.1 + im);
    }
    Some(product(d, sum))
}

/// w'(x + i y) for finite x >= 0, y >= 0.
fn derivative_in_quadrant(x: f64, y: f64) -> Pair {
    if x * x + y * y >= NEAR {
        // w' = (2/(i sqrt pi)) f with f = sqrt(pi) zeta w - 1.
        let (re, im) = deviation(x, y);
        return (TWO_INVERSE_SQRT_PI * im, -TWO_INVERSE_SQRT_PI * re);
    }
    let (re, im) = product((x, y), quadrant(x, y));
    (-2.0 * re, TWO_INVERSE_SQRT_PI - 2.0 * im)
}
