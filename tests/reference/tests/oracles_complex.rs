//! The oracles of w, erf, the erf difference and the Bessel functions: two routes against each other.

use reference::generate::{Generator, complex_points, erf_differences, points};
use reference::golden::{self, ComplexRow};
use reference::metrics::Reference;
use reference::oracle::{self, arbitrary, zeros};

/// Two routes may differ by this much in each component.
const AGREEMENT: f64 = 1e-25;
/// Numbers below 2^-UNDERFLOW of every format are equal to zero.
const UNDERFLOW: i32 = 20_000;

type Pair = [Reference; 2];
type Route = fn(f64, f64) -> Pair;

fn is_nothing(a: &Reference) -> bool {
    a.hi == 0.0 || a.exponent < -UNDERFLOW
}

fn difference(a: &Reference, b: &Reference) -> f64 {
    if a.hi.is_nan() && b.hi.is_nan() || a.hi == b.hi && a.hi.is_infinite() || is_nothing(a) && is_nothing(b) {
        return 0.0;
    }
    if is_nothing(a) != is_nothing(b) || !a.hi.is_finite() || !b.hi.is_finite() {
        return f64::INFINITY;
    }
    a.relative_difference(b)
}

/// The larger of the two components' relative differences.
fn component_wise(a: &Pair, b: &Pair) -> f64 {
    difference(&a[0], &b[0]).max(difference(&a[1], &b[1]))
}

/// |a - b|/|b|.
fn norm_wise(a: &Pair, b: &Pair) -> f64 {
    let top = b.iter().map(size).max().expect("two components");
    let share = |k: usize| {
        let moved = size(&b[k]) - top;
        if moved < -1000 {
            0.0
        } else {
            difference(&a[k], &b[k]) * 2f64.powi(moved)
        }
    };
    if b.iter().all(is_nothing) && a.iter().all(is_nothing) {
        return 0.0;
    }
    share(0).max(share(1))
}

fn size(a: &Reference) -> i32 {
    if is_nothing(a) {
        return -UNDERFLOW;
    }
    a.exponent + ((a.hi.abs().to_bits() >> 52) & 0x7FF) as i32 - 1023
}

fn hold(name: &str, domain: &Generator, count: usize, fast: Route, slow: Route) {
    let mut worst = (0.0, [0.0; 2]);
    for z in (domain.rows)(21, count).chunks(2) {
        let (a, b) = (fast(z[0], z[1]), slow(z[0], z[1]));
        let error = component_wise(&a, &b);
        if error > worst.0 {
            worst = (error, [z[0], z[1]]);
        }
        assert!(error < AGREEMENT, "{name}, {}: {z:?} {a:?} {b:?}", domain.name);
    }
    println!("{name}, {}: {:.1e} at {:?}", domain.name, worst.0, worst.1);
}

const DOMAINS: [Generator; 14] = [
    complex_points::UPPER_HALF_PLANE,
    complex_points::LOWER_HALF_PLANE,
    complex_points::UPPER_HALF_PLANE_F32,
    complex_points::LOWER_HALF_PLANE_F32,
    complex_points::WHOLE_PLANE,
    complex_points::ZEROS_OF_W,
    complex_points::ZEROS_OF_ERF,
    complex_points::FIRST_QUADRANT,
    complex_points::NEAR_REAL_AXIS,
    complex_points::NEAR_IMAGINARY_AXIS,
    complex_points::UPPER_TAIL,
    complex_points::RING,
    complex_points::REAL_LINE,
    complex_points::TIMING,
];

fn hold_everywhere(name: &str, fast: Route, slow: Route) {
    for domain in &DOMAINS {
        hold(name, domain, 250, fast, slow);
    }
}

#[test]
fn both_oracles_of_w_agree_in_each_component() {
    hold_everywhere("w", oracle::faddeeva_w, arbitrary::faddeeva::faddeeva_w);
}

#[test]
fn both_oracles_of_the_derivative_of_w_agree_in_each_component() {
    hold_everywhere(
        "w'",
        oracle::faddeeva_w_derivative,
        arbitrary::faddeeva::faddeeva_w_derivative,
    );
}

#[test]
fn both_oracles_of_erf_agree_in_each_component() {
    hold_everywhere("erf", oracle::erf_complex, arbitrary::faddeeva::erf_complex);
}

#[test]
fn both_oracles_of_erfc_agree_in_each_component() {
    hold_everywhere("erfc", oracle::erfc_complex, arbitrary::faddeeva::erfc_complex);
}

#[test]
fn both_oracles_of_the_erf_difference_agree_in_modulus() {
    for domain in [
        erf_differences::SCRATCH,
        erf_differences::SCRATCH_F32,
        erf_differences::SHORT,
        erf_differences::ANY,
    ] {
        let mut worst = (0.0, vec![]);
        for row in (domain.rows)(22, 600).chunks(3) {
            let (a, b) = (
                oracle::erf_difference_scaled(row[0], row[1], row[2]),
                arbitrary::erf_difference::erf_difference_scaled(row[0], row[1], row[2]),
            );
            let error = norm_wise(&a, &b);
            if error > worst.0 {
                worst = (error, row.to_vec());
            }
            assert!(error < AGREEMENT, "{}: {row:?} {a:?} {b:?}", domain.name);
        }
        println!("{}: {:.1e} at {:?}", domain.name, worst.0, worst.1);
    }
}

#[test]
fn both_oracles_of_the_bessel_functions_agree() {
    type Real = fn(f64) -> Reference;
    let routes: [(&str, Real, Real); 3] = [
        ("I0e", oracle::bessel_i0_scaled, arbitrary::bessel::bessel_i0_scaled),
        ("ln I0", oracle::log_bessel_i0, arbitrary::bessel::log_bessel_i0),
        (
            "I1/I0",
            oracle::bessel_i1_i0_ratio,
            arbitrary::bessel::bessel_i1_i0_ratio,
        ),
    ];
    for (name, fast, slow) in routes {
        let mut worst = (0.0, 0.0);
        for domain in [points::REAL_F64, points::REAL_F32, points::BESSEL_LINE] {
            for x in (domain.rows)(23, 1200) {
                if x == 0.0 {
                    continue;
                }
                let (a, b) = (fast(x), slow(x));
                let error = difference(&a, &b);
                if error > worst.0 {
                    worst = (error, x);
                }
                assert!(error < AGREEMENT, "{name}, {}: {x:e} {a:?} {b:?}", domain.name);
            }
        }
        println!("{name}: {:.1e} at {:e}", worst.0, worst.1);
    }
}

/// Largest error of a route against certified rows.
fn hold_certified(name: &str, rows: &[ComplexRow], least: usize, error: impl Fn(&[f64], &Pair) -> f64) {
    assert!(rows.len() > least, "{name}: {} rows", rows.len());
    let mut worst = (0.0, vec![]);
    for ComplexRow { inputs, truth } in rows {
        let e = error(inputs, truth);
        if e > worst.0 {
            worst = (e, inputs.clone());
        }
        assert!(e < AGREEMENT, "{name}: {inputs:?} {e:e}, certified {truth:?}");
    }
    println!("{name}, certified: {:.1e} at {:?}", worst.0, worst.1);
}

#[test]
fn both_oracles_of_the_complex_functions_give_the_certified_digits() {
    let cases: [(&str, Vec<ComplexRow>, Route, Route); 4] = [
        (
            "w",
            golden::faddeeva_w(),
            oracle::faddeeva_w,
            arbitrary::faddeeva::faddeeva_w,
        ),
        (
            "w'",
            golden::faddeeva_w_derivative(),
            oracle::faddeeva_w_derivative,
            arbitrary::faddeeva::faddeeva_w_derivative,
        ),
        (
            "erf",
            golden::erf_complex(),
            oracle::erf_complex,
            arbitrary::faddeeva::erf_complex,
        ),
        (
            "erfc",
            golden::erfc_complex(),
            oracle::erfc_complex,
            arbitrary::faddeeva::erfc_complex,
        ),
    ];
    for (name, rows, fast, slow) in cases {
        for route in [fast, slow] {
            hold_certified(name, &rows, 400, |z, truth| component_wise(&route(z[0], z[1]), truth));
        }
    }
}

#[test]
fn both_oracles_of_the_erf_difference_give_the_certified_digits() {
    let rows = golden::erf_difference_scaled();
    hold_certified("erf difference", &rows, 400, |r, truth| {
        norm_wise(&oracle::erf_difference_scaled(r[0], r[1], r[2]), truth)
    });
    hold_certified("erf difference, slow", &rows, 400, |r, truth| {
        norm_wise(
            &arbitrary::erf_difference::erf_difference_scaled(r[0], r[1], r[2]),
            truth,
        )
    });
}

#[test]
fn both_oracles_of_the_bessel_functions_give_the_certified_digits() {
    type Real = fn(f64) -> Reference;
    let cases: [(Vec<golden::Row>, Real, Real); 3] = [
        (
            golden::bessel_i0_scaled(),
            oracle::bessel_i0_scaled,
            arbitrary::bessel::bessel_i0_scaled,
        ),
        (
            golden::log_bessel_i0(),
            oracle::log_bessel_i0,
            arbitrary::bessel::log_bessel_i0,
        ),
        (
            golden::bessel_i1_i0_ratio(),
            oracle::bessel_i1_i0_ratio,
            arbitrary::bessel::bessel_i1_i0_ratio,
        ),
    ];
    for (rows, fast, slow) in cases {
        assert!(rows.len() > 250, "{}", rows.len());
        for row in &rows {
            for route in [fast, slow] {
                let value = route(row.inputs[0]);
                assert!(
                    difference(&value, &row.truth) < AGREEMENT,
                    "{:e}: {value:?}, certified {:?}",
                    row.inputs[0],
                    row.truth
                );
            }
        }
    }
}

#[test]
fn w_and_erf_vanish_at_their_tabulated_zeros() {
    // The fast oracle is zero there by construction; the slow one does not know the table.
    for (table, route) in [
        (zeros::W, arbitrary::faddeeva::faddeeva_w as Route),
        (zeros::ERF, arbitrary::faddeeva::erf_complex as Route),
    ] {
        for [re, im] in table {
            for sign in [1.0, -1.0] {
                let value = route(sign * re[0], im[0]).map(|part| part.value().abs());
                // The slope there is of order 1 to 10, and the f64 lies within an ulp of the zero.
                assert!(value[0].max(value[1]) < 1e-14, "{re:?} {im:?}: {value:?}");
                let beside = route(sign * re[0] + 1e-3, im[0]).map(|part| part.value().abs());
                assert!(beside[0].max(beside[1]) > 1e-4, "{re:?} {im:?}: {beside:?}");
            }
        }
    }
}

#[test]
fn the_oracles_keep_the_symmetries_exactly() {
    let negated = |[re, im]: Pair, signs: [bool; 2]| {
        [if signs[0] { -re } else { re }, if signs[1] { -im } else { im }].map(|part| (part.hi, part.lo, part.exponent))
    };
    let domains = [
        complex_points::WHOLE_PLANE,
        complex_points::ZEROS_OF_W,
        complex_points::ZEROS_OF_ERF,
    ];
    let points: Vec<f64> = domains.iter().flat_map(|domain| (domain.rows)(24, 2000)).collect();
    for z in points.chunks(2) {
        let (x, y) = (z[0], z[1]);
        let cases: [(Route, [bool; 2], [bool; 2]); 4] = [
            (oracle::faddeeva_w, [false, true], [false, false]),
            (oracle::faddeeva_w_derivative, [true, false], [false, false]),
            (oracle::erf_complex, [true, false], [false, true]),
            (oracle::erfc_complex, [false, false], [false, true]),
        ];
        for (k, (route, mirrored, conjugated)) in cases.into_iter().enumerate() {
            let value = route(x, y);
            if k < 3 {
                assert_eq!(negated(value, mirrored), negated(route(-x, y), [false; 2]), "{k} {z:?}");
            }
            if k > 1 {
                assert_eq!(
                    negated(value, conjugated),
                    negated(route(x, -y), [false; 2]),
                    "{k} {z:?}"
                );
            }
        }
    }
    for row in (erf_differences::ANY.rows)(24, 3000).chunks(3) {
        let value = oracle::erf_difference_scaled(row[0], row[1], row[2]);
        let swapped = oracle::erf_difference_scaled(row[1], row[0], row[2]);
        let conjugate = oracle::erf_difference_scaled(row[0], row[1], -row[2]);
        assert_eq!(negated(value, [true; 2]), negated(swapped, [false; 2]), "{row:?}");
        assert_eq!(negated(value, [false, true]), negated(conjugate, [false; 2]), "{row:?}");
    }
}

/// Both components as values, for comparison: NaN as a pattern of its own, zeros with their sign.
fn pattern(value: Pair) -> [Option<u64>; 2] {
    value.map(|part| (!part.hi.is_nan()).then_some(part.hi.to_bits()))
}

fn is_nan(value: Pair) -> bool {
    value.iter().all(|part| part.hi.is_nan())
}

#[test]
fn the_oracles_take_their_limits_at_infinity_and_nan_in_either_part_gives_both() {
    let inf = f64::INFINITY;
    let exactly = |re: f64, im: f64| [Some(re.to_bits()), Some(im.to_bits())];
    for y in [0.0, -0.0, 1e-300, -2.0, 3.0, f64::MAX, -f64::MAX] {
        for x in [inf, -inf] {
            let zero = 0f64.copysign(x);
            assert_eq!(pattern(oracle::faddeeva_w(x, y)), exactly(0.0, zero), "{y}");
            assert_eq!(pattern(oracle::faddeeva_w_derivative(x, y)), exactly(0.0, zero), "{y}");
            assert_eq!(pattern(oracle::erf_complex(x, y)), exactly(x.signum(), 0.0), "{y}");
            assert_eq!(
                pattern(oracle::erfc_complex(x, y)),
                exactly(1.0 - x.signum(), 0.0),
                "{y}"
            );
            // No limit: erf and erfc turn as they grow.
            assert!(
                is_nan(oracle::erf_complex(y, x)) && is_nan(oracle::erfc_complex(y, x)),
                "{y}"
            );
        }
        assert_eq!(
            pattern(oracle::faddeeva_w(y, inf)),
            exactly(0.0, 0f64.copysign(y)),
            "{y}"
        );
        assert!(is_nan(oracle::faddeeva_w_derivative(y, -inf)), "{y}");
        assert_eq!(is_nan(oracle::faddeeva_w(y, -inf)), y != 0.0, "{y}");
    }
    for zero in [0.0, -0.0] {
        assert_eq!(pattern(oracle::faddeeva_w(zero, -inf)), exactly(inf, zero));
    }
    for x in [inf, -inf] {
        assert_eq!(pattern(oracle::faddeeva_w(x, inf)), exactly(0.0, 0f64.copysign(x)));
        assert!(is_nan(oracle::faddeeva_w(x, -inf)) && is_nan(oracle::erf_complex(x, inf)));
    }
    assert_eq!(oracle::erfcx(inf).hi.to_bits(), 0);
    assert_eq!(oracle::erfcx(-inf).hi, inf);
    let routes: [Route; 4] = [
        oracle::faddeeva_w,
        oracle::faddeeva_w_derivative,
        oracle::erf_complex,
        oracle::erfc_complex,
    ];
    for route in routes {
        for other in [0.0, 1.5, inf, -inf, f64::NAN] {
            assert!(
                is_nan(route(f64::NAN, other)) && is_nan(route(other, f64::NAN)),
                "{other}"
            );
        }
    }
    for b in [0.0, 1.0, 1e200, inf] {
        let whole = oracle::erf_difference_scaled(-inf, inf, b)[0].value();
        assert!((whole - 2.0 * (-b * b).exp()).abs() <= 4.0 * f64::EPSILON, "{b}");
        for a in [inf, -inf] {
            assert_eq!(pattern(oracle::erf_difference_scaled(a, a, b)), exactly(0.0, 0.0));
        }
    }
    assert!(is_nan(oracle::erf_difference_scaled(f64::NAN, f64::NAN, 1.0)));
}
