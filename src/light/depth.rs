//! Area lights over a scratch of some depth: the depth term inside the integral.
//!
//! # Definition
//!
//! The depth term depends on the angle of incidence, so that over a wide light it belongs under the integral:
//!
//! ```math
//! I_D = \iint_{\text{light}} e^{-(\sigma k \xi_1)^2}\,\mathrm{sinc}^2\frac{kW\xi_2}{2}\,
//! \bigl|1 - e^{ikD(\gamma_i + \gamma_o)}\bigr|^2\,d\xi_1\,d\xi_2, \qquad
//! \gamma_i = \sqrt{1 - \omega_{i,1}^2 - \omega_{i,2}^2}
//! ```
//!
//! VWH18 takes it out, at normal incidence and observation (Eqs. 4 and 27).
//!
//! # Domain
//!
//! That of [`sphere_light`](super::sphere_light()), any depth that is finite; NaN elsewhere. Depth 0 gives 0.
//!
//! # Methods
//!
//! [`sphere_light_depth`] and [`polygon_light_depth`] follow the light's outline as the integrals without depth do, with the
//! integral along each chord by Gauss-Legendre panels over its angle on the sphere, on which gamma is smooth up to the
//! horizon.
//!
//! [`sphere_light_depth_chord`] and [`polygon_light_depth_chord`] are one chord in closed form: gamma is taken to be linear
//! along the chord, between its ends, and then sinc^2 times a wave is integrated by H of the sine integral and by Cin,
//!
//! ```math
//! \int_0^q \mathrm{sinc}^2 t\,e^{ict}\,dt = \tfrac14\bigl[(2+c)\,h((2+c)q) + (2-c)\,\bar h((2-c)q) - 2c\,h(cq)\bigr],
//! \qquad h = H + iG,\; G(x) = \mathrm{Cin}\,x - 1 + \frac{\sin x}{x}
//! ```
//!
//! # Where it fails
//!
//! The closed form, for a chord long enough for gamma to bend: the phase is off by up to k D times the sagitta of the
//! chord's arc. `tests/light_depth.rs` holds the errors by the length of the chord.

use super::outline_integral;
use super::scratch_lobe::{Scales, ScratchLobe};
use super::sphere::Sphere;
use crate::geometry::{Cone, cone_chords, cone_outline, polygon_crossings, polygon_outline};
use crate::numeric::gauss::SIXTEEN_POINTS;
use crate::special::{cosine_integral_entire, sinc, sinc_squared_integral};

/// Largest phase of a panel of 16 nodes, of lobe and depth together.
const PANEL: f64 = 8.0;
/// Most panels of a chord.
const MOST_PANELS: f64 = 65536.0;

/// The depth term of a scratch as the light moves.
#[derive(Clone, Copy)]
pub(super) struct Depth {
    /// k D.
    phase: f64,
    /// The cosine of observation.
    gamma: f64,
}

impl Depth {
    fn of(lobe: &ScratchLobe, depth: f64) -> Option<Depth> {
        let [x, y] = lobe.view;
        let phase = 2.0 * core::f64::consts::PI * (depth / lobe.coherence.wavelength);
        phase.is_finite().then(|| Depth {
            phase,
            gamma: libm::sqrt((1.0 - (x * x + y * y)).max(0.0)),
        })
    }

    /// k D over k W/2, the depth's part of the phases across a light.
    pub(super) fn share(&self, scales: &Scales) -> f64 {
        self.phase.abs() / scales.across
    }

    /// |1 - exp(ikD(gamma_i + gamma_o))|^2.
    fn term(&self, gamma: f64) -> f64 {
        let sine = libm::sin(0.5 * self.phase * (gamma + self.gamma));
        4.0 * (sine * sine)
    }

    /// k W/2 times the integral of sinc^2 and depth term at this x between two values of y, by panels.
    pub(super) fn chord(&self, scales: &Scales, x: f64, [from, to]: [f64; 2]) -> f64 {
        let edge = libm::sqrt(((1.0 - x) * (1.0 + x)).max(0.0));
        if edge == 0.0 {
            return 0.0;
        }
        let angles = [from, to].map(|y| libm::asin((y / edge).clamp(-1.0, 1.0)));
        let half = 0.5 * (angles[1] - angles[0]);
        let middle = 0.5 * (angles[0] + angles[1]);
        let phase = 2.0 * half.abs() * edge * (2.0 * scales.across + self.phase.abs());
        let panels = libm::ceil(phase / PANEL).clamp(1.0, MOST_PANELS);
        let width = half / panels;
        let mut sum = 0.0;
        for i in 0..panels as u32 {
            let centre = middle + (f64::from(2 * i + 1) - panels) * width;
            for [node, weight] in SIXTEEN_POINTS {
                for angle in [centre - width * node, centre + width * node] {
                    let (sine, cosine) = libm::sincos(angle);
                    let lobe = sinc(scales.across * (edge * sine + scales.view[1]));
                    sum += weight * width * (edge * cosine) * (lobe * lobe) * self.term(edge * cosine);
                }
            }
        }
        scales.across * sum
    }

    /// The same with gamma linear along the chord, in closed form.
    fn chord_linear(&self, scales: &Scales, x: f64, [from, to]: [f64; 2]) -> f64 {
        let rest = (1.0 - x) * (1.0 + x);
        let q = [from, to].map(|y| scales.across * (y + scales.view[1]));
        let gamma = [from, to].map(|y| libm::sqrt((rest - y * y).max(0.0)) + self.gamma);
        let length = q[1] - q[0];
        if length == 0.0 {
            return 0.0;
        }
        // The phase is start + c q.
        let c = self.phase * (gamma[1] - gamma[0]) / length;
        let start = self.phase * gamma[0] - c * q[0];
        let [re, im] = wave_integral(q, c);
        let (sine, cosine) = libm::sincos(start);
        let value = 2.0 * (sinc_squared_integral(q) - (re * cosine - im * sine));
        // A short chord at a zero of the term may round below it, in the direction of the chord.
        if value * length < 0.0 { 0.0 } else { value }
    }
}

/// Returns the integral of sinc^2 t exp(ict) from q\[0\] to q\[1\], real and imaginary part.
fn wave_integral(q: [f64; 2], c: f64) -> [f64; 2] {
    let [from, to] = q.map(|q| {
        // a h(a q) of the three frequencies.
        let part = |a: f64| [a * sinc_squared_integral([0.0, 0.5 * (a * q)]), a * odd_part(a * q)];
        let (above, below, itself) = (part(2.0 + c), part(2.0 - c), part(c));
        [
            0.25 * (above[0] + below[0]) - 0.5 * itself[0],
            0.25 * (above[1] - below[1]) - 0.5 * itself[1],
        ]
    });
    [to[0] - from[0], to[1] - from[1]]
}

/// G(x), the integral of (t - sin t)/t^2 from 0 to x.
fn odd_part(x: f64) -> f64 {
    cosine_integral_entire(x) - (1.0 - sinc(x))
}

/// Returns the integral of a scratch's lobe times its squared depth term over the visible part of a sphere, dimensionless.
///
/// `depth` in um, positive below the surface. Relative error 1e-9 down to 1e-6 of four times the whole plane's integral.
/// VWH18 3.4 with the depth term of WVJH17 Eq. 20 inside.
#[must_use]
pub fn sphere_light_depth(lobe: ScratchLobe, depth: f64, sphere: Sphere) -> f64 {
    let cone = Cone::of_sphere(sphere.centre, sphere.radius);
    let (Some(scales), Some(cone), Some(term)) = (lobe.scales(), cone, Depth::of(&lobe, depth)) else {
        return f64::NAN;
    };
    outline_integral::exact_with_depth(scales, term, |visit| cone_outline(cone, visit)).max(0.0)
}

/// Returns the same over the visible part of a polygon.
///
/// Vertices relative to the shaded point, in order, either way round, convex or not.
#[must_use]
pub fn polygon_light_depth(lobe: ScratchLobe, depth: f64, vertices: &[[f64; 3]]) -> f64 {
    let directed = polygon_outline(vertices, |_| {});
    let (Some(scales), Some(term), true) = (lobe.scales(), Depth::of(&lobe, depth), directed) else {
        return f64::NAN;
    };
    let outline = |visit: &mut dyn FnMut(&crate::geometry::Arc)| {
        polygon_outline(vertices, visit);
    };
    outline_integral::exact_with_depth(scales, term, outline).abs()
}

/// Returns the integral of a scratch's lobe times its squared depth term over a sphere that covers the band, by one chord in
/// closed form, dimensionless.
///
/// `depth` in um. The light's cosine of incidence is taken to be linear along the chord.
#[must_use]
pub fn sphere_light_depth_chord(lobe: ScratchLobe, depth: f64, sphere: Sphere) -> f64 {
    let cone = Cone::of_sphere(sphere.centre, sphere.radius);
    let (Some(scales), Some(cone), Some(term)) = (lobe.scales(), cone, Depth::of(&lobe, depth)) else {
        return f64::NAN;
    };
    let x = -scales.view[0];
    let [first, second] = cone_chords(cone, x).map(|ends| ends.map_or(0.0, |ends| term.chord_linear(&scales, x, ends)));
    scales.band() * (first + second) / scales.across
}

/// Returns the same over a polygon that covers the band.
#[must_use]
pub fn polygon_light_depth_chord(lobe: ScratchLobe, depth: f64, vertices: &[[f64; 3]]) -> f64 {
    let (Some(scales), Some(term)) = (lobe.scales(), Depth::of(&lobe, depth)) else {
        return f64::NAN;
    };
    let x = -scales.view[0];
    let (mut sum, mut begin) = (0.0, None);
    let directed = polygon_crossings(vertices, x, |crossing| match begin.take() {
        None => begin = Some(crossing.y),
        Some(y) => {
            let chord = term.chord_linear(&scales, x, [y, crossing.y]);
            sum += if crossing.upward { chord } else { -chord };
        }
    });
    if directed {
        scales.band() * f64::abs(sum) / scales.across
    } else {
        f64::NAN
    }
}
