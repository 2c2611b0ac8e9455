// Written by data/fits/bessel.py; do not edit.
//! Coefficients of the f32 scaled modified Bessel functions; the letters count powers upward.

/// Where the piece ends.
pub(super) const BESSEL_FIRST_END: f32 = 0.36;

/// a of the piece.
pub(super) const BESSEL_FIRST_CENTRE: f32 = 0.16500461;

/// c, e^-x I0(x) at a.
pub(super) const BESSEL_FIRST_VALUE: f32 = 0.8536709;

/// (e^-x I0(x) - c)/(x - a) in x - a; within 3.0e-11 of e^-x I0(x).
pub(super) const BESSEL_FIRST_A: f32 = -0.7834797;
/// (e^-x I0(x) - c)/(x - a) in x - a; within 3.0e-11 of e^-x I0(x).
pub(super) const BESSEL_FIRST_B: f32 = 0.570785;
/// (e^-x I0(x) - c)/(x - a) in x - a; within 3.0e-11 of e^-x I0(x).
pub(super) const BESSEL_FIRST_C: f32 = -0.31254634;
/// (e^-x I0(x) - c)/(x - a) in x - a; within 3.0e-11 of e^-x I0(x).
pub(super) const BESSEL_FIRST_D: f32 = 0.13556284;
/// (e^-x I0(x) - c)/(x - a) in x - a; within 3.0e-11 of e^-x I0(x).
pub(super) const BESSEL_FIRST_E: f32 = -0.048531253;
/// (e^-x I0(x) - c)/(x - a) in x - a; within 3.0e-11 of e^-x I0(x).
pub(super) const BESSEL_FIRST_F: f32 = 0.014805781;
/// (e^-x I0(x) - c)/(x - a) in x - a; within 3.0e-11 of e^-x I0(x).
pub(super) const BESSEL_FIRST_G: f32 = -0.00375398;

/// Where the piece ends.
pub(super) const BESSEL_SECOND_END: f32 = 0.86;

/// a of the piece.
pub(super) const BESSEL_SECOND_CENTRE: f32 = 0.56998736;

/// c, e^-x I0(x) at a.
pub(super) const BESSEL_SECOND_VALUE: f32 = 0.6124071;

/// (e^-x I0(x) - c)/(x - a) in x - a; within 4.7e-11 of e^-x I0(x).
pub(super) const BESSEL_SECOND_A: f32 = -0.4445993;
/// (e^-x I0(x) - c)/(x - a) in x - a; within 4.7e-11 of e^-x I0(x).
pub(super) const BESSEL_SECOND_B: f32 = 0.29739624;
/// (e^-x I0(x) - c)/(x - a) in x - a; within 4.7e-11 of e^-x I0(x).
pub(super) const BESSEL_SECOND_C: f32 = -0.15609547;
/// (e^-x I0(x) - c)/(x - a) in x - a; within 4.7e-11 of e^-x I0(x).
pub(super) const BESSEL_SECOND_D: f32 = 0.066040955;
/// (e^-x I0(x) - c)/(x - a) in x - a; within 4.7e-11 of e^-x I0(x).
pub(super) const BESSEL_SECOND_E: f32 = -0.023268692;
/// (e^-x I0(x) - c)/(x - a) in x - a; within 4.7e-11 of e^-x I0(x).
pub(super) const BESSEL_SECOND_F: f32 = 0.007030464;
/// (e^-x I0(x) - c)/(x - a) in x - a; within 4.7e-11 of e^-x I0(x).
pub(super) const BESSEL_SECOND_G: f32 = -0.0017126619;

/// Where the piece ends.
pub(super) const BESSEL_THIRD_END: f32 = 1.6;

/// a of the piece.
pub(super) const BESSEL_THIRD_CENTRE: f32 = 1.1800063;

/// c, e^-x I0(x) at a.
pub(super) const BESSEL_THIRD_VALUE: f32 = 0.42391765;

/// (e^-x I0(x) - c)/(x - a) in x - a; within 3.3e-10 of e^-x I0(x).
pub(super) const BESSEL_THIRD_A: f32 = -0.20918402;
/// (e^-x I0(x) - c)/(x - a) in x - a; within 3.3e-10 of e^-x I0(x).
pub(super) const BESSEL_THIRD_B: f32 = 0.1181957;
/// (e^-x I0(x) - c)/(x - a) in x - a; within 3.3e-10 of e^-x I0(x).
pub(super) const BESSEL_THIRD_C: f32 = -0.056936633;
/// (e^-x I0(x) - c)/(x - a) in x - a; within 3.3e-10 of e^-x I0(x).
pub(super) const BESSEL_THIRD_D: f32 = 0.022919957;
/// (e^-x I0(x) - c)/(x - a) in x - a; within 3.3e-10 of e^-x I0(x).
pub(super) const BESSEL_THIRD_E: f32 = -0.007829978;
/// (e^-x I0(x) - c)/(x - a) in x - a; within 3.3e-10 of e^-x I0(x).
pub(super) const BESSEL_THIRD_F: f32 = 0.0023298704;
/// (e^-x I0(x) - c)/(x - a) in x - a; within 3.3e-10 of e^-x I0(x).
pub(super) const BESSEL_THIRD_G: f32 = -0.0005487821;

/// Where the piece ends.
pub(super) const BESSEL_FOURTH_END: f32 = 3.0;

/// a of the piece.
pub(super) const BESSEL_FOURTH_CENTRE: f32 = 2.2999098;

/// c, e^-x I0(x) at a.
pub(super) const BESSEL_FOURTH_VALUE: f32 = 0.2836996;

/// (e^-x I0(x) - c)/(x - a) in x - a; within 1.9e-10 of e^-x I0(x).
pub(super) const BESSEL_FOURTH_A: f32 = -0.073374964;
/// (e^-x I0(x) - c)/(x - a) in x - a; within 1.9e-10 of e^-x I0(x).
pub(super) const BESSEL_FOURTH_B: f32 = 0.027650414;
/// (e^-x I0(x) - c)/(x - a) in x - a; within 1.9e-10 of e^-x I0(x).
pub(super) const BESSEL_FOURTH_C: f32 = -0.010496839;
/// (e^-x I0(x) - c)/(x - a) in x - a; within 1.9e-10 of e^-x I0(x).
pub(super) const BESSEL_FOURTH_D: f32 = 0.003662269;
/// (e^-x I0(x) - c)/(x - a) in x - a; within 1.9e-10 of e^-x I0(x).
pub(super) const BESSEL_FOURTH_E: f32 = -0.0011413017;
/// (e^-x I0(x) - c)/(x - a) in x - a; within 1.9e-10 of e^-x I0(x).
pub(super) const BESSEL_FOURTH_F: f32 = 0.00031557522;
/// (e^-x I0(x) - c)/(x - a) in x - a; within 1.9e-10 of e^-x I0(x).
pub(super) const BESSEL_FOURTH_G: f32 = -7.812707e-05;
/// (e^-x I0(x) - c)/(x - a) in x - a; within 1.9e-10 of e^-x I0(x).
pub(super) const BESSEL_FOURTH_H: f32 = 1.8563202e-05;
/// (e^-x I0(x) - c)/(x - a) in x - a; within 1.9e-10 of e^-x I0(x).
pub(super) const BESSEL_FOURTH_I: f32 = -3.7091993e-06;

/// c of mantissas on this side of the square root of 2.
pub(super) const BESSEL_LOW_CENTRE: f32 = 1.2069249;

/// 1/c.
pub(super) const BESSEL_LOW_INVERSE: f32 = 0.82855195;

/// 1/sqrt(2 pi c).
pub(super) const BESSEL_LOW_EVEN: f32 = 0.36313653;

/// 1/sqrt(4 pi c).
pub(super) const BESSEL_LOW_ODD: f32 = 0.2567763;

/// ln(2 pi c)/2.
pub(super) const BESSEL_LOW_LOG: f32 = 1.0129764;

/// c of mantissas on this side of the square root of 2.
pub(super) const BESSEL_HIGH_CENTRE: f32 = 1.7068787;

/// 1/c.
pub(super) const BESSEL_HIGH_INVERSE: f32 = 0.5858647;

/// 1/sqrt(2 pi c).
pub(super) const BESSEL_HIGH_EVEN: f32 = 0.3053576;

/// 1/sqrt(4 pi c).
pub(super) const BESSEL_HIGH_ODD: f32 = 0.21592043;

/// ln(2 pi c)/2.
pub(super) const BESSEL_HIGH_LOG: f32 = 1.1862717;

/// Between the two c.
pub(super) const BESSEL_SPLIT: f32 = 1.4142135;

/// ((1 + t)^(-1/2) - 1)/t in t; the root within 1.4e-9.
pub(super) const BESSEL_ROOT_A: f32 = -0.5;
/// ((1 + t)^(-1/2) - 1)/t in t; the root within 1.4e-9.
pub(super) const BESSEL_ROOT_B: f32 = 0.37500098;
/// ((1 + t)^(-1/2) - 1)/t in t; the root within 1.4e-9.
pub(super) const BESSEL_ROOT_C: f32 = -0.31250283;
/// ((1 + t)^(-1/2) - 1)/t in t; the root within 1.4e-9.
pub(super) const BESSEL_ROOT_D: f32 = 0.27323663;
/// ((1 + t)^(-1/2) - 1)/t in t; the root within 1.4e-9.
pub(super) const BESSEL_ROOT_E: f32 = -0.24576588;
/// ((1 + t)^(-1/2) - 1)/t in t; the root within 1.4e-9.
pub(super) const BESSEL_ROOT_F: f32 = 0.23715664;
/// ((1 + t)^(-1/2) - 1)/t in t; the root within 1.4e-9.
pub(super) const BESSEL_ROOT_G: f32 = -0.22318871;

/// ln(1 + t)/(2 t) in t; the logarithm within 4.5e-10.
pub(super) const BESSEL_LN_A: f32 = 0.5;
/// ln(1 + t)/(2 t) in t; the logarithm within 4.5e-10.
pub(super) const BESSEL_LN_B: f32 = -0.2500003;
/// ln(1 + t)/(2 t) in t; the logarithm within 4.5e-10.
pub(super) const BESSEL_LN_C: f32 = 0.1666675;
/// ln(1 + t)/(2 t) in t; the logarithm within 4.5e-10.
pub(super) const BESSEL_LN_D: f32 = -0.12493642;
/// ln(1 + t)/(2 t) in t; the logarithm within 4.5e-10.
pub(super) const BESSEL_LN_E: f32 = 0.09990236;
/// ln(1 + t)/(2 t) in t; the logarithm within 4.5e-10.
pub(super) const BESSEL_LN_F: f32 = -0.08700084;
/// ln(1 + t)/(2 t) in t; the logarithm within 4.5e-10.
pub(super) const BESSEL_LN_G: f32 = 0.07551904;

/// Where the piece ends.
pub(super) const BESSEL_OUTER_END: f32 = 6.5;

/// (sqrt(2 pi x) e^-x I0(x) - 1)/V in V = 1/(2 pi x); V times it within 9.7e-10.
pub(super) const BESSEL_TAIL_A: f32 = 0.785402;
/// (sqrt(2 pi x) e^-x I0(x) - 1)/V in V = 1/(2 pi x); V times it within 9.7e-10.
pub(super) const BESSEL_TAIL_B: f32 = 2.7710798;
/// (sqrt(2 pi x) e^-x I0(x) - 1)/V in V = 1/(2 pi x); V times it within 9.7e-10.
pub(super) const BESSEL_TAIL_C: f32 = 20.155907;
/// (sqrt(2 pi x) e^-x I0(x) - 1)/V in V = 1/(2 pi x); V times it within 9.7e-10.
pub(super) const BESSEL_TAIL_D: f32 = -218.7877;
/// (sqrt(2 pi x) e^-x I0(x) - 1)/V in V = 1/(2 pi x); V times it within 9.7e-10.
pub(super) const BESSEL_TAIL_E: f32 = 43648.676;
/// (sqrt(2 pi x) e^-x I0(x) - 1)/V in V = 1/(2 pi x); V times it within 9.7e-10.
pub(super) const BESSEL_TAIL_F: f32 = -2333362.0;
/// (sqrt(2 pi x) e^-x I0(x) - 1)/V in V = 1/(2 pi x); V times it within 9.7e-10.
pub(super) const BESSEL_TAIL_G: f32 = 69145850.0;
/// (sqrt(2 pi x) e^-x I0(x) - 1)/V in V = 1/(2 pi x); V times it within 9.7e-10.
pub(super) const BESSEL_TAIL_H: f32 = -735768640.0;

/// W: the middle of the V below.
pub(super) const BESSEL_OUTER_CENTRE: f32 = 0.03876851;

/// sqrt(2 pi x) e^-x I0(x) - 1 in V - W with V = 1/(2 pi x); within 1.3e-9.
pub(super) const BESSEL_OUTER_A: f32 = 0.03654081;
/// sqrt(2 pi x) e^-x I0(x) - 1 in V - W with V = 1/(2 pi x); within 1.3e-9.
pub(super) const BESSEL_OUTER_B: f32 = 1.1803682;
/// sqrt(2 pi x) e^-x I0(x) - 1 in V - W with V = 1/(2 pi x); within 1.3e-9.
pub(super) const BESSEL_OUTER_C: f32 = 8.338566;
/// sqrt(2 pi x) e^-x I0(x) - 1 in V - W with V = 1/(2 pi x); within 1.3e-9.
pub(super) const BESSEL_OUTER_D: f32 = 7.426099;
/// sqrt(2 pi x) e^-x I0(x) - 1 in V - W with V = 1/(2 pi x); within 1.3e-9.
pub(super) const BESSEL_OUTER_E: f32 = -2785.3804;
/// sqrt(2 pi x) e^-x I0(x) - 1 in V - W with V = 1/(2 pi x); within 1.3e-9.
pub(super) const BESSEL_OUTER_F: f32 = -7030.0894;
/// sqrt(2 pi x) e^-x I0(x) - 1 in V - W with V = 1/(2 pi x); within 1.3e-9.
pub(super) const BESSEL_OUTER_G: f32 = 1309036.1;
/// sqrt(2 pi x) e^-x I0(x) - 1 in V - W with V = 1/(2 pi x); within 1.3e-9.
pub(super) const BESSEL_OUTER_H: f32 = -8430924.0;
/// sqrt(2 pi x) e^-x I0(x) - 1 in V - W with V = 1/(2 pi x); within 1.3e-9.
pub(super) const BESSEL_OUTER_I: f32 = -442043140.0;

/// Where the tails of ln I0 and of I1/I0 begin.
pub(super) const BESSEL_BORDER: f32 = 4.0;

/// Where the heads of ln I0 and of I1/I0 end.
pub(super) const BESSEL_HEAD_END: f32 = 1.0;

/// (ln I0(x)/x^2 - 1/4)/x^2 in x^2; ln I0(x)/x^2 within 2.2e-10.
pub(super) const BESSEL_LOG_HEAD_A: f32 = -0.01562499;
/// (ln I0(x)/x^2 - 1/4)/x^2 in x^2; ln I0(x)/x^2 within 2.2e-10.
pub(super) const BESSEL_LOG_HEAD_B: f32 = 0.0017359626;
/// (ln I0(x)/x^2 - 1/4)/x^2 in x^2; ln I0(x)/x^2 within 2.2e-10.
pub(super) const BESSEL_LOG_HEAD_C: f32 = -0.00022308876;
/// (ln I0(x)/x^2 - 1/4)/x^2 in x^2; ln I0(x)/x^2 within 2.2e-10.
pub(super) const BESSEL_LOG_HEAD_D: f32 = 2.943114e-05;
/// (ln I0(x)/x^2 - 1/4)/x^2 in x^2; ln I0(x)/x^2 within 2.2e-10.
pub(super) const BESSEL_LOG_HEAD_E: f32 = -2.9568555e-06;

/// Where the piece ends.
pub(super) const BESSEL_LOG_FIRST_END: f32 = 1.5;

/// a of the piece.
pub(super) const BESSEL_LOG_FIRST_CENTRE: f32 = 1.2500476;

/// c, ln I0(x) at a.
pub(super) const BESSEL_LOG_FIRST_VALUE: f32 = 0.35802728;

/// (ln I0(x) - c)/(x - a) in x - a; within 3.7e-11 of ln I0(x).
pub(super) const BESSEL_LOG_FIRST_A: f32 = 0.52800995;
/// (ln I0(x) - c)/(x - a) in x - a; within 3.7e-11 of ln I0(x).
pub(super) const BESSEL_LOG_FIRST_B: f32 = 0.14940679;
/// (ln I0(x) - c)/(x - a) in x - a; within 3.7e-11 of ln I0(x).
pub(super) const BESSEL_LOG_FIRST_C: f32 = -0.0361158;
/// (ln I0(x) - c)/(x - a) in x - a; within 3.7e-11 of ln I0(x).
pub(super) const BESSEL_LOG_FIRST_D: f32 = 0.0027255923;
/// (ln I0(x) - c)/(x - a) in x - a; within 3.7e-11 of ln I0(x).
pub(super) const BESSEL_LOG_FIRST_E: f32 = 0.0019267182;
/// (ln I0(x) - c)/(x - a) in x - a; within 3.7e-11 of ln I0(x).
pub(super) const BESSEL_LOG_FIRST_F: f32 = -0.00079366803;

/// Where the piece ends.
pub(super) const BESSEL_LOG_SECOND_END: f32 = 2.4;

/// a of the piece.
pub(super) const BESSEL_LOG_SECOND_CENTRE: f32 = 1.9000068;

/// c, ln I0(x) at a.
pub(super) const BESSEL_LOG_SECOND_VALUE: f32 = 0.7550651;

/// (ln I0(x) - c)/(x - a) in x - a; within 2.5e-10 of ln I0(x).
pub(super) const BESSEL_LOG_SECOND_A: f32 = 0.6806503;
/// (ln I0(x) - c)/(x - a) in x - a; within 2.5e-10 of ln I0(x).
pub(super) const BESSEL_LOG_SECOND_B: f32 = 0.08923973;
/// (ln I0(x) - c)/(x - a) in x - a; within 2.5e-10 of ln I0(x).
pub(super) const BESSEL_LOG_SECOND_C: f32 = -0.024726195;
/// (ln I0(x) - c)/(x - a) in x - a; within 2.5e-10 of ln I0(x).
pub(super) const BESSEL_LOG_SECOND_D: f32 = 0.0048648315;
/// (ln I0(x) - c)/(x - a) in x - a; within 2.5e-10 of ln I0(x).
pub(super) const BESSEL_LOG_SECOND_E: f32 = -0.00022707779;
/// (ln I0(x) - c)/(x - a) in x - a; within 2.5e-10 of ln I0(x).
pub(super) const BESSEL_LOG_SECOND_F: f32 = -0.00026824258;
/// (ln I0(x) - c)/(x - a) in x - a; within 2.5e-10 of ln I0(x).
pub(super) const BESSEL_LOG_SECOND_G: f32 = 0.000102527556;

/// a of the piece.
pub(super) const BESSEL_LOG_THIRD_CENTRE: f32 = 3.2000892;

/// c, ln I0(x) at a.
pub(super) const BESSEL_LOG_THIRD_VALUE: f32 = 1.7487875;

/// (ln I0(x) - c)/(x - a) in x - a; within 2.8e-9 of ln I0(x).
pub(super) const BESSEL_LOG_THIRD_A: f32 = 0.8237543;
/// (ln I0(x) - c)/(x - a) in x - a; within 2.8e-9 of ln I0(x).
pub(super) const BESSEL_LOG_THIRD_B: f32 = 0.032006305;
/// (ln I0(x) - c)/(x - a) in x - a; within 2.8e-9 of ln I0(x).
pub(super) const BESSEL_LOG_THIRD_C: f32 = -0.0075040204;
/// (ln I0(x) - c)/(x - a) in x - a; within 2.8e-9 of ln I0(x).
pub(super) const BESSEL_LOG_THIRD_D: f32 = 0.0017625364;
/// (ln I0(x) - c)/(x - a) in x - a; within 2.8e-9 of ln I0(x).
pub(super) const BESSEL_LOG_THIRD_E: f32 = -0.00036190744;
/// (ln I0(x) - c)/(x - a) in x - a; within 2.8e-9 of ln I0(x).
pub(super) const BESSEL_LOG_THIRD_F: f32 = 5.3291064e-05;
/// (ln I0(x) - c)/(x - a) in x - a; within 2.8e-9 of ln I0(x).
pub(super) const BESSEL_LOG_THIRD_G: f32 = -2.015393e-06;

/// ln(sqrt(2 pi x) e^-x I0(x)) x in 1/x; the logarithm within 5.3e-8.
pub(super) const BESSEL_LOG_TAIL_A: f32 = 0.12497927;
/// ln(sqrt(2 pi x) e^-x I0(x)) x in 1/x; the logarithm within 5.3e-8.
pub(super) const BESSEL_LOG_TAIL_B: f32 = 0.065043844;
/// ln(sqrt(2 pi x) e^-x I0(x)) x in 1/x; the logarithm within 5.3e-8.
pub(super) const BESSEL_LOG_TAIL_C: f32 = -0.039425373;
/// ln(sqrt(2 pi x) e^-x I0(x)) x in 1/x; the logarithm within 5.3e-8.
pub(super) const BESSEL_LOG_TAIL_D: f32 = 2.1019201;
/// ln(sqrt(2 pi x) e^-x I0(x)) x in 1/x; the logarithm within 5.3e-8.
pub(super) const BESSEL_LOG_TAIL_E: f32 = -19.640245;
/// ln(sqrt(2 pi x) e^-x I0(x)) x in 1/x; the logarithm within 5.3e-8.
pub(super) const BESSEL_LOG_TAIL_F: f32 = 103.07769;
/// ln(sqrt(2 pi x) e^-x I0(x)) x in 1/x; the logarithm within 5.3e-8.
pub(super) const BESSEL_LOG_TAIL_G: f32 = -247.29543;
/// ln(sqrt(2 pi x) e^-x I0(x)) x in 1/x; the logarithm within 5.3e-8.
pub(super) const BESSEL_LOG_TAIL_H: f32 = 213.7775;

/// (I1(x)/(x I0(x)) - 1/2)/x^2 in x^2; I1(x)/(x I0(x)) within 2.9e-9.
pub(super) const BESSEL_RATIO_HEAD_A: f32 = -0.062499866;
/// (I1(x)/(x I0(x)) - 1/2)/x^2 in x^2; I1(x)/(x I0(x)) within 2.9e-9.
pub(super) const BESSEL_RATIO_HEAD_B: f32 = 0.010414709;
/// (I1(x)/(x I0(x)) - 1/2)/x^2 in x^2; I1(x)/(x I0(x)) within 2.9e-9.
pub(super) const BESSEL_RATIO_HEAD_C: f32 = -0.0017810093;
/// (I1(x)/(x I0(x)) - 1/2)/x^2 in x^2; I1(x)/(x I0(x)) within 2.9e-9.
pub(super) const BESSEL_RATIO_HEAD_D: f32 = 0.00028933206;
/// (I1(x)/(x I0(x)) - 1/2)/x^2 in x^2; I1(x)/(x I0(x)) within 2.9e-9.
pub(super) const BESSEL_RATIO_HEAD_E: f32 = -3.3203592e-05;

/// Where the piece ends.
pub(super) const BESSEL_RATIO_FIRST_END: f32 = 2.0;

/// a of the piece.
pub(super) const BESSEL_RATIO_FIRST_CENTRE: f32 = 1.5000024;

/// c, I1(x)/I0(x) at a.
pub(super) const BESSEL_RATIO_FIRST_VALUE: f32 = 0.5961338;

/// (I1(x)/I0(x) - c)/(x - a) in x - a; within 5.7e-9 of I1(x)/I0(x).
pub(super) const BESSEL_RATIO_FIRST_A: f32 = 0.24720253;
/// (I1(x)/I0(x) - c)/(x - a) in x - a; within 5.7e-9 of I1(x)/I0(x).
pub(super) const BESSEL_RATIO_FIRST_B: f32 = -0.097293206;
/// (I1(x)/I0(x) - c)/(x - a) in x - a; within 5.7e-9 of I1(x)/I0(x).
pub(super) const BESSEL_RATIO_FIRST_C: f32 = 0.017662916;
/// (I1(x)/I0(x) - c)/(x - a) in x - a; within 5.7e-9 of I1(x)/I0(x).
pub(super) const BESSEL_RATIO_FIRST_D: f32 = 0.004145302;
/// (I1(x)/I0(x) - c)/(x - a) in x - a; within 5.7e-9 of I1(x)/I0(x).
pub(super) const BESSEL_RATIO_FIRST_E: f32 = -0.0037807873;
/// (I1(x)/I0(x) - c)/(x - a) in x - a; within 5.7e-9 of I1(x)/I0(x).
pub(super) const BESSEL_RATIO_FIRST_F: f32 = 0.00085296825;
/// (I1(x)/I0(x) - c)/(x - a) in x - a; within 5.7e-9 of I1(x)/I0(x).
pub(super) const BESSEL_RATIO_FIRST_G: f32 = 0.00014570318;

/// a of the piece.
pub(super) const BESSEL_RATIO_SECOND_CENTRE: f32 = 2.999974;

/// c, I1(x)/I0(x) at a.
pub(super) const BESSEL_RATIO_SECOND_VALUE: f32 = 0.8099834;

/// (I1(x)/I0(x) - c)/(x - a) in x - a; within 8.9e-9 of I1(x)/I0(x).
pub(super) const BESSEL_RATIO_SECOND_A: f32 = 0.073930226;
/// (I1(x)/I0(x) - c)/(x - a) in x - a; within 8.9e-9 of I1(x)/I0(x).
pub(super) const BESSEL_RATIO_SECOND_B: f32 = -0.027204137;
/// (I1(x)/I0(x) - c)/(x - a) in x - a; within 8.9e-9 of I1(x)/I0(x).
pub(super) const BESSEL_RATIO_SECOND_C: f32 = 0.008627776;
/// (I1(x)/I0(x) - c)/(x - a) in x - a; within 8.9e-9 of I1(x)/I0(x).
pub(super) const BESSEL_RATIO_SECOND_D: f32 = -0.002148176;
/// (I1(x)/I0(x) - c)/(x - a) in x - a; within 8.9e-9 of I1(x)/I0(x).
pub(super) const BESSEL_RATIO_SECOND_E: f32 = 0.00034924946;
/// (I1(x)/I0(x) - c)/(x - a) in x - a; within 8.9e-9 of I1(x)/I0(x).
pub(super) const BESSEL_RATIO_SECOND_F: f32 = 3.8275207e-06;
/// (I1(x)/I0(x) - c)/(x - a) in x - a; within 8.9e-9 of I1(x)/I0(x).
pub(super) const BESSEL_RATIO_SECOND_G: f32 = -3.1629304e-05;
/// (I1(x)/I0(x) - c)/(x - a) in x - a; within 8.9e-9 of I1(x)/I0(x).
pub(super) const BESSEL_RATIO_SECOND_H: f32 = 1.1114423e-05;

/// (1 - I1(x)/I0(x)) x in 1/x; the ratio within 1.6e-8.
pub(super) const BESSEL_RATIO_TAIL_A: f32 = 0.5000091;
/// (1 - I1(x)/I0(x)) x in 1/x; the ratio within 1.6e-8.
pub(super) const BESSEL_RATIO_TAIL_B: f32 = 0.12332922;
/// (1 - I1(x)/I0(x)) x in 1/x; the ratio within 1.6e-8.
pub(super) const BESSEL_RATIO_TAIL_C: f32 = 0.22921288;
/// (1 - I1(x)/I0(x)) x in 1/x; the ratio within 1.6e-8.
pub(super) const BESSEL_RATIO_TAIL_D: f32 = -2.9445055;
/// (1 - I1(x)/I0(x)) x in 1/x; the ratio within 1.6e-8.
pub(super) const BESSEL_RATIO_TAIL_E: f32 = 52.64979;
/// (1 - I1(x)/I0(x)) x in 1/x; the ratio within 1.6e-8.
pub(super) const BESSEL_RATIO_TAIL_F: f32 = -504.88522;
/// (1 - I1(x)/I0(x)) x in 1/x; the ratio within 1.6e-8.
pub(super) const BESSEL_RATIO_TAIL_G: f32 = 2858.2017;
/// (1 - I1(x)/I0(x)) x in 1/x; the ratio within 1.6e-8.
pub(super) const BESSEL_RATIO_TAIL_H: f32 = -8947.848;
/// (1 - I1(x)/I0(x)) x in 1/x; the ratio within 1.6e-8.
pub(super) const BESSEL_RATIO_TAIL_I: f32 = 14135.413;
/// (1 - I1(x)/I0(x)) x in 1/x; the ratio within 1.6e-8.
pub(super) const BESSEL_RATIO_TAIL_J: f32 = -8708.469;
