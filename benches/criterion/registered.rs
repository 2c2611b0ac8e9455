//! A criterion group for one function: all its methods from the registry, on the inputs of all timings.

use criterion::{BenchmarkGroup, Criterion, SamplingMode, Throughput, measurement::WallTime};
use reference::generate::timing::ROWS;
use reference::registry::{Precision, Value, Visitor, methods};
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
        let name = format!("{} {precision}{form}", m.method);
        m.call.visit(&m.timing_rows(), Add(&mut group, name));
    }
    group.finish();
    criterion.final_summary();
}

/// Adds a benchmark of a call in its own shape of inputs and results.
struct Add<'a, 'b>(&'a mut BenchmarkGroup<'b, WallTime>, String);

impl Visitor for Add<'_, '_> {
    type Output = ();

    fn scalar<X: Copy + 'static, Y: Value>(self, x: Vec<X>, f: impl Fn(X) -> Y + 'static) {
        let mut out = vec![Y::default(); x.len()];
        self.0.bench_function(self.1, |b| {
            b.iter(|| {
                let f = black_box(&f);
                for (o, &x) in out.iter_mut().zip(black_box(&x)) {
                    *o = f(x);
                }
                black_box(&mut out);
            });
        });
    }

    fn slice<X: 'static, Y: Value>(self, x: Vec<X>, f: fn(&[X], &mut [Y])) {
        let mut out = vec![Y::default(); x.len()];
        self.0.bench_function(self.1, |b| {
            b.iter(|| {
                f(black_box(&x), &mut out);
                black_box(&mut out);
            });
        });
    }
}
