//! The one list of methods: accuracy tests, criterion inputs, charts, tables and `report eval` all read it.

mod functions;
mod own;
mod peer;

use crate::generate::Generator;
use crate::metrics::Reference;
use std::sync::LazyLock;

/// Number format in which a method computes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Precision {
    /// IEEE binary64.
    F64,
    /// IEEE binary32.
    F32,
}

/// Whose method it is; decides colour and marker on a chart.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Origin {
    /// This crate.
    Ours,
    /// The formula of one of the four papers, as a method.
    Published,
    /// Another library.
    Peer,
}

/// How a method is called. One row of inputs gives one row of results.
#[derive(Clone, Copy)]
pub enum Call {
    /// One f64 in, one out.
    F64(fn(f64) -> f64),
    /// Two f64 in (an interval), one out.
    F64Pair(fn([f64; 2]) -> f64),
    /// One f32 in, one out.
    F32(fn(f32) -> f32),
    /// Two f32 in, one out.
    F32Pair(fn(f32, f32) -> f32),
    /// Three f32 in, one out.
    F32Triple(fn(f32, f32, f32) -> f32),
    /// A slice of f64 in, a slice of the same length out.
    F64Slice(fn(&[f64], &mut [f64])),
    /// A slice of f64 intervals in.
    F64PairSlice(fn(&[[f64; 2]], &mut [f64])),
    /// A slice of f32 in.
    F32Slice(fn(&[f32], &mut [f32])),
    /// A slice of f32 intervals in.
    F32PairSlice(fn(&[[f32; 2]], &mut [f32])),
}

/// The measure in which a budget is stated.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Metric {
    /// Units in the last place of the correctly rounded result, in the method's own precision.
    Ulp,
    /// Relative error in units of the precision's epsilon (2^-52 or 2^-23).
    Eps,
    /// Absolute error.
    Absolute,
    /// Relative error.
    Relative,
}

/// A promised bound. A test fails when measured > bound, and when bound > 4 x measured.
#[derive(Clone, Copy, Debug)]
pub struct Budget {
    /// What is bounded.
    pub metric: Metric,
    /// The bound on the maximum over the domain.
    pub bound: f64,
}

impl Budget {
    /// Whether a measured maximum keeps the promise, and the promise is not more than four times the maximum.
    pub fn judge(&self, measured: f64) -> Result<(), String> {
        let Budget { metric, bound } = *self;
        if measured <= bound && bound <= 4.0 * measured {
            return Ok(());
        }
        let fault = if measured < bound { "too loose" } else { "broken" };
        Err(format!(
            "the bound of {bound:e} ({metric:?}) is {fault}, measured {measured:e}"
        ))
    }
}

/// A function of the house: what `eval` calls it, its columns, its truth.
pub struct Function {
    /// Name, as in `report eval`.
    pub name: &'static str,
    /// One line in words.
    pub summary: &'static str,
    /// Names and units of the input columns.
    pub inputs: &'static [(&'static str, &'static str)],
    /// Names and units of the result columns.
    pub outputs: &'static [(&'static str, &'static str)],
    /// True value of a row, to well beyond f64 (double-double).
    pub oracle: fn(&[f64]) -> Reference,
    /// What the oracle is, for the ledger.
    pub oracle_name: &'static str,
}

/// One way to compute a function.
pub struct Method {
    /// Name of its [`Function`].
    pub function: &'static str,
    /// Short name of the method: `accurate`, `vwh18`, `coarse`, `cephes`, ... A slice form has the name of its scalar form;
    /// function, method, precision and kind of call (scalar or slice) together are unique.
    pub method: &'static str,
    /// What it is, for a chart's legend: `Cephes (crate spec_math 0.1.6)`.
    pub label: &'static str,
    /// Precision it computes in.
    pub precision: Precision,
    /// Whose it is.
    pub origin: Origin,
    /// The call.
    pub call: Call,
    /// Inputs on which its accuracy is judged.
    pub domain: Generator,
    /// Its promise (None for a peer, which promises us nothing).
    pub budget: Option<Budget>,
    /// The scalar method of which this one is the slice form, if it is.
    pub slice_of: Option<&'static str>,
}

/// All functions.
pub fn functions() -> &'static [Function] {
    &functions::FUNCTIONS
}

/// The function of a name.
pub fn function(name: &str) -> Option<&'static Function> {
    functions().iter().find(|f| f.name == name)
}

/// All methods: ours and the published ones, then the peers.
pub fn methods() -> &'static [Method] {
    static METHODS: LazyLock<Vec<Method>> =
        LazyLock::new(|| own::methods().into_iter().chain(peer::methods()).collect());
    &METHODS
}

impl Call {
    /// Whether it takes slices.
    pub fn is_slice(&self) -> bool {
        matches!(
            self,
            Call::F64Slice(_) | Call::F64PairSlice(_) | Call::F32Slice(_) | Call::F32PairSlice(_)
        )
    }

    /// Numbers in a row of inputs.
    pub fn columns(&self) -> usize {
        match self {
            Call::F64(_) | Call::F32(_) | Call::F64Slice(_) | Call::F32Slice(_) => 1,
            Call::F64Pair(_) | Call::F32Pair(_) | Call::F64PairSlice(_) | Call::F32PairSlice(_) => 2,
            Call::F32Triple(_) => 3,
        }
    }

    /// Results for `rows` in row-major order. An f32 call gets each number rounded to f32.
    pub fn evaluate(&self, rows: &[f64]) -> Vec<f64> {
        match *self {
            Call::F64(f) => rows.iter().map(|&x| f(x)).collect(),
            Call::F64Pair(f) => rows.chunks_exact(2).map(|q| f([q[0], q[1]])).collect(),
            Call::F32(f) => rows.iter().map(|&x| f64::from(f(x as f32))).collect(),
            Call::F32Pair(f) => rows
                .chunks_exact(2)
                .map(|q| f64::from(f(q[0] as f32, q[1] as f32)))
                .collect(),
            Call::F32Triple(f) => rows
                .chunks_exact(3)
                .map(|x| f64::from(f(x[0] as f32, x[1] as f32, x[2] as f32)))
                .collect(),
            Call::F64Slice(f) => through(f, rows),
            Call::F64PairSlice(f) => through(f, rows.as_chunks::<2>().0),
            Call::F32Slice(f) => widened(through(f, &narrowed(rows))),
            Call::F32PairSlice(f) => widened(through(f, narrowed(rows).as_chunks::<2>().0)),
        }
    }
}

fn through<X, Y: Copy + Default>(f: fn(&[X], &mut [Y]), x: &[X]) -> Vec<Y> {
    let mut results = vec![Y::default(); x.len()];
    f(x, &mut results);
    results
}

fn narrowed(x: &[f64]) -> Vec<f32> {
    x.iter().map(|&x| x as f32).collect()
}

fn widened(x: Vec<f32>) -> Vec<f64> {
    x.into_iter().map(f64::from).collect()
}
