//! The coherence window: radius and angle of the light against the disc's Airy function, the base response by quadrature,
//! the window's averages, limits and bad input.

use iridescence::diffraction::{
    Coherence, angular_diameter, base_response, coherence_area, coherence_degree, coherence_radius, coherence_window,
    window_reach,
};
use proptest::prelude::*;
use reference::generate::random::Random;
use std::f64::consts::PI;

const INFINITY: f64 = f64::INFINITY;

/// J1(x)/x from Bessel's integral, by the trapezoid rule over the period, which is exact for it.
fn bessel_j1_over_x(x: f64) -> f64 {
    let count = 200;
    let value = |step: i32| {
        let angle = 2.0 * PI * f64::from(step) / f64::from(count);
        (angle - x * angle.sin()).cos()
    };
    (0..count).map(value).sum::<f64>() / f64::from(count) / x
}

#[test]
fn disc_and_window_share_the_half_of_their_degree_of_coherence() {
    for (diameter, wavelength) in [(0.53f64.to_radians(), 0.55), (0.1, 0.4), (1.0, 0.7), (3.0, 0.5)] {
        let sigma = coherence_radius(diameter, wavelength);
        let half = sigma * 2.0 * 2f64.ln().sqrt();
        assert!((coherence_degree(half, sigma) - 0.5).abs() < 1e-15);
        // The light's disc: 2 J1(x)/x at x = k d sin(theta/2).
        let x = 2.0 * PI / wavelength * half * (0.5 * diameter).sin();
        assert!((2.0 * bessel_j1_over_x(x) - 0.5).abs() < 1e-15, "{diameter} {x}");
    }
    // The sun, to the digits that mpmath gives.
    let sigma = coherence_radius(0.53f64.to_radians(), 0.55);
    assert!((sigma / 25.177328960851096 - 1.0).abs() < 4.0 * f64::EPSILON, "{sigma}");
}

#[test]
fn the_angle_of_a_radius_is_the_inverse_of_the_radius_of_an_angle() {
    let mut random = Random::new(801);
    for _ in 0..10_000 {
        let (diameter, wavelength) = (random.log_uniform(1e-12, 2.5), random.uniform(0.3, 0.9));
        let back = angular_diameter(coherence_radius(diameter, wavelength), wavelength);
        assert!((back / diameter - 1.0).abs() < 1e-14, "{diameter} {back}");
    }
    assert_eq!(coherence_radius(0.0, 0.5), INFINITY);
    assert_eq!(angular_diameter(INFINITY, 0.5), 0.0);
    // A hemisphere of light, and nothing larger.
    let least = coherence_radius(PI, 1.0);
    assert!((least - 0.2117233017143401).abs() < 1e-16);
    assert!((angular_diameter(least, 1.0) - PI).abs() < 1e-7);
    assert!(angular_diameter(0.99 * least, 1.0).is_nan());
    for (diameter, wavelength) in [
        (-0.1, 0.5),
        (3.2, 0.5),
        (0.1, 0.0),
        (0.1, -1.0),
        (f64::NAN, 0.5),
        (0.1, f64::NAN),
    ] {
        assert!(
            coherence_radius(diameter, wavelength).is_nan(),
            "{diameter} {wavelength}"
        );
    }
    for (radius, wavelength) in [(0.0, 0.5), (-1.0, 0.5), (1.0, 0.0), (f64::NAN, 0.5), (1.0, f64::NAN)] {
        assert!(angular_diameter(radius, wavelength).is_nan(), "{radius} {wavelength}");
    }
}

#[test]
fn the_reach_of_the_window_is_where_it_has_the_tolerance() {
    let mut random = Random::new(802);
    for _ in 0..2_000 {
        let (tolerance, radius) = (random.log_uniform(1e-300, 1.0), random.uniform(1.0, 100.0));
        let window = coherence_window(radius * window_reach(tolerance), radius);
        assert!((window / tolerance - 1.0).abs() < 4e-12, "{tolerance:e}");
    }
    assert!((window_reach(1e-3) - 3.716922188849838).abs() < 1e-14);
    // The published cull at three radii leaves a hundredth.
    assert!((coherence_window(3.0, 1.0) - 0.011108996538242306).abs() < 1e-17);
}

#[test]
fn the_degree_is_the_product_of_two_windows_averaged_over_their_place() {
    let radius = 7.0;
    for separation in [0.0, 1.0, 5.0, 20.0, 60.0] {
        let (mut both, mut square) = (0.0, 0.0);
        for step in -400..=400 {
            let place = f64::from(step) * 0.25;
            both += coherence_window(place, radius) * coherence_window(place + separation, radius);
            square += coherence_window(place, radius).powi(2);
        }
        assert!(
            (coherence_degree(separation, radius) - both / square).abs() < 1e-14,
            "{separation}"
        );
    }
}

#[test]
fn the_base_response_is_the_fourier_integral_of_the_window() {
    let mut random = Random::new(803);
    for _ in 0..200 {
        let light = Coherence {
            radius: random.uniform(5.0, 60.0),
            wavelength: random.uniform(0.38, 0.78),
        };
        let scale = 4.0 * light.wavelength / (2.0 * PI * light.radius);
        let xi = [0; 2].map(|_| random.uniform(-1.0, 1.0) * scale);
        // Separable: the trapezoid rule along either axis.
        let along = |xi: f64| {
            let step = 0.1 * light.radius;
            let value = |place: i32| {
                let t = f64::from(place) * step;
                coherence_window(t, light.radius) * (2.0 * PI * xi * t / light.wavelength).cos()
            };
            (-100..=100).map(value).sum::<f64>() * step
        };
        let due = along(xi[0]) * along(xi[1]);
        let peak = 2.0 * coherence_area(light.radius);
        assert!(
            (base_response(light, xi) - due).abs() <= 1e-13 * peak,
            "{light:?} {xi:?}"
        );
    }
}

#[test]
fn limits_and_bad_input_have_their_values() {
    let light = |radius, wavelength| Coherence { radius, wavelength };
    assert_eq!(base_response(light(2.0, 0.5), [0.0, 0.0]), 8.0 * PI);
    assert_eq!(base_response(light(0.0, 0.5), [0.1, 0.2]), 0.0);
    assert_eq!(base_response(light(2.0, 0.5), [INFINITY, 0.0]), 0.0);
    assert_eq!(base_response(light(2.0, INFINITY), [0.4, 0.1]), 8.0 * PI);
    assert_eq!(base_response(light(0.0, 0.5), [INFINITY, 0.0]), 0.0);
    assert_eq!(base_response(light(1e200, 0.5), [1e-3, 0.0]), 0.0);
    assert!(base_response(light(INFINITY, 0.5), [1e-3, 0.0]).is_nan());
    // sigma xi leaves the range, the exponent does not.
    assert_eq!(base_response(light(1e-200, 0.5), [1e-200, 0.0]), 0.0);
    assert!(base_response(light(1e150, 1e300), [1e150, 0.0]) > 1e280);
    for (radius, wavelength, xi) in [
        (-1.0, 0.5, 0.1),
        (1.0, 0.0, 0.1),
        (1.0, -0.5, 0.1),
        (f64::NAN, 0.5, 0.1),
        (1.0, f64::NAN, 0.1),
        (1.0, 0.5, f64::NAN),
    ] {
        assert!(
            base_response(light(radius, wavelength), [xi, 0.0]).is_nan(),
            "{radius} {wavelength} {xi}"
        );
        assert!(
            base_response(light(radius, wavelength), [0.0, xi]).is_nan(),
            "{radius} {wavelength} {xi}"
        );
    }
    assert_eq!(coherence_window(0.0, 0.0), 1.0);
    assert_eq!(coherence_window(-0.0, 0.0), 1.0);
    assert_eq!(coherence_window(5e-324, 0.0), 0.0);
    assert_eq!(coherence_window(INFINITY, 3.0), 0.0);
    assert_eq!(coherence_window(3.0, INFINITY), 1.0);
    assert_eq!(coherence_degree(0.0, 0.0), 1.0);
    assert_eq!(coherence_degree(1.0, 0.0), 0.0);
    assert_eq!(coherence_area(0.0), 0.0);
    assert!(coherence_area(-1.0).is_nan() && coherence_area(f64::NAN).is_nan());
    for window in [coherence_window, coherence_degree] {
        for (distance, radius) in [
            (1.0, -1.0),
            (0.0, -1.0),
            (f64::NAN, 1.0),
            (f64::NAN, 0.0),
            (1.0, f64::NAN),
        ] {
            assert!(window(distance, radius).is_nan(), "{distance} {radius}");
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, cases: 4000, ..ProptestConfig::default() })]

    #[test]
    fn the_window_is_even_and_falls_from_1(distance in 0.0..300.0f64, more in 0.0..300.0f64, radius in 0.01..100.0f64) {
        let window = coherence_window(distance, radius);
        prop_assert_eq!(window, coherence_window(-distance, radius));
        prop_assert!((0.0..=1.0).contains(&window));
        prop_assert!(coherence_window(distance + more, radius) <= window);
        // The degree's exponent is half the window's.
        let degree = coherence_degree(distance, radius);
        prop_assert!((degree * degree - window).abs() <= 1e-14);
    }
}
