//! The chords of a sphere: the cone of directions within an angle a of the axis c, sin a = r/|p|.
//!
//! A line of constant x is the circle (x, s sin phi, s cos phi), s^2 = 1 - x^2, of which |phi| <= pi/2 is seen. The
//! axis is at phi_0 on the circle of its own x, radius rho. For a point at phi_0 + eta the chord to the axis is
//!
//! |omega - c|^2 = (x - c_x)^2 + (s - rho)^2 + 4 s rho sin^2(eta/2), and it belongs to the light when that is at most
//! 4 sin^2(a/2): no cosine of a small angle, so a small light keeps its digits.

use super::adaptive::{Chord, Light};
use super::root::bracketed_root;
use super::vectors::{Vector, direction, length};
use std::f64::consts::{FRAC_PI_2, PI, TAU};

/// A cone about the axis.
pub struct Cone {
    /// The unit vector c.
    pub axis: Vector,
    /// The angle a.
    pub angle: f64,
    /// 4 sin^2(a/2).
    square: f64,
}

/// eta in \[0, pi\] where `scale` sin^2(eta/2) reaches `level`; None where it is above 0 already, pi where it never is.
fn reached(scale: f64, level: f64) -> Option<f64> {
    if level <= 0.0 {
        return None;
    }
    if level >= scale {
        return Some(PI);
    }
    // eta/pi <= sin(eta/2) <= eta/2.
    let sine = (level / scale).sqrt();
    let ends = [2.0 * sine, (PI * sine).min(PI)];
    let f = |eta: f64| {
        let (sine, cosine) = (0.5 * eta).sin_cos();
        [scale * sine * sine - level, scale * sine * cosine]
    };
    Some(bracketed_root(f, ends, 2.2 * sine, 1e-17 * level))
}

/// cos(angle + step) - cos(angle).
fn cosine_step(angle: f64, step: f64) -> f64 {
    -2.0 * (angle + 0.5 * step).sin() * (0.5 * step).sin()
}

impl Cone {
    /// The directions to a sphere; None where it holds the origin, or has no place or radius.
    pub fn new(centre: Vector, radius: f64) -> Option<Cone> {
        let axis = direction(centre)?;
        let distance = length(centre);
        if !(radius >= 0.0 && radius < distance) {
            return None;
        }
        let sine = radius / distance;
        let cosine = ((distance - radius) * (distance + radius)).sqrt() / distance;
        Some(Cone {
            axis,
            angle: sine.atan2(cosine),
            square: 2.0 * sine * sine / (1.0 + cosine),
        })
    }

    /// u of the points where the outline meets the horizon.
    fn horizon(&self) -> Vec<f64> {
        let [x, y, z] = self.axis;
        let flat = x.hypot(y);
        let deficit = z * z / (1.0 + flat);
        let psi = y.atan2(x);
        match reached(4.0 * flat, self.square - deficit * deficit - z * z) {
            None => vec![],
            Some(eta) if eta == PI => vec![],
            Some(eta) => [eta, -eta]
                .map(|eta| cosine_step(psi, eta) + deficit * psi.cos())
                .to_vec(),
        }
    }
}

impl Light for Cone {
    type Piece = ();

    fn anchor(&self) -> f64 {
        self.axis[0]
    }

    fn pieces(&self) -> Vec<([f64; 2], ())> {
        let [x, y, z] = self.axis;
        let alpha = y.hypot(z).atan2(x);
        let ends = [-1.0 - x, 1.0 - x];
        // The least and the largest x of the outline; beyond either, where the pole is inside, the whole circle
        // belongs.
        let mut breaks = [self.angle, -self.angle].map(|step| cosine_step(alpha, step)).to_vec();
        if self.angle > alpha {
            breaks.push(ends[1]);
        }
        if self.angle > PI - alpha {
            breaks.push(ends[0]);
        }
        breaks.extend(self.horizon());
        breaks.iter_mut().for_each(|u| *u = u.clamp(ends[0], ends[1]));
        breaks.sort_by(f64::total_cmp);
        let pairs = breaks.windows(2).map(|pair| [pair[0], pair[1]]);
        pairs
            .filter(|[a, b]| b > a && !self.chords(&(), 0.5 * (a + b)).is_empty())
            .map(|piece| (piece, ()))
            .collect()
    }

    fn chords(&self, (): &(), u: f64) -> Vec<Chord> {
        let [x_0, y_0, z_0] = self.axis;
        let rho = y_0.hypot(z_0);
        let x = x_0 + u;
        let s = ((1.0 - x) * (1.0 + x)).max(0.0).sqrt();
        if s == 0.0 {
            return vec![];
        }
        let nearer = -u * (x + x_0) / (s + rho);
        let level = self.square - u * u - nearer * nearer;
        let Some(eta) = reached(4.0 * s * rho, level) else {
            return vec![];
        };
        let phi = y_0.atan2(z_0);
        // The level is known to an epsilon of the square, and the chord is as its root.
        let doubt = 0.5 * (1.0 + self.square / level);
        let seen = [-TAU, 0.0, TAU].map(|turn| {
            let low = (phi - eta).max(turn - FRAC_PI_2);
            let high = (phi + eta).min(turn + FRAC_PI_2);
            (high > low).then(|| {
                let length = 2.0 * s * (0.5 * (low + high)).cos().abs() * (0.5 * (high - low)).sin();
                let start = s * low.sin();
                Chord {
                    start,
                    length,
                    doubt: doubt * length,
                }
            })
        });
        seen.into_iter().flatten().collect()
    }
}
