//! Arcs of circles on the unit sphere, projected on the surface.
//!
//! # Definition
//!
//! ```math
//! x(\varphi) = x_0 + \rho \cos\varphi, \qquad y(\varphi) = y_0 + a \cos\varphi + b \sin\varphi
//! ```
//!
//! A great circle has x0 = y0 = 0, the circle of a cone its centre at the projected axis times the cosine of the opening;
//! the horizon is the unit circle. The angle counts from the point of largest x: x has no part in sin phi, and it turns
//! back at the multiples of pi. Any light that spheres and straight edges bound has an outline of such arcs, and both
//! coordinates are entire functions of the angle, also where the outline turns back in x.
//!
//! # Methods
//!
//! Angles are kept as pairs of cosine and sine: everything here is algebraic.

/// An arc of a circle on the unit sphere, projected; run through in the direction of growing angles.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Arc {
    /// The projected centre (x0, y0).
    pub centre: [f64; 2],
    /// rho >= 0, half the circle's extent in x.
    pub reach: f64,
    /// The coefficients a and b of y.
    pub across: [f64; 2],
    /// Cosine and sine of the first angle.
    pub from: [f64; 2],
    /// Cosine and sine of the last angle.
    pub to: [f64; 2],
    /// Whether the arc is longer than half a turn, which its ends cannot tell.
    pub reflex: bool,
}

/// The angle of the largest x, and of the smallest.
const TURNS: [[f64; 2]; 2] = [[1.0, 0.0], [-1.0, 0.0]];

impl Arc {
    /// Returns the projected point (x, y) at an angle given by its cosine and sine.
    #[must_use]
    #[inline(always)]
    pub fn point(&self, [cosine, sine]: [f64; 2]) -> [f64; 2] {
        [
            self.centre[0] + self.reach * cosine,
            self.centre[1] + (self.across[0] * cosine + self.across[1] * sine),
        ]
    }

    /// Calls `visit` for each piece on which x is monotone, in order, with cosine and sine of its two angles.
    #[inline]
    pub fn monotone_pieces(&self, mut visit: impl FnMut([[f64; 2]; 2])) {
        let (mut from, to) = (self.from, self.to);
        // On the first half turn x falls, on the second it grows.
        let mut falling = from[1] > 0.0 || from[1] == 0.0 && from[0] > 0.0;
        let end_falling = to[1] > 0.0 || to[1] == 0.0 && to[0] < 0.0;
        // An arc that ends before it begins, but for rounding, has no length: by the angle between, or by x.
        let back = falling == end_falling && if falling { to[0] > from[0] } else { to[0] < from[0] };
        if !self.reflex && (back || from[0] * to[1] - from[1] * to[0] <= 0.0) && from[0] * to[0] + from[1] * to[1] > 0.0
        {
            return;
        }
        let mut ends = !self.reflex && !back;
        for _ in 0..3 {
            if falling == end_falling && ends {
                visit([from, to]);
                return;
            }
            // Behind a turn the end is ahead, whatever its cosine is rounded to.
            ends = true;
            let turn = TURNS[usize::from(falling)];
            visit([from, turn]);
            from = turn;
            falling = !falling;
        }
    }

    /// Returns the smallest and the largest x on the arc.
    #[must_use]
    pub fn extent(&self) -> [f64; 2] {
        let x = |angle: [f64; 2]| self.point(angle)[0];
        let mut extent = [x(self.from).min(x(self.to)), x(self.from).max(x(self.to))];
        self.monotone_pieces(|[_, to]| {
            extent = [extent[0].min(x(to)), extent[1].max(x(to))];
        });
        extent
    }
}
