//! Monte Carlo over a sphere's tangent cone in f32, as a path tracer would write it: the yardstick of the cost of a chord.

use crate::generate::random::Random;
use iridescence::shader;
use std::f32::consts::TAU;

/// sigma, lambda, width, wo_x, wo_y, px, py, pz, radius.
type Row = [f32; 9];

/// The mean over `N` uniform samples of the cone, each of the integrand times the cone's solid angle and the cosine.
pub fn sphere_light_samples<const N: usize>(row: Row) -> f32 {
    samples::<N>(row, f32::sin_cos, f32::exp)
}

/// The same with the sine, cosine and exponential of the f32 kernels, as a shader that trusts no built-in would.
pub fn sphere_light_samples_portable<const N: usize>(row: Row) -> f32 {
    let sine_cosine = |x| {
        let both = shader::sine_cosine(x);
        (both.sine, both.cosine)
    };
    samples::<N>(row, sine_cosine, shader::exponential)
}

#[inline(always)]
fn samples<const N: usize>(row: Row, sine_cosine: impl Fn(f32) -> (f32, f32), exponential: impl Fn(f32) -> f32) -> f32 {
    let [sigma, lambda, width, view_x, view_y, x, y, z, radius] = row;
    let distance = (x * x + y * y + z * z).sqrt();
    let axis = [x / distance, y / distance, z / distance];
    let sine = radius / distance;
    // 1 less the cosine of half the opening.
    let depth = sine * sine / (1.0 + ((1.0 - sine) * (1.0 + sine)).sqrt());
    let level = axis[1].hypot(axis[2]);
    let first = [level, -axis[0] * axis[1] / level, -axis[0] * axis[2] / level];
    let second = [0.0, axis[2] / level, -axis[1] / level];
    let (along, across) = (TAU * sigma / lambda, 0.5 * TAU * width / lambda);
    let mut random = Random::new(1);
    let mut sum = 0.0;
    for _ in 0..N {
        let bits = random.bits();
        let [u, v] = [(bits >> 40) as f32, (bits & 0xff_ffff) as f32].map(|n| n / 16_777_216.0);
        let cosine = 1.0 - u * depth;
        let sine = ((1.0 - cosine) * (1.0 + cosine)).sqrt();
        let (s, c) = sine_cosine(TAU * v);
        let [x, y, z] = std::array::from_fn(|k| cosine * axis[k] + sine * (c * first[k] + s * second[k]));
        let t = along * (x + view_x);
        let q = across * (y + view_y);
        let sinc = if q.abs() < 1e-4 { 1.0 } else { sine_cosine(q).0 / q };
        sum += exponential(-t * t) * (sinc * sinc) * z.max(0.0);
    }
    TAU * depth * sum / N as f32
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::oracle::light::sphere_light;

    #[test]
    fn many_samples_come_near_the_integral() {
        let row = [20.0, 0.5, 1.5, 0.1, 0.0, 0.0, 0.0, 2.0, 0.5];
        let truth = sphere_light(&row.map(f64::from)).value;
        for found in [
            sphere_light_samples::<1_000_000>(row),
            sphere_light_samples_portable::<1_000_000>(row),
        ] {
            assert!((f64::from(found) / truth - 1.0).abs() < 0.02, "{found:e} {truth:e}");
        }
    }
}
