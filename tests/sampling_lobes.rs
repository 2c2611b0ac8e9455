//! The lobes of a scratched surface: each density integrates to the share of draws that propagate, each sample has the
//! density it says, draws fall as the density tells, limits hold.

mod sampling_statistics;

use iridescence::diffraction::Coherence;
use iridescence::sampling::{
    Sample, base_lobe_pdf, base_lobe_sample, scratch_cone_pdf, scratch_cone_sample, scratch_lobe_pdf,
    scratch_lobe_sample, scratch_sinc_pdf, scratch_sinc_sample, von_mises_fisher_pdf,
};
use iridescence::special::erf;
use reference::generate::random::Random;
use sampling_statistics::{Direction, Lobe, above, integral, pearson};
use std::f64::consts::{PI, TAU};

const LIGHT: Coherence = Coherence {
    radius: 10.0,
    wavelength: 0.55,
};
const WIDE_LIGHT: Coherence = Coherence {
    radius: 0.8,
    wavelength: 0.55,
};

type Pdf = Box<dyn Fn(Direction) -> f64>;
type Draw = Box<dyn Fn(&mut Random) -> Option<Sample>>;

/// A strategy at an incident direction.
struct Case {
    name: String,
    incident: Direction,
    pdf: Pdf,
    draw: Draw,
}

fn uniform(random: &mut Random) -> f64 {
    random.uniform(0.0, 1.0)
}

fn base(light: Coherence, incident: Direction) -> Case {
    Case {
        name: format!("base {light:?} {incident:?}"),
        incident,
        pdf: Box::new(move |o| base_lobe_pdf(light, incident, o)),
        draw: Box::new(move |r| base_lobe_sample(light, incident, [uniform(r), uniform(r)])),
    }
}

fn lorentz(light: Coherence, width: f64, incident: Direction) -> Case {
    Case {
        name: format!("lobe {light:?} {width} {incident:?}"),
        incident,
        pdf: Box::new(move |o| scratch_lobe_pdf(light, width, incident, o)),
        draw: Box::new(move |r| scratch_lobe_sample(light, width, incident, [uniform(r), uniform(r)])),
    }
}

fn exact(light: Coherence, width: f64, incident: Direction) -> Case {
    Case {
        name: format!("sinc {light:?} {width} {incident:?}"),
        incident,
        pdf: Box::new(move |o| scratch_sinc_pdf(light, width, incident, o)),
        draw: Box::new(move |r| scratch_sinc_sample(light, width, incident, [uniform(r), uniform(r)])),
    }
}

fn cone(concentration: f64, incident: Direction) -> Case {
    Case {
        name: format!("cone {concentration} {incident:?}"),
        incident,
        pdf: Box::new(move |o| scratch_cone_pdf(concentration, incident, o)),
        draw: Box::new(move |r| scratch_cone_sample(concentration, incident, [uniform(r), uniform(r), uniform(r)])),
    }
}

fn cases() -> Vec<Case> {
    let incidents = [
        above(0.0, 0.0),
        above(0.5, -0.3),
        above(85f64.to_radians().sin(), 0.0),
        above(-0.1, 0.95),
    ];
    let mut all = Vec::new();
    for incident in incidents {
        for light in [LIGHT, WIDE_LIGHT] {
            all.push(base(light, incident));
            for width in [0.0, 0.2, 1.1, 11.0] {
                all.push(lorentz(light, width, incident));
            }
            for width in [0.0, 0.2, 1.1, 5.5] {
                all.push(exact(light, width, incident));
            }
        }
        for concentration in [0.0, 1e-9, 0.3, 20.0, 3e4] {
            all.push(cone(concentration, incident));
        }
    }
    all
}

#[test]
fn draws_fall_as_the_densities_tell() {
    let cases = cases();
    let enough = 0.01 / cases.len() as f64;
    for (i, case) in cases.iter().enumerate() {
        let sample = |r: &mut Random| (case.draw)(r).map(|s| s.direction);
        let lobe = Lobe {
            incident: case.incident,
            pdf: &case.pdf,
            sample: &sample,
        };
        let p = pearson(&lobe, 100 + i as u64, 100_000);
        assert!(p > enough, "{}: p = {p:e}", case.name);
    }
}

#[test]
fn pearson_finds_a_density_that_is_wrong_by_a_twentieth() {
    let incident = above(0.5, -0.3);
    for (case, ripples) in [
        (base(LIGHT, incident), 200.0),
        (lorentz(LIGHT, 1.1, incident), 200.0),
        (cone(20.0, incident), 8.0),
    ] {
        let sample = |r: &mut Random| (case.draw)(r).map(|s| s.direction);
        let wrong = |o: Direction| (case.pdf)(o) * (1.0 + 0.05 * (ripples * o[0]).sin());
        let lobe = Lobe {
            incident: case.incident,
            pdf: &wrong,
            sample: &sample,
        };
        assert!(pearson(&lobe, 7, 200_000) < 1e-6, "{}", case.name);
    }
}

#[test]
fn a_sample_has_the_density_it_says_and_points_upwards() {
    let mut random = Random::new(3);
    for case in cases() {
        let mut drawn = 0;
        for _ in 0..3000 {
            let Some(Sample { direction, pdf }) = (case.draw)(&mut random) else {
                continue;
            };
            drawn += 1;
            assert_eq!(pdf, (case.pdf)(direction), "{} {direction:?}", case.name);
            assert!(pdf > 0.0 && pdf.is_finite(), "{} {direction:?}: {pdf}", case.name);
            let [x, y, z] = direction;
            assert!(
                z >= 0.0 && (x * x + y * y + z * z - 1.0).abs() < 1e-14,
                "{} {direction:?}",
                case.name
            );
        }
        assert!(drawn > 500, "{}: {drawn}", case.name);
    }
}

/// The share of a Gaussian along the tangent that propagates.
fn propagating(light: Coherence, incident: Direction) -> f64 {
    let q = TAU * light.radius / light.wavelength;
    0.5 * (erf(q * (1.0 - incident[0])) + erf(q * (1.0 + incident[0])))
}

#[test]
fn the_densities_integrate_to_the_share_that_propagates() {
    for case in cases() {
        let total = integral(case.incident, &case.pdf);
        let cut = case.name.starts_with("lobe") || case.name.starts_with("sinc");
        let light = if case.name.contains("10.0") { LIGHT } else { WIDE_LIGHT };
        let truth = if case.name.starts_with("cone") {
            1.0
        } else {
            propagating(light, case.incident)
        };
        if cut || case.name.starts_with("cone") {
            assert!((total - truth).abs() < 1e-9, "{}: {total} of {truth}", case.name);
        } else {
            assert!(total <= truth + 1e-9, "{}: {total} of {truth}", case.name);
        }
    }
    // The base lobe of a narrow disc's centre is whole.
    let whole = integral(above(0.2, 0.1), |o| base_lobe_pdf(LIGHT, above(0.2, 0.1), o));
    assert!((whole - 1.0).abs() < 1e-12, "{whole}");
}

#[test]
fn evanescent_draws_are_counted_as_zero_and_never_drawn_again() {
    // WVJH17's window at a grazing angle: more than a quarter of the draws do not propagate.
    let incident = above(85f64.to_radians().sin(), 0.0);
    let mut random = Random::new(5);
    let draws = 1_000_000;
    let lost = (0..draws)
        .filter(|_| base_lobe_sample(LIGHT, incident, [uniform(&mut random), uniform(&mut random)]).is_none())
        .count() as f64
        / f64::from(draws);
    let mass = 1.0 - integral(incident, |o| base_lobe_pdf(LIGHT, incident, o));
    println!("evanescent share {lost}, {mass} by quadrature");
    assert!(
        (lost - mass).abs() < 4.0 * (mass / f64::from(draws)).sqrt(),
        "{lost} of {mass}"
    );
    assert!((0.26..0.28).contains(&mass), "{mass}");
}

#[test]
fn the_cone_integrates_to_one_at_every_concentration() {
    for exponent in -12..=6 {
        let concentration = 10f64.powi(exponent);
        for incident in [
            above(0.0, 0.0),
            above(0.6, 0.5),
            above(-0.99, 0.1),
            above(0.999999, 0.0),
        ] {
            // The same density at every azimuth, so that one integral is left.
            let density = |outgoing: Direction| scratch_cone_pdf(concentration, incident, outgoing);
            let total = azimuths_alike(incident, density);
            assert!(
                (total - 1.0).abs() < 1e-12,
                "{concentration:e} {incident:?}: {total:.17}"
            );
        }
        // Of 1 - cosine, which is graded towards 0; what its rounding changes is taken out again.
        let total = TAU
            * sampling_statistics::line([0.0, 2.0], 0.0, |versine| {
                let cosine = 1.0 - versine;
                von_mises_fisher_pdf(concentration, cosine) * (concentration * ((1.0 - cosine) - versine)).exp()
            });
        assert!((total - 1.0).abs() < 1e-12, "{concentration:e}: {total:.17}");
    }
}

/// pi times the integral over the component along the tangent, after a look at three azimuths.
fn azimuths_alike(incident: Direction, density: impl Fn(Direction) -> f64) -> f64 {
    PI * sampling_statistics::line([0.0, PI], (-incident[0]).acos(), |theta| {
        let (s, c) = theta.sin_cos();
        let value = density([c, 0.0, s]);
        for psi in [0.1f64, 2.9] {
            let turned = density([c, s * psi.cos(), s * psi.sin()]);
            assert!((turned - value).abs() <= 1e-9 * value + 1e-300, "{theta} {psi}");
        }
        value * s
    })
}

#[test]
fn the_cone_is_finite_where_its_printed_factors_overflow() {
    for concentration in [0.0, 1e-300, 1e-12, 1.0, 710.0, 1e6, 1e12, 1e300] {
        for incident in [above(0.0, 0.0), above(0.6, 0.5), [1.0, 0.0, 0.0]] {
            for outgoing in [above(0.0, 0.0), above(-0.6, 0.2), [-1.0, 0.0, 0.0], [0.0, 1.0, 0.0]] {
                let pdf = scratch_cone_pdf(concentration, incident, outgoing);
                assert!(
                    pdf >= 0.0 && pdf.is_finite(),
                    "{concentration:e} {incident:?} {outgoing:?}: {pdf}"
                );
            }
        }
    }
    assert_eq!(scratch_cone_pdf(0.0, above(0.3, 0.1), above(0.5, 0.5)), 0.5 / PI);
    // Printed as it stands, kappa/(4 pi sinh kappa) exp(-kappa c c) I0(kappa s s), at concentration 2.
    let (incident, outgoing) = (above(0.3, 0.1), above(0.5, 0.5));
    let across = |d: Direction| (1.0 - d[0] * d[0]).sqrt();
    let z = 2.0 * across(incident) * across(outgoing);
    let printed =
        2.0 * 2.0 / (4.0 * PI * 2f64.sinh()) * (-2.0 * 0.15f64).exp() * iridescence::special::log_bessel_i0(z).exp();
    assert!((scratch_cone_pdf(2.0, incident, outgoing) / printed - 1.0).abs() < 1e-14);
}

#[test]
fn directions_below_the_surface_have_no_density_and_give_no_sample() {
    let (up, down) = (above(0.3, 0.1), [0.3, 0.1, -above(0.3, 0.1)[2]]);
    let pdfs: [fn(Direction, Direction) -> f64; 4] = [
        |i, o| base_lobe_pdf(LIGHT, i, o),
        |i, o| scratch_lobe_pdf(LIGHT, 1.1, i, o),
        |i, o| scratch_sinc_pdf(LIGHT, 1.1, i, o),
        |i, o| scratch_cone_pdf(100.0, i, o),
    ];
    for pdf in pdfs {
        assert_eq!((pdf(up, down), pdf(down, up), pdf(down, down)), (0.0, 0.0, 0.0));
        for i in 0..3 {
            let mut broken = up;
            broken[i] = f64::NAN;
            assert!(pdf(broken, up).is_nan() && pdf(up, broken).is_nan(), "{i}");
        }
    }
    assert!(base_lobe_sample(LIGHT, down, [0.1; 2]).is_none());
    assert!(scratch_lobe_sample(LIGHT, 1.1, down, [0.1; 2]).is_none());
    assert!(scratch_sinc_sample(LIGHT, 1.1, down, [0.1; 2]).is_none());
    assert!(scratch_cone_sample(100.0, down, [0.1; 3]).is_none());
}

#[test]
fn outside_the_domain_there_is_no_density_and_no_sample() {
    let up = above(0.3, 0.1);
    for [radius, wavelength] in [
        [f64::NAN, 0.5],
        [1.0, f64::NAN],
        [-1.0, 0.5],
        [1.0, -0.5],
        [f64::INFINITY, 0.5],
        [1.0, 0.0],
        [0.0, 0.0],
    ] {
        let light = Coherence { radius, wavelength };
        assert!(base_lobe_pdf(light, up, up).is_nan(), "{light:?}");
        assert!(base_lobe_sample(light, up, [0.2; 2]).is_none(), "{light:?}");
        assert!(scratch_lobe_pdf(light, 1.0, up, up).is_nan(), "{light:?}");
        assert!(scratch_lobe_sample(light, 1.0, up, [0.2; 2]).is_none(), "{light:?}");
        assert!(scratch_sinc_pdf(light, 1.0, up, up).is_nan(), "{light:?}");
        assert!(scratch_sinc_sample(light, 1.0, up, [0.2; 2]).is_none(), "{light:?}");
    }
    for width in [-1.0, f64::NAN, f64::INFINITY] {
        assert!(scratch_lobe_pdf(LIGHT, width, up, up).is_nan(), "{width}");
        assert!(scratch_lobe_sample(LIGHT, width, up, [0.2; 2]).is_none(), "{width}");
        assert!(scratch_sinc_pdf(LIGHT, width, up, up).is_nan(), "{width}");
        assert!(scratch_sinc_sample(LIGHT, width, up, [0.2; 2]).is_none(), "{width}");
    }
    for concentration in [-1.0, f64::NAN, f64::INFINITY] {
        assert!(scratch_cone_pdf(concentration, up, up).is_nan(), "{concentration}");
        assert!(
            scratch_cone_sample(concentration, up, [0.2; 3]).is_none(),
            "{concentration}"
        );
        assert!(von_mises_fisher_pdf(concentration, 0.5).is_nan(), "{concentration}");
    }
    for random in [-0.1, 1.0, f64::NAN] {
        assert!(base_lobe_sample(LIGHT, up, [0.2, random]).is_none(), "{random}");
        assert!(scratch_lobe_sample(LIGHT, 1.0, up, [random, 0.2]).is_none(), "{random}");
        assert!(scratch_sinc_sample(LIGHT, 1.0, up, [0.2, random]).is_none(), "{random}");
        assert!(scratch_cone_sample(5.0, up, [0.2, random, 0.2]).is_none(), "{random}");
    }
    // An infinitely small window: an infinitely wide lobe, of which nothing propagates.
    let point = Coherence {
        radius: 0.0,
        wavelength: 0.55,
    };
    assert_eq!(base_lobe_pdf(point, up, up), 0.0);
    assert!(base_lobe_sample(point, up, [0.2; 2]).is_none());
    assert_eq!(scratch_lobe_pdf(point, 1.0, up, up), 0.0);
    assert!(scratch_lobe_sample(point, 1.0, up, [0.2; 2]).is_none());
}

#[test]
fn a_scratch_without_width_is_the_limit_of_narrow_ones() {
    let incident = above(0.2, 0.4);
    let outgoing = above(-0.203, 0.6);
    let limit = scratch_lobe_pdf(LIGHT, 0.0, incident, outgoing);
    for width in [1e-320, 1e-200, 1e-101, 1e-99, 1e-20, 1e-9] {
        for pdf in [scratch_lobe_pdf, scratch_sinc_pdf] {
            let narrow = pdf(LIGHT, width, incident, outgoing);
            assert!((narrow / limit - 1.0).abs() < 1e-13, "{width:e}: {narrow} {limit}");
        }
        for sample in [scratch_lobe_sample, scratch_sinc_sample] {
            let [narrow, none] = [width, 0.0].map(|w| sample(LIGHT, w, incident, [0.3, 0.8]).expect("a sample"));
            let apart = (narrow.direction[1] - none.direction[1]).abs();
            assert!(apart < 1e-14, "{width:e}: {apart:e}");
        }
    }
    // Mirrored scratches have mirrored samples.
    let mirrored = [incident[0], -incident[1], incident[2]];
    for width in [0.0, 1.1] {
        for sample in [scratch_lobe_sample, scratch_sinc_sample] {
            let one = sample(LIGHT, width, incident, [0.3, 0.75]).expect("a sample").direction;
            let two = sample(LIGHT, width, mirrored, [0.3, 0.25]).expect("a sample").direction;
            assert!(
                (one[1] + two[1]).abs() < 1e-14 && one[0] == two[0],
                "{width}: {one:?} {two:?}"
            );
        }
    }
}
