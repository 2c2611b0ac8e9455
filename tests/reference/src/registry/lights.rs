//! The integrals over area lights: columns, truths, scales, refusals, and the methods: ours exact, to a tolerance and by
//! chords, the published method, and Monte Carlo.

use super::faddeeva::{own, peer, region};
use super::scratch_functions::{COSINE, LAMBDA, Refusal, SIGMA, UM, finite, positive, refuse};
use super::{Call, Function, Generator, Method, Metric, Oracle, Origin, Peak, Precision};
use crate::as_printed::{self, LightRepairs};
use crate::generate::lights as rows;
use crate::metrics::Reference;
use crate::oracle::light as oracle;
use crate::peers::light::{sphere_light_samples, sphere_light_samples_portable};
use iridescence::diffraction::Coherence;
use iridescence::light::{self, ScratchLobe, Sphere};
use iridescence::shader;
use iridescence::simd::shader as slices;
use std::collections::HashMap;
use std::f64::consts::PI;
use std::sync::{LazyLock, Mutex};

/// Names of the functions.
pub const SPHERE: &str = "sphere_light";
/// Of a polygon; its rows may have more vertices or fewer.
pub const POLYGON: &str = "polygon_light";
const SPHERE_CHORD: &str = "sphere_light_chord";
const QUAD_CHORD: &str = "quad_light_chord";
/// Monte Carlo in f32, 64 samples a row: among the methods of the chord, whose cost it measures.
pub const SAMPLES: &str = "monte_carlo_64";
/// The same with the elementary functions of the kernels.
pub const PORTABLE_SAMPLES: &str = "monte_carlo_64_portable";

const ORACLE: &str = "adaptive two-dimensional quadrature, 1e-12";
const CHORD_ORACLE: &str = "bracketed chord ends and panels of quadrature, 1e-13";
const WIDTH: &str = "the width is not a positive length";
const VIEW: &str = "the view's projection is longer than 1";
const INFINITE: &str = "the number is not finite";
const LIGHT: &str = "dimensionless, of the plane of direction cosines";

type SphereRow<T> = [T; 9];
type QuadRow<T> = [T; 17];

/// The columns of a quadrilateral: sigma to wo_y, then three to a vertex.
const QUAD: &[(&str, &str)] = &[
    ("sigma", UM),
    ("lambda", UM),
    ("width", UM),
    ("wo_x", COSINE),
    ("wo_y", COSINE),
    ("x1", "any length"),
    ("y1", "any length"),
    ("z1", "any length"),
    ("x2", "any length"),
    ("y2", "any length"),
    ("z2", "any length"),
    ("x3", "any length"),
    ("y3", "any length"),
    ("z3", "any length"),
    ("x4", "any length"),
    ("y4", "any length"),
    ("z4", "any length"),
];

const SPHERE_COLUMNS: &[(&str, &str)] = &[
    ("sigma", UM),
    ("lambda", UM),
    ("width", UM),
    ("wo_x", COSINE),
    ("wo_y", COSINE),
    ("px", "any length"),
    ("py", "any length"),
    ("pz", "any length"),
    ("radius", "any length"),
];

fn refuse_scratch(row: &[f64]) -> Refusal {
    positive(row, 0, SIGMA)
        .or_else(|| positive(row, 1, LAMBDA))
        .or_else(|| positive(row, 2, WIDTH))
        .or_else(|| finite(row, 3..row.len(), INFINITE))
        .or_else(|| {
            let unit = |x: f64| x.abs() <= 1.0;
            refuse(row, 3, unit, VIEW).or_else(|| refuse(row, 4, unit, VIEW))
        })
        .or_else(|| (row[3].hypot(row[4]) > 1.0 + 4e-7).then_some((4, VIEW)))
}

fn refuse_sphere(row: &[f64]) -> Refusal {
    let inside = "the sphere contains the shaded point or touches it";
    refuse_scratch(row)
        .or_else(|| refuse(row, 8, |x| x >= 0.0, "the radius is negative"))
        .or_else(|| (row[8] >= row[5].hypot(row[6]).hypot(row[7])).then_some((8, inside)))
}

fn refuse_polygon(row: &[f64]) -> Refusal {
    let here = "the vertex is the shaded point: it has no direction";
    refuse_scratch(row).or_else(|| {
        let vertex = row[5..].chunks_exact(3).position(|v| v.iter().all(|&x| x == 0.0));
        vertex.map(|i| (5 + 3 * i, here))
    })
}

/// True values of rows: an oracle takes a quarter of a millisecond, and every method asks for the scale.
fn cached(name: &'static str, row: &[f64], oracle: fn(&[f64]) -> f64) -> f64 {
    type Known = HashMap<(&'static str, Vec<u64>), f64>;
    static KNOWN: LazyLock<Mutex<Known>> = LazyLock::new(Mutex::default);
    let key = (name, row.iter().map(|x| x.to_bits()).collect());
    let known = |lock: &Mutex<Known>| lock.lock().expect("no oracle panics").get(&key).copied();
    if let Some(value) = known(&KNOWN) {
        return value;
    }
    let value = oracle(row);
    KNOWN.lock().expect("no oracle panics").insert(key, value);
    value
}

fn sphere_truth(row: &[f64]) -> f64 {
    cached(SPHERE, row, |row| oracle::sphere_light(row).value)
}

fn polygon_truth(row: &[f64]) -> f64 {
    cached(POLYGON, row, |row| oracle::polygon_light(row).value)
}

/// The integral of the lobe over the whole plane, sqrt(pi)/(sigma k) 2 pi/(k W).
fn whole_plane(row: &[f64]) -> f64 {
    let k = 2.0 * PI / row[1];
    PI.sqrt() / (row[0] * k) * (2.0 * PI / (k * row[2]))
}

const VISIBLE: &str = "the value, or of 0.001 of the plane's";
const PLANE: &str = "the whole plane's integral";

/// Below this share of the whole plane's integral errors are counted as of it.
const FAINT: f64 = 1e-3;

pub(super) const FUNCTIONS: [Function; 4] = [
    Function {
        name: SPHERE,
        summary: "the integral of exp(-(sigma k xi1)^2) sinc^2(k W xi2/2) over the visible part of a sphere's tangent cone",
        inputs: SPHERE_COLUMNS,
        outputs: &[("integral", LIGHT)],
        oracle: Oracle::Real(|row| Reference::exact(sphere_truth(row))),
        oracle_name: ORACLE,
        peak: Some(Peak {
            of: |row| sphere_truth(row).max(FAINT * whole_plane(row)),
            words: VISIBLE,
            largest: Some(1.0),
        }),
        refuse: refuse_sphere,
        timed: Some(rows::SPHERE_F32),
        thinning: 400,
    },
    Function {
        name: POLYGON,
        summary: "the same over a polygon of three vertices or more, convex or not",
        inputs: QUAD,
        outputs: &[("integral", LIGHT)],
        oracle: Oracle::Real(|row| Reference::exact(polygon_truth(row))),
        oracle_name: ORACLE,
        peak: Some(Peak {
            of: |row| polygon_truth(row).max(FAINT * whole_plane(row)),
            words: VISIBLE,
            largest: Some(1.0),
        }),
        refuse: refuse_polygon,
        timed: Some(rows::QUAD_F32),
        thinning: 400,
    },
    Function {
        name: SPHERE_CHORD,
        summary: "the integral of sinc^2(k W xi2/2) along the chord xi1 = 0 of a sphere, times sqrt(pi)/(sigma k)",
        inputs: SPHERE_COLUMNS,
        outputs: &[("integral", LIGHT)],
        oracle: Oracle::Real(|row| Reference::exact(cached(SPHERE_CHORD, row, oracle::sphere_light_chord))),
        oracle_name: CHORD_ORACLE,
        peak: Some(Peak {
            of: whole_plane,
            words: PLANE,
            largest: Some(1.0),
        }),
        refuse: refuse_sphere,
        timed: Some(rows::SPHERE_F32),
        thinning: 100,
    },
    Function {
        name: QUAD_CHORD,
        summary: "the same along the chords of a quadrilateral",
        inputs: QUAD,
        outputs: &[("integral", LIGHT)],
        oracle: Oracle::Real(|row| Reference::exact(cached(QUAD_CHORD, row, oracle::polygon_light_chord))),
        oracle_name: CHORD_ORACLE,
        peak: Some(Peak {
            of: whole_plane,
            words: PLANE,
            largest: Some(1.0),
        }),
        refuse: refuse_polygon,
        timed: Some(rows::QUAD_F32),
        thinning: 100,
    },
];

fn lobe([radius, wavelength, width, view_t, view_b]: [f64; 5]) -> ScratchLobe {
    ScratchLobe {
        coherence: Coherence { radius, wavelength },
        width,
        view: [view_t, view_b],
    }
}

fn scratch_of(row: &[f64]) -> ScratchLobe {
    lobe(std::array::from_fn(|i| row[i]))
}

fn sphere_of(row: &[f64]) -> Sphere {
    Sphere {
        centre: [row[5], row[6], row[7]],
        radius: row[8],
    }
}

fn vertices_of(row: &[f64]) -> Vec<[f64; 3]> {
    row[5..].chunks_exact(3).map(|v| [v[0], v[1], v[2]]).collect()
}

/// The vertices of a row without a heap: what is timed.
fn corners(row: &QuadRow<f64>) -> [[f64; 3]; 4] {
    std::array::from_fn(|i| [row[5 + 3 * i], row[6 + 3 * i], row[7 + 3 * i]])
}

/// What `report eval` may do with a row beyond the registered methods: rows of other lengths, and any tolerance.
pub struct Open {
    /// The function.
    pub function: &'static str,
    /// The least number of columns, and how many more there may be at a time (0: none).
    pub columns: [usize; 2],
    /// The value of a row by a method, where the method takes rows of this length.
    pub value: fn(&str, Precision, &[f64]) -> Option<f64>,
    /// The value with a relative error of at most a tolerance.
    pub within: fn(&[f64], f64) -> f64,
}

/// The functions that are more open than their registered methods.
pub const OPEN: [Open; 2] = [
    Open {
        function: SPHERE,
        columns: [9, 0],
        value: |_, _, _| None,
        within: |row, tolerance| light::sphere_light_within(scratch_of(row), sphere_of(row), tolerance).value,
    },
    Open {
        function: POLYGON,
        columns: [14, 3],
        value: polygon_value,
        within: |row, tolerance| light::polygon_light_within(scratch_of(row), &vertices_of(row), tolerance).value,
    },
];

/// A polygon of any number of vertices by a method of the registry; in f32 of eight at most.
fn polygon_value(method: &str, precision: Precision, row: &[f64]) -> Option<f64> {
    let (lobe, vertices) = (scratch_of(row), vertices_of(row));
    if precision == Precision::F32 {
        let mut x = [0.0f32; 30];
        for (x, value) in x.iter_mut().zip(&row[..5]) {
            *x = *value as f32;
        }
        x[5] = vertices.len() as f32;
        for (x, value) in x[6..].iter_mut().zip(&row[5..]) {
            *x = *value as f32;
        }
        let value = match method {
            "accurate" => polygon_f32(&x, shader::polygon_light),
            "chord" => polygon_f32(&x, shader::polygon_light_chord),
            _ => return None,
        };
        return (vertices.len() <= 8).then_some(f64::from(value));
    }
    Some(match method {
        "accurate" => light::polygon_light(lobe, &vertices),
        "within_1e-2" => light::polygon_light_within(lobe, &vertices, 1e-2).value,
        "within_1e-3" => light::polygon_light_within(lobe, &vertices, 1e-3).value,
        "within_1e-4" => light::polygon_light_within(lobe, &vertices, 1e-4).value,
        "chord" => light::polygon_light_chords(lobe, &vertices, 1),
        "chords_3" => light::polygon_light_chords(lobe, &vertices, 3),
        "vwh18" => light::polygon_light_vwh18(lobe, &vertices),
        "as_printed" => as_printed::polygon_light_vwh18(row, LightRepairs::default()),
        _ => return None,
    })
}

#[rustfmt::skip]
type Eight = fn(f32, f32, f32, f32, f32, f32, f32, f32, f32, f32, f32, f32, f32, f32, f32, f32, f32, f32, f32, f32, f32, f32, f32, f32, f32, f32, f32, f32, f32, f32) -> f32;

/// A function of sigma, lambda, width, view, count and eight vertices on a row.
#[rustfmt::skip]
fn polygon_f32(x: &[f32; 30], f: Eight) -> f32 {
    f(
        x[0], x[1], x[2], x[3], x[4], x[5], x[6], x[7], x[8], x[9], x[10], x[11], x[12], x[13], x[14], x[15], x[16],
        x[17], x[18], x[19], x[20], x[21], x[22], x[23], x[24], x[25], x[26], x[27], x[28], x[29],
    )
}

fn sphere_f32(f: fn(f32, f32, f32, f32, f32, f32, f32, f32, f32) -> f32, x: SphereRow<f32>) -> f32 {
    f(x[0], x[1], x[2], x[3], x[4], x[5], x[6], x[7], x[8])
}

#[rustfmt::skip]
type Four = fn(f32, f32, f32, f32, f32, f32, f32, f32, f32, f32, f32, f32, f32, f32, f32, f32, f32) -> f32;

#[rustfmt::skip]
fn quad_f32(f: Four, x: QuadRow<f32>) -> f32 {
    f(
        x[0], x[1], x[2], x[3], x[4], x[5], x[6], x[7], x[8], x[9], x[10], x[11], x[12], x[13], x[14], x[15], x[16],
    )
}

pub(super) fn methods() -> Vec<Method> {
    let mut methods = sphere_methods();
    methods.extend(polygon_methods());
    methods.extend(chord_methods());
    methods
}

fn published(
    function: &'static str,
    method: &'static str,
    label: &'static str,
    call: Call,
    domain: Generator,
) -> Method {
    Method {
        origin: Origin::Published,
        ..peer(function, method, label, call, domain, &[])
    }
}

fn sphere_methods() -> Vec<Method> {
    let exact = |row: SphereRow<f64>| light::sphere_light(scratch_of(&row), sphere_of(&row));
    let ours = |method, label, call, bound| {
        let promise = [region(rows::SPHERE, Metric::Peak, bound)];
        own(SPHERE, method, label, call, &promise)
    };
    let printed = |method, label, call: fn(SphereRow<f64>) -> f64| {
        published(SPHERE, method, label, Call::row(call), rows::SPHERE)
    };
    let sampled = |method, label, call: fn(SphereRow<f64>) -> f64| {
        peer(SPHERE, method, label, Call::row(call), rows::SPHERE, &[])
    };
    vec![
        ours("accurate", "iridescence f64", Call::row(exact), 2.5e-11),
        ours(
            "within_1e-2",
            "iridescence f64 to 1e-2",
            Call::row(|row: SphereRow<f64>| light::sphere_light_within(scratch_of(&row), sphere_of(&row), 1e-2).value),
            1e-2,
        ),
        ours(
            "within_1e-3",
            "iridescence f64 to 1e-3",
            Call::row(|row: SphereRow<f64>| light::sphere_light_within(scratch_of(&row), sphere_of(&row), 1e-3).value),
            1e-3,
        ),
        ours(
            "within_1e-4",
            "iridescence f64 to 1e-4",
            Call::row(|row: SphereRow<f64>| light::sphere_light_within(scratch_of(&row), sphere_of(&row), 1e-4).value),
            1e-4,
        ),
        own(
            SPHERE,
            "accurate",
            "iridescence f32",
            Call::row(|row: SphereRow<f32>| sphere_f32(shader::sphere_light, row)),
            &[region(rows::SPHERE_F32, Metric::Peak, 4e-3)],
        ),
        printed("chord", "VWH18, exact chord", |row| {
            light::sphere_light_chords(scratch_of(&row), sphere_of(&row), 1)
        }),
        printed("chords_3", "VWH18, three exact chords", |row| {
            light::sphere_light_chords(scratch_of(&row), sphere_of(&row), 3)
        }),
        printed("vwh18", "VWH18 3.4.1, roots mended", |row| {
            light::sphere_light_vwh18(scratch_of(&row), sphere_of(&row))
        }),
        printed("as_printed", "VWH18 3.4.1", |row| {
            as_printed::sphere_light_vwh18(&row, LightRepairs::default())
        }),
        sampled("monte_carlo_16", "16 samples of the cone", |row| {
            oracle::sphere_light_monte_carlo(&row, 16, 1).mean
        }),
        sampled("monte_carlo_256", "256 samples of the cone", |row| {
            oracle::sphere_light_monte_carlo(&row, 256, 1).mean
        }),
        sampled("importance_16", "16 samples of the Gaussian", |row| {
            oracle::sphere_light_importance(&row, 16, 1).mean
        }),
        sampled("importance_256", "256 samples of the Gaussian", |row| {
            oracle::sphere_light_importance(&row, 256, 1).mean
        }),
    ]
}

fn polygon_methods() -> Vec<Method> {
    let ours = |method, label, call: fn(QuadRow<f64>) -> f64, bound| {
        let promise = [region(rows::QUAD, Metric::Peak, bound)];
        own(POLYGON, method, label, Call::row(call), &promise)
    };
    let printed =
        |method, label, call: fn(QuadRow<f64>) -> f64| published(POLYGON, method, label, Call::row(call), rows::QUAD);
    let sampled =
        |method, label, call: fn(QuadRow<f64>) -> f64| peer(POLYGON, method, label, Call::row(call), rows::QUAD, &[]);
    vec![
        ours(
            "accurate",
            "iridescence f64",
            |row| light::polygon_light(scratch_of(&row), &corners(&row)),
            6e-11,
        ),
        ours(
            "within_1e-2",
            "iridescence f64 to 1e-2",
            |row| light::polygon_light_within(scratch_of(&row), &corners(&row), 1e-2).value,
            7e-3,
        ),
        ours(
            "within_1e-3",
            "iridescence f64 to 1e-3",
            |row| light::polygon_light_within(scratch_of(&row), &corners(&row), 1e-3).value,
            1e-3,
        ),
        ours(
            "within_1e-4",
            "iridescence f64 to 1e-4",
            |row| light::polygon_light_within(scratch_of(&row), &corners(&row), 1e-4).value,
            8e-5,
        ),
        own(
            POLYGON,
            "accurate",
            "iridescence f32",
            Call::row(|row: QuadRow<f32>| quad_f32(shader::quad_light, row)),
            &[region(rows::QUAD_F32, Metric::Peak, 3e-2)],
        ),
        printed("chord", "VWH18, exact chords", |row| {
            light::polygon_light_chords(scratch_of(&row), &corners(&row), 1)
        }),
        printed("chords_3", "VWH18, exact chords on three lines", |row| {
            light::polygon_light_chords(scratch_of(&row), &corners(&row), 3)
        }),
        printed("vwh18", "VWH18 3.4.2, roots mended", |row| {
            light::polygon_light_vwh18(scratch_of(&row), &corners(&row))
        }),
        printed("as_printed", "VWH18 3.4.2", |row| {
            as_printed::polygon_light_vwh18(&row, LightRepairs::default())
        }),
        sampled("monte_carlo_16", "16 samples of the cone", |row| {
            oracle::polygon_light_monte_carlo(&row, 16, 1).mean
        }),
        sampled("monte_carlo_256", "256 samples of the cone", |row| {
            oracle::polygon_light_monte_carlo(&row, 256, 1).mean
        }),
        sampled("importance_16", "16 samples of the Gaussian", |row| {
            oracle::polygon_light_importance(&row, 16, 1).mean
        }),
        sampled("importance_256", "256 samples of the Gaussian", |row| {
            oracle::polygon_light_importance(&row, 256, 1).mean
        }),
    ]
}

fn chord_methods() -> Vec<Method> {
    let ours = |function, label, call: Call, domain, bound| {
        own(
            function,
            "accurate",
            label,
            call,
            &[region(domain, Metric::Peak, bound)],
        )
    };
    vec![
        ours(
            SPHERE_CHORD,
            "iridescence f64",
            Call::row(|row: SphereRow<f64>| light::sphere_light_chords(scratch_of(&row), sphere_of(&row), 1)),
            rows::SPHERE,
            1e-14,
        ),
        ours(
            SPHERE_CHORD,
            "iridescence f32",
            Call::row(|row: SphereRow<f32>| sphere_f32(shader::sphere_light_chord, row)),
            rows::SPHERE_F32,
            3e-5,
        ),
        ours(
            SPHERE_CHORD,
            "iridescence f32 slices",
            Call::rows(slices::sphere_light_chord),
            rows::SPHERE_F32,
            3e-5,
        ),
        peer(
            SPHERE_CHORD,
            SAMPLES,
            "64 samples of the cone in f32",
            Call::row(sphere_light_samples::<64>),
            rows::SPHERE_F32,
            &[],
        ),
        peer(
            SPHERE_CHORD,
            PORTABLE_SAMPLES,
            "64 samples of the cone in the f32 kernels",
            Call::row(sphere_light_samples_portable::<64>),
            rows::SPHERE_F32,
            &[],
        ),
        ours(
            QUAD_CHORD,
            "iridescence f64",
            Call::row(|row: QuadRow<f64>| light::polygon_light_chords(scratch_of(&row), &corners(&row), 1)),
            rows::QUAD_CHORD,
            1e-13,
        ),
        ours(
            QUAD_CHORD,
            "iridescence f32",
            Call::row(|row: QuadRow<f32>| quad_f32(shader::quad_light_chord, row)),
            rows::QUAD_CHORD_F32,
            4e-5,
        ),
        ours(
            QUAD_CHORD,
            "iridescence f32 slices",
            Call::rows(slices::quad_light_chord),
            rows::QUAD_CHORD_F32,
            4e-5,
        ),
    ]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rows_out_of_the_domain_are_refused_by_column() {
        let sphere = [30.0, 0.5, 2.5, 0.1, 0.2, 0.0, 0.0, 2.0, 1.0];
        assert_eq!(refuse_sphere(&sphere), None);
        let wrong = [
            (0, 0.0),
            (1, -1.0),
            (2, 0.0),
            (3, 1.5),
            (4, f64::INFINITY),
            (8, 2.0),
            (8, -1.0),
        ];
        for (column, value) in wrong {
            let mut row = sphere;
            row[column] = value;
            assert_eq!(refuse_sphere(&row).map(|r| r.0), Some(column), "{row:?}");
        }
        let mut polygon = [30.0, 0.5, 2.5, 0.1, 0.2, 0.0, 0.0, 2.0, 1.0, 0.0, 2.0, 0.0, 1.0, 2.0];
        assert_eq!(refuse_polygon(&polygon), None);
        polygon[8..11].fill(0.0);
        assert_eq!(refuse_polygon(&polygon).map(|r| r.0), Some(8));
    }

    #[test]
    fn a_row_of_the_registered_length_has_the_registered_value() {
        let row = (rows::QUAD_F32.rows)(3, 40);
        for m in polygon_methods().iter().filter(|m| m.origin != Origin::Peer) {
            for row in row.chunks_exact(17) {
                let open = polygon_value(m.method, m.precision, row).expect(m.method);
                let registered = m.call.evaluate(row)[0];
                // In f32 the reference is a vertex for any number of them, the middle for four.
                let allowed = if m.precision == Precision::F32 {
                    1e-3 * whole_plane(row)
                } else {
                    0.0
                };
                assert!(
                    (open - registered).abs() <= allowed || open.to_bits() == registered.to_bits(),
                    "{}: {open:e} {registered:e} {row:?}",
                    m.method
                );
            }
        }
    }
}
