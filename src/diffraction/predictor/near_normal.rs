//! Is the depth term near normal enough for a range of directions.

use crate::numeric::turns::{sine_cosine_of_turns, turns_of_ratio};

/// Returns the largest ||1 - e^{ip(gamma)}|^2 - |1 - e^{ip(2)}|^2| over a range of gamma = gamma_i + gamma_o, with
/// p = 2 pi gamma D/lambda, in \[0, 4\].
///
/// `depth` and `wavelength` in um, `gamma_sum` the two ends of the range, in any order. The exact supremum: between the
/// ends the cosine is monotone or passes ±1. NaN where an argument is not finite and for a wavelength that is not
/// positive. VWH18 Eq. 4 is the term at gamma = 2.
///
/// ```
/// use iridescence::diffraction::near_normal_depth_error;
///
/// // A depth of lambda/4 at normal incidence: 4, the most there is; at 60 degrees to both sides 2.
/// assert!((near_normal_depth_error(0.125, [1.0, 2.0], 0.5) - 2.0).abs() < 1e-15);
/// ```
#[must_use]
pub fn near_normal_depth_error(depth: f64, gamma_sum: [f64; 2], wavelength: f64) -> f64 {
    let Some([low, high]) = turns(depth, gamma_sum, wavelength) else {
        return f64::NAN;
    };
    // 2 |cos p - cos q| = 4 |sin((p + q)/2) sin((p - q)/2)|.
    let half_sine = |gamma: f64| sine_cosine_of_turns(0.5 * turns_of_ratio(gamma, depth, wavelength)).0;
    let at = |gamma: f64| (half_sine(gamma + 2.0) * half_sine(gamma - 2.0)).abs();
    let (first, last) = (at(gamma_sum[0]), at(gamma_sum[1]));
    let mut largest = if first >= last { first } else { last };
    let top = contains_integer(low, high);
    let bottom = contains_integer(low - 0.5, high - 0.5);
    if top || bottom {
        let (sine, cosine) = sine_cosine_of_turns(turns_of_ratio(2.0, depth, wavelength) * 0.5);
        if top && sine * sine > largest {
            largest = sine * sine;
        }
        if bottom && cosine * cosine > largest {
            largest = cosine * cosine;
        }
    }
    // A sine may round beyond 1.
    if largest < 1.0 { 4.0 * largest } else { 4.0 }
}

/// Returns the largest |e^{ip(gamma)} - e^{ip(2)}| over a range of gamma = gamma_i + gamma_o, in \[0, 2\]: the error of the
/// depth term's amplitude.
///
/// 2 |sin(pi (2 - gamma) D/lambda)| at an end, or 2 where it passes a whole half turn between. Arguments and domain as in
/// [`near_normal_depth_error`].
///
/// ```
/// use iridescence::diffraction::near_normal_depth_amplitude_error;
///
/// assert_eq!(near_normal_depth_amplitude_error(0.3, [2.0, 2.0], 0.5), 0.0);
/// ```
#[must_use]
pub fn near_normal_depth_amplitude_error(depth: f64, gamma_sum: [f64; 2], wavelength: f64) -> f64 {
    let less = gamma_sum.map(|gamma| gamma - 2.0);
    let Some([low, high]) = turns(depth, less, wavelength) else {
        return f64::NAN;
    };
    if contains_integer(low - 0.5, high - 0.5) {
        return 2.0;
    }
    let [first, last] = less.map(|gamma| {
        sine_cosine_of_turns(0.5 * turns_of_ratio(gamma, depth, wavelength))
            .0
            .abs()
    });
    2.0 * if first >= last { first } else { last }
}

/// Returns whether the squared depth term near normal is within `tolerance` of the exact one over the whole range; false
/// where an argument is NaN.
///
/// Arguments as in [`near_normal_depth_error`]; the tolerance is absolute, the squared term lies in \[0, 4\]. VWH18 Eq. 11
/// is the term near normal.
///
/// ```
/// use iridescence::diffraction::near_normal_depth_is_enough;
///
/// // A light 5 degrees wide around the normal, a shallow scratch.
/// assert!(near_normal_depth_is_enough(0.05, [1.99, 2.0], 0.55, 0.02));
/// assert!(!near_normal_depth_is_enough(0.5, [1.5, 2.0], 0.55, 0.02));
/// ```
#[must_use]
pub fn near_normal_depth_is_enough(depth: f64, gamma_sum: [f64; 2], wavelength: f64, tolerance: f64) -> bool {
    let error = near_normal_depth_error(depth, gamma_sum, wavelength);
    // The rounding of the phases.
    let margin = 32.0 * f64::EPSILON * (1.0 + depth.abs() / wavelength);
    // No error whatever rounds: no depth, or normal directions alone.
    let none = depth == 0.0 || gamma_sum == [2.0, 2.0];
    if none && error == 0.0 {
        tolerance >= 0.0
    } else {
        error + margin <= tolerance
    }
}

/// Returns gamma depth/wavelength at the ends of a range, in rising order; none outside the domain.
fn turns(depth: f64, gamma_sum: [f64; 2], wavelength: f64) -> Option<[f64; 2]> {
    let [first, last] = gamma_sum.map(|gamma| gamma * depth / wavelength);
    let inside = first.is_finite() && last.is_finite() && depth.is_finite() && wavelength.is_finite();
    if !inside || wavelength <= 0.0 {
        return None;
    }
    Some(if first <= last { [first, last] } else { [last, first] })
}

/// Returns whether an integer lies in \[low, high\].
fn contains_integer(low: f64, high: f64) -> bool {
    libm::floor(high) >= low
}
