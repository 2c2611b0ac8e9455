//! Shared numerics below the special functions: polynomials, exact phases, fixed Gauss rules.

pub(crate) mod complex_polynomial;
pub(crate) mod exponential;
pub(crate) mod gauss;
pub(crate) mod phase;
pub(crate) mod polynomial;
pub(crate) mod product_phase;
mod tables;
pub(crate) mod turns;

/// 1.5 * 2^52: adding it rounds to an integer, left in the low bits.
pub(crate) const ROUND: f64 = 6755399441055744.0;
