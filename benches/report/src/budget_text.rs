//! Budgets in text: `0.75 ulp`, `4e-4 absolute`.

use crate::ledger::parse;
use reference::registry::{Budget, Metric};

/// All measures.
const METRICS: [Metric; 5] = [
    Metric::Ulp,
    Metric::Eps,
    Metric::Absolute,
    Metric::Relative,
    Metric::Peak,
];

/// The name of a measure as written in the ledger.
pub fn metric(m: Metric) -> &'static str {
    match m {
        Metric::Ulp => "ulp",
        Metric::Eps => "eps",
        Metric::Absolute => "absolute",
        Metric::Relative => "relative",
        Metric::Peak => "peak",
    }
}

/// A budget in words: `0.75 ulp`.
pub fn budget_text(b: Option<Budget>) -> String {
    let number = |x: f64| {
        if (1e-3..1e6).contains(&x) {
            format!("{x}")
        } else {
            format!("{x:e}")
        }
    };
    b.map_or(String::new(), |b| format!("{} {}", number(b.bound), metric(b.metric)))
}

/// The budget that a text writes; none for an empty text.
pub fn parse_budget(text: &str) -> Result<Option<Budget>, String> {
    if text.is_empty() {
        return Ok(None);
    }
    let (bound, unit) = text
        .split_once(' ')
        .ok_or_else(|| format!("budget \"{text}\" has no unit"))?;
    let metric = METRICS
        .into_iter()
        .find(|m| metric(*m) == unit)
        .ok_or_else(|| format!("unit of budget \"{text}\""))?;
    Ok(Some(Budget {
        metric,
        bound: parse(bound)?,
    }))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn budgets_survive_writing_and_reading() {
        for (bound, metric, text) in [
            (0.75, Metric::Ulp, "0.75 ulp"),
            (4e-4, Metric::Absolute, "4e-4 absolute"),
            (1e-5, Metric::Peak, "1e-5 peak"),
        ] {
            assert_eq!(budget_text(Some(Budget { metric, bound })), text);
            let read = parse_budget(text).expect("well formed").expect("not empty");
            assert_eq!((read.bound, read.metric), (bound, metric));
        }
        assert!(parse_budget("").expect("empty").is_none());
        assert!(parse_budget("4e-4").is_err() && parse_budget("x ulp").is_err() && parse_budget("1 parsec").is_err());
    }
}
