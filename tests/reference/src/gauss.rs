//! The Gauss-Legendre rule of 8 points over equal pieces, for integrands that a test knows to be smooth.

/// The positive nodes on \[-1, 1\] and their weights; each counts on either side of 0 (DLMF 3.5(v)).
pub const EIGHT_POINTS: [[f64; 2]; 4] = [
    [0.1834346424956498, 0.362683783378362],
    [0.525532409916329, 0.31370664587788727],
    [0.7966664774136267, 0.22238103445337448],
    [0.9602898564975363, 0.10122853629037626],
];

/// The integral of a function over an interval cut in equal pieces, 8 nodes to each; real or complex.
pub fn gauss<T>(f: impl Fn(f64) -> T, [from, to]: [f64; 2], pieces: usize) -> T
where
    T: std::ops::Add<Output = T> + std::ops::Mul<f64, Output = T> + std::iter::Sum,
{
    let half = 0.5 * (to - from) / pieces as f64;
    let middles = (0..pieces).map(|piece| from + (2 * piece + 1) as f64 * half);
    middles
        .flat_map(|middle| EIGHT_POINTS.map(|[node, weight]| (middle, half * node, half * weight)))
        .map(|(middle, node, weight)| (f(middle - node) + f(middle + node)) * weight)
        .sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn degree_15_is_exact_and_degree_16_misses_by_what_the_rule_must() {
        // On [0, 1] the integral of x^n is 1/(n + 1).
        for n in 0..=15 {
            let value: f64 = gauss(|x| x.powi(n), [0.0, 1.0], 1);
            assert!((value * f64::from(n + 1) - 1.0).abs() < 4e-15, "{n}: {value}");
        }
        // (8!)^4/(17 (16!)^2) on an interval of length 1 (DLMF 3.5(v)), less by 2^-16 over two halves.
        let due = 40_320f64.powi(4) / (17.0 * 20_922_789_888_000f64.powi(2));
        let missed = |pieces| 1.0 / 17.0 - gauss(|x| x.powi(16), [-1.0, 0.0], pieces);
        // Sixteen nodes, each weight and power with its own rounding.
        let rounding = 4.0 * f64::EPSILON / 17.0;
        assert!((missed(1) - due).abs() < 4.0 * rounding, "{:e} {due:e}", missed(1));
        assert!((missed(2) - due / 65_536.0).abs() < 4.0 * rounding, "{:e}", missed(2));
    }
}
