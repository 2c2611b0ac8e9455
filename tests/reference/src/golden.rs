//! The certified values of `data/golden`, made by `data/golden/make.py` with ball arithmetic.

use crate::hexadecimal;
use crate::metrics::Reference;

/// One certified value.
pub struct Row {
    /// The inputs.
    pub inputs: Vec<f64>,
    /// The true value.
    pub truth: Reference,
    /// The same in 40 decimal digits.
    pub digits: &'static str,
}

/// Certified values of the sine integral.
pub fn sine_integral() -> Vec<Row> {
    rows(1, include_str!("../../../data/golden/sine_integral.csv"))
}

/// Certified values of the integral of sinc squared.
pub fn sinc_squared_integral() -> Vec<Row> {
    rows(2, include_str!("../../../data/golden/sinc_squared_integral.csv"))
}

/// One certified complex value.
pub struct ComplexRow {
    /// The inputs.
    pub inputs: Vec<f64>,
    /// The true real and imaginary part.
    pub truth: [Reference; 2],
}

/// Certified values of w, in both half planes.
pub fn faddeeva_w() -> Vec<ComplexRow> {
    complex_rows(2, include_str!("../../../data/golden/faddeeva_w.csv"))
}

/// Certified values of the derivative of w.
pub fn faddeeva_w_derivative() -> Vec<ComplexRow> {
    complex_rows(2, include_str!("../../../data/golden/faddeeva_w_derivative.csv"))
}

/// Certified values of erf.
pub fn erf_complex() -> Vec<ComplexRow> {
    complex_rows(2, include_str!("../../../data/golden/erf_complex.csv"))
}

/// Certified values of erfc.
pub fn erfc_complex() -> Vec<ComplexRow> {
    complex_rows(2, include_str!("../../../data/golden/erfc_complex.csv"))
}

/// Certified values of the scaled erf difference; its modulus is certified, not each part.
pub fn erf_difference_scaled() -> Vec<ComplexRow> {
    complex_rows(3, include_str!("../../../data/golden/erf_difference_scaled.csv"))
}

/// Certified values of exp(-|x|) I0(x).
pub fn bessel_i0_scaled() -> Vec<Row> {
    rows(1, include_str!("../../../data/golden/bessel_i0_scaled.csv"))
}

/// Certified values of ln I0(x).
pub fn log_bessel_i0() -> Vec<Row> {
    rows(1, include_str!("../../../data/golden/log_bessel_i0.csv"))
}

/// Certified values of I1(x)/I0(x).
pub fn bessel_i1_i0_ratio() -> Vec<Row> {
    rows(1, include_str!("../../../data/golden/bessel_i1_i0_ratio.csv"))
}

/// Certified values of the spatial phase; its modulus is certified, not each part.
pub fn spatial_phase() -> Vec<ComplexRow> {
    complex_rows(8, include_str!("../../../data/golden/spatial_phase.csv"))
}

/// Certified values of the rectangle's transform, to digits of its width.
pub fn profile_rectangle() -> Vec<ComplexRow> {
    complex_rows(5, include_str!("../../../data/golden/profile_rectangle.csv"))
}

/// Certified values of the triangle's transform, to digits of its width.
pub fn profile_triangle() -> Vec<ComplexRow> {
    complex_rows(5, include_str!("../../../data/golden/profile_triangle.csv"))
}

/// Certified values of M(H, C).
pub fn footprint_mean_reduced() -> Vec<Row> {
    rows(2, include_str!("../../../data/golden/footprint_mean_reduced.csv"))
}

/// Certified values of the mean over a footprint.
pub fn footprint_mean() -> Vec<Row> {
    rows(5, include_str!("../../../data/golden/footprint_mean.csv"))
}

/// Certified values of the energy of a segment.
pub fn segment_energy() -> Vec<Row> {
    rows(4, include_str!("../../../data/golden/segment_energy.csv"))
}

/// Certified values of the inverse of the integral of sinc squared.
pub fn sinc_squared_inverse() -> Vec<Row> {
    rows(1, include_str!("../../../data/golden/sinc_squared_inverse.csv"))
}

fn number(word: &str) -> f64 {
    hexadecimal::parse(word).unwrap_or_else(|_| panic!("{word:?} in data/golden"))
}

/// A truth in the columns hi, lo, exponent.
fn truth(words: &[&str]) -> Reference {
    Reference {
        hi: number(words[0]),
        lo: number(words[1]),
        exponent: words[2].parse().expect("an exponent"),
    }
}

fn complex_rows(columns: usize, text: &'static str) -> Vec<ComplexRow> {
    let rows = text.lines().skip(1).map(|line| {
        let words: Vec<&str> = line.split(',').collect();
        assert_eq!(words.len(), columns + 8, "{line}");
        ComplexRow {
            inputs: words[..columns].iter().map(|word| number(word)).collect(),
            truth: [truth(&words[columns..]), truth(&words[columns + 4..])],
        }
    });
    rows.collect()
}

fn rows(columns: usize, text: &'static str) -> Vec<Row> {
    let rows = text.lines().skip(1).map(|line| {
        let words: Vec<&'static str> = line.split(',').collect();
        assert_eq!(words.len(), columns + 4, "{line}");
        Row {
            inputs: words[..columns].iter().map(|word| number(word)).collect(),
            truth: truth(&words[columns..]),
            digits: words[columns + 3],
        }
    });
    rows.collect()
}
