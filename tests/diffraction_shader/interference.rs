//! Crossings, the interference with the base, the amplitude kernel of the area density.

use crate::scenes::{complex, profile_row, single, wide};
use crate::worst::Worst;
use iridescence::diffraction::{self, AreaKernel, Coherence, Profile};
use iridescence::{Complex, shader};
use reference::generate::random::Random;
use std::f64::consts::{PI, TAU};

/// Two scratches of any directions in a common plane, and what the crossing's response may be at most.
fn crossing(random: &mut Random) -> ([f32; 15], f64) {
    let [first_width, first_depth, _, gamma, wavelength] = profile_row(random);
    let [second_width, second_depth, ..] = profile_row(random);
    let angle = random.uniform(0.0, TAU);
    let between = random.uniform(0.1, PI - 0.1);
    let between = random.signed(between);
    let radius = random.uniform(5.0, 60.0);
    let (one, two) = (angle.sin_cos(), (angle + between).sin_cos());
    let place = [0; 2].map(|_| random.uniform(-3.0, 3.0) * radius);
    let xi = [0; 2].map(|_| random.uniform(-1.4, 1.4));
    let row = [
        single(radius),
        wavelength,
        first_width,
        first_depth,
        second_width,
        second_depth,
        single(one.1),
        single(one.0),
        single(two.1),
        single(two.0),
        single(place[0]),
        single(place[1]),
        single(xi[0]),
        single(xi[1]),
        gamma,
    ];
    let area = f64::from(first_width) * f64::from(second_width) / between.sin().abs();
    (row, 4.0 * area)
}

fn ours([a, b, c, d, e, f, g, h, i, j, k, l, m, n, o]: [f32; 15]) -> shader::Complex {
    shader::crossing_response(a, b, c, d, e, f, g, h, i, j, k, l, m, n, o)
}

fn theirs(row: [f32; 15]) -> Complex<f64> {
    let [radius, wavelength, w1, d1, w2, d2, x1, y1, x2, y2, x, y, xi, eta, gamma] = wide(row);
    let profiles = [Profile { width: w1, depth: d1 }, Profile { width: w2, depth: d2 }];
    diffraction::crossing_response(
        Coherence { radius, wavelength },
        profiles,
        [[x1, y1], [x2, y2]],
        [x, y],
        [xi, eta, gamma],
    )
}

#[test]
fn a_crossing_holds_its_bound() {
    let mut random = Random::new(412);
    let mut worst = Worst::of("crossing, over its largest value");
    let mut narrow = Worst::of("crossing of scratches up to 5 um");
    for _ in 0..500_000 {
        let (row, peak) = crossing(&mut random);
        if peak < 1e-25 {
            continue;
        }
        let error = (complex(ours(row)) - theirs(row)).norm() / peak;
        if row[2].max(row[4]) <= 5.0 {
            narrow.add(error, &row);
        } else {
            worst.add(error, &row);
        }
    }
    worst.hold(7e-7);
    narrow.hold(7e-7);
}

#[test]
fn a_crossing_of_nothing_is_nothing_and_a_nan_stays() {
    let mut random = Random::new(413);
    for _ in 0..1000 {
        let (row, _) = crossing(&mut random);
        for flat in 2..6 {
            let mut nothing = row;
            nothing[flat] = 0.0;
            let value = ours(nothing);
            assert_eq!((value.re, value.im), (0.0, 0.0), "{nothing:?}");
        }
        for k in 0..15 {
            let mut strange = row;
            strange[k] = f32::NAN;
            let value = ours(strange);
            assert!(value.re.is_nan() && value.im.is_nan(), "argument {k}");
        }
    }
}

#[test]
fn the_interference_with_the_base_completes_the_squares() {
    let mut random = Random::new(414);
    for _ in 0..10_000 {
        let [base, re, im] = [0; 3].map(|_| single(random.uniform(-10.0, 10.0)));
        let whole = shader::reflectance_coherent(10.0, 0.5, base, re, im);
        let sum = base * base + (re * re + im * im) + shader::base_interference(base, re);
        let parts = shader::reflectance_incoherent(10.0, 0.5, sum);
        let scale = shader::reflectance_incoherent(10.0, 0.5, base * base + (re * re + im * im));
        assert!((whole - parts).abs() <= 1e-6 * scale, "{base} {re} {im}");
    }
}

#[test]
fn the_amplitude_kernel_holds_its_bound() {
    let mut random = Random::new(415);
    let mut worst = Worst::of("area density of the amplitude");
    for _ in 0..200_000 {
        let [width, ..] = profile_row(&mut random);
        let radius = single(random.uniform(5.0, 60.0));
        let offset = single(random.uniform(-5.0, 5.0)) * radius;
        let [w, o, r] = wide([width, offset, radius]);
        let truth = diffraction::area_density(AreaKernel::Amplitude, w, o, r);
        let ours = f64::from(shader::area_density_amplitude(width, offset, radius));
        worst.add((ours - truth).abs() / (w / r).max(1e-30), &[width, offset, radius]);
    }
    worst.hold(2e-7);
    for far in [f32::INFINITY, -1e30] {
        assert_eq!(shader::area_density_amplitude(1.0, far, 10.0), 0.0);
    }
    assert!(shader::area_density_amplitude(f32::NAN, 1.0, 10.0).is_nan());
}
