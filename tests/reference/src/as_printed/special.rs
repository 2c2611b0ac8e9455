//! Sine integral, band integral and difference of error functions: VWH18 Eqs. 5, 27 and 29, WVJH17 Eqs. 23 and 24.

use errorfunctions::ComplexErrorFunctions;
use num_complex::Complex;
use std::f64::consts::SQRT_2;

const A0: f64 = 0.66142739;
const B0: f64 = 0.38272292;

/// sgn as the paper needs it: 0 at 0.
fn sgn(x: f64) -> f64 {
    if x > 0.0 {
        1.0
    } else if x < 0.0 {
        -1.0
    } else {
        x
    }
}

/// VWH18 Eq. 29: Si(x) as "the superposition of a sigmoid and a hyperbolically decaying oscillation".
pub fn sine_integral_vwh18_29(x: f64) -> f64 {
    sine_integral_signs([1.0, -1.0, -1.0, 1.0, 1.0, 1.0], x)
}

/// VWH18 Eq. 29 with the sign of each part chosen: of tanh, of the hyperbola, of b0, of the oscillation, of the cosine
/// within it, and of x in its denominator. `[1, -1, -1, 1, 1, 1]` is the printed formula; the others answer whether a
/// sign was misprinted.
pub fn sine_integral_signs(signs: [f64; 6], x: f64) -> f64 {
    let [sigmoid, hyperbola, shift, oscillation, cosine, size] = signs;
    let (a0, b0) = (A0, B0);
    sigmoid * (std::f64::consts::PI / 2.0) * x.tanh()
        + hyperbola * (a0 * x) / (1.0 + (x + shift * sgn(x) * b0).powi(2))
        + oscillation * sgn(x) * (1.0 - cosine * x.cos()) / (1.0 + size * x.abs())
}

/// VWH18 Eq. 29 in f32, as a shader runs it.
pub fn sine_integral_vwh18_29_f32(x: f32) -> f32 {
    let (a0, b0) = (A0 as f32, B0 as f32);
    let sgn = sgn(f64::from(x)) as f32;
    std::f32::consts::PI / 2.0 * x.tanh() - a0 * x / (1.0 + (x - sgn * b0).powi(2))
        + sgn * (1.0 - x.cos()) / (1.0 + x.abs())
}

/// VWH18 Eq. 27, N(xi, q), with the sine integral that is put into it. 0/0 at q = 0, as printed.
pub fn band_antiderivative_vwh18_27(sigma: f64, k: f64, width: f64, q: f64, si: impl Fn(f64) -> f64) -> f64 {
    let kw = k * width;
    std::f64::consts::PI.sqrt() / (sigma * k)
        * (2.0 * si(kw * q) / kw - 4.0 * (kw * q / 2.0).sin().powi(2) / (k.powi(2) * width.powi(2) * q))
}

/// The integral of sinc^2 from `q0` to `q1` as Eq. 27 gives it: the bracket of N(q1) - N(q0) at k W = 2, Eq. 29 inside.
pub fn sinc_squared_integral_vwh18_27([q0, q1]: [f64; 2]) -> f64 {
    let bracket = |q: f64| sine_integral_vwh18_29(2.0 * q) - q.sin().powi(2) / q;
    bracket(q1) - bracket(q0)
}

/// The same in f32.
pub fn sinc_squared_integral_vwh18_27_f32(q0: f32, q1: f32) -> f32 {
    let bracket = |q: f32| sine_integral_vwh18_29_f32(2.0 * q) - q.sin().powi(2) / q;
    bracket(q1) - bracket(q0)
}

/// exp(-b^2) [erf(a2 + ib) - erf(a1 + ib)] as the factors stand in WVJH17 Eq. 23 and 24 and VWH18 Eq. 5, with the complex
/// erf of crate `errorfunctions`.
pub fn erf_difference([a1, a2, b]: [f64; 3]) -> Complex<f64> {
    let erf = |a: f64| ComplexErrorFunctions::erf(Complex::new(a, b));
    (-b * b).exp() * (erf(a2) - erf(a1))
}

/// The same in f32. Its erf is exact but for rounding to f32: no f32 implementation could give more.
pub fn erf_difference_f32([a1, a2, b]: [f32; 3]) -> Complex<f32> {
    let erf = |a: f32| {
        let value = ComplexErrorFunctions::erf(Complex::new(f64::from(a), f64::from(b)));
        Complex::new(value.re as f32, value.im as f32)
    };
    (-b * b).exp() * (erf(a2) - erf(a1))
}

/// A finite scratch before its coherence window, lengths in one unit: the coherence radius, the place of the window's
/// centre along the scratch, and the ends of the scratch.
#[derive(Clone, Copy, Debug)]
pub struct Segment {
    /// Coherence radius sigma.
    pub sigma: f64,
    /// s_t, where the scratch's origin lies along the tangent.
    pub offset: f64,
    /// l1 and l2.
    pub ends: [f64; 2],
}

impl Segment {
    /// a1, a2 and b of the two error functions of VWH18 Eq. 5: (s_t + l)/(sqrt2 sigma) and sigma k xi1/sqrt2.
    pub fn arguments(&self, wave_number: f64, xi1: f64) -> [f64; 3] {
        let [a1, a2] = self.ends.map(|l| (self.offset + l) / self.sigma / SQRT_2);
        [a1, a2, self.sigma * wave_number * xi1 / SQRT_2]
    }
}

/// VWH18 Eq. 5: the difference of erf(((s_t + h)/sigma + i sigma k xi1)/sqrt2) between h = l1 and h = l2. It grows like
/// exp(b^2); the factor exp(-b^2) stands apart, in h of WVJH17 Eq. 24.
pub fn spatial_phase_vwh18_5(segment: &Segment, wave_number: f64, xi1: f64) -> Complex<f64> {
    let [a1, a2, b] = segment.arguments(wave_number, xi1);
    let erf = |a: f64| ComplexErrorFunctions::erf(Complex::new(a, b));
    erf(a2) - erf(a1)
}
