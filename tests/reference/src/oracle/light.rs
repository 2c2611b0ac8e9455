//! The light that a finite scratch sends to one view from a sphere or a polygon, by quadrature in direction-cosine
//! space.
//!
//! # Definition
//!
//! ```math
//! I = \int_{\text{light}} e^{-(\beta(x + o_x))^2}\,\mathrm{sinc}^2\!\big(\tfrac{kW}{2}(y + o_y)\big)\,dx\,dy,
//! \qquad k = \frac{2\pi}{\lambda},\quad \beta = \sigma k
//! ```
//!
//! over the directions (x, y, z), z >= 0, from the shaded point to the light: x along the scratch, y across it, z along
//! the normal, (o_x, o_y) the view.
//!
//! # Domain
//!
//! Rows of finite numbers with sigma, lambda and width positive. A sphere does not hold the shaded point; a polygon is
//! simple, planar or nearly so, and seen from a point outside its own surface. NaN elsewhere.
//!
//! # Methods
//!
//! - The adaptive values: for every x the chords of the light, then Gauss-Legendre rules in x. The integrand has square
//!   roots where an outline turns back in x and kinks at vertices and at the horizon; the pieces end there, and the
//!   variable of each is graded quadratically at both of its ends (`adaptive`). Chord ends come from bracketed roots on
//!   the distance from the axis of a sphere (`cone`) or on the directions along an edge in space (`polygon`). All of
//!   it is reckoned in differences from one direction of the light, so that lights of a hundredth of a degree keep
//!   their digits.
//! - Midpoint sums and Monte Carlo, with nothing but a test whether a direction belongs to the light (`sampling`).
//!
//! # Where it fails
//!
//! Values below 1e-300 underflow to 0. Vertices with coordinates near the ends of the range of f64 overflow. The error
//! holds the difference of two rules and an estimate of the roundings of the chord ends; it is no bound. A needle, or
//! an edge between vertices nearly opposite as seen, costs digits: those of its width, and the error says so.

mod adaptive;
mod cone;
mod legendre;
mod polygon;
mod root;
mod sampling;
#[cfg(test)]
mod scenes;
mod sinc_squared;
#[cfg(test)]
mod tests;
mod vectors;

pub use sampling::{
    MonteCarlo, polygon_light_brute, polygon_light_importance, polygon_light_monte_carlo, sphere_light_brute,
    sphere_light_importance, sphere_light_monte_carlo,
};

use adaptive::{ACCURATE, Rule};
use cone::Cone;
use polygon::Polygon;
use vectors::Vector;

/// An integral and an estimate of its absolute error.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LightValue {
    /// The integral over the light.
    pub value: f64,
    /// Estimated absolute error.
    pub error: f64,
}

impl LightValue {
    const NAN: LightValue = LightValue {
        value: f64::NAN,
        error: f64::NAN,
    };
}

/// What scatters: the first five numbers of a row.
#[derive(Clone, Copy, Debug)]
struct Scratch {
    /// sigma k.
    beta: f64,
    /// k W/2.
    half_wave: f64,
    /// Projection of the view.
    view: [f64; 2],
}

impl Scratch {
    /// None outside the domain.
    fn new(row: &[f64]) -> Option<Scratch> {
        let &[sigma, lambda, width, x, y, ..] = row else {
            panic!("a scratch has 5 numbers: {row:?}")
        };
        let k = std::f64::consts::TAU / lambda;
        let good = row.iter().all(|x| x.is_finite()) && sigma > 0.0 && lambda > 0.0 && width > 0.0;
        good.then_some(Scratch {
            beta: sigma * k,
            half_wave: 0.5 * k * width,
            view: [x, y],
        })
    }

    /// The integrand at a projected direction.
    fn integrand(&self, [x, y]: [f64; 2]) -> f64 {
        let t = self.beta * (x + self.view[0]);
        (-t * t).exp() * sinc_squared::sinc_squared(self.half_wave * (y + self.view[1]))
    }
}

/// Centre and radius of the row sigma, lambda, width, wo_x, wo_y, px, py, pz, radius.
fn sphere_of(row: &[f64]) -> (Vector, f64) {
    let &[_, _, _, _, _, x, y, z, radius] = row else {
        panic!("a row of 9: {row:?}")
    };
    ([x, y, z], radius)
}

/// Vertices of the row sigma, lambda, width, wo_x, wo_y, x1, y1, z1, ...
fn vertices_of(row: &[f64]) -> Vec<Vector> {
    assert!(
        row.len() >= 14 && row.len() % 3 == 2,
        "5 numbers and 3 a vertex: {row:?}"
    );
    row[5..].chunks_exact(3).map(|v| [v[0], v[1], v[2]]).collect()
}

fn sphere_light_by(row: &[f64], rule: &Rule) -> LightValue {
    let (centre, radius) = sphere_of(row);
    match (Scratch::new(row), Cone::new(centre, radius)) {
        (Some(scratch), Some(light)) => adaptive::integrate(&light, &scratch, rule),
        _ => LightValue::NAN,
    }
}

fn polygon_light_by(row: &[f64], rule: &Rule) -> LightValue {
    let vertices = vertices_of(row);
    let light = Scratch::new(row).and_then(|scratch| Some((scratch, Polygon::new(&vertices)?)));
    light.map_or(LightValue::NAN, |(scratch, light)| {
        adaptive::integrate(&light, &scratch, rule)
    })
}

/// The integral over the directions to a sphere, of the row sigma, lambda, width, wo_x, wo_y, px, py, pz, radius:
/// lengths of the scratch in one unit, of the sphere in another. NaN unless the first three are positive, all finite
/// and 0 <= radius < |p|.
///
/// A direction belongs to the light when its cosine with the centre's is at least sqrt(1 - (r/|p|)^2) and z >= 0.
pub fn sphere_light(row: &[f64]) -> LightValue {
    sphere_light_by(row, &ACCURATE)
}

/// The integral over the directions to a polygon, of the row sigma, lambda, width, wo_x, wo_y, x1, y1, z1, x2, y2, z2,
/// ... with three vertices or more. NaN unless the first three are positive, all finite, no vertex is the shaded point,
/// and the vertices lie in an open half space from it.
///
/// A direction belongs to the light when z >= 0 and the ray meets the polygon (even-odd rule), from either side. The
/// edges of a polygon that is not quite planar are straight in space.
pub fn polygon_light(row: &[f64]) -> LightValue {
    polygon_light_by(row, &ACCURATE)
}

/// The chord of a sphere's light on the line xi1 = 0 times the Gaussian's integral, of the row of [`sphere_light`].
pub fn sphere_light_chord(row: &[f64]) -> f64 {
    let (centre, radius) = sphere_of(row);
    match (Scratch::new(row), Cone::new(centre, radius)) {
        (Some(scratch), Some(light)) => adaptive::chord(&light, &scratch),
        _ => f64::NAN,
    }
}

/// The chords of a polygon's light on the line xi1 = 0 times the Gaussian's integral, of the row of [`polygon_light`].
pub fn polygon_light_chord(row: &[f64]) -> f64 {
    let vertices = vertices_of(row);
    let light = Scratch::new(row).and_then(|scratch| Some((scratch, Polygon::new(&vertices)?)));
    light.map_or(f64::NAN, |(scratch, light)| adaptive::chord(&light, &scratch))
}
