//! Slices against scalars, bit by bit, at every level.

use iridescence::Complex;
use iridescence::simd::Level;

/// The machine's level and all that it includes.
pub fn levels() -> Vec<Level> {
    let best = Level::new();
    #[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
    let lower = [
        best.as_sse2().map(Level::Sse2),
        best.as_sse4_2().map(Level::Sse4_2),
        best.as_avx2().map(Level::Avx2),
        best.as_avx512().map(Level::Avx512),
    ];
    #[cfg(not(any(target_arch = "x86", target_arch = "x86_64")))]
    let lower: [Option<Level>; 0] = [];
    let levels: Vec<Level> = lower.into_iter().flatten().chain([Level::baseline(), best]).collect();
    println!("levels: {levels:?}");
    levels
}

const LENGTHS: [usize; 10] = [0, 1, 17, 63, 64, 65, 129, 511, 513, 1000];

/// Bits of a result, one pattern for every NaN: no operation promises the bits of a NaN.
pub trait Bits: Copy {
    fn pattern(self) -> [u64; 2];
    const FILLED: Self;
}

impl Bits for f64 {
    fn pattern(self) -> [u64; 2] {
        [if self.is_nan() { u64::MAX } else { self.to_bits() }, 0]
    }
    const FILLED: f64 = -77.0;
}

impl Bits for f32 {
    fn pattern(self) -> [u64; 2] {
        let bits = if self.is_nan() {
            u64::MAX
        } else {
            u64::from(self.to_bits())
        };
        [bits, 0]
    }
    const FILLED: f32 = -77.0;
}

impl<T: Bits> Bits for Complex<T> {
    fn pattern(self) -> [u64; 2] {
        [self.re.pattern()[0], self.im.pattern()[0]]
    }
    const FILLED: Complex<T> = Complex {
        re: T::FILLED,
        im: T::FILLED,
    };
}

/// Holds a slice function to its scalar at every level, with slices of equal and of unequal length.
pub fn check<X: Copy + std::fmt::Debug, Y: Bits>(
    name: &str,
    inputs: fn(usize, usize) -> Vec<X>,
    scalar: impl Fn(X) -> Y,
    plain: fn(&[X], &mut [Y]),
    at: fn(Level, &[X], &mut [Y]),
) {
    let levels = levels();
    for length in LENGTHS {
        for kind in 0..5 {
            let x = inputs(kind, length);
            let expected: Vec<[u64; 2]> = x.iter().map(|&x| scalar(x).pattern()).collect();
            for room in [length, length / 2, length + 70] {
                let counted = length.min(room);
                let hold = |out: &[Y], level: &str| {
                    for (i, y) in out.iter().enumerate() {
                        let due = if i < counted { expected[i] } else { Y::FILLED.pattern() };
                        assert_eq!(
                            y.pattern(),
                            due,
                            "{name} at {level}, kind {kind}, {i} of {length} ({room})"
                        );
                    }
                };
                let mut out = vec![Y::FILLED; room];
                plain(&x, &mut out);
                hold(&out, "the plain call");
                for &level in &levels {
                    let mut out = vec![Y::FILLED; room];
                    at(level, &x, &mut out);
                    hold(&out, &format!("{level:?}"));
                }
            }
        }
    }
}
