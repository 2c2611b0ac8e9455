//! Slice functions give the bits of their scalars, at every level that the machine has.
#![cfg(feature = "simd")]

mod check;
mod inputs;
mod scratches;
mod special;
mod sums;

#[test]
fn every_slice_function_of_the_source_is_held_here() {
    let sources = [
        include_str!("../../src/simd.rs"),
        include_str!("../../src/simd/shader.rs"),
        include_str!("../../src/simd/shader/scratches.rs"),
    ];
    let tests = [include_str!("special.rs"), include_str!("scratches.rs")];
    let defined: usize = sources
        .iter()
        .map(|s| s.matches("slice_function! {\n    ///").count())
        .sum();
    let text: String = tests.concat().chars().filter(|c| !c.is_whitespace()).collect();
    assert_eq!(defined, text.matches("check(\"").count());
}
