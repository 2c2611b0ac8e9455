//! The raster of a surface: which share of each pixel lies below none, one, two, ... scratches.

use super::{Grid, Surface};
use std::f64::consts::{PI, SQRT_2};

/// An infinite scratch in the plane of the surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Band {
    /// Unit tangent; the bitangent is the tangent turned by a right angle to the left.
    pub tangent: [f64; 2],
    /// Distance of the centre line from the origin, along the bitangent.
    pub offset: f64,
    /// Width.
    pub width: f64,
}

impl Band {
    /// Component along the tangent and along the bitangent.
    pub fn components(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        let [tx, ty] = self.tangent;
        [x * tx + y * ty, y * tx - x * ty]
    }

    /// The two edges, along the bitangent.
    fn edges(&self) -> [f64; 2] {
        [self.offset - 0.5 * self.width, self.offset + 0.5 * self.width]
    }
}

/// The share of a normal distribution below x.
fn below(x: f64) -> f64 {
    0.5 * libm::erfc(-x / SQRT_2)
}

/// The share of a normal distribution of mean `mean` between two edges, in units of its deviation.
fn between([from, to]: [f64; 2], mean: f64, deviation: f64) -> f64 {
    below((to - mean) / deviation) - below((from - mean) / deviation)
}

/// The share of a round normal distribution within two bands at once; `means` are its components across them.
fn within_both([first, second]: [Band; 2], means: [f64; 2], deviation: f64) -> f64 {
    // b2 = cosine b1 + sine t1: across the second band, a point is cosine u + sine v, u and v independent.
    let cosine = first.tangent[0] * second.tangent[0] + first.tangent[1] * second.tangent[1];
    let sine = (1.0 - cosine * cosine).max(0.0).sqrt();
    let [from, to] = first.edges();
    let (lo, hi) = (from.max(means[0] - 6.0 * deviation), to.min(means[0] + 6.0 * deviation));
    if lo >= hi {
        return 0.0;
    }
    // Gauss-Legendre of 5 points on 6 parts between the first band's edges.
    const NODES: [[f64; 2]; 5] = [
        [-0.906_179_845_938_664, 0.236_926_885_056_189],
        [-0.538_469_310_105_683, 0.478_628_670_499_366],
        [0.0, 0.568_888_888_888_889],
        [0.538_469_310_105_683, 0.478_628_670_499_366],
        [0.906_179_845_938_664, 0.236_926_885_056_189],
    ];
    let half = (hi - lo) / 12.0;
    let mut sum = 0.0;
    for part in 0..6 {
        for [node, weight] in NODES {
            let u = lo + half * (f64::from(2 * part + 1) + node) - means[0];
            let density = (-0.5 * (u / deviation).powi(2)).exp() / ((2.0 * PI).sqrt() * deviation);
            sum += weight * half * density * between(second.edges(), means[1] + cosine * u, sine.max(1e-3) * deviation);
        }
    }
    sum
}

/// Window times the share of each pixel below exactly n scratches, n = 0, 1, ..., row by row.
pub fn levels(surface: &Surface, grid: Grid) -> Vec<Vec<f64>> {
    let blur = grid.step;
    let total = surface.radius.powi(2) + blur.powi(2);
    // A Gaussian window times a Gaussian pixel is a Gaussian about `shrink` times the pixel's place.
    let shrink = surface.radius.powi(2) / total;
    let deviation = surface.radius * blur / total.sqrt();
    let mut found = vec![vec![0.0; grid.size * grid.size]];
    let mut partial = Vec::new();
    for (row, column) in (0..grid.size * grid.size).map(|i| (i / grid.size, i % grid.size)) {
        let place = [grid.place(column), grid.place(row)];
        let window = shrink * (-(place[0].powi(2) + place[1].powi(2)) / (2.0 * total)).exp();
        partial.clear();
        let mut full = 0;
        for band in &surface.bands {
            let mean = shrink * band.components(place)[1];
            let inside = 0.5 * band.width - (mean - band.offset).abs();
            if inside >= 6.0 * deviation {
                full += 1;
            } else if inside > -6.0 * deviation {
                partial.push((*band, mean, between(band.edges(), mean, deviation)));
            }
        }
        // Shares of 0, 1, ... of the scratches that cover the pixel in part.
        let mut shares = vec![1.0];
        let mut rest = partial.as_slice();
        if let [a, b, others @ ..] = partial.as_slice() {
            let both = within_both([a.0, b.0], [a.1, b.1], deviation);
            shares = vec![1.0 - a.2 - b.2 + both, a.2 + b.2 - 2.0 * both, both];
            rest = others;
        }
        for (_, _, share) in rest {
            let mut next = vec![0.0; shares.len() + 1];
            for (n, s) in shares.iter().enumerate() {
                next[n] += s * (1.0 - share);
                next[n + 1] += s * share;
            }
            shares = next;
        }
        for (n, share) in shares.iter().enumerate() {
            while found.len() <= full + n {
                found.push(vec![0.0; grid.size * grid.size]);
            }
            found[full + n][row * grid.size + column] = window * share;
        }
    }
    found
}

/// The sharp raster: the number of scratches over each pixel's centre.
pub fn counts(surface: &Surface, grid: Grid) -> Vec<usize> {
    let cells = (0..grid.size * grid.size).map(|i| [grid.place(i % grid.size), grid.place(i / grid.size)]);
    let over = |place| {
        let hit = |band: &&Band| (band.components(place)[1] - band.offset).abs() <= 0.5 * band.width;
        surface.bands.iter().filter(hit).count()
    };
    cells.map(over).collect()
}
