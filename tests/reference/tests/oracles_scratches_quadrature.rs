//! The oracles of the scratch functions against plain quadrature of the defining integrals, on rows of the generators.

use reference::generate::random::Random;
use reference::generate::scratches;
use reference::metrics::Reference;
use reference::oracle::{self, arbitrary};
use std::f64::consts::PI;

/// Nodes and weights of the Gauss-Legendre rule with 16 nodes on [0, 1].
fn gauss() -> Vec<(f64, f64)> {
    const NODES: usize = 16;
    let rule = (0..NODES).map(|i| {
        let mut x = -(PI * (i as f64 + 0.75) / (NODES as f64 + 0.5)).cos();
        let mut slope = 1.0;
        for _ in 0..8 {
            let (mut before, mut value) = (1.0, x);
            for k in 2..=NODES {
                let k = k as f64;
                (before, value) = (value, ((2.0 * k - 1.0) * x * value - (k - 1.0) * before) / k);
            }
            slope = NODES as f64 * (x * value - before) / (x * x - 1.0);
            x -= value / slope;
        }
        (0.5 * (x + 1.0), 1.0 / ((1.0 - x * x) * slope * slope))
    });
    rule.collect()
}

/// The integral of a complex function over [from, to] in `panels` panels.
fn integral(from: f64, to: f64, panels: f64, f: impl Fn(f64) -> [f64; 2]) -> [f64; 2] {
    let rule = gauss();
    let width = (to - from) / panels.ceil();
    let mut sum = [0.0; 2];
    for panel in 0..panels.ceil() as usize {
        let start = from + width * panel as f64;
        for &(node, weight) in &rule {
            let [re, im] = f(start + width * node);
            sum = [sum[0] + weight * width * re, sum[1] + weight * width * im];
        }
    }
    sum
}

fn distance(value: [Reference; 2], other: [f64; 2]) -> f64 {
    (value[0].value() - other[0]).hypot(value[1].value() - other[1])
}

#[test]
fn the_spatial_phase_is_the_integral_of_the_window_along_the_scratch() {
    let mut held = 0;
    let mut worst: f64 = 0.0;
    for row in (scratches::SPATIAL_PHASE.rows)(41, 1200).chunks_exact(8) {
        let &[sigma, lambda, xi1, xi2, s_t, s_b, l1, l2] = row else {
            unreachable!()
        };
        if l1 >= l2 || s_b.abs() > 25.0 * sigma {
            continue;
        }
        // Places along the scratch from the window's centre, in sigma; where the window is 1e-18 of its largest value.
        let (u1, u2) = ((s_t + l1) / sigma, (s_t + l2) / sigma);
        let nearest = if u1 > 0.0 { u1 } else { u2.min(0.0) };
        if nearest.abs() > 25.0 {
            continue;
        }
        let reach = nearest.hypot(9.2);
        let start = u1.max(-reach);
        let length = if u1 >= -reach && u2 <= reach {
            (l2 - l1) / sigma
        } else {
            u2.min(reach) - start
        };
        let beta = 2.0 * PI * sigma * xi1 / lambda;
        let turns = s_b * xi2 / lambda;
        let outer = sigma * (-0.5 * (s_b / sigma).powi(2)).exp();
        let size = |v: f64| outer * (-0.5 * (start + v).powi(2)).exp();
        let panels = 8.0 + length * (2.0 + beta.abs() / 4.0);
        let along = integral(0.0, length, panels, |v| {
            let (sine, cosine) = (beta * (start + v)).sin_cos();
            [size(v) * cosine, -size(v) * sine]
        });
        let [whole, _] = integral(0.0, length, 8.0 + 2.0 * length, |v| [size(v), 0.0]);
        let (sine, cosine) = (2.0 * PI * (turns - turns.round())).sin_cos();
        let quadrature = [along[0] * cosine + along[1] * sine, along[1] * cosine - along[0] * sine];
        // What f64 leaves of the phases.
        let phase = beta.abs() * (nearest.abs() + 2.0) + 2.0 * PI * turns.abs();
        let allowed = 1e-13 * (1.0 + nearest * nearest) + 4e-16 * phase;
        let error = distance(oracle::spatial_phase(row), quadrature) / whole;
        worst = worst.max(error / allowed);
        assert!(error < allowed, "{row:?}: {error:e}, allowed {allowed:e}");
        held += 1;
    }
    assert!(held > 500, "{held}");
    println!("{held} rows, {worst:.2} of what is allowed");
}

#[test]
fn the_profiles_are_the_transforms_of_their_cross_sections() {
    for domain in [scratches::PROFILE, scratches::TRIANGLE_POLES] {
        for row in (domain.rows)(42, 900).chunks_exact(5) {
            let &[width, depth, xi2, gamma_sum, lambda] = row else {
                unreachable!()
            };
            let (p, q) = (2.0 * PI * gamma_sum * depth / lambda, PI * width * xi2 / lambda);
            let panels = 4.0 + (p.abs() + q.abs()) / 4.0;
            // Over both halves of the width, u = 2|b|/W.
            let rectangle = integral(0.0, 1.0, panels, |u| {
                let size = width * (q * u).cos();
                let half = (0.5 * p).sin();
                [2.0 * size * half * half, -2.0 * size * half * (0.5 * p).cos()]
            });
            let triangle = integral(0.0, 1.0, panels, |u| {
                let size = width * (q * u).cos();
                let (sine, cosine) = (p * (1.0 - u)).sin_cos();
                [size * cosine, size * sine]
            });
            let allowed = width * (1e-14 + 1e-15 * (p.abs() + q.abs()));
            for (name, oracle, quadrature) in [
                ("rectangle", oracle::profile_rectangle(row), rectangle),
                ("triangle", oracle::profile_triangle(row), triangle),
            ] {
                let error = distance(oracle, quadrature);
                assert!(error <= allowed, "{name} {row:?}: {error:e}, allowed {allowed:e}");
            }
        }
    }
}

/// The share of the footprint mean between one edge, at the distance `d`, and the centre: with t = 1 - v^2 it is
/// (4/pi) int_0^1 v^2 sqrt(2 - v^2) exp(-(d - H v^2)^2) dv.
fn from_edge(h: f64, d: f64) -> f64 {
    let reach = 6.2;
    let place = |depth: f64| (depth / h.max(1e-300)).clamp(0.0, 1.0).sqrt();
    let last = if d > 0.0 {
        d + reach
    } else {
        reach * reach / (reach - d)
    };
    let (from, to) = if h < 20.0 {
        (0.0, 1.0)
    } else {
        (place(d - reach), place(last))
    };
    let share = integral(from, to, 60.0, |v| {
        let below = h * v * v;
        [v * v * (2.0 - v * v).sqrt() * (-(d - below).powi(2)).exp(), 0.0]
    });
    4.0 / PI * share[0]
}

#[test]
fn the_footprint_mean_is_the_integral_over_the_chords_of_the_ellipse() {
    let (mut worst, mut tails): (f64, usize) = (0.0, 0);
    for row in (scratches::FOOTPRINT_REDUCED.rows)(43, 3000).chunks_exact(2) {
        let &[h, c] = row else { unreachable!() };
        let d = h - c.abs();
        let quadrature = from_edge(h, d) + from_edge(h, h + c.abs());
        let error = (oracle::footprint_mean_reduced(row).value() / quadrature - 1.0).abs();
        // What f64 leaves of the distance to the edge, and of the depth below it.
        let allowed = 2e-14 + 8e-16 * h;
        worst = worst.max(error / allowed);
        tails += usize::from(d < -1.0);
        assert!(error < allowed, "{row:?}: {error:e}, allowed {allowed:e}");
    }
    assert!(tails > 300, "{tails}");
    println!("{worst:.2} of what is allowed");
}

#[test]
fn the_footprint_mean_is_the_mean_over_the_points_of_the_ellipse() {
    // Over the disc r, phi of the ellipse's own axes: no chord, no half width.
    let mut random = Random::new(44);
    for _ in 0..60 {
        let sigma = 10.0;
        let (a1, a2) = (random.log_uniform(0.1, 60.0), random.log_uniform(0.1, 60.0));
        let phi = random.uniform(0.0, PI);
        let offset = random.uniform(-80.0, 80.0);
        let steps = 400;
        let mean = integral(0.0, 1.0, 12.0, |r| {
            let ring = (0..steps).map(|k| {
                let (sine, cosine) = (2.0 * PI * (f64::from(k) + 0.5) / f64::from(steps)).sin_cos();
                // The first axis at phi to the tangent; the bitangent's component of the point.
                let across = a1 * r * cosine * phi.sin() + a2 * r * sine * phi.cos();
                (-((across - offset) / sigma).powi(2)).exp()
            });
            [2.0 * r * ring.sum::<f64>() / f64::from(steps), 0.0]
        });
        let truth = oracle::footprint_mean(&[a1, a2, phi.cos(), offset, sigma]).value();
        let centred = oracle::footprint_mean(&[a1, a2, phi.cos(), 0.0, sigma]).value();
        assert!(
            (mean[0] - truth).abs() < 1e-13 * centred,
            "{a1} {a2} {phi} {offset}: {mean:?} {truth}"
        );
    }
}

#[test]
fn a_segments_energy_is_the_sum_of_its_spatial_phase_over_the_plane() {
    let mut random = Random::new(45);
    for row in (scratches::SEGMENT_ENERGY.rows)(45, 120).chunks_exact(4) {
        let &[sigma, lambda, xi1, _] = row else { unreachable!() };
        let length = sigma * random.log_uniform(1e-3, 30.0);
        // |eta|^2 has no detail finer than sigma along the tangent: the trapezoidal rule; across, int exp(-s^2/sigma^2).
        let step = 0.4 * sigma;
        let count = ((length + 18.0 * sigma) / step).ceil() as i32;
        let sum: f64 = (0..=count)
            .map(|k| {
                let s_t = -length - 9.0 * sigma + step * f64::from(k);
                let eta = oracle::spatial_phase(&[sigma, lambda, xi1, 0.3, s_t, 0.0, 0.0, length]);
                eta[0].value().powi(2) + eta[1].value().powi(2)
            })
            .sum();
        let quadrature = sum * step * sigma * PI.sqrt();
        let truth = oracle::segment_energy(&[sigma, lambda, xi1, length]).value();
        assert!(
            (quadrature / truth - 1.0).abs() < 1e-12,
            "{row:?} {length}: {quadrature:e} {truth:e}"
        );
    }
}

#[test]
fn the_inverse_of_the_sinc_squared_integral_gives_the_integral_back() {
    let mut random = Random::new(46);
    for k in 0..160 {
        let u = if k % 2 == 0 {
            random.uniform(0.0, 1.0)
        } else {
            random.log_uniform(1e-10, 0.5)
        };
        let x = oracle::sinc_squared_inverse(u);
        let share = arbitrary::sinc_squared_integral(f64::NEG_INFINITY, x.hi);
        // What the low part adds, to the second order.
        let sinc = x.hi.sin() / x.hi;
        let slope = (x.hi.cos() - sinc) / x.hi;
        let (hi, lo) = (share.hi, share.lo + x.lo * sinc * (sinc + x.lo * slope));
        let pi_u = Reference {
            hi: PI * u,
            lo: PI.mul_add(u, -(PI * u)) + 1.2246467991473532e-16 * u,
            exponent: 0,
        };
        let error = ((hi - pi_u.hi) + (lo - pi_u.lo)) / pi_u.hi;
        assert!(share.exponent == 0 && error.abs() < 1e-29, "{u}: {x:?} {error:e}");
    }
}
