//! Other people's w(z), erf and their relatives.

use errorfunctions::{ComplexErrorFunctions, RealErrorFunctions};
use num_complex::Complex;
use special::Error;

type C = Complex<f64>;

/// w(z) by crate `errorfunctions`, a translation of the Faddeeva package.
pub fn faddeeva_w_errorfunctions(z: C) -> C {
    z.w()
}

/// w(z) by crate `puruspe`, a translation of libcerf.
pub fn faddeeva_w_puruspe(z: C) -> C {
    let (re, im) = puruspe::faddeeva(z.re, z.im);
    C::new(re, im)
}

/// w(z) in f64 by `errorfunctions`, rounded to f32: what a CPU renderer would do.
pub fn faddeeva_w_rounded(re: f32, im: f32) -> Complex<f32> {
    let w = C::new(f64::from(re), f64::from(im)).w();
    Complex::new(w.re as f32, w.im as f32)
}

/// w'(z) = 2i/sqrt(pi) - 2 z w(z) with a given w.
pub fn derivative(z: C, w: C) -> C {
    C::new(0.0, std::f64::consts::FRAC_2_SQRT_PI) - 2.0 * z * w
}

/// w'(z) from the w of `errorfunctions`.
pub fn faddeeva_w_derivative_errorfunctions(z: C) -> C {
    derivative(z, z.w())
}

/// erf(z) by crate `errorfunctions`.
pub fn erf_complex_errorfunctions(z: C) -> C {
    z.erf()
}

/// erfc(z) by crate `errorfunctions`.
pub fn erfc_complex_errorfunctions(z: C) -> C {
    z.erfc()
}

/// The erf difference by two w of the upper half plane from `errorfunctions`, b^2 cancelled by hand: what a careful user
/// would write.
pub fn erf_difference_by_w([a1, a2, b]: [f64; 3]) -> C {
    let tail = |a: f64, b: f64| (-a * a).exp() * C::cis(-2.0 * a * b) * C::new(-b, a).w();
    if a1 >= 0.0 && a2 >= 0.0 {
        tail(a1, b) - tail(a2, b)
    } else if a1 < 0.0 && a2 < 0.0 {
        (tail(-a2, b) - tail(-a1, b)).conj()
    } else if a1 < 0.0 {
        2.0 * (-b * b).exp() - tail(a2, b) - tail(-a1, b).conj()
    } else {
        -(2.0 * (-b * b).exp() - tail(a1, b) - tail(-a2, b).conj())
    }
}

/// Real erf by crate `libm`.
pub fn erf_libm(x: f64) -> f64 {
    libm::erf(x)
}

/// Real erf by crate `special`.
pub fn erf_special(x: f64) -> f64 {
    x.error()
}

/// Real erf by crate `puruspe`.
pub fn erf_puruspe(x: f64) -> f64 {
    puruspe::erf(x)
}

/// Real erf by crate `errorfunctions`.
pub fn erf_errorfunctions(x: f64) -> f64 {
    RealErrorFunctions::erf(x)
}

/// Real erf by Cephes, through crate `spec_math`.
pub fn erf_cephes(x: f64) -> f64 {
    spec_math::cephes64::erf(x)
}

/// Real erf by crate `pxfm`.
pub fn erf_pxfm(x: f64) -> f64 {
    pxfm::f_erf(x)
}

/// exp(x^2) erfc(x) by crate `errorfunctions`.
pub fn erfcx_errorfunctions(x: f64) -> f64 {
    RealErrorFunctions::erfcx(x)
}

/// exp(x^2) erfc(x) by crate `puruspe`.
pub fn erfcx_puruspe(x: f64) -> f64 {
    puruspe::erfcx(x)
}

/// exp(x^2) erfc(x) by crate `pxfm`.
pub fn erfcx_pxfm(x: f64) -> f64 {
    pxfm::f_erfcx(x)
}
