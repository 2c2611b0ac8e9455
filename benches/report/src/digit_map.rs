//! Maps of digits lost, kept as CSV in `data/charts`: the error of w(z) over the complex plane for every library, and of
//! the finite scratch's spatial phase over the hemisphere. All points follow from the grid and a seed; no clock.
//!
//! A cell holds log10 of the largest relative error in epsilons at its points: its centre, a few random ones, the same for
//! every panel of a place, and on the map of w the f64 nearest to each zero inside it. 0 is one epsilon, 15.65 the whole
//! of f64, 6.92 the whole of f32. 99 stands for a result that is not finite; NaN for a truth beyond the range of f64.

use crate::axis_points::logarithmic;
use crate::map_grid::{Measured, NOT_FINITE, Panel, Place, scalar};
use reference::as_printed::Segment;
use reference::metrics::{MISMATCH, Truth, complex};
use reference::oracle::zeros;
use reference::registry::{Call, Function, Precision, function};
use std::f64::consts::TAU;

/// The methods of w on its map, in the order of the panels.
pub const W_METHODS: [&str; 4] = ["accurate", "errorfunctions", "puruspe", "libcerf"];
/// Linear window: real and imaginary part.
pub const LINEAR: [[f64; 2]; 2] = [[0.0, 8.0], [-8.0, 8.0]];
/// Logarithmic window: real and imaginary part.
pub const LOGARITHMIC: [[f64; 2]; 2] = [[1e-2, 1e10], [1e-12, 1e4]];

/// The methods of the spatial phase on its map: name and precision, in the order of the panels.
pub const PHASE_METHODS: [(&str, Precision); 4] = [
    ("as_printed", Precision::F64),
    ("as_printed", Precision::F32),
    ("accurate", Precision::F64),
    ("accurate", Precision::F32),
];
/// Coherence radii in micrometres: of VWH18, of WVJH17.
pub const SIGMAS: [f64; 2] = [60.0, 10.0];
/// Wavelength in micrometres.
pub const WAVELENGTH: f64 = 0.55;
/// The direction cosine along the scratch; a uniform hemisphere has it uniform.
pub const COSINE: [f64; 2] = [0.0, 1.0];
/// Length of the scratch in micrometres; a quarter of it lies before the window's centre.
pub const LENGTH: [f64; 2] = [1.0, 1e3];

/// Digits of a precision.
pub fn digits(precision: Precision) -> f64 {
    match precision {
        Precision::F64 => -libm::log10(f64::EPSILON),
        Precision::F32 => -libm::log10(f64::from(f32::EPSILON)),
    }
}

fn lost(function: &Function, call: &Call, row: &[f64]) -> f64 {
    let precision = call.precision();
    let rounded: Vec<f64> = match precision {
        Precision::F64 => row.to_vec(),
        Precision::F32 => row.iter().map(|&x| f64::from(x as f32)).collect(),
    };
    let Truth::Complex(truth) = function.truth(&rounded) else {
        return f64::NAN;
    };
    if truth.iter().any(|t| !t.value().is_finite()) {
        return f64::NAN;
    }
    let result = call.evaluate(&rounded);
    let error = complex::eps_error([result[0], result[1]], &truth, precision);
    if error >= MISMATCH {
        NOT_FINITE
    } else {
        // At most 98, so that no finite result is taken for another.
        libm::log10(error.max(1.0)).min(98.0)
    }
}

/// The map of w: two panels a method, the linear window first.
pub fn faddeeva_w() -> Result<Vec<Panel>, String> {
    let function = function("faddeeva_w").ok_or("w is not registered")?;
    let mut calls = Vec::new();
    for (i, name) in W_METHODS.into_iter().enumerate() {
        if let Some(m) = scalar("faddeeva_w", name, Precision::F64) {
            calls.extend([(2 * i, m.call), (2 * i + 1, m.call)]);
        }
    }
    let row = |panel: usize, [s, t]: [f64; 2]| {
        if panel.is_multiple_of(2) {
            let [x, y] = LINEAR;
            vec![x[0] + s * (x[1] - x[0]), y[0] + t * (y[1] - y[0])]
        } else {
            vec![logarithmic(LOGARITHMIC[0], s), logarithmic(LOGARITHMIC[1], t)]
        }
    };
    let near_zeros = |panel: usize| {
        if panel.is_multiple_of(2) {
            zeros_of_w()
        } else {
            Vec::new()
        }
    };
    let measured = Measured {
        score: |call: &Call, row: &[f64]| lost(function, call, row),
        row,
        more: near_zeros,
        worthless: digits,
    };
    Ok(measured.panels(&calls))
}

/// The zeros of w in the linear window, each rounded to f64.
fn zeros_of_w() -> Vec<Place> {
    let [x, y] = LINEAR;
    let place = |zero: &[[f64; 3]; 2]| {
        let [re, im] = [zero[0][0], zero[1][0]];
        ([(re - x[0]) / (x[1] - x[0]), (im - y[0]) / (y[1] - y[0])], vec![re, im])
    };
    zeros::W.iter().map(place).collect()
}

/// The map of the spatial phase: two panels a method, the larger coherence radius first.
pub fn spatial_phase() -> Result<Vec<Panel>, String> {
    let function = function("erf_difference_scaled").ok_or("the erf difference is not registered")?;
    let mut calls = Vec::new();
    for (i, (name, precision)) in PHASE_METHODS.into_iter().enumerate() {
        if let Some(m) = scalar("erf_difference_scaled", name, precision) {
            calls.extend([(2 * i, m.call), (2 * i + 1, m.call)]);
        }
    }
    let row = |panel: usize, [s, t]: [f64; 2]| {
        let length = logarithmic(LENGTH, t);
        let segment = Segment {
            sigma: SIGMAS[panel % 2],
            offset: 0.0,
            ends: [-0.25 * length, 0.75 * length],
        };
        let xi1 = COSINE[0] + s * (COSINE[1] - COSINE[0]);
        segment.arguments(TAU / WAVELENGTH, xi1).to_vec()
    };
    let measured = Measured {
        score: |call: &Call, row: &[f64]| lost(function, call, row),
        row,
        more: |_| Vec::new(),
        worthless: digits,
    };
    Ok(measured.panels(&calls))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::map_grid::{CELLS, cell_of};

    #[test]
    fn each_zero_of_w_darkens_the_cell_it_lies_in() {
        let function = function("faddeeva_w").expect("registered");
        let [accurate, peer] = ["accurate", "errorfunctions"]
            .map(|name| scalar("faddeeva_w", name, Precision::F64).expect("registered").call);
        for (place, z) in zeros_of_w() {
            let cell = cell_of(place);
            let (column, row) = (cell % CELLS[0], cell / CELLS[0]);
            let side = |k: usize, axis: usize| {
                let [lo, hi] = LINEAR[axis];
                lo + k as f64 / CELLS[axis] as f64 * (hi - lo)
            };
            assert!(side(column, 0) <= z[0] && z[0] <= side(column + 1, 0), "{z:?}");
            assert!(side(row, 1) <= z[1] && z[1] <= side(row + 1, 1), "{z:?}");
            assert!(
                lost(function, &peer, &z) > 8.0 && lost(function, &accurate, &z) < 2.0,
                "{z:?}"
            );
        }
        assert_eq!(cell_of([1.0, 1.0]), CELLS[0] * CELLS[1] - 1);
    }

    #[test]
    fn all_digits_are_lost_where_the_published_phase_overflows_and_nowhere_in_ours() {
        for panel in spatial_phase().expect("registered") {
            let (method, precision) = PHASE_METHODS[panel.number / 2];
            let sigma = SIGMAS[panel.number % 2];
            // exp(b^2), b = sigma k xi1/sqrt2, leaves the range of the format here, and exp(-b^2) a little later.
            let range = if precision == Precision::F64 {
                [709.0, 746.0]
            } else {
                [88.0, 104.0]
            };
            let bounds = range.map(|square: f64| square.sqrt() * 2f64.sqrt() / (sigma * TAU / WAVELENGTH));
            if method == "as_printed" {
                let kept = 1.0 - 0.01 * panel.hopeless;
                assert!(
                    (0.9 * bounds[0]..1.1 * bounds[1]).contains(&kept),
                    "{}: {kept} {bounds:?}",
                    panel.number
                );
                assert!(
                    sigma < 60.0 || panel.hopeless > 90.0,
                    "{}: {}",
                    panel.number,
                    panel.hopeless
                );
            } else {
                assert_eq!(panel.hopeless, 0.0, "{}", panel.number);
                assert!(panel.most() < digits(precision), "{}", panel.number);
            }
        }
    }
}
