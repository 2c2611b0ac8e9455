//! The public functions of `iridescence::shader`, callable by name on rows of numbers.

use iridescence::shader;

use crate::adapter::Kernel;
use crate::comparison::Continuous;

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
    complex("faddeeva_w", 2, |z, y| store(shader::faddeeva_w(z[0], z[1]), y)),
    complex("faddeeva_w_coarse", 2, |z, y| {
        store(shader::faddeeva_w_coarse(z[0], z[1]), y)
    }),
    complex("erf_difference_scaled", 3, |x, y| {
        store(shader::erf_difference_scaled(x[0], x[1], x[2]), y)
    }),
    complex("erf_difference_scaled_turns", 5, |x, y| {
        store(shader::erf_difference_scaled_turns(x[0], x[1], x[2], x[3], x[4]), y)
    }),
    plain("width_term", 3, |x, y| y[0] = shader::width_term(x[0], x[1], x[2])),
    complex("depth_term", 3, |x, y| store(shader::depth_term(x[0], x[1], x[2]), y)),
    plain("depth_term_squared", 3, |x, y| {
        y[0] = shader::depth_term_squared(x[0], x[1], x[2])
    }),
    complex("profile_rectangle", 5, |x, y| {
        store(shader::profile_rectangle(x[0], x[1], x[2], x[3], x[4]), y)
    }),
    complex("profile_triangle", 5, |x, y| {
        store(shader::profile_triangle(x[0], x[1], x[2], x[3], x[4]), y)
    }),
    complex("response_triangle", 5, |x, y| {
        store(shader::response_triangle(x[0], x[1], x[2], x[3], x[4]), y)
    }),
    plain("base_interference", 2, |x, y| {
        y[0] = shader::base_interference(x[0], x[1])
    }),
    complex("crossing_response", 15, |x, y| {
        store(
            shader::crossing_response(
                x[0], x[1], x[2], x[3], x[4], x[5], x[6], x[7], x[8], x[9], x[10], x[11], x[12], x[13], x[14],
            ),
            y,
        )
    }),
    plain("area_density_amplitude", 3, |x, y| {
        y[0] = shader::area_density_amplitude(x[0], x[1], x[2])
    }),
    complex("spatial_phase", 8, |x, y| {
        store(shader::spatial_phase(x[0], x[1], x[2], x[3], x[4], x[5], x[6], x[7]), y)
    }),
    complex("spatial_phase_infinite", 5, |x, y| {
        store(shader::spatial_phase_infinite(x[0], x[1], x[2], x[3], x[4]), y)
    }),
    plain("spatial_phase_infinite_squared", 4, |x, y| {
        y[0] = shader::spatial_phase_infinite_squared(x[0], x[1], x[2], x[3])
    }),
    plain("coherence_window", 2, |x, y| {
        y[0] = shader::coherence_window(x[0], x[1])
    }),
    plain("base_response", 4, |x, y| {
        y[0] = shader::base_response(x[0], x[1], x[2], x[3])
    }),
    plain("area_density", 3, |x, y| y[0] = shader::area_density(x[0], x[1], x[2])),
    plain("energy_blend_base", 2, |x, y| {
        y[0] = shader::energy_blend_base(x[0], x[1])
    }),
    plain("energy_blend_scattered", 2, |x, y| {
        y[0] = shader::energy_blend_scattered(x[0], x[1])
    }),
    plain("energy_blend_scratches", 1, |x, y| {
        y[0] = shader::energy_blend_scratches(x[0])
    }),
    plain("reflectance_coherent", 5, |x, y| {
        y[0] = shader::reflectance_coherent(x[0], x[1], x[2], x[3], x[4])
    }),
    plain("reflectance_incoherent", 3, |x, y| {
        y[0] = shader::reflectance_incoherent(x[0], x[1], x[2])
    }),
    plain("scratch_squared", 8, |x, y| {
        y[0] = shader::scratch_squared(x[0], x[1], x[2], x[3], x[4], x[5], x[6], x[7])
    }),
    plain("footprint_half_width", 3, |x, y| {
        y[0] = shader::footprint_half_width(x[0], x[1], x[2])
    }),
    plain("footprint_mean_reduced", 2, |x, y| {
        y[0] = shader::footprint_mean_reduced(x[0], x[1])
    }),
    plain("footprint_mean_reduced_coarse", 2, |x, y| {
        y[0] = shader::footprint_mean_reduced_coarse(x[0], x[1])
    }),
    plain("footprint_mean", 5, |x, y| {
        y[0] = shader::footprint_mean(x[0], x[1], x[2], x[3], x[4])
    }),
    plain("footprint_mean_coarse", 5, |x, y| {
        y[0] = shader::footprint_mean_coarse(x[0], x[1], x[2], x[3], x[4])
    }),
    plain("gaussian_inverse", 1, |x, y| y[0] = shader::gaussian_inverse(x[0])),
    plain("balance_weight", 2, |x, y| y[0] = shader::balance_weight(x[0], x[1])),
    plain("base_lobe_pdf", 7, |x, y| {
        y[0] = shader::base_lobe_pdf(x[0], x[1], x[2], x[3], x[4], x[5], x[6])
    }),
    direction("base_lobe_sample", 6, |x, y| {
        store_direction(shader::base_lobe_sample(x[0], x[1], x[2], x[3], x[4], x[5]), y)
    }),
    plain("scratch_lobe_pdf", 8, |x, y| {
        y[0] = shader::scratch_lobe_pdf(x[0], x[1], x[2], x[3], x[4], x[5], x[6], x[7])
    }),
    direction("scratch_lobe_sample", 7, |x, y| {
        store_direction(shader::scratch_lobe_sample(x[0], x[1], x[2], x[3], x[4], x[5], x[6]), y)
    }),
    plain("scratch_cone_pdf", 7, |x, y| {
        y[0] = shader::scratch_cone_pdf(x[0], x[1], x[2], x[3], x[4], x[5], x[6])
    }),
    direction("scratch_cone_sample", 7, |x, y| {
        store_direction(shader::scratch_cone_sample(x[0], x[1], x[2], x[3], x[4], x[5], x[6]), y)
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
    plain("sphere_light", 9, |x, y| {
        y[0] = shader::sphere_light(x[0], x[1], x[2], x[3], x[4], x[5], x[6], x[7], x[8])
    }),
    plain("sphere_light_chord", 9, |x, y| {
        y[0] = shader::sphere_light_chord(x[0], x[1], x[2], x[3], x[4], x[5], x[6], x[7], x[8])
    }),
    plain("triangle_light", 14, |x, y| {
        y[0] = shader::triangle_light(
            x[0], x[1], x[2], x[3], x[4], x[5], x[6], x[7], x[8], x[9], x[10], x[11], x[12], x[13],
        )
    }),
    plain("triangle_light_chord", 14, |x, y| {
        y[0] = shader::triangle_light_chord(
            x[0], x[1], x[2], x[3], x[4], x[5], x[6], x[7], x[8], x[9], x[10], x[11], x[12], x[13],
        )
    }),
    plain("quad_light", 17, |x, y| {
        y[0] = shader::quad_light(
            x[0], x[1], x[2], x[3], x[4], x[5], x[6], x[7], x[8], x[9], x[10], x[11], x[12], x[13], x[14], x[15], x[16],
        )
    }),
    plain("quad_light_chord", 17, |x, y| {
        y[0] = shader::quad_light_chord(
            x[0], x[1], x[2], x[3], x[4], x[5], x[6], x[7], x[8], x[9], x[10], x[11], x[12], x[13], x[14], x[15], x[16],
        )
    }),
    plain("polygon_light", 30, |x, y| {
        y[0] = shader::polygon_light(
            x[0], x[1], x[2], x[3], x[4], x[5], x[6], x[7], x[8], x[9], x[10], x[11], x[12], x[13], x[14], x[15],
            x[16], x[17], x[18], x[19], x[20], x[21], x[22], x[23], x[24], x[25], x[26], x[27], x[28], x[29],
        )
    }),
    plain("polygon_light_chord", 30, |x, y| {
        y[0] = shader::polygon_light_chord(
            x[0], x[1], x[2], x[3], x[4], x[5], x[6], x[7], x[8], x[9], x[10], x[11], x[12], x[13], x[14], x[15],
            x[16], x[17], x[18], x[19], x[20], x[21], x[22], x[23], x[24], x[25], x[26], x[27], x[28], x[29],
        )
    }),
];

/// Writes a complex number into a row of results.
fn store(z: shader::Complex, row: &mut [f32]) {
    row.copy_from_slice(&[z.re, z.im]);
}

/// Writes a sampled direction into a row of results.
fn store_direction(drawn: shader::SampledDirection, row: &mut [f32]) {
    row.copy_from_slice(&[drawn.x, drawn.y, drawn.z, drawn.pdf]);
}

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

/// A function with a sampled direction as its result.
const fn direction(name: &'static str, arguments: usize, call: fn(&[f32], &mut [f32])) -> Entry {
    Entry {
        name,
        arguments,
        fields: &["x", "y", "z", "pdf"],
        call,
    }
}

/// A hundred-thousandth of the lobe's integral over the whole plane.
fn light_bound(row: &[f32]) -> f64 {
    let [radius, wavelength, width] = [row[0], row[1], row[2]].map(f64::from);
    1e-5 * (wavelength / radius) * (wavelength / width)
}

impl Entry {
    /// The bound across its decisions, where they only choose between forms of one value: an area light chooses how many
    /// panels to sum, on a thousand operations.
    pub fn continuous(&self) -> Option<Continuous> {
        let light = ["sphere_light", "triangle_light", "quad_light", "polygon_light"];
        light.contains(&self.name).then_some(light_bound)
    }

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
