//! WVJH17: each formula exactly as printed against the integral or the path length it stands for, and ours beside it.

use iridescence::diffraction::*;
use iridescence::sampling;
use num_complex::Complex;
use reference::as_printed::{self, TriangleRepairs};
use reference::generate::random::Random;
use reference::simpson::simpson;
use std::f64::consts::{PI, TAU};

const WAVELENGTH: f64 = 0.55;

fn coherence(radius: f64) -> Coherence {
    Coherence {
        radius,
        wavelength: WAVELENGTH,
    }
}

#[test]
fn equations_16_and_21_are_right_as_printed() {
    for (sigma, xi) in [(10.0, [0.003, -0.004]), (60.0, [0.0005, 0.001]), (10.0, [0.0, 0.0])] {
        // The window is a product, so its transform is one too.
        let along = |x: f64| {
            let wave = |t: f64| (-t * t / (2.0 * sigma * sigma)).exp() * (TAU * t * x / WAVELENGTH).cos();
            simpson(wave, [-12.0 * sigma, 12.0 * sigma], 2000)
        };
        let truth = along(xi[0]) * along(xi[1]);
        let printed = as_printed::base_response_wvjh17_16(sigma, xi.map(|x| x / WAVELENGTH));
        let ours = base_response(coherence(sigma), xi);
        assert!(
            (printed - truth).abs() <= 1e-13 * TAU * sigma * sigma,
            "{printed} {truth}"
        );
        assert!(
            (ours - printed).abs() <= 2e-15 * TAU * sigma * sigma,
            "{ours} {printed}"
        );
        // The deviation of |B|^2 in 1/length, by its second moment.
        let lobe = |x: f64| as_printed::base_response_wvjh17_16(sigma, [x, 0.0]).powi(2);
        let reach = 12.0 * as_printed::base_deviation_wvjh17_21(sigma);
        let variance = simpson(|x| x * x * lobe(x), [-reach, reach], 2000) / simpson(lobe, [-reach, reach], 2000);
        let printed = as_printed::base_deviation_wvjh17_21(sigma);
        assert!(
            (variance.sqrt() / printed - 1.0).abs() < 1e-13,
            "{} {printed}",
            variance.sqrt()
        );
    }
}

#[test]
fn equations_23_and_24_are_right_as_printed_at_any_orientation() {
    let mut random = Random::new(23);
    let mut worst = 0.0_f64;
    for _ in 0..2000 {
        let sigma = random.log_uniform(5.0, 80.0);
        let (sine, cosine) = random.uniform(0.0, TAU).sin_cos();
        let r0 = [random.uniform(-2.0, 2.0) * sigma, random.uniform(-2.0, 2.0) * sigma];
        let length = random.log_uniform(0.2, 5.0) * sigma;
        let xi = [random.uniform(-3.0, 3.0), random.uniform(-3.0, 3.0)].map(|x| x * WAVELENGTH / (TAU * sigma));
        let printed =
            as_printed::spatial_phase_wvjh17_23(sigma, r0, [cosine, sine], length, xi.map(|x| x / WAVELENGTH));
        let own = |[x, y]: [f64; 2]| [x * cosine + y * sine, y * cosine - x * sine];
        let segment = Segment {
            position: own(r0),
            ends: [-0.5 * length, 0.5 * length],
        };
        let ours = spatial_phase(coherence(sigma), segment, own(xi));
        worst = worst.max((printed - ours).norm() / (TAU.sqrt() * sigma));
    }
    println!("{worst:e}");
    assert!(worst <= 1e-14, "{worst}");
}

/// The integral over the hemisphere of a reflectance times the cosine of the way out: over direction cosines, around the
/// mirror direction.
fn mirror_albedo(incidence: f64, sigma: f64, reflectance: impl Fn(f64) -> f64) -> f64 {
    let reach = 8.0 * WAVELENGTH / (8f64.sqrt() * PI * sigma);
    let row = |y: f64| {
        let cell = |x: f64| {
            let out = [x - incidence.sin(), y];
            if out[0] * out[0] + out[1] * out[1] < 1.0 {
                reflectance(base_response(coherence(sigma), [x, y]))
            } else {
                0.0
            }
        };
        simpson(cell, [-reach, reach], 200)
    };
    simpson(row, [-reach, reach], 200)
}

#[test]
fn equations_4_7_and_15_darken_a_mirror_by_the_cosine_of_incidence() {
    let sigma = 60.0;
    for (degrees, expected) in [(0.0, 1.0), (30.0, 0.866), (60.0, 0.5), (80.0, 0.174)] {
        let incidence = f64::to_radians(degrees);
        let printed =
            |base: f64| as_printed::reflectance_wvjh17_15(incidence.cos(), sigma, WAVELENGTH, Complex::new(base, 0.0));
        let albedo = mirror_albedo(incidence, sigma, printed);
        assert!((albedo - expected).abs() < 5e-4, "{degrees}: {albedo}");
        let ours = |base: f64| reflectance_coherent(coherence(sigma), base, Complex::new(0.0, 0.0));
        let albedo = mirror_albedo(incidence, sigma, ours);
        assert!((albedo - 1.0).abs() < 1e-12, "{degrees}: {albedo}");
    }
    // Reciprocity: the response depends on the sum of the two directions alone, the printed factor on one of them.
    let response = Complex::new(3.0, 4.0);
    let [gamma_in, gamma_out] = [0.9, 0.3];
    let there = as_printed::reflectance_wvjh17_15(gamma_in, sigma, WAVELENGTH, response);
    let back = as_printed::reflectance_wvjh17_15(gamma_out, sigma, WAVELENGTH, response);
    assert!((there / back - 3.0).abs() < 1e-14, "{there} {back}");
}

#[test]
fn equation_19_divides_by_the_wavelength_twice() {
    let (width, xi2) = (2.2, 0.25);
    // xi' of Eq. 5 already holds 1/lambda; Eq. 14 has no other.
    let truth = simpson(
        |b| (TAU * b * xi2 / WAVELENGTH).cos(),
        [-0.5 * width, 0.5 * width],
        2000,
    );
    let printed = as_printed::width_term_wvjh17_19(width, xi2 / WAVELENGTH, WAVELENGTH);
    let ours = width_term(width, xi2, WAVELENGTH);
    assert!((ours - truth).abs() < 1e-12, "{ours} {truth}");
    assert!(truth.abs() < 1e-12 && printed.abs() > 0.05 * width, "{printed} {truth}");
    // In nanometres the printed width term loses its lobes: all of the hemisphere is peak.
    let in_nm = as_printed::width_term_wvjh17_19(2200.0, xi2 / 550.0, 550.0) / 2200.0;
    assert!(in_nm > 0.9999, "{in_nm}");
}

/// The field of a mirror with one scratch in a direction, by the lengths of the paths: time factor exp(-i omega t), a
/// longer path turns the phase forwards.
fn field_by_paths(sigma: f64, width: f64, depth: f64, offset: f64, scattering: [f64; 3]) -> Complex<f64> {
    let k = TAU / WAVELENGTH;
    let wave = |x: f64, below: f64| {
        // Both directions point away: a point in their direction is nearer by its component along each.
        let path = -scattering[1] * x + scattering[2] * below;
        Complex::from_polar((-x * x / (2.0 * sigma * sigma)).exp(), k * path)
    };
    let [from, to] = [offset - 0.5 * width, offset + 0.5 * width];
    let across = simpson(|x| wave(x, 0.0), [-8.0 * sigma, from], 8000)
        + simpson(|x| wave(x, depth), [from, to], 2000)
        + simpson(|x| wave(x, 0.0), [to, 8.0 * sigma], 8000);
    across * windowed_transform(coherence(sigma), [f64::NEG_INFINITY, f64::INFINITY], scattering[0])
}

#[test]
fn equations_20_and_28_clash_in_sign_and_20_is_the_one_of_a_groove() {
    let (sigma, width, depth, offset) = (10.0, 2.0, 0.1, 5.0);
    let scattering = [0.001, 0.012, 1.9];
    let truth = field_by_paths(sigma, width, depth, offset, scattering).norm_sqr();
    let base = base_response(coherence(sigma), [scattering[0], scattering[1]]);
    let line = width_term(width, scattering[1], WAVELENGTH)
        * spatial_phase_infinite(coherence(sigma), offset, [scattering[0], scattering[1]]);
    let by_20 = as_printed::depth_term_wvjh17_20(depth, scattering[2], WAVELENGTH);
    let by_28 = 1.0 - as_printed::depth_phase_wvjh17_28(depth, scattering[2], WAVELENGTH);
    let [one, two] = [by_20, by_28].map(|term| (base - line * term).norm_sqr());
    println!("to the truth: {} and {}", one / truth, two / truth);
    assert!((one / truth - 1.0).abs() < 0.02, "{one} {truth}");
    assert!((two / truth - 1.0).abs() > 0.1, "{two} {truth}");
    let segment = Segment {
        position: [0.0, offset],
        ends: [f64::NEG_INFINITY, f64::INFINITY],
    };
    let profile = Profile { width, depth };
    let ours = base - response_rectangle_windowed(coherence(sigma), profile, segment, scattering);
    assert!(
        (ours.norm_sqr() / truth - 1.0).abs() < 1e-9,
        "{} {truth}",
        ours.norm_sqr()
    );
    // Without the base the two signs give the same.
    assert!((by_20.norm_sqr() - by_28.norm_sqr()).abs() < 1e-15);
}

/// The transform of a triangular groove by Simpson's rule on each flank.
fn triangle_by_quadrature([width, depth, xi2, gamma_sum, wavelength]: [f64; 5]) -> Complex<f64> {
    let wave = |b: f64| {
        let bottom = depth * (1.0 - 2.0 * b.abs() / width);
        Complex::from_polar(1.0, TAU * (gamma_sum * bottom - b * xi2) / wavelength)
    };
    simpson(wave, [-0.5 * width, 0.0], 4000) + simpson(wave, [0.0, 0.5 * width], 4000)
}

fn ours_triangle([width, depth, xi2, gamma_sum, wavelength]: [f64; 5]) -> Complex<f64> {
    profile_triangle(Profile { width, depth }, [0.0, xi2, gamma_sum], wavelength)
}

#[test]
fn equations_29_to_31_have_two_misprints_and_both_must_be_mended() {
    let mut random = Random::new(29);
    let (none, width) = (
        TriangleRepairs::default(),
        TriangleRepairs {
            width: true,
            sign: false,
        },
    );
    let sign = TriangleRepairs {
        width: false,
        sign: true,
    };
    let both = TriangleRepairs {
        width: true,
        sign: true,
    };
    let mut worst = [0.0_f64; 5];
    for _ in 0..400 {
        let row = [
            random.uniform(0.5, 6.0),
            random.uniform(0.02, 1.0),
            random.uniform(-1.5, 1.5),
            random.uniform(0.5, 2.0),
            random.uniform(0.38, 0.78),
        ];
        let truth = triangle_by_quadrature(row);
        let forms = [none, width, sign, both].map(|repairs| as_printed::profile_triangle_repaired(repairs, row));
        for (worst, form) in worst.iter_mut().zip(forms) {
            *worst = worst.max((form - truth).norm() / row[0]);
        }
        worst[4] = worst[4].max((ours_triangle(row) - truth).norm() / row[0]);
    }
    println!("as printed, width, sign, both, ours: {worst:?}");
    assert!(worst[0] > 5.0, "{worst:?}");
    assert!(worst[1] > 1.0, "{worst:?}");
    assert!(worst[2] > 1.0, "{worst:?}");
    assert!(worst[3] < 1e-8 && worst[4] < 1e-8, "{worst:?}");
}

#[test]
fn equation_29_has_poles_at_which_a_groove_has_none() {
    // Exactly representable: 2 D gamma/W = 0.5.
    let at = |xi2: f64| [2.0, 0.25, xi2, 2.0, 0.5];
    let mended = TriangleRepairs {
        width: true,
        sign: true,
    };
    let printed = as_printed::profile_triangle_repaired(mended, at(0.5));
    assert!(printed.re.is_nan(), "{printed}");
    for pole in [0.5, -0.5] {
        let ours = ours_triangle(at(pole));
        assert!(
            (ours - triangle_by_quadrature(at(pole))).norm() < 1e-10,
            "{pole}: {ours}"
        );
    }
    // Beside it the printed form cancels: at a relative distance of 1e-14 it has about four digits.
    let mut random = Random::new(31);
    let mut worst = [0.0_f64; 2];
    for _ in 0..400 {
        let [width, depth, gamma] = [
            random.uniform(0.5, 6.0),
            random.uniform(0.02, 1.0),
            random.uniform(0.5, 2.0),
        ];
        let wavelength = random.uniform(0.38, 0.78);
        let pole = random.signed(2.0 * depth * gamma / width) * (1.0 + random.signed(1e-14));
        let row = [width, depth, pole, gamma, wavelength];
        let truth = triangle_by_quadrature(row);
        let form = as_printed::profile_triangle_repaired(mended, row);
        worst[0] = worst[0].max((form - truth).norm() / width);
        worst[1] = worst[1].max((ours_triangle(row) - truth).norm() / width);
    }
    println!("beside a pole: {worst:?}");
    assert!(worst[0] > 1e-4 && worst[0] < 1.0, "{worst:?}");
    assert!(worst[1] < 1e-10, "{worst:?}");
}

#[test]
fn equation_24_cancels_in_single_precision_far_along_a_scratch() {
    let mut random = Random::new(24);
    let sigma = 10.0_f32;
    // Distance along, in radii; the root mean square of the printed error between two bounds; ours below a bound.
    for (distance, printed, ours) in [(1e3, [0.02, 0.06], 2e-5), (1e4, [0.8, f64::INFINITY], 2e-4)] {
        let mut squares = [0.0; 2];
        let count = 4000;
        for _ in 0..count {
            let (sine, cosine) = random.uniform(0.0, TAU).sin_cos();
            let tangent = [cosine as f32, sine as f32];
            let [along, across] = [distance as f32 * sigma, random.uniform(0.0, 1.0) as f32 * sigma];
            let r0 = [
                along * tangent[0] - across * tangent[1],
                along * tangent[1] + across * tangent[0],
            ];
            let exact = r0.map(f64::from);
            let bitangential = exact[1] * f64::from(tangent[0]) - exact[0] * f64::from(tangent[1]);
            let truth = (-(bitangential / f64::from(sigma)).powi(2) / 2.0).exp();
            let typed = as_printed::spatial_weight_wvjh17_24_f32(sigma, r0, tangent);
            let b = r0[1] * tangent[0] - r0[0] * tangent[1];
            let stable = (-b * b / (2.0 * sigma * sigma)).exp();
            for (sum, found) in squares.iter_mut().zip([typed, stable]) {
                *sum += (f64::from(found) - truth).powi(2) / f64::from(count);
            }
        }
        let [typed, stable] = squares.map(f64::sqrt);
        println!("{distance:e} radii along: printed {typed:e}, by the bitangent {stable:e}");
        assert!((printed[0]..=printed[1]).contains(&typed), "{distance}: {typed}");
        assert!(stable < ours, "{distance}: {stable}");
    }
}

#[test]
fn crossings_violate_energy_where_section_4_2_says_they_do_not() {
    // Two phases, each uniform: the mean of |1 - D1 - D2|^2 against that of |(1 - D1)(1 - D2)|^2.
    let count = 64;
    let terms: Vec<_> = (0..count)
        .map(|j| as_printed::depth_term_wvjh17_20(f64::from(j) / f64::from(count), 1.0, 1.0))
        .collect();
    let (mut added, mut crossed, mut largest) = (0.0, 0.0, 0.0_f64);
    for one in &terms {
        for two in &terms {
            let sum = (1.0 - one - two).norm_sqr();
            largest = largest.max(sum);
            added += sum / f64::from(count * count);
            crossed += (1.0 - one - two + one * two).norm_sqr() / f64::from(count * count);
        }
    }
    assert!((added - 3.0).abs() < 1e-12, "{added}");
    assert!((largest - 9.0).abs() < 1e-12, "{largest}");
    assert!((crossed - 1.0).abs() < 1e-12, "{crossed}");
}

#[test]
fn the_cull_at_three_radii_drops_an_amplitude_of_a_hundredth() {
    let sigma = 60.0 / 6.0;
    let dropped = coherence_window(30.0, sigma);
    assert!((dropped - 1.1e-2).abs() < 2e-4, "{dropped}");
    assert!((coherence_window(37.2, sigma) / 1e-3 - 1.0).abs() < 0.02);
    // Beside the base it shows: |B - S|^2 of a scratch just beyond the cull, in the mirror direction.
    let base = base_response(coherence(sigma), [0.0, 0.0]);
    let profile = Profile {
        width: 3.0,
        depth: WAVELENGTH / 4.0,
    };
    let scratch = profile_rectangle(profile, [0.0, 0.0, 2.0], WAVELENGTH)
        * spatial_phase_infinite(coherence(sigma), 30.0, [0.0, 0.0]);
    let change = (base - scratch).norm_sqr() / (base * base) - 1.0;
    println!("{change}");
    assert!(change.abs() > 1e-3, "{change}");
}

#[test]
fn equation_22_lacks_the_wavelength_and_turns_the_incident_direction() {
    let sigma = 10.0;
    let incident = [0.5, 0.0];
    // Eq. 5: xi' = (alpha - alpha_i)/lambda, so the lobe's middle, xi' = 0, lies at alpha = alpha_i.
    let middle = as_printed::base_direction_wvjh17_22([0.0, 0.0], incident);
    let by_5 = [0, 1].map(|i| (middle[i] - incident[i]) / WAVELENGTH);
    assert_eq!(as_printed::base_response_wvjh17_16(sigma, by_5), 0.0);
    assert!(as_printed::base_response_wvjh17_16(sigma, [0.0, 0.0]) > 600.0);
    // A deviation of Eq. 21 is a frequency; as a direction cosine it must be times the wavelength.
    let deviation = as_printed::base_deviation_wvjh17_21(sigma);
    let typed = as_printed::base_direction_wvjh17_22([deviation, 0.0], incident)[0] - middle[0];
    let scene = coherence(sigma);
    let lobe = |x: f64| base_response(scene, [x, 0.0]).powi(2);
    let reach = 12.0 * deviation;
    let variance = simpson(|x| x * x * lobe(x), [-reach, reach], 4000) / simpson(lobe, [-reach, reach], 4000);
    let ratio = typed / variance.sqrt();
    assert!((ratio * WAVELENGTH - 1.0).abs() < 1e-10, "{ratio}");
}

#[test]
fn base_lobe_samples_have_the_deviation_of_the_lobe_in_direction_cosines() {
    let scene = coherence(10.0);
    let mut random = Random::new(22);
    let incident = [0.5, 0.0, 0.75_f64.sqrt()];
    let (mut sum, mut squares, mut count) = (0.0, 0.0, 0.0);
    for _ in 0..40_000 {
        let numbers = [random.uniform(0.0, 1.0), random.uniform(0.0, 1.0)];
        if let Some(sample) = sampling::base_lobe_sample(scene, incident, numbers) {
            let xi = sample.direction[0] + incident[0];
            sum += xi;
            squares += xi * xi;
            count += 1.0;
        }
    }
    let truth = WAVELENGTH * as_printed::base_deviation_wvjh17_21(10.0);
    let found = f64::sqrt(squares / count);
    assert!((found / truth - 1.0).abs() < 0.02, "{found} {truth}");
    assert!((sum / count).abs() < 0.03 * truth, "{}", sum / count);
}

#[test]
fn the_blend_without_a_base_gives_up_to_four_times_the_coverage() {
    let (scene, width, offset) = (coherence(10.0), 2.0, 4.0);
    let k = TAU / WAVELENGTH;
    let mean = (-(offset / scene.radius).powi(2)).exp();
    // The share of the window's energy that lies below the scratch.
    let energy = |x: f64| (-(x / scene.radius).powi(2)).exp();
    let coverage = simpson(energy, [offset - 0.5 * width, offset + 0.5 * width], 200) / (PI.sqrt() * scene.radius);
    for depth in [WAVELENGTH / 4.0, WAVELENGTH / 8.0, 0.03] {
        let profile = Profile { width, depth };
        // B = 0 in Eq. 15: the energy over all direction cosines, real and evanescent, at one phase of the depth.
        let along = simpson(|x| (-(scene.radius * k * x).powi(2)).exp(), [-0.05, 0.05], 2000);
        let reach = 400.0;
        let across = simpson(
            |x| reflectance_incoherent(scene, scratch_squared(scene, profile, [0.0, x, 2.0], mean)),
            [-reach, reach],
            400_000,
        );
        let albedo = along * across;
        let expected = coverage * (2.0 - 2.0 * (2.0 * k * depth).cos());
        println!("depth {depth}: {:.3} times the coverage", albedo / coverage);
        assert!((albedo / expected - 1.0).abs() < 5e-3, "{albedo} {expected}");
        let ours = energy_blend(coverage, depth_term_squared(depth, 2.0, WAVELENGTH));
        // With a base the window's energy, split by the mean of the transfer function below and beside the scratch.
        let phase = Complex::from_polar(1.0, 2.0 * k * depth);
        let mirror = ((1.0 - coverage) + phase * coverage).norm_sqr();
        assert!((ours.base - mirror).abs() < 1e-14, "{ours:?} {mirror}");
        assert!(
            (ours.base + ours.scratches * albedo - 1.0).abs() < 5e-3 * albedo,
            "{ours:?} {albedo}"
        );
        assert!(ours.scattered < albedo);
    }
}

#[test]
fn the_cone_of_section_5_overflows_and_ours_is_finite_and_normalised() {
    for concentration in [1.0, 30.0, 600.0] {
        let (theta_in, theta_out) = (1.0_f64, PI - 1.05);
        let printed = as_printed::scratch_cone_wvjh17(concentration, theta_in, theta_out);
        assert!(printed.is_finite() && printed > 0.0, "{concentration}: {printed}");
    }
    for concentration in [720.0, 1e4, 1e6] {
        let printed = as_printed::scratch_cone_wvjh17(concentration, 1.5, PI - 1.5);
        assert!(!printed.is_finite(), "{concentration}: {printed}");
        let incident = [1.5_f64.cos(), 0.0, 1.5_f64.sin()];
        let peak = [-incident[0], 0.0, incident[2]];
        let density = sampling::scratch_cone_pdf(concentration, incident, peak);
        assert!(density.is_finite() && density > 0.0, "{concentration}: {density}");
        // 2 pi times the integral over the cosine, by the variable in which the lobe is an exponential.
        let lobe = |u: f64| {
            let depth = u / concentration;
            sampling::von_mises_fisher_pdf(concentration, 1.0 - depth) * TAU / concentration
        };
        let whole = simpson(lobe, [0.0, 60.0], 20_000);
        assert!((whole - 1.0).abs() < 1e-9, "{concentration}: {whole}");
    }
}
