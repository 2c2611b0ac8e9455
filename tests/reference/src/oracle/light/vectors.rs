//! Vectors of three numbers.

/// Components along scratch, bitangent and normal.
pub type Vector = [f64; 3];

/// Inner product.
pub fn dot(a: Vector, b: Vector) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// a + s b.
pub fn add_scaled(a: Vector, s: f64, b: Vector) -> Vector {
    std::array::from_fn(|k| a[k] + s * b[k])
}

/// Vector product.
pub fn cross(a: Vector, b: Vector) -> Vector {
    std::array::from_fn(|k| {
        let (next, last) = ((k + 1) % 3, (k + 2) % 3);
        a[next] * b[last] - a[last] * b[next]
    })
}

/// Euclidean length.
pub fn length(a: Vector) -> f64 {
    dot(a, a).sqrt()
}

/// The direction of `a`; None without one.
pub fn direction(a: Vector) -> Option<Vector> {
    let size = length(a);
    (size > 0.0 && size.is_finite()).then(|| a.map(|x| x / size))
}

/// Two unit vectors square to the unit vector `axis` and to each other.
pub fn frame(axis: Vector) -> [Vector; 2] {
    // The coordinate axis farthest from it.
    let least = (0..3).fold(0, |k, j| if axis[j].abs() < axis[k].abs() { j } else { k });
    let other: Vector = std::array::from_fn(|k| if k == least { 1.0 } else { 0.0 });
    let across = cross(axis, other);
    let size = length(across);
    let across = across.map(|x| x / size);
    [across, cross(axis, across)]
}

/// Whether a point of the plane lies in a polygon, by the number of edges to its right.
pub fn even_odd(outline: &[[f64; 2]], [x, y]: [f64; 2]) -> bool {
    let mut inside = false;
    for (i, &[x1, y1]) in outline.iter().enumerate() {
        let [x0, y0] = outline[if i == 0 { outline.len() - 1 } else { i - 1 }];
        if (y0 > y) != (y1 > y) && x < x0 + (x1 - x0) * ((y - y0) / (y1 - y0)) {
            inside = !inside;
        }
    }
    inside
}
