//! Polygonal lights.

use super::outline_integral::{self, LightIntegral};
use super::scratch_lobe::ScratchLobe;
use crate::geometry::polygon_outline;

/// Returns the integral of a scratch's lobe over the visible part of a polygon.
#[must_use]
pub fn polygon_light(lobe: ScratchLobe, vertices: &[[f64; 3]]) -> f64 {
    let directed = polygon_outline(vertices, |_| {});
    let (Some(scales), true) = (lobe.scales(), directed) else {
        return f64::NAN;
    };
    let integral = outline_integral::exact(scales, |visit| {
        polygon_outline(vertices, visit);
    });
    integral.value.abs()
}

/// Returns the integral of a scratch's lobe over the visible part of a polygon to a tolerance.
#[must_use]
pub fn polygon_light_within(lobe: ScratchLobe, vertices: &[[f64; 3]], tolerance: f64) -> LightIntegral {
    let directed = polygon_outline(vertices, |_| {});
    let (Some(scales), true) = (lobe.scales(), directed) else {
        return LightIntegral::NAN;
    };
    let found = outline_integral::within(scales, tolerance, |visit| {
        polygon_outline(vertices, visit);
    });
    LightIntegral {
        value: found.value.abs(),
        ..found
    }
}
