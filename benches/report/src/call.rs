//! One row through any kind of call.

use reference::registry::Call;

/// The results of a method for one row of inputs, as f64; f32 methods get the row rounded to f32. The row has as many
/// columns as the call takes.
pub fn one_row(call: &Call, row: &[f64]) -> f64 {
    let single = |i: usize| row[i] as f32;
    match *call {
        Call::F64(f) => f(row[0]),
        Call::F64Pair(f) => f([row[0], row[1]]),
        Call::F32(f) => f64::from(f(single(0))),
        Call::F32Pair(f) => f64::from(f(single(0), single(1))),
        Call::F32Triple(f) => f64::from(f(single(0), single(1), single(2))),
        Call::F64Slice(f) => through(f, [row[0]]),
        Call::F64PairSlice(f) => through(f, [[row[0], row[1]]]),
        Call::F32Slice(f) => f64::from(through(f, [single(0)])),
        Call::F32PairSlice(f) => f64::from(through(f, [[single(0), single(1)]])),
    }
}

fn through<X, Y: Default + Copy>(f: fn(&[X], &mut [Y]), x: [X; 1]) -> Y {
    let mut out = [Y::default()];
    f(&x, &mut out);
    out[0]
}
