//! Searches for the inputs on which our methods err most and appends the new ones to `data/worst`.
//!
//! `cargo run --release -p reference --example worst -- [points]`
//!
//! A row is appended to its function's file where a method of ours errs more than on everything recorded there and by more
//! than half its budget.

use reference::generate::worst;
use reference::hexadecimal;
use reference::measure::{accuracy, accuracy_on};
use reference::registry::{Method, Origin, Precision, functions, methods};
use std::io::Write;

/// The recorded rows that a method of this precision is judged on.
fn judged(rows: &[f64], columns: usize, precision: Precision) -> Vec<f64> {
    let single = |row: &&[f64]| row.iter().all(|&x| f64::from(x as f32) == x);
    rows.chunks(columns)
        .filter(|row| precision == Precision::F64 || single(row))
        .flatten()
        .copied()
        .collect()
}

fn main() -> std::io::Result<()> {
    let points: usize = std::env::args()
        .nth(1)
        .map_or(1_000_000, |word| word.parse().expect("a number of points"));
    let seed = std::time::SystemTime::now()
        .duration_since(std::time::UNIX_EPOCH)
        .map_or(1, |t| t.as_secs());
    for f in functions() {
        let columns = f.inputs.len();
        let mut recorded: Vec<f64> = worst::recorded_for(&[f.name]).into_iter().flatten().collect();
        let mut found = Vec::new();
        let own = methods()
            .iter()
            .filter(|m| m.function == f.name && m.origin == Origin::Ours && !m.call.is_slice());
        for m in own.flat_map(Method::on_each_domain) {
            let budget = m.budget.expect("each of our methods has a budget");
            let before = accuracy_on(&m, &judged(&recorded, columns, m.precision)).maximum(budget.metric);
            let now = accuracy(&m, seed, points / f.thinning);
            let error = now.maximum(budget.metric);
            println!(
                "{} / {} on {}: {error:.4e} {:?} at {:?}, recorded {before:.4e}",
                f.name, m.label, m.domain.name, budget.metric, now.worst_input
            );
            if error > before && error > 0.5 * budget.bound {
                recorded.extend(&now.worst_input);
                found.push(now.worst_input);
            }
        }
        let path = format!("{}/../../data/worst/{}.csv", env!("CARGO_MANIFEST_DIR"), f.name);
        let mut file = std::fs::OpenOptions::new().append(true).open(path)?;
        for row in found {
            let words: Vec<String> = row.iter().map(|&x| hexadecimal::format(x)).collect();
            writeln!(file, "{}", words.join(","))?;
        }
    }
    Ok(())
}
