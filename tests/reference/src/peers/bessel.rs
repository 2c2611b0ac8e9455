//! Other people's scaled Bessel functions of order 0 and 1, with log I0 and I1/I0 as a user would form them.

use spec_math::cephes64;

/// exp(-|x|) I0(x) by Cephes, through crate `spec_math`.
pub fn bessel_i0_scaled_cephes(x: f64) -> f64 {
    cephes64::i0e(x)
}

/// exp(-|x|) I0(x) by crate `pxfm`.
pub fn bessel_i0_scaled_pxfm(x: f64) -> f64 {
    pxfm::f_i0e(x)
}

/// exp(-|x|) I0(x) in f32 by crate `pxfm`.
pub fn bessel_i0_scaled_pxfm_f32(x: f32) -> f32 {
    pxfm::f_i0ef(x)
}

/// Cephes in f64, rounded to f32: what a CPU renderer would do.
pub fn bessel_i0_scaled_cephes_rounded(x: f32) -> f32 {
    cephes64::i0e(f64::from(x)) as f32
}

/// log I0(x) as |x| + log(exp(-|x|) I0(x)) by Cephes.
pub fn log_bessel_i0_cephes(x: f64) -> f64 {
    x.abs() + cephes64::i0e(x).ln()
}

/// log I0(x) as |x| + log(exp(-|x|) I0(x)) by crate `pxfm`.
pub fn log_bessel_i0_pxfm(x: f64) -> f64 {
    x.abs() + pxfm::f_i0e(x).ln()
}

/// I1(x)/I0(x) as a quotient of the scaled functions of Cephes.
pub fn bessel_i1_i0_ratio_cephes(x: f64) -> f64 {
    cephes64::i1e(x) / cephes64::i0e(x)
}

/// I1(x)/I0(x) as a quotient of the scaled functions of crate `pxfm`.
pub fn bessel_i1_i0_ratio_pxfm(x: f64) -> f64 {
    pxfm::f_i1e(x) / pxfm::f_i0e(x)
}
