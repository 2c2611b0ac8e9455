// iridescence: closed-form wave optics for renderers, f32.
// HLSL, shader model 5.1 and later.
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

struct Turns {
    float whole;
    float rest;
};

struct TriangleFlanks {
    float sinc_a;
    float sinc_b;
    SineCosine a;
    SineCosine b;
    float deep;
    float across;
};

struct FootprintWindow {
    float near;
    float far;
    float start;
    float span;
    float share;
};

struct SampledDirection {
    float x;
    float y;
    float z;
    float pdf;
};

struct LightPoint {
    float x;
    float y;
    float z;
};

struct LightLine {
    float x;
    float rest;
    float view;
    float width;
};

struct LightChords {
    float sum;
    float begin_b;
    float begin_n;
    float open;
    LightPoint setting;
    float below;
    LightPoint rise;
    float risen;
};

struct LightBand {
    float along;
    float width;
    float view_t;
    float view_b;
    float reference;
};

struct LightCircle {
    float centre_t;
    float centre_b;
    float reach;
    float across_cosine;
    float across_sine;
};

struct LightAngle {
    float c;
    float s;
};

struct LightOutline {
    float sum;
    LightPoint setting;
    float below;
    LightPoint rise;
    float risen;
};
static const float SINE_A = -0.16666657;
static const float SINE_B = 0.008333015;
static const float SINE_C = -0.00019806474;
static const float SINE_D = 2.5997415e-6;
static const float COSINE_A = 0.041666657;
static const float COSINE_B = -0.0013888567;
static const float COSINE_C = 2.4769173e-5;
static const float COSINE_D = -2.6191063e-7;
static const float SINE_MEDIUM_A = -0.16665675;
static const float SINE_MEDIUM_B = 0.00831228;
static const float SINE_MEDIUM_C = -0.00018489461;
static const float COSINE_MEDIUM_A = 0.04166543;
static const float COSINE_MEDIUM_B = -0.0013865135;
static const float COSINE_MEDIUM_C = 2.3376515e-5;
static const float SINE_COARSE_A = -0.1660762;
static const float SINE_COARSE_B = 0.00763235;
static const float COSINE_COARSE_A = 0.041583017;
static const float COSINE_COARSE_B = -0.0012964817;
static const float EXPONENTIAL_A = 0.5;
static const float EXPONENTIAL_B = 0.16666518;
static const float EXPONENTIAL_C = 0.041666202;
static const float EXPONENTIAL_D = 0.00836896;
static const float EXPONENTIAL_E = 0.0013950627;
static const float ARCTANGENT_A = 0.33332753;
static const float ARCTANGENT_B = -0.199718;
static const float ARCTANGENT_C = 0.13823614;
static const float ARCTANGENT_D = -0.07899901;
static const float ARTANH_A = 0.6666682;
static const float ARTANH_B = 0.39973545;
static const float ARTANH_C = 0.29962823;
static const float SI_BORDER = 3.0;
static const float SI_HEAD_A = -0.055555556;
static const float SI_HEAD_B = 0.001666666;
static const float SI_HEAD_C = -2.8344251e-5;
static const float SI_HEAD_D = 3.060661e-7;
static const float SI_HEAD_E = -2.2577045e-9;
static const float SI_HEAD_F = 1.0790571e-11;
static const float SI_F_A = 70.17039;
static const float SI_F_B = 989.60046;
static const float SI_F_C = 2541.1763;
static const float SI_F_D = 364.07697;
static const float SI_D_A = 72.17014;
static const float SI_D_B = 1110.126;
static const float SI_D_C = 3699.743;
static const float SI_D_D = 1548.3854;
static const float SI_G_A = 66.17814;
static const float SI_G_B = 793.8138;
static const float SI_G_C = 1338.202;
static const float SI_MEDIUM_BORDER = 4.0;
static const float SI_MEDIUM_HEAD_A = -0.055555113;
static const float SI_MEDIUM_HEAD_B = 0.0016663427;
static const float SI_MEDIUM_HEAD_C = -2.8261613e-5;
static const float SI_MEDIUM_HEAD_D = 2.9645898e-7;
static const float SI_MEDIUM_HEAD_E = -1.7360231e-9;
static const float SI_MEDIUM_F_A = 17.290882;
static const float SI_MEDIUM_F_B = 12.183432;
static const float SI_MEDIUM_D_A = 19.27993;
static const float SI_MEDIUM_D_B = 29.837011;
static const float SI_MEDIUM_G_A = 13.527913;
static const float SI_COARSE_BORDER = 4.2;
static const float SI_COARSE_HEAD_A = -0.055537447;
static const float SI_COARSE_HEAD_B = 0.0016581498;
static const float SI_COARSE_HEAD_C = -2.7003263e-5;
static const float SI_COARSE_HEAD_D = 2.1766542e-7;
static const float SI_COARSE_F_A = 2.6163409;
static const float SI_COARSE_D_A = 4.341545;
static const float ARC_BORDER = 1.5;
static const float ARC_HEAD_A = -0.11111111;
static const float ARC_HEAD_B = 0.008888887;
static const float ARC_HEAD_C = -0.00045351134;
static const float ARC_HEAD_D = 1.5672966e-5;
static const float ARC_HEAD_E = -3.8613345e-7;
static const float ARC_HEAD_F = 6.4225927e-9;
static const float ARC_K_A = 1.9999956;
static const float ARC_K_B = 258.43646;
static const float ARC_K_C = 7410.3594;
static const float ARC_K_D = 46687.168;
static const float ARC_K_E = 36415.418;
static const float ARC_D_A = 141.21405;
static const float ARC_D_B = 5042.531;
static const float ARC_D_C = 52164.527;
static const float ARC_D_D = 133795.45;
static const float ARC_D_E = 46657.9;
static const float ARC_G_A = 135.21423;
static const float ARC_G_B = 4315.019;
static const float ARC_G_C = 33926.46;
static const float ARC_G_D = 43137.465;
static const float ARC_MEDIUM_BORDER = 1.5;
static const float ARC_MEDIUM_HEAD_A = -0.1111111;
static const float ARC_MEDIUM_HEAD_B = 0.008888806;
static const float ARC_MEDIUM_HEAD_C = -0.0004533653;
static const float ARC_MEDIUM_HEAD_D = 1.5554067e-5;
static const float ARC_MEDIUM_HEAD_E = -3.4116866e-7;
static const float ARC_MEDIUM_K_A = 1.9999629;
static const float ARC_MEDIUM_K_B = 145.12321;
static const float ARC_MEDIUM_K_C = 1707.5638;
static const float ARC_MEDIUM_K_D = 2135.3086;
static const float ARC_MEDIUM_D_A = 84.52877;
static const float ARC_MEDIUM_D_B = 1521.9207;
static const float ARC_MEDIUM_D_C = 5905.193;
static const float ARC_MEDIUM_D_D = 2854.2007;
static const float ARC_MEDIUM_G_A = 78.53092;
static const float ARC_MEDIUM_G_B = 1133.2189;
static const float ARC_MEDIUM_G_C = 2315.1272;
static const float ARC_COARSE_BORDER = 1.5;
static const float ARC_COARSE_HEAD_A = -0.11111016;
static const float ARC_COARSE_HEAD_B = 0.008885415;
static const float ARC_COARSE_HEAD_C = -0.00044930252;
static const float ARC_COARSE_HEAD_D = 1.3569316e-5;
static const float ARC_COARSE_K_A = 1.9989456;
static const float ARC_COARSE_K_B = 67.905655;
static const float ARC_COARSE_K_C = 185.41277;
static const float ARC_COARSE_D_A = 45.673885;
static const float ARC_COARSE_D_B = 335.51318;
static const float ARC_COARSE_D_C = 273.18066;
static const float ARC_COARSE_G_A = 39.695797;
static const float ARC_COARSE_G_B = 173.4533;
static const float INVERSE_PI = 0.31830987;
static const float PI_HIGH = 3.140625;
static const float PI_LOW = 0.0009676536;
static const float REST_LIMIT = 1.75;
static const float TWO_PI = 6.2831855;
static const float PHASE_LIMIT = 33554432.0;
static const float EXPONENT_BIAS = 8388735.0;
static const float LOG_TWO_E = 1.442695;
static const float LN_TWO_HIGH = 0.6933594;
static const float LN_TWO_LOW = -0.00021219444;
static const float HALF_PI = 1.5707964;
static const float SQUARE_LIMIT = 16777216.0;
static const float VELINOV_BUMP = 0.6614274;
static const float VELINOV_OFFSET = 0.3827229;
static const float ARC_SHORT = 1.0;
static const float ARC_INFINITE = 3e37;
static const float ARC_TINY = 1e-30;
static const float ARC_PHASE_LIMIT = 8388608.0;
static const float ARC_PI = 3.1415927;
static const float GAUSS_INNER = 0.33998105;
static const float GAUSS_OUTER = 0.8611363;
static const float GAUSS_INNER_WEIGHT = 0.65214515;
static const float GAUSS_OUTER_WEIGHT = 0.34785485;
static const float GAUSS_THREE = 0.7745967;
static const float GAUSS_THREE_MIDDLE_WEIGHT = 0.8888889;
static const float GAUSS_THREE_OUTER_WEIGHT = 0.5555556;
static const float BESSEL_FIRST_END = 0.36;
static const float BESSEL_FIRST_CENTRE = 0.16500461;
static const float BESSEL_FIRST_VALUE = 0.8536709;
static const float BESSEL_FIRST_A = -0.7834797;
static const float BESSEL_FIRST_B = 0.570785;
static const float BESSEL_FIRST_C = -0.31254634;
static const float BESSEL_FIRST_D = 0.13556284;
static const float BESSEL_FIRST_E = -0.048531253;
static const float BESSEL_FIRST_F = 0.014805781;
static const float BESSEL_FIRST_G = -0.00375398;
static const float BESSEL_SECOND_END = 0.86;
static const float BESSEL_SECOND_CENTRE = 0.56998736;
static const float BESSEL_SECOND_VALUE = 0.6124071;
static const float BESSEL_SECOND_A = -0.4445993;
static const float BESSEL_SECOND_B = 0.29739624;
static const float BESSEL_SECOND_C = -0.15609547;
static const float BESSEL_SECOND_D = 0.066040955;
static const float BESSEL_SECOND_E = -0.023268692;
static const float BESSEL_SECOND_F = 0.007030464;
static const float BESSEL_SECOND_G = -0.0017126619;
static const float BESSEL_THIRD_END = 1.6;
static const float BESSEL_THIRD_CENTRE = 1.1800063;
static const float BESSEL_THIRD_VALUE = 0.42391765;
static const float BESSEL_THIRD_A = -0.20918402;
static const float BESSEL_THIRD_B = 0.1181957;
static const float BESSEL_THIRD_C = -0.056936633;
static const float BESSEL_THIRD_D = 0.022919957;
static const float BESSEL_THIRD_E = -0.007829978;
static const float BESSEL_THIRD_F = 0.0023298704;
static const float BESSEL_THIRD_G = -0.0005487821;
static const float BESSEL_FOURTH_END = 3.0;
static const float BESSEL_FOURTH_CENTRE = 2.2999098;
static const float BESSEL_FOURTH_VALUE = 0.2836996;
static const float BESSEL_FOURTH_A = -0.073374964;
static const float BESSEL_FOURTH_B = 0.027650414;
static const float BESSEL_FOURTH_C = -0.010496839;
static const float BESSEL_FOURTH_D = 0.003662269;
static const float BESSEL_FOURTH_E = -0.0011413017;
static const float BESSEL_FOURTH_F = 0.00031557522;
static const float BESSEL_FOURTH_G = -7.812707e-5;
static const float BESSEL_FOURTH_H = 1.8563202e-5;
static const float BESSEL_FOURTH_I = -3.7091993e-6;
static const float BESSEL_LOW_CENTRE = 1.2069249;
static const float BESSEL_LOW_INVERSE = 0.82855195;
static const float BESSEL_LOW_EVEN = 0.36313653;
static const float BESSEL_LOW_ODD = 0.2567763;
static const float BESSEL_LOW_LOG = 1.0129764;
static const float BESSEL_HIGH_CENTRE = 1.7068787;
static const float BESSEL_HIGH_INVERSE = 0.5858647;
static const float BESSEL_HIGH_EVEN = 0.3053576;
static const float BESSEL_HIGH_ODD = 0.21592043;
static const float BESSEL_HIGH_LOG = 1.1862717;
static const float BESSEL_SPLIT = 1.4142135;
static const float BESSEL_ROOT_A = -0.5;
static const float BESSEL_ROOT_B = 0.37500098;
static const float BESSEL_ROOT_C = -0.31250283;
static const float BESSEL_ROOT_D = 0.27323663;
static const float BESSEL_ROOT_E = -0.24576588;
static const float BESSEL_ROOT_F = 0.23715664;
static const float BESSEL_ROOT_G = -0.22318871;
static const float BESSEL_LN_A = 0.5;
static const float BESSEL_LN_B = -0.2500003;
static const float BESSEL_LN_C = 0.1666675;
static const float BESSEL_LN_D = -0.12493642;
static const float BESSEL_LN_E = 0.09990236;
static const float BESSEL_LN_F = -0.08700084;
static const float BESSEL_LN_G = 0.07551904;
static const float BESSEL_OUTER_END = 6.5;
static const float BESSEL_TAIL_A = 0.785402;
static const float BESSEL_TAIL_B = 2.7710798;
static const float BESSEL_TAIL_C = 20.155907;
static const float BESSEL_TAIL_D = -218.7877;
static const float BESSEL_TAIL_E = 43648.676;
static const float BESSEL_TAIL_F = -2333362.0;
static const float BESSEL_TAIL_G = 69145850.0;
static const float BESSEL_TAIL_H = -735768640.0;
static const float BESSEL_OUTER_CENTRE = 0.03876851;
static const float BESSEL_OUTER_A = 0.03654081;
static const float BESSEL_OUTER_B = 1.1803682;
static const float BESSEL_OUTER_C = 8.338566;
static const float BESSEL_OUTER_D = 7.426099;
static const float BESSEL_OUTER_E = -2785.3804;
static const float BESSEL_OUTER_F = -7030.0894;
static const float BESSEL_OUTER_G = 1309036.1;
static const float BESSEL_OUTER_H = -8430924.0;
static const float BESSEL_OUTER_I = -442043140.0;
static const float BESSEL_BORDER = 4.0;
static const float BESSEL_HEAD_END = 1.0;
static const float BESSEL_LOG_HEAD_A = -0.01562499;
static const float BESSEL_LOG_HEAD_B = 0.0017359626;
static const float BESSEL_LOG_HEAD_C = -0.00022308876;
static const float BESSEL_LOG_HEAD_D = 2.943114e-5;
static const float BESSEL_LOG_HEAD_E = -2.9568555e-6;
static const float BESSEL_LOG_FIRST_END = 1.5;
static const float BESSEL_LOG_FIRST_CENTRE = 1.2500476;
static const float BESSEL_LOG_FIRST_VALUE = 0.35802728;
static const float BESSEL_LOG_FIRST_A = 0.52800995;
static const float BESSEL_LOG_FIRST_B = 0.14940679;
static const float BESSEL_LOG_FIRST_C = -0.0361158;
static const float BESSEL_LOG_FIRST_D = 0.0027255923;
static const float BESSEL_LOG_FIRST_E = 0.0019267182;
static const float BESSEL_LOG_FIRST_F = -0.00079366803;
static const float BESSEL_LOG_SECOND_END = 2.4;
static const float BESSEL_LOG_SECOND_CENTRE = 1.9000068;
static const float BESSEL_LOG_SECOND_VALUE = 0.7550651;
static const float BESSEL_LOG_SECOND_A = 0.6806503;
static const float BESSEL_LOG_SECOND_B = 0.08923973;
static const float BESSEL_LOG_SECOND_C = -0.024726195;
static const float BESSEL_LOG_SECOND_D = 0.0048648315;
static const float BESSEL_LOG_SECOND_E = -0.00022707779;
static const float BESSEL_LOG_SECOND_F = -0.00026824258;
static const float BESSEL_LOG_SECOND_G = 0.000102527556;
static const float BESSEL_LOG_THIRD_CENTRE = 3.2000892;
static const float BESSEL_LOG_THIRD_VALUE = 1.7487875;
static const float BESSEL_LOG_THIRD_A = 0.8237543;
static const float BESSEL_LOG_THIRD_B = 0.032006305;
static const float BESSEL_LOG_THIRD_C = -0.0075040204;
static const float BESSEL_LOG_THIRD_D = 0.0017625364;
static const float BESSEL_LOG_THIRD_E = -0.00036190744;
static const float BESSEL_LOG_THIRD_F = 5.3291064e-5;
static const float BESSEL_LOG_THIRD_G = -2.015393e-6;
static const float BESSEL_LOG_TAIL_A = 0.12497927;
static const float BESSEL_LOG_TAIL_B = 0.065043844;
static const float BESSEL_LOG_TAIL_C = -0.039425373;
static const float BESSEL_LOG_TAIL_D = 2.1019201;
static const float BESSEL_LOG_TAIL_E = -19.640245;
static const float BESSEL_LOG_TAIL_F = 103.07769;
static const float BESSEL_LOG_TAIL_G = -247.29543;
static const float BESSEL_LOG_TAIL_H = 213.7775;
static const float BESSEL_RATIO_HEAD_A = -0.062499866;
static const float BESSEL_RATIO_HEAD_B = 0.010414709;
static const float BESSEL_RATIO_HEAD_C = -0.0017810093;
static const float BESSEL_RATIO_HEAD_D = 0.00028933206;
static const float BESSEL_RATIO_HEAD_E = -3.3203592e-5;
static const float BESSEL_RATIO_FIRST_END = 2.0;
static const float BESSEL_RATIO_FIRST_CENTRE = 1.5000024;
static const float BESSEL_RATIO_FIRST_VALUE = 0.5961338;
static const float BESSEL_RATIO_FIRST_A = 0.24720253;
static const float BESSEL_RATIO_FIRST_B = -0.097293206;
static const float BESSEL_RATIO_FIRST_C = 0.017662916;
static const float BESSEL_RATIO_FIRST_D = 0.004145302;
static const float BESSEL_RATIO_FIRST_E = -0.0037807873;
static const float BESSEL_RATIO_FIRST_F = 0.00085296825;
static const float BESSEL_RATIO_FIRST_G = 0.00014570318;
static const float BESSEL_RATIO_SECOND_CENTRE = 2.999974;
static const float BESSEL_RATIO_SECOND_VALUE = 0.8099834;
static const float BESSEL_RATIO_SECOND_A = 0.073930226;
static const float BESSEL_RATIO_SECOND_B = -0.027204137;
static const float BESSEL_RATIO_SECOND_C = 0.008627776;
static const float BESSEL_RATIO_SECOND_D = -0.002148176;
static const float BESSEL_RATIO_SECOND_E = 0.00034924946;
static const float BESSEL_RATIO_SECOND_F = 3.8275207e-6;
static const float BESSEL_RATIO_SECOND_G = -3.1629304e-5;
static const float BESSEL_RATIO_SECOND_H = 1.1114423e-5;
static const float BESSEL_RATIO_TAIL_A = 0.5000091;
static const float BESSEL_RATIO_TAIL_B = 0.12332922;
static const float BESSEL_RATIO_TAIL_C = 0.22921288;
static const float BESSEL_RATIO_TAIL_D = -2.9445055;
static const float BESSEL_RATIO_TAIL_E = 52.64979;
static const float BESSEL_RATIO_TAIL_F = -504.88522;
static const float BESSEL_RATIO_TAIL_G = 2858.2017;
static const float BESSEL_RATIO_TAIL_H = -8947.848;
static const float BESSEL_RATIO_TAIL_I = 14135.413;
static const float BESSEL_RATIO_TAIL_J = -8708.469;
static const float BESSEL_HALF_LN_TWO = 0.3465736;
static const float FADDEEVA_BORDER = 4.0;
static const float FADDEEVA_CENTRE = 2.0;
static const float FADDEEVA_NEAR_POLE = 2.0;
static const float FADDEEVA_FAR_POLE = 3.0;
static const float FADDEEVA_AT_CENTRE = 0.25539568;
static const float FADDEEVA_COARSE_POLE = 2.5;
static const float FADDEEVA_NEAR_A = -0.106796466;
static const float FADDEEVA_NEAR_B = 0.16721098;
static const float FADDEEVA_NEAR_C = -0.080159344;
static const float FADDEEVA_NEAR_D = 0.020677371;
static const float FADDEEVA_NEAR_E = 0.0008148871;
static const float FADDEEVA_NEAR_F = -0.0019636583;
static const float FADDEEVA_NEAR_G = -3.7765014e-5;
static const float FADDEEVA_NEAR_H = 0.00025102615;
static const float FADDEEVA_NEAR_I = 2.6974167e-5;
static const float FADDEEVA_NEAR_J = -4.1503077e-5;
static const float FADDEEVA_NEAR_K = -1.6607877e-5;
static const float FADDEEVA_NEAR_L = 2.7369815e-6;
static const float FADDEEVA_NEAR_M = 4.669254e-6;
static const float FADDEEVA_NEAR_N = 1.8796283e-6;
static const float FADDEEVA_NEAR_O = 3.2530315e-7;
static const float FADDEEVA_FAR_A = -2.3661494;
static const float FADDEEVA_FAR_B = 4.529406;
static const float FADDEEVA_FAR_C = -5.0040684;
static const float FADDEEVA_FAR_D = 3.61526;
static const float FADDEEVA_FAR_E = -1.5806278;
static const float FADDEEVA_FAR_F = 0.20925954;
static const float FADDEEVA_FAR_G = 0.1795237;
static const float FADDEEVA_FAR_H = -0.075746216;
static const float FADDEEVA_FAR_I = -0.03169403;
static const float FADDEEVA_FAR_J = 0.03326945;
static const float FADDEEVA_FAR_K = -0.01147905;
static const float FADDEEVA_FAR_L = 0.008491194;
static const float FADDEEVA_FAR_M = -0.009628222;
static const float FADDEEVA_FAR_N = 0.0053928373;
static const float FADDEEVA_FAR_O = -0.0011878925;
static const float FADDEEVA_COARSE_A = 1.0540318;
static const float FADDEEVA_COARSE_B = 0.80465186;
static const float FADDEEVA_COARSE_C = 0.4539141;
static const float FADDEEVA_COARSE_D = 0.17125115;
static const float FADDEEVA_COARSE_E = 0.028361548;
static const float FADDEEVA_COARSE_F = -0.00839299;
static const float FADDEEVA_COARSE_G = -0.004818751;
static const float FADDEEVA_COARSE_H = 0.00043853337;
static const float FADDEEVA_COARSE_I = 0.0006994823;
static const float FADDEEVA_COARSE_J = -6.722101e-5;
static const float FADDEEVA_COARSE_K = -0.00012964732;
static const float FADDEEVA_SQUARE_LIMIT = 1.1529215e18;
static const float FADDEEVA_SHRINK = 1.3552527e-20;
static const float INFINITE_LIMIT = 3e38;
static const float INVERSE_ROOT_PI = 0.5641896;
static const float EXPONENT_LOWEST = -110.0;
static const float EXPONENT_HIGHEST = 176.0;
static const float GRID_UPPER_LIMIT = 512.0;
static const float GRID_LOWER_LIMIT = 0.0001;
static const float ERF_END_LARGEST = 12.0;
static const float ERF_SHORT = 0.5;
static const float ERF_SHORT_SQUARE = 0.0625;
static const float TWO_INVERSE_ROOT_PI = 1.1283792;
static const float SINC_TURNS_LIMIT = 1e-5;
static const float TRIANGLE_SHALLOW_LIMIT = 0.13926058;
static const float INVERSE_ROOT_TWO = 0.70710677;
static const float ROOT_TWO_TIMES_PI = 4.442883;
static const float INVERSE_ROOT_TWO_PI = 0.3989423;
static const float ROOT_HALF_PI = 1.2533141;
static const float ROOT_TWO_PI = 2.5066283;
static const float FOOTPRINT_NODE_A = 0.0019026509;
static const float FOOTPRINT_NODE_SINE_A = 0.087155744;
static const float FOOTPRINT_NODE_B = 0.017037086;
static const float FOOTPRINT_NODE_SINE_B = 0.25881904;
static const float FOOTPRINT_NODE_C = 0.046846107;
static const float FOOTPRINT_NODE_SINE_C = 0.42261827;
static const float FOOTPRINT_NODE_D = 0.09042398;
static const float FOOTPRINT_NODE_SINE_D = 0.57357645;
static const float FOOTPRINT_NODE_E = 0.14644662;
static const float FOOTPRINT_NODE_SINE_E = 0.70710677;
static const float FOOTPRINT_NODE_F = 0.21321177;
static const float FOOTPRINT_NODE_SINE_F = 0.81915206;
static const float FOOTPRINT_NODE_G = 0.28869087;
static const float FOOTPRINT_NODE_SINE_G = 0.9063078;
static const float FOOTPRINT_NODE_H = 0.37059048;
static const float FOOTPRINT_NODE_SINE_H = 0.9659258;
static const float FOOTPRINT_NODE_I = 0.45642212;
static const float FOOTPRINT_NODE_SINE_I = 0.9961947;
static const float HALVING_A = 0.6931472;
static const float HALVING_B = 0.2402235;
static const float HALVING_C = 0.05550381;
static const float HALVING_D = 0.009666368;
static const float HALVING_E = 0.0013381302;
static const float FOOTPRINT_NARROW_A = 0.13825849;
static const float FOOTPRINT_NARROW_B = -0.25333163;
static const float FOOTPRINT_NARROW_C = -0.00026723035;
static const float FOOTPRINT_NARROW_D = 0.01970528;
static const float FOOTPRINT_NARROW_E = -0.0026913143;
static const float FOOTPRINT_NARROW_F = 0.00012525705;
static const float FOOTPRINT_NARROW_G = 0.26582924;
static const float FOOTPRINT_NARROW_H = -1.1349578;
static const float FOOTPRINT_NARROW_I = 0.7839661;
static const float FOOTPRINT_NARROW_J = -0.20106;
static const float FOOTPRINT_NARROW_K = 0.022316214;
static const float FOOTPRINT_NARROW_L = -0.00094284577;
static const float FOOTPRINT_NARROW_M = -0.18790737;
static const float FOOTPRINT_NARROW_N = 1.1706403;
static const float FOOTPRINT_NARROW_O = -1.039597;
static const float FOOTPRINT_NARROW_P = 0.30889568;
static const float FOOTPRINT_NARROW_Q = -0.03554422;
static const float FOOTPRINT_NARROW_R = 0.0015310182;
static const float FOOTPRINT_EDGE_A = 0.94492203;
static const float FOOTPRINT_EDGE_B = -1.4870366;
static const float FOOTPRINT_EDGE_C = 0.60066104;
static const float FOOTPRINT_EDGE_D = -0.10374308;
static const float FOOTPRINT_EDGE_E = -0.004889445;
static const float FOOTPRINT_EDGE_F = 0.00267118;
static const float FOOTPRINT_EDGE_SLOPE_A = 0.36916718;
static const float FOOTPRINT_EDGE_SLOPE_B = -0.24061514;
static const float FOOTPRINT_EDGE_SLOPE_C = 0.049636792;
static const float FOOTPRINT_LEAST_LIMIT = 0.00048828125;
static const float FOOTPRINT_MOST_LIMIT = 1e18;
static const float FOOTPRINT_REACH = 3.95;
static const float FOOTPRINT_SHARE = 0.055555556;
static const float FOOTPRINT_BINARY = 1.2011224;
static const float FOOTPRINT_WIDE_LIMIT = 3.0;
static const float FOOTPRINT_INTERIOR_LIMIT = 2.5;
static const float FOOTPRINT_OUTSIDE_LIMIT = -3.0;
static const float QUARTER_PI = 0.7853982;
static const float TANGENT_SPLIT = 0.41421357;
static const float SHARE_SMALLEST_LIMIT = 2.9802322e-8;
static const float LOBE_NARROW_LIMIT = 1e-6;
static const float LOBE_UNIFORM_LIMIT = 1e-7;
static const float LIGHT_HALF_INVERSE_ROOT_PI = 0.2820948;
static const float BAND_END = 3.5;
static const float BAND_PANEL_LIMIT = 4.0;
static const float BAND_NODE_A = 0.18343464;
static const float BAND_NODE_B = 0.5255324;
static const float BAND_NODE_C = 0.7966665;
static const float BAND_NODE_D = 0.96028984;
static const float BAND_WEIGHT_A = 0.36268377;
static const float BAND_WEIGHT_B = 0.31370664;
static const float BAND_WEIGHT_C = 0.22238104;
static const float BAND_WEIGHT_D = 0.101228535;

// Returns the value of an odd function at x from its `value` at |x|, the sign of a zero included.
float odd_continuation(float x, float value)
{
    return asfloat((asuint(value) ^ (asuint(x) & 2147483648u)));
}

HalfTurns ConstructHalfTurns(float arg0, float arg1) {
    HalfTurns ret = (HalfTurns)0;
    ret.rest = arg0;
    ret.parity = arg1;
    return ret;
}

// Returns x reduced by half turns, for x in radians.
//
// The error of the rest is at most 1e-7 for |x| to 1e4, and 2^-24 |x| beyond.
HalfTurns reduce_half_turns(float x_1)
{
    float n_2 = round((x_1 * INVERSE_PI));
    float rest_4 = ((x_1 - (n_2 * PI_HIGH)) - (n_2 * PI_LOW));
    float pairs = (n_2 * 0.5);
    float parity = (1.0 - (4.0 * abs((pairs - round(pairs)))));
    const HalfTurns halfturns = ConstructHalfTurns(rest_4, parity);
    return halfturns;
}

SineCosine ConstructSineCosine(float arg0, float arg1) {
    SineCosine ret = (SineCosine)0;
    ret.sine = arg0;
    ret.cosine = arg1;
    return ret;
}

// Returns the sine and cosine of r for r within a quarter turn of 0, to 1e-7; the sine keeps its
// relative accuracy.
SineCosine sine_cosine_near(float r)
{
    float u_2 = (r * r);
    float s_4 = (SINE_A + (u_2 * (SINE_B + (u_2 * (SINE_C + (u_2 * SINE_D))))));
    float c_6 = (COSINE_A + (u_2 * (COSINE_B + (u_2 * (COSINE_C + (u_2 * COSINE_D))))));
    const SineCosine sinecosine = ConstructSineCosine((r + (r * (u_2 * s_4))), (1.0 - (u_2 * (0.5 - (u_2 * c_6)))));
    return sinecosine;
}

// Returns the sine and cosine of r for r within a quarter turn of 0, to 5e-6.
SineCosine sine_cosine_near_medium(float r_1)
{
    float u_3 = (r_1 * r_1);
    float s_5 = (SINE_MEDIUM_A + (u_3 * (SINE_MEDIUM_B + (u_3 * SINE_MEDIUM_C))));
    float c_7 = (COSINE_MEDIUM_A + (u_3 * (COSINE_MEDIUM_B + (u_3 * COSINE_MEDIUM_C))));
    const SineCosine sinecosine_1 = ConstructSineCosine((r_1 + (r_1 * (u_3 * s_5))), (1.0 - (u_3 * (0.5 - (u_3 * c_7)))));
    return sinecosine_1;
}

// Returns the sine and cosine of r for r within a quarter turn of 0, to 6e-4.
SineCosine sine_cosine_near_coarse(float r_2)
{
    float u_4 = (r_2 * r_2);
    float s_6 = (SINE_COARSE_A + (u_4 * SINE_COARSE_B));
    float c_8 = (COSINE_COARSE_A + (u_4 * COSINE_COARSE_B));
    const SineCosine sinecosine_2 = ConstructSineCosine((r_2 + (r_2 * (u_4 * s_6))), (1.0 - (u_4 * (0.5 - (u_4 * c_8)))));
    return sinecosine_2;
}

// Returns the sine and cosine of x in radians, to 2.5e-7 for |x| to 1e4.
//
// Beyond, the phase loses digits in proportion; both stay within 1 for any finite x.
SineCosine sine_cosine(float x_2)
{
    const HalfTurns _e1 = reduce_half_turns(x_2);
    const SineCosine _e7 = sine_cosine_near(min(max(_e1.rest, -1.75), REST_LIMIT));
    const SineCosine sinecosine_3 = ConstructSineCosine(((x_2 == 0.0) ? x_2 : (_e1.parity * _e7.sine)), (_e1.parity * _e7.cosine));
    return sinecosine_3;
}

// Returns the sine and cosine of a whole number of turns and a part: of 2 pi `turns`.
//
// Exact reduction for |turns| to 1.7e38: a caller that knows its phase in turns loses nothing to
// the size of the phase.
SineCosine sine_cosine_turns(float turns)
{
    float whole = round((turns + turns));
    float pairs_1 = (whole * 0.5);
    const SineCosine _e8 = sine_cosine_near((TWO_PI * (turns - pairs_1)));
    float parity_1 = (1.0 - (4.0 * abs((pairs_1 - round(pairs_1)))));
    const SineCosine sinecosine_4 = ConstructSineCosine((parity_1 * _e8.sine), (parity_1 * _e8.cosine));
    return sinecosine_4;
}

// Returns e to the x, to 2 units of the last place for x from -87 to 88.
//
// Below, the result falls to 0 by way of subnormal numbers, which a GPU may flush; above 88.7 it
// stays at e^88.7.
float exponential(float x_3)
{
    float bounded = min(max(x_3, -104.0), 88.7);
    float n_3 = round((bounded * LOG_TWO_E));
    float r_3 = ((bounded - (n_3 * LN_TWO_HIGH)) - (n_3 * LN_TWO_LOW));
    float e_1 = (EXPONENTIAL_A + (r_3 * (EXPONENTIAL_B + (r_3 * (EXPONENTIAL_C + (r_3 * (EXPONENTIAL_D + (r_3 * EXPONENTIAL_E))))))));
    float value_1 = (1.0 + (r_3 * (1.0 + (r_3 * e_1))));
    float halved_2 = round((n_3 * 0.5));
    float first_10 = asfloat((asuint((halved_2 + EXPONENT_BIAS)) << 23u));
    float second_3 = asfloat((asuint(((n_3 - halved_2) + EXPONENT_BIAS)) << 23u));
    return ((value_1 * first_10) * second_3);
}

// Returns Si(x), the integral of sin t / t from 0 to x (radians), to f32 grade.
//
// Any x; odd. VWH18 Eq. 28.
float sine_integral(float x_4)
{
    float y_8 = abs(x_4);
    float u_5 = (y_8 * y_8);
    float q_8 = (SI_HEAD_A + (u_5 * (SI_HEAD_B + (u_5 * (SI_HEAD_C + (u_5 * (SI_HEAD_D + (u_5 * (SI_HEAD_E + (u_5 * SI_HEAD_F))))))))));
    float head = (y_8 + (y_8 * (u_5 * q_8)));
    float bounded_1 = min(y_8, PHASE_LIMIT);
    const HalfTurns _e24 = reduce_half_turns(bounded_1);
    const SineCosine _e26 = sine_cosine_near(_e24.rest);
    float s_7 = min(u_5, SQUARE_LIMIT);
    float n_4 = ((s_7 * ((s_7 * ((s_7 * (s_7 + SI_F_A)) + SI_F_B)) + SI_F_C)) + SI_F_D);
    float d_1 = ((s_7 * ((s_7 * ((s_7 * (s_7 + SI_D_A)) + SI_D_B)) + SI_D_C)) + SI_D_D);
    float m_1 = ((s_7 * ((s_7 * (s_7 + SI_G_A)) + SI_G_B)) + SI_G_C);
    float wave = (((_e26.cosine * n_4) + ((_e26.sine * bounded_1) * m_1)) / (bounded_1 * d_1));
    float tail = (HALF_PI - (_e24.parity * wave));
    float value_2 = ((y_8 < SI_BORDER) ? head : tail);
    float finite = ((y_8 >= PHASE_LIMIT) ? HALF_PI : value_2);
    const float _e78 = odd_continuation(x_4, finite);
    return _e78;
}

// Returns Si(x) to 1e-5 absolute. Any x; odd. VWH18 Eq. 28.
float sine_integral_medium(float x_5)
{
    float y_9 = abs(x_5);
    float u_6 = (y_9 * y_9);
    float q_9 = (SI_MEDIUM_HEAD_A + (u_6 * (SI_MEDIUM_HEAD_B + (u_6 * (SI_MEDIUM_HEAD_C + (u_6 * (SI_MEDIUM_HEAD_D + (u_6 * SI_MEDIUM_HEAD_E))))))));
    float head_1 = (y_9 + (y_9 * (u_6 * q_9)));
    float bounded_2 = min(y_9, PHASE_LIMIT);
    const HalfTurns _e21 = reduce_half_turns(bounded_2);
    const SineCosine _e23 = sine_cosine_near_medium(_e21.rest);
    float s_8 = min(u_6, SQUARE_LIMIT);
    float n_5 = ((s_8 * (s_8 + SI_MEDIUM_F_A)) + SI_MEDIUM_F_B);
    float d_2 = ((s_8 * (s_8 + SI_MEDIUM_D_A)) + SI_MEDIUM_D_B);
    float m_2 = (s_8 + SI_MEDIUM_G_A);
    float wave_1 = (((_e23.cosine * n_5) + ((_e23.sine * bounded_2) * m_2)) / (bounded_2 * d_2));
    float tail_1 = (HALF_PI - (_e21.parity * wave_1));
    float value_3 = ((y_9 < SI_MEDIUM_BORDER) ? head_1 : tail_1);
    const float _e53 = odd_continuation(x_5, value_3);
    return _e53;
}

// Returns Si(x) to 4e-4 absolute. Any x; odd. VWH18 Eq. 28.
float sine_integral_coarse(float x_6)
{
    float y_10 = abs(x_6);
    float u_7 = (y_10 * y_10);
    float q_10 = (SI_COARSE_HEAD_A + (u_7 * (SI_COARSE_HEAD_B + (u_7 * (SI_COARSE_HEAD_C + (u_7 * SI_COARSE_HEAD_D))))));
    float head_2 = (y_10 + (y_10 * (u_7 * q_10)));
    float bounded_3 = min(y_10, PHASE_LIMIT);
    const HalfTurns _e18 = reduce_half_turns(bounded_3);
    const SineCosine _e20 = sine_cosine_near_coarse(_e18.rest);
    float s_9 = min(u_7, SQUARE_LIMIT);
    float wave_2 = (((_e20.cosine * (s_9 + SI_COARSE_F_A)) + (_e20.sine * bounded_3)) / (bounded_3 * (s_9 + SI_COARSE_D_A)));
    float tail_2 = (HALF_PI - (_e18.parity * wave_2));
    float value_4 = ((y_10 < SI_COARSE_BORDER) ? head_2 : tail_2);
    const float _e41 = odd_continuation(x_6, value_4);
    return _e41;
}

// Returns Si(x) by the fit that VWH18 publishes, Eq. 29, to 0.051 absolute.
//
// Kept to compare with: its differences have the wrong sign over a quarter of the axis.
float sine_integral_velinov(float x_7)
{
    float y_11 = abs(x_7);
    const SineCosine _e4 = sine_cosine(min(y_11, PHASE_LIMIT));
    const float _e11 = exponential((2.0 * min(y_11, 20.0)));
    float sigmoid = (1.0 - (2.0 / (_e11 + 1.0)));
    float offset_5 = (y_11 - VELINOV_OFFSET);
    float value_5 = (((HALF_PI * sigmoid) - ((VELINOV_BUMP * y_11) / (1.0 + (offset_5 * offset_5)))) + ((1.0 - _e4.cosine) / (1.0 + y_11)));
    const float _e34 = odd_continuation(x_7, value_5);
    return _e34;
}

ArcEnds ConstructArcEnds(float arg0, float arg1, bool arg2) {
    ArcEnds ret = (ArcEnds)0;
    ret.near = arg0;
    ret.far = arg1;
    ret.straddles = arg2;
    return ret;
}

// Returns the ends of the arc from q0 to q1.
ArcEnds arc_ends(float first, float last)
{
    bool local = (bool)0;

    float a_7 = abs(first);
    float b_11 = abs(last);
    bool swap = (b_11 < a_7);
    if ((min(first, last) < 0.0)) {
        local = (max(first, last) > 0.0);
    } else {
        local = false;
    }
    bool _e16 = local;
    const ArcEnds arcends = ConstructArcEnds((swap ? b_11 : a_7), (swap ? a_7 : b_11), _e16);
    return arcends;
}

// Returns the two nodes m - s and m + s of the Gauss sum, sin^2 t / t^2 each, added.
float arc_node_pair(SineCosine middle, SineCosine node, float m, float s)
{
    float even = (middle.sine * node.cosine);
    float odd = (middle.cosine * node.sine);
    float right_1 = ((even + odd) / (m + s));
    float left_1 = ((even - odd) / (m - s));
    return ((right_1 * right_1) + (left_1 * left_1));
}

// Returns the phase of the middle of a short arc, within a quarter turn of 0.
float arc_middle_phase(float rest, float halved)
{
    float phase_3 = (rest + halved);
    return ((phase_3 > HALF_PI) ? (phase_3 - ARC_PI) : phase_3);
}

// Returns one of the three cases of an arc of a given extent from its parts.
//
// `near_line` and `far_line` are H at the ends where they are below the border, `near_wave` and
// `far_wave` what the
// tails have beside 1/(2q), `gauss_sum` the Gauss sum.
float arc_join(ArcEnds ends, float extent, float border, float near_line, float far_line, float near_wave, float far_wave, float gauss_sum)
{
    bool local_1 = (bool)0;

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
float arc_head(float q)
{
    float u_8 = (q * q);
    float p_2 = (ARC_HEAD_A + (u_8 * (ARC_HEAD_B + (u_8 * (ARC_HEAD_C + (u_8 * (ARC_HEAD_D + (u_8 * (ARC_HEAD_E + (u_8 * ARC_HEAD_F))))))))));
    return (q + (q * (u_8 * p_2)));
}

// Returns pi/2 - H(2q) - 1/(2q) for q above the border, from the phase of q reduced by half turns,
// to f32 grade.
float arc_wave(float q_1, SineCosine phase)
{
    float v_5 = (0.5 / q_1);
    float w_1 = (v_5 * v_5);
    float k_1 = (w_1 * (ARC_K_A + (w_1 * (ARC_K_B + (w_1 * (ARC_K_C + (w_1 * (ARC_K_D + (w_1 * ARC_K_E)))))))));
    float d_3 = (1.0 + (w_1 * (ARC_D_A + (w_1 * (ARC_D_B + (w_1 * (ARC_D_C + (w_1 * (ARC_D_D + (w_1 * ARC_D_E))))))))));
    float m_3 = (1.0 + (w_1 * (ARC_G_A + (w_1 * (ARC_G_B + (w_1 * (ARC_G_C + (w_1 * ARC_G_D))))))));
    float twice = (phase.sine + phase.sine);
    float double_sine = (twice * phase.cosine);
    float double_cosine = (1.0 - (twice * phase.sine));
    return (((double_sine * (w_1 * m_3)) - (double_cosine * (v_5 * k_1))) / d_3);
}

// Returns the Gauss sum over a short arc that begins at q with the phase `rest`, to f32 grade.
float arc_short(float q_2, float extent_1, float rest_1)
{
    float halved_3 = (0.5 * extent_1);
    float m_4 = (q_2 + halved_3);
    const float _e6 = arc_middle_phase(rest_1, halved_3);
    const SineCosine _e7 = sine_cosine_near(_e6);
    float inner = (halved_3 * GAUSS_INNER);
    float outer = (halved_3 * GAUSS_OUTER);
    const SineCosine _e12 = sine_cosine_near(inner);
    const float _e13 = arc_node_pair(_e7, _e12, m_4, inner);
    const SineCosine _e14 = sine_cosine_near(outer);
    const float _e15 = arc_node_pair(_e7, _e14, m_4, outer);
    return (halved_3 * ((GAUSS_INNER_WEIGHT * _e13) + (GAUSS_OUTER_WEIGHT * _e15)));
}

// Returns the arc from its ends, its extent and the phases of its ends reduced by half turns, to
// f32 grade.
float arc_of_phases(ArcEnds ends_1, float extent_2, float near_rest, float far_rest)
{
    const SineCosine _e5 = sine_cosine_near(near_rest);
    const float _e6 = arc_wave(ends_1.near, _e5);
    const SineCosine _e8 = sine_cosine_near(far_rest);
    const float _e9 = arc_wave(ends_1.far, _e8);
    const float _e11 = arc_short(ends_1.near, extent_2, near_rest);
    const float _e14 = arc_head(ends_1.near);
    const float _e16 = arc_head(ends_1.far);
    const float _e17 = arc_join(ends_1, extent_2, ARC_BORDER, _e14, _e16, _e6, _e9, _e11);
    return _e17;
}

// Returns the integral of (sin t / t)^2 from q0 to q1 (radians), whose difference is known apart
// from them, to f32 grade;
// `extent` is its magnitude.
float arc_of_extent(float first_1, float last_1, float extent_3)
{
    const ArcEnds _e3 = arc_ends(first_1, last_1);
    const HalfTurns _e7 = reduce_half_turns(min(_e3.near, ARC_PHASE_LIMIT));
    const HalfTurns _e11 = reduce_half_turns(min(_e3.far, ARC_PHASE_LIMIT));
    const float _e14 = arc_of_phases(_e3, extent_3, _e7.rest, _e11.rest);
    return ((last_1 < first_1) ? -(_e14) : _e14);
}

// Returns the integral of (sin t / t)^2 from q0 to q1 (radians), to f32 grade.
//
// Never negative for q0 <= q1, antisymmetric in its bounds, even in their signs. The phase is exact
// to 1e-7 for
// |q| to 1e4. VWH18 Eq. 27.
float sinc_squared_integral(float first_2, float last_2)
{
    const float _e6 = arc_of_extent(first_2, last_2, abs((abs(last_2) - abs(first_2))));
    return ((first_2 == last_2) ? 0.0 : _e6);
}

// Returns the distance of the product x y from the nearest integer, exact to 3e-8 for 0 <= x < 256
// and |y| <= 2.
//
// Both factors are cut so that the product of their leading parts fits 24 bits.
float product_fraction(float x_8, float y)
{
    float x_high = (floor((x_8 * 16.0)) * 0.0625);
    float y_high = (floor((y * 2048.0)) * 0.00048828125);
    float product = (x_high * y_high);
    float rest_5 = ((x_high * (y - y_high)) + ((x_8 - x_high) * y));
    float leading_1 = min((product - round(product)), 0.5);
    float fraction = (leading_1 + min(rest_5, 0.5));
    return (fraction - round(fraction));
}

// Returns the integral of (sin t / t)^2 over t = pi (W/lambda) xi between two direction cosines, to
// f32 grade.
//
// `width` is W/lambda, from 0 to 256, dimensionless; `first` and `last` are direction cosines from
// -2 to 2. The phase
// is reduced in turns before it is rounded, so that wide scratches lose nothing. Wider scratches
// lose digits in
// proportion; a negative width has no meaning. VWH18 Eq. 27.
float sinc_squared_integral_turns(float width, float first_3, float last_3)
{
    const ArcEnds _e3 = arc_ends(first_3, last_3);
    float scale = (ARC_PI * width);
    ArcEnds ends_3 = ConstructArcEnds((scale * _e3.near), (scale * _e3.far), _e3.straddles);
    const float _e14 = product_fraction(width, _e3.near);
    float near_rest_1 = (ARC_PI * _e14);
    const float _e18 = product_fraction(width, _e3.far);
    float far_rest_1 = (ARC_PI * _e18);
    const float _e24 = arc_of_phases(ends_3, (scale * (_e3.far - _e3.near)), near_rest_1, far_rest_1);
    float signed_ = ((last_3 < first_3) ? -(_e24) : _e24);
    return ((first_3 == last_3) ? 0.0 : signed_);
}

// Returns H(2q) for q below the border, to 1e-8.
float arc_head_medium(float q_3)
{
    float u_9 = (q_3 * q_3);
    float p_3 = (ARC_MEDIUM_HEAD_A + (u_9 * (ARC_MEDIUM_HEAD_B + (u_9 * (ARC_MEDIUM_HEAD_C + (u_9 * (ARC_MEDIUM_HEAD_D + (u_9 * ARC_MEDIUM_HEAD_E))))))));
    return (q_3 + (q_3 * (u_9 * p_3)));
}

// Returns pi/2 - H(2q) - 1/(2q) for q above the border, to about 1e-6 of 1/(2q).
float arc_wave_medium(float q_4, SineCosine phase_1)
{
    float v_6 = (0.5 / q_4);
    float w_2 = (v_6 * v_6);
    float k_2 = (w_2 * (ARC_MEDIUM_K_A + (w_2 * (ARC_MEDIUM_K_B + (w_2 * (ARC_MEDIUM_K_C + (w_2 * ARC_MEDIUM_K_D)))))));
    float d_4 = (1.0 + (w_2 * (ARC_MEDIUM_D_A + (w_2 * (ARC_MEDIUM_D_B + (w_2 * (ARC_MEDIUM_D_C + (w_2 * ARC_MEDIUM_D_D))))))));
    float m_5 = (1.0 + (w_2 * (ARC_MEDIUM_G_A + (w_2 * (ARC_MEDIUM_G_B + (w_2 * ARC_MEDIUM_G_C))))));
    float twice_1 = (phase_1.sine + phase_1.sine);
    float double_sine_1 = (twice_1 * phase_1.cosine);
    float double_cosine_1 = (1.0 - (twice_1 * phase_1.sine));
    return (((double_sine_1 * (w_2 * m_5)) - (double_cosine_1 * (v_6 * k_2))) / d_4);
}

// Returns the arc of [`sinc_squared_integral`] to 5e-6 absolute.
float sinc_squared_integral_medium(float first_4, float last_4)
{
    const ArcEnds _e2 = arc_ends(first_4, last_4);
    float extent_5 = (_e2.far - _e2.near);
    const HalfTurns _e9 = reduce_half_turns(min(_e2.near, ARC_PHASE_LIMIT));
    const HalfTurns _e13 = reduce_half_turns(min(_e2.far, ARC_PHASE_LIMIT));
    const SineCosine _e16 = sine_cosine_near_medium(_e9.rest);
    const float _e17 = arc_wave_medium(_e2.near, _e16);
    const SineCosine _e20 = sine_cosine_near_medium(_e13.rest);
    const float _e21 = arc_wave_medium(_e2.far, _e20);
    float halved_4 = (0.5 * extent_5);
    float m_6 = (_e2.near + halved_4);
    const float _e27 = arc_middle_phase(_e9.rest, halved_4);
    const SineCosine _e28 = sine_cosine_near_medium(_e27);
    float inner_1 = (halved_4 * GAUSS_INNER);
    float outer_1 = (halved_4 * GAUSS_OUTER);
    const SineCosine _e33 = sine_cosine_near_medium(inner_1);
    const float _e34 = arc_node_pair(_e28, _e33, m_6, inner_1);
    const SineCosine _e35 = sine_cosine_near_medium(outer_1);
    const float _e36 = arc_node_pair(_e28, _e35, m_6, outer_1);
    float gauss_sum_1 = (halved_4 * ((GAUSS_INNER_WEIGHT * _e34) + (GAUSS_OUTER_WEIGHT * _e36)));
    const float _e45 = arc_head_medium(_e2.near);
    const float _e47 = arc_head_medium(_e2.far);
    const float _e48 = arc_join(_e2, extent_5, ARC_MEDIUM_BORDER, _e45, _e47, _e17, _e21, gauss_sum_1);
    float signed_1 = ((last_4 < first_4) ? -(_e48) : _e48);
    return ((first_4 == last_4) ? 0.0 : signed_1);
}

// Returns H(2q) for q below the border, to 6e-6.
float arc_head_coarse(float q_5)
{
    float u_10 = (q_5 * q_5);
    float p_4 = (ARC_COARSE_HEAD_A + (u_10 * (ARC_COARSE_HEAD_B + (u_10 * (ARC_COARSE_HEAD_C + (u_10 * ARC_COARSE_HEAD_D))))));
    return (q_5 + (q_5 * (u_10 * p_4)));
}

// Returns pi/2 - H(2q) - 1/(2q) for q above the border, to about 3e-4 of 1/(2q).
float arc_wave_coarse(float q_6, SineCosine phase_2)
{
    float v_7 = (0.5 / q_6);
    float w_3 = (v_7 * v_7);
    float k_3 = (w_3 * (ARC_COARSE_K_A + (w_3 * (ARC_COARSE_K_B + (w_3 * ARC_COARSE_K_C)))));
    float d_5 = (1.0 + (w_3 * (ARC_COARSE_D_A + (w_3 * (ARC_COARSE_D_B + (w_3 * ARC_COARSE_D_C))))));
    float m_7 = (1.0 + (w_3 * (ARC_COARSE_G_A + (w_3 * ARC_COARSE_G_B))));
    float twice_2 = (phase_2.sine + phase_2.sine);
    float double_sine_2 = (twice_2 * phase_2.cosine);
    float double_cosine_2 = (1.0 - (twice_2 * phase_2.sine));
    return (((double_sine_2 * (w_3 * m_7)) - (double_cosine_2 * (v_7 * k_3))) / d_5);
}

// Returns the arc of [`sinc_squared_integral`] to 4e-4 absolute.
float sinc_squared_integral_coarse(float first_5, float last_5)
{
    const ArcEnds _e2 = arc_ends(first_5, last_5);
    float extent_6 = (_e2.far - _e2.near);
    const HalfTurns _e9 = reduce_half_turns(min(_e2.near, ARC_PHASE_LIMIT));
    const HalfTurns _e13 = reduce_half_turns(min(_e2.far, ARC_PHASE_LIMIT));
    const SineCosine _e16 = sine_cosine_near_coarse(_e9.rest);
    const float _e17 = arc_wave_coarse(_e2.near, _e16);
    const SineCosine _e20 = sine_cosine_near_coarse(_e13.rest);
    const float _e21 = arc_wave_coarse(_e2.far, _e20);
    float halved_5 = (0.5 * extent_6);
    float m_8 = (_e2.near + halved_5);
    const float _e27 = arc_middle_phase(_e9.rest, halved_5);
    const SineCosine _e28 = sine_cosine_near_coarse(_e27);
    float outer_2 = (halved_5 * GAUSS_THREE);
    const SineCosine _e31 = sine_cosine_near_coarse(outer_2);
    const float _e32 = arc_node_pair(_e28, _e31, m_8, outer_2);
    float centre = (_e28.sine / m_8);
    float gauss_sum_2 = (halved_5 * ((GAUSS_THREE_OUTER_WEIGHT * _e32) + ((GAUSS_THREE_MIDDLE_WEIGHT * centre) * centre)));
    const float _e44 = arc_head_coarse(_e2.near);
    const float _e46 = arc_head_coarse(_e2.far);
    const float _e47 = arc_join(_e2, extent_6, ARC_COARSE_BORDER, _e44, _e46, _e17, _e21, gauss_sum_2);
    float signed_2 = ((last_5 < first_5) ? -(_e47) : _e47);
    return ((first_5 == last_5) ? 0.0 : signed_2);
}

// Returns the bracket of VWH18 Eq. 27, Si(2q) - sin^2 q / q with the fit of Eq. 29, 0 at q = 0.
float arc_antiderivative_velinov(float q_7)
{
    const SineCosine _e1 = sine_cosine(q_7);
    float sine_2 = _e1.sine;
    float square = ((q_7 == 0.0) ? 0.0 : ((sine_2 * sine_2) / q_7));
    const float _e10 = sine_integral_velinov((q_7 + q_7));
    return (_e10 - square);
}

// Returns the arc by VWH18 Eq. 27 with the fit of Eq. 29.
//
// Kept to compare with: negative for many arcs that do not contain the peak.
float sinc_squared_integral_velinov(float first_6, float last_6)
{
    const float _e2 = arc_antiderivative_velinov(last_6);
    const float _e3 = arc_antiderivative_velinov(first_6);
    return (_e2 - _e3);
}

BesselPowers ConstructBesselPowers(float arg0, bool arg1, uint arg2) {
    BesselPowers ret = (BesselPowers)0;
    ret.rest = arg0;
    ret.high = arg1;
    ret.exponent = arg2;
    return ret;
}

// Returns x >= 1 taken apart.
BesselPowers bessel_powers(float x_9)
{
    uint bits = asuint(x_9);
    float mantissa = asfloat(((bits & 8388607u) | 1065353216u));
    bool high = (mantissa >= BESSEL_SPLIT);
    float centre_1 = (high ? BESSEL_HIGH_CENTRE : BESSEL_LOW_CENTRE);
    float inverse = (high ? BESSEL_HIGH_INVERSE : BESSEL_LOW_INVERSE);
    const BesselPowers besselpowers = ConstructBesselPowers(((mantissa - centre_1) * inverse), high, ((bits >> 23u) & 255u));
    return besselpowers;
}

// Returns e to the -|x| times I0(x), to 1 unit of the last place.
//
// Any x; even; 1 at 0, falls as 1/sqrt(2 pi |x|), 0 at infinity.
float bessel_i0_scaled(float x_10)
{
    float y_12 = abs(x_10);
    float near_y = min(y_12, BESSEL_FOURTH_END);
    bool second_4 = (near_y >= BESSEL_FIRST_END);
    bool third_1 = (near_y >= BESSEL_SECOND_END);
    bool fourth = (near_y >= BESSEL_THIRD_END);
    float centre_low = (second_4 ? BESSEL_SECOND_CENTRE : BESSEL_FIRST_CENTRE);
    float centre_high = (fourth ? BESSEL_FOURTH_CENTRE : BESSEL_THIRD_CENTRE);
    float centre_2 = (third_1 ? centre_high : centre_low);
    float value_low = (second_4 ? BESSEL_SECOND_VALUE : BESSEL_FIRST_VALUE);
    float value_high = (fourth ? BESSEL_FOURTH_VALUE : BESSEL_THIRD_VALUE);
    float value_7 = (third_1 ? value_high : value_low);
    float pa_low = (second_4 ? BESSEL_SECOND_A : BESSEL_FIRST_A);
    float pa_high = (fourth ? BESSEL_FOURTH_A : BESSEL_THIRD_A);
    float pa = (third_1 ? pa_high : pa_low);
    float pb_low = (second_4 ? BESSEL_SECOND_B : BESSEL_FIRST_B);
    float pb_high = (fourth ? BESSEL_FOURTH_B : BESSEL_THIRD_B);
    float pb = (third_1 ? pb_high : pb_low);
    float pc_low = (second_4 ? BESSEL_SECOND_C : BESSEL_FIRST_C);
    float pc_high = (fourth ? BESSEL_FOURTH_C : BESSEL_THIRD_C);
    float pc = (third_1 ? pc_high : pc_low);
    float pd_low = (second_4 ? BESSEL_SECOND_D : BESSEL_FIRST_D);
    float pd_high = (fourth ? BESSEL_FOURTH_D : BESSEL_THIRD_D);
    float pd = (third_1 ? pd_high : pd_low);
    float pe_low = (second_4 ? BESSEL_SECOND_E : BESSEL_FIRST_E);
    float pe_high = (fourth ? BESSEL_FOURTH_E : BESSEL_THIRD_E);
    float pe = (third_1 ? pe_high : pe_low);
    float pf_low = (second_4 ? BESSEL_SECOND_F : BESSEL_FIRST_F);
    float pf_high = (fourth ? BESSEL_FOURTH_F : BESSEL_THIRD_F);
    float pf = (third_1 ? pf_high : pf_low);
    float pg_low = (second_4 ? BESSEL_SECOND_G : BESSEL_FIRST_G);
    float pg_high = (fourth ? BESSEL_FOURTH_G : BESSEL_THIRD_G);
    float pg = (third_1 ? pg_high : pg_low);
    float ph = (fourth ? BESSEL_FOURTH_H : 0.0);
    float pi = (fourth ? BESSEL_FOURTH_I : 0.0);
    float d_6 = (near_y - centre_2);
    float upper = (pd + (d_6 * (pe + (d_6 * (pf + (d_6 * (pg + (d_6 * (ph + (d_6 * pi))))))))));
    float near_1 = (value_7 + (d_6 * (pa + (d_6 * (pb + (d_6 * (pc + (d_6 * upper))))))));
    const BesselPowers _e100 = bessel_powers(max(y_12, BESSEL_FOURTH_END));
    bool odd_1 = ((_e100.exponent & 1u) == 0u);
    float low_root = (odd_1 ? BESSEL_LOW_ODD : BESSEL_LOW_EVEN);
    float high_root = (odd_1 ? BESSEL_HIGH_ODD : BESSEL_HIGH_EVEN);
    float scale_1 = asfloat(((191u - ((_e100.exponent + 1u) >> 1u)) << 23u));
    float root = ((_e100.high ? high_root : low_root) * scale_1);
    float t = _e100.rest;
    float upper_root = (BESSEL_ROOT_E + (t * (BESSEL_ROOT_F + (t * BESSEL_ROOT_G))));
    float bend = (BESSEL_ROOT_A + (t * (BESSEL_ROOT_B + (t * (BESSEL_ROOT_C + (t * (BESSEL_ROOT_D + (t * upper_root))))))));
    float q_11 = (t * bend);
    float whole_root = (root + (root * q_11));
    float v_8 = (whole_root * whole_root);
    bool tail_3 = (y_12 >= BESSEL_OUTER_END);
    float w_4 = (v_8 - (tail_3 ? 0.0 : BESSEL_OUTER_CENTRE));
    float ga = (tail_3 ? 0.0 : BESSEL_OUTER_A);
    float gb = (tail_3 ? BESSEL_TAIL_A : BESSEL_OUTER_B);
    float gc = (tail_3 ? BESSEL_TAIL_B : BESSEL_OUTER_C);
    float gd = (tail_3 ? BESSEL_TAIL_C : BESSEL_OUTER_D);
    float ge = (tail_3 ? BESSEL_TAIL_D : BESSEL_OUTER_E);
    float gf = (tail_3 ? BESSEL_TAIL_E : BESSEL_OUTER_F);
    float gg = (tail_3 ? BESSEL_TAIL_F : BESSEL_OUTER_G);
    float gh = (tail_3 ? BESSEL_TAIL_G : BESSEL_OUTER_H);
    float gi = (tail_3 ? BESSEL_TAIL_H : BESSEL_OUTER_I);
    float upper_growth = (ge + (w_4 * (gf + (w_4 * (gg + (w_4 * (gh + (w_4 * gi))))))));
    float growth = (ga + (w_4 * (gb + (w_4 * (gc + (w_4 * (gd + (w_4 * upper_growth))))))));
    float far = (root + (root * (q_11 + (growth + (q_11 * growth)))));
    float finite_1 = ((y_12 >= BESSEL_FOURTH_END) ? far : near_1);
    return ((asuint(y_12) == 2139095040u) ? 0.0 : finite_1);
}

// Returns ln I0(x), to 2 units of the last place.
//
// Any x; even; x^2/4 near 0, |x| - ln(2 pi |x|)/2 far from it.
float log_bessel_izero(float x_11)
{
    float y_13 = abs(x_11);
    float bounded_4 = min(y_13, BESSEL_HEAD_END);
    float u_11 = (bounded_4 * bounded_4);
    float bend_1 = (BESSEL_LOG_HEAD_A + (u_11 * (BESSEL_LOG_HEAD_B + (u_11 * (BESSEL_LOG_HEAD_C + (u_11 * (BESSEL_LOG_HEAD_D + (u_11 * BESSEL_LOG_HEAD_E))))))));
    float head_3 = (u_11 * (0.25 + (u_11 * bend_1)));
    float middle_y = min(y_13, BESSEL_BORDER);
    bool second_5 = (middle_y >= BESSEL_LOG_FIRST_END);
    bool third_2 = (middle_y >= BESSEL_LOG_SECOND_END);
    float centre_low_1 = (second_5 ? BESSEL_LOG_SECOND_CENTRE : BESSEL_LOG_FIRST_CENTRE);
    float centre_3 = (third_2 ? BESSEL_LOG_THIRD_CENTRE : centre_low_1);
    float value_low_1 = (second_5 ? BESSEL_LOG_SECOND_VALUE : BESSEL_LOG_FIRST_VALUE);
    float value_8 = (third_2 ? BESSEL_LOG_THIRD_VALUE : value_low_1);
    float pa_low_1 = (second_5 ? BESSEL_LOG_SECOND_A : BESSEL_LOG_FIRST_A);
    float pa_1 = (third_2 ? BESSEL_LOG_THIRD_A : pa_low_1);
    float pb_low_1 = (second_5 ? BESSEL_LOG_SECOND_B : BESSEL_LOG_FIRST_B);
    float pb_1 = (third_2 ? BESSEL_LOG_THIRD_B : pb_low_1);
    float pc_low_1 = (second_5 ? BESSEL_LOG_SECOND_C : BESSEL_LOG_FIRST_C);
    float pc_1 = (third_2 ? BESSEL_LOG_THIRD_C : pc_low_1);
    float pd_low_1 = (second_5 ? BESSEL_LOG_SECOND_D : BESSEL_LOG_FIRST_D);
    float pd_1 = (third_2 ? BESSEL_LOG_THIRD_D : pd_low_1);
    float pe_low_1 = (second_5 ? BESSEL_LOG_SECOND_E : BESSEL_LOG_FIRST_E);
    float pe_1 = (third_2 ? BESSEL_LOG_THIRD_E : pe_low_1);
    float pf_low_1 = (second_5 ? BESSEL_LOG_SECOND_F : BESSEL_LOG_FIRST_F);
    float pf_1 = (third_2 ? BESSEL_LOG_THIRD_F : pf_low_1);
    float pg_high_1 = (third_2 ? BESSEL_LOG_THIRD_G : BESSEL_LOG_SECOND_G);
    float pg_1 = (second_5 ? pg_high_1 : 0.0);
    float d_7 = (middle_y - centre_3);
    float upper_1 = (pd_1 + (d_7 * (pe_1 + (d_7 * (pf_1 + (d_7 * pg_1))))));
    float middle_3 = (value_8 + (d_7 * (pa_1 + (d_7 * (pb_1 + (d_7 * (pc_1 + (d_7 * upper_1))))))));
    const BesselPowers _e90 = bessel_powers(max(y_13, BESSEL_BORDER));
    float t_1 = _e90.rest;
    float upper_log = (BESSEL_LN_E + (t_1 * (BESSEL_LN_F + (t_1 * BESSEL_LN_G))));
    float logarithm = (t_1 * (BESSEL_LN_A + (t_1 * (BESSEL_LN_B + (t_1 * (BESSEL_LN_C + (t_1 * (BESSEL_LN_D + (t_1 * upper_log)))))))));
    float v_9 = (1.0 / max(y_13, BESSEL_BORDER));
    float upper_growth_1 = (BESSEL_LOG_TAIL_E + (v_9 * (BESSEL_LOG_TAIL_F + (v_9 * (BESSEL_LOG_TAIL_G + (v_9 * BESSEL_LOG_TAIL_H))))));
    float lower_growth = (BESSEL_LOG_TAIL_B + (v_9 * (BESSEL_LOG_TAIL_C + (v_9 * (BESSEL_LOG_TAIL_D + (v_9 * upper_growth_1))))));
    float growth_1 = (v_9 * (BESSEL_LOG_TAIL_A + (v_9 * lower_growth)));
    float constant = (_e90.high ? BESSEL_HIGH_LOG : BESSEL_LOW_LOG);
    float exponent = float((_e90.exponent - 127u));
    float half_log = ((exponent * BESSEL_HALF_LN_TWO) + (constant + (logarithm - growth_1)));
    float near_2 = ((y_13 >= BESSEL_HEAD_END) ? middle_3 : head_3);
    return ((y_13 >= BESSEL_BORDER) ? (y_13 - half_log) : near_2);
}

// Returns I1(x)/I0(x), to 2 units of the last place.
//
// Any x; odd; x/2 near 0, 1 - 1/(2x) far from it. The derivative of [`log_bessel_izero`].
float bessel_ratio(float x_12)
{
    float y_14 = abs(x_12);
    float bounded_5 = min(y_14, BESSEL_HEAD_END);
    float u_12 = (bounded_5 * bounded_5);
    float bend_2 = (BESSEL_RATIO_HEAD_A + (u_12 * (BESSEL_RATIO_HEAD_B + (u_12 * (BESSEL_RATIO_HEAD_C + (u_12 * (BESSEL_RATIO_HEAD_D + (u_12 * BESSEL_RATIO_HEAD_E))))))));
    float head_4 = (bounded_5 * (0.5 + (u_12 * bend_2)));
    float middle_y_1 = min(y_14, BESSEL_BORDER);
    bool second_6 = (middle_y_1 >= BESSEL_RATIO_FIRST_END);
    float centre_4 = (second_6 ? BESSEL_RATIO_SECOND_CENTRE : BESSEL_RATIO_FIRST_CENTRE);
    float value_9 = (second_6 ? BESSEL_RATIO_SECOND_VALUE : BESSEL_RATIO_FIRST_VALUE);
    float pa_2 = (second_6 ? BESSEL_RATIO_SECOND_A : BESSEL_RATIO_FIRST_A);
    float pb_2 = (second_6 ? BESSEL_RATIO_SECOND_B : BESSEL_RATIO_FIRST_B);
    float pc_2 = (second_6 ? BESSEL_RATIO_SECOND_C : BESSEL_RATIO_FIRST_C);
    float pd_2 = (second_6 ? BESSEL_RATIO_SECOND_D : BESSEL_RATIO_FIRST_D);
    float pe_2 = (second_6 ? BESSEL_RATIO_SECOND_E : BESSEL_RATIO_FIRST_E);
    float pf_2 = (second_6 ? BESSEL_RATIO_SECOND_F : BESSEL_RATIO_FIRST_F);
    float pg_2 = (second_6 ? BESSEL_RATIO_SECOND_G : BESSEL_RATIO_FIRST_G);
    float ph_1 = (second_6 ? BESSEL_RATIO_SECOND_H : 0.0);
    float d_8 = (middle_y_1 - centre_4);
    float upper_2 = (pd_2 + (d_8 * (pe_2 + (d_8 * (pf_2 + (d_8 * (pg_2 + (d_8 * ph_1))))))));
    float middle_4 = (value_9 + (d_8 * (pa_2 + (d_8 * (pb_2 + (d_8 * (pc_2 + (d_8 * upper_2))))))));
    float v_10 = (1.0 / max(y_14, BESSEL_BORDER));
    float top = (BESSEL_RATIO_TAIL_H + (v_10 * (BESSEL_RATIO_TAIL_I + (v_10 * BESSEL_RATIO_TAIL_J))));
    float upper_tail = (BESSEL_RATIO_TAIL_E + (v_10 * (BESSEL_RATIO_TAIL_F + (v_10 * (BESSEL_RATIO_TAIL_G + (v_10 * top))))));
    float lower_tail = (BESSEL_RATIO_TAIL_B + (v_10 * (BESSEL_RATIO_TAIL_C + (v_10 * (BESSEL_RATIO_TAIL_D + (v_10 * upper_tail))))));
    float tail_4 = (1.0 - (v_10 * (BESSEL_RATIO_TAIL_A + (v_10 * lower_tail))));
    float near_3 = ((y_14 >= BESSEL_HEAD_END) ? middle_4 : head_4);
    const float _e114 = odd_continuation(x_12, ((y_14 >= BESSEL_BORDER) ? tail_4 : near_3));
    return _e114;
}

PowerOfE ConstructPowerOfE(float arg0, float arg1, float arg2) {
    PowerOfE ret = (PowerOfE)0;
    ret.mantissa = arg0;
    ret.first = arg1;
    ret.second = arg2;
    return ret;
}

// Returns e to the sum of a leading part from -110 to 176 and a small rest.
//
// The leading part may carry all its digits: it is reduced before the rest is added.
PowerOfE power_of_e(float leading, float rest_2)
{
    float n_6 = round(((leading + rest_2) * LOG_TWO_E));
    float r_4 = ((leading - (n_6 * LN_TWO_HIGH)) + (rest_2 - (n_6 * LN_TWO_LOW)));
    float e_2 = (EXPONENTIAL_A + (r_4 * (EXPONENTIAL_B + (r_4 * (EXPONENTIAL_C + (r_4 * (EXPONENTIAL_D + (r_4 * EXPONENTIAL_E))))))));
    float halved_6 = round((n_6 * 0.5));
    const PowerOfE powerofe = ConstructPowerOfE((1.0 + (r_4 * (1.0 + (r_4 * e_2)))), asfloat((asuint((halved_6 + EXPONENT_BIAS)) << 23u)), asfloat((asuint(((n_6 - halved_6) + EXPONENT_BIAS)) << 23u)));
    return powerofe;
}

// Returns the twelve leading bits of x: the product of two such numbers is exact.
float leading_bits(float x_13)
{
    return asfloat((asuint(x_13) & 4294963200u));
}

// Returns x y/pi less the nearest integer, for x y in radians.
float product_turns(float x_14, float y_1)
{
    const float _e2 = leading_bits(x_14);
    const float _e3 = leading_bits(y_1);
    float leading_2 = min(max((_e2 * _e3), -33554432.0), PHASE_LIMIT);
    float rest_6 = ((_e2 * (y_1 - _e3)) + ((x_14 - _e2) * y_1));
    float bounded_6 = min(max(rest_6, -33554432.0), PHASE_LIMIT);
    float n_7 = round((leading_2 * INVERSE_PI));
    float turns_3 = (((leading_2 - (n_7 * PI_HIGH)) - (n_7 * PI_LOW)) * INVERSE_PI);
    float small = (bounded_6 * INVERSE_PI);
    float sum_5 = (turns_3 + (small - round(small)));
    return (sum_5 - round(sum_5));
}

Complex ConstructComplex(float arg0, float arg1) {
    Complex ret = (Complex)0;
    ret.re = arg0;
    ret.im = arg1;
    return ret;
}

// Returns the polynomial of the near or of the far fit at v, in the upper half plane.
Complex faddeeva_polynomial(Complex v_1, bool near)
{
    float s_10 = (v_1.re + v_1.re);
    float t_2 = ((v_1.re * v_1.re) + (v_1.im * v_1.im));
    float p_o = (near ? FADDEEVA_NEAR_O : FADDEEVA_FAR_O);
    float p_n = ((near ? FADDEEVA_NEAR_N : FADDEEVA_FAR_N) + (s_10 * p_o));
    float p_m = (((near ? FADDEEVA_NEAR_M : FADDEEVA_FAR_M) - (t_2 * p_o)) + (s_10 * p_n));
    float p_l = (((near ? FADDEEVA_NEAR_L : FADDEEVA_FAR_L) - (t_2 * p_n)) + (s_10 * p_m));
    float p_k = (((near ? FADDEEVA_NEAR_K : FADDEEVA_FAR_K) - (t_2 * p_m)) + (s_10 * p_l));
    float p_j = (((near ? FADDEEVA_NEAR_J : FADDEEVA_FAR_J) - (t_2 * p_l)) + (s_10 * p_k));
    float p_i = (((near ? FADDEEVA_NEAR_I : FADDEEVA_FAR_I) - (t_2 * p_k)) + (s_10 * p_j));
    float p_h = (((near ? FADDEEVA_NEAR_H : FADDEEVA_FAR_H) - (t_2 * p_j)) + (s_10 * p_i));
    float p_g = (((near ? FADDEEVA_NEAR_G : FADDEEVA_FAR_G) - (t_2 * p_i)) + (s_10 * p_h));
    float p_f = (((near ? FADDEEVA_NEAR_F : FADDEEVA_FAR_F) - (t_2 * p_h)) + (s_10 * p_g));
    float p_e = (((near ? FADDEEVA_NEAR_E : FADDEEVA_FAR_E) - (t_2 * p_g)) + (s_10 * p_f));
    float p_d = (((near ? FADDEEVA_NEAR_D : FADDEEVA_FAR_D) - (t_2 * p_f)) + (s_10 * p_e));
    float p_c = (((near ? FADDEEVA_NEAR_C : FADDEEVA_FAR_C) - (t_2 * p_e)) + (s_10 * p_d));
    float p_b = (((near ? FADDEEVA_NEAR_B : FADDEEVA_FAR_B) - (t_2 * p_d)) + (s_10 * p_c));
    float re_3 = (((near ? FADDEEVA_NEAR_A : FADDEEVA_FAR_A) - (t_2 * p_c)) + (v_1.re * p_b));
    float im_3 = (v_1.im * p_b);
    const Complex complex = ConstructComplex(re_3, im_3);
    return complex;
}

// Returns w(x + i y) for x >= 0 and y >= 0.
Complex faddeeva_quadrant(float x_15, float y_2)
{
    float largest = max(x_15, y_2);
    bool huge = (largest > FADDEEVA_SQUARE_LIMIT);
    float scale_2 = (huge ? FADDEEVA_SHRINK : 1.0);
    float xs = (min(x_15, INFINITE_LIMIT) * scale_2);
    float ys = (min(y_2, INFINITE_LIMIT) * scale_2);
    float square_1 = (xs * xs);
    float size = (square_1 + (ys * ys));
    bool near_4 = (size < (huge ? 0.0 : FADDEEVA_BORDER));
    float pole = (near_4 ? FADDEEVA_NEAR_POLE : FADDEEVA_FAR_POLE);
    float across_1 = (ys + pole);
    float inverse_1 = (1.0 / ((across_1 * across_1) + square_1));
    float along_1 = (ys - FADDEEVA_CENTRE);
    Complex v_11 = ConstructComplex((((along_1 * across_1) + square_1) * inverse_1), -(((pole + FADDEEVA_CENTRE) * (xs * inverse_1))));
    const Complex _e40 = faddeeva_polynomial(v_11, near_4);
    float near_re = (FADDEEVA_AT_CENTRE + ((along_1 * _e40.re) + (xs * _e40.im)));
    float near_im = ((along_1 * _e40.im) - (xs * _e40.re));
    float inverse_square = (inverse_1 * inverse_1);
    float q_square = (((across_1 - xs) * (across_1 + xs)) * inverse_square);
    float q_twice = (((across_1 + across_1) * xs) * inverse_square);
    float f_re = (huge ? 0.0 : ((q_square * _e40.re) - (q_twice * _e40.im)));
    float f_im = (huge ? 0.0 : ((q_square * _e40.im) + (q_twice * _e40.re)));
    float shrink = (INVERSE_ROOT_PI / size);
    float far_re = ((ys + ((ys * f_re) - (xs * f_im))) * shrink);
    float far_im = ((xs + ((xs * f_re) + (ys * f_im))) * shrink);
    float unscale = ((largest > INFINITE_LIMIT) ? 0.0 : scale_2);
    const Complex complex_1 = ConstructComplex(((near_4 ? near_re : far_re) * unscale), ((near_4 ? near_im : far_im) * unscale));
    return complex_1;
}

// Returns 2 exp(-z^2) at z = x - i y for x >= 0 and y > 0.
Complex faddeeva_gaussian(float x_16, float y_3)
{
    bool local_2 = (bool)0;
    bool local_3 = (bool)0;

    float halved_7 = ((y_3 - x_16) * ((0.5 * y_3) + (0.5 * x_16)));
    float rough = (halved_7 + halved_7);
    float largest_1 = max(x_16, y_3);
    uint bits_1 = (asuint(max(min(largest_1, GRID_UPPER_LIMIT), GRID_LOWER_LIMIT)) & 2139095040u);
    float grid = (asfloat(bits_1) * 0.00048828125);
    float inverse_grid = (asfloat((bits_1 ^ 2139095040u)) * 1024.0);
    float x_high_1 = (round((x_16 * inverse_grid)) * grid);
    float y_high_1 = (round((y_3 * inverse_grid)) * grid);
    float exact = ((y_high_1 * y_high_1) - (x_high_1 * x_high_1));
    float small_1 = (((y_3 - y_high_1) * (y_3 + y_high_1)) - ((x_16 - x_high_1) * (x_16 + x_high_1)));
    if (!((largest_1 > GRID_UPPER_LIMIT))) {
        local_2 = (abs(rough) > 104.0);
    } else {
        local_2 = true;
    }
    bool plain = local_2;
    float bounded_7 = min(max(rough, EXPONENT_LOWEST), EXPONENT_HIGHEST);
    const PowerOfE _e59 = power_of_e((plain ? bounded_7 : exact), (plain ? 0.0 : small_1));
    if (!((x_16 == 0.0))) {
        local_3 = (rough < EXPONENT_LOWEST);
    } else {
        local_3 = true;
    }
    bool nothing = local_3;
    const float _e69 = product_turns(x_16, y_3);
    const SineCosine _e75 = sine_cosine_turns((nothing ? 0.0 : (_e69 + (0.0 * y_3))));
    float re_4 = ((_e59.mantissa * _e75.cosine) * _e59.first);
    float im_4 = ((_e59.mantissa * _e75.sine) * _e59.first);
    const Complex complex_2 = ConstructComplex(((re_4 + re_4) * _e59.second), ((im_4 + im_4) * _e59.second));
    return complex_2;
}

// Returns w(re + i im) from its value at |re| + i |im|, by w(z) = 2 exp(-z^2) - w(-z) below the
// real axis.
Complex faddeeva_in_plane(float re, float im, Complex above)
{
    float w_re = (float)0;
    float w_im = (float)0;

    w_re = above.re;
    w_im = above.im;
    if ((im < 0.0)) {
        const Complex _e11 = faddeeva_gaussian(abs(re), abs(im));
        w_re = (_e11.re - above.re);
        w_im = (_e11.im + above.im);
    }
    float _e18 = w_re;
    float _e19 = w_im;
    const float _e20 = odd_continuation(re, _e19);
    const Complex complex_3 = ConstructComplex(_e18, _e20);
    return complex_3;
}

// Returns w(z) = exp(-z^2) erfc(-i z) at z = re + i im, to f32 grade in the upper half plane.
//
// The error counts against |w(z)| above the real axis and on it, and against |2 exp(-z^2)| +
// |w(-z)| below, where
// exponent and phase keep their digits for |z| to 100. w(-conj z) = conj w(z) holds exactly. An
// infinite z gives 0 in
// the upper half plane and on horizontal lines below it; straight down w tends to infinity.
Complex faddeeva_w(float re_1, float im_1)
{
    const Complex _e4 = faddeeva_quadrant(abs(re_1), abs(im_1));
    const Complex _e5 = faddeeva_in_plane(re_1, im_1, _e4);
    const Complex complex_4 = _e5;
    return complex_4;
}

// Returns the polynomial of the coarse tier at v.
Complex faddeeva_polynomial_coarse(Complex v_2)
{
    float s_11 = (v_2.re + v_2.re);
    float t_3 = ((v_2.re * v_2.re) + (v_2.im * v_2.im));
    float p_j_1 = (FADDEEVA_COARSE_J + (s_11 * FADDEEVA_COARSE_K));
    float p_i_1 = ((FADDEEVA_COARSE_I - (t_3 * FADDEEVA_COARSE_K)) + (s_11 * p_j_1));
    float p_h_1 = ((FADDEEVA_COARSE_H - (t_3 * p_j_1)) + (s_11 * p_i_1));
    float p_g_1 = ((FADDEEVA_COARSE_G - (t_3 * p_i_1)) + (s_11 * p_h_1));
    float p_f_1 = ((FADDEEVA_COARSE_F - (t_3 * p_h_1)) + (s_11 * p_g_1));
    float p_e_1 = ((FADDEEVA_COARSE_E - (t_3 * p_g_1)) + (s_11 * p_f_1));
    float p_d_1 = ((FADDEEVA_COARSE_D - (t_3 * p_f_1)) + (s_11 * p_e_1));
    float p_c_1 = ((FADDEEVA_COARSE_C - (t_3 * p_e_1)) + (s_11 * p_d_1));
    float p_b_1 = ((FADDEEVA_COARSE_B - (t_3 * p_d_1)) + (s_11 * p_c_1));
    float re_5 = ((FADDEEVA_COARSE_A - (t_3 * p_c_1)) + (v_2.re * p_b_1));
    float im_5 = (v_2.im * p_b_1);
    const Complex complex_5 = ConstructComplex(re_5, im_5);
    return complex_5;
}

// Returns w(x + i y) for x >= 0 and y >= 0, to 5e-5.
Complex faddeeva_quadrant_coarse(float x_17, float y_4)
{
    float largest_2 = max(x_17, y_4);
    bool huge_1 = (largest_2 > FADDEEVA_SQUARE_LIMIT);
    float scale_3 = (huge_1 ? FADDEEVA_SHRINK : 1.0);
    float xs_1 = (min(x_17, INFINITE_LIMIT) * scale_3);
    float across_2 = ((min(y_4, INFINITE_LIMIT) * scale_3) + (huge_1 ? 0.0 : FADDEEVA_COARSE_POLE));
    float inverse_2 = (1.0 / ((across_2 * across_2) + (xs_1 * xs_1)));
    float q_re = (across_2 * inverse_2);
    float q_im = (xs_1 * inverse_2);
    float double_pole = (huge_1 ? 0.0 : 5.0);
    Complex v_12 = ConstructComplex(((double_pole * q_re) - 1.0), (double_pole * q_im));
    const Complex _e33 = faddeeva_polynomial_coarse(v_12);
    float unscale_1 = ((largest_2 > INFINITE_LIMIT) ? 0.0 : scale_3);
    const Complex complex_6 = ConstructComplex((((q_re * _e33.re) - (q_im * _e33.im)) * unscale_1), (((q_re * _e33.im) + (q_im * _e33.re)) * unscale_1));
    return complex_6;
}

// Returns w(z) of [`faddeeva_w`] to 5e-5.
Complex faddeeva_w_coarse(float re_2, float im_2)
{
    const Complex _e4 = faddeeva_quadrant_coarse(abs(re_2), abs(im_2));
    const Complex _e5 = faddeeva_in_plane(re_2, im_2, _e4);
    const Complex complex_7 = _e5;
    return complex_7;
}

// Returns exp(-a^2 - rest) for a from 0 to 12, or what is left of it.
float erf_gaussian(float a, float rest_3)
{
    const float _e2 = leading_bits(a);
    float square_2 = (_e2 * _e2);
    float low = (((a - _e2) * (a + _e2)) + rest_3);
    const PowerOfE _e16 = power_of_e(max(-(square_2), EXPONENT_LOWEST), ((square_2 > 110.0) ? 0.0 : -(low)));
    return ((_e16.mantissa * _e16.first) * _e16.second);
}

// Returns P(a), for a >= 0, and its conjugate continuation for a < 0.
Complex erf_end(float a_1, float b, float turns_1)
{
    bool local_4 = (bool)0;

    float size_1 = abs(a_1);
    float height = abs(b);
    if (!((size_1 > ERF_END_LARGEST))) {
        local_4 = (height > INFINITE_LIMIT);
    } else {
        local_4 = true;
    }
    bool nothing_1 = local_4;
    const SineCosine _e16 = sine_cosine_turns((nothing_1 ? 0.0 : turns_1));
    const float _e20 = erf_gaussian(min(size_1, ERF_END_LARGEST), 0.0);
    const Complex _e21 = faddeeva_quadrant(height, size_1);
    float im_6 = (((a_1 < 0.0) != (b < 0.0)) ? _e21.im : -(_e21.im));
    const Complex complex_8 = ConstructComplex((_e20 * ((_e21.re * _e16.cosine) + (im_6 * _e16.sine))), (_e20 * ((im_6 * _e16.cosine) - (_e21.re * _e16.sine))));
    return complex_8;
}

// Returns the integral of exp(-s^2 - 2 (m + i b) s) over |s| <= d as a multiple of 2 d, for short
// segments.
//
// The Taylor series in q = (m + i b)^2 d^2 and d^2.
Complex erf_short_series(float middle_1, float b_1, float halved_1)
{
    float d_9 = (halved_1 * halved_1);
    float across_3 = (halved_1 * middle_1);
    float along_2 = (halved_1 * b_1);
    float q_re_1 = ((across_3 - along_2) * (across_3 + along_2));
    float q_im_1 = ((across_3 + across_3) * along_2);
    float k_4 = (1.0 + (d_9 * (-0.33333334 + (d_9 * (0.1 + (d_9 * (-0.023809524 + (d_9 * (0.0046296297 - (d_9 * 0.00075757573))))))))));
    float l = (0.6666667 + (d_9 * (-0.4 + (d_9 * (0.14285715 + (d_9 * (-0.037037037 + (d_9 * 0.007575758))))))));
    float m_9 = (0.13333334 + (d_9 * (-0.0952381 + (d_9 * 0.037037037))));
    float n_8 = (0.012698413 - (d_9 * 0.009876543));
    float first_re = (m_9 + (q_re_1 * n_8));
    float first_im = (q_im_1 * n_8);
    float second_re = (l + ((q_re_1 * first_re) - (q_im_1 * first_im)));
    float second_im = ((q_re_1 * first_im) + (q_im_1 * first_re));
    const Complex complex_9 = ConstructComplex((k_4 + ((q_re_1 * second_re) - (q_im_1 * second_im))), ((q_re_1 * second_im) + (q_im_1 * second_re)));
    return complex_9;
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
Complex erf_difference_scaled_turns(float a_from, float a_to, float b_2, float turns_from, float turns_to)
{
    bool local_5 = (bool)0;
    bool local_6 = (bool)0;

    float extent_7 = (a_to - a_from);
    float halved_8 = (0.5 * extent_7);
    bool nearer_to = (abs(a_to) < abs(a_from));
    float base_2 = (nearer_to ? a_to : a_from);
    float stride = (nearer_to ? -(halved_8) : halved_8);
    float middle_5 = (base_2 + stride);
    float across_4 = (halved_8 * middle_5);
    float along_3 = (halved_8 * b_2);
    if ((abs(halved_8) <= ERF_SHORT)) {
        local_5 = (((across_4 * across_4) + (along_3 * along_3)) <= ERF_SHORT_SQUARE);
    } else {
        local_5 = false;
    }
    bool is_short = local_5;
    float apart = (nearer_to ? (turns_from - turns_to) : (turns_to - turns_from));
    float turns_4 = ((nearer_to ? turns_to : turns_from) + (0.5 * (apart - round(apart))));
    const SineCosine _e38 = sine_cosine_turns(turns_4);
    float rest_7 = (stride * ((base_2 + base_2) + stride));
    const float _e47 = erf_gaussian(min(abs(base_2), ERF_END_LARGEST), rest_7);
    float scale_4 = ((TWO_INVERSE_ROOT_PI * extent_7) * _e47);
    const Complex _e49 = erf_short_series(middle_5, b_2, halved_8);
    float short_re = (scale_4 * ((_e49.re * _e38.cosine) + (_e49.im * _e38.sine)));
    float short_im = (scale_4 * ((_e49.im * _e38.cosine) - (_e49.re * _e38.sine)));
    const Complex _e66 = erf_end(a_from, b_2, turns_from);
    const Complex _e67 = erf_end(a_to, b_2, turns_to);
    float side_from = ((a_from < 0.0) ? -1.0 : 1.0);
    float side_to = ((a_to < 0.0) ? -1.0 : 1.0);
    const float _e83 = erf_gaussian(min(abs(b_2), ERF_END_LARGEST), 0.0);
    float between_1 = ((side_to - side_from) * _e83);
    float long_re = (between_1 + ((side_from * _e66.re) - (side_to * _e67.re)));
    float long_im = ((side_from * _e66.im) - (side_to * _e67.im));
    if ((a_from == a_to)) {
        local_6 = (abs(b_2) >= 0.0);
    } else {
        local_6 = false;
    }
    bool is_empty = local_6;
    const Complex complex_10 = ConstructComplex((is_empty ? 0.0 : (is_short ? short_re : long_re)), (is_empty ? 0.0 : (is_short ? short_im : long_im)));
    return complex_10;
}

// Returns exp(-b^2) (erf(`a_to` + i b) - erf(`a_from` + i b)), the three dimensionless.
//
// As [`erf_difference_scaled_turns`], with the phases formed from exact partial products: they hold
// to 1e-6 for |a b| to
// 1e4, and lose digits in proportion beyond.
Complex erf_difference_scaled(float a_from_1, float a_to_1, float b_3)
{
    const float _e3 = product_turns(a_from_1, b_3);
    const float _e4 = product_turns(a_to_1, b_3);
    const Complex _e5 = erf_difference_scaled_turns(a_from_1, a_to_1, b_3, _e3, _e4);
    const Complex complex_11 = _e5;
    return complex_11;
}

Turns ConstructTurns(float arg0, float arg1) {
    Turns ret = (Turns)0;
    ret.whole = arg0;
    ret.rest = arg1;
    return ret;
}

// Returns a b/c in turns.
//
// The partial products are exact for |a b/c| to 4096; beyond, the error of the rest grows as 2^-35
// |a b/c|.
Turns ratio_turns(float a_2, float b_4, float c)
{
    float whole_1 = round(((a_2 * b_4) / c));
    const float _e6 = leading_bits(a_2);
    const float _e7 = leading_bits(b_4);
    const float _e8 = leading_bits(c);
    const float _e9 = leading_bits(whole_1);
    float leading_3 = min(max(((_e6 * _e7) - (_e9 * _e8)), -33554432.0), PHASE_LIMIT);
    float given = ((_e6 * (b_4 - _e7)) + ((a_2 - _e6) * b_4));
    float taken = ((_e9 * (c - _e8)) + ((whole_1 - _e9) * c));
    const Turns turns_5 = ConstructTurns(whole_1, ((leading_3 + (given - taken)) / c));
    return turns_5;
}

// Returns sin(2 pi t)/(2 pi t) from t and from its sine.
float sinc_turns(Turns turns_2, float sine)
{
    float total_1 = (turns_2.whole + turns_2.rest);
    return ((abs(total_1) < SINC_TURNS_LIMIT) ? 1.0 : (sine / (TWO_PI * total_1)));
}

// Returns W sinc(pi W xi/lambda), in the unit of the width (VWH18 Eq. 3).
float width_term(float width_1, float xi_b, float wavelength)
{
    const Turns _e4 = ratio_turns(width_1, xi_b, (wavelength + wavelength));
    const SineCosine _e6 = sine_cosine_turns(_e4.rest);
    const float _e8 = sinc_turns(_e4, _e6.sine);
    return (width_1 * _e8);
}

// Returns the sine and cosine of half the phase of the depth, pi gamma D/lambda; both may have the
// other sign.
SineCosine depth_half_phase(float depth, float gamma_sum, float wavelength_1)
{
    const Turns _e4 = ratio_turns(depth, gamma_sum, wavelength_1);
    const SineCosine _e7 = sine_cosine_turns((0.5 * _e4.rest));
    const SineCosine sinecosine_5 = _e7;
    return sinecosine_5;
}

// Returns 1 - exp(2 pi i (gamma_i + gamma_o) D/lambda), dimensionless (WVJH17 Eq. 20).
Complex depth_term(float depth_1, float gamma_sum_1, float wavelength_2)
{
    const SineCosine _e3 = depth_half_phase(depth_1, gamma_sum_1, wavelength_2);
    float twice_3 = (_e3.sine + _e3.sine);
    const Complex complex_12 = ConstructComplex((twice_3 * _e3.sine), -((twice_3 * _e3.cosine)));
    return complex_12;
}

// Returns |1 - exp(2 pi i (gamma_i + gamma_o) D/lambda)|^2, from 0 to 4.
float depth_term_squared(float depth_2, float gamma_sum_2, float wavelength_3)
{
    const SineCosine _e3 = depth_half_phase(depth_2, gamma_sum_2, wavelength_3);
    float twice_4 = (_e3.sine + _e3.sine);
    return (twice_4 * twice_4);
}

// Returns W sinc(pi W xi/lambda) (1 - exp(2 pi i (gamma_i + gamma_o) D/lambda)), in the unit of the
// width: mask less
// scratch of a rectangle (VWH18 Eq. 3).
Complex profile_rectangle(float width_2, float depth_3, float xi_b_1, float gamma_sum_3, float wavelength_4)
{
    const float _e5 = width_term(width_2, xi_b_1, wavelength_4);
    const Complex _e6 = depth_term(depth_3, gamma_sum_3, wavelength_4);
    const Complex complex_13 = ConstructComplex((_e5 * _e6.re), (_e5 * _e6.im));
    return complex_13;
}

TriangleFlanks ConstructTriangleFlanks(float arg0, float arg1, SineCosine arg2, SineCosine arg3, float arg4, float arg5) {
    TriangleFlanks ret = (TriangleFlanks)0;
    ret.sinc_a = arg0;
    ret.sinc_b = arg1;
    ret.a = arg2;
    ret.b = arg3;
    ret.deep = arg4;
    ret.across = arg5;
    return ret;
}

// Returns the two sinc of a triangle.
TriangleFlanks triangle_flanks(float width_3, float depth_4, float xi_b_2, float gamma_sum_4, float wavelength_5)
{
    float twice_5 = (wavelength_5 + wavelength_5);
    const Turns _e6 = ratio_turns(depth_4, gamma_sum_4, twice_5);
    const Turns _e8 = ratio_turns(width_3, xi_b_2, (twice_5 + twice_5));
    Turns sum_6 = ConstructTurns((_e6.whole + _e8.whole), (_e6.rest + _e8.rest));
    Turns difference = ConstructTurns((_e6.whole - _e8.whole), (_e6.rest - _e8.rest));
    const SineCosine _e24 = sine_cosine_turns(sum_6.rest);
    const SineCosine _e26 = sine_cosine_turns(difference.rest);
    float halved_9 = (0.5 * width_3);
    const float _e30 = sinc_turns(sum_6, _e24.sine);
    const float _e33 = sinc_turns(difference, _e26.sine);
    const TriangleFlanks triangleflanks = ConstructTriangleFlanks((halved_9 * _e30), (halved_9 * _e33), _e24, _e26, (_e6.whole + _e6.rest), (_e8.whole + _e8.rest));
    return triangleflanks;
}

// Returns the transform of a triangular groove alone, without its mask, in the unit of the width
// (WVJH17 Eq. 29).
//
// Two sinc, each the other's phase: no poles.
Complex profile_triangle(float width_4, float depth_5, float xi_b_3, float gamma_sum_5, float wavelength_6)
{
    const TriangleFlanks _e5 = triangle_flanks(width_4, depth_5, xi_b_3, gamma_sum_5, wavelength_6);
    const Complex complex_14 = ConstructComplex(((_e5.sinc_a * _e5.b.cosine) + (_e5.sinc_b * _e5.a.cosine)), ((_e5.sinc_a * _e5.b.sine) + (_e5.sinc_b * _e5.a.sine)));
    return complex_14;
}

// Returns (1 - exp(i p (1 - u))) cos(w u) at one u, for half phases p/2 and w/2.
Complex triangle_shallow_node(float deep, float across, float u)
{
    const SineCosine _e6 = sine_cosine_near((deep * (1.0 - u)));
    const SineCosine _e11 = sine_cosine_near(((across + across) * u));
    float height_1 = (2.0 * (_e6.sine * _e11.cosine));
    const Complex complex_15 = ConstructComplex((height_1 * _e6.sine), -((height_1 * _e6.cosine)));
    return complex_15;
}

// Returns the response of a triangular groove, mask less scratch, in the unit of the width (WVJH17
// Eqs. 9 and 29).
//
// The difference of mask and [`profile_triangle`] in a deep groove, its own two sinc in a wide one,
// and a Gauss rule of
// four points where both phases are small: a shallow groove keeps its digits.
Complex response_triangle(float width_5, float depth_6, float xi_b_4, float gamma_sum_6, float wavelength_7)
{
    const TriangleFlanks _e5 = triangle_flanks(width_5, depth_6, xi_b_4, gamma_sum_6, wavelength_7);
    const float _e6 = width_term(width_5, xi_b_4, wavelength_7);
    float slope = (_e5.deep / _e5.across);
    bool is_wide = (abs(_e5.deep) <= abs(_e5.across));
    float a_re = (_e5.sinc_a * _e5.b.cosine);
    float a_im = (_e5.sinc_a * _e5.b.sine);
    float b_re = (_e5.sinc_b * _e5.a.cosine);
    float b_im = (_e5.sinc_b * _e5.a.sine);
    float re_6 = (is_wide ? (slope * (a_re - b_re)) : (_e6 - (a_re + b_re)));
    float im_7 = (is_wide ? (slope * (a_im - b_im)) : -((a_im + b_im)));
    float deep_1 = min(max((TWO_PI * _e5.deep), -0.875), 0.875);
    float across_5 = min(max((TWO_PI * _e5.across), -0.875), 0.875);
    bool is_shallow = ((abs(_e5.deep) + abs(_e5.across)) <= TRIANGLE_SHALLOW_LIMIT);
    const Complex _e63 = triangle_shallow_node(deep_1, across_5, 0.06943184);
    const Complex _e65 = triangle_shallow_node(deep_1, across_5, 0.33000946);
    const Complex _e67 = triangle_shallow_node(deep_1, across_5, 0.66999054);
    const Complex _e69 = triangle_shallow_node(deep_1, across_5, 0.93056816);
    float outer_re = (0.17392743 * (_e63.re + _e69.re));
    float outer_im = (0.17392743 * (_e63.im + _e69.im));
    float inner_re = (0.32607257 * (_e65.re + _e67.re));
    float inner_im = (0.32607257 * (_e65.im + _e67.im));
    const Complex complex_16 = ConstructComplex((is_shallow ? (width_5 * (outer_re + inner_re)) : re_6), (is_shallow ? (width_5 * (outer_im + inner_im)) : im_7));
    return complex_16;
}

// Returns a place over a radius, 0 of 0.
float in_radii(float place, float radius)
{
    return ((place == 0.0) ? place : (place / radius));
}

// Returns exp(-r^2/(2 sigma^2)), the coherence window at a distance (WVJH17 Eq. 13).
float coherence_window(float offset, float radius_1)
{
    const float _e2 = in_radii(offset, radius_1);
    const float _e6 = exponential((-0.5 * (_e2 * _e2)));
    return _e6;
}

// Returns the share of the window's amplitude on one infinite scratch at a distance: 1 for a full
// coverage (VWH18 Eq. 17,
// normalised). [`area_density`](super::area_density) is the share of its energy.
float area_density_amplitude(float width_6, float offset_1, float radius_2)
{
    float r_5 = (offset_1 / radius_2);
    const float _e10 = exponential((-0.5 * (r_5 * r_5)));
    return ((INVERSE_ROOT_TWO_PI * (width_6 / radius_2)) * _e10);
}

// Returns sigma k xi, the direction cosine in widths of the transformed window.
float window_cosine(float radius_3, float wavelength_8, float xi)
{
    return ((TWO_PI * radius_3) * (xi / wavelength_8));
}

// Returns a modulus times exp(-2 pi i a b/c), 0 where the modulus is 0.
Complex turned_back(float modulus, float a_3, float b_5, float c_1)
{
    const Turns _e4 = ratio_turns(a_3, b_5, c_1);
    const SineCosine _e10 = sine_cosine_turns(((modulus == 0.0) ? 0.0 : _e4.rest));
    const Complex complex_17 = ConstructComplex((modulus * _e10.cosine), -((modulus * _e10.sine)));
    return complex_17;
}

// Returns eta of a finite scratch, in the unit of the lengths (VWH18 Eq. 5).
//
// `radius` is sigma, `s_t` and `s_b` the scratch's origin along and across it from the shaded
// point, `l_from` and `l_to`
// its ends from the origin, infinite ones allowed; `xi_t` and `xi_b` the scattering vector along
// and across.
Complex spatial_phase(float radius_4, float wavelength_9, float xi_t, float xi_b_5, float s_t, float s_b, float l_from, float l_to)
{
    float height_2 = ((ROOT_TWO_TIMES_PI * radius_4) * (xi_t / wavelength_9));
    const Turns _e12 = ratio_turns(s_t, xi_t, wavelength_9);
    float origin = _e12.rest;
    const float _e16 = in_radii((s_t + l_from), radius_4);
    const float _e20 = in_radii((s_t + l_to), radius_4);
    const Turns _e22 = ratio_turns(l_from, xi_t, wavelength_9);
    const Turns _e25 = ratio_turns(l_to, xi_t, wavelength_9);
    const Complex _e28 = erf_difference_scaled_turns((INVERSE_ROOT_TWO * _e16), (INVERSE_ROOT_TWO * _e20), height_2, (origin + _e22.rest), (origin + _e25.rest));
    const float _e31 = coherence_window(s_b, radius_4);
    const Complex _e33 = turned_back(((ROOT_HALF_PI * radius_4) * _e31), s_b, xi_b_5, wavelength_9);
    const Complex complex_18 = ConstructComplex(((_e28.re * _e33.re) - (_e28.im * _e33.im)), ((_e28.re * _e33.im) + (_e28.im * _e33.re)));
    return complex_18;
}

// Returns eta of an infinite scratch at the distance `s_b` (VWH18 Eq. 8).
Complex spatial_phase_infinite(float radius_5, float wavelength_10, float xi_t_1, float xi_b_6, float s_b_1)
{
    const float _e5 = in_radii(s_b_1, radius_5);
    const float _e6 = window_cosine(radius_5, wavelength_10, xi_t_1);
    const float _e14 = exponential((-0.5 * ((_e5 * _e5) + (_e6 * _e6))));
    float modulus_1 = ((ROOT_TWO_PI * radius_5) * _e14);
    const Complex _e16 = turned_back(modulus_1, s_b_1, xi_b_6, wavelength_10);
    const Complex complex_19 = _e16;
    return complex_19;
}

// Returns |eta|^2 of an infinite scratch at the distance `s_b` (VWH18 Eq. 9).
float spatial_phase_infinite_squared(float radius_6, float wavelength_11, float xi_t_2, float s_b_2)
{
    const float _e4 = in_radii(s_b_2, radius_6);
    const float _e5 = window_cosine(radius_6, wavelength_11, xi_t_2);
    const float _e13 = exponential(-(((_e4 * _e4) + (_e5 * _e5))));
    return (((TWO_PI * radius_6) * radius_6) * _e13);
}

// Returns 2 pi sigma^2 exp(-(sigma k |xi|)^2/2), the transform of the window (WVJH17 Eq. 16).
float base_response(float radius_7, float wavelength_12, float xi_t_3, float xi_b_7)
{
    const float _e4 = window_cosine(radius_7, wavelength_12, xi_t_3);
    const float _e5 = window_cosine(radius_7, wavelength_12, xi_b_7);
    const float _e14 = exponential((-0.5 * ((_e4 * _e4) + (_e5 * _e5))));
    return (((TWO_PI * radius_7) * radius_7) * _e14);
}

// Returns the share of the window's energy on one infinite scratch at a distance: 1 for a full
// coverage.
float area_density(float width_7, float offset_2, float radius_8)
{
    float r_6 = (offset_2 / radius_8);
    const float _e9 = exponential(-((r_6 * r_6)));
    return ((INVERSE_ROOT_PI * (width_7 / radius_8)) * _e9);
}

// Returns 1 - rho, the factor of the scratches' incoherent reflectance; a density above 1 counts as
// 1.
float energy_blend_scratches(float density)
{
    return ((density > 1.0) ? 0.0 : (1.0 - density));
}

// Returns rho (1 - rho) times the squared depth term, the energy that scratches of an area density
// rho scatter: no factor.
//
// A density above 1 counts as 1.
float energy_blend_scattered(float density_1, float depth_squared)
{
    const float _e2 = energy_blend_scratches(density_1);
    return ((density_1 * _e2) * depth_squared);
}

// Returns 1 - rho (1 - rho) times the squared depth term of the mirror direction, the factor of the
// base's reflectance.
float energy_blend_base(float density_2, float depth_squared_1)
{
    const float _e3 = energy_blend_scattered(density_2, depth_squared_1);
    return (1.0 - _e3);
}

// Returns the sum of |S|^2 over A_C lambda^2, in 1/sr (VWH18 Eqs. 6 and 7).
float reflectance_incoherent(float radius_9, float wavelength_13, float squared_sum)
{
    float size_2 = (radius_9 * wavelength_13);
    return (squared_sum / (ARC_PI * (size_2 * size_2)));
}

// Returns |B - S|^2/(A_C lambda^2), in 1/sr (VWH18 Eq. 1; Fresnel factor apart).
float reflectance_coherent(float radius_10, float wavelength_14, float base, float scratches_re, float scratches_im)
{
    float re_7 = (base - scratches_re);
    const float _e9 = reflectance_incoherent(radius_10, wavelength_14, ((re_7 * re_7) + (scratches_im * scratches_im)));
    return _e9;
}

// Returns the mean |S|^2 of an infinite rectangular scratch over a footprint, in the fourth power
// of the lengths' unit.
//
// `mean` is that of the footprint, `footprint_mean`, or exp(-s_b^2/sigma^2) at a point (VWH18 Eqs.
// 9 and 16).
float scratch_squared(float radius_11, float wavelength_15, float width_8, float depth_7, float xi_t_4, float xi_b_8, float gamma_sum_7, float mean)
{
    const float _e8 = width_term(width_8, xi_b_8, wavelength_15);
    const float _e9 = depth_term_squared(depth_7, gamma_sum_7, wavelength_15);
    const float _e10 = window_cosine(radius_11, wavelength_15, xi_t_4);
    const float _e16 = exponential(-((_e10 * _e10)));
    float along_4 = (((TWO_PI * radius_11) * radius_11) * _e16);
    return (((_e8 * _e8) * _e9) * (along_4 * mean));
}

// Returns -2 Re(B S), the interference of base and scratches: |B - S|^2 less |B|^2 + |S|^2 (VWH18
// Eq. 6, corrected).
//
// `base` is B, which is real in the frame of the shaded point, `scratches_re` the real part of the
// sum of all S.
float base_interference(float base_1, float scratches_re_1)
{
    return (-2.0 * (base_1 * scratches_re_1));
}

// Returns a product of two complex numbers.
Complex complex_product(Complex a_4, Complex b_6)
{
    const Complex complex_20 = ConstructComplex(((a_4.re * b_6.re) - (a_4.im * b_6.im)), ((a_4.re * b_6.im) + (a_4.im * b_6.re)));
    return complex_20;
}

// Returns what two crossing rectangular scratches lack in B - S1 - S2, in the square of the
// lengths' unit: the product of
// the depth terms times the transform of the overlap. No paper has it; WVJH17 4.2 neglects it.
//
// Width, depth and unit tangent of the two scratches, the place where their centre lines meet
// relative to the shaded
// point, and the scattering vector, all in the same axes of the surface. No result for parallel
// scratches.
Complex crossing_response(float radius_12, float wavelength_16, float first_width, float first_depth, float second_width, float second_depth, float first_x, float first_y, float second_x, float second_y, float crossing_x, float crossing_y, float xi_x, float xi_y, float gamma_sum_8)
{
    float sine_3 = ((first_x * second_y) - (first_y * second_x));
    float p_5 = (((xi_x * second_x) + (xi_y * second_y)) / sine_3);
    float q_12 = (-(((xi_x * first_x) + (xi_y * first_y))) / sine_3);
    const float _e27 = width_term(first_width, p_5, wavelength_16);
    const float _e28 = width_term(second_width, q_12, wavelength_16);
    float overlap = (_e27 * (_e28 / abs(sine_3)));
    const float _e32 = in_radii(crossing_x, radius_12);
    const float _e33 = in_radii(crossing_y, radius_12);
    const float _e39 = exponential((-0.5 * ((_e32 * _e32) + (_e33 * _e33))));
    const Complex _e41 = turned_back((overlap * _e39), crossing_x, xi_x, wavelength_16);
    const Complex _e43 = turned_back(1.0, crossing_y, xi_y, wavelength_16);
    const Complex _e44 = depth_term(first_depth, gamma_sum_8, wavelength_16);
    const Complex _e45 = depth_term(second_depth, gamma_sum_8, wavelength_16);
    const Complex _e46 = complex_product(_e44, _e45);
    const Complex _e47 = complex_product(_e41, _e43);
    const Complex _e48 = complex_product(_e46, _e47);
    const Complex complex_21 = _e48;
    return complex_21;
}

FootprintWindow ConstructFootprintWindow(float arg0, float arg1, float arg2, float arg3, float arg4) {
    FootprintWindow ret = (FootprintWindow)0;
    ret.near = arg0;
    ret.far = arg1;
    ret.start = arg2;
    ret.span = arg3;
    ret.share = arg4;
    return ret;
}

// Returns the part of the ellipse within reach of the line.
FootprintWindow footprint_window(float half_width, float edge)
{
    float width_23 = min(max(half_width, FOOTPRINT_LEAST_LIMIT), FOOTPRINT_MOST_LIMIT);
    float near_edge = (edge + (width_23 - half_width));
    float far_edge = ((width_23 - near_edge) + width_23);
    float inverse_3 = (1.0 / width_23);
    float start_7 = max(-(near_edge), -3.95);
    bool whole_2 = (max(near_edge, far_edge) <= FOOTPRINT_REACH);
    float seen_1 = max((min(far_edge, FOOTPRINT_REACH) - start_7), 0.0);
    float span = (whole_2 ? (width_23 + width_23) : seen_1);
    const FootprintWindow footprintwindow = ConstructFootprintWindow((max((near_edge - FOOTPRINT_REACH), 0.0) * inverse_3), (max((far_edge - FOOTPRINT_REACH), 0.0) * inverse_3), (FOOTPRINT_BINARY * start_7), (FOOTPRINT_BINARY * span), (span * inverse_3));
    return footprintwindow;
}

// Returns 2^(-x^2), to f32 grade of 1, for |x| up to 11.
float halving_square(float x_18)
{
    float y_15 = (x_18 * x_18);
    float n_9 = round(y_15);
    float r_7 = (n_9 - y_15);
    float series = (HALVING_A + (r_7 * (HALVING_B + (r_7 * (HALVING_C + (r_7 * (HALVING_D + (r_7 * HALVING_E))))))));
    return ((1.0 + (r_7 * series)) * asfloat((asuint((EXPONENT_BIAS - n_9)) << 23u)));
}

// Returns two nodes of the rule, mirror images within the window.
float footprint_pair(FootprintWindow window, float part, float sine_1)
{
    float rest_8 = (1.0 - part);
    float low_1 = (window.start + (window.span * part));
    float high_1 = (window.start + (window.span * rest_8));
    float lesser = (window.share * part);
    float greater = (window.share * rest_8);
    const float _e23 = halving_square(low_1);
    float first_11 = (sqrt(((window.near + lesser) * (window.far + greater))) * _e23);
    const float _e31 = halving_square(high_1);
    float second_7 = (sqrt(((window.near + greater) * (window.far + lesser))) * _e31);
    return (sine_1 * (first_11 + second_7));
}

// Returns the half width of an ellipse across the tangent; half axes, cosine of the angle from the
// first to the tangent.
//
// For |cos_phi| up to 1.
float footprint_half_width(float a_first, float a_second, float cos_phi)
{
    float sine_squared = max(((1.0 - cos_phi) * (1.0 + cos_phi)), 0.0);
    float along_5 = (a_second * cos_phi);
    return sqrt((((a_first * a_first) * sine_squared) + (along_5 * along_5)));
}

// Returns the mean over an ellipse of exp(-s_b^2/sigma^2) for an infinite scratch, to f32 grade of
// its largest value.
//
// Half width H of the ellipse across the scratch and `edge` = H - |C| with C the scratch's offset
// from the centre, both
// over sigma: the caller may know the edge better than the difference of two rounded numbers. Any H
// >= 0.
float footprint_mean_reduced(float half_width_1, float edge_1)
{
    const FootprintWindow _e2 = footprint_window(half_width_1, edge_1);
    const float _e5 = footprint_pair(_e2, FOOTPRINT_NODE_A, FOOTPRINT_NODE_SINE_A);
    const float _e8 = footprint_pair(_e2, FOOTPRINT_NODE_B, FOOTPRINT_NODE_SINE_B);
    const float _e11 = footprint_pair(_e2, FOOTPRINT_NODE_C, FOOTPRINT_NODE_SINE_C);
    const float _e14 = footprint_pair(_e2, FOOTPRINT_NODE_D, FOOTPRINT_NODE_SINE_D);
    const float _e17 = footprint_pair(_e2, FOOTPRINT_NODE_E, FOOTPRINT_NODE_SINE_E);
    const float _e20 = footprint_pair(_e2, FOOTPRINT_NODE_F, FOOTPRINT_NODE_SINE_F);
    const float _e23 = footprint_pair(_e2, FOOTPRINT_NODE_G, FOOTPRINT_NODE_SINE_G);
    const float _e26 = footprint_pair(_e2, FOOTPRINT_NODE_H, FOOTPRINT_NODE_SINE_H);
    const float _e29 = footprint_pair(_e2, FOOTPRINT_NODE_I, FOOTPRINT_NODE_SINE_I);
    float outer_3 = ((_e5 + _e8) + (_e11 + _e14));
    float inner_2 = (((_e29 + _e26) + (_e23 + _e20)) + _e17);
    return ((_e2.share * FOOTPRINT_SHARE) * (outer_3 + inner_2));
}

// Returns a polynomial of degree 5.
float footprint_quintic(float w, float a_5, float b_7, float c_2, float d, float e, float f)
{
    float upper_3 = (c_2 + (w * (d + (w * (e + (w * f))))));
    return (a_5 + (w * (b_7 + (w * upper_3))));
}

// Returns [`footprint_mean_reduced`] to 1e-3.
//
// One exponential and one root: of a narrow ellipse, of one edge, or of the middle of a wide
// ellipse.
float footprint_mean_reduced_coarse(float half_width_2, float edge_2)
{
    float d_10 = max(edge_2, -3.05);
    bool is_narrow = (half_width_2 < FOOTPRINT_WIDE_LIMIT);
    bool is_interior = (edge_2 >= FOOTPRINT_INTERIOR_LIMIT);
    float narrow = min(half_width_2, FOOTPRINT_WIDE_LIMIT);
    float offset_6 = (narrow - d_10);
    float spread = (2.0 / (2.0 + (narrow * narrow)));
    float v_13 = (0.5 * ((narrow * narrow) * spread));
    float u_13 = (v_13 * v_13);
    float w_5 = (2.0 * ((offset_6 * offset_6) * spread));
    const float _e31 = footprint_quintic(w_5, FOOTPRINT_NARROW_A, FOOTPRINT_NARROW_B, FOOTPRINT_NARROW_C, FOOTPRINT_NARROW_D, FOOTPRINT_NARROW_E, FOOTPRINT_NARROW_F);
    const float _e38 = footprint_quintic(w_5, FOOTPRINT_NARROW_G, FOOTPRINT_NARROW_H, FOOTPRINT_NARROW_I, FOOTPRINT_NARROW_J, FOOTPRINT_NARROW_K, FOOTPRINT_NARROW_L);
    const float _e45 = footprint_quintic(w_5, FOOTPRINT_NARROW_M, FOOTPRINT_NARROW_N, FOOTPRINT_NARROW_O, FOOTPRINT_NARROW_P, FOOTPRINT_NARROW_Q, FOOTPRINT_NARROW_R);
    float excess = ((0.5 * w_5) + (u_13 * (_e31 + (u_13 * (_e38 + (u_13 * _e45))))));
    float wide = min(max(half_width_2, FOOTPRINT_WIDE_LIMIT), FOOTPRINT_MOST_LIMIT);
    float inverse_4 = (1.0 / wide);
    float far_1 = (((wide - d_10) + wide) * inverse_4);
    float near_5 = (d_10 * inverse_4);
    float t_4 = min(d_10, FOOTPRINT_INTERIOR_LIMIT);
    float upper_4 = (FOOTPRINT_EDGE_C + (t_4 * (FOOTPRINT_EDGE_D + (t_4 * (FOOTPRINT_EDGE_E + (t_4 * FOOTPRINT_EDGE_F))))));
    float decay = (FOOTPRINT_EDGE_A + (t_4 * (FOOTPRINT_EDGE_B + (t_4 * upper_4))));
    float slope_1 = (FOOTPRINT_EDGE_SLOPE_A + (t_4 * (FOOTPRINT_EDGE_SLOPE_B + (t_4 * FOOTPRINT_EDGE_SLOPE_C))));
    float edged = (decay + (slope_1 * (inverse_4 / far_1)));
    float exponent_1 = (is_narrow ? excess : (is_interior ? 0.0 : edged));
    float under_root = (is_narrow ? spread : (is_interior ? (near_5 * far_1) : (far_1 * inverse_4)));
    float bend_3 = (1.0 / (d_10 * far_1));
    float z_2 = (bend_3 * bend_3);
    float middle_6 = (inverse_4 * (1.1283792 - (z_2 * (0.2820948 + (0.1410474 * z_2)))));
    float height_3 = (is_narrow ? 1.0 : (is_interior ? middle_6 : inverse_4));
    const float _e117 = exponential(-(exponent_1));
    float value_10 = ((sqrt(under_root) * height_3) * _e117);
    return ((edge_2 < FOOTPRINT_OUTSIDE_LIMIT) ? 0.0 : value_10);
}

// Returns the mean over an ellipse of exp(-s_b^2/sigma^2) for an infinite scratch at an offset;
// lengths in one unit.
//
// Half axes and angle as in [`footprint_half_width`]. Wide ellipses lose what the rounding of the
// half width costs the
// distance of the edge.
float footprint_mean(float a_first_1, float a_second_1, float cos_phi_1, float offset_3, float radius_13)
{
    const float _e5 = footprint_half_width(a_first_1, a_second_1, cos_phi_1);
    float inverse_5 = (1.0 / radius_13);
    const float _e12 = footprint_mean_reduced((_e5 * inverse_5), ((_e5 - abs(offset_3)) * inverse_5));
    return _e12;
}

// Returns [`footprint_mean`] to 1e-3.
float footprint_mean_coarse(float a_first_2, float a_second_2, float cos_phi_2, float offset_4, float radius_14)
{
    const float _e5 = footprint_half_width(a_first_2, a_second_2, cos_phi_2);
    float inverse_6 = (1.0 / radius_14);
    const float _e12 = footprint_mean_reduced_coarse((_e5 * inverse_6), ((_e5 - abs(offset_4)) * inverse_6));
    return _e12;
}

// Returns 2 artanh s, for |s| <= 0.172, to f32 grade.
float artanh_twice(float s_1)
{
    float u_14 = (s_1 * s_1);
    float series_1 = (u_14 * (ARTANH_A + (u_14 * (ARTANH_B + (u_14 * ARTANH_C)))));
    return ((s_1 + s_1) + (s_1 * series_1));
}

// Returns ln x for a normal x > 0, to f32 grade.
float natural_log(float x_19)
{
    uint bits_2 = asuint(x_19);
    float fraction_1 = asfloat(((bits_2 & 8388607u) | 1056964608u));
    bool small_2 = (fraction_1 < INVERSE_ROOT_TWO);
    float m_10 = (small_2 ? (fraction_1 + fraction_1) : fraction_1);
    float e_3 = (float((bits_2 >> 23u)) - (small_2 ? 127.0 : 126.0));
    const float _e27 = artanh_twice(((m_10 - 1.0) / (m_10 + 1.0)));
    return ((e_3 * LN_TWO_HIGH) + ((e_3 * LN_TWO_LOW) + _e27));
}

// Returns ln(1 - a) for 0 <= a < 1, to f32 grade also for the smallest a.
float log_one_minus(float a_6)
{
    float bounded_8 = min(a_6, 0.29);
    const float _e7 = artanh_twice((-(bounded_8) / (2.0 - bounded_8)));
    const float _e12 = natural_log(max((1.0 - a_6), SHARE_SMALLEST_LIMIT));
    return ((a_6 < 0.29) ? _e7 : _e12);
}

// Returns the angle of (x, y) from the first axis, for y >= 0: from 0 to pi, to f32 grade.
float angle_from_axis(float x_20, float y_5)
{
    float size_3 = abs(x_20);
    float low_2 = min(size_3, y_5);
    float high_2 = max(size_3, y_5);
    bool split = (low_2 > (TANGENT_SPLIT * high_2));
    float t_5 = ((split ? (low_2 - high_2) : low_2) / (split ? (low_2 + high_2) : high_2));
    float u_15 = (t_5 * t_5);
    float series_2 = (u_15 * (ARCTANGENT_A + (u_15 * (ARCTANGENT_B + (u_15 * (ARCTANGENT_C + (u_15 * ARCTANGENT_D)))))));
    float eighth = ((t_5 - (t_5 * series_2)) + (split ? QUARTER_PI : 0.0));
    float quarter = ((y_5 > size_3) ? (HALF_PI - eighth) : eighth);
    return ((x_20 < 0.0) ? (ARC_PI - quarter) : quarter);
}

// Returns the y at which int_-inf^y exp(-t^2) dt/sqrt(pi) is `u`, for 0 <= u < 1.
//
// Below 2^-25 it stays. The polynomials are those of Giles 2010, "Approximating the erfinv
// function", Table 5.
float gaussian_inverse(float u_1)
{
    float share = max(u_1, SHARE_SMALLEST_LIMIT);
    float x_23 = ((share + share) - 1.0);
    float tail_5 = min(share, (1.0 - share));
    const float _e10 = log_one_minus((x_23 * x_23));
    float middle_7 = -(_e10);
    const float _e12 = natural_log(tail_5);
    const float _e14 = log_one_minus(tail_5);
    float outer_4 = -((_e12 + (1.3862944 + _e14)));
    float v_14 = ((abs(x_23) > 0.5) ? outer_4 : middle_7);
    float c_9 = (v_14 - 2.5);
    float upper_centre = (0.00021858087 + (c_9 * (-4.3915065e-6 + (c_9 * (-3.5233877e-6 + (c_9 * (3.4327394e-7 + (c_9 * 2.8102264e-8))))))));
    float centre_5 = (1.5014094 + (c_9 * (0.24664073 + (c_9 * (-0.0041776816 + (c_9 * (-0.001253725 + (c_9 * upper_centre))))))));
    float d_11 = (sqrt(max(v_14, 0.0)) - 3.0);
    float upper_far = (-0.0036734284 + (d_11 * (0.0013493432 + (d_11 * (0.00010095056 + (d_11 * -0.00020021426))))));
    float far_2 = (2.8329768 + (d_11 * (1.001674 + (d_11 * (0.00943887 + (d_11 * (-0.007622461 + (d_11 * (0.0057395077 + (d_11 * upper_far))))))))));
    return (x_23 * ((v_14 >= 5.0) ? far_2 : centre_5));
}

// Returns k sigma.
float lobe_reduced_radius(float radius_15, float wavelength_17)
{
    return (TWO_PI * (radius_15 / wavelength_17));
}

// Returns the density of the base lobe, in 1/sr: a Gaussian of direction cosines.
//
// Radius of the coherence window and wavelength in um; incident and outgoing direction by
// components along tangent (t),
// bitangent (b) and normal (n), away from the surface; the incident one above it. 0 for an outgoing
// one below it.
float base_lobe_pdf(float radius_16, float wavelength_18, float incident_t, float incident_b, float outgoing_t, float outgoing_b, float outgoing_n)
{
    const float _e7 = lobe_reduced_radius(radius_16, wavelength_18);
    float x_24 = (_e7 * (incident_t + outgoing_t));
    float y_16 = (_e7 * (incident_b + outgoing_b));
    const float _e16 = exponential(-(((x_24 * x_24) + (y_16 * y_16))));
    float height_4 = (_e16 * INVERSE_PI);
    return ((outgoing_n <= 0.0) ? 0.0 : (_e7 * (_e7 * (height_4 * outgoing_n))));
}

SampledDirection ConstructSampledDirection(float arg0, float arg1, float arg2, float arg3) {
    SampledDirection ret = (SampledDirection)0;
    ret.x = arg0;
    ret.y = arg1;
    ret.z = arg2;
    ret.pdf = arg3;
    return ret;
}

// Returns a direction of the base lobe from two random numbers of \[0, 1); density 0 for an
// evanescent draw.
SampledDirection base_lobe_sample(float radius_17, float wavelength_19, float incident_t_1, float incident_b_1, float first_7, float second)
{
    const float _e6 = lobe_reduced_radius(radius_17, wavelength_19);
    const float _e7 = log_one_minus(first_7);
    float size_4 = (sqrt(-(_e7)) / _e6);
    const SineCosine _e11 = sine_cosine_turns(second);
    float x_25 = ((size_4 * _e11.cosine) - incident_t_1);
    float y_17 = ((size_4 * _e11.sine) - incident_b_1);
    float z_3 = sqrt(max((((1.0 - x_25) * (1.0 + x_25)) - (y_17 * y_17)), 0.0));
    const float _e28 = base_lobe_pdf(radius_17, wavelength_19, incident_t_1, incident_b_1, x_25, y_17, z_3);
    const SampledDirection sampleddirection = ConstructSampledDirection(x_25, y_17, z_3, _e28);
    return sampleddirection;
}

// Returns the Lorentzian's angle over the directions that propagate, from c (b - g) to c (b + g).
float lobe_lorentz_angle(float c_3, float b_8, float g)
{
    float low_3 = (c_3 * (b_8 - g));
    float high_3 = (c_3 * (b_8 + g));
    const float _e12 = angle_from_axis((1.0 + (low_3 * high_3)), (c_3 * (g + g)));
    return _e12;
}

// Returns the length of (b, n) without underflow at grazing angles: the squares are taken of 2^40
// times each.
float lobe_reach(float b_9, float n)
{
    float wide_1 = (b_9 * 1099511600000.0);
    float high_4 = (n * 1099511600000.0);
    return (sqrt(((wide_1 * wide_1) + (high_4 * high_4))) * 9.094947e-13);
}

// Returns the density of the lobe of a scratch, in 1/sr: a Gaussian along it, a Lorentzian across.
//
// Radius, wavelength and width in um; directions as in [`base_lobe_pdf`].
float scratch_lobe_pdf(float radius_18, float wavelength_20, float width_9, float incident_t_2, float incident_b_2, float outgoing_t_1, float outgoing_b_1, float outgoing_n_1)
{
    const float _e8 = lobe_reduced_radius(radius_18, wavelength_20);
    float c_10 = (ARC_PI * (width_9 / wavelength_20));
    float along_6 = (_e8 * (incident_t_2 + outgoing_t_1));
    float x_26 = (c_10 * (incident_b_2 + outgoing_b_1));
    const float _e16 = lobe_reach(outgoing_b_1, outgoing_n_1);
    const float _e17 = lobe_lorentz_angle(c_10, incident_b_2, _e16);
    float curved = (c_10 / (_e17 * (1.0 + (x_26 * x_26))));
    float across_6 = ((c_10 < LOBE_NARROW_LIMIT) ? (0.5 / _e16) : curved);
    const float _e30 = exponential(-((along_6 * along_6)));
    float gaussian = (_e8 * (_e30 * INVERSE_ROOT_PI));
    return ((outgoing_n_1 <= 0.0) ? 0.0 : (gaussian * (across_6 * outgoing_n_1)));
}

// Returns a direction of the lobe of a scratch from two random numbers of \[0, 1); density 0 for an
// evanescent draw.
SampledDirection scratch_lobe_sample(float radius_19, float wavelength_21, float width_10, float incident_t_3, float incident_b_3, float first_8, float second_1)
{
    const float _e7 = lobe_reduced_radius(radius_19, wavelength_21);
    float c_11 = (ARC_PI * (width_10 / wavelength_21));
    const float _e11 = gaussian_inverse(first_8);
    float x_27 = ((_e11 / _e7) - incident_t_3);
    float g_1 = sqrt(max(((1.0 - x_27) * (1.0 + x_27)), 0.0));
    float b_12 = abs(incident_b_3);
    bool mirrored = (incident_b_3 < 0.0);
    float u_16 = (mirrored ? second_1 : (1.0 - second_1));
    float far_3 = (c_11 * (b_12 + g_1));
    const float _e30 = lobe_lorentz_angle(c_11, b_12, g_1);
    const SineCosine _e32 = sine_cosine((u_16 * _e30));
    float curved_1 = ((_e32.sine * (1.0 + (far_3 * far_3))) / (c_11 * (_e32.cosine + (far_3 * _e32.sine))));
    float from_end = ((c_11 < LOBE_NARROW_LIMIT) ? (u_16 * (g_1 + g_1)) : curved_1);
    float beta = (g_1 - from_end);
    float y_18 = (mirrored ? -(beta) : beta);
    float z_4 = sqrt(max((from_end * ((g_1 + g_1) - from_end)), 0.0));
    const float _e58 = scratch_lobe_pdf(radius_19, wavelength_21, width_10, incident_t_3, incident_b_3, x_27, y_18, z_4);
    const SampledDirection sampleddirection_1 = ConstructSampledDirection(x_27, y_18, z_4, _e58);
    return sampleddirection_1;
}

// Returns 1 - e^(-2 kappa), relatively accurate, for kappa >= 0.
float cone_mass(float concentration)
{
    float z_5 = (concentration + concentration);
    float upper_5 = (0.008333334 - (z_5 * (0.0013888889 - (z_5 * (0.0001984127 - (z_5 * 2.4801588e-5))))));
    float series_3 = (z_5 * (0.5 - (z_5 * (0.16666667 - (z_5 * (0.041666668 - (z_5 * upper_5)))))));
    const float _e24 = exponential(-(z_5));
    return ((z_5 < 0.5) ? (z_5 - (z_5 * series_3)) : (1.0 - _e24));
}

// Returns the density of the published cone of a scratch, in 1/sr (WVJH17 section 5), for a
// concentration >= 0.
//
// Directions as in [`base_lobe_pdf`].
float scratch_cone_pdf(float concentration_1, float incident_t_4, float incident_b_4, float incident_n, float outgoing_t_2, float outgoing_b_2, float outgoing_n_2)
{
    float across_in = sqrt(((incident_b_4 * incident_b_4) + (incident_n * incident_n)));
    float across_out = sqrt(((outgoing_b_2 * outgoing_b_2) + (outgoing_n_2 * outgoing_n_2)));
    float sum_7 = (incident_t_4 + outgoing_t_2);
    float difference_1 = (across_in - across_out);
    float decay_1 = ((0.5 * concentration_1) * ((sum_7 * sum_7) + (difference_1 * difference_1)));
    const float _e23 = cone_mass(concentration_1);
    float peak = ((concentration_1 < LOBE_UNIFORM_LIMIT) ? 0.5 : (concentration_1 / _e23));
    const float _e31 = bessel_i0_scaled((concentration_1 * (across_in * across_out)));
    const float _e33 = exponential(-(decay_1));
    float density_3 = (peak * ((_e33 * INVERSE_PI) * _e31));
    return ((outgoing_n_2 < 0.0) ? 0.0 : density_3);
}

// Returns a direction of the published cone from three random numbers of \[0, 1).
SampledDirection scratch_cone_sample(float concentration_2, float incident_t_5, float incident_b_5, float incident_n_1, float first_9, float second_2, float third)
{
    const float _e7 = cone_mass(concentration_2);
    const float _e9 = log_one_minus((first_9 * _e7));
    float curved_2 = (-(_e9) / concentration_2);
    float versine = min(((concentration_2 < LOBE_UNIFORM_LIMIT) ? (first_9 + first_9) : curved_2), 2.0);
    float cosine = (1.0 - versine);
    float sine_4 = sqrt((versine * (2.0 - versine)));
    const SineCosine _e24 = sine_cosine_turns(second_2);
    float s_12 = sqrt(((incident_b_5 * incident_b_5) + (incident_n_1 * incident_n_1)));
    float turned = (sine_4 * _e24.cosine);
    float x_28 = (-((incident_t_5 * cosine)) - (s_12 * turned));
    float across_7 = ((s_12 * cosine) - (incident_t_5 * turned));
    float beside = (sine_4 * _e24.sine);
    float reach = sqrt(((across_7 * across_7) + (beside * beside)));
    const SineCosine _e46 = sine_cosine_turns((0.5 * third));
    float y_19 = (reach * _e46.cosine);
    float z_6 = (reach * _e46.sine);
    const float _e51 = scratch_cone_pdf(concentration_2, incident_t_5, incident_b_5, incident_n_1, x_28, y_19, z_6);
    const SampledDirection sampleddirection_2 = ConstructSampledDirection(x_28, y_19, z_6, _e51);
    return sampleddirection_2;
}

// Returns the balance weight of a strategy with the density `own` beside `others`, for finite
// densities >= 0.
//
// 0 where both are 0.
float balance_weight(float own, float others)
{
    float ratio = (min(own, others) / max(own, others));
    float larger = (1.0 / (1.0 + ratio));
    return ((own == 0.0) ? 0.0 : ((own >= others) ? larger : (ratio * larger)));
}

LightLine ConstructLightLine(float arg0, float arg1, float arg2, float arg3) {
    LightLine ret = (LightLine)0;
    ret.x = arg0;
    ret.rest = arg1;
    ret.view = arg2;
    ret.width = arg3;
    return ret;
}

// Returns the line xi_t = 0 for a view and a scratch.
LightLine light_line(float wavelength_22, float width_11, float view_t, float view_b)
{
    const LightLine lightline = ConstructLightLine(-(view_t), max(((1.0 - view_t) * (1.0 + view_t)), 0.0), view_b, (ARC_PI * (width_11 / wavelength_22)));
    return lightline;
}

// Returns the band's Gaussian integral over k W/2: what turns an arc of sinc^2 into the integral
// over a light.
float light_scale(float radius_20, float wavelength_23, float width_12)
{
    return ((LIGHT_HALF_INVERSE_ROOT_PI * (wavelength_23 / radius_20)) * (wavelength_23 / (ARC_PI * width_12)));
}

// Returns the integral of exp(-(sigma k xi_t)^2) sinc^2(k W xi_b/2) over a sphere that covers the
// band, by the chord at
// xi_t = 0, dimensionless (VWH18 3.4.1 with the true tangent cone).
//
// `x`, `y`, `z` is the sphere's centre. A sphere that the line misses gives 0; one that contains
// the shaded point has
// no chord.
float sphere_light_chord(float radius_21, float wavelength_24, float width_13, float view_t_1, float view_b_1, float x_21, float y_6, float z, float sphere_radius)
{
    bool local_7 = (bool)0;
    bool local_8 = (bool)0;
    bool local_9 = (bool)0;
    float left = (float)0;
    float right = (float)0;
    float extent_4 = (float)0;
    float gap = 0.0;
    bool seen = true;
    bool local_10 = (bool)0;
    bool local_11 = (bool)0;
    bool local_12 = (bool)0;

    const LightLine _e9 = light_line(wavelength_24, width_13, view_t_1, view_b_1);
    float tilt = ((y_6 * y_6) + (z * z));
    float square_3 = ((x_21 * x_21) + tilt);
    float tangent = sqrt(max((square_3 - (sphere_radius * sphere_radius)), 0.0));
    float per_square = (1.0 / square_3);
    float per_tilt = (1.0 / tilt);
    float p_6 = (_e9.x - ((tangent * per_square) * x_21));
    float sine_5 = (sphere_radius * per_square);
    float discriminant = (((sine_5 * sine_5) * tilt) - (p_6 * p_6));
    float root_1 = (sqrt((max(discriminant, 0.0) * square_3)) * per_tilt);
    float level = ((tangent * per_square) - ((p_6 * per_tilt) * x_21));
    float centre_b = (y_6 * level);
    float reach_b = (z * root_1);
    float left_z = ((z * level) + (y_6 * root_1));
    float right_z = ((z * level) - (y_6 * root_1));
    bool met = (discriminant > 0.0);
    if ((left_z >= 0.0)) {
        local_7 = met;
    } else {
        local_7 = false;
    }
    bool left_up = local_7;
    if ((right_z >= 0.0)) {
        local_8 = met;
    } else {
        local_8 = false;
    }
    bool right_up = local_8;
    if (left_up) {
        local_9 = right_up;
    } else {
        local_9 = false;
    }
    bool above_1 = local_9;
    left = (centre_b - reach_b);
    right = (centre_b + reach_b);
    extent_4 = abs((reach_b + reach_b));
    if (!(!(above_1))) {
        local_10 = (reach_b < 0.0);
    } else {
        local_10 = true;
    }
    bool _e86 = local_10;
    if (_e86) {
        float edge_3 = sqrt(_e9.rest);
        float depth_8 = (level * tilt);
        bool inside_1 = ((met ? (depth_8 + (abs(y_6) * edge_3)) : depth_8) < 0.0);
        if (!(left_up)) {
            local_11 = right_up;
        } else {
            local_11 = true;
        }
        bool _e100 = local_11;
        if (!(_e100)) {
            local_12 = inside_1;
        } else {
            local_12 = true;
        }
        bool _e105 = local_12;
        seen = _e105;
        float _e107 = left;
        left = (left_up ? min(max(_e107, -(edge_3)), edge_3) : -(edge_3));
        float _e112 = right;
        right = (right_up ? min(max(_e112, -(edge_3)), edge_3) : edge_3);
        float _e117 = right;
        float _e118 = left;
        float _e121 = extent_4;
        extent_4 = (above_1 ? _e121 : abs((_e117 - _e118)));
        if (above_1) {
            const float _e134 = arc_of_extent((_e9.width * (_e9.view - edge_3)), (_e9.width * (_e9.view + edge_3)), (_e9.width * (edge_3 + edge_3)));
            gap = _e134;
        }
    }
    float _e136 = left;
    float _e141 = right;
    float _e146 = extent_4;
    const float _e148 = arc_of_extent((_e9.width * (_e136 + _e9.view)), (_e9.width * (_e141 + _e9.view)), (_e9.width * _e146));
    float _e150 = gap;
    bool _e152 = seen;
    float value_11 = (_e152 ? (_e150 + _e148) : 0.0);
    const float _e154 = light_scale(radius_21, wavelength_24, width_13);
    return (_e154 * max(value_11, 0.0));
}

// Returns where an outline has met the line once more, at a direction of these two components: the
// chord it ends, or
// the beginning of the next.
LightChords light_crossing(LightChords chords, LightLine cut, float b_10, float n_1, float direction)
{
    LightChords next = (LightChords)0;

    next = chords;
    if ((chords.open > 0.0)) {
        next.begin_b = b_10;
        next.begin_n = n_1;
        next.open = 0.0;
    } else {
        float sum_b = abs((b_10 + chords.begin_b));
        float sum_n = abs((n_1 + chords.begin_n));
        float by_normals = ((abs((n_1 - chords.begin_n)) * sum_n) / sum_b);
        float extent_8 = ((sum_n < sum_b) ? by_normals : abs((b_10 - chords.begin_b)));
        const float _e40 = arc_of_extent((cut.width * (chords.begin_b + cut.view)), (cut.width * (b_10 + cut.view)), (cut.width * extent_8));
        next.sum = (chords.sum + (direction * _e40));
        next.open = 1.0;
    }
    LightChords _e47 = next;
    const LightChords lightchords = _e47;
    return lightchords;
}

// Returns on which side of the line a point is: 1 or -1.
float light_side(LightLine cut_1, LightPoint p)
{
    return (((p.x - (cut_1.x * sqrt((((p.x * p.x) + (p.y * p.y)) + (p.z * p.z))))) >= 0.0) ? 1.0 : -1.0);
}

// Returns the chords after the visible arc from one point to another, whose sides are known.
LightChords light_arc(LightChords chords_1, LightLine cut_2, LightPoint start, LightPoint stop, float start_side, float stop_side)
{
    LightChords next_1 = (LightChords)0;
    bool local_13 = (bool)0;
    bool local_14 = (bool)0;
    bool local_15 = (bool)0;
    bool local_16 = (bool)0;

    next_1 = chords_1;
    float dx_4 = (stop.x - start.x);
    float dy_4 = (stop.y - start.y);
    float dz_4 = (stop.z - start.z);
    float nx = ((start.y * dz_4) - (start.z * dy_4));
    float ny = ((start.z * dx_4) - (start.x * dz_4));
    float nz = ((start.x * dy_4) - (start.y * dx_4));
    float tilt_1 = ((ny * ny) + (nz * nz));
    float offset_7 = (cut_2.x * nx);
    float discriminant_1 = ((tilt_1 * cut_2.rest) - (offset_7 * offset_7));
    float leaving = (start_side * ((nz * start.y) - (ny * start.z)));
    float returning = (start_side * ((nz * stop.y) - (ny * stop.z)));
    if ((start_side == stop_side)) {
        local_13 = (discriminant_1 > 0.0);
    } else {
        local_13 = false;
    }
    bool _e58 = local_13;
    if (_e58) {
        local_14 = (leaving > 0.0);
    } else {
        local_14 = false;
    }
    bool _e64 = local_14;
    if (_e64) {
        local_15 = (returning < 0.0);
    } else {
        local_15 = false;
    }
    bool twice_6 = local_15;
    if (!(twice_6)) {
        local_16 = (start_side != stop_side);
    } else {
        local_16 = true;
    }
    bool _e76 = local_16;
    if (_e76) {
        float root_2 = sqrt(max(discriminant_1, 0.0));
        float inverse_7 = (1.0 / tilt_1);
        float base_b = -((offset_7 * ny));
        float base_n = -((offset_7 * nz));
        float move_b = (start_side * (nz * root_2));
        float move_n = (start_side * (ny * root_2));
        bool no_plane = (tilt_1 == 0.0);
        float b_13 = (no_plane ? start.y : ((base_b + move_b) * inverse_7));
        float n_10 = (no_plane ? start.z : ((base_n - move_n) * inverse_7));
        LightChords _e100 = next_1;
        const LightChords _e101 = light_crossing(_e100, cut_2, b_13, n_10, start_side);
        next_1 = _e101;
        if (twice_6) {
            LightChords _e102 = next_1;
            const LightChords _e108 = light_crossing(_e102, cut_2, ((base_b - move_b) * inverse_7), ((base_n + move_n) * inverse_7), -(start_side));
            next_1 = _e108;
        }
    }
    LightChords _e109 = next_1;
    const LightChords lightchords_1 = _e109;
    return lightchords_1;
}

LightPoint ConstructLightPoint(float arg0, float arg1, float arg2) {
    LightPoint ret = (LightPoint)0;
    ret.x = arg0;
    ret.y = arg1;
    ret.z = arg2;
    return ret;
}

// Returns the point of an edge at the horizon: between its ends, and of their size.
LightPoint light_horizon(LightPoint start_1, LightPoint stop_1)
{
    float whole_3 = (abs(stop_1.z) + abs(start_1.z));
    float a_8 = (abs(stop_1.z) / whole_3);
    float b_14 = (abs(start_1.z) / whole_3);
    const LightPoint lightpoint = ConstructLightPoint(((start_1.x * a_8) + (stop_1.x * b_14)), ((start_1.y * a_8) + (stop_1.y * b_14)), 0.0);
    return lightpoint;
}

// Returns the chords after one more edge of a polygon.
LightChords light_edge(LightChords chords_2, LightLine cut_3, LightPoint start_2, LightPoint stop_2, float start_side_1, float stop_side_1)
{
    LightChords next_2 = (LightChords)0;
    bool local_17 = (bool)0;

    next_2 = chords_2;
    if ((start_2.z >= 0.0)) {
        local_17 = (stop_2.z >= 0.0);
    } else {
        local_17 = false;
    }
    bool _e16 = local_17;
    if (_e16) {
        LightChords _e17 = next_2;
        const LightChords _e18 = light_arc(_e17, cut_3, start_2, stop_2, start_side_1, stop_side_1);
        next_2 = _e18;
    } else {
        if ((start_2.z >= 0.0)) {
            const LightPoint _e22 = light_horizon(start_2, stop_2);
            LightChords _e23 = next_2;
            const float _e24 = light_side(cut_3, _e22);
            const LightChords _e25 = light_arc(_e23, cut_3, start_2, _e22, start_side_1, _e24);
            next_2 = _e25;
            next_2.setting = _e22;
            next_2.below = 1.0;
        } else {
            if ((stop_2.z >= 0.0)) {
                const LightPoint _e32 = light_horizon(start_2, stop_2);
                const float _e33 = light_side(cut_3, _e32);
                float _e35 = next_2.below;
                if ((_e35 > 0.0)) {
                    LightChords _e38 = next_2;
                    LightPoint _e40 = next_2.setting;
                    LightPoint _e42 = next_2.setting;
                    const float _e43 = light_side(cut_3, _e42);
                    const LightChords _e44 = light_arc(_e38, cut_3, _e40, _e32, _e43, _e33);
                    next_2 = _e44;
                    next_2.below = 0.0;
                } else {
                    next_2.rise = _e32;
                    next_2.risen = 1.0;
                }
                LightChords _e50 = next_2;
                const LightChords _e51 = light_arc(_e50, cut_3, _e32, stop_2, _e33, stop_side_1);
                next_2 = _e51;
            }
        }
    }
    LightChords _e52 = next_2;
    const LightChords lightchords_2 = _e52;
    return lightchords_2;
}

LightChords ConstructLightChords(float arg0, float arg1, float arg2, float arg3, LightPoint arg4, float arg5, LightPoint arg6, float arg7) {
    LightChords ret = (LightChords)0;
    ret.sum = arg0;
    ret.begin_b = arg1;
    ret.begin_n = arg2;
    ret.open = arg3;
    ret.setting = arg4;
    ret.below = arg5;
    ret.rise = arg6;
    ret.risen = arg7;
    return ret;
}

// Returns no chords.
LightChords light_chords()
{
    LightPoint none = ConstructLightPoint(0.0, 0.0, 0.0);
    const LightChords lightchords_3 = ConstructLightChords(0.0, 0.0, 0.0, 1.0, none, 0.0, none, 0.0);
    return lightchords_3;
}

// Returns the integral over all chords of a closed outline.
float light_closed(LightChords chords_3, LightLine cut_4)
{
    LightChords inside = (LightChords)0;
    bool local_18 = (bool)0;

    inside = chords_3;
    float _e4 = inside.below;
    if ((_e4 > 0.0)) {
        float _e10 = inside.risen;
        local_18 = (_e10 > 0.0);
    } else {
        local_18 = false;
    }
    bool _e14 = local_18;
    if (_e14) {
        LightChords _e15 = inside;
        LightPoint _e17 = inside.setting;
        LightPoint _e19 = inside.rise;
        LightPoint _e21 = inside.setting;
        const float _e22 = light_side(cut_4, _e21);
        LightPoint _e24 = inside.rise;
        const float _e25 = light_side(cut_4, _e24);
        const LightChords _e26 = light_arc(_e15, cut_4, _e17, _e19, _e22, _e25);
        inside = _e26;
    }
    float _e28 = inside.sum;
    return abs(_e28);
}

// Returns the integral of exp(-(sigma k xi_t)^2) sinc^2(k W xi_b/2) over a triangle that covers the
// band, by the chord at
// xi_t = 0, dimensionless (VWH18 3.4.2).
//
// The three vertices follow, either way round. A triangle that the line misses gives 0.
float triangle_light_chord(float radius_22, float wavelength_25, float width_14, float view_t_2, float view_b_2, float ax, float ay, float az, float bx, float by, float bz, float cx, float cy, float cz)
{
    const LightLine _e14 = light_line(wavelength_25, width_14, view_t_2, view_b_2);
    LightPoint a_9 = ConstructLightPoint(ax, ay, az);
    LightPoint b_15 = ConstructLightPoint(bx, by, bz);
    LightPoint c_12 = ConstructLightPoint(cx, cy, cz);
    const float _e18 = light_side(_e14, a_9);
    const float _e19 = light_side(_e14, b_15);
    const float _e20 = light_side(_e14, c_12);
    const LightChords _e21 = light_chords();
    const LightChords _e22 = light_edge(_e21, _e14, a_9, b_15, _e18, _e19);
    const LightChords _e23 = light_edge(_e22, _e14, b_15, c_12, _e19, _e20);
    const LightChords _e24 = light_edge(_e23, _e14, c_12, a_9, _e20, _e18);
    const float _e25 = light_scale(radius_22, wavelength_25, width_14);
    const float _e26 = light_closed(_e24, _e14);
    return (_e25 * _e26);
}

// Returns the integral of exp(-(sigma k xi_t)^2) sinc^2(k W xi_b/2) over a quadrilateral that
// covers the band, by the
// chords at xi_t = 0, dimensionless (VWH18 3.4.2).
//
// The four vertices follow in order, either way round, convex or not. A quadrilateral that the line
// misses gives 0.
float quad_light_chord(float radius_23, float wavelength_26, float width_15, float view_t_3, float view_b_3, float ax_1, float ay_1, float az_1, float bx_1, float by_1, float bz_1, float cx_1, float cy_1, float cz_1, float dx, float dy, float dz)
{
    const LightLine _e17 = light_line(wavelength_26, width_15, view_t_3, view_b_3);
    LightPoint a_10 = ConstructLightPoint(ax_1, ay_1, az_1);
    LightPoint b_16 = ConstructLightPoint(bx_1, by_1, bz_1);
    LightPoint c_13 = ConstructLightPoint(cx_1, cy_1, cz_1);
    LightPoint d_12 = ConstructLightPoint(dx, dy, dz);
    const float _e22 = light_side(_e17, a_10);
    const float _e23 = light_side(_e17, b_16);
    const float _e24 = light_side(_e17, c_13);
    const float _e25 = light_side(_e17, d_12);
    const LightChords _e26 = light_chords();
    const LightChords _e27 = light_edge(_e26, _e17, a_10, b_16, _e22, _e23);
    const LightChords _e28 = light_edge(_e27, _e17, b_16, c_13, _e23, _e24);
    const LightChords _e29 = light_edge(_e28, _e17, c_13, d_12, _e24, _e25);
    const LightChords _e30 = light_edge(_e29, _e17, d_12, a_10, _e25, _e22);
    const float _e31 = light_scale(radius_23, wavelength_26, width_15);
    const float _e32 = light_closed(_e30, _e17);
    return (_e31 * _e32);
}

// Returns the integral of exp(-(sigma k xi_t)^2) sinc^2(k W xi_b/2) over a polygon of three to
// eight vertices that covers
// the band, by the chords at xi_t = 0, dimensionless (VWH18 3.4.2).
//
// `count` is the number of vertices; the vertices follow in order, either way round, convex or not;
// those beyond the
// count are not read. A polygon that the line misses gives 0.
float polygon_light_chord(float radius_24, float wavelength_27, float width_16, float view_t_4, float view_b_4, float count, float ax_2, float ay_2, float az_2, float bx_2, float by_2, float bz_2, float cx_2, float cy_2, float cz_2, float dx_1, float dy_1, float dz_1, float ex, float ey, float ez, float fx, float fy, float fz, float gx, float gy, float gz, float hx, float hy, float hz)
{
    LightChords chords_4 = (LightChords)0;
    LightPoint last_7 = (LightPoint)0;
    float last_side = (float)0;
    uint i = 1u;

    const LightLine _e30 = light_line(wavelength_27, width_16, view_t_4, view_b_4);
    LightPoint a_11 = ConstructLightPoint(ax_2, ay_2, az_2);
    const float _e32 = light_side(_e30, a_11);
    const LightChords _e33 = light_chords();
    chords_4 = _e33;
    last_7 = a_11;
    last_side = _e32;
    bool loop_init = true;
    while(true) {
        if (!loop_init) {
            uint _e124 = i;
            i = (_e124 + 1u);
        }
        loop_init = false;
        uint _e39 = i;
        if ((_e39 < 8u)) {
        } else {
            break;
        }
        {
            uint _e42 = i;
            if ((float(_e42) < count)) {
                uint _e45 = i;
                uint _e49 = i;
                uint _e53 = i;
                uint _e57 = i;
                uint _e61 = i;
                uint _e65 = i;
                float x_29 = ((_e65 > 4u) ? ((_e61 > 5u) ? ((_e57 == 7u) ? hx : gx) : fx) : ((_e53 > 2u) ? ((_e49 == 4u) ? ex : dx_1) : ((_e45 == 2u) ? cx_2 : bx_2)));
                uint _e69 = i;
                uint _e73 = i;
                uint _e77 = i;
                uint _e81 = i;
                uint _e85 = i;
                uint _e89 = i;
                float y_20 = ((_e89 > 4u) ? ((_e85 > 5u) ? ((_e81 == 7u) ? hy : gy) : fy) : ((_e77 > 2u) ? ((_e73 == 4u) ? ey : dy_1) : ((_e69 == 2u) ? cy_2 : by_2)));
                uint _e93 = i;
                uint _e97 = i;
                uint _e101 = i;
                uint _e105 = i;
                uint _e109 = i;
                uint _e113 = i;
                float z_7 = ((_e113 > 4u) ? ((_e109 > 5u) ? ((_e105 == 7u) ? hz : gz) : fz) : ((_e101 > 2u) ? ((_e97 == 4u) ? ez : dz_1) : ((_e93 == 2u) ? cz_2 : bz_2)));
                LightPoint place_1 = ConstructLightPoint(x_29, y_20, z_7);
                const float _e118 = light_side(_e30, place_1);
                LightChords _e119 = chords_4;
                LightPoint _e120 = last_7;
                float _e121 = last_side;
                const LightChords _e122 = light_edge(_e119, _e30, _e120, place_1, _e121, _e118);
                chords_4 = _e122;
                last_7 = place_1;
                last_side = _e118;
            }
        }
    }
    LightChords _e126 = chords_4;
    LightPoint _e127 = last_7;
    float _e128 = last_side;
    const LightChords _e129 = light_edge(_e126, _e30, _e127, a_11, _e128, _e32);
    chords_4 = _e129;
    const float _e130 = light_scale(radius_24, wavelength_27, width_16);
    LightChords _e131 = chords_4;
    const float _e132 = light_closed(_e131, _e30);
    return (_e130 * _e132);
}

LightBand ConstructLightBand(float arg0, float arg1, float arg2, float arg3, float arg4) {
    LightBand ret = (LightBand)0;
    ret.along = arg0;
    ret.width = arg1;
    ret.view_t = arg2;
    ret.view_b = arg3;
    ret.reference = arg4;
    return ret;
}

// Returns the band of a view and a scratch, its reference at the direction of these bitangent
// components.
LightBand light_band(float radius_25, float wavelength_28, float width_17, float view_t_5, float view_b_5, float reference)
{
    const LightBand lightband = ConstructLightBand((TWO_PI * (radius_25 / wavelength_28)), (ARC_PI * (width_17 / wavelength_28)), view_t_5, view_b_5, (reference + view_b_5));
    return lightband;
}

// Returns the factor from sums along an outline to the integral over the light, 1 over k W/2.
float light_band_scale(float wavelength_29, float width_18)
{
    return (wavelength_29 / (ARC_PI * width_18));
}

// Returns -exp(-t^2) Phi dt for one node of a panel, at the half-angle tangent v from the middle of
// a piece.
float light_band_node(LightBand band, LightCircle circle, LightAngle middle_2, float v_3)
{
    float inverse_8 = (1.0 / (1.0 + (v_3 * v_3)));
    float cosine_1 = ((1.0 - (v_3 * v_3)) * inverse_8);
    float sine_6 = ((v_3 + v_3) * inverse_8);
    float c_14 = ((middle_2.c * cosine_1) - (middle_2.s * sine_6));
    float s_13 = ((middle_2.s * cosine_1) + (middle_2.c * sine_6));
    float t_6 = (band.along * ((circle.centre_t + band.view_t) + (circle.reach * c_14)));
    float b_17 = ((circle.centre_b + band.view_b) + ((circle.across_cosine * c_14) + (circle.across_sine * s_13)));
    float way = (b_17 - band.reference);
    const float _e52 = arc_of_extent((band.width * band.reference), (band.width * b_17), (band.width * abs(way)));
    const float _e59 = exponential(-((t_6 * t_6)));
    return (((circle.reach * s_13) * (inverse_8 + inverse_8)) * (_e59 * _e52));
}

LightAngle ConstructLightAngle(float arg0, float arg1) {
    LightAngle ret = (LightAngle)0;
    ret.c = arg0;
    ret.s = arg1;
    return ret;
}

// Returns the integral of -exp(-t^2) Phi dt over the part in the band of a piece whose ends lie on
// one half turn.
float light_band_piece(LightBand band_1, LightCircle circle_1, LightAngle start_3, LightAngle stop_3)
{
    bool local_19 = (bool)0;
    bool local_20 = (bool)0;
    bool local_21 = (bool)0;
    float sum = 0.0;
    uint i_1 = 0u;

    float offset_8 = (circle_1.centre_t + band_1.view_t);
    float t_start = (band_1.along * (offset_8 + (circle_1.reach * start_3.c)));
    float t_stop = (band_1.along * (offset_8 + (circle_1.reach * stop_3.c)));
    if (!((min(t_start, t_stop) >= BAND_END))) {
        local_19 = (max(t_start, t_stop) <= -3.5);
    } else {
        local_19 = true;
    }
    bool _e29 = local_19;
    if (_e29) {
        return 0.0;
    }
    float height_5 = (start_3.s + stop_3.s);
    if (!((height_5 > 0.0))) {
        if ((height_5 == 0.0)) {
            local_21 = (start_3.c > stop_3.c);
        } else {
            local_21 = false;
        }
        bool _e47 = local_21;
        local_20 = _e47;
    } else {
        local_20 = true;
    }
    bool upper_6 = local_20;
    float high_5 = min(max((((BAND_END / band_1.along) - offset_8) / circle_1.reach), -1.0), 1.0);
    float low_4 = min(max((((-3.5 / band_1.along) - offset_8) / circle_1.reach), -1.0), 1.0);
    float high_s = sqrt(((1.0 - high_5) * (1.0 + high_5)));
    float low_s = sqrt(((1.0 - low_4) * (1.0 + low_4)));
    float a_c = ((t_start < -3.5) ? low_4 : ((t_start > BAND_END) ? high_5 : start_3.c));
    float a_size = ((t_start < -3.5) ? low_s : ((t_start > BAND_END) ? high_s : abs(start_3.s)));
    float z_c = ((t_stop < -3.5) ? low_4 : ((t_stop > BAND_END) ? high_5 : stop_3.c));
    float z_size = ((t_stop < -3.5) ? low_s : ((t_stop > BAND_END) ? high_s : abs(stop_3.s)));
    float a_s = (upper_6 ? a_size : -(a_size));
    float z_s = (upper_6 ? z_size : -(z_size));
    float sum_c = (a_c + z_c);
    float sum_s = (a_s + z_s);
    float way_c = (z_c - a_c);
    float way_s = (z_s - a_s);
    float length_sum = sqrt(((sum_c * sum_c) + (sum_s * sum_s)));
    float length_way = sqrt(((way_c * way_c) + (way_s * way_s)));
    bool by_sum = (length_sum > length_way);
    float size_5 = (1.0 / (by_sum ? length_sum : length_way));
    LightAngle middle_8 = ConstructLightAngle((size_5 * (by_sum ? sum_c : way_s)), (size_5 * (by_sum ? sum_s : -(way_c))));
    float reach_v = (length_way / (2.0 + length_sum));
    float angle = (4.0 * reach_v);
    float steepest = (((a_c * z_c) < 0.0) ? 1.0 : max(a_size, z_size));
    float swing = sqrt(((circle_1.across_cosine * circle_1.across_cosine) + (circle_1.across_sine * circle_1.across_sine)));
    float slope_2 = min(swing, (abs(((circle_1.across_sine * middle_8.c) - (circle_1.across_cosine * middle_8.s))) + (swing * reach_v)));
    float measure = ((1.5 * ((band_1.along * circle_1.reach) * (steepest * angle))) + (0.5 * (band_1.width * (slope_2 * angle))));
    float panels = min(max(ceil((measure / BAND_PANEL_LIMIT)), 1.0), 16.0);
    float panel = (reach_v / panels);
    bool loop_init_1 = true;
    while(true) {
        if (!loop_init_1) {
            uint _e260 = i_1;
            i_1 = (_e260 + 1u);
        }
        loop_init_1 = false;
        uint _e193 = i_1;
        if ((_e193 < 16u)) {
        } else {
            break;
        }
        {
            uint _e196 = i_1;
            if ((float(_e196) < panels)) {
                uint _e200 = i_1;
                float centre_6 = (((2.0 * float(_e200)) + (1.0 - panels)) * panel);
                float _e207 = sum;
                const float _e212 = light_band_node(band_1, circle_1, middle_8, (centre_6 - (BAND_NODE_A * panel)));
                const float _e216 = light_band_node(band_1, circle_1, middle_8, (centre_6 + (BAND_NODE_A * panel)));
                sum = (_e207 + (BAND_WEIGHT_A * (_e212 + _e216)));
                float _e220 = sum;
                const float _e225 = light_band_node(band_1, circle_1, middle_8, (centre_6 - (BAND_NODE_B * panel)));
                const float _e229 = light_band_node(band_1, circle_1, middle_8, (centre_6 + (BAND_NODE_B * panel)));
                sum = (_e220 + (BAND_WEIGHT_B * (_e225 + _e229)));
                float _e233 = sum;
                const float _e238 = light_band_node(band_1, circle_1, middle_8, (centre_6 - (BAND_NODE_C * panel)));
                const float _e242 = light_band_node(band_1, circle_1, middle_8, (centre_6 + (BAND_NODE_C * panel)));
                sum = (_e233 + (BAND_WEIGHT_C * (_e238 + _e242)));
                float _e246 = sum;
                const float _e251 = light_band_node(band_1, circle_1, middle_8, (centre_6 - (BAND_NODE_D * panel)));
                const float _e255 = light_band_node(band_1, circle_1, middle_8, (centre_6 + (BAND_NODE_D * panel)));
                sum = (_e246 + (BAND_WEIGHT_D * (_e251 + _e255)));
            }
        }
    }
    float _e262 = sum;
    return (_e262 * panel);
}

// Returns the integral of -exp(-t^2) Phi dt over an arc run through in the direction of growing
// angles; `reflex` is 1 for an
// arc longer than half a turn, else 0.
float light_band_arc(LightBand band_2, LightCircle circle_2, LightAngle start_4, LightAngle stop_4, float reflex)
{
    float sum_1 = 0.0;
    LightAngle at = (LightAngle)0;
    bool local_22 = (bool)0;
    bool local_23 = (bool)0;
    bool falling = (bool)0;
    bool local_24 = (bool)0;
    bool local_25 = (bool)0;
    bool local_26 = (bool)0;
    bool local_27 = (bool)0;
    bool local_28 = (bool)0;
    bool local_29 = (bool)0;
    bool open = (bool)0;
    bool local_30 = (bool)0;
    bool ends_2 = (bool)0;
    uint k = 0u;
    bool local_31 = (bool)0;
    bool local_32 = (bool)0;

    float turn = ((start_4.c * stop_4.s) - (start_4.s * stop_4.c));
    float along_7 = ((start_4.c * stop_4.c) + (start_4.s * stop_4.s));
    at = start_4;
    bool all_round = (reflex > 0.0);
    if (!((start_4.s > 0.0))) {
        if ((start_4.s == 0.0)) {
            local_23 = (start_4.c > 0.0);
        } else {
            local_23 = false;
        }
        bool _e39 = local_23;
        local_22 = _e39;
    } else {
        local_22 = true;
    }
    bool _e41 = local_22;
    falling = _e41;
    if (!((stop_4.s > 0.0))) {
        if ((stop_4.s == 0.0)) {
            local_25 = (stop_4.c < 0.0);
        } else {
            local_25 = false;
        }
        bool _e58 = local_25;
        local_24 = _e58;
    } else {
        local_24 = true;
    }
    bool stop_falling = local_24;
    bool _e61 = falling;
    if ((_e61 == stop_falling)) {
        bool _e71 = falling;
        local_26 = ((_e71 ? (start_4.c - stop_4.c) : (stop_4.c - start_4.c)) < 0.0);
    } else {
        local_26 = false;
    }
    bool back = local_26;
    if (!(all_round)) {
        local_27 = (along_7 <= 0.0);
    } else {
        local_27 = true;
    }
    bool _e83 = local_27;
    if (!(_e83)) {
        if ((turn > 0.0)) {
            local_29 = !(back);
        } else {
            local_29 = false;
        }
        bool _e93 = local_29;
        local_28 = _e93;
    } else {
        local_28 = true;
    }
    bool _e95 = local_28;
    open = _e95;
    if (!(all_round)) {
        local_30 = !(back);
    } else {
        local_30 = false;
    }
    bool _e102 = local_30;
    ends_2 = _e102;
    bool loop_init_2 = true;
    while(true) {
        if (!loop_init_2) {
            uint _e146 = k;
            k = (_e146 + 1u);
        }
        loop_init_2 = false;
        uint _e106 = k;
        if ((_e106 < 3u)) {
        } else {
            break;
        }
        {
            bool _e109 = open;
            if (_e109) {
                uint _e112 = k;
                local_31 = (_e112 < 3u);
            } else {
                local_31 = false;
            }
            bool _e116 = local_31;
            if (_e116) {
                bool _e117 = falling;
                if ((_e117 == stop_falling)) {
                    bool _e121 = ends_2;
                    local_32 = _e121;
                } else {
                    local_32 = false;
                }
                bool last_9 = local_32;
                bool _e126 = falling;
                LightAngle corner = ConstructLightAngle((_e126 ? -1.0 : 1.0), 0.0);
                LightAngle next_4 = ConstructLightAngle((last_9 ? stop_4.c : corner.c), (last_9 ? stop_4.s : corner.s));
                float _e137 = sum_1;
                LightAngle _e138 = at;
                const float _e139 = light_band_piece(band_2, circle_2, _e138, next_4);
                sum_1 = (_e137 + _e139);
                at = next_4;
                bool _e141 = falling;
                falling = !(_e141);
                ends_2 = true;
                open = !(last_9);
            }
        }
    }
    float _e148 = sum_1;
    return _e148;
}

// Returns an angle of this cosine and sine, which share a factor.
LightAngle light_angle(float c_4, float s_2)
{
    float size_6 = (1.0 / sqrt(((c_4 * c_4) + (s_2 * s_2))));
    const LightAngle lightangle = ConstructLightAngle((c_4 * size_6), (s_2 * size_6));
    return lightangle;
}

// Returns the angle of one turned by another, which share a factor.
LightAngle light_turned(float c_5, float s_3, float along, float aside)
{
    const LightAngle _e10 = light_angle(((c_5 * along) - (s_3 * aside)), ((s_3 * along) + (c_5 * aside)));
    const LightAngle lightangle_1 = _e10;
    return lightangle_1;
}

LightCircle ConstructLightCircle(float arg0, float arg1, float arg2, float arg3, float arg4) {
    LightCircle ret = (LightCircle)0;
    ret.centre_t = arg0;
    ret.centre_b = arg1;
    ret.reach = arg2;
    ret.across_cosine = arg3;
    ret.across_sine = arg4;
    return ret;
}

// Returns the integral of exp(-(sigma k xi_t)^2) sinc^2(k W xi_b/2) over the visible part of a
// sphere, dimensionless
// (VWH18 3.4.1, for any place of the light).
//
// `x`, `y`, `z` is the sphere's centre, outside which the shaded point lies.
float sphere_light(float radius_26, float wavelength_30, float width_19, float view_t_6, float view_b_6, float x_22, float y_7, float z_1, float sphere_radius_1)
{
    float sum_2 = 0.0;

    float far_4 = sqrt((((x_22 * x_22) + (y_7 * y_7)) + (z_1 * z_1)));
    float sine_7 = min((sphere_radius_1 / far_4), 1.0);
    float cosine_2 = sqrt(((1.0 - sine_7) * (1.0 + sine_7)));
    float cx_6 = (x_22 / far_4);
    float cy_6 = (y_7 / far_4);
    float cz_6 = (z_1 / far_4);
    float tilt_2 = sqrt(((cy_6 * cy_6) + (cz_6 * cz_6)));
    float level_1 = sqrt(((cx_6 * cx_6) + (cy_6 * cy_6)));
    float flat_b = ((tilt_2 == 0.0) ? cx_6 : (-((cx_6 * cy_6)) / tilt_2));
    float flat_n = ((tilt_2 == 0.0) ? 0.0 : (-((cx_6 * cz_6)) / tilt_2));
    float side_b = ((tilt_2 == 0.0) ? 0.0 : (cz_6 / tilt_2));
    float side_n = ((tilt_2 == 0.0) ? 1.0 : (-(cy_6) / tilt_2));
    LightCircle circle_3 = ConstructLightCircle((cosine_2 * cx_6), (cosine_2 * cy_6), (sine_7 * tilt_2), (sine_7 * flat_b), (sine_7 * side_b));
    const LightBand _e66 = light_band(radius_26, wavelength_30, width_19, view_t_6, view_b_6, (cosine_2 * cy_6));
    float highest = ((sine_7 * level_1) + (cosine_2 * cz_6));
    float lowest = ((cosine_2 * cz_6) - (sine_7 * level_1));
    float root_3 = sqrt(max(-((lowest * highest)), 0.0));
    bool whole_4 = (lowest >= 0.0);
    float down = -((cosine_2 * cz_6));
    LightAngle left_2 = ConstructLightAngle(-1.0, 0.0);
    LightAngle right_2 = ConstructLightAngle(1.0, 0.0);
    const LightAngle _e89 = light_turned(flat_n, side_n, down, -(root_3));
    const LightAngle _e90 = light_turned(flat_n, side_n, down, root_3);
    if (whole_4) {
        const float _e93 = light_band_piece(_e66, circle_3, right_2, left_2);
        const float _e94 = light_band_piece(_e66, circle_3, left_2, right_2);
        sum_2 = (_e93 + _e94);
    } else {
        if ((highest > 0.0)) {
            LightCircle horizon = ConstructLightCircle(0.0, 0.0, 1.0, 0.0, 1.0);
            const float _e109 = light_band_arc(_e66, circle_3, _e89, _e90, ((down < 0.0) ? 1.0 : 0.0));
            const LightAngle _e111 = light_turned(cx_6, cy_6, cosine_2, -(root_3));
            const LightAngle _e112 = light_turned(cx_6, cy_6, cosine_2, root_3);
            const float _e114 = light_band_arc(_e66, horizon, _e111, _e112, 0.0);
            sum_2 = (_e109 + _e114);
        }
    }
    const float _e116 = light_band_scale(wavelength_30, width_19);
    float _e117 = sum_2;
    return (_e116 * max(_e117, 0.0));
}

// Returns the integral of -exp(-t^2) Phi dt along the visible arc from one point to another.
float light_outline_arc(LightBand band_3, LightPoint start_5, LightPoint stop_5)
{
    float sum_3 = 0.0;

    float dx_5 = (stop_5.x - start_5.x);
    float dy_5 = (stop_5.y - start_5.y);
    float dz_5 = (stop_5.z - start_5.z);
    float nx_1 = ((start_5.y * dz_5) - (start_5.z * dy_5));
    float ny_1 = ((start_5.z * dx_5) - (start_5.x * dz_5));
    float nz_1 = ((start_5.x * dy_5) - (start_5.y * dx_5));
    float tilt_3 = sqrt(((ny_1 * ny_1) + (nz_1 * nz_1)));
    float size_7 = sqrt((((nx_1 * nx_1) + (ny_1 * ny_1)) + (nz_1 * nz_1)));
    if ((tilt_3 > 0.0)) {
        LightCircle circle_4 = ConstructLightCircle(0.0, 0.0, (tilt_3 / size_7), (-((nx_1 / size_7)) * (ny_1 / tilt_3)), (nz_1 / tilt_3));
        const LightAngle _e57 = light_angle((start_5.x * size_7), ((nz_1 * start_5.y) - (ny_1 * start_5.z)));
        const LightAngle _e65 = light_angle((stop_5.x * size_7), ((nz_1 * stop_5.y) - (ny_1 * stop_5.z)));
        const float _e67 = light_band_arc(band_3, circle_4, _e57, _e65, 0.0);
        sum_3 = _e67;
    }
    float _e68 = sum_3;
    return _e68;
}

// Returns the outline after one more edge of a polygon.
LightOutline light_outline_edge(LightOutline outline, LightBand band_4, LightPoint start_6, LightPoint stop_6)
{
    LightOutline next_3 = (LightOutline)0;
    bool local_33 = (bool)0;
    bool local_34 = (bool)0;
    bool local_35 = (bool)0;

    next_3 = outline;
    const LightPoint _e5 = light_horizon(start_6, stop_6);
    bool up = (start_6.z >= 0.0);
    bool stays = (stop_6.z >= 0.0);
    LightPoint first_12 = ConstructLightPoint((up ? start_6.x : _e5.x), (up ? start_6.y : _e5.y), (up ? start_6.z : _e5.z));
    LightPoint last_10 = ConstructLightPoint((stays ? stop_6.x : _e5.x), (stays ? stop_6.y : _e5.y), (stays ? stop_6.z : _e5.z));
    if (!(up)) {
        local_33 = stays;
    } else {
        local_33 = true;
    }
    bool _e36 = local_33;
    if (_e36) {
        float _e38 = next_3.sum;
        const float _e39 = light_outline_arc(band_4, first_12, last_10);
        next_3.sum = (_e38 + _e39);
    }
    if (stays) {
        local_34 = !(up);
    } else {
        local_34 = false;
    }
    bool _e45 = local_34;
    if (_e45) {
        float _e47 = next_3.below;
        if ((_e47 > 0.0)) {
            float _e51 = next_3.sum;
            LightPoint _e53 = next_3.setting;
            const float _e54 = light_outline_arc(band_4, _e53, _e5);
            next_3.sum = (_e51 + _e54);
            next_3.below = 0.0;
        } else {
            next_3.rise = _e5;
            next_3.risen = 1.0;
        }
    }
    if (up) {
        local_35 = !(stays);
    } else {
        local_35 = false;
    }
    bool _e65 = local_35;
    if (_e65) {
        next_3.setting = _e5;
        next_3.below = 1.0;
    }
    LightOutline _e69 = next_3;
    const LightOutline lightoutline = _e69;
    return lightoutline;
}

LightOutline ConstructLightOutline(float arg0, LightPoint arg1, float arg2, LightPoint arg3, float arg4) {
    LightOutline ret = (LightOutline)0;
    ret.sum = arg0;
    ret.setting = arg1;
    ret.below = arg2;
    ret.rise = arg3;
    ret.risen = arg4;
    return ret;
}

// Returns an empty outline.
LightOutline light_outline()
{
    LightPoint none_1 = ConstructLightPoint(0.0, 0.0, 0.0);
    const LightOutline lightoutline_1 = ConstructLightOutline(0.0, none_1, 0.0, none_1, 0.0);
    return lightoutline_1;
}

// Returns the integral along a closed outline.
float light_outline_closed(LightOutline outline_1, LightBand band_5)
{
    float sum_4 = (float)0;
    bool local_36 = (bool)0;

    sum_4 = outline_1.sum;
    if ((outline_1.below > 0.0)) {
        local_36 = (outline_1.risen > 0.0);
    } else {
        local_36 = false;
    }
    bool _e13 = local_36;
    if (_e13) {
        float _e14 = sum_4;
        const float _e17 = light_outline_arc(band_5, outline_1.setting, outline_1.rise);
        sum_4 = (_e14 + _e17);
    }
    float _e19 = sum_4;
    return abs(_e19);
}

// Returns the bitangent component of the direction of a point, or of its projection where it is
// below the horizon.
float light_bitangent(LightPoint p_1)
{
    float far_5 = sqrt((((p_1.x * p_1.x) + (p_1.y * p_1.y)) + (p_1.z * p_1.z)));
    return ((far_5 == 0.0) ? 0.0 : (p_1.y / far_5));
}

// Returns the integral of exp(-(sigma k xi_t)^2) sinc^2(k W xi_b/2) over the visible part of a
// triangle, dimensionless
// (VWH18 3.4.2, for any place of the light).
//
// The three vertices follow, either way round.
float triangle_light(float radius_27, float wavelength_31, float width_20, float view_t_7, float view_b_7, float ax_3, float ay_3, float az_3, float bx_3, float by_3, float bz_3, float cx_3, float cy_3, float cz_3)
{
    LightOutline outline_2 = (LightOutline)0;

    LightPoint a_12 = ConstructLightPoint(ax_3, ay_3, az_3);
    LightPoint b_18 = ConstructLightPoint(bx_3, by_3, bz_3);
    LightPoint c_15 = ConstructLightPoint(cx_3, cy_3, cz_3);
    const float _e24 = light_bitangent(ConstructLightPoint(((ax_3 + bx_3) + cx_3), ((ay_3 + by_3) + cy_3), ((az_3 + bz_3) + cz_3)));
    const LightBand _e25 = light_band(radius_27, wavelength_31, width_20, view_t_7, view_b_7, _e24);
    const LightOutline _e26 = light_outline();
    const LightOutline _e27 = light_outline_edge(_e26, _e25, a_12, b_18);
    outline_2 = _e27;
    LightOutline _e29 = outline_2;
    const LightOutline _e30 = light_outline_edge(_e29, _e25, b_18, c_15);
    outline_2 = _e30;
    LightOutline _e31 = outline_2;
    const LightOutline _e32 = light_outline_edge(_e31, _e25, c_15, a_12);
    outline_2 = _e32;
    const float _e33 = light_band_scale(wavelength_31, width_20);
    LightOutline _e34 = outline_2;
    const float _e35 = light_outline_closed(_e34, _e25);
    return (_e33 * _e35);
}

// Returns the integral of exp(-(sigma k xi_t)^2) sinc^2(k W xi_b/2) over the visible part of a
// quadrilateral,
// dimensionless (VWH18 3.4.2, for any place of the light).
//
// The four vertices follow in order, either way round, convex or not.
float quad_light(float radius_28, float wavelength_32, float width_21, float view_t_8, float view_b_8, float ax_4, float ay_4, float az_4, float bx_4, float by_4, float bz_4, float cx_4, float cy_4, float cz_4, float dx_2, float dy_2, float dz_2)
{
    LightOutline outline_3 = (LightOutline)0;

    LightPoint a_13 = ConstructLightPoint(ax_4, ay_4, az_4);
    LightPoint b_19 = ConstructLightPoint(bx_4, by_4, bz_4);
    LightPoint c_16 = ConstructLightPoint(cx_4, cy_4, cz_4);
    LightPoint d_13 = ConstructLightPoint(dx_2, dy_2, dz_2);
    const float _e31 = light_bitangent(ConstructLightPoint(((ax_4 + bx_4) + (cx_4 + dx_2)), ((ay_4 + by_4) + (cy_4 + dy_2)), ((az_4 + bz_4) + (cz_4 + dz_2))));
    const LightBand _e32 = light_band(radius_28, wavelength_32, width_21, view_t_8, view_b_8, _e31);
    const LightOutline _e33 = light_outline();
    const LightOutline _e34 = light_outline_edge(_e33, _e32, a_13, b_19);
    outline_3 = _e34;
    LightOutline _e36 = outline_3;
    const LightOutline _e37 = light_outline_edge(_e36, _e32, b_19, c_16);
    outline_3 = _e37;
    LightOutline _e38 = outline_3;
    const LightOutline _e39 = light_outline_edge(_e38, _e32, c_16, d_13);
    outline_3 = _e39;
    LightOutline _e40 = outline_3;
    const LightOutline _e41 = light_outline_edge(_e40, _e32, d_13, a_13);
    outline_3 = _e41;
    const float _e42 = light_band_scale(wavelength_32, width_21);
    LightOutline _e43 = outline_3;
    const float _e44 = light_outline_closed(_e43, _e32);
    return (_e42 * _e44);
}

// Returns the integral of exp(-(sigma k xi_t)^2) sinc^2(k W xi_b/2) over the visible part of a
// polygon of three to eight
// vertices, dimensionless (VWH18 3.4.2, for any place of the light).
//
// `count` is the number of vertices; the vertices follow in order, either way round, convex or not;
// those beyond the
// count are not read.
float polygon_light(float radius_29, float wavelength_33, float width_22, float view_t_9, float view_b_9, float count_1, float ax_5, float ay_5, float az_5, float bx_5, float by_5, float bz_5, float cx_5, float cy_5, float cz_5, float dx_3, float dy_3, float dz_3, float ex_1, float ey_1, float ez_1, float fx_1, float fy_1, float fz_1, float gx_1, float gy_1, float gz_1, float hx_1, float hy_1, float hz_1)
{
    LightOutline outline_4 = (LightOutline)0;
    LightPoint last_8 = (LightPoint)0;
    uint i_2 = 1u;

    LightPoint a_14 = ConstructLightPoint(ax_5, ay_5, az_5);
    const float _e31 = light_bitangent(a_14);
    const LightBand _e32 = light_band(radius_29, wavelength_33, width_22, view_t_9, view_b_9, _e31);
    const LightOutline _e33 = light_outline();
    outline_4 = _e33;
    last_8 = a_14;
    bool loop_init_3 = true;
    while(true) {
        if (!loop_init_3) {
            uint _e121 = i_2;
            i_2 = (_e121 + 1u);
        }
        loop_init_3 = false;
        uint _e38 = i_2;
        if ((_e38 < 8u)) {
        } else {
            break;
        }
        {
            uint _e41 = i_2;
            if ((float(_e41) < count_1)) {
                uint _e44 = i_2;
                uint _e48 = i_2;
                uint _e52 = i_2;
                uint _e56 = i_2;
                uint _e60 = i_2;
                uint _e64 = i_2;
                float x_30 = ((_e64 > 4u) ? ((_e60 > 5u) ? ((_e56 == 7u) ? hx_1 : gx_1) : fx_1) : ((_e52 > 2u) ? ((_e48 == 4u) ? ex_1 : dx_3) : ((_e44 == 2u) ? cx_5 : bx_5)));
                uint _e68 = i_2;
                uint _e72 = i_2;
                uint _e76 = i_2;
                uint _e80 = i_2;
                uint _e84 = i_2;
                uint _e88 = i_2;
                float y_21 = ((_e88 > 4u) ? ((_e84 > 5u) ? ((_e80 == 7u) ? hy_1 : gy_1) : fy_1) : ((_e76 > 2u) ? ((_e72 == 4u) ? ey_1 : dy_3) : ((_e68 == 2u) ? cy_5 : by_5)));
                uint _e92 = i_2;
                uint _e96 = i_2;
                uint _e100 = i_2;
                uint _e104 = i_2;
                uint _e108 = i_2;
                uint _e112 = i_2;
                float z_8 = ((_e112 > 4u) ? ((_e108 > 5u) ? ((_e104 == 7u) ? hz_1 : gz_1) : fz_1) : ((_e100 > 2u) ? ((_e96 == 4u) ? ez_1 : dz_3) : ((_e92 == 2u) ? cz_5 : bz_5)));
                LightPoint place_2 = ConstructLightPoint(x_30, y_21, z_8);
                LightOutline _e117 = outline_4;
                LightPoint _e118 = last_8;
                const LightOutline _e119 = light_outline_edge(_e117, _e32, _e118, place_2);
                outline_4 = _e119;
                last_8 = place_2;
            }
        }
    }
    LightOutline _e123 = outline_4;
    LightPoint _e124 = last_8;
    const LightOutline _e125 = light_outline_edge(_e123, _e32, _e124, a_14);
    outline_4 = _e125;
    const float _e126 = light_band_scale(wavelength_33, width_22);
    LightOutline _e127 = outline_4;
    const float _e128 = light_outline_closed(_e127, _e32);
    return (_e126 * _e128);
}
