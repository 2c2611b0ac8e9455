//! The mean over a footprint: which tier keeps a tolerance, against the oracle.

use super::{FEW, INF, MANY, Tally};
use iridescence::diffraction::{
    Footprint, FootprintMethod, footprint_mean, footprint_mean_coarse, footprint_mean_medium, footprint_method,
};
use reference::generate::random::Random;
use reference::metrics::Reference;
use reference::oracle;

/// Scenes whose largest error of every tier is sought.
const SOUGHT: u64 = 2_500;

type Mean = fn(Footprint, f64, f64) -> f64;

/// The tiers, cheapest first.
const TIERS: [(FootprintMethod, Mean); 3] = [
    (FootprintMethod::Coarse, footprint_mean_coarse),
    (FootprintMethod::Medium, footprint_mean_medium),
    (FootprintMethod::Accurate, footprint_mean),
];

/// 1/M(H, 0) - 1, the error of the value at the centre as a share of the mean.
fn centre_error(most: Reference) -> f64 {
    ((1.0 - most.hi) - most.lo) / most.hi
}

fn truth(Footprint { axes, cos_phi }: Footprint, offset: f64, radius: f64) -> Reference {
    oracle::footprint_mean(&[axes[0], axes[1], cos_phi, offset, radius])
}

/// |value - truth| over M(H, 0).
fn share(value: f64, truth: Reference, most: Reference) -> f64 {
    if truth.exponent == 0 {
        ((value - truth.hi) - truth.lo).abs() / most.hi
    } else {
        (value - truth.value()).abs() / most.hi
    }
}

#[test]
fn the_value_at_the_centre_errs_by_less_than_a_quarter_of_the_square_of_the_half_width() {
    let mut previous = 0.0;
    for n in -600..=600 {
        let h = 10f64.powf(f64::from(n) / 100.0);
        // The error at offset 0, the largest.
        let error = centre_error(oracle::footprint_mean_reduced(&[h, 0.0]));
        assert!(error <= 0.25 * h * h * (1.0 + 4.0 * f64::EPSILON), "{h}: {error}");
        assert!(error > previous, "{h}");
        previous = error;
    }
}

#[test]
fn the_footprint_method_steps_at_the_bounds_of_the_tiers() {
    let pixel = Footprint {
        axes: [40.0, 8.0],
        cos_phi: 0.0,
    };
    let at = |radius, tolerance| footprint_method(pixel, radius, tolerance);
    // Across the scratch lies the first axis: H = 40/radius.
    for (radius, steps) in [
        (
            16.0,
            [
                (5.1e-4, FootprintMethod::Coarse),
                (3.1e-7, FootprintMethod::Medium),
                (3e-13, FootprintMethod::Accurate),
            ],
        ),
        (
            0.1,
            [
                (1.56e-5, FootprintMethod::Coarse),
                (3.05e-9, FootprintMethod::Medium),
                (2.8e-14, FootprintMethod::Accurate),
            ],
        ),
    ] {
        let mut next = Some(FootprintMethod::Coarse);
        for (bound, method) in steps {
            assert_eq!(next, Some(method));
            assert_eq!(at(radius, bound * 1.01), next, "{radius} {bound}");
            next = TIERS.map(|(tier, _)| tier).into_iter().find(|tier| *tier > method);
            assert_eq!(at(radius, bound * 0.97), next, "{radius} {bound}");
        }
        assert_eq!(at(radius, 0.0), None);
    }
    assert_eq!(at(1000.0, 4.001e-4), Some(FootprintMethod::Point));
    assert_eq!(at(1000.0, 3.999e-4), Some(FootprintMethod::Medium));
    assert_eq!(at(1e-300, 1e-2), Some(FootprintMethod::Coarse));
    assert_eq!(at(0.0, 1e-2), None);
    assert_eq!(at(INF, 1e-30), Some(FootprintMethod::Point));
    let point = Footprint {
        axes: [0.0, 0.0],
        ..pixel
    };
    for radius in [1e-300, 1.0, INF] {
        assert_eq!(footprint_method(point, radius, 0.0), Some(FootprintMethod::Point));
        assert_eq!(footprint_method(point, radius, -1.0), None);
    }
    assert!(FootprintMethod::Point < FootprintMethod::Coarse && FootprintMethod::Medium < FootprintMethod::Accurate);
}

/// The largest error of every tier over offsets inside, around the edge, and outside; the accurate one against the oracle,
/// the others against the accurate one. `h` is the half width in um.
fn largest_errors(footprint: Footprint, h: f64, radius: f64, most: Reference) -> [f64; 3] {
    let mut largest = [0.0f64; 3];
    for step in 0..192 {
        let step = f64::from(step);
        for offset in [h * step / 192.0, (h - radius * (step / 16.0 - 5.0)).abs()] {
            let accurate = footprint_mean(footprint, offset, radius);
            for (largest, (_, mean)) in largest.iter_mut().zip(&TIERS[..2]) {
                *largest = largest.max((mean(footprint, offset, radius) - accurate).abs() / most.hi);
            }
            if step % 12.0 == 0.0 {
                largest[2] = largest[2].max(share(accurate, truth(footprint, offset, radius), most));
            }
        }
    }
    largest
}

fn footprints(scenes: u64) {
    let mut random = Random::new(42);
    let mut tallies: [Tally; 4] = Default::default();
    let mut chosen = [0_u64; 5];
    for scene in 0..scenes {
        let radius = random.log_uniform(3.0, 100.0);
        let along = radius * random.log_uniform(1e-3, 1e3);
        let footprint = Footprint {
            axes: [along, along * random.log_uniform(0.02, 1.0)],
            cos_phi: random.uniform(-1.0, 1.0),
        };
        let angle = footprint.cos_phi.acos();
        let h = (footprint.axes[0] * angle.sin()).hypot(footprint.axes[1] * angle.cos());
        let tolerance = random.log_uniform(1e-13, 0.1);
        // Offsets inside, around the edge, and outside.
        let offset = match random.integer(0, 2) {
            0 => random.uniform(0.0, 1.0) * h,
            1 => (h + radius * random.uniform(-3.0, 3.0)).abs(),
            _ => radius * random.uniform(0.0, 4.0),
        };
        let method = footprint_method(footprint, radius, tolerance);
        let most = truth(footprint, 0.0, radius);
        let words = || format!("{footprint:?} {radius} {offset} {tolerance}: {method:?}");
        let value = match method {
            None => None,
            Some(FootprintMethod::Point) => Some((-(offset / radius).powi(2)).exp()),
            Some(FootprintMethod::Coarse) => Some(footprint_mean_coarse(footprint, offset, radius)),
            Some(FootprintMethod::Medium) => Some(footprint_mean_medium(footprint, offset, radius)),
            Some(FootprintMethod::Accurate) => Some(footprint_mean(footprint, offset, radius)),
        };
        chosen[method.map_or(4, |m| m as usize)] += 1;
        if let Some(value) = value {
            let error = share(value, truth(footprint, offset, radius), most);
            assert!(error <= tolerance + 1e-15, "{}: {error}", words());
        }
        // The value at the centre is enough at every offset when it is at offset 0.
        let point = centre_error(most) <= tolerance + 1e-15;
        tallies[0].count(method == Some(FootprintMethod::Point), point, words);
        // A tier is, when it or a cheaper way is.
        if scene % (scenes / SOUGHT) == 0 {
            let errors = largest_errors(footprint, h, radius, most);
            let mut holds = point;
            for (index, error) in errors.into_iter().enumerate() {
                holds |= error <= tolerance + 1e-15;
                tallies[index + 1].count(method.is_some_and(|m| m <= TIERS[index].0), holds, words);
            }
        }
    }
    println!("footprint_method: point, coarse, medium, accurate, none: {chosen:?}");
    assert!(chosen.iter().all(|n| *n > scenes / 200), "{chosen:?}");
    let [point, coarse, medium, accurate] = tallies;
    point.hold("footprint_method: point");
    coarse.hold("footprint_method: coarse");
    medium.hold("footprint_method: medium");
    // At tolerances from 1e-13 it is enough in nearly every scene.
    accurate.refuses_seldom("footprint_method: accurate");
}

#[test]
fn the_footprint_method_keeps_its_tolerance() {
    footprints(FEW);
}

#[test]
#[ignore = "1e6 scenes: in release only"]
fn the_footprint_method_keeps_its_tolerance_in_a_million_scenes() {
    footprints(MANY);
}

#[test]
fn on_vast_footprints_the_tiers_keep_the_tolerance_that_the_rounding_of_their_edge_leaves() {
    let mut random = Random::new(43);
    for _ in 0..2_000 {
        let radius = random.log_uniform(3.0, 100.0);
        let along = radius * random.log_uniform(1e3, 1e10);
        let footprint = Footprint {
            axes: [along, along * random.log_uniform(0.1, 1.0)],
            cos_phi: random.uniform(-1.0, 1.0),
        };
        let angle = footprint.cos_phi.acos();
        let h = (footprint.axes[0] * angle.sin()).hypot(footprint.axes[1] * angle.cos());
        let offset = h - radius * random.uniform(-3.0, 6.0);
        let (most, due) = (truth(footprint, 0.0, radius), truth(footprint, offset, radius));
        for (tier, mean) in TIERS {
            let error = share(mean(footprint, offset, radius), due, most);
            // The smallest tolerance at which the rule chooses this tier or a cheaper one.
            let mut least = 1.0;
            while footprint_method(footprint, radius, 0.9 * least).is_some_and(|method| method <= tier) {
                least *= 0.9;
            }
            assert!(
                error <= least,
                "{tier:?} {footprint:?} {radius} {offset}: {error:e} {least:e}"
            );
        }
    }
}
