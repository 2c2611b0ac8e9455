//! The two oracles against each other and against the certified digits of `data/golden`.

use reference::generate::{self, arcs, points};
use reference::hexadecimal;
use reference::metrics::Reference;
use reference::oracle::{self, arbitrary};

/// Two routes may differ by this much; double-double holds about 1e-31, one digit in ten goes to cancellation.
const AGREEMENT: f64 = 1e-27;

fn same(a: &Reference, b: &Reference) -> bool {
    (a.hi.is_nan() && b.hi.is_nan())
        || a.hi == b.hi && a.exponent == b.exponent && a.lo == b.lo
        || a.relative_difference(b) < AGREEMENT
}

#[test]
fn the_fast_and_the_slow_oracle_agree_on_every_generator() {
    for generator in generate::all() {
        for row in (generator.rows)(11, 120).chunks(generator.columns) {
            let pairs = match *row {
                [x] => vec![
                    (oracle::sine_integral(x), arbitrary::sine_integral(x)),
                    (oracle::sinc(x), arbitrary::sinc(x)),
                ],
                [q0, q1] => vec![(
                    oracle::sinc_squared_integral(q0, q1),
                    arbitrary::sinc_squared_integral(q0, q1),
                )],
                _ => unreachable!(),
            };
            for (fast, slow) in pairs {
                assert!(same(&fast, &slow), "{} {row:?}: {fast:?} {slow:?}", generator.name);
            }
        }
    }
}

#[test]
fn the_oracles_agree_at_infinities_extremes_and_nan() {
    for x in points::non_finite() {
        assert!(same(&oracle::sine_integral(x), &arbitrary::sine_integral(x)), "{x}");
        assert!(same(&oracle::sinc(x), &arbitrary::sinc(x)), "{x}");
    }
    for [q0, q1] in arcs::non_finite().into_iter().chain(arcs::extreme()) {
        let (fast, slow) = (
            oracle::sinc_squared_integral(q0, q1),
            arbitrary::sinc_squared_integral(q0, q1),
        );
        assert!(same(&fast, &slow), "{q0:e} {q1:e}: {fast:?} {slow:?}");
    }
}

#[test]
fn the_oracles_keep_the_symmetries_exactly() {
    for row in (arcs::ARC_F64.rows)(12, 4000).chunks(2) {
        let arc = oracle::sinc_squared_integral(row[0], row[1]);
        let swapped = oracle::sinc_squared_integral(row[1], row[0]);
        let mirrored = oracle::sinc_squared_integral(-row[1], -row[0]);
        assert_eq!((arc.hi, arc.lo), (-swapped.hi, -swapped.lo), "{row:?}");
        assert_eq!((arc.hi, arc.lo), (mirrored.hi, mirrored.lo), "{row:?}");
        assert_eq!(row[0] == row[1], arc.hi == 0.0, "{row:?}");
        assert_eq!(row[0] < row[1], arc.hi > 0.0, "{row:?}");
    }
    for x in (points::REAL_F64.rows)(12, 4000) {
        assert_eq!(oracle::sine_integral(-x), -oracle::sine_integral(x), "{x:e}");
    }
    assert!(oracle::sine_integral(-0.0).hi.is_sign_negative());
}

/// Rows of a golden table: inputs, certified value, the 40 digits.
fn golden(columns: usize, text: &str) -> Vec<(Vec<f64>, Reference, String)> {
    let number = |word: &str| hexadecimal::parse(word).unwrap_or_else(|_| panic!("{word:?} in data/golden"));
    let rows = text.lines().skip(1).map(|line| {
        let words: Vec<&str> = line.split(',').collect();
        assert_eq!(words.len(), columns + 4, "{line}");
        let inputs = words[..columns].iter().map(|word| number(word)).collect();
        let exponent = words[columns + 2].parse().expect("an exponent");
        let value = Reference {
            hi: number(words[columns]),
            lo: number(words[columns + 1]),
            exponent,
        };
        (inputs, value, words[columns + 3].to_owned())
    });
    rows.collect()
}

#[test]
fn both_oracles_of_the_sine_integral_give_the_certified_digits() {
    let rows = golden(1, include_str!("../../../data/golden/sine_integral.csv"));
    assert!(rows.len() > 300);
    for (x, truth, digits) in rows {
        for value in [oracle::sine_integral(x[0]), arbitrary::sine_integral(x[0])] {
            assert!(
                value.relative_difference(&truth) < AGREEMENT,
                "{x:?}: {value:?}, certified {truth:?}"
            );
        }
        assert_decimal(&truth, &digits);
    }
}

#[test]
fn both_oracles_of_the_arc_give_the_certified_digits() {
    let rows = golden(2, include_str!("../../../data/golden/sinc_squared_integral.csv"));
    assert!(rows.len() > 300);
    for (q, truth, digits) in rows {
        for value in [
            oracle::sinc_squared_integral(q[0], q[1]),
            arbitrary::sinc_squared_integral(q[0], q[1]),
        ] {
            assert!(
                value.relative_difference(&truth) < AGREEMENT,
                "{q:?}: {value:?}, certified {truth:?}"
            );
        }
        assert_decimal(&truth, &digits);
    }
}

/// The decimal column says the same as the binary ones, as far as f64 can tell.
fn assert_decimal(truth: &Reference, digits: &str) {
    let decimal: f64 = digits.parse().expect("decimal digits");
    let value = truth.value();
    assert!(
        (decimal - value).abs() <= 2.0 * f64::EPSILON * value.abs() + f64::from_bits(1),
        "{digits} {truth:?}"
    );
}
