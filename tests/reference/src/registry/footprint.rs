//! The methods of the mean over a footprint: ours in three tiers, the published blend, and quadratures of the definition
//! by one rule for all footprints, in place of a library, which none has.

use super::faddeeva::{own, peer, region};
use super::{Call, Generator, Method, Metric, Origin};
use crate::as_printed::{Crossed, footprint_blend_vwh18_16};
use crate::generate::footprints as rows;
use crate::peers::footprint::windowed_midpoint;
use Metric::Peak;
use iridescence::diffraction::{self, Footprint};
use iridescence::shader;
use iridescence::simd::shader as slices;
use std::f64::consts::PI;

const MEAN: &str = "footprint_mean";
const REDUCED: &str = "footprint_mean_reduced";
const EDGE: &str = "footprint_mean_reduced_edge";

/// Half widths that f32 can take the distance of the edge from.
const MEAN_F32: Generator = Generator {
    name: "footprint_mean_f32",
    domain: "f32 footprints with half axes to 100 sigma, else as in f64",
    columns: 5,
    rows: |seed, n| {
        let mut found = Vec::with_capacity(5 * n);
        let mut part = seed;
        while found.len() < 5 * n {
            let drawn = (rows::FOOTPRINT.rows)(part, n.max(1000));
            let small = drawn.chunks_exact(5).filter(|row| row[0].max(row[1]) <= 100.0 * row[4]);
            found.extend(small.flatten().map(|&x| f64::from(x as f32)));
            part += 1;
        }
        found.truncate(5 * n);
        found
    },
};

/// a1, a2, cos_phi, offset, sigma.
type Row = [f64; 5];

/// A function of the crate with the arguments of a row.
fn of_row([a1, a2, cos_phi, offset, radius]: Row, mean: fn(Footprint, f64, f64) -> f64) -> f64 {
    let axes = [a1, a2];
    mean(Footprint { axes, cos_phi }, offset, radius)
}

/// VWH18 Eq. 16 over 2 A_C, the mean that it stands for.
fn as_printed([a1, a2, cos_phi, offset, sigma]: Row) -> f64 {
    let crossed = Crossed {
        axes: [a1, a2],
        cos_phi,
        offset,
        sigma,
    };
    footprint_blend_vwh18_16(&crossed) / (2.0 * PI * sigma * sigma)
}

/// The quadrature of one formula on the whole row.
fn midpoint<const N: usize>([a1, a2, cos_phi, offset, sigma]: Row, reach: f64) -> f64 {
    let sine = ((1.0 - cos_phi) * (1.0 + cos_phi)).sqrt();
    let half_width = (a1 * sine).hypot(a2 * cos_phi);
    windowed_midpoint::<N>(half_width / sigma, offset / sigma, reach)
}

pub(super) fn methods() -> Vec<Method> {
    let mut methods = own_methods();
    methods.extend(own_methods_f32());
    methods.extend(others());
    methods
}

fn own_methods() -> Vec<Method> {
    let mean = |method, label, call: fn(Row) -> f64, bound| {
        let promise = [region(rows::FOOTPRINT, Peak, bound)];
        own(MEAN, method, label, Call::row(call), &promise)
    };
    let reduced = |method, label, call: fn([f64; 2]) -> f64, bound| {
        let promise = [region(rows::FOOTPRINT_REDUCED, Peak, bound)];
        own(REDUCED, method, label, Call::row(call), &promise)
    };
    vec![
        mean(
            "accurate",
            "iridescence f64",
            |row| of_row(row, diffraction::footprint_mean),
            5e-13,
        ),
        mean(
            "medium",
            "iridescence f64 1e-6 tier",
            |row| of_row(row, diffraction::footprint_mean_medium),
            1e-6,
        ),
        mean(
            "coarse",
            "iridescence f64 1e-3 tier",
            |row| of_row(row, diffraction::footprint_mean_coarse),
            1e-3,
        ),
        reduced(
            "accurate",
            "iridescence f64",
            |[h, c]| diffraction::footprint_mean_reduced(h, c),
            5e-13,
        ),
        reduced(
            "medium",
            "iridescence f64 1e-6 tier",
            |[h, c]| diffraction::footprint_mean_reduced_medium(h, c),
            1e-6,
        ),
        reduced(
            "coarse",
            "iridescence f64 1e-3 tier",
            |[h, c]| diffraction::footprint_mean_reduced_coarse(h, c),
            1e-3,
        ),
    ]
}

fn own_methods_f32() -> Vec<Method> {
    let mean = |method, label, call: fn([f32; 5]) -> f32, bound| {
        let promise = [region(MEAN_F32, Peak, bound)];
        own(MEAN, method, label, Call::row(call), &promise)
    };
    let edge = |method, label, call: Call, bound| {
        let promise = [region(rows::FOOTPRINT_REDUCED_F32, Peak, bound)];
        own(EDGE, method, label, call, &promise)
    };
    let row = |f: fn([f32; 2]) -> f32| Call::row(f);
    vec![
        mean(
            "accurate",
            "iridescence f32",
            |[a1, a2, cos_phi, offset, radius]| shader::footprint_mean(a1, a2, cos_phi, offset, radius),
            2e-6,
        ),
        mean(
            "coarse",
            "iridescence f32 1e-3 tier",
            |[a1, a2, cos_phi, offset, radius]| shader::footprint_mean_coarse(a1, a2, cos_phi, offset, radius),
            1e-3,
        ),
        edge(
            "accurate",
            "iridescence f32",
            row(|[half_width, edge]| shader::footprint_mean_reduced(half_width, edge)),
            1e-6,
        ),
        edge(
            "coarse",
            "iridescence f32 1e-3 tier",
            row(|[half_width, edge]| shader::footprint_mean_reduced_coarse(half_width, edge)),
            1e-3,
        ),
        edge(
            "accurate",
            "iridescence f32 slices",
            Call::rows(slices::footprint_mean_reduced),
            1e-6,
        ),
        edge(
            "coarse",
            "iridescence f32 1e-3 slices",
            Call::rows(slices::footprint_mean_reduced_coarse),
            1e-3,
        ),
    ]
}

fn others() -> Vec<Method> {
    let other = |method, label, call: fn(Row) -> f64| peer(MEAN, method, label, Call::row(call), rows::FOOTPRINT, &[]);
    vec![
        Method {
            origin: Origin::Published,
            ..other("vwh18", "VWH18 Eq. 16 with its factor pi", |row| {
                of_row(row, diffraction::footprint_mean_vwh18)
            })
        },
        Method {
            origin: Origin::Published,
            ..other("as_printed", "VWH18 Eq. 16", as_printed)
        },
        other("quadrature_9", "quadrature of the definition, 9 midpoints", |row| {
            midpoint::<9>(row, 2.8)
        }),
        other("quadrature_17", "quadrature of the definition, 17 midpoints", |row| {
            midpoint::<17>(row, 3.8)
        }),
        other("quadrature_33", "quadrature of the definition, 33 midpoints", |row| {
            midpoint::<33>(row, 5.4)
        }),
    ]
}
