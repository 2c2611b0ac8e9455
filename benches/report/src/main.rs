//! The program `report`: measures every method, writes the ledger, charts and tables; lists and evaluates functions.

use clap::{Parser, Subcommand, ValueEnum};
use reference::registry::Precision;
use report::{budget_text, eval, ledger, promise, run};
use std::io::{self, Write};
use std::path::PathBuf;
use std::process::ExitCode;

/// Measures error against time of every registered method; lists and evaluates functions.
///
/// Without a subcommand: measures everything and rewrites data/accuracy.csv, data/charts, docs/charts, docs/failures
/// and the generated parts of the pages.
#[derive(Parser)]
#[command(version, args_conflicts_with_subcommands = true)]
struct Arguments {
    #[command(subcommand)]
    command: Option<Command>,
    /// Fewer points and shorter timing; writes outside the tree, to --out or a temporary folder.
    #[arg(long, conflicts_with_all = ["check", "render"])]
    quick: bool,
    /// Measures the errors again and compares ledger, charts and tables with the committed ones; writes nothing.
    #[arg(long, conflicts_with = "render")]
    check: bool,
    /// Draws charts and tables again from the committed ledger, without measuring.
    #[arg(long)]
    render: bool,
    /// Folder for all that is written, instead of the tree.
    #[arg(long, value_name = "DIR", conflicts_with = "check")]
    out: Option<PathBuf>,
}

#[derive(Subcommand)]
enum Command {
    /// Names every function with its columns, units, results and methods.
    List,
    /// Reads rows of numbers from standard input and writes a row of results each, 17 significant digits.
    ///
    /// Columns are separated by commas or blanks; `#` starts a comment; blank lines are skipped; numbers are decimal,
    /// hexadecimal (0x1.8p+1), inf or nan. The first bad row ends the run: line and reason go to standard error, the
    /// exit code is 2, and no result is written for it or any row after it.
    Eval {
        /// Name of the function, as in `report list`.
        name: String,
        /// Precision of the computation; in f32 the inputs are rounded to f32 first.
        #[arg(long, value_enum, default_value = "f64")]
        precision: Single,
        /// One method by name instead of the accurate one.
        #[arg(long)]
        method: Option<String>,
        /// Picks the cheapest own method in this precision that promises |error| <= T max(1, |result|), or T max(scale,
        /// |result|) for a function with a scale that has a unit, as `report list` says. A function whose tolerance is any
        /// keeps |error| <= T |result| row by row.
        #[arg(long, value_name = "T", conflicts_with = "method", allow_negative_numbers = true)]
        tolerance: Option<f64>,
    },
}

#[derive(Clone, Copy, ValueEnum)]
enum Single {
    F64,
    F32,
}

fn main() -> ExitCode {
    let arguments = Arguments::parse();
    match arguments.command {
        Some(Command::List) => print_all(&eval::list()),
        Some(Command::Eval {
            name,
            precision,
            method,
            tolerance,
        }) => {
            let precision = match precision {
                Single::F64 => Precision::F64,
                Single::F32 => Precision::F32,
            };
            evaluate(&eval::Request {
                function: &name,
                precision,
                method: method.as_deref(),
                tolerance,
            })
        }
        None => {
            let mode = match (arguments.quick, arguments.check, arguments.render) {
                (true, ..) => run::Mode::Quick,
                (_, true, _) => run::Mode::Check,
                (.., true) => run::Mode::Render,
                _ => run::Mode::Full,
            };
            match run::run(mode, arguments.out) {
                Ok(report) => {
                    let code = print_all(&report.text);
                    if report.passed { code } else { ExitCode::FAILURE }
                }
                Err(reason) => {
                    eprintln!("report: {reason}");
                    ExitCode::FAILURE
                }
            }
        }
    }
}

/// Writes to standard output; a reader that has gone away is no failure.
fn print_all(text: &str) -> ExitCode {
    match io::stdout().write_all(text.as_bytes()) {
        Err(e) if e.kind() != io::ErrorKind::BrokenPipe => {
            eprintln!("report: {e}");
            ExitCode::FAILURE
        }
        _ => ExitCode::SUCCESS,
    }
}

fn evaluate(request: &eval::Request) -> ExitCode {
    // Only a choice by cost needs the ledger; a tree without one has a fixed order.
    let entries = match request.tolerance {
        Some(_) => std::fs::read_to_string(run::root().join(run::LEDGER)).unwrap_or_default(),
        None => String::new(),
    };
    let entries = ledger::read(&entries).unwrap_or_default();
    let (function, evaluator) = match eval::choose_evaluator(request, &entries) {
        Ok(found) => found,
        Err(reason) => {
            eprintln!("report eval: {reason}");
            return ExitCode::from(2);
        }
    };
    match evaluator {
        eval::Evaluator::Within(open, tolerance) => {
            eprintln!(
                "report eval: {} with a relative error of at most {tolerance:e}",
                open.function
            );
        }
        eval::Evaluator::Method(method) if request.tolerance.is_some() => {
            let scale = promise::unit(method.function).map_or(String::new(), |words| format!(", the scale {words}"));
            eprintln!(
                "report eval: method {} promises {}{scale}",
                method.method,
                budget_text::budget_text(method.budget)
            );
        }
        eval::Evaluator::Method(_) => {}
    }
    match eval::evaluate(function, evaluator, io::stdin().lock(), io::stdout().lock()) {
        Ok(eval::End::Complete) => ExitCode::SUCCESS,
        Ok(eval::End::Refused(reason)) => {
            eprintln!("report eval: {reason}");
            ExitCode::from(2)
        }
        Err(e) if e.kind() == io::ErrorKind::BrokenPipe => ExitCode::SUCCESS,
        Err(e) => {
            eprintln!("report eval: {e}");
            ExitCode::FAILURE
        }
    }
}
