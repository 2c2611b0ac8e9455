//! The two oracles against each other and against the certified digits of `data/golden`.

use reference::generate::{self, arcs, points};
use reference::golden::{self, Row};
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
    // Complex points and erf differences are held in `oracles_complex`, scratches in `oracles_scratches` and
    // `oracles_surfaces`.
    const APART: [&str; 15] = [
        "complex_",
        "erf_difference_",
        "spatial_phase",
        "profile",
        "triangle_poles",
        "segment_energy",
        "footprint",
        "depth_term",
        "base_response",
        "scratch_squared",
        "response_rectangle_windowed",
        "area_density",
        "von_mises_fisher",
        "sphere_light",
        "quad_light",
    ];
    let apart = |name: &str| APART.iter().any(|start| name.starts_with(start));
    for generator in generate::all().iter().filter(|g| !apart(g.name)) {
        for row in (generator.rows)(11, 120).chunks(generator.columns) {
            let pairs = match *row {
                [x] => {
                    let bounded = x.clamp(-700.0, 700.0);
                    vec![
                        (oracle::sine_integral(x), arbitrary::sine_integral(x)),
                        (oracle::sinc(x), arbitrary::sinc(x)),
                        (oracle::sine(x), arbitrary::sine(x)),
                        (oracle::cosine(x), arbitrary::cosine(x)),
                        (oracle::exponential(bounded), arbitrary::exponential(bounded)),
                    ]
                }
                [q0, q1] => vec![(
                    oracle::sinc_squared_integral(q0, q1),
                    arbitrary::sinc_squared_integral(q0, q1),
                )],
                [width, xi0, xi1] => vec![(
                    oracle::sinc_squared_integral_turns(width, xi0, xi1),
                    arbitrary::sinc_squared_integral_turns(width, xi0, xi1),
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

#[test]
fn both_oracles_of_the_sine_integral_give_the_certified_digits() {
    let rows = golden::sine_integral();
    assert!(rows.len() > 300);
    for Row {
        inputs: x,
        truth,
        digits,
    } in rows
    {
        for value in [oracle::sine_integral(x[0]), arbitrary::sine_integral(x[0])] {
            assert!(
                value.relative_difference(&truth) < AGREEMENT,
                "{x:?}: {value:?}, certified {truth:?}"
            );
        }
        assert_decimal(&truth, digits);
    }
}

#[test]
fn both_oracles_of_the_arc_give_the_certified_digits() {
    let rows = golden::sinc_squared_integral();
    assert!(rows.len() > 300);
    for Row {
        inputs: q,
        truth,
        digits,
    } in rows
    {
        for value in [
            oracle::sinc_squared_integral(q[0], q[1]),
            arbitrary::sinc_squared_integral(q[0], q[1]),
        ] {
            assert!(
                value.relative_difference(&truth) < AGREEMENT,
                "{q:?}: {value:?}, certified {truth:?}"
            );
        }
        assert_decimal(&truth, digits);
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
