//! Nodes and weights of Gauss-Legendre rules, by Newton steps on the polynomial (DLMF 3.5(v) and 18.9.1).

/// Nodes on \[0, 1\] and weights of the rule of `count` points.
pub fn rule(count: usize) -> Vec<[f64; 2]> {
    // P_n and its derivative at x, from the recurrence in n.
    let polynomial = |x: f64| {
        let (mut last, mut value) = (1.0, x);
        for n in 1..count {
            let n = n as f64;
            (last, value) = (value, ((2.0 * n + 1.0) * x * value - n * last) / (n + 1.0));
        }
        [value, count as f64 * (last - x * value) / (1.0 - x * x)]
    };
    let node = |i: usize| {
        let mut x = (std::f64::consts::PI * (i as f64 + 0.75) / (count as f64 + 0.5)).cos();
        for _ in 0..6 {
            let [value, slope] = polynomial(x);
            x -= value / slope;
        }
        let [_, slope] = polynomial(x);
        [0.5 - 0.5 * x, 1.0 / ((1.0 - x * x) * slope * slope)]
    };
    (0..count).map(node).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn powers_below_twice_the_count_are_exact() {
        for count in [2, 8, 16, 21] {
            let nodes = rule(count);
            for n in 0..2 * count as i32 {
                let value: f64 = nodes.iter().map(|[x, w]| w * x.powi(n)).sum();
                assert!((value * f64::from(n + 1) - 1.0).abs() < 1e-13, "{count} {n}: {value}");
            }
            let beyond: f64 = nodes.iter().map(|[x, w]| w * (x - 0.5).powi(2 * count as i32)).sum();
            let truth = 0.25f64.powi(count as i32) / f64::from(2 * count as i32 + 1);
            assert!(count > 8 || beyond < 0.99999 * truth, "{count}");
        }
    }
}
