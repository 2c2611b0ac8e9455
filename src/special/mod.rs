//! Special functions.
mod cells;
mod sinc;
mod sinc_squared_integral;
mod sine_integral;
mod tables;

pub use sinc::{sinc, sinc_derivative};
pub use sinc_squared_integral::{sinc_squared_integral, sinc_squared_integral_gradient, sinc_squared_integral_vwh18};
#[cfg(feature = "simd")]
pub(crate) use sine_integral::sine_integral_block;
pub use sine_integral::{sine_integral, sine_integral_vwh18};
