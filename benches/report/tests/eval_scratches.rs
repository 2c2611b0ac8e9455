//! `report eval` of the functions of scratches: columns, infinite ends, refused rows, tolerances.

mod program;

use program::{lines, report, rows};
use reference::registry::{function, methods};
use std::process::Output;

const PHASE: [f64; 2] = [1.3076958876190834, 2.142487737594054];
const RECTANGLE: [f64; 2] = [0.00431213870395954, 0.07541068011078444];
const TRIANGLE: [f64; 2] = [-0.14800638213000233, -0.6193603339684828];
const MEAN: [f64; 1] = [0.4092668076579739];
const REDUCED: [f64; 1] = [0.1772821744830446];
const ENERGY: [f64; 1] = [96232.83491621808];
const INVERSE: [f64; 1] = [-0.8497850219515947];

fn error_text(output: &Output) -> String {
    String::from_utf8_lossy(&output.stderr).into_owned()
}

fn answers(name: &str, input: &str) -> Vec<Vec<f64>> {
    let out = report(&["eval", name], input);
    assert_eq!(out.status.code(), Some(0), "{name}: {}", error_text(&out));
    rows(&out)
}

fn close(found: &[f64], expected: &[f64], scale: f64) -> bool {
    found.len() == expected.len() && found.iter().zip(expected).all(|(a, b)| (a - b).abs() <= 1e-13 * scale)
}

#[test]
fn the_columns_are_those_of_the_formulas() {
    // By mpmath's quadrature of the definitions with 30 digits.
    for (name, input, expected, scale) in [
        ("spatial_phase", "10 0.55 0.02 0.3 3 -4 -20 11", PHASE.as_slice(), 25.0),
        ("profile_rectangle", "2 0.3 0.2 1.8 0.55", RECTANGLE.as_slice(), 2.0),
        ("profile_triangle", "2 0.3 0.2 1.8 0.55", TRIANGLE.as_slice(), 2.0),
        ("footprint_mean", "30 12 0.6 7 10", MEAN.as_slice(), 1.0),
        ("footprint_mean_reduced", "3 2.5", REDUCED.as_slice(), 1.0),
        ("segment_energy", "10 0.55 0.01 25", ENERGY.as_slice(), ENERGY[0]),
        ("sinc_squared_inverse", "0.25", INVERSE.as_slice(), 1.0),
    ] {
        let found = answers(name, input);
        assert_eq!(found.len(), 1, "{name}");
        assert!(close(&found[0], expected, scale), "{name}: {found:?} {expected:?}");
    }
}

#[test]
fn a_scratch_with_infinite_ends_has_its_limit() {
    let (sigma, lambda, xi1, xi2, s_b) = (10.0, 0.55, 0.015, 0.2, 4.0);
    let found = answers(
        "spatial_phase",
        "10 0.55 0.015 0.2 3 4 -inf inf\n10 0.55 0.015 0.2 3 4 -1e9 1e9\n10,0.55,0.015,0.2,3,4,-3,inf\n",
    );
    let tau = std::f64::consts::TAU;
    let exponent: f64 = (tau * sigma * xi1 / lambda).powi(2) + (s_b / sigma).powi(2);
    let modulus = tau.sqrt() * sigma * (-0.5 * exponent).exp();
    let (sine, cosine) = (tau * s_b * xi2 / lambda).sin_cos();
    let infinite = [modulus * cosine, -modulus * sine];
    assert!(close(&found[0], &infinite, 25.0), "{found:?} {infinite:?}");
    assert_eq!(found[0], found[1]);
    // The half line from the nearest point on: half the real part before the turn by s_b xi2.
    let turned = found[2][0] * cosine - found[2][1] * sine;
    assert!((turned - 0.5 * modulus).abs() < 1e-12, "{turned} {modulus}");
    // A footprint of any length: offsets and half widths may be infinite.
    assert_eq!(answers("footprint_mean_reduced", "0 inf\n0 -inf\n"), [[0.0], [0.0]]);
}

#[test]
fn not_a_number_gives_not_a_number_and_nothing_is_refused() {
    for (name, columns) in [
        ("spatial_phase", 8),
        ("profile_rectangle", 5),
        ("profile_triangle", 5),
        ("footprint_mean", 5),
        ("footprint_mean_reduced", 2),
        ("segment_energy", 4),
        ("sinc_squared_inverse", 1),
    ] {
        assert_eq!(function(name).expect("registered").inputs.len(), columns);
        let mut input = String::new();
        for i in 0..columns {
            let row: Vec<&str> = (0..columns).map(|j| if i == j { "nan" } else { "0.5" }).collect();
            input.push_str(&row.join(" "));
            input.push('\n');
        }
        let found = answers(name, &input);
        assert_eq!(found.len(), columns, "{name}");
        assert!(found.iter().flatten().all(|x| x.is_nan()), "{name}: {found:?}");
    }
}

#[test]
fn a_row_out_of_the_domain_is_refused_by_line_column_and_reason_after_the_rows_before_it() {
    let good = "10 0.5 0 0 0 0 -1 1";
    for (name, input, place, reason, before) in [
        (
            "spatial_phase",
            format!("{good}\n0 0.5 0 0 0 0 -1 1\n"),
            "line 2, column 1",
            "sigma is not a positive length",
            1,
        ),
        (
            "spatial_phase",
            format!("{good}\n# a comment\n10,-0.5,0,0,0,0,-1,1\n"),
            "line 3, column 2",
            "lambda is not a positive length",
            1,
        ),
        (
            "spatial_phase",
            "10 0.5 0 0 inf 0 -1 1\n".to_string(),
            "line 1, column 5",
            "only the ends",
            0,
        ),
        (
            "spatial_phase",
            "10 0.5 0 0 0 0 -1\n".to_string(),
            "line 1",
            "8 columns expected (sigma lambda xi1 xi2 s_t s_b l1 l2), 7 found",
            0,
        ),
        (
            "profile_rectangle",
            "-2 0.3 0.2 1.8 0.5\n".to_string(),
            "line 1, column 1",
            "the width is not a length",
            0,
        ),
        (
            "profile_triangle",
            "2 0.3 0.2 1.8 0\n".to_string(),
            "line 1, column 5",
            "lambda is not a positive length",
            0,
        ),
        (
            "footprint_mean",
            "10 10 1 0 10\n10 10 1.5 0 10\n".to_string(),
            "line 2, column 3",
            "the cosine is beyond 1",
            1,
        ),
        (
            "footprint_mean",
            "10 -10 1 0 10\n".to_string(),
            "line 1, column 2",
            "a2 is negative",
            0,
        ),
        (
            "footprint_mean_reduced",
            "-1 0\n".to_string(),
            "line 1, column 1",
            "the half width is negative",
            0,
        ),
        (
            "segment_energy",
            "10 0.5 0 -3\n".to_string(),
            "line 1, column 4",
            "the length is negative",
            0,
        ),
        (
            "sinc_squared_inverse",
            "0.5\n1.5\n".to_string(),
            "line 2, column 1",
            "u is not a probability",
            1,
        ),
    ] {
        let out = report(&["eval", name], &input);
        let message = error_text(&out);
        assert_eq!(out.status.code(), Some(2), "{name} {input:?}: {message}");
        assert!(
            message.contains(place) && message.contains(reason),
            "{name} {input:?}: {message}"
        );
        assert_eq!(lines(&out.stdout).len(), before, "{name} {input:?}");
    }
}

#[test]
fn a_number_that_f32_rounds_out_of_the_domain_is_refused_in_f32_alone() {
    let input = "1e-60 0.5 0 0 0 0 -1 1\n";
    assert_eq!(answers("spatial_phase", input).len(), 1);
    let out = report(&["eval", "spatial_phase", "--precision", "f32"], input);
    assert_eq!((out.status.code(), out.stdout.len()), (Some(2), 0));
    assert!(error_text(&out).contains("line 1, column 1"), "{}", error_text(&out));
}

/// Footprints of all sizes, with offsets to beyond the edge.
fn footprints() -> String {
    let mut input = String::new();
    for i in 0..30 {
        let half = 0.05 * 1.4_f64.powi(i);
        for j in 0..12 {
            let offset = half * 0.11 * f64::from(j);
            input.push_str(&format!("{half} {} 0.3 {offset} 1\n", 2.0 * half));
        }
    }
    input
}

#[test]
fn a_tolerance_picks_the_cheapest_tier_of_the_footprint_that_keeps_it() {
    let input = footprints();
    let truth = answers("footprint_mean", &input);
    for (tolerance, tier) in [("1e-3", "coarse"), ("1e-6", "medium"), ("1e-12", "accurate")] {
        let out = report(&["eval", "footprint_mean", "--tolerance", tolerance], &input);
        let message = error_text(&out);
        assert_eq!(out.status.code(), Some(0), "{message}");
        assert!(
            message.contains(&format!("method {tier} promises")),
            "{tolerance}: {message}"
        );
        let allowed: f64 = tolerance.parse().expect("a number");
        for (found, truth) in rows(&out).iter().zip(&truth) {
            assert!(
                (found[0] - truth[0]).abs() <= allowed,
                "{tolerance}: {found:?} {truth:?}"
            );
        }
    }
    let out = report(&["eval", "footprint_mean", "--tolerance", "1e-17"], &input);
    assert_eq!((out.status.code(), out.stdout.len()), (Some(2), 0));
}

#[test]
fn a_tolerance_of_a_length_counts_in_the_functions_scale_and_says_so() {
    let out = report(
        &["eval", "spatial_phase", "--precision", "f32", "--tolerance", "1e-5"],
        "10 0.55 0.02 0.3 3 -4 -20 11\n",
    );
    assert_eq!(out.status.code(), Some(0), "{}", error_text(&out));
    assert!(
        error_text(&out).contains("the scale sqrt(2 pi) sigma"),
        "{}",
        error_text(&out)
    );
    assert!((rows(&out)[0][0] - PHASE[0]).abs() <= 1e-5 * 25.1);
    let out = report(
        &["eval", "profile_triangle", "--tolerance", "1e-17"],
        "2 0.3 0.2 1.8 0.55\n",
    );
    assert_eq!((out.status.code(), out.stdout.len()), (Some(2), 0));
    assert!(
        error_text(&out).contains("max(the width, |result|)"),
        "{}",
        error_text(&out)
    );
    let text = String::from_utf8(report(&["list"], "").stdout).expect("UTF-8");
    assert!(text.contains("scale:   sqrt(2 pi) sigma; peak errors and tolerances are multiples of it"));
}

#[test]
fn every_function_of_scratches_answers_in_each_precision_it_is_registered_in() {
    for (name, input) in [
        ("spatial_phase", "10 0.55 0.02 0.3 3 -4 -20 11"),
        ("profile_rectangle", "2 0.3 0.2 1.8 0.55"),
        ("profile_triangle", "2 0.3 0.2 1.8 0.55"),
    ] {
        let wide = answers(name, input);
        let narrow = report(&["eval", name, "--precision", "f32"], input);
        assert_eq!(narrow.status.code(), Some(0), "{name}: {}", error_text(&narrow));
        for (a, b) in wide[0].iter().zip(&rows(&narrow)[0]) {
            assert!(a != b && (a - b).abs() < 1e-4, "{name}: {a} {b}");
        }
        for m in methods()
            .iter()
            .filter(|m| m.function == name && m.method.starts_with("as_printed"))
        {
            let out = report(&["eval", name, "--method", m.method], input);
            assert_eq!(out.status.code(), Some(0), "{name} / {}", m.method);
        }
    }
}
