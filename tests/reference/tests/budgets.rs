//! Every promise holds on the domain it is made for, none is more than four times too loose, nothing has a wrong sign.

use reference::measure::accuracy;
use reference::registry::{Budget, Metric, Origin, methods};

const POINTS: usize = 60_000;

#[test]
fn every_method_keeps_its_budget_and_no_budget_is_four_times_too_loose() {
    let mut broken = Vec::new();
    for m in methods() {
        let Some(budget) = m.budget else { continue };
        let a = accuracy(m, 20180813, POINTS);
        let name = format!("{} / {} ({})", m.function, m.method, m.label);
        if let Err(reason) = budget.judge(a.maximum(budget.metric)) {
            broken.push(format!("{name}: {reason} at {:?}", a.worst_input));
        }
        if m.origin == Origin::Ours && a.wrong_sign > 0 {
            broken.push(format!("{name}: {} wrong signs", a.wrong_sign));
        }
        if a.non_finite > 0 {
            broken.push(format!("{name}: {} results not finite", a.non_finite));
        }
    }
    assert!(broken.is_empty(), "\n{}", broken.join("\n"));
}

#[test]
fn a_broken_and_a_loose_budget_are_both_refused() {
    let budget = Budget {
        metric: Metric::Ulp,
        bound: 2.0,
    };
    assert!(budget.judge(2.0).is_ok() && budget.judge(0.5).is_ok());
    assert!(budget.judge(2.01).is_err());
    assert!(budget.judge(0.49).is_err());
    assert!(budget.judge(f64::NAN).is_err());
}
