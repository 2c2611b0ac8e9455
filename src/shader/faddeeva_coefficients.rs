// Written by data/fits/faddeeva_shader.py; do not edit.
//! Coefficients of the f32 Faddeeva function; the letters count powers upward.

#![allow(clippy::excessive_precision, clippy::approx_constant)]

/// |z|^2 where the two fits meet.
pub(super) const FADDEEVA_BORDER: f32 = 4.0;
/// zeta about which both fits are made.
pub(super) const FADDEEVA_CENTRE: f32 = 2.0;
/// Minus the zeta of the pole of the near fit.
pub(super) const FADDEEVA_NEAR_POLE: f32 = 2.0;
/// Minus the zeta of the pole of the far fit.
pub(super) const FADDEEVA_FAR_POLE: f32 = 3.0;
/// w at the centre.
pub(super) const FADDEEVA_AT_CENTRE: f32 = 0.25539568;
/// L of the coarse tier.
pub(super) const FADDEEVA_COARSE_POLE: f32 = 2.5;

/// (w - w(2i))/(zeta - 2) in (zeta - 2)/(zeta + 2); w within 1.0e-08.
pub(super) const FADDEEVA_NEAR_A: f32 = -0.106796466;
/// (w - w(2i))/(zeta - 2) in (zeta - 2)/(zeta + 2); w within 1.0e-08.
pub(super) const FADDEEVA_NEAR_B: f32 = 0.16721098;
/// (w - w(2i))/(zeta - 2) in (zeta - 2)/(zeta + 2); w within 1.0e-08.
pub(super) const FADDEEVA_NEAR_C: f32 = -0.080159344;
/// (w - w(2i))/(zeta - 2) in (zeta - 2)/(zeta + 2); w within 1.0e-08.
pub(super) const FADDEEVA_NEAR_D: f32 = 0.020677371;
/// (w - w(2i))/(zeta - 2) in (zeta - 2)/(zeta + 2); w within 1.0e-08.
pub(super) const FADDEEVA_NEAR_E: f32 = 0.0008148871;
/// (w - w(2i))/(zeta - 2) in (zeta - 2)/(zeta + 2); w within 1.0e-08.
pub(super) const FADDEEVA_NEAR_F: f32 = -0.0019636583;
/// (w - w(2i))/(zeta - 2) in (zeta - 2)/(zeta + 2); w within 1.0e-08.
pub(super) const FADDEEVA_NEAR_G: f32 = -3.7765014e-05;
/// (w - w(2i))/(zeta - 2) in (zeta - 2)/(zeta + 2); w within 1.0e-08.
pub(super) const FADDEEVA_NEAR_H: f32 = 0.00025102615;
/// (w - w(2i))/(zeta - 2) in (zeta - 2)/(zeta + 2); w within 1.0e-08.
pub(super) const FADDEEVA_NEAR_I: f32 = 2.6974167e-05;
/// (w - w(2i))/(zeta - 2) in (zeta - 2)/(zeta + 2); w within 1.0e-08.
pub(super) const FADDEEVA_NEAR_J: f32 = -4.1503077e-05;
/// (w - w(2i))/(zeta - 2) in (zeta - 2)/(zeta + 2); w within 1.0e-08.
pub(super) const FADDEEVA_NEAR_K: f32 = -1.6607877e-05;
/// (w - w(2i))/(zeta - 2) in (zeta - 2)/(zeta + 2); w within 1.0e-08.
pub(super) const FADDEEVA_NEAR_L: f32 = 2.7369815e-06;
/// (w - w(2i))/(zeta - 2) in (zeta - 2)/(zeta + 2); w within 1.0e-08.
pub(super) const FADDEEVA_NEAR_M: f32 = 4.669254e-06;
/// (w - w(2i))/(zeta - 2) in (zeta - 2)/(zeta + 2); w within 1.0e-08.
pub(super) const FADDEEVA_NEAR_N: f32 = 1.8796283e-06;
/// (w - w(2i))/(zeta - 2) in (zeta - 2)/(zeta + 2); w within 1.0e-08.
pub(super) const FADDEEVA_NEAR_O: f32 = 3.2530315e-07;

/// (zeta + 3)^2 (sqrt(pi) zeta w - 1) in (zeta - 2)/(zeta + 3); w within 9.1e-08.
pub(super) const FADDEEVA_FAR_A: f32 = -2.3661494;
/// (zeta + 3)^2 (sqrt(pi) zeta w - 1) in (zeta - 2)/(zeta + 3); w within 9.1e-08.
pub(super) const FADDEEVA_FAR_B: f32 = 4.529406;
/// (zeta + 3)^2 (sqrt(pi) zeta w - 1) in (zeta - 2)/(zeta + 3); w within 9.1e-08.
pub(super) const FADDEEVA_FAR_C: f32 = -5.0040684;
/// (zeta + 3)^2 (sqrt(pi) zeta w - 1) in (zeta - 2)/(zeta + 3); w within 9.1e-08.
pub(super) const FADDEEVA_FAR_D: f32 = 3.61526;
/// (zeta + 3)^2 (sqrt(pi) zeta w - 1) in (zeta - 2)/(zeta + 3); w within 9.1e-08.
pub(super) const FADDEEVA_FAR_E: f32 = -1.5806278;
/// (zeta + 3)^2 (sqrt(pi) zeta w - 1) in (zeta - 2)/(zeta + 3); w within 9.1e-08.
pub(super) const FADDEEVA_FAR_F: f32 = 0.20925954;
/// (zeta + 3)^2 (sqrt(pi) zeta w - 1) in (zeta - 2)/(zeta + 3); w within 9.1e-08.
pub(super) const FADDEEVA_FAR_G: f32 = 0.1795237;
/// (zeta + 3)^2 (sqrt(pi) zeta w - 1) in (zeta - 2)/(zeta + 3); w within 9.1e-08.
pub(super) const FADDEEVA_FAR_H: f32 = -0.075746216;
/// (zeta + 3)^2 (sqrt(pi) zeta w - 1) in (zeta - 2)/(zeta + 3); w within 9.1e-08.
pub(super) const FADDEEVA_FAR_I: f32 = -0.03169403;
/// (zeta + 3)^2 (sqrt(pi) zeta w - 1) in (zeta - 2)/(zeta + 3); w within 9.1e-08.
pub(super) const FADDEEVA_FAR_J: f32 = 0.03326945;
/// (zeta + 3)^2 (sqrt(pi) zeta w - 1) in (zeta - 2)/(zeta + 3); w within 9.1e-08.
pub(super) const FADDEEVA_FAR_K: f32 = -0.01147905;
/// (zeta + 3)^2 (sqrt(pi) zeta w - 1) in (zeta - 2)/(zeta + 3); w within 9.1e-08.
pub(super) const FADDEEVA_FAR_L: f32 = 0.008491194;
/// (zeta + 3)^2 (sqrt(pi) zeta w - 1) in (zeta - 2)/(zeta + 3); w within 9.1e-08.
pub(super) const FADDEEVA_FAR_M: f32 = -0.009628222;
/// (zeta + 3)^2 (sqrt(pi) zeta w - 1) in (zeta - 2)/(zeta + 3); w within 9.1e-08.
pub(super) const FADDEEVA_FAR_N: f32 = 0.0053928373;
/// (zeta + 3)^2 (sqrt(pi) zeta w - 1) in (zeta - 2)/(zeta + 3); w within 9.1e-08.
pub(super) const FADDEEVA_FAR_O: f32 = -0.0011878925;

/// w (L + zeta) in (L - zeta)/(L + zeta); w within 2.4e-05.
pub(super) const FADDEEVA_COARSE_A: f32 = 1.0540318;
/// w (L + zeta) in (L - zeta)/(L + zeta); w within 2.4e-05.
pub(super) const FADDEEVA_COARSE_B: f32 = 0.80465186;
/// w (L + zeta) in (L - zeta)/(L + zeta); w within 2.4e-05.
pub(super) const FADDEEVA_COARSE_C: f32 = 0.4539141;
/// w (L + zeta) in (L - zeta)/(L + zeta); w within 2.4e-05.
pub(super) const FADDEEVA_COARSE_D: f32 = 0.17125115;
/// w (L + zeta) in (L - zeta)/(L + zeta); w within 2.4e-05.
pub(super) const FADDEEVA_COARSE_E: f32 = 0.028361548;
/// w (L + zeta) in (L - zeta)/(L + zeta); w within 2.4e-05.
pub(super) const FADDEEVA_COARSE_F: f32 = -0.00839299;
/// w (L + zeta) in (L - zeta)/(L + zeta); w within 2.4e-05.
pub(super) const FADDEEVA_COARSE_G: f32 = -0.004818751;
/// w (L + zeta) in (L - zeta)/(L + zeta); w within 2.4e-05.
pub(super) const FADDEEVA_COARSE_H: f32 = 0.00043853337;
/// w (L + zeta) in (L - zeta)/(L + zeta); w within 2.4e-05.
pub(super) const FADDEEVA_COARSE_I: f32 = 0.0006994823;
/// w (L + zeta) in (L - zeta)/(L + zeta); w within 2.4e-05.
pub(super) const FADDEEVA_COARSE_J: f32 = -6.722101e-05;
/// w (L + zeta) in (L - zeta)/(L + zeta); w within 2.4e-05.
pub(super) const FADDEEVA_COARSE_K: f32 = -0.00012964732;
