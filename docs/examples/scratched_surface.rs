//! One shaded point of a scratched mirror under the sun: ten scratches on a base, coherent and incoherent, in three
//! wavelengths.
//!
//! `cargo run --example scratched_surface`
//!
//! The reflectance beside the mirror direction, first with every interference, |B - S_1 - ... - S_10|^2 (VWH18 Eq. 1), then
//! as the blend of the base's lobe with the sum of the scratches' lobes (in place of VWH18 Eq. 6). Then the energies: what
//! the base keeps, and what the scratches scatter by the integral of their lobes over all directions. The ten cross; the
//! depths that add where they do are in neither sum.

use iridescence::Complex;
use iridescence::diffraction::*;
use std::f64::consts::PI;

/// Red, green and blue of WVJH17 section 5, micrometres.
const WAVELENGTHS: [f64; 3] = [0.70, 0.52, 0.44];
/// Angular diameter of the sun.
const SUN: f64 = 0.53 * PI / 180.0;
/// Cosine of the angle of incidence to the normal.
const INCIDENCE: f64 = 0.95;

/// An infinite scratch: its profile, the angle of its tangent, its distance from the shaded point in micrometres.
struct Scratch {
    profile: Profile,
    angle: f64,
    offset: f64,
}

/// Ten scratches around the point, their places by the golden section.
fn scratches() -> [Scratch; 10] {
    std::array::from_fn(|i| {
        let golden = (0.618_033_988_749_895 * (i + 1) as f64).fract();
        Scratch {
            profile: Profile {
                width: 0.6 + golden,
                depth: 0.06 + 0.012 * i as f64,
            },
            angle: 0.3 * i as f64,
            offset: 90.0 * (golden - 0.5),
        }
    })
}

/// The light at a wavelength: the window is as wide as the sun is small.
fn light(wavelength: f64) -> Coherence {
    Coherence {
        radius: coherence_radius(SUN, wavelength),
        wavelength,
    }
}

impl Scratch {
    /// (xi1, xi2, gamma) along and across this scratch.
    fn own(&self, [x, y, gamma]: [f64; 3]) -> [f64; 3] {
        let (sine, cosine) = self.angle.sin_cos();
        [cosine * x + sine * y, cosine * y - sine * x, gamma]
    }

    /// The same scratch as another point sees it.
    #[cfg(test)]
    fn seen_from(self, [x, y]: [f64; 2]) -> Scratch {
        let [_, across, _] = self.own([x, y, 0.0]);
        Scratch {
            offset: self.offset - across,
            ..self
        }
    }

    /// The share of the window's energy that lies on the scratch.
    fn density(&self, light: Coherence) -> f64 {
        area_density(AreaKernel::Energy, self.profile.width, self.offset, light.radius)
    }

    /// S: profile times spatial phase.
    fn response(&self, light: Coherence, scattering: [f64; 3]) -> Complex<f64> {
        let own = self.own(scattering);
        profile_rectangle(self.profile, own, light.wavelength)
            * spatial_phase_infinite(light, self.offset, [own[0], own[1]])
    }

    /// |S|^2, without the phase.
    fn squared(&self, light: Coherence, scattering: [f64; 3]) -> f64 {
        let window = coherence_window(self.offset, light.radius);
        scratch_squared(light, self.profile, self.own(scattering), window * window)
    }
}

/// The factors of base and scratches: each depth with its own share, at the phase of the mirror direction.
fn blend(light: Coherence) -> EnergyBlend {
    energy_blend_depths(scratches().iter().map(|scratch| {
        let depth = depth_term(scratch.profile.depth, 2.0 * INCIDENCE, light.wavelength);
        (scratch.density(light), depth)
    }))
}

/// The reflectance of base and scratches with all their interference.
fn coherent(scratches: &[Scratch], light: Coherence, scattering: [f64; 3]) -> f64 {
    let sum = scratches
        .iter()
        .map(|scratch| scratch.response(light, scattering))
        .sum();
    reflectance_coherent(light, base_response(light, [scattering[0], scattering[1]]), sum)
}

/// The reflectance of base and scratches, blended without interference: in the mean over places of the point.
fn incoherent(light: Coherence, scattering: [f64; 3]) -> f64 {
    let base = base_response(light, [scattering[0], scattering[1]]);
    let alone = scratches()
        .iter()
        .map(|scratch| scratch.squared(light, scattering))
        .sum();
    let blend = blend(light);
    blend.base * reflectance_incoherent(light, base * base) + blend.scratches * reflectance_incoherent(light, alone)
}

/// The energy of the scratches' lobes alone: the rectangle rule along, where the lobe is a Gaussian, and across, where a
/// step of lambda/(2 W) sums sinc^2 exactly but for the far side lobes.
fn energy_alone(light: Coherence) -> f64 {
    let of_one = |scratch: &Scratch| {
        let along = 0.2 * light.wavelength / (2.0 * PI * light.radius);
        let across = 0.5 * light.wavelength / scratch.profile.width;
        let (sine, cosine) = scratch.angle.sin_cos();
        let at = |i: i32, j: i32| {
            let (x, y) = (f64::from(i) * along, f64::from(j) * across);
            let scattering = [cosine * x - sine * y, sine * x + cosine * y, 2.0 * INCIDENCE];
            reflectance_incoherent(light, scratch.squared(light, scattering))
        };
        let peak = at(0, 0);
        let gaussian: f64 = (-30..=30).map(|i| at(i, 0)).sum();
        let lobes: f64 = (-2000..=2000).map(|j| at(0, j)).sum();
        gaussian * lobes / peak * along * across
    };
    scratches().iter().map(of_one).sum()
}

fn main() {
    println!("                  reflectance, 1/sr");
    println!("direction cosines  wavelength      coherent    incoherent");
    for [x, y] in [[0.0, 0.0], [0.01, 0.02], [-0.02, 0.05], [-0.26, -0.15]] {
        for wavelength in WAVELENGTHS {
            let (light, scattering) = (light(wavelength), [x, y, 2.0 * INCIDENCE]);
            let [one, other] = [coherent(&scratches(), light, scattering), incoherent(light, scattering)];
            println!("[{x:5.2}, {y:5.2}]     {wavelength:.2} um      {one:12.5e}  {other:12.5e}");
        }
    }
    println!("\nwavelength  coverage  base keeps  scratches scatter  together");
    for wavelength in WAVELENGTHS {
        let light = light(wavelength);
        let coverage: f64 = scratches().iter().map(|scratch| scratch.density(light)).sum();
        let blend = blend(light);
        let scattered = blend.scratches * energy_alone(light);
        println!(
            "{wavelength:.2} um     {coverage:8.4}  {:10.6}  {scattered:17.6}  {:8.6}",
            blend.base,
            blend.base + scattered
        );
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn base_and_scratches_together_have_the_whole_energy() {
        for wavelength in WAVELENGTHS {
            let light = light(wavelength);
            let blend = blend(light);
            let together = blend.base + blend.scratches * energy_alone(light);
            // The far side lobes that the sum across leaves out.
            assert!((together - 1.0).abs() < 2e-4, "{wavelength}: {together}");
            assert!(blend.base < 0.9 && blend.scattered > 0.1, "{wavelength}: {blend:?}");
        }
    }

    #[test]
    fn without_interference_the_scratches_have_the_squares_of_their_responses() {
        for wavelength in WAVELENGTHS {
            let (light, scattering) = (light(wavelength), [0.1, 0.05, 1.9]);
            for scratch in scratches() {
                let (squared, response) = (scratch.squared(light, scattering), scratch.response(light, scattering));
                assert!(
                    (squared - response.norm_sqr()).abs() <= 1e-12 * squared,
                    "{wavelength}: {squared}"
                );
            }
        }
    }

    #[test]
    fn over_a_patch_of_points_the_interference_averages_out() {
        let (light, scattering) = (light(0.52), [0.01, 0.02, 2.0 * INCIDENCE]);
        let (mut together, mut apart, mut largest) = (0.0, 0.0, 0.0_f64);
        for i in -60..60 {
            for j in -60..60 {
                let seen = scratches().map(|scratch| scratch.seen_from([f64::from(i), f64::from(j)].map(|x| 4.0 * x)));
                let one = coherent(&seen, light, scattering);
                let alone = seen.iter().map(|scratch| scratch.squared(light, scattering)).sum();
                let other = reflectance_incoherent(light, alone);
                together += one;
                apart += other;
                largest = largest.max(one / other);
            }
        }
        assert!((together / apart - 1.0).abs() < 0.05, "{}", together / apart);
        assert!(largest > 1.5, "{largest}");
    }
}
