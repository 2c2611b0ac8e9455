//! The f32 kernels: sine, cosine, exponential, the arc in turns; limits and symmetries of all.
#![cfg(feature = "shader")]

use iridescence::shader::{self, exponential, sine_cosine, sine_cosine_turns};
use reference::generate::random::{Random, neighbour_f32};
use reference::generate::{arcs, points};
use reference::measure::{Accuracy, accuracy_on};
use reference::metrics::{relative_error, ulp_error};
use reference::oracle;
use reference::registry::Precision::F32;
use reference::registry::{Call, Method, methods};
use std::f64::consts::TAU;

type Arc = fn(f32, f32) -> f32;
const ARCS: [(&str, Arc); 3] = [
    ("accurate", shader::sinc_squared_integral),
    ("medium", shader::sinc_squared_integral_medium),
    ("coarse", shader::sinc_squared_integral_coarse),
];

#[test]
fn sine_and_cosine_hold_to_ten_thousand_radians() {
    // Every f32 of the last octave, where the reduction has the most to lose, and a sample below.
    let dense = 8192f32.to_bits()..=1e4f32.to_bits();
    let sparse = (1e-6f32.to_bits()..8192f32.to_bits()).step_by(101);
    for x in dense.chain(sparse).map(f32::from_bits) {
        let near = sine_cosine(x);
        let (sine, cosine) = f64::from(x).sin_cos();
        assert!((f64::from(near.sine) - sine).abs() <= 2e-7, "sine {x:e}");
        assert!((f64::from(near.cosine) - cosine).abs() <= 2.5e-7, "cosine {x:e}");
        let mirrored = sine_cosine(-x);
        assert_eq!((mirrored.sine, mirrored.cosine), (-near.sine, near.cosine), "{x:e}");
    }
    assert_eq!((sine_cosine(0.0).sine, sine_cosine(0.0).cosine), (0.0, 1.0));
    assert!(sine_cosine(f32::NAN).sine.is_nan() && sine_cosine(f32::NAN).cosine.is_nan());
}

#[test]
fn a_phase_in_turns_loses_nothing_to_its_size() {
    let mut random = Random::new(1);
    for _ in 0..400_000 {
        let size = random.log_uniform(1e-6, 1e9);
        let turns = random.signed(size) as f32;
        let near = sine_cosine_turns(turns);
        let (sine, cosine) = (TAU * f64::from(turns).fract()).sin_cos();
        assert!((f64::from(near.sine) - sine).abs() <= 3e-7, "sine {turns:e}");
        assert!((f64::from(near.cosine) - cosine).abs() <= 3e-7, "cosine {turns:e}");
    }
    for whole in [0.0, 1.0, -3.0, 8388607.0, 16777216.0, 1.5e38] {
        let near = sine_cosine_turns(whole);
        assert_eq!((near.sine, near.cosine), (0.0, 1.0), "{whole:e}");
    }
    for quarter in [0.5, 1001.5, -4194302.5] {
        assert_eq!(sine_cosine_turns(quarter).cosine, -1.0, "{quarter:e}");
    }
    assert!(sine_cosine_turns(f32::NAN).sine.is_nan());
}

#[test]
fn the_exponential_keeps_2_units_over_its_range_and_saturates_beyond() {
    let mut checked = 0u32;
    let positive = 1e-8f32.to_bits()..=88.7f32.to_bits();
    let negative = (-1e-8f32).to_bits()..=(-87f32).to_bits();
    for bits in positive.chain(negative).step_by(97) {
        let x = f32::from_bits(bits);
        let truth = f64::from(x).exp();
        let unit = f64::from_bits(truth.to_bits() & 0x7FF0_0000_0000_0000) * f64::from(f32::EPSILON);
        let error = (f64::from(exponential(x)) - truth).abs() / unit;
        assert!(error <= 2.0, "{x:e}: {error}");
        checked += 1;
    }
    assert!(checked > 4_000_000);
    for x in (points::EXPONENTS_F32.rows)(2, 20_000) {
        let error = ulp_error(f64::from(exponential(x as f32)), &oracle::exponential(x), F32);
        assert!(error <= 2.0, "{x:e}: {error}");
    }
    assert_eq!(exponential(0.0), 1.0);
    assert_eq!(exponential(f32::NEG_INFINITY), 0.0);
    assert_eq!(exponential(-1e30), 0.0);
    assert_eq!(exponential(f32::INFINITY), exponential(88.7));
    assert!(exponential(88.7) > 3.3e38 && exponential(88.7).is_finite());
    assert!(exponential(-90.0) > 0.0 && exponential(-90.0) < f32::MIN_POSITIVE);
    assert!(exponential(f32::NAN).is_nan());
}

#[test]
fn the_arcs_keep_their_limits_and_symmetries_exactly() {
    let mut rows = (arcs::SCRATCH_F32.rows)(3, 40_000);
    // Far beyond the scratch range, where no phase is left: the arcs stay positive all the same.
    let mut random = Random::new(3);
    for _ in 0..40_000 {
        let start = random.log_uniform(1e3, 1e30);
        let length = random.log_uniform(1e-7, 10.0);
        rows.extend([start, start * (1.0 + length)].map(|q| neighbour_f32(q, 0)));
    }
    // The smallest numbers there are, from 0 and from each other.
    for bits in 0..40u32 {
        rows.extend([f32::from_bits(bits), f32::from_bits(bits * 3 + 1)].map(f64::from));
        rows.extend([0.0, f32::from_bits(1 << (bits % 31)).min(1e38)].map(f64::from));
    }
    let inf = f32::INFINITY;
    for (name, arc) in ARCS {
        for q in rows.chunks_exact(2) {
            let (a, b) = (q[0] as f32, q[1] as f32);
            let value = arc(a, b);
            assert!(
                if a <= b { value >= 0.0 } else { value <= 0.0 },
                "{name} {a:e} {b:e}: {value:e}"
            );
            if a != b {
                assert_eq!(arc(b, a).to_bits(), (-value).to_bits(), "{name} {a:e} {b:e}");
            }
            assert_eq!(arc(-b, -a), value, "{name} {a:e} {b:e}");
            assert_eq!(arc(a, a).to_bits(), 0, "{name} {a:e}");
        }
        for q in [0.0, 1e-30, 1.0, 40.0, 1e6, 1e38, inf, -inf, -2.0] {
            assert!(arc(f32::NAN, q).is_nan() && arc(q, f32::NAN).is_nan(), "{name} {q:e}");
            assert_eq!(arc(q, q).to_bits(), 0, "{name} {q:e}");
            if q.abs() < inf {
                for [a, b] in [[q, inf], [-inf, q], [-inf, inf], [inf, q]] {
                    let truth = oracle::sinc_squared_integral(f64::from(a), f64::from(b));
                    let error = relative_error(f64::from(arc(a, b)), &truth, F32);
                    assert!(error <= 4e-4, "{name} {a:e} {b:e}: {error:e}");
                }
            }
        }
        assert!(
            (arc(-inf, inf) - std::f32::consts::PI).abs() <= 2.0 * f32::EPSILON,
            "{name}"
        );
    }
}

/// The registered arc in turns, or another way to compute it.
fn turns(call: fn([f32; 3]) -> f32) -> Method {
    let registered = methods().iter().find(|m| m.function == "sinc_squared_integral_turns");
    let m = registered.expect("registered");
    Method {
        call: Call::row(call),
        regions: m.regions.clone(),
        ..*m
    }
}

/// Accuracy over scratches of one width and arcs that begin at |xi| of 1 to 2.
fn accuracy_of_width(method: &Method, width: f64) -> Accuracy {
    let mut random = Random::new(width.to_bits());
    let width = neighbour_f32(width, 0);
    let rows: Vec<f64> = (0..20_000)
        .flat_map(|_| {
            let size = random.uniform(1.0, 2.0);
            let xi0 = neighbour_f32(random.signed(size), 0);
            let xi1 = neighbour_f32((xi0 + random.log_uniform(1e-3, 0.3)).min(2.0), 0);
            [width, xi0, xi1]
        })
        .collect();
    accuracy_on(method, &rows)
}

#[test]
fn the_error_of_the_arc_in_turns_does_not_grow_with_the_phase() {
    let ours = turns(|[width, xi0, xi1]| shader::sinc_squared_integral_turns(width, xi0, xi1));
    let naive = turns(|[width, xi0, xi1]| {
        let scale = std::f32::consts::PI * width;
        shader::sinc_squared_integral(scale * xi0, scale * xi1)
    });
    for width in [1.371, 4.817, 17.29, 63.71, 254.93] {
        let error = accuracy_of_width(&ours, width).p999_rel;
        assert!(error <= 2e-6, "W/lambda {width}: {error:e}");
    }
    let (reduced, rounded) = (
        accuracy_of_width(&ours, 254.93).p999_rel,
        accuracy_of_width(&naive, 254.93).p999_rel,
    );
    println!("p99.9 at W/lambda 254.93: {reduced:e} in turns, {rounded:e} where q is formed in f32");
    assert!(rounded > 20.0 * reduced, "{rounded:e} {reduced:e}");
}

#[test]
fn the_arc_in_turns_keeps_its_symmetries_and_is_never_negative() {
    for row in (arcs::SCRATCH_TURNS_F32.rows)(4, 60_000).chunks_exact(3) {
        let [width, a, b] = [row[0] as f32, row[1] as f32, row[2] as f32];
        let arc = shader::sinc_squared_integral_turns;
        let value = arc(width, a, b);
        assert!(if a <= b { value >= 0.0 } else { value <= 0.0 }, "{row:?}: {value:e}");
        assert_eq!(arc(width, a, a).to_bits(), 0, "{row:?}");
        if a != b {
            assert_eq!(arc(width, b, a), -value, "{row:?}");
        }
        assert_eq!(arc(width, -b, -a), value, "{row:?}");
        assert!(arc(f32::NAN, a, b).is_nan() || a == b, "{row:?}");
        assert!(
            arc(width, f32::NAN, b).is_nan() && arc(width, a, f32::NAN).is_nan(),
            "{row:?}"
        );
    }
}

#[test]
fn an_arc_from_zero_is_its_length_where_the_lobe_is_flat() {
    for bits in (1..0x3000_0000u32).step_by(9_973) {
        let q = f32::from_bits(bits);
        for (name, arc) in ARCS {
            assert_eq!(arc(0.0, q), q, "{name} {q:e}");
        }
    }
}

#[test]
fn a_scratch_of_no_width_sends_nothing() {
    let turns = shader::sinc_squared_integral_turns;
    for [first, last] in [[0.1, 0.2], [0.0, 1.0], [-1.0, 1.0], [-2.0, -1.0]] {
        assert_eq!(turns(0.0, first, last), 0.0);
        for width in [f32::from_bits(1), 1e-38, 1e-30, 1e-20] {
            let length = std::f32::consts::PI * width * (last - first);
            let value = turns(width, first, last);
            let slack = 4e-7 * length + 4.0 * f32::from_bits(1);
            assert!((value - length).abs() <= slack, "{width:e} {first} {last}: {value:e}");
        }
    }
    assert_eq!(
        turns(2.0, 0.0, f32::from_bits(1)),
        2.0 * std::f32::consts::PI * f32::from_bits(1)
    );
}

#[test]
fn far_arcs_keep_their_size_to_the_end_of_the_range() {
    for [a, b] in [
        [1e30f32, 1.1e30],
        [9e29, 2e30],
        [1e36, 2.5e37],
        [2.078_157_4e31, 2.078_158e31],
    ] {
        let truth = oracle::sinc_squared_integral(f64::from(a), f64::from(b));
        for (name, arc) in ARCS {
            let error = relative_error(f64::from(arc(a, b)), &truth, F32);
            assert!(error <= 1e-5, "{name} {a:e} {b:e}: {error:e}");
        }
    }
}

#[test]
fn sine_and_cosine_stay_within_one_for_any_number() {
    for bits in (0..0x7F80_0000u32).step_by(4_099) {
        let x = f32::from_bits(bits);
        let both = shader::sine_cosine(x);
        assert!(both.sine.abs() <= 1.0 && both.cosine.abs() <= 1.0, "{x:e}: {both:?}");
    }
    for zero in [0.0f32, -0.0] {
        assert_eq!(shader::sine_cosine(zero).sine.to_bits(), zero.to_bits());
    }
}

#[test]
fn the_published_fit_turns_arcs_negative_where_ours_never_does() {
    let mut random = Random::new(5);
    let count = 50_000;
    let mut negative = 0;
    for _ in 0..count {
        let start = random.uniform(1.0, 500.0);
        let (a, b) = (start as f32, (start + random.log_uniform(1e-2, 3.0)) as f32);
        negative += u32::from(shader::sinc_squared_integral_velinov(a, b) < 0.0);
        for (name, arc) in ARCS {
            assert!(arc(a, b) >= 0.0, "{name} {a} {b}");
        }
    }
    let share = f64::from(negative) / f64::from(count);
    println!("the published fit makes {:.1} % of these arcs negative", 100.0 * share);
    assert!((0.1..0.4).contains(&share), "{share}");
}
