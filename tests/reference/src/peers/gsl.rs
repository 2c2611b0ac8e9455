//! Si of the GNU Scientific Library, from Debian's `libgsl-dev`.
#![allow(unsafe_code)]

use std::ffi::{c_int, c_void};
use std::sync::Once;

/// `gsl_sf_result`.
#[repr(C)]
struct SfResult {
    value: f64,
    error: f64,
}

unsafe extern "C" {
    fn gsl_sf_Si_e(x: f64, result: *mut SfResult) -> c_int;
    fn gsl_set_error_handler_off() -> *mut c_void;
}

/// `gsl_sf_Si_e(x)`; NaN where GSL reports an error.
pub fn sine_integral(x: f64) -> f64 {
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
    let status = unsafe { gsl_sf_Si_e(x, &mut result) };
    if status == 0 { result.value } else { f64::NAN }
}
