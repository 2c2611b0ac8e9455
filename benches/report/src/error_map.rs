//! Maps of errors as multiples of a function's scale, kept as CSV in `data/charts`: the mean over a footprint, and the
//! transform of a triangular groove. All points follow from the grid and a seed; no clock.
//!
//! A cell holds 16 + log10 of the largest error at its points, not below 0; 99 stands for a result that is not finite.

use crate::axis_points::logarithmic;
use crate::map_grid::{Measured, NOT_FINITE, Panel, Place, scalar};
use reference::metrics::{MISMATCH, Truth, absolute_error, complex};
use reference::registry::{Call, Function, Precision, function};

/// Added to the logarithm of an error.
pub const SHIFT: f64 = 16.0;

/// The methods of the mean over a footprint on its map, in the order of the columns.
pub const FOOTPRINT_METHODS: [&str; 4] = ["as_printed", "vwh18", "coarse", "accurate"];
/// Footprint over coherence area, A_P/A_C = a1 a2/sigma^2.
pub const AREA_RATIO: [f64; 2] = [1e-2, 1e3];
/// Half axis along the scratch over half axis across it.
pub const ASPECT: [f64; 2] = [0.02, 50.0];
/// Distance of the scratch from the centre in coherence radii.
pub const OFFSET: [f64; 2] = [0.0, 6.0];
/// Aspect of the footprint on each row of the map; the first runs over all of [`ASPECT`], with the scratch at the centre.
pub const ASPECTS: [Option<f64>; 3] = [None, Some(1.0), Some(50.0)];
/// The error, in per cent of the value at the centre, that counts as worthless on the map of the footprint.
pub const WORTHLESS: f64 = 10.0;
const RADIUS: f64 = 10.0;

/// The methods of the triangle on its map: name and precision, in the order of the columns.
pub const TRIANGLE_METHODS: [(&str, Precision); 4] = [
    ("as_printed", Precision::F64),
    ("as_printed_mended", Precision::F64),
    ("accurate", Precision::F64),
    ("accurate", Precision::F32),
];
/// Width of the groove, gamma_i + gamma_o and wavelength.
pub const GROOVE: [f64; 3] = [2.0, 1.8, 0.55];
/// Depth of the groove.
pub const DEPTH: [f64; 2] = [0.0, 1.0];
/// The direction cosine across the groove.
pub const ACROSS: [f64; 2] = [0.0, 2.0];
/// Relative distance from the pole xi2 = 2 D (gamma_i + gamma_o)/W.
pub const FROM_POLE: [f64; 2] = [1e-16, 1.0];

/// The methods of a sphere's light on its map, in the order of the columns.
pub const LIGHT_METHODS: [&str; 4] = ["as_printed", "vwh18", "chord", "within_1e-3"];
/// Angular radius of the light in degrees.
pub const LIGHT_RADIUS: [f64; 2] = [0.03, 60.0];
/// Distance of the light's edge from the line xi1 = 0 in standard deviations of the band; negative over the light.
pub const EDGE: [f64; 2] = [-8.0, 4.0];
/// Radius of coherence, wavelength and width of the scratch on the map of lights.
pub const LIGHT_SCRATCH: [f64; 3] = [30.0, 0.55, 2.5];
/// The tangent component of the view, and the bitangent cosine xi2 of the light's centre.
const LIGHT_VIEW: [f64; 2] = [-0.2, 0.08];
/// Elevation of the light on the two rows of the map: of its centre in degrees, or in its own radii.
pub const HIGH: f64 = 60.0;
/// In its own radii, of the second row.
pub const LOW: f64 = 0.3;

/// 16 + log10 of the error of a call as a multiple of the function's scale.
fn score(function: &Function, call: &Call, row: &[f64]) -> f64 {
    let rounded: Vec<f64> = match call.precision() {
        Precision::F64 => row.to_vec(),
        Precision::F32 => row.iter().map(|&x| f64::from(x as f32)).collect(),
    };
    let result = call.evaluate(&rounded);
    let error = match (function.truth(&rounded), result.as_slice()) {
        (Truth::Real(truth), &[x]) => absolute_error(x, &truth),
        (Truth::Complex(truth), &[re, im]) => complex::absolute_error([re, im], &truth),
        _ => f64::NAN,
    };
    let scale = function.peak.map_or(1.0, |peak| (peak.of)(&rounded));
    if error >= MISMATCH {
        NOT_FINITE
    } else if error == 0.0 {
        0.0
    } else {
        (SHIFT + libm::log10(error / scale)).clamp(0.0, 98.0)
    }
}

/// The map of the footprint: one column a method, one row of panels for each of [`ASPECTS`].
pub fn footprint() -> Result<Vec<Panel>, String> {
    let function = function("footprint_mean").ok_or("the footprint is not registered")?;
    let mut calls = Vec::new();
    for row in 0..ASPECTS.len() {
        for (i, name) in FOOTPRINT_METHODS.into_iter().enumerate() {
            let found = scalar(function.name, name, Precision::F64);
            calls.extend(found.map(|m| (row * FOOTPRINT_METHODS.len() + i, m.call)));
        }
    }
    let row = |panel: usize, [s, t]: [f64; 2]| {
        let ratio = logarithmic(AREA_RATIO, s);
        let (aspect, offset) = match ASPECTS[panel / FOOTPRINT_METHODS.len()] {
            None => (logarithmic(ASPECT, t), 0.0),
            Some(aspect) => (aspect, OFFSET[0] + t * (OFFSET[1] - OFFSET[0])),
        };
        let axes = [ratio * aspect, ratio / aspect].map(|square| RADIUS * libm::sqrt(square));
        vec![axes[0], axes[1], 1.0, RADIUS * offset, RADIUS]
    };
    let measured = Measured {
        score: |call: &Call, row: &[f64]| score(function, call, row),
        row,
        more: |_| Vec::<Place>::new(),
        worthless: |_| SHIFT + libm::log10(0.01 * WORTHLESS),
    };
    Ok(measured.panels(&calls))
}

/// The map of the triangle: one column a method, first over direction and depth, then around the pole.
pub fn triangle() -> Result<Vec<Panel>, String> {
    let function = function("profile_triangle").ok_or("the triangle is not registered")?;
    let mut calls = Vec::new();
    for window in 0..2 {
        for (i, (name, precision)) in TRIANGLE_METHODS.into_iter().enumerate() {
            let found = scalar(function.name, name, precision);
            calls.extend(found.map(|m| (window * TRIANGLE_METHODS.len() + i, m.call)));
        }
    }
    let [width, gamma_sum, wavelength] = GROOVE;
    let row = |panel: usize, [s, t]: [f64; 2]| {
        let depth = DEPTH[0] + t * (DEPTH[1] - DEPTH[0]);
        let xi2 = if panel < TRIANGLE_METHODS.len() {
            ACROSS[0] + s * (ACROSS[1] - ACROSS[0])
        } else {
            2.0 * depth * gamma_sum / width * (1.0 + logarithmic(FROM_POLE, s))
        };
        vec![width, depth, xi2, gamma_sum, wavelength]
    };
    let measured = Measured {
        score: |call: &Call, row: &[f64]| score(function, call, row),
        row,
        more: |_| Vec::<Place>::new(),
        worthless: |_| SHIFT + libm::log10(0.01 * WORTHLESS),
    };
    Ok(measured.panels(&calls))
}

/// The row of a sphere's light: its angular radius, the distance of its edge from the line, its place in the sky.
fn light_row(radius: f64, edge: f64, low: bool) -> Vec<f64> {
    let [sigma, lambda, width] = LIGHT_SCRATCH;
    let [view_t, xi2] = LIGHT_VIEW;
    let alpha = radius.to_radians();
    let deviation = lambda / (std::f64::consts::TAU * sigma * std::f64::consts::SQRT_2);
    // The edge nearest to the line lies alpha from the centre; a small light has its centre on the line at most.
    let from_line = (alpha + libm::asin(edge * deviation - view_t)).max(libm::asin(-view_t));
    let (x, rest) = (libm::sin(from_line), libm::cos(from_line));
    let elevation = if low { LOW * alpha } else { HIGH.to_radians() };
    let y = rest * libm::cos(elevation);
    let z = rest * libm::sin(elevation);
    let view_b = (xi2 - y).max(-0.97);
    vec![sigma, lambda, width, view_t, view_b, x, y, z, libm::sin(alpha)]
}

/// The map of a sphere's light: one column a method, high in the sky and at the horizon.
pub fn light() -> Result<Vec<Panel>, String> {
    let function = function("sphere_light").ok_or("the sphere is not registered")?;
    let mut calls = Vec::new();
    for window in 0..2 {
        for (i, name) in LIGHT_METHODS.into_iter().enumerate() {
            let found = scalar(function.name, name, Precision::F64);
            calls.extend(found.map(|m| (window * LIGHT_METHODS.len() + i, m.call)));
        }
    }
    let row = |panel: usize, [s, t]: [f64; 2]| {
        let edge = EDGE[0] + t * (EDGE[1] - EDGE[0]);
        light_row(logarithmic(LIGHT_RADIUS, s), edge, panel >= LIGHT_METHODS.len())
    };
    let measured = Measured {
        score: |call: &Call, row: &[f64]| score(function, call, row),
        row,
        more: |_| Vec::<Place>::new(),
        worthless: |_| SHIFT + libm::log10(0.01 * WORTHLESS),
    };
    Ok(measured.panels(&calls))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn worst(panels: &[Panel], number: usize) -> f64 {
        let panel = panels.iter().find(|p| p.number == number).expect("measured");
        libm::pow(10.0, panel.most() - SHIFT)
    }

    #[test]
    fn the_printed_blend_lacks_pi_where_the_footprint_is_small_and_the_mended_one_is_worst_along_the_scratch() {
        let panels = footprint().expect("registered");
        let of = |row: usize, method: &str| {
            let column = FOOTPRINT_METHODS.iter().position(|m| *m == method).expect("a column");
            row * FOOTPRINT_METHODS.len() + column
        };
        // A_P -> 0: the printed value is 1/pi of the truth; at A_P = A_C/100 the first term adds to it.
        let printed = panels
            .iter()
            .find(|p| p.number == of(1, "as_printed"))
            .expect("measured");
        let corner = libm::pow(10.0, printed.cells[0] - SHIFT);
        assert!((corner - (1.0 - 1.0 / std::f64::consts::PI)).abs() < 0.04, "{corner}");
        let mended = panels.iter().find(|p| p.number == of(1, "vwh18")).expect("measured");
        assert!(libm::pow(10.0, mended.cells[0] - SHIFT) < 0.1);
        assert!(
            worst(&panels, of(2, "vwh18")) > 4.0,
            "{}",
            worst(&panels, of(2, "vwh18"))
        );
        for row in 0..ASPECTS.len() {
            assert!(worst(&panels, of(row, "coarse")) <= 1e-3);
            assert!(worst(&panels, of(row, "accurate")) <= 1e-12);
        }
    }

    #[test]
    fn the_form_with_poles_loses_digits_beside_them_and_all_on_them_and_the_stable_form_none() {
        let panels = triangle().expect("registered");
        let beside = |column: usize| worst(&panels, TRIANGLE_METHODS.len() + column);
        assert!(worst(&panels, 0) > 0.5, "as printed: {}", worst(&panels, 0));
        let poles = panels
            .iter()
            .find(|p| p.number == TRIANGLE_METHODS.len() + 1)
            .expect("measured");
        let without = poles.cells.iter().filter(|c| **c == NOT_FINITE).count();
        let spoilt = poles.cells.iter().filter(|c| **c > SHIFT - 10.0).count();
        assert!(without > 10 && spoilt > 200, "{without} {spoilt}");
        assert!(beside(2) <= 1e-14, "{}", beside(2));
        assert!(beside(3) <= 1e-6, "{}", beside(3));
    }

    #[test]
    fn the_published_light_fails_at_edges_and_away_from_the_mirror_and_ours_nowhere() {
        let panels = light().expect("registered");
        for window in 0..2 {
            let of = |method: usize| window * LIGHT_METHODS.len() + method;
            let gone = |method| {
                panels
                    .iter()
                    .find(|p| p.number == of(method))
                    .expect("measured")
                    .hopeless
            };
            assert!(
                gone(0) > 50.0 && gone(1) > 30.0 && gone(2) > 5.0,
                "{} {} {}",
                gone(0),
                gone(1),
                gone(2)
            );
            assert!(worst(&panels, of(3)) <= 1e-3, "{}", worst(&panels, of(3)));
        }
    }
}
