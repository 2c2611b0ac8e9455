//! Profiles across a scratch in f32: the transforms of rectangle and triangle, and the depth term.
//!
//! The f32 forms of [`diffraction::profile`](crate::diffraction::profile). Lengths share one unit; gamma is the sum of
//! the two cosines to the normal, xi the sum of the two direction cosines across the scratch. `tests/diffraction_shader/profiles.rs`
//! holds the errors, for depths to 20 um and widths to 100 um.

use super::elementary::*;
use super::faddeeva::Complex;
use super::gpu::{abs, max, min, select};
use super::turns::*;

/// Half phases of depth and width, in turns and together, up to which a triangle is shallow: phases of 1.75 radians.
pub(super) const TRIANGLE_SHALLOW_LIMIT: f32 = 0.13926058;

/// Returns W sinc(pi W xi/lambda), in the unit of the width (VWH18 Eq. 3).
#[inline(always)]
#[must_use]
pub fn width_term(width: f32, xi_b: f32, wavelength: f32) -> f32 {
    let halves = ratio_turns(width, xi_b, wavelength + wavelength);
    width * sinc_turns(halves, sine_cosine_turns(halves.rest).sine)
}

/// Returns the sine and cosine of half the phase of the depth, pi gamma D/lambda; both may have the other sign.
#[inline(always)]
pub(super) fn depth_half_phase(depth: f32, gamma_sum: f32, wavelength: f32) -> SineCosine {
    sine_cosine_turns(0.5 * ratio_turns(depth, gamma_sum, wavelength).rest)
}

/// Returns 1 - exp(2 pi i (gamma_i + gamma_o) D/lambda), dimensionless (WVJH17 Eq. 20).
#[inline(always)]
#[must_use]
pub fn depth_term(depth: f32, gamma_sum: f32, wavelength: f32) -> Complex {
    let phase = depth_half_phase(depth, gamma_sum, wavelength);
    let twice = phase.sine + phase.sine;
    Complex {
        re: twice * phase.sine,
        im: -(twice * phase.cosine),
    }
}

/// Returns |1 - exp(2 pi i (gamma_i + gamma_o) D/lambda)|^2, from 0 to 4.
#[inline(always)]
#[must_use]
pub fn depth_term_squared(depth: f32, gamma_sum: f32, wavelength: f32) -> f32 {
    let phase = depth_half_phase(depth, gamma_sum, wavelength);
    let twice = phase.sine + phase.sine;
    twice * twice
}

/// Returns W sinc(pi W xi/lambda) (1 - exp(2 pi i (gamma_i + gamma_o) D/lambda)), in the unit of the width: mask less
/// scratch of a rectangle (VWH18 Eq. 3).
#[inline(always)]
#[must_use]
pub fn profile_rectangle(width: f32, depth: f32, xi_b: f32, gamma_sum: f32, wavelength: f32) -> Complex {
    let across = width_term(width, xi_b, wavelength);
    let deep = depth_term(depth, gamma_sum, wavelength);
    Complex {
        re: across * deep.re,
        im: across * deep.im,
    }
}

/// The two sinc of a triangle, at the half sum a and the half difference b of the phases of depth and width.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct TriangleFlanks {
    /// sinc a, times half the width.
    pub(super) sinc_a: f32,
    /// sinc b, times half the width.
    pub(super) sinc_b: f32,
    /// Sine and cosine of a.
    pub(super) a: SineCosine,
    /// Sine and cosine of b.
    pub(super) b: SineCosine,
    /// Half the phase of the depth, (a + b)/2, in turns.
    pub(super) deep: f32,
    /// Half the phase of the width, (a - b)/2, in turns.
    pub(super) across: f32,
}

/// Returns the two sinc of a triangle.
#[inline(always)]
pub(super) fn triangle_flanks(width: f32, depth: f32, xi_b: f32, gamma_sum: f32, wavelength: f32) -> TriangleFlanks {
    let twice = wavelength + wavelength;
    // a and b in turns.
    let deep = ratio_turns(depth, gamma_sum, twice);
    let across = ratio_turns(width, xi_b, twice + twice);
    let sum = Turns {
        whole: deep.whole + across.whole,
        rest: deep.rest + across.rest,
    };
    let difference = Turns {
        whole: deep.whole - across.whole,
        rest: deep.rest - across.rest,
    };
    let a = sine_cosine_turns(sum.rest);
    let b = sine_cosine_turns(difference.rest);
    let halved = 0.5 * width;
    TriangleFlanks {
        sinc_a: halved * sinc_turns(sum, a.sine),
        sinc_b: halved * sinc_turns(difference, b.sine),
        a,
        b,
        deep: deep.whole + deep.rest,
        across: across.whole + across.rest,
    }
}

/// Returns the transform of a triangular groove alone, without its mask, in the unit of the width (WVJH17 Eq. 29).
///
/// Two sinc, each the other's phase: no poles.
#[inline(always)]
#[must_use]
pub fn profile_triangle(width: f32, depth: f32, xi_b: f32, gamma_sum: f32, wavelength: f32) -> Complex {
    let flanks = triangle_flanks(width, depth, xi_b, gamma_sum, wavelength);
    Complex {
        re: flanks.sinc_a * flanks.b.cosine + flanks.sinc_b * flanks.a.cosine,
        im: flanks.sinc_a * flanks.b.sine + flanks.sinc_b * flanks.a.sine,
    }
}

/// Returns (1 - exp(i p (1 - u))) cos(w u) at one u, for half phases p/2 and w/2.
#[inline(always)]
pub(super) fn triangle_shallow_node(deep: f32, across: f32, u: f32) -> Complex {
    let phase = sine_cosine_near(deep * (1.0 - u));
    let height = 2.0 * (phase.sine * sine_cosine_near((across + across) * u).cosine);
    Complex {
        re: height * phase.sine,
        im: -(height * phase.cosine),
    }
}

/// Returns the response of a triangular groove, mask less scratch, in the unit of the width (WVJH17 Eqs. 9 and 29).
///
/// The difference of mask and [`profile_triangle`] in a deep groove, its own two sinc in a wide one, and a Gauss rule of
/// four points where both phases are small: a shallow groove keeps its digits.
#[inline(always)]
#[must_use]
pub fn response_triangle(width: f32, depth: f32, xi_b: f32, gamma_sum: f32, wavelength: f32) -> Complex {
    let flanks = triangle_flanks(width, depth, xi_b, gamma_sum, wavelength);
    let mask = width_term(width, xi_b, wavelength);
    let slope = flanks.deep / flanks.across;
    let is_wide = abs(flanks.deep) <= abs(flanks.across);
    let a_re = flanks.sinc_a * flanks.b.cosine;
    let a_im = flanks.sinc_a * flanks.b.sine;
    let b_re = flanks.sinc_b * flanks.a.cosine;
    let b_im = flanks.sinc_b * flanks.a.sine;
    let re = select(mask - (a_re + b_re), slope * (a_re - b_re), is_wide);
    let im = select(-(a_im + b_im), slope * (a_im - b_im), is_wide);
    // Half phases in radians, bounded where the rule is not used.
    let deep = min(max(TWO_PI * flanks.deep, -0.875), 0.875);
    let across = min(max(TWO_PI * flanks.across, -0.875), 0.875);
    let is_shallow = abs(flanks.deep) + abs(flanks.across) <= TRIANGLE_SHALLOW_LIMIT;
    let n = triangle_shallow_node(deep, across, 0.06943184);
    let o = triangle_shallow_node(deep, across, 0.33000946);
    let p = triangle_shallow_node(deep, across, 0.66999054);
    let q = triangle_shallow_node(deep, across, 0.93056816);
    let outer_re = 0.17392743 * (n.re + q.re);
    let outer_im = 0.17392743 * (n.im + q.im);
    let inner_re = 0.32607257 * (o.re + p.re);
    let inner_im = 0.32607257 * (o.im + p.im);
    Complex {
        re: select(re, width * (outer_re + inner_re), is_shallow),
        im: select(im, width * (outer_im + inner_im), is_shallow),
    }
}
