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

/// Returns the smallest integer that is not below `x`.
#[inline(always)]
pub(super) fn ceil(x: f32) -> f32 {
    let nearest = round(x);
    select(nearest, nearest + 1.0, nearest < x)
}

/// Returns the square root, correctly rounded; NaN below 0.
///
/// The library has no platform to ask and loops over this vectorise: a step of second and one of third order for
/// 1/sqrt(x), and the rest x - s^2 from exact partial products for the last place.
#[inline(always)]
pub(super) fn sqrt(x: f32) -> f32 {
    /// 2^64, and 2^-32.
    const SCALE: [f32; 2] = [18446744073709551616.0, 2.3283064365386963e-10];
    /// 2^-40.
    const SMALL: f32 = 9.094947e-13;
    let small = x < SMALL;
    let scaled = x * select(1.0, SCALE[0], small);
    // Half the bits, counted down: 1/sqrt(x) to 4 %.
    let mut inverse = f32::from_bits(0x5f37_59df_u32.wrapping_sub(scaled.to_bits() >> 1));
    inverse *= 1.5 - (0.5 * scaled * inverse) * inverse;
    let left = 1.0 - (scaled * inverse) * inverse;
    inverse += (inverse * left) * (0.5 + 0.375 * left);
    let rough = scaled * inverse;
    let high = f32::from_bits(rough.to_bits() & 0xffff_f000);
    let low = rough - high;
    let rest = ((scaled - high * high) - 2.0 * high * low) - low * low;
    let root = (rough + rest * (0.5 * inverse)) * select(1.0, SCALE[1], small);
    // 0 with its sign, infinity and NaN are their own roots.
    let special = select(x, f32::NAN, x < 0.0);
    select(special, root, x > 0.0 && x < f32::INFINITY)
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

#[cfg(test)]
mod tests {
    use super::sqrt;

    #[test]
    fn the_square_root_is_correctly_rounded_at_every_mantissa_and_every_exponent() {
        let hold = |bits: u32| {
            let x = f32::from_bits(bits);
            // The square of a midpoint beside the root, in f64 without an error, says which root is the nearest.
            let root = f64::from(sqrt(x));
            let [below, above] = [-1, 1].map(|d| {
                let neighbour = f64::from(f32::from_bits((root as f32).to_bits().wrapping_add_signed(d)));
                0.5 * (root + neighbour)
            });
            let x = f64::from(x);
            assert!(below * below < x && x < above * above, "{x:e}: {root:e}");
        };
        // Two octaves hold every case there is but for the scale.
        (0x3f80_0000..0x4080_0000).for_each(hold);
        (0x0000_0001..0x7f80_0000).step_by(4099).for_each(hold);
        (0x0000_0001..0x0000_1000).for_each(hold);
        (0x7f7f_f000..0x7f80_0000).for_each(hold);
        for x in [0.0, -0.0, f32::INFINITY] {
            assert_eq!(sqrt(x).to_bits(), x.to_bits());
        }
        for x in [-1e-45, -2.0, f32::NEG_INFINITY, f32::NAN] {
            assert!(sqrt(x).is_nan(), "{x:e}");
        }
    }
}
