//! w(z) = exp(-z^2) erfc(-iz) and its derivative, each component to about 30 digits of its own.
//!
//! w = m exp(-z^2) + i x A + y B with even functions A and B of order 1/(1 + |z|^2), so that a component keeps its digits
//! however close to an axis z lies. |z| < 9.5: the trapezoidal or the midpoint sum of the integral over
//! exp(-t^2)/(z^2 - t^2) with the residue of its pole (Chiarella and Reichel 1968; Matta and Reichel 1971), the sum whose
//! nodes lie farther from z. Beyond: the asymptotic series (DLMF 7.12.1). Beside the first zeros: their Taylor series.
//! Where a component cancels elsewhere: [`arbitrary`].

use super::arbitrary;
use super::double_double::{Dd, HALF_PI, two_product};
use super::reduction::Reduced;
use super::scaled::{
    ONE_OVER_ROOT_PI, Scaled, TWO_OVER_ROOT_PI, exponential, minus_real_square, sine_quotient_and_cosine,
};
use super::zeros;
use crate::metrics::Reference;
use std::sync::LazyLock;

/// |z| from which the asymptotic series is used; its smallest term there is e^-90.
const FAR: f64 = 9.5;
/// Distance to the real axis up to which the sum is written with exp(-z^2) apart.
const NEAR_AXIS: f64 = 0.5;
/// The same for the asymptotic series: farther off, exp(-z^2) is no part of it.
const FAR_NEAR_AXIS: f64 = 1e-3;
/// Nodes a unit of the sums; their error is about e^(-9 pi^2).
const NODES: f64 = 3.0;
/// A component that is smaller than its terms by more bits than these is taken from the slow oracle.
const LOST_BITS: i64 = 14;

/// w = m exp(-z^2) + i x A + y B.
#[derive(Clone, Copy)]
pub struct Parts {
    /// A.
    pub along_x: Scaled,
    /// B.
    pub along_y: Scaled,
    /// Whether exp(-z^2) stands apart: m is 1. Otherwise m is 0 above the real axis and 2 below.
    pub apart: bool,
}

/// exp(-z^2), both components.
pub fn gaussian(x: f64, y: f64) -> [Scaled; 2] {
    let size = exponential(minus_real_square(x, y));
    let (quotient, cosine) = sine_quotient_and_cosine(x, y);
    let sine = quotient * Scaled::from(x) * Scaled::from(y);
    [size * cosine.into(), -(size * sine)]
}

/// Squares t^2 and weights (2/(pi NODES)) exp(-t^2) of t = k/NODES and of t = (k + 1/2)/NODES.
static SUM: LazyLock<[Vec<(Dd, Dd, Dd)>; 2]> = LazyLock::new(|| {
    [0.0, 0.5].map(|offset| {
        let nodes = (0..31).map(|k| {
            let t = Dd::from(f64::from(k) + offset) / NODES;
            let mut weight = exponential(-t.square()).value() / (HALF_PI * NODES);
            if t.hi == 0.0 {
                weight = weight.scale(0.5);
            }
            (t, t.square(), weight)
        });
        nodes.collect()
    })
});

/// cosh u and sinh u/u for u >= 0.
fn hyperbolic(u: Dd) -> (Dd, Dd) {
    if u.hi < 1.0 {
        let square = u.square();
        let (mut cosh, mut quotient) = (Dd::ZERO, Dd::ZERO);
        for k in (0..14).rev() {
            let factorial = &*super::reduction::INVERSE_FACTORIAL;
            cosh = cosh * square + factorial[2 * k];
            quotient = quotient * square + factorial[2 * k + 1];
        }
        return (cosh, quotient);
    }
    let grown = exponential(u).value();
    let inverse = Dd::ONE / grown;
    ((grown + inverse).scale(0.5), (grown - inverse).scale(0.5) / u)
}

/// A and B for x, y >= 0 and |z| < 9.5.
fn near(x: f64, y: f64) -> Parts {
    let turns = two_product(NODES, x);
    let turns = turns + -turns.hi.round();
    let midpoint = turns.hi.abs() < 0.25;
    let sigma = if midpoint { 1.0 } else { -1.0 };
    let (square_x, square_y) = (two_product(x, x), two_product(y, y));
    let square = square_x + square_y;
    let (mut a, mut b) = (Dd::ZERO, Dd::ZERO);
    for &(t, square_t, weight) in &SUM[usize::from(midpoint)] {
        let distance = ((t + x).square() + square_y) * ((t + -x).square() + square_y);
        let share = weight / distance;
        a = a + share * (square - square_t);
        b = b + share * (square + square_t);
    }
    // Sine and cosine of 2 pi NODES x, the sine over x.
    let quarters = (4.0 * turns.hi).round();
    let (sine, cosine) = Reduced {
        quadrant: quarters as i32 as u32 & 3,
        remainder: (turns + -0.25 * quarters) * HALF_PI.scale(4.0),
    }
    .sin_cos();
    let rate = HALF_PI * (4.0 * NODES);
    let sine_over_x = if x < 1e-30 { rate } else { sine / x };
    let (quotient, cos_phase) = sine_quotient_and_cosine(x, y);
    let quotient = quotient.value();
    let exponent = minus_real_square(x, y);
    if y <= NEAR_AXIS {
        let (cosh, sinh) = hyperbolic(rate * y);
        let denominator = cosh + cosine * sigma;
        let c_x = -sine_over_x * sigma / denominator;
        let c_y = -(sinh * rate) / denominator;
        let size = exponential(exponent).value();
        return Parts {
            along_x: (a - size * (cos_phase * c_x + square_y * quotient * c_y)).into(),
            along_y: (b + size * (cos_phase * c_y - square_x * quotient * c_x)).into(),
            apart: true,
        };
    }
    let decay = exponential(-(rate * y)).value();
    let shifted = decay + cosine * sigma;
    let denominator = decay.square() + decay * cosine * (2.0 * sigma) + 1.0;
    let size = exponential(exponent - rate * y).value().scale(2.0) / denominator;
    let pole_re = cos_phase * shifted + quotient * x * y * sine * sigma;
    let pole_im = cos_phase * sine_over_x * sigma - quotient * y * shifted;
    Parts {
        along_x: (a + size * pole_im).into(),
        along_y: (b + size * pole_re / y).into(),
        apart: false,
    }
}

/// z over a power of two, and 1/|z|^2, Re z^-2, -Im z^-2/(xy) of the quotient.
struct Far {
    xi: f64,
    eta: f64,
    exponent: i64,
    inverse: Dd,
    p: Dd,
    q: Dd,
}

impl Far {
    fn new(x: f64, y: f64) -> Far {
        let exponent = ((x.abs().max(y.abs()).to_bits() >> 52) & 0x7FF) as i64 - 1023;
        let half = exponent / 2;
        let scale = |x: f64| x * power(-half) * power(half - exponent);
        let (xi, eta) = (scale(x), scale(y));
        let inverse = Dd::ONE / (two_product(xi, xi) + two_product(eta, eta));
        let square = inverse.square();
        Far {
            xi,
            eta,
            exponent,
            inverse,
            p: -(minus_real_square(xi, eta) * square),
            q: square.scale(2.0),
        }
    }

    /// 2^-2e, or so little that it adds nothing to 1.
    fn square_scale(&self) -> f64 {
        power((-2 * self.exponent).max(-1000))
    }

    /// U and V of sum_n (2n - 1)!!/(2 z^2)^n weight(n) = U + i xi eta V 2^-2e, e the exponent.
    fn sums(&self, weight: fn(f64) -> f64) -> (Dd, Dd) {
        let product = two_product(self.xi, self.eta);
        let product = product.square();
        let scale = self.square_scale();
        let (mut a, mut b) = (Dd::ONE, Dd::ZERO);
        let (mut u, mut v) = (Dd::ONE, Dd::ZERO);
        // The terms fall until n = |z|^2.
        let most = if self.exponent > 20 {
            6.0
        } else {
            (power(2 * self.exponent) / self.inverse.hi).min(120.0)
        };
        let mut n = 0.0;
        while n < most {
            // The first step leaves its factor 2^-2e to the sums.
            let factor = (n + 0.5) * if n == 0.0 { 1.0 } else { scale };
            (a, b) = (
                (a * self.p + product * b * self.q) * factor,
                (b * self.p - a * self.q) * factor,
            );
            n += 1.0;
            u = u + a * (weight(n) * scale);
            v = v + b * weight(n);
            if a.hi.abs() + b.hi.abs() < 1e-37 {
                break;
            }
        }
        (u, v)
    }
}

fn power(n: i64) -> f64 {
    f64::from_bits(((n + 1023) as u64) << 52)
}

fn far(x: f64, y: f64) -> Parts {
    let far = Far::new(x, y);
    let (u, v) = far.sums(|_| 1.0);
    let v = v.scale(far.square_scale());
    let scale = far.inverse * ONE_OVER_ROOT_PI;
    let (square_x, square_y) = (two_product(far.xi, far.xi), two_product(far.eta, far.eta));
    Parts {
        along_x: Scaled::new(scale * (u + square_y * v), -2 * far.exponent),
        along_y: Scaled::new(scale * (u - square_x * v), -2 * far.exponent),
        apart: y < FAR_NEAR_AXIS,
    }
}

/// A and B at finite x + iy, of any signs.
pub fn parts(x: f64, y: f64) -> Parts {
    let (x, y) = (x.abs(), y.abs());
    if x.hypot(y) < FAR { near(x, y) } else { far(x, y) }
}

/// m of the definition of [`Parts`].
fn multiple(apart: bool, y: f64) -> f64 {
    match apart {
        true => 1.0,
        false if y < 0.0 => 2.0,
        false => 0.0,
    }
}

/// The sum of two terms of each component, or none where one has lost too many bits.
pub fn sum_of_two(a: [Scaled; 2], b: [Scaled; 2]) -> Option<[Scaled; 2]> {
    let sum = [a[0] + b[0], a[1] + b[1]];
    let lost = (0..2).any(|k| sum[k].has_lost(LOST_BITS, &[a[k], b[k]]));
    (!lost).then_some(sum)
}

/// Whether 2xy leaves the range of f64.
pub fn phase_overflows(x: f64, y: f64) -> bool {
    !(2.0 * x * y).is_finite()
}

/// w as scaled components; none where a component cancels or a phase overflows.
fn components(x: f64, y: f64) -> Option<[Scaled; 2]> {
    let parts = parts(x, y);
    let tail = [parts.along_y * y.into(), parts.along_x * x.into()];
    let m = multiple(parts.apart, y);
    if m == 0.0 {
        return Some(tail);
    }
    if phase_overflows(x, y) {
        return None;
    }
    let [re, im] = gaussian(x, y);
    sum_of_two([re * m.into(), im * m.into()], tail)
}

/// Components as truths, with the signs of exact zeros.
pub fn references([re, im]: [Scaled; 2], zeros: [f64; 2]) -> [Reference; 2] {
    let part = |value: Scaled, zero: f64| {
        if value.size() == i64::MIN {
            Reference::exact(zero)
        } else {
            value.reference()
        }
    };
    [part(re, zeros[0]), part(im, zeros[1])]
}

/// w(re + i im). NaN in either component gives NaN in both; infinities give the limit where it exists, NaN elsewhere.
pub fn faddeeva_w(re: f64, im: f64) -> [Reference; 2] {
    let (x, y) = (re, im);
    if !(x.is_finite() && y.is_finite()) {
        return at_infinity(x, y);
    }
    if let Some(w) = zeros::faddeeva_w(x, y) {
        return [w.re.into(), w.im.into()];
    }
    match components(x, y) {
        Some(w) => references(w, [0.0, 0.0 * x]),
        None => arbitrary::faddeeva::faddeeva_w(x, y),
    }
}

/// The limit of w where a component is infinite: 0 where exp(-z^2) vanishes or has no share, +infinity on the negative
/// imaginary axis, NaN elsewhere.
fn at_infinity(x: f64, y: f64) -> [Reference; 2] {
    let [re, im] = if x.is_nan() || y.is_nan() || (y == f64::NEG_INFINITY && x != 0.0) {
        [f64::NAN; 2]
    } else if y == f64::NEG_INFINITY {
        [f64::INFINITY, 0.0]
    } else {
        [0.0, 0.0]
    };
    [Reference::exact(re), Reference::exact(im.copysign(x))]
}

/// The limit of w' where a component is infinite: 0 where w tends to 0, NaN elsewhere.
fn derivative_at_infinity(x: f64, y: f64) -> [Reference; 2] {
    let limit = at_infinity(x, y);
    if limit[0].hi == 0.0 {
        limit
    } else {
        [Reference::exact(f64::NAN); 2]
    }
}

/// w'(z) = -2 z w + 2i/sqrt(pi).
pub fn faddeeva_w_derivative(re: f64, im: f64) -> [Reference; 2] {
    let (x, y) = (re, im);
    if !(x.is_finite() && y.is_finite()) {
        return derivative_at_infinity(x, y);
    }
    derivative(x, y).unwrap_or_else(|| arbitrary::faddeeva::faddeeva_w_derivative(x, y))
}

fn derivative(x: f64, y: f64) -> Option<[Reference; 2]> {
    let [sx, sy] = [Scaled::from(x), Scaled::from(y)];
    if x.hypot(y) < FAR {
        let [re, im] = match zeros::faddeeva_w(x, y) {
            Some(w) => [w.re.into(), w.im.into()],
            None => components(x, y)?,
        };
        let minus_two = Scaled::from(-2.0);
        let re = sum_of_two(
            [minus_two * sx * re, minus_two * sx * im],
            [-(minus_two * sy * im), minus_two * sy * re],
        )?;
        let sum = sum_of_two(re, [Scaled::ZERO, TWO_OVER_ROOT_PI.into()])?;
        return Some(references(sum, [-0.0 * x, 0.0]));
    }
    let far = Far::new(x, y);
    let (u, v) = far.sums(|n| 2.0 * n + 1.0);
    let product = two_product(far.xi, far.eta).square();
    let shift = -2 * far.exponent;
    let small = v.scale(far.square_scale());
    let re = Scaled::from(ONE_OVER_ROOT_PI * (far.p * small - far.q * u)) * sx * sy;
    let im = Scaled::from(far.p * u) + Scaled::new(product * far.q * v, shift);
    let tail = [re.shift(2 * shift), (im * (-ONE_OVER_ROOT_PI).into()).shift(shift)];
    let m = multiple(y.abs() < FAR_NEAR_AXIS, y);
    if m == 0.0 {
        return Some(references(tail, [-0.0 * x, 0.0]));
    }
    if phase_overflows(x, y) {
        return None;
    }
    // -2 m z exp(-z^2).
    let [re, im] = gaussian(x, y).map(|part| part * (-2.0 * m).into());
    let grown = sum_of_two([sx * re, sx * im], [-(sy * im), sy * re])?;
    Some(references(sum_of_two(grown, tail)?, [-0.0 * x, 0.0]))
}
