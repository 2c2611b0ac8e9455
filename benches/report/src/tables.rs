//! Tables in Markdown, drawn from the ledger alone.

use crate::budget_text::metric;
use crate::ledger::Entry;
use crate::{goals, names, overview};
use reference::registry::{Metric, Origin};

/// A table by name, or what is wrong with the name.
///
/// - `summary`: one row a function, its accurate method in f64 and f32 and the time against the best peer;
/// - `accuracy`: every method of every function;
/// - `accuracy FUNCTION`: every method of one function;
/// - `methods FUNCTION` or `FUNCTION` alone: the crate's own and published methods of one function;
/// - `goals`: the figures asked for, with what was measured.
pub fn table(name: &str, entries: &[Entry]) -> Result<String, String> {
    let words: Vec<&str> = name.split_ascii_whitespace().collect();
    let of = |function: &str| {
        let rows: Vec<&Entry> = entries.iter().filter(|e| e.function == function).collect();
        if rows.is_empty() {
            Err(format!("the ledger has no function \"{function}\""))
        } else {
            Ok(rows)
        }
    };
    match words.as_slice() {
        ["summary"] => Ok(overview::table(entries)),
        ["accuracy"] => Ok(accuracy(&entries.iter().collect::<Vec<_>>(), true)),
        ["accuracy", function] => Ok(accuracy(&of(function)?, false)),
        ["goals"] => Ok(goals::table(entries)),
        ["methods", function] | [function] => Ok(methods(
            &of(function)?
                .into_iter()
                .filter(|e| e.origin != Origin::Peer)
                .collect::<Vec<_>>(),
        )),
        _ => Err(format!("unknown table \"{name}\"")),
    }
}

/// Two significant digits, powers of ten where they are shorter.
pub fn short(value: f64) -> String {
    if value == 0.0 {
        "0".to_string()
    } else if !value.is_finite() || value >= 1e300 {
        "not finite".to_string()
    } else if (0.01..1000.0).contains(&value) {
        let digits = (1 - libm::floor(libm::log10(value)) as i32).max(0) as usize;
        format!("{value:.digits$}")
    } else {
        format!("{value:.1e}")
    }
}

/// An error with its unit.
pub fn with_unit(value: f64, m: Metric) -> String {
    let text = short(value);
    match m {
        Metric::Ulp | Metric::Eps => format!("{text} {}", metric(m)),
        Metric::Absolute => format!("{text} abs."),
        Metric::Relative => format!("{text} rel."),
        Metric::Peak => format!("{text} of peak"),
    }
}

/// The promise of a row, in words.
pub fn promise(e: &Entry) -> String {
    e.budget
        .map_or("none".to_string(), |b| with_unit_exact(b.bound, b.metric))
}

fn with_unit_exact(bound: f64, m: Metric) -> String {
    let unit = match m {
        Metric::Ulp => "ulp",
        Metric::Eps => "eps",
        Metric::Absolute => "abs.",
        Metric::Relative => "rel.",
        Metric::Peak => "of peak",
    };
    let epsilons = bound / f64::EPSILON;
    if (1e-2..1e3).contains(&bound) {
        format!("{bound} {unit}")
    } else if m == Metric::Peak && epsilons < 1e3 && epsilons.fract() == 0.0 {
        format!("{epsilons} eps {unit}")
    } else {
        format!("{bound:e} {unit}")
    }
}

fn cost(e: &Entry) -> String {
    if e.cost.is_finite() {
        format!("{:.2} ({})", e.cost, e.baseline)
    } else {
        "not timed".to_string()
    }
}

fn name(e: &Entry) -> String {
    let form = if e.call == "slice" { ", slice" } else { "" };
    format!("`{}`{form}", e.method)
}

/// What a row is: the method's label, and of its further rows the domain.
fn what(e: &Entry, rows: &[&Entry]) -> String {
    let main = rows.iter().find(|other| other.key() == e.key());
    let text = match main {
        Some(main) if !std::ptr::eq(*main, e) && main.domain == e.domain => "the same, by another measure".to_string(),
        Some(main) if !std::ptr::eq(*main, e) => format!("the same on {}", e.domain),
        _ => e.label.clone(),
    };
    text.replace('|', "\\|")
}

fn worst(e: &Entry) -> String {
    let inputs: Vec<String> = e.worst.iter().map(|x| format!("{x:.6e}")).collect();
    inputs.join(" ")
}

fn accuracy(rows: &[&Entry], with_function: bool) -> String {
    let mut text = String::new();
    let (head, rule) = if with_function {
        ("| function ", "|---")
    } else {
        ("", "")
    };
    text.push_str(&format!(
        "{head}| method | what it is | precision | max abs. error | max rel. error | 99.9 % rel. error | max ulp | wrong sign | promise | time / baseline | worst input |\n"
    ));
    text.push_str(&format!("{rule}|---|---|---|---|---|---|---|---|---|---|---|\n"));
    for e in rows {
        if with_function {
            text.push_str(&format!("| `{}` ", e.function));
        }
        let sign = if e.wrong_sign == 0.0 {
            "none".to_string()
        } else {
            format!("{} %", short(100.0 * e.wrong_sign))
        };
        text.push_str(&format!(
            "| {} | {} ({}) | {} | {} | {} | {} | {} | {sign} | {} | {} | {} |\n",
            name(e),
            what(e, rows),
            names::origin(e.origin),
            names::precision(e.precision),
            short(e.max_abs),
            short(e.max_rel),
            short(e.p999_rel),
            short(e.max_ulp),
            promise(e),
            cost(e),
            worst(e)
        ));
    }
    text
}

fn methods(rows: &[&Entry]) -> String {
    let mut text = "| method | what it is | precision | largest error | promise | time / baseline |\n".to_string();
    text.push_str("|---|---|---|---|---|---|\n");
    for e in rows {
        let error = with_unit(
            e.measured(e.budget.map_or(Metric::Relative, |b| b.metric)),
            e.budget.map_or(Metric::Relative, |b| b.metric),
        );
        text.push_str(&format!(
            "| {} | {} | {} | {error} | {} | {} |\n",
            name(e),
            what(e, rows),
            names::precision(e.precision),
            promise(e),
            cost(e)
        ));
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ledger::sample;
    use reference::registry::Precision;

    #[test]
    fn numbers_are_short_and_keep_two_digits() {
        for (value, text) in [
            (0.0, "0"),
            (0.523, "0.52"),
            (0.0512, "0.051"),
            (15.97, "16"),
            (1.234e-16, "1.2e-16"),
            (86.0, "86"),
            (1e308, "not finite"),
        ] {
            assert_eq!(short(value), text);
        }
    }

    #[test]
    fn a_promise_of_epsilons_of_the_peak_says_so() {
        assert_eq!(with_unit_exact(6.0 * f64::EPSILON, Metric::Peak), "6 eps of peak");
        assert_eq!(with_unit_exact(1e-5, Metric::Peak), "1e-5 of peak");
        assert_eq!(with_unit_exact(0.75, Metric::Ulp), "0.75 ulp");
    }

    #[test]
    fn further_rows_of_a_method_say_on_which_domain_they_are() {
        let mut entries = [0; 3].map(|_| sample("accurate", Origin::Ours, Precision::F64, 10.0, 1e-16));
        entries[2].domain = "|z| < 2".to_string();
        let text = table("accuracy sine_integral", &entries).expect("known");
        let rows: Vec<&str> = text.lines().skip(2).collect();
        for (row, what) in rows.iter().zip([
            "| accurate, in words (ours) |",
            "| the same, by another measure (ours) |",
            "| the same on \\|z\\| < 2 (ours) |",
        ]) {
            assert!(row.contains(what), "{row}");
        }
    }

    #[test]
    fn a_table_of_methods_leaves_peers_out_and_an_unknown_name_is_refused() {
        let entries = [
            sample("accurate", Origin::Ours, Precision::F64, 10.0, 1e-16),
            sample("cephes", Origin::Peer, Precision::F64, 20.0, 3e-16),
        ];
        let text = table("methods sine_integral", &entries).expect("known");
        assert!(text.contains("`accurate`") && !text.contains("`cephes`"));
        assert_eq!(text.lines().count(), 3);
        assert!(table("accuracy", &entries).expect("known").contains("`cephes`"));
        assert!(table("methods sinus", &entries).is_err() && table("speed", &entries).is_err());
    }
}
