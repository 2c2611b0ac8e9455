//! The integral of sinc squared over an arc, in f32.
//!
//! VWH18 Eq. 27 in q = k W xi / 2, by way of H(2q), the integral from 0 to q. Three cases, chosen so that nothing
//! cancels, all evaluated and one selected: a Gauss-Legendre sum for arcs shorter than 1, the difference of the tails
//! with their leading terms subtracted exactly, and the difference or sum of two H.

use super::coefficients::*;
use super::elementary::*;
use super::gpu::{abs, floor, max, min, round, select};
use super::sine_integral::*;

/// Arcs shorter than this are summed by a Gauss rule.
pub(super) const ARC_SHORT: f32 = 1.0;
/// From here on an end counts as infinite: its inverse is not a normal number any more.
pub(super) const ARC_INFINITE: f32 = 3.0e37;
/// Ends nearer to 0 are left out of the Gauss rule, which divides by them.
pub(super) const ARC_TINY: f32 = 1.0e-30;
/// No phase beyond this.
pub(super) const ARC_PHASE_LIMIT: f32 = 8388608.0;
/// pi as an f32.
pub(super) const ARC_PI: f32 = 3.1415927;
/// Gauss-Legendre, 4 points: the inner node.
pub(super) const GAUSS_INNER: f32 = 0.33998104;
/// Gauss-Legendre, 4 points: the outer node.
pub(super) const GAUSS_OUTER: f32 = 0.8611363;
/// Gauss-Legendre, 4 points: the inner weight.
pub(super) const GAUSS_INNER_WEIGHT: f32 = 0.65214515;
/// Gauss-Legendre, 4 points: the outer weight.
pub(super) const GAUSS_OUTER_WEIGHT: f32 = 0.34785485;
/// Gauss-Legendre, 3 points: the outer node.
pub(super) const GAUSS_THREE: f32 = 0.7745967;
/// Gauss-Legendre, 3 points: the weight of the middle.
pub(super) const GAUSS_THREE_MIDDLE_WEIGHT: f32 = 0.8888889;
/// Gauss-Legendre, 3 points: the weight of the outer nodes.
pub(super) const GAUSS_THREE_OUTER_WEIGHT: f32 = 0.5555556;

/// The two ends of an arc by magnitude, and how they lie.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct ArcEnds {
    /// The end nearer to 0, as a magnitude.
    pub(super) near: f32,
    /// The other end, as a magnitude.
    pub(super) far: f32,
    /// Whether 0 lies between the ends.
    pub(super) straddles: bool,
}

/// Returns the ends of the arc from q0 to q1.
#[inline(always)]
pub(super) fn arc_ends(first: f32, last: f32) -> ArcEnds {
    let a = abs(first);
    let b = abs(last);
    let swap = b < a;
    ArcEnds {
        near: select(a, b, swap),
        far: select(b, a, swap),
        straddles: min(first, last) < 0.0 && max(first, last) > 0.0,
    }
}

/// Returns the two nodes m - s and m + s of the Gauss sum, sin^2 t / t^2 each, added.
#[inline(always)]
pub(super) fn arc_node_pair(middle: SineCosine, node: SineCosine, m: f32, s: f32) -> f32 {
    let even = middle.sine * node.cosine;
    let odd = middle.cosine * node.sine;
    let right = (even + odd) / (m + s);
    let left = (even - odd) / (m - s);
    right * right + left * left
}

/// Returns the phase of the middle of a short arc, within a quarter turn of 0.
#[inline(always)]
pub(super) fn arc_middle_phase(rest: f32, halved: f32) -> f32 {
    let phase = rest + halved;
    select(phase, phase - ARC_PI, phase > HALF_PI)
}

/// Returns one of the three cases of an arc of a given extent from its parts.
///
/// `near_line` and `far_line` are H at the ends where they are below the border, `near_wave` and `far_wave` what the
/// tails have beside 1/(2q), `gauss_sum` the Gauss sum.
#[inline(always)]
#[allow(clippy::too_many_arguments)]
pub(super) fn arc_join(
    ends: ArcEnds,
    extent: f32,
    border: f32,
    near_line: f32,
    far_line: f32,
    near_wave: f32,
    far_wave: f32,
    gauss_sum: f32,
) -> f32 {
    let near_inverse = 0.5 / ends.near;
    let far_inverse = 0.5 / ends.far;
    let near_tail = HALF_PI - (near_inverse + near_wave);
    let far_tail = HALF_PI - (far_inverse + far_wave);
    let near_value = select(near_tail, near_line, ends.near < border);
    let far_value = select(far_tail, far_line, ends.far < border);
    let lead = select(
        (extent * far_inverse) * (near_inverse + near_inverse),
        near_inverse,
        ends.far > ARC_INFINITE,
    );
    let tails = lead + (near_wave - far_wave);
    let between = select(far_value - near_value, tails, ends.near >= border);
    let one_sided = select(between, gauss_sum, extent < ARC_SHORT && ends.near >= ARC_TINY);
    let value = select(one_sided, far_value + near_value, ends.straddles);
    select(value, 0.0, value < 0.0)
}

/// Returns H(2q) for q below the border, to f32 grade.
#[inline(always)]
pub(super) fn arc_head(q: f32) -> f32 {
    let u = q * q;
    let p = ARC_HEAD_A + u * (ARC_HEAD_B + u * (ARC_HEAD_C + u * (ARC_HEAD_D + u * (ARC_HEAD_E + u * ARC_HEAD_F))));
    q + q * (u * p)
}

/// Returns pi/2 - H(2q) - 1/(2q) for q above the border, from the phase of q reduced by half turns, to f32 grade.
#[inline(always)]
pub(super) fn arc_wave(q: f32, phase: SineCosine) -> f32 {
    let v = 0.5 / q;
    let w = v * v;
    let k = w * (ARC_K_A + w * (ARC_K_B + w * (ARC_K_C + w * (ARC_K_D + w * ARC_K_E))));
    let d = 1.0 + w * (ARC_D_A + w * (ARC_D_B + w * (ARC_D_C + w * (ARC_D_D + w * ARC_D_E))));
    let m = 1.0 + w * (ARC_G_A + w * (ARC_G_B + w * (ARC_G_C + w * ARC_G_D)));
    let twice = phase.sine + phase.sine;
    let double_sine = twice * phase.cosine;
    let double_cosine = 1.0 - twice * phase.sine;
    (double_sine * (w * m) - double_cosine * (v * k)) / d
}

/// Returns the Gauss sum over a short arc that begins at q with the phase `rest`, to f32 grade.
#[inline(always)]
pub(super) fn arc_short(q: f32, extent: f32, rest: f32) -> f32 {
    let halved = 0.5 * extent;
    let m = q + halved;
    let middle = sine_cosine_near(arc_middle_phase(rest, halved));
    let inner = halved * GAUSS_INNER;
    let outer = halved * GAUSS_OUTER;
    let inner_pair = arc_node_pair(middle, sine_cosine_near(inner), m, inner);
    let outer_pair = arc_node_pair(middle, sine_cosine_near(outer), m, outer);
    halved * (GAUSS_INNER_WEIGHT * inner_pair + GAUSS_OUTER_WEIGHT * outer_pair)
}

/// Returns the arc from its ends, its extent and the phases of its ends reduced by half turns, to f32 grade.
#[inline(always)]
pub(super) fn arc_of_phases(ends: ArcEnds, extent: f32, near_rest: f32, far_rest: f32) -> f32 {
    let near_wave = arc_wave(ends.near, sine_cosine_near(near_rest));
    let far_wave = arc_wave(ends.far, sine_cosine_near(far_rest));
    let gauss_sum = arc_short(ends.near, extent, near_rest);
    arc_join(
        ends,
        extent,
        ARC_BORDER,
        arc_head(ends.near),
        arc_head(ends.far),
        near_wave,
        far_wave,
        gauss_sum,
    )
}

/// Returns the integral of (sin t / t)^2 from q0 to q1 (radians), whose difference is known apart from them, to f32 grade;
/// `extent` is its magnitude.
#[inline(always)]
pub(super) fn arc_of_extent(first: f32, last: f32, extent: f32) -> f32 {
    let ends = arc_ends(first, last);
    let near = reduce_half_turns(min(ends.near, ARC_PHASE_LIMIT));
    let far = reduce_half_turns(min(ends.far, ARC_PHASE_LIMIT));
    let value = arc_of_phases(ends, extent, near.rest, far.rest);
    select(value, -value, last < first)
}

/// Returns the integral of (sin t / t)^2 from q0 to q1 (radians), to f32 grade.
///
/// Never negative for q0 <= q1, antisymmetric in its bounds, even in their signs. The phase is exact to 1e-7 for
/// |q| to 1e4. VWH18 Eq. 27.
#[inline(always)]
#[must_use]
pub fn sinc_squared_integral(first: f32, last: f32) -> f32 {
    let signed = arc_of_extent(first, last, abs(abs(last) - abs(first)));
    select(signed, 0.0, first == last)
}

/// Returns the distance of the product x y from the nearest integer, exact to 3e-8 for 0 <= x < 256 and |y| <= 2.
///
/// Both factors are cut so that the product of their leading parts fits 24 bits.
#[inline(always)]
pub(super) fn product_fraction(x: f32, y: f32) -> f32 {
    let x_high = floor(x * 16.0) * 0.0625;
    let y_high = floor(y * 2048.0) * 0.00048828125;
    let product = x_high * y_high;
    let rest = x_high * (y - y_high) + (x - x_high) * y;
    // The bounds change nothing; they keep a compiler that reorders sums from joining the large terms to the small.
    let leading = min(product - round(product), 0.5);
    let fraction = leading + min(rest, 0.5);
    fraction - round(fraction)
}

/// Returns the integral of (sin t / t)^2 over t = pi (W/lambda) xi between two direction cosines, to f32 grade.
///
/// `width` is W/lambda, from 0 to 256, dimensionless; `first` and `last` are direction cosines from -2 to 2. The phase
/// is reduced in turns before it is rounded, so that wide scratches lose nothing. Wider scratches lose digits in
/// proportion; a negative width has no meaning. VWH18 Eq. 27.
#[inline(always)]
#[must_use]
pub fn sinc_squared_integral_turns(width: f32, first: f32, last: f32) -> f32 {
    let xi = arc_ends(first, last);
    let scale = ARC_PI * width;
    let ends = ArcEnds {
        near: scale * xi.near,
        far: scale * xi.far,
        straddles: xi.straddles,
    };
    let near_rest = ARC_PI * product_fraction(width, xi.near);
    let far_rest = ARC_PI * product_fraction(width, xi.far);
    let value = arc_of_phases(ends, scale * (xi.far - xi.near), near_rest, far_rest);
    let signed = select(value, -value, last < first);
    select(signed, 0.0, first == last)
}

/// Returns H(2q) for q below the border, to 1e-8.
#[inline(always)]
pub(super) fn arc_head_medium(q: f32) -> f32 {
    let u = q * q;
    let p = ARC_MEDIUM_HEAD_A
        + u * (ARC_MEDIUM_HEAD_B + u * (ARC_MEDIUM_HEAD_C + u * (ARC_MEDIUM_HEAD_D + u * ARC_MEDIUM_HEAD_E)));
    q + q * (u * p)
}

/// Returns pi/2 - H(2q) - 1/(2q) for q above the border, to about 1e-6 of 1/(2q).
#[inline(always)]
pub(super) fn arc_wave_medium(q: f32, phase: SineCosine) -> f32 {
    let v = 0.5 / q;
    let w = v * v;
    let k = w * (ARC_MEDIUM_K_A + w * (ARC_MEDIUM_K_B + w * (ARC_MEDIUM_K_C + w * ARC_MEDIUM_K_D)));
    let d = 1.0 + w * (ARC_MEDIUM_D_A + w * (ARC_MEDIUM_D_B + w * (ARC_MEDIUM_D_C + w * ARC_MEDIUM_D_D)));
    let m = 1.0 + w * (ARC_MEDIUM_G_A + w * (ARC_MEDIUM_G_B + w * ARC_MEDIUM_G_C));
    let twice = phase.sine + phase.sine;
    let double_sine = twice * phase.cosine;
    let double_cosine = 1.0 - twice * phase.sine;
    (double_sine * (w * m) - double_cosine * (v * k)) / d
}

/// Returns the arc of [`sinc_squared_integral`] to 5e-6 absolute.
#[inline(always)]
#[must_use]
pub fn sinc_squared_integral_medium(first: f32, last: f32) -> f32 {
    let ends = arc_ends(first, last);
    let extent = ends.far - ends.near;
    let near = reduce_half_turns(min(ends.near, ARC_PHASE_LIMIT));
    let far = reduce_half_turns(min(ends.far, ARC_PHASE_LIMIT));
    let near_wave = arc_wave_medium(ends.near, sine_cosine_near_medium(near.rest));
    let far_wave = arc_wave_medium(ends.far, sine_cosine_near_medium(far.rest));
    let halved = 0.5 * extent;
    let m = ends.near + halved;
    let middle = sine_cosine_near_medium(arc_middle_phase(near.rest, halved));
    let inner = halved * GAUSS_INNER;
    let outer = halved * GAUSS_OUTER;
    let inner_pair = arc_node_pair(middle, sine_cosine_near_medium(inner), m, inner);
    let outer_pair = arc_node_pair(middle, sine_cosine_near_medium(outer), m, outer);
    let gauss_sum = halved * (GAUSS_INNER_WEIGHT * inner_pair + GAUSS_OUTER_WEIGHT * outer_pair);
    let value = arc_join(
        ends,
        extent,
        ARC_MEDIUM_BORDER,
        arc_head_medium(ends.near),
        arc_head_medium(ends.far),
        near_wave,
        far_wave,
        gauss_sum,
    );
    let signed = select(value, -value, last < first);
    select(signed, 0.0, first == last)
}

/// Returns H(2q) for q below the border, to 6e-6.
#[inline(always)]
pub(super) fn arc_head_coarse(q: f32) -> f32 {
    let u = q * q;
    let p = ARC_COARSE_HEAD_A + u * (ARC_COARSE_HEAD_B + u * (ARC_COARSE_HEAD_C + u * ARC_COARSE_HEAD_D));
    q + q * (u * p)
}

/// Returns pi/2 - H(2q) - 1/(2q) for q above the border, to about 3e-4 of 1/(2q).
#[inline(always)]
pub(super) fn arc_wave_coarse(q: f32, phase: SineCosine) -> f32 {
    let v = 0.5 / q;
    let w = v * v;
    let k = w * (ARC_COARSE_K_A + w * (ARC_COARSE_K_B + w * ARC_COARSE_K_C));
    let d = 1.0 + w * (ARC_COARSE_D_A + w * (ARC_COARSE_D_B + w * ARC_COARSE_D_C));
    let m = 1.0 + w * (ARC_COARSE_G_A + w * ARC_COARSE_G_B);
    let twice = phase.sine + phase.sine;
    let double_sine = twice * phase.cosine;
    let double_cosine = 1.0 - twice * phase.sine;
    (double_sine * (w * m) - double_cosine * (v * k)) / d
}

/// Returns the arc of [`sinc_squared_integral`] to 4e-4 absolute.
#[inline(always)]
#[must_use]
pub fn sinc_squared_integral_coarse(first: f32, last: f32) -> f32 {
    let ends = arc_ends(first, last);
    let extent = ends.far - ends.near;
    let near = reduce_half_turns(min(ends.near, ARC_PHASE_LIMIT));
    let far = reduce_half_turns(min(ends.far, ARC_PHASE_LIMIT));
    let near_wave = arc_wave_coarse(ends.near, sine_cosine_near_coarse(near.rest));
    let far_wave = arc_wave_coarse(ends.far, sine_cosine_near_coarse(far.rest));
    let halved = 0.5 * extent;
    let m = ends.near + halved;
    let middle = sine_cosine_near_coarse(arc_middle_phase(near.rest, halved));
    let outer = halved * GAUSS_THREE;
    let pair = arc_node_pair(middle, sine_cosine_near_coarse(outer), m, outer);
    let centre = middle.sine / m;
    let gauss_sum = halved * (GAUSS_THREE_OUTER_WEIGHT * pair + (GAUSS_THREE_MIDDLE_WEIGHT * centre) * centre);
    let value = arc_join(
        ends,
        extent,
        ARC_COARSE_BORDER,
        arc_head_coarse(ends.near),
        arc_head_coarse(ends.far),
        near_wave,
        far_wave,
        gauss_sum,
    );
    let signed = select(value, -value, last < first);
    select(signed, 0.0, first == last)
}

/// Returns the bracket of VWH18 Eq. 27, Si(2q) - sin^2 q / q with the fit of Eq. 29, 0 at q = 0.
#[inline(always)]
pub(super) fn arc_antiderivative_velinov(q: f32) -> f32 {
    let sine = sine_cosine(q).sine;
    let square = select(sine * sine / q, 0.0, q == 0.0);
    sine_integral_velinov(q + q) - square
}

/// Returns the arc by VWH18 Eq. 27 with the fit of Eq. 29.
///
/// Kept to compare with: negative for many arcs that do not contain the peak.
#[inline(always)]
#[must_use]
pub fn sinc_squared_integral_velinov(first: f32, last: f32) -> f32 {
    arc_antiderivative_velinov(last) - arc_antiderivative_velinov(first)
}
