//! The methods of w(z) and of its derivative: ours with the bounds they promise, and the peers on the same points.

use super::{Budget, Call, Method, Metric, Origin, Region};
use crate::generate::{Generator, complex_points as points};
use crate::peers::error_function as peers;
use Metric::{Eps, Relative, Ulp};
use iridescence::{shader, simd, special};
use num_complex::Complex;

const W: &str = "faddeeva_w";
const DERIVATIVE: &str = "faddeeva_w_derivative";

/// A complex function of a complex number.
pub(super) type Plane = fn(Complex<f64>) -> Complex<f64>;

/// A complex result of the f32 subset as a complex number.
pub(super) fn complex(z: shader::Complex) -> Complex<f32> {
    Complex::new(z.re, z.im)
}

pub(super) fn region(domain: Generator, metric: Metric, bound: f64) -> Region {
    Region {
        domain,
        budget: Some(Budget { metric, bound }),
    }
}

/// A method of ours, judged first on `main` and then on the others.
pub(super) fn own(
    function: &'static str,
    method: &'static str,
    label: &'static str,
    call: Call,
    regions: &[Region],
) -> Method {
    let (main, others) = regions.split_first().expect("a method has a main domain");
    Method {
        function,
        method,
        label,
        precision: call.precision(),
        origin: Origin::Ours,
        domain: main.domain,
        budget: main.budget,
        slice_of: call.is_slice().then_some(method),
        call,
        regions: others.to_vec(),
    }
}

/// A method of others, judged on the same points.
pub(super) fn peer(
    function: &'static str,
    method: &'static str,
    label: &'static str,
    call: Call,
    main: Generator,
    others: &[Generator],
) -> Method {
    let region = |domain: &Generator| Region {
        domain: *domain,
        budget: None,
    };
    Method {
        function,
        method,
        label,
        precision: call.precision(),
        origin: Origin::Peer,
        domain: main,
        budget: None,
        slice_of: None,
        call,
        regions: others.iter().map(region).collect(),
    }
}

/// A tier of w: one relative bound above the real axis.
fn tier(bound: f64) -> [Region; 1] {
    [region(points::UPPER_HALF_PLANE, Relative, bound)]
}

fn tier_f32(bound: f64) -> [Region; 1] {
    [region(points::UPPER_HALF_PLANE_F32, Relative, bound)]
}

pub(super) fn methods() -> Vec<Method> {
    let mut methods = own_methods();
    methods.extend(own_methods_f32());
    methods.extend(others());
    methods
}

fn own_methods() -> Vec<Method> {
    let accurate = [
        region(points::UPPER_HALF_PLANE, Eps, 2.0),
        region(points::UPPER_HALF_PLANE, Ulp, 8.0),
        region(points::LOWER_HALF_PLANE, Eps, 8.0),
        region(points::ZEROS_OF_W, Eps, 5.0),
    ];
    let derivative = [region(points::UPPER_HALF_PLANE, Eps, 48.0)];
    let (fine, medium, coarse) = (tier(1e-10), tier(4e-7), tier(5e-5));
    let own_w = |method, label, call, regions: &[Region]| own(W, method, label, call, regions);
    vec![
        own_w("accurate", "iridescence f64", Call::row(special::faddeeva_w), &accurate),
        own_w(
            "fine",
            "iridescence f64 1e-10 tier",
            Call::row(special::faddeeva_w_fine),
            &fine,
        ),
        own_w(
            "medium",
            "iridescence f64 4e-7 tier",
            Call::row(special::faddeeva_w_medium),
            &medium,
        ),
        own_w(
            "coarse",
            "iridescence f64 5e-5 tier",
            Call::row(special::faddeeva_w_coarse),
            &coarse,
        ),
        own_w(
            "accurate",
            "iridescence f64 slices",
            Call::rows(simd::faddeeva_w),
            &accurate,
        ),
        own_w(
            "fine",
            "iridescence f64 1e-10 slices",
            Call::rows(simd::faddeeva_w_fine),
            &fine,
        ),
        own_w(
            "medium",
            "iridescence f64 4e-7 slices",
            Call::rows(simd::faddeeva_w_medium),
            &medium,
        ),
        own_w(
            "coarse",
            "iridescence f64 5e-5 slices",
            Call::rows(simd::faddeeva_w_coarse),
            &coarse,
        ),
        own(
            DERIVATIVE,
            "accurate",
            "iridescence f64",
            Call::row(special::faddeeva_w_derivative),
            &derivative,
        ),
    ]
}

fn own_methods_f32() -> Vec<Method> {
    let single = [
        region(points::UPPER_HALF_PLANE_F32, Eps, 4.0),
        region(points::LOWER_HALF_PLANE_F32, Eps, 64.0),
    ];
    let coarse_f32 = tier_f32(5e-5);
    let own_w = |method, label, call, regions: &[Region]| own(W, method, label, call, regions);
    vec![
        own_w(
            "accurate",
            "iridescence f32",
            Call::row(|[re, im]: [f32; 2]| complex(shader::faddeeva_w(re, im))),
            &single,
        ),
        own_w(
            "coarse",
            "iridescence f32 5e-5 tier",
            Call::row(|[re, im]: [f32; 2]| complex(shader::faddeeva_w_coarse(re, im))),
            &coarse_f32,
        ),
        own_w(
            "accurate",
            "iridescence f32 slices",
            Call::rows(simd::shader::faddeeva_w),
            &single,
        ),
        own_w(
            "coarse",
            "iridescence f32 5e-5 slices",
            Call::rows(simd::shader::faddeeva_w_coarse),
            &coarse_f32,
        ),
    ]
}

/// Peers of the tests of w; `puruspe` asserts on nothing in these domains.
fn others() -> Vec<Method> {
    let further = [points::LOWER_HALF_PLANE, points::ZEROS_OF_W];
    let upper = points::UPPER_HALF_PLANE;
    let w = |method, label, call: Plane| peer(W, method, label, Call::row(call), upper, &further);
    #[allow(unused_mut, reason = "libcerf is added only with its feature")]
    let mut methods = vec![
        w(
            "errorfunctions",
            "crate errorfunctions 0.2.0",
            peers::faddeeva_w_errorfunctions,
        ),
        w("puruspe", "crate puruspe 0.4.4", peers::faddeeva_w_puruspe),
        peer(
            W,
            "errorfunctions_rounded",
            "errorfunctions 0.2.0 in f64, rounded to f32",
            Call::row(|[re, im]: [f32; 2]| peers::faddeeva_w_rounded(re, im)),
            points::UPPER_HALF_PLANE_F32,
            &[],
        ),
        peer(
            DERIVATIVE,
            "errorfunctions",
            "2i/sqrt(pi) - 2 z w, w of errorfunctions 0.2.0",
            Call::row(peers::faddeeva_w_derivative_errorfunctions),
            upper,
            &[],
        ),
    ];
    #[cfg(feature = "libcerf")]
    methods.extend([
        w("libcerf", "libcerf 1.3 (Debian)", crate::peers::libcerf::faddeeva_w),
        peer(
            DERIVATIVE,
            "libcerf",
            "2i/sqrt(pi) - 2 z w, w of libcerf 1.3 (Debian)",
            Call::row(crate::peers::libcerf::faddeeva_w_derivative),
            upper,
            &[],
        ),
    ]);
    methods
}
