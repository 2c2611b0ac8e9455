//! Everything that is drawn from committed numbers: charts and the generated parts of pages. No measurement, no clock.

use crate::chart::digits::{self, Frame, Measure, Scale};
use crate::chart::{error_time, failures, light_sizes, ulp};
use crate::ledger::Entry;
use crate::map_grid::{self, Panel};
use crate::{digit_map, fourier_figures, light_figures};
use crate::{names, pages, run, series, tables};
use reference::registry::Precision;
use std::path::{Path, PathBuf};

mod scratch_maps;

/// A file's path below the root and its text.
pub type File = (PathBuf, String);

/// Numbers behind charts and tables.
pub struct Numbers {
    /// The ledger.
    pub entries: Vec<Entry>,
    /// CSV of the ulp plot.
    pub ulp: String,
    /// CSV of the failure map.
    pub map: String,
    /// CSV of the ulp plot of the scaled Bessel function, once measured.
    pub bessel_ulp: Option<String>,
    /// CSV of the cuts of one scratch's lobe, once measured.
    pub one_scratch: Option<String>,
    /// CSV of the samples that Monte Carlo needs by the size of a light, once measured.
    pub light_sizes: Option<String>,
    /// Path and CSV of each map of panels, once measured.
    pub panels: Vec<(&'static str, String)>,
}

impl Numbers {
    /// The CSV of the map of panels at a path.
    pub fn map_of(&self, path: &str) -> Option<&str> {
        let found = self.panels.iter().find(|(known, _)| *known == path);
        found.map(|(_, csv)| csv.as_str())
    }
}

/// Why the published arc loses its digits and its sign; the caption of the failure map.
const CAUSE: [&str; 2] = [
    "Cause: cancellation. The published fit of Si is off by a bias that does not cancel between the two ends of an arc,",
    "and its antiderivative is not monotone; away from the peak the difference is smaller than the bias, or negative.",
];

/// What draws a map.
type Drawing = fn(&[Panel], &[Entry]) -> String;
/// The maps of panels: where the numbers lie, the name of the picture, what draws it.
const MAPS: [(&str, &str, Drawing); 6] = [
    (run::PLANE, "failures/faddeeva_w", plane),
    (run::PHASE, "failures/spatial_phase_vwh18", phase),
    (run::TEN, "charts/ten_scratches_wvjh17", scratch_maps::ten_scratches),
    (run::FOOTPRINT, "failures/footprint_mean_vwh18", scratch_maps::footprint),
    (
        run::TRIANGLE,
        "failures/profile_triangle_wvjh17",
        scratch_maps::triangle,
    ),
    (run::LIGHT, "failures/sphere_light_vwh18", scratch_maps::light),
];

/// All charts.
pub fn charts(numbers: &Numbers) -> Result<Vec<File>, String> {
    let entries = &numbers.entries;
    let mut files = Vec::new();
    for (function, title) in [
        ("sine_integral", "Sine integral: error against time"),
        (
            "sinc_squared_integral",
            "Integral of sinc\u{b2} over an arc: error against time",
        ),
        ("faddeeva_w", "Faddeeva function w(z): error against time"),
        ("erf_complex", "Complex error function: error against time"),
        ("erf", "Error function on the real line: error against time"),
        ("erf_difference_scaled", "Scaled erf difference: error against time"),
        ("bessel_i0_scaled", "Scaled Bessel function I0: error against time"),
        ("spatial_phase", "Spatial phase of a finite scratch: error against time"),
        (
            "profile_rectangle",
            "Transform of a rectangular profile: error against time",
        ),
        (
            "profile_triangle",
            "Transform of a triangular profile: error against time",
        ),
        (
            "footprint_mean",
            "Mean over the footprint of a pixel: error against time",
        ),
        (
            "sphere_light",
            "Light of a sphere over a scratch lobe: error against time",
        ),
        (
            "polygon_light",
            "Light of a polygon over a scratch lobe: error against time",
        ),
    ] {
        if !entries.iter().any(|e| e.function == function && e.ns > 0.0) {
            continue;
        }
        let text = error_time::draw(function, title, entries)?;
        files.push((PathBuf::from(format!("docs/charts/{function}_error_time.svg")), text));
    }
    for (function, csv) in [
        ("sine_integral", Some(&numbers.ulp)),
        ("bessel_i0_scaled", numbers.bessel_ulp.as_ref()),
    ] {
        let Some(csv) = csv else { continue };
        let (bins, peer) = series::read_ulp(csv)?;
        let words = entries
            .iter()
            .find(|e| e.function == function && e.method == peer)
            .map_or(peer.clone(), |e| e.label.clone());
        let text = ulp::draw(&format!("{function} in f64: error over x"), &bins, &words);
        files.push((PathBuf::from(format!("docs/charts/{function}_ulp.svg")), text));
    }
    if let Some(csv) = &numbers.one_scratch {
        let text = scratch_maps::one_scratch(&fourier_figures::read(csv)?);
        files.push((PathBuf::from("docs/charts/one_scratch_wvjh17.svg"), text));
    }
    if let (Some(csv), Some(times)) = (&numbers.light_sizes, light_times(entries)) {
        let text = light_sizes::draw(&light_figures::read(csv)?, times);
        files.push((PathBuf::from("docs/charts/sphere_light_monte_carlo.svg"), text));
    }
    for (path, name, draw) in MAPS {
        if let Some(csv) = numbers.map_of(path) {
            let text = draw(&map_grid::read(csv)?, entries);
            files.push((PathBuf::from(format!("docs/{name}.svg")), text));
        }
    }
    let cells = series::read_map(&numbers.map)?;
    let title = "Relative error of the sinc\u{b2} arc: the published fit and ours";
    let text = failures::draw(title, CAUSE, &cells);
    files.push((PathBuf::from("docs/failures/sinc_squared_integral_vwh18.svg"), text));
    Ok(files)
}

/// The times of one sample of the cone, of one of the Gaussian, and of a sphere's light to the error of the comparison.
pub fn light_times(entries: &[Entry]) -> Option<[f64; 3]> {
    let time = |method: &str| {
        let mut found = entries.iter().filter(|e| e.function == "sphere_light" && e.ns > 0.0);
        found
            .find(|e| e.method == method && e.precision == Precision::F64)
            .map(|e| e.ns)
    };
    // What 240 samples more cost: no sample pays for the set-up of its light.
    let sample = |many: &str, few: &str| Some((time(many)? - time(few)?) / 240.0);
    Some([
        sample("monte_carlo_256", "monte_carlo_16")?,
        sample("importance_256", "importance_16")?,
        time("within_1e-2")?,
    ])
}

const LOGARITHM: Scale = Scale {
    range: [0.0, 0.0],
    logarithmic: true,
    step: 3.0,
    name: "",
};

/// The map of w: the linear window of every method above its logarithmic one.
fn plane(panels: &[Panel], entries: &[Entry]) -> String {
    let mut frames = Vec::new();
    for window in 0..2 {
        for (i, method) in digit_map::W_METHODS.into_iter().enumerate() {
            let number = 2 * i + window;
            let label = entries
                .iter()
                .find(|e| e.function == "faddeeva_w" && e.method == method)
                .map_or(method.to_string(), |e| e.label.clone());
            let most = panels.iter().find(|p| p.number == number).map(Panel::most);
            let found = most.map_or(String::new(), |most| format!("at most {most:.1} digits lost"));
            let [x, y] = if window == 0 {
                let linear = |range, step, name| Scale {
                    range,
                    logarithmic: false,
                    step,
                    name,
                };
                let [x, y] = digit_map::LINEAR;
                [linear(x, 2.0, "Re z"), linear(y, 4.0, "Im z")]
            } else {
                let [x, y] = digit_map::LOGARITHMIC;
                [
                    Scale {
                        range: x,
                        name: "Re z",
                        ..LOGARITHM
                    },
                    Scale {
                        range: y,
                        name: "Im z",
                        ..LOGARITHM
                    },
                ]
            };
            frames.push(Frame {
                number,
                lines: [label, found],
                x,
                y,
            });
        }
    }
    let cause = [
        "Pole: the zeros of w are poles of its relative error, 2 exp(-z\u{b2}) and w(-z) cancel there: dots below the real axis, first row, all peers.",
        "Cancellation: z\u{b2} is rounded before its exponential: the box up to Re z = 6 (errorfunctions, libcerf) and the lower edge (all peers), first row.",
        "Truncation: a continued fraction ends a term early: at |z| = 4000 and |z| = 10^7^, second row, errorfunctions and libcerf.",
        "Wrong branch: not even Im w of a real argument is right where Im z/Re z < 10^-8^, second row, puruspe. Overflow: none in these windows.",
    ];
    digits::draw(
        "Digits of w(z) lost, by norm",
        &cause.map(String::from),
        &frames,
        panels,
        Measure::Digits,
    )
}

/// The map of the spatial phase: as printed above ours.
fn phase(panels: &[Panel], _: &[Entry]) -> String {
    let mut frames = Vec::new();
    let mut shares = Vec::new();
    for (i, (method, precision)) in digit_map::PHASE_METHODS.into_iter().enumerate() {
        for (j, sigma) in digit_map::SIGMAS.into_iter().enumerate() {
            let number = 2 * i + j;
            let name = if precision == Precision::F64 { "f64" } else { "f32" };
            let share = panels.iter().find(|p| p.number == number);
            let share = share.map(|p| p.hopeless);
            let ours = method == "accurate";
            if let (Some(share), false) = (share, ours) {
                shares.push(format!("{share:.1} % ({name}, {sigma} \u{3bc}m)"));
            }
            let what = if ours { "ours" } else { "as printed" };
            frames.push(Frame {
                number,
                lines: [
                    format!("{what}, {name}, {sigma} \u{3bc}m"),
                    share.map_or(String::new(), |s| format!("all digits lost on {s:.1} %")),
                ],
                x: Scale {
                    range: digit_map::COSINE,
                    logarithmic: false,
                    step: 0.25,
                    name: "\u{3be}\u{2081}",
                },
                y: Scale {
                    range: digit_map::LENGTH,
                    step: 1.0,
                    name: "length of the scratch in \u{3bc}m",
                    ..LOGARITHM
                },
            });
        }
    }
    let cause = [
        "Cause: overflow. exp(-b\u{b2}) is 0 where erf(a + ib) is infinite; b = \u{3c3} k \u{3be}\u{2081}/\u{221a}2 grows with the coherence radius \u{3c3}.".to_string(),
        format!(
            "As printed (first row), at a wavelength of {} \u{3bc}m, all digits are lost on this share of the hemisphere:",
            digit_map::WAVELENGTH
        ),
        format!("{}.", shares.join(", ")),
        "Cancellation: ours (second row) loses digits between the lobes of a short scratch, where the phase has zeros.".to_string(),
    ];
    digits::draw(
        "Digits of the spatial phase lost: VWH18 Eq. 5 as printed, and ours",
        &cause,
        &frames,
        panels,
        Measure::Digits,
    )
}

/// The share of the hemisphere on which the spatial phase loses all digits, as a table: one row a coherence radius.
fn phase_shares(panels: &[Panel]) -> String {
    let named = |(method, precision): (&str, Precision)| {
        let whose = if method == "accurate" { "ours" } else { "as printed" };
        format!("{whose}, {}", names::precision(precision))
    };
    let heads: Vec<String> = digit_map::PHASE_METHODS.into_iter().map(named).collect();
    let mut text = format!(
        "| coherence radius | {} |\n|---|{}\n",
        heads.join(" | "),
        "---|".repeat(heads.len())
    );
    for (j, sigma) in digit_map::SIGMAS.into_iter().enumerate() {
        text.push_str(&format!("| {sigma} um |"));
        for i in 0..heads.len() {
            let panel = panels.iter().find(|p| p.number == 2 * i + j);
            let share = panel.map_or("not measured".to_string(), |p| format!("{:.1} %", p.hopeless));
            text.push_str(&format!(" {share} |"));
        }
        text.push('\n');
    }
    text
}

/// A generated part of a page, by name: `spatial_phase_digits` from its map, all others from the ledger.
fn part(name: &str, numbers: &Numbers) -> Result<String, String> {
    match (name, numbers.map_of(run::PHASE)) {
        ("spatial_phase_digits", Some(csv)) => Ok(phase_shares(&map_grid::read(csv)?)),
        ("spatial_phase_digits", None) => Ok(phase_shares(&[])),
        _ => tables::table(name, &numbers.entries),
    }
}

/// All pages below the root that carry generated parts, renewed.
pub fn renewed_pages(root: &Path, numbers: &Numbers) -> Result<Vec<File>, String> {
    let mut files = Vec::new();
    for path in pages::files(root).map_err(|e| e.to_string())? {
        let text = std::fs::read_to_string(root.join(&path)).map_err(|e| format!("{}: {e}", path.display()))?;
        if text.contains("<!-- report:") {
            let new =
                pages::renew(&text, |name| part(name, numbers)).map_err(|e| format!("{}: {e}", path.display()))?;
            files.push((path, new));
        }
    }
    Ok(files)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_shares_of_the_hemisphere_stand_under_their_method_and_radius() {
        let panels: Vec<Panel> = (0..7)
            .map(|number| Panel {
                number,
                cells: Vec::new(),
                hopeless: 10.0 * number as f64,
            })
            .collect();
        let text = phase_shares(&panels);
        let lines: Vec<&str> = text.lines().collect();
        assert_eq!(
            lines[0],
            "| coherence radius | as printed, f64 | as printed, f32 | ours, f64 | ours, f32 |"
        );
        assert_eq!(lines[2], "| 60 um | 0.0 % | 20.0 % | 40.0 % | 60.0 % |");
        assert_eq!(lines[3], "| 10 um | 10.0 % | 30.0 % | 50.0 % | not measured |");
    }
}
