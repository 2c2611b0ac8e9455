//! The distribution of sinc^2 x / pi: its function and the inverse of it.
//!
//! # Definition
//!
//! ```math
//! F(x) = \frac{1}{\pi} \int_{-\infty}^{x} \frac{\sin^2 t}{t^2}\,dt, \qquad F(x(u)) = u
//! ```
//!
//! The energy of a rectangular scratch across its tangent, in x = pi W xi2/lambda (VWH18 Eq. 3).
//!
//! # Domain
//!
//! F for every f64. The inverse for 0 <= u <= 1: 0 gives -inf, 1/2 gives 0, 1 gives inf, anything else NaN;
//! antisymmetric about 1/2 exactly. Below u = 9e-310 the result leaves the f64 and is -inf.
//!
//! # Methods
//!
//! The middle of the main lobe starts from the series of the inverse. Elsewhere a lobe is known by the mass beyond its
//! ends, and x by the mass between it and the nearer end, which vanishes as the cube of the distance s. In a side lobe the
//! density is sin^2 s over a square that hardly changes, so that twice s is the eccentric anomaly of a parabolic Kepler
//! equation, E - sin E = M, whose series in the cube root of 6 M starts Halley's method. On the main lobe's flank it
//! starts from the polynomial in the cube root that has the derivatives of the inverse at both ends. At most three
//! evaluations of [`sinc_squared_integral()`] follow; a step that is small enough ends it. No difference cancels: beside a
//! zero of sinc the distance to it keeps its relative accuracy.
//!
//! <!-- report:begin sinc_squared_inverse -->
//!
//! | method | what it is | precision | largest error | promise | time / baseline |
//! |---|---|---|---|---|---|
//! | `accurate` | iridescence f64 | f64 | 5.8e-13 rel. | 1.2e-12 rel. | 1.00 (accurate) |
//! | `accurate` | the same on u within 8 f64 of the probability of n pi, 1 <= \|n\| <= 40 | f64 | 4.1e-6 rel. | 1e-5 rel. | not timed |
//!
//! <!-- report:end sinc_squared_inverse -->
//!
//! # Where it fails
//!
//! The density is zero at the multiples of pi: beside them x follows the cube root of what u has lost in rounding. No
//! method can do better from u alone.
//!
//! # Errata
//!
//! None: the inverse is not in the papers.

use crate::special::sinc_squared_integral;
use core::f64::consts::{FRAC_1_PI, FRAC_PI_2, PI, TAU};

/// int_pi^inf sinc^2.
const SIDE_LOBES: f64 = 0.15264475066226823;
/// Up to here the integral from 0 is in the middle of the main lobe.
const MIDDLE: f64 = 0.9;
/// Below this tail nothing is left of the lobes: it is 1/(2x).
const NO_LOBES: f64 = 1e-16;
/// The distance from pi in powers of the cube root of the mass over that of half the lobe, from the first power.
const MAIN_EDGE: [f64; 6] = [3.47574482, -1.92271936, 0.2640392, 6.09282128, -8.07050561, 3.30221233];
/// The cube of a relative step below this is nothing.
const SMALL_STEP: f64 = 2e-6;

/// Returns int_{-inf}^{x} sinc^2(t) dt/pi, in \[0, 1\].
#[must_use]
pub fn sinc_squared_cdf(x: f64) -> f64 {
    sinc_squared_integral([f64::NEG_INFINITY, x]) * FRAC_1_PI
}

/// Returns the x at which [`sinc_squared_cdf`] is `u`, in radians.
///
/// ```
/// use iridescence::sampling::sinc_squared_inverse;
/// assert_eq!(sinc_squared_inverse(0.5), 0.0);
/// assert_eq!(sinc_squared_inverse(0.125), -sinc_squared_inverse(0.875));
/// assert_eq!(sinc_squared_inverse(1.0), f64::INFINITY);
/// ```
#[must_use]
pub fn sinc_squared_inverse(u: f64) -> f64 {
    if !(0.0..=1.0).contains(&u) {
        f64::NAN
    } else if u < 0.5 {
        -half_line(u)
    } else {
        half_line(1.0 - u)
    }
}

/// The x >= 0 beyond which the share `u` <= 1/2 lies.
fn half_line(u: f64) -> f64 {
    let from_centre = PI * (0.5 - u);
    if from_centre < MIDDLE {
        inverse_from_centre(from_centre)
    } else {
        inverse_from_tail(PI * u)
    }
}

/// Returns the x at which the integral of sinc^2 from 0 is `v`, for 0 <= v < pi/2.
pub(super) fn inverse_from_centre(v: f64) -> f64 {
    if v >= MIDDLE {
        return inverse_from_tail((FRAC_PI_2 - v) + 6.123233995736766e-17);
    }
    let w = v * v;
    let mut x = v * (1.0 + w * (1.0 / 9.0 + w * (19.0 / 675.0 + w * (1.0 / 110.0))));
    for _ in 0..3 {
        let sinc = crate::special::sinc(x);
        let density = sinc * sinc;
        let ratio = (sinc_squared_integral([0.0, x]) - v) / density;
        // Half the logarithmic derivative of the density: cot x - 1/x, which is -x/3 near 0.
        let bend = if x < 0.01 {
            -x / 3.0
        } else {
            1.0 / libm::tan(x) - 1.0 / x
        };
        let step = ratio / (1.0 - ratio * bend);
        x -= step;
        if step.abs() <= SMALL_STEP * x {
            break;
        }
    }
    x
}

/// Returns the x > 0 beyond which the integral of sinc^2 is `r`, for 0 <= r <= 0.7.
pub(super) fn inverse_from_tail(r: f64) -> f64 {
    if r >= SIDE_LOBES {
        return from_main_edge(r - SIDE_LOBES);
    }
    if r < NO_LOBES {
        return 0.5 / r;
    }
    // The tail beyond n pi is f(2 pi n), DLMF 6.2.17, and f(z) is 1/z - 2/z^3 + ...
    let mut n = libm::floor((1.0 / r - 2.0 * r) / TAU).max(1.0);
    let tail = |n: f64| sinc_squared_integral([n * PI, f64::INFINITY]);
    let mut low = tail(n);
    if r > low {
        n -= 1.0;
        low = tail(n);
    }
    let mut high = tail(n + 1.0);
    if r <= high {
        n += 1.0;
        (low, high) = (high, tail(n + 1.0));
    }
    let (from_low, from_high) = (low - r, r - high);
    if from_low < from_high {
        from_edge(n * PI, 1.0, from_low)
    } else {
        from_edge((n + 1.0) * PI, -1.0, from_high)
    }
}

/// The x below pi with the integral `mass` from it to pi.
fn from_main_edge(mass: f64) -> f64 {
    // Up to the second derivative at the edge and the third at the centre.
    let w = libm::cbrt(mass / (FRAC_PI_2 - SIDE_LOBES));
    let [a, b, c, d, e, f] = MAIN_EDGE;
    refined(PI, -1.0, mass, w * (a + w * (b + w * (c + w * (d + w * (e + w * f))))))
}

/// The x on one side of the zero of sinc at `edge`, within half a side lobe, with the integral `mass` between them.
fn from_edge(edge: f64, side: f64, mass: f64) -> f64 {
    // The square under sin^2 at the mean of the mass, three quarters of the way while that is short.
    let mut s = 0.0;
    for _ in 0..3 {
        let middle = edge + side * 0.75 * s;
        s = 0.5 * eccentric_anomaly(4.0 * mass * (middle * middle));
    }
    refined(edge, side, mass, s)
}

/// The x at about the distance `guess` from the zero of sinc at `edge` with the integral `mass` between them.
fn refined(edge: f64, side: f64, mass: f64, guess: f64) -> f64 {
    let mut x = edge + side * guess;
    for _ in 0..3 {
        // After the rounding of x.
        let s = side * (x - edge);
        if s <= 0.0 {
            return edge;
        }
        let (sine, cosine) = libm::sincos(x);
        let sinc = sine / x;
        let reached = side * sinc_squared_integral([edge, x]);
        let ratio = (reached - mass) / (sinc * sinc);
        let step = ratio / (1.0 - ratio * side * (cosine / sine - 1.0 / x));
        x -= side * step;
        if step.abs() <= SMALL_STEP * s {
            break;
        }
    }
    x
}

/// The E with E - sin E = M, 0 <= M <= pi or little beyond, to about a hundredth.
fn eccentric_anomaly(mean: f64) -> f64 {
    let c = libm::cbrt(6.0 * mean);
    let w = c * c;
    c * (1.0 + w * (1.0 / 60.0 + w * (1.0 / 1400.0 + w * (1.0 / 25200.0 + w * (43.0 / 17248000.0)))))
}
