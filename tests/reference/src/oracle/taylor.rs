//! Si and the antiderivative of sinc^2 from Taylor series about the multiples of 1/2.
//!
//! y = sinc satisfies t y' + y = cos t, so its Taylor coefficients c_n about a follow from those of the cosine, d_n, by
//! c_{n+1} = (d_n/(n+1) - c_n)/a. The series converges everywhere; at |h| <= 1/4 its n-th term is below 4^-n/(n+1)!.

use super::double_double::Dd;
use super::reduction::{INVERSE_FACTORIAL, sin_cos};
use std::sync::LazyLock;

const SPACING: f64 = 0.5;
const SINC_TERMS: usize = 22;
const SQUARE_TERMS: usize = 26;

/// Largest argument of [`sine_integral`].
pub const SINE_INTEGRAL_END: f64 = 80.0;
/// Largest argument of [`sinc_squared_antiderivative`].
pub const SINC_SQUARED_END: f64 = 40.0;

/// A value and the Taylor coefficients of (f(a + h) - f(a))/h about an anchor a.
struct Anchor<const N: usize> {
    value: Dd,
    slope: [Dd; N],
}

impl<const N: usize> Anchor<N> {
    /// Change of the value from the anchor over the step `h`.
    fn step(&self, h: Dd) -> Dd {
        h * self.slope.iter().rev().fold(Dd::ZERO, |sum, &c| c + h * sum)
    }
}

/// Taylor coefficients of sinc about `a`, a multiple of 1/2.
fn sinc_coefficients(a: f64) -> [Dd; SQUARE_TERMS] {
    let mut c = [Dd::ZERO; SQUARE_TERMS];
    let factorial = &*INVERSE_FACTORIAL;
    if a == 0.0 {
        for n in (0..SQUARE_TERMS).step_by(2) {
            let sign = if n % 4 == 0 { 1.0 } else { -1.0 };
            c[n] = factorial[n + 1] * sign;
        }
        return c;
    }
    let (sine, cosine) = sin_cos(a);
    c[0] = sine / a;
    for n in 0..SQUARE_TERMS - 1 {
        let derivative = [cosine, -sine, -cosine, sine][n % 4];
        c[n + 1] = (derivative * factorial[n + 1] - c[n]) / a;
    }
    c
}

/// Coefficients of the square of a power series.
fn squared(c: &[Dd; SQUARE_TERMS]) -> [Dd; SQUARE_TERMS] {
    std::array::from_fn(|n| (0..=n).fold(Dd::ZERO, |sum, k| sum + c[k] * c[n - k]))
}

/// Coefficients of the integral of a power series, divided by the variable.
fn integrated<const N: usize>(c: [Dd; N]) -> [Dd; N] {
    std::array::from_fn(|n| c[n] / (n + 1) as f64)
}

/// Anchors from 0 to `end`, each value reached from the one before by two half steps.
fn anchors<const N: usize>(end: f64, derivative: impl Fn(f64) -> [Dd; N]) -> Vec<Anchor<N>> {
    let mut table: Vec<Anchor<N>> = Vec::new();
    for k in 0..=(end / SPACING) as usize {
        let mut anchor = Anchor {
            value: Dd::ZERO,
            slope: integrated(derivative(k as f64 * SPACING)),
        };
        if let Some(before) = table.last() {
            let half = SPACING / 2.0;
            anchor.value = before.value + before.step(half.into()) - anchor.step((-half).into());
        }
        table.push(anchor);
    }
    table
}

static SINE_INTEGRAL: LazyLock<Vec<Anchor<SINC_TERMS>>> = LazyLock::new(|| {
    anchors(SINE_INTEGRAL_END, |a| {
        let c = sinc_coefficients(a);
        std::array::from_fn(|n| c[n])
    })
});

static SINC_SQUARED: LazyLock<Vec<Anchor<SQUARE_TERMS>>> =
    LazyLock::new(|| anchors(SINC_SQUARED_END, |a| squared(&sinc_coefficients(a))));

fn evaluate<const N: usize>(table: &[Anchor<N>], x: f64) -> Dd {
    let k = (x / SPACING).round();
    let anchor = &table[k as usize];
    anchor.value + anchor.step((x - k * SPACING).into())
}

/// Si(x) for 0 <= x <= 80, relative error about 1e-31.
pub fn sine_integral(x: f64) -> Dd {
    if x < 1e-20 {
        return x.into();
    }
    evaluate(&SINE_INTEGRAL, x)
}

/// Integral of sinc^2 from 0 to `q` for 0 <= q <= 40, absolute error about 1e-31.
pub fn sinc_squared_antiderivative(q: f64) -> Dd {
    evaluate(&SINC_SQUARED, q)
}
