//! Eta of finite, tiny, far and infinite scratches, the window and the base.

use crate::scenes::{complex, eta, eta_f64, segment_row, single, wide};
use crate::worst::Worst;
use iridescence::diffraction::{self, Coherence};
use iridescence::shader;
use reference::generate::random::Random;
use std::f64::consts::PI;

#[test]
fn eta_holds_its_bound_over_the_hemisphere_for_tiny_far_and_infinite_scratches() {
    let mut random = Random::new(403);
    let mut worst = Worst::of("eta");
    for _ in 0..1_500_000 {
        let row = segment_row(&mut random);
        let peak = (2.0 * PI).sqrt() * f64::from(row[0]);
        worst.add((eta(row) - eta_f64(row)).norm() / peak, &row);
    }
    worst.hold(8e-7);
}

#[test]
fn an_origin_far_along_the_line_costs_digits_only_beyond_4096_turns() {
    let mut random = Random::new(409);
    let mut near = Worst::of("eta, origin within 4096 turns");
    let mut far = Worst::of("eta, origin beyond, per turn");
    for _ in 0..1_000_000 {
        let mut row = segment_row(&mut random);
        let origin = random.log_uniform(1.0, 1e5);
        let shift = single(random.signed(origin)) - row[4];
        (row[4], row[6], row[7]) = (row[4] + shift, row[6] - shift, row[7] - shift);
        let peak = (2.0 * PI).sqrt() * f64::from(row[0]);
        let error = (eta(row) - eta_f64(row)).norm() / peak;
        let turns = f64::from(row[4]) * f64::from(row[2]) / f64::from(row[1]);
        if turns.abs() < 4096.0 {
            near.add(error, &row);
        } else {
            far.add(error / turns.abs(), &row);
        }
    }
    near.hold(8e-7);
    far.hold(2e-10);
}

#[test]
fn a_tiny_segment_keeps_digits_of_its_own() {
    let mut random = Random::new(404);
    let mut worst = Worst::of("tiny eta, relative to its length");
    for _ in 0..300_000 {
        let mut row = segment_row(&mut random);
        let length = random.log_uniform(1e-6, 1e-3) * f64::from(row[0]);
        (row[4], row[6], row[7]) = (0.0, single(-0.5 * length), single(0.5 * length));
        row[5] = single(random.uniform(-2.0, 2.0)) * row[0];
        worst.add((eta(row) - eta_f64(row)).norm() / length, &row);
    }
    worst.hold(1e-6);
}

#[test]
fn the_infinite_scratch_the_window_and_the_base_hold_their_bounds() {
    let mut random = Random::new(405);
    let mut infinite = Worst::of("infinite eta");
    let mut squared = Worst::of("infinite eta squared");
    let mut limit = Worst::of("infinite ends against the infinite scratch");
    let mut window = Worst::of("window");
    let mut base = Worst::of("base");
    for _ in 0..500_000 {
        let row = segment_row(&mut random);
        let [radius, wavelength, xi_t, xi_b, _, s_b, ..] = row;
        let [sigma, lambda, x, y, _, s, ..] = wide(row);
        let coherence = Coherence {
            radius: sigma,
            wavelength: lambda,
        };
        let peak = (2.0 * PI).sqrt() * sigma;
        let ours = complex(shader::spatial_phase_infinite(radius, wavelength, xi_t, xi_b, s_b));
        let truth = diffraction::spatial_phase_infinite(coherence, s, [x, y]);
        infinite.add((ours - truth).norm() / peak, &row);
        let ends = [
            radius,
            wavelength,
            xi_t,
            xi_b,
            0.0,
            s_b,
            f32::NEG_INFINITY,
            f32::INFINITY,
        ];
        limit.add((eta(ends) - truth).norm() / peak, &row);
        let ours = f64::from(shader::spatial_phase_infinite_squared(radius, wavelength, xi_t, s_b));
        let truth = diffraction::spatial_phase_infinite_squared(coherence, s, x);
        squared.add((ours - truth).abs() / (peak * peak), &row);
        let ours = f64::from(shader::coherence_window(s_b, radius));
        window.add((ours - diffraction::coherence_window(s, sigma)).abs(), &row);
        let (core_t, core_b) = (xi_t * 0.02, xi_b * 0.02);
        let ours = f64::from(shader::base_response(radius, wavelength, core_t, core_b));
        let truth = diffraction::base_response(coherence, [f64::from(core_t), f64::from(core_b)]);
        base.add((ours - truth).abs() / (peak * peak), &row);
    }
    infinite.hold(8e-7);
    squared.hold(5e-7);
    limit.hold(8e-7);
    window.hold(3e-7);
    base.hold(5e-7);
}
