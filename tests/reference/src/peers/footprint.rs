//! The mean over a footprint by quadrature of its definition, one rule for all half widths and offsets: no library has the
//! function, and this is what its user would write.

/// (2/pi) int_{-1}^{1} sqrt(1 - t^2) exp(-(H t - C)^2) dt by `N` midpoints in the angle of the window |H t - C| <= `reach`.
pub fn windowed_midpoint<const N: usize>(half_width: f64, offset: f64, reach: f64) -> f64 {
    let edge = half_width - offset.abs();
    if edge < -reach {
        return 0.0;
    }
    if half_width == 0.0 {
        return (-offset * offset).exp();
    }
    // In s = 1 - t, the distance from the nearer edge, so that nothing cancels there: H t - |C| = edge - H s.
    let lo = ((edge - reach) / half_width).max(0.0);
    let hi = ((edge + reach) / half_width).min(2.0);
    let radius = 0.5 * (hi - lo);
    let mut sum = 0.0;
    for j in 0..N {
        let half = std::f64::consts::PI * (j as f64 + 0.5) / (2.0 * N as f64);
        let (sine, cosine) = half.sin_cos();
        let s = lo + 2.0 * radius * sine * sine;
        let x = edge - half_width * s;
        sum += (s * (2.0 - s)).sqrt() * (-x * x).exp() * 2.0 * sine * cosine;
    }
    2.0 / N as f64 * radius * sum
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::oracle::footprint_mean_reduced;

    #[test]
    fn the_rule_converges_with_its_nodes() {
        for row in [[0.0, 0.4], [1.0, 0.3], [6.0, 5.0], [300.0, 299.0], [300.0, -10.0]] {
            let truth = footprint_mean_reduced(&row).value();
            let centre = footprint_mean_reduced(&[row[0], 0.0]).value();
            let error = |mean: f64| (mean - truth).abs() / centre;
            assert!(error(windowed_midpoint::<9>(row[0], row[1], 2.8)) < 2e-3, "{row:?}");
            assert!(error(windowed_midpoint::<17>(row[0], row[1], 3.8)) < 2e-6, "{row:?}");
            assert!(error(windowed_midpoint::<33>(row[0], row[1], 5.4)) < 3e-12, "{row:?}");
        }
    }
}
