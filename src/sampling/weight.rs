//! Weights of several sampling strategies, and the density of a mixture (Veach and Guibas 1995).
//!
//! # Definition
//!
//! ```math
//! w = \frac{p}{p + \sum q}, \qquad w = \frac{p^2}{p^2 + q^2}, \qquad \bar p = \sum_i P_i\,p_i
//! ```
//!
//! One draw of a strategy chosen with the probabilities P_i, divided by the mixture's density, is the balance
//! heuristic: where each f_i/p_i is bounded by m_i, the mixture's weight is at most the largest m_i/P_i times the number
//! of terms whose f_i add up.
//!
//! # Domain
//!
//! Densities and probabilities >= 0, infinite ones included; NaN elsewhere.
//!
//! | own | other | weight |
//! |---|---|---|
//! | 0 | 0 | 0 |
//! | inf | finite | 1 |
//! | finite | inf | 0 |
//! | inf | inf | 1/2 |
//!
//! # Methods
//!
//! Ratios of the smaller to the larger density: neither sums nor squares overflow, and squares that underflow are 0.
//!
//! # Where it fails
//!
//! Nowhere known.
//!
//! # Errata
//!
//! None.

/// Returns the balance weight of a strategy: its n p over the sum of all n p, `others` being the sum of the others.
///
/// ```
/// use iridescence::sampling::balance_weight;
/// assert_eq!(balance_weight(1e308, 1e308), 0.5);
/// assert_eq!(balance_weight(0.0, 2.0), 0.0);
/// ```
#[must_use]
pub fn balance_weight(own: f64, others: f64) -> f64 {
    weight(own, others, |ratio| ratio)
}

/// Returns the power weight with exponent 2 of a strategy with n p = `own` beside one `other`.
#[must_use]
pub fn power_weight(own: f64, other: f64) -> f64 {
    weight(own, other, |ratio| ratio * ratio)
}

/// The share of `own`, from the power of the ratio of the smaller to the larger.
#[inline]
fn weight(own: f64, other: f64, power: impl Fn(f64) -> f64) -> f64 {
    if !(own >= 0.0 && other >= 0.0) {
        f64::NAN
    } else if own == 0.0 {
        0.0
    } else if own == other {
        0.5
    } else if own > other {
        1.0 / (1.0 + power(other / own))
    } else {
        let ratio = power(own / other);
        ratio / (1.0 + ratio)
    }
}

/// A strategy of a mixture.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Strategy {
    /// The probability with which it is chosen.
    pub probability: f64,
    /// Its density at the direction in question, in 1/sr.
    pub pdf: f64,
}

/// Returns the density of a draw from one of several strategies, in 1/sr: the sum of probability times density.
///
/// A strategy that is never chosen adds nothing, whatever its density.
#[must_use]
pub fn mixture_pdf(strategies: &[Strategy]) -> f64 {
    let term = |s: &Strategy| {
        if s.probability == 0.0 {
            0.0
        } else {
            s.probability * s.pdf
        }
    };
    strategies.iter().map(term).sum()
}

/// A strategy chosen from a list.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Choice {
    /// Its place in the list.
    pub index: usize,
    /// The probability with which it is chosen.
    pub probability: f64,
    /// What is left of the random number, uniform in \[0, 1) again.
    pub random: f64,
}

/// Returns the strategy that a uniform number of \[0, 1) picks from a list of relative weights.
///
/// Weights >= 0 and finite, their sum positive and finite; none elsewhere. The energies of base and scratches are good
/// weights. The remainder of the random number has lost as many binary places as the probability has before its first.
#[must_use]
pub fn choose_strategy(weights: &[f64], random: f64) -> Option<Choice> {
    let total: f64 = weights.iter().sum();
    let positive = weights.iter().all(|w| *w >= 0.0);
    if !(positive && total > 0.0 && total < f64::INFINITY && (0.0..1.0).contains(&random)) {
        return None;
    }
    let mut left = random * total;
    let mut chosen = None;
    for (index, &weight) in weights.iter().enumerate() {
        // A weight that has no probability beside the others is never chosen.
        if weight / total > 0.0 {
            // Rounding may leave a rest behind the last weight: the last one takes it.
            chosen = Some(Choice {
                index,
                probability: weight / total,
                random: (left / weight).min(1.0 - 0.5 * f64::EPSILON),
            });
            if left < weight {
                break;
            }
            left -= weight;
        }
    }
    chosen
}
