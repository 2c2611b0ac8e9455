//! Integrals over the hemisphere above a scratch, and Pearson's test of samples against a density.
//!
//! A direction is known by its angle theta to the tangent and its angle psi around it. Panels grow away from the lobe and
//! are split at the edges of the bins, so that each is smooth.

#![allow(dead_code, reason = "each test that includes this uses its own part")]

use reference::gauss::EIGHT_POINTS;
use reference::generate::random::Random;
use std::f64::consts::PI;

pub type Direction = [f64; 3];

/// A unit vector from its direction cosines along tangent and bitangent.
pub fn above(x: f64, y: f64) -> Direction {
    [x, y, (1.0 - x * x - y * y).max(0.0).sqrt()]
}

/// The angles of a direction.
pub fn angles([x, y, z]: Direction) -> [f64; 2] {
    [y.hypot(z).atan2(x), z.atan2(y)]
}

/// The borders of panels between two bounds: `levels` graded towards a centre on each side, and `even` equal ones.
fn panels([low, high]: [f64; 2], centre: f64, [levels, even]: [i32; 2], edges: &[f64]) -> Vec<f64> {
    let centre = centre.clamp(low, high);
    let size = |k| (high - low) * 0.7f64.powi(k);
    let graded = (0..levels).flat_map(|k| [centre - size(k), centre + size(k)]);
    let even = (0..=even).map(|i| low + (high - low) * f64::from(i) / f64::from(even));
    let mut all: Vec<f64> = graded
        .chain(even)
        .chain([high, centre])
        .chain(edges.iter().copied())
        .collect();
    all.retain(|x| (low..=high).contains(x));
    all.sort_by(f64::total_cmp);
    all.dedup();
    all
}

/// The nodes and weights of the Gauss rule over all panels.
fn rule(borders: &[f64]) -> Vec<[f64; 2]> {
    let mut rule = Vec::new();
    for panel in borders.windows(2) {
        let (middle, half) = (0.5 * (panel[0] + panel[1]), 0.5 * (panel[1] - panel[0]));
        for [node, weight] in EIGHT_POINTS {
            rule.push([middle - half * node, half * weight]);
            rule.push([middle + half * node, half * weight]);
        }
    }
    rule
}

/// The integral of a function between two bounds, graded towards `centre`.
pub fn line(bounds: [f64; 2], centre: f64, function: impl Fn(f64) -> f64) -> f64 {
    rule(&panels(bounds, centre, [48, 64], &[]))
        .iter()
        .map(|[x, weight]| weight * function(*x))
        .sum()
}

/// A division of the hemisphere into bins.
pub struct Bins {
    /// Inner edges of the angle to the tangent.
    pub along: Vec<f64>,
    /// Inner edges of the angle around it.
    pub around: Vec<f64>,
}

impl Bins {
    /// One bin.
    pub fn one() -> Bins {
        Bins {
            along: Vec::new(),
            around: Vec::new(),
        }
    }

    /// Bins with equal numbers of the given directions on each axis.
    pub fn quantiles(directions: &[Direction], counts: [usize; 2]) -> Bins {
        let edges = |axis: usize| {
            let mut values: Vec<f64> = directions.iter().map(|d| angles(*d)[axis]).collect();
            values.sort_by(f64::total_cmp);
            (1..counts[axis])
                .map(|i| values[i * values.len() / counts[axis]])
                .collect()
        };
        Bins {
            along: edges(0),
            around: edges(1),
        }
    }

    fn len(&self) -> usize {
        (self.along.len() + 1) * (self.around.len() + 1)
    }

    fn place(&self, [theta, psi]: [f64; 2]) -> usize {
        let i = self.along.partition_point(|edge| *edge <= theta);
        let j = self.around.partition_point(|edge| *edge <= psi);
        i * (self.around.len() + 1) + j
    }
}

/// The integral of a density over each bin of the hemisphere; the lobe's centre is the mirror image of `incident`.
pub fn integrals(bins: &Bins, incident: Direction, density: impl Fn(Direction) -> f64) -> Vec<f64> {
    let mut sums = vec![0.0; bins.len()];
    for [theta, weight_theta] in rule(&panels([0.0, PI], (-incident[0]).acos(), [24, 1], &bins.along)) {
        let (g, a) = theta.sin_cos();
        let centre = (-incident[1] / g).clamp(-1.0, 1.0).acos();
        for [psi, weight_psi] in rule(&panels([0.0, PI], centre, [24, 48], &bins.around)) {
            let (sine, cosine) = psi.sin_cos();
            let value = density([a, g * cosine, g * sine]);
            sums[bins.place([theta, psi])] += weight_theta * g * weight_psi * value;
        }
    }
    sums
}

/// The integral of a density over the hemisphere.
pub fn integral(incident: Direction, density: impl Fn(Direction) -> f64) -> f64 {
    integrals(&Bins::one(), incident, density)[0]
}

/// The probability that chi-square with so many degrees of freedom exceeds the value (Wilson and Hilferty 1931).
pub fn chi_square_tail(value: f64, freedom: f64) -> f64 {
    let ninth = 2.0 / (9.0 * freedom);
    let z = ((value / freedom).cbrt() - (1.0 - ninth)) / ninth.sqrt();
    0.5 * iridescence::special::erfc_complex(iridescence::Complex::new(z / 2f64.sqrt(), 0.0)).re
}

/// A lobe under test: a density, and a sampler that may give no direction.
pub struct Lobe<'a> {
    pub incident: Direction,
    pub pdf: &'a dyn Fn(Direction) -> f64,
    pub sample: &'a dyn Fn(&mut Random) -> Option<Direction>,
}

/// Pearson's test: the probability of counts as unlikely as those of `draws` samples. Draws without a direction have a
/// bin of their own, bins with fewer than 8 expected counts are joined.
pub fn pearson(lobe: &Lobe, seed: u64, draws: usize) -> f64 {
    let mut random = Random::new(seed);
    let pilot: Vec<Direction> = (0..20_000).filter_map(|_| (lobe.sample)(&mut random)).collect();
    let bins = Bins::quantiles(&pilot, [12, 16]);
    let mut expected = integrals(&bins, lobe.incident, lobe.pdf);
    let total: f64 = expected.iter().sum();
    expected.push((1.0 - total).max(0.0));
    let mut counts = vec![0usize; expected.len()];
    for _ in 0..draws {
        let place = (lobe.sample)(&mut random).map_or(bins.len(), |d| bins.place(angles(d)));
        counts[place] += 1;
    }
    let (mut joined, mut joined_count, mut value, mut freedom) = (0.0, 0.0, 0.0, -1.0);
    let mut add = |expected: f64, count: f64| {
        value += (count - expected).powi(2) / expected;
        freedom += 1.0;
    };
    for (share, count) in expected.iter().zip(counts) {
        let (share, count) = (share * draws as f64, count as f64);
        if share < 8.0 {
            joined += share;
            joined_count += count;
        } else {
            add(share, count);
        }
    }
    if joined >= 1.0 {
        add(joined, joined_count);
    } else if joined_count > 8.0 {
        // Directions where none may be.
        return 0.0;
    }
    chi_square_tail(value, freedom)
}
