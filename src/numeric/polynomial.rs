//! Polynomials of a fixed number of terms by Estrin's scheme.
//!
//! Pairs of terms are formed side by side, which shortens the chain of dependent operations against Horner's.
//! Multiplications and additions stay unfused, so that every machine gives the same bits.

/// The powers x, x^2 and x^4, shared by polynomials in the same variable.
#[derive(Clone, Copy)]
pub(crate) struct Powers(f64, f64, f64);

impl Powers {
    /// Returns the powers of `x`.
    #[inline(always)]
    pub(crate) fn of(x: f64) -> Self {
        let square = x * x;
        Self(x, square, square * square)
    }

    /// Returns c\[0\] + c\[1\] x + c\[2\] x^2 + c\[3\] x^3.
    #[inline(always)]
    pub(crate) fn four(self, [c0, c1, c2, c3]: [f64; 4]) -> f64 {
        let Self(x, x2, _) = self;
        (c0 + c1 * x) + (c2 + c3 * x) * x2
    }

    /// Returns c\[0\] + c\[1\] x + ... + c\[7\] x^7.
    #[inline(always)]
    pub(crate) fn eight(self, [c0, c1, c2, c3, c4, c5, c6, c7]: [f64; 8]) -> f64 {
        let Self(x, x2, x4) = self;
        let low = (c0 + c1 * x) + (c2 + c3 * x) * x2;
        let high = (c4 + c5 * x) + (c6 + c7 * x) * x2;
        low + high * x4
    }

    /// Returns c\[0\] x + c\[1\] x^2 + ... + c\[8\] x^9.
    #[inline(always)]
    pub(crate) fn nine_from_first(self, [c1, c2, c3, c4, c5, c6, c7, c8, c9]: [f64; 9]) -> f64 {
        let Self(x, x2, x4) = self;
        let low = c1 * x + (c2 + c3 * x) * x2;
        let high = (c4 + c5 * x) + (c6 + c7 * x) * x2;
        low + (high + (c8 + c9 * x) * x4) * x4
    }
}
