//! A criterion group for one function: all its methods from the registry, on the inputs of all timings.

use criterion::{BenchmarkGroup, Criterion, SamplingMode, Throughput, measurement::WallTime};
use reference::generate::timing::{ROWS, rows};
use reference::registry::{Call, Precision, methods};
use std::hint::black_box;
use std::time::Duration;

/// Benches every method of a function. Flat sampling and many short samples: see the module that calls this.
pub fn bench(function: &str) {
    let mut criterion = Criterion::default()
        .warm_up_time(Duration::from_millis(50))
        .measurement_time(Duration::from_millis(100))
        .sample_size(400)
        .without_plots()
        .configure_from_args();
    let mut group = criterion.benchmark_group(function);
    group
        .sampling_mode(SamplingMode::Flat)
        .throughput(Throughput::Elements(ROWS as u64));
    for m in methods().iter().filter(|m| m.function == function) {
        let precision = if m.precision == Precision::F64 { "f64" } else { "f32" };
        let form = if m.call.is_slice() { " slice" } else { "" };
        add(
            &mut group,
            &format!("{} {precision}{form}", m.method),
            &m.call,
            &rows(&m.domain),
        );
    }
    group.finish();
    criterion.final_summary();
}

fn add(group: &mut BenchmarkGroup<WallTime>, name: &str, call: &Call, rows: &[f64]) {
    let pairs: Vec<[f64; 2]> = rows.chunks_exact(2).map(|r| [r[0], r[1]]).collect();
    let single: Vec<f32> = rows.iter().map(|&x| x as f32).collect();
    let single_pairs: Vec<[f32; 2]> = pairs.iter().map(|q| q.map(|x| x as f32)).collect();
    match *call {
        Call::F64(f) => each(group, name, rows, f),
        Call::F64Pair(f) => each(group, name, &pairs, f),
        Call::F32(f) => each(group, name, &single, f),
        Call::F32Pair(f) => each(group, name, &single_pairs, move |[a, b]| f(a, b)),
        Call::F32Triple(f) => each(group, name, single.as_chunks::<3>().0, move |[a, b, c]| f(a, b, c)),
        Call::F64Slice(f) => whole(group, name, rows, f),
        Call::F64PairSlice(f) => whole(group, name, &pairs, f),
        Call::F32Slice(f) => whole(group, name, &single, f),
        Call::F32PairSlice(f) => whole(group, name, &single_pairs, f),
    }
}

fn each<X: Copy, Y: Copy + Default>(group: &mut BenchmarkGroup<WallTime>, name: &str, x: &[X], f: impl Fn(X) -> Y) {
    let mut out = vec![Y::default(); x.len()];
    group.bench_function(name, |b| {
        b.iter(|| {
            for (o, &x) in out.iter_mut().zip(black_box(x)) {
                *o = f(x);
            }
            black_box(&mut out);
        });
    });
}

fn whole<X, Y: Copy + Default>(group: &mut BenchmarkGroup<WallTime>, name: &str, x: &[X], f: fn(&[X], &mut [Y])) {
    let mut out = vec![Y::default(); x.len()];
    group.bench_function(name, |b| {
        b.iter(|| {
            f(black_box(x), black_box(&mut out));
        });
    });
}
