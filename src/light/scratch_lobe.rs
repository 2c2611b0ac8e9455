//! What an area light meets: the angular lobe of an infinite scratch.

use crate::diffraction::Coherence;
use crate::special::sinc_squared_integral;
use core::f64::consts::PI;

/// The angular lobe of an infinite scratch, exp(-(sigma k xi1)^2) sinc^2(k W xi2/2), seen from one direction.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ScratchLobe {
    /// The light at one wavelength: radius sigma and wavelength lambda, in um.
    pub coherence: Coherence,
    /// Width W of the scratch, in um.
    #[doc(alias = "W")]
    pub width: f64,
    /// The direction of view projected on the surface: its components along the tangent and the bitangent.
    #[doc(alias = "omega_o")]
    pub view: [f64; 2],
}

/// The lobe in the units of its two factors.
#[derive(Clone, Copy, Debug)]
pub(super) struct Scales {
    /// sigma k.
    pub(super) along: f64,
    /// k W/2.
    pub(super) across: f64,
    /// Of the direction of view.
    pub(super) view: [f64; 2],
}

impl ScratchLobe {
    /// The scales; none outside the domain.
    pub(super) fn scales(&self) -> Option<Scales> {
        let Coherence { radius, wavelength } = self.coherence;
        let k = 2.0 * PI / wavelength;
        let scales = Scales {
            along: radius * k,
            across: 0.5 * self.width * k,
            view: self.view,
        };
        let view = self.view[0] * self.view[0] + self.view[1] * self.view[1];
        // A unit vector may round beyond 1, in f32 too.
        let valid = scales.along > 0.0
            && scales.along < f64::INFINITY
            && scales.across > 0.0
            && scales.across < f64::INFINITY
            && view <= 1.0 + 1e-6
            && wavelength > 0.0;
        valid.then_some(scales)
    }

    /// Returns the integral of the lobe over the whole plane, sqrt(pi)/(sigma k) times 2 pi/(k W): what a light that covered
    /// all directions, evanescent ones included, would give.
    #[must_use]
    pub fn whole_plane(&self) -> f64 {
        self.scales().map_or(f64::NAN, |s| s.band() * (PI / s.across))
    }
}

impl Scales {
    /// The integral of the Gaussian over the line, sqrt(pi)/(sigma k).
    #[inline]
    pub(super) fn band(&self) -> f64 {
        libm::sqrt(PI) / self.along
    }

    /// The integral of sinc^2 over a chord between two bitangent cosines of light, times k W/2.
    #[inline]
    pub(super) fn chord(&self, [from, to]: [f64; 2]) -> f64 {
        sinc_squared_integral([from, to].map(|y| self.across * (y + self.view[1])))
    }
}
