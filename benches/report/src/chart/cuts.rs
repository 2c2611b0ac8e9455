//! Radiance of one scratch along two cuts of the hemisphere: closed forms over the transform, their differences below.

use super::axis::Axis;
use super::palette;
use super::svg::{Align, Font, Rect, Svg};
use crate::fourier_figures::Direction;

const TITLE: Font = Font {
    size: 17.0,
    color: palette::INK,
    bold: true,
};
const PANEL: Font = Font {
    size: 13.0,
    color: palette::INK,
    bold: true,
};
const SMALL: Font = Font {
    size: 11.5,
    color: palette::FAINT_INK,
    bold: false,
};
/// Decades of radiance and of error below the peak.
const RADIANCE: [f64; 2] = [1e-9, 2.0];
const ERROR: [f64; 2] = [1e-9, 1.0];
const ANALYTIC: &str = "#cc4b00";
const EXACT: &str = "#0064a8";
const FOURIER: &str = "#b9bdb6";

/// Points of a curve, broken where the value leaves the axis below.
fn curve(svg: &mut Svg, x: Axis, y: Axis, points: &[[f64; 2]], color: &str, width: f64) {
    for run in points.chunk_by(|a, b| (a[1] >= y.values[0]) == (b[1] >= y.values[0])) {
        if run[0][1] >= y.values[0] && run.len() > 1 {
            let line: Vec<[f64; 2]> = run.iter().map(|p| [x.at(p[0]), y.at(p[1])]).collect();
            svg.polyline(&line, color, width, "");
        }
    }
}

/// The chart: one column a cut; `names` of the cuts.
pub fn draw(title: &str, lines: &[String], names: [&str; 2], directions: &[Direction]) -> String {
    let mut svg = Svg::new(960.0, 690.0, title);
    svg.text([24.0, 34.0], title, TITLE, Align::Start);
    for (i, line) in lines.iter().enumerate() {
        svg.text([24.0, 57.0 + 17.0 * i as f64], line, SMALL, Align::Start);
    }
    let peak = directions.iter().map(|d| d.fourier).fold(0.0, f64::max);
    for (cut, name) in names.into_iter().enumerate() {
        let x0 = 84.0 + 440.0 * cut as f64;
        let frames = [[150.0, 400.0], [430.0, 590.0]].map(|[y0, y1]| Rect {
            x0,
            y0,
            x1: x0 + 400.0,
            y1,
        });
        let found: Vec<&Direction> = directions.iter().filter(|d| d.cut == cut).collect();
        let points =
            |of: &dyn Fn(&Direction) -> f64| -> Vec<[f64; 2]> { found.iter().map(|d| [d.xi, of(d) / peak]).collect() };
        let worst = |of: &dyn Fn(&Direction) -> f64| points(of).iter().map(|p| p[1]).fold(0.0, f64::max);
        let (papers, window) = (
            |d: &Direction| (d.analytic - d.fourier).abs(),
            |d: &Direction| (d.exact - d.fourier).abs(),
        );
        svg.text([x0, 122.0], name, PANEL, Align::Start);
        let text = format!(
            "largest difference: {:.1e} closed form, {:.1e} with the window across",
            worst(&papers),
            worst(&window)
        );
        svg.text([x0, 139.0], &text, SMALL, Align::Start);
        let x = Axis {
            values: [-1.0, 1.0],
            pixels: [x0, x0 + 400.0],
            logarithmic: false,
        };
        for (i, (frame, values)) in frames.into_iter().zip([RADIANCE, ERROR]).enumerate() {
            let y = Axis {
                values,
                pixels: [frame.y1, frame.y0],
                logarithmic: true,
            };
            let label = match (cut, i) {
                (0, 0) => "radiance/peak",
                (0, _) => "difference/peak",
                _ => "",
            };
            y.draw_left(&mut svg, frame, label, 2, 1.0, true);
            if i == 0 {
                curve(&mut svg, x, y, &points(&|d| d.fourier), FOURIER, 5.0);
                curve(&mut svg, x, y, &points(&|d| d.analytic), ANALYTIC, 1.6);
                curve(&mut svg, x, y, &points(&|d| d.exact), EXACT, 1.0);
            } else {
                x.draw_below(&mut svg, frame, "direction cosine", 1, 0.5, false);
                curve(&mut svg, x, y, &points(&papers), ANALYTIC, 1.2);
                curve(&mut svg, x, y, &points(&window), EXACT, 1.2);
            }
            svg.path(
                &format!("M{} {}H{}V{}H{}z", frame.x0, frame.y0, frame.x1, frame.y1, frame.x0),
                &format!("fill=\"none\" stroke=\"{}\" stroke-width=\"1\"", palette::INK),
            );
        }
    }
    for (i, (color, width, name)) in [
        (FOURIER, 5.0, "Fourier transform of the raster"),
        (ANALYTIC, 1.6, "closed form of the papers"),
        (EXACT, 1.0, "closed form with the window across the width"),
    ]
    .into_iter()
    .enumerate()
    {
        let x = 84.0 + 270.0 * i as f64;
        svg.line([x, 662.0], [x + 26.0, 662.0], color, width, "");
        svg.text([x + 33.0, 666.0], name, SMALL, Align::Start);
    }
    svg.finish()
}
