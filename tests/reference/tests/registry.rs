//! The registry is consistent, its peers are what they claim, and slices equal their scalars bit for bit.

use reference::measure::{accuracy, accuracy_on};
use reference::registry::{Method, Origin, Precision, function, functions, methods};
use reference::{generate, metrics};
use std::collections::HashSet;

fn find(function: &str, method: &str, precision: Precision) -> &'static Method {
    let mut found = methods()
        .iter()
        .filter(|m| m.function == function && m.method == method && m.precision == precision);
    found
        .find(|m| !m.call.is_slice())
        .unwrap_or_else(|| panic!("{function} / {method}"))
}

#[test]
fn every_method_is_registered_once_with_a_function_a_domain_and_a_promise_of_its_own() {
    let mut keys = HashSet::new();
    for m in methods() {
        assert!(
            keys.insert((m.function, m.method, m.precision, m.call.is_slice())),
            "{} / {} twice",
            m.function,
            m.method
        );
        let f = function(m.function).unwrap_or_else(|| panic!("{} is no function", m.function));
        assert_eq!(f.inputs.len(), m.call.columns(), "{} / {}", m.function, m.method);
        assert_eq!(f.inputs.len(), m.domain.columns, "{} / {}", m.function, m.method);
        // What is printed without a bound of its own is held by none; the papers bound the fit of Eq. 29 alone.
        let fitted = m.method == "vwh18" && m.function.contains("integral");
        assert_eq!(
            m.origin == Origin::Ours || fitted,
            m.budget.is_some(),
            "{} / {}",
            m.function,
            m.method
        );
        assert_eq!(f.outputs.len(), m.call.results(), "{} / {}", m.function, m.method);
        for region in &m.regions {
            assert_eq!(f.inputs.len(), region.domain.columns, "{} / {}", m.function, m.method);
            let promised = region.budget.is_some();
            assert_eq!(m.origin == Origin::Ours, promised, "{} / {}", m.function, m.method);
        }
        assert_eq!(m.call.is_slice(), m.slice_of.is_some(), "{} / {}", m.function, m.method);
    }
    for f in functions() {
        assert!(
            methods().iter().any(|m| m.function == f.name && m.method == "accurate"),
            "{}",
            f.name
        );
    }
}

#[test]
fn slices_give_the_bits_of_their_scalars() {
    for slice in methods().iter().filter(|m| m.call.is_slice()) {
        let scalar = find(slice.function, slice.slice_of.expect("checked above"), slice.precision);
        for rows in [(slice.domain.rows)(5, 3001), (slice.domain.rows)(6, 7)] {
            let bits = |m: &Method| m.call.evaluate(&rows).iter().map(|x| x.to_bits()).collect::<Vec<_>>();
            assert!(bits(slice) == bits(scalar), "{} / {}", slice.function, slice.label);
        }
    }
}

#[test]
fn the_peers_of_the_sine_integral_are_as_good_as_their_authors_say() {
    use Precision::{F32, F64};
    for (method, precision, bound) in [
        ("cephes", F64, 4.0),
        ("galsim", F64, 4.0),
        ("cephes_rounded", F32, 0.51),
        ("galsim", F32, 8.0),
    ] {
        let a = accuracy(find("sine_integral", method, precision), 1, 30_000);
        assert!(
            a.max_ulp < bound && a.max_ulp > 0.49,
            "{method}: {} ulp at {:?}",
            a.max_ulp,
            a.worst_input
        );
        assert_eq!(a.non_finite, 0, "{method}");
    }
}

#[test]
fn every_peer_of_the_arc_integrates_ordinary_arcs() {
    let rows = (generate::arcs::ARC_UNIFORM_60.rows)(2, 3000);
    for m in methods()
        .iter()
        .filter(|m| m.origin == Origin::Peer && m.function == "sinc_squared_integral")
    {
        let a = accuracy_on(m, &rows);
        // The quadrature stops early: it meets its tolerance of 1e-15 on no long arc.
        let bound = match (m.precision, m.method) {
            (Precision::F32, _) => 1e-6,
            (Precision::F64, "quadrature") => 1e-11,
            (Precision::F64, _) => 1e-14,
        };
        assert!(a.max_abs < bound, "{}: {} at {:?}", m.method, a.max_abs, a.worst_input);
    }
}

#[test]
fn a_measurement_is_finite_whatever_the_method_does() {
    for m in methods() {
        let a = accuracy(m, 3, 600);
        assert_eq!(a.points, 600);
        let peak = methods_function_has_peak(m);
        assert_eq!(a.max_peak.is_some(), peak, "{} / {}", m.function, m.method);
        for x in [a.max_abs, a.max_rel, a.max_ulp, a.max_eps, a.p999_rel, a.mean_ulp] {
            assert!(x.is_finite() && x <= metrics::MISMATCH, "{} / {}", m.function, m.method);
        }
        assert_eq!(a.worst_input.len(), m.domain.columns);
    }
}

fn methods_function_has_peak(m: &Method) -> bool {
    function(m.function).is_some_and(|f| f.peak.is_some())
}
