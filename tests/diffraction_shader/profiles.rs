//! Rectangle, triangle and depth term.

use crate::scenes::{complex, pole_row, profile_row, wide};
use crate::worst::Worst;
use iridescence::diffraction::{self, Profile};
use iridescence::shader;
use reference::generate::random::Random;

#[test]
fn profiles_hold_1e_6_of_the_width_at_the_poles_of_the_printed_triangle_too() {
    let mut random = Random::new(401);
    let mut rectangle = Worst::of("rectangle");
    let mut triangle = Worst::of("triangle");
    let mut poles = Worst::of("triangle at its poles");
    let mut mask = Worst::of("width term");
    for i in 0..1_500_000 {
        let row = if i % 3 == 0 {
            pole_row(&mut random)
        } else {
            profile_row(&mut random)
        };
        let [width, depth, xi, gamma, wavelength] = row;
        let [w, d, x, g, l] = wide(row);
        let (profile, scattering) = (Profile { width: w, depth: d }, [0.3, x, g]);
        let scale = if width == 0.0 { 1.0 } else { w };
        let ours = complex(shader::profile_rectangle(width, depth, xi, gamma, wavelength));
        let truth = diffraction::profile_rectangle(profile, scattering, l);
        rectangle.add((ours - truth).norm() / scale, &row);
        let ours = complex(shader::profile_triangle(width, depth, xi, gamma, wavelength));
        let error = (ours - diffraction::profile_triangle(profile, scattering, l)).norm() / scale;
        if i % 3 == 0 {
            poles.add(error, &row);
        } else {
            triangle.add(error, &row);
        }
        let ours = f64::from(shader::width_term(width, xi, wavelength));
        mask.add((ours - diffraction::width_term(w, x, l)).abs() / scale, &row);
    }
    rectangle.hold(1e-6);
    triangle.hold(1e-6);
    poles.hold(1e-6);
    mask.hold(5e-7);
}

#[test]
fn the_depth_term_holds_to_20_um_and_keeps_a_shallow_groove() {
    let mut random = Random::new(402);
    let mut term = Worst::of("depth term");
    let mut squared = Worst::of("depth term squared");
    let mut shallow = Worst::of("shallow depth term, relative");
    for _ in 0..1_000_000 {
        let [_, depth, _, gamma, wavelength] = profile_row(&mut random);
        let row = [depth, gamma, wavelength];
        let [d, g, l] = wide(row);
        let ours = complex(shader::depth_term(depth, gamma, wavelength));
        let truth = diffraction::depth_term(d, g, l);
        let error = (ours - truth).norm();
        term.add(error, &row);
        let ours = f64::from(shader::depth_term_squared(depth, gamma, wavelength));
        squared.add((ours - diffraction::depth_term_squared(d, g, l)).abs(), &row);
        if (d * g / l).abs() < 0.4 && truth.norm() > 0.0 {
            shallow.add(error / truth.norm(), &row);
        }
    }
    term.hold(1e-6);
    squared.hold(2e-6);
    shallow.hold(1e-6);
}

#[test]
fn the_response_of_a_triangle_keeps_the_digits_of_a_shallow_groove() {
    let mut random = Random::new(411);
    let mut worst = Worst::of("triangle response, over min(1, |p|)");
    for i in 0..1_000_000 {
        let row = if i % 3 == 0 {
            pole_row(&mut random)
        } else {
            profile_row(&mut random)
        };
        let [width, depth, xi, gamma, wavelength] = row;
        let [w, d, x, g, l] = wide(row);
        let size = w * (std::f64::consts::TAU * d * g / l).abs().min(1.0);
        // Below, products leave the range of f32.
        if size < 1e-25 {
            continue;
        }
        let ours = complex(shader::response_triangle(width, depth, xi, gamma, wavelength));
        let truth = diffraction::response_triangle(Profile { width: w, depth: d }, [0.0, x, g], l);
        worst.add((ours - truth).norm() / size, &row);
    }
    worst.hold(1e-6);
}
