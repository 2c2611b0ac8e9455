//! Scratches and footprints.

use crate::check::check;
use crate::inputs::*;
use iridescence::simd;
use iridescence::{Complex, shader};

#[test]
fn the_f32_scratches_have_the_bits_of_their_scalars_at_every_level() {
    use simd::shader::*;
    let complex = |z: shader::Complex| Complex::new(z.re, z.im);
    check(
        "profile_rectangle",
        scratch_rows::<5>,
        |[a, b, c, d, e]| complex(shader::profile_rectangle(a, b, c, d, e)),
        profile_rectangle,
        profile_rectangle_at,
    );
    check(
        "profile_triangle",
        scratch_rows::<5>,
        |[a, b, c, d, e]| complex(shader::profile_triangle(a, b, c, d, e)),
        profile_triangle,
        profile_triangle_at,
    );
    check(
        "response_triangle",
        scratch_rows::<5>,
        |[a, b, c, d, e]| complex(shader::response_triangle(a, b, c, d, e)),
        response_triangle,
        response_triangle_at,
    );
    check(
        "spatial_phase_infinite",
        infinite_rows,
        |[a, b, c, d, e]| complex(shader::spatial_phase_infinite(a, b, c, d, e)),
        spatial_phase_infinite,
        spatial_phase_infinite_at,
    );
    check(
        "spatial_phase",
        scratch_rows::<8>,
        |[a, b, c, d, e, f, g, h]| complex(shader::spatial_phase(a, b, c, d, e, f, g, h)),
        spatial_phase,
        spatial_phase_at,
    );
    check(
        "scratch_squared",
        scratch_rows::<8>,
        |[a, b, c, d, e, f, g, h]| shader::scratch_squared(a, b, c, d, e, f, g, h),
        scratch_squared,
        scratch_squared_at,
    );
}

#[test]
fn the_f32_footprints_have_the_bits_of_their_scalars_at_every_level() {
    use simd::shader::*;
    check(
        "footprint_mean_reduced",
        footprint_rows,
        |[half_width, edge]| shader::footprint_mean_reduced(half_width, edge),
        footprint_mean_reduced,
        footprint_mean_reduced_at,
    );
    check(
        "footprint_mean_reduced_coarse",
        footprint_rows,
        |[half_width, edge]| shader::footprint_mean_reduced_coarse(half_width, edge),
        footprint_mean_reduced_coarse,
        footprint_mean_reduced_coarse_at,
    );
}
