//! The figures asked of w, the complex error function, the scaled erf difference and the scaled Bessel function.

use super::Precision::{F32, F64};
use super::{Goal, Ledger, at_least, at_most};
use crate::exact::{self, Violations};
use crate::ledger::Entry;

/// The figures, in order.
pub(super) fn goals(l: &Ledger) -> Vec<Goal> {
    const W: &str = "faddeeva_w";
    const ERF: &str = "erf_complex";
    const DIFFERENCE: &str = "erf_difference_scaled";
    const BESSEL: &str = "bessel_i0_scaled";
    let goal = |function, asked, measured| Goal {
        function,
        asked,
        measured,
    };
    let on = |function, domain: &str| {
        let mut rows = l.rows(function, "accurate", F64, "scalar");
        rows.find(|e| e.domain.starts_with(domain))
    };
    let w = |precision, call| l.find(W, "accurate", precision, call);
    let ratio = |a: Option<&Entry>, b: Option<&Entry>| Some(a?.ns / b?.ns);
    let peer = |function: &str, name: &str, precision| l.peers(function, precision).find(|e| e.method == name);
    let crate_w = peer(W, "errorfunctions", F64);
    let eps = |e: &Entry, bound| at_most(e.max_eps, bound, " eps");
    let non_finite: Vec<&Entry> = l.rows(DIFFERENCE, "accurate", F64, "scalar").collect();
    let count: u64 = non_finite.iter().map(|e| e.non_finite).sum();
    let most = |of: fn(&Entry) -> f64| non_finite.iter().map(|e| of(e)).reduce(f64::max);
    let exactly = |of: fn(&Violations) -> usize| {
        (!non_finite.is_empty()).then(|| {
            let broken = of(&exact::of_erf_difference());
            (format!("broken by {broken} of {} rows", exact::ROWS), broken == 0)
        })
    };
    let single = l.find(DIFFERENCE, "turns", F32, "scalar");
    let bessel = |precision| l.find(BESSEL, "accurate", precision, "scalar");
    let cephes = peer(BESSEL, "cephes", F64);
    vec![
        goal(
            W,
            "f64, upper half plane: at most 2 eps by norm",
            w(F64, "scalar").map(|e| eps(e, 2.0)),
        ),
        goal(
            W,
            "f64, upper half plane: each component at most 8 ulp",
            w(F64, "scalar").map(|e| at_most(e.max_ulp, 8.0, " ulp")),
        ),
        goal(
            W,
            "f64, lower half plane away from zeros: at most 16 eps",
            on(W, "y < 0").map(|e| eps(e, 16.0)),
        ),
        goal(
            W,
            "f64, around the first 8 zeros: at most 64 eps",
            on(W, "within 0.1").map(|e| eps(e, 64.0)),
        ),
        goal(
            ERF,
            "f64, around the first 8 zeros: at most 64 eps",
            on(ERF, "within 0.1").map(|e| eps(e, 64.0)),
        ),
        goal(
            W,
            "f64, scalar: at most 0.8 x the time of libcerf",
            ratio(w(F64, "scalar"), peer(W, "libcerf", F64)).map(|r| at_most(r, 0.8, " x")),
        ),
        goal(
            W,
            "f64, scalar: at most 0.5 x the time of errorfunctions",
            ratio(w(F64, "scalar"), crate_w).map(|r| at_most(r, 0.5, " x")),
        ),
        goal(
            W,
            "f64, slices: at least 15 x faster than errorfunctions",
            ratio(crate_w, w(F64, "slice")).map(|r| at_least(r, 15.0, " x")),
        ),
        goal(W, "f32: at most 4 eps by norm", w(F32, "scalar").map(|e| eps(e, 4.0))),
        goal(
            W,
            "f32, slices: at least 40 x faster than errorfunctions",
            ratio(crate_w, w(F32, "slice")).map(|r| at_least(r, 40.0, " x")),
        ),
        goal(
            DIFFERENCE,
            "f64: no result that is not finite",
            (!non_finite.is_empty()).then(|| (count.to_string(), count == 0)),
        ),
        goal(
            DIFFERENCE,
            "f64: at most 6 eps of the value at b = 0",
            most(|e| e.max_peak / f64::EPSILON).map(|e| at_most(e, 6.0, " eps")),
        ),
        goal(
            DIFFERENCE,
            "f64: relative error at most 64 eps",
            most(|e| e.max_eps).map(|e| at_most(e, 64.0, " eps")),
        ),
        goal(
            DIFFERENCE,
            "f32, phases in turns: at most 1e-5 of the value at b = 0",
            single.map(|e| at_most(e.max_peak, 1e-5, "")),
        ),
        goal(DIFFERENCE, "f64: equal ends give exactly 0", exactly(|v| v.equal_ends)),
        goal(
            DIFFERENCE,
            "f64: exchanged ends give exactly the negative",
            exactly(|v| v.exchanged_ends),
        ),
        goal(
            DIFFERENCE,
            "f64: a negative b gives exactly the conjugate",
            exactly(|v| v.conjugate),
        ),
        goal(
            BESSEL,
            "f64: at most 1.0 ulp",
            bessel(F64).map(|e| at_most(e.max_ulp, 1.0, " ulp")),
        ),
        goal(
            BESSEL,
            "f32: at most 1 ulp",
            bessel(F32).map(|e| at_most(e.max_ulp, 1.0, " ulp")),
        ),
        goal(
            BESSEL,
            "f64: at most 1.5 x the time of Cephes",
            ratio(bessel(F64), cephes).map(|r| at_most(r, 1.5, " x")),
        ),
    ]
}
