//! int sinc^2 over an interval, by the Gauss-Legendre rule of 8 points on panels of length 1.
//!
//! The rule misses less than 2e-18 of a panel of length 1. Whole panels come from a table of running sums in pairs of
//! f64, so that a difference of two keeps the digits of what lies between; parts of a panel are integrated as they
//! come.

use crate::gauss::gauss;
use std::sync::OnceLock;

/// Panels in the table.
const PANELS: usize = 1024;

/// (sin u/u)^2.
pub fn sinc_squared(u: f64) -> f64 {
    if u == 0.0 { 1.0 } else { (u.sin() / u).powi(2) }
}

/// Sums of the first panels, each a leading part and a remainder.
fn sums() -> &'static [[f64; 2]] {
    static SUMS: OnceLock<Vec<[f64; 2]>> = OnceLock::new();
    SUMS.get_or_init(|| {
        let mut sum = [0.0, 0.0];
        let mut all = vec![sum];
        for panel in 0..PANELS {
            let value = part(panel as f64, 1.0);
            let next = sum[0] + value;
            // Exact, as the sum is the larger after the first panel.
            sum = [next, sum[1] + (value - (next - sum[0]))];
            all.push(sum);
        }
        all
    })
}

/// The integral over at most one panel.
fn part(start: f64, length: f64) -> f64 {
    length * gauss(|s| sinc_squared(start + length * s), [0.0, 1.0], 1)
}

/// The integral over an interval of positive numbers.
fn right(start: f64, length: f64) -> f64 {
    if length <= 1.0 {
        return part(start, length);
    }
    let end = start + length;
    let (first, last) = (start.ceil(), end.floor());
    let sums = sums();
    let at = |u: f64| sums[u.min(PANELS as f64) as usize];
    let (low, high) = (at(first), at(last));
    let tabulated = (high[0] - low[0]) + (high[1] - low[1]);
    let mut beyond = 0.0;
    let mut panel = first.max(PANELS as f64);
    while panel < last {
        beyond += part(panel, 1.0);
        panel += 1.0;
    }
    part(start, first - start) + tabulated + beyond + part(last, end - last)
}

/// The integral of sinc^2 from `start` over `length` >= 0, relative to its own size.
pub fn integral(start: f64, length: f64) -> f64 {
    let end = start + length;
    if start >= 0.0 {
        right(start, length)
    } else if end <= 0.0 {
        right(-end, length)
    } else {
        right(0.0, -start) + right(0.0, end)
    }
}

/// The same, by panels of at most 0.7 from end to end and another rule.
pub fn integral_by_panels(start: f64, length: f64, nodes: &[[f64; 2]]) -> f64 {
    let count = (length / 0.7).ceil().max(1.0);
    let panel = length / count;
    let mut sum = 0.0;
    for k in 0..count as usize {
        for [node, weight] in nodes {
            sum += weight * sinc_squared(start + panel * (k as f64 + node));
        }
    }
    panel * sum
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::generate::random::Random;

    #[test]
    fn the_whole_line_holds_pi() {
        // Less 2 int sin^2 u/u^2 from N on: 1/N to leading order, and the oscillation below 1/(2 N^2).
        let value = integral(-3000.0, 6000.0);
        assert!(
            (value - std::f64::consts::PI + 1.0 / 3000.0).abs() < 1.0 / 9e6,
            "{value}"
        );
    }

    #[test]
    fn tabulated_and_direct_panels_agree_relatively() {
        let nodes = super::super::legendre::rule(12);
        let mut random = Random::new(31);
        for _ in 0..2000 {
            let (start, length) = (random.uniform(-1200.0, 1200.0), random.log_uniform(1e-9, 1500.0));
            let (a, b) = (integral(start, length), integral_by_panels(start, length, &nodes));
            // Near a zero of the sine the rounding of u itself shows.
            let ends = sinc_squared(start) + sinc_squared(start + length);
            let due = 1e-13 * b + 4.0 * f64::EPSILON * start.abs() * ends;
            assert!((a - b).abs() < due, "{start} {length}: {a:e} {b:e}");
        }
    }
}
