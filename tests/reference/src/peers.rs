//! Other people's methods, wrapped to one signature. Each arc peer is a sine integral put into the exact antiderivative
//! of VWH18 Eq. 27, N(q) = Si(2q) - sin^2(q)/q, except for the quadrature.
//!
//! Not here, with the reason: crate `special-fun` (Cephes in C) links functions named `sin`, `exp`, `pow` ... that replace
//! the platform's in the whole program; crate `scirs2-special` is wrong by 1e15 ulp.

pub mod bessel;
pub mod error_function;
pub mod footprint;
mod galsim;
#[cfg(feature = "gsl")]
pub mod gsl;
#[cfg(feature = "libcerf")]
pub mod libcerf;
pub mod light;

/// Si by Cephes, through crate `spec_math`; it computes Ci in the same call.
pub fn sine_integral_cephes(x: f64) -> f64 {
    spec_math::cephes64::sici(x).0
}

/// Si by the Pade forms of Rowe et al. 2015 (GalSim), f64.
pub fn sine_integral_galsim(x: f64) -> f64 {
    galsim::sine_integral(x)
}

/// The same forms evaluated in f32.
pub fn sine_integral_galsim_f32(x: f32) -> f32 {
    galsim::sine_integral_f32(x)
}

/// Cephes in f64, rounded to f32: what a CPU renderer would do.
pub fn sine_integral_cephes_rounded(x: f32) -> f32 {
    sine_integral_cephes(f64::from(x)) as f32
}

/// Si by the GNU Scientific Library.
#[cfg(feature = "gsl")]
pub fn sine_integral_gsl(x: f64) -> f64 {
    gsl::sine_integral(x)
}

/// N(q) with a given Si; 0 at q = 0, where the printed form is 0/0.
fn antiderivative(q: f64, si: fn(f64) -> f64) -> f64 {
    if q == 0.0 {
        return 0.0;
    }
    let twice = (2.0 * q).clamp(f64::MIN, f64::MAX);
    si(twice) - q.sin() * q.sin() / q
}

fn arc([q0, q1]: [f64; 2], si: fn(f64) -> f64) -> f64 {
    antiderivative(q1, si) - antiderivative(q0, si)
}

/// Arc by Cephes' Si in the antiderivative.
pub fn sinc_squared_integral_cephes(q: [f64; 2]) -> f64 {
    arc(q, sine_integral_cephes)
}

/// Arc by GalSim's Si in the antiderivative.
pub fn sinc_squared_integral_galsim(q: [f64; 2]) -> f64 {
    arc(q, galsim::sine_integral)
}

/// Arc by GSL's Si in the antiderivative.
#[cfg(feature = "gsl")]
pub fn sinc_squared_integral_gsl(q: [f64; 2]) -> f64 {
    arc(q, gsl::sine_integral)
}

/// Arc by double-exponential quadrature (crate `quadrature`), absolute tolerance 1e-15.
pub fn sinc_squared_integral_quadrature([q0, q1]: [f64; 2]) -> f64 {
    let integrand = |t: f64| {
        let sinc = if t == 0.0 { 1.0 } else { t.sin() / t };
        sinc * sinc
    };
    quadrature::double_exponential::integrate(integrand, q0, q1, 1e-15).integral
}

/// Arc in f32 from an exact Si rounded to f32: what any better Si would give in a shader that keeps Eq. 27.
pub fn sinc_squared_integral_rounded(q0: f32, q1: f32) -> f32 {
    let antiderivative = |q: f32| {
        if q == 0.0 {
            return 0.0;
        }
        sine_integral_cephes(2.0 * f64::from(q)) as f32 - q.sin() * q.sin() / q
    };
    antiderivative(q1) - antiderivative(q0)
}
