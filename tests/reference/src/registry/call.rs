//! How methods are called: one shape of inputs and results each, over rows of f64 in row-major order.

use super::Precision;
use num_complex::Complex;
use std::hint::black_box;
use std::ops::Range;

/// How a method is called. One row of inputs gives one row of results: one number, or the two parts of a complex one.
#[derive(Clone, Copy)]
pub enum Call {
    /// One f64 in, one out.
    F64(fn(f64) -> f64),
    /// Two f64 in (an interval), one out.
    F64Pair(fn([f64; 2]) -> f64),
    /// One f32 in, one out.
    F32(fn(f32) -> f32),
    /// Two f32 in, one out.
    F32Pair(fn(f32, f32) -> f32),
    /// Three f32 in, one out.
    F32Triple(fn(f32, f32, f32) -> f32),
    /// A slice of f64 in, a slice of the same length out.
    F64Slice(fn(&[f64], &mut [f64])),
    /// A slice of f64 intervals in.
    F64PairSlice(fn(&[[f64; 2]], &mut [f64])),
    /// A slice of f32 in.
    F32Slice(fn(&[f32], &mut [f32])),
    /// A slice of f32 intervals in.
    F32PairSlice(fn(&[[f32; 2]], &mut [f32])),
    /// A complex f64 in, a complex one out.
    ComplexF64(fn(Complex<f64>) -> Complex<f64>),
    /// Three f64 in, a complex one out.
    F64TripleComplex(fn([f64; 3]) -> Complex<f64>),
    /// Real and imaginary part in f32 in, a complex f32 out.
    ComplexF32(fn(f32, f32) -> Complex<f32>),
    /// Three f32 in, a complex one out.
    F32TripleComplex(fn([f32; 3]) -> Complex<f32>),
    /// Five f32 in, a complex one out.
    F32QuintupleComplex(fn([f32; 5]) -> Complex<f32>),
    /// A slice of complex f64 in, a slice of the same length out.
    ComplexF64Slice(fn(&[Complex<f64>], &mut [Complex<f64>])),
    /// A slice of f64 triples in, complex f64 out.
    F64TripleComplexSlice(fn(&[[f64; 3]], &mut [Complex<f64>])),
    /// A slice of complex f32 in.
    ComplexF32Slice(fn(&[Complex<f32>], &mut [Complex<f32>])),
    /// A slice of f32 triples in, complex f32 out.
    F32TripleComplexSlice(fn(&[[f32; 3]], &mut [Complex<f32>])),
}

/// A result: one number or a complex one.
pub trait Value: Copy + Default + 'static {
    /// Appends its parts, as f64.
    fn append(self, results: &mut Vec<f64>);
}

impl Value for f64 {
    fn append(self, results: &mut Vec<f64>) {
        results.push(self);
    }
}

impl Value for f32 {
    fn append(self, results: &mut Vec<f64>) {
        results.push(f64::from(self));
    }
}

impl<T: Value> Value for Complex<T> {
    fn append(self, results: &mut Vec<f64>) {
        self.re.append(results);
        self.im.append(results);
    }
}

/// Something done with a call whose shape of inputs and results is known.
pub trait Visitor {
    /// What comes of it.
    type Output;

    /// A function of one row, and the rows.
    fn scalar<X: Copy + 'static, Y: Value>(self, inputs: Vec<X>, f: impl Fn(X) -> Y + 'static) -> Self::Output;

    /// A function of slices, and the rows.
    fn slice<X: 'static, Y: Value>(self, inputs: Vec<X>, f: fn(&[X], &mut [Y])) -> Self::Output;
}

impl Call {
    /// Whether it takes slices.
    pub fn is_slice(&self) -> bool {
        matches!(
            self,
            Call::F64Slice(_)
                | Call::F64PairSlice(_)
                | Call::F32Slice(_)
                | Call::F32PairSlice(_)
                | Call::ComplexF64Slice(_)
                | Call::F64TripleComplexSlice(_)
                | Call::ComplexF32Slice(_)
                | Call::F32TripleComplexSlice(_)
        )
    }

    /// The precision of inputs and results.
    pub fn precision(&self) -> Precision {
        match self {
            Call::F64(_)
            | Call::F64Pair(_)
            | Call::F64Slice(_)
            | Call::F64PairSlice(_)
            | Call::ComplexF64(_)
            | Call::F64TripleComplex(_)
            | Call::ComplexF64Slice(_)
            | Call::F64TripleComplexSlice(_) => Precision::F64,
            Call::F32(_)
            | Call::F32Pair(_)
            | Call::F32Triple(_)
            | Call::F32Slice(_)
            | Call::F32PairSlice(_)
            | Call::ComplexF32(_)
            | Call::F32TripleComplex(_)
            | Call::F32QuintupleComplex(_)
            | Call::ComplexF32Slice(_)
            | Call::F32TripleComplexSlice(_) => Precision::F32,
        }
    }

    /// Numbers in a row of inputs.
    pub fn columns(&self) -> usize {
        match self {
            Call::F64(_) | Call::F32(_) | Call::F64Slice(_) | Call::F32Slice(_) => 1,
            Call::F64Pair(_)
            | Call::F32Pair(_)
            | Call::F64PairSlice(_)
            | Call::F32PairSlice(_)
            | Call::ComplexF64(_)
            | Call::ComplexF32(_)
            | Call::ComplexF64Slice(_)
            | Call::ComplexF32Slice(_) => 2,
            Call::F32Triple(_)
            | Call::F64TripleComplex(_)
            | Call::F32TripleComplex(_)
            | Call::F64TripleComplexSlice(_)
            | Call::F32TripleComplexSlice(_) => 3,
            Call::F32QuintupleComplex(_) => 5,
        }
    }

    /// Numbers in a row of results.
    pub fn results(&self) -> usize {
        match self {
            Call::F64(_)
            | Call::F64Pair(_)
            | Call::F32(_)
            | Call::F32Pair(_)
            | Call::F32Triple(_)
            | Call::F64Slice(_)
            | Call::F64PairSlice(_)
            | Call::F32Slice(_)
            | Call::F32PairSlice(_) => 1,
            _ => 2,
        }
    }

    /// Hands the call and `rows` (row-major; each number rounded to f32 for an f32 call) to a visitor, in their shape.
    pub fn visit<V: Visitor>(&self, rows: &[f64], visitor: V) -> V::Output {
        match *self {
            Call::F64(f) => visitor.scalar(rows.to_vec(), f),
            Call::F64Pair(f) => visitor.scalar(wide::<2>(rows), f),
            Call::F32(f) => visitor.scalar(narrow::<1>(rows), move |[x]| f(x)),
            Call::F32Pair(f) => visitor.scalar(narrow::<2>(rows), move |[a, b]| f(a, b)),
            Call::F32Triple(f) => visitor.scalar(narrow::<3>(rows), move |[a, b, c]| f(a, b, c)),
            Call::F64Slice(f) => visitor.slice(rows.to_vec(), f),
            Call::F64PairSlice(f) => visitor.slice(wide::<2>(rows), f),
            Call::F32Slice(f) => visitor.slice(rows.iter().map(|&x| x as f32).collect(), f),
            Call::F32PairSlice(f) => visitor.slice(narrow::<2>(rows), f),
            Call::ComplexF64(f) => visitor.scalar(complex(wide::<2>(rows)), f),
            Call::F64TripleComplex(f) => visitor.scalar(wide::<3>(rows), f),
            Call::ComplexF32(f) => visitor.scalar(narrow::<2>(rows), move |[re, im]| f(re, im)),
            Call::F32TripleComplex(f) => visitor.scalar(narrow::<3>(rows), f),
            Call::F32QuintupleComplex(f) => visitor.scalar(narrow::<5>(rows), f),
            Call::ComplexF64Slice(f) => visitor.slice(complex(wide::<2>(rows)), f),
            Call::F64TripleComplexSlice(f) => visitor.slice(wide::<3>(rows), f),
            Call::ComplexF32Slice(f) => visitor.slice(complex(narrow::<2>(rows)), f),
            Call::F32TripleComplexSlice(f) => visitor.slice(narrow::<3>(rows), f),
        }
    }

    /// Results for `rows`, both in row-major order. An f32 call gets each number rounded to f32.
    pub fn evaluate(&self, rows: &[f64]) -> Vec<f64> {
        self.visit(rows, Evaluate)
    }

    /// Something to time: evaluates the rows of a range each time it is called.
    pub fn pass(&self, rows: &[f64]) -> Box<dyn FnMut(Range<usize>)> {
        self.visit(rows, Pass)
    }
}

fn wide<const N: usize>(rows: &[f64]) -> Vec<[f64; N]> {
    rows.as_chunks::<N>().0.to_vec()
}

fn narrow<const N: usize>(rows: &[f64]) -> Vec<[f32; N]> {
    let rows = rows.as_chunks::<N>().0.iter();
    rows.map(|row| row.map(|x| x as f32)).collect()
}

fn complex<T>(pairs: Vec<[T; 2]>) -> Vec<Complex<T>> {
    pairs.into_iter().map(|[re, im]| Complex::new(re, im)).collect()
}

struct Evaluate;

impl Visitor for Evaluate {
    type Output = Vec<f64>;

    fn scalar<X: Copy + 'static, Y: Value>(self, inputs: Vec<X>, f: impl Fn(X) -> Y + 'static) -> Vec<f64> {
        let mut results = Vec::with_capacity(2 * inputs.len());
        inputs.into_iter().for_each(|x| f(x).append(&mut results));
        results
    }

    fn slice<X: 'static, Y: Value>(self, inputs: Vec<X>, f: fn(&[X], &mut [Y])) -> Vec<f64> {
        let mut values = vec![Y::default(); inputs.len()];
        f(&inputs, &mut values);
        let mut results = Vec::with_capacity(2 * inputs.len());
        values.into_iter().for_each(|y| y.append(&mut results));
        results
    }
}

struct Pass;

impl Visitor for Pass {
    type Output = Box<dyn FnMut(Range<usize>)>;

    fn scalar<X: Copy + 'static, Y: Value>(self, inputs: Vec<X>, f: impl Fn(X) -> Y + 'static) -> Self::Output {
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

    fn slice<X: 'static, Y: Value>(self, inputs: Vec<X>, f: fn(&[X], &mut [Y])) -> Self::Output {
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
        let call = Call::ComplexF64(swap);
        assert_eq!(call.evaluate(&[1.0, 2.0, 3.0, 4.0]), [2.0, 1.0, 4.0, 3.0]);
        let calls = [
            call,
            Call::F64TripleComplex(|[a, b, c]| Complex::new(a + b, c)),
            Call::ComplexF32(Complex::new),
            Call::F32TripleComplex(|[a, b, c]| Complex::new(a + b, c)),
            Call::F32QuintupleComplex(|[a, b, c, d, e]| Complex::new(a + b + c, d + e)),
            Call::ComplexF64Slice(|x, out| out.copy_from_slice(x)),
            Call::F32TripleComplexSlice(|_, out| out.fill(Complex::new(0.1, 0.2))),
            Call::F64Pair(|[a, b]| a + b),
            Call::F32(|x| x),
        ];
        for call in calls {
            let results = call.evaluate(&ROWS);
            assert_eq!(results.len(), ROWS.len() / call.columns() * call.results());
            let single = results.iter().all(|&x| f64::from(x as f32) == x);
            assert_eq!(single, call.precision() == Precision::F32);
        }
    }
}
