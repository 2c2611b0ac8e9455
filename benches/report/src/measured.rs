//! The measuring part of a run: errors against the oracle, times against the peers, the series behind the plots.

use crate::ledger::Entry;
use crate::names::{self, methods_of};
use crate::{series, timing};
use indicatif::{ProgressBar, ProgressStyle};
use reference::measure::{self, Accuracy};
use reference::metrics::Truth;
use reference::registry::{Function, Method, Origin, Precision, functions};
use std::time::Duration;

/// Seed of all generators.
pub const SEED: u64 = 20180813;

/// How much is measured.
#[derive(Clone, Copy)]
pub struct Effort {
    /// Points for each method's error.
    pub points: usize,
    /// Points in each interval of the ulp plot.
    pub samples: usize,
    /// Longest time for the timing of one function.
    pub timing: Duration,
    /// Time for each of its methods.
    pub method: Duration,
}

/// Effort of a full run; `--check` repeats its errors.
pub const FULL: Effort = Effort {
    points: 1_000_000,
    samples: 24,
    timing: Duration::from_secs(3),
    method: Duration::from_millis(250),
};
/// Effort of `--quick`.
pub const QUICK: Effort = Effort {
    points: 4_000,
    samples: 3,
    timing: Duration::from_millis(500),
    method: Duration::from_millis(50),
};

/// A bar on standard error, absent where that is no terminal.
pub fn bar(length: u64) -> ProgressBar {
    let style = ProgressStyle::with_template("{bar:40} {pos}/{len} {msg}").expect("the template is fixed");
    ProgressBar::new(length).with_style(style)
}

/// Whether every f32 input is tried: `exhaustive_f32` of the reference package does, and holds that its worst input is
/// among the points measured here.
fn is_swept(method: &Method) -> bool {
    method.function == "sine_integral" && method.precision == Precision::F32 && method.origin != Origin::Peer
}

/// The row of one method, without its time.
pub fn entry(function: &Function, method: &Method, a: Accuracy) -> Entry {
    Entry {
        function: function.name.to_string(),
        method: method.method.to_string(),
        precision: method.precision,
        origin: method.origin,
        call: names::call(&method.call).to_string(),
        slice_of: method.slice_of.unwrap_or_default().to_string(),
        label: method.label.to_string(),
        device: String::new(),
        domain: method.domain.domain.to_string(),
        points: a.points as u64,
        exhaustive: is_swept(method),
        budget: method.budget,
        max_abs: a.max_abs,
        max_rel: a.max_rel,
        p999_rel: a.p999_rel,
        max_ulp: a.max_ulp,
        max_eps: a.max_eps,
        max_peak: a.max_peak.unwrap_or(f64::NAN),
        wrong_sign: a.wrong_sign as f64 / a.points as f64,
        non_finite: a.non_finite as u64,
        worst: a.worst_input,
        reference: function.oracle_name.to_string(),
        ns: f64::NAN,
        cost: f64::NAN,
        baseline: String::new(),
    }
}

/// Errors of all methods of all functions.
pub fn accuracies(effort: Effort) -> Vec<Entry> {
    let count: usize = functions().iter().map(|f| methods_of(f.name).count()).sum();
    let progress = bar(count as u64);
    let mut entries = Vec::with_capacity(count);
    for f in functions() {
        // Methods of one domain share its points and their truths.
        let mut shared: Vec<(&str, Vec<f64>, Vec<Truth>)> = Vec::new();
        for m in methods_of(f.name) {
            progress.set_message(format!(
                "error of {} / {} ({})",
                f.name,
                m.method,
                names::precision(m.precision)
            ));
            for m in m.on_each_domain() {
                let domain = m.domain.name;
                if !shared.iter().any(|(name, ..)| *name == domain) {
                    let rows = (m.domain.rows)(SEED, effort.points / f.thinning);
                    let truths = measure::truths(f, &rows);
                    shared.push((domain, rows, truths));
                }
                for (_, rows, truths) in shared.iter().filter(|(name, ..)| *name == domain) {
                    entries.push(entry(f, &m, measure::accuracy_against(&m, rows, truths)));
                }
            }
            progress.inc(1);
        }
    }
    progress.finish_and_clear();
    entries
}

/// Times all methods and fills in the columns that come from the clock.
pub fn times(entries: &mut [Entry], effort: Effort) {
    let device = timing::device();
    let progress = bar(functions().len() as u64);
    for f in functions() {
        progress.set_message(format!("time of {}", f.name));
        let methods: Vec<&Method> = methods_of(f.name).collect();
        let budget = effort.timing.min(effort.method * methods.len() as u32);
        let ns = timing::measure(&methods, budget, || progress.tick());
        for (m, &time) in methods.iter().zip(&ns) {
            let key = (m.function, m.method, m.precision, names::call(&m.call));
            let base = timing::baseline(&methods, m);
            let base_time = base
                .and_then(|b| methods.iter().position(|x| std::ptr::eq(*x, b)))
                .map(|i| ns[i]);
            if let Some(e) = entries.iter_mut().find(|e| e.key() == key) {
                e.device.clone_from(&device);
                e.ns = time;
                e.cost = base_time.map_or(f64::NAN, |b| time / b);
                e.baseline = base.map_or(String::new(), |b| timing::baseline_name(m, b));
            }
        }
        progress.inc(1);
    }
    progress.finish_and_clear();
}

fn find(function: &str, want: impl Fn(&Method) -> bool) -> Result<&'static Method, String> {
    methods_of(function)
        .find(|m| m.precision == Precision::F64 && names::call(&m.call) == "scalar" && want(m))
        .ok_or_else(|| format!("{function} has no such f64 method"))
}

/// The best peer of a function: the f64 peer with the smallest largest error in ulp.
pub fn best_peer(function: &str, entries: &[Entry]) -> Result<&'static Method, String> {
    let best = entries
        .iter()
        .filter(|e| e.function == function && e.origin == Origin::Peer && e.precision == Precision::F64)
        .min_by(|a, b| a.max_ulp.total_cmp(&b.max_ulp))
        .ok_or_else(|| format!("{function} has no f64 peer"))?;
    find(function, |m| m.method == best.method)
}

/// The ulp plot as CSV, with this peer.
pub fn ulp(peer: &Method, effort: Effort) -> Result<String, String> {
    let function = names::function(peer.function)?;
    let ours = find(peer.function, |m| m.origin == Origin::Ours)?;
    Ok(series::write_ulp(
        &series::ulp_bins(function, ours, peer, effort.samples),
        peer.method,
    ))
}

/// The failure map as CSV.
pub fn map() -> Result<String, String> {
    let function = names::function("sinc_squared_integral")?;
    let published = find("sinc_squared_integral", |m| m.method == "vwh18")?;
    let ours = find("sinc_squared_integral", |m| m.origin == Origin::Ours)?;
    Ok(series::write_map(&series::failure_map(function, published, ours)))
}
