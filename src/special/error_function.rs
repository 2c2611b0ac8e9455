//! The error function erf and its complement erfc of a complex argument, and the scaled erfcx of a real one.
//!
//! # Definition
//!
//! ```math
//! \mathrm{erf}(z) = \frac{2}{\sqrt{\pi}} \int_0^z e^{-t^2}\,dt, \qquad \mathrm{erfc}(z) = 1 - \mathrm{erf}(z), \qquad
//! \mathrm{erfcx}(x) = e^{x^2} \mathrm{erfc}(x)
//! ```
//!
//! DLMF 7.2.1 to 7.2.3. The derivative of erf is 2/sqrt(pi) exp(-z^2). VWH18 Eq. 5 and WVJH17 Eq. 24 write the spatial
//! phase of a scratch with differences of erf: use
//! [`erf_difference_scaled`](super::erf_difference_scaled()) for those, which neither overflows nor cancels.
//!
//! # Domain
//!
//! Every complex number of finite components; infinities as each function states. erf is odd exactly, and all commute
//! with conjugation exactly. NaN in either component gives NaN in both.
//!
//! # Methods
//!
//! Below |z| = 5/4 erf is z times a polynomial in z^2. Beyond, erfc(z) = exp(-z^2) w(i z) for Re z >= 0 with the
//! Faddeeva function [`w`](mod@super::faddeeva), the exponent and the phase 2 Re z Im z taken from exact products.
//! Beside the imaginary axis erf is exp(-z^2) times Dawson's integral, which keeps the small real part. Within 1/8 of the
//! first twelve zeros of erf, and of erfc, a Taylor series about the zero keeps the relative accuracy.
//!
//! <!-- report:begin erf_complex -->
//!
//! | method | what it is | precision | largest error | promise | time / baseline |
//! |---|---|---|---|---|---|
//! | `accurate` | iridescence f64 | f64 | 8.7 eps | 12 eps | 0.45 (errorfunctions) |
//! | `accurate` | the same on within 0.1 of the first 8 zeros of erf and their images in all quadrants, distance log-uniform from 1e-16 | f64 | 1.7 eps | 5 eps | not timed |
//!
//! <!-- report:end erf_complex -->
//!
//! <!-- report:begin erfc_complex -->
//!
//! | method | what it is | precision | largest error | promise | time / baseline |
//! |---|---|---|---|---|---|
//! | `accurate` | iridescence f64 | f64 | 4.5 eps | 8 eps | 0.44 (errorfunctions) |
//!
//! <!-- report:end erfc_complex -->
//!
//! <!-- report:begin erfcx -->
//!
//! | method | what it is | precision | largest error | promise | time / baseline |
//! |---|---|---|---|---|---|
//! | `accurate` | iridescence f64 | f64 | 2.4 ulp | 3 ulp | 1.43 (errorfunctions) |
//!
//! <!-- report:end erfcx -->
//!
//! # Where it fails
//!
//! Beside the zeros of erf and erfc farther out than the first twelve the relative error grows as the inverse of the
//! distance. Components grow as exp(y^2 - x^2) and overflow to infinity.
//!
//! # Errata
//!
//! None known in the definitions.

use super::faddeeva::quadrant::{EDGE, dawson, quadrant};
use super::faddeeva::{difference_of_squares, near_a_zero};
use super::faddeeva_tables::{ERF, ERF_ZEROS, W_ZEROS};
use crate::numeric::complex_polynomial::{Pair, in_two, product, square};
use crate::numeric::exponential::times_exponential;
use crate::numeric::product_phase::sine_cosine_of_twice_product;
use num_complex::Complex;

/// |z|^2 below which erf is its power series in z^2, refitted.
const NEAR: f64 = 1.5625;

/// Returns erf(z), dimensionless, for any z.
///
/// Errors: the table above. erf(-z) = -erf(z) and erf(conj z) = conj erf(z) hold exactly. NaN in either component gives
/// NaN in both. Where |Re z| tends to infinity with a finite imaginary part, erf tends to ±1; other infinite z have no
/// limit and give NaN. A component beyond the range of f64 is infinite. DLMF 7.2.1.
///
/// ```
/// use iridescence::{Complex, special};
///
/// let erf = special::erf_complex(Complex::new(1.0, 0.0));
/// assert!((erf.re - 0.8427007929497149).abs() < 1e-15);
/// assert_eq!(erf.im, 0.0);
/// ```
#[doc(alias = "cerf")]
#[must_use]
pub fn erf_complex(z: Complex<f64>) -> Complex<f64> {
    let (x, y) = (z.re.abs(), z.im.abs());
    if !(x < f64::INFINITY && y < f64::INFINITY) {
        return if y < f64::INFINITY && x == f64::INFINITY {
            Complex::new(z.re.signum(), f64::copysign(0.0, z.im))
        } else {
            Complex::new(f64::NAN, f64::NAN)
        };
    }
    let (re, im) = erf_in_quadrant(x, y);
    Complex::new(with_sign(re, z.re), with_sign(im, z.im))
}

/// Returns erfc(z) = 1 - erf(z), dimensionless, for any z, without cancellation where erf is close to 1.
///
/// erfc(conj z) = conj erfc(z) holds exactly. NaN in either component gives NaN in both. Where Re z tends to +infinity with
/// a finite imaginary part erfc tends to 0, to -infinity to 2; other infinite z have no limit and give NaN. DLMF 7.2.2.
#[must_use]
pub fn erfc_complex(z: Complex<f64>) -> Complex<f64> {
    let (x, y) = (z.re.abs(), z.im.abs());
    if !(x < f64::INFINITY && y < f64::INFINITY) {
        let erf = erf_complex(z);
        return Complex::new(1.0 - erf.re, 0.0 - erf.im);
    }
    let (re, im) = if x < EDGE {
        let (re, im) = erf_in_quadrant(x, y);
        (1.0 - with_sign(re, z.re), -im)
    } else if z.re >= 0.0 {
        erfc_in_quadrant(x, y)
    } else if let Some((re, im)) = near_a_zero(&W_ZEROS, y, -x) {
        // erfc(z) = exp(-z^2) w(i z), and i z lies beside a zero of w.
        let [re, im] = times_gaussian(x, y, |sine, cosine| [cosine * re + sine * im, sine * re - cosine * im]);
        (re, im)
    } else {
        let (re, im) = erfc_in_quadrant(x, y);
        (2.0 - re, im)
    };
    Complex::new(re, with_sign(im, z.im))
}

/// Returns exp(x^2) erfc(x), dimensionless, for any real x.
///
/// x -> +inf gives 0, x -> -inf gives +inf; NaN gives NaN. It is w(i x), DLMF 7.2.3.
///
/// ```
/// assert_eq!(iridescence::special::erfcx(0.0), 1.0);
/// ```
#[must_use]
pub fn erfcx(x: f64) -> f64 {
    super::faddeeva_w(Complex::new(0.0, x)).re
}

/// `value` for a coordinate >= 0, carried to the coordinate's own sign.
#[inline(always)]
fn with_sign(value: f64, coordinate: f64) -> f64 {
    if coordinate.is_sign_negative() { -value } else { value }
}

/// exp(y^2 - x^2) times what `factors` makes of the sine and cosine of 2 x y, for finite x, y >= 0.
#[inline]
fn times_gaussian(x: f64, y: f64, factors: impl Fn(f64, f64) -> [f64; 2]) -> [f64; 2] {
    let (sine, cosine) = sine_cosine_of_twice_product(x, y);
    let (high, low) = difference_of_squares(y, x);
    times_exponential(factors(sine, cosine), high, low)
}

/// erf(x + i y) for finite x, y >= 0.
fn erf_in_quadrant(x: f64, y: f64) -> Pair {
    if x * x + y * y < NEAR {
        return product((x, y), in_two::<{ ERF.len() }>(|k| ERF[k], square((x, y))));
    }
    if let Some(value) = near_a_zero(&ERF_ZEROS, x, y) {
        return value;
    }
    if x < EDGE {
        // erf(z) = exp(-z^2) (2/(i sqrt pi)) D(i z) with Dawson's integral D: no 1 is added and taken away.
        let (p, q) = dawson(y, x);
        let [re, im] = times_gaussian(x, y, |sine, cosine| [q * cosine + p * sine, p * cosine - q * sine]);
        return (re, im);
    }
    let (re, im) = erfc_in_quadrant(x, y);
    (1.0 - re, -im)
}

/// erfc(x + i y) = exp(-z^2) w(i z) for finite x >= 1/2, y >= 0.
fn erfc_in_quadrant(x: f64, y: f64) -> Pair {
    let (p, q) = quadrant(y, x);
    let [re, im] = times_gaussian(x, y, |sine, cosine| [p * cosine - q * sine, -(p * sine + q * cosine)]);
    (re, im)
}
