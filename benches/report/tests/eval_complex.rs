//! `report eval` of functions with complex results: w, erf, the scaled erf difference.

mod program;

use program::{lines, report, rows};
use std::process::Output;

const COMPLEX: [&str; 3] = ["faddeeva_w", "erf_complex", "erf_difference_scaled"];

fn error_text(output: &Output) -> String {
    String::from_utf8_lossy(&output.stderr).into_owned()
}

/// |a - b| / |b|.
fn relative(a: &[f64], b: &[f64]) -> f64 {
    (a[0] - b[0]).hypot(a[1] - b[1]) / b[0].hypot(b[1])
}

#[test]
fn two_columns_come_out_with_all_digits_in_the_order_of_the_rows() {
    // By mpmath with 30 digits.
    for (name, input, expected) in [
        (
            "faddeeva_w",
            "1 1\n-0.5,2.25\n",
            [
                [0.304_744_205_256_912_6, 0.208_218_938_202_831_63],
                [0.223_309_955_767_052_36, -0.042_902_948_456_019_51],
            ],
        ),
        (
            "erf_complex",
            "# re im\n1 1\n-0.5,2.25\n",
            [
                [1.316_151_281_697_947_6, 0.190_453_469_237_834_69],
                [-31.541_686_375_919_433, -12.540_720_744_072_232],
            ],
        ),
        (
            "erf_difference_scaled",
            "0 1 0.5\n2 1 1\n",
            [
                [0.740_413_480_888_406_4, -0.332_531_289_430_825_5],
                [0.114_978_857_490_090_76, 0.074_205_872_678_403_48],
            ],
        ),
    ] {
        let out = report(&["eval", name], input);
        assert_eq!(out.status.code(), Some(0), "{name}: {}", error_text(&out));
        let found = rows(&out);
        assert_eq!(found.len(), 2, "{name}");
        for (found, expected) in found.iter().zip(&expected) {
            assert_eq!(found.len(), 2, "{name}");
            assert!(relative(found, expected) < 1e-15, "{name}: {found:?} {expected:?}");
        }
        for word in lines(&out.stdout).iter().flat_map(|line| line.split(' ')) {
            let (digits, exponent) = word.split_once('e').expect("an exponent");
            let count = digits.chars().filter(char::is_ascii_digit).count();
            assert!(count == 17 && exponent.parse::<i32>().is_ok(), "{name}: {word}");
        }
    }
}

#[test]
fn results_read_back_are_the_same_numbers() {
    let z = iridescence::Complex::new(1.75, -0.3);
    let found = rows(&report(&["eval", "faddeeva_w"], "1.75 -0.3\n"));
    let w = iridescence::special::faddeeva_w(z);
    assert_eq!(found, [vec![w.re, w.im]]);
    let found = rows(&report(&["eval", "erf_complex"], "0x1.cp0 -0x1.3333333333333p-2\n"));
    let erf = iridescence::special::erf_complex(z);
    assert_eq!(found, [vec![erf.re, erf.im]]);
}

#[test]
fn not_a_number_in_either_column_gives_two_and_infinities_have_limits() {
    for (name, input) in [
        ("faddeeva_w", "nan 1\n1 nan\nnan nan\n"),
        ("erf_complex", "nan 0\n0 nan\nnan inf\n"),
        ("erf_difference_scaled", "nan 1 1\n1 nan 1\n1 2 nan\n"),
    ] {
        let found = rows(&report(&["eval", name], input));
        assert_eq!(found.len(), 3, "{name}");
        assert!(found.iter().flatten().all(|x| x.is_nan()), "{name}: {found:?}");
    }
    let limits = |name, input| rows(&report(&["eval", name], input));
    assert_eq!(limits("faddeeva_w", "inf 0\n-inf 3\n0 inf\n"), vec![vec![0.0, 0.0]; 3]);
    assert_eq!(limits("erf_complex", "inf 0\n-inf 2\n"), [[1.0, 0.0], [-1.0, 0.0]]);
    let found = limits("erf_difference_scaled", "-inf inf 0\n0 inf 0\n1 1 3\n0 1 inf\n");
    assert_eq!(found, [[2.0, 0.0], [1.0, 0.0], [0.0, 0.0], [0.0, 0.0]]);
}

#[test]
fn a_bad_row_is_refused_by_line_and_reason_after_the_rows_before_it() {
    for (name, input, place, reason, before) in [
        (
            "faddeeva_w",
            "1 1\n1\n2 2\n",
            "line 2",
            "2 columns expected (re im), 1 found",
            1,
        ),
        (
            "faddeeva_w",
            "1 1 1\n",
            "line 1",
            "2 columns expected (re im), 3 found",
            0,
        ),
        ("erf_complex", "\n1 i\n", "line 2, column 2", "\"i\" is not a number", 0),
        (
            "erf_complex",
            "1 1\n2 2\n1,,2\n",
            "line 3, column 2",
            "the column is empty",
            2,
        ),
        (
            "erf_difference_scaled",
            "0 1\n",
            "line 1",
            "3 columns expected (a1 a2 b), 2 found",
            0,
        ),
        (
            "erf_difference_scaled",
            "0 1 2\n0 1 1e400\n",
            "line 2, column 3",
            "beyond the range of f64",
            1,
        ),
    ] {
        let out = report(&["eval", name], input);
        let message = error_text(&out);
        assert_eq!(out.status.code(), Some(2), "{name} {input:?}");
        assert!(
            message.contains(place) && message.contains(reason),
            "{name} {input:?}: {message}"
        );
        assert_eq!(lines(&out.stdout).len(), before, "{name} {input:?}");
    }
}

#[test]
fn single_precision_answers_in_f32_numbers_close_to_f64() {
    for (name, input) in [
        ("faddeeva_w", "0.5 0.25\n3.25 1\n-7 0.5\n"),
        ("erf_difference_scaled", "-0.5 1.5 2\n0 0.75 3\n-2 -1 0.5\n"),
    ] {
        let wide = rows(&report(&["eval", name], input));
        let out = report(&["eval", name, "--precision", "f32"], input);
        assert_eq!(out.status.code(), Some(0), "{name}: {}", error_text(&out));
        let narrow = rows(&out);
        assert_eq!((wide.len(), narrow.len()), (3, 3), "{name}");
        for (wide, narrow) in wide.iter().zip(&narrow) {
            assert!(relative(narrow, wide) < 2e-6, "{name}: {wide:?} {narrow:?}");
            assert!(narrow.iter().all(|x| f64::from(*x as f32) == *x), "{name}: {narrow:?}");
        }
        assert_ne!(wide, narrow, "{name}");
    }
}

#[test]
fn a_named_tier_answers_and_a_tolerance_picks_one_that_keeps_it() {
    let mut input = String::new();
    for i in 0..40 {
        for j in 0..20 {
            input.push_str(&format!("{} {}\n", f64::from(i) * 0.3 - 6.0, f64::from(j) * 0.25));
        }
    }
    let truth = rows(&report(&["eval", "faddeeva_w"], &input));
    let error = |out: &Output| {
        let found = rows(out);
        assert_eq!(found.len(), truth.len());
        found
            .iter()
            .zip(&truth)
            .map(|(a, b)| relative(a, b))
            .fold(0.0, f64::max)
    };
    let fine = error(&report(&["eval", "faddeeva_w", "--method", "fine"], &input));
    let coarse = error(&report(&["eval", "faddeeva_w", "--method", "coarse"], &input));
    assert!(fine > 0.0 && fine <= 1e-10, "{fine}");
    assert!(coarse > 1e-7 && coarse <= 5e-5, "{coarse}");
    for (tolerance, allowed) in [
        ("1e-4", vec!["coarse", "medium", "fine", "accurate"]),
        ("1e-8", vec!["fine", "accurate"]),
        ("1e-14", vec!["accurate"]),
    ] {
        let out = report(&["eval", "faddeeva_w", "--tolerance", tolerance], &input);
        let message = error_text(&out);
        assert_eq!(out.status.code(), Some(0), "{message}");
        assert!(
            allowed
                .iter()
                .any(|name| message.contains(&format!("method {name} promises"))),
            "{tolerance}: {message}"
        );
        assert!(error(&out) <= tolerance.parse().expect("a number"), "{tolerance}");
    }
    let out = report(&["eval", "faddeeva_w", "--tolerance", "1e-17"], &input);
    assert_eq!((out.status.code(), out.stdout.len()), (Some(2), 0));
}

#[test]
fn peers_and_slices_cannot_be_asked_for() {
    for name in COMPLEX {
        let out = report(&["eval", name, "--method", "errorfunctions"], "1 1\n");
        assert_eq!((out.status.code(), out.stdout.len()), (Some(2), 0), "{name}");
        assert!(error_text(&out).contains("accurate"), "{name}: {}", error_text(&out));
    }
}
