//! Runs the committed WGSL on a GPU API and compares it, row by row and bit by bit, with the Rust f32 functions.
//!
//! - [`adapter`] opens any Vulkan adapter, a software one included, and runs one function on rows of inputs.
//! - [`trace`] evaluates the WGSL text itself with correctly rounded operations, and carries with every value the
//!   bound that the accuracy table of WGSL gives a GPU: a row that differs is judged by it.
//! - [`catalogue`] lists the Rust functions; [`inputs`] makes the rows; [`comparison`] counts and judges.
//!
//! Without an adapter the tests say so loudly and pass; with `REQUIRE_GPU=1` they fail.

pub mod adapter;
pub mod catalogue;
pub mod comparison;
pub mod inputs;
pub mod trace;
