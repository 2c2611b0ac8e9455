//! Bounds of the derivatives of Phi, the integral of sinc^2, along an arc.
//!
//! Phi is a superposition of waves exp(iwq) with 0 <= w <= 2, since the spectrum of sinc^2 is a triangle:
//!
//! |d^j Phi/dq^j| <= 2^j/(j (j + 1)), and far out about 2^j/(4 q^2), the first 1/q^2.
//!
//! Along an arc q is a constant plus a multiple of the cosine of an angle. With bounds of its slope and its bend, which
//! alternate as bounds of all its derivatives, the formula of Faa di Bruno sums what each number j of factors contributes.

use super::gauss_rule::MOST_NODES;

/// The highest derivative plus one.
const ORDERS: usize = 2 * MOST_NODES + 1;

/// Phi along an angle over which its argument has a bounded slope and a bounded bend.
#[derive(Clone, Copy)]
pub(super) struct Wave {
    /// Largest |dq|, and largest |d^2 q|, over the angle.
    pub(super) slope: f64,
    pub(super) bend: f64,
    /// Smallest |q|.
    pub(super) nearest: f64,
}

impl Wave {
    /// A bound on the third derivative.
    pub(super) fn third(&self) -> f64 {
        let Wave { slope, bend, .. } = *self;
        let [one, two, three] = [1.0, 2.0, 3.0].map(|j| self.amplitude(j));
        slope * (2.0 * one + 12.0 * two * bend + 8.0 * three * (slope * slope))
    }

    /// A bound on the fourth derivative.
    pub(super) fn fourth(&self) -> f64 {
        let Wave { slope, bend, .. } = *self;
        let [one, two, three, four] = [1.0, 2.0, 3.0, 4.0].map(|j| self.amplitude(j));
        let square = slope * slope;
        2.0 * one * bend
            + 4.0 * two * (3.0 * bend * bend + 4.0 * square)
            + 48.0 * three * square * bend
            + 16.0 * four * square * square
    }

    /// The bound of the j-th derivative with respect to q, over 2^j.
    fn amplitude(&self, j: f64) -> f64 {
        let near = 1.0 / (j * (j + 1.0));
        let inverse = 1.0 / self.nearest;
        // The first, sinc^2 itself, is no wave about 0 but one about its mean.
        let far = if j == 1.0 {
            0.5
        } else {
            let growth = 1.0 + 0.5 * j * inverse;
            0.25 * (growth * growth)
        };
        near.min(far * (inverse * inverse))
    }
}

/// Bounds of the derivatives of any order: partial Bell polynomials of the bounds of dq, d^2 q, ...
pub(super) struct Derivatives {
    wave: Wave,
    /// B(m, j) up to m = `known`.
    bell: [[f64; ORDERS]; ORDERS],
    known: usize,
}

impl Derivatives {
    pub(super) fn of(wave: Wave) -> Derivatives {
        let mut bell = [[0.0; ORDERS]; ORDERS];
        bell[0][0] = 1.0;
        Derivatives { wave, bell, known: 0 }
    }

    /// A bound on the m-th derivative over m!.
    pub(super) fn over_factorial(&mut self, m: usize) -> f64 {
        while self.known < m {
            self.known += 1;
            self.extend(self.known);
        }
        let (mut sum, mut power, mut factorial) = (0.0, 1.0, 1.0);
        for j in 1..=m {
            power *= 2.0;
            factorial *= j as f64;
            sum += self.bell[m][j] * (power * self.wave.amplitude(j as f64));
        }
        sum / factorial
    }

    /// The polynomials of one more order.
    fn extend(&mut self, m: usize) {
        let mut binomial = 1.0;
        for k in 1..=m {
            let factor = binomial * if k % 2 == 1 { self.wave.slope } else { self.wave.bend };
            for j in 1..=m + 1 - k {
                self.bell[m][j] += factor * self.bell[m - k][j - 1];
            }
            binomial *= (m - k) as f64 / k as f64;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_third_and_the_fourth_derivative_are_those_of_the_table() {
        for nearest in [0.0, 0.7, 5.0] {
            let wave = Wave {
                slope: 1.7,
                bend: 2.3,
                nearest,
            };
            let mut all = Derivatives::of(wave);
            for (m, factorial, closed) in [(3, 6.0, wave.third()), (4, 24.0, wave.fourth())] {
                let table = all.over_factorial(m) * factorial;
                assert!((table - closed).abs() < 1e-12 * closed, "{m}: {table} {closed}");
            }
        }
    }
}
