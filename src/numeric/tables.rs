// Written by data/fits/special.py; do not edit.
//! Coefficients of the f64 sine and cosine on a quarter turn either side of zero.

/// (sin r / r - 1)/r^2 in powers of r^2; fit error 8.0e-18 absolute.
#[rustfmt::skip]
pub(super) const SINE: [f64; 8] = [
    -0.16666666666666666, 0.008333333333333316, -0.00019841269841254795, 2.7557319219115013e-06, -2.505210761086116e-08,
    1.6058976915095007e-10, -7.643957622560617e-13, 2.7312868913092307e-15,
];

/// ((cos r - 1)/r^2 + 1/2)/r^2 in powers of r^2; fit error 1.4e-18 absolute.
#[rustfmt::skip]
pub(super) const COSINE: [f64; 8] = [
    0.041666666666666664, -0.001388888888888888, 2.4801587301579763e-05, -2.755731922154539e-07, 2.087675659980025e-09,
    -1.1470712073563234e-11, 4.7778715720485557e-14, -1.5217846979888659e-16,
];
