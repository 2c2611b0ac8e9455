//! The frames of the maps of scratches: the mean over a footprint, the triangular groove, the figures of WVJH17.

use super::LOGARITHM;
use crate::chart::cuts;
use crate::chart::digits::{self, Frame, Measure, Scale};
use crate::error_map::{self, ASPECTS, FOOTPRINT_METHODS, LIGHT_METHODS, SHIFT, TRIANGLE_METHODS, WORTHLESS};
use crate::fourier_figures::Direction;
use crate::ledger::Entry;
use crate::map_grid::{NOT_FINITE, Panel};
use crate::names;
use crate::tables::short;

const LINEAR: Scale = Scale {
    range: [0.0, 0.0],
    logarithmic: false,
    step: 1.0,
    name: "",
};

/// The largest error of a panel, in words; `percent` for errors of the size of the result.
fn largest(panels: &[Panel], number: usize, percent: bool) -> String {
    let Some(panel) = panels.iter().find(|p| p.number == number) else {
        return String::new();
    };
    let lost = panel.cells.iter().filter(|c| **c == NOT_FINITE).count();
    if lost > 0 {
        return format!("not finite in {lost} cells");
    }
    let error = libm::pow(10.0, panel.most() - SHIFT);
    if percent && error >= 0.01 {
        return format!("error up to {:.0} %", 100.0 * error);
    }
    let text = short(error);
    match text.split_once('e') {
        Some((digits, exponent)) => format!("error up to {digits}\u{d7}10^{exponent}^"),
        None => format!("error up to {text}"),
    }
}

/// The map of the footprint: aspect above, offset below.
pub fn footprint(panels: &[Panel], _: &[Entry]) -> String {
    let mut frames = Vec::new();
    let mut shares = Vec::new();
    for (i, aspect) in ASPECTS.into_iter().enumerate() {
        for (j, method) in FOOTPRINT_METHODS.into_iter().enumerate() {
            let number = i * FOOTPRINT_METHODS.len() + j;
            let shape = match aspect {
                None => "offset 0".to_string(),
                Some(1.0) => "circle".to_string(),
                Some(aspect) => format!("{aspect}:1 along"),
            };
            let whose = match method {
                "as_printed" => "Eq. 16",
                "vwh18" => "Eq. 16 with \u{3c0}",
                "coarse" => "ours, 10^-3^",
                _ => "ours, 10^-12^",
            };
            if method == "vwh18" && aspect.is_some() {
                let share = panels.iter().find(|p| p.number == number).map_or(0.0, |p| p.hopeless);
                shares.push(format!("{share:.0} % ({shape})"));
            }
            let y = match aspect {
                None => Scale {
                    range: error_map::ASPECT,
                    step: 1.0,
                    name: "half axis along/half axis across",
                    ..LOGARITHM
                },
                Some(_) => Scale {
                    range: error_map::OFFSET,
                    name: "offset of the scratch/\u{3c3}",
                    ..LINEAR
                },
            };
            frames.push(Frame {
                number,
                lines: [format!("{whose}, {shape}"), largest(panels, number, true)],
                x: Scale {
                    range: error_map::AREA_RATIO,
                    step: 1.0,
                    name: "footprint/coherence area",
                    ..LOGARITHM
                },
                y,
            });
        }
    }
    let cause = [
        "Error as a multiple of the mean of a scratch through the centre, over the ratio of areas A_P/A_C = a1 a2/\u{3c3}\u{b2}.".to_string(),
        "Missing factor: the second term of Eq. 16 lacks \u{3c0}, so a small footprint keeps 1/\u{3c0} of its value: first column, left."
            .to_string(),
        "Wrong variable: Eq. 16 blends by A_P/A_C, the mean depends on the half width across the scratch alone: second column."
            .to_string(),
        format!(
            "With \u{3c0} restored, the error exceeds {WORTHLESS} % on this share of the map: {}.",
            shares.join(", ")
        ),
    ];
    digits::draw(
        "Error of the mean over a footprint: VWH18 Eq. 16, and ours",
        &cause,
        &frames,
        panels,
        Measure::Errors,
    )
}

/// The map of the triangle: over the direction, and around the pole.
pub fn triangle(panels: &[Panel], _: &[Entry]) -> String {
    let mut frames = Vec::new();
    for window in 0..2 {
        for (j, (method, precision)) in TRIANGLE_METHODS.into_iter().enumerate() {
            let number = window * TRIANGLE_METHODS.len() + j;
            let whose = match method {
                "as_printed" => "as printed".to_string(),
                "as_printed_mended" => "misprints mended".to_string(),
                _ => format!("ours, {}", names::precision(precision)),
            };
            let x = if window == 0 {
                Scale {
                    range: error_map::ACROSS,
                    step: 0.5,
                    name: "\u{3be}\u{2082}",
                    ..LINEAR
                }
            } else {
                Scale {
                    range: error_map::FROM_POLE,
                    step: 4.0,
                    name: "distance from the pole",
                    ..LOGARITHM
                }
            };
            frames.push(Frame {
                number,
                lines: [whose, largest(panels, number, false)],
                x,
                y: Scale {
                    range: error_map::DEPTH,
                    step: 0.2,
                    name: "depth in \u{3bc}m",
                    ..LINEAR
                },
            });
        }
    }
    let [width, gamma_sum, wavelength] = error_map::GROOVE;
    let cause = [
        format!(
            "Error as a multiple of the width; a groove {width} \u{3bc}m wide, \u{3b3}\u{1d62} + \u{3b3}\u{2092} = {gamma_sum}, a wavelength of {wavelength} \u{3bc}m."
        ),
        "Misprints: the first exponential of Eq. 29 lacks the width, and the phase of Eq. 28 has the other sign: first column.".to_string(),
        "Pole: 1/(\u{3be}\u{2082} - 2 D (\u{3b3}\u{1d62} + \u{3b3}\u{2092})/W) meets a zero of its bracket: digits cancel beside it, and on it the result is 0/0: second row.".to_string(),
    ];
    digits::draw(
        "Error of the triangular groove: WVJH17 Eqs. 29 to 31, and ours",
        &cause,
        &frames,
        panels,
        Measure::Errors,
    )
}

/// The map of a sphere's light: high in the sky above, at the horizon below.
pub fn light(panels: &[Panel], _: &[Entry]) -> String {
    let mut frames = Vec::new();
    let mut shares = Vec::new();
    for window in 0..2 {
        for (j, method) in LIGHT_METHODS.into_iter().enumerate() {
            let number = window * LIGHT_METHODS.len() + j;
            let whose = match method {
                "as_printed" => "as printed",
                "vwh18" => "roots mended",
                "chord" => "+ cone, Si",
                _ => "ours, 10^-3^",
            };
            if window == 0 && method != "within_1e-3" {
                let share = panels.iter().find(|p| p.number == number).map_or(0.0, |p| p.hopeless);
                shares.push(format!("{share:.0} % ({whose})"));
            }
            let place = ["high", "low"][window];
            frames.push(Frame {
                number,
                lines: [format!("{whose}, {place}"), largest(panels, number, true)],
                x: Scale {
                    range: error_map::LIGHT_RADIUS,
                    step: 1.0,
                    name: "radius of the light in degrees",
                    ..LOGARITHM
                },
                y: Scale {
                    range: error_map::EDGE,
                    step: 2.0,
                    name: "its edge, in deviations of the band",
                    ..LINEAR
                },
            });
        }
    }
    let [sigma, lambda, width] = error_map::LIGHT_SCRATCH;
    let cause = [
        format!(
            "Error over the value, or over 0.001 of the whole plane's; \u{3c3} = {sigma} \u{3bc}m, \u{3bb} = {lambda} \u{3bc}m, W = {width} \u{3bc}m. Edge below 0: the line lies over the light."
        ),
        "Roots: Eq. 35 takes an inverse for the second root: first column. Si: the fit of Eq. 29 does not cancel over a small light's chord. Disc".to_string(),
        "for cone: Eq. 31 is up to a third too narrow: second column. Edge in the band, tangency: one chord stands for all of a light, or for".to_string(),
        format!("none of it: third column, above -3. High, off by more than {WORTHLESS} %: {}.", shares.join(", ")),
    ];
    digits::draw(
        "Error of a sphere's light: VWH18 3.4.1, and ours",
        &cause,
        &frames,
        panels,
        Measure::Errors,
    )
}

/// One scratch, cut along and across it (WVJH17 Fig. 13).
pub fn one_scratch(directions: &[Direction]) -> String {
    let lines = [
        "Radiance of a scratch 2 \u{3bc}m wide and 0.2 \u{3bc}m deep at normal incidence, \u{3c3} = 10 \u{3bc}m, \u{3bb} = 0.55 \u{3bc}m, against the Fourier",
        "transform of the rasterised transfer function. The papers' closed form has no window across the width of the scratch.",
    ];
    cuts::draw(
        "One scratch, closed form against Fourier transform (WVJH17 Fig. 13)",
        &lines.map(String::from),
        ["along the scratch", "across the scratch"],
        directions,
    )
}

/// Ten scratches over the hemisphere (WVJH17 Fig. 14).
pub fn ten_scratches(panels: &[Panel], _: &[Entry]) -> String {
    let axis = |name| Scale {
        range: [-1.0, 1.0],
        step: 0.5,
        name,
        ..LINEAR
    };
    let frame = |number: usize| {
        let name = ["closed form", "Fourier transform", "difference", "with crossings"][number];
        let found = if number < 2 {
            "radiance/peak".to_string()
        } else {
            largest(panels, number, true).replace("error", "difference")
        };
        Frame {
            number,
            lines: [name.to_string(), found],
            x: axis("\u{3be}\u{2081}"),
            y: axis("\u{3be}\u{2082}"),
        }
    };
    let cause = [
        "Ten random scratches, 1 to 3 \u{3bc}m wide, 0.2 \u{3bc}m deep; \u{3c3} = 10 \u{3bc}m, \u{3bb} = 0.55 \u{3bc}m, normal incidence. The papers' sum leaves out",
        "that scratches cross: third panel. The fourth panel has the term of each crossing pair, and none where three or more meet.",
    ];
    digits::draw(
        "Ten scratches, closed form against Fourier transform (WVJH17 Fig. 14)",
        &cause.map(String::from),
        &(0..4).map(frame).collect::<Vec<_>>(),
        panels,
        Measure::Shares,
    )
}
