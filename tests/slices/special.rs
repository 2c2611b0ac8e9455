//! The special functions.

use crate::check::check;
use crate::inputs::*;
use iridescence::{Complex, shader, simd, special};

#[test]
fn the_f64_sine_integral_has_the_bits_of_its_scalar_at_every_level() {
    check(
        "sine_integral",
        numbers,
        special::sine_integral,
        simd::sine_integral,
        simd::sine_integral_at,
    );
}

#[test]
fn erf_has_the_bits_of_its_scalar_at_every_level() {
    check("erf", some_tiny, special::erf, simd::erf, simd::erf_at);
}

#[test]
fn the_f64_faddeeva_functions_have_the_bits_of_their_scalars_at_every_level() {
    use simd::*;
    check("faddeeva_w", points, special::faddeeva_w, faddeeva_w, faddeeva_w_at);
    check(
        "fine",
        points,
        special::faddeeva_w_fine,
        faddeeva_w_fine,
        faddeeva_w_fine_at,
    );
    check(
        "medium",
        points,
        special::faddeeva_w_medium,
        faddeeva_w_medium,
        faddeeva_w_medium_at,
    );
    check(
        "coarse",
        points,
        special::faddeeva_w_coarse,
        faddeeva_w_coarse,
        faddeeva_w_coarse_at,
    );
}

#[test]
fn the_f32_complex_functions_have_the_bits_of_their_scalars_at_every_level() {
    use simd::shader::*;
    let complex = |z: shader::Complex| Complex::new(z.re, z.im);
    check(
        "faddeeva_w",
        single_points,
        |z| complex(shader::faddeeva_w(z.re, z.im)),
        faddeeva_w,
        faddeeva_w_at,
    );
    check(
        "coarse",
        single_points,
        |z| complex(shader::faddeeva_w_coarse(z.re, z.im)),
        faddeeva_w_coarse,
        faddeeva_w_coarse_at,
    );
    check(
        "erf_difference_scaled",
        single_rows,
        |[from, to, b]| complex(shader::erf_difference_scaled(from, to, b)),
        erf_difference_scaled,
        erf_difference_scaled_at,
    );
}

#[test]
fn the_scaled_bessel_functions_have_the_bits_of_their_scalars_at_every_level() {
    check(
        "bessel_i0_scaled",
        numbers,
        special::bessel_i0_scaled,
        simd::bessel_i0_scaled,
        simd::bessel_i0_scaled_at,
    );
    check(
        "bessel_i0_scaled",
        singles,
        shader::bessel_i0_scaled,
        simd::shader::bessel_i0_scaled,
        simd::shader::bessel_i0_scaled_at,
    );
}

#[test]
fn the_f32_sine_integrals_have_the_bits_of_their_scalars_at_every_level() {
    use simd::shader::*;
    check(
        "sine_integral",
        singles,
        shader::sine_integral,
        sine_integral,
        sine_integral_at,
    );
    check(
        "medium",
        singles,
        shader::sine_integral_medium,
        sine_integral_medium,
        sine_integral_medium_at,
    );
    check(
        "coarse",
        singles,
        shader::sine_integral_coarse,
        sine_integral_coarse,
        sine_integral_coarse_at,
    );
    check(
        "velinov",
        singles,
        shader::sine_integral_velinov,
        sine_integral_velinov,
        sine_integral_velinov_at,
    );
}

#[test]
fn the_f32_arcs_have_the_bits_of_their_scalars_at_every_level() {
    use shader::{
        sinc_squared_integral as accurate, sinc_squared_integral_coarse as coarse,
        sinc_squared_integral_medium as medium, sinc_squared_integral_velinov as velinov,
    };
    use simd::shader::*;
    check(
        "accurate",
        pairs,
        |[a, b]| accurate(a, b),
        sinc_squared_integral,
        sinc_squared_integral_at,
    );
    check(
        "medium",
        pairs,
        |[a, b]| medium(a, b),
        sinc_squared_integral_medium,
        sinc_squared_integral_medium_at,
    );
    check(
        "coarse",
        pairs,
        |[a, b]| coarse(a, b),
        sinc_squared_integral_coarse,
        sinc_squared_integral_coarse_at,
    );
    check(
        "velinov",
        pairs,
        |[a, b]| velinov(a, b),
        sinc_squared_integral_velinov,
        sinc_squared_integral_velinov_at,
    );
}
