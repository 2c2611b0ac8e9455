//! The inverse of the Gaussian's distribution function.
//!
//! # Definition
//!
//! ```math
//! u = \frac{1}{\sqrt\pi} \int_{-\infty}^{y} e^{-t^2}\,dt = \frac{1 + \mathrm{erf}\,y}{2}
//! ```
//!
//! The component of a sample along a scratch is y/(k sigma).
//!
//! # Domain
//!
//! 0 <= u <= 1; 0 gives -inf, 1/2 gives 0, 1 gives inf, anything else NaN. Antisymmetric about 1/2 exactly.
//!
//! # Methods
//!
//! The closed form of Winitzki 2008 for the inverse of erf, which keeps the leading term of both ends, starts two
//! steps of Halley's method: on erf in the middle half, on the logarithm of erfc, by way of erfcx, in the tails.
//!
//! # Where it fails
//!
//! Nowhere known.
//!
//! # Errata
//!
//! None.

use crate::special::{erf, erfcx};
use core::f64::consts::{FRAC_2_SQRT_PI, PI};

/// The constant of Winitzki's form.
const WINITZKI: f64 = 0.147;

/// Returns the y at which int_{-inf}^{y} exp(-t^2) dt/sqrt(pi) is `u`.
///
/// ```
/// use iridescence::sampling::gaussian_inverse;
/// assert_eq!(gaussian_inverse(0.5), 0.0);
/// assert_eq!(gaussian_inverse(0.125), -gaussian_inverse(0.875));
/// assert_eq!(gaussian_inverse(0.0), f64::NEG_INFINITY);
/// ```
#[must_use]
pub fn gaussian_inverse(u: f64) -> f64 {
    if !(0.0..=1.0).contains(&u) {
        f64::NAN
    } else if u < 0.25 {
        -tail(u)
    } else if u <= 0.75 {
        middle(2.0 * u - 1.0)
    } else {
        tail(1.0 - u)
    }
}

/// Winitzki's form from ln(1 - x^2).
#[inline]
fn guess(logarithm: f64) -> f64 {
    let half = 2.0 / (PI * WINITZKI) + 0.5 * logarithm;
    let part = -logarithm / WINITZKI;
    libm::sqrt(part / (libm::sqrt(half * half + part) + half))
}

/// The y with erf y = x, for |x| <= 1/2.
fn middle(x: f64) -> f64 {
    let mut y = guess(libm::log1p(-x * x)).copysign(x);
    for _ in 0..2 {
        let ratio = (erf(y) - x) * libm::exp(y * y) / FRAC_2_SQRT_PI;
        y -= ratio / (1.0 + y * ratio);
    }
    y
}

/// The y > 0 with erfc y = 2 u, for 0 <= u < 1/4.
fn tail(u: f64) -> f64 {
    if u == 0.0 {
        return f64::INFINITY;
    }
    let logarithm = libm::log(2.0 * u);
    let mut y = guess(logarithm + libm::log(2.0 - 2.0 * u));
    for _ in 0..2 {
        let scaled = erfcx(y);
        // Of ln erfc y, which falls as -y^2: the derivative is -slope.
        let slope = FRAC_2_SQRT_PI / scaled;
        let ratio = (libm::log(scaled) - y * y - logarithm) / slope;
        y += ratio / (1.0 + ratio * (0.5 * slope - y));
    }
    y
}
