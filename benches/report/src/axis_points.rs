//! Points spaced evenly in the logarithm.

/// The point at part `t` in [0, 1] of an interval of positive numbers, evenly in the logarithm.
pub fn logarithmic(range: [f64; 2], t: f64) -> f64 {
    range[0] * libm::pow(range[1] / range[0], t)
}
