//! The figures asked of the crate, each with what the ledger says. The figures are targets, typed here once; what was
//! measured comes from the ledger, the counts of exact properties from [`crate::exact`].

mod diffraction;
mod light;
mod special;

use crate::front::front;
use crate::ledger::Entry;
use crate::tables::short;
use reference::registry::{Origin, Precision};

/// One figure asked for.
#[derive(Clone, Debug, PartialEq)]
pub struct Goal {
    /// Function it is about.
    pub function: &'static str,
    /// What is asked, in words.
    pub asked: &'static str,
    /// What was measured, in words; `None` where the ledger has no such method yet.
    pub measured: Option<(String, bool)>,
}

struct Ledger<'a>(&'a [Entry]);

impl<'a> Ledger<'a> {
    fn find(&self, function: &str, method: &str, precision: Precision, call: &str) -> Option<&'a Entry> {
        self.0.iter().find(|e| {
            let named = e.method == method || (call == "slice" && e.slice_of == method);
            e.function == function && named && e.precision == precision && e.call == call
        })
    }

    fn rows(&self, function: &str, method: &str, precision: Precision, call: &str) -> impl Iterator<Item = &'a Entry> {
        let names = [function, method, call].map(str::to_string);
        self.0
            .iter()
            .filter(move |e| [&e.function, &e.method, &e.call].into_iter().eq(&names) && e.precision == precision)
    }

    fn published(&self, function: &str, precision: Precision, call: &str) -> Option<&'a Entry> {
        self.0.iter().find(|e| {
            e.function == function
                && e.origin == Origin::Published
                && e.precision == precision
                && e.call == call
                && !e.method.contains("printed")
        })
    }

    fn peers(&self, function: &str, precision: Precision) -> impl Iterator<Item = &'a Entry> {
        let function = function.to_string();
        self.0
            .iter()
            .filter(move |e| e.function == function && e.origin == Origin::Peer && e.precision == precision)
    }
}

const SI: &str = "sine_integral";
const ARC: &str = "sinc_squared_integral";
/// Functions on whose fronts no peer may stand.
const FRONTS: [&str; 12] = [
    SI,
    ARC,
    "faddeeva_w",
    "erf_complex",
    "erf_difference_scaled",
    "bessel_i0_scaled",
    "spatial_phase",
    "profile_rectangle",
    "profile_triangle",
    "footprint_mean",
    "sphere_light",
    "polygon_light",
];
use Precision::{F32, F64};

fn at_most(value: f64, bound: f64, unit: &str) -> (String, bool) {
    judged(value, value <= bound, unit)
}

fn at_least(value: f64, bound: f64, unit: &str) -> (String, bool) {
    judged(value, value >= bound, unit)
}

/// A figure in two digits; in three where it is missed, lest it read as the one asked.
fn judged(value: f64, reached: bool, unit: &str) -> (String, bool) {
    let plain = !reached && (0.01..1000.0).contains(&value);
    let text = if plain {
        let digits = (2 - libm::floor(libm::log10(value)) as i32).max(0) as usize;
        format!("{value:.digits$}")
    } else {
        short(value)
    };
    (format!("{text}{unit}"), reached)
}

fn sine_integral(l: &Ledger) -> Vec<Goal> {
    let goal = |asked, measured| Goal {
        function: SI,
        asked,
        measured,
    };
    let own = |method, precision, call| l.find(SI, method, precision, call);
    let ratio = |a: Option<&Entry>, b: Option<&Entry>| Some(a?.ns / b?.ns);
    let accurate = own("accurate", F64, "scalar");
    let cephes = l.peers(SI, F64).find(|e| e.method.starts_with("cephes"));
    let fastest = l
        .peers(SI, F64)
        .filter(|e| e.ns > 0.0)
        .min_by(|a, b| a.ns.total_cmp(&b.ns));
    let (fit, fit_slice) = (l.published(SI, F32, "scalar"), l.published(SI, F32, "slice"));
    let coarse = own("coarse", F32, "scalar");
    vec![
        goal(
            "f64: at most 0.75 ulp",
            accurate.map(|e| at_most(e.max_ulp, 0.75, " ulp")),
        ),
        goal(
            "f64, scalar: at most 1.0 x the time of Cephes",
            ratio(accurate, cephes).map(|r| at_most(r, 1.0, " x")),
        ),
        goal(
            "f64, slices: at least 8 x faster than the fastest scalar peer",
            ratio(fastest, own("accurate", F64, "slice")).map(|r| at_least(r, 8.0, " x")),
        ),
        goal(
            "f32 grade: at most 2 ulp",
            own("accurate", F32, "scalar").map(|e| at_most(e.max_ulp, 2.0, " ulp")),
        ),
        goal(
            "f32 grade, slices: at most 1.3 x the time of the published fit's slices",
            ratio(own("accurate", F32, "slice"), fit_slice).map(|r| at_most(r, 1.3, " x")),
        ),
        goal(
            "4e-4 tier, scalar: at most 1.0 x the time of the published fit",
            ratio(coarse, fit).map(|r| at_most(r, 1.0, " x")),
        ),
        goal(
            "4e-4 tier, slices: at most 1.0 x the time of the published fit's slices",
            ratio(own("coarse", F32, "slice"), fit_slice).map(|r| at_most(r, 1.0, " x")),
        ),
        goal(
            "4e-4 tier: over 100 x more accurate than the published fit",
            fit.zip(coarse)
                .map(|(f, c)| at_least(f.max_abs / c.max_abs, 100.0, " x")),
        ),
    ]
}

fn arc(l: &Ledger) -> Vec<Goal> {
    let goal = |asked, measured| Goal {
        function: ARC,
        asked,
        measured,
    };
    let accurate = l.find(ARC, "accurate", F64, "scalar");
    let single = l.find(ARC, "accurate", F32, "scalar");
    let never = |e: &Entry| {
        (
            format!("{} % of results", short(100.0 * e.wrong_sign)),
            e.wrong_sign == 0.0,
        )
    };
    let calls = accurate
        .zip(l.find(SI, "accurate", F64, "scalar"))
        .map(|(a, s)| a.ns / s.ns);
    vec![
        goal(
            "f64: at most 16 eps, for any arc",
            accurate.map(|e| at_most(e.max_eps, 16.0, " eps")),
        ),
        goal("f64: never the wrong sign", accurate.map(never)),
        goal(
            "f64: at most 2.5 calls of the sine integral",
            calls.map(|r| at_most(r, 2.5, " calls")),
        ),
        goal(
            "f32: 99.9 % of relative errors at most 2e-6",
            single.map(|e| at_most(e.p999_rel, 2e-6, "")),
        ),
        goal("f32: never the wrong sign", single.map(never)),
    ]
}

/// Peers on the front of error against time of a function; of all calls, or of scalar calls alone.
pub fn peers_on_front<'a>(entries: &'a [Entry], function: &str, scalar_only: bool) -> Vec<&'a Entry> {
    on_front(entries, function, scalar_only)
        .into_iter()
        .filter(|e| e.origin == Origin::Peer)
        .collect()
}

/// Methods on the front of error against time, by rising time.
pub fn on_front<'a>(entries: &'a [Entry], function: &str, scalar_only: bool) -> Vec<&'a Entry> {
    let rows: Vec<&Entry> = entries
        .iter()
        .filter(|e| e.function == function && e.ns > 0.0 && (!scalar_only || e.call == "scalar"))
        .collect();
    let points: Vec<[f64; 2]> = rows.iter().map(|e| [e.ns, e.charted()]).collect();
    front(&points).into_iter().map(|i| rows[i]).collect()
}

/// All figures asked for, in order.
pub fn goals(entries: &[Entry]) -> Vec<Goal> {
    let ledger = Ledger(entries);
    let mut all = sine_integral(&ledger);
    all.extend(arc(&ledger));
    all.extend(special::goals(&ledger));
    all.extend(diffraction::goals(&ledger));
    all.extend(light::goals(&ledger));
    for function in FRONTS {
        for (scalar_only, asked) in [
            (false, "no peer on the front"),
            (true, "no peer on the front of scalar calls"),
        ] {
            let timed = entries.iter().any(|e| e.function == function && e.ns > 0.0);
            let peers = peers_on_front(entries, function, scalar_only);
            let names: Vec<&str> = peers.iter().map(|e| e.method.as_str()).collect();
            let text = if names.is_empty() {
                "none".to_string()
            } else {
                names.join(", ")
            };
            all.push(Goal {
                function,
                asked,
                measured: timed.then_some((text, names.is_empty())),
            });
        }
    }
    all
}

/// The figures as a table in Markdown.
pub fn table(entries: &[Entry]) -> String {
    let mut text = "| function | asked | measured | |\n|---|---|---|---|\n".to_string();
    for g in goals(entries) {
        let (measured, state) = match &g.measured {
            Some((m, true)) => (m.as_str(), "reached"),
            Some((m, false)) => (m.as_str(), "missed: stays a goal"),
            None => ("", "not measured"),
        };
        text.push_str(&format!("| `{}` | {} | {measured} | {state} |\n", g.function, g.asked));
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ledger::sample;

    #[test]
    fn goals_are_reached_missed_or_not_measured() {
        let mut entries = vec![
            sample("accurate", Origin::Ours, F64, 10.0, 1e-16),
            sample("cephes", Origin::Peer, F64, 9.0, 3e-16),
        ];
        let of = |entries: &[Entry], asked: &str| {
            goals(entries)
                .into_iter()
                .find(|g| g.asked == asked)
                .expect("asked")
                .measured
                .map(|m| m.1)
        };
        assert_eq!(of(&entries, "f64: at most 0.75 ulp"), Some(true));
        assert_eq!(
            of(&entries, "f64, scalar: at most 1.0 x the time of Cephes"),
            Some(false)
        );
        assert_eq!(of(&entries, "no peer on the front"), Some(false));
        assert_eq!(at_most(1.204, 1.2, " x").0, "1.20 x");
        assert_eq!(at_least(24.96, 25.0, " x"), ("25.0 x".to_string(), false));
        assert_eq!(at_most(2.8e5, 64.0, "").0, "2.8e5");
        assert_eq!(of(&entries, "f32 grade: at most 2 ulp"), None);
        entries[1].ns = 11.0;
        assert_eq!(of(&entries, "no peer on the front"), Some(true));
        assert!(table(&entries).contains("| `sine_integral` | f64: at most 0.75 ulp | 0.70 ulp | reached |"));
    }
}
