//! The cardinal sine, unnormalised, and its derivative.
//!
//! # Definition
//!
//! ```math
//! \mathrm{sinc}(x) = \frac{\sin x}{x}
//! ```
//!
//! # Domain
//!
//! Every f64, in radians. sinc(0) = 1, sinc(±inf) = 0, NaN gives NaN.

use crate::numeric::polynomial::Powers;

/// Returns sin x / x for `x` in radians, dimensionless; 1 at 0, 0 at ±inf.
///
/// The derivative of [`sine_integral`](super::sine_integral()).
#[must_use]
pub fn sinc(x: f64) -> f64 {
    if x == 0.0 {
        1.0
    } else if x.is_infinite() {
        0.0
    } else {
        libm::sin(x) / x
    }
}

/// Returns the derivative of [`sinc`], (cos x - sinc x)/x, in 1/rad; odd, 0 at 0 and at ±inf.
///
/// A Taylor series below |x| = 1, where the closed form cancels.
#[must_use]
pub fn sinc_derivative(x: f64) -> f64 {
    if x.abs() < 1.0 {
        // (-1)^n 2 (n+1) / (2n+3)!
        -x * Powers::of(x * x).eight([
            1.0 / 3.0,
            -1.0 / 30.0,
            1.0 / 840.0,
            -1.0 / 45360.0,
            1.0 / 3991680.0,
            -1.0 / 518918400.0,
            1.0 / 93405312000.0,
            -1.0 / 22230464256000.0,
        ])
    } else if x.is_infinite() {
        0.0
    } else {
        (libm::cos(x) - sinc(x)) / x
    }
}
