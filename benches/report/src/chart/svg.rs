//! A small SVG writer: shapes and text on a card of its own colour, so that a chart reads the same on a
//! light and on a dark page. Coordinates are written with two decimals, so equal inputs give equal text.

use std::fmt::Write;

/// Axis-aligned box in pixels, y downwards.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rect {
    /// Left edge.
    pub x0: f64,
    /// Top edge.
    pub y0: f64,
    /// Right edge.
    pub x1: f64,
    /// Bottom edge.
    pub y1: f64,
}

impl Rect {
    /// The box of the given half extents around a centre.
    pub fn around(center: [f64; 2], half: [f64; 2]) -> Self {
        Self {
            x0: center[0] - half[0],
            y0: center[1] - half[1],
            x1: center[0] + half[0],
            y1: center[1] + half[1],
        }
    }

    /// The box grown by a margin on every side.
    pub fn grown(self, by: f64) -> Self {
        Self {
            x0: self.x0 - by,
            y0: self.y0 - by,
            x1: self.x1 + by,
            y1: self.y1 + by,
        }
    }

    /// Whether two boxes share inner points.
    pub fn meets(&self, other: &Self) -> bool {
        self.x0 < other.x1 && other.x0 < self.x1 && self.y0 < other.y1 && other.y0 < self.y1
    }

    /// Whether this box lies in another one.
    pub fn is_in(&self, other: &Self) -> bool {
        self.x0 >= other.x0 && self.y0 >= other.y0 && self.x1 <= other.x1 && self.y1 <= other.y1
    }

    /// Whether a point lies in the box.
    pub fn holds(&self, p: [f64; 2]) -> bool {
        self.nearest(p) == p
    }

    /// The point of the box nearest to a point.
    pub fn nearest(&self, p: [f64; 2]) -> [f64; 2] {
        [p[0].clamp(self.x0, self.x1), p[1].clamp(self.y0, self.y1)]
    }
}

/// Where text hangs on its anchor.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Align {
    /// The anchor is the left end.
    Start,
    /// The anchor is the middle.
    Middle,
    /// The anchor is the right end.
    End,
}

/// Style of a line of text.
#[derive(Clone, Copy, Debug)]
pub struct Font {
    /// Size in pixels.
    pub size: f64,
    /// Fill colour.
    pub color: &'static str,
    /// Bold or not.
    pub bold: bool,
}

/// Width in pixels of a line of text in the widest of the listed fonts (DejaVu Sans, Verdana), so that what
/// is laid out here fits in the narrower ones too. `^` toggles raised text of 0.7 the size.
pub fn text_width(text: &str, font: Font) -> f64 {
    let mut raised = false;
    let mut width = 0.0;
    for c in text.chars() {
        if c == '^' {
            raised = !raised;
            continue;
        }
        let em = match c {
            'i' | 'j' | 'l' | '\'' | '|' => 0.30,
            ' ' | '.' | ',' | ':' | ';' => 0.34,
            't' | 'f' | 'r' | '(' | ')' | '[' | ']' | '/' | '-' => 0.42,
            's' | 'c' | 'z' | 'v' | 'x' | 'y' | 'k' | '_' => 0.60,
            'm' | 'M' | 'W' | '@' | '%' => 1.0,
            'w' | '+' | '<' | '>' | '=' | '\u{2264}' | '\u{00d7}' => 0.84,
            'A'..='Z' => 0.76,
            _ => 0.65,
        };
        width += em * if raised { 0.7 } else { 1.0 };
    }
    width * font.size * if font.bold { 1.13 } else { 1.0 }
}

/// A picture in the making.
pub struct Svg {
    body: String,
    definitions: String,
    width: f64,
    height: f64,
    title: String,
}

fn escape(text: &str) -> String {
    text.replace('&', "&amp;")
        .replace('<', "&lt;")
        .replace('>', "&gt;")
        .replace('"', "&quot;")
}

impl Svg {
    /// An empty card with an accessible title.
    pub fn new(width: f64, height: f64, title: &str) -> Self {
        Self {
            body: String::new(),
            definitions: String::new(),
            width,
            height,
            title: escape(title),
        }
    }

    /// Adds an element to the definitions.
    pub fn define(&mut self, element: &str) {
        self.definitions.push_str(element);
        self.definitions.push('\n');
    }

    /// A filled rectangle.
    pub fn rect(&mut self, r: Rect, fill: &str, stroke: Option<&str>) {
        let stroke = stroke.map_or(String::new(), |s| format!(" stroke=\"{s}\""));
        let (w, h) = (r.x1 - r.x0, r.y1 - r.y0);
        let _ = writeln!(
            self.body,
            "<rect x=\"{:.2}\" y=\"{:.2}\" width=\"{w:.2}\" height=\"{h:.2}\" fill=\"{fill}\"{stroke}/>",
            r.x0, r.y0
        );
    }

    /// A straight line; `dash` is the SVG dash pattern, empty for a solid line.
    pub fn line(&mut self, a: [f64; 2], b: [f64; 2], stroke: &str, width: f64, dash: &str) {
        self.polyline(&[a, b], stroke, width, dash);
    }

    /// A line through points.
    pub fn polyline(&mut self, points: &[[f64; 2]], stroke: &str, width: f64, dash: &str) {
        let mut d = String::new();
        for (i, p) in points.iter().enumerate() {
            let _ = write!(d, "{}{:.2} {:.2}", if i == 0 { 'M' } else { 'L' }, p[0], p[1]);
        }
        let dash = if dash.is_empty() {
            String::new()
        } else {
            format!(" stroke-dasharray=\"{dash}\"")
        };
        let _ = writeln!(
            self.body,
            "<path d=\"{d}\" fill=\"none\" stroke=\"{stroke}\" stroke-width=\"{width}\" stroke-linejoin=\"round\"{dash}/>"
        );
    }

    /// A path with its own data and paint attributes.
    pub fn path(&mut self, d: &str, attributes: &str) {
        let _ = writeln!(self.body, "<path d=\"{d}\" {attributes}/>");
    }

    /// A line of text; `^` toggles raised small text, as in `10^-16^`.
    pub fn text(&mut self, at: [f64; 2], text: &str, font: Font, align: Align) {
        self.text_turned(at, text, font, align, 0.0);
    }

    /// A line of text turned by an angle in degrees around its anchor.
    pub fn text_turned(&mut self, at: [f64; 2], text: &str, font: Font, align: Align, degrees: f64) {
        let anchor = match align {
            Align::Start => "start",
            Align::Middle => "middle",
            Align::End => "end",
        };
        let mut spans = String::new();
        for (i, part) in text.split('^').enumerate() {
            let part = escape(part);
            if i % 2 == 1 {
                let (dy, size) = (0.35 * font.size, 0.72 * font.size);
                let _ = write!(spans, "<tspan dy=\"-{dy:.1}\" font-size=\"{size:.1}\">{part}</tspan>");
            } else if i > 0 && !part.is_empty() {
                let _ = write!(spans, "<tspan dy=\"{:.1}\">{part}</tspan>", 0.35 * font.size);
            } else {
                spans.push_str(&part);
            }
        }
        let weight = if font.bold { " font-weight=\"bold\"" } else { "" };
        let turn = if degrees == 0.0 {
            String::new()
        } else {
            format!(" transform=\"rotate({degrees:.0} {:.2} {:.2})\"", at[0], at[1])
        };
        let _ = writeln!(
            self.body,
            "<text x=\"{:.2}\" y=\"{:.2}\" font-size=\"{}\" fill=\"{}\" text-anchor=\"{anchor}\"{weight}{turn}>{spans}</text>",
            at[0], at[1], font.size, font.color
        );
    }

    /// The finished document.
    pub fn finish(self) -> String {
        let Self {
            body,
            definitions,
            width,
            height,
            title,
        } = self;
        format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {width} {height}\" width=\"{width}\" height=\"{height}\" \
             role=\"img\" font-family=\"DejaVu Sans, Verdana, Helvetica, Arial, sans-serif\">\n<title>{title}</title>\n\
             <defs>\n{definitions}</defs>\n\
             <rect x=\"0.5\" y=\"0.5\" width=\"{:.1}\" height=\"{:.1}\" rx=\"8\" fill=\"{}\" stroke=\"{}\"/>\n{body}</svg>\n",
            width - 1.0,
            height - 1.0,
            super::palette::CARD,
            super::palette::CARD_EDGE
        )
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn text_is_escaped_and_raised() {
        let mut svg = Svg::new(10.0, 10.0, "a < b");
        svg.text(
            [1.0, 2.0],
            "10^-7^ & x",
            Font {
                size: 10.0,
                color: "#000",
                bold: false,
            },
            Align::Start,
        );
        let text = svg.finish();
        assert!(text.contains("<title>a &lt; b</title>"));
        assert!(text.contains("10<tspan dy=\"-3.5\" font-size=\"7.2\">-7</tspan><tspan dy=\"3.5\"> &amp; x</tspan>"));
    }

    #[test]
    fn boxes_that_share_an_edge_do_not_meet() {
        let a = Rect {
            x0: 0.0,
            y0: 0.0,
            x1: 1.0,
            y1: 1.0,
        };
        let b = Rect {
            x0: 1.0,
            y0: 0.0,
            x1: 2.0,
            y1: 1.0,
        };
        assert!(!a.meets(&b) && a.meets(&b.grown(0.1)));
    }
}
