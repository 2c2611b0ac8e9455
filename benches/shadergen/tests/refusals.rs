//! What is outside the subset is refused with its file, line and reason.

use shadergen::translate;

/// Line and reason of the refusal of `source`.
fn refused(source: &str) -> (usize, String) {
    match translate(&[("kernel.rs", source)]) {
        Ok(translation) => panic!("accepted:\n{source}\nas\n{}", translation.wgsl),
        Err(refusal) => {
            assert_eq!(refusal.file, "kernel.rs");
            assert!(
                refusal
                    .to_string()
                    .starts_with(&format!("kernel.rs:{}:{}: ", refusal.line, refusal.column))
            );
            (refusal.line, refusal.reason)
        }
    }
}

/// Each bad line stands third in a function, so that the line number is seen to be right.
#[test]
fn statements_and_values_outside_the_subset_are_refused_at_their_line() {
    let cases = [
        ("let y = x.abs();", "method"),
        ("let y = 1.0 / 3.0;", "two literals"),
        ("let y = -(2.0) * (3.0);", "two literals"),
        ("let y = core::f32::consts::PI;", "`::`"),
        ("let y = f32::sqrt(x);", "plain name"),
        ("let y = sinh(x);", "neither a function"),
        ("let y = sqrt(x, x);", "takes 1 argument"),
        ("let y = unknown;", "not defined"),
        ("let (y, z) = (x, x);", "pattern"),
        ("let y = (x, x);", "tuple"),
        ("let y = &x;", "reference"),
        ("let y = if x > 0.0 { x } else { -x };", "select"),
        ("let y = match 1u32 { _ => x };", "match"),
        ("let y = { x };", "block"),
        ("let y = x % 2.0;", "`%` on f32"),
        ("let y = 3;", "without a type"),
        ("let y = 1e-40;", "subnormal"),
        ("let y = 1.0f64;", "f64"),
        ("let y = x as f64;", "f64"),
        ("let y: f64 = 1.0;", "f64"),
        ("let y1 = x;", "ends in a digit"),
        ("let half = x;", "reserved"),
        ("let sin = x;", "built-in"),
        ("let f = x;", "also an item"),
        ("let y_ = x;", "underscores"),
        ("x = 1.0;", "let mut"),
        ("assert!(x > 0.0);", "macro"),
        ("let y = |a: f32| a;", "closure"),
        ("while x > 0.0 { }", "while"),
        ("loop { }", "loop"),
        ("for i in 0..6 { }", "suffix"),
        ("for i in 0..n { }", "literals"),
        ("const C: f32 = 1.0;", "item inside"),
        ("x * 2.0;", "not used"),
        ("let y = x + 1u32;", "different types"),
        ("let y = f(x, x);", "do not fit"),
    ];
    for (bad, reason) in cases {
        let source = format!("/// A function.\npub fn f(x: f32) -> f32 {{\n    {bad}\n    x\n}}\n");
        let (line, found) = refused(&source);
        assert_eq!(line, 3, "{bad}: {found}");
        assert!(found.contains(reason), "{bad}: {found}");
    }
}

#[test]
fn items_outside_the_subset_are_refused_at_their_line() {
    let cases = [
        ("use core::f32::consts::PI;", "use super"),
        ("use super::gpu::abs as absolute;", "names stay"),
        ("use super::super::special;", "names stay"),
        ("pub fn f(x: f64) -> f64 { x }", "f64"),
        ("pub fn f(mut x: f32) -> f32 { x }", "`mut` argument"),
        ("pub fn f<T>(x: f32) -> f32 { x }", "generic"),
        ("pub fn f(x: f32) { }", "without a result"),
        ("pub fn f(x: [f32; 2]) -> (f32, f32) { x }", "no WGSL form"),
        ("pub unsafe fn f(x: f32) -> f32 { x }", "plain functions"),
        ("pub fn sin(x: f32) -> f32 { x }", "built-in"),
        ("pub fn select(x: f32) -> f32 { x }", "built-in"),
        ("pub fn atan2(x: f32) -> f32 { x }", "ends in a digit"),
        ("pub const A: f32 = 1.0 + B;", "literal"),
        ("pub const A: f32 = 1e39;", "overflows"),
        ("pub static A: f32 = 1.0;", "static"),
        ("pub enum E { A }", "enum"),
        ("pub struct S(f32);", "unnamed"),
        ("pub type F = f32;", "alias"),
        ("mod inner { }", "module"),
        ("#[cfg(feature = \"x\")] pub fn f(x: f32) -> f32 { x }", "attribute"),
        ("pub const ONE: f32 = 1.0;", "defined twice"),
        ("/// ℝ\npub const A: f32 = 1.0;", "ASCII"),
    ];
    for (bad, reason) in cases {
        let (line, found) = refused(&format!("//! Module.\npub const ONE: f32 = 1.0;\n{bad}\n"));
        assert_eq!(line, 3, "{bad}: {found}");
        assert!(found.contains(reason), "{bad}: {found}");
    }
}

#[test]
fn a_syntax_error_is_refused_at_its_line() {
    let (line, _) = refused("pub const A: f32 = 1.0;\npub fn f(x: f32 -> f32 { x }\n");
    assert_eq!(line, 2);
}

#[test]
fn the_column_points_at_the_construct() {
    let refusal = translate(&[("kernel.rs", "fn f(x: f32) -> f32 { x.abs() }")]).expect_err("a method");
    assert_eq!((refusal.line, refusal.column), (1, 25));
}
