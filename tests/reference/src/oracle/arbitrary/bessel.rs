//! exp(-|x|) I0, ln I0 and I1/I0 by the power series, beyond 200 by the asymptotic one.

use super::faddeeva::reference;
use super::{Big, big, is_zero, magnitude};
use crate::metrics::Reference;

const BITS: usize = 400;
/// Argument from which the asymptotic series is used; its smallest term there is e^-400.
const FAR: f64 = 200.0;

/// exp(-x) I0(x) and exp(-x) I1(x), to 2^-BITS; the first less exp(-x) where `reduced`.
fn pair(x: f64) -> (Big, Big) {
    let exact = big(x, BITS);
    if x < FAR {
        let (zeroth, first) = series(&exact);
        let decay = (-exact).exp();
        return ((zeroth + big(1.0, BITS)) * &decay, first * decay);
    }
    let sum = |order: f64| {
        let (mut term, mut sum) = (big(1.0, BITS), big(1.0, BITS));
        for k in 1..400u32 {
            let odd = f64::from(2 * k - 1);
            term = term * big(odd * odd - 4.0 * order * order, BITS) / (&exact * big(8.0 * f64::from(k), BITS));
            sum += &term;
            if magnitude(&term) < -(BITS as isize) {
                break;
            }
        }
        sum
    };
    let root = ((Big::pi(BITS) * &exact) << 1).sqrt();
    (sum(0.0) / &root, sum(1.0) / root)
}

/// I0(x) - 1 and I1(x).
fn series(x: &Big) -> (Big, Big) {
    let quarter = x.sqr() >> 2;
    let mut term = big(1.0, BITS);
    let (mut zeroth, mut first) = (big(0.0, BITS), big(1.0, BITS));
    for k in 1..2000u32 {
        term = term * &quarter / big(f64::from(k) * f64::from(k), BITS);
        zeroth += &term;
        first += &term / big(f64::from(k + 1), BITS);
        if is_zero(&term) || magnitude(&term) < magnitude(&zeroth) - BITS as isize {
            break;
        }
    }
    (zeroth, first * (x.clone() >> 1))
}

/// exp(-|x|) I0(x) for finite x.
pub fn bessel_i0_scaled(x: f64) -> Reference {
    reference(&pair(x.abs()).0)
}

/// ln I0(x) for finite x other than zero.
pub fn log_bessel_i0(x: f64) -> Reference {
    let x = x.abs();
    if x < 1.0 {
        return reference(&series(&big(x, BITS)).0.ln_1p());
    }
    reference(&(pair(x).0.ln() + big(x, BITS)))
}

/// I1(x)/I0(x) for finite x other than zero.
pub fn bessel_i1_i0_ratio(x: f64) -> Reference {
    let (zeroth, first) = pair(x.abs());
    let ratio = reference(&(first / zeroth));
    if x < 0.0 { -ratio } else { ratio }
}
