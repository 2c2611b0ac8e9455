//! Exact limits, symmetries, finite results, NaN.

use crate::scenes::{complex, eta, profile_row, segment_row, single};
use iridescence::shader;
use reference::generate::random::Random;
use std::f64::consts::PI;

#[test]
fn widths_depths_and_cosines_of_0_are_exact() {
    for wavelength in [0.38f32, 0.55, 0.78] {
        for size in [0.1f32, 2.5, 60.0] {
            assert_eq!(shader::width_term(0.0, 1.3, wavelength), 0.0);
            assert_eq!(shader::width_term(size, 0.0, wavelength), size);
            let nothing = shader::Complex { re: 0.0, im: 0.0 };
            assert_eq!(shader::depth_term(0.0, 1.7, wavelength), nothing);
            assert_eq!(shader::depth_term(size, 0.0, wavelength), nothing);
            assert_eq!(shader::depth_term_squared(0.0, 1.7, wavelength), 0.0);
            assert_eq!(shader::profile_rectangle(size, 0.0, 0.4, 1.7, wavelength), nothing);
            assert_eq!(shader::profile_rectangle(0.0, 2.0, 0.4, 1.7, wavelength), nothing);
            assert_eq!(shader::profile_triangle(0.0, 2.0, 0.4, 1.7, wavelength), nothing);
            assert_eq!(shader::profile_triangle(size, 0.0, 0.0, 1.7, wavelength).re, size);
            // Without a depth the triangle is its mask.
            let flat = shader::profile_triangle(size, 0.0, 0.0125, 1.7, wavelength);
            assert!((flat.re - shader::width_term(size, 0.0125, wavelength)).abs() <= 1e-6 * size);
            // A whole wavelength of depth is no depth.
            assert_eq!(shader::depth_term(wavelength, 1.0, wavelength), nothing);
            assert_eq!(shader::depth_term(16.0 * wavelength, 2.0, wavelength), nothing);
            assert_eq!(shader::coherence_window(0.0, size), 1.0);
            assert_eq!(shader::coherence_window(f32::INFINITY, size), 0.0);
            assert_eq!(
                shader::spatial_phase(size, wavelength, 0.2, 0.1, 0.0, 0.0, 3.0, 3.0),
                nothing
            );
            for far in [f32::INFINITY, 1e30, f32::NEG_INFINITY] {
                assert_eq!(
                    shader::spatial_phase(size, wavelength, 0.2, 0.1, 0.0, far, -3.0, 3.0),
                    nothing
                );
                assert_eq!(shader::spatial_phase_infinite(size, wavelength, 0.0, 0.1, far), nothing);
                assert_eq!(shader::spatial_phase_infinite_squared(size, wavelength, 0.0, far), 0.0);
                assert_eq!(shader::area_density(1.0, far, size), 0.0);
            }
        }
    }
    // No coherence: the window is a point, and nothing interferes.
    assert_eq!(shader::coherence_window(0.0, 0.0), 1.0);
    assert_eq!(shader::coherence_window(1e-30, 0.0), 0.0);
    for [across, from, to] in [[0.0, -1.0, 1.0], [0.0, 0.0, 1.0], [2.0, -1.0, 0.0], [0.0, 1.0, 2.0]] {
        let value = shader::spatial_phase(0.0, 0.5, 0.1, 0.1, 0.0, across, from, to);
        assert_eq!((value.re, value.im), (0.0, 0.0), "{across} {from} {to}");
        let value = shader::spatial_phase_infinite(0.0, 0.5, 0.1, 0.1, across);
        assert_eq!((value.re, value.im), (0.0, 0.0), "{across}");
        assert_eq!(shader::spatial_phase_infinite_squared(0.0, 0.5, 0.1, across), 0.0);
    }
    assert_eq!(shader::base_response(0.0, 0.5, 0.1, 0.1), 0.0);
    assert_eq!(shader::energy_blend_scattered(0.0, 4.0), 0.0);
    assert_eq!(shader::energy_blend_scattered(1.0, 4.0), 0.0);
    assert_eq!(shader::energy_blend_base(0.5, 1.0), 0.75);
    assert_eq!([0.0, 0.25, 1.0].map(shader::energy_blend_scratches), [1.0, 0.75, 0.0]);
    // What a sum of tiles may exceed 1 by.
    for covered in [1.0_f32.next_up(), 1.0 + 64.0 * f32::EPSILON] {
        assert_eq!(shader::energy_blend_scratches(covered), 0.0);
        assert_eq!(shader::energy_blend_scattered(covered, 4.0), 0.0);
        assert_eq!(shader::energy_blend_base(covered, 4.0), 1.0);
    }
    assert_eq!(shader::reflectance_coherent(10.0, 0.5, 3.0, 3.0, 0.0), 0.0);
}

#[test]
fn mirrored_and_exchanged_scratches_are_conjugate_and_negative() {
    let mut random = Random::new(407);
    for _ in 0..100_000 {
        let row = segment_row(&mut random);
        let [radius, wavelength, xi_t, xi_b, s_t, s_b, l_from, l_to] = row;
        let value = eta(row);
        assert_eq!(
            eta([radius, wavelength, -xi_t, -xi_b, s_t, s_b, l_from, l_to]),
            value.conj(),
            "{row:?}"
        );
        assert_eq!(
            eta([radius, wavelength, xi_t, xi_b, s_t, s_b, l_to, l_from]),
            -value,
            "{row:?}"
        );
        let [width, depth, xi, gamma, wavelength] = profile_row(&mut random);
        let value = shader::profile_triangle(width, depth, xi, gamma, wavelength);
        let mirrored = shader::profile_triangle(width, -depth, xi, gamma, wavelength);
        assert_eq!((mirrored.re, mirrored.im), (value.re, -value.im));
        assert_eq!(
            shader::width_term(width, -xi, wavelength),
            shader::width_term(width, xi, wavelength)
        );
    }
}

#[test]
fn no_finite_scene_gives_a_number_that_is_not_finite() {
    let mut random = Random::new(408);
    let mut worst = 0.0f64;
    for _ in 0..1_000_000 {
        // Scenes from atoms to metres.
        let mut length = |low: f64, high: f64| {
            let size = random.log_uniform(low, high);
            random.signed(size)
        };
        let places = [
            length(1e-6, 1e6),
            length(1e-6, 1e6),
            length(1e-6, 1e6),
            length(1e-6, 1e6),
        ];
        let sizes = [
            length(1e-2, 1e4).abs(),
            length(0.1, 2.0).abs(),
            length(1e-4, 1e4).abs(),
            length(1e-4, 1e4),
        ];
        let cosines = [length(1e-6, 2.0), length(1e-6, 2.0), length(1e-6, 2.0)];
        let row = [
            sizes[0], sizes[1], cosines[0], cosines[1], places[0], places[1], places[2], places[3],
        ]
        .map(single);
        let value = eta(row);
        assert!(value.re.is_finite() && value.im.is_finite(), "{row:?}: {value}");
        worst = worst.max(value.norm() / ((2.0 * PI).sqrt() * f64::from(row[0])));
        let [width, depth] = [sizes[2], sizes[3]].map(single);
        let [xi, gamma] = [cosines[1], cosines[2]].map(single);
        for value in [
            shader::profile_rectangle(width, depth, xi, gamma, row[1]),
            shader::profile_triangle(width, depth, xi, gamma, row[1]),
        ] {
            let size = complex(value).norm() / f64::from(width);
            assert!(
                size <= 2.000_01,
                "{width:e} {depth:e} {xi:e} {gamma:e} {}: {size}",
                row[1]
            );
        }
    }
    assert!(worst <= 1.00001, "{worst}");
}

#[test]
fn nan_in_any_argument_gives_nan() {
    let scene = [10.0f32, 0.5, 0.01, 0.02, 1.0, 2.0, -3.0, 4.0];
    let groove = [2.5f32, 0.4, 0.1, 1.8, 0.5];
    let nan = |z: shader::Complex| z.re.is_nan() && z.im.is_nan();
    for k in 0..8 {
        let mut row = scene;
        row[k] = f32::NAN;
        let value = eta(row);
        assert!(value.re.is_nan() && value.im.is_nan(), "eta, argument {k}");
        let mut row = [10.0f32, 0.5, 2.5, 0.4, 0.01, 0.1, 1.8, 0.7];
        row[k] = f32::NAN;
        let [a, b, c, d, e, f, g, h] = row;
        assert!(
            shader::scratch_squared(a, b, c, d, e, f, g, h).is_nan(),
            "squared, argument {k}"
        );
    }
    for k in 0..5 {
        let mut row = groove;
        row[k] = f32::NAN;
        let [a, b, c, d, e] = row;
        assert!(nan(shader::profile_rectangle(a, b, c, d, e)), "rectangle, argument {k}");
        assert!(nan(shader::profile_triangle(a, b, c, d, e)), "triangle, argument {k}");
        let mut row = [10.0f32, 0.5, 0.01, 0.02, 2.0];
        row[k] = f32::NAN;
        let [a, b, c, d, e] = row;
        assert!(
            nan(shader::spatial_phase_infinite(a, b, c, d, e)),
            "infinite eta, argument {k}"
        );
        if k < 4 {
            assert!(shader::base_response(a, b, c, d).is_nan(), "base, argument {k}");
            assert!(
                shader::spatial_phase_infinite_squared(a, b, c, d).is_nan(),
                "|eta|^2, argument {k}"
            );
        }
        if k < 3 {
            assert!(nan(shader::depth_term(a, b, c)) && shader::depth_term_squared(a, b, c).is_nan());
            assert!(shader::width_term(a, b, c).is_nan() && shader::area_density(a, b, c).is_nan());
            assert!(shader::reflectance_incoherent(a, b, c).is_nan());
        }
        if k < 2 {
            assert!(shader::coherence_window(a, b).is_nan());
            assert!(shader::energy_blend_base(a, b).is_nan() && shader::energy_blend_scattered(a, b).is_nan());
        }
        if k < 1 {
            assert!(shader::energy_blend_scratches(a).is_nan());
        }
        assert!(
            shader::reflectance_coherent(a, b, c, d, e).is_nan(),
            "coherent, argument {k}"
        );
    }
}
