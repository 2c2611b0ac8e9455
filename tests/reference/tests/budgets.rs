//! Every promise holds on the domain it is made for, none is more than four times too loose, nothing has a wrong sign.

use reference::generate::random::neighbour_f32;
use reference::measure::{accuracy, accuracy_on};
use reference::registry::{Budget, Method, Metric, Origin, Precision, function, methods};
use std::f64::consts::PI;

const POINTS: usize = 60_000;

/// Functions with zeros inside their domain, of which an absolute bound says no sign.
const CROSSING_ZERO: [&str; 4] = ["sine", "cosine", "sphere_light_chord", "quad_light_chord"];

#[test]
fn every_method_keeps_its_budget_and_no_budget_is_four_times_too_loose() {
    let mut broken = Vec::new();
    for m in methods().iter().flat_map(Method::on_each_domain) {
        let Some(budget) = m.budget else { continue };
        let complex = m.call.results() == 2;
        // Fewer where an oracle takes a quarter of a millisecond.
        let slow = function(m.function).map_or(1, |f| (f.thinning / 40).max(1));
        let a = accuracy(&m, 20180813, if complex { POINTS / 6 } else { POINTS / slow });
        let name = format!("{} / {} ({}) on {}", m.function, m.method, m.label, m.domain.name);
        if let Err(reason) = budget.judge(a.maximum(budget.metric)) {
            broken.push(format!("{name}: {reason} at {:?}", a.worst_input));
        }
        if m.origin == Origin::Ours && !complex && !CROSSING_ZERO.contains(&m.function) && a.wrong_sign > 0 {
            broken.push(format!("{name}: {} wrong signs", a.wrong_sign));
        }
        if a.non_finite > 0 {
            broken.push(format!("{name}: {} results not finite", a.non_finite));
        }
    }
    assert!(broken.is_empty(), "\n{}", broken.join("\n"));
}

/// The f32 arcs, scalar and slice, with the relative error that their name promises.
fn graded_arcs() -> impl Iterator<Item = (&'static Method, f64)> {
    let arcs = methods()
        .iter()
        .filter(|m| m.precision == Precision::F32 && m.origin == Origin::Ours);
    arcs.filter(|m| m.function.starts_with("sinc_squared_integral"))
        .map(|m| {
            let grade = match m.method {
                "accurate" => 2e-6,
                "medium" => 1e-5,
                "coarse" => 4e-4,
                other => panic!("{other} has no grade"),
            };
            (m, grade)
        })
}

#[test]
fn of_1000_f32_arcs_999_keep_the_relative_error_of_their_grade() {
    let mut count = 0;
    for (m, grade) in graded_arcs() {
        let a = accuracy(m, 27, 4 * POINTS);
        assert!(
            a.p999_rel <= grade && grade <= 8.0 * a.p999_rel,
            "{} / {}: {:e}, promised {grade:e}",
            m.function,
            m.label,
            a.p999_rel
        );
        count += 1;
    }
    assert_eq!(count, 7);
}

/// Arcs of 1 to 300 f32 neighbours that begin within 6 neighbours of n pi, where the integrand has its double zeros.
#[test]
fn the_worst_f32_arcs_lie_beside_a_zero_of_the_sine_and_keep_three_digits() {
    let mut rows = Vec::new();
    for n in 1..160 {
        for steps in -6..=6 {
            let q0 = neighbour_f32(f64::from(n) * PI, steps);
            let ends = [1, 2, 3, 5, 8, 16, 64, 300].map(|length| neighbour_f32(q0, length));
            rows.extend(ends.into_iter().filter(|&q1| q1 <= 500.0).flat_map(|q1| [q0, q1]));
        }
    }
    for (m, _) in graded_arcs().filter(|(m, _)| m.domain.columns == 2) {
        let worst = accuracy_on(m, &rows);
        assert!(worst.max_rel <= 1e-3, "{}: {:e}", m.label, worst.max_rel);
        let elsewhere = accuracy(m, 28, POINTS).p999_rel;
        assert!(worst.p999_rel > elsewhere, "{}: {:e}", m.label, worst.p999_rel);
        assert_eq!(worst.wrong_sign, 0, "{}", m.label);
    }
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
