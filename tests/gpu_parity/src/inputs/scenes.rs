//! Rows of inputs for functions of a scene: each argument a quantity with its own range.

use super::{ROWS, fraction, logarithmic};
use std::f64::consts::TAU;

/// Rows of a chord of an area light, a few hundred operations each.
const CHORDS: usize = 2048;
/// Rows of a light over the whole band, ten thousand operations each.
const LIGHTS: usize = 192;

/// What an argument is, lengths in um.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Quantity {
    /// Radius of coherence.
    Radius,
    /// Wavelength.
    Wavelength,
    /// Width of a scratch.
    Width,
    /// Depth of a scratch, of either sign.
    Depth,
    /// A component of the scattering vector, over the hemisphere.
    Cosine,
    /// The same within the core of the base response.
    Core,
    /// Component along the normal.
    Gamma,
    /// A place within a few radii.
    Place,
    /// A number between 0 and 1.
    Share,
    /// A number between 0 and 4.
    Contrast,
    /// A response, of either sign.
    Response,
    /// A size from far below the radius to far above it.
    Size,
    /// A concentration.
    Concentration,
    /// A unit vector in the surface: two numbers.
    Unit,
    /// Another, at an angle from the one before it: two numbers.
    OtherUnit,
    /// A direction above the surface: three numbers.
    Direction,
    /// Its components in the surface: two numbers.
    Plane,
    /// A direction within the core of the base lobe along the tangent, of the plane before it: three numbers.
    NearMirror,
}

impl Quantity {
    fn value(self, i: usize, stream: u64) -> f32 {
        let between = |low: f64, high: f64| (low + (high - low) * fraction(i, stream)) as f32;
        let size = |low: f64, high: f64| logarithmic(i, stream, low, high).abs();
        // No two zeros in step.
        let none = i % 97 == stream as usize % 97;
        match self {
            Quantity::Radius => between(5.0, 60.0),
            Quantity::Wavelength => between(0.36, 0.83),
            Quantity::Width if none => 0.0,
            Quantity::Width => size(0.05, 100.0),
            Quantity::Depth if none => 0.0,
            Quantity::Depth => logarithmic(i, stream, 1e-3, 20.0),
            Quantity::Cosine if none => 0.0,
            Quantity::Cosine => between(-2.0, 2.0),
            Quantity::Core if none => 0.0,
            Quantity::Core => between(-0.008, 0.008),
            Quantity::Gamma => between(0.0, 2.0),
            Quantity::Place if none => 0.0,
            Quantity::Place => between(-40.0, 40.0),
            Quantity::Share => between(0.0, 1.0),
            Quantity::Contrast => between(0.0, 4.0),
            Quantity::Response => logarithmic(i, stream, 1e-2, 1e4),
            Quantity::Size => size(1e-2, 1e4),
            Quantity::Concentration if none => 0.0,
            Quantity::Concentration => size(1e-2, 20.0),
            Quantity::Unit | Quantity::OtherUnit | Quantity::Direction | Quantity::Plane | Quantity::NearMirror => {
                unreachable!("more than one number")
            }
        }
    }

    /// Appends the quantity to a row.
    fn append(self, i: usize, stream: u64, row: &mut Vec<f32>) {
        let angle = TAU * fraction(i, stream + 8);
        match self {
            Quantity::Direction | Quantity::Plane => {
                let cosine = 0.02 + 0.98 * fraction(i, stream);
                let sine = (1.0 - cosine * cosine).sqrt();
                row.extend([sine * angle.cos(), sine * angle.sin()].map(|x| x as f32));
                if self == Quantity::Direction {
                    row.push(cosine as f32);
                }
            }
            Quantity::Unit => row.extend([angle.cos(), angle.sin()].map(|x| x as f32)),
            Quantity::OtherUnit => {
                let [x, y] = [row[row.len() - 2], row[row.len() - 1]].map(f64::from);
                let (sine, cosine) = (0.1 + 2.9 * fraction(i, stream)).sin_cos();
                row.extend([x * cosine - y * sine, x * sine + y * cosine].map(|x| x as f32));
            }
            Quantity::NearMirror => {
                let along = -f64::from(row[row.len() - 2]) + 0.016 * fraction(i, stream) - 0.008;
                let along = along.clamp(-0.99, 0.99);
                let rest = (1.0 - along * along).sqrt();
                row.extend([along, rest * angle.cos(), rest * angle.sin().abs()].map(|x| x as f32));
            }
            single => row.push(single.value(i, stream)),
        }
    }
}

/// The arguments of a function of a scene; None for the others.
fn quantities(name: &str) -> Option<&'static [Quantity]> {
    use Quantity::*;
    Some(match name {
        "width_term" => &[Width, Cosine, Wavelength],
        "depth_term" | "depth_term_squared" => &[Depth, Gamma, Wavelength],
        "profile_rectangle" | "profile_triangle" | "response_triangle" => &[Width, Depth, Cosine, Gamma, Wavelength],
        "spatial_phase" => &[Radius, Wavelength, Cosine, Cosine, Place, Place, Place, Place],
        "spatial_phase_infinite" => &[Radius, Wavelength, Core, Cosine, Place],
        "spatial_phase_infinite_squared" => &[Radius, Wavelength, Core, Place],
        "coherence_window" => &[Place, Radius],
        "base_response" => &[Radius, Wavelength, Core, Core],
        "area_density" | "area_density_amplitude" => &[Width, Place, Radius],
        "energy_blend_base" | "energy_blend_scattered" => &[Share, Contrast],
        "energy_blend_scratches" => &[Share],
        "reflectance_coherent" => &[Radius, Wavelength, Response, Response, Response],
        "base_interference" => &[Response, Response],
        "crossing_response" => &[
            Radius, Wavelength, Width, Depth, Width, Depth, Unit, OtherUnit, Place, Place, Cosine, Cosine, Gamma,
        ],
        "reflectance_incoherent" => &[Radius, Wavelength, Response],
        "scratch_squared" => &[Radius, Wavelength, Width, Depth, Core, Cosine, Gamma, Share],
        "footprint_half_width" => &[Size, Size, Share],
        "footprint_mean" | "footprint_mean_coarse" => &[Size, Size, Share, Place, Radius],
        "gaussian_inverse" => &[Share],
        "balance_weight" => &[Size, Size],
        "base_lobe_pdf" => &[Radius, Wavelength, Plane, NearMirror],
        "base_lobe_sample" => &[Radius, Wavelength, Plane, Share, Share],
        "scratch_lobe_pdf" => &[Radius, Wavelength, Width, Plane, NearMirror],
        "scratch_lobe_sample" => &[Radius, Wavelength, Width, Plane, Share, Share],
        "scratch_cone_pdf" => &[Concentration, Direction, Direction],
        "scratch_cone_sample" => &[Concentration, Direction, Share, Share, Share],
        _ => return None,
    })
}

/// Half widths and edges H - |C| of reduced footprints: from within the window to 1e4 of it, centres to 6 beyond the edge.
fn reduced_footprints() -> Vec<f32> {
    (0..ROWS)
        .flat_map(|i| {
            let half_width = logarithmic(i, 52, 1e-3, 1e4).abs();
            let inside = -f64::from(half_width) * fraction(i, 53);
            let edge = match i % 3 {
                0 => -inside,
                1 => 12.0 * fraction(i, 54) - 6.0,
                _ => -inside - 6.0 * fraction(i, 55),
            };
            [half_width, (edge as f32).min(half_width)]
        })
        .collect()
}

/// Rows of area lights: scratches and views with a light near the line xi_t = 0, large and small, over the horizon and at it.
fn lights(name: &str) -> Option<Vec<f32>> {
    let kind = name.strip_suffix("_chord").unwrap_or(name);
    let vertices = match kind {
        "sphere_light" => 0,
        "triangle_light" => 3,
        "quad_light" => 4,
        "polygon_light" => 8,
        _ => return None,
    };
    let mut rows = Vec::new();
    for i in 0..if kind == name { LIGHTS } else { CHORDS } {
        let between = |stream: u64, low: f64, high: f64| low + (high - low) * fraction(i, stream);
        let (sine, cosine) = between(60, 0.0, TAU).sin_cos();
        let size = between(61, 0.0, 1.0).sqrt();
        let view = [size * cosine, size * sine];
        rows.extend([between(62, 10.0, 60.0), between(63, 0.38, 0.78), between(64, 0.5, 10.0)].map(|x| x as f32));
        rows.extend(view.map(|x| x as f32));
        let angle = f64::from(logarithmic(i, 65, 1e-3, 1.0).abs());
        let x = (between(66, -1.0, 1.0) * (angle.sin() + 0.01) - view[0]).clamp(-0.99, 0.99);
        let (sine, cosine) = between(67, -0.2, 3.34).sin_cos();
        let rest = (1.0 - x * x).sqrt();
        let centre = [x, rest * cosine, rest * sine];
        if vertices == 0 {
            rows.extend(centre.map(|x| x as f32));
            rows.push(angle.sin() as f32);
            continue;
        }
        let count = if vertices == 8 { 3 + i % 6 } else { vertices };
        if vertices == 8 {
            rows.push(count as f32);
        }
        for k in 0..vertices {
            let turn = TAU * (k as f64 + 0.5 * between(68 + k as u64, 0.0, 1.0)) / count as f64;
            let reach = angle.tan() * between(76 + k as u64, 0.3, 1.0);
            for (axis, centre) in centre.into_iter().enumerate() {
                let [a, b] = [84, 87].map(|stream| between(stream + axis as u64, -1.0, 1.0));
                rows.push((centre + reach * (a * turn.cos() + b * turn.sin())) as f32);
            }
        }
    }
    Some(rows)
}

/// Rows for the function of this name, if it is one of a scene.
pub(super) fn rows(name: &str) -> Option<Vec<f32>> {
    if let Some(rows) = lights(name) {
        return Some(rows);
    }
    if name.starts_with("footprint_mean_reduced") {
        return Some(reduced_footprints());
    }
    let quantities = quantities(name)?;
    let mut rows = Vec::new();
    for i in 0..ROWS {
        for (stream, quantity) in (44..).zip(quantities) {
            quantity.append(i, stream, &mut rows);
        }
    }
    Some(rows)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rows_are_whole_and_hold_the_limits() {
        let rows = rows("spatial_phase").expect("a scene");
        assert_eq!(rows.len(), 8 * ROWS);
        for argument in 2..8 {
            let zeros = (0..ROWS).filter(|i| rows[8 * i + argument] == 0.0).count();
            assert!(zeros > ROWS / 100 && zeros < ROWS / 90, "argument {argument}: {zeros}");
        }
        assert!(rows.iter().all(|x| x.is_finite()));
    }

    #[test]
    fn reduced_footprints_have_their_centre_on_either_side_of_the_edge() {
        let rows = reduced_footprints();
        let outside = rows.chunks_exact(2).filter(|r| r[1] < 0.0).count();
        assert!(outside > ROWS / 8 && outside < ROWS / 2, "{outside}");
        assert!(rows.chunks_exact(2).all(|r| r[1] <= r[0]));
    }
}
