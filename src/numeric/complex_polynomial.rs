//! Polynomials with real coefficients at a complex argument, and the few products that surround them.
//!
//! The two-term recurrence (Goertzel's; Knuth, TAOCP 2, 4.6.4) keeps everything real: four operations a coefficient,
//! and an imaginary part that is a multiple of the argument's, so that it keeps its relative accuracy at the real axis.
//! Interleaved chains in a power of the argument shorten the dependent path.

/// (real, imaginary).
pub(crate) type Pair = (f64, f64);

/// Returns a b.
#[inline(always)]
pub(crate) fn product(a: Pair, b: Pair) -> Pair {
    (a.0 * b.0 - a.1 * b.1, a.0 * b.1 + a.1 * b.0)
}

/// Returns a^2.
#[inline(always)]
pub(crate) fn square(a: Pair) -> Pair {
    ((a.0 - a.1) * (a.0 + a.1), 2.0 * (a.0 * a.1))
}

/// Returns a + b.
#[inline(always)]
pub(crate) fn sum(a: Pair, b: Pair) -> Pair {
    (a.0 + b.0, a.1 + b.1)
}

/// Returns c\[OFFSET\] + c\[OFFSET + STRIDE\] u + c\[OFFSET + 2 STRIDE\] u^2 + ..., of two terms at least.
#[inline(always)]
pub(crate) fn chain<const N: usize, const OFFSET: usize, const STRIDE: usize>(
    c: impl Fn(usize) -> f64,
    u: Pair,
) -> Pair {
    let (s, t) = (2.0 * u.0, u.0 * u.0 + u.1 * u.1);
    let last = (N - 1 - OFFSET) / STRIDE;
    let mut second = c(OFFSET + last * STRIDE);
    if last == 1 {
        return (c(OFFSET) + u.0 * second, u.1 * second);
    }
    let mut first = c(OFFSET + (last - 1) * STRIDE) + s * second;
    let mut k = last - 1;
    while k > 1 {
        k -= 1;
        (first, second) = ((c(OFFSET + k * STRIDE) - t * second) + s * first, first);
    }
    ((c(OFFSET) - t * second) + u.0 * first, u.1 * first)
}

/// Returns the polynomial of the N coefficients `c(0)`, `c(1)`, ... at `v` in two chains.
#[inline(always)]
pub(crate) fn in_two<const N: usize>(c: impl Fn(usize) -> f64, v: Pair) -> Pair {
    let u = square(v);
    let even = chain::<N, 0, 2>(&c, u);
    let odd = chain::<N, 1, 2>(&c, u);
    sum(even, product(v, odd))
}

/// Returns the polynomial of the N coefficients `c` at `v` in four chains.
#[inline(always)]
pub(crate) fn in_four<const N: usize>(c: &[f64; N], v: Pair) -> Pair {
    let v2 = square(v);
    let v4 = square(v2);
    let c = |k: usize| c[k];
    let low = sum(chain::<N, 0, 4>(c, v4), product(v, chain::<N, 1, 4>(c, v4)));
    let high = sum(chain::<N, 2, 4>(c, v4), product(v, chain::<N, 3, 4>(c, v4)));
    sum(low, product(v2, high))
}
