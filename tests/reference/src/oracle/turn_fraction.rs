//! Angles given as a length over a period: reduced by whole periods first, exactly, so that a phase of millions of turns
//! keeps its digits, and a phase beside a whole turn keeps them relative to the distance.

use super::double_double::{Dd, HALF_PI, two_product, two_sum};
use super::reduction::Reduced;

/// pi.
pub const PI: Dd = Dd::new(std::f64::consts::PI, 1.2246467991473532e-16);

/// `x` over `period` without its whole turns: in [-1/2, 1/2]. The period is positive.
pub fn turn_fraction(x: Dd, period: f64) -> Dd {
    // The remainders of f64 are exact.
    let rest = two_sum(x.hi % period, x.lo % period);
    let whole = (rest.hi / period).round();
    (rest - two_product(whole, period)) / period
}

/// Sine and cosine of 2 pi f for |f| <= 1.
pub fn sin_cos_of_turns(f: Dd) -> (Dd, Dd) {
    let quarters = (4.0 * f.hi).round();
    Reduced {
        quadrant: quarters as i32 as u32 & 3,
        remainder: (f + -0.25 * quarters) * HALF_PI.scale(4.0),
    }
    .sin_cos()
}

/// sin(pi x/period) and cos(pi x/period); the sine keeps its digits beside each of its zeros.
pub fn sin_cos_of_half_turns(x: Dd, period: f64) -> (Dd, Dd) {
    let f = turn_fraction(x, period);
    let (sine, cosine) = sin_cos_of_turns(f.scale(0.5));
    // An odd number of half turns left out changes both signs.
    let odd = (turn_fraction(x, 2.0 * period).hi - 0.5 * f.hi).abs() > 0.25;
    if odd { (-sine, -cosine) } else { (sine, cosine) }
}

/// sin(pi x/period)/(pi x/period); 1 at 0.
pub fn sinc_of_half_turns(x: Dd, period: f64) -> Dd {
    if x.hi.abs() < 1e-20 * period {
        return Dd::ONE;
    }
    sin_cos_of_half_turns(x, period).0 * period / (x * PI)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::oracle::reduction::sin_cos;

    #[test]
    fn whole_turns_leave_nothing_and_what_is_beside_them_keeps_its_digits() {
        let (period, turns) = (0.55, 1048576.0);
        let x = two_product(period, turns);
        assert_eq!(turn_fraction(x, period), Dd::ZERO);
        let beside = turn_fraction(x + 1e-25, period);
        assert!(
            ((beside * period - Dd::from(1e-25)).hi / 1e-25).abs() < 1e-5,
            "{beside:?}"
        );
        let quarter = turn_fraction(x + 0.25 * period, period);
        assert!((quarter.hi - 0.25).abs() < 1e-16);
        assert!((turn_fraction(-x - Dd::from(0.2), period).hi * period + 0.2).abs() < 1e-16);
    }

    #[test]
    fn sine_and_cosine_of_turns_are_those_of_the_angle_in_every_quadrant() {
        for k in -40..=40 {
            let x = 0.1 * f64::from(k) + 0.013;
            // 2 pi x as f64 plus what it lacks, moved by the first order.
            let angle = two_product(PI.hi, x) + PI.lo * x;
            let (s, c) = sin_cos(angle.hi);
            let (sine, cosine) = (s + c * angle.lo, c - s * angle.lo);
            let (half_s, half_c) = sin_cos_of_half_turns(x.into(), 1.0);
            assert!(
                (half_s - sine).hi.abs() < 1e-30 && (half_c - cosine).hi.abs() < 1e-30,
                "{x}"
            );
            let (turn_s, turn_c) = sin_cos_of_turns(turn_fraction(x.into(), 2.0));
            assert!(
                (turn_s - sine).hi.abs() < 1e-30 && (turn_c - cosine).hi.abs() < 1e-30,
                "{x}"
            );
            let sinc = sinc_of_half_turns(x.into(), 1.0) * x * PI;
            assert!((sinc - sine).hi.abs() < 1e-30, "{x}");
        }
    }
}
