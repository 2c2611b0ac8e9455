//! Failure map: relative error of the arc integral over start and length as colour, wrong signs hatched, the published
//! method beside ours.

use super::axis::{Axis, TICK, power_of_ten};
use super::palette;
use super::svg::{Align, Font, Rect, Svg};
use crate::series::{Cell, LENGTH_RANGE, MAP, START_RANGE};

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
/// Decades of error from the palest to the darkest colour.
const DECADES: [i32; 2] = [-17, 5];

fn shade(error: f64) -> usize {
    let e = if error > 0.0 {
        libm::floor(libm::log10(error)) as i32
    } else {
        DECADES[0]
    };
    (e.clamp(DECADES[0], DECADES[1] - 1) - DECADES[0]) as usize
}

fn shades() -> usize {
    (DECADES[1] - DECADES[0]) as usize
}

fn color(shade: usize) -> String {
    palette::ramp(shade as f64 / (shades() - 1) as f64)
}

/// The two panels with colour bar and caption. `cause` says why the published method fails.
pub fn draw(title: &str, cause: [&str; 2], cells: &[Cell]) -> String {
    let frames = [
        Rect {
            x0: 84.0,
            y0: 132.0,
            x1: 454.0,
            y1: 470.0,
        },
        Rect {
            x0: 484.0,
            y0: 132.0,
            x1: 854.0,
            y1: 470.0,
        },
    ];
    let mut svg = Svg::new(960.0, 560.0, title);
    svg.define(&format!(
        "<pattern id=\"negative\" width=\"5\" height=\"5\" patternUnits=\"userSpaceOnUse\" patternTransform=\"rotate(45)\">\
         <path d=\"M0 0V5\" stroke=\"{}\" stroke-width=\"2.6\"/></pattern>",
        palette::WRONG_SIGN
    ));
    svg.text([24.0, 34.0], title, TITLE, Align::Start);
    svg.text([24.0, 57.0], cause[0], SMALL, Align::Start);
    svg.text([24.0, 74.0], cause[1], SMALL, Align::Start);
    let names = ["VWH18 Eq. 27 with the fit of Eq. 29", "sinc_squared_integral"];
    for (side, (frame, name)) in frames.into_iter().zip(names).enumerate() {
        let pick = |c: &Cell| if side == 0 { c.published } else { c.ours };
        svg.text([frame.x0, frame.y0 - 26.0], name, PANEL, Align::Start);
        let worst = cells.iter().map(|c| pick(c).0).fold(0.0, f64::max);
        let wrong = cells.iter().filter(|c| pick(c).1).count() as f64 / cells.len() as f64;
        let sign = if wrong > 0.0 {
            format!("wrong sign in {:.1} % of cells", 100.0 * wrong)
        } else {
            "never negative".to_string()
        };
        let found = format!("largest error {}, {sign}", power_text(worst));
        svg.text([frame.x0, frame.y0 - 10.0], &found, SMALL, Align::Start);
        panel(&mut svg, frame, cells, pick);
        let x = Axis {
            values: START_RANGE,
            pixels: [frame.x0, frame.x1],
            logarithmic: true,
        };
        let y = Axis {
            values: LENGTH_RANGE,
            pixels: [frame.y1, frame.y0],
            logarithmic: true,
        };
        x.draw_below(&mut svg, frame, "start of the arc, q0", 1, 1.0, false);
        if side == 0 {
            y.draw_left(&mut svg, frame, "length of the arc", 1, 1.0, false);
        }
        svg.path(
            &format!("M{} {}H{}V{}H{}z", frame.x0, frame.y0, frame.x1, frame.y1, frame.x0),
            &format!("fill=\"none\" stroke=\"{}\" stroke-width=\"1\"", palette::INK),
        );
    }
    color_bar(
        &mut svg,
        Rect {
            x0: 876.0,
            y0: 132.0,
            x1: 896.0,
            y1: 470.0,
        },
    );
    let patch = Rect {
        x0: 84.0,
        y0: 527.0,
        x1: 112.0,
        y1: 543.0,
    };
    svg.rect(patch, &color(shades() - 4), None);
    svg.rect(patch, "url(#negative)", None);
    let text = "hatched: a negative result, so negative radiance, at one of the cell's points; the true integral is positive everywhere";
    svg.text([122.0, 539.0], text, SMALL, Align::Start);
    svg.finish()
}

fn power_text(value: f64) -> String {
    if value == 0.0 {
        return "0".to_string();
    }
    let e = libm::floor(libm::log10(value)) as i32;
    format!("{:.1}\u{00d7}10^{e}^", value / power_of_ten(e))
}

/// One path for each shade, runs of equal cells in a row joined; one hatched path on top.
fn panel(svg: &mut Svg, frame: Rect, cells: &[Cell], pick: impl Fn(&Cell) -> (f64, bool)) {
    let [columns, rows] = MAP;
    let (w, h) = (
        (frame.x1 - frame.x0) / columns as f64,
        (frame.y1 - frame.y0) / rows as f64,
    );
    let mut paths = vec![String::new(); shades()];
    let mut hatched = String::new();
    let class = |i: usize, r: usize| {
        let (error, wrong) = pick(&cells[r * columns + i]);
        (shade(error), wrong)
    };
    for r in 0..rows {
        let y = frame.y1 - (r + 1) as f64 * h;
        for layer in 0..2 {
            let same = |a: usize, b: usize| {
                if layer == 0 {
                    class(a, r).0 == class(b, r).0
                } else {
                    class(a, r).1 == class(b, r).1
                }
            };
            let mut start = 0;
            while start < columns {
                let mut end = start + 1;
                while end < columns && same(start, end) {
                    end += 1;
                }
                let run = format!(
                    "M{:.1} {y:.1}H{:.1}v{h:.2}H{:.1}z",
                    frame.x0 + start as f64 * w,
                    frame.x0 + end as f64 * w,
                    frame.x0 + start as f64 * w
                );
                if layer == 0 {
                    paths[class(start, r).0].push_str(&run);
                } else if class(start, r).1 {
                    hatched.push_str(&run);
                }
                start = end;
            }
        }
    }
    for (i, d) in paths.iter().enumerate().filter(|(_, d)| !d.is_empty()) {
        let fill = color(i);
        svg.path(d, &format!("fill=\"{fill}\" stroke=\"{fill}\" stroke-width=\"0.4\""));
    }
    if !hatched.is_empty() {
        svg.path(&hatched, "fill=\"url(#negative)\"");
    }
}

fn color_bar(svg: &mut Svg, bar: Rect) {
    let step = (bar.y1 - bar.y0) / shades() as f64;
    for i in 0..shades() {
        let y1 = bar.y1 - i as f64 * step;
        svg.rect(
            Rect {
                x0: bar.x0,
                y0: y1 - step - 0.3,
                x1: bar.x1,
                y1,
            },
            &color(i),
            None,
        );
    }
    for e in (DECADES[0]..=DECADES[1]).filter(|e| e.rem_euclid(4) == 0) {
        let y = bar.y1 - f64::from(e - DECADES[0]) * step;
        svg.line([bar.x1, y], [bar.x1 + 5.0, y], palette::INK, 1.0, "");
        let text = if e == 0 { "1".to_string() } else { format!("10^{e}^") };
        svg.text([bar.x1 + 9.0, y + 4.0], &text, TICK, Align::Start);
    }
    svg.path(
        &format!("M{} {}H{}V{}H{}z", bar.x0, bar.y0, bar.x1, bar.y1, bar.x0),
        &format!("fill=\"none\" stroke=\"{}\" stroke-width=\"1\"", palette::INK),
    );
    let at = [bar.x0, bar.y0 - 10.0];
    svg.text(at, "rel. error", SMALL, Align::Start);
}
