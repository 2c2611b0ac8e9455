//! Other libraries' methods, on the domains of ours.

use super::own::domain_of_others;
use super::{Call, Method, Origin, Precision};
use crate::peers;
use Call::{F32, F64};

const SI: &str = "sine_integral";
const ARC: &str = "sinc_squared_integral";

fn peer(function: &'static str, method: &'static str, label: &'static str, call: Call) -> Method {
    let double = call.precision() == Precision::F64;
    Method {
        function,
        method,
        label,
        precision: call.precision(),
        origin: Origin::Peer,
        domain: domain_of_others(call.columns(), double),
        call,
        budget: None,
        slice_of: None,
        regions: Vec::new(),
    }
}

pub(super) fn methods() -> Vec<Method> {
    #[allow(unused_mut, reason = "GSL is added only with its feature")]
    let mut methods = vec![
        peer(
            SI,
            "cephes",
            "Cephes, Si and Ci (spec_math 0.1.6)",
            F64(peers::sine_integral_cephes),
        ),
        peer(
            SI,
            "galsim",
            "Pade of Rowe et al. 2015 (GalSim)",
            F64(peers::sine_integral_galsim),
        ),
        peer(
            SI,
            "cephes_rounded",
            "Cephes f64, Si and Ci, rounded to f32",
            F32(peers::sine_integral_cephes_rounded),
        ),
        peer(
            SI,
            "galsim",
            "Pade of Rowe et al. 2015 in f32",
            F32(peers::sine_integral_galsim_f32),
        ),
        peer(
            ARC,
            "cephes_antiderivative",
            "Eq. 27 with Cephes Si",
            Call::row(peers::sinc_squared_integral_cephes),
        ),
        peer(
            ARC,
            "galsim_antiderivative",
            "Eq. 27 with GalSim Si",
            Call::row(peers::sinc_squared_integral_galsim),
        ),
        peer(
            ARC,
            "quadrature",
            "double exponential (quadrature 0.1.2)",
            Call::row(peers::sinc_squared_integral_quadrature),
        ),
        peer(
            ARC,
            "rounded_antiderivative",
            "Eq. 27 with Si rounded to f32",
            Call::row(|[a, b]: [f32; 2]| peers::sinc_squared_integral_rounded(a, b)),
        ),
    ];
    #[cfg(feature = "gsl")]
    methods.extend([
        peer(SI, "gsl", "GSL (Debian libgsl)", F64(peers::sine_integral_gsl)),
        peer(
            ARC,
            "gsl_antiderivative",
            "Eq. 27 with GSL Si",
            Call::row(peers::sinc_squared_integral_gsl),
        ),
    ]);
    methods
}
