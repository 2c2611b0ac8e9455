//! Area lights at several wavelengths, and averaged over a channel.
//!
//! # Definition
//!
//! A channel here is uniform in the wave number k = 2 pi/lambda between two wavelengths, and the coherence radius is one for
//! all of it. The mean over it of one chord,
//!
//! ```math
//! \bar C = \frac{1}{k_1 - k_0}\int_{k_0}^{k_1} \frac{\sqrt\pi}{\sigma k}\,\frac{2}{kW}
//! \bigl[\Phi(\tfrac{kW}{2}\xi_b) - \Phi(\tfrac{kW}{2}\xi_a)\bigr]\,dk, \qquad \Phi(u) = \int_0^u \mathrm{sinc}^2,
//! ```
//!
//! closes, since with a = W xi/2
//!
//! ```math
//! \int \frac{\Phi(ak)}{k^2}\,dk = a\,P(ak), \qquad
//! P(u) = \ln u - \mathrm{Cin}\,2u - \frac{\Phi(u)}{u} - \frac{\mathrm{sinc}^2 u}{2} - \mathrm{sinc}\,2u
//! ```
//!
//! up to a constant. No paper has it.
//!
//! # Domain
//!
//! Wavelengths in um, positive and finite, in either order; equal ones give the chord at that wavelength. NaN elsewhere.
//!
//! # Where it fails
//!
//! Where one chord does: a light whose edge lies in the band. A light that covers many lobes has a mean near that of
//! geometric optics, of which the difference keeps the digits; a channel narrower than 1e-6 loses them in the division.

use super::outline_integral::{self, LightIntegral};
use super::scratch_lobe::ScratchLobe;
use super::sphere::Sphere;
use crate::diffraction::Coherence;
use crate::geometry::{Cone, cone_chords, cone_outline, polygon_crossings, polygon_outline};
use crate::special::{cosine_integral_entire, sinc, sinc_squared_integral};
use core::f64::consts::PI;

/// Returns the integral over a sphere at several wavelengths at once, each with a relative error of at most `tolerance`.
///
/// One entry of `light` per wavelength, with the coherence radius that belongs to it; the wavelength and radius of `lobe`
/// are not used. The cone is found once. See [`sphere_light_within`](super::sphere_light_within).
#[must_use]
pub fn sphere_light_wavelengths<const N: usize>(
    lobe: ScratchLobe,
    light: [Coherence; N],
    sphere: Sphere,
    tolerance: f64,
) -> [LightIntegral; N] {
    let Some(cone) = Cone::of_sphere(sphere.centre, sphere.radius) else {
        return [LightIntegral::NAN; N];
    };
    light.map(|coherence| {
        let scales = ScratchLobe { coherence, ..lobe }.scales();
        scales.map_or(LightIntegral::NAN, |scales| {
            outline_integral::within(scales, tolerance, |visit| cone_outline(cone, visit))
        })
    })
}

/// Returns the integral over a polygon at several wavelengths at once, each with a relative error of at most `tolerance`.
///
/// As [`sphere_light_wavelengths`]; vertices as for [`polygon_light`](super::polygon_light()).
#[must_use]
pub fn polygon_light_wavelengths<const N: usize>(
    lobe: ScratchLobe,
    light: [Coherence; N],
    vertices: &[[f64; 3]],
    tolerance: f64,
) -> [LightIntegral; N] {
    if !polygon_outline(vertices, |_| {}) {
        return [LightIntegral::NAN; N];
    }
    light.map(|coherence| {
        let scales = ScratchLobe { coherence, ..lobe }.scales();
        scales.map_or(LightIntegral::NAN, |scales| {
            let found = outline_integral::within(scales, tolerance, |visit| {
                polygon_outline(vertices, visit);
            });
            LightIntegral {
                value: found.value.abs(),
                ..found
            }
        })
    })
}

/// a \[P(a k1) - P(a k0)\] for the end xi of a chord; a = W xi/2.
fn end(a: f64, k: [f64; 2]) -> f64 {
    if a == 0.0 {
        return 0.0;
    }
    let [from, to] = k.map(|k| {
        let u = a * k;
        let lobe = sinc(u);
        // At u = 0 the quotient is 1.
        let share = if u == 0.0 {
            1.0
        } else {
            sinc_squared_integral([0.0, u]) / u
        };
        cosine_integral_entire(2.0 * u) + share + 0.5 * lobe * lobe + sinc(2.0 * u)
    });
    a * (libm::log(k[1] / k[0]) - (to - from))
}

/// The mean of a chord between two bitangent cosines over a channel.
fn channel(lobe: &ScratchLobe, wavelengths: [f64; 2], ends: [f64; 2]) -> f64 {
    let k = wavelengths.map(|wavelength| 2.0 * PI / wavelength);
    let [from, to] = ends.map(|y| end(0.5 * lobe.width * (y + lobe.view[1]), k));
    libm::sqrt(PI) / lobe.coherence.radius * (2.0 / lobe.width) * (to - from) / (k[1] - k[0])
}

/// The lobe at one end of a channel, where both ends are wavelengths.
fn valid(lobe: &ScratchLobe, wavelengths: [f64; 2]) -> bool {
    wavelengths.into_iter().all(|wavelength| {
        let coherence = Coherence {
            wavelength,
            ..lobe.coherence
        };
        ScratchLobe { coherence, ..*lobe }.scales().is_some()
    })
}

/// Returns the mean over a channel of the one-chord integral over a sphere that covers the band, dimensionless.
///
/// `wavelengths` in um are the channel's ends, uniform in 1/lambda between; that of `lobe` is not used.
#[must_use]
pub fn sphere_light_channel(lobe: ScratchLobe, wavelengths: [f64; 2], sphere: Sphere) -> f64 {
    let Some(cone) = Cone::of_sphere(sphere.centre, sphere.radius) else {
        return f64::NAN;
    };
    if !valid(&lobe, wavelengths) {
        return f64::NAN;
    }
    if wavelengths[0] == wavelengths[1] {
        return super::sphere_light_chords(at(lobe, wavelengths[0]), sphere, 1);
    }
    let chords =
        cone_chords(cone, -lobe.view[0]).map(|ends| ends.map_or(0.0, |ends| channel(&lobe, wavelengths, ends)));
    chords[0] + chords[1]
}

/// Returns the same over a polygon that covers the band.
#[must_use]
pub fn polygon_light_channel(lobe: ScratchLobe, wavelengths: [f64; 2], vertices: &[[f64; 3]]) -> f64 {
    if !valid(&lobe, wavelengths) {
        return f64::NAN;
    }
    if wavelengths[0] == wavelengths[1] {
        return super::polygon_light_chords(at(lobe, wavelengths[0]), vertices, 1);
    }
    let (mut sum, mut begin) = (0.0, None);
    let directed = polygon_crossings(vertices, -lobe.view[0], |crossing| match begin.take() {
        None => begin = Some(crossing.y),
        Some(y) => {
            let mean = channel(&lobe, wavelengths, [y, crossing.y]);
            sum += if crossing.upward { mean } else { -mean };
        }
    });
    if directed { f64::abs(sum) } else { f64::NAN }
}

fn at(lobe: ScratchLobe, wavelength: f64) -> ScratchLobe {
    ScratchLobe {
        coherence: Coherence {
            wavelength,
            ..lobe.coherence
        },
        ..lobe
    }
}
