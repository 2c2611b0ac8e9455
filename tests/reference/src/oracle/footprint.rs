//! M(H, C) = (2/pi) int_{-1}^{1} sqrt(1 - t^2) exp(-(Ht - C)^2) dt, to about 25 digits of its own value up to H = 1e8, and
//! a digit less for every tenfold from there.
//!
//! With t = cos theta the integrand is sin^2 theta exp(-(H cos theta - C)^2): entire, even and of period 2 pi, so the
//! trapezoidal rule on theta = pi k/n converges like exp(-2 tau n) times the growth of the integrand in the strip
//! |Im theta| <= tau, for every tau (Trefethen and Weideman 2014, theorem 3.2). The tau is sought that needs the fewest
//! nodes. Nodes where the exponential is below exp(-80) of its largest value are left out. The exponent is
//! formed from the distance d = H - |C| to the edge, so that nothing cancels where the edge is met; beyond it exp(-d^2)
//! stands apart.

use super::bessel::square_root;
use super::double_double::{Dd, two_product, two_sum};
use super::scaled::{Scaled, exponential};
use super::turn_fraction::sin_cos_of_turns;
use crate::metrics::Reference;

/// The error is to be exp(-DIGITS) of the largest value.
const DIGITS: f64 = 80.0;
/// Past this distance from the edge exp(-d^2) is nothing.
const NOTHING: f64 = 1e4;
/// Largest half width: beyond, the nodes are no f64 integers.
const WIDEST: f64 = 1e12;

/// The logarithm of the growth of the integrand in the strip |Im theta| <= `tau`.
fn growth(h: f64, d: f64, tau: f64) -> f64 {
    let (sinh, cosh, rise) = (tau.sinh(), tau.cosh(), 2.0 * (0.5 * tau).sinh().powi(2));
    let c = h - d;
    let doubled = (2.0 * tau).cosh();
    // The exponent is a parabola in cos theta with its vertex at C cosh tau/(H cosh 2 tau).
    let exponent = if c * cosh <= h * doubled {
        sinh * sinh * (d * (h + c) + c * c * 2.0 * sinh * sinh / doubled) + d.min(0.0).powi(2)
    } else {
        -(d + h * rise).powi(2) + d.min(0.0).powi(2)
    };
    exponent + 2.0 * cosh.ln()
}

/// Distance of the nodes.
fn step(h: f64, d: f64) -> f64 {
    let mut best = 0.0;
    let mut tau = 16.0;
    while tau > 1e-14 {
        let spacing = 2.0 * std::f64::consts::PI * tau / (DIGITS + growth(h, d, tau));
        if spacing < best {
            break;
        }
        best = spacing;
        tau *= 0.8;
    }
    best
}

/// M for half width `h` >= 0 and distance `d` = H - |C| from the edge, both finite.
fn mean(h: Dd, d: Dd) -> Scaled {
    if d.hi < -NOTHING {
        return exponential(Dd::from(-1e8));
    }
    let count = (std::f64::consts::PI / step(h.hi, d.hi)).ceil();
    // Depths y = 1 - t below the edge where the exponential counts: |d - Hy| <= reach, or as much beyond the edge.
    let reach = DIGITS.sqrt();
    let most = if d.hi >= 0.0 {
        d.hi + reach
    } else {
        DIGITS / (d.hi.hypot(reach) - d.hi)
    };
    let angle = |y: f64| 2.0 * (0.5 * y).min(1.0).sqrt().asin();
    let node = |y: f64| angle(y) * count / std::f64::consts::PI;
    let first = if d.hi > reach {
        node((d.hi - reach) / h.hi).floor()
    } else {
        0.0
    };
    let last = if most < 2.0 * h.hi {
        node(most / h.hi).ceil()
    } else {
        count
    }
    .min(count);
    // Sine and cosine of theta/2 by rotation.
    let turn = |k: f64| sin_cos_of_turns(Dd::from(k) / (4.0 * count));
    let ((mut s, mut c), (step_s, step_c)) = (turn(first), turn(1.0));
    let mut total = Dd::ZERO;
    let mut k = first;
    while k <= last {
        let below = s.square().scale(2.0) * h;
        let exponent = if d.hi >= 0.0 {
            -(d - below).square()
        } else {
            below * (d.scale(2.0) - below)
        };
        if exponent.hi > -300.0 {
            let node = (s * c).square().scale(4.0) * exponential(exponent).value();
            total = total + node;
        }
        (s, c) = (s * step_c + c * step_s, c * step_c - s * step_s);
        k += 1.0;
    }
    // (2/pi)(pi/n): the ends carry no weight.
    let mean = Scaled::from(total.scale(2.0) / count);
    if d.hi < 0.0 {
        mean * exponential(-d.square())
    } else {
        mean
    }
}

fn mean_reference(h: Dd, d: Dd) -> Reference {
    if h.hi > WIDEST {
        return Reference::exact(f64::NAN);
    }
    mean(h, d).reference()
}

/// M of the row H, C; 0 for infinite C. NaN for NaN and for H outside 0..1e12.
pub fn footprint_mean_reduced(row: &[f64]) -> Reference {
    let &[h, c] = row else { panic!("a row of 2: {row:?}") };
    if !(h >= 0.0 && h.is_finite()) || c.is_nan() {
        return Reference::exact(f64::NAN);
    }
    if c.is_infinite() {
        return Reference::exact(0.0);
    }
    mean_reference(h.into(), two_sum(h, -c.abs()))
}

/// M of the row H, H - |C|: the distance from the edge as given, which may be known better than the difference of two
/// numbers. NaN for NaN, for H outside 0..1e12, and for a distance above H.
pub fn footprint_mean_reduced_edge(row: &[f64]) -> Reference {
    let &[h, edge] = row else { panic!("a row of 2: {row:?}") };
    if !(h >= 0.0 && h.is_finite()) || edge.is_nan() || edge > h {
        return Reference::exact(f64::NAN);
    }
    if edge.is_infinite() {
        return Reference::exact(0.0);
    }
    mean_reference(h.into(), edge.into())
}

/// The mean over the ellipse of the row a1, a2, cos_phi, offset, sigma: M at H = h/sigma and C = offset/sigma with
/// h^2 = a1^2 (1 - cos^2) + a2^2 cos^2. NaN unless the half axes are not negative, |cos_phi| <= 1 and sigma is positive.
pub fn footprint_mean(row: &[f64]) -> Reference {
    let &[a1, a2, cosine, offset, sigma] = row else {
        panic!("a row of 5: {row:?}")
    };
    let finite = row.iter().all(|x| x.is_finite());
    if !finite || a1 < 0.0 || a2 < 0.0 || cosine.abs() > 1.0 || sigma <= 0.0 {
        return Reference::exact(f64::NAN);
    }
    let sine_squared = two_sum(1.0, -cosine) * two_sum(1.0, cosine);
    let square = two_product(a1, a1) * sine_squared + two_product(a2, a2) * two_product(cosine, cosine);
    let half_width = if square.hi == 0.0 {
        Dd::ZERO
    } else {
        square_root(square)
    };
    mean_reference(half_width / sigma, (half_width + -offset.abs()) / sigma)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_point_gives_the_gaussian_and_a_centred_scratch_the_bessel_form() {
        for c in [0.0, 1e-9, 0.3, 1.0, 5.0, 30.0] {
            let truth = exponential(-two_product(c, c)).reference();
            let error = footprint_mean_reduced(&[0.0, c]).relative_difference(&truth);
            assert!(error < 1e-28, "{c}: {error:e}");
        }
        // exp(-z) (I0 + I1)(z), z = H^2/2 exact.
        for h in [0.5f64, 1.0, 3.0, 8.0, 30.0, 1024.0] {
            let z = 0.5 * h * h;
            let (zeroth, ratio) = (super::super::bessel_i0_scaled(z), super::super::bessel_i1_i0_ratio(z));
            let truth = Dd::new(zeroth.hi, zeroth.lo) * (Dd::new(ratio.hi, ratio.lo) + 1.0);
            let error = footprint_mean_reduced(&[h, 0.0]).relative_difference(&truth.into());
            assert!(error < 1e-27, "{h}: {error:e}");
        }
    }
}
