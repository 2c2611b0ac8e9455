//! The one list of methods: accuracy tests, criterion inputs, charts, tables and `report eval` all read it.

mod bessel;
mod call;
mod erf_difference;
mod error_function;
mod faddeeva;
mod footprint;
mod functions;
pub mod lights;
mod own;
mod peer;
mod scratch_functions;
mod scratches;
mod surface_functions;
mod surfaces;

pub use call::{Call, Input, Number, Pass, Shape, Value};

use crate::generate::{Generator, timing};
use crate::metrics::{Reference, Truth};
use std::sync::LazyLock;

/// Seed of the rows for timings.
const TIMING_SEED: u64 = 0x5eed;

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
    /// Another library, or a plain quadrature where no library has the function.
    Peer,
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
    /// Absolute error as a multiple of the function's own scale, [`Peak`].
    Peak,
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
    pub oracle: Oracle,
    /// What the oracle is, for the ledger.
    pub oracle_name: &'static str,
    /// The scale of a row against which [`Metric::Peak`] counts errors, where the function has one.
    pub peak: Option<Peak>,
    /// What is wrong with a row: the column, from 0, and the reason. Not a number is not wrong: it gives itself.
    pub refuse: fn(&[f64]) -> Option<(usize, &'static str)>,
    /// Rows on which all its methods are timed; `None` where those of [`crate::generate::timing`] suit.
    pub timed: Option<Generator>,
    /// One of so many points of a run is measured: more than 1 where the oracle takes tens of microseconds.
    pub thinning: usize,
}

/// A function's own scale, about its largest size with these inputs; errors are counted as multiples of it.
#[derive(Clone, Copy)]
pub struct Peak {
    /// The scale of a row, to about six digits.
    pub of: fn(&[f64]) -> f64,
    /// What it is, in words or as a formula.
    pub words: &'static str,
    /// Its largest value over all rows, at least 1; none where it has a unit and no largest value.
    pub largest: Option<f64>,
}

/// The truth of a row of inputs.
#[derive(Clone, Copy)]
pub enum Oracle {
    /// One number.
    Real(fn(&[f64]) -> Reference),
    /// Real and imaginary part.
    Complex(fn(&[f64]) -> [Reference; 2]),
}

impl Function {
    /// True value of a row.
    pub fn truth(&self, row: &[f64]) -> Truth {
        match self.oracle {
            Oracle::Real(f) => Truth::Real(f(row)),
            Oracle::Complex(f) => Truth::Complex(f(row)),
        }
    }
}

/// A further part of the plane or line on which a method is judged, with a promise of its own.
#[derive(Clone, Copy)]
pub struct Region {
    /// Inputs of the part.
    pub domain: Generator,
    /// The promise there.
    pub budget: Option<Budget>,
}

/// One way to compute a function.
#[derive(Clone)]
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
    /// Where else it is judged; `domain` and `budget` above are what charts show.
    pub regions: Vec<Region>,
}

impl Method {
    /// The method once for each domain on which it is judged, the main one first.
    pub fn on_each_domain(&self) -> Vec<Method> {
        let whole = Region {
            domain: self.domain,
            budget: self.budget,
        };
        std::iter::once(&whole)
            .chain(&self.regions)
            .map(|region| Method {
                domain: region.domain,
                budget: region.budget,
                regions: Vec::new(),
                ..*self
            })
            .collect()
    }

    /// Rows on which it is timed.
    pub fn timing_rows(&self) -> Vec<f64> {
        match function(self.function).and_then(|f| f.timed) {
            Some(domain) => (domain.rows)(TIMING_SEED, timing::ROWS),
            None => timing::rows(&self.domain),
        }
    }
}

/// All functions.
pub fn functions() -> &'static [Function] {
    static ALL: LazyLock<Vec<Function>> = LazyLock::new(|| {
        let (special, scratches) = (functions::FUNCTIONS, scratch_functions::FUNCTIONS);
        let surfaces = surface_functions::FUNCTIONS;
        let all = special.into_iter().chain(scratches).chain(surfaces);
        all.chain(lights::FUNCTIONS).collect()
    });
    &ALL
}

/// The function of a name.
pub fn function(name: &str) -> Option<&'static Function> {
    functions().iter().find(|f| f.name == name)
}

/// All methods, of each function ours first.
pub fn methods() -> &'static [Method] {
    static METHODS: LazyLock<Vec<Method>> = LazyLock::new(|| {
        let parts = [
            own::methods(),
            peer::methods(),
            faddeeva::methods(),
            error_function::methods(),
            erf_difference::methods(),
            bessel::methods(),
            scratches::methods(),
            footprint::methods(),
            surfaces::methods(),
            lights::methods(),
        ];
        parts.into_iter().flatten().collect()
    });
    &METHODS
}
