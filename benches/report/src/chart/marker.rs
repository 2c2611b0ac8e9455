//! Markers of points: shape and colour by origin, hollow for f32, a ring for slice forms.

use super::palette;
use super::svg::{Rect, Svg};
use reference::registry::{Origin, Precision};

/// Half the side of the box around a marker, ring included.
pub const HALF: f64 = 8.0;

/// The look of a point.
#[derive(Clone, Copy, Debug)]
pub struct Marker {
    /// Colour and shape: circle for ours, square for published, triangle for peers.
    pub origin: Origin,
    /// Filled for f64, hollow for f32.
    pub precision: Precision,
    /// With a ring around it.
    pub slice: bool,
}

/// The box a marker fills.
pub fn extent(at: [f64; 2], slice: bool) -> Rect {
    let half = if slice { HALF } else { 6.0 };
    Rect::around(at, [half, half])
}

/// Draws a marker.
pub fn draw(svg: &mut Svg, at: [f64; 2], marker: Marker) {
    let color = palette::origin(marker.origin);
    let [x, y] = at;
    let d = match marker.origin {
        Origin::Ours => circle(at, 5.0),
        Origin::Published => format!("M{:.2} {:.2}h9v9h-9z", x - 4.5, y - 4.5),
        Origin::Peer => format!("M{x:.2} {:.2}l5.4 9.6h-10.8z", y - 5.6),
    };
    let fill = if marker.precision == Precision::F64 {
        color
    } else {
        palette::CARD
    };
    svg.path(&d, &format!("fill=\"{fill}\" stroke=\"{color}\" stroke-width=\"1.8\""));
    if marker.slice {
        svg.path(
            &circle(at, 7.5),
            &format!("fill=\"none\" stroke=\"{color}\" stroke-width=\"1\""),
        );
    }
}

fn circle([x, y]: [f64; 2], r: f64) -> String {
    format!(
        "M{:.2} {y:.2}a{r} {r} 0 1 0 {:.2} 0a{r} {r} 0 1 0 -{:.2} 0z",
        x - r,
        2.0 * r,
        2.0 * r
    )
}
