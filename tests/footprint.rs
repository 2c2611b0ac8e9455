//! The mean over a footprint: errors of every tier against quadrature, limits and symmetries.

use iridescence::diffraction::*;
use proptest::prelude::*;
use reference::generate::random::Random;
use reference::oracle;
use std::f64::consts::PI;

type Reduced = fn(f64, f64) -> f64;
const TIERS: [(&str, Reduced, f64); 3] = [
    ("accurate", footprint_mean_reduced, 1e-12),
    ("medium", footprint_mean_reduced_medium, 1e-6),
    ("coarse", footprint_mean_reduced_coarse, 1e-3),
];

/// M by the trapezoidal rule in the angle, over the part that counts, from the distances to both edges.
fn quadrature(half_width: f64, edge: f64) -> f64 {
    const NODES: u32 = 160;
    let far = 2.0 * half_width - edge;
    let (start, end) = ((-edge).max(-7.5), far.min(7.5));
    if start >= end {
        return 0.0;
    }
    let (near, rest, span) = ((edge - 7.5).max(0.0), (far - 7.5).max(0.0), end - start);
    let mut sum = 0.0;
    for j in 1..NODES {
        let angle = PI * f64::from(j) / f64::from(NODES);
        let (a, b) = (span * (0.5 * angle).sin().powi(2), span * (0.5 * angle).cos().powi(2));
        let root = ((near + a) / half_width * ((rest + b) / half_width)).sqrt();
        sum += angle.sin() * root * (-(start + a).powi(2)).exp();
    }
    sum * span / (half_width * f64::from(NODES))
}

fn share(value: f64, half_width: f64, edge: f64) -> f64 {
    (value - quadrature(half_width, edge)).abs() / quadrature(half_width, half_width)
}

/// H and C, denser where the forms meet.
fn random_place(random: &mut Random) -> (f64, f64) {
    let h = if random.chance(0.5) {
        random.log_uniform(1e-3, 1e4)
    } else {
        random.uniform(1e-3, 14.0)
    };
    let c = match random.integer(0, 2) {
        0 => random.uniform(0.0, h + 8.0),
        1 => (h + random.uniform(-7.0, 8.0)).abs(),
        _ => (random.uniform(4.5, 11.0) - h).abs(),
    };
    (h, c)
}

fn sweep(seed: u64, points: usize) {
    let mut random = Random::new(seed);
    for _ in 0..points {
        let (h, c) = random_place(&mut random);
        for (name, mean, bound) in TIERS {
            let error = share(mean(h, c), h, h - c);
            assert!(error <= bound, "{name} at {h:e} {c:e}: {error:e}");
        }
    }
}

#[test]
fn every_tier_holds_its_error_over_all_half_widths_and_offsets() {
    sweep(1, 60_000);
}

#[test]
#[ignore = "a sweep for release builds"]
fn every_tier_holds_its_error_at_two_million_places() {
    sweep(2, 2_000_000);
}

#[test]
fn the_quadrature_knows_the_closed_value_at_the_centre() {
    // exp(-x) (I0(x) + I1(x)) with x = H^2/2, exact.
    for h in [0.125, 1.0, 3.0, 10.0, 300.0] {
        let x = 0.5 * h * h;
        let closed = oracle::bessel_i0_scaled(x).value() * (1.0 + oracle::bessel_i1_i0_ratio(x).value());
        assert!((quadrature(h, h) / closed - 1.0).abs() < 1e-13, "{h}");
        assert!((footprint_mean_reduced(h, 0.0) / closed - 1.0).abs() < 1e-12, "{h}");
    }
}

#[test]
fn a_footprint_of_no_size_gives_the_point() {
    for c in [0.0f64, 1e-300, 0.3, 1.0, 3.0, 8.0, 20.0] {
        let point = (-c * c).exp();
        for h in [0.0, -0.0, 5e-324, 1e-200, 1e-9] {
            let value = footprint_mean_reduced(h, c);
            assert!((value - point).abs() <= 1e-13 * point, "{h:e} {c}: {value:e} {point:e}");
            assert!((footprint_mean_reduced_medium(h, c) - point).abs() <= 1e-6, "{h:e} {c}");
            assert!((footprint_mean_reduced_coarse(h, c) - point).abs() <= 1e-3, "{h:e} {c}");
        }
    }
    assert_eq!(footprint_mean_reduced(0.0, 0.0), 1.0);
}

#[test]
fn a_vast_footprint_gives_the_chord() {
    for (name, mean, bound) in TIERS {
        for h in [1e13, 1e60, 1e99, 1e101, 1e150, 1e300] {
            for t in [0.0, 0.3, 0.9, 0.999] {
                let limit = 2.0 / PI.sqrt() * f64::sqrt((1.0 - t) * (1.0 + t)) / h;
                let value = mean(h, t * h);
                assert!(
                    (value / limit - 1.0).abs() <= bound,
                    "{name} {h:e} {t}: {value:e} {limit:e}"
                );
            }
            assert_eq!(mean(h, 1.5 * h), 0.0, "{name} {h:e}");
        }
        assert_eq!(mean(f64::INFINITY, 3.0), 0.0, "{name}");
        assert_eq!(mean(f64::INFINITY, f64::INFINITY), 0.0, "{name}");
        for h in [0.0, 0.5, 2.0, 5.0, 1e5, 1e200] {
            assert_eq!(mean(h, f64::INFINITY), 0.0, "{name} {h:e}");
        }
    }
}

#[test]
fn outside_the_domain_and_for_nan_the_mean_is_nan() {
    for (name, mean, _) in TIERS {
        for h in [f64::NAN, -1e-300, -1.0, -30.0, f64::NEG_INFINITY] {
            for c in [0.0, 1.0, 40.0, f64::INFINITY] {
                assert!(mean(h, c).is_nan(), "{name} {h:e} {c}");
            }
        }
        for h in [0.0, 0.5, 1.0, 2.0, 4.0, 8.0, 1e5, 1e200, f64::INFINITY] {
            assert!(mean(h, f64::NAN).is_nan(), "{name} {h:e}");
        }
    }
    let good = Footprint {
        axes: [3.0, 5.0],
        cos_phi: 0.5,
    };
    let bad = [
        (
            Footprint {
                cos_phi: 1.0000000001,
                ..good
            },
            1.0,
        ),
        (Footprint { cos_phi: -1.5, ..good }, 1.0),
        (
            Footprint {
                cos_phi: f64::NAN,
                ..good
            },
            1.0,
        ),
        (
            Footprint {
                axes: [-1.0, 5.0],
                ..good
            },
            1.0,
        ),
        (
            Footprint {
                axes: [3.0, -1e-9],
                ..good
            },
            1.0,
        ),
        (good, 0.0),
        (good, -1.0),
        (good, f64::NAN),
    ];
    for (footprint, radius) in bad {
        for mean in [
            footprint_mean,
            footprint_mean_medium,
            footprint_mean_coarse,
            footprint_mean_vwh18,
        ] {
            assert!(mean(footprint, 1.0, radius).is_nan(), "{footprint:?} {radius}");
            assert!(!mean(good, 1.0, 1.0).is_nan());
        }
    }
}

#[test]
fn the_edge_of_a_wide_footprint_keeps_its_place() {
    // Half width and offset in um differ by an exact number of radii: the quotients would have lost it.
    let radius = 0.1;
    for (h, gap) in [(1e4, 0.03125), (123456.0, -0.0625), (1e6, 0.25), (1e6, -0.125)] {
        let footprint = Footprint {
            axes: [h, 1.0],
            cos_phi: 0.0,
        };
        let value = footprint_mean(footprint, h - gap, radius);
        let edge = gap / radius;
        let error = share(value, h / radius, edge);
        assert!(error <= 1e-13, "{h} {gap}: {error:e}");
    }
}

#[test]
fn the_half_width_holds_for_thin_ellipses() {
    // cos phi = 1 - 2^-40: sin^2 phi = 2^-39 - 2^-80.
    let cos_phi = 1.0 - 2f64.powi(-40);
    let half_width = footprint_half_width(Footprint {
        axes: [1e6, 0.0],
        cos_phi,
    });
    let sine = (2f64.powi(-39) - 2f64.powi(-80)).sqrt();
    assert!((half_width / (1e6 * sine) - 1.0).abs() < 1e-15);
    assert_eq!(
        footprint_half_width(Footprint {
            axes: [7.0, 3.0],
            cos_phi: 1.0
        }),
        3.0
    );
    assert_eq!(
        footprint_half_width(Footprint {
            axes: [7.0, 3.0],
            cos_phi: -1.0
        }),
        3.0
    );
    assert_eq!(
        footprint_half_width(Footprint {
            axes: [7.0, 3.0],
            cos_phi: 0.0
        }),
        7.0
    );
}

#[test]
fn all_lines_over_a_footprint_sum_to_the_windows_integral() {
    // The integral of M over C is sqrt(pi), whatever H.
    for (name, mean, bound) in TIERS {
        for h in [0.0, 0.4, 1.7, 3.3, 6.0, 9.0, 40.0] {
            let (end, n) = (h + 9.0, 40_000);
            let step = 2.0 * end / f64::from(n);
            let sum: f64 = (0..n).map(|j| mean(h, -end + (f64::from(j) + 0.5) * step)).sum();
            let error = (sum * step / PI.sqrt() - 1.0).abs();
            assert!(error <= 2.0 * bound, "{name} {h}: {error:e}");
        }
    }
}

#[test]
fn the_blend_of_the_paper_is_right_at_both_ends_and_three_times_too_large_between() {
    let point = footprint_mean_vwh18(
        Footprint {
            axes: [1e-4, 1e-4],
            cos_phi: 0.3,
        },
        0.7,
        1.0,
    );
    assert!((point - (-0.49f64).exp()).abs() < 1e-8, "{point}");
    assert_eq!(
        footprint_mean_vwh18(
            Footprint {
                axes: [0.0, 0.0],
                cos_phi: 0.3
            },
            0.0,
            1.0
        ),
        1.0
    );
    let wide = Footprint {
        axes: [400.0, 400.0],
        cos_phi: 0.3,
    };
    let error = footprint_mean_vwh18(wide, 30.0, 1.0) / footprint_mean(wide, 30.0, 1.0) - 1.0;
    assert!(error.abs() < 1e-4, "{error}");
    // Fifty times as long as wide, along the scratch, of twice the coherence area.
    let long = Footprint {
        axes: [10.0, 0.2],
        cos_phi: 1.0,
    };
    let peak = footprint_mean(long, 0.0, 1.0);
    let error = (0..100)
        .map(|j| f64::from(j) * 0.02)
        .map(|c| (footprint_mean_vwh18(long, c, 1.0) - footprint_mean(long, c, 1.0)) / peak)
        .fold(0.0, f64::max);
    assert!(error > 4.0 && error < 5.5, "{error}");
}

proptest! {
    #[test]
    fn the_mean_is_even_in_the_offset_between_0_and_1_and_falls_with_it(
        h in prop_oneof![0.0..14.0f64, (-3.0..4.0f64).prop_map(|e| 10f64.powf(e))],
        c in 0.0..30.0f64,
        step in 0.05..1.0f64,
    ) {
        for (name, mean, bound) in TIERS {
            let value = mean(h, c);
            prop_assert!((0.0..=1.0 + bound).contains(&value), "{} {} {}", name, h, c);
            prop_assert_eq!(value.to_bits(), mean(h, -c).to_bits());
            let next = mean(h, c + step);
            prop_assert!(next <= value + 2.0 * bound * mean(h, 0.0), "{} {} {}", name, h, c);
        }
    }

    #[test]
    fn the_footprint_forms_are_the_reduced_ones(
        a1 in (-3.0..4.0f64).prop_map(|e| 10f64.powf(e)),
        a2 in (-3.0..4.0f64).prop_map(|e| 10f64.powf(e)),
        cos_phi in -1.0..1.0f64,
        part in -1.5..1.5f64,
        radius in 0.5..60.0f64,
    ) {
        let footprint = Footprint { axes: [a1, a2], cos_phi };
        let h = footprint_half_width(footprint);
        prop_assert!((h / (a1 * a1 * (1.0 - cos_phi * cos_phi) + a2 * a2 * cos_phi * cos_phi).sqrt() - 1.0).abs() < 1e-10);
        let forms = [footprint_mean, footprint_mean_medium, footprint_mean_coarse];
        for ((name, mean, bound), form) in TIERS.into_iter().zip(forms) {
            let offset = part * (h + radius);
            let value = form(footprint, offset, radius);
            prop_assert_eq!(value.to_bits(), form(footprint, -offset, radius).to_bits());
            let difference = (value - mean(h / radius, offset / radius)).abs() / mean(h / radius, 0.0);
            prop_assert!(difference <= 2.0 * bound, "{} {}", name, difference);
        }
    }
}
