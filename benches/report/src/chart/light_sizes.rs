//! Monte Carlo's time over that of the closed form at equal error, over the size of the light.

use super::axis::Axis;
use super::palette;
use super::svg::{Align, Font, Rect, Svg};
use crate::light_figures::{EQUAL_ERROR, RADII, Size};

const TITLE: Font = Font {
    size: 17.0,
    color: palette::INK,
    bold: true,
};
const SMALL: Font = Font {
    size: 11.5,
    color: palette::FAINT_INK,
    bold: false,
};
const CONE: &str = "#7a3f8f";
const GAUSSIAN: &str = "#0064a8";

fn label(color: &'static str) -> Font {
    Font {
        size: 13.0,
        color,
        bold: true,
    }
}

/// The chart; `sample` and `ours` are the times of one sample of the cone and of the Gaussian, and of the closed form.
pub fn draw(sizes: &[Size], [cone, gaussian, ours]: [f64; 3]) -> String {
    let mut svg = Svg::new(960.0, 600.0, "Area lights: Monte Carlo's time over ours at equal error");
    svg.text(
        [24.0, 34.0],
        "Area lights: Monte Carlo's time over ours at equal error",
        TITLE,
        Align::Start,
    );
    let worst = sizes.iter().map(|s| s.ours).fold(0.0, f64::max);
    let lines = [
        format!(
            "Time for a standard error of {:.0} % over the mean time of the closed form told that tolerance (largest error here {:.2} %), random spheres",
            100.0 * EQUAL_ERROR,
            100.0 * worst
        ),
        "aimed at the band, of 0.001 of the whole plane's integral or more. Lines: medians; shaded: quartiles. One core, f64; samples from a pilot run.".to_string(),
    ];
    for (i, line) in lines.iter().enumerate() {
        svg.text([24.0, 57.0 + 17.0 * i as f64], line, SMALL, Align::Start);
    }
    let frame = Rect {
        x0: 96.0,
        y0: 96.0,
        x1: 780.0,
        y1: 530.0,
    };
    let series = [
        (CONE, cone / ours, sizes.iter().map(|s| s.cone).collect::<Vec<_>>()),
        (GAUSSIAN, gaussian / ours, sizes.iter().map(|s| s.gaussian).collect()),
    ];
    let ratios = series
        .iter()
        .flat_map(|(_, cost, found)| found.iter().flatten().map(move |n| n * cost));
    let (low, high) = ratios.fold((1.0_f64, 10.0_f64), |(low, high), r| (low.min(r), high.max(r)));
    let x = Axis {
        values: RADII,
        pixels: [frame.x0, frame.x1],
        logarithmic: true,
    };
    let y = Axis {
        values: [0.3 * low, 3.0 * high],
        pixels: [frame.y1, frame.y0],
        logarithmic: true,
    };
    x.draw_below(&mut svg, frame, "angular radius of the light in degrees", 1, 1.0, true);
    y.draw_left(
        &mut svg,
        frame,
        "time of Monte Carlo/time of the closed form",
        1,
        1.0,
        true,
    );
    svg.line(
        [frame.x0, y.at(1.0)],
        [frame.x1, y.at(1.0)],
        palette::REFERENCE,
        1.2,
        "6 4",
    );
    for (color, cost, found) in &series {
        let at = |i: usize, quartile: usize| [x.at(sizes[i].radius), y.at(found[i][quartile] * cost)];
        let count = found.len();
        let edge = (0..count).map(|i| at(i, 0)).chain((0..count).rev().map(|i| at(i, 2)));
        let corners: Vec<String> = edge.map(|[x, y]| format!("{x:.1} {y:.1}")).collect();
        svg.path(
            &format!("M{}Z", corners.join("L")),
            &format!("fill=\"{color}\" fill-opacity=\"0.16\""),
        );
        let line: Vec<[f64; 2]> = (0..count).map(|i| at(i, 1)).collect();
        svg.polyline(&line, color, 2.4, "");
    }
    let names = [["uniform over", "the cone"], ["importance:", "the Gaussian"]];
    for ((color, cost, found), name) in series.iter().zip(names) {
        let end = found.last().map_or(frame.y0, |last| y.at(last[1] * cost));
        for (i, word) in name.into_iter().enumerate() {
            svg.text(
                [frame.x1 + 12.0, end + 15.0 * i as f64],
                word,
                label(color),
                Align::Start,
            );
        }
    }
    svg.text([frame.x1 - 8.0, y.at(1.0) - 6.0], "equal", SMALL, Align::End);
    svg.finish()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_chart_names_both_samplers_and_the_error() {
        let sizes: Vec<Size> = (0..4)
            .map(|i| Size {
                radius: 0.05 * f64::from(1 << (2 * i)),
                cone: [1e2, 1e3, 1e4],
                gaussian: [1e1, 1e2, 1e3],
                ours: 5e-3,
            })
            .collect();
        let svg = draw(&sizes, [40.0, 50.0, 1000.0]);
        for text in ["uniform over", "importance:", "0.50 %", "angular radius"] {
            assert!(svg.contains(text), "{text}");
        }
    }
}
