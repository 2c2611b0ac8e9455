//! The blend of a base material with scratches: its energies against the lobes' integrals, against the transform of a
//! transfer function, at full coverage, and for several depths.

use iridescence::Complex;
use iridescence::diffraction::{
    AreaKernel, Coherence, EnergyBlend, Footprint, Profile, area_density, area_density_footprint, coherence_window,
    depth_term, depth_term_squared, energy_blend, energy_blend_depths, footprint_mean, reflectance_incoherent,
    scratch_squared,
};
use proptest::prelude::*;
use reference::generate::random::Random;
use reference::simpson::simpson;
use std::f64::consts::PI;

const LIGHT: Coherence = Coherence {
    radius: 25.0,
    wavelength: 0.55,
};

fn is_nowhere(blend: EnergyBlend) -> bool {
    [blend.base, blend.scattered, blend.scratches]
        .iter()
        .all(|x| x.is_nan())
}

#[test]
fn a_density_or_a_depth_outside_its_range_gives_nan() {
    for (density, squared) in [
        (-0.1, 1.0),
        (1.1, 1.0),
        (0.5, -0.1),
        (0.5, 4.1),
        (f64::NAN, 1.0),
        (0.5, f64::NAN),
    ] {
        assert!(is_nowhere(energy_blend(density, squared)), "{density} {squared}");
    }
}

/// The integral over the scratch's lobe, all direction cosines at one phase of the depth, of the incoherent reflectance.
fn lobe_energy(light: Coherence, profile: Profile, gamma: f64, mean: f64) -> f64 {
    let reflectance =
        |xi1, xi2| reflectance_incoherent(light, scratch_squared(light, profile, [xi1, xi2, gamma], mean));
    // Along: a Gaussian that vanishes at both ends, by the trapezoid rule, which is exact for it.
    let step = 0.2 * light.wavelength / (2.0 * PI * light.radius);
    let along: f64 = (-40..=40).map(|i| reflectance(f64::from(i) * step, 0.0)).sum::<f64>() * step;
    // Across: the lobe and 400 side lobes to either side; beyond q = pi W xi/lambda half of 1/q^2 is left, up to 1/q^3.
    let reach = 400.0 * light.wavelength / profile.width;
    let lobes = simpson(|xi2| reflectance(0.0, xi2), [-reach, reach], 40_000);
    let peak = reflectance(0.0, 0.0);
    let rest = peak * light.wavelength / (PI * profile.width) / (400.0 * PI);
    along * (lobes + rest) / peak
}

#[test]
fn base_and_scratches_at_a_point_reflect_all_the_energy_together() {
    let mut random = Random::new(906);
    for _ in 0..12 {
        let light = Coherence {
            radius: random.uniform(10.0, 60.0),
            ..LIGHT
        };
        let gamma = random.uniform(0.5, 2.0);
        let depth = random.uniform(0.02, 0.5);
        let (mut density, mut scratches) = (0.0, 0.0);
        for _ in 0..random.integer(1, 6) {
            let width = random.uniform(0.5, 3.0);
            let offset = random.uniform(-2.0, 2.0) * light.radius;
            density += area_density(AreaKernel::Energy, width, offset, light.radius);
            let mean = coherence_window(offset, light.radius).powi(2);
            scratches += lobe_energy(light, Profile { width, depth }, gamma, mean);
        }
        let blend = energy_blend(density, depth_term_squared(depth, gamma, 0.55));
        // f_B itself integrates to 1: the_bare_surface_reflects_all_the_energy.
        let whole = blend.base + blend.scratches * scratches;
        assert!((whole - 1.0).abs() < 1e-9, "{density} {depth}: {whole}");
        assert!(
            (blend.scratches * scratches - blend.scattered).abs() < 1e-9,
            "{density} {depth}"
        );
    }
}

#[test]
fn base_and_scratches_of_many_depths_under_a_footprint_reflect_all_the_energy_together() {
    let mut random = Random::new(907);
    for _ in 0..8 {
        let footprint = Footprint {
            axes: [random.uniform(5.0, 80.0), random.uniform(5.0, 80.0)],
            cos_phi: random.uniform(-1.0, 1.0),
        };
        let gamma = random.uniform(0.5, 2.0);
        let (mut shares, mut scratches) = (Vec::new(), 0.0);
        for _ in 0..random.integer(1, 6) {
            let profile = Profile {
                width: random.uniform(0.5, 3.0),
                depth: random.uniform(0.02, 0.5),
            };
            let offset = random.uniform(-1.5, 1.5) * 25.0;
            let share = area_density_footprint(AreaKernel::Energy, profile.width, footprint, offset, 25.0);
            shares.push((share, depth_term(profile.depth, gamma, 0.55)));
            scratches += lobe_energy(LIGHT, profile, gamma, footprint_mean(footprint, offset, 25.0));
        }
        let blend = energy_blend_depths(shares.iter().copied());
        let whole = blend.base + blend.scratches * scratches;
        assert!((whole - 1.0).abs() < 1e-9, "{shares:?}: {whole}");
    }
}

#[test]
fn tiles_that_sum_to_more_than_one_by_rounding_cover_the_surface() {
    let mut above = 0;
    for width in [0.3, 1.0, 2.0, 3.0, 7.0] {
        for shift in 0..40 {
            let tiles = (-800..=800).map(|j| (f64::from(j) + 0.025 * f64::from(shift)) * width);
            let sum: f64 = tiles
                .clone()
                .map(|b| area_density(AreaKernel::Energy, width, b, 25.0))
                .sum();
            above += usize::from(sum > 1.0);
            let blend = energy_blend(sum, 4.0);
            assert!(
                (blend.base - 1.0).abs() < 1e-12 && blend.scratches < 1e-12,
                "{width} {shift}: {sum:e}"
            );
            assert!(
                blend.scattered >= 0.0 && blend.scratches >= 0.0,
                "{width} {shift}: {sum:e}"
            );
            let depth = Complex::new(2.0, 0.0);
            let several = energy_blend_depths(tiles.map(|b| (area_density(AreaKernel::Energy, width, b, 25.0), depth)));
            assert!(
                (several.base - 1.0).abs() < 1e-12 && several.scratches < 1e-12,
                "{width} {shift}"
            );
            assert!(several.scattered >= 0.0 && several.scratches >= 0.0, "{width} {shift}");
        }
    }
    println!("{above} of 200 sums above 1");
    assert!(above > 20, "{above}");
    let [last, next] = [64.0, 65.0].map(|eps| energy_blend(1.0 + eps * f64::EPSILON, 4.0));
    assert_eq!((last.base, last.scattered, last.scratches), (1.0, 0.0, 0.0));
    assert!(is_nowhere(next));
}

#[test]
fn scratches_of_one_depth_blend_alike_one_by_one_and_by_their_sum() {
    let mut random = Random::new(908);
    for _ in 0..4_000 {
        let depth = depth_term(random.uniform(0.0, 2.0), random.uniform(0.0, 2.0), 0.55);
        let shares: [f64; 4] = std::array::from_fn(|_| random.uniform(0.0, 0.25));
        let [one, several] = [
            energy_blend(shares.iter().sum(), depth.norm_sqr()),
            energy_blend_depths(shares.map(|share| (share, depth))),
        ];
        assert!((one.base - several.base).abs() < 4e-15, "{one:?} {several:?}");
        assert!((one.scattered - several.scattered).abs() < 4e-15, "{one:?} {several:?}");
        assert!((one.scratches - several.scratches).abs() < 4e-15, "{one:?} {several:?}");
    }
    let nothing = energy_blend_depths([]);
    assert_eq!((nothing.base, nothing.scattered, nothing.scratches), (1.0, 0.0, 1.0));
    let level = energy_blend_depths([(0.25, Complex::new(0.0, 0.0))]);
    assert_eq!((level.base, level.scattered, level.scratches), (1.0, 0.0, 0.75));
    let two = Complex::new(2.0, 0.0);
    for shares in [
        [(-0.1, two), (0.2, two)],
        [(0.6, two), (0.5, two)],
        [(f64::NAN, two), (0.2, two)],
    ] {
        assert!(is_nowhere(energy_blend_depths(shares)), "{shares:?}");
    }
    assert!(is_nowhere(energy_blend_depths([(0.1, Complex::new(0.0, f64::NAN))])));
}

/// The energy of what the scratches change, 1 - exp(ip) on their cells and nothing elsewhere: a sum over the cells.
fn lone_energy(low: &[bool], phase: Complex<f64>) -> f64 {
    let change = (Complex::new(1.0, 0.0) - phase).norm_sqr();
    low.iter().map(|low| if *low { change } else { 0.0 }).sum::<f64>() / low.len() as f64
}

#[test]
fn the_blend_has_the_energies_of_a_transfer_function_of_unit_modulus() {
    // Scratches along a line: cells of the surface, or lowered by one depth. Parseval splits the energy of the discrete
    // transform into that of the mean, which is the mirror's, and the rest, by a direct sum over all frequencies.
    const CELLS: usize = 240;
    let mut random = Random::new(905);
    for _ in 0..30 {
        let (depth, gamma, wavelength) = (
            random.uniform(0.01, 1.0),
            random.uniform(0.2, 2.0),
            random.uniform(0.4, 0.7),
        );
        let mut low = [false; CELLS];
        for _ in 0..random.integer(0, 20) {
            let (start, width) = (
                random.integer(0, CELLS as i64 - 1) as usize,
                random.integer(1, 20) as usize,
            );
            (start..(start + width).min(CELLS)).for_each(|cell| low[cell] = true);
        }
        let phase = Complex::from_polar(1.0, 2.0 * PI * gamma * depth / wavelength);
        let transfer = low.map(|low| if low { phase } else { Complex::new(1.0, 0.0) });
        let energy = |frequency: usize| {
            let wave =
                |cell: usize| Complex::from_polar(1.0, -2.0 * PI * ((frequency * cell) % CELLS) as f64 / CELLS as f64);
            let sum: Complex<f64> = (0..CELLS).map(|cell| transfer[cell] * wave(cell)).sum();
            (sum / CELLS as f64).norm_sqr()
        };
        let [mirror, alone] = [energy(0), lone_energy(&low, phase)];
        let rest: f64 = (1..CELLS).map(energy).sum();
        let density = low.iter().filter(|low| **low).count() as f64 / CELLS as f64;
        let blend = energy_blend(density, depth_term_squared(depth, gamma, wavelength));
        assert!(
            (blend.base - mirror).abs() < 1e-12,
            "{density} {depth}: {} {mirror}",
            blend.base
        );
        assert!(
            (blend.scattered - rest).abs() < 1e-12,
            "{density} {depth}: {} {rest}",
            blend.scattered
        );
        assert!(
            (blend.scratches * alone - rest).abs() < 1e-12,
            "{density} {depth}: {alone} {rest}"
        );
    }
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, cases: 4000, ..ProptestConfig::default() })]

    #[test]
    fn the_factors_of_the_blend_are_those_of_the_mean_and_shares(density in 0.0..=1.0f64, squared in 0.0..=4.0f64) {
        let blend = energy_blend(density, squared);
        // The phase with this squared depth term, and |1 - rho (1 - exp(ip))|^2.
        let phase = 2.0 * (0.5 * squared.sqrt()).min(1.0).asin();
        let mean = Complex::new(1.0 - density, 0.0) + Complex::from_polar(density, phase);
        prop_assert!((blend.base - mean.norm_sqr()).abs() <= 8.0 * f64::EPSILON);
        prop_assert!((blend.scattered - blend.scratches * density * squared).abs() <= 4.0 * f64::EPSILON);
        prop_assert!((0.0..=1.0).contains(&blend.base) && (0.0..=1.0).contains(&blend.scattered));
        prop_assert!((0.0..=1.0).contains(&blend.scratches));
        prop_assert!((energy_blend(1.0 - density, squared).base - blend.base).abs() <= 4.0 * f64::EPSILON);
    }
}
