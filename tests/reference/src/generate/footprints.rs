//! Rows of the mean over a footprint. The columns are those of the oracles.

use super::random::{Random, neighbour};
use super::scratches::{kept, radius, recorded, single};
use super::{Generator, fill};

/// a1, a2, cos_phi, offset, sigma.
pub const FOOTPRINT: Generator = Generator {
    name: "footprint",
    domain: "half axes log-uniform in 1e-2..1e5 um, aspect to 1e4, any angle, offsets to 8 sigma beyond the edge, sigma 10, 60 or log-uniform in 1..100 um",
    columns: 5,
    rows: |seed, n| fill(seed, n, 5, ellipse_rows(), |r, rows| rows.extend(ellipse(r))),
};

/// H, C.
pub const FOOTPRINT_REDUCED: Generator = Generator {
    name: "footprint_reduced",
    domain: "H log-uniform in 1e-3..1e4, with 0, 1e-300 and 1e8; |C| to H + 6",
    columns: 2,
    rows: |seed, n| {
        fill(seed, n, 2, reduced_rows(), |r, rows| {
            let [h, depth] = edge(r);
            rows.extend([h, r.signed((h - depth).abs())]);
        })
    },
};

/// H, H - |C|: the half width and the distance from the edge, as f32 numbers.
pub const FOOTPRINT_REDUCED_F32: Generator = Generator {
    name: "footprint_reduced_f32",
    domain: "f32: H log-uniform in 1e-3..1e4, with 0, 1e-30 and 1e8; distance from the edge H - |C| from -6 to H",
    columns: 2,
    rows: |seed, n| {
        fill(seed, n, 2, edge_rows(), |r, rows| {
            let [h, depth] = edge(r).map(single);
            rows.extend([h, depth.min(h)]);
        })
    },
};

/// H and the distance H - |C| >= -6 from the edge, not above H.
fn edge(random: &mut Random) -> [f64; 2] {
    let h = random.log_uniform(1e-3, 1e4);
    let near = random.log_uniform(1e-6, 6.0);
    let depth = match random.integer(0, 6) {
        0 => h,
        1 => h * (1.0 - random.log_uniform(1e-6, 1.0)),
        2 => random.signed(near),
        3 => random.uniform(-6.0, 6.0),
        4 => random.uniform(-6.0, 0.0),
        _ => random.uniform(-6.0_f64.min(h), h),
    };
    [h, depth.min(h)]
}

const HALF_WIDTHS: [f64; 20] = [
    0.0, 1e-300, 1e-30, 1e-3, 0.1, 0.5, 1.0, 1.7, 2.9, 3.0, 4.3, 4.4, 7.0, 10.8, 11.0, 33.0, 100.0, 1e3, 1e4, 1e8,
];

fn reduced_rows() -> Vec<f64> {
    let mut rows = recorded("footprint_mean_reduced", false);
    for h in HALF_WIDTHS {
        for c in [
            0.0,
            -0.0,
            1e-9,
            0.5 * h,
            h,
            neighbour(h, 1),
            neighbour(h, -1),
            h + 1.0,
            (h - 1.0).abs(),
            h + 6.0,
        ] {
            rows.push(vec![h, c]);
            rows.push(vec![h, -c]);
        }
    }
    kept(rows, false)
}

fn edge_rows() -> Vec<f64> {
    let mut rows = recorded("footprint_mean_reduced_edge", true);
    for h in HALF_WIDTHS.map(|h| if h == 1e-300 { 1e-20 } else { h }) {
        for depth in [h, 0.5 * h, 0.0, -0.0, 1e-9, -1e-9, 1.0, -1.0, 3.0, -3.0, -6.0] {
            rows.push(vec![single(h), single(depth).min(single(h))]);
        }
    }
    kept(rows, true)
}

/// Half the width of the ellipse across the scratch.
fn half_width(a1: f64, a2: f64, cos_phi: f64) -> f64 {
    (a1 * ((1.0 - cos_phi) * (1.0 + cos_phi)).sqrt()).hypot(a2 * cos_phi)
}

fn ellipse(random: &mut Random) -> [f64; 5] {
    let long = random.log_uniform(1e-2, 1e5);
    let short = (long * random.log_uniform(1e-4, 1.0)).max(1e-2);
    let [a1, a2] = if random.chance(0.5) {
        [long, short]
    } else {
        [short, long]
    };
    let small = random.log_uniform(1e-16, 1e-2);
    let cos_phi = match random.integer(0, 6) {
        0 => 0.0,
        1 => 1.0,
        2 => 1.0 - small,
        3 => small,
        _ => random.uniform(0.0, std::f64::consts::PI).cos(),
    };
    let sigma = radius(random);
    let h = half_width(a1, a2, cos_phi);
    let near = random.log_uniform(1e-9, 1.0);
    let offset = match random.integer(0, 5) {
        0 => 0.0,
        1 => h,
        2 => (h + sigma * random.signed(near)).abs(),
        3 => (h + sigma * random.uniform(-8.0, 8.0)).abs(),
        _ => random.uniform(0.0, h),
    };
    [a1, a2, random.signed(cos_phi), random.signed(offset), sigma]
}

fn ellipse_rows() -> Vec<f64> {
    let mut rows = recorded("footprint_mean", false);
    for [a1, a2] in [
        [0.0, 0.0],
        [0.0, 30.0],
        [1e5, 0.0],
        [10.0, 10.0],
        [500.0, 10.0],
        [10.0, 500.0],
        [1e5, 10.0],
        [1e-2, 1e-2],
    ] {
        for cos_phi in [0.0, -0.0, 1.0, -1.0, 0.6, neighbour(1.0, -1), 1e-300] {
            let h = half_width(a1, a2, cos_phi);
            for offset in [0.0, h, -h - 20.0, 0.7 * h] {
                rows.push(vec![a1, a2, cos_phi, offset, 10.0]);
            }
        }
    }
    kept(rows, false)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ellipses_hold_every_aspect_and_every_place_of_the_scratch() {
        let rows = (FOOTPRINT.rows)(1, 20_000);
        let share =
            |condition: fn(&[f64]) -> bool| rows.chunks_exact(5).filter(|row| condition(row)).count() as f64 / 20_000.0;
        assert_eq!(share(|r| r[2].abs() > 1.0), 0.0);
        assert!(share(|r| r[0] > 1e3 * r[1]) > 0.05 && share(|r| r[1] > 1e3 * r[0]) > 0.05);
        assert!(share(|r| r[2] == 0.0) > 0.1 && share(|r| r[2] == 1.0) > 0.05 && share(|r| r[2] == -1.0) > 0.05);
        let beyond = |r: &[f64]| (r[3].abs() - half_width(r[0], r[1], r[2])) / r[4];
        assert!(rows.chunks_exact(5).all(|r| beyond(r) < 8.1));
        assert!(rows.chunks_exact(5).filter(|r| beyond(r) > 1.0).count() > 1000);
        assert!(rows.chunks_exact(5).filter(|r| beyond(r).abs() < 1e-3).count() > 2000);
    }

    #[test]
    fn the_edge_is_never_farther_than_the_centre() {
        let rows = (FOOTPRINT_REDUCED_F32.rows)(1, 20_000);
        assert!(rows.chunks_exact(2).all(|r| r[1] <= r[0] && r[1] >= -6.0));
        assert!(rows.chunks_exact(2).filter(|r| r[1] == r[0]).count() > 1000);
        let rows = (FOOTPRINT_REDUCED.rows)(1, 20_000);
        assert!(rows.chunks_exact(2).all(|r| r[1].abs() <= r[0] + 6.0001));
        assert!(rows.chunks_exact(2).filter(|r| r[1].abs() > r[0]).count() > 2000);
    }
}
