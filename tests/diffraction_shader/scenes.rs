//! Rows of scenes in f32, and the two evaluations of eta on one.

use iridescence::diffraction::{self, Coherence, Segment};
use iridescence::{Complex, shader};
use reference::generate::random::{Random, neighbour_f32};

pub fn complex(z: shader::Complex) -> Complex<f64> {
    Complex::new(f64::from(z.re), f64::from(z.im))
}

pub fn single(x: f64) -> f32 {
    x as f32
}

pub fn wide<const N: usize>(row: [f32; N]) -> [f64; N] {
    row.map(f64::from)
}

pub fn wavelength(random: &mut Random) -> f32 {
    single(random.uniform(0.36, 0.83))
}

/// Width, depth, xi, gamma, wavelength of a scratch.
pub fn profile_row(random: &mut Random) -> [f32; 5] {
    let narrow = random.log_uniform(0.05, 100.0);
    let width = random.pick(&[narrow, 0.0, 1.0, 2.5, narrow, narrow]);
    let shallow = random.log_uniform(1e-4, 20.0);
    let depth = random.pick(&[shallow, 0.0, -shallow, shallow, shallow]);
    let small = random.log_uniform(1e-8, 1e-2);
    let any = random.uniform(-2.0, 2.0);
    let xi = random.pick(&[0.0, small, any, any, any, any]);
    let grazing = random.log_uniform(1e-6, 2.0);
    let gamma = random.pick(&[0.0, grazing, 2.0 - 0.5 * grazing, 2.0]);
    [width, depth, xi, gamma, f64::from(wavelength(random))].map(single)
}

/// A groove at a pole of the printed triangle, or beside it by a few units of the last place and up to 1e-3.
pub fn pole_row(random: &mut Random) -> [f32; 5] {
    loop {
        let [width, depth, _, gamma, wavelength] = profile_row(random);
        let pole = 2.0 * f64::from(depth) * f64::from(gamma) / f64::from(width);
        if pole.is_nan() || pole.abs() >= 2.0 {
            continue;
        }
        let beside = random.log_uniform(1e-8, 1e-3);
        let away = random.signed(beside);
        let near = random.uniform(-4.0, 4.0) as i64;
        let pole = random.pick(&[pole, pole * (1.0 + away)]);
        let xi = neighbour_f32(random.signed(pole), near);
        return [width, depth, single(xi), gamma, wavelength];
    }
}

/// sigma, lambda, xi1, xi2, s_t, s_b, l1, l2 of a scratch about the window: long, tiny, far, half infinite.
pub fn segment_row(random: &mut Random) -> [f32; 8] {
    let any = random.log_uniform(1.0, 200.0);
    let radius = random.pick(&[10.0, 60.0, 10.0, 60.0, any]);
    let wavelength = f64::from(wavelength(random));
    let core = random.log_uniform(1e-6, 2.0);
    let hemisphere = random.uniform(-2.0, 2.0);
    let core = random.signed(core);
    let xi_t = random.pick(&[0.0, core, hemisphere]);
    let xi_b = random.uniform(-2.0, 2.0);
    let xi_b = random.pick(&[0.0, xi_b, xi_b]);
    // A middle within the window or beyond it, a length from 1e-6 to 30 sigma, an origin anywhere on the line.
    let middle = random.uniform(-5.0, 5.0) * radius;
    let half = random.log_uniform(1e-6, 15.0) * radius;
    let far = random.log_uniform(1.0, 10.0) * radius;
    let far = random.signed(far);
    let along = random.pick(&[0.0, middle, far]);
    let across = random.uniform(-6.0, 6.0) * radius;
    let across = random.pick(&[0.0, across, across]);
    let ends = [middle - half - along, middle + half - along];
    let ends = match random.bits() % 8 {
        0 => [f64::NEG_INFINITY, ends[1]],
        1 => [ends[0], f64::INFINITY],
        2 if random.bits().is_multiple_of(4) => [f64::NEG_INFINITY, f64::INFINITY],
        3 => [ends[1], ends[0]],
        _ => ends,
    };
    [radius, wavelength, xi_t, xi_b, along, across, ends[0], ends[1]].map(single)
}

pub fn eta(row: [f32; 8]) -> Complex<f64> {
    let [radius, wavelength, xi_t, xi_b, s_t, s_b, l_from, l_to] = row;
    complex(shader::spatial_phase(
        radius, wavelength, xi_t, xi_b, s_t, s_b, l_from, l_to,
    ))
}

pub fn eta_f64(row: [f32; 8]) -> Complex<f64> {
    let [radius, wavelength, xi_t, xi_b, s_t, s_b, l_from, l_to] = wide(row);
    let segment = Segment {
        position: [s_t, s_b],
        ends: [l_from, l_to],
    };
    diffraction::spatial_phase(Coherence { radius, wavelength }, segment, [xi_t, xi_b])
}
