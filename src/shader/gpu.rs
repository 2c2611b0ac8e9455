//! The built-ins of WGSL that the kernels use, spelled in Rust with the same names, argument order and results.
//!
//! Not translated: on a GPU each is the built-in itself. Branch-free, so that loops over them vectorise.

/// Returns `when_true` if `condition`, else `when_false`.
#[inline(always)]
pub(super) fn select(when_false: f32, when_true: f32, condition: bool) -> f32 {
    if condition { when_true } else { when_false }
}

/// Returns the magnitude of `x`.
#[inline(always)]
pub(super) fn abs(x: f32) -> f32 {
    x.abs()
}

/// Returns the smaller argument; the first if either is NaN.
#[inline(always)]
pub(super) fn min(x: f32, y: f32) -> f32 {
    if y < x { y } else { x }
}

/// Returns the larger argument; the first if either is NaN.
#[inline(always)]
pub(super) fn max(x: f32, y: f32) -> f32 {
    if x < y { y } else { x }
}

/// Returns the nearest integer, ties to even.
#[inline(always)]
pub(super) fn round(x: f32) -> f32 {
    /// 2^23: from here on every f32 is an integer.
    const INTEGERS: f32 = 8388608.0;
    let magnitude = x.abs();
    let rounded = (magnitude + INTEGERS) - INTEGERS;
    select(x, rounded.copysign(x), magnitude < INTEGERS)
}

/// Returns the largest integer that is not above `x`.
#[inline(always)]
pub(super) fn floor(x: f32) -> f32 {
    let nearest = round(x);
    select(nearest, nearest - 1.0, nearest > x)
}

/// Returns the f32 with the given bits.
#[inline(always)]
pub(super) fn from_bits(bits: u32) -> f32 {
    f32::from_bits(bits)
}

/// Returns the bits of an f32.
#[inline(always)]
pub(super) fn bits_of(x: f32) -> u32 {
    x.to_bits()
}
