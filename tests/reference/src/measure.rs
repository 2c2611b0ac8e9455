//! Measures the error of a method against the oracle, on both cores.

use crate::metrics::{Reference, absolute_error, eps_error, relative_error, ulp_error, wrong_sign};
use crate::registry::{Function, Method, Metric, function};
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
    /// Relative error that 99.9 % of the points keep below.
    pub p999_rel: f64,
    /// Mean error in units of the last place.
    pub mean_ulp: f64,
    /// The row on which the error in the budget's metric (in ulp where there is no budget) is largest.
    pub worst_input: Vec<f64>,
    /// Results with the wrong sign.
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
    wrong_sign: bool,
    non_finite: bool,
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
pub fn truths(function: &Function, rows: &[f64]) -> Vec<Reference> {
    let columns = function.inputs.len();
    let threads = thread::available_parallelism().map_or(1, usize::from);
    let share = (rows.len() / columns).div_ceil(threads).max(1) * columns;
    thread::scope(|scope| {
        let parts: Vec<_> = rows
            .chunks(share)
            .map(|part| scope.spawn(move || part.chunks_exact(columns).map(function.oracle).collect::<Vec<_>>()))
            .collect();
        parts
            .into_iter()
            .flat_map(|part| part.join().expect("an oracle does not panic"))
            .collect()
    })
}

/// Accuracy of `method` on rows whose truths are known.
pub fn accuracy_against(method: &Method, rows: &[f64], truths: &[Reference]) -> Accuracy {
    let results = method.call.evaluate(rows);
    assert_eq!(
        results.len(),
        truths.len(),
        "one truth for every row of {}",
        method.function
    );
    let precision = method.precision;
    let errors: Vec<Errors> = results
        .iter()
        .zip(truths)
        .map(|(&result, truth)| Errors {
            absolute: absolute_error(result, truth),
            relative: relative_error(result, truth, precision),
            ulp: ulp_error(result, truth, precision),
            eps: eps_error(result, truth, precision),
            wrong_sign: wrong_sign(result, truth),
            non_finite: !result.is_finite() && truth.hi.is_finite(),
        })
        .collect();
    let maximum = |of: fn(&Errors) -> f64| errors.iter().map(of).fold(0.0, f64::max);
    let judged = |e: &Errors| match method.budget.map(|b| b.metric) {
        Some(Metric::Absolute) => e.absolute,
        Some(Metric::Relative) => e.relative,
        Some(Metric::Eps) => e.eps,
        Some(Metric::Ulp) | None => e.ulp,
    };
    let columns = method.call.columns();
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
