//! The first zeros of w and of erf, and both functions beside them by their Taylor series about the zero.
//!
//! Each centre is known to three f64, so the step from it keeps its digits down to the f64 nearest to the zero.

use super::complex::Complex;
use super::double_double::two_sum;
use super::scaled::{TWO_OVER_ROOT_PI, exponential, sin_cos};
use std::sync::LazyLock;

/// Distance from a zero up to which its series is used.
const RADIUS: f64 = 0.15;
/// Least ratio of the two components.
const CANCELLED: f64 = 1e-4;
/// Terms of a series: (2 |z0| RADIUS)^n/n! is below 1e-33 of the first.
const TERMS: usize = 40;

/// The first 8 zeros of w with positive real part, by size: real and imaginary part, each the sum of three f64. The others
/// are their mirror images in the imaginary axis.
pub const W: [[[f64; 3]; 2]; 8] = [
    [
        [1.9914668428338795, 4.143650417934867e-17, 2.9868443058672766e-33],
        [-1.3548101281120062, -6.439116393941566e-17, 2.2947845783233147e-33],
    ],
    [
        [2.691149024251439, -4.1585566708123044e-17, -8.519050646412431e-34],
        [-2.1770449060896158, -1.5039260427624898e-16, -7.440461923718524e-33],
    ],
    [
        [3.2353308683528166, -1.3006795726241603e-16, -5.6903803857503695e-33],
        [-2.7843876132304284, 2.1332250782718736e-16, -1.160200997487133e-32],
    ],
    [
        [3.6973097024684685, -6.413689284438924e-17, 2.2886197041346092e-33],
        [-3.2874107893898485, -2.5271029371576216e-17, -1.3791837407252061e-33],
    ],
    [
        [4.106107284682632, 1.9106297629371049e-16, -3.842059818483071e-33],
        [-3.7259487194457903, -1.1021997665934811e-16, -3.586954462491754e-33],
    ],
    [
        [4.476815692967546, -7.690734106065121e-17, 1.132910089576804e-34],
        [-4.119635227611731, 4.284516051676418e-16, -1.4339380031592882e-32],
    ],
    [
        [4.818488291883319, 4.35021017734955e-16, 4.1982857986831295e-34],
        [-4.479832797731202, -3.007237265666797e-16, 2.2390063635087732e-32],
    ],
    [
        [5.137067271266347, 2.4459186807793716e-16, -1.1296349999636037e-32],
        [-4.813806682044434, -4.0555570564143583e-16, 1.659012586008747e-33],
    ],
];

/// The first 8 zeros of erf in the first quadrant, in the same form. The others are their images in the four quadrants.
pub const ERF: [[[f64; 3]; 2]; 8] = [
    [
        [1.4506161632436756, -2.2956075946245313e-18, -6.61384557158455e-35],
        [1.8809430001533154, -2.005671886543489e-17, -8.425540731092386e-34],
    ],
    [
        [2.2446592738032467, 1.786448352259049e-16, -7.33926792977074e-33],
        [2.6165751406894397, -1.0745500990156672e-16, 5.928755884510105e-33],
    ],
    [
        [2.839741046908047, -1.179152449607214e-16, 1.2842540811854887e-33],
        [3.175628099643187, 5.755428756943965e-18, 8.505653372494661e-35],
    ],
    [
        [3.3354607354411554, -1.930430627796127e-16, -4.8244311502767914e-33],
        [3.646174376387361, 1.722485940424768e-16, 6.172904903722418e-33],
    ],
    [
        [3.7690055670142, -2.0002190718725902e-16, 6.29680663724617e-33],
        [4.060697233933303, 3.623095221906511e-16, 2.2501426827893454e-32],
    ],
    [
        [4.158998399781451, -1.394641950625419e-16, 9.37385176993305e-33],
        [4.435571444236523, -5.8552248217601e-17, 2.4103626203836565e-33],
    ],
    [
        [4.516319399583918, 3.3514917244515803e-16, 1.8336192847990888e-33],
        [4.7804476441484285, 4.937619971557528e-17, -2.7537506832783957e-33],
    ],
    [
        [4.847970309201611, 2.4166471271244863e-16, -8.263184587326283e-33],
        [5.101588043491399, 8.841430010072586e-17, 3.525704406770246e-33],
    ],
];

type Series = [Complex; TERMS];

fn centre(zero: &[[f64; 3]; 2]) -> Complex {
    let [re, im] = zero.map(|[a, b, c]| two_sum(a, b) + c);
    Complex { re, im }
}

/// Coefficients of w: (n + 1) c_{n+1} = -2 z0 c_n - 2 c_{n-1}, from w' = -2 z w + 2i/sqrt(pi).
static W_SERIES: LazyLock<[Series; 8]> = LazyLock::new(|| {
    W.each_ref().map(|zero| {
        let z = centre(zero);
        let mut c = [Complex::ZERO; TERMS];
        c[1].im = TWO_OVER_ROOT_PI;
        for n in 1..TERMS - 1 {
            c[n + 1] = (z * c[n] + c[n - 1]).scale(-2.0) / (n + 1) as f64;
        }
        c
    })
});

/// Coefficients of erf: (n + 2)(n + 1) c_{n+2} = -2 z0 (n + 1) c_{n+1} - 2 n c_n, from erf'' = -2 z erf'.
static ERF_SERIES: LazyLock<[Series; 8]> = LazyLock::new(|| {
    ERF.each_ref().map(|zero| {
        let z = centre(zero);
        let mut c = [Complex::ZERO; TERMS];
        let square = z * z;
        let (sine, cosine) = sin_cos(&[square.im.hi, square.im.lo]);
        let size = exponential(-square.re).value() * TWO_OVER_ROOT_PI;
        c[1] = Complex {
            re: cosine * size,
            im: -sine * size,
        };
        for n in 0..TERMS - 2 {
            let sum = z * c[n + 1] * (n + 1) as f64 + c[n] * n as f64;
            c[n + 2] = sum.scale(-2.0) / ((n + 2) * (n + 1)) as f64;
        }
        c
    })
});

fn beside(table: &[[[f64; 3]; 2]; 8], series: &[Series; 8], x: f64, y: f64) -> Option<Complex> {
    let k = table
        .iter()
        .position(|zero| (x - zero[0][0]).hypot(y - zero[1][0]) < RADIUS)?;
    let step = |x: f64, [a, b, c]: [f64; 3]| two_sum(x - a, -b) + -c;
    let h = Complex {
        re: step(x, table[k][0]),
        im: step(y, table[k][1]),
    };
    let value = series[k].iter().rev().fold(Complex::ZERO, |sum, &c| sum * h + c);
    let (re, im) = (value.re.hi.abs(), value.im.hi.abs());
    // A component that vanishes beside the other has lost digits.
    (re.min(im) > CANCELLED * re.max(im)).then_some(value)
}

/// w(x + iy) beside one of the first zeros; none elsewhere and where a component cancels.
pub fn faddeeva_w(x: f64, y: f64) -> Option<Complex> {
    let mut w = beside(&W, &W_SERIES, x.abs(), y)?;
    if x < 0.0 {
        w.im = -w.im;
    }
    Some(w)
}

/// erf(x + iy) beside one of the first zeros; none elsewhere and where a component cancels.
pub fn erf(x: f64, y: f64) -> Option<Complex> {
    let mut e = beside(&ERF, &ERF_SERIES, x.abs(), y.abs())?;
    if x < 0.0 {
        e.re = -e.re;
    }
    if y < 0.0 {
        e.im = -e.im;
    }
    Some(e)
}
