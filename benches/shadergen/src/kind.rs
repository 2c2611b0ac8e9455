//! Value types of the subset.

use std::fmt;

/// Type of a value.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Kind {
    /// `f32`.
    F32,
    /// `i32`.
    I32,
    /// `u32`.
    U32,
    /// `bool`.
    Bool,
    /// An integer literal whose type its surroundings decide.
    Whole,
    /// A struct of the subset, by name.
    Struct(String),
    /// `[T; N]`.
    Array(Box<Kind>, usize),
}

impl Kind {
    /// `i32`, `u32` or an untyped integer literal.
    pub(crate) fn is_integer(&self) -> bool {
        matches!(self, Kind::I32 | Kind::U32 | Kind::Whole)
    }

    /// The common type of two operands, if they have one.
    pub(crate) fn unify(&self, other: &Kind) -> Option<Kind> {
        match (self, other) {
            (Kind::Whole, k) if k.is_integer() => Some(k.clone()),
            (k, Kind::Whole) if k.is_integer() => Some(k.clone()),
            (a, b) if a == b => Some(a.clone()),
            _ => None,
        }
    }
}

/// WGSL spelling.
impl fmt::Display for Kind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Kind::F32 => f.write_str("f32"),
            Kind::I32 => f.write_str("i32"),
            Kind::U32 => f.write_str("u32"),
            Kind::Bool => f.write_str("bool"),
            Kind::Whole => f.write_str("integer"),
            Kind::Struct(name) => f.write_str(name),
            Kind::Array(element, length) => write!(f, "array<{element}, {length}>"),
        }
    }
}
