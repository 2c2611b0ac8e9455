//! Shared numerics below the special functions: polynomials, exact phases, fixed Gauss rules.

pub(crate) mod gauss;
pub(crate) mod phase;
pub(crate) mod polynomial;
mod tables;
