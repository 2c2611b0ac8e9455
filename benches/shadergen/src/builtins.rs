//! Rust functions of `src/shader/gpu.rs` that stand for WGSL built-ins.

use crate::kind::Kind;

/// Number of arguments and WGSL name of a built-in, by its Rust name.
fn spelling(name: &str) -> Option<(usize, &'static str)> {
    Some(match name {
        "abs" => (1, "abs"),
        "ceil" => (1, "ceil"),
        "floor" => (1, "floor"),
        "round" => (1, "round"),
        "sign" => (1, "sign"),
        "sqrt" => (1, "sqrt"),
        "trunc" => (1, "trunc"),
        "max" => (2, "max"),
        "min" => (2, "min"),
        "clamp" => (3, "clamp"),
        "select" => (3, "select"),
        "bits_of" => (1, "bitcast<u32>"),
        "from_bits" => (1, "bitcast<f32>"),
        _ => return None,
    })
}

/// Whether `name` stands for a WGSL built-in.
pub(crate) fn is_builtin(name: &str) -> bool {
    spelling(name).is_some()
}

/// WGSL name and result type of a call of `name`, or the reason why the call is refused.
pub(crate) fn call(name: &str, arguments: &[Kind]) -> Option<Result<(&'static str, Kind), String>> {
    let (arity, wgsl) = spelling(name)?;
    if arguments.len() != arity {
        return Some(Err(format!("`{name}` takes {arity} arguments")));
    }
    let result = match (name, arguments) {
        ("bits_of", [Kind::F32]) => Some(Kind::U32),
        ("from_bits", [Kind::U32 | Kind::Whole]) => Some(Kind::F32),
        ("select", [no, yes, Kind::Bool]) => no.unify(yes),
        ("bits_of" | "from_bits" | "select", _) => None,
        (_, all) if all.iter().all(|kind| *kind == Kind::F32) => Some(Kind::F32),
        _ => None,
    };
    Some(match result {
        Some(kind) => Ok((wgsl, kind)),
        None => Err(format!("`{name}` is not in the subset for these argument types")),
    })
}
