//! libcerf, from Debian's `libcerf-dev`.
//!
//! A `double _Complex` is passed and returned like a structure of two doubles on x86-64 and AArch64 (System V), which is
//! what `num_complex::Complex<f64>` is.
#![allow(unsafe_code)]

use super::error_function::derivative;
use num_complex::Complex;

type C = Complex<f64>;

mod library {
    use super::C;

    unsafe extern "C" {
        pub safe fn w_of_z(z: C) -> C;
        pub safe fn cerf(z: C) -> C;
        pub safe fn cerfc(z: C) -> C;
        pub safe fn erfcx(x: f64) -> f64;
    }
}

/// w(z).
pub fn faddeeva_w(z: C) -> C {
    library::w_of_z(z)
}

/// w'(z) from its w.
pub fn faddeeva_w_derivative(z: C) -> C {
    derivative(z, library::w_of_z(z))
}

/// erf(z).
pub fn erf_complex(z: C) -> C {
    library::cerf(z)
}

/// erfc(z).
pub fn erfc_complex(z: C) -> C {
    library::cerfc(z)
}

/// exp(x^2) erfc(x).
pub fn erfcx(x: f64) -> f64 {
    library::erfcx(x)
}

/// exp(-b^2) [erf(a2 + ib) - erf(a1 + ib)] as it stands.
pub fn erf_difference_as_printed([a1, a2, b]: [f64; 3]) -> C {
    (-b * b).exp() * (library::cerf(C::new(a2, b)) - library::cerf(C::new(a1, b)))
}
