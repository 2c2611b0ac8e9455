//! Densities and samples of the lobes of a scratched surface, in f32: the base lobe, the lobe of a scratch, the
//! published cone, and the balance of two strategies.
//!
//! Directions are given by their components along tangent, bitangent and normal; a density is in 1/sr, and a density of
//! 0 means that there is no direction.

use super::bessel::bessel_i0_scaled;
use super::elementary::*;
use super::faddeeva::INVERSE_ROOT_PI;
use super::gpu::{abs, max, min, select, sqrt};
use super::inverse::*;
use super::sinc_squared_integral::ARC_PI;

/// Narrower scratches, in pi W/lambda, have a flat lobe.
pub(super) const LOBE_NARROW_LIMIT: f32 = 0.000001;
/// Less concentrated cones are uniform.
pub(super) const LOBE_UNIFORM_LIMIT: f32 = 1.0e-7;

/// A sampled direction.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SampledDirection {
    /// The component along the tangent.
    pub x: f32,
    /// The component along the bitangent.
    pub y: f32,
    /// The component along the normal.
    pub z: f32,
    /// The density, in 1/sr; 0 where the draw gives no direction and counts as zero.
    pub pdf: f32,
}

/// Returns the y at which int_-inf^y exp(-t^2) dt/sqrt(pi) is `u`, for 0 <= u < 1.
///
/// Below 2^-25 it stays. The polynomials are those of Giles 2010, "Approximating the erfinv function", Table 5.
#[inline(always)]
#[must_use]
pub fn gaussian_inverse(u: f32) -> f32 {
    let share = max(u, SHARE_SMALLEST_LIMIT);
    let x = (share + share) - 1.0;
    let tail = min(share, 1.0 - share);
    // -ln(1 - x^2) = -ln(4 u (1 - u)): of 1 - x^2 in the middle, of the small factor in the tails.
    let middle = -log_one_minus(x * x);
    let outer = -(natural_log(tail) + (1.3862944 + log_one_minus(tail)));
    let v = select(middle, outer, abs(x) > 0.5);
    let c = v - 2.5;
    let upper_centre =
        0.00021858087 + c * (-4.3915065e-6 + c * (-3.5233877e-6 + c * (3.4327394e-7 + c * 2.8102264e-8)));
    let centre = 1.5014094 + c * (0.24664073 + c * (-0.0041776816 + c * (-0.001253725 + c * upper_centre)));
    let d = sqrt(max(v, 0.0)) - 3.0;
    let upper_far = -0.0036734284 + d * (0.0013493432 + d * (0.00010095056 + d * -0.00020021426));
    let far = 2.8329768 + d * (1.001674 + d * (0.00943887 + d * (-0.007622461 + d * (0.0057395077 + d * upper_far))));
    x * select(centre, far, v >= 5.0)
}

/// Returns k sigma.
#[inline(always)]
pub(super) fn lobe_reduced_radius(radius: f32, wavelength: f32) -> f32 {
    TWO_PI * (radius / wavelength)
}

/// Returns the density of the base lobe, in 1/sr: a Gaussian of direction cosines.
///
/// Radius of the coherence window and wavelength in um; incident and outgoing direction by components along tangent (t),
/// bitangent (b) and normal (n), away from the surface; the incident one above it. 0 for an outgoing one below it.
#[inline(always)]
#[must_use]
#[allow(clippy::too_many_arguments)]
pub fn base_lobe_pdf(
    radius: f32,
    wavelength: f32,
    incident_t: f32,
    incident_b: f32,
    outgoing_t: f32,
    outgoing_b: f32,
    outgoing_n: f32,
) -> f32 {
    let q = lobe_reduced_radius(radius, wavelength);
    let x = q * (incident_t + outgoing_t);
    let y = q * (incident_b + outgoing_b);
    let height = exponential(-(x * x + y * y)) * INVERSE_PI;
    select(q * (q * (height * outgoing_n)), 0.0, outgoing_n <= 0.0)
}

/// Returns a direction of the base lobe from two random numbers of \[0, 1); density 0 for an evanescent draw.
#[inline(always)]
#[must_use]
pub fn base_lobe_sample(
    radius: f32,
    wavelength: f32,
    incident_t: f32,
    incident_b: f32,
    first: f32,
    second: f32,
) -> SampledDirection {
    let q = lobe_reduced_radius(radius, wavelength);
    let size = sqrt(-log_one_minus(first)) / q;
    let turn = sine_cosine_turns(second);
    let x = size * turn.cosine - incident_t;
    let y = size * turn.sine - incident_b;
    let z = sqrt(max((1.0 - x) * (1.0 + x) - y * y, 0.0));
    SampledDirection {
        x,
        y,
        z,
        pdf: base_lobe_pdf(radius, wavelength, incident_t, incident_b, x, y, z),
    }
}

/// Returns the Lorentzian's angle over the directions that propagate, from c (b - g) to c (b + g).
#[inline(always)]
pub(super) fn lobe_lorentz_angle(c: f32, b: f32, g: f32) -> f32 {
    let low = c * (b - g);
    let high = c * (b + g);
    angle_from_axis(1.0 + low * high, c * (g + g))
}

/// Returns the length of (b, n) without underflow at grazing angles: the squares are taken of 2^40 times each.
#[inline(always)]
pub(super) fn lobe_reach(b: f32, n: f32) -> f32 {
    let wide = b * 1099511627776.0;
    let high = n * 1099511627776.0;
    sqrt(wide * wide + high * high) * 9.094947e-13
}

/// Returns the density of the lobe of a scratch, in 1/sr: a Gaussian along it, a Lorentzian across.
///
/// Radius, wavelength and width in um; directions as in [`base_lobe_pdf`].
#[inline(always)]
#[must_use]
#[allow(clippy::too_many_arguments)]
pub fn scratch_lobe_pdf(
    radius: f32,
    wavelength: f32,
    width: f32,
    incident_t: f32,
    incident_b: f32,
    outgoing_t: f32,
    outgoing_b: f32,
    outgoing_n: f32,
) -> f32 {
    let q = lobe_reduced_radius(radius, wavelength);
    let c = ARC_PI * (width / wavelength);
    let along = q * (incident_t + outgoing_t);
    let x = c * (incident_b + outgoing_b);
    let g = lobe_reach(outgoing_b, outgoing_n);
    let curved = c / (lobe_lorentz_angle(c, incident_b, g) * (1.0 + x * x));
    let across = select(curved, 0.5 / g, c < LOBE_NARROW_LIMIT);
    let gaussian = q * (exponential(-(along * along)) * INVERSE_ROOT_PI);
    select(gaussian * (across * outgoing_n), 0.0, outgoing_n <= 0.0)
}

/// Returns a direction of the lobe of a scratch from two random numbers of \[0, 1); density 0 for an evanescent draw.
#[inline(always)]
#[must_use]
#[allow(clippy::too_many_arguments)]
pub fn scratch_lobe_sample(
    radius: f32,
    wavelength: f32,
    width: f32,
    incident_t: f32,
    incident_b: f32,
    first: f32,
    second: f32,
) -> SampledDirection {
    let q = lobe_reduced_radius(radius, wavelength);
    let c = ARC_PI * (width / wavelength);
    let x = gaussian_inverse(first) / q - incident_t;
    let g = sqrt(max((1.0 - x) * (1.0 + x), 0.0));
    // From the end that lies farther from the specular direction, where no difference cancels.
    let b = abs(incident_b);
    let mirrored = incident_b < 0.0;
    let u = select(1.0 - second, second, mirrored);
    let far = c * (b + g);
    let turn = sine_cosine(u * lobe_lorentz_angle(c, b, g));
    let curved = turn.sine * (1.0 + far * far) / (c * (turn.cosine + far * turn.sine));
    let from_end = select(curved, u * (g + g), c < LOBE_NARROW_LIMIT);
    let beta = g - from_end;
    let y = select(beta, -beta, mirrored);
    let z = sqrt(max(from_end * ((g + g) - from_end), 0.0));
    SampledDirection {
        x,
        y,
        z,
        pdf: scratch_lobe_pdf(radius, wavelength, width, incident_t, incident_b, x, y, z),
    }
}

/// Returns 1 - e^(-2 kappa), relatively accurate, for kappa >= 0.
#[inline(always)]
pub(super) fn cone_mass(concentration: f32) -> f32 {
    let z = concentration + concentration;
    let upper = 0.008333334 - z * (0.0013888889 - z * (0.0001984127 - z * 0.000024801588));
    let series = z * (0.5 - z * (0.16666667 - z * (0.041666668 - z * upper)));
    select(1.0 - exponential(-z), z - z * series, z < 0.5)
}

/// Returns the density of the published cone of a scratch, in 1/sr (WVJH17 section 5), for a concentration >= 0.
///
/// Directions as in [`base_lobe_pdf`].
#[inline(always)]
#[must_use]
#[allow(clippy::too_many_arguments)]
pub fn scratch_cone_pdf(
    concentration: f32,
    incident_t: f32,
    incident_b: f32,
    incident_n: f32,
    outgoing_t: f32,
    outgoing_b: f32,
    outgoing_n: f32,
) -> f32 {
    let across_in = sqrt(incident_b * incident_b + incident_n * incident_n);
    let across_out = sqrt(outgoing_b * outgoing_b + outgoing_n * outgoing_n);
    let sum = incident_t + outgoing_t;
    let difference = across_in - across_out;
    let decay = (0.5 * concentration) * (sum * sum + difference * difference);
    let peak = select(
        concentration / cone_mass(concentration),
        0.5,
        concentration < LOBE_UNIFORM_LIMIT,
    );
    let rise = bessel_i0_scaled(concentration * (across_in * across_out));
    let density = peak * ((exponential(-decay) * INVERSE_PI) * rise);
    select(density, 0.0, outgoing_n < 0.0)
}

/// Returns a direction of the published cone from three random numbers of \[0, 1).
#[inline(always)]
#[must_use]
#[allow(clippy::too_many_arguments)]
pub fn scratch_cone_sample(
    concentration: f32,
    incident_t: f32,
    incident_b: f32,
    incident_n: f32,
    first: f32,
    second: f32,
    third: f32,
) -> SampledDirection {
    let curved = -log_one_minus(first * cone_mass(concentration)) / concentration;
    let versine = min(select(curved, first + first, concentration < LOBE_UNIFORM_LIMIT), 2.0);
    let cosine = 1.0 - versine;
    let sine = sqrt(versine * (2.0 - versine));
    let offset = sine_cosine_turns(second);
    let s = sqrt(incident_b * incident_b + incident_n * incident_n);
    let turned = sine * offset.cosine;
    let x = -(incident_t * cosine) - s * turned;
    let across = s * cosine - incident_t * turned;
    let beside = sine * offset.sine;
    let reach = sqrt(across * across + beside * beside);
    let azimuth = sine_cosine_turns(0.5 * third);
    let y = reach * azimuth.cosine;
    let z = reach * azimuth.sine;
    SampledDirection {
        x,
        y,
        z,
        pdf: scratch_cone_pdf(concentration, incident_t, incident_b, incident_n, x, y, z),
    }
}

/// Returns the balance weight of a strategy with the density `own` beside `others`, for finite densities >= 0.
///
/// 0 where both are 0.
#[inline(always)]
#[must_use]
pub fn balance_weight(own: f32, others: f32) -> f32 {
    let ratio = min(own, others) / max(own, others);
    let larger = 1.0 / (1.0 + ratio);
    select(select(ratio * larger, larger, own >= others), 0.0, own == 0.0)
}
