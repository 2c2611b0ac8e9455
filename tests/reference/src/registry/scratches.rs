//! The methods of the spatial phase, the profiles, the energy of a segment and the inverse of the sinc^2 distribution.

use super::faddeeva::{complex, own, peer, region};
use super::{Call, Generator, Method, Metric, Origin, Region};
use crate::generate::random::{Random, neighbour};
use crate::generate::scratches as rows;
use crate::{as_printed, oracle, peers};
use Metric::{Peak, Relative};
use iridescence::diffraction::{self, Coherence, Profile, Segment};
use iridescence::simd::shader as slices;
use iridescence::{sampling, shader};
use num_complex::Complex;
use std::f64::consts::PI;

const PHASE: &str = "spatial_phase";
const RECTANGLE: &str = "profile_rectangle";
const TRIANGLE: &str = "profile_triangle";
const ENERGY: &str = "segment_energy";
const INVERSE: &str = "sinc_squared_inverse";

/// Probabilities beside 1 with large errors, found by other seeds.
const NEAR_ONE: [f64; 2] = [0.999_999_999_990_809_5, 1.0 - 1e-12];

/// Probabilities, both tails and the middle.
pub(super) const PROBABILITIES: Generator = Generator {
    name: "probabilities",
    domain: "two recorded u beside 1, then u half uniform in (0, 1), half u or 1 - u log-uniform in 1e-12..0.5",
    columns: 1,
    rows: |seed, n| {
        let mut random = Random::new(seed);
        let draw = |_| match (random.chance(0.5), random.chance(0.5)) {
            (true, _) => random.uniform(1e-12, 1.0),
            (_, below) => {
                let tail = random.log_uniform(1e-12, 0.5);
                if below { tail } else { 1.0 - tail }
            }
        };
        NEAR_ONE.into_iter().chain((0..n).map(draw)).take(n).collect()
    },
};

/// Probabilities of the zeros of sinc, where the density vanishes and x follows the cube root of u.
const ZEROS: Generator = Generator {
    name: "probabilities_of_zeros",
    domain: "u within 8 f64 of the probability of n pi, 1 <= |n| <= 40",
    columns: 1,
    rows: |seed, n| {
        let mut random = Random::new(seed);
        let draw = |_| {
            let order = random.integer(1, 40) as f64;
            let tail = oracle::sinc_squared_integral(order * PI, f64::INFINITY).value() / PI;
            let u = if random.chance(0.5) { tail } else { 1.0 - tail };
            neighbour(u, random.integer(-8, 8))
        };
        (0..n).map(draw).collect()
    },
};

/// A row of the spatial phase.
type Phase<T> = [T; 8];
/// Width, depth, xi2, gamma_sum, lambda.
type Groove<T> = [T; 5];

fn phase([radius, wavelength, xi1, xi2, s_t, s_b, l1, l2]: Phase<f64>) -> Complex<f64> {
    let segment = Segment {
        position: [s_t, s_b],
        ends: [l1, l2],
    };
    diffraction::spatial_phase(Coherence { radius, wavelength }, segment, [xi1, xi2])
}

/// WVJH17 Eqs. 23 and 24 for a scratch along the first axis.
fn phase_as_printed([sigma, lambda, xi1, xi2, s_t, s_b, l1, l2]: Phase<f64>) -> Complex<f64> {
    let centre = [s_t + 0.5 * (l1 + l2), s_b];
    as_printed::spatial_phase_wvjh17_23(sigma, centre, [1.0, 0.0], l2 - l1, [xi1 / lambda, xi2 / lambda])
}

/// Eq. 5 with an erf difference of another library, its factors by the platform's mathematics.
fn phase_by(row: Phase<f64>, difference: fn([f64; 3]) -> Complex<f64>) -> Complex<f64> {
    use std::f64::consts::{SQRT_2, TAU};
    let [sigma, lambda, xi1, xi2, s_t, s_b, l1, l2] = row;
    let ends = [l1, l2].map(|l| (s_t + l) / (SQRT_2 * sigma));
    let window = (PI / 2.0).sqrt() * sigma * (-0.5 * (s_b / sigma).powi(2)).exp();
    let turn = Complex::from_polar(window, -TAU * s_b * xi2 / lambda);
    turn * difference([ends[0], ends[1], SQRT_2 * PI * sigma * xi1 / lambda])
}

fn rectangle([width, depth, xi2, gamma_sum, lambda]: Groove<f64>) -> Complex<f64> {
    diffraction::profile_rectangle(Profile { width, depth }, [0.0, xi2, gamma_sum], lambda)
}

fn triangle([width, depth, xi2, gamma_sum, lambda]: Groove<f64>) -> Complex<f64> {
    diffraction::profile_triangle(Profile { width, depth }, [0.0, xi2, gamma_sum], lambda)
}

/// VWH18 Eq. 3 with the depth term of WVJH17 Eq. 20.
fn rectangle_as_printed([width, depth, xi2, gamma_sum, lambda]: Groove<f64>) -> Complex<f64> {
    as_printed::width_term_vwh18_3(width, xi2, lambda) * as_printed::depth_term_wvjh17_20(depth, gamma_sum, lambda)
}

/// VWH18 Eqs. 3 and 4: the depth term as at normal incidence and observation.
fn rectangle_near_normal([width, depth, xi2, _, lambda]: Groove<f64>) -> Complex<f64> {
    as_printed::width_term_vwh18_3(width, xi2, lambda) * as_printed::depth_term_vwh18_4(depth, lambda)
}

/// WVJH17 Eqs. 29 to 31 without their two misprints: what is left has poles.
fn triangle_mended(row: Groove<f64>) -> Complex<f64> {
    let repairs = as_printed::TriangleRepairs {
        width: true,
        sign: true,
    };
    as_printed::profile_triangle_repaired(repairs, row)
}

fn energy([radius, wavelength, xi1, length]: [f64; 4]) -> f64 {
    diffraction::segment_energy(Coherence { radius, wavelength }, length, xi1)
}

pub(super) fn methods() -> Vec<Method> {
    let mut methods = own_methods();
    methods.extend(own_methods_f32());
    methods.extend(published());
    methods.extend(others());
    methods
}

fn own_methods() -> Vec<Method> {
    let ours = |function, call, regions: &[Region]| own(function, "accurate", "iridescence f64", call, regions);
    vec![
        ours(PHASE, Call::row(phase), &[region(rows::SPATIAL_PHASE, Peak, 1e-15)]),
        ours(RECTANGLE, Call::row(rectangle), &[region(rows::PROFILE, Peak, 3e-15)]),
        ours(
            TRIANGLE,
            Call::row(triangle),
            &[
                region(rows::PROFILE, Peak, 8e-16),
                region(rows::TRIANGLE_POLES, Peak, 8e-16),
            ],
        ),
        ours(ENERGY, Call::row(energy), &[region(rows::SEGMENT_ENERGY, Peak, 4e-15)]),
        ours(
            INVERSE,
            Call::F64(sampling::sinc_squared_inverse),
            &[region(PROBABILITIES, Relative, 1.2e-12), region(ZEROS, Relative, 1e-5)],
        ),
    ]
}

fn own_methods_f32() -> Vec<Method> {
    let ours = |function, label, call, domain| {
        let bound = match function {
            PHASE => 3.5e-6,
            TRIANGLE => 6e-7,
            _ => 1e-6,
        };
        let promise = [region(domain, Peak, bound)];
        own(function, "accurate", label, call, &promise)
    };
    vec![
        ours(
            PHASE,
            "iridescence f32",
            Call::row(|[radius, lambda, xi_t, xi_b, s_t, s_b, from, to]: Phase<f32>| {
                complex(shader::spatial_phase(radius, lambda, xi_t, xi_b, s_t, s_b, from, to))
            }),
            rows::SPATIAL_PHASE_F32,
        ),
        ours(
            RECTANGLE,
            "iridescence f32",
            Call::row(|[width, depth, xi_b, gamma_sum, lambda]: Groove<f32>| {
                complex(shader::profile_rectangle(width, depth, xi_b, gamma_sum, lambda))
            }),
            rows::PROFILE_F32,
        ),
        ours(
            TRIANGLE,
            "iridescence f32",
            Call::row(|[width, depth, xi_b, gamma_sum, lambda]: Groove<f32>| {
                complex(shader::profile_triangle(width, depth, xi_b, gamma_sum, lambda))
            }),
            rows::PROFILE_F32,
        ),
        ours(
            PHASE,
            "iridescence f32 slices",
            Call::rows(slices::spatial_phase),
            rows::SPATIAL_PHASE_F32,
        ),
        ours(
            RECTANGLE,
            "iridescence f32 slices",
            Call::rows(slices::profile_rectangle),
            rows::PROFILE_F32,
        ),
        ours(
            TRIANGLE,
            "iridescence f32 slices",
            Call::rows(slices::profile_triangle),
            rows::PROFILE_F32,
        ),
    ]
}

fn published() -> Vec<Method> {
    let printed = |function, method, label, call, domain, further: &[Generator]| Method {
        origin: Origin::Published,
        ..peer(function, method, label, call, domain, further)
    };
    let poles = [rows::TRIANGLE_POLES];
    vec![
        printed(
            PHASE,
            "as_printed",
            "WVJH17 Eqs. 23 and 24, erf of errorfunctions 0.2.0",
            Call::row(phase_as_printed),
            rows::SPATIAL_PHASE,
            &[],
        ),
        printed(
            RECTANGLE,
            "as_printed",
            "VWH18 Eq. 3, depth of WVJH17 Eq. 20",
            Call::row(rectangle_as_printed),
            rows::PROFILE,
            &[],
        ),
        printed(
            RECTANGLE,
            "as_printed_near_normal",
            "VWH18 Eqs. 3 and 4: the depth near normal",
            Call::row(rectangle_near_normal),
            rows::PROFILE,
            &[],
        ),
        printed(
            TRIANGLE,
            "as_printed",
            "WVJH17 Eqs. 29 to 31",
            Call::row(as_printed::profile_triangle_wvjh17_29),
            rows::PROFILE,
            &poles,
        ),
        printed(
            TRIANGLE,
            "as_printed_mended",
            "WVJH17 Eqs. 29 to 31 without their two misprints",
            Call::row(triangle_mended),
            rows::PROFILE,
            &poles,
        ),
    ]
}

fn others() -> Vec<Method> {
    let other = |method, label, call: fn(Phase<f64>) -> Complex<f64>| {
        peer(PHASE, method, label, Call::row(call), rows::SPATIAL_PHASE, &[])
    };
    #[allow(unused_mut, reason = "libcerf is added only with its feature")]
    let mut methods = vec![other(
        "errorfunctions_w",
        "Eq. 5 by two w of errorfunctions 0.2.0",
        |row| phase_by(row, peers::error_function::erf_difference_by_w),
    )];
    #[cfg(feature = "libcerf")]
    methods.push(other(
        "libcerf_as_printed",
        "Eq. 5 by cerf of libcerf 1.3 (Debian)",
        |row| phase_by(row, peers::libcerf::erf_difference_as_printed),
    ));
    methods
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_printed_and_the_librarys_phase_are_the_same_formula_as_ours() {
        let row = [10.0, 0.5, 0.02, 0.3, 3.0, -4.0, -20.0, 11.0];
        let ours = phase(row);
        let by_w = phase_by(row, peers::error_function::erf_difference_by_w);
        for other in [phase_as_printed(row), by_w] {
            assert!((other - ours).norm() < 1e-12 * ours.norm(), "{other} {ours}");
        }
    }

    #[test]
    fn the_mended_triangle_is_ours_away_from_its_poles() {
        let row = [2.0, 0.2, 0.7, 1.5, 0.5];
        assert!((triangle_mended(row) - triangle(row)).norm() < 1e-13);
        assert!((rectangle_as_printed(row) - rectangle(row)).norm() < 1e-13);
    }
}
