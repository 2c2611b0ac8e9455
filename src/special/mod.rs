//! Special functions in f64: sinc, the sine integral and the integral of sinc squared over an arc; the Faddeeva function,
//! the error functions and their scaled difference; the scaled Bessel function I0.
//!
//! All are accurate over the whole line. They call the `libm` crate or the crate's own sine and cosine, never the
//! platform's, and so give the same bits on every machine. A function whose name ends in a paper's short name
//! (`_vwh18`) is that paper's method, kept to compare with.
//!
//! | function | what it returns | errors |
//! |---|---|---|
//! | [`bessel_i0_scaled()`], [`log_bessel_i0`], [`bessel_i1_i0_ratio`] | exp(-\|x\|) I0(x), ln I0(x) and I1(x)/I0(x) | [`mod@bessel`] |
//! | [`faddeeva_w`], [`faddeeva_w_fine`], [`faddeeva_w_medium`], [`faddeeva_w_coarse`], [`faddeeva_w_derivative`] | w(z) and its derivative | [`mod@faddeeva`] |
//! | [`erf()`] | erf of a real argument | [`mod@erf`] |
//! | [`erf_complex`], [`erfc_complex`], [`erfcx`] | the error functions | [`mod@error_function`] |
//! | [`erf_difference_scaled`] | exp(-b^2) (erf(a2 + ib) - erf(a1 + ib)) | [`mod@erf_difference`] |
//! | [`sinc()`], [`sinc_derivative`] | sin x / x and its derivative | [`mod@sinc`] |
//! | [`sine_integral()`], [`sine_integral_vwh18`] | Si(x) | [`mod@sine_integral`] |
//! | [`sinc_squared_integral()`], [`sinc_squared_integral_gradient`], [`sinc_squared_integral_vwh18`] | the integral of (sin t / t)^2 over an arc, and its derivatives | [`mod@sinc_squared_integral`] |

pub mod bessel;
mod bessel_tables;
mod cells;
mod cosine_integral;
pub mod erf;
pub mod erf_difference;
mod erf_tables;
pub mod error_function;
pub mod faddeeva;
mod faddeeva_tables;
pub mod sinc;
pub mod sinc_squared_integral;
pub mod sine_integral;
mod tables;

#[cfg(feature = "simd")]
pub(crate) use bessel::bessel_i0_scaled_block;
pub use bessel::{bessel_i0_scaled, bessel_i1_i0_ratio, log_bessel_i0};
pub(crate) use cosine_integral::cosine_integral_entire;
#[doc(inline)]
pub use erf::erf;
#[cfg(feature = "simd")]
pub(crate) use erf::erf_block;
#[doc(inline)]
pub use erf_difference::erf_difference_scaled;
#[doc(inline)]
pub use error_function::{erf_complex, erfc_complex, erfcx};
#[cfg(feature = "simd")]
pub(crate) use faddeeva::slices as faddeeva_slices;
#[doc(inline)]
pub use faddeeva::{faddeeva_w, faddeeva_w_coarse, faddeeva_w_derivative, faddeeva_w_fine, faddeeva_w_medium};
#[doc(inline)]
pub use sinc::{sinc, sinc_derivative};
#[doc(inline)]
pub use sinc_squared_integral::{sinc_squared_integral, sinc_squared_integral_gradient, sinc_squared_integral_vwh18};
#[cfg(feature = "simd")]
pub(crate) use sine_integral::sine_integral_block;
#[doc(inline)]
pub use sine_integral::{sine_integral, sine_integral_vwh18};
