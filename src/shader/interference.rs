//! What the sum of squares leaves out, in f32: the interference of scratches with the base, and their crossings.
//!
//! The f32 forms of functions of [`diffraction::reflectance`](crate::diffraction::reflectance). Lengths share one unit.

use super::elementary::*;
use super::faddeeva::Complex;
use super::gpu::abs;
use super::profile::{depth_term, width_term};
use super::spatial_phase::{in_radii, turned_back};

/// Returns -2 Re(B S), the interference of base and scratches: |B - S|^2 less |B|^2 + |S|^2 (VWH18 Eq. 6, corrected).
///
/// `base` is B, which is real in the frame of the shaded point, `scratches_re` the real part of the sum of all S.
#[inline(always)]
#[must_use]
pub fn base_interference(base: f32, scratches_re: f32) -> f32 {
    -2.0 * (base * scratches_re)
}

/// Returns a product of two complex numbers.
#[inline(always)]
pub(super) fn complex_product(a: Complex, b: Complex) -> Complex {
    Complex {
        re: a.re * b.re - a.im * b.im,
        im: a.re * b.im + a.im * b.re,
    }
}

/// Returns what two crossing rectangular scratches lack in B - S1 - S2, in the square of the lengths' unit: the product of
/// the depth terms times the transform of the overlap. No paper has it; WVJH17 4.2 neglects it.
///
/// Width, depth and unit tangent of the two scratches, the place where their centre lines meet relative to the shaded
/// point, and the scattering vector, all in the same axes of the surface. No result for parallel scratches.
#[inline(always)]
#[must_use]
#[allow(clippy::too_many_arguments)]
pub fn crossing_response(
    radius: f32,
    wavelength: f32,
    first_width: f32,
    first_depth: f32,
    second_width: f32,
    second_depth: f32,
    first_x: f32,
    first_y: f32,
    second_x: f32,
    second_y: f32,
    crossing_x: f32,
    crossing_y: f32,
    xi_x: f32,
    xi_y: f32,
    gamma_sum: f32,
) -> Complex {
    let sine = first_x * second_y - first_y * second_x;
    // xi = p b1 + q b2 with the bitangents b = (-y, x).
    let p = (xi_x * second_x + xi_y * second_y) / sine;
    let q = -(xi_x * first_x + xi_y * first_y) / sine;
    let overlap = width_term(first_width, p, wavelength) * (width_term(second_width, q, wavelength) / abs(sine));
    let x = in_radii(crossing_x, radius);
    let y = in_radii(crossing_y, radius);
    let window = exponential(-0.5 * (x * x + y * y));
    let along = turned_back(overlap * window, crossing_x, xi_x, wavelength);
    let across = turned_back(1.0, crossing_y, xi_y, wavelength);
    let deep = complex_product(
        depth_term(first_depth, gamma_sum, wavelength),
        depth_term(second_depth, gamma_sum, wavelength),
    );
    complex_product(deep, complex_product(along, across))
}
