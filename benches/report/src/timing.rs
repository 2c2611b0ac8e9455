//! Time per call on a noisy machine: short samples of all methods of a function, taken in turn on the same inputs,
//! so that noise meets all alike; the minimum of each method counts.
//!
//! A sample is a batch of passes over a block of the 4096 inputs, sized to about 60 microseconds. Slow methods get
//! several blocks; the sum of the blocks' minima is the time of all inputs, so no cheap block stands for the rest.

use reference::generate::timing::{ROWS, rows};
use reference::registry::{Call, Method, Precision};
use std::hint::black_box;
use std::time::{Duration, Instant};

const SAMPLE: Duration = Duration::from_micros(60);
const SMALLEST_BLOCK: usize = 64;

/// Inputs in the shape that a call takes, with room for its results.
enum Work {
    F64(fn(f64) -> f64, Vec<f64>, Vec<f64>),
    F64Pair(fn([f64; 2]) -> f64, Vec<[f64; 2]>, Vec<f64>),
    F32(fn(f32) -> f32, Vec<f32>, Vec<f32>),
    F32Pair(fn(f32, f32) -> f32, Vec<[f32; 2]>, Vec<f32>),
    F32Triple(fn(f32, f32, f32) -> f32, Vec<[f32; 3]>, Vec<f32>),
    F64Slice(fn(&[f64], &mut [f64]), Vec<f64>, Vec<f64>),
    F64PairSlice(fn(&[[f64; 2]], &mut [f64]), Vec<[f64; 2]>, Vec<f64>),
    F32Slice(fn(&[f32], &mut [f32]), Vec<f32>, Vec<f32>),
    F32PairSlice(fn(&[[f32; 2]], &mut [f32]), Vec<[f32; 2]>, Vec<f32>),
}

impl Work {
    fn new(call: &Call, rows: &[f64]) -> Self {
        let pairs = || rows.chunks_exact(2).map(|r| [r[0], r[1]]).collect::<Vec<_>>();
        let single = || rows.iter().map(|&x| x as f32).collect::<Vec<_>>();
        let single_pairs = || {
            rows.chunks_exact(2)
                .map(|r| [r[0] as f32, r[1] as f32])
                .collect::<Vec<_>>()
        };
        let (wide, narrow) = (vec![0.0_f64; ROWS], vec![0.0_f32; ROWS]);
        match *call {
            Call::F64(f) => Self::F64(f, rows.to_vec(), wide),
            Call::F64Pair(f) => Self::F64Pair(f, pairs(), wide),
            Call::F32(f) => Self::F32(f, single(), narrow),
            Call::F32Pair(f) => Self::F32Pair(f, single_pairs(), narrow),
            Call::F32Triple(f) => Self::F32Triple(f, single().as_chunks::<3>().0.to_vec(), narrow),
            Call::F64Slice(f) => Self::F64Slice(f, rows.to_vec(), wide),
            Call::F64PairSlice(f) => Self::F64PairSlice(f, pairs(), wide),
            Call::F32Slice(f) => Self::F32Slice(f, single(), narrow),
            Call::F32PairSlice(f) => Self::F32PairSlice(f, single_pairs(), narrow),
        }
    }

    fn pass(&mut self, block: std::ops::Range<usize>) {
        fn each<X: Copy, Y>(x: &[X], out: &mut [Y], f: impl Fn(X) -> Y) {
            for (o, &x) in out.iter_mut().zip(black_box(x)) {
                *o = f(x);
            }
            black_box(out);
        }
        fn whole<X, Y>(x: &[X], out: &mut [Y], f: fn(&[X], &mut [Y])) {
            f(black_box(x), out);
            black_box(out);
        }
        match self {
            Self::F64(f, x, o) => each(&x[block.clone()], &mut o[block], black_box(*f)),
            Self::F64Pair(f, x, o) => each(&x[block.clone()], &mut o[block], black_box(*f)),
            Self::F32(f, x, o) => each(&x[block.clone()], &mut o[block], black_box(*f)),
            Self::F32Pair(f, x, o) => {
                let f = black_box(*f);
                each(&x[block.clone()], &mut o[block], |[a, b]| f(a, b));
            }
            Self::F32Triple(f, x, o) => {
                let f = black_box(*f);
                each(&x[block.clone()], &mut o[block], |[a, b, c]| f(a, b, c));
            }
            Self::F64Slice(f, x, o) => whole(&x[block.clone()], &mut o[block], *f),
            Self::F64PairSlice(f, x, o) => whole(&x[block.clone()], &mut o[block], *f),
            Self::F32Slice(f, x, o) => whole(&x[block.clone()], &mut o[block], *f),
            Self::F32PairSlice(f, x, o) => whole(&x[block.clone()], &mut o[block], *f),
        }
    }

    fn seconds(&mut self, block: std::ops::Range<usize>, passes: u32) -> f64 {
        let start = Instant::now();
        for _ in 0..passes {
            self.pass(block.clone());
        }
        start.elapsed().as_secs_f64()
    }
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
        let mut work = Work::new(&method.call, rows);
        let mut all = f64::INFINITY;
        for _ in 0..3 {
            all = all.min(work.seconds(0..ROWS, 1)).max(1e-9);
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
        let seconds = self.work.seconds(i * self.block..(i + 1) * self.block, self.passes);
        self.best[i] = self.best[i].min(seconds / f64::from(self.passes));
        self.next = (i + 1) % self.best.len();
    }

    fn nanoseconds(&self) -> f64 {
        self.best.iter().sum::<f64>() * 1e9 / ROWS as f64
    }
}

/// Nanoseconds per row of each method of one function, measured together for about `budget`, and for at least
/// three samples of every block.
pub fn measure(methods: &[&Method], budget: Duration, mut tick: impl FnMut()) -> Vec<f64> {
    let mut plans: Vec<Plan> = methods.iter().map(|m| Plan::new(m, &rows(&m.domain))).collect();
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
/// form for slices), else the first of another origin, else the first.
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
        .or_else(|| same().next())
        .copied()
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
