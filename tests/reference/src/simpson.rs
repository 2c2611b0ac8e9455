//! Simpson's rule with a fixed number of steps, for integrands that a test knows to be smooth.

/// The integral of a function over an interval by Simpson's rule of `count` steps, an even number; real or complex.
pub fn simpson<T>(f: impl Fn(f64) -> T, [from, to]: [f64; 2], count: i32) -> T
where
    T: std::ops::Mul<f64, Output = T> + std::iter::Sum,
{
    let step = (to - from) / f64::from(count);
    let weight = |i: i32| {
        if i == 0 || i == count {
            1.0
        } else {
            f64::from(2 + 2 * (i % 2))
        }
    };
    (0..=count)
        .map(|i| f(from + f64::from(i) * step) * (weight(i) * step / 3.0))
        .sum()
}
