//! Published formulas exactly as printed, with the platform's mathematics: what a reader gets who types them in.
//!
//! VWH18: Velinov, Werner, Hullin, Real-Time Rendering of Wave-Optical Effects on Scratched Surfaces, 2018.

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
