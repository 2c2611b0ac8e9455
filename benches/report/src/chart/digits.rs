//! Maps of digits lost, small multiples: colour for the digits, red for results that are not finite, grey where the truth
//! is beyond the range of f64.

use super::axis::{Axis, TICK};
use super::palette;
use super::svg::{Align, Font, Rect, Svg};
use crate::error_map;
use crate::map_grid::{CELLS, NOT_FINITE, Panel};
use std::fmt::Write;

const TITLE: Font = Font {
    size: 17.0,
    color: palette::INK,
    bold: true,
};
const PANEL: Font = Font {
    size: 12.0,
    color: palette::INK,
    bold: true,
};
const SMALL: Font = Font {
    size: 11.5,
    color: palette::FAINT_INK,
    bold: false,
};
/// Digits of the darkest colour.
const MOST: usize = 16;
const UNKNOWN: &str = "#c9ced6";
/// Less than one digit.
const NONE: &str = "#fdf7d0";
/// Places on the ramp of one, two and three digits; the rest share what is left of it.
const FIRST: [f64; 3] = [0.0, 0.28, 0.5];

/// How the colours stand for the values of cells.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Measure {
    /// Digits lost, one a step.
    Digits,
    /// Errors as a multiple of a scale: 16 and their logarithm.
    Errors,
    /// Radiances and errors as shares of a peak, in the same way, on square panels.
    Shares,
}

/// Powers of ten at which the colour of an error changes.
const STEPS: [f64; 14] = [
    -15.0, -12.0, -9.0, -7.0, -6.0, -5.0, -4.0, -3.0, -2.0, -1.5, -1.0, -0.5, 0.0, 0.5,
];
/// The same for shares of a peak.
const SHARES: [f64; 14] = [
    -8.0, -7.0, -6.5, -6.0, -5.5, -5.0, -4.5, -4.0, -3.5, -3.0, -2.5, -2.0, -1.0, -0.5,
];
/// What stands under those steps.
const SHARE_NAMES: [&str; 14] = [
    "10^-8^", "10^-7^", "", "10^-6^", "", "10^-5^", "", "10^-4^", "", "10^-3^", "", "10^-2^", "10^-1^", "",
];
/// What stands under the steps.
const STEP_NAMES: [&str; 14] = [
    "10^-15^", "", "10^-9^", "", "10^-6^", "", "", "10^-3^", "10^-2^", "", "10^-1^", "", "1", "",
];

/// What stands around one panel.
pub struct Frame {
    /// Number of the panel.
    pub number: usize,
    /// Two lines above it.
    pub lines: [String; 2],
    /// Horizontal axis: range, logarithmic or not, step of ticks, name.
    pub x: Scale,
    /// Vertical axis.
    pub y: Scale,
}

/// An axis of a panel.
#[derive(Clone, Copy)]
pub struct Scale {
    /// Values at its ends.
    pub range: [f64; 2],
    /// Logarithmic or linear.
    pub logarithmic: bool,
    /// Step of the ticks: in decades, or in units.
    pub step: f64,
    /// Its name.
    pub name: &'static str,
}

fn class(value: f64, measure: Measure) -> usize {
    if value.is_nan() {
        MOST + 2
    } else if value >= NOT_FINITE {
        MOST + 1
    } else if measure != Measure::Digits {
        let steps = if measure == Measure::Errors { STEPS } else { SHARES };
        steps.iter().filter(|step| value - error_map::SHIFT >= **step).count()
    } else {
        (value as usize).min(MOST)
    }
}

fn color(class: usize, measure: Measure) -> String {
    match class {
        c if c == MOST + 2 => UNKNOWN.to_string(),
        c if c == MOST + 1 => palette::WRONG_SIGN.to_string(),
        0 => NONE.to_string(),
        c if measure != Measure::Digits => palette::ramp((c - 1) as f64 / (STEPS.len() - 1) as f64),
        c => {
            let last = FIRST.len();
            let rest = || 0.62 + 0.38 * (c - 1 - last) as f64 / (MOST - 1 - last) as f64;
            palette::ramp(FIRST.get(c - 1).copied().unwrap_or_else(rest))
        }
    }
}

/// The figure: frames in rows of four, one for each panel.
pub fn draw(title: &str, cause: &[String], frames: &[Frame], panels: &[Panel], measure: Measure) -> String {
    let (width, gap, left) = (176.0, 44.0, 74.0);
    // A hemisphere is a circle.
    let height = if measure == Measure::Shares { width } else { 236.0 };
    let top = 104.0 + 17.0 * cause.len() as f64;
    let pitch = height + 110.0;
    let rows = frames.len().div_ceil(4);
    let bottom = top + pitch * rows as f64;
    let mut svg = Svg::new(960.0, bottom + 20.0, title);
    svg.text([24.0, 34.0], title, TITLE, Align::Start);
    for (i, line) in cause.iter().enumerate() {
        svg.text([24.0, 57.0 + 17.0 * i as f64], line, SMALL, Align::Start);
    }
    for (i, frame) in frames.iter().enumerate() {
        let x0 = left + (width + gap) * (i % 4) as f64;
        let y0 = top + pitch * (i / 4) as f64;
        let rect = Rect {
            x0,
            y0,
            x1: x0 + width,
            y1: y0 + height,
        };
        svg.text([x0, y0 - 26.0], &frame.lines[0], PANEL, Align::Start);
        svg.text([x0, y0 - 10.0], &frame.lines[1], SMALL, Align::Start);
        if let Some(panel) = panels.iter().find(|p| p.number == frame.number) {
            fill(&mut svg, rect, panel, measure);
        } else {
            svg.text(
                [x0 + 0.5 * width, y0 + 0.5 * height],
                "not measured",
                SMALL,
                Align::Middle,
            );
        }
        let axis = |scale: Scale, pixels: [f64; 2]| Axis {
            values: scale.range,
            pixels,
            logarithmic: scale.logarithmic,
        };
        let every = |scale: Scale| scale.step as i32;
        let (x, y) = (frame.x, frame.y);
        axis(x, [rect.x0, rect.x1]).draw_below(&mut svg, rect, x.name, every(x).max(1), x.step, false);
        let name = if i % 4 == 0 { y.name } else { "" };
        axis(y, [rect.y1, rect.y0]).draw_left(&mut svg, rect, name, every(y).max(1), y.step, false);
        outline(&mut svg, rect);
    }
    match measure {
        Measure::Digits => key(&mut svg, bottom - 20.0),
        Measure::Errors => error_key(&mut svg, bottom - 20.0, "error", STEP_NAMES),
        Measure::Shares => error_key(&mut svg, bottom - 20.0, "of peak", SHARE_NAMES),
    }
    svg.finish()
}

fn outline(svg: &mut Svg, r: Rect) {
    svg.path(
        &format!("M{} {}H{}V{}H{}z", r.x0, r.y0, r.x1, r.y1, r.x0),
        &format!("fill=\"none\" stroke=\"{}\" stroke-width=\"1\"", palette::INK),
    );
}

/// One path for each colour, runs of equal cells in a row joined.
fn fill(svg: &mut Svg, frame: Rect, panel: &Panel, measure: Measure) {
    let [columns, rows] = CELLS;
    let (w, h) = (
        (frame.x1 - frame.x0) / columns as f64,
        (frame.y1 - frame.y0) / rows as f64,
    );
    let mut paths = vec![String::new(); MOST + 3];
    for (r, cells) in panel.cells.chunks_exact(columns).enumerate() {
        let y = frame.y1 - (r + 1) as f64 * h;
        let mut start = 0;
        for run in cells.chunk_by(|a, b| class(*a, measure) == class(*b, measure)) {
            let from = frame.x0 + start as f64 * w;
            let to = from + run.len() as f64 * w;
            let _ = write!(
                paths[class(run[0], measure)],
                "M{from:.1} {y:.1}H{to:.1}v{h:.2}H{from:.1}z"
            );
            start += run.len();
        }
    }
    for (i, d) in paths.iter().enumerate().filter(|(_, d)| !d.is_empty()) {
        let fill = color(i, measure);
        svg.path(d, &format!("fill=\"{fill}\" stroke=\"{fill}\" stroke-width=\"0.4\""));
    }
}

fn key(svg: &mut Svg, y: f64) {
    let step = 18.0;
    let patch = |x: f64| Rect {
        x0: x,
        y0: y,
        x1: x + step,
        y1: y + 14.0,
    };
    svg.text([74.0, y + 11.0], "digits lost", SMALL, Align::Start);
    for i in 0..=MOST {
        let r = patch(150.0 + step * i as f64);
        svg.rect(r, &color(i, Measure::Digits), None);
        if i % 4 == 0 {
            svg.text([0.5 * (r.x0 + r.x1), y + 28.0], &i.to_string(), TICK, Align::Middle);
        }
    }
    for (x, class, text) in [
        (500.0, MOST + 1, "result not finite"),
        (650.0, MOST + 2, "truth beyond the range of f64"),
    ] {
        svg.rect(patch(x), &color(class, Measure::Digits), None);
        svg.text([x + step + 7.0, y + 11.0], text, SMALL, Align::Start);
    }
}

/// The key of a map of errors: the colours side by side, the powers of ten where they change.
fn error_key(svg: &mut Svg, y: f64, name: &str, names: [&str; 14]) {
    let step = 30.0;
    svg.text([74.0, y + 11.0], name, SMALL, Align::Start);
    for i in 0..=STEPS.len() {
        let x0 = 124.0 + step * i as f64;
        let r = Rect {
            x0,
            y0: y,
            x1: x0 + step,
            y1: y + 14.0,
        };
        svg.rect(r, &color(i, Measure::Errors), None);
        if i > 0 && !names[i - 1].is_empty() {
            svg.text([x0, y + 29.0], names[i - 1], TICK, Align::Middle);
        }
    }
    if name != "error" {
        return;
    }
    let r = Rect {
        x0: 620.0,
        y0: y,
        x1: 638.0,
        y1: y + 14.0,
    };
    svg.rect(r, &color(MOST + 1, Measure::Errors), None);
    svg.text([645.0, y + 11.0], "result not finite", SMALL, Align::Start);
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn more_digits_lost_are_darker_and_the_first_steps_differ_most() {
        let light = |c: usize, measure| {
            let text = color(c, measure);
            let part = |i: usize| f64::from(u8::from_str_radix(&text[i..i + 2], 16).expect("two hex digits"));
            0.2126 * part(1) + 0.7152 * part(3) + 0.0722 * part(5)
        };
        let digits = Measure::Digits;
        let steps: Vec<f64> = (0..MOST).map(|c| light(c, digits) - light(c + 1, digits)).collect();
        assert!(steps.iter().all(|step| *step > 2.0), "{steps:?}");
        assert!(steps[..3].iter().all(|step| *step > 18.0), "{steps:?}");
        let errors = Measure::Errors;
        let steps = (0..STEPS.len()).map(|c| light(c, errors) - light(c + 1, errors));
        assert!(steps.into_iter().all(|step| step > 5.0));
        assert_eq!(color(0, digits), NONE);
        assert_eq!(
            (class(0.9, digits), class(1.0, digits), class(40.0, digits)),
            (0, 1, MOST)
        );
        let of = |error: f64| class(16.0 + libm::log10(error), errors);
        assert_eq!((of(1e-16), of(2e-15), of(4.7), of(1.5)), (0, 1, 14, 13));
    }
}
