//! The methods of the responses of scratches and of the bare surface, of the area density and of the sampling densities.

use super::faddeeva::{complex, own, region};
use super::{Call, Method, Metric};
use crate::generate::{scratches, surfaces as rows};
use Metric::{Absolute, Eps, Peak, Ulp};
use iridescence::diffraction::{self, AreaKernel, Coherence, Profile, Segment};
use iridescence::simd::shader as slices;
use iridescence::{sampling, shader};
use num_complex::Complex;

const PHASE: &str = "spatial_phase_infinite";
const DEPTH: &str = "depth_term";
const TRIANGLE: &str = "response_triangle";
const WINDOWED: &str = "response_rectangle_windowed";
const BASE: &str = "base_response";
const SQUARED: &str = "scratch_squared";
const DENSITY: &str = "area_density";
const GAUSSIAN: &str = "gaussian_inverse";
const CONE: &str = "von_mises_fisher_pdf";

const DOUBLE: &str = "iridescence f64";
const SINGLE: &str = "iridescence f32";

fn phase([radius, wavelength, xi1, xi2, offset]: [f64; 5]) -> Complex<f64> {
    diffraction::spatial_phase_infinite(Coherence { radius, wavelength }, offset, [xi1, xi2])
}

fn triangle([width, depth, xi2, gamma_sum, lambda]: [f64; 5]) -> Complex<f64> {
    diffraction::response_triangle(Profile { width, depth }, [0.0, xi2, gamma_sum], lambda)
}

fn windowed(row: [f64; 11]) -> Complex<f64> {
    let [radius, wavelength, width, depth, xi1, xi2, gamma_sum, s_t, s_b, l1, l2] = row;
    let segment = Segment {
        position: [s_t, s_b],
        ends: [l1, l2],
    };
    let (light, profile) = (Coherence { radius, wavelength }, Profile { width, depth });
    diffraction::response_rectangle_windowed(light, profile, segment, [xi1, xi2, gamma_sum])
}

fn base([radius, wavelength, xi1, xi2]: [f64; 4]) -> f64 {
    diffraction::base_response(Coherence { radius, wavelength }, [xi1, xi2])
}

fn squared([radius, wavelength, width, depth, xi1, xi2, gamma_sum, mean]: [f64; 8]) -> f64 {
    let (light, profile) = (Coherence { radius, wavelength }, Profile { width, depth });
    diffraction::scratch_squared(light, profile, [xi1, xi2, gamma_sum], mean)
}

fn squared_f32([radius, wavelength, width, depth, xi_t, xi_b, gamma_sum, mean]: [f32; 8]) -> f32 {
    shader::scratch_squared(radius, wavelength, width, depth, xi_t, xi_b, gamma_sum, mean)
}

pub(super) fn methods() -> Vec<Method> {
    let mut methods = own_methods();
    methods.extend(own_methods_f32());
    methods
}

fn own_methods() -> Vec<Method> {
    let ours = |function, call, domain, metric, bound| {
        own(function, "accurate", DOUBLE, call, &[region(domain, metric, bound)])
    };
    let depth = Call::row(|[depth, gamma_sum, lambda]: [f64; 3]| diffraction::depth_term(depth, gamma_sum, lambda));
    let density = Call::row(|[width, offset, radius]: [f64; 3]| {
        diffraction::area_density(AreaKernel::Energy, width, offset, radius)
    });
    let cone = Call::row(|[kappa, cosine]: [f64; 2]| sampling::von_mises_fisher_pdf(kappa, cosine));
    vec![
        ours(PHASE, Call::row(phase), rows::INFINITE_PHASE, Peak, 1e-15),
        ours(DEPTH, depth, rows::DEPTH, Eps, 6.0),
        ours(TRIANGLE, Call::row(triangle), scratches::PROFILE, Peak, 1.2e-15),
        ours(WINDOWED, Call::row(windowed), rows::WINDOWED, Peak, 4e-16),
        ours(BASE, Call::row(base), rows::BASE, Peak, 1e-15),
        ours(SQUARED, Call::row(squared), rows::SCRATCH, Peak, 2e-15),
        ours(DENSITY, density, rows::DENSITY, Peak, 1e-15),
        ours(
            GAUSSIAN,
            Call::F64(sampling::gaussian_inverse),
            rows::GAUSSIAN_U,
            Ulp,
            6.0,
        ),
        ours(CONE, cone, rows::CONE, Peak, 1e-15),
    ]
}

fn own_methods_f32() -> Vec<Method> {
    let ours = |function, call, domain, metric, bound| {
        own(function, "accurate", SINGLE, call, &[region(domain, metric, bound)])
    };
    let phase = Call::row(|[radius, lambda, xi_t, xi_b, s_b]: [f32; 5]| {
        complex(shader::spatial_phase_infinite(radius, lambda, xi_t, xi_b, s_b))
    });
    let depth = Call::row(|[depth, gamma_sum, lambda]: [f32; 3]| complex(shader::depth_term(depth, gamma_sum, lambda)));
    let triangle = Call::row(|[width, depth, xi_b, gamma_sum, lambda]: [f32; 5]| {
        complex(shader::response_triangle(width, depth, xi_b, gamma_sum, lambda))
    });
    let base = Call::row(|[radius, lambda, xi_t, xi_b]: [f32; 4]| shader::base_response(radius, lambda, xi_t, xi_b));
    let density = Call::row(|[width, offset, radius]: [f32; 3]| shader::area_density(width, offset, radius));
    vec![
        ours(PHASE, phase, rows::INFINITE_PHASE_F32, Peak, 5e-7),
        ours(DEPTH, depth, rows::DEPTH_F32, Absolute, 1e-6),
        ours(TRIANGLE, triangle, scratches::PROFILE_F32, Peak, 5e-7),
        ours(BASE, base, rows::BASE_F32, Peak, 5e-7),
        ours(SQUARED, Call::row(squared_f32), rows::SCRATCH_F32, Peak, 1e-6),
        own(
            SQUARED,
            "accurate",
            "iridescence f32 slices",
            Call::rows(slices::scratch_squared),
            &[region(rows::SCRATCH_F32, Peak, 1e-6)],
        ),
        ours(DENSITY, density, rows::DENSITY_F32, Peak, 5e-7),
        ours(
            GAUSSIAN,
            Call::F32(shader::gaussian_inverse),
            rows::GAUSSIAN_U_F32,
            Absolute,
            1.5e-6,
        ),
    ]
}
