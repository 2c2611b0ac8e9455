//! Our methods at infinities, at NaN, beyond the domains of the ledger, and where a result is exactly known.

use iridescence::{shader, special};
use reference::generate::{arcs, points};
use reference::metrics::{eps_error, ulp_error, wrong_sign};
use reference::oracle;
use reference::registry::Precision::{F32, F64};

#[test]
fn the_sine_integral_keeps_its_limits() {
    for x in points::non_finite() {
        let truth = oracle::sine_integral(x);
        assert!(ulp_error(special::sine_integral(x), &truth, F64) <= 0.75, "{x}");
        assert!(
            ulp_error(f64::from(shader::sine_integral(x as f32)), &truth, F32) <= 2.0,
            "{x}"
        );
    }
    for x in points::edges() {
        assert!(
            !wrong_sign(special::sine_integral(x), &oracle::sine_integral(x)),
            "{x:e}"
        );
    }
}

#[test]
fn the_arc_keeps_16_eps_with_infinite_and_extreme_ends() {
    for [q0, q1] in arcs::non_finite().into_iter().chain(arcs::extreme()) {
        let truth = oracle::sinc_squared_integral(q0, q1);
        let result = special::sinc_squared_integral([q0, q1]);
        assert!(
            eps_error(result, &truth, F64) <= 16.0,
            "{q0:e} {q1:e}: {result:e}, true {truth:?}"
        );
        assert!(
            truth.hi.is_nan() || !wrong_sign(result, &truth),
            "{q0:e} {q1:e}: {result:e}"
        );
    }
}
