//! The methods of erf: of a complex argument, on the real line alone, its complement, and the scaled complement.
//!
//! Most libraries have erf of a real argument only. They are methods of the function `erf`, beside ours and our complex
//! one at z = x.

use super::faddeeva::{Plane, own, peer, region};
use super::{Call, Generator, Method, Metric};
use crate::generate::complex_points as points;
use crate::generate::random::Random;
use crate::generate::worst;
use crate::peers::error_function as peers;
use Call::{F64, F64Slice};
use Metric::{Eps, Ulp};
use iridescence::{simd, special};
use num_complex::Complex;

const ERF_COMPLEX: &str = "erf_complex";
const ERFC_COMPLEX: &str = "erfc_complex";
const ERF: &str = "erf";
const ERFCX: &str = "erfcx";

/// The real line where erf is neither x nor 1.
pub(super) const ERF_LINE: Generator = Generator {
    name: "erf_line",
    domain: "recorded worst inputs, then half uniform in (-6, 6), half |x| log-uniform in 1e-300..30",
    columns: 1,
    rows: |seed, n| {
        let mut random = Random::new(seed);
        let draw = |_| match random.chance(0.5) {
            true => random.uniform(-6.0, 6.0),
            false => {
                let size = random.log_uniform(1e-300, 30.0);
                random.signed(size)
            }
        };
        let recorded = worst::recorded_for(&[ERF]).into_iter().flatten();
        recorded.chain((0..n).map(draw)).take(n).collect()
    },
};

/// The inputs of erf's timings: f32 numbers of moderate size.
pub(super) const ERF_TIMING: Generator = Generator {
    name: "erf_timing_f32",
    domain: "f32 x uniform in (-6, 6)",
    columns: 1,
    rows: |seed, n| {
        let mut random = Random::new(seed);
        (0..n).map(|_| f64::from(random.uniform(-6.0, 6.0) as f32)).collect()
    },
};

pub(super) fn methods() -> Vec<Method> {
    let mut methods = Vec::new();

    methods.extend(own_methods());
    methods.extend(others());
    methods
}

fn own_methods() -> Vec<Method> {
    let erf = [
        region(points::WHOLE_PLANE, Eps, 12.0),
        region(points::ZEROS_OF_ERF, Eps, 5.0),
    ];
    vec![
        own(
            ERF_COMPLEX,
            "accurate",
            "iridescence f64",
            Call::row(special::erf_complex),
            &erf,
        ),
        own(
            ERFC_COMPLEX,
            "accurate",
            "iridescence f64",
            Call::row(special::erfc_complex),
            &[region(points::WHOLE_PLANE, Eps, 8.0)],
        ),
        own(
            ERF,
            "accurate",
            "iridescence f64",
            F64(special::erf),
            &[region(ERF_LINE, Ulp, 0.501)],
        ),
        own(
            ERF,
            "accurate",
            "iridescence f64 slices",
            F64Slice(simd::erf),
            &[region(ERF_LINE, Ulp, 0.501)],
        ),
        own(
            ERF,
            "complex",
            "iridescence f64, complex erf at z = x",
            F64(|x| special::erf_complex(Complex::new(x, 0.0)).re),
            &[region(ERF_LINE, Ulp, 8.0)],
        ),
        own(
            ERFCX,
            "accurate",
            "iridescence f64",
            F64(special::erfcx),
            &[region(points::ERFCX_LINE, Ulp, 3.0)],
        ),
    ]
}

fn others() -> Vec<Method> {
    let complex = |method, label, call: Plane| {
        let further = [points::ZEROS_OF_ERF];
        peer(
            ERF_COMPLEX,
            method,
            label,
            Call::row(call),
            points::WHOLE_PLANE,
            &further,
        )
    };
    let complement =
        |method, label, call: Plane| peer(ERFC_COMPLEX, method, label, Call::row(call), points::WHOLE_PLANE, &[]);
    let real = |method, label, call| peer(ERF, method, label, F64(call), ERF_LINE, &[]);
    let scaled = |method, label, call| peer(ERFCX, method, label, F64(call), points::ERFCX_LINE, &[]);
    #[allow(unused_mut, reason = "GSL and libcerf are added only with their features")]
    let mut methods = vec![
        complex(
            "errorfunctions",
            "crate errorfunctions 0.2.0",
            peers::erf_complex_errorfunctions,
        ),
        complement(
            "errorfunctions",
            "crate errorfunctions 0.2.0",
            peers::erfc_complex_errorfunctions,
        ),
        real("libm", "crate libm 0.2.16", peers::erf_libm),
        real("special", "crate special 0.14.2", peers::erf_special),
        real("puruspe", "crate puruspe 0.4.4", peers::erf_puruspe),
        real(
            "errorfunctions",
            "crate errorfunctions 0.2.0",
            peers::erf_errorfunctions,
        ),
        real("cephes", "Cephes (spec_math 0.1.6)", peers::erf_cephes),
        real("pxfm", "crate pxfm 0.1.30", peers::erf_pxfm),
        scaled(
            "errorfunctions",
            "crate errorfunctions 0.2.0",
            peers::erfcx_errorfunctions,
        ),
        scaled("puruspe", "crate puruspe 0.4.4", peers::erfcx_puruspe),
        scaled("pxfm", "crate pxfm 0.1.30", peers::erfcx_pxfm),
    ];
    #[cfg(feature = "gsl")]
    methods.push(real("gsl", "GSL 2.7 (Debian)", crate::peers::gsl::erf));
    #[cfg(feature = "libcerf")]
    {
        use crate::peers::libcerf;
        methods.extend([
            complex("libcerf", "libcerf 1.3 (Debian)", libcerf::erf_complex),
            complement("libcerf", "libcerf 1.3 (Debian)", libcerf::erfc_complex),
            scaled("libcerf", "libcerf 1.3 (Debian)", libcerf::erfcx),
        ]);
    }
    methods
}
