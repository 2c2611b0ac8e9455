//! Form factors against quadrature that shares nothing with them: a polygon over its own area, a sphere in polar
//! coordinates about its centre; for the cosine lobe and for transformed ones.

use iridescence::light::{
    LinearCosine, linear_cosine_density, polygon_form_factor, polygon_form_factor_clipless, polygon_linear_cosine,
    sphere_form_factor, sphere_linear_cosine,
};
use reference::gauss::gauss;
use reference::generate::random::Random;
use std::f64::consts::PI;

type Vector = [f64; 3];

const EPSILON: f64 = f64::EPSILON;
const UP: Vector = [0.0, 0.0, 1.0];
const IDENTITY: LinearCosine = LinearCosine {
    matrix: [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], UP],
    amplitude: 1.0,
};

/// Spheres that have nearly set, cross the horizon and are tiny, or nearly touch the shaded point; mpmath, 60 digits, of
/// the exact inputs, by the cancelling closed form.
const GOLDEN: [(Vector, f64, f64); 7] = [
    ([2.0, 0.0, -0.9999], 1.0, 3.0011186903171046e-12),
    ([1.0, 1.0, -1.0], 1.00000001, 8.48826359051397e-22),
    ([0.75, -0.25, -0.999999999], 1.0, 1.5365397405969293e-23),
    ([1.0, 0.0, -1e-9], 1.5e-9, 5.007793432964476e-29),
    ([1.0, 2.0, 1e-12], 3e-12, 9.995728644959997e-37),
    ([1e-7, 2e-7, -1.0], 1.00000000000001, 2.9128704054002793e-16),
    ([0.5, 0.25, -0.75], 0.921875, 0.045880702373529876),
];

fn dot(a: Vector, b: Vector) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn cross(a: Vector, b: Vector) -> Vector {
    [0, 1, 2].map(|i| a[(i + 1) % 3] * b[(i + 2) % 3] - a[(i + 2) % 3] * b[(i + 1) % 3])
}

/// a + t b.
fn step(a: Vector, t: f64, b: Vector) -> Vector {
    [0, 1, 2].map(|i| a[i] + t * b[i])
}

fn less(a: Vector, b: Vector) -> Vector {
    step(a, -1.0, b)
}

fn scale(t: f64, a: Vector) -> Vector {
    a.map(|x| t * x)
}

fn norm(a: Vector) -> f64 {
    dot(a, a).sqrt()
}

fn unit(a: Vector) -> Vector {
    scale(1.0 / norm(a), a)
}

/// max(z, 0)/pi of a unit direction.
fn cosine_density(w: Vector) -> f64 {
    w[2].max(0.0) / PI
}

/// The density of a transformed cosine, from the map of its solid angle by finite vectors: no library code.
fn transformed_density(matrix: [Vector; 3], w: Vector) -> f64 {
    let p = matrix.map(|row| dot(row, w));
    let determinant = dot(matrix[0], cross(matrix[1], matrix[2]));
    cosine_density(unit(p)) * determinant.abs() / norm(p).powi(3)
}

/// A density of directions and the plane that bounds its support.
struct Lobe<F: Fn(Vector) -> f64> {
    density: F,
    horizon: Vector,
}

impl<F: Fn(Vector) -> f64> Lobe<F> {
    /// The integral over a triangle that is entirely visible, cut in four until both sizes agree. Corners are offsets from
    /// `base`, so that a small light far away keeps its shape.
    fn triangle(&self, base: Vector, [a, b, c]: [Vector; 3], tolerance: f64, depth: u32) -> f64 {
        let whole = self.coarse(base, [a, b, c]);
        let [ab, bc, ca] = [(a, b), (b, c), (c, a)].map(|(a, b)| scale(0.5, step(a, 1.0, b)));
        let parts = [[a, ab, ca], [ab, b, bc], [ca, bc, c], [ab, bc, ca]];
        let finer: f64 = parts.iter().map(|&part| self.coarse(base, part)).sum();
        if depth == 0 || (whole - finer).abs() <= tolerance * finer.abs() {
            return finer;
        }
        let finest = parts
            .iter()
            .map(|&part| self.triangle(base, part, tolerance, depth - 1));
        finest.sum()
    }

    fn coarse(&self, base: Vector, [a, b, c]: [Vector; 3]) -> f64 {
        let (ab, ac, bc) = (less(b, a), less(c, a), less(c, b));
        let normal = cross(ab, ac);
        let value = |u: f64, v: f64| {
            let p = step(base, 1.0, step(step(a, u, ab), u * v, bc));
            let r = norm(p);
            u * (self.density)(scale(1.0 / r, p)) * dot(normal, p).abs() / (r * r * r)
        };
        let line = |u: f64| gauss(|v| value(u, v), [0.0, 1.0], 1);
        gauss(line, [0.0, 1.0], 1)
    }

    /// The integral over a plane polygon: signed triangles about its first vertex, each cut at the horizon.
    fn over_polygon(&self, vertices: &[Vector], tolerance: f64) -> f64 {
        let base = vertices[0];
        let offsets: Vec<_> = vertices.iter().map(|&v| less(v, base)).collect();
        let fan = || (1..vertices.len() - 1).map(|i| [[0.0; 3], offsets[i], offsets[i + 1]]);
        let area = fan().fold([0.0; 3], |sum, [_, a, b]| step(sum, 1.0, cross(a, b)));
        let signed = fan().map(|triangle| {
            let sign = dot(area, cross(triangle[1], triangle[2])).signum();
            let visible = self.visible(base, &triangle);
            let parts = (2..visible.len()).map(|i| [visible[0], visible[i - 1], visible[i]]);
            sign * parts.map(|part| self.triangle(base, part, tolerance, 10)).sum::<f64>()
        });
        signed.sum()
    }

    /// A convex polygon cut by the horizon.
    fn visible(&self, base: Vector, offsets: &[Vector]) -> Vec<Vector> {
        let mut kept = Vec::new();
        for (i, &a) in offsets.iter().enumerate() {
            let b = offsets[(i + 1) % offsets.len()];
            let [above, next] = [a, b].map(|v| dot(self.horizon, base) + dot(self.horizon, v));
            if above >= 0.0 {
                kept.push(a);
            }
            if above * next < 0.0 {
                kept.push(step(a, above / (above - next), less(b, a)));
            }
        }
        kept
    }

    /// The integral over a sphere's cone: polar angle and azimuth about its axis, the visible azimuths alone.
    fn over_sphere(&self, centre: Vector, radius: f64, pieces: usize) -> f64 {
        let axis = unit(centre);
        let half = (radius / norm(centre)).asin();
        let along = dot(self.horizon, axis);
        let level = less(self.horizon, scale(along, axis));
        let slope = norm(level);
        let (e1, e2) = (scale(1.0 / slope, level), cross(axis, scale(1.0 / slope, level)));
        let ring = |alpha: f64| {
            let (s, c) = alpha.sin_cos();
            let reach = (-along * c / (slope * s)).clamp(-1.0, 1.0).acos();
            let density = |beta: f64| {
                let (sine, cosine) = beta.sin_cos();
                (self.density)(step(step(scale(c, axis), s * cosine, e1), s * sine, e2))
            };
            s * gauss(density, [-reach, reach], pieces)
        };
        // The reach has the shape of a square root where the ring touches the horizon.
        let touch = (along.abs() / slope).atan().min(half);
        let toward = |end: f64| gauss(|u| 2.0 * u * ring(touch + end * u * u), [0.0, 1.0], pieces) * end.abs();
        let inner = if touch > 0.0 { toward(-touch) } else { 0.0 };
        inner + if half > touch { toward(half - touch) } else { 0.0 }
    }
}

fn cosine_lobe() -> Lobe<fn(Vector) -> f64> {
    Lobe {
        density: cosine_density,
        horizon: UP,
    }
}

fn transformed(lobe: LinearCosine) -> Lobe<impl Fn(Vector) -> f64> {
    Lobe {
        density: move |w| lobe.amplitude * transformed_density(lobe.matrix, w),
        horizon: unit(lobe.matrix[2]),
    }
}

fn direction(random: &mut Random) -> Vector {
    let z = random.uniform(-1.0, 1.0);
    let (s, c) = random.uniform(0.0, 2.0 * PI).sin_cos();
    let level = (1.0 - z * z).sqrt();
    [level * c, level * s, z]
}

/// A polygon about a centre, star-shaped and mostly not convex, in a random plane.
fn polygon(random: &mut Random, centre: Vector, size: f64) -> Vec<Vector> {
    let u = direction(random);
    let v = unit(cross(u, direction(random)));
    let count = random.integer(3, 8);
    let corner = |i: i64| {
        let (s, c) = ((i as f64 + random.uniform(-0.4, 0.4)) * 2.0 * PI / count as f64).sin_cos();
        let reach = size * random.uniform(0.3, 1.0);
        step(step(centre, reach * c, u), reach * s, v)
    };
    (0..count).map(corner).collect()
}

/// A matrix of random entries whose columns are not far from independent.
fn random_lobe(random: &mut Random) -> LinearCosine {
    loop {
        let matrix = [0; 3].map(|_| scale(random.log_uniform(0.5, 2.0), direction(random)));
        let volume = dot(matrix[0], cross(matrix[1], matrix[2])).abs();
        if volume > 0.3 * matrix.iter().map(|&row| norm(row)).product::<f64>() {
            let amplitude = random.uniform(0.2, 1.0);
            return LinearCosine { matrix, amplitude };
        }
    }
}

/// Sine of the angle between a polygon's plane and the direction of its first vertex: 1 when seen from the front.
fn facing(vertices: &[Vector]) -> f64 {
    let normal = unit(cross(less(vertices[1], vertices[0]), less(vertices[2], vertices[0])));
    dot(normal, unit(vertices[0])).abs()
}

fn crosses(vertices: &[Vector], horizon: Vector) -> bool {
    vertices.iter().any(|&v| dot(horizon, v) > 0.0) && vertices.iter().any(|&v| dot(horizon, v) < 0.0)
}

fn close(value: f64, exact: f64, absolute: f64, what: &str) {
    assert!((value - exact).abs() <= absolute, "{what}: {value:e}, exact {exact:e}");
}

fn square(half: f64, height: f64) -> Vec<Vector> {
    [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]]
        .map(|[x, y]| [half * x, half * y, height])
        .to_vec()
}

#[test]
fn a_square_overhead_has_its_textbook_form_factor_and_fills_the_hemisphere_as_it_grows() {
    for half in [1e-9, 1e-3, 0.5, 1.0, 30.0] {
        let t = half / f64::hypot(1.0, half);
        let exact = 4.0 / PI * t * t.atan();
        let value = polygon_form_factor(&square(half, 1.0));
        assert!((value / exact - 1.0).abs() < 4.0 * EPSILON, "{half}: {value}");
    }
    for half in [1e8, 1e150, 1e300] {
        close(polygon_form_factor(&square(half, 1.0)), 1.0, 1e-15, "hemisphere");
        // One of four quarters, and half of it below the horizon.
        let quarter = [[0.0, 0.0, 1.0], [half, 0.0, 1.0], [half, half, 1.0], [0.0, half, 1.0]];
        close(polygon_form_factor(&quarter), 0.25, 1e-8, "quarter");
    }
    // A wall that fills one side: half of the light.
    let wall = [
        [1e-9, -1.0, -1.0],
        [1e-9, 1.0, -1.0],
        [1e-9, 1.0, 1.0],
        [1e-9, -1.0, 1.0],
    ];
    close(polygon_form_factor(&wall), 0.5, 1e-8, "wall");
    // A vertical wall of great width and height h at distance 1: (1 - 1/sqrt(1 + h^2))/2.
    for height in [0.1, 1.0, 7.0] {
        let wide = 1e9;
        let wall = [
            [1.0, -wide, -3.0],
            [1.0, wide, -3.0],
            [1.0, wide, height],
            [1.0, -wide, height],
        ];
        let exact = 0.5 * (1.0 - 1.0 / f64::hypot(1.0, height));
        close(polygon_form_factor(&wall), exact, 1e-8, "long wall");
    }
}

#[test]
fn a_sphere_overhead_gives_the_squared_sine_and_a_half_set_one_its_closed_value() {
    for sine in [1e-12, 0.3, 0.999] {
        assert_eq!(
            sphere_form_factor([0.0, 0.0, 3.0], 3.0 * sine) as f32,
            (sine * sine) as f32
        );
        // Centre on the horizon: (a - sin a cos a)/pi.
        let a = f64::asin(sine);
        let exact = if sine < 1e-3 {
            2.0 / 3.0 * sine.powi(3)
        } else {
            a - a.sin() * a.cos()
        } / PI;
        let value = sphere_form_factor([0.6, 0.8, 0.0], sine);
        assert!((value / exact - 1.0).abs() < 1e-14, "{value:e} {exact:e}");
    }
    // A disc of 10^4 sides is a sphere.
    let (s, c) = f64::sin_cos(0.4);
    let disc: Vec<_> = (0..10_000)
        .map(|i| (2.0 * PI * f64::from(i) / 1e4).sin_cos())
        .map(|(y, x)| [s * x, c * 0.6 + s * y * 0.8, c * 0.8 - s * y * 0.6])
        .collect();
    close(
        polygon_form_factor(&disc),
        sphere_form_factor([0.0, 0.6, 0.8], s),
        2e-8,
        "disc",
    );
}

#[test]
fn setting_and_tiny_spheres_keep_their_digits() {
    // By mpmath in 60 digits.
    for (centre, radius, exact) in GOLDEN {
        let value = sphere_form_factor(centre, radius);
        assert!(
            (value / exact - 1.0).abs() < 1e-13,
            "{centre:?} {radius}: {value:e} {exact:e}"
        );
        // The elliptic cone: by its area where it is narrow, else in closed form, to a few eps of 1.
        let value = sphere_linear_cosine(IDENTITY, centre, radius);
        let allowed = if radius < 0.1 { 1e-13 * exact } else { 1e-15 };
        close(value, exact, allowed, &format!("{centre:?} {radius}"));
    }
}

#[test]
fn spheres_agree_with_quadrature_over_their_cones() {
    let mut random = Random::new(411);
    let (mut crossing, mut worst) = (0, 0.0_f64);
    for _ in 0..400 {
        let centre = direction(&mut random);
        let radius = random.log_uniform(0.05, 0.98);
        crossing += i32::from(centre[2].abs() < radius);
        let exact = cosine_lobe().over_sphere(centre, radius, 8);
        let value = sphere_form_factor(scale(7.0, centre), 7.0 * radius);
        worst = worst.max((value - exact).abs());
        close(value, exact, 2e-13, &format!("{centre:?} {radius}"));
    }
    println!("worst {worst:e}");
    assert!(crossing > 100, "{crossing}");
}

#[test]
fn polygons_agree_with_quadrature_over_their_area() {
    let mut random = Random::new(412);
    let (mut crossing, mut count, mut worst) = (0, 0, 0.0_f64);
    while count < 200 {
        let centre = scale(random.uniform(0.5, 2.0), direction(&mut random));
        let size = random.uniform(0.1, 2.0);
        let vertices = polygon(&mut random, centre, size);
        if facing(&vertices) < 0.1 {
            continue;
        }
        count += 1;
        crossing += i32::from(crosses(&vertices, UP));
        let exact = cosine_lobe().over_polygon(&vertices, 1e-11);
        let value = polygon_form_factor(&vertices);
        worst = worst.max((value - exact).abs());
        close(value, exact, 1e-12, &format!("{vertices:?}"));
    }
    println!("worst {worst:e}");
    assert!(crossing > 50, "{crossing}");
}

#[test]
fn small_polygons_keep_their_digits_above_and_across_the_horizon() {
    let mut random = Random::new(413);
    let mut worst = 0.0_f64;
    for size in [0.017, 1e-4, 1e-6, 1e-8, 1e-11] {
        let mut count = 0;
        while count < 40 {
            let mut centre = direction(&mut random);
            if random.chance(0.5) {
                centre[2] = size * random.uniform(-0.3, 3.0);
            }
            let vertices = polygon(&mut random, centre, 0.5 * size);
            let exact = cosine_lobe().over_polygon(&vertices, 1e-13);
            let spread = 0.01 * size.powi(2) * vertices.iter().map(|v| v[2]).fold(0.0, f64::max);
            // Seen from the edge, or barely in sight: no digits are due.
            if facing(&vertices) < 0.2 || exact <= 0.1 * spread.max(0.0) {
                continue;
            }
            count += 1;
            let value = polygon_form_factor(&vertices);
            worst = worst.max((value / exact - 1.0).abs());
            assert!(
                (value / exact - 1.0).abs() < 1e-12,
                "{size}: {value:e} {exact:e} {vertices:?}"
            );
            // A small light: solid angle times cosine over pi, to second order in its size.
            if size < 1e-7 && vertices.iter().all(|v| v[2] > 0.1) {
                let area = (1..vertices.len() - 1).fold([0.0; 3], |sum, i| {
                    let [a, b] = [vertices[i], vertices[i + 1]].map(|v| less(v, vertices[0]));
                    step(sum, 0.5, cross(a, b))
                });
                let near =
                    dot(area, unit(vertices[0])).abs() / dot(vertices[0], vertices[0]) * unit(vertices[0])[2] / PI;
                assert!((value / near - 1.0).abs() < 100.0 * size, "{value:e} {near:e}");
            }
        }
    }
    println!("worst {worst:e}");
}

#[test]
fn scale_rotation_start_and_order_of_the_vertices_do_not_count() {
    let mut random = Random::new(414);
    for _ in 0..500 {
        let centre = direction(&mut random);
        let size = random.uniform(0.1, 1.5);
        let vertices = polygon(&mut random, centre, size);
        let value = polygon_form_factor(&vertices);
        let each = |f: &dyn Fn(Vector) -> Vector| vertices.iter().map(|&v| f(v)).collect::<Vec<_>>();
        for power in [2f64.powi(660), 2f64.powi(-660), 0.25] {
            assert_eq!(polygon_form_factor(&each(&|v| scale(power, v))), value);
        }
        for length in [1e200, 1e-200, 3.0] {
            close(
                polygon_form_factor(&each(&|v| scale(length, v))),
                value,
                4e-14,
                "length",
            );
        }
        let (s, c) = random.uniform(0.0, 6.0).sin_cos();
        close(
            polygon_form_factor(&each(&|[x, y, z]| [c * x - s * y, s * x + c * y, z])),
            value,
            4e-14,
            "turn",
        );
        close(
            polygon_form_factor(&each(&|[x, y, z]| [-x, y, z])),
            value,
            4e-14,
            "mirror",
        );
        let mut other = vertices.clone();
        other.reverse();
        close(polygon_form_factor(&other), value, 4e-14, "reversal");
        other.rotate_left(2);
        close(polygon_form_factor(&other), value, 4e-14, "start");
        // Vertices twice, and on the edges.
        let denser: Vec<_> = (0..vertices.len())
            .flat_map(|i| {
                let (a, b) = (vertices[i], vertices[(i + 1) % vertices.len()]);
                [a, a, step(a, 0.375, less(b, a))]
            })
            .collect();
        close(polygon_form_factor(&denser), value, 4e-14, "denser");
        let radius = random.uniform(0.0, 0.9);
        let sphere = sphere_form_factor(centre, radius);
        assert_eq!(
            sphere_form_factor(scale(2f64.powi(-700), centre), radius * 2f64.powi(-700)),
            sphere
        );
        close(
            sphere_form_factor(scale(3e300, centre), 3e300 * radius),
            sphere,
            1e-14,
            "sphere",
        );
    }
}

#[test]
fn the_parts_of_a_split_polygon_add_up_and_a_notch_is_taken_out() {
    let mut random = Random::new(415);
    let mut crossing = 0;
    for _ in 0..1000 {
        let corner = scale(random.uniform(0.3, 2.0), direction(&mut random));
        let (u, v) = (direction(&mut random), direction(&mut random));
        let at = |s: f64, t: f64| step(step(corner, s, u), t, v);
        let whole = [at(0.0, 0.0), at(1.0, 0.0), at(1.0, 1.0), at(0.0, 1.0)];
        crossing += i32::from(crosses(&whole, UP));
        let (s, t) = (random.uniform(0.0, 1.0), random.uniform(0.0, 1.0));
        let value = polygon_form_factor(&whole);
        let parts = [
            [at(0.0, 0.0), at(s, 0.0), at(t, 1.0), at(0.0, 1.0)],
            [at(s, 0.0), at(1.0, 0.0), at(1.0, 1.0), at(t, 1.0)],
        ];
        let sum: f64 = parts.iter().map(|part| polygon_form_factor(part)).sum();
        close(sum, value, 2e-13, "sum");
        // Not convex: a triangle from one side to the inside is missing.
        let notched = [
            at(0.0, 0.0),
            at(1.0, 0.0),
            at(0.5 * s + 0.25, t),
            at(1.0, 1.0),
            at(0.0, 1.0),
        ];
        let notch = [at(1.0, 0.0), at(1.0, 1.0), at(0.5 * s + 0.25, t)];
        close(
            polygon_form_factor(&notched) + polygon_form_factor(&notch),
            value,
            2e-13,
            "notch",
        );
    }
    assert!(crossing > 300, "{crossing}");
    // A comb whose teeth go below the horizon and come back: as many arcs along it as there are gaps.
    let teeth = 5;
    let mut comb = vec![[f64::from(teeth), 1.0, 1.0], [0.0, 1.0, 1.0]];
    let mut sum = polygon_form_factor(&[[0.0, 1.0, 0.5], [5.0, 1.0, 0.5], [5.0, 1.0, 1.0], [0.0, 1.0, 1.0]]);
    for tooth in 0..teeth {
        let x = f64::from(tooth);
        comb.extend([
            [x, 1.0, -1.0],
            [x + 0.5, 1.0, -1.0],
            [x + 0.5, 1.0, 0.5],
            [x + 1.0, 1.0, 0.5],
        ]);
        sum += polygon_form_factor(&[[x, 1.0, -1.0], [x + 0.5, 1.0, -1.0], [x + 0.5, 1.0, 0.5], [x, 1.0, 0.5]]);
    }
    close(polygon_form_factor(&comb), sum, 1e-15, "comb");
    // The same comb upside down: its teeth alone are in sight.
    let flipped: Vec<_> = comb.iter().map(|&[x, y, z]| [x, y, -z]).collect();
    let visible: f64 = (0..teeth)
        .map(f64::from)
        .map(|x| polygon_form_factor(&[[x, 1.0, 0.0], [x + 0.5, 1.0, 0.0], [x + 0.5, 1.0, 1.0], [x, 1.0, 1.0]]))
        .sum();
    close(polygon_form_factor(&flipped), visible, 1e-15, "flipped comb");
}

#[test]
fn a_lobe_of_the_identity_is_the_form_factor_and_its_scale_does_not_count() {
    let mut random = Random::new(416);
    for _ in 0..500 {
        let centre = direction(&mut random);
        let size = random.uniform(0.1, 1.5);
        let vertices = polygon(&mut random, centre, size);
        let radius = random.log_uniform(1e-3, 0.99);
        for factor in [1.0, -0.0625, 2f64.powi(900)] {
            let matrix = if factor > 0.0 {
                IDENTITY.matrix.map(|row| scale(factor, row))
            } else {
                [[factor, 0.0, 0.0], [0.0, factor, 0.0], [0.0, 0.0, -factor]]
            };
            let lobe = LinearCosine { matrix, amplitude: 2.0 };
            assert_eq!(
                polygon_linear_cosine(lobe, &vertices),
                2.0 * polygon_form_factor(&vertices)
            );
            let sphere = sphere_linear_cosine(lobe, centre, radius);
            close(sphere, 2.0 * sphere_form_factor(centre, radius), 4e-15, "sphere");
            close(
                linear_cosine_density(lobe, centre),
                2.0 * cosine_density(centre),
                1e-15,
                "density",
            );
        }
    }
}

#[test]
fn transformed_lobes_agree_with_quadrature_of_their_density() {
    let mut random = Random::new(417);
    let (mut crossing, mut count, mut worst) = ([0, 0], 0, [0.0_f64; 2]);
    while count < 100 {
        let lobe = random_lobe(&mut random);
        let oracle = transformed(lobe);
        let w = direction(&mut random);
        let density = (oracle.density)(w);
        close(linear_cosine_density(lobe, w), density, 1e-13 * density, "density");
        let (centre, size) = (direction(&mut random), random.uniform(0.1, 1.5));
        let vertices = polygon(&mut random, centre, size);
        if facing(&vertices) < 0.15 {
            continue;
        }
        count += 1;
        crossing[0] += i32::from(crosses(&vertices, oracle.horizon));
        let exact = oracle.over_polygon(&vertices, 1e-11);
        let value = polygon_linear_cosine(lobe, &vertices);
        worst[0] = worst[0].max((value - exact).abs());
        close(value, exact, 1e-12, &format!("{lobe:?} {vertices:?}"));
        for radius in [random.log_uniform(0.01, 0.2), random.uniform(0.2, 0.97)] {
            crossing[1] += i32::from(dot(oracle.horizon, centre).abs() < radius);
            let exact = oracle.over_sphere(centre, radius, 40);
            let value = sphere_linear_cosine(lobe, centre, radius);
            worst[1] = worst[1].max((value - exact).abs());
            close(value, exact, 1e-12, &format!("{lobe:?} {centre:?} {radius}"));
        }
    }
    println!("worst {worst:?}");
    assert!(crossing[0] > 30 && crossing[1] > 60, "{crossing:?}");
}

#[test]
fn the_whole_lobe_is_its_amplitude() {
    let mut random = Random::new(418);
    for _ in 0..200 {
        let lobe = random_lobe(&mut random);
        // The plane z = 1 of the lobe's space, taken back to the world by Cramer's rule; or a sphere that fills its half.
        let [a, b, c] = lobe.matrix;
        let volume = dot(a, cross(b, c));
        let world = |p: Vector| {
            let part = step(scale(p[0], cross(b, c)), p[1], cross(c, a));
            scale(1.0 / volume, step(part, p[2], cross(a, b)))
        };
        let plane: Vec<_> = square(1e8, 1.0).into_iter().map(world).collect();
        close(polygon_linear_cosine(lobe, &plane), lobe.amplitude, 1e-14, "plane");
        let half = sphere_linear_cosine(lobe, unit(c), 1.0 - 1e-15);
        close(half, lobe.amplitude, 1e-13, "sphere");
    }
}

#[test]
fn strongly_stretched_lobes_stay_with_the_polygon_of_many_sides() {
    let mut random = Random::new(419);
    for _ in 0..50 {
        let stretch = [1.0, 1.0, 1.0].map(|_: f64| random.log_uniform(1e-3, 1.0));
        let mut lobe = random_lobe(&mut random);
        for (row, factor) in lobe.matrix.iter_mut().zip(stretch) {
            *row = scale(factor, *row);
        }
        let axis = direction(&mut random);
        let radius: f64 = random.uniform(0.05, 0.9);
        let e1 = unit(cross(axis, direction(&mut random)));
        let e2 = cross(axis, e1);
        // Between an inscribed and a circumscribed polygon.
        let count = 4000;
        let ring = |grown: f64| -> Vec<Vector> {
            (0..count)
                .map(|i| (2.0 * PI * f64::from(i) / f64::from(count)).sin_cos())
                .map(|(s, c)| {
                    let p = step(scale((1.0 - radius * radius).sqrt(), axis), grown * radius * c, e1);
                    step(p, grown * radius * s, e2)
                })
                .collect()
        };
        let inside = polygon_linear_cosine(lobe, &ring(1.0));
        let outside = polygon_linear_cosine(lobe, &ring(1.0 / (PI / f64::from(count)).cos()));
        let value = sphere_linear_cosine(lobe, axis, radius);
        assert!(
            inside <= value + 1e-13 && value <= outside + 1e-13,
            "{inside} {value} {outside}"
        );
        assert!(outside - inside < 1e-4);
    }
}

/// The vector form factor f through the rational fit (|f|^2 + f_z)/(|f| + 1) that web engines use for the sphere's clip.
fn engine_form_factor(quad: &[Vector; 4]) -> f64 {
    let sum = (0..4).fold([0.0; 3], |sum, i| {
        let (a, b) = (quad[i], quad[(i + 1) % 4]);
        let normal = cross(a, b);
        step(sum, norm(normal).atan2(dot(a, b)) / norm(normal) / (2.0 * PI), normal)
    });
    let toward = dot(cross(less(quad[1], quad[0]), less(quad[3], quad[0])), quad[0]).signum();
    let length = norm(sum);
    ((length * length + toward * sum[2]) / (length + 1.0)).max(0.0)
}

#[test]
fn without_a_clip_the_form_factor_is_right_for_what_is_round_and_off_by_a_sixth_across_the_horizon() {
    // Above the horizon.
    let above = square(0.4, 1.0)
        .iter()
        .map(|v| step(*v, 1.0, [0.3, 0.2, 0.1]))
        .collect::<Vec<_>>();
    close(
        polygon_form_factor_clipless(&above),
        polygon_form_factor(&above),
        1e-15,
        "above",
    );
    // A round polygon at the horizon is as good as a sphere.
    let disc: Vec<_> = (0..1000)
        .map(|i| (f64::from(i) * 2.0 * PI / 1e3).sin_cos())
        .map(|(z, y)| [2.0, y, z + 0.3])
        .collect();
    let error = polygon_form_factor_clipless(&disc) / polygon_form_factor(&disc) - 1.0;
    assert!(error.abs() < 0.02, "{error}");
    let mut random = Random::new(420);
    let (mut errors, mut fitted) = (Vec::new(), Vec::new());
    while errors.len() < 4001 {
        let corner = scale(random.uniform(0.5, 2.0), direction(&mut random));
        let (u, v) = (direction(&mut random), direction(&mut random));
        let quad = [
            corner,
            step(corner, 1.0, u),
            step(step(corner, 1.0, u), 1.0, v),
            step(corner, 1.0, v),
        ];
        if crosses(&quad, UP) {
            let exact = polygon_form_factor(&quad);
            let value = polygon_form_factor_clipless(&quad);
            assert!((0.0..=1.0).contains(&value));
            let mut reversed = quad;
            reversed.reverse();
            close(polygon_form_factor_clipless(&reversed), value, 1e-13, "reversal");
            errors.push((value / exact - 1.0).abs());
            fitted.push((engine_form_factor(&quad) / exact - 1.0).abs());
        }
    }
    let [(median, worse), (fitted, _)] = [errors, fitted].map(|mut errors| {
        errors.sort_by(f64::total_cmp);
        (errors[2000], errors[3600])
    });
    println!("clipless: median {median}, 90 % {worse}; by the fit {fitted}");
    assert!((0.16..0.20).contains(&median) && worse == 1.0, "{median} {worse}");
    assert!((0.40..0.50).contains(&fitted), "{fitted}");
}

#[test]
fn no_finite_light_gives_a_number_outside_0_to_1() {
    let mut random = Random::new(421);
    let values = [
        0.0,
        -0.0,
        1.0,
        -1.0,
        1e-8,
        -1e-8,
        1e-200,
        -1e-200,
        1e200,
        -1e200,
        5e-324,
        -5e-324,
        f64::MAX,
        f64::MIN,
        1e-16,
    ];
    let check = |value: f64, what: &str| assert!((0.0..=1.0).contains(&value), "{what}: {value}");
    for round in 0..40_000 {
        let mut pick = |_: usize| {
            if round % 3 == 0 {
                random.uniform(-1.0, 1.0)
            } else {
                random.pick(&values)
            }
        };
        let count = 2 + round % 5;
        let vertices: Vec<Vector> = (0..count).map(|_| [0, 1, 2].map(&mut pick)).collect();
        let matrix = [0, 1, 2].map(|_| [0, 1, 2].map(&mut pick));
        let lobe = LinearCosine { matrix, amplitude: 1.0 };
        let radius = pick(0).abs();
        let what = format!("{vertices:?} {matrix:?} {radius}");
        check(polygon_form_factor(&vertices), &what);
        check(polygon_form_factor_clipless(&vertices), &what);
        check(polygon_linear_cosine(lobe, &vertices), &what);
        let sphere = sphere_form_factor(vertices[0], radius);
        let transformed = sphere_linear_cosine(lobe, vertices[0], radius);
        assert_eq!(sphere.is_nan(), transformed.is_nan(), "{what}");
        if !sphere.is_nan() {
            check(sphere, &what);
            check(transformed, &what);
        }
    }
}

#[test]
fn degenerate_lights_have_no_form_factor_and_bad_ones_have_nan() {
    let triangle = [[1.0, 0.0, 1.0], [0.0, 1.0, 1.0], [-1.0, -1.0, 1.0]];
    assert_eq!(polygon_form_factor(&[]), 0.0);
    assert_eq!(polygon_form_factor(&triangle[..2]), 0.0);
    assert_eq!(polygon_form_factor(&triangle.map(|[x, y, z]| [x, y, -z])), 0.0);
    assert_eq!(polygon_form_factor(&triangle.map(|[x, y, _]| [x, y, 0.0])), 0.0);
    assert_eq!(polygon_form_factor(&[triangle[0]; 4]), 0.0);
    // A vertex at the shaded point, and an edge through it.
    assert_eq!(polygon_form_factor(&[[0.0; 3], triangle[0], triangle[1]]), 0.0);
    assert_eq!(
        polygon_form_factor(&[[1.0, 0.0, 1.0], [-1.0, 0.0, -1.0], [0.0, 1.0, 1.0]]),
        0.0
    );
    assert_eq!(
        polygon_form_factor(&[[1.0, 0.0, 0.0], [-1.0, 0.0, 0.0], [0.0, 1.0, 1.0]]),
        0.0
    );
    // An edge whose line goes through it, vertices on the horizon, an edge almost through it.
    let radial = [[1.0, 1.0, 1.0], [2.0, 2.0, 2.0], [0.0, 3.0, 1.0]];
    close(polygon_form_factor(&radial), 0.0, 1e-16, "radial");
    let leaning = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    close(polygon_form_factor(&leaning), 0.25, 1e-15, "octant");
    let near = [
        [1.0, 1e-12, 0.0],
        [-1.0, 1e-12, 0.0],
        [-1.0, 1e-12, 1.0],
        [1.0, 1e-12, 1.0],
    ];
    let visible = polygon_form_factor(&near);
    assert!((visible - 0.5).abs() < 1e-11, "{visible}");
    assert_eq!(sphere_form_factor([0.0, 0.0, -1.0], 1.0 - EPSILON), 0.0);
    assert_eq!(sphere_form_factor([1.0, 0.0, -1.0], 1.0), 0.0);
    assert_eq!(sphere_form_factor([1.0, 2.0, 3.0], 0.0), 0.0);
    for (centre, radius) in [
        ([0.0, 0.0, 1.0], 1.0),
        ([0.6, 0.0, 0.0], 1.0),
        ([0.0; 3], 0.0),
        ([0.0, 0.0, 1.0], -0.5),
        ([0.0, f64::INFINITY, 1.0], 1.0),
        ([0.0, 0.0, 1.0], f64::INFINITY),
        ([f64::NAN, 0.0, 1.0], 0.5),
        ([0.0, 0.0, 1.0], f64::NAN),
    ] {
        assert!(sphere_form_factor(centre, radius).is_nan(), "{centre:?} {radius}");
        assert!(
            sphere_linear_cosine(IDENTITY, centre, radius).is_nan(),
            "{centre:?} {radius}"
        );
    }
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        for i in 0..9 {
            let mut vertices = triangle;
            vertices[i / 3][i % 3] = bad;
            assert!(polygon_form_factor(&vertices).is_nan() && polygon_form_factor_clipless(&vertices).is_nan());
            assert!(polygon_linear_cosine(IDENTITY, &vertices).is_nan());
            let mut lobe = IDENTITY;
            lobe.matrix[i / 3][i % 3] = bad;
            assert!(polygon_linear_cosine(lobe, &triangle).is_nan());
            assert!(sphere_linear_cosine(lobe, [0.0, 0.0, 2.0], 1.0).is_nan());
            assert!(linear_cosine_density(lobe, UP).is_nan());
        }
        assert!(polygon_form_factor(&[[bad; 3]]).is_nan());
        assert!(linear_cosine_density(IDENTITY, [0.0, 0.0, bad]).is_nan() || bad.is_infinite());
    }
    let nameless = LinearCosine {
        amplitude: f64::NAN,
        ..IDENTITY
    };
    assert!(polygon_linear_cosine(nameless, &triangle).is_nan());
}
