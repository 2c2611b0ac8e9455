//! Translates the f32 subset of `iridescence` from Rust to WGSL, and through naga to GLSL and HLSL.
//!
//! `cargo run -p shadergen` writes the four texts beside `src/shader`; `cargo run -p shadergen -- --check`
//! exits with 1 and names the file whose committed text is not what the sources give.
//!
//! # The subset
//! Kernel files (listed in [`SOURCES`]) keep to this; anything else is refused with file, line and column.
//! - Items: `const` (a literal, a negated literal, an array of them), structs with named fields, free functions
//!   with a result, `use super::..` or `use crate::shader::..`, `#[cfg(test)] mod tests`. One scope for all
//!   files: an item name is defined once, and no local has the name of an item.
//! - Types: `f32`, `i32`, `u32`, `bool`, arrays of them, structs of the subset. No tuples, references, generics.
//! - Statements: `let`, `let mut`, `let x: f32;`, assignment and compound assignment, `if`/`else`, `return`,
//!   `for i in 0..6u32` with literal bounds and a suffix, `break`, `continue`. No `while`, `loop`, `match`.
//! - Values: `+ - * /`, `%` on integers, `& | ^ << >>`, comparisons, `&& || !`, unary minus, `as` between numbers,
//!   calls by plain name, struct literals, fields, indexing. No methods, no macros, no `::` paths.
//!   `if` gives a value only as the last expression of a function; elsewhere use `select`.
//! - Built-ins of `gpu.rs`: `abs ceil clamp floor max min round select sign sqrt trunc bits_of from_bits`.
//! - Literals: floats normal or zero in f32, no operation between two literals; an integer `let` needs a suffix
//!   or an annotation; negative hexadecimal bits go through `from_bits`.
//! - Names: ASCII, not ending in a digit, no leading, trailing or double underscore, no word that WGSL, GLSL or
//!   HLSL reserves or predefines. A shadowed `let t` becomes `t_b`, `t_c`, ... in the text.
//! - Comments of items go into the text up to their first heading or code block, and are ASCII.
//!
//! # Rounding
//! Parentheses and the tree of operations stay as written. A GPU may still fuse `a * b + c`, reassociate,
//! flush subnormals and assume that no NaN or infinity occurs: kernels branch on their inputs, never on a NaN.
//! Seen on Mesa's llvmpipe (22.3), where the result then differs from Rust in 15-85 % of the rows:
//! - a product of two variables used once and then multiplied by a constant, `(x * y) * C`, becomes `x * (y * C)`;
//!   write `(x * C) * y`, or use the product twice (as every `t = x * x` of a polynomial of degree 2 in t is);
//! - `(x * C) * D` and `(x + C) + D` have their constants folded; write one constant;
//! - `x * y + x * C` is factored; write `x * (y + C)`.
//!
//! Everything else that was tried kept its bits: polynomials in Horner's form, Cody-Waite reduction in two steps,
//! quotients, `sqrt`, differences of differences, `select`, `min`, `max`.
//!
//! Private items reach the text as well, in one scope with those of the renderer that includes it: give them names
//! that say what they belong to.

mod body;
mod builtins;
mod composites;
mod control;
mod expression;
mod items;
mod kind;
mod languages;
mod layout;
mod literal;
mod module;
mod names;
mod operators;
mod outputs;
mod refusal;
mod symbols;

pub use kind::Kind;
pub use languages::{glsl, hlsl, validate};
pub use module::{Source, Translation, translate};
pub use outputs::{Output, SOURCES, library, outputs, root};
pub use refusal::Refusal;
pub use symbols::{Signature, Symbols};
