//! A criterion group for one function: all its methods from the registry, on the inputs of all timings.

use criterion::{Criterion, SamplingMode, Throughput};
use reference::generate::timing::ROWS;
use reference::registry::{Precision, methods};
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
        let mut pass = m.call.pass(&m.timing_rows());
        group.bench_function(name, |b| b.iter(|| pass(0..ROWS)));
    }
    group.finish();
    criterion.final_summary();
}
