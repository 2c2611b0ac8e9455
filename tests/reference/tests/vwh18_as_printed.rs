//! VWH18 Eq. 29 and Eq. 27 as printed: what they give, how far off, and where radiance turns negative.

use iridescence::special;
use reference::as_printed::*;
use reference::generate::random::Random;
use reference::oracle;

const PRINTED: [f64; 6] = [1.0, -1.0, -1.0, 1.0, 1.0, 1.0];

/// Largest absolute error of a form of Eq. 29 over (0, 60], and where.
fn largest_error(si: impl Fn(f64) -> f64) -> (f64, f64) {
    (1..=30_000)
        .map(|k| f64::from(k) * 0.002)
        .map(|x| ((si(x) - oracle::sine_integral(x).hi).abs(), x))
        .fold((0.0, 0.0), |worst, error| {
            if error.0 > worst.0 || error.0.is_nan() {
                error
            } else {
                worst
            }
        })
}

#[test]
fn the_fit_errs_by_0_0510_at_3_56_and_its_slope_at_zero_is_0_994() {
    let (error, x) = largest_error(sine_integral_vwh18_29);
    assert!(
        (error - 0.0510).abs() < 5e-5 && (x - 3.56).abs() < 0.01,
        "{error} at {x}"
    );
    let slope = sine_integral_vwh18_29(1e-8) / 1e-8;
    assert!((slope - 0.994).abs() < 5e-4, "{slope}");
    let relative = (1..30_000).map(|k| f64::from(k) * 0.002);
    let relative = relative
        .map(|x| (sine_integral_vwh18_29(x) / oracle::sine_integral(x).hi - 1.0).abs())
        .fold(0.0, f64::max);
    assert!((relative - 0.030).abs() < 5e-4, "{relative}");
    // The mean over a period of x (fit - Si) far out: (1 - a0) never cancels.
    let bias = (0..1000).map(|k| 1e4 + f64::from(k) * std::f64::consts::TAU / 1000.0);
    let bias = bias
        .map(|x| x * (sine_integral_vwh18_29(x) - oracle::sine_integral(x).hi) / 1000.0)
        .sum::<f64>();
    assert!((bias - 0.339).abs() < 2e-3, "{bias}");
    assert!((largest_error(|x| f64::from(sine_integral_vwh18_29_f32(x as f32))).0 - error).abs() < 1e-5);
}

#[test]
fn no_sign_in_equation_29_is_misprinted() {
    let printed = largest_error(|x| sine_integral_signs(PRINTED, x)).0;
    for variant in 1..64 {
        let signs = std::array::from_fn(|i| if variant >> i & 1 == 1 { -PRINTED[i] } else { PRINTED[i] });
        let error = largest_error(|x| sine_integral_signs(signs, x)).0;
        assert!(error > 5.0 * printed || !error.is_finite(), "{signs:?}: {error}");
    }
}

/// Share of arcs whose integral comes out negative, for a method and a way to draw arcs.
fn negative_share(arc: impl Fn([f64; 2]) -> f64, draw: impl Fn(&mut Random) -> [f64; 2]) -> f64 {
    let mut random = Random::new(29);
    let count = 40_000;
    let negative = (0..count).filter(|_| arc(draw(&mut random)) < 0.0).count();
    negative as f64 / f64::from(count)
}

/// Both ends uniform on one side of the peak.
fn wide(random: &mut Random) -> [f64; 2] {
    let (a, b) = (random.uniform(1.0, 75.0), random.uniform(1.0, 75.0));
    [a.min(b), a.max(b)]
}

/// From 0.1 % to 10 % of the start in length.
fn short(random: &mut Random) -> [f64; 2] {
    let start = random.uniform(1.0, 60.0);
    [start, start * (1.0 + random.log_uniform(1e-3, 0.1))]
}

#[test]
fn the_printed_fit_makes_light_negative_where_ours_never_does() {
    let shares = [wide, short].map(|draw| negative_share(sinc_squared_integral_vwh18_27, draw));
    println!(
        "negative: {:.2} % of wide arcs, {:.2} % of short ones",
        100.0 * shares[0],
        100.0 * shares[1]
    );
    assert!(shares[0] > 0.005 && shares[1] > 0.15, "{shares:?}");
    let single = negative_share(
        |[a, b]| f64::from(sinc_squared_integral_vwh18_27_f32(a as f32, b as f32)),
        short,
    );
    assert!(single > 0.15, "{single}");
    for draw in [wide, short] {
        assert_eq!(negative_share(special::sinc_squared_integral, draw), 0.0);
        let exact = |[a, b]: [f64; 2]| oracle::sinc_squared_integral(a, b).hi;
        assert_eq!(negative_share(exact, draw), 0.0);
    }
    // The fitted antiderivative falls over about a quarter of its range, where the true one never does.
    let falls =
        (1..150_000).filter(|&k| sinc_squared_integral_vwh18_27([f64::from(k) * 1e-3, f64::from(k + 1) * 1e-3]) < 0.0);
    let share = falls.count() as f64 / 150_000.0;
    println!(
        "the fitted antiderivative falls over {:.1} % of (0, 150)",
        100.0 * share
    );
    assert!((0.15..0.35).contains(&share), "{share}");
}

#[test]
fn equation_27_as_printed_is_zero_over_zero_at_the_peak() {
    assert!(sinc_squared_integral_vwh18_27([0.0, 1.0]).is_nan());
    assert!(sinc_squared_integral_vwh18_27_f32(-1.0, 0.0).is_nan());
    assert!(special::sinc_squared_integral([0.0, 1.0]) > 0.89);
}

#[test]
fn equation_27_is_the_band_integral_once_si_is_exact() {
    // int over [q0, q1] of exp(-(sigma k xi)^2)-normalised sinc^2(k W q/2): sqrt(pi)/(sigma k) times the arc in q.
    let (sigma, k, width) = (60.0, 11.4, 2.5);
    let n = |q: f64| band_antiderivative_vwh18_27(sigma, k, width, q, |x| oracle::sine_integral(x).hi);
    for [q0, q1] in [[0.01, 0.3], [-0.2, 0.4], [0.5, 0.9]] {
        let a = k * width / 2.0;
        let arc = oracle::sinc_squared_integral(a * q0, a * q1).hi / a;
        let expected = std::f64::consts::PI.sqrt() / (sigma * k) * arc;
        assert!((n(q1) - n(q0) - expected).abs() < 1e-13 * expected, "{q0} {q1}");
    }
}
