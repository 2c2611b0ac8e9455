//! Profiles, depth, base response, eta and sampling of scratches: VWH18 section 3.1, WVJH17 sections 3 to 5 and appendices.

use errorfunctions::ComplexErrorFunctions;
use num_complex::Complex;
use std::f64::consts::{PI, SQRT_2};

const I: Complex<f64> = Complex::new(0.0, 1.0);

fn sinc(x: f64) -> f64 {
    if x == 0.0 { 1.0 } else { x.sin() / x }
}

/// VWH18 Eq. 3: the width term, xi2 a direction cosine.
pub fn width_term_vwh18_3(width: f64, xi2: f64, wavelength: f64) -> f64 {
    width * sinc(PI * width * xi2 / wavelength)
}

/// VWH18 Eq. 4: the depth term.
pub fn depth_term_vwh18_4(depth: f64, wavelength: f64) -> Complex<f64> {
    1.0 - (I * (4.0 * PI * depth / wavelength)).exp()
}

/// VWH18 Eq. 8: eta of an infinite scratch.
pub fn spatial_phase_infinite_vwh18_8(sigma: f64, wavelength: f64, offset: f64, xi: [f64; 2]) -> Complex<f64> {
    let k = 2.0 * PI / wavelength;
    let real = -1.0 / (2.0 * sigma.powi(2)) * offset.powi(2) - sigma.powi(2) / 2.0 * k.powi(2) * xi[0].powi(2);
    (2.0 * PI).sqrt() * sigma * Complex::new(real, -k * offset * xi[1]).exp()
}

/// VWH18 Eq. 9: the square of Eq. 8.
pub fn spatial_phase_squared_vwh18_9(sigma: f64, wavelength: f64, offset: f64, xi1: f64) -> f64 {
    let k = 2.0 * PI / wavelength;
    2.0 * (PI * sigma.powi(2)) * (-offset.powi(2) / sigma.powi(2) - sigma.powi(2) * k.powi(2) * xi1.powi(2)).exp()
}

/// VWH18 Eq. 10: the angular and the spatial part of Eq. 9.
pub fn spatial_phase_parts_vwh18_10(sigma: f64, wavelength: f64, offset: f64, xi1: f64) -> [f64; 2] {
    let k = 2.0 * PI / wavelength;
    [
        (-sigma.powi(2) * k.powi(2) * xi1.powi(2)).exp(),
        2.0 * (PI * sigma.powi(2)) * (-offset.powi(2) / sigma.powi(2)).exp(),
    ]
}

/// VWH18 Eq. 11: the square of Eq. 4.
pub fn depth_squared_vwh18_11(depth: f64, wavelength: f64) -> f64 {
    2.0 - 2.0 * (4.0 * PI * depth / wavelength).cos()
}

/// VWH18 Eq. 6, first member: |B|^2 + |S|^2 - 2 B* S, a complex number as it stands.
pub fn squared_difference_vwh18_6(base: Complex<f64>, scratches: Complex<f64>) -> Complex<f64> {
    base.norm_sqr() + scratches.norm_sqr() - 2.0 * base.conj() * scratches
}

/// VWH18 Eq. 26: the largest standard deviation of the Gaussian, lengths in one unit.
pub fn largest_deviation_vwh18_26(longest_wavelength: f64, sigma: f64) -> f64 {
    longest_wavelength / (2.0 * SQRT_2 * PI * sigma)
}

/// WVJH17 Eq. 15 with F = 1: the reflectance, with the cosine of incidence before it. VWH18 Eq. 1 has none.
pub fn reflectance_wvjh17_15(gamma_in: f64, sigma: f64, wavelength: f64, response: Complex<f64>) -> f64 {
    gamma_in * 1.0 / (PI * sigma.powi(2)) * (1.0 / wavelength.powi(2)) * response.norm_sqr()
}

/// WVJH17 Eq. 16: the base response; xi' = xi/lambda.
pub fn base_response_wvjh17_16(sigma: f64, xi: [f64; 2]) -> f64 {
    2.0 * PI * sigma.powi(2) * (-2.0 * PI.powi(2) * sigma.powi(2) * (xi[0].powi(2) + xi[1].powi(2))).exp()
}

/// WVJH17 Eq. 19: the width term; xi' = xi/lambda by Eq. 5.
pub fn width_term_wvjh17_19(width: f64, xi2: f64, wavelength: f64) -> f64 {
    width * sinc(PI * width / wavelength * xi2)
}

/// WVJH17 Eq. 20: the depth term.
pub fn depth_term_wvjh17_20(depth: f64, gamma_sum: f64, wavelength: f64) -> Complex<f64> {
    1.0 - (I * (2.0 * PI * gamma_sum * depth / wavelength)).exp()
}

/// WVJH17 Eq. 28: the phase of the depth.
pub fn depth_phase_wvjh17_28(depth: f64, gamma_sum: f64, wavelength: f64) -> Complex<f64> {
    (-I * (2.0 * PI * gamma_sum * depth / wavelength)).exp()
}

/// WVJH17 Eq. 21: the standard deviation of |B|^2 in 1/length.
pub fn base_deviation_wvjh17_21(sigma: f64) -> f64 {
    1.0 / (8f64.sqrt() * PI * sigma)
}

/// WVJH17 Eq. 22: the direction of a sampled frequency.
pub fn base_direction_wvjh17_22(frequency: [f64; 2], incident: [f64; 2]) -> [f64; 2] {
    [frequency[0] - incident[0], frequency[1] - incident[1]]
}

/// The two misprints of WVJH17 Eqs. 29 to 31, each as printed or mended.
#[derive(Clone, Copy, Debug, Default)]
pub struct TriangleRepairs {
    /// W xi2' in the first exponential of Eq. 29, where xi2' is printed.
    pub width: bool,
    /// The phase of Eq. 28 with the sign of Eq. 20.
    pub sign: bool,
}

/// WVJH17 Eqs. 29 to 31: the transform of a triangular groove; xi' = xi/lambda.
pub fn profile_triangle_wvjh17_29([width, depth, xi2, gamma_sum, wavelength]: [f64; 5]) -> Complex<f64> {
    profile_triangle_repaired(TriangleRepairs::default(), [width, depth, xi2, gamma_sum, wavelength])
}

/// The same with the repairs chosen. `xi2` is the direction cosine, xi2' = xi2/lambda.
pub fn profile_triangle_repaired(
    repairs: TriangleRepairs,
    [width, depth, xi2, gamma_sum, wavelength]: [f64; 5],
) -> Complex<f64> {
    let xi2 = xi2 / wavelength;
    let printed = depth_phase_wvjh17_28(depth, gamma_sum, wavelength);
    let phase = if repairs.sign { printed.conj() } else { printed };
    let b = I * phase / (2.0 * PI * (xi2 - 2.0 * depth * gamma_sum / (width * wavelength)));
    let c = I * phase / (2.0 * PI * (xi2 + 2.0 * depth * gamma_sum / (width * wavelength)));
    let factor = if repairs.width { width } else { 1.0 };
    b * (1.0 - (PI * I * (factor * xi2 - 2.0 * depth * gamma_sum / wavelength)).exp())
        + c * ((-PI * I * (width * xi2 + 2.0 * depth * gamma_sum / wavelength)).exp() - 1.0)
}

/// WVJH17 Eqs. 23 and 24: eta of a scratch of a length about the place `r0`, in the plane of the surface with the unit
/// tangent `tangent`; xi' = xi/lambda in that plane.
pub fn spatial_phase_wvjh17_23(sigma: f64, r0: [f64; 2], tangent: [f64; 2], length: f64, xi: [f64; 2]) -> Complex<f64> {
    let dot = |a: [f64; 2], b: [f64; 2]| a[0] * b[0] + a[1] * b[1];
    let (along, xi1) = (dot(tangent, r0), dot(tangent, xi));
    let a0 = Complex::new(along / sigma, 2.0 * PI * sigma * xi1);
    let h = -dot(r0, r0) / (2.0 * sigma.powi(2)) - 2.0 * PI.powi(2) * sigma.powi(2) * xi1.powi(2)
        + along.powi(2) / (2.0 * sigma.powi(2));
    let f = 2.0 * PI * xi1 * along - 2.0 * PI * dot(r0, xi);
    let c0 = (PI / 2.0).sqrt() * sigma * Complex::new(h, f).exp();
    let erf = |x: Complex<f64>| ComplexErrorFunctions::erf(x / SQRT_2);
    c0 * (erf(a0 + length / (2.0 * sigma)) - erf(a0 - length / (2.0 * sigma)))
}

/// exp(h) of WVJH17 Eq. 24 at xi' = 0, in f32 as a shader runs it.
pub fn spatial_weight_wvjh17_24_f32(sigma: f32, r0: [f32; 2], tangent: [f32; 2]) -> f32 {
    let dot = |a: [f32; 2], b: [f32; 2]| a[0] * b[0] + a[1] * b[1];
    let h = -dot(r0, r0) / (2.0 * sigma.powi(2)) + dot(tangent, r0).powi(2) / (2.0 * sigma.powi(2));
    h.exp()
}

/// WVJH17 section 5: the density of the sampled cone, theta_i and theta_o the angles to the tangent.
pub fn scratch_cone_wvjh17(concentration: f64, theta_in: f64, theta_out: f64) -> f64 {
    concentration / (4.0 * PI * concentration.sinh())
        * (-concentration * theta_in.cos() * theta_out.cos()).exp()
        * bessel_i0(concentration * theta_in.sin() * theta_out.sin())
}

/// I0 by its power series: infinite where I0 exceeds f64, as any library's.
fn bessel_i0(x: f64) -> f64 {
    let quarter = (x / 2.0).powi(2);
    let (mut term, mut sum, mut k) = (1.0, 1.0, 1.0);
    while term > 1e-17 * sum && term < f64::INFINITY {
        term *= quarter / (k * k);
        sum += term;
        k += 1.0;
    }
    sum
}
