//! The f32 lobes: densities against f64, samples that have the density they say, draws that fall as it tells.
#![cfg(feature = "shader")]

mod sampling_statistics;

use iridescence::diffraction::Coherence;
use iridescence::sampling;
use iridescence::shader::{
    SampledDirection, balance_weight, base_lobe_pdf, base_lobe_sample, gaussian_inverse, scratch_cone_pdf,
    scratch_cone_sample, scratch_lobe_pdf, scratch_lobe_sample,
};
use reference::generate::random::Random;
use sampling_statistics::{Direction, Lobe, above, pearson};

/// A uniform f32 of [0, 1).
fn uniform(random: &mut Random) -> f32 {
    (random.bits() >> 40) as f32 * 2f32.powi(-24)
}

/// Radius, wavelength, width and concentration of a test, in f32.
#[derive(Clone, Copy, Debug)]
struct Surface {
    radius: f32,
    wavelength: f32,
    width: f32,
    concentration: f32,
}

impl Surface {
    fn coherence(self) -> Coherence {
        Coherence {
            radius: self.radius.into(),
            wavelength: self.wavelength.into(),
        }
    }
}

const SURFACE: Surface = Surface {
    radius: 10.0,
    wavelength: 0.55,
    width: 1.1,
    concentration: 20.0,
};

fn surfaces() -> [Surface; 4] {
    [
        SURFACE,
        Surface {
            radius: 0.8,
            width: 0.2,
            concentration: 0.0,
            ..SURFACE
        },
        Surface {
            width: 0.0,
            concentration: 0.3,
            ..SURFACE
        },
        Surface {
            radius: 2.0,
            width: 11.0,
            concentration: 3e4,
            ..SURFACE
        },
    ]
}

fn incidents() -> [[f32; 3]; 4] {
    [above(0.0, 0.0), above(0.5, -0.3), above(0.99, 0.0), above(-0.1, 0.95)].map(|d| d.map(|x| x as f32))
}

/// A density in f32 and in f64, and a sampler.
struct Strategy {
    name: &'static str,
    pdf: fn(Surface, [f32; 3], [f32; 3]) -> f32,
    truth: fn(Surface, Direction, Direction) -> f64,
    sample: fn(Surface, [f32; 3], &mut Random) -> SampledDirection,
}

const STRATEGIES: [Strategy; 3] = [
    Strategy {
        name: "base",
        pdf: |s, i, o| base_lobe_pdf(s.radius, s.wavelength, i[0], i[1], o[0], o[1], o[2]),
        truth: |s, i, o| sampling::base_lobe_pdf(s.coherence(), i, o),
        sample: |s, i, r| base_lobe_sample(s.radius, s.wavelength, i[0], i[1], uniform(r), uniform(r)),
    },
    Strategy {
        name: "scratch",
        pdf: |s, i, o| scratch_lobe_pdf(s.radius, s.wavelength, s.width, i[0], i[1], o[0], o[1], o[2]),
        truth: |s, i, o| sampling::scratch_lobe_pdf(s.coherence(), s.width.into(), i, o),
        sample: |s, i, r| scratch_lobe_sample(s.radius, s.wavelength, s.width, i[0], i[1], uniform(r), uniform(r)),
    },
    Strategy {
        name: "cone",
        pdf: |s, i, o| scratch_cone_pdf(s.concentration, i[0], i[1], i[2], o[0], o[1], o[2]),
        truth: |s, i, o| sampling::scratch_cone_pdf(s.concentration.into(), i, o),
        sample: |s, i, r| scratch_cone_sample(s.concentration, i[0], i[1], i[2], uniform(r), uniform(r), uniform(r)),
    },
];

#[test]
fn the_densities_are_those_of_f64() {
    let mut random = Random::new(31);
    for strategy in STRATEGIES {
        let mut worst = 0f64;
        for surface in surfaces() {
            for incident in incidents() {
                for i in 0..4000 {
                    // Half of them where the density is, half of them anywhere.
                    let drawn = (strategy.sample)(surface, incident, &mut random);
                    let outgoing = if i % 2 == 0 && drawn.pdf > 0.0 {
                        [drawn.x, drawn.y, drawn.z]
                    } else {
                        let (x, y) = (random.uniform(-0.7, 0.7), random.uniform(-0.7, 0.7));
                        above(x, y).map(|c| c as f32)
                    };
                    let value = f64::from((strategy.pdf)(surface, incident, outgoing));
                    let truth = (strategy.truth)(surface, incident.map(f64::from), outgoing.map(f64::from));
                    if truth < 1e-30 {
                        assert!(
                            value < 2e-30,
                            "{} {surface:?} {incident:?} {outgoing:?}: {value:e}",
                            strategy.name
                        );
                        continue;
                    }
                    // The exponent of a direction known to half an eps: twice the root of it times the scale of the lobe.
                    let scale = f64::from(surface.radius / surface.wavelength * 6.3)
                        .max(f64::from(surface.concentration).sqrt());
                    let exponent = (-(truth / scale.powi(2)).ln()).max(1.0);
                    let error = (value / truth - 1.0).abs()
                        / (f64::from(f32::EPSILON) * (8.0 + exponent + scale * exponent.sqrt()));
                    worst = worst.max(error);
                    assert!(
                        error < 2.0,
                        "{} {surface:?} {incident:?} {outgoing:?}: {value} {truth} {error}",
                        strategy.name
                    );
                }
            }
        }
        println!("{}: {worst} of the envelope", strategy.name);
    }
}

#[test]
fn the_densities_along_the_tangent_are_those_of_f64_however_low_the_direction() {
    for strategy in STRATEGIES {
        for surface in surfaces() {
            for z in (2..=30).map(|n| 10f32.powi(-n)) {
                let (incident, outgoing) = ([-0.999_999_5, 0.001, 0.0], [1.0, 0.0, z]);
                let value = f64::from((strategy.pdf)(surface, incident, outgoing));
                let truth = (strategy.truth)(surface, incident.map(f64::from), outgoing.map(f64::from));
                assert!(
                    (value - truth).abs() <= 1e-4 * truth + 1e-30,
                    "{} {surface:?} {z:e}: {value:e} {truth:e}",
                    strategy.name
                );
            }
        }
    }
}

#[test]
fn a_sample_has_the_density_it_says_and_is_a_unit_vector() {
    let mut random = Random::new(32);
    for strategy in STRATEGIES {
        let (mut drawn, mut lost) = (0, 0);
        for surface in surfaces() {
            for incident in incidents() {
                for _ in 0..20_000 {
                    let SampledDirection { x, y, z, pdf } = (strategy.sample)(surface, incident, &mut random);
                    assert_eq!(pdf, (strategy.pdf)(surface, incident, [x, y, z]), "{}", strategy.name);
                    assert!(
                        pdf >= 0.0 && pdf.is_finite(),
                        "{} {surface:?} {incident:?}: {pdf}",
                        strategy.name
                    );
                    if pdf > 0.0 {
                        drawn += 1;
                        let size = x * x + y * y + z * z;
                        assert!(
                            (size - 1.0).abs() < 2e-6 && z >= 0.0,
                            "{} {surface:?} {x} {y} {z}",
                            strategy.name
                        );
                    } else {
                        lost += 1;
                    }
                }
            }
        }
        assert!(
            drawn > 200_000 && (strategy.name == "cone") == (lost == 0),
            "{}: {drawn} {lost}",
            strategy.name
        );
    }
}

#[test]
fn draws_fall_as_the_densities_of_f64_tell() {
    let mut seed = 300;
    for strategy in STRATEGIES {
        for surface in surfaces() {
            for incident in incidents() {
                let truth = |o: Direction| (strategy.truth)(surface, incident.map(f64::from), o);
                let sample = |r: &mut Random| {
                    let drawn = (strategy.sample)(surface, incident, r);
                    (drawn.pdf > 0.0).then(|| [drawn.x, drawn.y, drawn.z].map(f64::from))
                };
                let lobe = Lobe {
                    incident: incident.map(f64::from),
                    pdf: &truth,
                    sample: &sample,
                };
                seed += 1;
                let p = pearson(&lobe, seed, 60_000);
                assert!(p > 0.01 / 48.0, "{} {surface:?} {incident:?}: p = {p:e}", strategy.name);
            }
        }
    }
}

#[test]
fn the_inverse_of_the_gaussian_is_that_of_f64_at_every_random_number() {
    let mut worst = 0f64;
    for i in (1..1u32 << 24).step_by(7) {
        let u = i as f32 * 2f32.powi(-24);
        let truth = sampling::gaussian_inverse(u.into());
        let error = (f64::from(gaussian_inverse(u)) - truth).abs() / truth.abs().max(1.0);
        worst = worst.max(error);
    }
    println!("{worst:e}");
    assert!(worst <= 1e-6, "{worst:e}");
    assert_eq!(gaussian_inverse(0.5), 0.0);
    assert!(gaussian_inverse(0.0).is_finite() && gaussian_inverse(0.0) < -3.7);
    let mut random = Random::new(33);
    for _ in 0..20_000 {
        let u = random.log_uniform(3e-8, 1e-4) as f32;
        let truth = sampling::gaussian_inverse(u.into());
        assert!((f64::from(gaussian_inverse(u)) / truth - 1.0).abs() < 1e-6, "{u:e}");
    }
}

#[test]
fn the_balance_weight_is_that_of_f64() {
    let mut random = Random::new(34);
    for _ in 0..100_000 {
        let [a, b] = [(); 2].map(|()| random.log_uniform(1e-30, 1e38) as f32);
        let truth = sampling::balance_weight(a.into(), b.into());
        let value = f64::from(balance_weight(a, b));
        assert!(
            (value - truth).abs() <= 2e-7 * truth + 1e-45,
            "{a:e} {b:e}: {value} {truth}"
        );
    }
    assert_eq!(
        (
            balance_weight(0.0, 2.0),
            balance_weight(2.0, 0.0),
            balance_weight(0.0, 0.0)
        ),
        (0.0, 1.0, 0.0)
    );
}
