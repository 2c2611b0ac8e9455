//! The area density: full coverage gives 1, for either kernel, whatever the directions.

use iridescence::diffraction::*;
use reference::generate::random::Random;
use std::f64::consts::PI;

const KERNELS: [AreaKernel; 2] = [AreaKernel::Amplitude, AreaKernel::Energy];

#[test]
fn scratches_side_by_side_cover_the_surface_once() {
    let (radius, width) = (10.0, 2.0);
    for kernel in KERNELS {
        for shift in [0.0, 0.3, 1.0, 1.7] {
            let tiles = (-80..=80).map(|j| f64::from(j) * width + shift);
            let sum: f64 = tiles.clone().map(|b| area_density(kernel, width, b, radius)).sum();
            assert!((sum - 1.0).abs() < 1e-12, "{kernel:?} {shift}: {sum}");
            let footprint = Footprint {
                axes: [25.0, 4.0],
                cos_phi: 0.6,
            };
            let sum: f64 = tiles
                .map(|b| area_density_footprint(kernel, width, footprint, b, radius))
                .sum();
            assert!((sum - 1.0).abs() < 1e-12, "{kernel:?} {shift}: {sum}");
        }
    }
}

#[test]
fn all_directions_together_cover_the_surface_once_on_average() {
    // Lines within D on either side, one at a random place of each strip: density 1 when count times width is 2 D.
    let (radius, width, count) = (10.0, 0.05, 40_000);
    let distance = 0.5 * width * f64::from(count);
    let mut random = Random::new(9);
    for kernel in KERNELS {
        let mut sum = 0.0;
        for strip in 0..count {
            let line = (f64::from(strip) + random.uniform(0.0, 1.0)) * width - distance;
            // Directions by the golden section, so that neighbouring strips hold all of them.
            let footprint = Footprint {
                axes: [900.0, 300.0],
                cos_phi: (PI * (f64::from(strip) * 0.618_033_988_749_895).fract()).cos(),
            };
            sum += area_density_footprint(kernel, width, footprint, line, radius);
        }
        println!("{kernel:?}: {:e}", sum - 1.0);
        assert!((sum - 1.0).abs() < 1e-3, "{kernel:?}: {sum}");
    }
}

#[test]
fn random_scratches_cover_the_union_of_their_densities() {
    // Lines of random direction and distance from the centre: a Poisson process as far as the footprint sees.
    let (radius, reach) = (2.0, 60.0);
    let footprint = Footprint {
        axes: [30.0, 30.0],
        cos_phi: 1.0,
    };
    let mut random = Random::new(10);
    for (width, count, expected) in [(1.0, 60, 0.5), (2.0, 60, 1.0), (2.0, 120, 2.0)] {
        let (mut covered, mut union, mut plain) = (0.0, 0.0, 0.0);
        let surfaces = 200;
        for _ in 0..surfaces {
            let lines: Vec<_> = (0..count)
                .map(|_| (random.uniform(0.0, PI).sin_cos(), random.uniform(-reach, reach)))
                .collect();
            let sum: f64 = (lines.iter())
                .map(|(_, offset)| area_density_footprint(AreaKernel::Energy, width, footprint, *offset, radius))
                .sum();
            plain += sum;
            union += area_density_union(sum);
            let (mut hits, points) = (0, 500);
            for _ in 0..points {
                // A point of the ellipse, displaced by the window's square.
                let (distance, (sine, cosine)) = (
                    30.0 * random.uniform(0.0, 1.0).sqrt(),
                    random.uniform(0.0, 2.0 * PI).sin_cos(),
                );
                let blur = radius * (-(1.0 - random.uniform(0.0, 1.0)).ln()).sqrt();
                let (turn_sine, turn_cosine) = random.uniform(0.0, 2.0 * PI).sin_cos();
                let [x, y] = [
                    distance * cosine + blur * turn_cosine,
                    distance * sine + blur * turn_sine,
                ];
                hits += i32::from(
                    lines
                        .iter()
                        .any(|((sine, cosine), offset)| (x * cosine + y * sine - offset).abs() < 0.5 * width),
                );
            }
            covered += f64::from(hits) / f64::from(points);
        }
        let [covered, union, plain] = [covered, union, plain].map(|x| x / f64::from(surfaces));
        println!("sum {plain:.3}: covered {covered:.4}, union {union:.4}");
        assert!((plain - expected).abs() < 0.05 * expected, "{plain}");
        assert!((covered - union).abs() < 0.01, "{covered} {union}");
        assert!(plain - covered > 0.08, "{covered} {plain}");
    }
    assert_eq!([0.0, f64::INFINITY].map(area_density_union), [0.0, 1.0]);
    assert_eq!(area_density_union(1e-20), 1e-20);
    assert!([-1e-9, f64::NAN].map(area_density_union).iter().all(|x| x.is_nan()));
}

#[test]
fn the_kernels_as_printed_would_cover_it_twice() {
    // VWH18 Eq. 17: the amplitude window over pi sigma^2.
    let (radius, width) = (10.0, 2.0);
    let printed =
        |b: f64| width * (2.0 * PI).sqrt() * radius * (-0.5 * b * b / (radius * radius)).exp() / coherence_area(radius);
    let sum: f64 = (-80..=80).map(|j| printed(f64::from(j) * width)).sum();
    assert!((sum - 2.0).abs() < 1e-12, "{sum}");
}

#[test]
fn the_density_over_a_point_is_the_density_there() {
    let point = Footprint {
        axes: [0.0, 0.0],
        cos_phi: 0.1,
    };
    for kernel in KERNELS {
        for offset in [0.0, 3.0, -12.0, 40.0] {
            let (there, over) = (
                area_density(kernel, 2.0, offset, 10.0),
                area_density_footprint(kernel, 2.0, point, offset, 10.0),
            );
            assert!(
                (over - there).abs() <= 1e-13 * there,
                "{kernel:?} {offset}: {over:e} {there:e}"
            );
        }
        assert_eq!(area_density(kernel, 0.0, 1.0, 10.0), 0.0);
        assert_eq!(area_density(kernel, 2.0, f64::INFINITY, 10.0), 0.0);
        for (width, offset, radius) in [
            (-1.0, 0.0, 10.0),
            (1.0, f64::NAN, 10.0),
            (1.0, 0.0, 0.0),
            (1.0, 0.0, -2.0),
            (f64::NAN, 0.0, 1.0),
        ] {
            assert!(area_density(kernel, width, offset, radius).is_nan());
            assert!(area_density_footprint(kernel, width, point, offset, radius).is_nan());
        }
    }
}

#[test]
fn the_kernels_fall_like_the_window_and_its_square() {
    let window = coherence_window(7.0, 10.0);
    for (kernel, share) in KERNELS.into_iter().zip([window, window * window]) {
        let fall = area_density(kernel, 2.0, 7.0, 10.0) / area_density(kernel, 2.0, 0.0, 10.0);
        assert!((fall / share - 1.0).abs() < 1e-14, "{kernel:?}: {fall} {share}");
    }
}
