//! The closed forms against the transform of a rasterised surface: one scratch, crossings, ten scratches, and energy.

use iridescence::diffraction::*;
use num_complex::Complex;
use reference::fourier::figures::{GRID, plane, scratched};
use reference::fourier::raster::counts;
use reference::fourier::transform::{Spectrum, depth_phase, transform, weighted};
use reference::fourier::{Band, Grid, Surface, figure_13, figure_14};
use reference::generate::random::Random;

/// The largest value of a list.
fn peak(values: &[f64]) -> f64 {
    values.iter().copied().fold(0.0, f64::max)
}

#[test]
fn one_scratch_is_its_closed_form_with_the_window_across_it_and_nearly_the_papers_without() {
    for slice in figure_13() {
        let brightest = peak(&slice.fourier);
        let error = |form: &[f64]| {
            let errors: Vec<_> = form.iter().zip(&slice.fourier).map(|(a, b)| (a - b).abs()).collect();
            peak(&errors) / brightest
        };
        let [separable, exact] = [error(&slice.analytic), error(&slice.exact)];
        println!("{}: separable {separable:e}, exact {exact:e}", slice.label);
        assert!(slice.xi.len() > 2900 && slice.xi.is_sorted());
        assert!(exact < 3e-6, "{}: {exact}", slice.label);
        assert!((1e-4..1e-3).contains(&separable), "{}: {separable}", slice.label);
    }
    // Far from the peak the papers' form is too bright or too dark by a share that the window across the scratch removes.
    let [_, across] = figure_13();
    let far = |form: &[f64]| {
        let side = across.xi.iter().zip(form.iter().zip(&across.fourier));
        let side: Vec<_> = side.filter(|(xi, _)| xi.abs() > 0.2).map(|(_, pair)| pair).collect();
        let bright = side.iter().map(|(_, fourier)| **fourier).fold(0.0, f64::max);
        side.iter()
            .map(|(form, fourier)| (**form - **fourier).abs())
            .fold(0.0, f64::max)
            / bright
    };
    let [separable, exact] = [&across.analytic, &across.exact].map(|form| far(form));
    println!("beside the peak: separable {separable:e}, exact {exact:e}");
    assert!(separable > 2e-3, "{separable}");
    assert!(exact < 0.1 * separable, "{exact} {separable}");
}

#[test]
fn the_crossing_of_two_scratches_is_their_closed_form_unless_they_are_nearly_parallel() {
    for (degrees, without, with) in [
        (90.0, 4e-3, 1e-3),
        (45.0, 6e-3, 1e-3),
        (20.0, 0.015, 3e-3),
        (8.0, 0.01, 0.01),
    ] {
        let mut surface = scratched(1);
        let (sine, cosine) = f64::to_radians(degrees).sin_cos();
        surface.bands.push(Band {
            tangent: [cosine, sine],
            offset: 3.0,
            width: 1.5,
        });
        let plane = plane(&surface);
        let found = [&plane.analytic, &plane.crossings].map(|form| plane.largest_error(form));
        println!("{degrees} degrees: without {:e}, with {:e}", found[0], found[1]);
        assert!(found[0] > without && found[1] < with, "{degrees}: {found:?}");
    }
}

#[test]
fn ten_scratches_differ_from_the_papers_by_their_crossings_and_from_the_pairs_by_the_triples() {
    let surface = scratched(10);
    let spectrum = Spectrum::new(&surface, GRID);
    let bright = radiance_peak(&spectrum, &surface);
    // The share of the peak's amplitude by which a closed form misses a transform in which n scratches over each other
    // have this transfer function.
    let error = |closed: &dyn Fn([f64; 2]) -> Complex<f64>, weight: &dyn Fn(usize, Complex<f64>) -> Complex<f64>| {
        let mut worst = 0.0_f64;
        for row in (-180..=180_i64).step_by(9).chain(-3..=3) {
            for column in (-180..=180_i64).step_by(9).chain(-3..=3) {
                let xi = [column, row].map(|j| j as f64 * surface.wavelength / (GRID.size as f64 * GRID.step));
                if xi[0].hypot(xi[1]) > 1.0 {
                    continue;
                }
                let [i, j] = [column, row].map(|j| j.rem_euclid(GRID.size as i64) as usize);
                let depth = 1.0 - Complex::from_polar(1.0, depth_phase(&surface, xi));
                let truth = weighted(&spectrum.at(i, j), |n| weight(n, depth));
                worst = worst.max((closed(xi) - truth).norm());
            }
        }
        worst / bright
    };
    let added = |n: usize, depth: Complex<f64>| 1.0 - depth * n as f64;
    let paired = |n: usize, depth: Complex<f64>| added(n, depth) + depth * depth * (n * n.saturating_sub(1) / 2) as f64;
    let heights = |n: usize, depth: Complex<f64>| (1.0 - depth).powu(n as u32);
    let papers = |xi: [f64; 2]| surface.base(xi) - surface.scratches(xi);
    let windowed = |xi: [f64; 2]| surface.base(xi) - surface.scratches_windowed(xi);
    let crossings = |xi: [f64; 2]| papers(xi) + surface.crossings(xi);
    let found = [
        error(&windowed, &added),
        error(&papers, &added),
        error(&crossings, &paired),
        error(&papers, &heights),
        error(&crossings, &heights),
    ];
    println!("of the peak's amplitude: {found:?}");
    assert!(found[0] < 1e-5, "the window across: {found:?}");
    assert!(found[1] < 5e-3, "the papers' sum: {found:?}");
    assert!(found[2] < 2e-2, "pairs: {found:?}");
    assert!(found[3] > 0.1, "crossings neglected: {found:?}");
    assert!(found[4] < 0.5 * found[3], "crossings added: {found:?}");
}

/// The amplitude of the surface's response at xi = 0 without scratches.
fn radiance_peak(spectrum: &Spectrum, surface: &Surface) -> f64 {
    let whole = weighted(&spectrum.at(0, 0), |_| Complex::new(1.0, 0.0)).norm();
    assert!(
        (whole
            / base_response(
                Coherence {
                    radius: surface.radius,
                    wavelength: 0.55
                },
                [0.0; 2]
            )
            - 1.0)
            .abs()
            < 1e-6
    );
    whole
}

#[test]
fn figure_14_gains_more_than_ten_decibels_by_the_crossings() {
    let plane = figure_14();
    let found =
        [&plane.analytic, &plane.crossings].map(|form| [plane.signal_to_noise(form), plane.largest_error(form)]);
    println!("decibels and largest error, without and with crossings: {found:?}");
    assert!((45.0..55.0).contains(&found[0][0]), "{found:?}");
    assert!(found[1][0] > found[0][0] + 10.0, "{found:?}");
    assert!(found[0][1] > 0.3 && found[1][1] < 0.1, "{found:?}");
}

/// Random scratches, their share of the window's energy, the window and the transfer function with one phase for all.
struct Scene {
    surface: Surface,
    grid: Grid,
    window: Vec<f64>,
    counts: Vec<usize>,
}

fn scene(seed: u64, count: usize) -> Scene {
    let mut random = Random::new(seed);
    let bands = (0..count).map(|_| {
        let (sine, cosine) = random.uniform(0.0, 3.0).sin_cos();
        Band {
            tangent: [cosine, sine],
            offset: random.uniform(-20.0, 20.0),
            width: random.log_uniform(0.5, 6.0),
        }
    });
    let surface = Surface {
        bands: bands.collect(),
        depth: 0.0,
        radius: 10.0,
        wavelength: 0.55,
    };
    let grid = Grid { size: 256, step: 0.4 };
    let places: Vec<_> = (0..256).map(|i| grid.place(i)).collect();
    let weight = |x: f64| (-x * x / 200.0).exp();
    let window = (0..256 * 256)
        .map(|i| weight(places[i % 256]) * weight(places[i / 256]))
        .collect();
    Scene {
        counts: counts(&surface, grid),
        surface,
        grid,
        window,
    }
}

impl Scene {
    /// The transform of window times a function of the number of scratches.
    fn spectrum(&self, transfer: impl Fn(usize) -> Complex<f64>) -> Vec<Complex<f64>> {
        let mut field: Vec<_> = self
            .window
            .iter()
            .zip(&self.counts)
            .map(|(w, n)| transfer(*n) * w)
            .collect();
        transform(&mut field, self.grid.size);
        field
    }

    /// The share of the window's energy below at least one scratch.
    fn density(&self) -> f64 {
        let squares = |keep: &dyn Fn(usize) -> bool| {
            let kept = self.window.iter().zip(&self.counts).filter(|(_, n)| keep(**n));
            kept.map(|(w, _)| w * w).sum::<f64>()
        };
        squares(&|n| n > 0) / squares(&|_| true)
    }
}

/// The energy of a spectrum over all its frequencies, evanescent ones included.
fn energy(spectrum: &[Complex<f64>]) -> f64 {
    spectrum.iter().map(Complex::norm_sqr).sum()
}

#[test]
fn base_and_scratches_share_the_energy_as_the_blend_says() {
    let mut random = Random::new(3);
    for (seed, count) in [(1, 1), (2, 4), (3, 12), (4, 40)] {
        let scene = scene(seed, count);
        let mirror = scene.spectrum(|_| Complex::new(1.0, 0.0));
        let whole = energy(&mirror);
        let density = scene.density();
        for _ in 0..3 {
            let gamma = random.uniform(0.5, 2.0);
            let depth = depth_term(random.uniform(0.0, 0.5), gamma, scene.surface.wavelength);
            let pit = 1.0 - depth;
            // Scratches of one depth, not deeper where they cross.
            let surface = scene.spectrum(|n| if n > 0 { pit } else { Complex::new(1.0, 0.0) });
            assert!(
                (energy(&surface) / whole - 1.0).abs() < 1e-12,
                "a unit modulus keeps the energy"
            );
            // The mirror's lobe with the mean transfer function, and all that is not it.
            let mean = 1.0 - depth * density;
            let base: Vec<_> = mirror.iter().map(|value| value * mean).collect();
            let rest: Vec<_> = surface.iter().zip(&base).map(|(a, b)| a - b).collect();
            let blend = energy_blend(density, depth.norm_sqr());
            assert!((energy(&base) / whole - blend.base).abs() < 1e-12, "{seed}: {blend:?}");
            assert!(
                (energy(&rest) / whole - blend.scattered).abs() < 1e-12,
                "{seed}: {blend:?}"
            );
            // The scratches alone, before a black ground, times their factor: the same energy.
            let alone = scene.spectrum(|n| if n > 0 { depth } else { Complex::new(0.0, 0.0) });
            let shared = blend.scratches * energy(&alone) / whole;
            assert!((shared - blend.scattered).abs() < 1e-12, "{seed}: {blend:?} {shared}");
            // The papers' sum of transfer functions is no longer of unit modulus where scratches cross.
            let sum = energy(&scene.spectrum(|n| 1.0 - depth * n as f64)) / whole;
            let heights = energy(&scene.spectrum(|n| pit.powu(n as u32))) / whole;
            assert!((heights - 1.0).abs() < 1e-12, "{heights}");
            println!(
                "{count} scratches, rho = {density:.3}, |D|^2 = {:.3}: sum of transfers {sum:.4}",
                depth.norm_sqr()
            );
            assert!(count < 12 || (sum - 1.0).abs() > 1e-2, "{sum}");
        }
    }
}

#[test]
fn the_energy_of_the_scratches_alone_is_their_area_density_times_the_depth_term() {
    // Edges on grid lines, so that the raster is exact.
    let mut surface = scene(5, 0).surface;
    for offset in [-16.0, -8.0, 0.0, 8.0, 16.0] {
        surface.bands.push(Band {
            tangent: [1.0, 0.0],
            offset,
            width: 0.8,
        });
    }
    let empty = scene(5, 0);
    let scratched = Scene {
        counts: counts(&surface, empty.grid),
        ..empty
    };
    let whole = energy(&scratched.spectrum(|_| Complex::new(1.0, 0.0)));
    let depth = depth_term(0.2, 1.9, 0.55);
    let alone = energy(&scratched.spectrum(|n| depth * n as f64)) / whole;
    let share = |kernel| {
        surface
            .bands
            .iter()
            .map(|b| area_density(kernel, b.width, b.offset, 10.0))
            .sum::<f64>()
    };
    let ours = share(AreaKernel::Energy) * depth.norm_sqr();
    assert!((alone / ours - 1.0).abs() < 2e-3, "{alone} {ours}");
    // A base and these scratches' incoherent sum keep the surface's energy, up to the raster's share of the window.
    let blend = energy_blend(share(AreaKernel::Energy), depth.norm_sqr());
    assert!(
        (blend.base + blend.scratches * alone - 1.0).abs() < 2e-3 * alone,
        "{blend:?} {alone}"
    );
    let amplitude = share(AreaKernel::Amplitude) * depth.norm_sqr();
    assert!((alone / amplitude - 1.0).abs() > 1e-3, "{alone} {amplitude}");
}
