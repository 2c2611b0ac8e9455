//! Error in ulp over x, of ours and of the best peer, with the conditioning envelope.

use super::axis::Axis;
use super::palette;
use super::svg::{Align, Font, Rect, Svg};
use crate::series::{UlpBin, X_RANGE};
use reference::registry::Origin;
use std::fmt::Write;

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
const ENVELOPE: &str = "#8a6d1f";

/// The chart; `peer` says what the peer is.
pub fn draw(title: &str, bins: &[UlpBin], peer: &str) -> String {
    let frame = Rect {
        x0: 84.0,
        y0: 112.0,
        x1: 936.0,
        y1: 452.0,
    };
    let top = bins
        .iter()
        .map(|b| b.peer.max(b.ours).max(b.envelope))
        .fold(1.0, f64::max);
    let step = if top < 2.0 {
        0.25
    } else if top < 5.0 {
        0.5
    } else {
        (top / 8.0).ceil()
    };
    let y = Axis {
        values: [0.0, (top / step + 0.3).ceil() * step],
        pixels: [frame.y1, frame.y0],
        logarithmic: false,
    };
    let x = Axis {
        values: X_RANGE,
        pixels: [frame.x0, frame.x1],
        logarithmic: true,
    };

    let mut svg = Svg::new(960.0, 514.0, title);
    svg.text([24.0, 34.0], title, TITLE, Align::Start);
    let sub = "one dot for the largest error of each interval of x; 0.5 ulp is a correctly rounded result";
    svg.text([24.0, 56.0], sub, SMALL, Align::Start);
    x.draw_below(&mut svg, frame, "x", 1, 1.0, true);
    y.draw_left(&mut svg, frame, "error in ulp", 1, step, true);

    let mut area = format!("M{:.2} {:.2}", frame.x0, frame.y1);
    for b in bins {
        let _ = write!(area, "L{:.2} {:.2}H{:.2}", x.at(b.x[0]), y.at(b.envelope), x.at(b.x[1]));
    }
    let _ = write!(area, "L{:.2} {:.2}z", frame.x1, frame.y1);
    svg.path(&area, &format!("fill=\"{ENVELOPE}\" fill-opacity=\"0.22\""));
    for (origin, pick) in [
        (Origin::Peer, peer_error as fn(&UlpBin) -> f64),
        (Origin::Ours, own_error),
    ] {
        let mut d = String::new();
        for b in bins {
            let at = [0.5 * (x.at(b.x[0]) + x.at(b.x[1])), y.at(pick(b))];
            let _ = write!(d, "M{:.1} {:.1}h0", at[0], at[1]);
        }
        let color = palette::origin(origin);
        // Where both errors are the same, a rim of the peer's colour shows behind ours.
        let size = if origin == Origin::Ours { 3.4 } else { 5.6 };
        svg.path(
            &d,
            &format!("stroke=\"{color}\" stroke-width=\"{size}\" stroke-linecap=\"round\" fill=\"none\""),
        );
    }
    svg.path(
        &format!("M{} {}H{}V{}H{}z", frame.x0, frame.y0, frame.x1, frame.y1, frame.x0),
        &format!("fill=\"none\" stroke=\"{}\" stroke-width=\"1\"", palette::INK),
    );
    let dot = |svg: &mut Svg, at: [f64; 2], color: &str, size: f64| {
        svg.path(
            &format!("M{} {}h0", at[0], at[1]),
            &format!("stroke=\"{color}\" stroke-width=\"{size}\" stroke-linecap=\"round\" fill=\"none\""),
        );
    };
    dot(&mut svg, [34.0, 80.0], palette::origin(Origin::Ours), 7.0);
    svg.text([45.0, 84.0], "ours", SMALL, Align::Start);
    dot(&mut svg, [104.0, 80.0], palette::origin(Origin::Peer), 7.0);
    svg.text([115.0, 84.0], &format!("best peer: {peer}"), SMALL, Align::Start);
    let patch = Rect {
        x0: 560.0,
        y0: 73.0,
        x1: 584.0,
        y1: 87.0,
    };
    svg.path(
        &format!("M{} {}H{}V{}H{}z", patch.x0, patch.y0, patch.x1, patch.y1, patch.x0),
        &format!("fill=\"{ENVELOPE}\" fill-opacity=\"0.22\""),
    );
    svg.text(
        [592.0, 84.0],
        "conditioning: |x f'(x)/f(x)|/2 + 1/2, input rounded once",
        SMALL,
        Align::Start,
    );
    svg.finish()
}

fn own_error(b: &UlpBin) -> f64 {
    b.ours
}

fn peer_error(b: &UlpBin) -> f64 {
    b.peer
}
