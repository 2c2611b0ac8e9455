//! Vectors of three numbers.

/// Returns the scalar product.
#[inline(always)]
pub(crate) fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// Returns the vector product.
#[inline(always)]
pub(crate) fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    ]
}

/// Returns a - b.
#[inline(always)]
pub(crate) fn difference(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

/// Returns the length, of numbers whose squares stay in the range of f64.
#[inline(always)]
pub(crate) fn length(a: [f64; 3]) -> f64 {
    libm::sqrt(dot(a, a))
}

/// Returns a vector times a power of two that brings its largest component near 1; a zero vector unchanged.
#[inline(always)]
pub(crate) fn near_one(a: [f64; 3]) -> [f64; 3] {
    scale_by_exponent(a, -largest_exponent(a))
}

/// The exponent e of the largest component, 2^e <= |component| < 2^(e+1); of a subnormal number or 0 the smallest, -1023.
#[inline(always)]
pub(crate) fn largest_exponent(a: [f64; 3]) -> i32 {
    let largest = a[0].abs().max(a[1].abs()).max(a[2].abs());
    (largest.to_bits() >> 52) as i32 - 1023
}

/// Returns a 2^n for |n| <= 1023, in two steps so that neither power leaves the range.
#[inline(always)]
pub(crate) fn scale_by_exponent(a: [f64; 3], n: i32) -> [f64; 3] {
    let half = n / 2;
    let power = |n: i32| f64::from_bits(((n + 1023) as u64) << 52);
    let (first, second) = (power(half), power(n - half));
    a.map(|x| x * first * second)
}
