//! The public functions of `iridescence::shader`, callable by name on rows of numbers.

use iridescence::shader;

use crate::adapter::Kernel;

/// A Rust function of the subset on one row.
#[derive(Clone, Copy, Debug)]
pub struct Entry {
    /// Name in Rust and in WGSL.
    pub name: &'static str,
    /// Number of arguments.
    pub arguments: usize,
    /// Names of the fields of a struct result, empty for a plain f32.
    pub fields: &'static [&'static str],
    /// Reads a row of arguments and writes the row of results.
    pub call: fn(&[f32], &mut [f32]),
}

/// Every public function of the subset.
pub const CATALOGUE: &[Entry] = &[
    plain("sine_integral", 1, |x, y| y[0] = shader::sine_integral(x[0])),
    plain("sine_integral_medium", 1, |x, y| {
        y[0] = shader::sine_integral_medium(x[0])
    }),
    plain("sine_integral_coarse", 1, |x, y| {
        y[0] = shader::sine_integral_coarse(x[0])
    }),
    plain("sine_integral_velinov", 1, |x, y| {
        y[0] = shader::sine_integral_velinov(x[0])
    }),
    plain("sinc_squared_integral", 2, |q, y| {
        y[0] = shader::sinc_squared_integral(q[0], q[1])
    }),
    plain("sinc_squared_integral_medium", 2, |q, y| {
        y[0] = shader::sinc_squared_integral_medium(q[0], q[1])
    }),
    plain("sinc_squared_integral_coarse", 2, |q, y| {
        y[0] = shader::sinc_squared_integral_coarse(q[0], q[1])
    }),
    plain("sinc_squared_integral_velinov", 2, |q, y| {
        y[0] = shader::sinc_squared_integral_velinov(q[0], q[1])
    }),
    plain("sinc_squared_integral_turns", 3, |x, y| {
        y[0] = shader::sinc_squared_integral_turns(x[0], x[1], x[2])
    }),
    plain("bessel_i0_scaled", 1, |x, y| y[0] = shader::bessel_i0_scaled(x[0])),
    plain("log_bessel_izero", 1, |x, y| y[0] = shader::log_bessel_izero(x[0])),
    plain("bessel_ratio", 1, |x, y| y[0] = shader::bessel_ratio(x[0])),
    complex("faddeeva_w", 2, |z, y| {
        let w = shader::faddeeva_w(z[0], z[1]);
        y.copy_from_slice(&[w.re, w.im]);
    }),
    complex("faddeeva_w_coarse", 2, |z, y| {
        let w = shader::faddeeva_w_coarse(z[0], z[1]);
        y.copy_from_slice(&[w.re, w.im]);
    }),
    complex("erf_difference_scaled", 3, |x, y| {
        let difference = shader::erf_difference_scaled(x[0], x[1], x[2]);
        y.copy_from_slice(&[difference.re, difference.im]);
    }),
    complex("erf_difference_scaled_turns", 5, |x, y| {
        let difference = shader::erf_difference_scaled_turns(x[0], x[1], x[2], x[3], x[4]);
        y.copy_from_slice(&[difference.re, difference.im]);
    }),
    plain("exponential", 1, |x, y| y[0] = shader::exponential(x[0])),
    Entry {
        name: "sine_cosine",
        arguments: 1,
        fields: &["sine", "cosine"],
        call: |x, y| {
            let both = shader::sine_cosine(x[0]);
            y.copy_from_slice(&[both.sine, both.cosine]);
        },
    },
    Entry {
        name: "sine_cosine_turns",
        arguments: 1,
        fields: &["sine", "cosine"],
        call: |x, y| {
            let both = shader::sine_cosine_turns(x[0]);
            y.copy_from_slice(&[both.sine, both.cosine]);
        },
    },
];

/// A function with a plain f32 result.
pub const fn plain(name: &'static str, arguments: usize, call: fn(&[f32], &mut [f32])) -> Entry {
    Entry {
        name,
        arguments,
        fields: &[],
        call,
    }
}

/// A function with a complex result.
pub const fn complex(name: &'static str, arguments: usize, call: fn(&[f32], &mut [f32])) -> Entry {
    Entry {
        name,
        arguments,
        fields: &["re", "im"],
        call,
    }
}

impl Entry {
    /// The WGSL function of the same name.
    pub fn kernel(&self) -> Kernel {
        Kernel {
            name: self.name.to_owned(),
            arguments: self.arguments,
            fields: self.fields.iter().map(ToString::to_string).collect(),
        }
    }

    /// Results of the Rust function, row-major.
    pub fn run(&self, rows: &[f32]) -> Vec<f32> {
        let width = self.fields.len().max(1);
        let mut results = vec![0.0; rows.len() / self.arguments * width];
        for (row, result) in rows.chunks_exact(self.arguments).zip(results.chunks_exact_mut(width)) {
            (self.call)(row, result);
        }
        results
    }
}
