//! erf, erfc and erfcx from the parts of w: with w(iz) = m exp(z^2) + x B - i y A, erfc z = m + exp(-z^2) (x B - i y A), so
//! nothing overflows before the result does and each component keeps its digits beside the axes.

use super::arbitrary;
use super::faddeeva::{faddeeva_w, gaussian, parts, phase_overflows, references, sum_of_two};
use super::scaled::{Scaled, minus_real_square};
use super::zeros;
use crate::metrics::Reference;

/// m and both components of exp(-z^2) (x B - i y A); none where a component cancels or a phase overflows.
fn tail(x: f64, y: f64) -> Option<(f64, [Scaled; 2])> {
    let parts = parts(y, x);
    let m = match parts.apart {
        true => 1.0,
        false if x < 0.0 => 2.0,
        false => 0.0,
    };
    if minus_real_square(x, y).hi < -1e6 {
        return Some((m, [Scaled::ZERO; 2]));
    }
    if phase_overflows(x, y) {
        return None;
    }
    let [re, im] = gaussian(x, y);
    let (xb, ya) = (parts.along_y * x.into(), parts.along_x * y.into());
    Some((m, sum_of_two([re * xb, im * xb], [im * ya, -(re * ya)])?))
}

/// erf(re + im i); both components NaN where one is, and where an infinity has no limit.
pub fn erf_complex(re: f64, im: f64) -> [Reference; 2] {
    if !(re.is_finite() && im.is_finite()) {
        return at_infinity(re, im, 1f64.copysign(re));
    }
    if let Some(value) = zeros::erf(re, im) {
        return [value.re.into(), value.im.into()];
    }
    let value = tail(re, im).and_then(|(m, [a, b])| sum_of_two([(1.0 - m).into(), Scaled::ZERO], [-a, -b]));
    match value {
        Some(value) => references(value, [0f64.copysign(re), 0f64.copysign(im)]),
        None => arbitrary::faddeeva::erf_complex(re, im),
    }
}

/// erfc(re + im i); both components NaN where one is, and where an infinity has no limit.
pub fn erfc_complex(re: f64, im: f64) -> [Reference; 2] {
    if !(re.is_finite() && im.is_finite()) {
        return at_infinity(re, im, if re > 0.0 { 0.0 } else { 2.0 });
    }
    if let Some(value) = zeros::erf(re, im) {
        return [(-value.re + 1.0).into(), (-value.im).into()];
    }
    let value = tail(re, im).and_then(|(m, value)| sum_of_two([m.into(), Scaled::ZERO], value));
    match value {
        Some(value) => references(value, [0.0, -0f64.copysign(im)]),
        None => arbitrary::faddeeva::erfc_complex(re, im),
    }
}

/// The limit at infinite `x` and finite `y`; NaN elsewhere.
fn at_infinity(x: f64, y: f64, limit: f64) -> [Reference; 2] {
    if x.is_infinite() && y.is_finite() {
        return [Reference::exact(limit), Reference::exact(0.0)];
    }
    [Reference::exact(f64::NAN); 2]
}

/// exp(x^2) erfc(x).
pub fn erfcx(x: f64) -> Reference {
    if x == f64::NEG_INFINITY {
        return Reference::exact(f64::INFINITY);
    }
    faddeeva_w(0.0, x)[0]
}
