//! VWH18 sections 3.1 to 3.3: each formula exactly as printed against the integral it stands for, and ours beside it.

use iridescence::diffraction::*;
use num_complex::Complex;
use reference::as_printed::{self, Crossed};
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

/// The mean of exp(-s_b^2/sigma^2) over the ellipse, point by point on rings of its own coordinates: no chord, no H.
fn mean_over_ellipse(x: &Crossed) -> f64 {
    mean_over_rings(x, 2000, 256)
}

fn mean_over_rings(x: &Crossed, rings: i32, spokes: i32) -> f64 {
    let sin_phi = (1.0 - x.cos_phi.powi(2)).sqrt();
    let ring = |radius: f64| {
        let point = |j: i32| {
            let (sine, cosine) = (TAU * (f64::from(j) + 0.5) / f64::from(spokes)).sin_cos();
            let across = x.axes[0] * radius * cosine * sin_phi + x.axes[1] * radius * sine * x.cos_phi - x.offset;
            (-(across / x.sigma).powi(2)).exp()
        };
        2.0 * radius * (0..spokes).map(point).sum::<f64>() / f64::from(spokes)
    };
    simpson(ring, [0.0, 1.0], rings)
}

/// A footprint whose area is a multiple of the coherence area, the first axis `aspect` times the second.
fn crossed(ratio: f64, aspect: f64, cos_phi: f64, offset: f64, sigma: f64) -> Crossed {
    let second = sigma * (ratio / aspect).sqrt();
    Crossed {
        axes: [aspect * second, second],
        cos_phi,
        offset,
        sigma,
    }
}

fn footprint(x: &Crossed) -> Footprint {
    Footprint {
        axes: x.axes,
        cos_phi: x.cos_phi,
    }
}

#[test]
fn equations_3_5_and_8_to_11_are_right_as_printed() {
    let mut random = Random::new(8);
    let mut worst = [0.0_f64; 6];
    for _ in 0..4000 {
        let sigma = random.log_uniform(5.0, 80.0);
        let wavelength = random.uniform(0.38, 0.78);
        let k = TAU / wavelength;
        let offset = random.uniform(-2.0, 2.0) * sigma;
        let xi = [random.uniform(-2.0, 2.0) / (sigma * k), random.uniform(-0.05, 0.05)];
        let (depth, width) = (random.uniform(0.0, 0.5), random.uniform(0.2, 4.0));
        let scene = Coherence {
            radius: sigma,
            wavelength,
        };
        let peak = TAU.sqrt() * sigma;
        let printed = as_printed::spatial_phase_infinite_vwh18_8(sigma, wavelength, offset, xi);
        let squared = as_printed::spatial_phase_squared_vwh18_9(sigma, wavelength, offset, xi[0]);
        let [angular, spatial] = as_printed::spatial_phase_parts_vwh18_10(sigma, wavelength, offset, xi[0]);
        let depth_printed = as_printed::depth_squared_vwh18_11(depth, wavelength);
        let errors = [
            (printed - spatial_phase_infinite(scene, offset, xi)).norm() / peak,
            (squared - printed.norm_sqr()).abs() / peak.powi(2),
            (squared - angular * spatial).abs() / peak.powi(2),
            (squared - spatial_phase_infinite_squared(scene, offset, xi[0])).abs() / peak.powi(2),
            (depth_printed - as_printed::depth_term_vwh18_4(depth, wavelength).norm_sqr()).abs() / 4.0,
            (as_printed::width_term_vwh18_3(width, xi[1], wavelength) - width_term(width, xi[1], wavelength)).abs()
                / width,
        ];
        for (worst, error) in worst.iter_mut().zip(errors) {
            *worst = worst.max(error);
        }
    }
    println!("{worst:?}");
    assert!(worst.iter().all(|error| *error <= 4e-15), "{worst:?}");
    // And they are the integral they stand for, which no closed form enters.
    for (sigma, offset, xi) in [
        (10.0, 3.0, [0.01, 0.2]),
        (60.0, -20.0, [0.001, -0.05]),
        (10.0, 0.0, [0.0, 0.0]),
    ] {
        let k = TAU / WAVELENGTH;
        let value = |t: f64| {
            let weight = (-(t * t + offset * offset) / (2.0 * sigma * sigma)).exp();
            Complex::from_polar(weight, -k * (xi[0] * t + xi[1] * offset))
        };
        let truth = simpson(value, [-12.0 * sigma, 12.0 * sigma], 4000);
        let printed = as_printed::spatial_phase_infinite_vwh18_8(sigma, WAVELENGTH, offset, xi);
        assert!((printed - truth).norm() <= 1e-13 * sigma, "{printed} {truth}");
    }
}

#[test]
fn equation_16_lacks_a_factor_pi_in_its_second_term() {
    for (sigma, offset) in [(10.0, 0.0), (60.0, 25.0)] {
        let x = crossed(1e-16, 1.5, 0.3, offset, sigma);
        let truth = TAU * sigma * sigma * mean_over_ellipse(&x);
        let printed = as_printed::footprint_blend_vwh18_16(&x);
        let mended = as_printed::footprint_blend_with_factor(&x, PI);
        let ours = TAU * sigma * sigma * footprint_mean(footprint(&x), offset, sigma);
        assert!((truth / printed - PI).abs() < 1e-6, "{truth} {printed}");
        assert!((mended / truth - 1.0).abs() < 1e-6, "{mended} {truth}");
        assert!((ours / truth - 1.0).abs() < 1e-11, "{ours} {truth}");
    }
}

/// The blend over the truth, both summed over all offsets of a footprint: what a dense set of parallel scratches shows.
fn dense(ratio: f64, method: impl Fn(&Crossed) -> f64) -> f64 {
    let sigma = 10.0;
    let wide = crossed(ratio, 1.0, 1.0, 0.0, sigma);
    let reach = 8.0 * sigma + wide.axes[1];
    let sum = simpson(|offset| method(&Crossed { offset, ..wide }), [-reach, reach], 20_000);
    sum / (TAU * sigma * sigma * sigma * PI.sqrt())
}

#[test]
fn equation_16_darkens_a_dense_set_by_65_percent_below_the_coherence_area_and_the_factor_restores_it() {
    for (ratio, expected) in [(0.1, -0.65), (1.0, -0.34), (2.0, 0.0), (7.0, 0.0)] {
        let printed = dense(ratio, as_printed::footprint_blend_vwh18_16) - 1.0;
        let mended = dense(ratio, |x| as_printed::footprint_blend_with_factor(x, PI)) - 1.0;
        let ours = |x: &Crossed| TAU * x.sigma.powi(2) * footprint_mean(footprint(x), x.offset, x.sigma);
        println!("A_P/A_C = {ratio}: {printed:.4} {mended:.2e}");
        assert!((printed - expected).abs() < 0.006, "{ratio}: {printed}");
        assert!(mended.abs() < 1e-4, "{ratio}: {mended}");
        assert!((dense(ratio, ours) - 1.0).abs() < 1e-9);
    }
}

#[test]
fn equation_16_blends_by_the_area_where_the_extent_across_the_scratch_decides() {
    // A footprint fifty times as long along the scratch as across it.
    for (ratio, low, high) in [(2.0, 4.6, 4.8), (7.0, 2.0, 2.2)] {
        let x = crossed(ratio, 50.0, 1.0, 0.0, 10.0);
        let truth = mean_over_ellipse(&x);
        let mended = as_printed::footprint_blend_with_factor(&x, PI) / (TAU * x.sigma.powi(2));
        let error = mended / truth - 1.0;
        println!("A_P/A_C = {ratio}, along: {:+.1} %", 100.0 * error);
        assert!((low..high).contains(&error), "{ratio}: {error}");
        let ours = footprint_mean(footprint(&x), x.offset, x.sigma);
        assert!((ours / truth - 1.0).abs() < 1e-11, "{ours} {truth}");
    }
    // Round footprints, over all offsets: never within a tenth.
    for (ratio, at_least) in [(1.0, 0.3), (2.0, 0.4), (7.0, 0.25), (100.0, 0.12)] {
        let error = |offset: f64| {
            let x = crossed(ratio, 1.0, 1.0, offset, 10.0);
            let mended = as_printed::footprint_blend_with_factor(&x, PI) / (TAU * x.sigma.powi(2));
            (mended - mean_over_rings(&x, 200, 96)).abs()
        };
        let largest = mean_over_ellipse(&crossed(ratio, 1.0, 1.0, 0.0, 10.0));
        let reach = 10.0 * ratio.sqrt();
        let worst = (0..=60)
            .map(|j| error(reach * f64::from(j) / 40.0) / largest)
            .fold(0.0, f64::max);
        println!("A_P/A_C = {ratio}, round: {worst:.3}");
        assert!(worst > at_least && worst < at_least + 0.1, "{ratio}: {worst}");
    }
}

#[test]
fn equation_15_gives_the_mean_where_its_middle_member_gives_the_integral() {
    let x = crossed(400.0, 2.0, 0.6, 30.0, 10.0);
    let integral = TAU * x.sigma.powi(2) * mean_over_ellipse(&x) * x.area();
    let printed = as_printed::footprint_wide_vwh18_15(&x);
    assert!(
        (integral / printed / x.area() - 1.0).abs() < 0.01,
        "{integral} {printed}"
    );
    let ours = TAU * x.sigma.powi(2) * footprint_mean(footprint(&x), x.offset, x.sigma);
    assert!((ours * x.area() / integral - 1.0).abs() < 1e-10);
}

#[test]
fn equations_17_and_18_give_2_for_a_surface_tiled_with_scratches_and_ours_1() {
    for (sigma, width) in [(10.0, 1.0), (60.0, 3.0)] {
        let reach = (12.0 * sigma / width) as i32;
        let offsets = || (-reach..=reach).map(|j| (f64::from(j) + 0.3) * width);
        let printed = as_printed::area_density_vwh18_17(width, sigma, offsets());
        assert!((printed - 2.0).abs() < 1e-12, "{printed}");
        for kernel in [AreaKernel::Amplitude, AreaKernel::Energy] {
            let ours: f64 = offsets().map(|s_b| area_density(kernel, width, s_b, sigma)).sum();
            assert!((ours - 1.0).abs() < 1e-12, "{kernel:?} {ours}");
        }
        let narrow = 0.02 * sigma;
        let wide = |offset| crossed(40.0, 1.3, 0.8, offset, sigma);
        let count = (20.0 * sigma / narrow) as i32;
        let footprints = (-count..=count).map(|j| wide(f64::from(j) * narrow));
        let printed = as_printed::area_density_vwh18_18(narrow, footprints);
        assert!((printed - 2.0).abs() < 2e-3, "{printed}");
        let ours: f64 = (-count..=count)
            .map(|j| f64::from(j) * narrow)
            .map(|s_b| area_density_footprint(AreaKernel::Energy, narrow, footprint(&wide(0.0)), s_b, sigma))
            .sum();
        assert!((ours - 1.0).abs() < 1e-9, "{ours}");
    }
    // Every other strip: the base's factor 1 - rho is gone at half coverage.
    let half = as_printed::area_density_vwh18_17(1.0, 10.0, (-200..=200).map(|j| f64::from(2 * j)));
    assert!((1.0 - half).abs() < 1e-12, "{half}");
}

#[test]
fn equation_6_gains_or_loses_energy_and_ours_keeps_it() {
    // A line of pixels: the window's energy, the share below scratches, and the energy the scratches' field holds.
    let mut random = Random::new(6);
    let mut printed = Vec::new();
    for (density, depth_squared) in [(0.1, 4.0), (0.1, 0.38), (0.5, 2.0)] {
        let phase = f64::acos(1.0 - 0.5 * depth_squared);
        let depth = 1.0 - Complex::from_polar(1.0, phase);
        let mask: Vec<bool> = (0..400_000).map(|_| random.chance(density)).collect();
        let [mut window, mut below, mut base, mut scratches] = [0.0; 4];
        let mut sum = Complex::new(0.0, 0.0);
        for (i, covered) in mask.iter().enumerate() {
            let energy = (-((i as f64 - 2e5) / 5e4).powi(2)).exp();
            window += energy;
            below += if *covered { energy } else { 0.0 };
            scratches += if *covered { energy * depth.norm_sqr() } else { 0.0 };
            let transfer = if *covered { 1.0 - depth } else { Complex::new(1.0, 0.0) };
            base += energy * transfer.norm_sqr();
            sum += energy * transfer;
        }
        let rho = below / window;
        assert!(
            (base / window - 1.0).abs() < 1e-12,
            "a unit-modulus transfer keeps the energy"
        );
        let total = as_printed::blended_vwh18_6(rho, 1.0, scratches / window);
        let ours = energy_blend(rho, depth.norm_sqr());
        // The mirror's lobe keeps the mean transfer function, |sum e T|^2/(sum e)^2; the rest is scattered.
        let mirror = sum.norm_sqr() / (window * window);
        assert!((ours.base - mirror).abs() < 1e-11, "{ours:?} {mirror}");
        assert!(
            (ours.scattered - (base / window - mirror)).abs() < 1e-11,
            "{ours:?} {mirror}"
        );
        // And the printed sum of scratches needs a factor of its own.
        let blended = ours.base + ours.scratches * scratches / window;
        assert!((blended - 1.0).abs() < 1e-11, "{ours:?} {blended}");
        printed.push(total);
    }
    println!("totals of Eq. 6: {printed:?}");
    assert!((printed[0] - 1.30).abs() < 0.01, "{printed:?}");
    assert!((printed[1] - 0.94).abs() < 0.01, "{printed:?}");
    assert!((printed[2] - 1.50).abs() < 0.01, "{printed:?}");
}

#[test]
fn equation_6_prints_a_complex_energy_where_twice_the_real_part_is_meant() {
    let scene = coherence(10.0);
    let (offset, xi) = (5.0, [0.001, 0.01]);
    let base = base_response(scene, xi);
    let scratches = profile_rectangle(Profile { width: 3.0, depth: 0.1 }, [xi[0], xi[1], 2.0], WAVELENGTH)
        * spatial_phase_infinite(scene, offset, xi);
    let truth = (Complex::new(base, 0.0) - scratches).norm_sqr();
    let printed = as_printed::squared_difference_vwh18_6(Complex::new(base, 0.0), scratches);
    println!("{printed} {truth}");
    assert!(printed.im.abs() > 0.1 * truth, "{printed} {truth}");
    let ours = base * base + scratches.norm_sqr() + base_interference(base, scratches);
    assert!((ours - truth).abs() <= 1e-14 * base * base, "{ours} {truth}");
}

/// L1 distance of the near-normal lobe from the exact one across the scratch, as a share of the energy of the brightest
/// lobe, |D|^2 = 4; the light lies across the scratch too.
fn near_normal_distance(width: f64, depth: f64, incidence: f64) -> f64 {
    let (sine, cosine) = incidence.to_radians().sin_cos();
    let term = |out: f64| width_term(width, sine + out, WAVELENGTH).powi(2);
    let distance = |out: f64| {
        let gamma = cosine + (1.0 - out * out).max(0.0).sqrt();
        let exact = depth_term_squared(depth, gamma, WAVELENGTH);
        term(out) * (as_printed::depth_squared_vwh18_11(depth, WAVELENGTH) - exact).abs()
    };
    simpson(distance, [-1.0, 1.0], 4000) / simpson(|out| 4.0 * term(out), [-1.0, 1.0], 4000)
}

#[test]
fn equation_4_holds_near_the_normal_alone() {
    // The largest and the smallest distance over widths from 1 to 5 um and depths from 0.05 to 0.5 um.
    for (incidence, smallest, largest) in [
        (0.0, 0.0, [0.06, 0.08]),
        (30.0, 0.01, [0.6, 0.7]),
        (60.0, 0.16, [0.8, 0.95]),
    ] {
        let mut span = [f64::INFINITY, 0.0_f64];
        for width in [1.0, 2.0, 5.0] {
            for step in 1..=10 {
                let distance = near_normal_distance(width, 0.05 * f64::from(step), incidence);
                span = [span[0].min(distance), span[1].max(distance)];
            }
        }
        println!("{incidence} degrees: {span:?}");
        assert!(
            span[0] >= smallest && (largest[0]..largest[1]).contains(&span[1]),
            "{incidence}: {span:?}"
        );
    }
    // The exact lobe's phase is the length of the path into the groove and out of it.
    let (depth, incidence, out) = (0.3_f64, 0.5_f64, 0.2_f64);
    let path = depth * (incidence.cos() + out.cos());
    let truth = Complex::new(1.0, 0.0) - Complex::from_polar(1.0, TAU * path / WAVELENGTH);
    let ours = depth_term(depth, incidence.cos() + out.cos(), WAVELENGTH);
    assert!((ours - truth).norm() < 1e-14, "{ours} {truth}");
}

#[test]
fn equation_26_means_nanometres() {
    let found = as_printed::largest_deviation_vwh18_26(0.750, 60.0);
    assert!((found - 1.40674e-3).abs() < 5e-9, "{found}");
    let typed = as_printed::largest_deviation_vwh18_26(750.0, 60.0);
    assert!(typed > 1.4, "750 um would give {typed}: wider than the hemisphere");
    // It is the deviation of |eta|^2 along the scratch: there the lobe is exp(-1/2) of its peak.
    let scene = Coherence {
        radius: 60.0,
        wavelength: 0.750,
    };
    let ratio = spatial_phase_infinite_squared(scene, 0.0, found) / spatial_phase_infinite_squared(scene, 0.0, 0.0);
    assert!((ratio - (-0.5_f64).exp()).abs() < 1e-14, "{ratio}");
}

/// The degree of coherence of two points under a uniform disc: the mean of cos over the disc, by quadrature.
fn disc_coherence(diameter: f64, separation: f64) -> f64 {
    let reach = (0.5 * diameter).sin();
    let slab = |u: f64| 2.0 * (1.0 - u * u).max(0.0).sqrt() / PI * (TAU / WAVELENGTH * separation * reach * u).cos();
    simpson(
        |angle: f64| slab(angle.sin()) * angle.cos(),
        [-0.5 * PI, 0.5 * PI],
        2000,
    )
}

#[test]
fn the_two_papers_radii_of_60_micrometres_differ_by_36_in_area_and_the_sun_gives_neither() {
    // VWH18 Eq. 26 needs 60 um as the deviation itself; WVJH17 Eq. 6 says 6 sigma = 60 um.
    let [wide, narrow] = [60.0, 60.0 / 6.0];
    assert!((coherence_area(wide) / coherence_area(narrow) - 36.0).abs() < 1e-12);
    let sun = 0.53_f64.to_radians();
    let ours = coherence_radius(sun, WAVELENGTH);
    assert!((20.0..30.0).contains(&ours), "{ours}");
    // At the separation where the sun's degree of coherence is one half, so is that of our window.
    let mut bounds = [0.0, 3.0 * ours];
    for _ in 0..60 {
        let middle = 0.5 * (bounds[0] + bounds[1]);
        bounds[usize::from(disc_coherence(sun, middle) < 0.5)] = middle;
    }
    let degree = coherence_degree(bounds[0], ours);
    assert!((degree - 0.5).abs() < 1e-6, "{degree}");
    for published in [wide, narrow] {
        let degree = coherence_degree(bounds[0], published);
        assert!((degree - 0.5).abs() > 0.2, "{published}: {degree}");
    }
}

#[test]
fn figure_11_prints_a_radius_of_10_nanometres_under_which_no_lobe_is_left() {
    let fall = |radius: f64| {
        let scene = coherence(radius);
        spatial_phase_infinite_squared(scene, 0.0, 1.0) / spatial_phase_infinite_squared(scene, 0.0, 0.0)
    };
    // Along the scratch, from its mirror direction to the horizon.
    assert!(fall(0.010) > 0.98, "{}", fall(0.010));
    assert!(fall(10.0) < 1e-300, "{}", fall(10.0));
}
