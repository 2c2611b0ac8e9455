//! The x at which int_{-inf}^{x} (sin t/t)^2 dt/pi is u, to about 28 digits; to 19 beside a zero of sinc, where x hangs on the
//! last digits of pi.
//!
//! By symmetry x >= 0 with int_x^inf = pi min(u, 1 - u), exact in u. That tail is 1/(2x) within 1/(4 x^2), so the root lies
//! within 2 of its first guess: bisection with Newton steps on the oracle of the arc, in f64 up to 1e9, and from there in
//! double-double on the asymptotic series of the tail. Last steps find what the f64 lacks.

use super::double_double::{Dd, two_sum};
use super::scaled::{Scaled, sin_cos};
use super::sinc_squared_integral;
use super::turn_fraction::PI;
use super::turns::beyond;
use crate::metrics::Reference;

/// x from which the asymptotic series is used; with y = 2x, P = 2/y^3 and g = 1/y^2 - 6/y^4 give 1e-36 of the tail.
const FAR: f64 = 1e9;
/// x from which the tail is 1/(2x) to every digit.
const FARTHEST: f64 = 1e34;

/// The tail from x >= 1e9 on, times 2x: 1 - 2x (P cos 2x - g sin 2x).
fn far_tail(x: Dd) -> Dd {
    let inverse = Dd::new(0.5, 0.0) / x;
    let square = inverse.square();
    let (sine, cosine) = sin_cos(&[2.0 * x.hi, 2.0 * x.lo]);
    let p = square * 2.0;
    let g = inverse * (Dd::ONE - square * 6.0);
    Dd::ONE - p * cosine + g * sine
}

/// The root of an increasing function between `lo` and `hi`, to the last bit of a double-double of its size.
fn bisected(mut lo: Dd, mut hi: Dd, is_below: impl Fn(Dd) -> bool) -> Dd {
    for _ in 0..112 {
        let middle = (lo + hi).scale(0.5);
        if is_below(middle) {
            lo = middle;
        } else {
            hi = middle;
        }
    }
    (lo + hi).scale(0.5)
}

/// What the tail from `x` on exceeds `tail` by.
fn excess(x: f64, tail: Dd) -> Dd {
    let value = sinc_squared_integral(x, f64::INFINITY);
    Dd::new(value.hi, value.lo) - tail
}

/// The root in [0, 1e9]: the f64 nearest to it, but for a few units.
fn nearest(tail: Dd) -> f64 {
    let guess = 0.5 / tail.hi;
    let (mut lo, mut hi) = ((guess - 2.0).max(0.0), guess + 2.0);
    let mut x = guess.min(hi);
    for _ in 0..200 {
        let rest = excess(x, tail).hi;
        if rest == 0.0 {
            return x;
        }
        if rest > 0.0 {
            lo = x;
        } else {
            hi = x;
        }
        let sinc = if x < 1e-9 { 1.0 } else { x.sin() / x };
        let newton = x + rest / (sinc * sinc);
        if (newton - x).abs() <= f64::EPSILON * x {
            return x;
        }
        // Newton's step where it stays inside and short of the flat places, where it creeps: the density changes by less
        // than its half over the step.
        let slope = if x < 1e-3 {
            x
        } else {
            2.0 * (x.cos() / x.sin() - 1.0 / x)
        };
        let inside = newton > lo && newton < hi && ((newton - x) * slope).abs() < 0.5;
        let next = if inside { newton } else { 0.5 * (lo + hi) };
        if next == x || next == lo || next == hi {
            return x;
        }
        x = next;
    }
    x
}

/// x >= 0 whose tail is pi `share`, 0 < share <= 1/2.
fn from_tail(share: f64) -> Scaled {
    if share < 0.5 / (std::f64::consts::PI * FARTHEST) {
        return Scaled::from(0.5) / (Scaled::from(share) * Scaled::from(PI));
    }
    let tail = PI * share;
    let guess = Dd::new(0.5, 0.0) / tail;
    if guess.hi > FAR {
        let root = bisected(guess + -2.0, guess + 2.0, |x| {
            (far_tail(x) - tail * x.scale(2.0)).hi > 0.0
        });
        return root.into();
    }
    let arc = PI * (0.5 - share);
    if arc.hi < 1e-7 {
        // The arc from 0 is x - x^3/9 + 2 x^5/225.
        let square = arc.square();
        return (arc * (Dd::ONE + square * (Dd::ONE / 9.0 + square * (Dd::ONE / 27.0 - Dd::new(2.0, 0.0) / 225.0))))
            .into();
    }
    let x = nearest(tail);
    let rest = excess(x, tail);
    // Newton's steps on the arc from `x` on; no f64 share brings the root nearer to a zero of sinc than 1e-5.
    let sinc = x.sin() / x;
    let mut lacking = Dd::ZERO;
    for _ in 0..4 {
        lacking = lacking + (rest - beyond((x, lacking))) / (sinc * sinc);
    }
    (two_sum(x, lacking.hi) + lacking.lo).into()
}

/// The inverse at `u`: minus and plus infinity at 0 and 1, NaN outside.
pub fn sinc_squared_inverse(u: f64) -> Reference {
    if !(0.0..=1.0).contains(&u) {
        return Reference::exact(f64::NAN);
    }
    if u == 0.5 {
        return Reference::exact(0.0);
    }
    let (share, sign) = if u < 0.5 { (u, -1.0) } else { (1.0 - u, 1.0) };
    if share == 0.0 {
        return Reference::exact(sign * f64::INFINITY);
    }
    let x = from_tail(share).reference();
    if sign < 0.0 { -x } else { x }
}
