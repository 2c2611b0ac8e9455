//! Promises of our own methods, measured: on fresh points here, and on the committed ledger.

use reference::measure::{Accuracy, accuracy};
use reference::registry::{Budget, Method, Origin, methods};
use report::budget_text;
use report::ledger::Entry;
use report::promise::{Verdict, complaint, judge, verdict};
use report::{measured, names, run};

/// Points for each method; the ledger itself has many more.
const POINTS: usize = 3000;

fn entry(method: &Method, a: Accuracy) -> Entry {
    measured::entry(names::function(method.function).expect("registered"), method, a)
}

fn promising() -> impl Iterator<Item = &'static Method> {
    methods().iter().filter(|m| m.budget.is_some())
}

#[test]
fn every_promise_is_kept_on_points_of_another_seed() {
    let mut broken = Vec::new();
    for m in promising().flat_map(Method::on_each_domain) {
        let e = entry(&m, accuracy(&m, measured::SEED + 1, POINTS));
        if verdict(&e) == Some(Verdict::Broken) {
            broken.extend(complaint(&e));
        }
    }
    assert!(broken.is_empty(), "{}", broken.join("\n"));
}

#[test]
fn every_own_method_promises_something() {
    for m in methods().iter().filter(|m| m.origin == Origin::Ours) {
        assert!(m.budget.is_some(), "{} / {}", m.function, m.method);
    }
}

#[test]
fn the_committed_ledger_keeps_every_promise_within_a_factor_of_four() {
    let entries = run::committed().expect("the ledger is committed").entries;
    let complaints: Vec<String> = entries.iter().filter_map(complaint).collect();
    assert!(complaints.is_empty(), "{}", complaints.join("\n"));
    for m in promising() {
        let found = entries
            .iter()
            .find(|e| e.key() == (m.function, m.method, m.precision, names::call(&m.call)))
            .unwrap_or_else(|| panic!("{} / {} is not in the ledger", m.function, m.method));
        assert_eq!(
            budget_text::budget_text(found.budget),
            budget_text::budget_text(m.budget),
            "{} / {}",
            m.function,
            m.method
        );
    }
}

#[test]
fn a_promise_four_times_too_loose_or_too_tight_is_found() {
    let m = promising().find(|m| m.function == "sine_integral").expect("registered");
    let mut e = entry(m, accuracy(m, measured::SEED, POINTS));
    let budget = e.budget.expect("promised");
    let found = e.measured(budget.metric);
    e.budget = Some(Budget {
        bound: 4.0 * found * 1.000001,
        ..budget
    });
    assert_eq!(verdict(&e), Some(Verdict::TooLoose));
    assert!(complaint(&e).expect("too loose").contains("four times too loose"));
    e.budget = Some(Budget {
        bound: 4.0 * found,
        ..budget
    });
    assert_eq!(verdict(&e), Some(Verdict::Kept));
    e.budget = Some(Budget {
        bound: found * 0.999999,
        ..budget
    });
    assert_eq!(verdict(&e), Some(Verdict::Broken));
    assert_eq!(judge(0.0, 0.0), Verdict::Kept);
}
