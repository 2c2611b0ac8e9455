//! The integral of sinc squared over an arc: the light that a scratch diffracts into an interval of directions.
//!
//! # Definition
//!
//! ```math
//! I(q_0, q_1) = \int_{q_0}^{q_1} \frac{\sin^2 t}{t^2}\,dt = H(2 q_1) - H(2 q_0),
//! \qquad H(y) = \mathrm{Si}(y) - \frac{1 - \cos y}{y} = \int_0^y \frac{1 - \cos t}{t^2}\,dt
//! ```
//!
//! The bracket of VWH18 Eq. 27 in q = k W xi / 2: a scratch of width W sends (2/(k W)) I of its sinc^2 lobe between the
//! direction cosines 2 q0/(k W) and 2 q1/(k W).
//!
//! # Domain
//!
//! Any two f64, infinite ones included; swapped bounds change the sign, equal bounds give 0, NaN gives NaN.
//! The whole line gives pi.
//!
//! # Methods
//!
//! [`sinc_squared_integral`] has three cases.
//!
//! - An arc on one side of 0 and shorter than 1 is a Gauss-Legendre sum of sin^2 t / t^2 over 8 points (4 below 1/64),
//!   positive term by term, with the phase of its middle reduced exactly.
//! - With both ends far out on one side it is the difference of the tails pi/2 - H, whose leading terms are subtracted as
//!   (q1 - q0)/(2 q0 q1).
//! - Everything else is the difference or, across 0, the sum of two H, each held as a base and a small rest, which are
//!   subtracted apart.
//!
//! [`sinc_squared_integral_vwh18`] is Eq. 27 with the fit of Eq. 29.
//!
//! <!-- report:begin sinc_squared_integral -->
//!
//! | method | what it is | precision | largest error | promise | time / baseline |
//! |---|---|---|---|---|---|
//! | `accurate` | iridescence f64 | f64 | 9.2 eps | 16 eps | 0.30 (cephes_antiderivative) |
//! | `vwh18` | VWH18 Eq. 27 with Eq. 29 | f64 | 0.10 abs. | 0.103 abs. | 0.71 (cephes_antiderivative) |
//! | `accurate` | iridescence f32 | f32 | 4.5e-7 abs. | 6e-7 abs. | 0.85 (vwh18) |
//! | `medium` | iridescence f32 1e-5 tier | f32 | 3.4e-6 abs. | 5e-6 abs. | 0.77 (vwh18) |
//! | `coarse` | iridescence f32 4e-4 tier | f32 | 2.9e-4 abs. | 4e-4 abs. | 0.64 (vwh18) |
//! | `vwh18` | VWH18 Eq. 27 f32 | f32 | 0.10 abs. | 0.103 abs. | 1.00 (vwh18) |
//! | `accurate`, slice | iridescence f32 slices | f32 | 4.5e-7 abs. | 6e-7 abs. | 1.02 (vwh18) |
//! | `medium`, slice | iridescence f32 1e-5 slices | f32 | 3.4e-6 abs. | 5e-6 abs. | 0.88 (vwh18) |
//! | `coarse`, slice | iridescence f32 4e-4 slices | f32 | 2.9e-4 abs. | 4e-4 abs. | 0.68 (vwh18) |
//! | `vwh18`, slice | VWH18 Eq. 27 f32 slices | f32 | 0.10 abs. | 0.103 abs. | 1.00 (vwh18) |
//!
//! <!-- report:end sinc_squared_integral -->
//!
//! # Where it fails
//!
//! [`sinc_squared_integral`]: nowhere known. [`sinc_squared_integral_vwh18`] loses all digits, and
//! often the sign, on short arcs that do not contain the peak. The cause is the bias of the fit, and that it is not
//! monotone where the true integral is; the map is docs/failures/sinc_squared_integral_vwh18.svg.
//!
//! # Errata
//!
//! VWH18 Eq. 27 is right with q in the denominator of its second term. As printed it is 0/0 at q = 0, where its limit
//! is 0.

use super::cells::{HALF_PI, auxiliary, cell};
use super::tables::{H, TAIL, TAIL_LOW};
use super::{sinc, sine_integral_vwh18};
use crate::numeric::gauss::{EIGHT_POINTS, FOUR_POINTS};
use crate::numeric::phase::{distance_to_half_turn, reduce_half_turns, sine_cosine};

/// Arcs shorter than this are summed by the Gauss rule.
const SHORT: f64 = 1.125;
/// Arcs shorter than this need half the points.
const SHORTER: f64 = 0.015625;
/// Up to here the fast reduction is exact to 2^-53.
const FAST_PHASE: f64 = 67108864.0;
/// From here on (2^110) an oscillation is below an eps of any difference of two different arguments.
const NO_PHASE: f64 = 1.298074214633707e33;

/// Returns the integral of (sin t / t)^2 from `q[0]` to `q[1]` (radians), dimensionless.
///
/// Never negative for q\[0\] <= q\[1\], antisymmetric in its bounds and even in their signs, exactly.
/// Infinite bounds are limits; NaN gives NaN. VWH18 Eq. 27.
///
/// ```
/// use iridescence::special::sinc_squared_integral;
/// assert_eq!(sinc_squared_integral([f64::NEG_INFINITY, f64::INFINITY]), core::f64::consts::PI);
/// // A light well away from the peak still gives a positive radiance.
/// assert!(sinc_squared_integral([100.0, 100.001]) > 0.0);
/// ```
#[must_use]
pub fn sinc_squared_integral(q: [f64; 2]) -> f64 {
    let [q0, q1] = q;
    if q0 > q1 {
        -ordered(q1, q0)
    } else if q0 == q1 {
        0.0
    } else {
        ordered(q0, q1)
    }
}

/// The arc for q0 < q1 (or a NaN).
fn ordered(q0: f64, q1: f64) -> f64 {
    if q0 >= 0.0 {
        one_sided(q0, q1)
    } else if q1 <= 0.0 {
        one_sided(-q1, -q0)
    } else {
        let [(base0, rest0), (base1, rest1)] = half_lines([-q0, q1]);
        (base0 + base1) + (rest0 + rest1)
    }
}

/// The arc for 0 <= a < b.
fn one_sided(a: f64, b: f64) -> f64 {
    let length = b - a;
    if a == 0.0 {
        let (base, rest) = half_line(b);
        base + rest
    } else if length < SHORT {
        short_arc(a, length)
    } else if a >= 0.5 * TAIL_LOW && b >= 0.5 * TAIL {
        let lead = if b < f64::INFINITY {
            (length / b) * (0.5 / a)
        } else {
            0.5 / a
        };
        let [from_a, from_b] = oscillations([a, b]);
        lead + (from_a - from_b)
    } else {
        let (base0, rest0) = half_line(a);
        let (base1, rest1) = half_line(b);
        (base1 - base0) + (rest1 - rest0)
    }
}

/// Returns (base, rest), whose sum is the integral from 0 to q >= 0, H(2q).
#[inline]
fn half_line(q: f64) -> (f64, f64) {
    let y = 2.0 * q;
    if y < TAIL {
        let (base, constant, rest) = cell(&H, 0.5, y);
        (base, constant + rest)
    } else {
        (HALF_PI[0], HALF_PI[1] - (0.5 / q + oscillation(q)))
    }
}

/// [`half_line`] of two arguments, side by side where both are in the tail.
#[inline]
fn half_lines(q: [f64; 2]) -> [(f64, f64); 2] {
    if q[0].min(q[1]) >= 0.5 * TAIL {
        let [wave0, wave1] = oscillations(q);
        [
            (HALF_PI[0], HALF_PI[1] - (0.5 / q[0] + wave0)),
            (HALF_PI[0], HALF_PI[1] - (0.5 / q[1] + wave1)),
        ]
    } else {
        q.map(half_line)
    }
}

/// Returns what is left of pi/2 - H(2q) without its leading term 1/(2q), for q >= TAIL_LOW/2.
#[inline]
fn oscillation(q: f64) -> f64 {
    if q < FAST_PHASE {
        oscillation_of(q, reduce_half_turns(q).0)
    } else if q < NO_PHASE {
        oscillation_of(q, distance_to_half_turn(q))
    } else {
        0.0
    }
}

/// [`oscillation`] of two arguments, side by side where both are below [`FAST_PHASE`].
///
/// Kept out of its callers: on its own the compiler evaluates both in one vector.
#[inline(never)]
fn oscillations(q: [f64; 2]) -> [f64; 2] {
    if q[0].max(q[1]) < FAST_PHASE {
        let r = q.map(|q| reduce_half_turns(q).0);
        [oscillation_of(q[0], r[0]), oscillation_of(q[1], r[1])]
    } else {
        q.map(oscillation)
    }
}

/// [`oscillation`] from the distance r of q to a multiple of pi.
#[inline(always)]
fn oscillation_of(q: f64, r: f64) -> f64 {
    let (sine, cosine) = sine_cosine(r);
    let v = 0.5 / q;
    let w = v * v;
    let (a, b) = auxiliary(w);
    // g(2q) sin 2q - (1/(2q) - f(2q)) cos 2q, the double angle from the single one.
    w * ((1.0 - w * b) * (2.0 * sine * cosine) - v * a * (1.0 - 2.0 * sine * sine))
}

/// The arc from a > 0 over a length below [`SHORT`], by quadrature.
///
/// The middle's distance from a zero of the sine is that of `a`, which is exact, plus half the length: no rounding of
/// the middle itself enters the phase.
fn short_arc(a: f64, length: f64) -> f64 {
    let half = 0.5 * length;
    let middle = a + half;
    let r = distance_to_half_turn(a) + half;
    let wrapped = (r - core::f64::consts::PI) - 1.2246467991473532e-16;
    let phase = sine_cosine(if r > core::f64::consts::FRAC_PI_2 { wrapped } else { r });
    if length < SHORTER {
        half * gauss_sum(&FOUR_POINTS, phase, middle, half)
    } else {
        half * gauss_sum(&EIGHT_POINTS, phase, middle, half)
    }
}

/// The Gauss sum of sin^2 t / t^2 over `middle` - `half` to `middle` + `half`, from the sine and cosine of the middle.
#[inline(always)]
fn gauss_sum<const N: usize>(rule: &[[f64; 2]; N], (sine, cosine): (f64, f64), middle: f64, half: f64) -> f64 {
    let mut terms = [0.0; N];
    for (term, [node, weight]) in terms.iter_mut().zip(rule) {
        let s = half * node;
        let (sine_s, cosine_s) = sine_cosine(s);
        let (even, odd) = (sine * cosine_s, cosine * sine_s);
        let right = (even + odd) / (middle + s);
        let left = (even - odd) / (middle - s);
        *term = weight * (right * right + left * left);
    }
    terms.iter().sum()
}

/// Returns the derivative of [`sinc_squared_integral`] with respect to each bound, \[-sinc^2 q0, sinc^2 q1\].
#[must_use]
pub fn sinc_squared_integral_gradient([q0, q1]: [f64; 2]) -> [f64; 2] {
    let (s0, s1) = (sinc(q0), sinc(q1));
    [-(s0 * s0), s1 * s1]
}

/// Returns the arc by VWH18 Eq. 27 with the fit of Eq. 29 for Si, the limit 0 taken at a bound of 0.
///
/// Kept to compare with; its sign is wrong for many arcs that do not contain the peak. See [`sinc_squared_integral`].
#[must_use]
pub fn sinc_squared_integral_vwh18([q0, q1]: [f64; 2]) -> f64 {
    antiderivative_vwh18(q1) - antiderivative_vwh18(q0)
}

/// Si(2q) - sin^2 q / q, the bracket of Eq. 27.
fn antiderivative_vwh18(q: f64) -> f64 {
    let s = sinc(q);
    sine_integral_vwh18(2.0 * q) - q * s * s
}
