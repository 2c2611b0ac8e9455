//! Colours of the charts: the Okabe-Ito set for origins, the cividis ramp for magnitudes. Both stay apart
//! under the common colour-vision deficiencies; origins also differ in marker.

use reference::registry::Origin;

/// Background of every chart.
pub const CARD: &str = "#fcfcf9";
/// Edge of the card, visible on a white page.
pub const CARD_EDGE: &str = "#c8c8c2";
/// Text and axes.
pub const INK: &str = "#1c1f24";
/// Secondary text.
pub const FAINT_INK: &str = "#565b63";
/// Grid lines.
pub const GRID: &str = "#e4e4df";
/// Hatching of results with the wrong sign.
pub const WRONG_SIGN: &str = "#ff5c33";
/// The Pareto front.
pub const FRONT: &str = "#8fd0ae";
/// The Pareto front of scalar calls, drawn over the other.
pub const SCALAR_FRONT: &str = "#14603b";
/// Reference lines.
pub const REFERENCE: &str = "#8a6d1f";

/// Colour of an origin.
pub fn origin(origin: Origin) -> &'static str {
    match origin {
        Origin::Ours => "#0064a8",
        Origin::Published => "#cc4b00",
        Origin::Peer => "#7a3f8f",
    }
}

/// Cividis, light to dark, sampled at equal steps.
const RAMP: [[u8; 3]; 10] = [
    [254, 232, 56],
    [225, 204, 85],
    [195, 179, 105],
    [165, 156, 116],
    [138, 134, 120],
    [112, 113, 115],
    [87, 93, 109],
    [59, 73, 108],
    [18, 53, 112],
    [0, 34, 78],
];

/// Colour at `t` in [0, 1] of the sequential ramp, light for 0 and dark for 1.
pub fn ramp(t: f64) -> String {
    let s = t.clamp(0.0, 1.0) * (RAMP.len() - 1) as f64;
    let i = (s as usize).min(RAMP.len() - 2);
    let f = s - i as f64;
    let mix = |c: usize| (f64::from(RAMP[i][c]) * (1.0 - f) + f64::from(RAMP[i + 1][c]) * f).round() as u8;
    format!("#{:02x}{:02x}{:02x}", mix(0), mix(1), mix(2))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_ramp_darkens_from_end_to_end() {
        let light = |t: f64| {
            let c = ramp(t);
            let part = |i: usize| f64::from(u8::from_str_radix(&c[i..i + 2], 16).expect("two hex digits"));
            0.2126 * part(1) + 0.7152 * part(3) + 0.0722 * part(5)
        };
        for i in 0..20 {
            let (a, b) = (f64::from(i) / 20.0, f64::from(i + 1) / 20.0);
            assert!(light(a) > light(b), "{a}");
        }
        assert_eq!(ramp(0.0), "#fee838");
        assert_eq!(ramp(1.0), "#00224e");
    }
}
