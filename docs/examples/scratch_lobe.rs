//! The share of a scratch's `sinc^2` lobe that falls on a light, for three wavelengths, by three methods.
//!
//! `cargo run --example scratch_lobe`
//!
//! A scratch of width W sends light of wavelength lambda into the direction cosines xi of its bitangent with the weight
//! `sinc^2(pi W xi/lambda)`, VWH18 Eq. 25. A light that covers [lo, hi] receives the integral over q = pi W xi/lambda
//! between its ends, divided by the whole lobe, which is pi. The published fit gives some lights beside the peak less
//! than nothing.

use iridescence::{shader, special};
use std::f64::consts::PI;

/// Width of the scratch, micrometres.
const WIDTH: f64 = 2.5;
/// Red, green and blue of WVJH17 section 5, micrometres.
const WAVELENGTHS: [f64; 3] = [0.70, 0.52, 0.44];
/// Lights as intervals of direction cosines: one on the peak, two beside it.
const LIGHTS: [[f64; 2]; 3] = [[-0.05, 0.05], [0.45, 0.47], [0.60, 0.62]];

/// The share of the lobe in f64.
fn accurate(wavelength: f64, light: [f64; 2]) -> f64 {
    special::sinc_squared_integral(light.map(|xi| PI * WIDTH * xi / wavelength)) / PI
}

/// The share of the lobe in f32, the phase in turns: W/lambda and xi are handed over apart.
fn single(wavelength: f64, [lo, hi]: [f64; 2]) -> f32 {
    shader::sinc_squared_integral_turns((WIDTH / wavelength) as f32, lo as f32, hi as f32) / std::f32::consts::PI
}

/// The share of the lobe by VWH18 Eq. 27 with the fit of Eq. 29.
fn published(wavelength: f64, light: [f64; 2]) -> f64 {
    special::sinc_squared_integral_vwh18(light.map(|xi| PI * WIDTH * xi / wavelength)) / PI
}

fn main() {
    println!("light          wavelength       f64            f32            VWH18 Eq. 29");
    for light in LIGHTS {
        for wavelength in WAVELENGTHS {
            println!(
                "[{:5.2}, {:4.2}]  {wavelength:.2} um      {:13.6e}  {:13.6e}  {:13.6e}",
                light[0],
                light[1],
                accurate(wavelength, light),
                single(wavelength, light),
                published(wavelength, light)
            );
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn rows() -> impl Iterator<Item = (f64, [f64; 2])> {
        LIGHTS
            .into_iter()
            .flat_map(|light| WAVELENGTHS.map(|wavelength| (wavelength, light)))
    }

    #[test]
    fn every_share_is_between_nothing_and_the_whole_lobe_in_both_precisions() {
        for (wavelength, light) in rows() {
            let share = accurate(wavelength, light);
            assert!(share > 0.0 && share < 1.0, "{wavelength} {light:?}: {share}");
            let error = f64::from(single(wavelength, light)) / share - 1.0;
            // The ends are rounded to f32, which changes the length of the light.
            assert!(error.abs() < 1e-5, "{wavelength} {light:?}: {error}");
        }
    }

    #[test]
    fn the_published_fit_gives_a_light_less_than_nothing() {
        assert!(rows().any(|(wavelength, light)| published(wavelength, light) < 0.0));
    }
}
