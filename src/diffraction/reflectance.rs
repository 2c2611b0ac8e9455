//! From responses to a reflectance: coherent, incoherent, blended with a base material so that energy is kept.
//!
//! # Definition
//!
//! ```math
//! f = \frac{|B - \sum_m S_m|^2}{A_C \lambda^2} \quad \text{(coherent)}, \qquad
//! f = \frac{|B|^2 + \sum_m |S_m|^2}{A_C \lambda^2} \quad \text{(incoherent)}
//! ```
//!
//! VWH18 Eqs. 1, 6 and 7; the Fresnel factor is apart. B is [`base_response`](super::base_response), S the response of a
//! scratch: its [`profile`](mod@super::profile) times its [`spatial_phase`](mod@super::spatial_phase). What the incoherent
//! sum leaves out is the interference of scratches with each other (predictor:
//! [`interference_bound`](super::interference_bound)) and with the base, [`base_interference`].
//!
//! Where two scratches cross, the depths add, and the light's phase with them: the field lacks
//! (1 - e^{ip_1})(1 - e^{ip_2}) on the overlap, a parallelogram. With xi = p b_1 + q b_2 in the scratches' bitangents and
//! r_x the crossing's place, B - S_1 - S_2 + X is complete with
//!
//! ```math
//! X = \mathcal D_1 \mathcal D_2\,\frac{W_1 W_2}{|\sin\theta|}\,\mathrm{sinc}\frac{\pi W_1 p}{\lambda}\,
//! \mathrm{sinc}\frac{\pi W_2 q}{\lambda}\,G(r_x)\,e^{-ik\xi \cdot r_x}
//! ```
//!
//! A surface whose share rho is lowered by one depth reflects a transfer function of unit modulus. Its mean is
//! 1 - rho $`\mathcal D`$ with the depth term $`\mathcal D`$ = 1 - exp(ip), and the energies of the mean and of the rest are
//!
//! ```math
//! |1 - \rho \mathcal D|^2 = 1 - \rho (1 - \rho)\,|\mathcal D|^2, \qquad \rho (1 - \rho)\,|\mathcal D|^2
//! ```
//!
//! The incoherent sum of the scratches alone has the energy rho $`|\mathcal D|^2`$, for it is taken from a black ground;
//! before a mirror its factor is 1 - rho. The blend of a base material, f_B, with scratches ([`energy_blend`]) is so
//!
//! ```math
//! f = \left[1 - \rho (1 - \rho)\,|\mathcal D|^2\right] f_B + (1 - \rho) \sum_m \frac{|S_m|^2}{A_C \lambda^2}
//! ```
//!
//! with the energies `base` + `scattered` = 1. Scratches of several depths share it by [`energy_blend_depths`].
//!
//! # Domain
//!
//! That of the parts; radius and wavelength above 0, for the quotient has no limit at 0. NaN in, NaN out. An area density
//! above 1 by no more than the rounding of a sum of tiles, 64 eps, counts as 1.
//!
//! # Methods
//!
//! Sums and products; [`scratch_squared`] has one exponential and two sines. The squared depth term of the base's factor is
//! that of the mirror direction, gamma_i + gamma_o = 2 gamma_i, where the base's lobe lies; each |S|^2 has that of its own
//! direction. The share rho is [`area_density`](super::area_density()) with
//! [`AreaKernel::Energy`](super::AreaKernel::Energy), or its mean over the footprint, summed over the same scratches.
//!
//! # Where it fails
//!
//! - The blend keeps the energy exactly as long as one phase of the depth holds over the scratches' lobe. Where gamma
//!   changes over it, what the scratches scatter is rho (1 - rho) times the lobe's mean of the squared depth term, and the
//!   sum differs from 1 by that mean less the mirror direction's.
//! - Energy is counted over all direction cosines. What a narrow scratch sends beyond the horizon is evanescent.
//! - Scratches that cross cover less than the sum of their shares: [`area_density_union`](super::area_density_union) for
//!   random ones. Where they cross, both depths add, and the sum over single scratches lacks X.
//! - The crossing's window is taken constant over the overlap: nearly parallel scratches have a long one.
//!
//! # Errata
//!
//! - VWH18 Eq. 6 weighs the base with 1 - rho and adds the scratches in full: the energies sum to 1.30 at rho = 0.1 and
//!   $`|\mathcal D|^2`$ = 4.
//! - Its cross term, -2 B S, is -2 Re(B S); the middle of Eq. 15 lacks 1/A_P.
//! - WVJH17 4.2 says that crossings left out do not violate energy. Where both depth terms are 2 the field is
//!   1 - 2 - 2 = -3, nine times the energy; with X it is 1.
//! - WVJH17 Eqs. 4, 7 and 15 have another factor of gamma_i, which breaks reciprocity; VWH18 Eq. 1 is right.

use super::coherence::{Coherence, coherence_area, coherence_window};
use super::limits::{NAN, ZERO};
use super::profile::{Profile, depth_term, depth_term_squared, width_term};
use super::spatial_phase::phase_across;
use num_complex::Complex;

/// Largest area density that counts as 1.
const COVERED: f64 = 1.0 + 64.0 * f64::EPSILON;

/// Factors of a base material's reflectance and of the scratches' incoherent one, and the energy that the latter gets.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct EnergyBlend {
    /// Factor of the base's reflectance, 1 - rho (1 - rho) |1 - exp(ip)|^2: the energy that its lobe keeps.
    pub base: f64,
    /// Energy that the scratches scatter, rho (1 - rho) |1 - exp(ip)|^2: no factor. `base` and this sum to 1.
    pub scattered: f64,
    /// Factor of the scratches' incoherent reflectance, 1 - rho. Their sum alone has the energy rho |1 - exp(ip)|^2.
    pub scratches: f64,
}

impl EnergyBlend {
    /// Outside the domain.
    const NAN: EnergyBlend = EnergyBlend {
        base: f64::NAN,
        scattered: f64::NAN,
        scratches: f64::NAN,
    };
}

/// Returns |B - S|^2/(A_C lambda^2), in 1/sr; Fresnel factor apart.
///
/// `base` is B and `scratches` the sum of all S, in um^2. VWH18 Eq. 1.
///
/// ```
/// use iridescence::diffraction::*;
///
/// let light = Coherence { radius: 30.0, wavelength: 0.55 };
/// let (scratch, place) = (Profile { width: 2.0, depth: 0.15 }, Segment { position: [0.0, 12.0], ends: [-80.0, 200.0] });
/// let scattering = [0.002, 0.04, 1.9];
/// let response = profile_rectangle(scratch, scattering, light.wavelength)
///     * spatial_phase(light, place, [scattering[0], scattering[1]]);
/// let base = base_response(light, [scattering[0], scattering[1]]);
/// assert!(reflectance_coherent(light, base, response) > 0.0);
/// ```
#[must_use]
#[inline]
pub fn reflectance_coherent(coherence: Coherence, base: f64, scratches: Complex<f64>) -> f64 {
    reflectance_incoherent(coherence, (Complex::new(base, 0.0) - scratches).norm_sqr())
}

/// Returns a sum of squared responses over A_C lambda^2, in 1/sr; Fresnel factor apart.
///
/// `squared_sum` is |B|^2 plus the sum of |S|^2, or one of them, in um^4. VWH18 Eqs. 6 and 7.
#[must_use]
#[inline]
pub fn reflectance_incoherent(coherence: Coherence, squared_sum: f64) -> f64 {
    if !(coherence.radius > 0.0 && coherence.wavelength > 0.0) {
        return f64::NAN;
    }
    squared_sum / (coherence_area(coherence.radius) * (coherence.wavelength * coherence.wavelength))
}

/// Returns the mean |S|^2 of one infinite rectangular scratch over a footprint, in um^4.
///
/// W^2 sinc^2 |1 - exp(ip)|^2 2 A_C M exp(-(sigma k xi1)^2), `mean` being M from [`footprint_mean`](super::footprint_mean()), or
/// exp(-s_b^2/sigma^2) at a point; `scattering` is (xi1, xi2, gamma_i + gamma_o). VWH18 Eqs. 9 to 11 and 15.
///
/// ```
/// use iridescence::diffraction::*;
///
/// // At a point it is the squared response of the infinite scratch.
/// let (light, scratch) = (Coherence { radius: 30.0, wavelength: 0.55 }, Profile { width: 2.0, depth: 0.15 });
/// let response = profile_rectangle(scratch, [0.002, 0.04, 1.9], 0.55) * spatial_phase_infinite(light, 12.0, [0.002, 0.04]);
/// let squared = scratch_squared(light, scratch, [0.002, 0.04, 1.9], (-(12.0_f64 / 30.0).powi(2)).exp());
/// assert!((squared / response.norm_sqr() - 1.0).abs() < 1e-13);
/// ```
#[must_use]
#[inline]
pub fn scratch_squared(coherence: Coherence, profile: Profile, scattering: [f64; 3], mean: f64) -> f64 {
    let width = width_term(profile.width, scattering[1], coherence.wavelength);
    let q = coherence.reduced(scattering[0]);
    let depth = depth_term_squared(profile.depth, scattering[2], coherence.wavelength);
    width * width * depth * (2.0 * coherence_area(coherence.radius)) * mean * libm::exp(-q * q)
}

/// Returns -2 Re(B S), the interference of base and scratches, in um^4: |B - S|^2 less |B|^2 + |S|^2.
///
/// B is real in the frame of the shaded point. VWH18 Eq. 6, first member, with the real part that it lacks.
#[must_use]
#[inline]
pub fn base_interference(base: f64, scratches: Complex<f64>) -> f64 {
    -2.0 * base * scratches.re
}

/// Returns the factors of base and scratches, for an area density rho in \[0, 1\] and the squared depth term in \[0, 4\]
/// ([`depth_term_squared`] at gamma_i + gamma_o = 2 gamma_i, the mirror direction); all NaN outside.
///
/// Exact for scratches of one depth: the energies of the mean and of the rest of a transfer function of unit modulus. In
/// place of the 1 - rho of VWH18 Eq. 6.
///
/// ```
/// use iridescence::diffraction::*;
///
/// // Half the surface lower by a quarter wavelength: a grating without a mirror image.
/// assert_eq!(energy_blend(0.5, 4.0).base, 0.0);
/// assert_eq!(energy_blend(1.0, 4.0).base, 1.0);
///
/// // A mirror with one scratch on it, towards one direction.
/// let (light, scratch, offset) = (Coherence { radius: 30.0, wavelength: 0.55 }, Profile { width: 2.0, depth: 0.1 }, 12.0);
/// let density = area_density(AreaKernel::Energy, scratch.width, offset, light.radius);
/// let blend = energy_blend(density, depth_term_squared(scratch.depth, 2.0 * 0.95, light.wavelength));
/// let (scattering, mean) = ([0.002, 0.04, 1.9], coherence_window(offset, light.radius).powi(2));
/// let mirror = reflectance_incoherent(light, base_response(light, [0.002, 0.04]).powi(2));
/// let alone = reflectance_incoherent(light, scratch_squared(light, scratch, scattering, mean));
/// let reflectance = blend.base * mirror + blend.scratches * alone;
/// assert!(blend.scratches < 1.0 && reflectance > 0.0);
/// ```
#[must_use]
#[inline]
pub fn energy_blend(density: f64, depth_squared: f64) -> EnergyBlend {
    if !((0.0..=COVERED).contains(&density) && (0.0..=4.0).contains(&depth_squared)) {
        return EnergyBlend::NAN;
    }
    let density = if density > 1.0 { 1.0 } else { density };
    let scratches = 1.0 - density;
    let scattered = density * scratches * depth_squared;
    EnergyBlend {
        base: 1.0 - scattered,
        scattered,
        scratches,
    }
}

/// Returns the factors of base and scratches for scratches of several depths: pairs of area density and depth term.
///
/// `shares` yields rho_m >= 0 and 1 - exp(ip_m), the [`depth_term`] of the mirror direction; the rho_m sum to 1 at most.
/// All NaN outside. The mean of the transfer function is 1 less the sum of rho_m (1 - exp(ip_m)):
///
/// ```math
/// \text{base} = \Bigl|1 - \sum_m \rho_m \mathcal D_m\Bigr|^2, \qquad
/// \text{scratches} = 1 - \frac{|\sum_m \rho_m \mathcal D_m|^2}{\sum_m \rho_m |\mathcal D_m|^2}
/// ```
///
/// Exact for scratches that do not cross: base + scratches times the energy of their incoherent sum is 1. One depth gives
/// [`energy_blend`]. Where nothing is scattered the last factor has no weight, and is 1 less the sum of rho_m. VWH18 Eq. 6
/// knows one sum of area densities only.
///
/// ```
/// use iridescence::diffraction::{depth_term, energy_blend, energy_blend_depths};
///
/// let [shallow, deep] = [0.03, 0.12].map(|depth| depth_term(depth, 1.9, 0.55));
/// let blend = energy_blend_depths([(0.2, shallow), (0.1, deep)]);
/// assert!((blend.base + blend.scattered - 1.0).abs() < 1e-15);
/// let one = energy_blend_depths([(0.2, deep), (0.1, deep)]);
/// assert!((one.base - energy_blend(0.3, deep.norm_sqr()).base).abs() < 1e-15);
/// ```
#[must_use]
pub fn energy_blend_depths(shares: impl IntoIterator<Item = (f64, Complex<f64>)>) -> EnergyBlend {
    let (mut density, mut mean, mut alone) = (0.0, ZERO, 0.0);
    for (share, depth) in shares {
        if share.is_nan() || share < 0.0 {
            return EnergyBlend::NAN;
        }
        density += share;
        mean += depth * share;
        alone += share * depth.norm_sqr();
    }
    if density.is_nan() || density > COVERED || !alone.is_finite() {
        return EnergyBlend::NAN;
    }
    // The sum of rho |D|^2 less |sum of rho D|^2, which rounding alone takes below 0.
    let rest = alone - mean.norm_sqr();
    let scattered = if rest > 0.0 { rest } else { 0.0 };
    let free = 1.0 - density;
    EnergyBlend {
        base: (Complex::new(1.0, 0.0) - mean).norm_sqr(),
        scattered,
        scratches: if alone > 0.0 {
            scattered / alone
        } else if free > 0.0 {
            free
        } else {
            0.0
        },
    }
}

/// Returns what two crossing rectangular scratches lack in B - S1 - S2, in um^2: the product of the depth terms times
/// the transform of the overlap.
///
/// `tangents` are the two unit tangents in the surface's plane, `crossing` the place where the centre lines meet, relative
/// to the shaded point; `scattering` is (xi_x, xi_y, gamma_i + gamma_o) in the same plane's axes. The window is taken
/// constant over the overlap. NaN for parallel scratches, which overlap without end or not at all. No paper has it; WVJH17
/// 4.2 neglects it.
#[must_use]
pub fn crossing_response(
    coherence: Coherence,
    profiles: [Profile; 2],
    tangents: [[f64; 2]; 2],
    crossing: [f64; 2],
    scattering: [f64; 3],
) -> Complex<f64> {
    let Coherence { radius, wavelength } = coherence;
    let [[x1, y1], [x2, y2]] = tangents;
    let [xi, eta, gamma] = scattering;
    let sine = x1 * y2 - y1 * x2;
    if sine == 0.0 {
        return NAN;
    }
    // xi = p b1 + q b2 with the bitangents b = (-y, x): the scalar products with the tangents t2 and t1.
    let (p, q) = ((xi * x2 + eta * y2) / sine, -(xi * x1 + eta * y1) / sine);
    let [one, two] = profiles;
    let overlap = width_term(one.width, p, wavelength) * width_term(two.width, q, wavelength) / sine.abs();
    let window = coherence_window(libm::hypot(crossing[0], crossing[1]), radius);
    let phase = phase_across(crossing[0], xi, wavelength, window) * phase_across(crossing[1], eta, wavelength, window);
    let depth = depth_term(one.depth, gamma, wavelength) * depth_term(two.depth, gamma, wavelength);
    depth * phase * (overlap * window)
}
