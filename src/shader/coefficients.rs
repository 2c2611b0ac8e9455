// Written by data/fits/shader.py; do not edit.
//! Coefficients of the f32 kernels; the letters count powers upward.

#![allow(clippy::excessive_precision, clippy::approx_constant)]

/// (sin r / r - 1)/r^2 in r^2; sine within 4.7e-9.
pub(super) const SINE_A: f32 = -0.16666657;
/// (sin r / r - 1)/r^2 in r^2; sine within 4.7e-9.
pub(super) const SINE_B: f32 = 0.008333015;
/// (sin r / r - 1)/r^2 in r^2; sine within 4.7e-9.
pub(super) const SINE_C: f32 = -0.00019806474;
/// (sin r / r - 1)/r^2 in r^2; sine within 4.7e-9.
pub(super) const SINE_D: f32 = 2.5997415e-06;

/// ((cos r - 1)/r^2 + 1/2)/r^2 in r^2; cosine within 4.0e-10.
pub(super) const COSINE_A: f32 = 0.041666657;
/// ((cos r - 1)/r^2 + 1/2)/r^2 in r^2; cosine within 4.0e-10.
pub(super) const COSINE_B: f32 = -0.0013888567;
/// ((cos r - 1)/r^2 + 1/2)/r^2 in r^2; cosine within 4.0e-10.
pub(super) const COSINE_C: f32 = 2.4769173e-05;
/// ((cos r - 1)/r^2 + 1/2)/r^2 in r^2; cosine within 4.0e-10.
pub(super) const COSINE_D: f32 = -2.6191063e-07;

/// (sin r / r - 1)/r^2 in r^2; sine within 8.9e-7.
pub(super) const SINE_MEDIUM_A: f32 = -0.16665675;
/// (sin r / r - 1)/r^2 in r^2; sine within 8.9e-7.
pub(super) const SINE_MEDIUM_B: f32 = 0.00831228;
/// (sin r / r - 1)/r^2 in r^2; sine within 8.9e-7.
pub(super) const SINE_MEDIUM_C: f32 = -0.00018489461;

/// ((cos r - 1)/r^2 + 1/2)/r^2 in r^2; cosine within 9.5e-8.
pub(super) const COSINE_MEDIUM_A: f32 = 0.04166543;
/// ((cos r - 1)/r^2 + 1/2)/r^2 in r^2; cosine within 9.5e-8.
pub(super) const COSINE_MEDIUM_B: f32 = -0.0013865135;
/// ((cos r - 1)/r^2 + 1/2)/r^2 in r^2; cosine within 9.5e-8.
pub(super) const COSINE_MEDIUM_C: f32 = 2.3376515e-05;

/// (sin r / r - 1)/r^2 in r^2; sine within 0.00011.
pub(super) const SINE_COARSE_A: f32 = -0.1660762;
/// (sin r / r - 1)/r^2 in r^2; sine within 0.00011.
pub(super) const SINE_COARSE_B: f32 = 0.00763235;

/// ((cos r - 1)/r^2 + 1/2)/r^2 in r^2; cosine within 1.7e-5.
pub(super) const COSINE_COARSE_A: f32 = 0.041583017;
/// ((cos r - 1)/r^2 + 1/2)/r^2 in r^2; cosine within 1.7e-5.
pub(super) const COSINE_COARSE_B: f32 = -0.0012964817;

/// (exp r - 1 - r)/r^2 in r; exp within 3.1e-9.
pub(super) const EXPONENTIAL_A: f32 = 0.5;
/// (exp r - 1 - r)/r^2 in r; exp within 3.1e-9.
pub(super) const EXPONENTIAL_B: f32 = 0.16666518;
/// (exp r - 1 - r)/r^2 in r; exp within 3.1e-9.
pub(super) const EXPONENTIAL_C: f32 = 0.041666202;
/// (exp r - 1 - r)/r^2 in r; exp within 3.1e-9.
pub(super) const EXPONENTIAL_D: f32 = 0.00836896;
/// (exp r - 1 - r)/r^2 in r; exp within 3.1e-9.
pub(super) const EXPONENTIAL_E: f32 = 0.0013950627;

/// (1 - arctan t/t)/t^2 in t^2; arctan within 5.0e-9.
pub(super) const ARCTANGENT_A: f32 = 0.33332753;
/// (1 - arctan t/t)/t^2 in t^2; arctan within 5.0e-9.
pub(super) const ARCTANGENT_B: f32 = -0.199718;
/// (1 - arctan t/t)/t^2 in t^2; arctan within 5.0e-9.
pub(super) const ARCTANGENT_C: f32 = 0.13823614;
/// (1 - arctan t/t)/t^2 in t^2; arctan within 5.0e-9.
pub(super) const ARCTANGENT_D: f32 = -0.07899901;

/// (2 artanh s/s - 2)/s^2 in s^2; 2 artanh within 1.8e-10.
pub(super) const ARTANH_A: f32 = 0.6666682;
/// (2 artanh s/s - 2)/s^2 in s^2; 2 artanh within 1.8e-10.
pub(super) const ARTANH_B: f32 = 0.39973545;
/// (2 artanh s/s - 2)/s^2 in s^2; 2 artanh within 1.8e-10.
pub(super) const ARTANH_C: f32 = 0.29962823;

/// Border of head and tail.
pub(super) const SI_BORDER: f32 = 3.0;

/// (Si(x)/x - 1)/x^2 in x^2; Si within 5.0e-11.
pub(super) const SI_HEAD_A: f32 = -0.055555556;
/// (Si(x)/x - 1)/x^2 in x^2; Si within 5.0e-11.
pub(super) const SI_HEAD_B: f32 = 0.001666666;
/// (Si(x)/x - 1)/x^2 in x^2; Si within 5.0e-11.
pub(super) const SI_HEAD_C: f32 = -2.8344251e-05;
/// (Si(x)/x - 1)/x^2 in x^2; Si within 5.0e-11.
pub(super) const SI_HEAD_D: f32 = 3.060661e-07;
/// (Si(x)/x - 1)/x^2 in x^2; Si within 5.0e-11.
pub(super) const SI_HEAD_E: f32 = -2.2577045e-09;
/// (Si(x)/x - 1)/x^2 in x^2; Si within 5.0e-11.
pub(super) const SI_HEAD_F: f32 = 1.0790571e-11;

/// N of x f = N/D from the power 1; within 1.7e-8 of f and g.
pub(super) const SI_F_A: f32 = 70.17039;
/// N of x f = N/D from the power 1; within 1.7e-8 of f and g.
pub(super) const SI_F_B: f32 = 989.60046;
/// N of x f = N/D from the power 1; within 1.7e-8 of f and g.
pub(super) const SI_F_C: f32 = 2541.1763;
/// N of x f = N/D from the power 1; within 1.7e-8 of f and g.
pub(super) const SI_F_D: f32 = 364.07697;

/// D of x f = N/D and x^2 g = M/D from the power 1; within 1.7e-8 of f and g.
pub(super) const SI_D_A: f32 = 72.17014;
/// D of x f = N/D and x^2 g = M/D from the power 1; within 1.7e-8 of f and g.
pub(super) const SI_D_B: f32 = 1110.126;
/// D of x f = N/D and x^2 g = M/D from the power 1; within 1.7e-8 of f and g.
pub(super) const SI_D_C: f32 = 3699.743;
/// D of x f = N/D and x^2 g = M/D from the power 1; within 1.7e-8 of f and g.
pub(super) const SI_D_D: f32 = 1548.3854;

/// M of x^2 g = M/D from the power 1; within 1.7e-8 of f and g.
pub(super) const SI_G_A: f32 = 66.17814;
/// M of x^2 g = M/D from the power 1; within 1.7e-8 of f and g.
pub(super) const SI_G_B: f32 = 793.8138;
/// M of x^2 g = M/D from the power 1; within 1.7e-8 of f and g.
pub(super) const SI_G_C: f32 = 1338.202;

/// Border of head and tail.
pub(super) const SI_MEDIUM_BORDER: f32 = 4.0;

/// (Si(x)/x - 1)/x^2 in x^2; Si within 2.1e-7.
pub(super) const SI_MEDIUM_HEAD_A: f32 = -0.055555113;
/// (Si(x)/x - 1)/x^2 in x^2; Si within 2.1e-7.
pub(super) const SI_MEDIUM_HEAD_B: f32 = 0.0016663427;
/// (Si(x)/x - 1)/x^2 in x^2; Si within 2.1e-7.
pub(super) const SI_MEDIUM_HEAD_C: f32 = -2.8261613e-05;
/// (Si(x)/x - 1)/x^2 in x^2; Si within 2.1e-7.
pub(super) const SI_MEDIUM_HEAD_D: f32 = 2.9645898e-07;
/// (Si(x)/x - 1)/x^2 in x^2; Si within 2.1e-7.
pub(super) const SI_MEDIUM_HEAD_E: f32 = -1.7360231e-09;

/// N of x f = N/D from the power 1; within 5.7e-6 of f and g.
pub(super) const SI_MEDIUM_F_A: f32 = 17.290882;
/// N of x f = N/D from the power 1; within 5.7e-6 of f and g.
pub(super) const SI_MEDIUM_F_B: f32 = 12.183432;

/// D of x f = N/D and x^2 g = M/D from the power 1; within 5.7e-6 of f and g.
pub(super) const SI_MEDIUM_D_A: f32 = 19.27993;
/// D of x f = N/D and x^2 g = M/D from the power 1; within 5.7e-6 of f and g.
pub(super) const SI_MEDIUM_D_B: f32 = 29.837011;

/// M of x^2 g = M/D from the power 1; within 5.7e-6 of f and g.
pub(super) const SI_MEDIUM_G_A: f32 = 13.527913;

/// Border of head and tail.
pub(super) const SI_COARSE_BORDER: f32 = 4.2;

/// (Si(x)/x - 1)/x^2 in x^2; Si within 1.6e-5.
pub(super) const SI_COARSE_HEAD_A: f32 = -0.055537447;
/// (Si(x)/x - 1)/x^2 in x^2; Si within 1.6e-5.
pub(super) const SI_COARSE_HEAD_B: f32 = 0.0016581498;
/// (Si(x)/x - 1)/x^2 in x^2; Si within 1.6e-5.
pub(super) const SI_COARSE_HEAD_C: f32 = -2.7003263e-05;
/// (Si(x)/x - 1)/x^2 in x^2; Si within 1.6e-5.
pub(super) const SI_COARSE_HEAD_D: f32 = 2.1766542e-07;

/// N of x f = N/D from the power 1; within 0.00027 of f and g.
pub(super) const SI_COARSE_F_A: f32 = 2.6163409;

/// D of x f = N/D and x^2 g = M/D from the power 1; within 0.00027 of f and g.
pub(super) const SI_COARSE_D_A: f32 = 4.341545;

/// Border of head and tail in q = y/2.
pub(super) const ARC_BORDER: f32 = 1.5;

/// (H(2q)/q - 1)/q^2 in q^2; H within 3.2e-12.
pub(super) const ARC_HEAD_A: f32 = -0.11111111;
/// (H(2q)/q - 1)/q^2 in q^2; H within 3.2e-12.
pub(super) const ARC_HEAD_B: f32 = 0.008888887;
/// (H(2q)/q - 1)/q^2 in q^2; H within 3.2e-12.
pub(super) const ARC_HEAD_C: f32 = -0.00045351134;
/// (H(2q)/q - 1)/q^2 in q^2; H within 3.2e-12.
pub(super) const ARC_HEAD_D: f32 = 1.5672966e-05;
/// (H(2q)/q - 1)/q^2 in q^2; H within 3.2e-12.
pub(super) const ARC_HEAD_E: f32 = -3.8613345e-07;
/// (H(2q)/q - 1)/q^2 in q^2; H within 3.2e-12.
pub(super) const ARC_HEAD_F: f32 = 6.4225927e-09;

/// K of 1 - y f = K/D from the power 1; 1 - y f within 4.0e-8/y, y^2 g within 4.0e-8.
pub(super) const ARC_K_A: f32 = 1.9999956;
/// K of 1 - y f = K/D from the power 1; 1 - y f within 4.0e-8/y, y^2 g within 4.0e-8.
pub(super) const ARC_K_B: f32 = 258.43646;
/// K of 1 - y f = K/D from the power 1; 1 - y f within 4.0e-8/y, y^2 g within 4.0e-8.
pub(super) const ARC_K_C: f32 = 7410.3594;
/// K of 1 - y f = K/D from the power 1; 1 - y f within 4.0e-8/y, y^2 g within 4.0e-8.
pub(super) const ARC_K_D: f32 = 46687.168;
/// K of 1 - y f = K/D from the power 1; 1 - y f within 4.0e-8/y, y^2 g within 4.0e-8.
pub(super) const ARC_K_E: f32 = 36415.418;

/// D of 1 - y f = K/D and y^2 g = M/D from the power 1; 1 - y f within 4.0e-8/y, y^2 g within 4.0e-8.
pub(super) const ARC_D_A: f32 = 141.21405;
/// D of 1 - y f = K/D and y^2 g = M/D from the power 1; 1 - y f within 4.0e-8/y, y^2 g within 4.0e-8.
pub(super) const ARC_D_B: f32 = 5042.531;
/// D of 1 - y f = K/D and y^2 g = M/D from the power 1; 1 - y f within 4.0e-8/y, y^2 g within 4.0e-8.
pub(super) const ARC_D_C: f32 = 52164.527;
/// D of 1 - y f = K/D and y^2 g = M/D from the power 1; 1 - y f within 4.0e-8/y, y^2 g within 4.0e-8.
pub(super) const ARC_D_D: f32 = 133795.45;
/// D of 1 - y f = K/D and y^2 g = M/D from the power 1; 1 - y f within 4.0e-8/y, y^2 g within 4.0e-8.
pub(super) const ARC_D_E: f32 = 46657.9;

/// M of y^2 g = M/D from the power 1; 1 - y f within 4.0e-8/y, y^2 g within 4.0e-8.
pub(super) const ARC_G_A: f32 = 135.21423;
/// M of y^2 g = M/D from the power 1; 1 - y f within 4.0e-8/y, y^2 g within 4.0e-8.
pub(super) const ARC_G_B: f32 = 4315.019;
/// M of y^2 g = M/D from the power 1; 1 - y f within 4.0e-8/y, y^2 g within 4.0e-8.
pub(super) const ARC_G_C: f32 = 33926.46;
/// M of y^2 g = M/D from the power 1; 1 - y f within 4.0e-8/y, y^2 g within 4.0e-8.
pub(super) const ARC_G_D: f32 = 43137.465;

/// Border of head and tail in q = y/2.
pub(super) const ARC_MEDIUM_BORDER: f32 = 1.5;

/// (H(2q)/q - 1)/q^2 in q^2; H within 4.0e-10.
pub(super) const ARC_MEDIUM_HEAD_A: f32 = -0.1111111;
/// (H(2q)/q - 1)/q^2 in q^2; H within 4.0e-10.
pub(super) const ARC_MEDIUM_HEAD_B: f32 = 0.008888806;
/// (H(2q)/q - 1)/q^2 in q^2; H within 4.0e-10.
pub(super) const ARC_MEDIUM_HEAD_C: f32 = -0.0004533653;
/// (H(2q)/q - 1)/q^2 in q^2; H within 4.0e-10.
pub(super) const ARC_MEDIUM_HEAD_D: f32 = 1.5554067e-05;
/// (H(2q)/q - 1)/q^2 in q^2; H within 4.0e-10.
pub(super) const ARC_MEDIUM_HEAD_E: f32 = -3.4116866e-07;

/// K of 1 - y f = K/D from the power 1; 1 - y f within 9.1e-7/y, y^2 g within 9.1e-7.
pub(super) const ARC_MEDIUM_K_A: f32 = 1.9999629;
/// K of 1 - y f = K/D from the power 1; 1 - y f within 9.1e-7/y, y^2 g within 9.1e-7.
pub(super) const ARC_MEDIUM_K_B: f32 = 145.12321;
/// K of 1 - y f = K/D from the power 1; 1 - y f within 9.1e-7/y, y^2 g within 9.1e-7.
pub(super) const ARC_MEDIUM_K_C: f32 = 1707.5638;
/// K of 1 - y f = K/D from the power 1; 1 - y f within 9.1e-7/y, y^2 g within 9.1e-7.
pub(super) const ARC_MEDIUM_K_D: f32 = 2135.3086;

/// D of 1 - y f = K/D and y^2 g = M/D from the power 1; 1 - y f within 9.1e-7/y, y^2 g within 9.1e-7.
pub(super) const ARC_MEDIUM_D_A: f32 = 84.52877;
/// D of 1 - y f = K/D and y^2 g = M/D from the power 1; 1 - y f within 9.1e-7/y, y^2 g within 9.1e-7.
pub(super) const ARC_MEDIUM_D_B: f32 = 1521.9207;
/// D of 1 - y f = K/D and y^2 g = M/D from the power 1; 1 - y f within 9.1e-7/y, y^2 g within 9.1e-7.
pub(super) const ARC_MEDIUM_D_C: f32 = 5905.193;
/// D of 1 - y f = K/D and y^2 g = M/D from the power 1; 1 - y f within 9.1e-7/y, y^2 g within 9.1e-7.
pub(super) const ARC_MEDIUM_D_D: f32 = 2854.2007;

/// M of y^2 g = M/D from the power 1; 1 - y f within 9.1e-7/y, y^2 g within 9.1e-7.
pub(super) const ARC_MEDIUM_G_A: f32 = 78.53092;
/// M of y^2 g = M/D from the power 1; 1 - y f within 9.1e-7/y, y^2 g within 9.1e-7.
pub(super) const ARC_MEDIUM_G_B: f32 = 1133.2189;
/// M of y^2 g = M/D from the power 1; 1 - y f within 9.1e-7/y, y^2 g within 9.1e-7.
pub(super) const ARC_MEDIUM_G_C: f32 = 2315.1272;

/// Border of head and tail in q = y/2.
pub(super) const ARC_COARSE_BORDER: f32 = 1.5;

/// (H(2q)/q - 1)/q^2 in q^2; H within 4.0e-8.
pub(super) const ARC_COARSE_HEAD_A: f32 = -0.11111016;
/// (H(2q)/q - 1)/q^2 in q^2; H within 4.0e-8.
pub(super) const ARC_COARSE_HEAD_B: f32 = 0.008885415;
/// (H(2q)/q - 1)/q^2 in q^2; H within 4.0e-8.
pub(super) const ARC_COARSE_HEAD_C: f32 = -0.00044930252;
/// (H(2q)/q - 1)/q^2 in q^2; H within 4.0e-8.
pub(super) const ARC_COARSE_HEAD_D: f32 = 1.3569316e-05;

/// K of 1 - y f = K/D from the power 1; 1 - y f within 1.8e-5/y, y^2 g within 1.8e-5.
pub(super) const ARC_COARSE_K_A: f32 = 1.9989456;
/// K of 1 - y f = K/D from the power 1; 1 - y f within 1.8e-5/y, y^2 g within 1.8e-5.
pub(super) const ARC_COARSE_K_B: f32 = 67.905655;
/// K of 1 - y f = K/D from the power 1; 1 - y f within 1.8e-5/y, y^2 g within 1.8e-5.
pub(super) const ARC_COARSE_K_C: f32 = 185.41277;

/// D of 1 - y f = K/D and y^2 g = M/D from the power 1; 1 - y f within 1.8e-5/y, y^2 g within 1.8e-5.
pub(super) const ARC_COARSE_D_A: f32 = 45.673885;
/// D of 1 - y f = K/D and y^2 g = M/D from the power 1; 1 - y f within 1.8e-5/y, y^2 g within 1.8e-5.
pub(super) const ARC_COARSE_D_B: f32 = 335.51318;
/// D of 1 - y f = K/D and y^2 g = M/D from the power 1; 1 - y f within 1.8e-5/y, y^2 g within 1.8e-5.
pub(super) const ARC_COARSE_D_C: f32 = 273.18066;

/// M of y^2 g = M/D from the power 1; 1 - y f within 1.8e-5/y, y^2 g within 1.8e-5.
pub(super) const ARC_COARSE_G_A: f32 = 39.695797;
/// M of y^2 g = M/D from the power 1; 1 - y f within 1.8e-5/y, y^2 g within 1.8e-5.
pub(super) const ARC_COARSE_G_B: f32 = 173.4533;
