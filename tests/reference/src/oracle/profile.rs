//! The transforms of the rectangular and the triangular profile, to about 28 digits of the width.
//!
//! Rectangle: W sinc(pi W xi2/lambda) (1 - exp(2 pi i gamma D/lambda)), the last factor as 2 s (s - ic) with the sine and the
//! cosine of half its phase. Triangle: the integral of exp(2 pi i gamma (D/lambda)(1 - 2|b|/W) - 2 pi i b xi2/lambda) over
//! b in [-W/2, W/2] is (W/2) (exp(i B) sinc A + exp(i A) sinc B), A and B = pi (2 gamma D +- W xi2)/(2 lambda): no pole.
//! Every phase is reduced by whole turns before it is rounded.

use super::double_double::{Dd, two_product};
use super::scaled::Scaled;
use super::scaled_complex::ScaledComplex;
use super::turn_fraction::{sin_cos_of_half_turns, sinc_of_half_turns};
use crate::metrics::Reference;

/// Whether width, depth, xi2, gamma_sum and lambda give a profile.
pub(super) fn is_profile(row: &[f64]) -> bool {
    row.iter().all(|x| x.is_finite()) && row[0] >= 0.0 && row[4] > 0.0
}

/// The rectangle's transform of the row width, depth, xi2, gamma_sum, lambda; NaN unless all are finite, the width not
/// negative and lambda positive.
pub fn profile_rectangle(row: &[f64]) -> [Reference; 2] {
    let &[width, depth, xi2, gamma_sum, lambda] = row else {
        panic!("a row of 5: {row:?}")
    };
    if !is_profile(row) {
        return [Reference::exact(f64::NAN); 2];
    }
    let mask = sinc_of_half_turns(two_product(width, xi2), lambda) * width;
    (depth_factor(depth, gamma_sum, lambda) * mask).references()
}

/// 1 - exp(2 pi i gamma_sum depth/lambda).
pub(super) fn depth_factor(depth: f64, gamma_sum: f64, lambda: f64) -> ScaledComplex {
    let (sine, cosine) = sin_cos_of_half_turns(two_product(gamma_sum, depth), lambda);
    ScaledComplex {
        re: (Scaled::from(sine) * sine.into()).shift(1),
        im: -(Scaled::from(sine) * cosine.into()).shift(1),
    }
}

/// The triangle's transform of the row width, depth, xi2, gamma_sum, lambda; NaN as of [`profile_rectangle`].
pub fn profile_triangle(row: &[f64]) -> [Reference; 2] {
    let &[width, depth, xi2, gamma_sum, lambda] = row else {
        panic!("a row of 5: {row:?}")
    };
    if !is_profile(row) {
        return [Reference::exact(f64::NAN); 2];
    }
    let (across, down) = (two_product(width, xi2), two_product(2.0 * gamma_sum, depth));
    let (sum, difference) = (down + across, down - across);
    let part = |turned: Dd, spread: Dd| {
        let (sine, cosine) = sin_cos_of_half_turns(turned, 2.0 * lambda);
        let weight = sinc_of_half_turns(spread, 2.0 * lambda);
        (cosine * weight, sine * weight)
    };
    let ((re1, im1), (re2, im2)) = (part(difference, sum), part(sum, difference));
    let half = 0.5 * width;
    ScaledComplex::new((re1 + re2) * half, (im1 + im2) * half).references()
}
