//! True values to about 30 digits for f64 inputs, by two routes that share nothing with each other or with the crate.
//!
//! The fast route (this module) works in double-double: some microseconds a call. The slow route, [`arbitrary`], sums
//! the defining series and its asymptotic counterpart with several hundred bits. The tests hold the two against each
//! other and both against the certified digits in `data/golden`.

pub mod arbitrary;
mod arc;
mod asymptotic;
mod bessel;
mod complex;
pub mod double_double;
mod elementary;
mod erf_difference;
mod error_function;
mod faddeeva;
mod reduction;
mod scaled;
mod taylor;
mod turns;
pub mod zeros;

pub use arc::sinc_squared_integral;
pub use bessel::{bessel_i0_scaled, bessel_i1_i0_ratio, log_bessel_i0};
pub use elementary::{cosine, exponential, sine};
pub use erf_difference::erf_difference_scaled;
pub use error_function::{erf_complex, erfc_complex, erfcx};
pub use faddeeva::{faddeeva_w, faddeeva_w_derivative};
pub use turns::sinc_squared_integral_turns;

use crate::metrics::Reference;
use double_double::{Dd, HALF_PI};

/// Si(x), the integral of sin t/t from 0 to `x`; +-pi/2 at the infinities, NaN for NaN, the sign of a zero kept.
pub fn sine_integral(x: f64) -> Reference {
    if x.is_nan() || x == 0.0 {
        return Reference::exact(x);
    }
    let size = x.abs();
    let value: Reference = if size.is_infinite() {
        HALF_PI.into()
    } else if size < taylor::SINE_INTEGRAL_END {
        taylor::sine_integral(size).into()
    } else {
        asymptotic::sine_integral(size).into()
    };
    if x < 0.0 { -value } else { value }
}

/// sin x/x; 1 at 0, 0 at the infinities, NaN for NaN.
pub fn sinc(x: f64) -> Reference {
    let size = x.abs();
    if x.is_nan() || size.is_infinite() {
        return Reference::exact(if x.is_nan() { x } else { 0.0 });
    }
    if size < 1e-20 {
        return Reference::exact(1.0);
    }
    let (sine, _) = reduction::sin_cos(size);
    if size > 1e150 {
        let Dd { hi, lo } = sine / (size * 2f64.powi(-600));
        return Reference { hi, lo, exponent: -600 };
    }
    (sine / size).into()
}
