//! The methods of the scaled I0, of log I0 and of I1/I0.

use super::faddeeva::{own, peer, region};
use super::{Call, Generator, Method, Metric, Precision};
use crate::generate::points;
use crate::peers::bessel as peers;
use Call::{F32, F32Slice, F64, F64Slice};
use Metric::Ulp;
use iridescence::{shader, simd, special};

const SCALED: &str = "bessel_i0_scaled";
const LOG: &str = "log_bessel_i0";
const RATIO: &str = "bessel_i1_i0_ratio";

fn domain(precision: Precision) -> Generator {
    match precision {
        Precision::F64 => points::REAL_F64,
        Precision::F32 => points::REAL_F32,
    }
}

fn ours(function: &'static str, label: &'static str, call: Call, bound: f64) -> Method {
    own(
        function,
        "accurate",
        label,
        call,
        &[region(domain(call.precision()), Ulp, bound)],
    )
}

fn other(function: &'static str, method: &'static str, label: &'static str, call: Call) -> Method {
    peer(function, method, label, call, domain(call.precision()), &[])
}

pub(super) fn methods() -> Vec<Method> {
    let mut methods = own_methods();
    methods.extend(others());
    methods
}

fn own_methods() -> Vec<Method> {
    vec![
        ours(SCALED, "iridescence f64", F64(special::bessel_i0_scaled), 1.0),
        ours(SCALED, "iridescence f64 slices", F64Slice(simd::bessel_i0_scaled), 1.0),
        ours(SCALED, "iridescence f32", F32(shader::bessel_i0_scaled), 1.0),
        ours(
            SCALED,
            "iridescence f32 slices",
            F32Slice(simd::shader::bessel_i0_scaled),
            1.0,
        ),
        ours(LOG, "iridescence f64", F64(special::log_bessel_i0), 2.0),
        ours(LOG, "iridescence f32", F32(shader::log_bessel_izero), 2.0),
        ours(RATIO, "iridescence f64", F64(special::bessel_i1_i0_ratio), 0.75),
        ours(RATIO, "iridescence f32", F32(shader::bessel_ratio), 2.0),
    ]
}

fn others() -> Vec<Method> {
    #[allow(unused_mut, reason = "GSL is added only with its feature")]
    let mut methods = vec![
        other(
            SCALED,
            "cephes",
            "Cephes (spec_math 0.1.6)",
            F64(peers::bessel_i0_scaled_cephes),
        ),
        other(SCALED, "pxfm", "crate pxfm 0.1.30", F64(peers::bessel_i0_scaled_pxfm)),
        other(
            SCALED,
            "pxfm",
            "crate pxfm 0.1.30 in f32",
            F32(peers::bessel_i0_scaled_pxfm_f32),
        ),
        other(
            SCALED,
            "cephes_rounded",
            "Cephes f64, rounded to f32",
            F32(peers::bessel_i0_scaled_cephes_rounded),
        ),
        other(
            LOG,
            "cephes",
            "|x| + log of Cephes' scaled I0",
            F64(peers::log_bessel_i0_cephes),
        ),
        other(
            LOG,
            "pxfm",
            "|x| + log of pxfm's scaled I0",
            F64(peers::log_bessel_i0_pxfm),
        ),
        other(
            RATIO,
            "cephes",
            "quotient of Cephes' scaled I1 and I0",
            F64(peers::bessel_i1_i0_ratio_cephes),
        ),
        other(
            RATIO,
            "pxfm",
            "quotient of pxfm's scaled I1 and I0",
            F64(peers::bessel_i1_i0_ratio_pxfm),
        ),
    ];
    #[cfg(feature = "gsl")]
    methods.extend([
        other(
            SCALED,
            "gsl",
            "GSL 2.7 (Debian)",
            F64(crate::peers::gsl::bessel_i0_scaled),
        ),
        other(
            RATIO,
            "gsl",
            "quotient of GSL's scaled I1 and I0",
            F64(crate::peers::gsl::bessel_i1_i0_ratio),
        ),
    ]);
    methods
}
