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

fn rows(columns: usize, text: &'static str) -> Vec<Row> {
    let number = |word: &str| hexadecimal::parse(word).unwrap_or_else(|_| panic!("{word:?} in data/golden"));
    let rows = text.lines().skip(1).map(|line| {
        let words: Vec<&'static str> = line.split(',').collect();
        assert_eq!(words.len(), columns + 4, "{line}");
        Row {
            inputs: words[..columns].iter().map(|word| number(word)).collect(),
            truth: Reference {
                hi: number(words[columns]),
                lo: number(words[columns + 1]),
                exponent: words[columns + 2].parse().expect("an exponent"),
            },
            digits: words[columns + 3],
        }
    });
    rows.collect()
}
