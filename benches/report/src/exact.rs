//! Properties that hold bit by bit or not at all, counted over rows of a function's widest domain.

use iridescence::special::erf_difference_scaled;
use reference::generate::erf_differences;
use std::sync::LazyLock;

/// Rows tried.
pub const ROWS: usize = 20_000;
const SEED: u64 = 24;

/// Rows of the scaled erf difference that break a property.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Violations {
    /// Equal ends whose result is not exactly 0.
    pub equal_ends: usize,
    /// Exchanged ends whose result is not exactly the negative.
    pub exchanged_ends: usize,
    /// A negative b whose result is not exactly the conjugate.
    pub conjugate: usize,
}

type Value = [f64; 2];

/// Whether two numbers are the same to the bit; zeros of either sign are one number.
fn same(a: Value, b: Value) -> bool {
    a == b
}

/// Counts the rows on which a difference of error functions breaks its exact properties.
pub fn violations(difference: impl Fn(f64, f64, f64) -> Value) -> Violations {
    let rows = (erf_differences::ANY.rows)(SEED, ROWS);
    let count = |holds: &dyn Fn(f64, f64, f64) -> bool| {
        let broken = rows.chunks_exact(3).filter(|row| !holds(row[0], row[1], row[2]));
        broken.count()
    };
    Violations {
        equal_ends: count(&|a1, a2, b| [a1, a2].into_iter().all(|a| same(difference(a, a, b), [0.0; 2]))),
        exchanged_ends: count(&|a1, a2, b| same(difference(a2, a1, b), difference(a1, a2, b).map(|x| -x))),
        conjugate: count(&|a1, a2, b| {
            let [re, im] = difference(a1, a2, b);
            same(difference(a1, a2, -b), [re, -im])
        }),
    }
}

/// The counts of [`erf_difference_scaled`].
pub fn of_erf_difference() -> Violations {
    static COUNTED: LazyLock<Violations> = LazyLock::new(|| {
        violations(|a1, a2, b| {
            let value = erf_difference_scaled(a1, a2, b);
            [value.re, value.im]
        })
    });
    *COUNTED
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_difference_that_breaks_a_property_is_found_and_ours_breaks_none() {
        let none = Violations {
            equal_ends: 0,
            exchanged_ends: 0,
            conjugate: 0,
        };
        assert_eq!(of_erf_difference(), none);
        let ours = |a1: f64, a2: f64, b: f64| {
            let value = erf_difference_scaled(a1, a2, b);
            [value.re, value.im]
        };
        let shifted = violations(|a1, a2, b| ours(a1, a2 + 1e-3, b));
        assert!(
            shifted.equal_ends > ROWS / 4 && shifted.exchanged_ends > ROWS / 4,
            "{shifted:?}"
        );
        let turned = violations(|a1, a2, b| {
            let [re, im] = ours(a1, a2, b);
            [re, im.abs()]
        });
        assert!(turned.conjugate > ROWS / 4 && turned.equal_ends == 0, "{turned:?}");
    }
}
