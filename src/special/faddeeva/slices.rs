//! w of many points: sorted by region, so that each region is one loop without branches.

use super::super::faddeeva_tables::{COARSE, COARSE_POLE, FINE, FINE_POLE, MEDIUM, MEDIUM_POLE};
use super::quadrant::{
    EDGE, FAR, MIDDLE_END, NEAR, START, asymptotic, axis_remainder, beside_the_axis, inner, middle, outer,
};
use super::tiers::upper;
use super::{HUGE, faddeeva_w, faddeeva_w_coarse, faddeeva_w_fine, faddeeva_w_medium};
use num_complex::Complex;

/// Points that are sorted together.
const BLOCK: usize = 512;
/// Points of a region that are evaluated together.
const LANES: usize = 16;
/// Number of regions.
const REGIONS: usize = 8;
/// The bits of infinity.
const INFINITE: u64 = 0x7ff0_0000_0000_0000;

/// Coordinates of a block, folded into the quadrant, and the values there.
struct Block {
    x: [f64; BLOCK],
    y: [f64; BLOCK],
    re: [f64; BLOCK],
    im: [f64; BLOCK],
}

/// Evaluates a kernel, named by its path so that it is inlined, at the listed points of a block.
macro_rules! at_each {
    ($block:ident, $list:expr, $kernel:path) => {
        for part in $list.chunks(LANES) {
            let (mut x, mut y) = ([1.0; LANES], [1.0; LANES]);
            for ((x, y), &i) in x.iter_mut().zip(&mut y).zip(part) {
                let i = usize::from(i) % BLOCK;
                (*x, *y) = ($block.x[i], $block.y[i]);
            }
            let (mut re, mut im) = ([0.0; LANES], [0.0; LANES]);
            for k in 0..LANES {
                (re[k], im[k]) = $kernel(x[k], y[k]);
            }
            for ((re, im), &i) in re.iter().zip(&im).zip(part) {
                let i = usize::from(i) % BLOCK;
                ($block.re[i], $block.im[i]) = (*re, *im);
            }
        }
    };
}

/// Writes w(z), with the bits of [`faddeeva_w`].
#[inline(always)]
pub(crate) fn faddeeva_w_slice(z: &[Complex<f64>], out: &mut [Complex<f64>]) {
    let mut block = Block::new();
    let mut regions = [0u32; BLOCK];
    let mut lists = [[0u16; BLOCK]; REGIONS];
    for (z, out) in z.chunks(BLOCK).zip(out.chunks_mut(BLOCK)) {
        let plain = block.fold(z);
        for ((region, x), y) in regions.iter_mut().zip(&block.x).zip(&block.y) {
            *region = region_of(*x, *y);
        }
        // The lengths of all lists in one word, 12 bits each.
        let mut packed = 0u64;
        for (i, region) in regions[..z.len()].iter().enumerate() {
            let shift = 12 * region;
            lists[*region as usize % REGIONS][(packed >> shift) as usize % BLOCK] = i as u16;
            packed += 1 << shift;
        }
        let lengths = [0, 12, 24, 36, 48].map(|shift| ((packed >> shift) & 0xfff) as usize);
        let [far, beside, near, between, beyond, ..] = &lists;
        let far = &far[..lengths[0]];
        at_each!(block, far, asymptotic);
        at_each!(block, &beside[..lengths[1]], beside_the_axis);
        at_each!(block, &near[..lengths[2]], inner);
        at_each!(block, &between[..lengths[3]], middle);
        at_each!(block, &beyond[..lengths[4]], outer);
        for &i in far {
            let i = usize::from(i) % BLOCK;
            block.re[i] += axis_remainder(block.x[i], block.y[i]);
        }
        block.unfold(z, out);
        if !plain {
            one_by_one(z, out, faddeeva_w);
        }
    }
}

/// The region of a point of the quadrant, in the order of [`faddeeva_w_slice`].
#[inline(always)]
fn region_of(x: f64, y: f64) -> u32 {
    let size = x * x + y * y;
    let rings = if size < MIDDLE_END { 3 } else { 4 };
    let rings = if size + 0.25 * (x * x) < NEAR { 2 } else { rings };
    let low = if (y < EDGE) & (x >= START) { 1 } else { rings };
    if size >= FAR { 0 } else { low }
}

/// Evaluates again, one by one, what is below the real axis or at infinity.
#[cold]
fn one_by_one(z: &[Complex<f64>], out: &mut [Complex<f64>], one: fn(Complex<f64>) -> Complex<f64>) {
    for (z, out) in z.iter().zip(out) {
        if !(z.im >= 0.0 && z.im < f64::INFINITY && z.re.abs() < f64::INFINITY) {
            *out = one(*z);
        }
    }
}

impl Block {
    #[inline(always)]
    fn new() -> Self {
        Self {
            x: [0.0; BLOCK],
            y: [0.0; BLOCK],
            re: [0.0; BLOCK],
            im: [0.0; BLOCK],
        }
    }

    /// Reads points into the quadrant; says whether all of them are finite and not below the real axis.
    #[inline(always)]
    fn fold(&mut self, z: &[Complex<f64>]) -> bool {
        let mut odd = 0;
        for ((x, y), z) in self.x.iter_mut().zip(&mut self.y).zip(z) {
            (*x, *y) = (z.re.abs(), z.im.abs());
            odd |= u64::from(x.to_bits() >= INFINITE) | u64::from(z.im.to_bits() >= INFINITE);
        }
        odd == 0
    }

    /// Carries the values to the points' own side of the imaginary axis.
    #[inline(always)]
    fn unfold(&self, z: &[Complex<f64>], out: &mut [Complex<f64>]) {
        for (((z, out), re), im) in z.iter().zip(out).zip(&self.re).zip(&self.im) {
            let sign = z.re.to_bits() & (1 << 63);
            *out = Complex {
                re: *re,
                im: f64::from_bits(im.to_bits() ^ sign),
            };
        }
    }
}

/// Defines the slice form of a tier.
macro_rules! tier {
    ($name:ident, $coefficients:ident, $pole:ident, $one:ident) => {
        /// Writes a tier of w(z), with the bits of the scalar form.
        #[inline(always)]
        pub(crate) fn $name(z: &[Complex<f64>], out: &mut [Complex<f64>]) {
            let mut block = Block::new();
            for (z, out) in z.chunks(BLOCK).zip(out.chunks_mut(BLOCK)) {
                let plain = block.fold(z);
                let mut huge = 0;
                for k in 0..BLOCK {
                    let (x, y) = (block.x[k], block.y[k]);
                    (block.re[k], block.im[k]) = upper(&$coefficients, $pole, x, y);
                    huge |= u64::from(x >= HUGE) | u64::from(y >= HUGE);
                }
                block.unfold(z, out);
                if huge != 0 {
                    for (z, out) in z.iter().zip(out) {
                        *out = $one(*z);
                    }
                } else if !plain {
                    one_by_one(z, out, $one);
                }
            }
        }
    };
}

tier!(faddeeva_w_fine_slice, FINE, FINE_POLE, faddeeva_w_fine);
tier!(faddeeva_w_medium_slice, MEDIUM, MEDIUM_POLE, faddeeva_w_medium);
tier!(faddeeva_w_coarse_slice, COARSE, COARSE_POLE, faddeeva_w_coarse);
