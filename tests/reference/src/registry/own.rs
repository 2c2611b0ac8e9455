//! The methods of this crate, the published fit among them, each with the bound it promises.

use super::{Budget, Call, Method, Metric, Origin, Precision};
use crate::generate::{Generator, arcs, points};
use Call::{F32, F32Slice, F64, F64Slice};
use Metric::{Absolute, Eps, Ulp};
use iridescence::{shader, simd, special};

const SI: &str = "sine_integral";
const ARC: &str = "sinc_squared_integral";

fn own(
    function: &'static str,
    method: &'static str,
    label: &'static str,
    call: Call,
    metric: Metric,
    bound: f64,
) -> Method {
    let double = call.precision() == Precision::F64;
    Method {
        function,
        method,
        label,
        precision: call.precision(),
        origin: if method == "vwh18" {
            Origin::Published
        } else {
            Origin::Ours
        },
        domain: if method == "vwh18" {
            domain_of_others(call.columns(), double)
        } else {
            domain(call.columns(), double)
        },
        slice_of: call.is_slice().then_some(method),
        call,
        budget: Some(Budget { metric, bound }),
        regions: Vec::new(),
    }
}

/// Where a peer or a published formula is judged: the domain of ours, but for arcs the range of scratches alone, in
/// either precision. Nobody else claims the far tails and the arcs of one last place that ours are held to.
pub(super) fn domain_of_others(columns: usize, double: bool) -> Generator {
    domain(columns, double && columns == 1)
}

/// One domain for all methods of a function and precision, so that a chart compares like with like.
pub(super) fn domain(columns: usize, double: bool) -> Generator {
    match (columns, double) {
        (1, true) => points::REAL_F64,
        (1, false) => points::REAL_F32,
        (3, _) => arcs::SCRATCH_TURNS_F32,
        (_, true) => arcs::ARC_F64,
        (_, false) => arcs::SCRATCH_F32,
    }
}

pub(super) fn methods() -> Vec<Method> {
    vec![
        own(
            SI,
            "accurate",
            "iridescence f64",
            F64(special::sine_integral),
            Ulp,
            0.75,
        ),
        own(
            SI,
            "vwh18",
            "VWH18 Eq. 29",
            F64(special::sine_integral_vwh18),
            Absolute,
            0.051,
        ),
        own(
            SI,
            "accurate",
            "iridescence f64 slices",
            F64Slice(simd::sine_integral),
            Ulp,
            0.75,
        ),
        own(SI, "accurate", "iridescence f32", F32(shader::sine_integral), Ulp, 2.0),
        own(
            SI,
            "medium",
            "iridescence f32 1e-5 tier",
            F32(shader::sine_integral_medium),
            Absolute,
            1e-5,
        ),
        own(
            SI,
            "coarse",
            "iridescence f32 4e-4 tier",
            F32(shader::sine_integral_coarse),
            Absolute,
            4e-4,
        ),
        own(
            SI,
            "vwh18",
            "VWH18 Eq. 29 f32",
            F32(shader::sine_integral_velinov),
            Absolute,
            0.051,
        ),
        own(
            SI,
            "accurate",
            "iridescence f32 slices",
            F32Slice(simd::shader::sine_integral),
            Ulp,
            2.0,
        ),
        own(
            SI,
            "medium",
            "iridescence f32 1e-5 slices",
            F32Slice(simd::shader::sine_integral_medium),
            Absolute,
            1e-5,
        ),
        own(
            SI,
            "coarse",
            "iridescence f32 4e-4 slices",
            F32Slice(simd::shader::sine_integral_coarse),
            Absolute,
            4e-4,
        ),
        own(
            SI,
            "vwh18",
            "VWH18 Eq. 29 f32 slices",
            F32Slice(simd::shader::sine_integral_velinov),
            Absolute,
            0.051,
        ),
        own(
            ARC,
            "accurate",
            "iridescence f64",
            Call::row(special::sinc_squared_integral),
            Eps,
            16.0,
        ),
        own(
            ARC,
            "vwh18",
            "VWH18 Eq. 27 with Eq. 29",
            Call::row(special::sinc_squared_integral_vwh18),
            Absolute,
            0.103,
        ),
        own(
            ARC,
            "accurate",
            "iridescence f32",
            Call::row(|[a, b]: [f32; 2]| shader::sinc_squared_integral(a, b)),
            Absolute,
            6e-7,
        ),
        own(
            ARC,
            "medium",
            "iridescence f32 1e-5 tier",
            Call::row(|[a, b]: [f32; 2]| shader::sinc_squared_integral_medium(a, b)),
            Absolute,
            5e-6,
        ),
        own(
            ARC,
            "coarse",
            "iridescence f32 4e-4 tier",
            Call::row(|[a, b]: [f32; 2]| shader::sinc_squared_integral_coarse(a, b)),
            Absolute,
            4e-4,
        ),
        own(
            ARC,
            "vwh18",
            "VWH18 Eq. 27 f32",
            Call::row(|[a, b]: [f32; 2]| shader::sinc_squared_integral_velinov(a, b)),
            Absolute,
            0.103,
        ),
        own(
            ARC,
            "accurate",
            "iridescence f32 slices",
            Call::rows(simd::shader::sinc_squared_integral),
            Absolute,
            6e-7,
        ),
        own(
            ARC,
            "medium",
            "iridescence f32 1e-5 slices",
            Call::rows(simd::shader::sinc_squared_integral_medium),
            Absolute,
            5e-6,
        ),
        own(
            ARC,
            "coarse",
            "iridescence f32 4e-4 slices",
            Call::rows(simd::shader::sinc_squared_integral_coarse),
            Absolute,
            4e-4,
        ),
        own(
            ARC,
            "vwh18",
            "VWH18 Eq. 27 f32 slices",
            Call::rows(simd::shader::sinc_squared_integral_velinov),
            Absolute,
            0.103,
        ),
        own("sinc", "accurate", "iridescence f64", F64(special::sinc), Ulp, 1.75),
        own(
            "sinc_squared_integral_turns",
            "accurate",
            "iridescence f32",
            Call::row(|[a, b, c]: [f32; 3]| shader::sinc_squared_integral_turns(a, b, c)),
            Absolute,
            6e-7,
        ),
        Method {
            domain: points::ANGLES_F32,
            ..own(
                "sine",
                "accurate",
                "iridescence f32",
                F32(|x| shader::sine_cosine(x).sine),
                Absolute,
                2e-7,
            )
        },
        Method {
            domain: points::ANGLES_F32,
            ..own(
                "cosine",
                "accurate",
                "iridescence f32",
                F32(|x| shader::sine_cosine(x).cosine),
                Absolute,
                2.5e-7,
            )
        },
        Method {
            domain: points::EXPONENTS_F32,
            ..own(
                "exponential",
                "accurate",
                "iridescence f32",
                F32(shader::exponential),
                Ulp,
                2.0,
            )
        },
    ]
}
