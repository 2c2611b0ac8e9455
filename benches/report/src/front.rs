//! The Pareto front: the methods that no other method beats in both time and error.

/// Indices of the points that no other point beats or equals in both coordinates, by rising first coordinate.
/// Of equal points the first counts. Points that are not finite in the first coordinate, or NaN, are left out.
pub fn front(points: &[[f64; 2]]) -> Vec<usize> {
    let mut order: Vec<usize> = (0..points.len())
        .filter(|&i| points[i][0].is_finite() && !points[i][1].is_nan())
        .collect();
    order.sort_by(|&i, &j| {
        let (a, b) = (points[i], points[j]);
        a[0].total_cmp(&b[0]).then(a[1].total_cmp(&b[1])).then(i.cmp(&j))
    });
    let mut best = f64::INFINITY;
    order
        .into_iter()
        .filter(|&i| {
            let on = points[i][1] < best;
            best = best.min(points[i][1]);
            on
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_front_holds_what_nothing_beats() {
        let points = [
            [2.0, 1e-3],
            [1.0, 1e-1],
            [3.0, 1e-3],
            [4.0, 1e-9],
            [1.0, 1e-2],
            [f64::NAN, 0.0],
            [5.0, 1e-9],
        ];
        assert_eq!(front(&points), vec![4, 0, 3]);
        assert!(front(&[]).is_empty());
    }
}
