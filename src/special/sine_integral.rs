//! The sine integral Si.
//!
//! # Definition
//!
//! ```math
//! \mathrm{Si}(x) = \int_0^x \frac{\sin t}{t}\,dt
//! ```
//!
//! VWH18 Eq. 28; DLMF 6.2.9. Its derivative is [`sinc`](super::sinc()).
//!
//! # Domain
//!
//! Every f64. Odd exactly; Si(±0) = ±0, Si(±inf) = ±pi/2, NaN gives NaN.
//!
//! # Methods
//!
//! [`sine_integral`] reads a cell of a table below |x| = 47.75: the value at the cell's centre and a polynomial of
//! degree 9 in the distance from it, so that the final addition is the only rounding that counts. Beyond, it is
//! pi/2 - f cos x - g sin x with the auxiliary functions f and g (DLMF 6.2.17-18) as polynomials in 1/x^2.
//! [`sine_integral_vwh18`] is the fit that VWH18 publishes for shaders.
//!
//! <!-- report:begin sine_integral -->
//!
//! | method | what it is | precision | largest error | promise | time / baseline |
//! |---|---|---|---|---|---|
//! | `accurate` | iridescence f64 | f64 | 0.67 ulp | 0.75 ulp | 0.38 (cephes) |
//! | `vwh18` | VWH18 Eq. 29 | f64 | 0.051 abs. | 0.051 abs. | 0.98 (cephes) |
//! | `accurate`, slice | iridescence f64 slices | f64 | 0.67 ulp | 0.75 ulp | 0.19 (cephes) |
//! | `accurate` | iridescence f32 | f32 | 1.9 ulp | 2 ulp | 0.68 (vwh18) |
//! | `medium` | iridescence f32 1e-5 tier | f32 | 7.0e-6 abs. | 1e-5 abs. | 0.54 (vwh18) |
//! | `coarse` | iridescence f32 4e-4 tier | f32 | 3.5e-4 abs. | 4e-4 abs. | 0.48 (vwh18) |
//! | `vwh18` | VWH18 Eq. 29 f32 | f32 | 0.051 abs. | 0.051 abs. | 1.00 (vwh18) |
//! | `accurate`, slice | iridescence f32 slices | f32 | 1.9 ulp | 2 ulp | 0.81 (vwh18) |
//! | `medium`, slice | iridescence f32 1e-5 slices | f32 | 7.0e-6 abs. | 1e-5 abs. | 0.61 (vwh18) |
//! | `coarse`, slice | iridescence f32 4e-4 slices | f32 | 3.5e-4 abs. | 4e-4 abs. | 0.54 (vwh18) |
//! | `vwh18`, slice | VWH18 Eq. 29 f32 slices | f32 | 0.051 abs. | 0.051 abs. | 1.00 (vwh18) |
//!
//! <!-- report:end sine_integral -->
//!
//! # Where it fails
//!
//! [`sine_integral`]: nowhere known. The error of [`sine_integral_vwh18`] does not cancel in a difference: used inside
//! VWH18 Eq. 27 it makes the light of some sources away from the specular direction negative; see
//! [`sinc_squared_integral_vwh18`](super::sinc_squared_integral_vwh18).
//!
//! # Errata
//!
//! None: Eq. 29 is printed right. Far out the fit exceeds Si by (1 - a0)/x on average.

use super::cells::{HALF_PI, auxiliary, cell};
use super::tables::{SI, TAIL};
use crate::numeric::phase::{reduce_half_turns, sine_cosine};

/// From here on Si rounds to pi/2.
const INFINITE: f64 = 18014398509481984.0;

/// Returns Si(x), the integral of sin t / t from 0 to `x` (radians), dimensionless.
///
/// Any f64; odd exactly; ±inf gives ±pi/2, NaN gives NaN. VWH18 Eq. 28; DLMF 6.2.9.
///
/// ```
/// let si = iridescence::special::sine_integral(core::f64::consts::PI);
/// assert_eq!(si, 1.8519370519824663); // the Wilbraham-Gibbs constant
/// ```
#[doc(alias = "Si")]
#[must_use]
#[inline]
pub fn sine_integral(x: f64) -> f64 {
    let magnitude = x.abs();
    let value = if magnitude < TAIL {
        near(magnitude)
    } else {
        far(magnitude)
    };
    value.copysign(x)
}

/// The bits of [`sine_integral`] for each element, in loops without a branch.
///
/// A block on one side of the border of cells and tail is spared the other evaluation.
#[cfg(feature = "simd")]
#[inline(always)]
pub(crate) fn sine_integral_block<const N: usize>(x: &[f64; N]) -> [f64; N] {
    let cells: usize = x.iter().map(|x| usize::from(x.abs() < TAIL)).sum();
    let mut values = [0.0; N];
    let pairs = values.iter_mut().zip(x);
    if cells == N {
        for (value, x) in pairs {
            *value = near(x.abs()).copysign(*x);
        }
    } else if cells == 0 {
        for (value, x) in pairs {
            *value = far(x.abs()).copysign(*x);
        }
    } else {
        for (value, x) in pairs {
            let magnitude = x.abs();
            let (near, far) = (near(magnitude), far(magnitude));
            *value = if magnitude < TAIL { near } else { far }.copysign(*x);
        }
    }
    values
}

#[inline(always)]
fn near(x: f64) -> f64 {
    let (base, constant, rest) = cell(&SI, 1.0, x);
    // The two leading terms are added without loss: the error is that of the last addition and of `rest` alone.
    let sum = base + constant;
    let lost = (base - sum) + constant;
    sum + (lost + rest)
}

#[inline(always)]
fn far(x: f64) -> f64 {
    let finite = x < INFINITE;
    let (r, odd) = reduce_half_turns(if finite { x } else { INFINITE });
    let (sine, cosine) = sine_cosine(r);
    // The product overflows, so that v is 0 from INFINITE on; a NaN stays one.
    let v = 1.0 / if finite { x } else { x * 1e300 };
    let w = v * v;
    let (a, b) = auxiliary(w);
    let oscillation = v * (cosine + (v * sine * (1.0 - w * b) - cosine * (w * a)));
    HALF_PI[0] - (f64::from_bits(oscillation.to_bits() ^ odd) - HALF_PI[1])
}

/// Returns Si(x) by the published fit, VWH18 Eq. 29.
///
/// A sigmoid, a decaying bump and a decaying oscillation. Any f64; ±inf gives NaN, as does NaN (the cosine has no
/// limit there). For its errors see the table above; do not difference it, use
/// [`sinc_squared_integral`](super::sinc_squared_integral()).
#[must_use]
pub fn sine_integral_vwh18(x: f64) -> f64 {
    /// VWH18, below Eq. 29.
    const A0: f64 = 0.66142739;
    /// VWH18, below Eq. 29.
    const B0: f64 = 0.38272292;
    let magnitude = x.abs();
    let offset = magnitude - B0;
    let value = core::f64::consts::FRAC_PI_2 * libm::tanh(magnitude) - A0 * magnitude / (1.0 + offset * offset)
        + (1.0 - libm::cos(magnitude)) / (1.0 + magnitude);
    value.copysign(x)
}
