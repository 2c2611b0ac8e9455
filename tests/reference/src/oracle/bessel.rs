//! exp(-|x|) I0(x), ln I0(x) and I1(x)/I0(x): the power series (DLMF 10.25.2), all terms positive, for |x| < 42; beyond,
//! the asymptotic series (10.40.1), whose smallest term there is e^-84.

use super::double_double::{Dd, HALF_PI, two_product};
use super::scaled::{Scaled, exponential};
use crate::metrics::Reference;

/// |x| from which the asymptotic series is used.
const FAR: f64 = 42.0;
/// Squares of smaller arguments add nothing to 1.
const TINY: f64 = 1e-17;

/// I0 - 1 and I1/(x/2) for 0 <= x < 42.
fn series(x: f64) -> (Dd, Dd) {
    let quarter = two_product(x, x).scale(0.25);
    let (mut term, mut zeroth, mut first) = (Dd::ONE, Dd::ZERO, Dd::ONE);
    for k in 1..200 {
        let k = f64::from(k);
        // (x^2/4)^k/k!^2, and that over k + 1.
        term = term * quarter / (k * k);
        zeroth = zeroth + term;
        first = first + term / (k + 1.0);
        if term.hi < 1e-36 * zeroth.hi {
            break;
        }
    }
    (zeroth, first)
}

/// sqrt(2 pi x) exp(-x) times I0 and I1 for x >= 42.
fn asymptotic(x: f64) -> (Dd, Dd) {
    let inverse = Dd::ONE / x / 8.0;
    let sum = |order: f64| {
        let (mut term, mut sum) = (Dd::ONE, Dd::ONE);
        for k in 1..84 {
            let odd = f64::from(2 * k - 1);
            term = term * inverse * (odd * odd - 4.0 * order * order) / f64::from(k);
            sum = sum + term;
            if term.hi.abs() < 1e-37 {
                break;
            }
        }
        sum
    };
    (sum(0.0), sum(1.0))
}

/// Square root by one Newton step from f64.
pub(super) fn square_root(x: Dd) -> Dd {
    let root = x.hi.sqrt();
    let rest = x - two_product(root, root);
    let root = Dd::from(root) + rest.hi / (2.0 * root);
    root + ((x - root.square()).hi / (2.0 * root.hi))
}

/// exp(-|x|) I0(x); 0 at the infinities.
pub fn bessel_i0_scaled(x: f64) -> Reference {
    let x = x.abs();
    if x.is_nan() || x.is_infinite() {
        return Reference::exact(if x.is_nan() { x } else { 0.0 });
    }
    if x < FAR {
        let grown = if x < TINY { Dd::ZERO } else { series(x).0 };
        return (Scaled::from(grown + 1.0) * exponential((-x).into())).reference();
    }
    // The root of an argument near the largest f64 is taken of a 2^-600 of it.
    let (y, shift) = if x > 1e200 { (x * 2f64.powi(-600), -300) } else { (x, 0) };
    Scaled::new(asymptotic(x).0 / square_root(HALF_PI * 4.0 * y), shift).reference()
}

/// ln x for x near 1 and beyond: Newton's step on exp, twice.
fn logarithm(x: Dd) -> Dd {
    let mut y = Dd::from(x.hi.ln());
    for _ in 0..2 {
        let rest = (Scaled::from(x) * exponential(-y)).value() + -1.0;
        y = y + (rest - rest.square().scale(0.5));
    }
    y
}

/// ln(1 + u) for 0 <= u <= 0.3: 2 artanh(u/(2 + u)).
fn logarithm_of_one_plus(u: Dd) -> Dd {
    let ratio = u / (u + 2.0);
    let square = ratio.square();
    let mut sum = Dd::ZERO;
    for k in (0..40).rev() {
        sum = sum * square + Dd::ONE / f64::from(2 * k + 1);
    }
    ratio.scale(2.0) * sum
}

/// ln I0(x); infinite at the infinities.
pub fn log_bessel_i0(x: f64) -> Reference {
    let x = x.abs();
    if x.is_nan() || x.is_infinite() {
        return Reference::exact(x);
    }
    if x < TINY {
        let square = Scaled::from(x) * x.into();
        return square.shift(-2).reference();
    }
    if x < FAR {
        let grown = series(x).0;
        return if grown.hi < 0.3 {
            logarithm_of_one_plus(grown).into()
        } else {
            logarithm(grown + 1.0).into()
        };
    }
    let (y, shift) = if x > 1e200 {
        (x * 2f64.powi(-600), 600.0)
    } else {
        (x, 0.0)
    };
    let root = logarithm(HALF_PI * 4.0 * y) + logarithm(Dd::from(2.0)) * shift;
    (logarithm(asymptotic(x).0) - root.scale(0.5) + x).into()
}

/// I1(x)/I0(x); odd, 1 at infinity.
pub fn bessel_i1_i0_ratio(x: f64) -> Reference {
    if x.is_nan() || x == 0.0 {
        return Reference::exact(x);
    }
    let size = x.abs();
    let ratio = if size.is_infinite() {
        Scaled::from(1.0)
    } else if size < TINY {
        Scaled::from(size).shift(-1)
    } else if size < FAR {
        let (zeroth, first) = series(size);
        Scaled::from(first / (zeroth + 1.0)) * Scaled::from(size).shift(-1)
    } else {
        let (zeroth, first) = asymptotic(size);
        Scaled::from(first / zeroth)
    };
    let ratio = ratio.reference();
    if x < 0.0 { -ratio } else { ratio }
}
