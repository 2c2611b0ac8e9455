//! The transforms of the raster, joined to the response of the surface in a direction.

use super::raster::levels;
use super::{Grid, Surface};
use num_complex::Complex;
use rustfft::{Fft, FftPlanner};
use std::f64::consts::PI;
use std::sync::Arc;

/// The two-dimensional transform of a square field, in place; the result stands transposed.
pub fn transform(field: &mut [Complex<f64>], size: usize) {
    let plan: Arc<dyn Fft<f64>> = FftPlanner::new().plan_fft_forward(size);
    for pass in 0..2 {
        plan.process(field);
        if pass == 0 {
            transpose(field, size);
        }
    }
}

fn transpose(field: &mut [Complex<f64>], size: usize) {
    for row in 0..size {
        for column in row + 1..size {
            field.swap(row * size + column, column * size + row);
        }
    }
}

/// The transforms of the parts of a surface, in um^2, at the frequencies of a grid.
pub struct Spectrum {
    /// The grid of the raster.
    pub grid: Grid,
    /// Transposed; part n at index n.
    parts: Vec<Vec<Complex<f64>>>,
}

impl Spectrum {
    /// The spectrum of a surface on a grid.
    pub fn new(surface: &Surface, grid: Grid) -> Spectrum {
        let fields = levels(surface, grid);
        let mut parts = Vec::new();
        for pair in fields.chunks(2) {
            // Two real fields in one transform: the even part under conjugation is the first, the odd part the second.
            let second = |i: usize| pair.get(1).map_or(0.0, |field| field[i]);
            let mut packed: Vec<_> = (0..pair[0].len())
                .map(|i| Complex::new(pair[0][i], second(i)))
                .collect();
            transform(&mut packed, grid.size);
            let mirrored = |i: usize| {
                let (row, column) = (i / grid.size, i % grid.size);
                packed[(grid.size - row) % grid.size * grid.size + (grid.size - column) % grid.size].conj()
            };
            let area = grid.step.powi(2);
            parts.push(
                (0..packed.len())
                    .map(|i| (packed[i] + mirrored(i)) * (0.5 * area))
                    .collect(),
            );
            if pair.len() == 2 {
                let odd = |i: usize| (packed[i] - mirrored(i)) * Complex::new(0.0, -0.5 * area);
                parts.push((0..packed.len()).map(odd).collect());
            }
        }
        Spectrum { grid, parts }
    }

    /// The transforms of the parts at a frequency's indices, without the pixel's blur and relative to the origin.
    pub fn at(&self, column: usize, row: usize) -> Vec<Complex<f64>> {
        let [f, g] = [column, row].map(|i| self.grid.frequency(i));
        let blur = (2.0 * PI.powi(2) * self.grid.step.powi(2) * (f * f + g * g)).exp();
        // The first point of the grid lies at place(0).
        let phase = Complex::from_polar(blur, -2.0 * PI * (f + g) * self.grid.place(0));
        self.parts
            .iter()
            .map(|part| part[column * self.grid.size + row] * phase)
            .collect()
    }
}

/// The response of a surface whose parts have these transforms, the transfer function being `weight(n)` below n
/// scratches.
pub fn weighted(parts: &[Complex<f64>], weight: impl Fn(usize) -> Complex<f64>) -> Complex<f64> {
    parts.iter().enumerate().map(|(n, part)| part * weight(n)).sum()
}

/// The response of a surface whose heights add up where scratches cross: exp(i n phi) below n of them.
pub fn joined(parts: &[Complex<f64>], phase: f64) -> Complex<f64> {
    weighted(parts, |n| Complex::from_polar(1.0, n as f64 * phase))
}

/// |F|^2/(A_C lambda^2): the radiance under unit irradiance, WVJH17 Eq. 7 without its cosine of incidence.
pub fn radiance(surface: &Surface, response: Complex<f64>) -> f64 {
    response.norm_sqr() / (PI * surface.radius.powi(2) * surface.wavelength.powi(2))
}

/// gamma_i + gamma_o at normal incidence for a direction xi.
pub fn gamma_sum([xi1, xi2]: [f64; 2]) -> f64 {
    1.0 + (1.0 - xi1 * xi1 - xi2 * xi2).max(0.0).sqrt()
}

/// The phase of the depth in a direction.
pub fn depth_phase(surface: &Surface, xi: [f64; 2]) -> f64 {
    2.0 * PI * gamma_sum(xi) * surface.depth / surface.wavelength
}

/// The parts of a surface projected onto an axis (0: the first), transformed finely: frequencies and, for each, the parts'
/// transforms. By the projection theorem this is the slice of the plane's transform along that axis.
pub fn slice(surface: &Surface, grid: Grid, axis: usize, padding: usize) -> Vec<(f64, Vec<Complex<f64>>)> {
    let fields = levels(surface, grid);
    let long = Grid {
        size: grid.size * padding,
        step: grid.step,
    };
    let plan = FftPlanner::new().plan_fft_forward(long.size);
    let mut spectra = Vec::new();
    for field in &fields {
        let mut sums = vec![Complex::new(0.0, 0.0); long.size];
        for (i, value) in field.iter().enumerate() {
            let index = if axis == 0 { i % grid.size } else { i / grid.size };
            sums[index] += value * grid.step.powi(2);
        }
        plan.process(&mut sums);
        spectra.push(sums);
    }
    let reach = long.size / 2;
    let indices = (long.size - reach..long.size).chain(0..reach);
    let row = |index: usize| {
        let f = long.frequency(index);
        let blur = (2.0 * PI.powi(2) * grid.step.powi(2) * f * f).exp();
        let phase = Complex::from_polar(blur, -2.0 * PI * f * grid.place(0));
        (f, spectra.iter().map(|spectrum| spectrum[index] * phase).collect())
    };
    indices.map(row).collect()
}
