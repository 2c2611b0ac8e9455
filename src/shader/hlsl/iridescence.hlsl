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
    float n = round((x_1 * INVERSE_PI));
    float rest_2 = ((x_1 - (n * PI_HIGH)) - (n * PI_LOW));
    float pairs = (n * 0.5);
    float parity = (1.0 - (4.0 * abs((pairs - round(pairs)))));
    const HalfTurns halfturns = ConstructHalfTurns(rest_2, parity);
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
    float u = (r * r);
    float s_1 = (SINE_A + (u * (SINE_B + (u * (SINE_C + (u * SINE_D))))));
    float c = (COSINE_A + (u * (COSINE_B + (u * (COSINE_C + (u * COSINE_D))))));
    const SineCosine sinecosine = ConstructSineCosine((r + (r * (u * s_1))), (1.0 - (u * (0.5 - (u * c)))));
    return sinecosine;
}

// Returns the sine and cosine of r for r within a quarter turn of 0, to 5e-6.
SineCosine sine_cosine_near_medium(float r_1)
{
    float u_1 = (r_1 * r_1);
    float s_2 = (SINE_MEDIUM_A + (u_1 * (SINE_MEDIUM_B + (u_1 * SINE_MEDIUM_C))));
    float c_1 = (COSINE_MEDIUM_A + (u_1 * (COSINE_MEDIUM_B + (u_1 * COSINE_MEDIUM_C))));
    const SineCosine sinecosine_1 = ConstructSineCosine((r_1 + (r_1 * (u_1 * s_2))), (1.0 - (u_1 * (0.5 - (u_1 * c_1)))));
    return sinecosine_1;
}

// Returns the sine and cosine of r for r within a quarter turn of 0, to 6e-4.
SineCosine sine_cosine_near_coarse(float r_2)
{
    float u_2 = (r_2 * r_2);
    float s_3 = (SINE_COARSE_A + (u_2 * SINE_COARSE_B));
    float c_2 = (COSINE_COARSE_A + (u_2 * COSINE_COARSE_B));
    const SineCosine sinecosine_2 = ConstructSineCosine((r_2 + (r_2 * (u_2 * s_3))), (1.0 - (u_2 * (0.5 - (u_2 * c_2)))));
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
    float n_1 = round((bounded * LOG_TWO_E));
    float r_3 = ((bounded - (n_1 * LN_TWO_HIGH)) - (n_1 * LN_TWO_LOW));
    float e = (EXPONENTIAL_A + (r_3 * (EXPONENTIAL_B + (r_3 * (EXPONENTIAL_C + (r_3 * (EXPONENTIAL_D + (r_3 * EXPONENTIAL_E))))))));
    float value_1 = (1.0 + (r_3 * (1.0 + (r_3 * e))));
    float halved_1 = round((n_1 * 0.5));
    float first_6 = asfloat((asuint((halved_1 + EXPONENT_BIAS)) << 23u));
    float second = asfloat((asuint(((n_1 - halved_1) + EXPONENT_BIAS)) << 23u));
    return ((value_1 * first_6) * second);
}

// Returns Si(x), the integral of sin t / t from 0 to x (radians), to f32 grade.
//
// Any x; odd. VWH18 Eq. 28.
float sine_integral(float x_4)
{
    float y_1 = abs(x_4);
    float u_3 = (y_1 * y_1);
    float q_8 = (SI_HEAD_A + (u_3 * (SI_HEAD_B + (u_3 * (SI_HEAD_C + (u_3 * (SI_HEAD_D + (u_3 * (SI_HEAD_E + (u_3 * SI_HEAD_F))))))))));
    float head = (y_1 + (y_1 * (u_3 * q_8)));
    float bounded_1 = min(y_1, PHASE_LIMIT);
    const HalfTurns _e24 = reduce_half_turns(bounded_1);
    const SineCosine _e26 = sine_cosine_near(_e24.rest);
    float s_4 = min(u_3, SQUARE_LIMIT);
    float n_2 = ((s_4 * ((s_4 * ((s_4 * (s_4 + SI_F_A)) + SI_F_B)) + SI_F_C)) + SI_F_D);
    float d = ((s_4 * ((s_4 * ((s_4 * (s_4 + SI_D_A)) + SI_D_B)) + SI_D_C)) + SI_D_D);
    float m_1 = ((s_4 * ((s_4 * (s_4 + SI_G_A)) + SI_G_B)) + SI_G_C);
    float wave = (((_e26.cosine * n_2) + ((_e26.sine * bounded_1) * m_1)) / (bounded_1 * d));
    float tail = (HALF_PI - (_e24.parity * wave));
    float value_2 = ((y_1 < SI_BORDER) ? head : tail);
    float finite = ((y_1 >= PHASE_LIMIT) ? HALF_PI : value_2);
    const float _e78 = odd_continuation(x_4, finite);
    return _e78;
}

// Returns Si(x) to 1e-5 absolute. Any x; odd. VWH18 Eq. 28.
float sine_integral_medium(float x_5)
{
    float y_2 = abs(x_5);
    float u_4 = (y_2 * y_2);
    float q_9 = (SI_MEDIUM_HEAD_A + (u_4 * (SI_MEDIUM_HEAD_B + (u_4 * (SI_MEDIUM_HEAD_C + (u_4 * (SI_MEDIUM_HEAD_D + (u_4 * SI_MEDIUM_HEAD_E))))))));
    float head_1 = (y_2 + (y_2 * (u_4 * q_9)));
    float bounded_2 = min(y_2, PHASE_LIMIT);
    const HalfTurns _e21 = reduce_half_turns(bounded_2);
    const SineCosine _e23 = sine_cosine_near_medium(_e21.rest);
    float s_5 = min(u_4, SQUARE_LIMIT);
    float n_3 = ((s_5 * (s_5 + SI_MEDIUM_F_A)) + SI_MEDIUM_F_B);
    float d_1 = ((s_5 * (s_5 + SI_MEDIUM_D_A)) + SI_MEDIUM_D_B);
    float m_2 = (s_5 + SI_MEDIUM_G_A);
    float wave_1 = (((_e23.cosine * n_3) + ((_e23.sine * bounded_2) * m_2)) / (bounded_2 * d_1));
    float tail_1 = (HALF_PI - (_e21.parity * wave_1));
    float value_3 = ((y_2 < SI_MEDIUM_BORDER) ? head_1 : tail_1);
    const float _e53 = odd_continuation(x_5, value_3);
    return _e53;
}

// Returns Si(x) to 4e-4 absolute. Any x; odd. VWH18 Eq. 28.
float sine_integral_coarse(float x_6)
{
    float y_3 = abs(x_6);
    float u_5 = (y_3 * y_3);
    float q_10 = (SI_COARSE_HEAD_A + (u_5 * (SI_COARSE_HEAD_B + (u_5 * (SI_COARSE_HEAD_C + (u_5 * SI_COARSE_HEAD_D))))));
    float head_2 = (y_3 + (y_3 * (u_5 * q_10)));
    float bounded_3 = min(y_3, PHASE_LIMIT);
    const HalfTurns _e18 = reduce_half_turns(bounded_3);
    const SineCosine _e20 = sine_cosine_near_coarse(_e18.rest);
    float s_6 = min(u_5, SQUARE_LIMIT);
    float wave_2 = (((_e20.cosine * (s_6 + SI_COARSE_F_A)) + (_e20.sine * bounded_3)) / (bounded_3 * (s_6 + SI_COARSE_D_A)));
    float tail_2 = (HALF_PI - (_e18.parity * wave_2));
    float value_4 = ((y_3 < SI_COARSE_BORDER) ? head_2 : tail_2);
    const float _e41 = odd_continuation(x_6, value_4);
    return _e41;
}

// Returns Si(x) by the fit that VWH18 publishes, Eq. 29, to 0.051 absolute.
//
// Kept to compare with: its differences have the wrong sign over a quarter of the axis.
float sine_integral_velinov(float x_7)
{
    float y_4 = abs(x_7);
    const SineCosine _e4 = sine_cosine(min(y_4, PHASE_LIMIT));
    const float _e11 = exponential((2.0 * min(y_4, 20.0)));
    float sigmoid = (1.0 - (2.0 / (_e11 + 1.0)));
    float offset = (y_4 - VELINOV_OFFSET);
    float value_5 = (((HALF_PI * sigmoid) - ((VELINOV_BUMP * y_4) / (1.0 + (offset * offset)))) + ((1.0 - _e4.cosine) / (1.0 + y_4)));
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

    float a = abs(first);
    float b = abs(last);
    bool swap = (b < a);
    if ((min(first, last) < 0.0)) {
        local = (max(first, last) > 0.0);
    } else {
        local = false;
    }
    bool _e16 = local;
    const ArcEnds arcends = ConstructArcEnds((swap ? b : a), (swap ? a : b), _e16);
    return arcends;
}

// Returns the two nodes m - s and m + s of the Gauss sum, sin^2 t / t^2 each, added.
float arc_node_pair(SineCosine middle, SineCosine node, float m, float s)
{
    float even = (middle.sine * node.cosine);
    float odd = (middle.cosine * node.sine);
    float right = ((even + odd) / (m + s));
    float left = ((even - odd) / (m - s));
    return ((right * right) + (left * left));
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
    float u_6 = (q * q);
    float p = (ARC_HEAD_A + (u_6 * (ARC_HEAD_B + (u_6 * (ARC_HEAD_C + (u_6 * (ARC_HEAD_D + (u_6 * (ARC_HEAD_E + (u_6 * ARC_HEAD_F))))))))));
    return (q + (q * (u_6 * p)));
}

// Returns pi/2 - H(2q) - 1/(2q) for q above the border, from the phase of q reduced by half turns,
// to f32 grade.
float arc_wave(float q_1, SineCosine phase)
{
    float v_2 = (0.5 / q_1);
    float w = (v_2 * v_2);
    float k = (w * (ARC_K_A + (w * (ARC_K_B + (w * (ARC_K_C + (w * (ARC_K_D + (w * ARC_K_E)))))))));
    float d_2 = (1.0 + (w * (ARC_D_A + (w * (ARC_D_B + (w * (ARC_D_C + (w * (ARC_D_D + (w * ARC_D_E))))))))));
    float m_3 = (1.0 + (w * (ARC_G_A + (w * (ARC_G_B + (w * (ARC_G_C + (w * ARC_G_D))))))));
    float twice = (phase.sine + phase.sine);
    float double_sine = (twice * phase.cosine);
    float double_cosine = (1.0 - (twice * phase.sine));
    return (((double_sine * (w * m_3)) - (double_cosine * (v_2 * k))) / d_2);
}

// Returns the Gauss sum over a short arc that begins at q with the phase `rest`, to f32 grade.
float arc_short(float q_2, float extent_1, float rest_1)
{
    float halved_2 = (0.5 * extent_1);
    float m_4 = (q_2 + halved_2);
    const float _e6 = arc_middle_phase(rest_1, halved_2);
    const SineCosine _e7 = sine_cosine_near(_e6);
    float inner = (halved_2 * GAUSS_INNER);
    float outer = (halved_2 * GAUSS_OUTER);
    const SineCosine _e12 = sine_cosine_near(inner);
    const float _e13 = arc_node_pair(_e7, _e12, m_4, inner);
    const SineCosine _e14 = sine_cosine_near(outer);
    const float _e15 = arc_node_pair(_e7, _e14, m_4, outer);
    return (halved_2 * ((GAUSS_INNER_WEIGHT * _e13) + (GAUSS_OUTER_WEIGHT * _e15)));
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

// Returns the integral of (sin t / t)^2 from q0 to q1 (radians), to f32 grade.
//
// Never negative for q0 <= q1, antisymmetric in its bounds, even in their signs. The phase is exact
// to 1e-7 for
// |q| to 1e4. VWH18 Eq. 27.
float sinc_squared_integral(float first_1, float last_1)
{
    const ArcEnds _e2 = arc_ends(first_1, last_1);
    const HalfTurns _e6 = reduce_half_turns(min(_e2.near, ARC_PHASE_LIMIT));
    const HalfTurns _e10 = reduce_half_turns(min(_e2.far, ARC_PHASE_LIMIT));
    const float _e16 = arc_of_phases(_e2, (_e2.far - _e2.near), _e6.rest, _e10.rest);
    float signed_ = ((last_1 < first_1) ? -(_e16) : _e16);
    return ((first_1 == last_1) ? 0.0 : signed_);
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
    float rest_3 = ((x_high * (y - y_high)) + ((x_8 - x_high) * y));
    float leading = min((product - round(product)), 0.5);
    float fraction = (leading + min(rest_3, 0.5));
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
float sinc_squared_integral_turns(float width, float first_2, float last_2)
{
    const ArcEnds _e3 = arc_ends(first_2, last_2);
    float scale = (ARC_PI * width);
    ArcEnds ends_2 = ConstructArcEnds((scale * _e3.near), (scale * _e3.far), _e3.straddles);
    const float _e14 = product_fraction(width, _e3.near);
    float near_rest_1 = (ARC_PI * _e14);
    const float _e18 = product_fraction(width, _e3.far);
    float far_rest_1 = (ARC_PI * _e18);
    const float _e24 = arc_of_phases(ends_2, (scale * (_e3.far - _e3.near)), near_rest_1, far_rest_1);
    float signed_1 = ((last_2 < first_2) ? -(_e24) : _e24);
    return ((first_2 == last_2) ? 0.0 : signed_1);
}

// Returns H(2q) for q below the border, to 1e-8.
float arc_head_medium(float q_3)
{
    float u_7 = (q_3 * q_3);
    float p_1 = (ARC_MEDIUM_HEAD_A + (u_7 * (ARC_MEDIUM_HEAD_B + (u_7 * (ARC_MEDIUM_HEAD_C + (u_7 * (ARC_MEDIUM_HEAD_D + (u_7 * ARC_MEDIUM_HEAD_E))))))));
    return (q_3 + (q_3 * (u_7 * p_1)));
}

// Returns pi/2 - H(2q) - 1/(2q) for q above the border, to about 1e-6 of 1/(2q).
float arc_wave_medium(float q_4, SineCosine phase_1)
{
    float v_3 = (0.5 / q_4);
    float w_1 = (v_3 * v_3);
    float k_1 = (w_1 * (ARC_MEDIUM_K_A + (w_1 * (ARC_MEDIUM_K_B + (w_1 * (ARC_MEDIUM_K_C + (w_1 * ARC_MEDIUM_K_D)))))));
    float d_3 = (1.0 + (w_1 * (ARC_MEDIUM_D_A + (w_1 * (ARC_MEDIUM_D_B + (w_1 * (ARC_MEDIUM_D_C + (w_1 * ARC_MEDIUM_D_D))))))));
    float m_5 = (1.0 + (w_1 * (ARC_MEDIUM_G_A + (w_1 * (ARC_MEDIUM_G_B + (w_1 * ARC_MEDIUM_G_C))))));
    float twice_1 = (phase_1.sine + phase_1.sine);
    float double_sine_1 = (twice_1 * phase_1.cosine);
    float double_cosine_1 = (1.0 - (twice_1 * phase_1.sine));
    return (((double_sine_1 * (w_1 * m_5)) - (double_cosine_1 * (v_3 * k_1))) / d_3);
}

// Returns the arc of [`sinc_squared_integral`] to 5e-6 absolute.
float sinc_squared_integral_medium(float first_3, float last_3)
{
    const ArcEnds _e2 = arc_ends(first_3, last_3);
    float extent_3 = (_e2.far - _e2.near);
    const HalfTurns _e9 = reduce_half_turns(min(_e2.near, ARC_PHASE_LIMIT));
    const HalfTurns _e13 = reduce_half_turns(min(_e2.far, ARC_PHASE_LIMIT));
    const SineCosine _e16 = sine_cosine_near_medium(_e9.rest);
    const float _e17 = arc_wave_medium(_e2.near, _e16);
    const SineCosine _e20 = sine_cosine_near_medium(_e13.rest);
    const float _e21 = arc_wave_medium(_e2.far, _e20);
    float halved_3 = (0.5 * extent_3);
    float m_6 = (_e2.near + halved_3);
    const float _e27 = arc_middle_phase(_e9.rest, halved_3);
    const SineCosine _e28 = sine_cosine_near_medium(_e27);
    float inner_1 = (halved_3 * GAUSS_INNER);
    float outer_1 = (halved_3 * GAUSS_OUTER);
    const SineCosine _e33 = sine_cosine_near_medium(inner_1);
    const float _e34 = arc_node_pair(_e28, _e33, m_6, inner_1);
    const SineCosine _e35 = sine_cosine_near_medium(outer_1);
    const float _e36 = arc_node_pair(_e28, _e35, m_6, outer_1);
    float gauss_sum_1 = (halved_3 * ((GAUSS_INNER_WEIGHT * _e34) + (GAUSS_OUTER_WEIGHT * _e36)));
    const float _e45 = arc_head_medium(_e2.near);
    const float _e47 = arc_head_medium(_e2.far);
    const float _e48 = arc_join(_e2, extent_3, ARC_MEDIUM_BORDER, _e45, _e47, _e17, _e21, gauss_sum_1);
    float signed_2 = ((last_3 < first_3) ? -(_e48) : _e48);
    return ((first_3 == last_3) ? 0.0 : signed_2);
}

// Returns H(2q) for q below the border, to 6e-6.
float arc_head_coarse(float q_5)
{
    float u_8 = (q_5 * q_5);
    float p_2 = (ARC_COARSE_HEAD_A + (u_8 * (ARC_COARSE_HEAD_B + (u_8 * (ARC_COARSE_HEAD_C + (u_8 * ARC_COARSE_HEAD_D))))));
    return (q_5 + (q_5 * (u_8 * p_2)));
}

// Returns pi/2 - H(2q) - 1/(2q) for q above the border, to about 3e-4 of 1/(2q).
float arc_wave_coarse(float q_6, SineCosine phase_2)
{
    float v_4 = (0.5 / q_6);
    float w_2 = (v_4 * v_4);
    float k_2 = (w_2 * (ARC_COARSE_K_A + (w_2 * (ARC_COARSE_K_B + (w_2 * ARC_COARSE_K_C)))));
    float d_4 = (1.0 + (w_2 * (ARC_COARSE_D_A + (w_2 * (ARC_COARSE_D_B + (w_2 * ARC_COARSE_D_C))))));
    float m_7 = (1.0 + (w_2 * (ARC_COARSE_G_A + (w_2 * ARC_COARSE_G_B))));
    float twice_2 = (phase_2.sine + phase_2.sine);
    float double_sine_2 = (twice_2 * phase_2.cosine);
    float double_cosine_2 = (1.0 - (twice_2 * phase_2.sine));
    return (((double_sine_2 * (w_2 * m_7)) - (double_cosine_2 * (v_4 * k_2))) / d_4);
}

// Returns the arc of [`sinc_squared_integral`] to 4e-4 absolute.
float sinc_squared_integral_coarse(float first_4, float last_4)
{
    const ArcEnds _e2 = arc_ends(first_4, last_4);
    float extent_4 = (_e2.far - _e2.near);
    const HalfTurns _e9 = reduce_half_turns(min(_e2.near, ARC_PHASE_LIMIT));
    const HalfTurns _e13 = reduce_half_turns(min(_e2.far, ARC_PHASE_LIMIT));
    const SineCosine _e16 = sine_cosine_near_coarse(_e9.rest);
    const float _e17 = arc_wave_coarse(_e2.near, _e16);
    const SineCosine _e20 = sine_cosine_near_coarse(_e13.rest);
    const float _e21 = arc_wave_coarse(_e2.far, _e20);
    float halved_4 = (0.5 * extent_4);
    float m_8 = (_e2.near + halved_4);
    const float _e27 = arc_middle_phase(_e9.rest, halved_4);
    const SineCosine _e28 = sine_cosine_near_coarse(_e27);
    float outer_2 = (halved_4 * GAUSS_THREE);
    const SineCosine _e31 = sine_cosine_near_coarse(outer_2);
    const float _e32 = arc_node_pair(_e28, _e31, m_8, outer_2);
    float centre = (_e28.sine / m_8);
    float gauss_sum_2 = (halved_4 * ((GAUSS_THREE_OUTER_WEIGHT * _e32) + ((GAUSS_THREE_MIDDLE_WEIGHT * centre) * centre)));
    const float _e44 = arc_head_coarse(_e2.near);
    const float _e46 = arc_head_coarse(_e2.far);
    const float _e47 = arc_join(_e2, extent_4, ARC_COARSE_BORDER, _e44, _e46, _e17, _e21, gauss_sum_2);
    float signed_3 = ((last_4 < first_4) ? -(_e47) : _e47);
    return ((first_4 == last_4) ? 0.0 : signed_3);
}

// Returns the bracket of VWH18 Eq. 27, Si(2q) - sin^2 q / q with the fit of Eq. 29, 0 at q = 0.
float arc_antiderivative_velinov(float q_7)
{
    const SineCosine _e1 = sine_cosine(q_7);
    float sine = _e1.sine;
    float square = ((q_7 == 0.0) ? 0.0 : ((sine * sine) / q_7));
    const float _e10 = sine_integral_velinov((q_7 + q_7));
    return (_e10 - square);
}

// Returns the arc by VWH18 Eq. 27 with the fit of Eq. 29.
//
// Kept to compare with: negative for many arcs that do not contain the peak.
float sinc_squared_integral_velinov(float first_5, float last_5)
{
    const float _e2 = arc_antiderivative_velinov(last_5);
    const float _e3 = arc_antiderivative_velinov(first_5);
    return (_e2 - _e3);
}
