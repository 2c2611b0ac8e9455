//! The program's command line, run as a program: `report eval` and `report list`.

mod program;

use program::{lines, report, rows};
use std::io::Write;
use std::process::{Command, Output, Stdio};

/// The only number of each line.
fn numbers(output: &Output) -> Vec<f64> {
    let only = |row: Vec<f64>| match row[..] {
        [number] => number,
        _ => panic!("{} numbers in a line", row.len()),
    };
    rows(output).into_iter().map(only).collect()
}

#[test]
fn rows_come_out_one_for_one_with_all_digits() {
    let out = report(&["eval", "sine_integral"], "# x\n1\n\n-1\n");
    assert_eq!(out.status.code(), Some(0), "{}", String::from_utf8_lossy(&out.stderr));
    // Si(1) = 0.946083070367183014941353313823...
    assert_eq!(lines(&out.stdout), ["9.4608307036718298e-1", "-9.4608307036718298e-1"]);
    assert!(out.stderr.is_empty());
}

#[test]
fn both_precisions_answer_and_differ() {
    let input = "0.5\n3.25\n40\n";
    let wide = numbers(&report(&["eval", "sine_integral"], input));
    let narrow = numbers(&report(&["eval", "sine_integral", "--precision", "f32"], input));
    assert_eq!((wide.len(), narrow.len()), (3, 3));
    for (w, n) in wide.iter().zip(&narrow) {
        assert!((w - n).abs() <= 4e-7 * w.abs(), "{w} {n}");
        assert_eq!(f64::from(*n as f32), *n, "an f32 result is an f32 number");
    }
    assert_ne!(wide, narrow);
}

#[test]
fn two_columns_are_separated_by_commas_or_blanks() {
    let out = report(&["eval", "sinc_squared_integral"], "0,1\r\n0 1 # the same\r\n 0\t, 1");
    let values = numbers(&out);
    assert_eq!(out.status.code(), Some(0));
    assert_eq!(values.len(), 3);
    // The integral of (sin t/t)^2 from 0 to 1 is 0.897339558529123...
    assert!(
        values
            .iter()
            .all(|v| (v - 0.897_339_558_529_123_6).abs() < 1e-12 && *v == values[0]),
        "{values:?}"
    );
}

#[test]
fn a_bad_row_is_refused_by_line_and_reason_and_nothing_stands_for_it() {
    for (input, place, reason, before) in [
        ("1\n2\nx\n4\n", "line 3, column 1", "\"x\" is not a number", 2),
        ("1\n1 2\n", "line 2", "1 column expected (x), 2 found", 1),
        (",\n", "line 1, column 1", "the column is empty", 0),
        ("\n# c\n0x1p9z\n", "line 3, column 1", "is not a number", 0),
        ("1e309\n", "line 1, column 1", "beyond the range of f64", 0),
    ] {
        let out = report(&["eval", "sine_integral"], input);
        let message = String::from_utf8_lossy(&out.stderr).into_owned();
        assert_eq!(out.status.code(), Some(2), "{input:?}");
        assert!(
            message.contains(place) && message.contains(reason),
            "{input:?}: {message}"
        );
        assert_eq!(lines(&out.stdout).len(), before, "{input:?}");
    }
    let out = report(
        &["eval", "sinc_squared_integral", "--precision", "f32"],
        "0 1\n0 1e39\n0 2\n",
    );
    assert_eq!((out.status.code(), lines(&out.stdout).len()), (Some(2), 1));
    assert!(String::from_utf8_lossy(&out.stderr).contains("line 2, column 2: \"1e39\" is beyond the range of f32"));
}

#[test]
fn a_line_without_end_and_bytes_that_are_no_text_are_refused() {
    let out = report(&["eval", "sine_integral"], &format!("1\n{}", "7".repeat(3 << 20)));
    assert_eq!((out.status.code(), lines(&out.stdout).len()), (Some(2), 1));
    assert!(String::from_utf8_lossy(&out.stderr).contains("line 2: the line is longer than"));
}

#[test]
fn not_a_number_in_gives_not_a_number_out_and_infinities_have_limits() {
    let out = report(&["eval", "sine_integral"], "nan\ninf\n-inf\n");
    let values = numbers(&out);
    assert!(values[0].is_nan());
    assert_eq!(values[1..], [std::f64::consts::FRAC_PI_2, -std::f64::consts::FRAC_PI_2]);
}

#[test]
fn unknown_names_are_refused_with_the_known_ones_and_a_suggestion() {
    let out = report(&["eval", "sine_integal"], "1\n");
    let message = String::from_utf8_lossy(&out.stderr).into_owned();
    assert_eq!(out.status.code(), Some(2));
    assert!(
        message.contains("did you mean sine_integral?") && message.contains("sinc_squared_integral"),
        "{message}"
    );
    assert!(out.stdout.is_empty());
    let out = report(&["eval", "sine_integral", "--method", "acurate"], "1\n");
    assert_eq!(out.status.code(), Some(2));
    assert!(String::from_utf8_lossy(&out.stderr).contains("did you mean accurate?"));
    assert_eq!(
        report(&["eval", "sine_integral", "--precision", "f16"], "1\n")
            .status
            .code(),
        Some(2)
    );
}

#[test]
fn a_named_method_is_the_one_that_answers() {
    let exact = numbers(&report(&["eval", "sine_integral", "--method", "accurate"], "3.56\n"))[0];
    let fit = numbers(&report(&["eval", "sine_integral", "--method", "vwh18"], "3.56\n"))[0];
    // The published fit is worst here: off by 0.0510.
    assert!(((fit - exact).abs() - 0.0510).abs() < 1e-4, "{fit} {exact}");
}

#[test]
fn a_tolerance_picks_a_method_that_keeps_it_or_says_that_none_does() {
    let input: String = (1..400).map(|i| format!("{}\n", f64::from(i) * 0.125)).collect();
    let truth = numbers(&report(&["eval", "sine_integral"], &input));
    for tolerance in [1e-3, 2e-5, 1e-6] {
        let text = tolerance.to_string();
        let out = report(
            &["eval", "sine_integral", "--precision", "f32", "--tolerance", &text],
            &input,
        );
        assert_eq!(out.status.code(), Some(0), "{}", String::from_utf8_lossy(&out.stderr));
        let values = numbers(&out);
        assert_eq!(values.len(), truth.len());
        for (v, t) in values.iter().zip(&truth) {
            assert!((v - t).abs() <= tolerance * t.abs().max(1.0), "{tolerance}: {v} {t}");
        }
        assert!(String::from_utf8_lossy(&out.stderr).contains("promises"));
    }
    for (precision, tolerance) in [
        ("f32", "1e-9"),
        ("f64", "1e-18"),
        ("f64", "0"),
        ("f64", "nan"),
        ("f64", "-1"),
    ] {
        let out = report(
            &[
                "eval",
                "sine_integral",
                "--precision",
                precision,
                "--tolerance",
                tolerance,
            ],
            "1\n",
        );
        assert_eq!(out.status.code(), Some(2), "{precision} {tolerance}");
        assert!(out.stdout.is_empty() && !out.stderr.is_empty());
    }
}

#[test]
fn the_list_names_functions_columns_units_results_and_methods() {
    let out = report(&["list"], "");
    let text = String::from_utf8(out.stdout).expect("UTF-8");
    assert_eq!(out.status.code(), Some(0));
    for f in reference::registry::functions() {
        assert!(text.contains(&format!("{}: {}", f.name, f.summary)), "{text}");
        for (name, unit) in f.inputs.iter().chain(f.outputs) {
            assert!(text.contains(&format!("{name} [{unit}]")), "{name}: {text}");
        }
    }
    assert!(text.contains("accurate  f64  scalar  error <= "), "{text}");
    assert!(text.contains("f32"));
}

#[test]
fn a_reader_that_goes_away_is_no_failure() {
    let mut child = Command::new(env!("CARGO_BIN_EXE_report"))
        .args(["eval", "sine_integral"])
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .expect("the program starts");
    drop(child.stdout.take());
    let mut stdin = child.stdin.take().expect("piped");
    let writer = std::thread::spawn(move || drop(stdin.write_all("1.5\n".repeat(200_000).as_bytes())));
    let output = child.wait_with_output().expect("the program ends");
    writer.join().expect("the writer ends");
    assert_eq!(output.status.code(), Some(0));
    assert!(output.stderr.is_empty(), "{}", String::from_utf8_lossy(&output.stderr));
}
