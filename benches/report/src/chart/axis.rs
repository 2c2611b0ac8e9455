//! Axes: a map from values to pixels, linear or logarithmic, with ticks and grid.

use super::palette;
use super::svg::{Align, Font, Rect, Svg};

/// A map from an interval of values to an interval of pixels.
#[derive(Clone, Copy, Debug)]
pub struct Axis {
    /// Values at the two ends.
    pub values: [f64; 2],
    /// Pixels at the two ends.
    pub pixels: [f64; 2],
    /// Logarithmic or linear.
    pub logarithmic: bool,
}

/// Tick labels.
pub const TICK: Font = Font {
    size: 12.0,
    color: palette::INK,
    bold: false,
};
/// Axis titles.
pub const NAME: Font = Font {
    size: 13.0,
    color: palette::INK,
    bold: false,
};

impl Axis {
    /// Pixel of a value; values outside are moved to the nearer end.
    pub fn at(&self, value: f64) -> f64 {
        let [lo, hi] = self.values;
        let t = if self.logarithmic {
            (libm::log10(value.max(f64::MIN_POSITIVE)) - libm::log10(lo)) / (libm::log10(hi) - libm::log10(lo))
        } else {
            (value - lo) / (hi - lo)
        };
        self.pixels[0] + t.clamp(0.0, 1.0) * (self.pixels[1] - self.pixels[0])
    }

    /// The powers of ten within a logarithmic axis, as exponents.
    pub fn decades(&self) -> Vec<i32> {
        let (lo, hi) = (libm::log10(self.values[0]), libm::log10(self.values[1]));
        ((lo - 1e-9).ceil() as i32..=(hi + 1e-9).floor() as i32).collect()
    }

    /// Tick values with their texts: powers of ten, or `step` multiples on a linear axis. Powers are thinned to
    /// every `every`-th.
    fn ticks(&self, every: i32, step: f64) -> Vec<(f64, String)> {
        if self.logarithmic {
            let named = |e: i32| {
                if e == 0 { "1".to_string() } else { format!("10^{e}^") }
            };
            self.decades()
                .into_iter()
                .filter(|e| e.rem_euclid(every) == 0)
                .map(|e| (power_of_ten(e), named(e)))
                .chain(self.between())
                .collect()
        } else {
            let (first, last) = (
                (self.values[0] / step).ceil() as i64,
                (self.values[1] / step).floor() as i64,
            );
            (first..=last)
                .map(|i| (i as f64 * step, trimmed(i as f64 * step)))
                .collect()
        }
    }

    /// Ticks at 2 and 5 times the powers of ten, on an axis that holds at most two powers.
    fn between(&self) -> Vec<(f64, String)> {
        let decades = self.decades();
        if decades.len() > 2 {
            return Vec::new();
        }
        let first = libm::floor(libm::log10(self.values[0])) as i32;
        (first..=first + 3)
            .flat_map(|e| [2.0, 5.0].map(|d| d * power_of_ten(e)))
            .filter(|v| *v > self.values[0] && *v < self.values[1])
            .map(|v| (v, trimmed(v)))
            .collect()
    }

    /// Draws grid, ticks, tick texts and title of a horizontal axis under `frame`.
    pub fn draw_below(&self, svg: &mut Svg, frame: Rect, name: &str, every: i32, step: f64, grid: bool) {
        if self.logarithmic && grid {
            for e in self.decades() {
                for digit in 2..10 {
                    let v = f64::from(digit) * power_of_ten(e);
                    if v < self.values[1] {
                        let x = self.at(v);
                        svg.line([x, frame.y1], [x, frame.y1 + 3.0], palette::FAINT_INK, 0.7, "");
                    }
                }
            }
        }
        for (value, text) in self.ticks(every, step) {
            let x = self.at(value);
            if grid {
                svg.line([x, frame.y0], [x, frame.y1], palette::GRID, 1.0, "");
            }
            svg.line([x, frame.y1], [x, frame.y1 + 6.0], palette::INK, 1.0, "");
            svg.text([x, frame.y1 + 21.0], &text, TICK, Align::Middle);
        }
        svg.text(
            [0.5 * (frame.x0 + frame.x1), frame.y1 + 43.0],
            name,
            NAME,
            Align::Middle,
        );
    }

    /// Draws grid, ticks, tick texts and title of a vertical axis left of `frame`.
    pub fn draw_left(&self, svg: &mut Svg, frame: Rect, name: &str, every: i32, step: f64, grid: bool) {
        for (value, text) in self.ticks(every, step) {
            let y = self.at(value);
            if grid {
                svg.line([frame.x0, y], [frame.x1, y], palette::GRID, 1.0, "");
            }
            svg.line([frame.x0 - 6.0, y], [frame.x0, y], palette::INK, 1.0, "");
            svg.text([frame.x0 - 10.0, y + 4.0], &text, TICK, Align::End);
        }
        let at = [frame.x0 - 56.0, 0.5 * (frame.y0 + frame.y1)];
        svg.text_turned(at, name, NAME, Align::Middle, -90.0);
    }
}

/// 10^e, correctly rounded.
pub fn power_of_ten(e: i32) -> f64 {
    format!("1e{e}").parse().expect("a power of ten parses")
}

fn trimmed(value: f64) -> String {
    let text = format!("{value:.3}");
    text.trim_end_matches('0').trim_end_matches('.').to_string()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_logarithmic_axis_maps_decades_to_equal_steps() {
        let axis = Axis {
            values: [1e-2, 1e2],
            pixels: [0.0, 400.0],
            logarithmic: true,
        };
        for (e, x) in axis.decades().into_iter().zip([0.0, 100.0, 200.0, 300.0, 400.0]) {
            assert!((axis.at(power_of_ten(e)) - x).abs() < 1e-9);
        }
        assert_eq!(axis.at(1e9), 400.0);
        assert_eq!(axis.at(0.0), 0.0);
    }
}
