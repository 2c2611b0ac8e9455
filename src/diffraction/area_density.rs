//! The share of the surface that scratches cover, as the window sees it.
//!
//! # Definition
//!
//! A scratch of a width W counts with its area under a normalised window. An infinite one, at the distance s_b:
//!
//! ```math
//! \rho = \frac{W}{\sqrt{2\pi}\,\sigma} e^{-s_b^2/(2\sigma^2)} \quad\text{(amplitude)}, \qquad
//! \rho = \frac{W}{\sqrt{\pi}\,\sigma} e^{-s_b^2/\sigma^2} \quad\text{(energy)}
//! ```
//!
//! The scratches' shares add up: full coverage gives 1 with either kernel, whatever the directions.
//!
//! # Domain
//!
//! Width >= 0 and narrow against the radius, any distance, radius > 0; NaN otherwise, and NaN for NaN. An infinite distance
//! gives 0. Crossings count twice: many random directions sum to more than what they cover; [`area_density_union`] turns
//! such a sum into what it covers.
//!
//! # Methods
//!
//! One exponential. Over a footprint the mean is [`footprint_mean`], with the radius times sqrt2 for the amplitude kernel.
//!
//! # Where it fails
//!
//! A scratch as wide as the radius: the window is taken as constant across it. The share of tiles at a pitch W above
//! 2 sigma depends on the place. Scratches side by side sum to 1 up to rounding, which
//! [`energy_blend`](super::energy_blend) takes for 1; scratches on top of each other sum to more, and give NaN there.
//!
//! # Errata
//!
//! VWH18 Eqs. 17 and 18 divide the window exp(-r^2/(2 sigma^2)) by A_C = pi sigma^2, half its area: full coverage gives 2, and
//! the base's factor 1 - rho is negative from half coverage on.

use super::footprint::{Footprint, footprint_mean};
use core::f64::consts::{FRAC_2_SQRT_PI, SQRT_2};

/// The weight of a point in the share, normalised so that full coverage gives 1.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum AreaKernel {
    /// The window exp(-r^2/(2 sigma^2)) over its area 2 pi sigma^2.
    Amplitude,
    /// The window's square exp(-r^2/sigma^2) over its area pi sigma^2: the share of the energy.
    Energy,
}

/// Returns the radius at which the kernel falls to 1/e, and W/(sqrt(pi) that radius).
fn reach_and_peak(kernel: AreaKernel, width: f64, radius: f64) -> (f64, f64) {
    let reach = match kernel {
        AreaKernel::Amplitude => SQRT_2 * radius,
        AreaKernel::Energy => radius,
    };
    if width >= 0.0 && radius > 0.0 {
        (reach, (0.5 * FRAC_2_SQRT_PI) * width / reach)
    } else {
        (f64::NAN, f64::NAN)
    }
}

/// Returns the share of one infinite scratch of a width at the distance s_b, dimensionless (VWH18 Eq. 17, normalised).
///
/// Width, distance and radius sigma in um; NaN for a negative width or a radius that is not positive.
#[must_use]
pub fn area_density(kernel: AreaKernel, width: f64, offset: f64, radius: f64) -> f64 {
    let (reach, peak) = reach_and_peak(kernel, width, radius);
    let r = offset / reach;
    peak * libm::exp(-r * r)
}

/// Returns the mean of [`area_density`] over a footprint (VWH18 Eq. 18, normalised), to 1e-12 of its largest value.
///
/// The offset from the centre of the ellipse, in um.
#[must_use]
pub fn area_density_footprint(kernel: AreaKernel, width: f64, footprint: Footprint, offset: f64, radius: f64) -> f64 {
    let (reach, peak) = reach_and_peak(kernel, width, radius);
    peak * footprint_mean(footprint, offset, reach)
}

/// Returns the share of the surface that scratches cover together, 1 - exp(-sum), from the sum of their area densities.
///
/// For scratches that lie independently of each other, at random places and in random directions (a Poisson process of
/// lines): a point is then free of every one of them with the probability exp(-sum). It is the mean over such surfaces, for
/// a footprint that sees many scratches; scratches side by side (a grating, brushed metal) cover their plain sum. No paper
/// has it. 1 for an infinite sum; NaN for a negative one.
///
/// ```
/// use iridescence::diffraction::area_density_union;
///
/// // As many scratches as would tile the surface leave 1/e of it free.
/// assert!((area_density_union(1.0) - 0.632120558828558).abs() < 1e-15);
/// ```
#[must_use]
pub fn area_density_union(sum: f64) -> f64 {
    if sum >= 0.0 { -libm::expm1(-sum) } else { f64::NAN }
}
