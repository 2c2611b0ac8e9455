//! The oracles of the responses, of the area density and of the sampling density against quadrature of the defining
//! integrals and against each other.

use reference::generate::{Generator, scratches, surfaces};
use reference::metrics::Reference;
use reference::oracle;
use reference::simpson::simpson;
use std::f64::consts::{PI, TAU};

type Complex = num_complex::Complex<f64>;

fn complex(parts: [Reference; 2]) -> Complex {
    Complex::new(parts[0].value(), parts[1].value())
}

/// Rows of a generator without those that a condition leaves out: 300 to 600.
fn rows(generator: Generator, keeps: impl Fn(&[f64]) -> bool) -> Vec<Vec<f64>> {
    let drawn = (generator.rows)(53, 15_000);
    let kept = drawn.chunks_exact(generator.columns).filter(|row| keeps(row));
    let kept: Vec<Vec<f64>> = kept.take(600).map(<[f64]>::to_vec).collect();
    assert!(kept.len() >= 300, "{}: {}", generator.name, kept.len());
    kept
}

#[test]
fn the_infinite_phase_and_the_base_response_are_those_of_a_scratch_with_infinite_ends() {
    let inf = f64::INFINITY;
    let line =
        |sigma, lambda, xi1, xi2, s_b| complex(oracle::spatial_phase(&[sigma, lambda, xi1, xi2, 0.0, s_b, -inf, inf]));
    for row in rows(surfaces::INFINITE_PHASE, |_| true) {
        let &[sigma, lambda, xi1, xi2, s_b] = &row[..] else {
            unreachable!()
        };
        let error = (complex(oracle::spatial_phase_infinite(&row)) - line(sigma, lambda, xi1, xi2, s_b)).norm();
        assert!(error <= 1e-15 * sigma, "{row:?}: {error:e}");
        let plane = line(sigma, lambda, xi1, 0.0, 0.0) * line(sigma, lambda, xi2, 0.0, 0.0);
        let base = oracle::base_response(&[sigma, lambda, xi1, xi2]).value();
        assert!(
            (plane - base).norm() <= 1e-14 * sigma * sigma,
            "{row:?}: {plane} {base}"
        );
    }
}

#[test]
fn the_triangles_response_is_the_integral_of_what_the_groove_changes() {
    let narrow = |row: &[f64]| row[0] * row[2].abs() < 8.0 * row[4] && row[1] * row[3] < 8.0 * row[4];
    for row in rows(scratches::PROFILE, narrow) {
        let &[width, depth, xi2, gamma_sum, lambda] = &row[..] else {
            unreachable!()
        };
        let p = TAU * gamma_sum * depth / lambda;
        // 1 - exp(i a) without cancellation, over half the width: the rest mirrors it.
        let change = |b: f64| {
            let half = 0.5 * p * (1.0 - 2.0 * b / width);
            let wave = 2.0 * (TAU * b * xi2 / lambda).cos();
            Complex::new(2.0 * half.sin() * half.sin(), -2.0 * half.sin() * half.cos()) * wave
        };
        let due = if width == 0.0 {
            Complex::new(0.0, 0.0)
        } else {
            simpson(change, [0.0, 0.5 * width], 4000)
        };
        let error = (complex(oracle::response_triangle(&row)) - due).norm();
        assert!(error <= 2e-9 * width * p.abs().min(1.0), "{row:?}: {error:e}");
    }
}

#[test]
fn the_windowed_rectangle_is_the_product_of_two_integrals_and_the_depth_term() {
    let slow = |row: &[f64]| {
        let [sigma, lambda] = [row[0], row[1]];
        // What is integrated holds at most some 30 waves, and the scratch lies in the window.
        sigma * row[4].abs().max(row[5].abs()) < 3.0 * lambda && row[7].abs() < 1e4 && row[8].abs() < 4.0 * sigma
    };
    for row in rows(surfaces::WINDOWED, slow) {
        let &[sigma, lambda, width, depth, xi1, xi2, gamma_sum, s_t, s_b, l1, l2] = &row[..] else {
            unreachable!()
        };
        let integral = |from: f64, to: f64, xi: f64| {
            let [from, to] = [from, to].map(|t| t.clamp(-8.0 * sigma, 8.0 * sigma));
            let wave = |t: f64| Complex::from_polar((-0.5 * (t / sigma).powi(2)).exp(), -TAU * xi * t / lambda);
            simpson(wave, [from, to], 6000)
        };
        let depth = Complex::new(1.0, 0.0) - Complex::from_polar(1.0, TAU * gamma_sum * depth / lambda);
        let along = integral(s_t + l1, s_t + l2, xi1);
        let due = along * integral(s_b - 0.5 * width, s_b + 0.5 * width, xi2) * depth;
        let error = (complex(oracle::response_rectangle_windowed(&row)) - due).norm();
        assert!(error <= 1e-9 * sigma * sigma, "{row:?}: {error:e}");
    }
}

#[test]
fn the_squared_scratch_is_the_squared_product_of_profile_and_phase() {
    for row in rows(surfaces::SCRATCH, |_| true) {
        let &[sigma, lambda, width, depth, xi1, xi2, gamma_sum, mean] = &row[..] else {
            unreachable!()
        };
        let profile = complex(oracle::profile_rectangle(&[width, depth, xi2, gamma_sum, lambda]));
        let phase = complex(oracle::spatial_phase_infinite(&[sigma, lambda, xi1, 0.0, 0.0]));
        let due = profile.norm_sqr() * phase.norm_sqr() * mean;
        let value = oracle::scratch_squared(&row).value();
        assert!(
            (value - due).abs() <= 1e-13 * due.max(1e-290),
            "{row:?}: {value:e} {due:e}"
        );
    }
    for row in rows(surfaces::DEPTH, |_| true) {
        let due = Complex::new(1.0, 0.0) - Complex::from_polar(1.0, TAU * row[1] * row[0] / row[2]);
        assert!((complex(oracle::depth_term(&row)) - due).norm() < 1e-12, "{row:?}");
    }
}

#[test]
fn the_shares_of_tiles_sum_to_1_and_the_sampling_density_has_its_closed_form() {
    for (width, sigma) in [(0.5, 1.0), (3.0, 10.0), (20.0, 60.0)] {
        let tiles = (-200..=200).map(|i| oracle::area_density(&[width, width * (f64::from(i) + 0.3), sigma]).value());
        let sum: f64 = tiles.sum();
        assert!((sum - 1.0).abs() < 1e-14, "{width} {sigma}: {sum}");
    }
    for row in rows(surfaces::CONE, |row| (1e-3..300.0).contains(&row[0])) {
        let due = row[0] / (4.0 * PI * row[0].sinh()) * (row[0] * row[1]).exp();
        let value = oracle::von_mises_fisher_pdf(&row).value();
        assert!((value / due - 1.0).abs() < 1e-12, "{row:?}: {value:e} {due:e}");
    }
}

#[test]
fn the_inverse_of_the_gaussian_gives_its_probability_back() {
    for u in (surfaces::GAUSSIAN_U.rows)(53, 400) {
        let y = oracle::gaussian_inverse(u).value();
        let given = 0.5 * oracle::erfc_complex(-y, 0.0)[0].value();
        // The last place of y moves u by its density over u.
        let slope = (-y * y).exp() / PI.sqrt() * y.abs();
        assert!((given - u).abs() <= 1e-15 * u + 4e-16 * slope, "{u:e}: {y} {given:e}");
    }
}
