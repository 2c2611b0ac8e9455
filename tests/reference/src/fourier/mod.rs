//! Radiance of a scratched surface by a discrete Fourier transform: the surface is rasterised, heights are summed where
//! scratches cross, the transfer function exp(i phase) is multiplied by the coherence window and transformed.
//!
//! Nothing of the closed forms enters it. The raster holds, for each pixel, the mean of window times transfer function
//! under a Gaussian of one pixel's deviation: so it is band limited, needs no edge on a grid line, and the transform is
//! divided by that Gaussian's own. The corners where edges cross are integrated. What the discretisation leaves is held in
//! `tests/fourier.rs`, where ten scratches whose transfer functions are added meet their closed form.
//!
//! The phase of a depth turns with the direction. The transfer function of n scratches of one depth over each other is
//! exp(i n phi), so the parts of the surface with n scratches are transformed apart and joined for each direction.

pub mod figures;
pub mod raster;
pub mod transform;

pub use figures::{Plane, Slice, figure_13, figure_14};
pub use raster::Band;

/// Infinite scratches of one rectangular depth on a mirror, light at normal incidence, window at the origin. Lengths in
/// micrometres.
#[derive(Clone, Debug)]
pub struct Surface {
    /// The scratches.
    pub bands: Vec<Band>,
    /// Depth of all scratches.
    pub depth: f64,
    /// Coherence radius sigma.
    pub radius: f64,
    /// Wavelength.
    pub wavelength: f64,
}

/// A square grid about the origin: points a side, and the step between them in micrometres.
#[derive(Clone, Copy, Debug)]
pub struct Grid {
    /// Points a side.
    pub size: usize,
    /// Step.
    pub step: f64,
}

impl Grid {
    /// The place of a point: pixel centres, so that the origin is a corner of four pixels.
    pub fn place(&self, index: usize) -> f64 {
        (index as f64 + 0.5 - 0.5 * self.size as f64) * self.step
    }

    /// The frequency of an index of the transform, in 1/um.
    pub fn frequency(&self, index: usize) -> f64 {
        let signed = if index < self.size / 2 {
            index as f64
        } else {
            index as f64 - self.size as f64
        };
        signed / (self.size as f64 * self.step)
    }
}
