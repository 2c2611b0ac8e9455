//! Operators: their WGSL signs, and parentheses where WGSL has no precedence between two of them.

use syn::{BinOp, Expr};

/// How tightly an operator binds; WGSL allows fewer mixtures than Rust.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum Class {
    /// `+ - * / %`
    Arithmetic,
    /// `& | ^ << >>`
    Bits,
    /// Comparisons.
    Relation,
    /// `&&`
    And,
    /// `||`
    Or,
}

/// WGSL sign and class of an operator that gives a value.
pub(crate) fn operator(op: &BinOp) -> Option<(&'static str, Class)> {
    Some(match op {
        BinOp::Add(_) => ("+", Class::Arithmetic),
        BinOp::Sub(_) => ("-", Class::Arithmetic),
        BinOp::Mul(_) => ("*", Class::Arithmetic),
        BinOp::Div(_) => ("/", Class::Arithmetic),
        BinOp::Rem(_) => ("%", Class::Arithmetic),
        BinOp::BitAnd(_) => ("&", Class::Bits),
        BinOp::BitOr(_) => ("|", Class::Bits),
        BinOp::BitXor(_) => ("^", Class::Bits),
        BinOp::Shl(_) => ("<<", Class::Bits),
        BinOp::Shr(_) => (">>", Class::Bits),
        BinOp::Eq(_) => ("==", Class::Relation),
        BinOp::Ne(_) => ("!=", Class::Relation),
        BinOp::Lt(_) => ("<", Class::Relation),
        BinOp::Le(_) => ("<=", Class::Relation),
        BinOp::Gt(_) => (">", Class::Relation),
        BinOp::Ge(_) => (">=", Class::Relation),
        BinOp::And(_) => ("&&", Class::And),
        BinOp::Or(_) => ("||", Class::Or),
        _ => return None,
    })
}

/// Sign of a compound assignment and the operation in it.
pub(crate) fn compound(op: &BinOp) -> Option<(&'static str, bool)> {
    Some(match op {
        BinOp::AddAssign(_) => ("+=", false),
        BinOp::SubAssign(_) => ("-=", false),
        BinOp::MulAssign(_) => ("*=", false),
        BinOp::DivAssign(_) => ("/=", false),
        BinOp::BitAndAssign(_) => ("&=", true),
        BinOp::BitOrAssign(_) => ("|=", true),
        BinOp::BitXorAssign(_) => ("^=", true),
        _ => return None,
    })
}

/// Whether the expression is a literal, in parentheses or negated.
pub(crate) fn is_literal(expression: &Expr) -> bool {
    match expression {
        Expr::Lit(_) => true,
        Expr::Paren(inner) => is_literal(&inner.expr),
        Expr::Unary(inner) => is_literal(&inner.expr),
        _ => false,
    }
}

/// Operand text, in parentheses where WGSL has no precedence between the two operators.
pub(crate) fn grouped(operand: &Expr, text: String, class: Class) -> String {
    let inner = match operand {
        Expr::Binary(inner) => operator(&inner.op).map(|(_, inner)| inner),
        _ => None,
    };
    let free = matches!(
        (class, inner),
        (_, None)
            | (Class::Arithmetic | Class::Relation, Some(Class::Arithmetic))
            | (Class::And | Class::Or, Some(Class::Arithmetic | Class::Relation))
            | (Class::And, Some(Class::And))
            | (Class::Or, Some(Class::Or))
    );
    if free { text } else { format!("({text})") }
}
