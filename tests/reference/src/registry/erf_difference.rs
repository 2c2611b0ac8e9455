//! The methods of the scaled erf difference: ours, the published form as printed, and what other libraries give.

use super::faddeeva::complex;
use super::faddeeva::{own, peer, region};
use super::{Call, Method, Metric, Origin};
use crate::generate::erf_differences as rows;
use crate::{as_printed, peers};
use Metric::{Eps, Peak};
use iridescence::special;
use iridescence::{shader, simd};
use num_complex::Complex;
use std::f64::consts::{FRAC_2_SQRT_PI, PI};

const DIFFERENCE: &str = "erf_difference_scaled";
/// The bound on the error in f64, as a multiple of the value at b = 0.
const PEAK_F64: f64 = 6.0 * f64::EPSILON;
/// The bound in f32.
const PEAK_F32: f64 = 1.4e-6;

/// |erf(a2) - erf(a1)|, the modulus at b = 0 and the largest one over b; to about six digits.
pub(super) fn peak(row: &[f64]) -> f64 {
    let (lo, hi) = (row[0].min(row[1]), row[0].max(row[1]));
    let (delta, middle) = (hi - lo, 0.5 * lo + 0.5 * hi);
    if delta * middle.abs().max(1.0) < 1e-3 {
        FRAC_2_SQRT_PI * delta * libm::exp(-middle * middle)
    } else if lo > 0.0 {
        libm::erfc(lo) - libm::erfc(hi)
    } else if hi < 0.0 {
        libm::erfc(-hi) - libm::erfc(-lo)
    } else {
        libm::erf(hi) - libm::erf(lo)
    }
}

/// The f32 form that takes its phases in turns, the turns a b/pi given as a scene would: from more than f32.
fn in_turns([from, to, b]: [f32; 3]) -> Complex<f32> {
    let turns = |a: f32| {
        let turns = f64::from(a) * f64::from(b) / PI;
        (turns - turns.round()) as f32
    };
    complex(shader::erf_difference_scaled_turns(from, to, b, turns(from), turns(to)))
}

pub(super) fn methods() -> Vec<Method> {
    let mut methods = own_methods();
    methods.extend(own_methods_f32());
    methods.extend(others());
    methods
}

fn own_methods() -> Vec<Method> {
    let double = [
        region(rows::SCRATCH, Peak, PEAK_F64),
        region(rows::SCRATCH, Eps, 150.0),
        region(rows::ANY, Peak, PEAK_F64),
    ];
    let call = Call::row(|[a1, a2, b]: [f64; 3]| special::erf_difference_scaled(a1, a2, b));
    vec![own(DIFFERENCE, "accurate", "iridescence f64", call, &double)]
}

fn own_methods_f32() -> Vec<Method> {
    let single = [region(rows::SCRATCH_F32, Peak, PEAK_F32)];
    let ours = |method, label, call| own(DIFFERENCE, method, label, call, &single);
    vec![
        ours(
            "accurate",
            "iridescence f32",
            Call::row(|[from, to, b]: [f32; 3]| complex(shader::erf_difference_scaled(from, to, b))),
        ),
        ours("turns", "iridescence f32, phases given in turns", Call::row(in_turns)),
        ours(
            "accurate",
            "iridescence f32 slices",
            Call::rows(simd::shader::erf_difference_scaled),
        ),
    ]
}

fn others() -> Vec<Method> {
    let other = |method, label, call: fn([f64; 3]) -> Complex<f64>| {
        peer(DIFFERENCE, method, label, Call::row(call), rows::SCRATCH, &[])
    };
    #[allow(unused_mut, reason = "libcerf is added only with its feature")]
    let mut methods = vec![
        Method {
            origin: Origin::Published,
            ..other(
                "as_printed",
                "VWH18 Eq. 5, erf of errorfunctions 0.2.0",
                as_printed::erf_difference,
            )
        },
        Method {
            origin: Origin::Published,
            ..peer(
                DIFFERENCE,
                "as_printed",
                "VWH18 Eq. 5 in f32",
                Call::row(as_printed::erf_difference_f32),
                rows::SCRATCH_F32,
                &[],
            )
        },
        other(
            "errorfunctions_w",
            "two w of errorfunctions 0.2.0, scaled by hand",
            peers::error_function::erf_difference_by_w,
        ),
    ];
    #[cfg(feature = "libcerf")]
    methods.push(other(
        "libcerf_as_printed",
        "VWH18 Eq. 5, cerf of libcerf 1.3 (Debian)",
        peers::libcerf::erf_difference_as_printed,
    ));
    methods
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_peak_is_the_modulus_at_b_zero_for_long_short_and_far_segments() {
        for (a1, a2, expected) in [
            (f64::NEG_INFINITY, f64::INFINITY, 2.0),
            (2.0, -1.0, libm::erf(2.0) + libm::erf(1.0)),
            (3.0, 3.5, libm::erfc(3.0) - libm::erfc(3.5)),
            (-3.5, -3.0, libm::erfc(3.0) - libm::erfc(3.5)),
            (1.0, 1.0 + 1e-9, FRAC_2_SQRT_PI * 1e-9 * libm::exp(-1.0)),
        ] {
            let found = peak(&[a1, a2, 7.0]);
            assert!((found / expected - 1.0).abs() < 1e-6, "{a1} {a2}: {found} {expected}");
        }
        // Both branches agree where they meet.
        let (short, long) = (peak(&[2.0, 2.0 + 0.4999e-3, 0.0]), peak(&[2.0, 2.0 + 0.5001e-3, 0.0]));
        assert!((long / short / (0.5001 / 0.4999) - 1.0).abs() < 1e-6, "{short} {long}");
    }
}
