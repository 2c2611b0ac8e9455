//! The inverses of the two distribution functions that samples are drawn from: of sinc^2 and of the Gaussian.

use iridescence::sampling::{gaussian_inverse, sinc_squared_cdf, sinc_squared_inverse};
use iridescence::special::{erf, erfcx};
use reference::generate::random::{Random, neighbour};
use reference::metrics::Reference;
use reference::oracle;
use std::f64::consts::PI;

/// pi less its f64.
const PI_REST: f64 = 1.2246467991473532e-16;

/// int_{-inf}^x sinc^2 - pi u from the oracle, for u <= 1/2, in units of eps pi u and of what one unit of x moves.
fn error_of_lower(x: f64, u: f64) -> f64 {
    let Reference { hi, lo, exponent } = oracle::sinc_squared_integral(f64::NEG_INFINITY, x);
    let scale = 2f64.powi(exponent);
    let product = PI * u;
    let rest = PI.mul_add(u, -product) + PI_REST * u;
    let residual = ((hi * scale - product) + lo * scale) - rest;
    let sinc = x.sin() / x;
    let envelope = product + sinc * sinc * x.abs();
    residual.abs() / (f64::EPSILON * envelope)
}

fn random_share(random: &mut Random) -> f64 {
    match random.integer(0, 3) {
        0 => random.uniform(0.0, 0.5),
        1 => random.log_uniform(1e-18, 0.5),
        2 => 0.5 - random.log_uniform(1e-16, 0.5),
        // Beside the mass that ends at a zero of sinc.
        _ => {
            let n = random.log_uniform(1.0, 1e6).floor();
            let share = oracle::sinc_squared_integral(n * PI, f64::INFINITY);
            let step = random.log_uniform(1.0, 1e14) as i64;
            let step = if random.chance(0.5) { step } else { -step };
            neighbour(
                (share.hi * 2f64.powi(share.exponent) / PI).min(0.4),
                step.clamp(-1 << 50, 1 << 50),
            )
        }
    }
}

#[test]
fn the_inverse_of_sinc_squared_is_within_the_conditioning_envelope() {
    let mut random = Random::new(11);
    let mut worst = (0.0, 0.0);
    for _ in 0..200_000 {
        let u = random_share(&mut random);
        if u <= 0.0 || u > 0.5 - 1e-16 {
            continue;
        }
        let x = sinc_squared_inverse(u);
        let error = error_of_lower(x, u);
        if error > worst.0 || error.is_nan() {
            worst = (error, u);
        }
    }
    println!("worst {} eps at u = {:e}", worst.0, worst.1);
    assert!(worst.0 <= 4.0, "{} eps at u = {:e}", worst.0, worst.1);
}

#[test]
fn the_inverse_of_sinc_squared_keeps_its_relative_accuracy_at_the_centre() {
    let mut random = Random::new(12);
    for _ in 0..50_000 {
        let step = random.log_uniform(1e-15, 0.05);
        let u = 0.5 + step;
        let v = PI * (u - 0.5);
        let x = sinc_squared_inverse(u);
        let truth = oracle::sinc_squared_integral(0.0, x);
        let error = (truth.hi * 2f64.powi(truth.exponent) - v).abs() / v;
        assert!(error <= 3.0 * f64::EPSILON, "{u:e}: {error:e}");
    }
}

#[test]
fn the_inverse_of_sinc_squared_is_antisymmetric_and_rises() {
    let mut random = Random::new(13);
    for _ in 0..50_000 {
        let u = (random.bits() >> 11) as f64 * 2f64.powi(-53);
        // 1 - u is exact for multiples of 2^-53.
        assert_eq!(sinc_squared_inverse(u), -sinc_squared_inverse(1.0 - u), "{u:e}");
    }
    let mut last = f64::NEG_INFINITY;
    for i in 0..=100_000 {
        let x = sinc_squared_inverse(f64::from(i) / 100_000.0);
        assert!(x >= last, "{i}: {x} after {last}");
        last = x;
    }
    assert_eq!(last, f64::INFINITY);
}

#[test]
fn the_inverses_have_their_limits() {
    for inverse in [sinc_squared_inverse as fn(f64) -> f64, gaussian_inverse] {
        assert_eq!(inverse(0.0), f64::NEG_INFINITY);
        assert_eq!(inverse(0.5), 0.0);
        assert_eq!(inverse(1.0), f64::INFINITY);
        for outside in [-1e-300, 1.0 + f64::EPSILON, f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            assert!(inverse(outside).is_nan(), "{outside}");
        }
        for tiny in [1e-300, 1e-200, 1e-17, 2f64.powi(-53)] {
            assert!(inverse(tiny).is_finite() && inverse(tiny) < 0.0, "{tiny:e}");
        }
    }
    // Far out the tail is 1/(2x).
    assert!((sinc_squared_inverse(1e-200) * (2e-200 * PI) + 1.0).abs() < 4.0 * f64::EPSILON);
    assert_eq!(sinc_squared_inverse(1e-310), f64::NEG_INFINITY);
    assert_eq!(sinc_squared_cdf(f64::INFINITY), 1.0);
    assert_eq!(sinc_squared_cdf(f64::NEG_INFINITY), 0.0);
    assert_eq!(sinc_squared_cdf(0.0), 0.5);
    assert!(sinc_squared_cdf(f64::NAN).is_nan());
}

#[test]
fn the_inverse_of_the_gaussian_is_within_the_conditioning_envelope() {
    let mut random = Random::new(14);
    let mut worst = (0.0, 0.0);
    for i in 0..400_000 {
        let u = match i % 3 {
            0 => random.uniform(0.0, 0.5),
            1 => random.log_uniform(1e-300, 0.5),
            _ => 0.5 - random.log_uniform(1e-15, 0.5),
        };
        if u <= 0.0 || u >= 0.5 {
            continue;
        }
        let y = gaussian_inverse(u);
        // The residual in units of y, by the derivative of the distribution.
        let step = if u < 0.25 {
            let logarithm = (2.0 * u).ln();
            (((y * y + logarithm).exp() - erfcx(-y)) * PI.sqrt() / 2.0).abs()
        } else {
            (erf(y) - (2.0 * u - 1.0)).abs() * (y * y).exp() * PI.sqrt() / 2.0
        };
        let error = step / (f64::EPSILON * y.abs());
        if error > worst.0 || error.is_nan() {
            worst = (error, u);
        }
    }
    println!("worst {} eps at u = {:e}", worst.0, worst.1);
    assert!(worst.0 <= 4.0, "{} eps at u = {:e}", worst.0, worst.1);
    // Known quantiles of the normal distribution over sqrt(2): 1.959963984540054 and 4.264890793922825.
    assert!((gaussian_inverse(0.975) * 2f64.sqrt() - 1.959963984540054).abs() < 1e-15);
    assert!((gaussian_inverse(1e-5) * 2f64.sqrt() + 4.264890793922825).abs() < 4e-15);
}
