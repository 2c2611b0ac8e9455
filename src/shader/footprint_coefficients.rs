// Written by data/fits/footprint.py; do not edit.
//! Nodes and coefficients of the f32 mean over a footprint; the letters of nodes count from the near end.

/// sin^2 of half the angle of a node; that of its mirror is 1 minus it.
pub(super) const FOOTPRINT_NODE_A: f32 = 0.0019026509;
/// The sine of the angle.
pub(super) const FOOTPRINT_NODE_SINE_A: f32 = 0.087155744;
/// sin^2 of half the angle of a node; that of its mirror is 1 minus it.
pub(super) const FOOTPRINT_NODE_B: f32 = 0.017037086;
/// The sine of the angle.
pub(super) const FOOTPRINT_NODE_SINE_B: f32 = 0.25881904;
/// sin^2 of half the angle of a node; that of its mirror is 1 minus it.
pub(super) const FOOTPRINT_NODE_C: f32 = 0.046846107;
/// The sine of the angle.
pub(super) const FOOTPRINT_NODE_SINE_C: f32 = 0.42261827;
/// sin^2 of half the angle of a node; that of its mirror is 1 minus it.
pub(super) const FOOTPRINT_NODE_D: f32 = 0.09042398;
/// The sine of the angle.
pub(super) const FOOTPRINT_NODE_SINE_D: f32 = 0.57357645;
/// sin^2 of half the angle of a node; that of its mirror is 1 minus it.
pub(super) const FOOTPRINT_NODE_E: f32 = 0.14644662;
/// The sine of the angle.
pub(super) const FOOTPRINT_NODE_SINE_E: f32 = 0.70710677;
/// sin^2 of half the angle of a node; that of its mirror is 1 minus it.
pub(super) const FOOTPRINT_NODE_F: f32 = 0.21321177;
/// The sine of the angle.
pub(super) const FOOTPRINT_NODE_SINE_F: f32 = 0.81915206;
/// sin^2 of half the angle of a node; that of its mirror is 1 minus it.
pub(super) const FOOTPRINT_NODE_G: f32 = 0.28869087;
/// The sine of the angle.
pub(super) const FOOTPRINT_NODE_SINE_G: f32 = 0.9063078;
/// sin^2 of half the angle of a node; that of its mirror is 1 minus it.
pub(super) const FOOTPRINT_NODE_H: f32 = 0.37059048;
/// The sine of the angle.
pub(super) const FOOTPRINT_NODE_SINE_H: f32 = 0.9659258;
/// sin^2 of half the angle of a node; that of its mirror is 1 minus it.
pub(super) const FOOTPRINT_NODE_I: f32 = 0.45642212;
/// The sine of the angle.
pub(super) const FOOTPRINT_NODE_SINE_I: f32 = 0.9961947;
/// (2^r - 1)/r in powers of r, to 3.2e-7.
pub(super) const HALVING_A: f32 = 0.6931472;
/// (2^r - 1)/r in powers of r, to 3.2e-7.
pub(super) const HALVING_B: f32 = 0.2402235;
/// (2^r - 1)/r in powers of r, to 3.2e-7.
pub(super) const HALVING_C: f32 = 0.05550381;
/// (2^r - 1)/r in powers of r, to 3.2e-7.
pub(super) const HALVING_D: f32 = 0.009666368;
/// (2^r - 1)/r in powers of r, to 3.2e-7.
pub(super) const HALVING_E: f32 = 0.0013381302;
/// Exponent for H < 3, v^2, v^4, v^6 times powers 0 to 5 of w, to 0.00028 of M(H, 0).
pub(super) const FOOTPRINT_NARROW_A: f32 = 0.13825849;
/// Exponent for H < 3, v^2, v^4, v^6 times powers 0 to 5 of w, to 0.00028 of M(H, 0).
pub(super) const FOOTPRINT_NARROW_B: f32 = -0.25333163;
/// Exponent for H < 3, v^2, v^4, v^6 times powers 0 to 5 of w, to 0.00028 of M(H, 0).
pub(super) const FOOTPRINT_NARROW_C: f32 = -0.00026723035;
/// Exponent for H < 3, v^2, v^4, v^6 times powers 0 to 5 of w, to 0.00028 of M(H, 0).
pub(super) const FOOTPRINT_NARROW_D: f32 = 0.01970528;
/// Exponent for H < 3, v^2, v^4, v^6 times powers 0 to 5 of w, to 0.00028 of M(H, 0).
pub(super) const FOOTPRINT_NARROW_E: f32 = -0.0026913143;
/// Exponent for H < 3, v^2, v^4, v^6 times powers 0 to 5 of w, to 0.00028 of M(H, 0).
pub(super) const FOOTPRINT_NARROW_F: f32 = 0.00012525705;
/// Exponent for H < 3, v^2, v^4, v^6 times powers 0 to 5 of w, to 0.00028 of M(H, 0).
pub(super) const FOOTPRINT_NARROW_G: f32 = 0.26582924;
/// Exponent for H < 3, v^2, v^4, v^6 times powers 0 to 5 of w, to 0.00028 of M(H, 0).
pub(super) const FOOTPRINT_NARROW_H: f32 = -1.1349578;
/// Exponent for H < 3, v^2, v^4, v^6 times powers 0 to 5 of w, to 0.00028 of M(H, 0).
pub(super) const FOOTPRINT_NARROW_I: f32 = 0.7839661;
/// Exponent for H < 3, v^2, v^4, v^6 times powers 0 to 5 of w, to 0.00028 of M(H, 0).
pub(super) const FOOTPRINT_NARROW_J: f32 = -0.20106;
/// Exponent for H < 3, v^2, v^4, v^6 times powers 0 to 5 of w, to 0.00028 of M(H, 0).
pub(super) const FOOTPRINT_NARROW_K: f32 = 0.022316214;
/// Exponent for H < 3, v^2, v^4, v^6 times powers 0 to 5 of w, to 0.00028 of M(H, 0).
pub(super) const FOOTPRINT_NARROW_L: f32 = -0.00094284577;
/// Exponent for H < 3, v^2, v^4, v^6 times powers 0 to 5 of w, to 0.00028 of M(H, 0).
pub(super) const FOOTPRINT_NARROW_M: f32 = -0.18790737;
/// Exponent for H < 3, v^2, v^4, v^6 times powers 0 to 5 of w, to 0.00028 of M(H, 0).
pub(super) const FOOTPRINT_NARROW_N: f32 = 1.1706403;
/// Exponent for H < 3, v^2, v^4, v^6 times powers 0 to 5 of w, to 0.00028 of M(H, 0).
pub(super) const FOOTPRINT_NARROW_O: f32 = -1.039597;
/// Exponent for H < 3, v^2, v^4, v^6 times powers 0 to 5 of w, to 0.00028 of M(H, 0).
pub(super) const FOOTPRINT_NARROW_P: f32 = 0.30889568;
/// Exponent for H < 3, v^2, v^4, v^6 times powers 0 to 5 of w, to 0.00028 of M(H, 0).
pub(super) const FOOTPRINT_NARROW_Q: f32 = -0.03554422;
/// Exponent for H < 3, v^2, v^4, v^6 times powers 0 to 5 of w, to 0.00028 of M(H, 0).
pub(super) const FOOTPRINT_NARROW_R: f32 = 0.0015310182;
/// Exponent beside the edge in powers of d, and its slope in 1/e, to 0.00057 of M(H, 0).
pub(super) const FOOTPRINT_EDGE_A: f32 = 0.94492203;
/// Exponent beside the edge in powers of d, and its slope in 1/e, to 0.00057 of M(H, 0).
pub(super) const FOOTPRINT_EDGE_B: f32 = -1.4870366;
/// Exponent beside the edge in powers of d, and its slope in 1/e, to 0.00057 of M(H, 0).
pub(super) const FOOTPRINT_EDGE_C: f32 = 0.60066104;
/// Exponent beside the edge in powers of d, and its slope in 1/e, to 0.00057 of M(H, 0).
pub(super) const FOOTPRINT_EDGE_D: f32 = -0.10374308;
/// Exponent beside the edge in powers of d, and its slope in 1/e, to 0.00057 of M(H, 0).
pub(super) const FOOTPRINT_EDGE_E: f32 = -0.004889445;
/// Exponent beside the edge in powers of d, and its slope in 1/e, to 0.00057 of M(H, 0).
pub(super) const FOOTPRINT_EDGE_F: f32 = 0.00267118;
/// Exponent beside the edge in powers of d, and its slope in 1/e, to 0.00057 of M(H, 0).
pub(super) const FOOTPRINT_EDGE_SLOPE_A: f32 = 0.36916718;
/// Exponent beside the edge in powers of d, and its slope in 1/e, to 0.00057 of M(H, 0).
pub(super) const FOOTPRINT_EDGE_SLOPE_B: f32 = -0.24061514;
/// Exponent beside the edge in powers of d, and its slope in 1/e, to 0.00057 of M(H, 0).
pub(super) const FOOTPRINT_EDGE_SLOPE_C: f32 = 0.049636792;
