//! Every one of the 2^32 f32 inputs of the f32 sine integrals, against Cephes in f64 (3 ulp of f64, 6e-9 ulp of f32)
//! and, below 1e-3, the series.
//!
//! `cargo test -p reference --release --test exhaustive_f32 -- --ignored --nocapture`

use iridescence::{shader, special};
use reference::generate::worst::recorded;
use reference::metrics::{MISMATCH, ulp_error};
use reference::oracle;
use reference::peers::sine_integral_cephes;
use reference::registry::{Call, Metric, Origin, Precision, methods};
use std::thread;

/// What is swept: the function and its promise.
struct Tier {
    name: &'static str,
    si: fn(f32) -> f32,
    /// The slice form, whose bits must be those of `si`; it makes the sweep fast.
    slice: fn(&[f32], &mut [f32]),
    metric: Metric,
    bound: f64,
    /// Ours keep their promise at infinity too; the published fit is 0/0 there.
    ours: bool,
}

/// The bits of infinity, behind those of the largest number.
const INFINITY: u32 = 0x7F80_0000;

/// The largest error found and its input.
type Worst = (f64, f32);

/// Unit in the last place of f32 numbers of the size of `x`, a normal f64.
fn ulp_of(x: f64) -> f64 {
    let exponent = ((x.to_bits() >> 52) & 0x7FF) as i64 - 1023;
    f64::from_bits(((exponent.max(-126) - 23 + 1023) as u64) << 52)
}

/// Si(x) in f64 for x >= 0, pi/2 at infinity: Cephes, and three terms of the series where they hold 1e-22.
fn reference(x: f64) -> f64 {
    if x < 1e-3 {
        let square = x * x;
        return x - x * square * (1.0 / 18.0 - square * (1.0 / 600.0));
    }
    sine_integral_cephes(x)
}

/// Error of one result in the tier's metric; `MISMATCH` where the class is wrong.
fn error(tier: &Tier, result: f32, truth: f64, ulp: f64) -> f64 {
    if !result.is_finite() {
        return MISMATCH;
    }
    let difference = (f64::from(result) - truth).abs();
    if tier.metric == Metric::Ulp {
        difference / ulp
    } else {
        difference
    }
}

/// Inputs swept at a time.
const BLOCK: u32 = 4096;

/// Sweeps the sizes with the bit patterns `first..last`; both signs of each, by slices, and every size by scalars too.
fn sweep(tiers: &[Tier], first: u32, last: u32) -> Vec<Worst> {
    let mut worst = vec![(0.0, 0.0); tiers.len()];
    let mut start = first;
    while start < last {
        let end = last.min(start + BLOCK);
        let x: Vec<f32> = (start..end).map(f32::from_bits).collect();
        let minus: Vec<f32> = x.iter().map(|x| -x).collect();
        let truth: Vec<f64> = x.iter().map(|&x| reference(f64::from(x))).collect();
        let (mut right, mut left) = (vec![0.0; x.len()], vec![0.0; x.len()]);
        for (tier, worst) in tiers.iter().zip(&mut worst) {
            (tier.slice)(&x, &mut right);
            (tier.slice)(&minus, &mut left);
            for (k, &x) in x.iter().enumerate() {
                let (result, mirrored) = (right[k], left[k]);
                assert_eq!(
                    mirrored.to_bits(),
                    result.to_bits() ^ (1 << 31),
                    "{} is not odd at {x:e}",
                    tier.name
                );
                let scalar = (tier.si)(x);
                assert!(
                    scalar.to_bits() == result.to_bits() || (scalar.is_nan() && result.is_nan()),
                    "{}: scalar {scalar:e} and slice {result:e} at {x:e}",
                    tier.name
                );
                if x.is_infinite() && !tier.ours {
                    continue;
                }
                let error = error(tier, result, truth[k], ulp_of(truth[k]));
                if error > worst.0 {
                    *worst = (error, x);
                }
            }
        }
        start = end;
    }
    worst
}

/// The scalar f32 methods of the sine integral that are ours or published.
fn tiers() -> Vec<Tier> {
    let own = methods().iter().filter(|m| m.function == "sine_integral");
    let slice = |method: &str| {
        methods().iter().find_map(|m| match m.call {
            Call::F32Slice(slice) if m.function == "sine_integral" && m.method == method => Some(slice),
            _ => None,
        })
    };
    own.filter_map(|m| match (m.call, m.budget) {
        (Call::F32(si), Some(budget)) => Some(Tier {
            name: m.method,
            si,
            slice: slice(m.method).expect("every f32 tier has a slice form"),
            metric: budget.metric,
            bound: budget.bound,
            ours: m.origin == Origin::Ours,
        }),
        _ => None,
    })
    .collect()
}

#[test]
#[ignore = "2^32 inputs: some minutes, in release only"]
fn the_f32_sine_integrals_keep_their_promise_on_every_input() {
    let tiers = tiers();
    assert!(
        tiers
            .iter()
            .any(|t| t.name == "accurate" && t.metric == Metric::Ulp && t.bound <= 2.0)
    );
    let threads = thread::available_parallelism().map_or(2, usize::from) as u32;
    // Small pieces taken in turn, since small arguments cost less than large ones. Infinity is the last input.
    let pieces = 256 * threads;
    let piece = |i: u32| (u64::from(INFINITY) + 1) * u64::from(i) / u64::from(pieces);
    let parts: Vec<Vec<Worst>> = thread::scope(|scope| {
        let tiers = &tiers;
        let handles: Vec<_> = (0..threads)
            .map(|t| {
                scope.spawn(move || {
                    let taken = (t..pieces).step_by(threads as usize);
                    taken
                        .map(|i| sweep(tiers, piece(i) as u32, piece(i + 1) as u32))
                        .collect::<Vec<_>>()
                })
            })
            .collect();
        handles
            .into_iter()
            .flat_map(|h| h.join().expect("a sweep found a broken symmetry"))
            .collect()
    });
    for tier in &tiers {
        for bits in INFINITY + 1..=0x7FFF_FFFF {
            let nan = f32::from_bits(bits);
            assert!(
                (tier.si)(nan).is_nan() && (tier.si)(-nan).is_nan(),
                "{}: {bits:#x} is NaN",
                tier.name
            );
        }
    }
    for (i, tier) in tiers.iter().enumerate() {
        let (largest, x) = parts
            .iter()
            .map(|part| part[i])
            .fold((0.0, 0.0), |a, b| if b.0 > a.0 { b } else { a });
        let sharp = ulp_error(
            f64::from((tier.si)(x)),
            &oracle::sine_integral(f64::from(x)),
            Precision::F32,
        );
        println!(
            "{}: {largest:.4e} {:?} at {x:e} ({:#010x}), {sharp:.4} ulp by the oracle",
            tier.name,
            tier.metric,
            x.to_bits()
        );
        // The ledger says "exhaustive" of these rows: its points begin with the worst input of the sweep.
        assert!(
            recorded(1).iter().any(|row| row[0].abs() == f64::from(x)),
            "{}: append {x:e} to data/worst/sine_integral.csv",
            tier.name
        );
        assert!(
            largest <= tier.bound,
            "{}: {largest} {:?} at {x:e}, promised {}",
            tier.name,
            tier.metric,
            tier.bound
        );
    }
}

#[test]
fn the_sweep_sees_a_single_wrong_input() {
    fn off_at_one(x: f32) -> f32 {
        let si = sine_integral_cephes(f64::from(x)) as f32;
        if x.abs() == 1.0 {
            (si * 1.000_001).copysign(x)
        } else {
            si.copysign(x)
        }
    }
    let tier = Tier {
        name: "off",
        si: off_at_one,
        slice: |x, out| x.iter().zip(out).for_each(|(x, out)| *out = off_at_one(*x)),
        metric: Metric::Ulp,
        bound: 2.0,
        ours: true,
    };
    let one = 1f32.to_bits();
    let worst = sweep(&[tier], one - 1000, one + 1000)[0];
    assert!(worst.1 == 1.0 && worst.0 > 10.0, "{worst:?}");
    assert_eq!(ulp_of(1.0), f64::from(f32::EPSILON));
    assert_eq!(ulp_of(1e-44), 2f64.powi(-149));
}

/// A Bessel function in f32 and its f64 form, which tests/bessel.rs holds to its oracle, both over slices, and its
/// promise in units of the last place.
struct Bessel {
    name: &'static str,
    single: fn(&[f32], &mut [f32]),
    double: fn(&[f32], &mut [f64]),
    odd: bool,
    bound: f64,
}

const BESSEL: [Bessel; 3] = [
    Bessel {
        name: "bessel_i0_scaled",
        single: |x, out| each(x, out, shader::bessel_i0_scaled),
        double: |x, out| each(x, out, |x| special::bessel_i0_scaled(f64::from(x))),
        odd: false,
        bound: 1.0,
    },
    Bessel {
        name: "log_bessel_izero",
        single: |x, out| each(x, out, shader::log_bessel_izero),
        double: |x, out| each(x, out, |x| special::log_bessel_i0(f64::from(x))),
        odd: false,
        bound: 2.0,
    },
    Bessel {
        name: "bessel_ratio",
        single: |x, out| each(x, out, shader::bessel_ratio),
        double: |x, out| each(x, out, |x| special::bessel_i1_i0_ratio(f64::from(x))),
        odd: true,
        bound: 2.0,
    },
];

/// Writes a function of each `x`; a loop that the compiler can vectorise.
fn each<T>(x: &[f32], out: &mut [T], function: impl Fn(f32) -> T) {
    for (out, &x) in out.iter_mut().zip(x) {
        *out = function(x);
    }
}

/// Sweeps the sizes with the bit patterns `first..last`, both signs of each.
fn sweep_bessel(function: &Bessel, first: u32, last: u32) -> Worst {
    let sign = u32::from(function.odd) << 31;
    let mut worst = (0.0, 0.0);
    let mut start = first;
    while start < last {
        let end = last.min(start + BLOCK);
        let x: Vec<f32> = (start..end).map(f32::from_bits).collect();
        let minus: Vec<f32> = x.iter().map(|x| -x).collect();
        let (mut values, mut mirrored, mut truths) = (vec![0.0; x.len()], vec![0.0; x.len()], vec![0.0; x.len()]);
        (function.single)(&x, &mut values);
        (function.single)(&minus, &mut mirrored);
        (function.double)(&x, &mut truths);
        for (k, &x) in x.iter().enumerate() {
            let (value, truth) = (values[k], truths[k]);
            assert_eq!(
                mirrored[k].to_bits(),
                value.to_bits() ^ sign,
                "{} of {x:e}: symmetry",
                function.name
            );
            let error = if truth.is_finite() && value.is_finite() {
                (f64::from(value) - truth).abs() / ulp_of(truth)
            } else if f64::from(value) == truth {
                0.0
            } else {
                MISMATCH
            };
            if error > worst.0 {
                worst = (error, x);
            }
        }
        start = end;
    }
    worst
}

#[test]
#[ignore = "2^32 inputs: some minutes, in release only"]
fn the_f32_bessel_functions_keep_their_promise_on_every_input() {
    let threads = thread::available_parallelism().map_or(2, usize::from) as u32;
    let pieces = 64 * threads;
    let piece = |i: u32| ((u64::from(INFINITY) + 1) * u64::from(i) / u64::from(pieces)) as u32;
    for function in &BESSEL {
        let one = |t: u32| {
            let taken = (t..pieces).step_by(threads as usize);
            taken
                .map(|i| sweep_bessel(function, piece(i), piece(i + 1)))
                .collect::<Vec<_>>()
        };
        let parts: Vec<Worst> = thread::scope(|scope| {
            let one = &one;
            let handles: Vec<_> = (0..threads).map(|t| scope.spawn(move || one(t))).collect();
            let joined = handles
                .into_iter()
                .map(|h| h.join().expect("a sweep found a broken symmetry"));
            joined.flatten().collect()
        });
        let (largest, x) = parts.into_iter().fold((0.0, 0.0), |a, b| if b.0 > a.0 { b } else { a });
        println!("{}: {largest:.4} ulp at {x:e} ({:#010x})", function.name, x.to_bits());
        let nan: Vec<f32> = (INFINITY + 1..=0x7FFF_FFFF).step_by(101).map(f32::from_bits).collect();
        let mut values = vec![0.0; nan.len()];
        (function.single)(&nan, &mut values);
        assert!(values.iter().all(|value| value.is_nan()), "{}", function.name);
        assert!(
            largest <= function.bound && function.bound <= 4.0 * largest,
            "{}: {largest} ulp at {x:e}, promised {}",
            function.name,
            function.bound
        );
    }
}

#[test]
fn the_sweep_of_bessel_functions_sees_a_single_wrong_input() {
    fn off_at_one(x: f32) -> f32 {
        let value = shader::bessel_i0_scaled(x);
        if x.abs() == 1.0 { value * 1.000_001 } else { value }
    }
    let function = Bessel {
        single: |x, out| each(x, out, off_at_one),
        ..BESSEL[0]
    };
    let one = 1f32.to_bits();
    let worst = sweep_bessel(&function, one - 1000, one + 1000);
    assert!(worst.1 == 1.0 && worst.0 > 10.0, "{worst:?}");
}
