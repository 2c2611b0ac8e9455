//! Figures of area lights that need more than a method's largest error: what a tolerance keeps and costs over random scenes,
//! how many samples Monte Carlo takes for the same, chords in f32 where one is right. No clock.

use crate::number_table;
use iridescence::diffraction::Coherence;
use iridescence::light::{
    LightIntegral, ScratchLobe, Sphere, polygon_light, polygon_light_chords, polygon_light_within, sphere_light,
    sphere_light_chords, sphere_light_within,
};
use iridescence::shader;
use reference::generate::lights;
use reference::generate::random::Random;
use reference::oracle::light::{sphere_light_importance, sphere_light_monte_carlo};
use std::sync::LazyLock;

/// Seed of the scenes.
const SEED: u64 = 51;
/// Scenes for a tolerance.
const SCENES: usize = 20_000;
/// A light counts from this share of the whole plane's integral on.
const VISIBLE: f64 = 1e-6;
/// The tolerances that figures are asked for.
pub const TOLERANCES: [f64; 3] = [1e-2, 1e-3, 1e-4];

/// A kind of light.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// A sphere.
    Sphere,
    /// A polygon of three to eight vertices.
    Polygon,
}

/// What a tolerance kept and cost over the visible scenes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tier {
    /// The 99.9th percentile of the relative error, and the largest, as multiples of the tolerance.
    pub errors: [f64; 2],
    /// Mean number of chords.
    pub chords: f64,
    /// Per cent of the scenes with one chord or less whose error is above the tolerance.
    pub wrong: f64,
}

fn lobe(row: &[f64]) -> ScratchLobe {
    ScratchLobe {
        coherence: Coherence {
            radius: row[0],
            wavelength: row[1],
        },
        width: row[2],
        view: [row[3], row[4]],
    }
}

fn sphere(row: &[f64]) -> Sphere {
    Sphere {
        centre: [row[5], row[6], row[7]],
        radius: row[8],
    }
}

fn vertices(row: &[f64]) -> Vec<[f64; 3]> {
    row[5..].chunks_exact(3).map(|v| [v[0], v[1], v[2]]).collect()
}

/// A random scene of a kind.
fn scene(random: &mut Random, kind: Kind) -> Vec<f64> {
    match kind {
        Kind::Sphere => lights::sphere(random).to_vec(),
        Kind::Polygon => {
            let count = random.integer(3, 8) as usize;
            lights::polygon(random, count)
        }
    }
}

fn exact(row: &[f64], kind: Kind) -> f64 {
    match kind {
        Kind::Sphere => sphere_light(lobe(row), sphere(row)),
        Kind::Polygon => polygon_light(lobe(row), &vertices(row)),
    }
}

fn within(row: &[f64], kind: Kind, tolerance: f64) -> LightIntegral {
    match kind {
        Kind::Sphere => sphere_light_within(lobe(row), sphere(row), tolerance),
        Kind::Polygon => polygon_light_within(lobe(row), &vertices(row), tolerance),
    }
}

fn percentile(sorted: &[f64], share: f64) -> f64 {
    sorted[((sorted.len() - 1) as f64 * share) as usize]
}

/// The tier of each of [`TOLERANCES`] for a kind of light, over random scenes.
pub fn tiers(kind: Kind) -> &'static [Tier; 3] {
    static SPHERES: LazyLock<[Tier; 3]> = LazyLock::new(|| measured_tiers(Kind::Sphere));
    static POLYGONS: LazyLock<[Tier; 3]> = LazyLock::new(|| measured_tiers(Kind::Polygon));
    match kind {
        Kind::Sphere => &SPHERES,
        Kind::Polygon => &POLYGONS,
    }
}

fn measured_tiers(kind: Kind) -> [Tier; 3] {
    let mut random = Random::new(SEED);
    let visible: Vec<(Vec<f64>, f64)> = (0..SCENES)
        .map(|_| scene(&mut random, kind))
        .map(|row| {
            let value = exact(&row, kind);
            (row, value)
        })
        .filter(|(row, value)| *value > VISIBLE * lobe(row).whole_plane())
        .collect();
    TOLERANCES.map(|tolerance| {
        let (mut errors, mut chords, mut wrong) = (Vec::new(), 0.0, 0);
        for (row, value) in &visible {
            let found = within(row, kind, tolerance);
            let error = (found.value / value - 1.0).abs() / tolerance;
            errors.push(error);
            chords += found.chords;
            wrong += usize::from(found.chords <= 1.0 && error > 1.0);
        }
        errors.sort_by(f64::total_cmp);
        let count = visible.len() as f64;
        Tier {
            errors: [percentile(&errors, 0.999), percentile(&errors, 1.0)],
            chords: chords / count,
            wrong: 100.0 * wrong as f64 / count,
        }
    })
}

/// The 99th percentile of the relative error of the f32 chord, over scenes of which one chord is right to 10 %.
pub fn chord_error(kind: Kind) -> f64 {
    let mut random = Random::new(SEED + 1);
    let mut errors = Vec::new();
    for _ in 0..SCENES {
        let row: Vec<f64> = scene(&mut random, kind).iter().map(|&x| f64::from(x as f32)).collect();
        let (one, whole) = match kind {
            Kind::Sphere => (sphere_light_chords(lobe(&row), sphere(&row), 1), exact(&row, kind)),
            Kind::Polygon => (polygon_light_chords(lobe(&row), &vertices(&row), 1), exact(&row, kind)),
        };
        if (one / whole - 1.0).abs() < 0.1 && one > VISIBLE * lobe(&row).whole_plane() {
            errors.push((f64::from(single_chord(&row, kind)) / one - 1.0).abs());
        }
    }
    errors.sort_by(f64::total_cmp);
    percentile(&errors, 0.99)
}

#[rustfmt::skip]
fn single_chord(row: &[f64], kind: Kind) -> f32 {
    let x: Vec<f32> = row.iter().map(|&x| x as f32).collect();
    if kind == Kind::Sphere {
        return shader::sphere_light_chord(x[0], x[1], x[2], x[3], x[4], x[5], x[6], x[7], x[8]);
    }
    let count = (row.len() - 5) / 3;
    let v = |i: usize| x.get(5 + i).copied().unwrap_or(0.0);
    shader::polygon_light_chord(
        x[0], x[1], x[2], x[3], x[4], count as f32, v(0), v(1), v(2), v(3), v(4), v(5), v(6), v(7), v(8), v(9), v(10),
        v(11), v(12), v(13), v(14), v(15), v(16), v(17), v(18), v(19), v(20), v(21), v(22), v(23),
    )
}

/// The error at which Monte Carlo and the closed form are compared.
pub const EQUAL_ERROR: f64 = 1e-2;
/// Bins of the angular radius, and its range in degrees.
pub const BINS: usize = 11;
/// Range of the angular radius in degrees.
pub const RADII: [f64; 2] = [0.03, 60.0];
/// Visible scenes in a bin, samples of a pilot run in each.
const BIN_SCENES: usize = 160;
const PILOT: usize = 8_000;

/// Samples that Monte Carlo needs for the same standard error, in one bin of the light's size.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Size {
    /// Angular radius at the middle of the bin, in degrees.
    pub radius: f64,
    /// Quartiles of the samples of the cone.
    pub cone: [f64; 3],
    /// Quartiles of the samples of the Gaussian.
    pub gaussian: [f64; 3],
    /// The largest relative error of the closed form told this tolerance.
    pub ours: f64,
}

/// Measures all bins.
pub fn sizes() -> Vec<Size> {
    let step = (RADII[1] / RADII[0]).ln() / BINS as f64;
    let edge = |i: usize| RADII[0] * (step * i as f64).exp();
    let bins: Vec<usize> = (0..BINS).collect();
    let threads = std::thread::available_parallelism().map_or(1, usize::from);
    let mut found = vec![None; BINS];
    std::thread::scope(|scope| {
        let share = BINS.div_ceil(threads);
        for (bins, slots) in bins.chunks(share).zip(found.chunks_mut(share)) {
            scope.spawn(move || {
                for (&bin, slot) in bins.iter().zip(slots) {
                    *slot = Some(size(bin, [edge(bin), edge(bin + 1)]));
                }
            });
        }
    });
    found.into_iter().flatten().collect()
}

fn size(bin: usize, [from, to]: [f64; 2]) -> Size {
    let mut random = Random::new(SEED + 100 + bin as u64);
    let (mut cone, mut gaussian, mut ours) = (Vec::new(), Vec::new(), 0.0_f64);
    while cone.len() < BIN_SCENES {
        let row = lights::sphere(&mut random);
        let distance = libm::hypot(libm::hypot(row[5], row[6]), row[7]);
        let radius = libm::asin(row[8] / distance).to_degrees();
        let value = exact(&row, Kind::Sphere);
        if !(from..to).contains(&radius) || value <= 1e-3 * lobe(&row).whole_plane() {
            continue;
        }
        // A pilot run tells the variance of one sample.
        let needed = |standard_error: f64| (standard_error / (EQUAL_ERROR * value)).powi(2) * PILOT as f64;
        let seed = cone.len() as u64;
        cone.push(needed(sphere_light_monte_carlo(&row, PILOT, seed).standard_error).max(1.0));
        gaussian.push(needed(sphere_light_importance(&row, PILOT, seed).standard_error).max(1.0));
        let found = within(&row, Kind::Sphere, EQUAL_ERROR);
        ours = ours.max((found.value / value - 1.0).abs());
    }
    let quartiles = |mut samples: Vec<f64>| {
        samples.sort_by(f64::total_cmp);
        [0.25, 0.5, 0.75].map(|share| percentile(&samples, share))
    };
    Size {
        radius: (from * to).sqrt(),
        cone: quartiles(cone),
        gaussian: quartiles(gaussian),
        ours,
    }
}

/// The sizes of the committed table; none where there is none.
pub fn committed() -> Vec<Size> {
    let text = std::fs::read_to_string(crate::run::root().join(crate::run::SIZES)).unwrap_or_default();
    read(&text).unwrap_or_default()
}

/// Columns of the table of sizes.
pub const COLUMNS: [&str; 8] = [
    "radius",
    "cone_25",
    "cone_50",
    "cone_75",
    "gaussian_25",
    "gaussian_50",
    "gaussian_75",
    "ours",
];

/// The sizes as CSV.
pub fn write(sizes: &[Size]) -> String {
    let mut text = COLUMNS.join(",");
    text.push('\n');
    for s in sizes {
        let numbers = [s.radius].into_iter().chain(s.cone).chain(s.gaussian).chain([s.ours]);
        let words: Vec<String> = numbers.map(|x| format!("{x:.3e}")).collect();
        text.push_str(&words.join(","));
        text.push('\n');
    }
    text
}

/// Reads what [`write()`] wrote.
pub fn read(text: &str) -> Result<Vec<Size>, String> {
    let (header, rows) = number_table::read(text)?;
    if header != COLUMNS {
        return Err(format!("the columns {} expected", COLUMNS.join(",")));
    }
    let size = |x: &Vec<f64>| Size {
        radius: x[0],
        cone: [x[1], x[2], x[3]],
        gaussian: [x[4], x[5], x[6]],
        ours: x[7],
    };
    Ok(rows.iter().map(size).collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sizes_survive_writing_and_reading() {
        let size = Size {
            radius: 0.5,
            cone: [1.0, 2.0, 3.0],
            gaussian: [4.0, 5.0, 6.0],
            ours: 0.125,
        };
        assert_eq!(read(&write(&[size])), Ok(vec![size]));
        assert!(read("radius\n1\n").is_err());
    }

    #[test]
    fn a_tolerance_is_kept_by_few_chords() {
        for kind in [Kind::Sphere, Kind::Polygon] {
            for (tier, tolerance) in tiers(kind).iter().zip(TOLERANCES) {
                assert!(
                    tier.errors[1] <= 1.0 && tier.errors[0] > 0.01,
                    "{kind:?} {tolerance}: {tier:?}"
                );
                assert!((1.0..4.0).contains(&tier.chords), "{kind:?} {tolerance}: {tier:?}");
                assert_eq!(tier.wrong, 0.0, "{kind:?} {tolerance}");
            }
        }
    }
}
