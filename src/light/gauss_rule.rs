//! Gauss rules of a measure that is known by samples.
//!
//! A positive weight over an angle, sampled at Gauss-Legendre nodes, is a discrete measure with all the weight's moments to
//! the accuracy of the sampling. Its orthogonal polynomials follow by Stieltjes' recurrence, and their zeros are the nodes
//! of the rule that integrates a smooth function against the weight with the fewest values of it.

use crate::numeric::gauss::SIXTEEN_POINTS;

/// Most nodes of a rule.
pub(super) const MOST_NODES: usize = 8;
/// Most panels of samples.
pub(super) const MOST_PANELS: usize = 3;
/// Most samples.
const SAMPLES: usize = 16 * MOST_PANELS;

/// A weight of one sign over an angle from -half to half, as samples.
pub(super) struct Measure {
    count: usize,
    half: f64,
    /// Angles over half.
    at: [f64; SAMPLES],
    weight: [f64; SAMPLES],
    /// The integral of the weight.
    pub(super) total: f64,
    /// The mean angle.
    pub(super) mean: f64,
    /// The integrals of the weight times the second, third and fourth power of the distance from the mean.
    pub(super) central: [f64; 3],
}

impl Measure {
    /// The measure of a weight, sampled in panels of 16 nodes.
    pub(super) fn of(panels: usize, half: f64, weight: impl Fn(f64) -> f64) -> Measure {
        let mut at = [0.0; SAMPLES];
        let mut weights = [0.0; SAMPLES];
        let width = 1.0 / panels as f64;
        for panel in 0..panels {
            let middle = (2 * panel + 1) as f64 * width - 1.0;
            for (i, [node, share]) in SIXTEEN_POINTS.into_iter().enumerate() {
                let first = 16 * panel + 2 * i;
                at[first] = middle + width * node;
                at[first + 1] = middle - width * node;
                weights[first] = share * width * half * weight(half * at[first]);
                weights[first + 1] = share * width * half * weight(half * at[first + 1]);
            }
        }
        let count = 16 * panels;
        let (mut total, mut first) = (0.0, 0.0);
        for i in 0..count {
            total += weights[i];
            first += weights[i] * at[i];
        }
        let mean = if total == 0.0 { 0.0 } else { first / total };
        let mut central = [0.0; 3];
        for i in 0..count {
            let d = at[i] - mean;
            let square = weights[i] * (d * d);
            central[0] += square;
            central[1] += square * d;
            central[2] += square * (d * d);
        }
        let square = half * half;
        Measure {
            count,
            half,
            at,
            weight: weights,
            total,
            mean: mean * half,
            central: [
                central[0] * square,
                central[1] * square * half,
                (central[2] * square * square).abs(),
            ],
        }
    }

    /// The standard deviation of the angle.
    pub(super) fn deviation(&self) -> f64 {
        if self.total == 0.0 {
            0.0
        } else {
            libm::sqrt(self.central[0] / self.total)
        }
    }

    /// The integral of a function of the angle by the Gauss rule of the lowest order from 2 on whose error is at most
    /// `allowed`, with that error and order; none up to the largest order. `error` gives it from the order and from the
    /// integral of the square of the monic orthogonal polynomial of that order.
    pub(super) fn gauss_rule(
        &self,
        mut error: impl FnMut(usize, f64) -> f64,
        allowed: f64,
        function: impl Fn(f64) -> f64,
    ) -> Option<(f64, f64, usize)> {
        let mut before = [0.0; SAMPLES];
        let mut now = [1.0; SAMPLES];
        let mut jacobi = Jacobi {
            diagonal: [0.0; MOST_NODES],
            beside: [0.0; MOST_NODES],
        };
        let mut last_norm = 0.0;
        let mut scale = 1.0;
        for order in 0..=MOST_NODES {
            let (mut norm, mut first) = (0.0, 0.0);
            for ((value, weight), at) in now.iter().zip(&self.weight).zip(&self.at).take(self.count) {
                let part = weight.abs() * (value * value);
                norm += part;
                first += part * at;
            }
            if order >= 2 {
                let expected = error(order, norm * scale);
                if expected <= allowed || norm == 0.0 {
                    return Some((self.apply(order, jacobi, function), expected, order));
                }
            }
            if order == MOST_NODES {
                break;
            }
            let centre = if norm > 0.0 { first / norm } else { 0.0 };
            let ratio = if order > 0 { norm / last_norm } else { 0.0 };
            jacobi.diagonal[order] = centre;
            if order > 0 {
                jacobi.beside[order - 1] = libm::sqrt(ratio);
            }
            for ((value, old), at) in now.iter_mut().zip(&mut before).zip(&self.at).take(self.count) {
                let next = (at - centre) * *value - ratio * *old;
                (*old, *value) = (*value, next);
            }
            last_norm = norm;
            scale *= self.half * self.half;
        }
        None
    }

    /// The integral by the rule of a Jacobi matrix.
    fn apply(&self, order: usize, jacobi: Jacobi, function: impl Fn(f64) -> f64) -> f64 {
        let (nodes, shares) = jacobi.rule(order);
        let mut sum = 0.0;
        for i in 0..order {
            sum += shares[i] * function(self.half * nodes[i].clamp(-1.0, 1.0));
        }
        self.total * sum
    }
}

/// The symmetric tridiagonal matrix of three-term recurrence coefficients.
#[derive(Clone, Copy)]
struct Jacobi {
    diagonal: [f64; MOST_NODES],
    beside: [f64; MOST_NODES],
}

impl Jacobi {
    /// The eigenvalues of the leading block and the squares of the eigenvectors' first components: nodes and weights of a
    /// measure of total 1 (Golub and Welsch 1969).
    ///
    /// Each zero of the characteristic polynomial is found between those of the one below by Newton's method kept inside its
    /// bracket; the weight is one over the sum of squares of the orthonormal polynomials.
    fn rule(&self, order: usize) -> ([f64; MOST_NODES], [f64; MOST_NODES]) {
        let mut zeros = [0.0; MOST_NODES];
        zeros[0] = self.diagonal[0];
        for n in 2..=order {
            let mut next = [0.0; MOST_NODES];
            for k in 0..n {
                let low = if k == 0 { -1.0 } else { zeros[k - 1] };
                let high = if k == n - 1 { 1.0 } else { zeros[k] };
                next[k] = self.zero(n, [low, high]);
            }
            zeros = next;
        }
        let mut shares = [0.0; MOST_NODES];
        for k in 0..order {
            let (mut before, mut now, mut sum) = (0.0, 1.0, 1.0);
            for i in 0..order - 1 {
                let below = if i > 0 { self.beside[i - 1] } else { 0.0 };
                let next = if self.beside[i] > 0.0 {
                    ((zeros[k] - self.diagonal[i]) * now - below * before) / self.beside[i]
                } else {
                    0.0
                };
                before = now;
                now = next;
                sum += now * now;
            }
            shares[k] = 1.0 / sum;
        }
        (zeros, shares)
    }

    /// The zero of the monic polynomial of order n in a bracket.
    fn zero(&self, n: usize, [mut low, mut high]: [f64; 2]) -> f64 {
        // The polynomial and its derivative.
        let value = |x: f64| {
            let (mut before, mut now) = (0.0, 1.0);
            let (mut slope_before, mut slope) = (0.0, 0.0);
            for i in 0..n {
                let ratio = if i > 0 {
                    self.beside[i - 1] * self.beside[i - 1]
                } else {
                    0.0
                };
                let next = (x - self.diagonal[i]) * now - ratio * before;
                let slope_next = now + (x - self.diagonal[i]) * slope - ratio * slope_before;
                (before, now) = (now, next);
                (slope_before, slope) = (slope, slope_next);
            }
            (now, slope)
        };
        // Above the largest zero the polynomial is positive; from there its sign alternates.
        let rising = value(high).0 >= 0.0;
        let mut x = 0.5 * (low + high);
        for _ in 0..40 {
            let (p, slope) = value(x);
            if (p >= 0.0) == rising {
                high = x;
            } else {
                low = x;
            }
            let newton = x - p / slope;
            let next = if newton > low && newton < high {
                newton
            } else {
                0.5 * (low + high)
            };
            if (next - x).abs() <= 1e-12 {
                return next;
            }
            x = next;
        }
        x
    }
}
