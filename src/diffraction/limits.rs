//! The values at the limits of the domain, and how small an argument leaves sinc and window at 1.

use num_complex::Complex;

/// No response.
pub(super) const ZERO: Complex<f64> = Complex { re: 0.0, im: 0.0 };
/// Outside the domain.
pub(super) const NAN: Complex<f64> = Complex {
    re: f64::NAN,
    im: f64::NAN,
};
/// 2^-27: a smaller argument changes sinc or a Gaussian by less than 2^-54.
pub(super) const FLAT: f64 = f64::from_bits((1023 - 27) << 52);
