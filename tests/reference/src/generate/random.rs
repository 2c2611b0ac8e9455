//! A small deterministic generator: splitmix64 (Steele, Lea and Flood 2014), the same numbers on every machine.

/// State of the generator.
#[derive(Clone, Debug)]
pub struct Random(u64);

impl Random {
    /// A generator that depends on nothing but `seed`.
    pub const fn new(seed: u64) -> Random {
        Random(seed)
    }

    /// 64 random bits.
    pub fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let z = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        z ^ (z >> 31)
    }

    /// Uniform in [lo, hi).
    pub fn uniform(&mut self, lo: f64, hi: f64) -> f64 {
        lo + (hi - lo) * ((self.bits() >> 11) as f64 * 2f64.powi(-53))
    }

    /// Log-uniform between two positive numbers.
    pub fn log_uniform(&mut self, lo: f64, hi: f64) -> f64 {
        self.uniform(lo.ln(), hi.ln()).exp()
    }

    /// Uniform among the integers lo..=hi.
    pub fn integer(&mut self, lo: i64, hi: i64) -> i64 {
        lo + (self.bits() % (hi - lo + 1) as u64) as i64
    }

    /// One entry of a list.
    pub fn pick<T: Copy>(&mut self, list: &[T]) -> T {
        list[(self.bits() % list.len() as u64) as usize]
    }

    /// True with probability `share`.
    pub fn chance(&mut self, share: f64) -> bool {
        self.uniform(0.0, 1.0) < share
    }

    /// `x` with a random sign.
    pub fn signed(&mut self, x: f64) -> f64 {
        if self.bits() & 1 == 0 { x } else { -x }
    }
}

/// `x` moved by `steps` f64 neighbours away from zero (negative: towards zero); stays finite.
pub fn neighbour(x: f64, steps: i64) -> f64 {
    let size = (x.abs().to_bits() as i64 + steps).clamp(0, f64::MAX.to_bits() as i64);
    f64::from_bits(size as u64).copysign(x)
}

/// The f32 nearest to `x`, moved by `steps` f32 neighbours away from zero, as an f64; stays finite.
pub fn neighbour_f32(x: f64, steps: i64) -> f64 {
    let size = ((x as f32).abs().to_bits() as i64 + steps).clamp(0, i64::from(f32::MAX.to_bits()));
    f64::from(f32::from_bits(size as u32).copysign(x as f32))
}
