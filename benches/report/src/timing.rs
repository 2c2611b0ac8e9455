//! Time per call on a noisy machine: short samples of all methods of a function, taken in turn on the same inputs,
//! so that noise meets all alike; the minimum of each method counts.
//!
//! A sample is a batch of passes over a block of the 4096 inputs, sized to about 60 microseconds. Slow methods get
//! several blocks; the sum of the blocks' minima is the time of all inputs, so no cheap block stands for the rest.

use reference::generate::timing::ROWS;
use reference::registry::{Method, Precision};
use std::ops::Range;
use std::time::{Duration, Instant};

const SAMPLE: Duration = Duration::from_micros(60);
const SMALLEST_BLOCK: usize = 64;

/// Evaluates the rows of a range each time it is called.
type Work = Box<dyn FnMut(Range<usize>)>;

fn seconds(work: &mut Work, block: Range<usize>, passes: u32) -> f64 {
    let start = Instant::now();
    for _ in 0..passes {
        work(block.clone());
    }
    start.elapsed().as_secs_f64()
}

struct Plan {
    work: Work,
    block: usize,
    passes: u32,
    next: usize,
    best: Vec<f64>,
}

impl Plan {
    fn new(method: &Method, rows: &[f64]) -> Self {
        let mut work = method.call.pass(rows);
        let mut all = f64::INFINITY;
        for _ in 0..3 {
            all = all.min(seconds(&mut work, 0..ROWS, 1)).max(1e-9);
        }
        let sample = SAMPLE.as_secs_f64();
        let mut block = ROWS;
        while block > SMALLEST_BLOCK && all * block as f64 / ROWS as f64 > 1.5 * sample {
            block /= 2;
        }
        let passes = (sample / (all * block as f64 / ROWS as f64)).clamp(1.0, 1e5) as u32;
        Self {
            work,
            block,
            passes,
            next: 0,
            best: vec![f64::INFINITY; ROWS / block],
        }
    }

    fn sample(&mut self) {
        let i = self.next;
        let spent = seconds(&mut self.work, i * self.block..(i + 1) * self.block, self.passes);
        self.best[i] = self.best[i].min(spent / f64::from(self.passes));
        self.next = (i + 1) % self.best.len();
    }

    fn nanoseconds(&self) -> f64 {
        self.best.iter().sum::<f64>() * 1e9 / ROWS as f64
    }
}

/// Nanoseconds per row of each method of one function, measured together for about `budget`, and for at least
/// three samples of every block.
pub fn measure(methods: &[&Method], budget: Duration, mut tick: impl FnMut()) -> Vec<f64> {
    let mut plans: Vec<Plan> = methods.iter().map(|m| Plan::new(m, &m.timing_rows())).collect();
    let blocks = plans.iter().map(|p| p.best.len()).max().unwrap_or(1);
    let start = Instant::now();
    let mut round = 0;
    while round < 3 * blocks || start.elapsed() < budget {
        plans.iter_mut().for_each(Plan::sample);
        round += 1;
        if round % 64 == 0 {
            tick();
        }
    }
    plans.iter().map(Plan::nanoseconds).collect()
}

/// The method that costs of a function and precision refer to: Cephes in f64, the published fit in f32 (its slice
/// form for slices), else the first of another origin; of a slice form then the scalar form, of a scalar one the first.
pub fn baseline<'a>(methods: &[&'a Method], method: &Method) -> Option<&'a Method> {
    let slice = method.slice_of.is_some() && method.precision == Precision::F32;
    let same = || {
        methods
            .iter()
            .filter(|m| m.precision == method.precision && m.slice_of.is_some() == slice)
    };
    let preferred: &[&str] = match method.precision {
        Precision::F64 => &["cephes"],
        Precision::F32 => &["vwh18", "velinov"],
    };
    let named = preferred
        .iter()
        .find_map(|name| same().find(|m| m.method.starts_with(name)));
    named
        .or_else(|| same().find(|m| m.origin != reference::registry::Origin::Ours))
        .or_else(|| {
            let scalar = |m: &&&Method| {
                method.slice_of == Some(m.method) && m.precision == method.precision && !m.call.is_slice()
            };
            methods.iter().find(scalar)
        })
        .or_else(|| same().next())
        .copied()
}

/// What the ledger calls a baseline: its method; of a slice form that is held against its scalar form, that too.
pub fn baseline_name(method: &Method, base: &Method) -> String {
    let form = if method.call.is_slice() && !base.call.is_slice() && method.slice_of == Some(base.method) {
        ", scalar"
    } else {
        ""
    };
    format!("{}{form}", base.method)
}

/// The processor's name, for the ledger.
pub fn device() -> String {
    let info = std::fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
    let model = info
        .lines()
        .find_map(|l| l.strip_prefix("model name"))
        .and_then(|l| l.split_once(':'));
    let name = model.map_or("processor not named by the system", |(_, name)| name.trim());
    format!("{name} ({})", std::env::consts::ARCH)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::names::methods_of;
    use reference::registry::Precision::{F32, F64};

    fn baseline_of(function: &str, precision: Precision, slice: bool) -> String {
        let methods: Vec<&Method> = methods_of(function).collect();
        let is_it = |m: &&&Method| m.method == "accurate" && m.precision == precision && m.call.is_slice() == slice;
        let method = methods.iter().find(is_it).expect("registered");
        baseline_name(method, baseline(&methods, method).expect("some method"))
    }

    #[test]
    fn a_slice_form_refers_to_the_published_slices_or_to_its_own_scalar_form_and_never_to_itself() {
        assert_eq!(baseline_of("sine_integral", F64, true), "cephes");
        assert_eq!(baseline_of("sine_integral", F32, true), "vwh18");
        assert_eq!(baseline_of("spatial_phase", F32, true), "accurate, scalar");
        assert_eq!(baseline_of("profile_rectangle", F32, false), "accurate");
        assert_eq!(baseline_of("profile_rectangle", F64, false), "as_printed");
    }
}
