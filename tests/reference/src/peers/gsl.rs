//! Functions of the GNU Scientific Library, from Debian's `libgsl-dev`.
#![allow(unsafe_code)]

use std::ffi::{c_int, c_void};
use std::sync::Once;

/// `gsl_sf_result`.
#[repr(C)]
struct SfResult {
    value: f64,
    error: f64,
}

type Function = unsafe extern "C" fn(f64, *mut SfResult) -> c_int;

unsafe extern "C" {
    fn gsl_sf_Si_e(x: f64, result: *mut SfResult) -> c_int;
    fn gsl_sf_erf_e(x: f64, result: *mut SfResult) -> c_int;
    fn gsl_sf_bessel_I0_scaled_e(x: f64, result: *mut SfResult) -> c_int;
    fn gsl_sf_bessel_I1_scaled_e(x: f64, result: *mut SfResult) -> c_int;
    fn gsl_set_error_handler_off() -> *mut c_void;
}

/// A function of GSL; NaN where it reports an error.
#[inline(always)]
fn value(function: Function, x: f64) -> f64 {
    static QUIET: Once = Once::new();
    // GSL's default handler aborts the process.
    QUIET.call_once(|| {
        // SAFETY: takes nothing, replaces a pointer inside the library.
        unsafe { gsl_set_error_handler_off() };
    });
    let mut result = SfResult {
        value: f64::NAN,
        error: 0.0,
    };
    // SAFETY: `result` is a live object with the layout of `gsl_sf_result`.
    let status = unsafe { function(x, &mut result) };
    if status == 0 { result.value } else { f64::NAN }
}

/// `gsl_sf_Si_e(x)`.
pub fn sine_integral(x: f64) -> f64 {
    value(gsl_sf_Si_e, x)
}

/// `gsl_sf_erf_e(x)`.
pub fn erf(x: f64) -> f64 {
    value(gsl_sf_erf_e, x)
}

/// `gsl_sf_bessel_I0_scaled_e(x)`.
pub fn bessel_i0_scaled(x: f64) -> f64 {
    value(gsl_sf_bessel_I0_scaled_e, x)
}

/// The quotient of `gsl_sf_bessel_I1_scaled_e(x)` and `gsl_sf_bessel_I0_scaled_e(x)`.
pub fn bessel_i1_i0_ratio(x: f64) -> f64 {
    value(gsl_sf_bessel_I1_scaled_e, x) / value(gsl_sf_bessel_I0_scaled_e, x)
}
