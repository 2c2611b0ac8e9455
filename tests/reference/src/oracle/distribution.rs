//! Densities and inverse distributions of the sampling, to 25 digits and more.
//!
//! The Gaussian's inverse by Newton's method on erf in the middle half, on erfc times exp(y^2) in the tails, the last step
//! with its quadratic term and in double-double. The von Mises-Fisher density as kappa/(1 - exp(-2 kappa)) times
//! exp(kappa (cos - 1))/(2 pi); the first factor by its series where kappa is small.

use super::double_double::{Dd, two_product, two_sum};
use super::error_function::{erf_complex, erfcx};
use super::scaled::{Scaled, TWO_OVER_ROOT_PI, exponential};
use super::turn_fraction::PI;
use crate::metrics::Reference;

/// Steps from a first guess that is right to a few per cent.
const STEPS: usize = 8;

/// The y with int_{-inf}^{y} exp(-t^2) dt/sqrt(pi) = u; infinite at 0 and 1, NaN outside.
pub fn gaussian_inverse(u: f64) -> Reference {
    if !(0.0..=1.0).contains(&u) {
        return Reference::exact(f64::NAN);
    }
    if u < 0.25 {
        -tail(u)
    } else if u <= 0.75 {
        middle(2.0 * u - 1.0)
    } else {
        tail(1.0 - u)
    }
}

/// y + r + y r^2: a step of Newton's method with its quadratic term.
fn stepped(y: f64, r: Dd) -> Dd {
    r + r.square() * y + y
}

/// The y with erf y = x for |x| <= 1/2.
fn middle(x: f64) -> Reference {
    if x == 0.0 {
        return Reference::exact(0.0);
    }
    let step = |y: f64| {
        let [erf, _] = erf_complex(y, 0.0);
        let slope = exponential(-two_product(y, y)).value() * TWO_OVER_ROOT_PI;
        stepped(y, (Dd::from(x) - Dd::new(erf.hi, erf.lo)) / slope)
    };
    let y = (1..STEPS).fold(0.9 * x, |y, _| step(y).hi);
    step(y).into()
}

/// The y > 0 with erfc y = 2 u for 0 <= u < 1/4.
fn tail(u: f64) -> Reference {
    if u == 0.0 {
        return Reference::exact(f64::INFINITY);
    }
    let step = |y: f64| {
        let scaled = erfcx(y);
        let due = Scaled::from(2.0 * u) * exponential(two_product(y, y));
        stepped(y, (Dd::new(scaled.hi, scaled.lo) - due.value()) / TWO_OVER_ROOT_PI)
    };
    // erfc y is about exp(-y^2)/(sqrt(pi) y); its logarithm gives a guess below the root, where the steps cannot overshoot.
    let logarithm = -(2.0 * u).ln();
    let mut y = (logarithm - (1.0 + 1.8 * logarithm.sqrt()).ln()).max(0.0).sqrt();
    for _ in 1..STEPS {
        y = step(y).hi;
    }
    step(y).into()
}

/// kappa/(4 pi sinh kappa) exp(kappa cos) of the row concentration, cosine; NaN unless the concentration is finite and
/// not negative.
pub fn von_mises_fisher_pdf(row: &[f64]) -> Reference {
    let &[concentration, cosine] = row else {
        panic!("a row of 2: {row:?}")
    };
    if !(0.0..f64::INFINITY).contains(&concentration) || cosine.is_nan() {
        return Reference::exact(f64::NAN);
    }
    let kappa = Dd::from(concentration);
    let amplitude = if concentration < 1e-6 {
        // k/(1 - exp(-2k)) = (1 + k + k^2/3 - k^4/45 + ...)/2.
        let square = kappa.square();
        (square / 3.0 - square.square() / 45.0 + kappa + Dd::ONE).scale(0.5)
    } else {
        kappa / (Dd::ONE - exponential(-kappa.scale(2.0)).value())
    };
    let below = two_sum(cosine, -1.0);
    (exponential(below * concentration) * (amplitude / PI.scale(2.0)).into()).reference()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_inverse_gives_its_probability_back() {
        for u in [
            1e-300,
            1e-30,
            1e-9,
            0.01,
            0.2499,
            0.25,
            0.3,
            0.5 - 1e-12,
            0.6,
            0.75,
            0.8,
            1.0 - 1e-9,
        ] {
            let Reference { hi, lo, .. } = gaussian_inverse(u);
            // erfc of hi, moved to hi + lo by its slope.
            let y = hi.abs();
            let rest = if hi < 0.0 { -lo } else { lo };
            let scaled = erfcx(y);
            let moved = Dd::new(scaled.hi, scaled.lo) - TWO_OVER_ROOT_PI * rest;
            let given = (exponential(-two_product(y, y)) * moved.into()).value().scale(0.5);
            let due = if u <= 0.5 { u } else { 1.0 - u };
            assert!(((given - Dd::from(due)) / due).hi.abs() < 1e-27, "{u}: {hi:e}");
        }
        assert_eq!(gaussian_inverse(0.5).hi, 0.0);
        assert_eq!(gaussian_inverse(0.0).hi, f64::NEG_INFINITY);
        assert!(gaussian_inverse(-0.1).hi.is_nan() && gaussian_inverse(f64::NAN).hi.is_nan());
    }

    #[test]
    fn the_two_forms_of_the_amplitude_meet_and_the_limits_are_uniform_and_sharp() {
        let at = |kappa: f64| von_mises_fisher_pdf(&[kappa, 0.25]);
        let (below, above) = (at(1e-6 * (1.0 - 1e-15)), at(1e-6));
        assert!(below.relative_difference(&above) < 1e-20);
        let uniform = Dd::ONE / PI.scale(4.0);
        assert!(at(0.0).relative_difference(&uniform.into()) < 1e-30);
        let sharp = von_mises_fisher_pdf(&[1e6, 1.0]);
        assert!(sharp.relative_difference(&(Dd::from(1e6) / PI.scale(2.0)).into()) < 1e-30);
        assert!(von_mises_fisher_pdf(&[-1.0, 0.0]).hi.is_nan());
    }
}
