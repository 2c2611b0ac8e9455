//! The key below a chart of error against time: what shapes, fills and lines mean, and what each method is.

use super::marker::{self, Marker};
use super::palette;
use super::svg::{Align, Font, Svg, text_width};
use crate::ledger::Entry;
use reference::registry::{Origin, Precision};

/// Secondary text.
pub const SMALL: Font = Font {
    size: 11.5,
    color: palette::FAINT_INK,
    bold: false,
};

/// Height of one row of methods.
pub const KEY_ROW: f64 = 19.0;

/// The text beside a point: method, precision where both are in play, and `slice` for the slice form.
pub fn point_name(entry: &Entry) -> String {
    let base = entry.method.replace('_', " ");
    let slice = if entry.call == "slice" && !base.contains("slice") {
        ", slice"
    } else {
        ""
    };
    let single = if entry.precision == Precision::F32 { " f32" } else { "" };
    format!("{base}{single}{slice}")
}

/// The key: shapes and lines in one row, then what each method is, in two columns.
pub fn draw(svg: &mut Svg, top: f64, keyed: &[&&Entry]) {
    let mut x = 34.0;
    let mut item = |svg: &mut Svg, look: Option<Marker>, dash: Option<&str>, text: &str| {
        if let Some(look) = look {
            marker::draw(svg, [x, top], look);
            x += 13.0;
        }
        if let Some(dash) = dash {
            let (color, width) = if dash.is_empty() {
                (palette::FRONT, 4.0)
            } else {
                (palette::SCALAR_FRONT, 1.6)
            };
            svg.line([x - 6.0, top], [x + 22.0, top], color, width, dash);
            x += 29.0;
        }
        svg.text([x, top + 4.0], text, SMALL, Align::Start);
        x += text_width(text, SMALL) + 22.0;
    };
    let look = |origin, precision, slice| {
        Some(Marker {
            origin,
            precision,
            slice,
        })
    };
    item(svg, look(Origin::Ours, Precision::F64, false), None, "ours");
    item(svg, look(Origin::Published, Precision::F64, false), None, "published");
    item(svg, look(Origin::Peer, Precision::F64, false), None, "peer");
    item(svg, look(Origin::Ours, Precision::F32, false), None, "hollow: f32");
    item(svg, look(Origin::Ours, Precision::F64, true), None, "ring: slices");
    item(svg, None, Some(""), "front");
    item(svg, None, Some("7 4"), "front of scalar calls");
    let rows = keyed.len().div_ceil(2);
    for (i, e) in keyed.iter().enumerate() {
        let at = [
            if i < rows { 34.0 } else { 500.0 },
            top + 32.0 + KEY_ROW * (i % rows) as f64,
        ];
        marker::draw(
            svg,
            at,
            Marker {
                origin: e.origin,
                precision: e.precision,
                slice: e.call == "slice",
            },
        );
        let room = 430.0;
        let mut text = format!("{}: {}", point_name(e), e.label);
        while text_width(&text, SMALL) > room {
            text.pop();
            if text_width(&format!("{text}..."), SMALL) <= room {
                text.push_str("...");
                break;
            }
        }
        svg.text([at[0] + 13.0, at[1] + 4.0], &text, SMALL, Align::Start);
    }
}
