//! The tails of Si and of the sinc^2 integral for large arguments, by their asymptotic series.
//!
//! With the auxiliary functions f and g of DLMF 6.2.17-18 and y >= 80 (the smallest term is e^-80, about 2e-35):
//! pi/2 - Si(x) = f(x) cos x + g(x) sin x, and the integral of sinc^2 from q to infinity is
//! 1/y - P(y) cos y + g(y) sin y with y = 2q and P = 1/y - f, which is of order 2/y^3.

use super::double_double::{Dd, HALF_PI};
use super::reduction::sin_cos;

/// 1/y, P(y) = 1/y - f(y), g(y).
fn auxiliary(y: f64) -> (Dd, Dd, Dd) {
    let inverse = Dd::ONE / y;
    let square = if y < 1e150 { inverse.square() } else { Dd::ZERO };
    // f = (1/y) sum (-1)^n (2n)!/y^2n, g = (1/y^2) sum (-1)^n (2n+1)!/y^2n.
    let (mut term, mut p, mut g) = (Dd::ONE, Dd::ZERO, Dd::ONE);
    let mut n = 1.0;
    while n < 40.0 && term.hi.abs() > 1e-36 {
        // `term` is (2n-1)!/y^(2n-2) with its sign; the n-th terms of f and g follow.
        term = -(term * square * (2.0 * n));
        p = p - term;
        term = term * (2.0 * n + 1.0);
        g = g + term;
        n += 1.0;
    }
    (inverse, inverse * p, square * g)
}

/// Si(x) for x >= 80.
pub fn sine_integral(x: f64) -> Dd {
    let (inverse, p, g) = auxiliary(x);
    let (sine, cosine) = sin_cos(x);
    HALF_PI - (inverse - p) * cosine - g * sine
}

/// The part of the tail beyond 1/y: P(y) cos y - g(y) sin y, with y = 2q.
pub fn oscillation(q: f64) -> Dd {
    if q > 1e60 {
        // Below 1e-60 of the leading term of any arc longer than 3.
        return Dd::ZERO;
    }
    let (_, p, g) = auxiliary(2.0 * q);
    let (sine, cosine) = sin_cos(2.0 * q);
    p * cosine - g * sine
}
