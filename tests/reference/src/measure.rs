//! Measures the error of a method against the oracle, on both cores.

use crate::metrics::{MISMATCH, Truth, absolute_error, complex, eps_error, relative_error, ulp_error, wrong_sign};
use crate::registry::{Function, Method, Metric, Precision, function};
use std::thread;

/// Errors of one method over the points of its domain. All of them finite (see [`crate::metrics`]).
#[derive(Clone, Debug, PartialEq)]
pub struct Accuracy {
    /// Rows of inputs measured.
    pub points: usize,
    /// Largest absolute error.
    pub max_abs: f64,
    /// Largest relative error.
    pub max_rel: f64,
    /// Largest error in units of the last place of the method's precision.
    pub max_ulp: f64,
    /// Largest relative error in epsilons of the method's precision.
    pub max_eps: f64,
    /// Largest error as a multiple of the function's scale ([`Function::peak`]), where it has one.
    pub max_peak: Option<f64>,
    /// Relative error that 99.9 % of the points keep below.
    pub p999_rel: f64,
    /// Mean error in units of the last place.
    pub mean_ulp: f64,
    /// The row on which the error in the budget's metric is largest (without a budget: in ulp, or eps if complex).
    pub worst_input: Vec<f64>,
    /// Results with the wrong sign; complex ones that point away from the truth.
    pub wrong_sign: usize,
    /// Results that are NaN or infinite where the truth is finite.
    pub non_finite: usize,
}

impl Accuracy {
    /// The maximum in a metric.
    pub fn maximum(&self, metric: Metric) -> f64 {
        match metric {
            Metric::Ulp => self.max_ulp,
            Metric::Eps => self.max_eps,
            Metric::Absolute => self.max_abs,
            Metric::Relative => self.max_rel,
            Metric::Peak => self.max_peak.unwrap_or(f64::NAN),
        }
    }
}

/// Errors of one row.
#[derive(Clone, Copy)]
struct Errors {
    absolute: f64,
    relative: f64,
    ulp: f64,
    eps: f64,
    peak: f64,
    wrong_sign: bool,
    non_finite: bool,
}

impl Errors {
    /// Errors of the results of a row; `scale` is what the function calls its peak there.
    fn new(results: &[f64], truth: &Truth, precision: Precision, scale: f64) -> Errors {
        let mut errors = match (results, truth) {
            (&[result], Truth::Real(truth)) => Errors {
                absolute: absolute_error(result, truth),
                relative: relative_error(result, truth, precision),
                ulp: ulp_error(result, truth, precision),
                eps: eps_error(result, truth, precision),
                peak: 0.0,
                wrong_sign: wrong_sign(result, truth),
                non_finite: !result.is_finite() && truth.hi.is_finite(),
            },
            (&[re, im], Truth::Complex(truth)) => Errors {
                absolute: complex::absolute_error([re, im], truth),
                relative: complex::relative_error([re, im], truth, precision),
                ulp: complex::ulp_error([re, im], truth, precision),
                eps: complex::eps_error([re, im], truth, precision),
                peak: 0.0,
                wrong_sign: complex::wrong_sign([re, im], truth),
                non_finite: !(re.is_finite() && im.is_finite()) && truth.iter().all(|t| t.hi.is_finite()),
            },
            _ => panic!("a method has as many results as its function"),
        };
        errors.peak = if errors.absolute == 0.0 {
            0.0
        } else {
            (errors.absolute / scale).min(MISMATCH)
        };
        errors
    }

    fn measured(&self, metric: Metric) -> f64 {
        match metric {
            Metric::Ulp => self.ulp,
            Metric::Eps => self.eps,
            Metric::Absolute => self.absolute,
            Metric::Relative => self.relative,
            Metric::Peak => self.peak,
        }
    }
}

/// Accuracy of `method` on `points` rows of its own domain.
///
/// # Panics
/// When the method names a function that is not registered.
pub fn accuracy(method: &Method, seed: u64, points: usize) -> Accuracy {
    accuracy_on(method, &(method.domain.rows)(seed, points))
}

/// Accuracy of `method` on given rows.
///
/// # Panics
/// When the method names a function that is not registered.
pub fn accuracy_on(method: &Method, rows: &[f64]) -> Accuracy {
    let function = function(method.function).expect("every method names a registered function");
    accuracy_against(method, rows, &truths(function, rows))
}

/// True values of rows in row-major order, computed on all cores. Shared by the methods of one domain.
pub fn truths(function: &Function, rows: &[f64]) -> Vec<Truth> {
    let columns = function.inputs.len();
    let threads = thread::available_parallelism().map_or(1, usize::from);
    let share = (rows.len() / columns).div_ceil(threads).max(1) * columns;
    thread::scope(|scope| {
        let parts: Vec<_> = rows
            .chunks(share)
            .map(|part| {
                scope.spawn(move || {
                    part.chunks_exact(columns)
                        .map(|row| function.truth(row))
                        .collect::<Vec<_>>()
                })
            })
            .collect();
        parts
            .into_iter()
            .flat_map(|part| part.join().expect("an oracle does not panic"))
            .collect()
    })
}

/// Accuracy of `method` on rows whose truths are known.
///
/// # Panics
/// When the method names a function that is not registered, or does not have its columns.
pub fn accuracy_against(method: &Method, rows: &[f64], truths: &[Truth]) -> Accuracy {
    let function = function(method.function).expect("every method names a registered function");
    let (columns, width) = (method.call.columns(), method.call.results());
    let results = method.call.evaluate(rows);
    assert_eq!(
        results.len(),
        truths.len() * width,
        "one truth for every row of {}",
        method.function
    );
    let inputs = rows.chunks_exact(columns);
    let smallest = match method.precision {
        Precision::F64 => f64::MIN_POSITIVE,
        Precision::F32 => f64::from(f32::MIN_POSITIVE),
    };
    let errors: Vec<Errors> = results
        .chunks_exact(width)
        .zip(truths)
        .zip(inputs)
        .map(|((result, truth), row)| {
            let scale = function.peak.map_or(1.0, |peak| (peak.of)(row).max(smallest));
            Errors::new(result, truth, method.precision, scale)
        })
        .collect();
    let maximum = |of: fn(&Errors) -> f64| errors.iter().map(of).fold(0.0, f64::max);
    let unpromised = if width == 1 { Metric::Ulp } else { Metric::Eps };
    let metric = method.budget.map_or(unpromised, |b| b.metric);
    let judged = |e: &Errors| e.measured(metric);
    let worst = (0..errors.len()).max_by(|&i, &j| judged(&errors[i]).total_cmp(&judged(&errors[j])));
    let mut relative: Vec<f64> = errors.iter().map(|e| e.relative).collect();
    relative.sort_by(f64::total_cmp);
    let points = errors.len();
    Accuracy {
        points,
        max_abs: maximum(|e| e.absolute),
        max_rel: maximum(|e| e.relative),
        max_ulp: maximum(|e| e.ulp),
        max_eps: maximum(|e| e.eps),
        max_peak: function.peak.map(|_| maximum(|e| e.peak)),
        p999_rel: relative
            .get((points as f64 * 0.999) as usize)
            .or(relative.last())
            .copied()
            .unwrap_or(0.0),
        mean_ulp: errors.iter().map(|e| e.ulp / points as f64).sum(),
        worst_input: worst.map_or(Vec::new(), |i| rows[i * columns..(i + 1) * columns].to_vec()),
        wrong_sign: errors.iter().filter(|e| e.wrong_sign).count(),
        non_finite: errors.iter().filter(|e| e.non_finite).count(),
    }
}
