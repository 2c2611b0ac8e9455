//! Gauss-Legendre rules on \[-1, 1\] (DLMF 3.5(v)): pairs of positive node and weight, the negative nodes implied.

/// The 4-point rule.
pub(crate) const FOUR_POINTS: [[f64; 2]; 2] = [
    [0.33998104358485626, 0.6521451548625461],
    [0.8611363115940526, 0.34785484513745385],
];

/// The 8-point rule.
pub(crate) const EIGHT_POINTS: [[f64; 2]; 4] = [
    [0.1834346424956498, 0.362683783378362],
    [0.525532409916329, 0.31370664587788727],
    [0.7966664774136267, 0.22238103445337448],
    [0.9602898564975363, 0.10122853629037626],
];
