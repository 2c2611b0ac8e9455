//! The f32 Faddeeva function and scaled erf difference: bounds over their domains, limits, symmetries, slices.
#![cfg(all(feature = "shader", feature = "simd"))]

use iridescence::shader::{self, erf_difference_scaled, erf_difference_scaled_turns, faddeeva_w, faddeeva_w_coarse};
use reference::generate::random::{Random, neighbour_f32};
use reference::generate::{complex_points as points, erf_differences};
use reference::metrics::complex::{absolute_error, eps_error, relative_error};
use reference::oracle;
use reference::registry::Precision::F32;
use std::f64::consts::{FRAC_2_SQRT_PI, PI};

type Plane = fn(f32, f32) -> shader::Complex;
const TIERS: [(&str, Plane); 2] = [("accurate", faddeeva_w), ("coarse", faddeeva_w_coarse)];

fn wide(z: shader::Complex) -> [f64; 2] {
    [f64::from(z.re), f64::from(z.im)]
}

fn bits(z: shader::Complex) -> [u32; 2] {
    // No operation promises the bits of a NaN.
    [z.re, z.im].map(|x| if x.is_nan() { u32::MAX } else { x.to_bits() })
}

#[test]
fn w_holds_4_eps_in_the_upper_half_plane_and_the_coarse_tier_5e_5() {
    let mut rows = (points::UPPER_HALF_PLANE_F32.rows)(31, 20_000);
    // Either side of the circle where the two fits meet, and the real axis beside it.
    let mut random = Random::new(32);
    for _ in 0..4_000 {
        let size = 2.0 + random.uniform(-1e-5, 1e-5);
        let (sine, cosine) = random.uniform(0.0, PI).sin_cos();
        rows.extend([size * cosine, size * sine]);
        let y = random.log_uniform(1e-12, 1.0);
        rows.extend([random.uniform(-9.0, 9.0), y]);
    }
    let mut lowest = 0.0f64;
    for row in rows.chunks_exact(2) {
        let (x, y) = (row[0] as f32, row[1] as f32);
        let truth = oracle::faddeeva_w(f64::from(x), f64::from(y));
        let ours = wide(faddeeva_w(x, y));
        let error = eps_error(ours, &truth, F32);
        assert!(error <= 4.0, "{x:e} {y:e}: {error}");
        let error = relative_error(wide(faddeeva_w_coarse(x, y)), &truth, F32);
        assert!(error <= 5e-5, "coarse {x:e} {y:e}: {error:e}");
        if ours[0] < 0.0 {
            lowest = lowest.max(-ours[0] / ours[0].hypot(ours[1]));
        }
    }
    // The real part of w is positive: what is negative is rounding.
    assert!(lowest <= 4.0 * f64::from(f32::EPSILON), "{lowest:e}");
}

#[test]
fn below_the_real_axis_the_error_counts_against_the_two_terms() {
    let mut random = Random::new(33);
    let mut rows = Vec::new();
    for _ in 0..6_000 {
        let (x, y) = (random.uniform(-9.0, 9.0), random.uniform(-9.0, 0.0));
        rows.push((x, y, 8.0));
        // Along the diagonal, where neither term wins, out to the last phases that count.
        let size = random.log_uniform(1e-3, 100.0);
        let depth = (size * size + random.uniform(-20.0, 85.0)).max(1e-6).sqrt();
        rows.push((random.signed(size), -depth, 32.0));
    }
    for (x, y, allowed) in rows {
        let (x, y) = (neighbour_f32(x, 0), neighbour_f32(y, 0));
        if y >= 0.0 || (y - x) * (y + x) > 85.0 {
            continue;
        }
        let truth = oracle::faddeeva_w(x, y);
        let terms = 2.0 * ((y - x) * (y + x)).exp()
            + oracle::faddeeva_w(-x, -y)
                .map(|t| t.hi)
                .iter()
                .fold(0.0, |s, t| f64::hypot(s, *t));
        let error = absolute_error(wide(faddeeva_w(x as f32, y as f32)), &truth) / terms;
        assert!(error <= allowed * f64::from(f32::EPSILON), "{x:e} {y:e}: {error:e}");
        let error = absolute_error(wide(faddeeva_w_coarse(x as f32, y as f32)), &truth) / terms;
        assert!(error <= 5e-5, "coarse {x:e} {y:e}: {error:e}");
    }
}

#[test]
fn w_keeps_its_symmetry_exactly_and_stays_finite_above_the_axis() {
    let mut random = Random::new(34);
    for _ in 0..200_000 {
        let (x, y) = (
            f32::from_bits(random.bits() as u32),
            f32::from_bits(random.bits() as u32),
        );
        if !x.is_finite() || !y.is_finite() {
            continue;
        }
        for (name, w) in TIERS {
            let (right, left) = (w(x, y), w(-x, y));
            assert_eq!(
                bits(right),
                bits(shader::Complex { im: -left.im, ..left }),
                "{name} {x:e} {y:e}"
            );
            let above = w(x, y.abs());
            assert!(
                above.re.is_finite() && above.im.is_finite(),
                "{name} {x:e} {y:e}: {above:?}"
            );
            assert!(above.re.hypot(above.im) <= 1.000_1, "{name} {x:e} {y:e}: {above:?}");
        }
    }
    for (name, w) in TIERS {
        let one = w(0.0, 0.0);
        assert!(
            (one.re - 1.0).abs() <= if name == "coarse" { 5e-5 } else { 1.2e-7 },
            "{name}: {one:?}"
        );
        assert_eq!(one.im.to_bits(), 0, "{name}");
        assert_eq!(w(0.0, 3.0).im.to_bits(), 0, "{name}");
    }
}

#[test]
fn w_has_its_limits_at_infinity_and_nan_gives_nan() {
    let inf = f32::INFINITY;
    for (name, w) in TIERS {
        for row in points::non_finite() {
            let (x, y) = (row[0] as f32, row[1] as f32);
            let value = w(x, y);
            if x.is_nan() || y.is_nan() {
                assert!(value.re.is_nan() && value.im.is_nan(), "{name} {x} {y}: {value:?}");
            } else if (x.is_infinite() || y.is_infinite()) && y > -inf {
                assert_eq!((value.re, value.im), (0.0, 0.0), "{name} {x} {y}");
                assert_eq!(value.im.is_sign_negative(), x.is_sign_negative(), "{name} {x} {y}");
            } else if y == -inf && x == 0.0 {
                assert_eq!((value.re, value.im), (inf, 0.0), "{name} {x} {y}");
            } else if y == -inf {
                assert!(value.re.is_nan() && value.im.is_nan(), "{name} {x} {y}: {value:?}");
            }
        }
        // Beyond the range of f32 straight down, and 0 of the exponential beside it.
        assert_eq!(w(0.0, -20.0).re, inf, "{name}");
        assert_eq!(
            (w(3e38, -1e38).re, w(3e38, -1e38).im),
            (-w(3e38, 1e38).re, w(3e38, 1e38).im),
            "{name}"
        );
    }
}

/// |G| at b = 0, the largest of all b, to six digits.
fn peak(a: f64, c: f64) -> f64 {
    let (lo, hi) = (a.min(c), a.max(c));
    let (length, middle) = (hi - lo, 0.5 * (lo + hi));
    if length * middle.abs().max(1.0) < 1e-3 {
        FRAC_2_SQRT_PI * length * (-middle * middle).exp()
    } else {
        oracle::erf_difference_scaled(a, c, 0.0)[0].hi.abs()
    }
}

/// a b/pi less whole turns.
fn turns(a: f32, b: f32) -> f32 {
    let turns = f64::from(a) * f64::from(b) / PI;
    (turns - turns.round()) as f32
}

/// Rows of scenes, of short segments, and of segments beside the border of the two forms.
fn segments() -> Vec<[f32; 3]> {
    let mut rows = (erf_differences::SCRATCH_F32.rows)(35, 4_000);
    rows.extend((erf_differences::SHORT.rows)(36, 4_000));
    let mut random = Random::new(37);
    for _ in 0..4_000 {
        let a = random.uniform(-8.0, 8.0);
        let length = random.log_uniform(1e-4, 1.2);
        // length |middle + i b| about 1/2.
        let b = 0.5 / length * random.uniform(0.9, 1.1);
        rows.extend([a, a + length, random.signed(b)]);
    }
    rows.as_chunks::<3>()
        .0
        .iter()
        .map(|row| row.map(|x| x as f32))
        .collect()
}

#[test]
fn the_erf_difference_holds_1e_5_of_its_peak_with_its_phases_given_or_formed() {
    let mut checked = 0;
    for [a, c, b] in segments() {
        let peak = peak(f64::from(a), f64::from(c));
        if !(peak > 1e-37 && (a * b).abs() < 1e4 && (c * b).abs() < 1e4) {
            continue;
        }
        let truth = oracle::erf_difference_scaled(f64::from(a), f64::from(c), f64::from(b));
        for (name, value) in [
            ("formed", erf_difference_scaled(a, c, b)),
            ("given", erf_difference_scaled_turns(a, c, b, turns(a, b), turns(c, b))),
        ] {
            let error = absolute_error(wide(value), &truth) / peak;
            assert!(error <= 2e-6, "{name} {a:e} {c:e} {b:e}: {error:e}");
        }
        checked += 1;
    }
    assert!(checked > 8_000, "{checked}");
}

#[test]
fn phases_given_in_turns_lose_nothing_to_their_size() {
    let mut random = Random::new(38);
    for _ in 0..2_000 {
        let (a, c) = (random.uniform(-3.0, 3.0) as f32, random.uniform(-3.0, 3.0) as f32);
        let b = random.uniform(1e5, 1e6) as f32;
        let truth = oracle::erf_difference_scaled(f64::from(a), f64::from(c), f64::from(b));
        let value = erf_difference_scaled_turns(a, c, b, turns(a, b), turns(c, b));
        let error = eps_error(wide(value), &truth, F32);
        let ends = (-f64::from(a).powi(2)).exp() + (-f64::from(c).powi(2)).exp();
        let size = f64::hypot(truth[0].hi, truth[1].hi) * f64::from(b) * PI.sqrt();
        assert!(error <= 16.0 * ends / size, "{a:e} {c:e} {b:e}: {error}");
    }
}

#[test]
fn the_erf_difference_keeps_its_symmetries_exactly() {
    let conjugate = |z: shader::Complex| shader::Complex { im: -z.im, ..z };
    let negative = |z: shader::Complex| shader::Complex { re: -z.re, im: -z.im };
    let same = |x: shader::Complex, y: shader::Complex| x.re == y.re && x.im == y.im;
    for [a, c, b] in segments() {
        let value = erf_difference_scaled(a, c, b);
        assert!(
            value.re.is_finite() && value.im.is_finite(),
            "{a:e} {c:e} {b:e}: {value:?}"
        );
        assert!(
            same(erf_difference_scaled(a, c, -b), conjugate(value)),
            "{a:e} {c:e} {b:e}"
        );
        assert!(
            same(erf_difference_scaled(-c, -a, b), conjugate(value)),
            "{a:e} {c:e} {b:e}"
        );
        if a != c {
            assert!(
                same(erf_difference_scaled(c, a, b), negative(value)),
                "{a:e} {c:e} {b:e}"
            );
        }
        assert_eq!(bits(erf_difference_scaled(a, a, b)), [0, 0], "{a:e} {b:e}");
        assert_eq!(erf_difference_scaled(-a, a, b).im, 0.0, "{a:e} {b:e}");
    }
    let mut random = Random::new(41);
    for _ in 0..10_000 {
        let a = random.log_uniform(1e-4, 0.5);
        let b = random.uniform(0.0, 0.25) / a;
        let (a, b) = (a as f32, b as f32);
        assert_eq!(erf_difference_scaled(-a, a, b).im, 0.0, "{a:e} {b:e}");
    }
}

#[test]
fn the_erf_difference_has_its_limits_and_nan_gives_nan() {
    let finite = |row: &[f64; 3]| row.iter().all(|x| !x.is_finite() || x.abs() < 3e38);
    for row in erf_differences::non_finite().into_iter().filter(finite) {
        let [a, c, b] = row.map(|x| x as f32);
        let value = erf_difference_scaled(a, c, b);
        if row.iter().any(|x| x.is_nan()) {
            assert!(value.re.is_nan() && value.im.is_nan(), "{row:?}: {value:?}");
            continue;
        }
        let truth = if b.is_infinite() {
            [0.0; 2].map(reference::metrics::Reference::exact)
        } else {
            oracle::erf_difference_scaled(f64::from(a), f64::from(c), f64::from(b))
        };
        let error = absolute_error(wide(value), &truth);
        assert!(error <= 2e-6, "{row:?}: {value:?}, {error:e}");
    }
    let equal = erf_difference_scaled(1.0, 1.0, f32::NAN);
    assert!(equal.re.is_nan() && equal.im.is_nan());
    // Any finite row: large, subnormal, equal ends.
    let mut random = Random::new(39);
    for _ in 0..200_000 {
        let [a, c, b] = [0; 3].map(|_| f32::from_bits(random.bits() as u32));
        if a.is_finite() && c.is_finite() && b.is_finite() {
            let value = erf_difference_scaled(a, c, b);
            assert!(value.re.hypot(value.im) <= 2.000_1, "{a:e} {c:e} {b:e}: {value:?}");
        }
    }
}
