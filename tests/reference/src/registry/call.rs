//! How methods are called: rows of f64 in row-major order, handed over in the shape that the method takes.
//!
//! The functions of one variable stand as plain pointers, for the tests that sweep them. Every other shape is a generic
//! wrapper behind one reference: a row of inputs is converted once, before the clock starts, and a timed pass calls the
//! method's own pointer in a loop compiled for its shape.

use super::Precision;
use num_complex::Complex;
use std::hint::black_box;
use std::ops::Range;

/// How a method is called. One row of inputs gives one row of results: one number, or the two parts of a complex one.
#[derive(Clone, Copy)]
pub enum Call {
    /// One f64 in, one out.
    F64(fn(f64) -> f64),
    /// One f32 in, one out.
    F32(fn(f32) -> f32),
    /// A slice of f64 in, a slice of the same length out.
    F64Slice(fn(&[f64], &mut [f64])),
    /// A slice of f32 in.
    F32Slice(fn(&[f32], &mut [f32])),
    /// Any other shape: made by [`Call::row`] and [`Call::rows`].
    Shaped(&'static dyn Shape),
}

/// Something to time: evaluates the rows of a range each time it is called.
pub type Pass = Box<dyn FnMut(Range<usize>)>;

/// A call of any shape.
pub trait Shape: Send + Sync {
    /// Whether it takes slices.
    fn is_slice(&self) -> bool;
    /// The precision of inputs and results.
    fn precision(&self) -> Precision;
    /// Numbers in a row of inputs.
    fn columns(&self) -> usize;
    /// Numbers in a row of results.
    fn results(&self) -> usize;
    /// Results for rows, both in row-major order.
    fn evaluate(&self, rows: &[f64]) -> Vec<f64>;
    /// Something to time on these rows.
    fn pass(&self, rows: &[f64]) -> Pass;
}

/// A number format of inputs and results.
pub trait Number: Copy + Default + Send + Sync + 'static {
    /// Its precision.
    const PRECISION: Precision;
    /// The nearest number of the format.
    fn nearest(x: f64) -> Self;
    /// The number as f64.
    fn wide(self) -> f64;
}

impl Number for f64 {
    const PRECISION: Precision = Precision::F64;
    fn nearest(x: f64) -> f64 {
        x
    }
    fn wide(self) -> f64 {
        self
    }
}

impl Number for f32 {
    const PRECISION: Precision = Precision::F32;
    fn nearest(x: f64) -> f32 {
        x as f32
    }
    fn wide(self) -> f64 {
        f64::from(self)
    }
}

/// A row of inputs: one number, a complex one, or an array.
pub trait Input: Copy + Send + Sync + 'static {
    /// Its number format.
    type Number: Number;
    /// Numbers in a row.
    const COLUMNS: usize;
    /// The row that these numbers make.
    fn read(row: &[f64]) -> Self;
}

impl Input for f64 {
    type Number = f64;
    const COLUMNS: usize = 1;
    fn read(row: &[f64]) -> f64 {
        row[0]
    }
}

impl Input for f32 {
    type Number = f32;
    const COLUMNS: usize = 1;
    fn read(row: &[f64]) -> f32 {
        row[0] as f32
    }
}

impl<T: Number> Input for Complex<T> {
    type Number = T;
    const COLUMNS: usize = 2;
    fn read(row: &[f64]) -> Complex<T> {
        Complex::new(T::nearest(row[0]), T::nearest(row[1]))
    }
}

impl<T: Number, const N: usize> Input for [T; N] {
    type Number = T;
    const COLUMNS: usize = N;
    fn read(row: &[f64]) -> [T; N] {
        std::array::from_fn(|i| T::nearest(row[i]))
    }
}

/// A result: one number or a complex one.
pub trait Value: Copy + Default + Send + Sync + 'static {
    /// Numbers in it.
    const PARTS: usize;
    /// Appends its parts, as f64.
    fn append(self, results: &mut Vec<f64>);
}

impl Value for f64 {
    const PARTS: usize = 1;
    fn append(self, results: &mut Vec<f64>) {
        results.push(self);
    }
}

impl Value for f32 {
    const PARTS: usize = 1;
    fn append(self, results: &mut Vec<f64>) {
        results.push(f64::from(self));
    }
}

impl<T: Number> Value for Complex<T> {
    const PARTS: usize = 2;
    fn append(self, results: &mut Vec<f64>) {
        results.extend([self.re.wide(), self.im.wide()]);
    }
}

/// A function of one row.
struct Row<X, Y>(fn(X) -> Y);

/// A function of slices of rows.
struct Rows<X, Y>(fn(&[X], &mut [Y]));

impl Call {
    /// The call of a function of one row: of an array, a complex number, or one number.
    pub fn row<X: Input, Y: Value>(f: fn(X) -> Y) -> Call {
        Call::Shaped(Box::leak(Box::new(Row(f))))
    }

    /// The call of a function of a slice of rows.
    pub fn rows<X: Input, Y: Value>(f: fn(&[X], &mut [Y])) -> Call {
        Call::Shaped(Box::leak(Box::new(Rows(f))))
    }

    /// Does something with the shape.
    fn with<R>(&self, act: impl FnOnce(&dyn Shape) -> R) -> R {
        match *self {
            Call::F64(f) => act(&Row(f)),
            Call::F32(f) => act(&Row(f)),
            Call::F64Slice(f) => act(&Rows(f)),
            Call::F32Slice(f) => act(&Rows(f)),
            Call::Shaped(shape) => act(shape),
        }
    }

    /// Whether it takes slices.
    pub fn is_slice(&self) -> bool {
        self.with(|shape| shape.is_slice())
    }

    /// The precision of inputs and results.
    pub fn precision(&self) -> Precision {
        self.with(|shape| shape.precision())
    }

    /// Numbers in a row of inputs.
    pub fn columns(&self) -> usize {
        self.with(|shape| shape.columns())
    }

    /// Numbers in a row of results.
    pub fn results(&self) -> usize {
        self.with(|shape| shape.results())
    }

    /// Results for `rows`, both in row-major order. An f32 call gets each number rounded to f32.
    pub fn evaluate(&self, rows: &[f64]) -> Vec<f64> {
        self.with(|shape| shape.evaluate(rows))
    }

    /// Something to time: evaluates the rows of a range each time it is called.
    pub fn pass(&self, rows: &[f64]) -> Pass {
        self.with(|shape| shape.pass(rows))
    }
}

fn read<X: Input>(rows: &[f64]) -> Vec<X> {
    rows.chunks_exact(X::COLUMNS).map(X::read).collect()
}

fn written<Y: Value>(values: Vec<Y>) -> Vec<f64> {
    let mut results = Vec::with_capacity(Y::PARTS * values.len());
    values.into_iter().for_each(|y| y.append(&mut results));
    results
}

impl<X: Input, Y: Value> Shape for Row<X, Y> {
    fn is_slice(&self) -> bool {
        false
    }
    fn precision(&self) -> Precision {
        X::Number::PRECISION
    }
    fn columns(&self) -> usize {
        X::COLUMNS
    }
    fn results(&self) -> usize {
        Y::PARTS
    }
    fn evaluate(&self, rows: &[f64]) -> Vec<f64> {
        written(read(rows).into_iter().map(self.0).collect())
    }
    fn pass(&self, rows: &[f64]) -> Pass {
        let (f, inputs) = (self.0, read::<X>(rows));
        let mut results = vec![Y::default(); inputs.len()];
        Box::new(move |range| {
            let f = black_box(&f);
            let results = &mut results[range.clone()];
            for (result, &x) in results.iter_mut().zip(black_box(&inputs[range])) {
                *result = f(x);
            }
            black_box(results);
        })
    }
}

impl<X: Input, Y: Value> Shape for Rows<X, Y> {
    fn is_slice(&self) -> bool {
        true
    }
    fn precision(&self) -> Precision {
        X::Number::PRECISION
    }
    fn columns(&self) -> usize {
        X::COLUMNS
    }
    fn results(&self) -> usize {
        Y::PARTS
    }
    fn evaluate(&self, rows: &[f64]) -> Vec<f64> {
        let inputs = read::<X>(rows);
        let mut values = vec![Y::default(); inputs.len()];
        self.0(&inputs, &mut values);
        written(values)
    }
    fn pass(&self, rows: &[f64]) -> Pass {
        let (f, inputs) = (self.0, read::<X>(rows));
        let mut results = vec![Y::default(); inputs.len()];
        Box::new(move |range| {
            let results = &mut results[range.clone()];
            f(black_box(&inputs[range]), results);
            black_box(results);
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const ROWS: [f64; 30] = [0.1; 30];

    #[test]
    fn columns_results_and_precision_are_those_of_the_shape() {
        let swap = |z: Complex<f64>| Complex::new(z.im, z.re);
        let call = Call::row(swap);
        assert_eq!(call.evaluate(&[1.0, 2.0, 3.0, 4.0]), [2.0, 1.0, 4.0, 3.0]);
        let calls: [(Call, usize, usize, bool); 8] = [
            (call, 2, 2, false),
            (Call::row(|[a, b, c]: [f64; 3]| Complex::new(a + b, c)), 3, 2, false),
            (Call::row(|x: [f32; 5]| Complex::new(x[0] + x[4], x[2])), 5, 2, false),
            (Call::row(|x: [f64; 10]| x.iter().sum::<f64>()), 10, 1, false),
            (
                Call::rows(|x: &[[f32; 6]], out| out.iter_mut().zip(x).for_each(|(o, x)| *o = x[0] + x[5])),
                6,
                1,
                true,
            ),
            (
                Call::rows(|x: &[Complex<f64>], out: &mut [Complex<f64>]| out.copy_from_slice(x)),
                2,
                2,
                true,
            ),
            (Call::F32(|x| x), 1, 1, false),
            (Call::F64Slice(|x, out| out.copy_from_slice(x)), 1, 1, true),
        ];
        for (call, columns, width, slice) in calls {
            assert_eq!(
                (call.columns(), call.results(), call.is_slice()),
                (columns, width, slice)
            );
            let results = call.evaluate(&ROWS);
            assert_eq!(results.len(), ROWS.len() / columns * width);
            let single = results.iter().all(|&x| f64::from(x as f32) == x);
            assert_eq!(single, call.precision() == Precision::F32);
        }
    }

    #[test]
    fn a_pass_evaluates_the_rows_of_its_range_alone() {
        use std::sync::atomic::{AtomicUsize, Ordering};
        static CALLS: AtomicUsize = AtomicUsize::new(0);
        let call = Call::row(|[a, b, c]: [f64; 3]| {
            CALLS.fetch_add(1, Ordering::Relaxed);
            a + b + c
        });
        call.pass(&ROWS)(2..5);
        assert_eq!(CALLS.load(Ordering::Relaxed), 3);
    }
}
