//! Error against time, log-log, one point a method, with the Pareto fronts of all calls and of scalar calls.

use super::axis::{Axis, power_of_ten};
use super::key::{self, KEY_ROW, SMALL, point_name};
use super::labels::{Fixed, Label, Segment, place};
use super::marker::{self, Marker};
use super::palette;
use super::svg::{Align, Font, Rect, Svg, text_width};
use crate::front::front;
use crate::ledger::{Entry, charted_error};

const LABEL: Font = Font {
    size: 12.0,
    color: palette::INK,
    bold: false,
};
const TITLE: Font = Font {
    size: 17.0,
    color: palette::INK,
    bold: true,
};
const WIDTH: f64 = 960.0;
const LEFT: f64 = 84.0;
const RIGHT: f64 = 800.0;
const TOP: f64 = 84.0;
/// Share of the height for results without a correct digit.
const STRIP: f64 = 0.28;

/// Horizontal lines: value and text.
fn references() -> [(f64, &'static str); 3] {
    [
        (1.0 / 510.0, "half an 8-bit step"),
        (f64::from(f32::EPSILON), "f32 eps"),
        (f64::EPSILON, "f64 eps"),
    ]
}

/// Whether a method's error is as large as the result itself.
fn is_hopeless(e: &Entry) -> bool {
    e.charted() >= 1.0 || e.charted().is_nan()
}

/// The text of an error too large for the axis.
fn size_text(error: f64) -> String {
    if error >= 1e300 || error.is_nan() {
        return "not finite".to_string();
    }
    let exponent = libm::floor(libm::log10(error)) as i32;
    if exponent < 3 {
        return format!("{error:.1}");
    }
    format!("{:.0}\u{00d7}10^{exponent}^", error / power_of_ten(exponent))
}

/// The chart of one function, or what is missing for it. The error is [`Entry::charted`].
pub fn draw(function: &str, title: &str, entries: &[Entry]) -> Result<String, String> {
    let shown: Vec<&Entry> = entries
        .iter()
        .filter(|e| e.function == function && e.ns.is_finite() && e.ns > 0.0)
        .collect();
    if shown.is_empty() {
        return Err(format!("no timed method of {function}"));
    }
    for height in [470.0, 560.0, 680.0, 820.0, 1000.0] {
        if let Some(svg) = draw_at(height, title, &shown) {
            return Ok(svg);
        }
    }
    Err(format!("no room for the labels of {function}"))
}

struct Plot {
    frame: Rect,
    strip: Rect,
    x: Axis,
    y: Axis,
}

impl Plot {
    fn new(height: f64, shown: &[&Entry]) -> Self {
        let overflow = shown.iter().any(|e| is_hopeless(e));
        let strip_height = if overflow { STRIP * height } else { 0.0 };
        let frame = Rect {
            x0: LEFT,
            y0: TOP,
            x1: RIGHT,
            y1: TOP + height,
        };
        let strip = Rect {
            y1: TOP + strip_height,
            ..frame
        };
        let log = |v: f64| libm::log10(v);
        let times = shown.iter().map(|e| log(e.ns));
        let lo = times.clone().fold(f64::INFINITY, f64::min) - 0.18;
        let hi = times.fold(f64::NEG_INFINITY, f64::max) + 0.35;
        let x = Axis {
            values: [libm::pow(10.0, lo), libm::pow(10.0, hi)],
            pixels: [LEFT, RIGHT],
            logarithmic: true,
        };
        let least = shown
            .iter()
            .map(|e| e.charted())
            .filter(|e| *e > 0.0)
            .fold(f64::EPSILON, f64::min);
        let bottom = libm::floor(log(least) - 0.4);
        let y = Axis {
            values: [libm::pow(10.0, bottom), 1.0],
            pixels: [frame.y1, strip.y1],
            logarithmic: true,
        };
        Self { frame, strip, x, y }
    }

    /// Place of a point; in the strip, the larger errors stand higher.
    fn at(&self, e: &Entry) -> [f64; 2] {
        let y = if is_hopeless(e) {
            let size = if e.charted().is_nan() { f64::MAX } else { e.charted() };
            let t = (libm::log10(1.0 + libm::log10(size)) / libm::log10(309.0)).clamp(0.0, 1.0);
            self.strip.y1 - 14.0 - t * (self.strip.y1 - self.strip.y0 - 40.0)
        } else {
            self.y.at(e.charted())
        };
        [self.x.at(e.ns), y]
    }

    fn staircase(&self, shown: &[&Entry], scalar_only: bool) -> Vec<[f64; 2]> {
        let candidates: Vec<&Entry> = shown
            .iter()
            .filter(|e| !scalar_only || e.call == "scalar")
            .copied()
            .collect();
        let points: Vec<[f64; 2]> = candidates.iter().map(|e| [e.ns, e.charted()]).collect();
        let mut line: Vec<[f64; 2]> = Vec::new();
        for i in front(&points) {
            let p = self.at(candidates[i]);
            if let Some(last) = line.last().copied() {
                line.push([p[0], last[1]]);
            } else {
                line.push([p[0], self.frame.y0]);
            }
            line.push(p);
        }
        if let Some(last) = line.last().copied() {
            line.push([self.frame.x1, last[1]]);
        }
        line
    }
}

fn pieces(line: &[[f64; 2]]) -> Vec<Segment> {
    line.windows(2).map(|w| Segment { a: w[0], b: w[1] }).collect()
}

fn draw_at(height: f64, title: &str, shown: &[&Entry]) -> Option<String> {
    let error = charted_error(&shown.first()?.function);
    let plot = Plot::new(height, shown);
    let frame = plot.frame;
    let all = plot.staircase(shown, false);
    let scalar = plot.staircase(shown, true);
    let mut segments: Vec<Segment> = pieces(&all).into_iter().chain(pieces(&scalar)).collect();
    for (value, _) in references() {
        let y = plot.y.at(value);
        segments.push(Segment {
            a: [frame.x0, y],
            b: [frame.x1, y],
        });
    }
    if plot.strip.y1 > plot.strip.y0 {
        segments.push(Segment {
            a: [frame.x0, plot.strip.y1],
            b: [frame.x1, plot.strip.y1],
        });
    }
    let names: Vec<String> = shown
        .iter()
        .map(|e| {
            let over = is_hopeless(e);
            if over {
                format!("{} ({})", point_name(e), size_text(e.charted()))
            } else {
                point_name(e)
            }
        })
        .collect();
    let labels: Vec<Label> = shown
        .iter()
        .zip(&names)
        .map(|(e, name)| Label {
            anchor: plot.at(e),
            size: [text_width(name, LABEL), 13.0],
        })
        .collect();
    let rects: Vec<Rect> = shown
        .iter()
        .map(|e| marker::extent(plot.at(e), e.call == "slice"))
        .collect();
    let placed = place(
        &labels,
        &Fixed {
            bounds: frame.grown(-2.0),
            rects,
            segments,
        },
    )?;

    let key_top = frame.y1 + 76.0;
    let keyed: Vec<&&Entry> = shown.iter().filter(|e| e.slice_of.is_empty()).collect();
    let rows = keyed.len().div_ceil(2);
    let mut svg = Svg::new(WIDTH, key_top + 34.0 + KEY_ROW * rows as f64 + 14.0, title);
    svg.text([24.0, 34.0], title, TITLE, Align::Start);
    let sub = format!("{error}, on each method's domain, against time per value; lower left is better");
    svg.text([24.0, 56.0], &sub, SMALL, Align::Start);
    if plot.strip.y1 > plot.strip.y0 {
        svg.rect(plot.strip, "#f3e6df", None);
        let middle = 0.5 * (plot.strip.y0 + plot.strip.y1);
        for (i, line) in ["no correct digit:", "relative error 1 or more"]
            .into_iter()
            .enumerate()
        {
            svg.text(
                [frame.x1 + 8.0, middle - 4.0 + 16.0 * i as f64],
                line,
                SMALL,
                Align::Start,
            );
        }
    }
    plot.x.draw_below(
        &mut svg,
        frame,
        "nanoseconds per value (minimum over many short samples, one core)",
        1,
        1.0,
        true,
    );
    plot.y.draw_left(
        &mut svg,
        Rect {
            y0: plot.strip.y1,
            ..frame
        },
        &error,
        2,
        1.0,
        true,
    );
    for (value, text) in references() {
        let y = plot.y.at(value);
        svg.line([frame.x0, y], [frame.x1, y], palette::REFERENCE, 1.2, "2 3");
        svg.text(
            [frame.x1 + 8.0, y + 4.0],
            text,
            Font {
                color: palette::REFERENCE,
                ..SMALL
            },
            Align::Start,
        );
    }
    svg.polyline(&all, palette::FRONT, 4.0, "");
    svg.polyline(&scalar, palette::SCALAR_FRONT, 1.6, "7 4");
    svg.path(
        &format!("M{} {}H{}V{}H{}z", frame.x0, frame.y0, frame.x1, frame.y1, frame.x0),
        &format!("fill=\"none\" stroke=\"{}\" stroke-width=\"1\"", palette::INK),
    );
    for p in &placed {
        if let Some(l) = p.leader {
            svg.line(l.a, l.b, palette::FAINT_INK, 0.8, "");
        }
    }
    for ((e, name), p) in shown.iter().zip(&names).zip(&placed) {
        let look = Marker {
            origin: e.origin,
            precision: e.precision,
            slice: e.call == "slice",
        };
        marker::draw(&mut svg, plot.at(e), look);
        let font = Font {
            color: palette::origin(e.origin),
            ..LABEL
        };
        svg.text([p.rect.x0, p.rect.y1 - 3.0], name, font, Align::Start);
    }
    key::draw(&mut svg, key_top, &keyed);
    Some(svg.finish())
}
