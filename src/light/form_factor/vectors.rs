//! Vectors of form factors: scaled, summed in twice the working precision, turned.

use crate::geometry::vector::{cross, dot, length};
use crate::numeric::phase::{two_product, two_sum};

/// The nodes and weights of a rule that is given by its positive half.
pub(super) fn both_signs(rule: &[[f64; 2]]) -> impl Iterator<Item = [f64; 2]> {
    rule.iter()
        .flat_map(|&[node, weight]| [[-node, weight], [node, weight]])
}

/// Returns the power of two that brings the largest of the numbers to [1, 2), as far as there is one; 1 for zeros, none
/// where a number is not finite.
pub(super) fn scale_to_one(numbers: &[f64]) -> Option<f64> {
    let mut largest = 0.0_f64;
    for &number in numbers {
        if !number.is_finite() {
            return None;
        }
        largest = largest.max(number.abs());
    }
    // The exponent field e of 2^(e - 1023); subnormal numbers have 0.
    let field = largest.to_bits() >> 52;
    let inverse = 2046_u64.saturating_sub(field).clamp(1, 2046);
    Some(if largest == 0.0 {
        1.0
    } else {
        f64::from_bits(inverse << 52)
    })
}

/// Returns a unit vector and the length; none for the zero vector.
pub(super) fn unit(v: [f64; 3]) -> Option<([f64; 3], f64)> {
    let scale = scale_to_one(&v)?;
    let near = scaled(scale, v);
    let length = length(near);
    (length > 0.0).then(|| (near.map(|x| x / length), length / scale))
}

/// Two unit vectors that complete a unit vector to a right-handed frame.
pub(super) fn across(axis: [f64; 3]) -> ([f64; 3], [f64; 3]) {
    let [x, y, z] = axis;
    let level = if z.abs() <= 0.7 { [-y, x, 0.0] } else { [0.0, -z, y] };
    let first = times(1.0 / length(level), level);
    (first, cross(axis, first))
}

/// Turns a pair of vectors in their plane.
pub(super) fn rotated(u: [f64; 3], v: [f64; 3], angle: f64) -> ([f64; 3], [f64; 3]) {
    let (sine, cosine) = libm::sincos(angle);
    (
        add(times(cosine, u), times(sine, v)),
        add(times(cosine, v), times(-sine, u)),
    )
}

/// Applies a matrix, each coordinate to its own precision: a height above the horizon keeps its digits.
pub(super) fn transform(matrix: &[[f64; 3]; 3], v: [f64; 3]) -> [f64; 3] {
    matrix.map(|row| sum_of_products(row, v))
}

/// Returns a sum of products in twice the working precision, rounded (Ogita, Rump and Oishi 2005).
pub(super) fn sum_of_products<const N: usize>(a: [f64; N], b: [f64; N]) -> f64 {
    let (mut sum, mut rest) = (0.0, 0.0);
    for i in 0..N {
        let (product, low) = two_product(a[i], b[i]);
        let (next, lost) = two_sum(sum, product);
        sum = next;
        rest += low + lost;
    }
    sum + rest
}

pub(super) fn determinant(matrix: [[f64; 3]; 3]) -> f64 {
    dot(matrix[0], cross(matrix[1], matrix[2]))
}

pub(super) fn scaled(scale: f64, v: [f64; 3]) -> [f64; 3] {
    v.map(|x| x * scale)
}

pub(super) fn times(factor: f64, v: [f64; 3]) -> [f64; 3] {
    v.map(|x| factor * x)
}

pub(super) fn add(u: [f64; 3], v: [f64; 3]) -> [f64; 3] {
    [u[0] + v[0], u[1] + v[1], u[2] + v[2]]
}
