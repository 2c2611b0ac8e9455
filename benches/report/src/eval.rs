//! `report eval`: rows of numbers in, a row of results out for each.
//!
//! Results go to standard output as they come, 17 significant digits each, blank separated. At the first bad row the program stops:
//! results of the rows before it stand on standard output, the line, column and reason on standard error, and the
//! exit code is 2.

use crate::ledger::Entry;
use crate::names::{self, methods_of, unknown};
use crate::promise::{bound_on_error, unit};
use crate::rows::{Next, Rows};
use reference::registry::lights::{OPEN, Open};
use reference::registry::{Function, Method, Origin, Precision};
use std::io::{self, BufRead, Write};

/// What is asked for.
pub struct Request<'a> {
    /// The function's name.
    pub function: &'a str,
    /// Precision of the computation.
    pub precision: Precision,
    /// The method, if one is named.
    pub method: Option<&'a str>,
    /// The largest error allowed, if one is given: as a multiple of max(1, |result|), or of max(scale, |result|) where the
    /// function's scale has a unit.
    pub tolerance: Option<f64>,
}

/// The methods that may be asked for: this crate's and the published ones, called one row at a time.
fn open(function: &Function, precision: Precision) -> Vec<&'static Method> {
    methods_of(function.name)
        .filter(|m| m.origin != Origin::Peer && m.precision == precision && names::call(&m.call) == "scalar")
        .collect()
}

/// How the rows of a request are evaluated.
#[derive(Clone, Copy)]
pub enum Evaluator {
    /// By a registered method.
    Method(&'static Method),
    /// With a relative error of at most a tolerance, by as much work as each row needs.
    Within(&'static Open, f64),
}

impl Evaluator {
    fn precision(&self) -> Precision {
        match self {
            Evaluator::Method(method) => method.precision,
            Evaluator::Within(..) => Precision::F64,
        }
    }

    /// The results of a row; what is wrong with a row that the method does not take.
    fn evaluate(&self, row: &[f64]) -> Result<Vec<f64>, String> {
        match self {
            Evaluator::Within(open, tolerance) => Ok(vec![(open.within)(row, *tolerance)]),
            Evaluator::Method(method) if row.len() == method.call.columns() => Ok(method.call.evaluate(row)),
            Evaluator::Method(method) => open_to(method.function)
                .and_then(|open| (open.value)(method.method, method.precision, row))
                .map(|value| vec![value])
                .ok_or_else(|| {
                    format!(
                        "the {} method {} does not take {} columns",
                        names::precision(method.precision),
                        method.method,
                        row.len()
                    )
                }),
        }
    }
}

fn open_to(function: &str) -> Option<&'static Open> {
    OPEN.iter().find(|open| open.function == function)
}

/// The function and the evaluator that a request means; `ledger` orders methods by cost where a tolerance is given.
pub fn choose_evaluator(request: &Request, ledger: &[Entry]) -> Result<(&'static Function, Evaluator), String> {
    if let (Some(tolerance), None, Some(open), Precision::F64) = (
        request.tolerance,
        request.method,
        open_to(request.function),
        request.precision,
    ) {
        positive(tolerance)?;
        return Ok((names::function(request.function)?, Evaluator::Within(open, tolerance)));
    }
    let (function, method) = choose(request, ledger)?;
    Ok((function, Evaluator::Method(method)))
}

fn positive(tolerance: f64) -> Result<(), String> {
    if tolerance > 0.0 && tolerance.is_finite() {
        Ok(())
    } else {
        Err(format!("a tolerance is a positive number, not {tolerance}"))
    }
}

/// The method that a request means; `ledger` orders methods by cost where a tolerance is given.
pub fn choose(request: &Request, ledger: &[Entry]) -> Result<(&'static Function, &'static Method), String> {
    let function = names::function(request.function)?;
    let choices = open(function, request.precision);
    let precision = names::precision(request.precision);
    if let Some(name) = request.method {
        let known: Vec<&str> = choices.iter().map(|m| m.method).collect();
        let found = choices.iter().find(|m| m.method == name);
        return found.map(|m| (function, *m)).ok_or_else(|| {
            let kind = format!("{precision} method of {}", function.name);
            unknown(&kind, name, &known)
        });
    }
    let own: Vec<&'static Method> = choices.into_iter().filter(|m| m.origin == Origin::Ours).collect();
    let Some(tolerance) = request.tolerance else {
        return own
            .first()
            .map(|m| (function, *m))
            .ok_or_else(|| format!("{} has no {precision} method", function.name));
    };
    positive(tolerance)?;
    let bound = |m: &Method| bound_on_error(m);
    let cost = |m: &Method| {
        ledger
            .iter()
            .find(|e| e.key() == (m.function, m.method, m.precision, "scalar"))
            .map_or(f64::NAN, |e| e.ns)
    };
    // Where any candidate has no cost yet, the looser promise stands for the lower cost.
    let kept: Vec<&'static Method> = own.iter().filter(|m| bound(m) <= tolerance).copied().collect();
    let timed = kept.iter().all(|m| cost(m).is_finite());
    let cheapest = kept.into_iter().min_by(|a, b| {
        if timed {
            cost(a).total_cmp(&cost(b))
        } else {
            bound(b).total_cmp(&bound(a))
        }
    });
    cheapest.map(|m| (function, m)).ok_or_else(|| {
        let best = own.iter().map(|m| bound(m)).fold(f64::INFINITY, f64::min);
        let scale = unit(function.name).unwrap_or("1");
        format!("no {precision} method of {} promises an error of at most {tolerance:e} max({scale}, |result|); the best promises {best:.3e}", function.name)
    })
}

/// How an evaluation ended.
#[derive(Debug, PartialEq, Eq)]
pub enum End {
    /// Every row has its result.
    Complete,
    /// A bad row: line, column and reason.
    Refused(String),
}

/// Evaluates all rows of `input`. Errors of the output (a closed pipe among them) are handed back.
pub fn evaluate(function: &Function, evaluator: Evaluator, input: impl BufRead, output: impl Write) -> io::Result<End> {
    let names: Vec<&str> = function.inputs.iter().map(|(name, _)| *name).collect();
    let single = evaluator.precision() == Precision::F32;
    let columns = open_to(function.name).map_or([names.len(), 0], |open| open.columns);
    let mut rows = Rows::open(input, &names, columns, single);
    let mut output = io::LineWriter::new(output);
    let mut row = Vec::with_capacity(names.len());
    let end = loop {
        match rows.next(&mut row, function.refuse)? {
            Next::Row => match evaluator.evaluate(&row) {
                Ok(results) => {
                    let words: Vec<String> = results.iter().map(|x| format!("{x:.16e}")).collect();
                    writeln!(output, "{}", words.join(" "))?;
                }
                Err(reason) => break End::Refused(rows.bad(None, reason).to_string()),
            },
            Next::End => break End::Complete,
            Next::Bad(refusal) => break End::Refused(refusal.to_string()),
        }
    };
    output.flush()?;
    Ok(end)
}

/// Text of `report list`.
pub fn list() -> String {
    let mut text = String::new();
    for f in reference::registry::functions() {
        let columns = |c: &[(&str, &str)]| {
            let each: Vec<String> = c
                .iter()
                .map(|(name, unit)| {
                    if unit.is_empty() {
                        (*name).to_string()
                    } else {
                        format!("{name} [{unit}]")
                    }
                })
                .collect();
            each.join(", ")
        };
        text.push_str(&format!("{}: {}\n", f.name, f.summary));
        if let Some(scale) = unit(f.name) {
            text.push_str(&format!(
                "  scale:   {scale}; peak errors and tolerances are multiples of it\n"
            ));
        }
        if let Some(open) = open_to(f.name) {
            text.push_str("  tolerance: any; a bound on the relative error, kept by as much work as a row needs\n");
            let [least, step] = open.columns;
            if step > 0 {
                text.push_str(&format!(
                    "  rows:    {least} columns, and {step} more for each further vertex\n"
                ));
            }
        }
        text.push_str(&format!(
            "  inputs:  {}\n  results: {}\n  methods:\n",
            columns(f.inputs),
            columns(f.outputs)
        ));
        let all: Vec<&Method> = methods_of(f.name).filter(|m| m.origin != Origin::Peer).collect();
        let width = all.iter().map(|m| m.method.len()).max().unwrap_or(0);
        for m in all {
            let budget = crate::budget_text::budget_text(m.budget);
            let promise = if budget.is_empty() {
                "no promise".to_string()
            } else {
                format!("error <= {budget}")
            };
            let form = if names::call(&m.call) == "slice" {
                "slice "
            } else {
                "scalar"
            };
            text.push_str(&format!(
                "    {:width$}  {}  {form}  {promise}; {}\n",
                m.method,
                names::precision(m.precision),
                m.label
            ));
        }
    }
    text
}
