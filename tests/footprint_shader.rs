//! The f32 mean over a footprint against the f64 one.
#![cfg(feature = "shader")]

use iridescence::diffraction::{self, Footprint};
use iridescence::shader;
use reference::generate::random::Random;

/// M(H, C) from half width and edge, which an f64 difference keeps.
fn truth(half_width: f32, edge: f32) -> (f64, f64) {
    let (h, d) = (f64::from(half_width), f64::from(edge));
    (
        diffraction::footprint_mean_reduced(h, h - d),
        diffraction::footprint_mean_reduced(h, 0.0),
    )
}

fn hold(random: &mut Random, points: usize) -> [f64; 2] {
    let mut worst = [0.0f64; 2];
    for _ in 0..points {
        let h = if random.chance(0.5) {
            random.log_uniform(1e-4, 1e4)
        } else {
            random.uniform(0.0, 12.0)
        } as f32;
        let edge = if random.chance(0.5) {
            random.uniform(-6.0, f64::from(h).min(6.0)) as f32
        } else {
            h - random.uniform(0.0, f64::from(h) + 5.0) as f32
        };
        let edge = edge.min(h);
        let (mean, peak) = truth(h, edge);
        let values = [
            shader::footprint_mean_reduced(h, edge),
            shader::footprint_mean_reduced_coarse(h, edge),
        ];
        for ((value, bound), worst) in values.into_iter().zip([1e-6, 1e-3]).zip(&mut worst) {
            let error = (f64::from(value) - mean).abs() / peak;
            assert!(
                error <= bound && value >= 0.0,
                "{h:e} {edge:e}: {value:e} {mean:e} {error:e}"
            );
            *worst = worst.max(error);
        }
    }
    worst
}

#[test]
fn both_tiers_hold_their_error_over_all_half_widths_and_edges() {
    let worst = hold(&mut Random::new(41), 400_000);
    assert!(
        worst[0] > 1e-9 && worst[1] > 1e-5,
        "{worst:?}: the sweep meets no hard place"
    );
}

#[test]
#[ignore = "a sweep for release builds"]
fn both_tiers_hold_their_error_at_ten_million_places() {
    hold(&mut Random::new(42), 10_000_000);
}

#[test]
fn limits_of_the_f32_mean() {
    for mean in [shader::footprint_mean_reduced, shader::footprint_mean_reduced_coarse] {
        for c in [0.0f32, 0.5, 1.5, 2.5] {
            let point = (-c * c).exp();
            for h in [0.0f32, 1e-38, 1e-10, 1e-4] {
                assert!((mean(h, h - c) - point).abs() < 1e-3, "{h:e} {c}");
            }
        }
        for h in [0.0f32, 1.0, 5.0, 1e4, 1e10] {
            assert_eq!(mean(h, -8.0), 0.0, "{h:e}");
            assert!(mean(h, f32::NAN).is_nan() && mean(f32::NAN, h).is_nan(), "{h:e}");
        }
        let wide = mean(1e10, 1e10);
        assert!((wide / 1.1283792e-10 - 1.0).abs() < 1e-3, "{wide:e}");
    }
}

#[test]
fn the_ellipse_forms_agree_with_f64() {
    let mut random = Random::new(43);
    for _ in 0..100_000 {
        let axes = [
            random.log_uniform(0.1, 300.0) as f32,
            random.log_uniform(0.1, 300.0) as f32,
        ];
        let cos_phi = random.uniform(-1.0, 1.0) as f32;
        let radius = random.uniform(5.0, 60.0) as f32;
        let footprint = Footprint {
            axes: axes.map(f64::from),
            cos_phi: f64::from(cos_phi),
        };
        let h = diffraction::footprint_half_width(footprint);
        let ours = shader::footprint_half_width(axes[0], axes[1], cos_phi);
        assert!((f64::from(ours) / h - 1.0).abs() < 1e-5, "{footprint:?}");
        let offset = random.uniform(-h - 100.0, h + 100.0) as f32;
        let mean = |offset: f32| diffraction::footprint_mean(footprint, f64::from(offset), f64::from(radius));
        let value = shader::footprint_mean(axes[0], axes[1], cos_phi, offset, radius);
        let error = (f64::from(value) - mean(offset)).abs() / mean(0.0);
        assert!(error < 1e-5, "{footprint:?} {offset} {radius}: {error:e}");
        let value = shader::footprint_mean_coarse(axes[0], axes[1], cos_phi, offset, radius);
        let error = (f64::from(value) - mean(offset)).abs() / mean(0.0);
        assert!(error < 1e-3, "coarse {footprint:?} {offset} {radius}: {error:e}");
    }
}
