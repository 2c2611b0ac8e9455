//! What a run found, in words.

use crate::budget_text::budget_text;
use crate::goals::{goals, on_front};
use crate::ledger::Entry;
use crate::promise;
use crate::tables::{short, with_unit};
use crate::{hex_float, names};
use reference::registry::Origin;
use std::fmt::Write;

fn title(e: &Entry) -> String {
    let slice = if e.call == "slice" { " slices" } else { "" };
    format!("{} ({}{slice})", e.method, names::precision(e.precision))
}

/// The summary of a ledger.
pub fn text(entries: &[Entry]) -> String {
    let mut out = String::new();
    let mut functions: Vec<&str> = Vec::new();
    for e in entries {
        if !functions.contains(&e.function.as_str()) {
            functions.push(&e.function);
        }
    }
    for function in functions {
        let _ = writeln!(out, "{function}");
        for (scalar_only, what) in [(false, "front of error against time"), (true, "front of scalar calls")] {
            let front: Vec<String> = on_front(entries, function, scalar_only)
                .iter()
                .map(|e| format!("{} {} ns {}", title(e), short(e.ns), short(e.charted())))
                .collect();
            let _ = writeln!(out, "  {what}: {}", front.join("; "));
        }
        for e in entries
            .iter()
            .filter(|e| e.function == function && e.origin == Origin::Ours)
        {
            let Some(budget) = e.budget else { continue };
            let inputs: Vec<String> = e.worst.iter().map(|&x| hex_float::format(x)).collect();
            let _ = writeln!(
                out,
                "  {}: at most {} on {} points, promised {}, worst at {}",
                title(e),
                with_unit(e.measured(budget.metric), budget.metric),
                e.points,
                budget_text(e.budget),
                inputs.join(" ")
            );
        }
        let wrong: Vec<String> = entries
            .iter()
            .filter(|e| e.function == function && e.wrong_sign > 0.0)
            .map(|e| format!("{} {} %", title(e), short(100.0 * e.wrong_sign)))
            .collect();
        if !wrong.is_empty() {
            let _ = writeln!(out, "  wrong sign: {}", wrong.join("; "));
        }
    }
    let complaints: Vec<String> = entries.iter().filter_map(promise::complaint).collect();
    let promised = entries.iter().filter(|e| e.budget.is_some()).count();
    let _ = writeln!(
        out,
        "budgets: {} of {promised} kept and tight",
        promised - complaints.len()
    );
    for complaint in complaints {
        let _ = writeln!(out, "  {complaint}");
    }
    let goals = goals(entries);
    let reached = goals.iter().filter(|g| matches!(g.measured, Some((_, true)))).count();
    let _ = writeln!(out, "figures asked: {reached} of {} reached", goals.len());
    for g in goals {
        let (state, measured) = match g.measured {
            Some((m, true)) => ("reached", m),
            Some((m, false)) => ("MISSED ", m),
            None => ("absent ", "no such method in the ledger".to_string()),
        };
        let _ = writeln!(out, "  {state}  {}: {}: {measured}", g.function, g.asked);
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ledger::sample;
    use reference::registry::{Budget, Metric, Precision};

    #[test]
    fn the_summary_names_front_budgets_and_goals() {
        let mut entry = sample("accurate", Origin::Ours, Precision::F64, 10.0, 1e-16);
        let kept = text(std::slice::from_ref(&entry));
        assert!(kept.contains("budgets: 1 of 1 kept and tight"), "{kept}");
        assert!(
            kept.contains("front of error against time: accurate (f64) 10 ns 1.0e-16"),
            "{kept}"
        );
        assert!(
            kept.contains("reached  sine_integral: f64: at most 0.75 ulp: 0.70 ulp"),
            "{kept}"
        );
        entry.budget = Some(Budget {
            metric: Metric::Ulp,
            bound: 0.6,
        });
        let broken = text(&[entry]);
        assert!(
            broken.contains("budgets: 0 of 1") && broken.contains("is broken"),
            "{broken}"
        );
    }
}
