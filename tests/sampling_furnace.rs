//! The furnace: the energy of a scratch under uniform light by every strategy, the variance of each, the bounds of the
//! weights, and base and scratches together in one sample.

mod sampling_statistics;

use iridescence::diffraction::{
    Coherence, Profile, base_response, coherence_area, profile_rectangle, spatial_phase_infinite,
};
use iridescence::sampling::{
    Strategy, balance_weight, base_lobe_pdf, base_lobe_sample, choose_strategy, mixture_pdf, power_weight,
    scratch_cone_pdf, scratch_cone_sample, scratch_lobe_pdf, scratch_lobe_sample, scratch_sinc_pdf,
    scratch_sinc_sample,
};
use iridescence::special::sinc;
use reference::generate::random::Random;
use sampling_statistics::{Direction, above, integral};
use std::f64::consts::{PI, TAU};

const LIGHT: Coherence = Coherence {
    radius: 10.0,
    wavelength: 0.55,
};
/// The largest sin^2 x (1 + 1/x^2).
const BOUND: f64 = 1.478;

/// The energy of a scratch into a direction under uniform light: exp(-(k sigma xi1)^2) sinc^2 x gamma_o.
fn energy(light: Coherence, width: f64, incident: Direction, outgoing: Direction) -> f64 {
    let y = TAU * light.radius / light.wavelength * (incident[0] + outgoing[0]);
    let x = sinc(PI * width / light.wavelength * (incident[1] + outgoing[1]));
    (-y * y).exp() * x * x * outgoing[2]
}

/// The mean of the energy and the variance of one draw's estimate over its square, by quadrature.
fn moments(incident: Direction, width: f64, pdf: impl Fn(Direction) -> f64) -> [f64; 2] {
    let mean = integral(incident, |o| energy(LIGHT, width, incident, o));
    let square = integral(incident, |o| {
        let e = energy(LIGHT, width, incident, o);
        if e == 0.0 { 0.0 } else { e * (e / pdf(o)) }
    });
    [mean, square / (mean * mean) - 1.0]
}

fn incidents() -> [(&'static str, Direction); 4] {
    [
        ("normal", above(0.0, 0.0)),
        ("30 degrees across", above(0.0, 0.5)),
        ("30 degrees along", above(0.5, 0.0)),
        ("60 degrees across", above(0.0, 0.75f64.sqrt())),
    ]
}

/// The concentration with the smallest variance, and that variance.
fn best_cone(incident: Direction, width: f64) -> [f64; 2] {
    let tried = (14..=19).map(|i| {
        let concentration = 10f64.powf(0.25 * f64::from(i));
        let [_, variance] = moments(incident, width, |o| scratch_cone_pdf(concentration, incident, o));
        [concentration, variance]
    });
    tried.min_by(|a, b| a[1].total_cmp(&b[1])).expect("a concentration")
}

#[test]
fn the_lobe_has_a_small_part_of_the_variance_of_the_published_cone() {
    for (name, incident) in incidents() {
        // At grazing incidence across the scratch the cone loses less.
        let least = if incident[1] < 0.6 {
            [25.0, 100.0, 200.0]
        } else {
            [25.0, 75.0, 140.0]
        };
        for (ratio, times) in [2.0, 10.0, 20.0].into_iter().zip(least) {
            let width = ratio * LIGHT.wavelength;
            let [concentration, cone] = best_cone(incident, width);
            assert!(
                (4000.0..50_000.0).contains(&concentration),
                "not the best: {concentration}"
            );
            let [_, lobe] = moments(incident, width, |o| scratch_lobe_pdf(LIGHT, width, incident, o));
            let [_, exact] = moments(incident, width, |o| scratch_sinc_pdf(LIGHT, width, incident, o));
            println!(
                "{name}, W/lambda {ratio}: cone {cone:.4} at {concentration:.0}, lobe {lobe:.5}, sinc {exact:.1e}, {:.0} times",
                cone / lobe
            );
            assert!(cone >= times * lobe, "{name}, {ratio}: {cone} {lobe}");
            // At its own width and wavelength the exact lobe has no variance but that of the cut.
            assert!(exact < 1e-4, "{name}, {ratio}: {exact}");
        }
    }
}

#[test]
fn every_strategy_gives_the_energy_of_quadrature() {
    let mut random = Random::new(21);
    for (name, incident) in incidents() {
        for width in [0.2, 1.1, 5.5] {
            let concentration = 3e4;
            type Density<'a> = &'a dyn Fn(Direction) -> f64;
            type Draw<'a> = &'a dyn Fn(&mut Random) -> Option<iridescence::sampling::Sample>;
            let u = |r: &mut Random| r.uniform(0.0, 1.0);
            let strategies: [(&str, Density, Draw); 3] = [
                ("cone", &|o| scratch_cone_pdf(concentration, incident, o), &|r| {
                    scratch_cone_sample(concentration, incident, [u(r), u(r), u(r)])
                }),
                ("lobe", &|o| scratch_lobe_pdf(LIGHT, width, incident, o), &|r| {
                    scratch_lobe_sample(LIGHT, width, incident, [u(r), u(r)])
                }),
                ("sinc", &|o| scratch_sinc_pdf(LIGHT, width, incident, o), &|r| {
                    scratch_sinc_sample(LIGHT, width, incident, [u(r), u(r)])
                }),
            ];
            for (strategy, pdf, draw) in strategies {
                let [mean, variance] = moments(incident, width, pdf);
                let draws = 200_000;
                let estimate = (0..draws)
                    .filter_map(|_| draw(&mut random))
                    .map(|s| energy(LIGHT, width, incident, s.direction) / s.pdf)
                    .sum::<f64>()
                    / f64::from(draws);
                let error = (variance.max(1e-18) / f64::from(draws)).sqrt();
                let apart = (estimate / mean - 1.0).abs();
                // Beside the statistics: the rounding of k sigma xi1.
                assert!(
                    apart < 4.0 * error + 1e-9,
                    "{name} {strategy} {width}: {estimate} of {mean}, {error}"
                );
            }
        }
    }
}

#[test]
fn the_weights_of_the_lobe_are_bounded_and_the_bound_is_reached() {
    let mut random = Random::new(22);
    let mut largest = 0f64;
    for i in 0..400_000 {
        let incident = above(random.uniform(-0.7, 0.7), random.uniform(-0.7, 0.7));
        let light = Coherence {
            radius: random.log_uniform(0.5, 60.0),
            wavelength: random.uniform(0.38, 0.73),
        };
        let width = if i % 50 == 0 {
            0.0
        } else {
            random.log_uniform(1e-3, 20.0)
        };
        let numbers = [random.uniform(0.0, 1.0), random.uniform(0.0, 1.0)];
        let Some(sample) = scratch_lobe_sample(light, width, incident, numbers) else {
            continue;
        };
        let weight = energy(light, width, incident, sample.direction) / sample.pdf;
        let (q, c) = (TAU * light.radius / light.wavelength, PI * width / light.wavelength);
        // The share of the width's angle: at most pi, and at most the interval's length.
        let angle = if c > 0.0 { (PI / c).min(2.0) } else { 2.0 };
        let bound = BOUND * PI.sqrt() / q * angle;
        largest = largest.max(weight / bound);
        assert!(weight <= bound, "{light:?} {width} {incident:?}: {weight} {bound}");
    }
    assert!(largest > 0.95, "{largest}");
}

#[test]
fn the_lorentzian_stays_above_sinc_squared_over_its_bound() {
    let largest = (1..4_000_000).map(|i| f64::from(i) * 1e-6 * 10.0).map(|x| {
        let s = sinc(x);
        s * s * (1.0 + x * x)
    });
    let largest = largest.fold(0.0, f64::max);
    assert!(largest <= BOUND && largest > BOUND - 1e-5, "{largest}");
}

/// A surface with one scratch: what a renderer draws from.
struct Surface {
    profile: Profile,
    offset: f64,
    incident: Direction,
    probabilities: [f64; 2],
}

impl Surface {
    fn reflected(&self, outgoing: Direction) -> f64 {
        let scattering = [0, 1, 2].map(|i| self.incident[i] + outgoing[i]);
        let xi = [scattering[0], scattering[1]];
        let scratch = spatial_phase_infinite(LIGHT, self.offset, xi)
            * profile_rectangle(self.profile, scattering, LIGHT.wavelength);
        let base = base_response(LIGHT, xi);
        (scratch - base).norm_sqr() * outgoing[2]
    }

    fn densities(&self, outgoing: Direction) -> [f64; 2] {
        [
            base_lobe_pdf(LIGHT, self.incident, outgoing),
            scratch_lobe_pdf(LIGHT, self.profile.width, self.incident, outgoing),
        ]
    }

    fn mixture(&self, outgoing: Direction) -> f64 {
        let [base, scratch] = self.densities(outgoing);
        mixture_pdf(&[
            Strategy {
                probability: self.probabilities[0],
                pdf: base,
            },
            Strategy {
                probability: self.probabilities[1],
                pdf: scratch,
            },
        ])
    }

    /// The largest weight: |B - S|^2 is at most twice |B|^2 + |S|^2, each bounded by its own lobe.
    fn bound(&self) -> f64 {
        let q = TAU * LIGHT.radius / LIGHT.wavelength;
        let c = PI * self.profile.width / LIGHT.wavelength;
        let area = coherence_area(LIGHT.radius);
        let base = (2.0 * area).powi(2) * PI / (q * q);
        let height = 4.0 * self.profile.width.powi(2) * 2.0 * area;
        let scratch = height * BOUND * PI.sqrt() / q * (PI / c).min(2.0);
        2.0 * (base / self.probabilities[0]).max(scratch / self.probabilities[1])
    }
}

#[test]
fn base_and_scratch_in_one_sample_have_bounded_weights_and_the_right_mean() {
    let mut random = Random::new(23);
    for (name, incident) in incidents() {
        for (width, depth, offset) in [(0.2, 0.1, 0.0), (1.1, 0.14, 3.0), (5.5, 0.2, -8.0)] {
            let surface = Surface {
                profile: Profile { width, depth },
                offset,
                incident,
                probabilities: [0.6, 0.4],
            };
            let bound = surface.bound();
            let mean = integral(incident, |o| surface.reflected(o));
            let square = integral(incident, |o| {
                let value = surface.reflected(o);
                if value == 0.0 {
                    0.0
                } else {
                    value * (value / surface.mixture(o))
                }
            });
            let draws = 100_000;
            let mut sum = 0.0;
            for _ in 0..draws {
                let choice = choose_strategy(&surface.probabilities, random.uniform(0.0, 1.0)).expect("a choice");
                let numbers = [choice.random, random.uniform(0.0, 1.0)];
                let sample = if choice.index == 0 {
                    base_lobe_sample(LIGHT, incident, numbers)
                } else {
                    scratch_lobe_sample(LIGHT, width, incident, numbers)
                };
                let Some(sample) = sample else { continue };
                let value = surface.reflected(sample.direction);
                let weight = value / surface.mixture(sample.direction);
                assert!(weight <= bound, "{name} {width}: {weight} of {bound}");
                // The same as the balance heuristic over its own density.
                let [base, scratch] = surface.densities(sample.direction);
                let terms = [base * 0.6, scratch * 0.4];
                let own = choice.index;
                let balanced = balance_weight(terms[own], terms[1 - own]) * value / (sample.pdf * choice.probability);
                assert!((balanced / weight - 1.0).abs() < 1e-12, "{balanced} {weight}");
                sum += weight;
            }
            let estimate = sum / f64::from(draws);
            let error = ((square - mean * mean) / f64::from(draws)).sqrt();
            assert!(
                (estimate - mean).abs() < 4.0 * error,
                "{name} {width}: {estimate} of {mean}, {error}"
            );
        }
    }
}

#[test]
fn weights_sum_to_one_and_have_their_limits() {
    let mut random = Random::new(24);
    for _ in 0..100_000 {
        let [a, b] = [(); 2].map(|()| random.log_uniform(1e-300, 1e300));
        for weight in [balance_weight, power_weight] {
            let (own, other) = (weight(a, b), weight(b, a));
            assert!(
                (own + other - 1.0).abs() <= f64::EPSILON && (0.0..=1.0).contains(&own),
                "{a:e} {b:e}"
            );
            assert!(own == other || (own > other) == (a > b), "{a:e} {b:e}");
        }
        let ratio = random.log_uniform(1e-3, 1e3);
        let (balance, power) = (balance_weight(ratio * 1e304, 1e304), power_weight(ratio * 1e304, 1e304));
        assert!((balance - ratio / (1.0 + ratio)).abs() < 4e-16, "{ratio}");
        assert!((power - ratio * ratio / (1.0 + ratio * ratio)).abs() < 8e-16, "{ratio}");
    }
    for weight in [balance_weight, power_weight] {
        assert_eq!((weight(0.0, 0.0), weight(0.0, 1.0), weight(1.0, 0.0)), (0.0, 0.0, 1.0));
        assert_eq!((weight(f64::INFINITY, 1.0), weight(1.0, f64::INFINITY)), (1.0, 0.0));
        assert_eq!(weight(f64::INFINITY, f64::INFINITY), 0.5);
        assert!(weight(f64::NAN, 1.0).is_nan() && weight(1.0, f64::NAN).is_nan() && weight(-1.0, 2.0).is_nan());
    }
}

#[test]
fn a_choice_has_its_probability_and_leaves_a_uniform_number() {
    let weights = [0.0, 3.0, 1.0, 0.0, 4.0, 0.0];
    let mut counts = [0u32; 6];
    let mut sums = [0.0; 6];
    let draws = 80_000;
    for i in 0..draws {
        let choice = choose_strategy(&weights, (f64::from(i) + 0.5) / f64::from(draws)).expect("a choice");
        counts[choice.index] += 1;
        sums[choice.index] += choice.random;
        assert_eq!(choice.probability, weights[choice.index] / 8.0);
        assert!((0.0..1.0).contains(&choice.random));
    }
    assert_eq!(counts, [0, 30_000, 10_000, 0, 40_000, 0]);
    for (sum, count) in sums.iter().zip(counts) {
        assert!((sum - 0.5 * f64::from(count)).abs() < 1e-6, "{sums:?}");
    }
    assert_eq!(choose_strategy(&weights, 0.0).map(|c| c.index), Some(1));
    assert_eq!(
        choose_strategy(&weights, 1.0 - f64::EPSILON / 2.0).map(|c| c.index),
        Some(4)
    );
    // The sum of tenths is rounded: the last of them takes what is left.
    let last = choose_strategy(&[0.1; 10], 1.0 - f64::EPSILON / 2.0).expect("a choice");
    assert!(last.index == 9 && last.random < 1.0);
    for refused in [&[][..], &[0.0], &[-1.0, 2.0], &[f64::NAN], &[f64::INFINITY, 1.0]] {
        assert!(choose_strategy(refused, 0.5).is_none(), "{refused:?}");
    }
    assert!(choose_strategy(&weights, 1.0).is_none() && choose_strategy(&weights, f64::NAN).is_none());
    let never = Strategy {
        probability: 0.0,
        pdf: f64::INFINITY,
    };
    assert_eq!(
        mixture_pdf(&[
            never,
            Strategy {
                probability: 0.5,
                pdf: 3.0
            }
        ]),
        1.5
    );
}
