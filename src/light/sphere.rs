//! Spherical lights.

use super::outline_integral::{self, LightIntegral};
use super::scratch_lobe::ScratchLobe;
use crate::geometry::{Cone, cone_outline};

/// A sphere: its centre relative to the shaded point, and its radius, in one unit of length.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sphere {
    /// Centre in the frame of the scratch: tangent, bitangent, normal.
    pub centre: [f64; 3],
    /// Radius.
    pub radius: f64,
}

/// Returns the integral of a scratch's lobe over the visible part of a sphere.
#[must_use]
pub fn sphere_light(lobe: ScratchLobe, sphere: Sphere) -> f64 {
    let (Some(scales), Some(cone)) = (lobe.scales(), Cone::of_sphere(sphere.centre, sphere.radius)) else {
        return f64::NAN;
    };
    let integral: LightIntegral = outline_integral::exact(scales, |visit| cone_outline(cone, visit));
    integral.value.max(0.0)
}

/// Returns the integral of a scratch's lobe over the visible part of a sphere to a tolerance.
#[must_use]
pub fn sphere_light_within(lobe: ScratchLobe, sphere: Sphere, tolerance: f64) -> LightIntegral {
    let (Some(scales), Some(cone)) = (lobe.scales(), Cone::of_sphere(sphere.centre, sphere.radius)) else {
        return LightIntegral::NAN;
    };
    outline_integral::within(scales, tolerance, |visit| cone_outline(cone, visit))
}
