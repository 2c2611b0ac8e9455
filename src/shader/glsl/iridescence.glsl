// iridescence: closed-form wave optics for renderers, f32.
// GLSL 3.30 and later; in GLSL ES 3.00 and later after `precision highp float;`.
// Generated from src/shader/*.rs by `cargo run -p shadergen`: do not edit.
// Licence: MIT OR Apache-2.0.

struct SineCosine {
    float sine;
    float cosine;
};

struct HalfTurns {
    float rest;
    float parity;
};

struct ArcEnds {
    float near;
    float far;
    bool straddles;
};

struct BesselPowers {
    float rest;
    bool high;
    uint exponent;
};

struct Complex {
    float re;
    float im;
};

struct PowerOfE {
    float mantissa;
    float first;
    float second;
};
const float SINE_A = -0.16666657;
const float SINE_B = 0.008333015;
const float SINE_C = -0.00019806474;
const float SINE_D = 2.5997415e-6;
const float COSINE_A = 0.041666657;
const float COSINE_B = -0.0013888567;
const float COSINE_C = 2.4769173e-5;
const float COSINE_D = -2.6191063e-7;
const float SINE_MEDIUM_A = -0.16665675;
const float SINE_MEDIUM_B = 0.00831228;
const float SINE_MEDIUM_C = -0.00018489461;
const float COSINE_MEDIUM_A = 0.04166543;
const float COSINE_MEDIUM_B = -0.0013865135;
const float COSINE_MEDIUM_C = 2.3376515e-5;
const float SINE_COARSE_A = -0.1660762;
const float SINE_COARSE_B = 0.00763235;
const float COSINE_COARSE_A = 0.041583017;
const float COSINE_COARSE_B = -0.0012964817;
const float EXPONENTIAL_A = 0.5;
const float EXPONENTIAL_B = 0.16666518;
const float EXPONENTIAL_C = 0.041666202;
const float EXPONENTIAL_D = 0.00836896;
const float EXPONENTIAL_E = 0.0013950627;
const float SI_BORDER = 3.0;
const float SI_HEAD_A = -0.055555556;
const float SI_HEAD_B = 0.001666666;
const float SI_HEAD_C = -2.8344251e-5;
const float SI_HEAD_D = 3.060661e-7;
const float SI_HEAD_E = -2.2577045e-9;
const float SI_HEAD_F = 1.0790571e-11;
const float SI_F_A = 70.17039;
const float SI_F_B = 989.60046;
const float SI_F_C = 2541.1763;
const float SI_F_D = 364.07697;
const float SI_D_A = 72.17014;
const float SI_D_B = 1110.126;
const float SI_D_C = 3699.743;
const float SI_D_D = 1548.3854;
const float SI_G_A = 66.17814;
const float SI_G_B = 793.8138;
const float SI_G_C = 1338.202;
const float SI_MEDIUM_BORDER = 4.0;
const float SI_MEDIUM_HEAD_A = -0.055555113;
const float SI_MEDIUM_HEAD_B = 0.0016663427;
const float SI_MEDIUM_HEAD_C = -2.8261613e-5;
const float SI_MEDIUM_HEAD_D = 2.9645898e-7;
const float SI_MEDIUM_HEAD_E = -1.7360231e-9;
const float SI_MEDIUM_F_A = 17.290882;
const float SI_MEDIUM_F_B = 12.183432;
const float SI_MEDIUM_D_A = 19.27993;
const float SI_MEDIUM_D_B = 29.837011;
const float SI_MEDIUM_G_A = 13.527913;
const float SI_COARSE_BORDER = 4.2;
const float SI_COARSE_HEAD_A = -0.055537447;
const float SI_COARSE_HEAD_B = 0.0016581498;
const float SI_COARSE_HEAD_C = -2.7003263e-5;
const float SI_COARSE_HEAD_D = 2.1766542e-7;
const float SI_COARSE_F_A = 2.6163409;
const float SI_COARSE_D_A = 4.341545;
const float ARC_BORDER = 1.5;
const float ARC_HEAD_A = -0.11111111;
const float ARC_HEAD_B = 0.008888887;
const float ARC_HEAD_C = -0.00045351134;
const float ARC_HEAD_D = 1.5672966e-5;
const float ARC_HEAD_E = -3.8613345e-7;
const float ARC_HEAD_F = 6.4225927e-9;
const float ARC_K_A = 1.9999956;
const float ARC_K_B = 258.43646;
const float ARC_K_C = 7410.3594;
const float ARC_K_D = 46687.168;
const float ARC_K_E = 36415.418;
const float ARC_D_A = 141.21405;
const float ARC_D_B = 5042.531;
const float ARC_D_C = 52164.527;
const float ARC_D_D = 133795.45;
const float ARC_D_E = 46657.9;
const float ARC_G_A = 135.21423;
const float ARC_G_B = 4315.019;
const float ARC_G_C = 33926.46;
const float ARC_G_D = 43137.465;
const float ARC_MEDIUM_BORDER = 1.5;
const float ARC_MEDIUM_HEAD_A = -0.1111111;
const float ARC_MEDIUM_HEAD_B = 0.008888806;
const float ARC_MEDIUM_HEAD_C = -0.0004533653;
const float ARC_MEDIUM_HEAD_D = 1.5554067e-5;
const float ARC_MEDIUM_HEAD_E = -3.4116866e-7;
const float ARC_MEDIUM_K_A = 1.9999629;
const float ARC_MEDIUM_K_B = 145.12321;
const float ARC_MEDIUM_K_C = 1707.5638;
const float ARC_MEDIUM_K_D = 2135.3086;
const float ARC_MEDIUM_D_A = 84.52877;
const float ARC_MEDIUM_D_B = 1521.9207;
const float ARC_MEDIUM_D_C = 5905.193;
const float ARC_MEDIUM_D_D = 2854.2007;
const float ARC_MEDIUM_G_A = 78.53092;
const float ARC_MEDIUM_G_B = 1133.2189;
const float ARC_MEDIUM_G_C = 2315.1272;
const float ARC_COARSE_BORDER = 1.5;
const float ARC_COARSE_HEAD_A = -0.11111016;
const float ARC_COARSE_HEAD_B = 0.008885415;
const float ARC_COARSE_HEAD_C = -0.00044930252;
const float ARC_COARSE_HEAD_D = 1.3569316e-5;
const float ARC_COARSE_K_A = 1.9989456;
const float ARC_COARSE_K_B = 67.905655;
const float ARC_COARSE_K_C = 185.41277;
const float ARC_COARSE_D_A = 45.673885;
const float ARC_COARSE_D_B = 335.51318;
const float ARC_COARSE_D_C = 273.18066;
const float ARC_COARSE_G_A = 39.695797;
const float ARC_COARSE_G_B = 173.4533;
const float INVERSE_PI = 0.31830987;
const float PI_HIGH = 3.140625;
const float PI_LOW = 0.0009676536;
const float REST_LIMIT = 1.75;
const float TWO_PI = 6.2831855;
const float PHASE_LIMIT = 33554432.0;
const float EXPONENT_BIAS = 8388735.0;
const float LOG_TWO_E = 1.442695;
const float LN_TWO_HIGH = 0.6933594;
const float LN_TWO_LOW = -0.00021219444;
const float HALF_PI = 1.5707964;
const float SQUARE_LIMIT = 16777216.0;
const float VELINOV_BUMP = 0.6614274;
const float VELINOV_OFFSET = 0.3827229;
const float ARC_SHORT = 1.0;
const float ARC_INFINITE = 3e37;
const float ARC_TINY = 1e-30;
const float ARC_PHASE_LIMIT = 8388608.0;
const float ARC_PI = 3.1415927;
const float GAUSS_INNER = 0.33998105;
const float GAUSS_OUTER = 0.8611363;
const float GAUSS_INNER_WEIGHT = 0.65214515;
const float GAUSS_OUTER_WEIGHT = 0.34785485;
const float GAUSS_THREE = 0.7745967;
const float GAUSS_THREE_MIDDLE_WEIGHT = 0.8888889;
const float GAUSS_THREE_OUTER_WEIGHT = 0.5555556;
const float BESSEL_FIRST_END = 0.36;
const float BESSEL_FIRST_CENTRE = 0.16500461;
const float BESSEL_FIRST_VALUE = 0.8536709;
const float BESSEL_FIRST_A = -0.7834797;
const float BESSEL_FIRST_B = 0.570785;
const float BESSEL_FIRST_C = -0.31254634;
const float BESSEL_FIRST_D = 0.13556284;
const float BESSEL_FIRST_E = -0.048531253;
const float BESSEL_FIRST_F = 0.014805781;
const float BESSEL_FIRST_G = -0.00375398;
const float BESSEL_SECOND_END = 0.86;
const float BESSEL_SECOND_CENTRE = 0.56998736;
const float BESSEL_SECOND_VALUE = 0.6124071;
const float BESSEL_SECOND_A = -0.4445993;
const float BESSEL_SECOND_B = 0.29739624;
const float BESSEL_SECOND_C = -0.15609547;
const float BESSEL_SECOND_D = 0.066040955;
const float BESSEL_SECOND_E = -0.023268692;
const float BESSEL_SECOND_F = 0.007030464;
const float BESSEL_SECOND_G = -0.0017126619;
const float BESSEL_THIRD_END = 1.6;
const float BESSEL_THIRD_CENTRE = 1.1800063;
const float BESSEL_THIRD_VALUE = 0.42391765;
const float BESSEL_THIRD_A = -0.20918402;
const float BESSEL_THIRD_B = 0.1181957;
const float BESSEL_THIRD_C = -0.056936633;
const float BESSEL_THIRD_D = 0.022919957;
const float BESSEL_THIRD_E = -0.007829978;
const float BESSEL_THIRD_F = 0.0023298704;
const float BESSEL_THIRD_G = -0.0005487821;
const float BESSEL_FOURTH_END = 3.0;
const float BESSEL_FOURTH_CENTRE = 2.2999098;
const float BESSEL_FOURTH_VALUE = 0.2836996;
const float BESSEL_FOURTH_A = -0.073374964;
const float BESSEL_FOURTH_B = 0.027650414;
const float BESSEL_FOURTH_C = -0.010496839;
const float BESSEL_FOURTH_D = 0.003662269;
const float BESSEL_FOURTH_E = -0.0011413017;
const float BESSEL_FOURTH_F = 0.00031557522;
const float BESSEL_FOURTH_G = -7.812707e-5;
const float BESSEL_FOURTH_H = 1.8563202e-5;
const float BESSEL_FOURTH_I = -3.7091993e-6;
const float BESSEL_LOW_CENTRE = 1.2069249;
const float BESSEL_LOW_INVERSE = 0.82855195;
const float BESSEL_LOW_EVEN = 0.36313653;
const float BESSEL_LOW_ODD = 0.2567763;
const float BESSEL_LOW_LOG = 1.0129764;
const float BESSEL_HIGH_CENTRE = 1.7068787;
const float BESSEL_HIGH_INVERSE = 0.5858647;
const float BESSEL_HIGH_EVEN = 0.3053576;
const float BESSEL_HIGH_ODD = 0.21592043;
const float BESSEL_HIGH_LOG = 1.1862717;
const float BESSEL_SPLIT = 1.4142135;
const float BESSEL_ROOT_A = -0.5;
const float BESSEL_ROOT_B = 0.37500098;
const float BESSEL_ROOT_C = -0.31250283;
const float BESSEL_ROOT_D = 0.27323663;
const float BESSEL_ROOT_E = -0.24576588;
const float BESSEL_ROOT_F = 0.23715664;
const float BESSEL_ROOT_G = -0.22318871;
const float BESSEL_LN_A = 0.5;
const float BESSEL_LN_B = -0.2500003;
const float BESSEL_LN_C = 0.1666675;
const float BESSEL_LN_D = -0.12493642;
const float BESSEL_LN_E = 0.09990236;
const float BESSEL_LN_F = -0.08700084;
const float BESSEL_LN_G = 0.07551904;
const float BESSEL_OUTER_END = 6.5;
const float BESSEL_TAIL_A = 0.785402;
const float BESSEL_TAIL_B = 2.7710798;
const float BESSEL_TAIL_C = 20.155907;
const float BESSEL_TAIL_D = -218.7877;
const float BESSEL_TAIL_E = 43648.676;
const float BESSEL_TAIL_F = -2333362.0;
const float BESSEL_TAIL_G = 69145850.0;
const float BESSEL_TAIL_H = -735768640.0;
const float BESSEL_OUTER_CENTRE = 0.03876851;
const float BESSEL_OUTER_A = 0.03654081;
const float BESSEL_OUTER_B = 1.1803682;
const float BESSEL_OUTER_C = 8.338566;
const float BESSEL_OUTER_D = 7.426099;
const float BESSEL_OUTER_E = -2785.3804;
const float BESSEL_OUTER_F = -7030.0894;
const float BESSEL_OUTER_G = 1309036.1;
const float BESSEL_OUTER_H = -8430924.0;
const float BESSEL_OUTER_I = -442043140.0;
const float BESSEL_BORDER = 4.0;
const float BESSEL_HEAD_END = 1.0;
const float BESSEL_LOG_HEAD_A = -0.01562499;
const float BESSEL_LOG_HEAD_B = 0.0017359626;
const float BESSEL_LOG_HEAD_C = -0.00022308876;
const float BESSEL_LOG_HEAD_D = 2.943114e-5;
const float BESSEL_LOG_HEAD_E = -2.9568555e-6;
const float BESSEL_LOG_FIRST_END = 1.5;
const float BESSEL_LOG_FIRST_CENTRE = 1.2500476;
const float BESSEL_LOG_FIRST_VALUE = 0.35802728;
const float BESSEL_LOG_FIRST_A = 0.52800995;
const float BESSEL_LOG_FIRST_B = 0.14940679;
const float BESSEL_LOG_FIRST_C = -0.0361158;
const float BESSEL_LOG_FIRST_D = 0.0027255923;
const float BESSEL_LOG_FIRST_E = 0.0019267182;
const float BESSEL_LOG_FIRST_F = -0.00079366803;
const float BESSEL_LOG_SECOND_END = 2.4;
const float BESSEL_LOG_SECOND_CENTRE = 1.9000068;
const float BESSEL_LOG_SECOND_VALUE = 0.7550651;
const float BESSEL_LOG_SECOND_A = 0.6806503;
const float BESSEL_LOG_SECOND_B = 0.08923973;
const float BESSEL_LOG_SECOND_C = -0.024726195;
const float BESSEL_LOG_SECOND_D = 0.0048648315;
const float BESSEL_LOG_SECOND_E = -0.00022707779;
const float BESSEL_LOG_SECOND_F = -0.00026824258;
const float BESSEL_LOG_SECOND_G = 0.000102527556;
const float BESSEL_LOG_THIRD_CENTRE = 3.2000892;
const float BESSEL_LOG_THIRD_VALUE = 1.7487875;
const float BESSEL_LOG_THIRD_A = 0.8237543;
const float BESSEL_LOG_THIRD_B = 0.032006305;
const float BESSEL_LOG_THIRD_C = -0.0075040204;
const float BESSEL_LOG_THIRD_D = 0.0017625364;
const float BESSEL_LOG_THIRD_E = -0.00036190744;
const float BESSEL_LOG_THIRD_F = 5.3291064e-5;
const float BESSEL_LOG_THIRD_G = -2.015393e-6;
const float BESSEL_LOG_TAIL_A = 0.12497927;
const float BESSEL_LOG_TAIL_B = 0.065043844;
const float BESSEL_LOG_TAIL_C = -0.039425373;
const float BESSEL_LOG_TAIL_D = 2.1019201;
const float BESSEL_LOG_TAIL_E = -19.640245;
const float BESSEL_LOG_TAIL_F = 103.07769;
const float BESSEL_LOG_TAIL_G = -247.29543;
const float BESSEL_LOG_TAIL_H = 213.7775;
const float BESSEL_RATIO_HEAD_A = -0.062499866;
const float BESSEL_RATIO_HEAD_B = 0.010414709;
const float BESSEL_RATIO_HEAD_C = -0.0017810093;
const float BESSEL_RATIO_HEAD_D = 0.00028933206;
const float BESSEL_RATIO_HEAD_E = -3.3203592e-5;
const float BESSEL_RATIO_FIRST_END = 2.0;
const float BESSEL_RATIO_FIRST_CENTRE = 1.5000024;
const float BESSEL_RATIO_FIRST_VALUE = 0.5961338;
const float BESSEL_RATIO_FIRST_A = 0.24720253;
const float BESSEL_RATIO_FIRST_B = -0.097293206;
const float BESSEL_RATIO_FIRST_C = 0.017662916;
const float BESSEL_RATIO_FIRST_D = 0.004145302;
const float BESSEL_RATIO_FIRST_E = -0.0037807873;
const float BESSEL_RATIO_FIRST_F = 0.00085296825;
const float BESSEL_RATIO_FIRST_G = 0.00014570318;
const float BESSEL_RATIO_SECOND_CENTRE = 2.999974;
const float BESSEL_RATIO_SECOND_VALUE = 0.8099834;
const float BESSEL_RATIO_SECOND_A = 0.073930226;
const float BESSEL_RATIO_SECOND_B = -0.027204137;
const float BESSEL_RATIO_SECOND_C = 0.008627776;
const float BESSEL_RATIO_SECOND_D = -0.002148176;
const float BESSEL_RATIO_SECOND_E = 0.00034924946;
const float BESSEL_RATIO_SECOND_F = 3.8275207e-6;
const float BESSEL_RATIO_SECOND_G = -3.1629304e-5;
const float BESSEL_RATIO_SECOND_H = 1.1114423e-5;
const float BESSEL_RATIO_TAIL_A = 0.5000091;
const float BESSEL_RATIO_TAIL_B = 0.12332922;
const float BESSEL_RATIO_TAIL_C = 0.22921288;
const float BESSEL_RATIO_TAIL_D = -2.9445055;
const float BESSEL_RATIO_TAIL_E = 52.64979;
const float BESSEL_RATIO_TAIL_F = -504.88522;
const float BESSEL_RATIO_TAIL_G = 2858.2017;
const float BESSEL_RATIO_TAIL_H = -8947.848;
const float BESSEL_RATIO_TAIL_I = 14135.413;
const float BESSEL_RATIO_TAIL_J = -8708.469;
const float BESSEL_HALF_LN_TWO = 0.3465736;
const float FADDEEVA_BORDER = 4.0;
const float FADDEEVA_CENTRE = 2.0;
const float FADDEEVA_NEAR_POLE = 2.0;
const float FADDEEVA_FAR_POLE = 3.0;
const float FADDEEVA_AT_CENTRE = 0.25539568;
const float FADDEEVA_COARSE_POLE = 2.5;
const float FADDEEVA_NEAR_A = -0.106796466;
const float FADDEEVA_NEAR_B = 0.16721098;
const float FADDEEVA_NEAR_C = -0.080159344;
const float FADDEEVA_NEAR_D = 0.020677371;
const float FADDEEVA_NEAR_E = 0.0008148871;
const float FADDEEVA_NEAR_F = -0.0019636583;
const float FADDEEVA_NEAR_G = -3.7765014e-5;
const float FADDEEVA_NEAR_H = 0.00025102615;
const float FADDEEVA_NEAR_I = 2.6974167e-5;
const float FADDEEVA_NEAR_J = -4.1503077e-5;
const float FADDEEVA_NEAR_K = -1.6607877e-5;
const float FADDEEVA_NEAR_L = 2.7369815e-6;
const float FADDEEVA_NEAR_M = 4.669254e-6;
const float FADDEEVA_NEAR_N = 1.8796283e-6;
const float FADDEEVA_NEAR_O = 3.2530315e-7;
const float FADDEEVA_FAR_A = -2.3661494;
const float FADDEEVA_FAR_B = 4.529406;
const float FADDEEVA_FAR_C = -5.0040684;
const float FADDEEVA_FAR_D = 3.61526;
const float FADDEEVA_FAR_E = -1.5806278;
const float FADDEEVA_FAR_F = 0.20925954;
const float FADDEEVA_FAR_G = 0.1795237;
const float FADDEEVA_FAR_H = -0.075746216;
const float FADDEEVA_FAR_I = -0.03169403;
const float FADDEEVA_FAR_J = 0.03326945;
const float FADDEEVA_FAR_K = -0.01147905;
const float FADDEEVA_FAR_L = 0.008491194;
const float FADDEEVA_FAR_M = -0.009628222;
const float FADDEEVA_FAR_N = 0.0053928373;
const float FADDEEVA_FAR_O = -0.0011878925;
const float FADDEEVA_COARSE_A = 1.0540318;
const float FADDEEVA_COARSE_B = 0.80465186;
const float FADDEEVA_COARSE_C = 0.4539141;
const float FADDEEVA_COARSE_D = 0.17125115;
const float FADDEEVA_COARSE_E = 0.028361548;
const float FADDEEVA_COARSE_F = -0.00839299;
const float FADDEEVA_COARSE_G = -0.004818751;
const float FADDEEVA_COARSE_H = 0.00043853337;
const float FADDEEVA_COARSE_I = 0.0006994823;
const float FADDEEVA_COARSE_J = -6.722101e-5;
const float FADDEEVA_COARSE_K = -0.00012964732;
const float FADDEEVA_SQUARE_LIMIT = 1.1529215e18;
const float FADDEEVA_SHRINK = 1.3552527e-20;
const float INFINITE_LIMIT = 3e38;
const float INVERSE_ROOT_PI = 0.5641896;
const float EXPONENT_LOWEST = -110.0;
const float EXPONENT_HIGHEST = 176.0;
const float GRID_UPPER_LIMIT = 512.0;
const float GRID_LOWER_LIMIT = 0.0001;
const float ERF_END_LARGEST = 12.0;
const float ERF_SHORT = 0.5;
const float ERF_SHORT_SQUARE = 0.0625;
const float TWO_INVERSE_ROOT_PI = 1.1283792;

// Returns the value of an odd function at x from its `value` at |x|, the sign of a zero included.
float odd_continuation(float x, float value) {
    return uintBitsToFloat((floatBitsToUint(value) ^ (floatBitsToUint(x) & 2147483648u)));
}

// Returns x reduced by half turns, for x in radians.
//
// The error of the rest is at most 1e-7 for |x| to 1e4, and 2^-24 |x| beyond.
HalfTurns reduce_half_turns(float x_1) {
    float n = roundEven((x_1 * INVERSE_PI));
    float rest_4 = ((x_1 - (n * PI_HIGH)) - (n * PI_LOW));
    float pairs = (n * 0.5);
    float parity = (1.0 - (4.0 * abs((pairs - roundEven(pairs)))));
    return HalfTurns(rest_4, parity);
}

// Returns the sine and cosine of r for r within a quarter turn of 0, to 1e-7; the sine keeps its
// relative accuracy.
SineCosine sine_cosine_near(float r) {
    float u = (r * r);
    float s_1 = (SINE_A + (u * (SINE_B + (u * (SINE_C + (u * SINE_D))))));
    float c = (COSINE_A + (u * (COSINE_B + (u * (COSINE_C + (u * COSINE_D))))));
    return SineCosine((r + (r * (u * s_1))), (1.0 - (u * (0.5 - (u * c)))));
}

// Returns the sine and cosine of r for r within a quarter turn of 0, to 5e-6.
SineCosine sine_cosine_near_medium(float r_1) {
    float u_1 = (r_1 * r_1);
    float s_2 = (SINE_MEDIUM_A + (u_1 * (SINE_MEDIUM_B + (u_1 * SINE_MEDIUM_C))));
    float c_1 = (COSINE_MEDIUM_A + (u_1 * (COSINE_MEDIUM_B + (u_1 * COSINE_MEDIUM_C))));
    return SineCosine((r_1 + (r_1 * (u_1 * s_2))), (1.0 - (u_1 * (0.5 - (u_1 * c_1)))));
}

// Returns the sine and cosine of r for r within a quarter turn of 0, to 6e-4.
SineCosine sine_cosine_near_coarse(float r_2) {
    float u_2 = (r_2 * r_2);
    float s_3 = (SINE_COARSE_A + (u_2 * SINE_COARSE_B));
    float c_2 = (COSINE_COARSE_A + (u_2 * COSINE_COARSE_B));
    return SineCosine((r_2 + (r_2 * (u_2 * s_3))), (1.0 - (u_2 * (0.5 - (u_2 * c_2)))));
}

// Returns the sine and cosine of x in radians, to 2.5e-7 for |x| to 1e4.
//
// Beyond, the phase loses digits in proportion; both stay within 1 for any finite x.
SineCosine sine_cosine(float x_2) {
    HalfTurns _e1 = reduce_half_turns(x_2);
    SineCosine _e7 = sine_cosine_near(min(max(_e1.rest, -1.75), REST_LIMIT));
    return SineCosine(((x_2 == 0.0) ? x_2 : (_e1.parity * _e7.sine)), (_e1.parity * _e7.cosine));
}

// Returns the sine and cosine of a whole number of turns and a part: of 2 pi `turns`.
//
// Exact reduction for |turns| to 1.7e38: a caller that knows its phase in turns loses nothing to
// the size of the phase.
SineCosine sine_cosine_turns(float turns) {
    float whole = roundEven((turns + turns));
    float pairs_1 = (whole * 0.5);
    SineCosine _e8 = sine_cosine_near((TWO_PI * (turns - pairs_1)));
    float parity_1 = (1.0 - (4.0 * abs((pairs_1 - roundEven(pairs_1)))));
    return SineCosine((parity_1 * _e8.sine), (parity_1 * _e8.cosine));
}

// Returns e to the x, to 2 units of the last place for x from -87 to 88.
//
// Below, the result falls to 0 by way of subnormal numbers, which a GPU may flush; above 88.7 it
// stays at e^88.7.
float exponential(float x_3) {
    float bounded = min(max(x_3, -104.0), 88.7);
    float n_1 = roundEven((bounded * LOG_TWO_E));
    float r_3 = ((bounded - (n_1 * LN_TWO_HIGH)) - (n_1 * LN_TWO_LOW));
    float e = (EXPONENTIAL_A + (r_3 * (EXPONENTIAL_B + (r_3 * (EXPONENTIAL_C + (r_3 * (EXPONENTIAL_D + (r_3 * EXPONENTIAL_E))))))));
    float value_1 = (1.0 + (r_3 * (1.0 + (r_3 * e))));
    float halved_2 = roundEven((n_1 * 0.5));
    float first_6 = uintBitsToFloat((floatBitsToUint((halved_2 + EXPONENT_BIAS)) << 23u));
    float second = uintBitsToFloat((floatBitsToUint(((n_1 - halved_2) + EXPONENT_BIAS)) << 23u));
    return ((value_1 * first_6) * second);
}

// Returns Si(x), the integral of sin t / t from 0 to x (radians), to f32 grade.
//
// Any x; odd. VWH18 Eq. 28.
float sine_integral(float x_4) {
    float y_5 = abs(x_4);
    float u_3 = (y_5 * y_5);
    float q_8 = (SI_HEAD_A + (u_3 * (SI_HEAD_B + (u_3 * (SI_HEAD_C + (u_3 * (SI_HEAD_D + (u_3 * (SI_HEAD_E + (u_3 * SI_HEAD_F))))))))));
    float head = (y_5 + (y_5 * (u_3 * q_8)));
    float bounded_1 = min(y_5, PHASE_LIMIT);
    HalfTurns _e24 = reduce_half_turns(bounded_1);
    SineCosine _e26 = sine_cosine_near(_e24.rest);
    float s_4 = min(u_3, SQUARE_LIMIT);
    float n_2 = ((s_4 * ((s_4 * ((s_4 * (s_4 + SI_F_A)) + SI_F_B)) + SI_F_C)) + SI_F_D);
    float d = ((s_4 * ((s_4 * ((s_4 * (s_4 + SI_D_A)) + SI_D_B)) + SI_D_C)) + SI_D_D);
    float m_1 = ((s_4 * ((s_4 * (s_4 + SI_G_A)) + SI_G_B)) + SI_G_C);
    float wave = (((_e26.cosine * n_2) + ((_e26.sine * bounded_1) * m_1)) / (bounded_1 * d));
    float tail = (HALF_PI - (_e24.parity * wave));
    float value_2 = ((y_5 < SI_BORDER) ? head : tail);
    float finite = ((y_5 >= PHASE_LIMIT) ? HALF_PI : value_2);
    float _e78 = odd_continuation(x_4, finite);
    return _e78;
}

// Returns Si(x) to 1e-5 absolute. Any x; odd. VWH18 Eq. 28.
float sine_integral_medium(float x_5) {
    float y_6 = abs(x_5);
    float u_4 = (y_6 * y_6);
    float q_9 = (SI_MEDIUM_HEAD_A + (u_4 * (SI_MEDIUM_HEAD_B + (u_4 * (SI_MEDIUM_HEAD_C + (u_4 * (SI_MEDIUM_HEAD_D + (u_4 * SI_MEDIUM_HEAD_E))))))));
    float head_1 = (y_6 + (y_6 * (u_4 * q_9)));
    float bounded_2 = min(y_6, PHASE_LIMIT);
    HalfTurns _e21 = reduce_half_turns(bounded_2);
    SineCosine _e23 = sine_cosine_near_medium(_e21.rest);
    float s_5 = min(u_4, SQUARE_LIMIT);
    float n_3 = ((s_5 * (s_5 + SI_MEDIUM_F_A)) + SI_MEDIUM_F_B);
    float d_1 = ((s_5 * (s_5 + SI_MEDIUM_D_A)) + SI_MEDIUM_D_B);
    float m_2 = (s_5 + SI_MEDIUM_G_A);
    float wave_1 = (((_e23.cosine * n_3) + ((_e23.sine * bounded_2) * m_2)) / (bounded_2 * d_1));
    float tail_1 = (HALF_PI - (_e21.parity * wave_1));
    float value_3 = ((y_6 < SI_MEDIUM_BORDER) ? head_1 : tail_1);
    float _e53 = odd_continuation(x_5, value_3);
    return _e53;
}

// Returns Si(x) to 4e-4 absolute. Any x; odd. VWH18 Eq. 28.
float sine_integral_coarse(float x_6) {
    float y_7 = abs(x_6);
    float u_5 = (y_7 * y_7);
    float q_10 = (SI_COARSE_HEAD_A + (u_5 * (SI_COARSE_HEAD_B + (u_5 * (SI_COARSE_HEAD_C + (u_5 * SI_COARSE_HEAD_D))))));
    float head_2 = (y_7 + (y_7 * (u_5 * q_10)));
    float bounded_3 = min(y_7, PHASE_LIMIT);
    HalfTurns _e18 = reduce_half_turns(bounded_3);
    SineCosine _e20 = sine_cosine_near_coarse(_e18.rest);
    float s_6 = min(u_5, SQUARE_LIMIT);
    float wave_2 = (((_e20.cosine * (s_6 + SI_COARSE_F_A)) + (_e20.sine * bounded_3)) / (bounded_3 * (s_6 + SI_COARSE_D_A)));
    float tail_2 = (HALF_PI - (_e18.parity * wave_2));
    float value_4 = ((y_7 < SI_COARSE_BORDER) ? head_2 : tail_2);
    float _e41 = odd_continuation(x_6, value_4);
    return _e41;
}

// Returns Si(x) by the fit that VWH18 publishes, Eq. 29, to 0.051 absolute.
//
// Kept to compare with: its differences have the wrong sign over a quarter of the axis.
float sine_integral_velinov(float x_7) {
    float y_8 = abs(x_7);
    SineCosine _e4 = sine_cosine(min(y_8, PHASE_LIMIT));
    float _e11 = exponential((2.0 * min(y_8, 20.0)));
    float sigmoid = (1.0 - (2.0 / (_e11 + 1.0)));
    float offset = (y_8 - VELINOV_OFFSET);
    float value_5 = (((HALF_PI * sigmoid) - ((VELINOV_BUMP * y_8) / (1.0 + (offset * offset)))) + ((1.0 - _e4.cosine) / (1.0 + y_8)));
    float _e34 = odd_continuation(x_7, value_5);
    return _e34;
}

// Returns the ends of the arc from q0 to q1.
ArcEnds arc_ends(float first, float last) {
    bool local = false;
    float a_2 = abs(first);
    float b_4 = abs(last);
    bool swap = (b_4 < a_2);
    if ((min(first, last) < 0.0)) {
        local = (max(first, last) > 0.0);
    } else {
        local = false;
    }
    bool _e16 = local;
    return ArcEnds((swap ? b_4 : a_2), (swap ? a_2 : b_4), _e16);
}

// Returns the two nodes m - s and m + s of the Gauss sum, sin^2 t / t^2 each, added.
float arc_node_pair(SineCosine middle, SineCosine node, float m, float s) {
    float even = (middle.sine * node.cosine);
    float odd = (middle.cosine * node.sine);
    float right = ((even + odd) / (m + s));
    float left = ((even - odd) / (m - s));
    return ((right * right) + (left * left));
}

// Returns the phase of the middle of a short arc, within a quarter turn of 0.
float arc_middle_phase(float rest, float halved) {
    float phase_3 = (rest + halved);
    return ((phase_3 > HALF_PI) ? (phase_3 - ARC_PI) : phase_3);
}

// Returns one of the three cases of an arc of a given extent from its parts.
//
// `near_line` and `far_line` are H at the ends where they are below the border, `near_wave` and
// `far_wave` what the
// tails have beside 1/(2q), `gauss_sum` the Gauss sum.
float arc_join(ArcEnds ends, float extent, float border, float near_line, float far_line, float near_wave, float far_wave, float gauss_sum) {
    bool local_1 = false;
    float near_inverse = (0.5 / ends.near);
    float far_inverse = (0.5 / ends.far);
    float near_tail = (HALF_PI - (near_inverse + near_wave));
    float far_tail = (HALF_PI - (far_inverse + far_wave));
    float near_value = ((ends.near < border) ? near_line : near_tail);
    float far_value = ((ends.far < border) ? far_line : far_tail);
    float lead = ((ends.far > ARC_INFINITE) ? near_inverse : ((extent * far_inverse) * (near_inverse + near_inverse)));
    float tails = (lead + (near_wave - far_wave));
    float between = ((ends.near >= border) ? tails : (far_value - near_value));
    if ((extent < ARC_SHORT)) {
        local_1 = (ends.near >= ARC_TINY);
    } else {
        local_1 = false;
    }
    bool _e47 = local_1;
    float one_sided = (_e47 ? gauss_sum : between);
    float value_6 = (ends.straddles ? (far_value + near_value) : one_sided);
    return ((value_6 < 0.0) ? 0.0 : value_6);
}

// Returns H(2q) for q below the border, to f32 grade.
float arc_head(float q) {
    float u_6 = (q * q);
    float p = (ARC_HEAD_A + (u_6 * (ARC_HEAD_B + (u_6 * (ARC_HEAD_C + (u_6 * (ARC_HEAD_D + (u_6 * (ARC_HEAD_E + (u_6 * ARC_HEAD_F))))))))));
    return (q + (q * (u_6 * p)));
}

// Returns pi/2 - H(2q) - 1/(2q) for q above the border, from the phase of q reduced by half turns,
// to f32 grade.
float arc_wave(float q_1, SineCosine phase) {
    float v_3 = (0.5 / q_1);
    float w = (v_3 * v_3);
    float k = (w * (ARC_K_A + (w * (ARC_K_B + (w * (ARC_K_C + (w * (ARC_K_D + (w * ARC_K_E)))))))));
    float d_2 = (1.0 + (w * (ARC_D_A + (w * (ARC_D_B + (w * (ARC_D_C + (w * (ARC_D_D + (w * ARC_D_E))))))))));
    float m_3 = (1.0 + (w * (ARC_G_A + (w * (ARC_G_B + (w * (ARC_G_C + (w * ARC_G_D))))))));
    float twice = (phase.sine + phase.sine);
    float double_sine = (twice * phase.cosine);
    float double_cosine = (1.0 - (twice * phase.sine));
    return (((double_sine * (w * m_3)) - (double_cosine * (v_3 * k))) / d_2);
}

// Returns the Gauss sum over a short arc that begins at q with the phase `rest`, to f32 grade.
float arc_short(float q_2, float extent_1, float rest_1) {
    float halved_3 = (0.5 * extent_1);
    float m_4 = (q_2 + halved_3);
    float _e6 = arc_middle_phase(rest_1, halved_3);
    SineCosine _e7 = sine_cosine_near(_e6);
    float inner = (halved_3 * GAUSS_INNER);
    float outer = (halved_3 * GAUSS_OUTER);
    SineCosine _e12 = sine_cosine_near(inner);
    float _e13 = arc_node_pair(_e7, _e12, m_4, inner);
    SineCosine _e14 = sine_cosine_near(outer);
    float _e15 = arc_node_pair(_e7, _e14, m_4, outer);
    return (halved_3 * ((GAUSS_INNER_WEIGHT * _e13) + (GAUSS_OUTER_WEIGHT * _e15)));
}

// Returns the arc from its ends, its extent and the phases of its ends reduced by half turns, to
// f32 grade.
float arc_of_phases(ArcEnds ends_1, float extent_2, float near_rest, float far_rest) {
    SineCosine _e5 = sine_cosine_near(near_rest);
    float _e6 = arc_wave(ends_1.near, _e5);
    SineCosine _e8 = sine_cosine_near(far_rest);
    float _e9 = arc_wave(ends_1.far, _e8);
    float _e11 = arc_short(ends_1.near, extent_2, near_rest);
    float _e14 = arc_head(ends_1.near);
    float _e16 = arc_head(ends_1.far);
    float _e17 = arc_join(ends_1, extent_2, ARC_BORDER, _e14, _e16, _e6, _e9, _e11);
    return _e17;
}

// Returns the integral of (sin t / t)^2 from q0 to q1 (radians), to f32 grade.
//
// Never negative for q0 <= q1, antisymmetric in its bounds, even in their signs. The phase is exact
// to 1e-7 for
// |q| to 1e4. VWH18 Eq. 27.
float sinc_squared_integral(float first_1, float last_1) {
    ArcEnds _e2 = arc_ends(first_1, last_1);
    HalfTurns _e6 = reduce_half_turns(min(_e2.near, ARC_PHASE_LIMIT));
    HalfTurns _e10 = reduce_half_turns(min(_e2.far, ARC_PHASE_LIMIT));
    float _e16 = arc_of_phases(_e2, (_e2.far - _e2.near), _e6.rest, _e10.rest);
    float signed = ((last_1 < first_1) ? -(_e16) : _e16);
    return ((first_1 == last_1) ? 0.0 : signed);
}

// Returns the distance of the product x y from the nearest integer, exact to 3e-8 for 0 <= x < 256
// and |y| <= 2.
//
// Both factors are cut so that the product of their leading parts fits 24 bits.
float product_fraction(float x_8, float y) {
    float x_high = (floor((x_8 * 16.0)) * 0.0625);
    float y_high = (floor((y * 2048.0)) * 0.00048828125);
    float product = (x_high * y_high);
    float rest_5 = ((x_high * (y - y_high)) + ((x_8 - x_high) * y));
    float leading_1 = min((product - roundEven(product)), 0.5);
    float fraction = (leading_1 + min(rest_5, 0.5));
    return (fraction - roundEven(fraction));
}

// Returns the integral of (sin t / t)^2 over t = pi (W/lambda) xi between two direction cosines, to
// f32 grade.
//
// `width` is W/lambda, from 0 to 256, dimensionless; `first` and `last` are direction cosines from
// -2 to 2. The phase
// is reduced in turns before it is rounded, so that wide scratches lose nothing. Wider scratches
// lose digits in
// proportion; a negative width has no meaning. VWH18 Eq. 27.
float sinc_squared_integral_turns(float width, float first_2, float last_2) {
    ArcEnds _e3 = arc_ends(first_2, last_2);
    float scale = (ARC_PI * width);
    ArcEnds ends_2 = ArcEnds((scale * _e3.near), (scale * _e3.far), _e3.straddles);
    float _e14 = product_fraction(width, _e3.near);
    float near_rest_1 = (ARC_PI * _e14);
    float _e18 = product_fraction(width, _e3.far);
    float far_rest_1 = (ARC_PI * _e18);
    float _e24 = arc_of_phases(ends_2, (scale * (_e3.far - _e3.near)), near_rest_1, far_rest_1);
    float signed_1 = ((last_2 < first_2) ? -(_e24) : _e24);
    return ((first_2 == last_2) ? 0.0 : signed_1);
}

// Returns H(2q) for q below the border, to 1e-8.
float arc_head_medium(float q_3) {
    float u_7 = (q_3 * q_3);
    float p_1 = (ARC_MEDIUM_HEAD_A + (u_7 * (ARC_MEDIUM_HEAD_B + (u_7 * (ARC_MEDIUM_HEAD_C + (u_7 * (ARC_MEDIUM_HEAD_D + (u_7 * ARC_MEDIUM_HEAD_E))))))));
    return (q_3 + (q_3 * (u_7 * p_1)));
}

// Returns pi/2 - H(2q) - 1/(2q) for q above the border, to about 1e-6 of 1/(2q).
float arc_wave_medium(float q_4, SineCosine phase_1) {
    float v_4 = (0.5 / q_4);
    float w_1 = (v_4 * v_4);
    float k_1 = (w_1 * (ARC_MEDIUM_K_A + (w_1 * (ARC_MEDIUM_K_B + (w_1 * (ARC_MEDIUM_K_C + (w_1 * ARC_MEDIUM_K_D)))))));
    float d_3 = (1.0 + (w_1 * (ARC_MEDIUM_D_A + (w_1 * (ARC_MEDIUM_D_B + (w_1 * (ARC_MEDIUM_D_C + (w_1 * ARC_MEDIUM_D_D))))))));
    float m_5 = (1.0 + (w_1 * (ARC_MEDIUM_G_A + (w_1 * (ARC_MEDIUM_G_B + (w_1 * ARC_MEDIUM_G_C))))));
    float twice_1 = (phase_1.sine + phase_1.sine);
    float double_sine_1 = (twice_1 * phase_1.cosine);
    float double_cosine_1 = (1.0 - (twice_1 * phase_1.sine));
    return (((double_sine_1 * (w_1 * m_5)) - (double_cosine_1 * (v_4 * k_1))) / d_3);
}

// Returns the arc of [`sinc_squared_integral`] to 5e-6 absolute.
float sinc_squared_integral_medium(float first_3, float last_3) {
    ArcEnds _e2 = arc_ends(first_3, last_3);
    float extent_3 = (_e2.far - _e2.near);
    HalfTurns _e9 = reduce_half_turns(min(_e2.near, ARC_PHASE_LIMIT));
    HalfTurns _e13 = reduce_half_turns(min(_e2.far, ARC_PHASE_LIMIT));
    SineCosine _e16 = sine_cosine_near_medium(_e9.rest);
    float _e17 = arc_wave_medium(_e2.near, _e16);
    SineCosine _e20 = sine_cosine_near_medium(_e13.rest);
    float _e21 = arc_wave_medium(_e2.far, _e20);
    float halved_4 = (0.5 * extent_3);
    float m_6 = (_e2.near + halved_4);
    float _e27 = arc_middle_phase(_e9.rest, halved_4);
    SineCosine _e28 = sine_cosine_near_medium(_e27);
    float inner_1 = (halved_4 * GAUSS_INNER);
    float outer_1 = (halved_4 * GAUSS_OUTER);
    SineCosine _e33 = sine_cosine_near_medium(inner_1);
    float _e34 = arc_node_pair(_e28, _e33, m_6, inner_1);
    SineCosine _e35 = sine_cosine_near_medium(outer_1);
    float _e36 = arc_node_pair(_e28, _e35, m_6, outer_1);
    float gauss_sum_1 = (halved_4 * ((GAUSS_INNER_WEIGHT * _e34) + (GAUSS_OUTER_WEIGHT * _e36)));
    float _e45 = arc_head_medium(_e2.near);
    float _e47 = arc_head_medium(_e2.far);
    float _e48 = arc_join(_e2, extent_3, ARC_MEDIUM_BORDER, _e45, _e47, _e17, _e21, gauss_sum_1);
    float signed_2 = ((last_3 < first_3) ? -(_e48) : _e48);
    return ((first_3 == last_3) ? 0.0 : signed_2);
}

// Returns H(2q) for q below the border, to 6e-6.
float arc_head_coarse(float q_5) {
    float u_8 = (q_5 * q_5);
    float p_2 = (ARC_COARSE_HEAD_A + (u_8 * (ARC_COARSE_HEAD_B + (u_8 * (ARC_COARSE_HEAD_C + (u_8 * ARC_COARSE_HEAD_D))))));
    return (q_5 + (q_5 * (u_8 * p_2)));
}

// Returns pi/2 - H(2q) - 1/(2q) for q above the border, to about 3e-4 of 1/(2q).
float arc_wave_coarse(float q_6, SineCosine phase_2) {
    float v_5 = (0.5 / q_6);
    float w_2 = (v_5 * v_5);
    float k_2 = (w_2 * (ARC_COARSE_K_A + (w_2 * (ARC_COARSE_K_B + (w_2 * ARC_COARSE_K_C)))));
    float d_4 = (1.0 + (w_2 * (ARC_COARSE_D_A + (w_2 * (ARC_COARSE_D_B + (w_2 * ARC_COARSE_D_C))))));
    float m_7 = (1.0 + (w_2 * (ARC_COARSE_G_A + (w_2 * ARC_COARSE_G_B))));
    float twice_2 = (phase_2.sine + phase_2.sine);
    float double_sine_2 = (twice_2 * phase_2.cosine);
    float double_cosine_2 = (1.0 - (twice_2 * phase_2.sine));
    return (((double_sine_2 * (w_2 * m_7)) - (double_cosine_2 * (v_5 * k_2))) / d_4);
}

// Returns the arc of [`sinc_squared_integral`] to 4e-4 absolute.
float sinc_squared_integral_coarse(float first_4, float last_4) {
    ArcEnds _e2 = arc_ends(first_4, last_4);
    float extent_4 = (_e2.far - _e2.near);
    HalfTurns _e9 = reduce_half_turns(min(_e2.near, ARC_PHASE_LIMIT));
    HalfTurns _e13 = reduce_half_turns(min(_e2.far, ARC_PHASE_LIMIT));
    SineCosine _e16 = sine_cosine_near_coarse(_e9.rest);
    float _e17 = arc_wave_coarse(_e2.near, _e16);
    SineCosine _e20 = sine_cosine_near_coarse(_e13.rest);
    float _e21 = arc_wave_coarse(_e2.far, _e20);
    float halved_5 = (0.5 * extent_4);
    float m_8 = (_e2.near + halved_5);
    float _e27 = arc_middle_phase(_e9.rest, halved_5);
    SineCosine _e28 = sine_cosine_near_coarse(_e27);
    float outer_2 = (halved_5 * GAUSS_THREE);
    SineCosine _e31 = sine_cosine_near_coarse(outer_2);
    float _e32 = arc_node_pair(_e28, _e31, m_8, outer_2);
    float centre = (_e28.sine / m_8);
    float gauss_sum_2 = (halved_5 * ((GAUSS_THREE_OUTER_WEIGHT * _e32) + ((GAUSS_THREE_MIDDLE_WEIGHT * centre) * centre)));
    float _e44 = arc_head_coarse(_e2.near);
    float _e46 = arc_head_coarse(_e2.far);
    float _e47 = arc_join(_e2, extent_4, ARC_COARSE_BORDER, _e44, _e46, _e17, _e21, gauss_sum_2);
    float signed_3 = ((last_4 < first_4) ? -(_e47) : _e47);
    return ((first_4 == last_4) ? 0.0 : signed_3);
}

// Returns the bracket of VWH18 Eq. 27, Si(2q) - sin^2 q / q with the fit of Eq. 29, 0 at q = 0.
float arc_antiderivative_velinov(float q_7) {
    SineCosine _e1 = sine_cosine(q_7);
    float sine = _e1.sine;
    float square = ((q_7 == 0.0) ? 0.0 : ((sine * sine) / q_7));
    float _e10 = sine_integral_velinov((q_7 + q_7));
    return (_e10 - square);
}

// Returns the arc by VWH18 Eq. 27 with the fit of Eq. 29.
//
// Kept to compare with: negative for many arcs that do not contain the peak.
float sinc_squared_integral_velinov(float first_5, float last_5) {
    float _e2 = arc_antiderivative_velinov(last_5);
    float _e3 = arc_antiderivative_velinov(first_5);
    return (_e2 - _e3);
}

// Returns x >= 1 taken apart.
BesselPowers bessel_powers(float x_9) {
    uint bits = floatBitsToUint(x_9);
    float mantissa = uintBitsToFloat(((bits & 8388607u) | 1065353216u));
    bool high = (mantissa >= BESSEL_SPLIT);
    float centre_1 = (high ? BESSEL_HIGH_CENTRE : BESSEL_LOW_CENTRE);
    float inverse_ = (high ? BESSEL_HIGH_INVERSE : BESSEL_LOW_INVERSE);
    return BesselPowers(((mantissa - centre_1) * inverse_), high, ((bits >> 23u) & 255u));
}

// Returns e to the -|x| times I0(x), to 1 unit of the last place.
//
// Any x; even; 1 at 0, falls as 1/sqrt(2 pi |x|), 0 at infinity.
float bessel_i0_scaled(float x_10) {
    float y_9 = abs(x_10);
    float near_y = min(y_9, BESSEL_FOURTH_END);
    bool second_1 = (near_y >= BESSEL_FIRST_END);
    bool third = (near_y >= BESSEL_SECOND_END);
    bool fourth = (near_y >= BESSEL_THIRD_END);
    float centre_low = (second_1 ? BESSEL_SECOND_CENTRE : BESSEL_FIRST_CENTRE);
    float centre_high = (fourth ? BESSEL_FOURTH_CENTRE : BESSEL_THIRD_CENTRE);
    float centre_2 = (third ? centre_high : centre_low);
    float value_low = (second_1 ? BESSEL_SECOND_VALUE : BESSEL_FIRST_VALUE);
    float value_high = (fourth ? BESSEL_FOURTH_VALUE : BESSEL_THIRD_VALUE);
    float value_7 = (third ? value_high : value_low);
    float pa_low = (second_1 ? BESSEL_SECOND_A : BESSEL_FIRST_A);
    float pa_high = (fourth ? BESSEL_FOURTH_A : BESSEL_THIRD_A);
    float pa = (third ? pa_high : pa_low);
    float pb_low = (second_1 ? BESSEL_SECOND_B : BESSEL_FIRST_B);
    float pb_high = (fourth ? BESSEL_FOURTH_B : BESSEL_THIRD_B);
    float pb = (third ? pb_high : pb_low);
    float pc_low = (second_1 ? BESSEL_SECOND_C : BESSEL_FIRST_C);
    float pc_high = (fourth ? BESSEL_FOURTH_C : BESSEL_THIRD_C);
    float pc = (third ? pc_high : pc_low);
    float pd_low = (second_1 ? BESSEL_SECOND_D : BESSEL_FIRST_D);
    float pd_high = (fourth ? BESSEL_FOURTH_D : BESSEL_THIRD_D);
    float pd = (third ? pd_high : pd_low);
    float pe_low = (second_1 ? BESSEL_SECOND_E : BESSEL_FIRST_E);
    float pe_high = (fourth ? BESSEL_FOURTH_E : BESSEL_THIRD_E);
    float pe = (third ? pe_high : pe_low);
    float pf_low = (second_1 ? BESSEL_SECOND_F : BESSEL_FIRST_F);
    float pf_high = (fourth ? BESSEL_FOURTH_F : BESSEL_THIRD_F);
    float pf = (third ? pf_high : pf_low);
    float pg_low = (second_1 ? BESSEL_SECOND_G : BESSEL_FIRST_G);
    float pg_high = (fourth ? BESSEL_FOURTH_G : BESSEL_THIRD_G);
    float pg = (third ? pg_high : pg_low);
    float ph = (fourth ? BESSEL_FOURTH_H : 0.0);
    float pi = (fourth ? BESSEL_FOURTH_I : 0.0);
    float d_5 = (near_y - centre_2);
    float upper = (pd + (d_5 * (pe + (d_5 * (pf + (d_5 * (pg + (d_5 * (ph + (d_5 * pi))))))))));
    float near_1 = (value_7 + (d_5 * (pa + (d_5 * (pb + (d_5 * (pc + (d_5 * upper))))))));
    BesselPowers _e100 = bessel_powers(max(y_9, BESSEL_FOURTH_END));
    bool odd_1 = ((_e100.exponent & 1u) == 0u);
    float low_root = (odd_1 ? BESSEL_LOW_ODD : BESSEL_LOW_EVEN);
    float high_root = (odd_1 ? BESSEL_HIGH_ODD : BESSEL_HIGH_EVEN);
    float scale_1 = uintBitsToFloat(((191u - ((_e100.exponent + 1u) >> 1u)) << 23u));
    float root = ((_e100.high ? high_root : low_root) * scale_1);
    float t = _e100.rest;
    float upper_root = (BESSEL_ROOT_E + (t * (BESSEL_ROOT_F + (t * BESSEL_ROOT_G))));
    float bend = (BESSEL_ROOT_A + (t * (BESSEL_ROOT_B + (t * (BESSEL_ROOT_C + (t * (BESSEL_ROOT_D + (t * upper_root))))))));
    float q_11 = (t * bend);
    float whole_root = (root + (root * q_11));
    float v_6 = (whole_root * whole_root);
    bool tail_3 = (y_9 >= BESSEL_OUTER_END);
    float w_3 = (v_6 - (tail_3 ? 0.0 : BESSEL_OUTER_CENTRE));
    float ga = (tail_3 ? 0.0 : BESSEL_OUTER_A);
    float gb = (tail_3 ? BESSEL_TAIL_A : BESSEL_OUTER_B);
    float gc = (tail_3 ? BESSEL_TAIL_B : BESSEL_OUTER_C);
    float gd = (tail_3 ? BESSEL_TAIL_C : BESSEL_OUTER_D);
    float ge = (tail_3 ? BESSEL_TAIL_D : BESSEL_OUTER_E);
    float gf = (tail_3 ? BESSEL_TAIL_E : BESSEL_OUTER_F);
    float gg = (tail_3 ? BESSEL_TAIL_F : BESSEL_OUTER_G);
    float gh = (tail_3 ? BESSEL_TAIL_G : BESSEL_OUTER_H);
    float gi = (tail_3 ? BESSEL_TAIL_H : BESSEL_OUTER_I);
    float upper_growth = (ge + (w_3 * (gf + (w_3 * (gg + (w_3 * (gh + (w_3 * gi))))))));
    float growth = (ga + (w_3 * (gb + (w_3 * (gc + (w_3 * (gd + (w_3 * upper_growth))))))));
    float far = (root + (root * (q_11 + (growth + (q_11 * growth)))));
    float finite_1 = ((y_9 >= BESSEL_FOURTH_END) ? far : near_1);
    return ((floatBitsToUint(y_9) == 2139095040u) ? 0.0 : finite_1);
}

// Returns ln I0(x), to 2 units of the last place.
//
// Any x; even; x^2/4 near 0, |x| - ln(2 pi |x|)/2 far from it.
float log_bessel_izero(float x_11) {
    float y_10 = abs(x_11);
    float bounded_4 = min(y_10, BESSEL_HEAD_END);
    float u_9 = (bounded_4 * bounded_4);
    float bend_1 = (BESSEL_LOG_HEAD_A + (u_9 * (BESSEL_LOG_HEAD_B + (u_9 * (BESSEL_LOG_HEAD_C + (u_9 * (BESSEL_LOG_HEAD_D + (u_9 * BESSEL_LOG_HEAD_E))))))));
    float head_3 = (u_9 * (0.25 + (u_9 * bend_1)));
    float middle_y = min(y_10, BESSEL_BORDER);
    bool second_2 = (middle_y >= BESSEL_LOG_FIRST_END);
    bool third_1 = (middle_y >= BESSEL_LOG_SECOND_END);
    float centre_low_1 = (second_2 ? BESSEL_LOG_SECOND_CENTRE : BESSEL_LOG_FIRST_CENTRE);
    float centre_3 = (third_1 ? BESSEL_LOG_THIRD_CENTRE : centre_low_1);
    float value_low_1 = (second_2 ? BESSEL_LOG_SECOND_VALUE : BESSEL_LOG_FIRST_VALUE);
    float value_8 = (third_1 ? BESSEL_LOG_THIRD_VALUE : value_low_1);
    float pa_low_1 = (second_2 ? BESSEL_LOG_SECOND_A : BESSEL_LOG_FIRST_A);
    float pa_1 = (third_1 ? BESSEL_LOG_THIRD_A : pa_low_1);
    float pb_low_1 = (second_2 ? BESSEL_LOG_SECOND_B : BESSEL_LOG_FIRST_B);
    float pb_1 = (third_1 ? BESSEL_LOG_THIRD_B : pb_low_1);
    float pc_low_1 = (second_2 ? BESSEL_LOG_SECOND_C : BESSEL_LOG_FIRST_C);
    float pc_1 = (third_1 ? BESSEL_LOG_THIRD_C : pc_low_1);
    float pd_low_1 = (second_2 ? BESSEL_LOG_SECOND_D : BESSEL_LOG_FIRST_D);
    float pd_1 = (third_1 ? BESSEL_LOG_THIRD_D : pd_low_1);
    float pe_low_1 = (second_2 ? BESSEL_LOG_SECOND_E : BESSEL_LOG_FIRST_E);
    float pe_1 = (third_1 ? BESSEL_LOG_THIRD_E : pe_low_1);
    float pf_low_1 = (second_2 ? BESSEL_LOG_SECOND_F : BESSEL_LOG_FIRST_F);
    float pf_1 = (third_1 ? BESSEL_LOG_THIRD_F : pf_low_1);
    float pg_high_1 = (third_1 ? BESSEL_LOG_THIRD_G : BESSEL_LOG_SECOND_G);
    float pg_1 = (second_2 ? pg_high_1 : 0.0);
    float d_6 = (middle_y - centre_3);
    float upper_1 = (pd_1 + (d_6 * (pe_1 + (d_6 * (pf_1 + (d_6 * pg_1))))));
    float middle_2 = (value_8 + (d_6 * (pa_1 + (d_6 * (pb_1 + (d_6 * (pc_1 + (d_6 * upper_1))))))));
    BesselPowers _e90 = bessel_powers(max(y_10, BESSEL_BORDER));
    float t_1 = _e90.rest;
    float upper_log = (BESSEL_LN_E + (t_1 * (BESSEL_LN_F + (t_1 * BESSEL_LN_G))));
    float logarithm = (t_1 * (BESSEL_LN_A + (t_1 * (BESSEL_LN_B + (t_1 * (BESSEL_LN_C + (t_1 * (BESSEL_LN_D + (t_1 * upper_log)))))))));
    float v_7 = (1.0 / max(y_10, BESSEL_BORDER));
    float upper_growth_1 = (BESSEL_LOG_TAIL_E + (v_7 * (BESSEL_LOG_TAIL_F + (v_7 * (BESSEL_LOG_TAIL_G + (v_7 * BESSEL_LOG_TAIL_H))))));
    float lower_growth = (BESSEL_LOG_TAIL_B + (v_7 * (BESSEL_LOG_TAIL_C + (v_7 * (BESSEL_LOG_TAIL_D + (v_7 * upper_growth_1))))));
    float growth_1 = (v_7 * (BESSEL_LOG_TAIL_A + (v_7 * lower_growth)));
    float constant = (_e90.high ? BESSEL_HIGH_LOG : BESSEL_LOW_LOG);
    float exponent = float((_e90.exponent - 127u));
    float half_log = ((exponent * BESSEL_HALF_LN_TWO) + (constant + (logarithm - growth_1)));
    float near_2 = ((y_10 >= BESSEL_HEAD_END) ? middle_2 : head_3);
    return ((y_10 >= BESSEL_BORDER) ? (y_10 - half_log) : near_2);
}

// Returns I1(x)/I0(x), to 2 units of the last place.
//
// Any x; odd; x/2 near 0, 1 - 1/(2x) far from it. The derivative of [`log_bessel_izero`].
float bessel_ratio(float x_12) {
    float y_11 = abs(x_12);
    float bounded_5 = min(y_11, BESSEL_HEAD_END);
    float u_10 = (bounded_5 * bounded_5);
    float bend_2 = (BESSEL_RATIO_HEAD_A + (u_10 * (BESSEL_RATIO_HEAD_B + (u_10 * (BESSEL_RATIO_HEAD_C + (u_10 * (BESSEL_RATIO_HEAD_D + (u_10 * BESSEL_RATIO_HEAD_E))))))));
    float head_4 = (bounded_5 * (0.5 + (u_10 * bend_2)));
    float middle_y_1 = min(y_11, BESSEL_BORDER);
    bool second_3 = (middle_y_1 >= BESSEL_RATIO_FIRST_END);
    float centre_4 = (second_3 ? BESSEL_RATIO_SECOND_CENTRE : BESSEL_RATIO_FIRST_CENTRE);
    float value_9 = (second_3 ? BESSEL_RATIO_SECOND_VALUE : BESSEL_RATIO_FIRST_VALUE);
    float pa_2 = (second_3 ? BESSEL_RATIO_SECOND_A : BESSEL_RATIO_FIRST_A);
    float pb_2 = (second_3 ? BESSEL_RATIO_SECOND_B : BESSEL_RATIO_FIRST_B);
    float pc_2 = (second_3 ? BESSEL_RATIO_SECOND_C : BESSEL_RATIO_FIRST_C);
    float pd_2 = (second_3 ? BESSEL_RATIO_SECOND_D : BESSEL_RATIO_FIRST_D);
    float pe_2 = (second_3 ? BESSEL_RATIO_SECOND_E : BESSEL_RATIO_FIRST_E);
    float pf_2 = (second_3 ? BESSEL_RATIO_SECOND_F : BESSEL_RATIO_FIRST_F);
    float pg_2 = (second_3 ? BESSEL_RATIO_SECOND_G : BESSEL_RATIO_FIRST_G);
    float ph_1 = (second_3 ? BESSEL_RATIO_SECOND_H : 0.0);
    float d_7 = (middle_y_1 - centre_4);
    float upper_2 = (pd_2 + (d_7 * (pe_2 + (d_7 * (pf_2 + (d_7 * (pg_2 + (d_7 * ph_1))))))));
    float middle_3 = (value_9 + (d_7 * (pa_2 + (d_7 * (pb_2 + (d_7 * (pc_2 + (d_7 * upper_2))))))));
    float v_8 = (1.0 / max(y_11, BESSEL_BORDER));
    float top = (BESSEL_RATIO_TAIL_H + (v_8 * (BESSEL_RATIO_TAIL_I + (v_8 * BESSEL_RATIO_TAIL_J))));
    float upper_tail = (BESSEL_RATIO_TAIL_E + (v_8 * (BESSEL_RATIO_TAIL_F + (v_8 * (BESSEL_RATIO_TAIL_G + (v_8 * top))))));
    float lower_tail = (BESSEL_RATIO_TAIL_B + (v_8 * (BESSEL_RATIO_TAIL_C + (v_8 * (BESSEL_RATIO_TAIL_D + (v_8 * upper_tail))))));
    float tail_4 = (1.0 - (v_8 * (BESSEL_RATIO_TAIL_A + (v_8 * lower_tail))));
    float near_3 = ((y_11 >= BESSEL_HEAD_END) ? middle_3 : head_4);
    float _e114 = odd_continuation(x_12, ((y_11 >= BESSEL_BORDER) ? tail_4 : near_3));
    return _e114;
}

// Returns e to the sum of a leading part from -110 to 176 and a small rest.
//
// The leading part may carry all its digits: it is reduced before the rest is added.
PowerOfE power_of_e(float leading, float rest_2) {
    float n_4 = roundEven(((leading + rest_2) * LOG_TWO_E));
    float r_4 = ((leading - (n_4 * LN_TWO_HIGH)) + (rest_2 - (n_4 * LN_TWO_LOW)));
    float e_1 = (EXPONENTIAL_A + (r_4 * (EXPONENTIAL_B + (r_4 * (EXPONENTIAL_C + (r_4 * (EXPONENTIAL_D + (r_4 * EXPONENTIAL_E))))))));
    float halved_6 = roundEven((n_4 * 0.5));
    return PowerOfE((1.0 + (r_4 * (1.0 + (r_4 * e_1)))), uintBitsToFloat((floatBitsToUint((halved_6 + EXPONENT_BIAS)) << 23u)), uintBitsToFloat((floatBitsToUint(((n_4 - halved_6) + EXPONENT_BIAS)) << 23u)));
}

// Returns the twelve leading bits of x: the product of two such numbers is exact.
float leading_bits(float x_13) {
    return uintBitsToFloat((floatBitsToUint(x_13) & 4294963200u));
}

// Returns x y/pi less the nearest integer, for x y in radians.
float product_turns(float x_14, float y_1) {
    float _e2 = leading_bits(x_14);
    float _e3 = leading_bits(y_1);
    float leading_2 = min(max((_e2 * _e3), -33554432.0), PHASE_LIMIT);
    float rest_6 = ((_e2 * (y_1 - _e3)) + ((x_14 - _e2) * y_1));
    float bounded_6 = min(max(rest_6, -33554432.0), PHASE_LIMIT);
    float n_5 = roundEven((leading_2 * INVERSE_PI));
    float turns_2 = (((leading_2 - (n_5 * PI_HIGH)) - (n_5 * PI_LOW)) * INVERSE_PI);
    float small = (bounded_6 * INVERSE_PI);
    float sum = (turns_2 + (small - roundEven(small)));
    return (sum - roundEven(sum));
}

// Returns the polynomial of the near or of the far fit at v, in the upper half plane.
Complex faddeeva_polynomial(Complex v_1, bool near) {
    float s_7 = (v_1.re + v_1.re);
    float t_2 = ((v_1.re * v_1.re) + (v_1.im * v_1.im));
    float p_o = (near ? FADDEEVA_NEAR_O : FADDEEVA_FAR_O);
    float p_n = ((near ? FADDEEVA_NEAR_N : FADDEEVA_FAR_N) + (s_7 * p_o));
    float p_m = (((near ? FADDEEVA_NEAR_M : FADDEEVA_FAR_M) - (t_2 * p_o)) + (s_7 * p_n));
    float p_l = (((near ? FADDEEVA_NEAR_L : FADDEEVA_FAR_L) - (t_2 * p_n)) + (s_7 * p_m));
    float p_k = (((near ? FADDEEVA_NEAR_K : FADDEEVA_FAR_K) - (t_2 * p_m)) + (s_7 * p_l));
    float p_j = (((near ? FADDEEVA_NEAR_J : FADDEEVA_FAR_J) - (t_2 * p_l)) + (s_7 * p_k));
    float p_i = (((near ? FADDEEVA_NEAR_I : FADDEEVA_FAR_I) - (t_2 * p_k)) + (s_7 * p_j));
    float p_h = (((near ? FADDEEVA_NEAR_H : FADDEEVA_FAR_H) - (t_2 * p_j)) + (s_7 * p_i));
    float p_g = (((near ? FADDEEVA_NEAR_G : FADDEEVA_FAR_G) - (t_2 * p_i)) + (s_7 * p_h));
    float p_f = (((near ? FADDEEVA_NEAR_F : FADDEEVA_FAR_F) - (t_2 * p_h)) + (s_7 * p_g));
    float p_e = (((near ? FADDEEVA_NEAR_E : FADDEEVA_FAR_E) - (t_2 * p_g)) + (s_7 * p_f));
    float p_d = (((near ? FADDEEVA_NEAR_D : FADDEEVA_FAR_D) - (t_2 * p_f)) + (s_7 * p_e));
    float p_c = (((near ? FADDEEVA_NEAR_C : FADDEEVA_FAR_C) - (t_2 * p_e)) + (s_7 * p_d));
    float p_b = (((near ? FADDEEVA_NEAR_B : FADDEEVA_FAR_B) - (t_2 * p_d)) + (s_7 * p_c));
    float re_3 = (((near ? FADDEEVA_NEAR_A : FADDEEVA_FAR_A) - (t_2 * p_c)) + (v_1.re * p_b));
    float im_3 = (v_1.im * p_b);
    return Complex(re_3, im_3);
}

// Returns w(x + i y) for x >= 0 and y >= 0.
Complex faddeeva_quadrant(float x_15, float y_2) {
    float largest = max(x_15, y_2);
    bool huge = (largest > FADDEEVA_SQUARE_LIMIT);
    float scale_2 = (huge ? FADDEEVA_SHRINK : 1.0);
    float xs = (min(x_15, INFINITE_LIMIT) * scale_2);
    float ys = (min(y_2, INFINITE_LIMIT) * scale_2);
    float square_1 = (xs * xs);
    float size = (square_1 + (ys * ys));
    bool near_4 = (size < (huge ? 0.0 : FADDEEVA_BORDER));
    float pole = (near_4 ? FADDEEVA_NEAR_POLE : FADDEEVA_FAR_POLE);
    float across = (ys + pole);
    float inverse_1 = (1.0 / ((across * across) + square_1));
    float along = (ys - FADDEEVA_CENTRE);
    Complex v_9 = Complex((((along * across) + square_1) * inverse_1), -(((pole + FADDEEVA_CENTRE) * (xs * inverse_1))));
    Complex _e40 = faddeeva_polynomial(v_9, near_4);
    float near_re = (FADDEEVA_AT_CENTRE + ((along * _e40.re) + (xs * _e40.im)));
    float near_im = ((along * _e40.im) - (xs * _e40.re));
    float inverse_square = (inverse_1 * inverse_1);
    float q_square = (((across - xs) * (across + xs)) * inverse_square);
    float q_twice = (((across + across) * xs) * inverse_square);
    float f_re = (huge ? 0.0 : ((q_square * _e40.re) - (q_twice * _e40.im)));
    float f_im = (huge ? 0.0 : ((q_square * _e40.im) + (q_twice * _e40.re)));
    float shrink = (INVERSE_ROOT_PI / size);
    float far_re = ((ys + ((ys * f_re) - (xs * f_im))) * shrink);
    float far_im = ((xs + ((xs * f_re) + (ys * f_im))) * shrink);
    float unscale = ((largest > INFINITE_LIMIT) ? 0.0 : scale_2);
    return Complex(((near_4 ? near_re : far_re) * unscale), ((near_4 ? near_im : far_im) * unscale));
}

// Returns 2 exp(-z^2) at z = x - i y for x >= 0 and y > 0.
Complex faddeeva_gaussian(float x_16, float y_3) {
    bool local_2 = false;
    bool local_3 = false;
    float halved_7 = ((y_3 - x_16) * ((0.5 * y_3) + (0.5 * x_16)));
    float rough = (halved_7 + halved_7);
    float largest_1 = max(x_16, y_3);
    uint bits_1 = (floatBitsToUint(max(min(largest_1, GRID_UPPER_LIMIT), GRID_LOWER_LIMIT)) & 2139095040u);
    float grid = (uintBitsToFloat(bits_1) * 0.00048828125);
    float inverse_grid = (uintBitsToFloat((bits_1 ^ 2139095040u)) * 1024.0);
    float x_high_1 = (roundEven((x_16 * inverse_grid)) * grid);
    float y_high_1 = (roundEven((y_3 * inverse_grid)) * grid);
    float exact = ((y_high_1 * y_high_1) - (x_high_1 * x_high_1));
    float small_1 = (((y_3 - y_high_1) * (y_3 + y_high_1)) - ((x_16 - x_high_1) * (x_16 + x_high_1)));
    if (!((largest_1 > GRID_UPPER_LIMIT))) {
        local_2 = (abs(rough) > 104.0);
    } else {
        local_2 = true;
    }
    bool plain = local_2;
    float bounded_7 = min(max(rough, EXPONENT_LOWEST), EXPONENT_HIGHEST);
    PowerOfE _e59 = power_of_e((plain ? bounded_7 : exact), (plain ? 0.0 : small_1));
    if (!((x_16 == 0.0))) {
        local_3 = (rough < EXPONENT_LOWEST);
    } else {
        local_3 = true;
    }
    bool nothing = local_3;
    float _e69 = product_turns(x_16, y_3);
    SineCosine _e75 = sine_cosine_turns((nothing ? 0.0 : (_e69 + (0.0 * y_3))));
    float re_4 = ((_e59.mantissa * _e75.cosine) * _e59.first);
    float im_4 = ((_e59.mantissa * _e75.sine) * _e59.first);
    return Complex(((re_4 + re_4) * _e59.second), ((im_4 + im_4) * _e59.second));
}

// Returns w(re + i im) from its value at |re| + i |im|, by w(z) = 2 exp(-z^2) - w(-z) below the
// real axis.
Complex faddeeva_in_plane(float re, float im, Complex above) {
    float w_re = 0.0;
    float w_im = 0.0;
    w_re = above.re;
    w_im = above.im;
    if ((im < 0.0)) {
        Complex _e11 = faddeeva_gaussian(abs(re), abs(im));
        w_re = (_e11.re - above.re);
        w_im = (_e11.im + above.im);
    }
    float _e18 = w_re;
    float _e19 = w_im;
    float _e20 = odd_continuation(re, _e19);
    return Complex(_e18, _e20);
}

// Returns w(z) = exp(-z^2) erfc(-i z) at z = re + i im, to f32 grade in the upper half plane.
//
// The error counts against |w(z)| above the real axis and on it, and against |2 exp(-z^2)| +
// |w(-z)| below, where
// exponent and phase keep their digits for |z| to 100. w(-conj z) = conj w(z) holds exactly. An
// infinite z gives 0 in
// the upper half plane and on horizontal lines below it; straight down w tends to infinity.
Complex faddeeva_w(float re_1, float im_1) {
    Complex _e4 = faddeeva_quadrant(abs(re_1), abs(im_1));
    Complex _e5 = faddeeva_in_plane(re_1, im_1, _e4);
    return _e5;
}

// Returns the polynomial of the coarse tier at v.
Complex faddeeva_polynomial_coarse(Complex v_2) {
    float s_8 = (v_2.re + v_2.re);
    float t_3 = ((v_2.re * v_2.re) + (v_2.im * v_2.im));
    float p_j_1 = (FADDEEVA_COARSE_J + (s_8 * FADDEEVA_COARSE_K));
    float p_i_1 = ((FADDEEVA_COARSE_I - (t_3 * FADDEEVA_COARSE_K)) + (s_8 * p_j_1));
    float p_h_1 = ((FADDEEVA_COARSE_H - (t_3 * p_j_1)) + (s_8 * p_i_1));
    float p_g_1 = ((FADDEEVA_COARSE_G - (t_3 * p_i_1)) + (s_8 * p_h_1));
    float p_f_1 = ((FADDEEVA_COARSE_F - (t_3 * p_h_1)) + (s_8 * p_g_1));
    float p_e_1 = ((FADDEEVA_COARSE_E - (t_3 * p_g_1)) + (s_8 * p_f_1));
    float p_d_1 = ((FADDEEVA_COARSE_D - (t_3 * p_f_1)) + (s_8 * p_e_1));
    float p_c_1 = ((FADDEEVA_COARSE_C - (t_3 * p_e_1)) + (s_8 * p_d_1));
    float p_b_1 = ((FADDEEVA_COARSE_B - (t_3 * p_d_1)) + (s_8 * p_c_1));
    float re_5 = ((FADDEEVA_COARSE_A - (t_3 * p_c_1)) + (v_2.re * p_b_1));
    float im_5 = (v_2.im * p_b_1);
    return Complex(re_5, im_5);
}

// Returns w(x + i y) for x >= 0 and y >= 0, to 5e-5.
Complex faddeeva_quadrant_coarse(float x_17, float y_4) {
    float largest_2 = max(x_17, y_4);
    bool huge_1 = (largest_2 > FADDEEVA_SQUARE_LIMIT);
    float scale_3 = (huge_1 ? FADDEEVA_SHRINK : 1.0);
    float xs_1 = (min(x_17, INFINITE_LIMIT) * scale_3);
    float across_1 = ((min(y_4, INFINITE_LIMIT) * scale_3) + (huge_1 ? 0.0 : FADDEEVA_COARSE_POLE));
    float inverse_2 = (1.0 / ((across_1 * across_1) + (xs_1 * xs_1)));
    float q_re = (across_1 * inverse_2);
    float q_im = (xs_1 * inverse_2);
    float double_pole = (huge_1 ? 0.0 : 5.0);
    Complex v_10 = Complex(((double_pole * q_re) - 1.0), (double_pole * q_im));
    Complex _e33 = faddeeva_polynomial_coarse(v_10);
    float unscale_1 = ((largest_2 > INFINITE_LIMIT) ? 0.0 : scale_3);
    return Complex((((q_re * _e33.re) - (q_im * _e33.im)) * unscale_1), (((q_re * _e33.im) + (q_im * _e33.re)) * unscale_1));
}

// Returns w(z) of [`faddeeva_w`] to 5e-5.
Complex faddeeva_w_coarse(float re_2, float im_2) {
    Complex _e4 = faddeeva_quadrant_coarse(abs(re_2), abs(im_2));
    Complex _e5 = faddeeva_in_plane(re_2, im_2, _e4);
    return _e5;
}

// Returns exp(-a^2 - rest) for a from 0 to 12, or what is left of it.
float erf_gaussian(float a, float rest_3) {
    float _e2 = leading_bits(a);
    float square_2 = (_e2 * _e2);
    float low = (((a - _e2) * (a + _e2)) + rest_3);
    PowerOfE _e16 = power_of_e(max(-(square_2), EXPONENT_LOWEST), ((square_2 > 110.0) ? 0.0 : -(low)));
    return ((_e16.mantissa * _e16.first) * _e16.second);
}

// Returns P(a), for a >= 0, and its conjugate continuation for a < 0.
Complex erf_end(float a_1, float b, float turns_1) {
    bool local_4 = false;
    float size_1 = abs(a_1);
    float height = abs(b);
    if (!((size_1 > ERF_END_LARGEST))) {
        local_4 = (height > INFINITE_LIMIT);
    } else {
        local_4 = true;
    }
    bool nothing_1 = local_4;
    SineCosine _e16 = sine_cosine_turns((nothing_1 ? 0.0 : turns_1));
    float _e20 = erf_gaussian(min(size_1, ERF_END_LARGEST), 0.0);
    Complex _e21 = faddeeva_quadrant(height, size_1);
    float im_6 = (((a_1 < 0.0) != (b < 0.0)) ? _e21.im : -(_e21.im));
    return Complex((_e20 * ((_e21.re * _e16.cosine) + (im_6 * _e16.sine))), (_e20 * ((im_6 * _e16.cosine) - (_e21.re * _e16.sine))));
}

// Returns the integral of exp(-s^2 - 2 (m + i b) s) over |s| <= d as a multiple of 2 d, for short
// segments.
//
// The Taylor series in q = (m + i b)^2 d^2 and d^2.
Complex erf_short_series(float middle_1, float b_1, float halved_1) {
    float d_8 = (halved_1 * halved_1);
    float across_2 = (halved_1 * middle_1);
    float along_1 = (halved_1 * b_1);
    float q_re_1 = ((across_2 - along_1) * (across_2 + along_1));
    float q_im_1 = ((across_2 + across_2) * along_1);
    float k_3 = (1.0 + (d_8 * (-0.33333334 + (d_8 * (0.1 + (d_8 * (-0.023809524 + (d_8 * (0.0046296297 - (d_8 * 0.00075757573))))))))));
    float l = (0.6666667 + (d_8 * (-0.4 + (d_8 * (0.14285715 + (d_8 * (-0.037037037 + (d_8 * 0.007575758))))))));
    float m_9 = (0.13333334 + (d_8 * (-0.0952381 + (d_8 * 0.037037037))));
    float n_6 = (0.012698413 - (d_8 * 0.009876543));
    float first_re = (m_9 + (q_re_1 * n_6));
    float first_im = (q_im_1 * n_6);
    float second_re = (l + ((q_re_1 * first_re) - (q_im_1 * first_im)));
    float second_im = ((q_re_1 * first_im) + (q_im_1 * first_re));
    return Complex((k_3 + ((q_re_1 * second_re) - (q_im_1 * second_im))), ((q_re_1 * second_im) + (q_im_1 * second_re)));
}

// Returns exp(-b^2) (erf(`a_to` + i b) - erf(`a_from` + i b)) with the phases a b/pi given apart,
// in turns.
//
// `turns_from` and `turns_to` are `a_from` b/pi and `a_to` b/pi, whole turns taken off or not: a
// scene that knows its
// lengths in wavelengths loses nothing to the size of the phase. All five are dimensionless. Errors
// are 1e-5 of the
// value at b = 0 at most, as long as that is a normal number. An infinite end takes any turns; an
// infinite b gives 0;
// equal ends give 0; swapped ends negate exactly. VWH18 Eq. 5.
Complex erf_difference_scaled_turns(float a_from, float a_to, float b_2, float turns_from, float turns_to) {
    bool local_5 = false;
    bool local_6 = false;
    float extent_5 = (a_to - a_from);
    float halved_8 = (0.5 * extent_5);
    bool nearer_to = (abs(a_to) < abs(a_from));
    float base = (nearer_to ? a_to : a_from);
    float stride = (nearer_to ? -(halved_8) : halved_8);
    float middle_4 = (base + stride);
    float across_3 = (halved_8 * middle_4);
    float along_2 = (halved_8 * b_2);
    if ((abs(halved_8) <= ERF_SHORT)) {
        local_5 = (((across_3 * across_3) + (along_2 * along_2)) <= ERF_SHORT_SQUARE);
    } else {
        local_5 = false;
    }
    bool is_short = local_5;
    float apart = (nearer_to ? (turns_from - turns_to) : (turns_to - turns_from));
    float turns_3 = ((nearer_to ? turns_to : turns_from) + (0.5 * (apart - roundEven(apart))));
    SineCosine _e38 = sine_cosine_turns(turns_3);
    float rest_7 = (stride * ((base + base) + stride));
    float _e47 = erf_gaussian(min(abs(base), ERF_END_LARGEST), rest_7);
    float scale_4 = ((TWO_INVERSE_ROOT_PI * extent_5) * _e47);
    Complex _e49 = erf_short_series(middle_4, b_2, halved_8);
    float short_re = (scale_4 * ((_e49.re * _e38.cosine) + (_e49.im * _e38.sine)));
    float short_im = (scale_4 * ((_e49.im * _e38.cosine) - (_e49.re * _e38.sine)));
    Complex _e66 = erf_end(a_from, b_2, turns_from);
    Complex _e67 = erf_end(a_to, b_2, turns_to);
    float side_from = ((a_from < 0.0) ? -1.0 : 1.0);
    float side_to = ((a_to < 0.0) ? -1.0 : 1.0);
    float _e83 = erf_gaussian(min(abs(b_2), ERF_END_LARGEST), 0.0);
    float between_1 = ((side_to - side_from) * _e83);
    float long_re = (between_1 + ((side_from * _e66.re) - (side_to * _e67.re)));
    float long_im = ((side_from * _e66.im) - (side_to * _e67.im));
    if ((a_from == a_to)) {
        local_6 = (abs(b_2) >= 0.0);
    } else {
        local_6 = false;
    }
    bool is_empty = local_6;
    return Complex((is_empty ? 0.0 : (is_short ? short_re : long_re)), (is_empty ? 0.0 : (is_short ? short_im : long_im)));
}

// Returns exp(-b^2) (erf(`a_to` + i b) - erf(`a_from` + i b)), the three dimensionless.
//
// As [`erf_difference_scaled_turns`], with the phases formed from exact partial products: they hold
// to 1e-6 for |a b| to
// 1e4, and lose digits in proportion beyond.
Complex erf_difference_scaled(float a_from_1, float a_to_1, float b_3) {
    float _e3 = product_turns(a_from_1, b_3);
    float _e4 = product_turns(a_to_1, b_3);
    Complex _e5 = erf_difference_scaled_turns(a_from_1, a_to_1, b_3, _e3, _e4);
    return _e5;
}
