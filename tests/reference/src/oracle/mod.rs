//! True values to about 30 digits for f64 inputs, by two routes that share nothing with each other or with the crate.
//!
//! The fast route (this module) works in double-double: some microseconds a call. The slow route, [`arbitrary`], sums
//! the defining series and its asymptotic counterpart with several hundred bits. The tests hold the two against each
//! other and both against the certified digits in `data/golden`.
//!
//! The functions of scratches have 19 to 30 digits. Their second routes are the certified digits and plain quadrature of
//! the defining integrals, in the tests.

pub mod arbitrary;
mod arc;
mod asymptotic;
mod bessel;
mod complex;
mod distribution;
pub mod double_double;
mod elementary;
mod erf_difference;
mod error_function;
mod faddeeva;
mod footprint;
pub mod light;
mod profile;
mod reduction;
mod response;
mod scaled;
mod scaled_complex;
mod segment_energy;
mod sinc_squared_inverse;
mod spatial_phase;
mod taylor;
mod turn_fraction;
mod turns;
pub mod zeros;

pub use arc::sinc_squared_integral;
pub use bessel::{bessel_i0_scaled, bessel_i1_i0_ratio, log_bessel_i0};
pub use distribution::{gaussian_inverse, von_mises_fisher_pdf};
pub use elementary::{cosine, exponential, sine};
pub use erf_difference::erf_difference_scaled;
pub use error_function::{erf_complex, erfc_complex, erfcx};
pub use faddeeva::{faddeeva_w, faddeeva_w_derivative};
pub use footprint::{footprint_mean, footprint_mean_reduced, footprint_mean_reduced_edge};
pub use profile::{profile_rectangle, profile_triangle};
pub use response::{
    area_density, base_response, depth_term, response_rectangle_windowed, response_triangle, scratch_squared,
    spatial_phase_infinite,
};
pub use segment_energy::segment_energy;
pub use sinc_squared_inverse::sinc_squared_inverse;
pub use spatial_phase::spatial_phase;
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
