//! The responses of scratches and of the surface without them, to 20 digits and more of their scale.
//!
//! Products of the oracles of phase and profile, and three more: the depth term 2 s (s - ic), s and c the sine and the
//! cosine of half its phase; Gaussians of exact arguments; and the triangle's response, mask less scratch,
//!
//! W sinc w - F = (W p/(2w)) [exp(iB) sinc A - exp(iA) sinc B] = -W sum_{n > 0, m} (ip)^n (-w^2)^m/(n + 2m + 1)!
//!
//! with p and w the phases of depth and width, A and B = (p +- w)/2: the difference from |p| = 1e-6 on, the series where
//! both phases are below, the product elsewhere.

use super::double_double::{Dd, two_product};
use super::profile::{depth_factor, is_profile, profile_triangle};
use super::scaled::{ONE_OVER_ROOT_PI, Scaled, exponential};
use super::scaled_complex::ScaledComplex;
use super::spatial_phase::spatial_phase;
use super::turn_fraction::{PI, sin_cos_of_half_turns, sin_cos_of_turns, sinc_of_half_turns, turn_fraction};
use crate::metrics::Reference;

/// The largest phase of the series, and the smallest of the difference.
const SHALLOW: f64 = 1e-6;
const NOT_A_NUMBER: [Reference; 2] = [Reference::exact(f64::NAN); 2];
/// sqrt(2 pi).
const ROOT_TWO_PI: Dd = Dd::new(2.5066282746310007, -1.8328579980459167e-16);

/// sigma k xi.
fn reduced(sigma: f64, xi: f64, lambda: f64) -> Dd {
    two_product(sigma, xi) * PI.scale(2.0) / lambda
}

/// Whether the numbers are finite and the first two, radius and wavelength, positive.
fn is_light(row: &[f64]) -> bool {
    row.iter().all(|x| x.is_finite()) && row[0] > 0.0 && row[1] > 0.0
}

/// 2 pi sigma^2.
fn twice_the_area(sigma: f64) -> Dd {
    two_product(sigma, sigma) * PI.scale(2.0)
}

/// eta of an infinite scratch (VWH18 Eq. 8), of the row sigma, lambda, xi1, xi2, s_b; NaN unless all are finite, sigma and
/// lambda positive.
pub fn spatial_phase_infinite(row: &[f64]) -> [Reference; 2] {
    let &[sigma, lambda, xi1, xi2, s_b] = row else {
        panic!("a row of 5: {row:?}")
    };
    if !is_light(row) {
        return NOT_A_NUMBER;
    }
    let (sine, cosine) = sin_cos_of_turns(turn_fraction(two_product(s_b, xi2), lambda));
    let squares = (Dd::from(s_b) / sigma).square() + reduced(sigma, xi1, lambda).square();
    let value = ScaledComplex::new(cosine, -sine) * (ROOT_TWO_PI * sigma);
    value.times_exponential(-squares.scale(0.5)).references()
}

/// 2 pi sigma^2 exp(-(sigma k |xi|)^2/2) of the row sigma, lambda, xi1, xi2; NaN as of [`spatial_phase_infinite`].
pub fn base_response(row: &[f64]) -> Reference {
    let &[sigma, lambda, xi1, xi2] = row else {
        panic!("a row of 4: {row:?}")
    };
    if !is_light(row) {
        return Reference::exact(f64::NAN);
    }
    let squares = reduced(sigma, xi1, lambda).square() + reduced(sigma, xi2, lambda).square();
    (exponential(-squares.scale(0.5)) * twice_the_area(sigma).into()).reference()
}

/// 1 - exp(2 pi i gamma D/lambda) of the row depth, gamma_sum, lambda; NaN unless all are finite and lambda positive.
pub fn depth_term(row: &[f64]) -> [Reference; 2] {
    let &[depth, gamma_sum, lambda] = row else {
        panic!("a row of 3: {row:?}")
    };
    if row.iter().all(|x| x.is_finite()) && lambda > 0.0 {
        depth_factor(depth, gamma_sum, lambda).references()
    } else {
        NOT_A_NUMBER
    }
}

/// The response of a triangular groove of the row width, depth, xi2, gamma_sum, lambda; NaN as of
/// [`profile_triangle`](super::profile_triangle).
pub fn response_triangle(row: &[f64]) -> [Reference; 2] {
    let &[width, depth, xi2, gamma_sum, lambda] = row else {
        panic!("a row of 5: {row:?}")
    };
    if !is_profile(row) {
        return NOT_A_NUMBER;
    }
    let (across, down) = (two_product(width, xi2), two_product(2.0 * gamma_sum, depth));
    let (p, w) = (PI * down / lambda, PI * across / lambda);
    if p.hi.abs() >= SHALLOW {
        let mask = sinc_of_half_turns(across, lambda) * width;
        let groove = ScaledComplex::from_references(profile_triangle(row));
        return (ScaledComplex::new(mask, Dd::ZERO) + -groove).references();
    }
    if w.hi.abs() < SHALLOW {
        return (series(p, w) * Dd::from(width)).references();
    }
    let part = |turned: Dd, spread: Dd| {
        let (sine, cosine) = sin_cos_of_half_turns(turned, 2.0 * lambda);
        ScaledComplex::new(cosine, sine) * sinc_of_half_turns(spread, 2.0 * lambda)
    };
    let (sum, difference) = (down + across, down - across);
    let bracket = part(difference, sum) + -part(sum, difference);
    (bracket * (Scaled::from(down) / Scaled::from(across)) * Dd::from(0.5 * width)).references()
}

/// The response over the width of small phases.
fn series(p: Dd, w: Dd) -> ScaledComplex {
    let square = w.square();
    // Without its factor p, lest a power of p underflow: n = 1 to 4 and m = 0 to 2.
    let order = |n: u32| {
        let factorial = |k: u32| (1..=k).map(f64::from).product::<f64>();
        let [a, b, c] = [n + 1, n + 3, n + 5].map(|k| Dd::ONE / factorial(k));
        a - square * b + square.square() * c
    };
    let re = p * (order(2) - p.square() * order(4));
    let im = -(order(1) - p.square() * order(3));
    ScaledComplex::new(re, im) * Scaled::from(p)
}

/// The response of a rectangle with the window across it as well, of the row sigma, lambda, width, depth, xi1, xi2,
/// gamma_sum, s_t, s_b, l1, l2: the ends may be infinite; NaN for other infinities, for NaN, for a negative width and unless
/// sigma and lambda are positive.
pub fn response_rectangle_windowed(row: &[f64]) -> [Reference; 2] {
    let &[sigma, lambda, width, depth, xi1, xi2, gamma_sum, s_t, s_b, l1, l2] = row else {
        panic!("a row of 11: {row:?}")
    };
    if !is_light(&row[..9]) || width < 0.0 {
        return NOT_A_NUMBER;
    }
    let along = spatial_phase(&[sigma, lambda, xi1, 0.0, s_t, 0.0, l1, l2]);
    let across = spatial_phase(&[sigma, lambda, xi2, 0.0, s_b, 0.0, -0.5 * width, 0.5 * width]);
    if along[0].hi.is_nan() {
        return NOT_A_NUMBER;
    }
    let [along, across] = [along, across].map(ScaledComplex::from_references);
    (along * across * depth_factor(depth, gamma_sum, lambda)).references()
}

/// |W sinc D|^2 2 pi sigma^2 M exp(-(sigma k xi1)^2) of the row sigma, lambda, width, depth, xi1, xi2, gamma_sum, mean; NaN
/// unless all are finite, sigma and lambda positive, the width not negative.
pub fn scratch_squared(row: &[f64]) -> Reference {
    let &[sigma, lambda, width, depth, xi1, xi2, gamma_sum, mean] = row else {
        panic!("a row of 8: {row:?}")
    };
    if !is_light(row) || width < 0.0 {
        return Reference::exact(f64::NAN);
    }
    let mask = sinc_of_half_turns(two_product(width, xi2), lambda) * width;
    let (sine, _) = sin_cos_of_half_turns(two_product(gamma_sum, depth), lambda);
    let [mask, sine] = [mask, sine].map(|x| Scaled::from(x) * Scaled::from(x));
    let along = exponential(-reduced(sigma, xi1, lambda).square());
    (mask * sine.shift(2) * along * (twice_the_area(sigma) * mean).into()).reference()
}

/// W/(sqrt(pi) sigma) exp(-(s_b/sigma)^2) of the row width, offset, sigma; NaN unless all are finite, the width not negative
/// and sigma positive.
pub fn area_density(row: &[f64]) -> Reference {
    let &[width, offset, sigma] = row else {
        panic!("a row of 3: {row:?}")
    };
    if !row.iter().all(|x| x.is_finite()) || width < 0.0 || sigma <= 0.0 {
        return Reference::exact(f64::NAN);
    }
    let window = exponential(-(Dd::from(offset) / sigma).square());
    (window * (ONE_OVER_ROOT_PI * width / sigma).into()).reference()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_constant_is_what_its_name_says() {
        assert!((ROOT_TWO_PI.square() - PI.scale(2.0)).hi.abs() < 1e-31);
    }

    #[test]
    fn the_three_forms_of_the_triangles_response_meet() {
        for (p, w) in [(SHALLOW, 0.3 * SHALLOW), (SHALLOW, 0.7), (0.3 * SHALLOW, SHALLOW)] {
            // Of a width and a wavelength of 1: p = 2 pi gamma D, w = pi xi2.
            let (tau, pi) = (std::f64::consts::TAU, std::f64::consts::PI);
            let at = |p: f64, w: f64| response_triangle(&[1.0, p / tau, w / pi, 1.0, 1.0]).map(|part| part.value());
            let step = 1.0 + 1e-12;
            let [below, above] = [at(p / step, w / step), at(p * step, w * step)];
            for part in 0..2 {
                let ratio = below[part] / above[part] - 1.0;
                assert!(ratio.abs() < 1e-11, "{p} {w}: {below:?} {above:?}");
            }
        }
    }
}
