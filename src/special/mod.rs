//! Special functions in f64: sinc, the sine integral, and the integral of sinc squared over an arc.
//!
//! All are accurate over the whole line. They call the `libm` crate or the crate's own sine and cosine, never the
//! platform's, and so give the same bits on every machine. A function whose name ends in a paper's short name
//! (`_vwh18`) is that paper's method, kept to compare with.
//!
//! | function | what it returns | errors |
//! |---|---|---|
//! | [`sinc()`], [`sinc_derivative`] | sin x / x and its derivative | [`mod@sinc`] |
//! | [`sine_integral()`], [`sine_integral_vwh18`] | Si(x) | [`mod@sine_integral`] |
//! | [`sinc_squared_integral()`], [`sinc_squared_integral_gradient`], [`sinc_squared_integral_vwh18`] | the integral of (sin t / t)^2 over an arc, and its derivatives | [`mod@sinc_squared_integral`] |

mod cells;
pub mod sinc;
pub mod sinc_squared_integral;
pub mod sine_integral;
mod tables;

#[doc(inline)]
pub use sinc::{sinc, sinc_derivative};
#[doc(inline)]
pub use sinc_squared_integral::{sinc_squared_integral, sinc_squared_integral_gradient, sinc_squared_integral_vwh18};
#[cfg(feature = "simd")]
pub(crate) use sine_integral::sine_integral_block;
#[doc(inline)]
pub use sine_integral::{sine_integral, sine_integral_vwh18};
