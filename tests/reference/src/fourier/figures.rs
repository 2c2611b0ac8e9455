//! The data of WVJH17 Figs. 13 and 14, remade: one scratch and ten random ones, closed forms against the transform.

use super::transform::{Spectrum, depth_phase, gamma_sum, joined, radiance, slice};
use super::{Band, Grid, Surface};
use crate::generate::random::Random;
use iridescence::diffraction::{
    Coherence, Profile, Segment, base_response, crossing_response, profile_rectangle, response_rectangle_windowed,
    spatial_phase_infinite,
};
use num_complex::Complex;

/// The coherence radius of WVJH17, 6 sigma = 60 um.
const RADIUS: f64 = 10.0;
const WAVELENGTH: f64 = 0.55;
/// The grid of the figures: the window has fallen to 2e-6 at its sides, and light up to the horizon stays below a fifth of
/// its sampling rate.
pub const GRID: Grid = Grid { size: 1024, step: 0.1 };

/// Radiance along a line of direction cosines.
#[derive(Clone, Debug)]
pub struct Slice {
    /// What is cut.
    pub label: &'static str,
    /// The direction cosine that runs.
    pub xi: Vec<f64>,
    /// Closed form of the papers: no window across the scratch.
    pub analytic: Vec<f64>,
    /// The window across the scratch as well.
    pub exact: Vec<f64>,
    /// By transform of the raster.
    pub fourier: Vec<f64>,
}

/// Radiance over the hemisphere, row by row over a square of direction cosines; zero outside the unit circle.
#[derive(Clone, Debug)]
pub struct Plane {
    /// Direction cosines of rows (second) and columns (first).
    pub xi: Vec<f64>,
    /// Closed form of the papers: no crossings, no window across a scratch.
    pub analytic: Vec<f64>,
    /// The same with the crossings.
    pub crossings: Vec<f64>,
    /// By transform of the raster.
    pub fourier: Vec<f64>,
}

impl Plane {
    /// Peak signal-to-noise ratio of a closed form against the transform, in dB, over the hemisphere.
    pub fn signal_to_noise(&self, form: &[f64]) -> f64 {
        let (mut squares, mut count) = (0.0, 0.0);
        for (i, (a, b)) in form.iter().zip(&self.fourier).enumerate() {
            let [x, y] = [self.xi[i % self.xi.len()], self.xi[i / self.xi.len()]];
            if x * x + y * y < 1.0 {
                squares += (a - b).powi(2);
                count += 1.0;
            }
        }
        let peak = self.fourier.iter().copied().fold(0.0, f64::max);
        10.0 * (peak.powi(2) * count / squares).log10()
    }

    /// The largest difference of a closed form from the transform, as a share of the transform's peak.
    pub fn largest_error(&self, form: &[f64]) -> f64 {
        let peak = self.fourier.iter().copied().fold(0.0, f64::max);
        let errors = form.iter().zip(&self.fourier).map(|(a, b)| (a - b).abs());
        errors.fold(0.0, f64::max) / peak
    }
}

impl Surface {
    fn coherence(&self) -> Coherence {
        Coherence {
            radius: self.radius,
            wavelength: self.wavelength,
        }
    }

    fn profile(&self, band: &Band) -> Profile {
        Profile {
            width: band.width,
            depth: self.depth,
        }
    }

    /// S in a direction, by the closed form: profile times spatial phase.
    pub fn scratches(&self, xi: [f64; 2]) -> Complex<f64> {
        let one = |band: &Band| {
            let own = band.components(xi);
            profile_rectangle(self.profile(band), [own[0], own[1], gamma_sum(xi)], self.wavelength)
                * spatial_phase_infinite(self.coherence(), band.offset, own)
        };
        self.bands.iter().map(one).sum()
    }

    /// S in a direction, with the window across each scratch.
    pub fn scratches_windowed(&self, xi: [f64; 2]) -> Complex<f64> {
        let one = |band: &Band| {
            let own = band.components(xi);
            let segment = Segment {
                position: [0.0, band.offset],
                ends: [f64::NEG_INFINITY, f64::INFINITY],
            };
            response_rectangle_windowed(
                self.coherence(),
                self.profile(band),
                segment,
                [own[0], own[1], gamma_sum(xi)],
            )
        };
        self.bands.iter().map(one).sum()
    }

    /// What the crossings add to B - S in a direction.
    pub fn crossings(&self, xi: [f64; 2]) -> Complex<f64> {
        let mut sum = Complex::new(0.0, 0.0);
        for (i, one) in self.bands.iter().enumerate() {
            for two in &self.bands[i + 1..] {
                // t1 s + b1 c1 lies on the second line: its component along b2 is c2.
                let [t1, b1] = [one.tangent, [-one.tangent[1], one.tangent[0]]];
                let [slope, shift] = [two.components(t1)[1], two.components(b1)[1]];
                if slope == 0.0 {
                    continue;
                }
                let s = (two.offset - one.offset * shift) / slope;
                let place = [0, 1].map(|i| s * t1[i] + one.offset * b1[i]);
                if place[0].hypot(place[1]) > 6.0 * self.radius {
                    continue;
                }
                sum += crossing_response(
                    self.coherence(),
                    [self.profile(one), self.profile(two)],
                    [one.tangent, two.tangent],
                    place,
                    [xi[0], xi[1], gamma_sum(xi)],
                );
            }
        }
        sum
    }

    /// B in a direction.
    pub fn base(&self, xi: [f64; 2]) -> f64 {
        base_response(self.coherence(), xi)
    }
}

/// One scratch through the origin, and ten random ones: offsets within two radii, widths from 1 to 3 um.
pub fn scratched(count: usize) -> Surface {
    let mut random = Random::new(14);
    let band = |turn: f64, offset: f64, width: f64| Band {
        tangent: [turn.cos(), turn.sin()],
        offset,
        width,
    };
    let bands = if count == 1 {
        vec![band(0.0, 0.0, 2.0)]
    } else {
        (0..count)
            .map(|i| {
                let turn = std::f64::consts::PI * (i as f64 + random.uniform(0.1, 0.9)) / count as f64;
                band(turn, random.uniform(-2.0, 2.0) * RADIUS, random.uniform(1.0, 3.0))
            })
            .collect()
    };
    Surface {
        bands,
        depth: 0.2,
        radius: RADIUS,
        wavelength: WAVELENGTH,
    }
}

/// WVJH17 Fig. 13: one scratch 2 um wide and 0.2 um deep, along it and across it.
pub fn figure_13() -> [Slice; 2] {
    let surface = scratched(1);
    [(0, "along the scratch"), (1, "across the scratch")].map(|(axis, label)| {
        let mut found = Slice {
            label,
            xi: vec![],
            analytic: vec![],
            exact: vec![],
            fourier: vec![],
        };
        for (frequency, parts) in slice(&surface, GRID, axis, 8) {
            let x = frequency * surface.wavelength;
            if x.abs() > 1.0 {
                continue;
            }
            let xi = if axis == 0 { [x, 0.0] } else { [0.0, x] };
            let base = surface.base(xi);
            found.xi.push(x);
            found.analytic.push(radiance(&surface, base - surface.scratches(xi)));
            found
                .exact
                .push(radiance(&surface, base - surface.scratches_windowed(xi)));
            found
                .fourier
                .push(radiance(&surface, joined(&parts, depth_phase(&surface, xi))));
        }
        found
    })
}

/// WVJH17 Fig. 14: ten random scratches over the hemisphere.
pub fn figure_14() -> Plane {
    plane(&scratched(10))
}

/// Radiance of a surface over the hemisphere by each form.
pub fn plane(surface: &Surface) -> Plane {
    let spectrum = Spectrum::new(surface, GRID);
    let reach = (GRID.size as f64 * GRID.step / surface.wavelength).floor() as i64;
    let xi: Vec<f64> = (-reach..=reach)
        .map(|j| j as f64 * surface.wavelength / (GRID.size as f64 * GRID.step))
        .collect();
    let index = |j: i64| (j - reach).rem_euclid(GRID.size as i64) as usize;
    let mut found = Plane {
        xi: xi.clone(),
        analytic: vec![],
        crossings: vec![],
        fourier: vec![],
    };
    for (row, &y) in xi.iter().enumerate() {
        for (column, &x) in xi.iter().enumerate() {
            let at = [x, y];
            if x * x + y * y >= 1.0 {
                for values in [&mut found.analytic, &mut found.crossings, &mut found.fourier] {
                    values.push(0.0);
                }
                continue;
            }
            let base = surface.base(at);
            let (scratches, crossings) = (surface.scratches(at), surface.crossings(at));
            found.analytic.push(radiance(surface, base - scratches));
            found.crossings.push(radiance(surface, base - scratches + crossings));
            let parts = spectrum.at(index(column as i64), index(row as i64));
            let phase = depth_phase(surface, at);
            found.fourier.push(radiance(surface, joined(&parts, phase)));
        }
    }
    found
}
