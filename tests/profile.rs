//! Profiles: limits, symmetries, the oracle at any depth and beside the poles of the published triangle, quadrature, the
//! shallow groove, and the rectangle under the window against quadrature over the surface.

use iridescence::Complex;
use iridescence::diffraction::{
    Coherence, Profile, Segment, depth_term, depth_term_near_normal, depth_term_near_normal_squared,
    depth_term_squared, profile_rectangle, profile_triangle, response_rectangle_windowed, response_triangle,
    spatial_phase, width_term,
};
use proptest::prelude::*;
use reference::gauss::gauss;
use reference::generate::random::{Random, neighbour};
use reference::metrics::Reference;
use reference::metrics::complex::{absolute_error, eps_error};
use reference::oracle;
use reference::registry::Precision::F64;
use std::f64::consts::PI;

/// Largest error in eps of W.
const BOUND: f64 = 8.0;
/// Largest relative error of the rectangle, in eps.
const RELATIVE: f64 = 12.0;
/// Largest error of the triangle's response in eps of W min(1, |p|).
const SHALLOW: f64 = 16.0;
const INFINITY: f64 = f64::INFINITY;

/// width depth xi2 gamma_sum lambda.
type Row = [f64; 5];

fn split([width, depth, xi2, gamma, wavelength]: Row) -> (Profile, [f64; 3], f64) {
    (Profile { width, depth }, [0.4, xi2, gamma], wavelength)
}

fn rectangle(row: Row) -> Complex<f64> {
    let (profile, scattering, wavelength) = split(row);
    profile_rectangle(profile, scattering, wavelength)
}

fn triangle(row: Row) -> Complex<f64> {
    let (profile, scattering, wavelength) = split(row);
    profile_triangle(profile, scattering, wavelength)
}

fn response(row: Row) -> Complex<f64> {
    let (profile, scattering, wavelength) = split(row);
    response_triangle(profile, scattering, wavelength)
}

fn pair(z: Complex<f64>) -> [f64; 2] {
    [z.re, z.im]
}

fn is_nan(z: Complex<f64>) -> bool {
    z.re.is_nan() && z.im.is_nan()
}

fn hold(row: Row) {
    let unit = row[0] * f64::EPSILON;
    let value = pair(rectangle(row));
    let truth: [Reference; 2] = oracle::profile_rectangle(&row);
    assert!(
        absolute_error(value, &truth) <= BOUND * unit,
        "rectangle {row:?}: {value:?}"
    );
    let relative = eps_error(value, &truth, F64);
    assert!(relative <= RELATIVE, "rectangle {row:?}: {relative} eps");
    let value = pair(triangle(row));
    let error = absolute_error(value, &oracle::profile_triangle(&row)) / unit;
    assert!(error <= BOUND, "triangle {row:?}: {value:?}, {error} eps of W");
}

fn scratch(random: &mut Random) -> Row {
    [
        random.log_uniform(0.1, 20.0),
        random.log_uniform(1e-3, 5.0),
        random.uniform(-2.0, 2.0) * random.pick(&[1.0, 0.1, 1e-6]),
        random.uniform(0.0, 2.0),
        random.uniform(0.38, 0.78),
    ]
}

#[test]
fn scratches_of_any_depth_keep_the_bounds() {
    let mut random = Random::new(501);
    for _ in 0..10_000 {
        let row = scratch(&mut random);
        hold(row);
        // Up to 1e4 wavelengths deep and wide, ridges too.
        let deep = random.log_uniform(1e-9, 1e4) * row[4];
        hold([row[0], random.signed(deep), row[2], row[3], row[4]]);
        hold([random.log_uniform(1e-9, 1e4) * row[4], deep, row[2], row[3], row[4]]);
    }
}

#[test]
fn the_triangle_keeps_the_bound_at_and_beside_the_poles_of_the_published_form() {
    let mut random = Random::new(502);
    for _ in 0..20_000 {
        let mut row = scratch(&mut random);
        row[1] = random.log_uniform(1e-3, 1e4) * row[4];
        row[0] = row[1] * random.log_uniform(1e-2, 1e3);
        let pole = 2.0 * row[1] * row[3] / row[0];
        for x in [
            pole,
            -pole,
            neighbour(pole, 1),
            neighbour(pole, -1),
            pole * (1.0 + random.log_uniform(1e-16, 1e-1)),
            -pole * (1.0 - random.log_uniform(1e-16, 1e-1)),
        ] {
            row[2] = x;
            hold(row);
        }
    }
}

#[test]
fn on_a_pole_one_sinc_is_whole_and_the_other_that_of_the_depth() {
    // p = w = 4 pi: F = W/2 (1 + 0).
    let row = [4.0, 0.5, 0.5, 2.0, 0.5];
    assert!((triangle(row) - Complex::new(2.0, 0.0)).norm() < 1e-14);
    // p = w = pi: (W/2) (sinc pi + exp(i pi)).
    let row = [4.0, 0.125, 0.125, 2.0, 0.5];
    assert!((triangle(row) - Complex::new(-2.0, 0.0)).norm() < 1e-14);
}

#[test]
fn zeros_of_the_lobes_have_relative_accuracy() {
    let mut random = Random::new(503);
    for _ in 0..10_000 {
        let mut row = scratch(&mut random);
        let n = f64::from(random.integer(1, 30) as i32);
        row[2] = neighbour(n * row[4] / row[0], random.integer(-3, 3));
        hold(row);
        // Depths of whole wavelengths.
        row[1] = neighbour(n * row[4] / row[3], random.integer(-3, 3));
        hold(row);
        let (depth, gamma, wavelength) = (row[1], row[3], row[4]);
        let squared = depth_term_squared(depth, gamma, wavelength);
        let due = depth_term(depth, gamma, wavelength).norm_sqr();
        assert!((squared - due).abs() <= 4.0 * f64::EPSILON * due, "{depth} {gamma}");
    }
}

/// int_{-W/2}^{W/2} f(b) exp(-2 pi i b xi2/lambda) db, split at 0, by the Gauss rule.
fn transform(row: Row, f: impl Fn(f64) -> Complex<f64>) -> Complex<f64> {
    let [width, depth, xi2, gamma, wavelength] = row;
    let waves = (width * xi2.abs() + depth.abs() * gamma) / wavelength;
    let pieces = 2 * (2 + (3.0 * waves) as usize);
    let wave = |b: f64| f(b) * Complex::from_polar(1.0, -2.0 * PI * b * xi2 / wavelength);
    gauss(wave, [-0.5 * width, 0.5 * width], pieces)
}

#[test]
fn the_integrals_by_brute_force_are_the_same() {
    let mut random = Random::new(504);
    for _ in 0..500 {
        let row = scratch(&mut random);
        let [width, depth, _, gamma, wavelength] = row;
        let bottom = |d: f64| Complex::from_polar(1.0, 2.0 * PI * gamma * d / wavelength);
        let one = Complex::new(1.0, 0.0);
        let due = transform(row, |_| one - bottom(depth));
        assert!((rectangle(row) - due).norm() <= 1e-12 * width, "rectangle {row:?}");
        let slant = |b: f64| bottom(depth * (1.0 - 2.0 * b.abs() / width));
        let due = transform(row, slant);
        assert!((triangle(row) - due).norm() <= 1e-12 * width, "triangle {row:?}");
        let due = transform(row, |b| one - slant(b));
        assert!((response(row) - due).norm() <= 1e-12 * width, "response {row:?}");
        let due = transform(row, |_| one).re;
        assert!((width_term(width, row[2], wavelength) - due).abs() <= 1e-12 * width);
    }
}

/// int_0^1 (1 - exp(ip(1-u))) cos(w u) du with 1 - exp from its half angle: relative accuracy for any small p.
fn response_over_width(p: f64, w: f64) -> Complex<f64> {
    let pieces = 4 + (p.abs() + w.abs()) as usize;
    let change = |u: f64| {
        let half = 0.5 * p * (1.0 - u);
        Complex::new(2.0 * half.sin().powi(2), -2.0 * half.sin() * half.cos()) * (w * u).cos()
    };
    gauss(change, [0.0, 1.0], pieces)
}

#[test]
fn a_shallow_groove_keeps_the_digits_of_its_response() {
    let mut random = Random::new(505);
    for _ in 0..4_000 {
        // gamma = 1/pi: p = 2 D/lambda, here lambda = 2 and W = 1, w = pi xi2/2.
        let (p, w) = (random.log_uniform(1e-250, 30.0), random.log_uniform(1e-30, 60.0));
        let row = [1.0, p / PI, 2.0 * w / PI, 1.0, 2.0];
        let (value, due) = (response(row), response_over_width(p, w));
        let error = (value - due).norm() / (p.min(1.0) * f64::EPSILON);
        assert!(error <= SHALLOW, "{p:e} {w:e}: {value:e} {due:e} {error}");
    }
    // The first order: -i p W/2 sinc^2(w/2).
    let value = response([1.0, 1e-30, 0.0, 1.0, 2.0]);
    assert!((value.im / (-0.5e-30 * PI) - 1.0).abs() < 1e-15, "{value:e}");
}

#[test]
fn the_response_of_a_triangle_is_its_mask_less_its_transform() {
    let mut random = Random::new(506);
    for _ in 0..20_000 {
        let mut row = scratch(&mut random);
        row[1] *= random.log_uniform(1e-3, 1e3);
        let mask = width_term(row[0], row[2], row[4]);
        let due = Complex::new(mask, 0.0) - triangle(row);
        assert!(
            (response(row) - due).norm() <= 2.0 * BOUND * f64::EPSILON * row[0],
            "{row:?}"
        );
    }
}

#[test]
fn limits_have_their_values() {
    let zero = Complex::new(0.0, 0.0);
    let row = [3.0, 0.4, 0.3, 1.7, 0.55];
    let with = |index: usize, value: f64| {
        let mut row = row;
        row[index] = value;
        row
    };
    for profile in [rectangle, triangle, response] {
        assert_eq!(profile(with(0, 0.0)), zero);
        for (index, value) in [(2, INFINITY), (2, -INFINITY)] {
            assert_eq!(profile(with(index, value)), zero);
        }
        for (index, value) in [
            (0, -1.0),
            (0, INFINITY),
            (1, INFINITY),
            (3, INFINITY),
            (4, 0.0),
            (4, -0.5),
        ] {
            assert!(is_nan(profile(with(index, value))), "{index} {value}");
        }
        for index in 0..5 {
            assert!(is_nan(profile(with(index, f64::NAN))), "{index}");
        }
    }
    let mask = width_term(3.0, 0.3, 0.55);
    assert_eq!(rectangle(with(1, 0.0)), zero);
    assert_eq!(rectangle(with(3, 0.0)), zero);
    assert_eq!(response(with(1, 0.0)), zero);
    assert!((triangle(with(1, 0.0)) - Complex::new(mask, 0.0)).norm() < 1e-15);
    assert_eq!(triangle(with(4, INFINITY)), Complex::new(3.0, 0.0));
    assert_eq!(rectangle(with(4, INFINITY)), zero);
    assert_eq!(width_term(3.0, 0.0, 0.5), 3.0);
    assert_eq!(width_term(0.0, INFINITY, 0.5), 0.0);
    assert_eq!(width_term(2.0, 0.25, 0.5), 0.0);
    assert_eq!(depth_term_squared(0.125, 2.0, 0.5), 4.0);
    assert_eq!(depth_term_squared(0.25, 2.0, 0.5), 0.0);
    assert_eq!(depth_term_squared(1e15, 2.0, 0.5), 0.0);
    assert_eq!(depth_term(0.125, 2.0, 0.5).re, 2.0);
    // 1 - i: an eighth of a turn, twice.
    assert!((depth_term(0.0625, 2.0, 0.5) - Complex::new(1.0, -1.0)).norm() < 1e-15);
    assert_eq!(depth_term_near_normal(0.0625, 0.5), depth_term(0.0625, 2.0, 0.5));
    assert_eq!(
        depth_term_near_normal_squared(0.07, 0.5),
        depth_term_squared(0.07, 2.0, 0.5)
    );
}

#[test]
fn no_finite_numbers_of_any_magnitude_give_a_value_that_is_not_finite_or_beyond_its_bound() {
    finite_and_within_the_bound(507, 100_000);
}

#[test]
#[ignore = "1e7 rows: in release only"]
fn ten_million_rows_of_any_magnitude_give_no_value_that_is_not_finite_or_beyond_its_bound() {
    finite_and_within_the_bound(517, 10_000_000);
}

fn finite_and_within_the_bound(seed: u64, count: usize) {
    let mut random = Random::new(seed);
    for k in 0..count {
        let row: Row = std::array::from_fn(|index| {
            let any = f64::from_bits(random.bits());
            let any = if any.is_finite() { any } else { -1e-300 };
            let x = match (k + index) % 3 {
                0 => any,
                1 => 10f64.powf(random.uniform(-12.0, 12.0)).copysign(any),
                _ => random.uniform(-2.0, 2.0),
            };
            if index == 0 || index == 4 {
                x.abs().max(5e-324)
            } else {
                x
            }
        });
        // The roundings of subnormal numbers beside.
        let most = row[0] * (1.0 + BOUND * f64::EPSILON) + 2e-323;
        for (profile, times) in [(rectangle as fn(Row) -> _, 2.0), (triangle, 1.0), (response, 2.0)] {
            let Complex { re, im } = profile(row);
            assert!(re.hypot(im) <= times * most || row[0] > 7e307, "{row:?}: {re:e} {im:e}");
        }
    }
}

/// The window times what the scratch changes, by quadrature over the surface.
fn over_the_surface(light: Coherence, row: Row, segment: Segment, xi1: f64) -> Complex<f64> {
    let [width, depth, xi2, gamma, wavelength] = row;
    let k = 2.0 * PI / wavelength;
    let [s_t, s_b] = segment.position;
    let pieces = |length: f64, xi: f64| 2 + (2.0 * length * (xi.abs() / wavelength + 1.0 / light.radius)) as usize;
    let [l1, l2] = segment.ends;
    let change = Complex::new(1.0, 0.0) - Complex::from_polar(1.0, k * gamma * depth);
    let wave = |t: f64, b: f64| {
        let window = (-0.5 * (t * t + b * b) / light.radius.powi(2)).exp();
        change * Complex::from_polar(window, -k * (xi1 * t + xi2 * b))
    };
    let along = |b: f64| gauss(|t| wave(t, b), [s_t + l1, s_t + l2], pieces(l2 - l1, xi1));
    gauss(along, [s_b - 0.5 * width, s_b + 0.5 * width], pieces(width, xi2))
}

#[test]
fn the_rectangle_under_the_window_is_the_integral_over_the_surface() {
    let mut random = Random::new(508);
    for _ in 0..60 {
        let row = scratch(&mut random);
        let light = Coherence {
            radius: random.pick(&[5.0, 10.0, 60.0]),
            wavelength: row[4],
        };
        let segment = Segment {
            position: [random.uniform(-9.0, 9.0), random.uniform(-2.0, 2.0) * light.radius],
            ends: [-random.uniform(0.0, 20.0), random.uniform(0.0, 20.0)],
        };
        let xi1 = random.uniform(-0.5, 0.5);
        let (profile, [_, xi2, gamma], _) = split(row);
        let value = response_rectangle_windowed(light, profile, segment, [xi1, xi2, gamma]);
        let due = over_the_surface(light, row, segment, xi1);
        let scale = 2.0 * row[0] * light.radius;
        assert!(
            (value - due).norm() <= 1e-12 * scale,
            "{row:?} {segment:?}: {value} {due}"
        );
    }
}

#[test]
fn the_separable_form_costs_what_the_notes_say_at_a_width_of_six_tenths_of_the_radius() {
    let light = Coherence {
        radius: 10.0,
        wavelength: 0.55,
    };
    let profile = Profile { width: 6.0, depth: 0.2 };
    let segment = Segment {
        position: [0.0, 0.0],
        ends: [-60.0, 60.0],
    };
    let largest = (0..400).map(|step| {
        let scattering = [0.0, f64::from(step) * 1e-3, 2.0];
        let exact = response_rectangle_windowed(light, profile, segment, scattering);
        let separable =
            profile_rectangle(profile, scattering, 0.55) * spatial_phase(light, segment, [0.0, scattering[1]]);
        (exact - separable).norm()
    });
    let peak = response_rectangle_windowed(light, profile, segment, [0.0, 0.0, 2.0]).norm();
    let share = largest.fold(0.0, f64::max) / peak;
    // (W/sigma)^2/24 = 1.5 % at the centre of the lobe, more beside it.
    assert!((0.014..0.035).contains(&share), "{share}");
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, cases: 2000, ..ProptestConfig::default() })]

    #[test]
    fn the_windowed_rectangle_tends_to_the_separable_form_as_the_width_falls(
        share in (-6.0..-1.0f64).prop_map(|e| 10f64.powf(e)),
        offset in -3.0..3.0f64,
        xi in [-0.02..0.02f64, -2.0..2.0f64],
        gamma in 0.0..2.0f64,
        radius in 5.0..100.0f64,
    ) {
        let light = Coherence { radius, wavelength: 0.55 };
        let profile = Profile { width: share * radius, depth: 0.17 };
        let segment = Segment { position: [3.0, offset * radius], ends: [-50.0, 90.0] };
        let exact = response_rectangle_windowed(light, profile, segment, [xi[0], xi[1], gamma]);
        let separable = profile_rectangle(profile, [xi[0], xi[1], gamma], 0.55)
            * spatial_phase(light, segment, [xi[0], xi[1]]);
        // Slope and curvature of the window over the width.
        let rest = (share * offset.abs() + share * share) * 2.0 * profile.width * 2.6 * radius + 1e-14 * radius * radius;
        prop_assert!((exact - separable).norm() <= rest, "{} {}", exact, separable);
    }

    #[test]
    fn profiles_are_even_across_and_conjugate_for_a_ridge_bit_for_bit(
        row in [0.1..20.0f64, -5.0..5.0f64, -2.0..2.0f64, 0.0..2.0f64, 0.3..0.8f64],
    ) {
        let mut across = row;
        across[2] = -row[2];
        let mut ridge = row;
        ridge[1] = -row[1];
        for profile in [rectangle, triangle, response] {
            prop_assert_eq!(profile(across), profile(row));
            prop_assert_eq!(profile(ridge), profile(row).conj());
        }
    }
}
