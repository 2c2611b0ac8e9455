//! The short table of README.md: one row a function, drawn from the ledger alone.

use crate::ledger::Entry;
use crate::tables::{promise, short};
use reference::registry::{Origin, Precision};

/// The accurate method of a function: its row on its main domain, in one precision and kind of call.
fn accurate<'a>(entries: &'a [Entry], function: &str, precision: Precision, call: &str) -> Option<&'a Entry> {
    let key = (function, "accurate", precision, call);
    entries.iter().find(|e| e.origin == Origin::Ours && e.key() == key)
}

/// The peer whose time ours is a ratio to.
enum Rival<'a> {
    /// No peer is timed.
    None,
    /// Every timed peer gives results that are not finite where the truth is.
    NoneFinite,
    /// The fastest that keeps a correct digit; where none does, the fastest that is finite.
    Best(&'a Entry),
}

fn best_peer<'a>(entries: &'a [Entry], function: &str, precision: Precision) -> Rival<'a> {
    let peers = || {
        let of_function = entries.iter().filter(|e| e.function == function && e.ns > 0.0);
        of_function.filter(|e| e.origin == Origin::Peer && e.precision == precision)
    };
    let by_time = |a: &&Entry, b: &&Entry| a.ns.total_cmp(&b.ns);
    let finite = || peers().filter(|e| e.non_finite == 0);
    let kept = peers().filter(|e| e.charted() < 1.0).min_by(by_time);
    match kept.or_else(|| finite().min_by(by_time)) {
        Some(peer) => Rival::Best(peer),
        None if peers().next().is_some() => Rival::NoneFinite,
        None => Rival::None,
    }
}

/// The largest error of a row, of the one it promises.
fn error(own: Option<&Entry>) -> String {
    own.zip(own.and_then(|e| e.budget))
        .map_or(String::new(), |(e, budget)| {
            let promised = promise(e);
            let unit = if promised.ends_with("eps of peak") {
                f64::EPSILON
            } else {
                1.0
            };
            format!("{} of {promised}", short(e.measured(budget.metric) / unit))
        })
}

/// Times of the scalar and the slice form as multiples of the best peer's.
fn time(entries: &[Entry], function: &str, precision: Precision) -> String {
    let peer = match best_peer(entries, function, precision) {
        Rival::None => return String::new(),
        Rival::NoneFinite => return "no peer is finite".to_string(),
        Rival::Best(peer) => peer,
    };
    let ratio = |call: &str| {
        let own = accurate(entries, function, precision, call).filter(|e| e.ns > 0.0);
        own.map(|e| short(e.ns / peer.ns))
    };
    match (ratio("scalar"), ratio("slice")) {
        (Some(scalar), Some(slice)) => format!("{scalar}, slices {slice} ({})", peer.method),
        (Some(scalar), None) => format!("{scalar} ({})", peer.method),
        _ => String::new(),
    }
}

/// The table: errors as `measured of promised`, times as multiples of the best peer's.
pub fn table(entries: &[Entry]) -> String {
    let mut text = "| function | f64: largest error of the promised | f64: time / best peer |".to_string();
    text.push_str(" f32: largest error of the promised | f32: time / best peer |\n|---|---|---|---|---|\n");
    let mut functions: Vec<&str> = Vec::new();
    for e in entries.iter().filter(|e| e.origin == Origin::Ours) {
        if !functions.contains(&e.function.as_str()) {
            functions.push(&e.function);
        }
    }
    for function in functions {
        text.push_str(&format!("| `{function}` |"));
        for precision in [Precision::F64, Precision::F32] {
            let own = accurate(entries, function, precision, "scalar");
            let time = own.map_or(String::new(), |_| time(entries, function, precision));
            for cell in [error(own), time] {
                text.push_str(&format!(" {cell} |"));
            }
        }
        text.push('\n');
    }
    text.replace("|  |", "| |").replace("|  |", "| |")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ledger::sample;
    use reference::registry::{Budget, Metric, Precision::F32, Precision::F64};

    #[test]
    fn one_row_a_function_with_the_times_against_the_fastest_peer_that_keeps_a_digit() {
        let mut entries = vec![
            sample("accurate", Origin::Ours, F64, 10.0, 1e-16),
            sample("accurate", Origin::Ours, F64, 2.5, 1e-16),
            sample("accurate", Origin::Ours, F32, 4.0, 1e-7),
            sample("coarse", Origin::Ours, F32, 1.0, 1e-3),
            sample("cephes", Origin::Peer, F64, 20.0, 3e-16),
            sample("wild", Origin::Peer, F64, 5.0, 3.0),
            sample("vwh18", Origin::Published, F32, 1.0, 1e-2),
        ];
        entries[1].call = "slice".to_string();
        entries[0].budget = Some(Budget {
            metric: Metric::Ulp,
            bound: 0.75,
        });
        let text = table(&entries);
        let rows: Vec<&str> = text.lines().collect();
        assert_eq!(rows.len(), 3, "{text}");
        assert_eq!(
            rows[2],
            "| `sine_integral` | 0.70 of 0.75 ulp | 0.50, slices 0.12 (cephes) | 1.0e-7 of 2e-7 rel. | |"
        );
        entries[0].max_peak = 3.0 * f64::EPSILON;
        entries[0].budget = Some(Budget {
            metric: Metric::Peak,
            bound: 6.0 * f64::EPSILON,
        });
        assert!(
            table(&entries).contains("| 3.0 of 6 eps of peak |"),
            "{}",
            table(&entries)
        );
        // Where no peer keeps a digit, the fastest of them that is finite; and it is said where none is.
        entries[4].max_rel = 2.0;
        assert!(table(&entries).contains("| 2.0, slices 0.50 (wild) |"));
        entries[5].non_finite = 3;
        assert!(table(&entries).contains("| 0.50, slices 0.12 (cephes) |"));
        entries[4].non_finite = 1;
        assert!(table(&entries).contains("| no peer is finite |"));
    }
}
