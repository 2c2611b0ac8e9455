//! The spatial phase: limits, symmetries, the whole hemisphere against the oracle, brute-force quadrature, finite values
//! for any bits, and what it costs beside the function it is made of.

use iridescence::Complex;
use iridescence::diffraction::{
    Coherence, Segment, spatial_phase, spatial_phase_infinite, spatial_phase_infinite_squared, windowed_transform,
};
use reference::gauss::gauss;
use reference::generate::random::Random;
use reference::metrics::complex::absolute_error;
use reference::oracle;
use std::f64::consts::PI;

/// Largest error in eps of sqrt(2 pi) sigma.
const BOUND: f64 = 6.0;
/// Largest relative error, in eps, of a segment too short for the window to change.
const FLAT_BOUND: f64 = 8.0;

const SQRT_2_PI: f64 = 2.5066282746310007;
const INFINITY: f64 = f64::INFINITY;

/// sigma lambda xi1 xi2 s_t s_b l1 l2.
type Row = [f64; 8];

fn eta([radius, wavelength, xi1, xi2, s_t, s_b, l1, l2]: Row) -> Complex<f64> {
    let segment = Segment {
        position: [s_t, s_b],
        ends: [l1, l2],
    };
    spatial_phase(Coherence { radius, wavelength }, segment, [xi1, xi2])
}

/// The error in eps of sqrt(2 pi) sigma.
fn error(row: Row) -> f64 {
    let value = eta(row);
    let absolute = absolute_error([value.re, value.im], &oracle::spatial_phase(&row));
    absolute / (SQRT_2_PI * row[0] * f64::EPSILON)
}

fn hold(row: Row) {
    let error = error(row);
    assert!(error <= BOUND, "{row:?}: {error} eps of the peak");
}

fn is_nan(z: Complex<f64>) -> bool {
    z.re.is_nan() && z.im.is_nan()
}

/// A scratch of a scene: either paper's coherence radius, any direction of the hemisphere.
fn scene(random: &mut Random) -> Row {
    let sigma = random.pick(&[10.0, 25.2, 60.0]);
    let xi = [0; 2].map(|_| random.uniform(-2.0, 2.0) * random.pick(&[1.0, 0.1, 1e-3]));
    let length = random.log_uniform(1.0, 1e4);
    let along = -length * random.uniform(-0.2, 1.2);
    [
        sigma,
        random.uniform(0.38, 0.78),
        xi[0],
        xi[1],
        random.uniform(-3.0, 3.0) * sigma,
        random.uniform(-5.0, 5.0) * sigma,
        along,
        along + length,
    ]
}

#[test]
fn the_whole_hemisphere_keeps_the_bound() {
    let mut random = Random::new(401);
    for _ in 0..20_000 {
        hold(scene(&mut random));
    }
}

#[test]
fn far_and_tiny_segments_keep_the_bound() {
    let mut random = Random::new(402);
    for _ in 0..10_000 {
        let mut row = scene(&mut random);
        // Origins 1 m away whose ends come back to the window, and ends beyond it.
        let far = random.log_uniform(1e3, 1e6);
        let far = random.signed(far);
        row[4] += far;
        row[6] -= far;
        row[7] -= far * f64::from(random.integer(0, 1) as i32);
        hold(row);
        // Lengths down to a femtometre.
        let mut row = scene(&mut random);
        row[7] = row[6] + random.log_uniform(1e-9, 1.0);
        hold(row);
        row[5] = random.uniform(-1e6, 1e6);
        hold(row);
    }
}

#[test]
fn semi_infinite_and_infinite_scratches_keep_the_bound() {
    let mut random = Random::new(403);
    for _ in 0..5_000 {
        let row = scene(&mut random);
        for (l1, l2) in [
            (-INFINITY, row[7]),
            (row[6], INFINITY),
            (-INFINITY, INFINITY),
            (INFINITY, row[6]),
        ] {
            hold([row[0], row[1], row[2], row[3], row[4], row[5], l1, l2]);
        }
    }
}

#[test]
fn an_infinite_scratch_is_the_limit_of_a_long_one() {
    let mut random = Random::new(404);
    for _ in 0..5_000 {
        let [radius, wavelength, xi1, xi2, s_t, s_b, ..] = scene(&mut random);
        let light = Coherence { radius, wavelength };
        let xi1 = xi1 * random.pick(&[1.0, 0.01]);
        let infinite = spatial_phase_infinite(light, s_b, [xi1, xi2]);
        let long = eta([radius, wavelength, xi1, xi2, s_t, s_b, -40.0 * radius, 40.0 * radius]);
        let scale = SQRT_2_PI * radius * f64::EPSILON;
        assert!((infinite - long).norm() <= BOUND * scale, "{radius} {xi1} {xi2} {s_b}");
        let truth = oracle::spatial_phase(&[radius, wavelength, xi1, xi2, 0.0, s_b, -INFINITY, INFINITY]);
        assert!(absolute_error([infinite.re, infinite.im], &truth) <= BOUND * scale);
        let squared = spatial_phase_infinite_squared(light, s_b, xi1);
        let due = infinite.norm_sqr();
        assert!(
            (squared - due).abs() <= 16.0 * f64::EPSILON * scale.max(due),
            "{squared} {due}"
        );
    }
}

/// int exp(-t^2/(2 sigma^2) - i k xi t) dt by the Gauss rule over many short pieces.
fn by_quadrature(light: Coherence, from: f64, to: f64, xi: f64) -> Complex<f64> {
    let pieces = 4 + ((to - from).abs() * (1.0 / light.radius + xi.abs() / light.wavelength) * 3.0) as usize;
    let wave = |t: f64| {
        let window = (-0.5 * (t / light.radius).powi(2)).exp();
        Complex::from_polar(window, -2.0 * PI * xi * t / light.wavelength)
    };
    gauss(wave, [from, to], pieces)
}

#[test]
fn the_integral_by_brute_force_is_the_same() {
    let mut random = Random::new(405);
    for _ in 0..300 {
        let row = scene(&mut random);
        let light = Coherence {
            radius: row[0],
            wavelength: row[1],
        };
        let (from, to, xi) = (row[4] + row[6].max(-300.0), row[4] + row[7].min(300.0), row[2]);
        let (value, due) = (
            windowed_transform(light, [from, to], xi),
            by_quadrature(light, from, to, xi),
        );
        assert!(
            (value - due).norm() <= 1e-12 * SQRT_2_PI * row[0],
            "{row:?}: {value} {due}"
        );
        // Across the scratch stand the window and the phase of the line's offset.
        let across = Complex::from_polar(
            (-0.5 * (row[5] / row[0]).powi(2)).exp(),
            -2.0 * PI * row[3] * row[5] / row[1],
        );
        let whole = eta([row[0], row[1], xi, row[3], 0.0, row[5], from, to]);
        assert!((whole - due * across).norm() <= 2e-12 * SQRT_2_PI * row[0], "{row:?}");
    }
}

#[test]
fn exchanged_ends_negate_and_a_mirrored_direction_conjugates_bit_for_bit() {
    let mut random = Random::new(406);
    for _ in 0..20_000 {
        let [radius, wavelength, xi1, xi2, s_t, s_b, l1, l2] = scene(&mut random);
        let value = eta([radius, wavelength, xi1, xi2, s_t, s_b, l1, l2]);
        assert_eq!(eta([radius, wavelength, xi1, xi2, s_t, s_b, l2, l1]), -value);
        assert_eq!(eta([radius, wavelength, -xi1, -xi2, s_t, s_b, l1, l2]), value.conj());
        assert_eq!(eta([radius, wavelength, -xi1, xi2, -s_t, s_b, -l2, -l1]), value);
        assert_eq!(eta([radius, wavelength, xi1, -xi2, s_t, -s_b, l1, l2]), value);
        assert_eq!(eta([radius, wavelength, xi1, xi2, s_t, s_b, l1, l1]).norm(), 0.0);
    }
}

#[test]
fn under_a_constant_window_a_segment_has_every_digit_of_length_times_sinc() {
    let mut random = Random::new(407);
    for _ in 0..4_000 {
        let length = random.log_uniform(1e-9, 10.0);
        let radius = length * random.log_uniform(1e9, 1e12);
        let (wavelength, xi) = (random.uniform(0.38, 0.78), random.uniform(-2.0, 2.0));
        let value = windowed_transform(Coherence { radius, wavelength }, [0.0, length], xi);
        // (1 - exp(-i k xi L))/(i k xi): the numerator is the response of a depth L to gamma = -xi.
        let [re, im] = oracle::profile_rectangle(&[1.0, length, 0.0, -xi, wavelength]).map(|part| part.value());
        let due = Complex::new(im, -re) / (2.0 * PI * xi / wavelength);
        let error = (value - due).norm() / (f64::EPSILON * length);
        assert!(error <= FLAT_BOUND, "{length} {xi}: {value} {due}");
        let infinite = Coherence {
            radius: INFINITY,
            wavelength,
        };
        assert_eq!(windowed_transform(infinite, [0.0, length], xi), value);
    }
    // The two ways meet where the window's last bit goes.
    let light = Coherence {
        radius: 10.0,
        wavelength: 0.5,
    };
    let edge = 10.0 / f64::from(1u32 << 27);
    for (length, xi) in [(edge, 0.3), (edge, 2.0), (edge, 1e7), (edge, 1e12)] {
        let [below, above] = [1.0 - 1e-15, 1.0 + 1e-15].map(|f| windowed_transform(light, [0.0, length * f], xi));
        assert!(
            (below - above).norm() <= 16.0 * f64::EPSILON * length,
            "{xi}: {below} {above}"
        );
    }
}

#[test]
fn limits_have_their_values() {
    let zero = Complex::new(0.0, 0.0);
    let row = [60.0, 0.55, 0.2, 0.3, 10.0, 5.0, -30.0, 80.0];
    let with = |index: usize, value: f64| {
        let mut row = row;
        row[index] = value;
        eta(row)
    };
    assert_eq!(with(0, 0.0), zero);
    assert_eq!(with(0, 1e-300), zero);
    assert_eq!(with(2, INFINITY), zero);
    assert_eq!(with(2, -INFINITY), zero);
    assert_eq!(with(4, INFINITY), zero);
    assert_eq!(with(5, INFINITY), zero);
    assert_eq!(with(5, -INFINITY), zero);
    assert_eq!(with(5, 1e300), zero);
    // No phases are left of an infinite wavelength.
    let plain = with(1, INFINITY);
    let area = Coherence {
        radius: 60.0,
        wavelength: 1.0,
    };
    let due = windowed_transform(area, [-20.0, 90.0], 0.0) * (-0.5f64 * (5.0f64 / 60.0).powi(2)).exp();
    assert!((plain - due).norm() < 1e-13, "{plain} {due}");
    // An infinite radius leaves the plain Fourier integral of finite ends, and nothing of infinite ones.
    assert!(with(0, INFINITY).norm() > 0.0 && with(0, INFINITY).norm() < 110.0);
    let mut endless = row;
    (endless[0], endless[7]) = (INFINITY, INFINITY);
    assert!(is_nan(eta(endless)));
    assert!(is_nan(with(3, INFINITY)));
    let light = |radius| Coherence {
        radius,
        wavelength: 0.5,
    };
    assert_eq!(spatial_phase_infinite(light(0.0), 0.0, [0.0, 0.3]), zero);
    assert_eq!(spatial_phase_infinite(light(9.0), INFINITY, [0.0, 0.3]), zero);
    assert_eq!(spatial_phase_infinite(light(9.0), 1.0, [INFINITY, 0.3]), zero);
    assert_eq!(spatial_phase_infinite_squared(light(0.0), 1.0, 0.0), 0.0);
    assert_eq!(spatial_phase_infinite_squared(light(2.0), 0.0, 0.0), 8.0 * PI);
}

#[test]
fn nan_and_a_light_outside_the_domain_give_nan() {
    let row = [60.0, 0.55, 0.2, 0.3, 10.0, 5.0, -30.0, 80.0];
    for index in 0..8 {
        let mut bad = row;
        bad[index] = f64::NAN;
        assert!(is_nan(eta(bad)), "{index}");
        bad[7] = if index == 7 { f64::NAN } else { INFINITY };
        assert!(is_nan(eta(bad)), "{index}");
    }
    for (index, value) in [(0, -1.0), (0, -INFINITY), (1, 0.0), (1, -0.5), (1, -INFINITY)] {
        let mut bad = row;
        bad[index] = value;
        assert!(is_nan(eta(bad)), "{index} {value}");
        let light = Coherence {
            radius: bad[0],
            wavelength: bad[1],
        };
        assert!(
            is_nan(spatial_phase_infinite(light, 1.0, [0.1, 0.2])),
            "{index} {value}"
        );
        assert!(
            spatial_phase_infinite_squared(light, 1.0, 0.1).is_nan(),
            "{index} {value}"
        );
        assert!(is_nan(windowed_transform(light, [0.0, 1.0], 0.1)), "{index} {value}");
    }
    let light = Coherence {
        radius: 9.0,
        wavelength: 0.5,
    };
    for [offset, xi1, xi2] in [[f64::NAN, 0.1, 0.1], [1.0, f64::NAN, 0.1], [1.0, 0.1, f64::NAN]] {
        assert!(is_nan(spatial_phase_infinite(light, offset, [xi1, xi2])));
        assert!(xi2.is_nan() || spatial_phase_infinite_squared(light, offset, xi1).is_nan());
    }
}

#[test]
fn no_finite_numbers_of_any_magnitude_give_a_value_that_is_not_finite_or_beyond_the_peak() {
    finite_and_within_the_peak(408, 200_000);
}

#[test]
#[ignore = "1e7 rows: in release only"]
fn ten_million_rows_of_any_magnitude_give_no_value_that_is_not_finite_or_beyond_the_peak() {
    finite_and_within_the_peak(418, 10_000_000);
}

fn finite_and_within_the_peak(seed: u64, count: usize) {
    let mut random = Random::new(seed);
    for k in 0..count {
        let row: Row = std::array::from_fn(|index| {
            let any = f64::from_bits(random.bits());
            let any = if any.is_finite() { any } else { 1e-300 };
            let x = match (k + index) % 3 {
                0 => any,
                1 => 10f64.powf(random.uniform(-12.0, 12.0)).copysign(any),
                _ => random.uniform(-2.0, 2.0),
            };
            if index < 2 { x.abs().max(5e-324) } else { x }
        });
        let value = eta(row);
        // The product with sigma may round to the largest numbers, no further.
        let peak = SQRT_2_PI * row[0] * (1.0 + BOUND * f64::EPSILON);
        let fits = value.re.abs().max(value.im.abs()) <= peak;
        assert!(
            fits && (value.re.is_finite() && value.im.is_finite() || row[0] > 7e307),
            "{row:?}: {value}"
        );
    }
}

#[test]
fn lengths_of_any_unit_give_the_same_phase() {
    let mut random = Random::new(409);
    for _ in 0..4_000 {
        // All lengths scaled together leave eta/sigma alone.
        let scale = 2f64.powi(random.integer(-420, 420) as i32);
        let mut row = scene(&mut random);
        let value = eta(row) * scale;
        for index in [0, 1, 4, 5, 6, 7] {
            row[index] *= scale;
        }
        let scaled = eta(row);
        assert!(
            (scaled - value).norm() <= BOUND * f64::EPSILON * SQRT_2_PI * row[0],
            "{row:?}"
        );
    }
    // A radius times a direction that leaves the range, their ratio to the wavelength does not.
    let (two, scale) = (|n: i32| 2f64.powi(n), 2f64.powi(500));
    let small = [two(15), two(522), 1.5 * two(510), 0.0, 0.0, 0.0, -two(14), two(16)];
    let large = [0, 1, 2, 3, 4, 5, 6, 7].map(|index| small[index] * if index == 2 || index == 3 { 1.0 } else { scale });
    assert!((large[0] * large[2]).is_infinite());
    assert_eq!(eta(large), eta(small) * scale);
    assert!(eta(small).norm() > 5e-3 * small[0]);
}

#[test]
#[cfg(not(debug_assertions))]
fn it_costs_little_more_than_the_difference_of_error_functions_inside_it() {
    use iridescence::special::erf_difference_scaled;
    use std::hint::black_box;
    use std::time::Instant;

    let mut random = Random::new(410);
    let rows: Vec<Row> = (0..2_000).map(|_| scene(&mut random)).collect();
    let inner: Vec<[f64; 3]> = rows
        .iter()
        .map(|row| {
            let unit = 1.0 / (row[0] * 2f64.sqrt());
            let (a1, a2) = ((row[4] + row[6]) * unit, (row[4] + row[7]) * unit);
            [a1, a2, PI * 2f64.sqrt() * row[0] * row[2] / row[1]]
        })
        .collect();
    let best = |run: &dyn Fn() -> f64| {
        let time = || {
            let start = Instant::now();
            black_box(run());
            start.elapsed().as_secs_f64()
        };
        (0..200).map(|_| time()).fold(INFINITY, f64::min)
    };
    let whole = best(&|| rows.iter().map(|row| eta(black_box(*row)).re).sum());
    let part = best(&|| {
        let value = |[a1, a2, b]: [f64; 3]| erf_difference_scaled(a1, a2, b).re;
        inner.iter().map(|row| value(black_box(*row))).sum()
    });
    let nanoseconds = |t: f64| t / rows.len() as f64 * 1e9;
    println!(
        "{} ns, {} ns of it the difference",
        nanoseconds(whole),
        nanoseconds(part)
    );
    assert!(whole < 1.5 * part, "{whole:e} {part:e}");
}
