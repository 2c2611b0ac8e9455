#define_import_path iridescence
// iridescence: closed-form wave optics for renderers, f32.
// WGSL.
// Generated from src/shader/*.rs by `cargo run -p shadergen`: do not edit.
// Licence: MIT OR Apache-2.0.

// ---- coefficients ----
// Coefficients of the f32 kernels; the letters count powers upward.

// (sin r / r - 1)/r^2 in r^2; sine within 4.7e-9.
const SINE_A: f32 = -0.16666657f;
const SINE_B: f32 = 0.008333015f;
const SINE_C: f32 = -0.00019806474f;
const SINE_D: f32 = 2.5997415e-06f;
// ((cos r - 1)/r^2 + 1/2)/r^2 in r^2; cosine within 4.0e-10.
const COSINE_A: f32 = 0.041666657f;
const COSINE_B: f32 = -0.0013888567f;
const COSINE_C: f32 = 2.4769173e-05f;
const COSINE_D: f32 = -2.6191063e-07f;
// (sin r / r - 1)/r^2 in r^2; sine within 8.9e-7.
const SINE_MEDIUM_A: f32 = -0.16665675f;
const SINE_MEDIUM_B: f32 = 0.00831228f;
const SINE_MEDIUM_C: f32 = -0.00018489461f;
// ((cos r - 1)/r^2 + 1/2)/r^2 in r^2; cosine within 9.5e-8.
const COSINE_MEDIUM_A: f32 = 0.04166543f;
const COSINE_MEDIUM_B: f32 = -0.0013865135f;
const COSINE_MEDIUM_C: f32 = 2.3376515e-05f;
// (sin r / r - 1)/r^2 in r^2; sine within 0.00011.
const SINE_COARSE_A: f32 = -0.1660762f;
const SINE_COARSE_B: f32 = 0.00763235f;
// ((cos r - 1)/r^2 + 1/2)/r^2 in r^2; cosine within 1.7e-5.
const COSINE_COARSE_A: f32 = 0.041583017f;
const COSINE_COARSE_B: f32 = -0.0012964817f;
// (exp r - 1 - r)/r^2 in r; exp within 3.1e-9.
const EXPONENTIAL_A: f32 = 0.5f;
const EXPONENTIAL_B: f32 = 0.16666518f;
const EXPONENTIAL_C: f32 = 0.041666202f;
const EXPONENTIAL_D: f32 = 0.00836896f;
const EXPONENTIAL_E: f32 = 0.0013950627f;
// (1 - arctan t/t)/t^2 in t^2; arctan within 5.0e-9.
const ARCTANGENT_A: f32 = 0.33332753f;
const ARCTANGENT_B: f32 = -0.199718f;
const ARCTANGENT_C: f32 = 0.13823614f;
const ARCTANGENT_D: f32 = -0.07899901f;
// (2 artanh s/s - 2)/s^2 in s^2; 2 artanh within 1.8e-10.
const ARTANH_A: f32 = 0.6666682f;
const ARTANH_B: f32 = 0.39973545f;
const ARTANH_C: f32 = 0.29962823f;
// Border of head and tail.
const SI_BORDER: f32 = 3.0f;
// (Si(x)/x - 1)/x^2 in x^2; Si within 5.0e-11.
const SI_HEAD_A: f32 = -0.055555556f;
const SI_HEAD_B: f32 = 0.001666666f;
const SI_HEAD_C: f32 = -2.8344251e-05f;
const SI_HEAD_D: f32 = 3.060661e-07f;
const SI_HEAD_E: f32 = -2.2577045e-09f;
const SI_HEAD_F: f32 = 1.0790571e-11f;
// N of x f = N/D from the power 1; within 1.7e-8 of f and g.
const SI_F_A: f32 = 70.17039f;
const SI_F_B: f32 = 989.60046f;
const SI_F_C: f32 = 2541.1763f;
const SI_F_D: f32 = 364.07697f;
// D of x f = N/D and x^2 g = M/D from the power 1; within 1.7e-8 of f and g.
const SI_D_A: f32 = 72.17014f;
const SI_D_B: f32 = 1110.126f;
const SI_D_C: f32 = 3699.743f;
const SI_D_D: f32 = 1548.3854f;
// M of x^2 g = M/D from the power 1; within 1.7e-8 of f and g.
const SI_G_A: f32 = 66.17814f;
const SI_G_B: f32 = 793.8138f;
const SI_G_C: f32 = 1338.202f;
// Border of head and tail.
const SI_MEDIUM_BORDER: f32 = 4.0f;
// (Si(x)/x - 1)/x^2 in x^2; Si within 2.1e-7.
const SI_MEDIUM_HEAD_A: f32 = -0.055555113f;
const SI_MEDIUM_HEAD_B: f32 = 0.0016663427f;
const SI_MEDIUM_HEAD_C: f32 = -2.8261613e-05f;
const SI_MEDIUM_HEAD_D: f32 = 2.9645898e-07f;
const SI_MEDIUM_HEAD_E: f32 = -1.7360231e-09f;
// N of x f = N/D from the power 1; within 5.7e-6 of f and g.
const SI_MEDIUM_F_A: f32 = 17.290882f;
const SI_MEDIUM_F_B: f32 = 12.183432f;
// D of x f = N/D and x^2 g = M/D from the power 1; within 5.7e-6 of f and g.
const SI_MEDIUM_D_A: f32 = 19.27993f;
const SI_MEDIUM_D_B: f32 = 29.837011f;
// M of x^2 g = M/D from the power 1; within 5.7e-6 of f and g.
const SI_MEDIUM_G_A: f32 = 13.527913f;
// Border of head and tail.
const SI_COARSE_BORDER: f32 = 4.2f;
// (Si(x)/x - 1)/x^2 in x^2; Si within 1.6e-5.
const SI_COARSE_HEAD_A: f32 = -0.055537447f;
const SI_COARSE_HEAD_B: f32 = 0.0016581498f;
const SI_COARSE_HEAD_C: f32 = -2.7003263e-05f;
const SI_COARSE_HEAD_D: f32 = 2.1766542e-07f;
// N of x f = N/D from the power 1; within 0.00027 of f and g.
const SI_COARSE_F_A: f32 = 2.6163409f;
// D of x f = N/D and x^2 g = M/D from the power 1; within 0.00027 of f and g.
const SI_COARSE_D_A: f32 = 4.341545f;
// Border of head and tail in q = y/2.
const ARC_BORDER: f32 = 1.5f;
// (H(2q)/q - 1)/q^2 in q^2; H within 3.2e-12.
const ARC_HEAD_A: f32 = -0.11111111f;
const ARC_HEAD_B: f32 = 0.008888887f;
const ARC_HEAD_C: f32 = -0.00045351134f;
const ARC_HEAD_D: f32 = 1.5672966e-05f;
const ARC_HEAD_E: f32 = -3.8613345e-07f;
const ARC_HEAD_F: f32 = 6.4225927e-09f;
// K of 1 - y f = K/D from the power 1; 1 - y f within 4.0e-8/y, y^2 g within 4.0e-8.
const ARC_K_A: f32 = 1.9999956f;
const ARC_K_B: f32 = 258.43646f;
const ARC_K_C: f32 = 7410.3594f;
const ARC_K_D: f32 = 46687.168f;
const ARC_K_E: f32 = 36415.418f;
// D of 1 - y f = K/D and y^2 g = M/D from the power 1; 1 - y f within 4.0e-8/y, y^2 g within
// 4.0e-8.
const ARC_D_A: f32 = 141.21405f;
const ARC_D_B: f32 = 5042.531f;
const ARC_D_C: f32 = 52164.527f;
const ARC_D_D: f32 = 133795.45f;
const ARC_D_E: f32 = 46657.9f;
// M of y^2 g = M/D from the power 1; 1 - y f within 4.0e-8/y, y^2 g within 4.0e-8.
const ARC_G_A: f32 = 135.21423f;
const ARC_G_B: f32 = 4315.019f;
const ARC_G_C: f32 = 33926.46f;
const ARC_G_D: f32 = 43137.465f;
// Border of head and tail in q = y/2.
const ARC_MEDIUM_BORDER: f32 = 1.5f;
// (H(2q)/q - 1)/q^2 in q^2; H within 4.0e-10.
const ARC_MEDIUM_HEAD_A: f32 = -0.1111111f;
const ARC_MEDIUM_HEAD_B: f32 = 0.008888806f;
const ARC_MEDIUM_HEAD_C: f32 = -0.0004533653f;
const ARC_MEDIUM_HEAD_D: f32 = 1.5554067e-05f;
const ARC_MEDIUM_HEAD_E: f32 = -3.4116866e-07f;
// K of 1 - y f = K/D from the power 1; 1 - y f within 9.1e-7/y, y^2 g within 9.1e-7.
const ARC_MEDIUM_K_A: f32 = 1.9999629f;
const ARC_MEDIUM_K_B: f32 = 145.12321f;
const ARC_MEDIUM_K_C: f32 = 1707.5638f;
const ARC_MEDIUM_K_D: f32 = 2135.3086f;
// D of 1 - y f = K/D and y^2 g = M/D from the power 1; 1 - y f within 9.1e-7/y, y^2 g within
// 9.1e-7.
const ARC_MEDIUM_D_A: f32 = 84.52877f;
const ARC_MEDIUM_D_B: f32 = 1521.9207f;
const ARC_MEDIUM_D_C: f32 = 5905.193f;
const ARC_MEDIUM_D_D: f32 = 2854.2007f;
// M of y^2 g = M/D from the power 1; 1 - y f within 9.1e-7/y, y^2 g within 9.1e-7.
const ARC_MEDIUM_G_A: f32 = 78.53092f;
const ARC_MEDIUM_G_B: f32 = 1133.2189f;
const ARC_MEDIUM_G_C: f32 = 2315.1272f;
// Border of head and tail in q = y/2.
const ARC_COARSE_BORDER: f32 = 1.5f;
// (H(2q)/q - 1)/q^2 in q^2; H within 4.0e-8.
const ARC_COARSE_HEAD_A: f32 = -0.11111016f;
const ARC_COARSE_HEAD_B: f32 = 0.008885415f;
const ARC_COARSE_HEAD_C: f32 = -0.00044930252f;
const ARC_COARSE_HEAD_D: f32 = 1.3569316e-05f;
// K of 1 - y f = K/D from the power 1; 1 - y f within 1.8e-5/y, y^2 g within 1.8e-5.
const ARC_COARSE_K_A: f32 = 1.9989456f;
const ARC_COARSE_K_B: f32 = 67.905655f;
const ARC_COARSE_K_C: f32 = 185.41277f;
// D of 1 - y f = K/D and y^2 g = M/D from the power 1; 1 - y f within 1.8e-5/y, y^2 g within
// 1.8e-5.
const ARC_COARSE_D_A: f32 = 45.673885f;
const ARC_COARSE_D_B: f32 = 335.51318f;
const ARC_COARSE_D_C: f32 = 273.18066f;
// M of y^2 g = M/D from the power 1; 1 - y f within 1.8e-5/y, y^2 g within 1.8e-5.
const ARC_COARSE_G_A: f32 = 39.695797f;
const ARC_COARSE_G_B: f32 = 173.4533f;

// ---- elementary ----
// Sine, cosine and exponential of the f32 kernels.

// 1/pi.
const INVERSE_PI: f32 = 0.31830987f;
// pi in 8 bits: its products with integers below 65536 are exact.
const PI_HIGH: f32 = 3.140625f;
// What [`PI_HIGH`] left out.
const PI_LOW: f32 = 0.0009676536f;
// A little more than pi/2: what the rounding of a phase may leave, and where the kernels still
// hold.
const REST_LIMIT: f32 = 1.75f;
// 2 pi.
const TWO_PI: f32 = 6.2831855f;
// From here on no phase of an f32 is known to better than a radian.
const PHASE_LIMIT: f32 = 33554432.0f;
// 2^23 + 127.
const EXPONENT_BIAS: f32 = 8388735.0f;
// log2 e.
const LOG_TWO_E: f32 = 1.442695f;
// ln 2 in 10 bits.
const LN_TWO_HIGH: f32 = 0.693359375f;
// What [`LN_TWO_HIGH`] left out.
const LN_TWO_LOW: f32 = -0.00021219444f;

// The sine and the cosine of one angle.
struct SineCosine {
    // The sine.
    sine: f32,
    // The cosine.
    cosine: f32,
}

// An angle reduced by half turns: x = n pi + r.
struct HalfTurns {
    // r, within a quarter turn of 0, in radians.
    rest: f32,
    // 1 for an even n, -1 for an odd one.
    parity: f32,
}

// Returns the value of an odd function at x from its `value` at |x|, the sign of a zero included.
fn odd_continuation(x: f32, value: f32) -> f32 {
    return bitcast<f32>(bitcast<u32>(value) ^ (bitcast<u32>(x) & 0x80000000u));
}

// Returns x reduced by half turns, for x in radians.
//
// The error of the rest is at most 1e-7 for |x| to 1e4, and 2^-24 |x| beyond.
fn reduce_half_turns(x: f32) -> HalfTurns {
    let n = round(x * INVERSE_PI);
    let rest = (x - n * PI_HIGH) - n * PI_LOW;
    let pairs = n * 0.5f;
    let parity = 1.0f - 4.0f * abs(pairs - round(pairs));
    return HalfTurns(rest, parity);
}

// Returns the sine and cosine of r for r within a quarter turn of 0, to 1e-7; the sine keeps its
// relative accuracy.
fn sine_cosine_near(r: f32) -> SineCosine {
    let u = r * r;
    let s = SINE_A + u * (SINE_B + u * (SINE_C + u * SINE_D));
    let c = COSINE_A + u * (COSINE_B + u * (COSINE_C + u * COSINE_D));
    return SineCosine(r + r * (u * s), 1.0f - u * (0.5f - u * c));
}

// Returns the sine and cosine of r for r within a quarter turn of 0, to 5e-6.
fn sine_cosine_near_medium(r: f32) -> SineCosine {
    let u = r * r;
    let s = SINE_MEDIUM_A + u * (SINE_MEDIUM_B + u * SINE_MEDIUM_C);
    let c = COSINE_MEDIUM_A + u * (COSINE_MEDIUM_B + u * COSINE_MEDIUM_C);
    return SineCosine(r + r * (u * s), 1.0f - u * (0.5f - u * c));
}

// Returns the sine and cosine of r for r within a quarter turn of 0, to 6e-4.
fn sine_cosine_near_coarse(r: f32) -> SineCosine {
    let u = r * r;
    let s = SINE_COARSE_A + u * SINE_COARSE_B;
    let c = COSINE_COARSE_A + u * COSINE_COARSE_B;
    return SineCosine(r + r * (u * s), 1.0f - u * (0.5f - u * c));
}

// Returns the sine and cosine of x in radians, to 2.5e-7 for |x| to 1e4.
//
// Beyond, the phase loses digits in proportion; both stay within 1 for any finite x.
fn sine_cosine(x: f32) -> SineCosine {
    let turns = reduce_half_turns(x);
    let near = sine_cosine_near(min(max(turns.rest, -REST_LIMIT), REST_LIMIT));
    return SineCosine(select(turns.parity * near.sine, x, x == 0.0f), turns.parity * near.cosine);
}

// Returns the sine and cosine of a whole number of turns and a part: of 2 pi `turns`.
//
// Exact reduction for |turns| to 1.7e38: a caller that knows its phase in turns loses nothing to
// the size of the phase.
fn sine_cosine_turns(turns: f32) -> SineCosine {
    let whole = round(turns + turns);
    let pairs = whole * 0.5f;
    let near = sine_cosine_near(TWO_PI * (turns - pairs));
    let parity = 1.0f - 4.0f * abs(pairs - round(pairs));
    return SineCosine(parity * near.sine, parity * near.cosine);
}

// Returns e to the x, to 2 units of the last place for x from -87 to 88.
//
// Below, the result falls to 0 by way of subnormal numbers, which a GPU may flush; above 88.7 it
// stays at e^88.7.
fn exponential(x: f32) -> f32 {
    let bounded = min(max(x, -104.0f), 88.7f);
    let n = round(bounded * LOG_TWO_E);
    let r = (bounded - n * LN_TWO_HIGH) - n * LN_TWO_LOW;
    let e = EXPONENTIAL_A + r * (EXPONENTIAL_B + r * (EXPONENTIAL_C + r * (EXPONENTIAL_D + r *
        EXPONENTIAL_E)));
    let value = 1.0f + r * (1.0f + r * e);
    let halved = round(n * 0.5f);
    let first = bitcast<f32>(bitcast<u32>(halved + EXPONENT_BIAS) << 23u);
    let second = bitcast<f32>(bitcast<u32>((n - halved) + EXPONENT_BIAS) << 23u);
    return value * first * second;
}

// ---- sine_integral ----
// The sine integral in f32, in four grades.
// Sources named: VWH18 Eq. 28, DLMF 6.2.17-18.

// pi/2 as an f32.
const HALF_PI: f32 = 1.5707964f;
// Squares beyond this change nothing in the ratio of two polynomials.
const SQUARE_LIMIT: f32 = 16777216.0f;

// Returns Si(x), the integral of sin t / t from 0 to x (radians), to f32 grade.
//
// Any x; odd. VWH18 Eq. 28.
fn sine_integral(x: f32) -> f32 {
    let y = abs(x);
    let u = y * y;
    let q = SI_HEAD_A + u * (SI_HEAD_B + u * (SI_HEAD_C + u * (SI_HEAD_D + u * (SI_HEAD_E + u *
        SI_HEAD_F))));
    let head = y + y * (u * q);
    let bounded = min(y, PHASE_LIMIT);
    let turns = reduce_half_turns(bounded);
    let near = sine_cosine_near(turns.rest);
    let s = min(u, SQUARE_LIMIT);
    let n = s * (s * (s * (s + SI_F_A) + SI_F_B) + SI_F_C) + SI_F_D;
    let d = s * (s * (s * (s + SI_D_A) + SI_D_B) + SI_D_C) + SI_D_D;
    let m = s * (s * (s + SI_G_A) + SI_G_B) + SI_G_C;
    let wave = (near.cosine * n + (near.sine * bounded) * m) / (bounded * d);
    let tail = HALF_PI - turns.parity * wave;
    let value = select(tail, head, y < SI_BORDER);
    let finite = select(value, HALF_PI, y >= PHASE_LIMIT);
    return odd_continuation(x, finite);
}

// Returns Si(x) to 1e-5 absolute. Any x; odd. VWH18 Eq. 28.
fn sine_integral_medium(x: f32) -> f32 {
    let y = abs(x);
    let u = y * y;
    let q = SI_MEDIUM_HEAD_A + u * (SI_MEDIUM_HEAD_B + u * (SI_MEDIUM_HEAD_C + u * (SI_MEDIUM_HEAD_D
        + u * SI_MEDIUM_HEAD_E)));
    let head = y + y * (u * q);
    let bounded = min(y, PHASE_LIMIT);
    let turns = reduce_half_turns(bounded);
    let near = sine_cosine_near_medium(turns.rest);
    let s = min(u, SQUARE_LIMIT);
    let n = s * (s + SI_MEDIUM_F_A) + SI_MEDIUM_F_B;
    let d = s * (s + SI_MEDIUM_D_A) + SI_MEDIUM_D_B;
    let m = s + SI_MEDIUM_G_A;
    let wave = (near.cosine * n + (near.sine * bounded) * m) / (bounded * d);
    let tail = HALF_PI - turns.parity * wave;
    let value = select(tail, head, y < SI_MEDIUM_BORDER);
    return odd_continuation(x, value);
}

// Returns Si(x) to 4e-4 absolute. Any x; odd. VWH18 Eq. 28.
fn sine_integral_coarse(x: f32) -> f32 {
    let y = abs(x);
    let u = y * y;
    let q = SI_COARSE_HEAD_A + u * (SI_COARSE_HEAD_B + u * (SI_COARSE_HEAD_C + u *
        SI_COARSE_HEAD_D));
    let head = y + y * (u * q);
    let bounded = min(y, PHASE_LIMIT);
    let turns = reduce_half_turns(bounded);
    let near = sine_cosine_near_coarse(turns.rest);
    let s = min(u, SQUARE_LIMIT);
    let wave = (near.cosine * (s + SI_COARSE_F_A) + near.sine * bounded) / (bounded * (s +
        SI_COARSE_D_A));
    let tail = HALF_PI - turns.parity * wave;
    let value = select(tail, head, y < SI_COARSE_BORDER);
    return odd_continuation(x, value);
}
// VWH18, below Eq. 29.
const VELINOV_BUMP: f32 = 0.66142739f;
const VELINOV_OFFSET: f32 = 0.38272292f;

// Returns Si(x) by the fit that VWH18 publishes, Eq. 29, to 0.051 absolute.
//
// Kept to compare with: its differences have the wrong sign over a quarter of the axis.
fn sine_integral_velinov(x: f32) -> f32 {
    let y = abs(x);
    let wave = sine_cosine(min(y, PHASE_LIMIT));
    let sigmoid = 1.0f - 2.0f / (exponential(2.0f * min(y, 20.0f)) + 1.0f);
    let offset = y - VELINOV_OFFSET;
    let value = HALF_PI * sigmoid - (VELINOV_BUMP * y) / (1.0f + offset * offset) + (1.0f -
        wave.cosine) / (1.0f + y);
    return odd_continuation(x, value);
}

// ---- sinc_squared_integral ----
// The integral of sinc squared over an arc, in f32.
// Sources named: VWH18 Eq. 27.

// Arcs shorter than this are summed by a Gauss rule.
const ARC_SHORT: f32 = 1.0f;
// From here on an end counts as infinite: its inverse is not a normal number any more.
const ARC_INFINITE: f32 = 3.0e37f;
// Ends nearer to 0 are left out of the Gauss rule, which divides by them.
const ARC_TINY: f32 = 1.0e-30f;
// No phase beyond this.
const ARC_PHASE_LIMIT: f32 = 8388608.0f;
// pi as an f32.
const ARC_PI: f32 = 3.1415927f;
// Gauss-Legendre, 4 points: the inner node.
const GAUSS_INNER: f32 = 0.33998104f;
// Gauss-Legendre, 4 points: the outer node.
const GAUSS_OUTER: f32 = 0.8611363f;
// Gauss-Legendre, 4 points: the inner weight.
const GAUSS_INNER_WEIGHT: f32 = 0.65214515f;
// Gauss-Legendre, 4 points: the outer weight.
const GAUSS_OUTER_WEIGHT: f32 = 0.34785485f;
// Gauss-Legendre, 3 points: the outer node.
const GAUSS_THREE: f32 = 0.7745967f;
// Gauss-Legendre, 3 points: the weight of the middle.
const GAUSS_THREE_MIDDLE_WEIGHT: f32 = 0.8888889f;
// Gauss-Legendre, 3 points: the weight of the outer nodes.
const GAUSS_THREE_OUTER_WEIGHT: f32 = 0.5555556f;

// The two ends of an arc by magnitude, and how they lie.
struct ArcEnds {
    // The end nearer to 0, as a magnitude.
    near: f32,
    // The other end, as a magnitude.
    far: f32,
    // Whether 0 lies between the ends.
    straddles: bool,
}

// Returns the ends of the arc from q0 to q1.
fn arc_ends(first: f32, last: f32) -> ArcEnds {
    let a = abs(first);
    let b = abs(last);
    let swap = b < a;
    return ArcEnds(select(a, b, swap), select(b, a, swap), min(first, last) < 0.0f && max(first,
        last) > 0.0f);
}

// Returns the two nodes m - s and m + s of the Gauss sum, sin^2 t / t^2 each, added.
fn arc_node_pair(middle: SineCosine, node: SineCosine, m: f32, s: f32) -> f32 {
    let even = middle.sine * node.cosine;
    let odd = middle.cosine * node.sine;
    let right = (even + odd) / (m + s);
    let left = (even - odd) / (m - s);
    return right * right + left * left;
}

// Returns the phase of the middle of a short arc, within a quarter turn of 0.
fn arc_middle_phase(rest: f32, halved: f32) -> f32 {
    let phase = rest + halved;
    return select(phase, phase - ARC_PI, phase > HALF_PI);
}

// Returns one of the three cases of an arc of a given extent from its parts.
//
// `near_line` and `far_line` are H at the ends where they are below the border, `near_wave` and
// `far_wave` what the
// tails have beside 1/(2q), `gauss_sum` the Gauss sum.
fn arc_join(ends: ArcEnds, extent: f32, border: f32, near_line: f32, far_line: f32, near_wave: f32,
    far_wave: f32, gauss_sum: f32) -> f32 {
    let near_inverse = 0.5f / ends.near;
    let far_inverse = 0.5f / ends.far;
    let near_tail = HALF_PI - (near_inverse + near_wave);
    let far_tail = HALF_PI - (far_inverse + far_wave);
    let near_value = select(near_tail, near_line, ends.near < border);
    let far_value = select(far_tail, far_line, ends.far < border);
    let lead = select((extent * far_inverse) * (near_inverse + near_inverse), near_inverse, ends.far
        > ARC_INFINITE);
    let tails = lead + (near_wave - far_wave);
    let between = select(far_value - near_value, tails, ends.near >= border);
    let one_sided = select(between, gauss_sum, extent < ARC_SHORT && ends.near >= ARC_TINY);
    let value = select(one_sided, far_value + near_value, ends.straddles);
    return select(value, 0.0f, value < 0.0f);
}

// Returns H(2q) for q below the border, to f32 grade.
fn arc_head(q: f32) -> f32 {
    let u = q * q;
    let p = ARC_HEAD_A + u * (ARC_HEAD_B + u * (ARC_HEAD_C + u * (ARC_HEAD_D + u * (ARC_HEAD_E + u *
        ARC_HEAD_F))));
    return q + q * (u * p);
}

// Returns pi/2 - H(2q) - 1/(2q) for q above the border, from the phase of q reduced by half turns,
// to f32 grade.
fn arc_wave(q: f32, phase: SineCosine) -> f32 {
    let v = 0.5f / q;
    let w = v * v;
    let k = w * (ARC_K_A + w * (ARC_K_B + w * (ARC_K_C + w * (ARC_K_D + w * ARC_K_E))));
    let d = 1.0f + w * (ARC_D_A + w * (ARC_D_B + w * (ARC_D_C + w * (ARC_D_D + w * ARC_D_E))));
    let m = 1.0f + w * (ARC_G_A + w * (ARC_G_B + w * (ARC_G_C + w * ARC_G_D)));
    let twice = phase.sine + phase.sine;
    let double_sine = twice * phase.cosine;
    let double_cosine = 1.0f - twice * phase.sine;
    return (double_sine * (w * m) - double_cosine * (v * k)) / d;
}

// Returns the Gauss sum over a short arc that begins at q with the phase `rest`, to f32 grade.
fn arc_short(q: f32, extent: f32, rest: f32) -> f32 {
    let halved = 0.5f * extent;
    let m = q + halved;
    let middle = sine_cosine_near(arc_middle_phase(rest, halved));
    let inner = halved * GAUSS_INNER;
    let outer = halved * GAUSS_OUTER;
    let inner_pair = arc_node_pair(middle, sine_cosine_near(inner), m, inner);
    let outer_pair = arc_node_pair(middle, sine_cosine_near(outer), m, outer);
    return halved * (GAUSS_INNER_WEIGHT * inner_pair + GAUSS_OUTER_WEIGHT * outer_pair);
}

// Returns the arc from its ends, its extent and the phases of its ends reduced by half turns, to
// f32 grade.
fn arc_of_phases(ends: ArcEnds, extent: f32, near_rest: f32, far_rest: f32) -> f32 {
    let near_wave = arc_wave(ends.near, sine_cosine_near(near_rest));
    let far_wave = arc_wave(ends.far, sine_cosine_near(far_rest));
    let gauss_sum = arc_short(ends.near, extent, near_rest);
    return arc_join(ends, extent, ARC_BORDER, arc_head(ends.near), arc_head(ends.far), near_wave,
        far_wave, gauss_sum);
}

// Returns the integral of (sin t / t)^2 from q0 to q1 (radians), whose difference is known apart
// from them, to f32 grade;
// `extent` is its magnitude.
fn arc_of_extent(first: f32, last: f32, extent: f32) -> f32 {
    let ends = arc_ends(first, last);
    let near = reduce_half_turns(min(ends.near, ARC_PHASE_LIMIT));
    let far = reduce_half_turns(min(ends.far, ARC_PHASE_LIMIT));
    let value = arc_of_phases(ends, extent, near.rest, far.rest);
    return select(value, -value, last < first);
}

// Returns the integral of (sin t / t)^2 from q0 to q1 (radians), to f32 grade.
//
// Never negative for q0 <= q1, antisymmetric in its bounds, even in their signs. The phase is exact
// to 1e-7 for
// |q| to 1e4. VWH18 Eq. 27.
fn sinc_squared_integral(first: f32, last: f32) -> f32 {
    let signed = arc_of_extent(first, last, abs(abs(last) - abs(first)));
    return select(signed, 0.0f, first == last);
}

// Returns the distance of the product x y from the nearest integer, exact to 3e-8 for 0 <= x < 256
// and |y| <= 2.
//
// Both factors are cut so that the product of their leading parts fits 24 bits.
fn product_fraction(x: f32, y: f32) -> f32 {
    let x_high = floor(x * 16.0f) * 0.0625f;
    let y_high = floor(y * 2048.0f) * 0.00048828125f;
    let product = x_high * y_high;
    let rest = x_high * (y - y_high) + (x - x_high) * y;
    let leading = min(product - round(product), 0.5f);
    let fraction = leading + min(rest, 0.5f);
    return fraction - round(fraction);
}

// Returns the integral of (sin t / t)^2 over t = pi (W/lambda) xi between two direction cosines, to
// f32 grade.
//
// `width` is W/lambda, from 0 to 256, dimensionless; `first` and `last` are direction cosines from
// -2 to 2. The phase
// is reduced in turns before it is rounded, so that wide scratches lose nothing. Wider scratches
// lose digits in
// proportion; a negative width has no meaning. VWH18 Eq. 27.
fn sinc_squared_integral_turns(width: f32, first: f32, last: f32) -> f32 {
    let xi = arc_ends(first, last);
    let scale = ARC_PI * width;
    let ends = ArcEnds(scale * xi.near, scale * xi.far, xi.straddles);
    let near_rest = ARC_PI * product_fraction(width, xi.near);
    let far_rest = ARC_PI * product_fraction(width, xi.far);
    let value = arc_of_phases(ends, scale * (xi.far - xi.near), near_rest, far_rest);
    let signed = select(value, -value, last < first);
    return select(signed, 0.0f, first == last);
}

// Returns H(2q) for q below the border, to 1e-8.
fn arc_head_medium(q: f32) -> f32 {
    let u = q * q;
    let p = ARC_MEDIUM_HEAD_A + u * (ARC_MEDIUM_HEAD_B + u * (ARC_MEDIUM_HEAD_C + u *
        (ARC_MEDIUM_HEAD_D + u * ARC_MEDIUM_HEAD_E)));
    return q + q * (u * p);
}

// Returns pi/2 - H(2q) - 1/(2q) for q above the border, to about 1e-6 of 1/(2q).
fn arc_wave_medium(q: f32, phase: SineCosine) -> f32 {
    let v = 0.5f / q;
    let w = v * v;
    let k = w * (ARC_MEDIUM_K_A + w * (ARC_MEDIUM_K_B + w * (ARC_MEDIUM_K_C + w * ARC_MEDIUM_K_D)));
    let d = 1.0f + w * (ARC_MEDIUM_D_A + w * (ARC_MEDIUM_D_B + w * (ARC_MEDIUM_D_C + w *
        ARC_MEDIUM_D_D)));
    let m = 1.0f + w * (ARC_MEDIUM_G_A + w * (ARC_MEDIUM_G_B + w * ARC_MEDIUM_G_C));
    let twice = phase.sine + phase.sine;
    let double_sine = twice * phase.cosine;
    let double_cosine = 1.0f - twice * phase.sine;
    return (double_sine * (w * m) - double_cosine * (v * k)) / d;
}

// Returns the arc of [`sinc_squared_integral`] to 5e-6 absolute.
fn sinc_squared_integral_medium(first: f32, last: f32) -> f32 {
    let ends = arc_ends(first, last);
    let extent = ends.far - ends.near;
    let near = reduce_half_turns(min(ends.near, ARC_PHASE_LIMIT));
    let far = reduce_half_turns(min(ends.far, ARC_PHASE_LIMIT));
    let near_wave = arc_wave_medium(ends.near, sine_cosine_near_medium(near.rest));
    let far_wave = arc_wave_medium(ends.far, sine_cosine_near_medium(far.rest));
    let halved = 0.5f * extent;
    let m = ends.near + halved;
    let middle = sine_cosine_near_medium(arc_middle_phase(near.rest, halved));
    let inner = halved * GAUSS_INNER;
    let outer = halved * GAUSS_OUTER;
    let inner_pair = arc_node_pair(middle, sine_cosine_near_medium(inner), m, inner);
    let outer_pair = arc_node_pair(middle, sine_cosine_near_medium(outer), m, outer);
    let gauss_sum = halved * (GAUSS_INNER_WEIGHT * inner_pair + GAUSS_OUTER_WEIGHT * outer_pair);
    let value = arc_join(ends, extent, ARC_MEDIUM_BORDER, arc_head_medium(ends.near),
        arc_head_medium(ends.far), near_wave, far_wave, gauss_sum);
    let signed = select(value, -value, last < first);
    return select(signed, 0.0f, first == last);
}

// Returns H(2q) for q below the border, to 6e-6.
fn arc_head_coarse(q: f32) -> f32 {
    let u = q * q;
    let p = ARC_COARSE_HEAD_A + u * (ARC_COARSE_HEAD_B + u * (ARC_COARSE_HEAD_C + u *
        ARC_COARSE_HEAD_D));
    return q + q * (u * p);
}

// Returns pi/2 - H(2q) - 1/(2q) for q above the border, to about 3e-4 of 1/(2q).
fn arc_wave_coarse(q: f32, phase: SineCosine) -> f32 {
    let v = 0.5f / q;
    let w = v * v;
    let k = w * (ARC_COARSE_K_A + w * (ARC_COARSE_K_B + w * ARC_COARSE_K_C));
    let d = 1.0f + w * (ARC_COARSE_D_A + w * (ARC_COARSE_D_B + w * ARC_COARSE_D_C));
    let m = 1.0f + w * (ARC_COARSE_G_A + w * ARC_COARSE_G_B);
    let twice = phase.sine + phase.sine;
    let double_sine = twice * phase.cosine;
    let double_cosine = 1.0f - twice * phase.sine;
    return (double_sine * (w * m) - double_cosine * (v * k)) / d;
}

// Returns the arc of [`sinc_squared_integral`] to 4e-4 absolute.
fn sinc_squared_integral_coarse(first: f32, last: f32) -> f32 {
    let ends = arc_ends(first, last);
    let extent = ends.far - ends.near;
    let near = reduce_half_turns(min(ends.near, ARC_PHASE_LIMIT));
    let far = reduce_half_turns(min(ends.far, ARC_PHASE_LIMIT));
    let near_wave = arc_wave_coarse(ends.near, sine_cosine_near_coarse(near.rest));
    let far_wave = arc_wave_coarse(ends.far, sine_cosine_near_coarse(far.rest));
    let halved = 0.5f * extent;
    let m = ends.near + halved;
    let middle = sine_cosine_near_coarse(arc_middle_phase(near.rest, halved));
    let outer = halved * GAUSS_THREE;
    let pair = arc_node_pair(middle, sine_cosine_near_coarse(outer), m, outer);
    let centre = middle.sine / m;
    let gauss_sum = halved * (GAUSS_THREE_OUTER_WEIGHT * pair + (GAUSS_THREE_MIDDLE_WEIGHT * centre)
        * centre);
    let value = arc_join(ends, extent, ARC_COARSE_BORDER, arc_head_coarse(ends.near),
        arc_head_coarse(ends.far), near_wave, far_wave, gauss_sum);
    let signed = select(value, -value, last < first);
    return select(signed, 0.0f, first == last);
}

// Returns the bracket of VWH18 Eq. 27, Si(2q) - sin^2 q / q with the fit of Eq. 29, 0 at q = 0.
fn arc_antiderivative_velinov(q: f32) -> f32 {
    let sine = sine_cosine(q).sine;
    let square = select(sine * sine / q, 0.0f, q == 0.0f);
    return sine_integral_velinov(q + q) - square;
}

// Returns the arc by VWH18 Eq. 27 with the fit of Eq. 29.
//
// Kept to compare with: negative for many arcs that do not contain the peak.
fn sinc_squared_integral_velinov(first: f32, last: f32) -> f32 {
    return arc_antiderivative_velinov(last) - arc_antiderivative_velinov(first);
}

// ---- bessel_coefficients ----
// Coefficients of the f32 scaled modified Bessel functions; the letters count powers upward.

// Where the piece ends.
const BESSEL_FIRST_END: f32 = 0.36f;
// a of the piece.
const BESSEL_FIRST_CENTRE: f32 = 0.16500461f;
// c, e^-x I0(x) at a.
const BESSEL_FIRST_VALUE: f32 = 0.8536709f;
// (e^-x I0(x) - c)/(x - a) in x - a; within 3.0e-11 of e^-x I0(x).
const BESSEL_FIRST_A: f32 = -0.7834797f;
const BESSEL_FIRST_B: f32 = 0.570785f;
const BESSEL_FIRST_C: f32 = -0.31254634f;
const BESSEL_FIRST_D: f32 = 0.13556284f;
const BESSEL_FIRST_E: f32 = -0.048531253f;
const BESSEL_FIRST_F: f32 = 0.014805781f;
const BESSEL_FIRST_G: f32 = -0.00375398f;
// Where the piece ends.
const BESSEL_SECOND_END: f32 = 0.86f;
// a of the piece.
const BESSEL_SECOND_CENTRE: f32 = 0.56998736f;
// c, e^-x I0(x) at a.
const BESSEL_SECOND_VALUE: f32 = 0.6124071f;
// (e^-x I0(x) - c)/(x - a) in x - a; within 4.7e-11 of e^-x I0(x).
const BESSEL_SECOND_A: f32 = -0.4445993f;
const BESSEL_SECOND_B: f32 = 0.29739624f;
const BESSEL_SECOND_C: f32 = -0.15609547f;
const BESSEL_SECOND_D: f32 = 0.066040955f;
const BESSEL_SECOND_E: f32 = -0.023268692f;
const BESSEL_SECOND_F: f32 = 0.007030464f;
const BESSEL_SECOND_G: f32 = -0.0017126619f;
// Where the piece ends.
const BESSEL_THIRD_END: f32 = 1.6f;
// a of the piece.
const BESSEL_THIRD_CENTRE: f32 = 1.1800063f;
// c, e^-x I0(x) at a.
const BESSEL_THIRD_VALUE: f32 = 0.42391765f;
// (e^-x I0(x) - c)/(x - a) in x - a; within 3.3e-10 of e^-x I0(x).
const BESSEL_THIRD_A: f32 = -0.20918402f;
const BESSEL_THIRD_B: f32 = 0.1181957f;
const BESSEL_THIRD_C: f32 = -0.056936633f;
const BESSEL_THIRD_D: f32 = 0.022919957f;
const BESSEL_THIRD_E: f32 = -0.007829978f;
const BESSEL_THIRD_F: f32 = 0.0023298704f;
const BESSEL_THIRD_G: f32 = -0.0005487821f;
// Where the piece ends.
const BESSEL_FOURTH_END: f32 = 3.0f;
// a of the piece.
const BESSEL_FOURTH_CENTRE: f32 = 2.2999098f;
// c, e^-x I0(x) at a.
const BESSEL_FOURTH_VALUE: f32 = 0.2836996f;
// (e^-x I0(x) - c)/(x - a) in x - a; within 1.9e-10 of e^-x I0(x).
const BESSEL_FOURTH_A: f32 = -0.073374964f;
const BESSEL_FOURTH_B: f32 = 0.027650414f;
const BESSEL_FOURTH_C: f32 = -0.010496839f;
const BESSEL_FOURTH_D: f32 = 0.003662269f;
const BESSEL_FOURTH_E: f32 = -0.0011413017f;
const BESSEL_FOURTH_F: f32 = 0.00031557522f;
const BESSEL_FOURTH_G: f32 = -7.812707e-05f;
const BESSEL_FOURTH_H: f32 = 1.8563202e-05f;
const BESSEL_FOURTH_I: f32 = -3.7091993e-06f;
// c of mantissas on this side of the square root of 2.
const BESSEL_LOW_CENTRE: f32 = 1.2069249f;
// 1/c.
const BESSEL_LOW_INVERSE: f32 = 0.82855195f;
// 1/sqrt(2 pi c).
const BESSEL_LOW_EVEN: f32 = 0.36313653f;
// 1/sqrt(4 pi c).
const BESSEL_LOW_ODD: f32 = 0.2567763f;
// ln(2 pi c)/2.
const BESSEL_LOW_LOG: f32 = 1.0129764f;
// c of mantissas on this side of the square root of 2.
const BESSEL_HIGH_CENTRE: f32 = 1.7068787f;
// 1/c.
const BESSEL_HIGH_INVERSE: f32 = 0.5858647f;
// 1/sqrt(2 pi c).
const BESSEL_HIGH_EVEN: f32 = 0.3053576f;
// 1/sqrt(4 pi c).
const BESSEL_HIGH_ODD: f32 = 0.21592043f;
// ln(2 pi c)/2.
const BESSEL_HIGH_LOG: f32 = 1.1862717f;
// Between the two c.
const BESSEL_SPLIT: f32 = 1.4142135f;
// ((1 + t)^(-1/2) - 1)/t in t; the root within 1.4e-9.
const BESSEL_ROOT_A: f32 = -0.5f;
const BESSEL_ROOT_B: f32 = 0.37500098f;
const BESSEL_ROOT_C: f32 = -0.31250283f;
const BESSEL_ROOT_D: f32 = 0.27323663f;
const BESSEL_ROOT_E: f32 = -0.24576588f;
const BESSEL_ROOT_F: f32 = 0.23715664f;
const BESSEL_ROOT_G: f32 = -0.22318871f;
// ln(1 + t)/(2 t) in t; the logarithm within 4.5e-10.
const BESSEL_LN_A: f32 = 0.5f;
const BESSEL_LN_B: f32 = -0.2500003f;
const BESSEL_LN_C: f32 = 0.1666675f;
const BESSEL_LN_D: f32 = -0.12493642f;
const BESSEL_LN_E: f32 = 0.09990236f;
const BESSEL_LN_F: f32 = -0.08700084f;
const BESSEL_LN_G: f32 = 0.07551904f;
// Where the piece ends.
const BESSEL_OUTER_END: f32 = 6.5f;
// (sqrt(2 pi x) e^-x I0(x) - 1)/V in V = 1/(2 pi x); V times it within 9.7e-10.
const BESSEL_TAIL_A: f32 = 0.785402f;
const BESSEL_TAIL_B: f32 = 2.7710798f;
const BESSEL_TAIL_C: f32 = 20.155907f;
const BESSEL_TAIL_D: f32 = -218.7877f;
const BESSEL_TAIL_E: f32 = 43648.676f;
const BESSEL_TAIL_F: f32 = -2333362.0f;
const BESSEL_TAIL_G: f32 = 69145850.0f;
const BESSEL_TAIL_H: f32 = -735768640.0f;
// W: the middle of the V below.
const BESSEL_OUTER_CENTRE: f32 = 0.03876851f;
// sqrt(2 pi x) e^-x I0(x) - 1 in V - W with V = 1/(2 pi x); within 1.3e-9.
const BESSEL_OUTER_A: f32 = 0.03654081f;
const BESSEL_OUTER_B: f32 = 1.1803682f;
const BESSEL_OUTER_C: f32 = 8.338566f;
const BESSEL_OUTER_D: f32 = 7.426099f;
const BESSEL_OUTER_E: f32 = -2785.3804f;
const BESSEL_OUTER_F: f32 = -7030.0894f;
const BESSEL_OUTER_G: f32 = 1309036.1f;
const BESSEL_OUTER_H: f32 = -8430924.0f;
const BESSEL_OUTER_I: f32 = -442043140.0f;
// Where the tails of ln I0 and of I1/I0 begin.
const BESSEL_BORDER: f32 = 4.0f;
// Where the heads of ln I0 and of I1/I0 end.
const BESSEL_HEAD_END: f32 = 1.0f;
// (ln I0(x)/x^2 - 1/4)/x^2 in x^2; ln I0(x)/x^2 within 2.2e-10.
const BESSEL_LOG_HEAD_A: f32 = -0.01562499f;
const BESSEL_LOG_HEAD_B: f32 = 0.0017359626f;
const BESSEL_LOG_HEAD_C: f32 = -0.00022308876f;
const BESSEL_LOG_HEAD_D: f32 = 2.943114e-05f;
const BESSEL_LOG_HEAD_E: f32 = -2.9568555e-06f;
// Where the piece ends.
const BESSEL_LOG_FIRST_END: f32 = 1.5f;
// a of the piece.
const BESSEL_LOG_FIRST_CENTRE: f32 = 1.2500476f;
// c, ln I0(x) at a.
const BESSEL_LOG_FIRST_VALUE: f32 = 0.35802728f;
// (ln I0(x) - c)/(x - a) in x - a; within 3.7e-11 of ln I0(x).
const BESSEL_LOG_FIRST_A: f32 = 0.52800995f;
const BESSEL_LOG_FIRST_B: f32 = 0.14940679f;
const BESSEL_LOG_FIRST_C: f32 = -0.0361158f;
const BESSEL_LOG_FIRST_D: f32 = 0.0027255923f;
const BESSEL_LOG_FIRST_E: f32 = 0.0019267182f;
const BESSEL_LOG_FIRST_F: f32 = -0.00079366803f;
// Where the piece ends.
const BESSEL_LOG_SECOND_END: f32 = 2.4f;
// a of the piece.
const BESSEL_LOG_SECOND_CENTRE: f32 = 1.9000068f;
// c, ln I0(x) at a.
const BESSEL_LOG_SECOND_VALUE: f32 = 0.7550651f;
// (ln I0(x) - c)/(x - a) in x - a; within 2.5e-10 of ln I0(x).
const BESSEL_LOG_SECOND_A: f32 = 0.6806503f;
const BESSEL_LOG_SECOND_B: f32 = 0.08923973f;
const BESSEL_LOG_SECOND_C: f32 = -0.024726195f;
const BESSEL_LOG_SECOND_D: f32 = 0.0048648315f;
const BESSEL_LOG_SECOND_E: f32 = -0.00022707779f;
const BESSEL_LOG_SECOND_F: f32 = -0.00026824258f;
const BESSEL_LOG_SECOND_G: f32 = 0.000102527556f;
// a of the piece.
const BESSEL_LOG_THIRD_CENTRE: f32 = 3.2000892f;
// c, ln I0(x) at a.
const BESSEL_LOG_THIRD_VALUE: f32 = 1.7487875f;
// (ln I0(x) - c)/(x - a) in x - a; within 2.8e-9 of ln I0(x).
const BESSEL_LOG_THIRD_A: f32 = 0.8237543f;
const BESSEL_LOG_THIRD_B: f32 = 0.032006305f;
const BESSEL_LOG_THIRD_C: f32 = -0.0075040204f;
const BESSEL_LOG_THIRD_D: f32 = 0.0017625364f;
const BESSEL_LOG_THIRD_E: f32 = -0.00036190744f;
const BESSEL_LOG_THIRD_F: f32 = 5.3291064e-05f;
const BESSEL_LOG_THIRD_G: f32 = -2.015393e-06f;
// ln(sqrt(2 pi x) e^-x I0(x)) x in 1/x; the logarithm within 5.3e-8.
const BESSEL_LOG_TAIL_A: f32 = 0.12497927f;
const BESSEL_LOG_TAIL_B: f32 = 0.065043844f;
const BESSEL_LOG_TAIL_C: f32 = -0.039425373f;
const BESSEL_LOG_TAIL_D: f32 = 2.1019201f;
const BESSEL_LOG_TAIL_E: f32 = -19.640245f;
const BESSEL_LOG_TAIL_F: f32 = 103.07769f;
const BESSEL_LOG_TAIL_G: f32 = -247.29543f;
const BESSEL_LOG_TAIL_H: f32 = 213.7775f;
// (I1(x)/(x I0(x)) - 1/2)/x^2 in x^2; I1(x)/(x I0(x)) within 2.9e-9.
const BESSEL_RATIO_HEAD_A: f32 = -0.062499866f;
const BESSEL_RATIO_HEAD_B: f32 = 0.010414709f;
const BESSEL_RATIO_HEAD_C: f32 = -0.0017810093f;
const BESSEL_RATIO_HEAD_D: f32 = 0.00028933206f;
const BESSEL_RATIO_HEAD_E: f32 = -3.3203592e-05f;
// Where the piece ends.
const BESSEL_RATIO_FIRST_END: f32 = 2.0f;
// a of the piece.
const BESSEL_RATIO_FIRST_CENTRE: f32 = 1.5000024f;
// c, I1(x)/I0(x) at a.
const BESSEL_RATIO_FIRST_VALUE: f32 = 0.5961338f;
// (I1(x)/I0(x) - c)/(x - a) in x - a; within 5.7e-9 of I1(x)/I0(x).
const BESSEL_RATIO_FIRST_A: f32 = 0.24720253f;
const BESSEL_RATIO_FIRST_B: f32 = -0.097293206f;
const BESSEL_RATIO_FIRST_C: f32 = 0.017662916f;
const BESSEL_RATIO_FIRST_D: f32 = 0.004145302f;
const BESSEL_RATIO_FIRST_E: f32 = -0.0037807873f;
const BESSEL_RATIO_FIRST_F: f32 = 0.00085296825f;
const BESSEL_RATIO_FIRST_G: f32 = 0.00014570318f;
// a of the piece.
const BESSEL_RATIO_SECOND_CENTRE: f32 = 2.999974f;
// c, I1(x)/I0(x) at a.
const BESSEL_RATIO_SECOND_VALUE: f32 = 0.8099834f;
// (I1(x)/I0(x) - c)/(x - a) in x - a; within 8.9e-9 of I1(x)/I0(x).
const BESSEL_RATIO_SECOND_A: f32 = 0.073930226f;
const BESSEL_RATIO_SECOND_B: f32 = -0.027204137f;
const BESSEL_RATIO_SECOND_C: f32 = 0.008627776f;
const BESSEL_RATIO_SECOND_D: f32 = -0.002148176f;
const BESSEL_RATIO_SECOND_E: f32 = 0.00034924946f;
const BESSEL_RATIO_SECOND_F: f32 = 3.8275207e-06f;
const BESSEL_RATIO_SECOND_G: f32 = -3.1629304e-05f;
const BESSEL_RATIO_SECOND_H: f32 = 1.1114423e-05f;
// (1 - I1(x)/I0(x)) x in 1/x; the ratio within 1.6e-8.
const BESSEL_RATIO_TAIL_A: f32 = 0.5000091f;
const BESSEL_RATIO_TAIL_B: f32 = 0.12332922f;
const BESSEL_RATIO_TAIL_C: f32 = 0.22921288f;
const BESSEL_RATIO_TAIL_D: f32 = -2.9445055f;
const BESSEL_RATIO_TAIL_E: f32 = 52.64979f;
const BESSEL_RATIO_TAIL_F: f32 = -504.88522f;
const BESSEL_RATIO_TAIL_G: f32 = 2858.2017f;
const BESSEL_RATIO_TAIL_H: f32 = -8947.848f;
const BESSEL_RATIO_TAIL_I: f32 = 14135.413f;
const BESSEL_RATIO_TAIL_J: f32 = -8708.469f;

// ---- bessel ----
// The scaled modified Bessel function I0 in f32, its logarithm, and the ratio I1/I0.

// ln(2)/2.
const BESSEL_HALF_LN_TWO: f32 = 0.34657359f;

// A positive number as c (1 + t) 2^e, for one of two c between 1 and 2.
struct BesselPowers {
    // t, within 0.172 of 0.
    rest: f32,
    // Whether c is the one above the square root of 2.
    high: bool,
    // e + 127.
    exponent: u32,
}

// Returns x >= 1 taken apart.
fn bessel_powers(x: f32) -> BesselPowers {
    let bits = bitcast<u32>(x);
    let mantissa = bitcast<f32>((bits & 0x7fffffu) | 0x3f800000u);
    let high = mantissa >= BESSEL_SPLIT;
    let centre = select(BESSEL_LOW_CENTRE, BESSEL_HIGH_CENTRE, high);
    let inverse = select(BESSEL_LOW_INVERSE, BESSEL_HIGH_INVERSE, high);
    return BesselPowers((mantissa - centre) * inverse, high, (bits >> 23u) & 0xffu);
}

// Returns e to the -|x| times I0(x), to 1 unit of the last place.
//
// Any x; even; 1 at 0, falls as 1/sqrt(2 pi |x|), 0 at infinity.
fn bessel_i0_scaled(x: f32) -> f32 {
    let y = abs(x);
    let near_y = min(y, BESSEL_FOURTH_END);
    let second = near_y >= BESSEL_FIRST_END;
    let third = near_y >= BESSEL_SECOND_END;
    let fourth = near_y >= BESSEL_THIRD_END;
    let centre_low = select(BESSEL_FIRST_CENTRE, BESSEL_SECOND_CENTRE, second);
    let centre_high = select(BESSEL_THIRD_CENTRE, BESSEL_FOURTH_CENTRE, fourth);
    let centre = select(centre_low, centre_high, third);
    let value_low = select(BESSEL_FIRST_VALUE, BESSEL_SECOND_VALUE, second);
    let value_high = select(BESSEL_THIRD_VALUE, BESSEL_FOURTH_VALUE, fourth);
    let value = select(value_low, value_high, third);
    let pa_low = select(BESSEL_FIRST_A, BESSEL_SECOND_A, second);
    let pa_high = select(BESSEL_THIRD_A, BESSEL_FOURTH_A, fourth);
    let pa = select(pa_low, pa_high, third);
    let pb_low = select(BESSEL_FIRST_B, BESSEL_SECOND_B, second);
    let pb_high = select(BESSEL_THIRD_B, BESSEL_FOURTH_B, fourth);
    let pb = select(pb_low, pb_high, third);
    let pc_low = select(BESSEL_FIRST_C, BESSEL_SECOND_C, second);
    let pc_high = select(BESSEL_THIRD_C, BESSEL_FOURTH_C, fourth);
    let pc = select(pc_low, pc_high, third);
    let pd_low = select(BESSEL_FIRST_D, BESSEL_SECOND_D, second);
    let pd_high = select(BESSEL_THIRD_D, BESSEL_FOURTH_D, fourth);
    let pd = select(pd_low, pd_high, third);
    let pe_low = select(BESSEL_FIRST_E, BESSEL_SECOND_E, second);
    let pe_high = select(BESSEL_THIRD_E, BESSEL_FOURTH_E, fourth);
    let pe = select(pe_low, pe_high, third);
    let pf_low = select(BESSEL_FIRST_F, BESSEL_SECOND_F, second);
    let pf_high = select(BESSEL_THIRD_F, BESSEL_FOURTH_F, fourth);
    let pf = select(pf_low, pf_high, third);
    let pg_low = select(BESSEL_FIRST_G, BESSEL_SECOND_G, second);
    let pg_high = select(BESSEL_THIRD_G, BESSEL_FOURTH_G, fourth);
    let pg = select(pg_low, pg_high, third);
    let ph = select(0.0f, BESSEL_FOURTH_H, fourth);
    let pi = select(0.0f, BESSEL_FOURTH_I, fourth);
    let d = near_y - centre;
    let upper = pd + d * (pe + d * (pf + d * (pg + d * (ph + d * pi))));
    let near = value + d * (pa + d * (pb + d * (pc + d * upper)));
    let powers = bessel_powers(max(y, BESSEL_FOURTH_END));
    let odd = (powers.exponent & 1u) == 0u;
    let low_root = select(BESSEL_LOW_EVEN, BESSEL_LOW_ODD, odd);
    let high_root = select(BESSEL_HIGH_EVEN, BESSEL_HIGH_ODD, odd);
    let scale = bitcast<f32>((191u - ((powers.exponent + 1u) >> 1u)) << 23u);
    let root = select(low_root, high_root, powers.high) * scale;
    let t = powers.rest;
    let upper_root = BESSEL_ROOT_E + t * (BESSEL_ROOT_F + t * BESSEL_ROOT_G);
    let bend = BESSEL_ROOT_A + t * (BESSEL_ROOT_B + t * (BESSEL_ROOT_C + t * (BESSEL_ROOT_D + t *
        upper_root)));
    let q = t * bend;
    let whole_root = root + root * q;
    let v = whole_root * whole_root;
    let tail = y >= BESSEL_OUTER_END;
    let w = v - select(BESSEL_OUTER_CENTRE, 0.0f, tail);
    let ga = select(BESSEL_OUTER_A, 0.0f, tail);
    let gb = select(BESSEL_OUTER_B, BESSEL_TAIL_A, tail);
    let gc = select(BESSEL_OUTER_C, BESSEL_TAIL_B, tail);
    let gd = select(BESSEL_OUTER_D, BESSEL_TAIL_C, tail);
    let ge = select(BESSEL_OUTER_E, BESSEL_TAIL_D, tail);
    let gf = select(BESSEL_OUTER_F, BESSEL_TAIL_E, tail);
    let gg = select(BESSEL_OUTER_G, BESSEL_TAIL_F, tail);
    let gh = select(BESSEL_OUTER_H, BESSEL_TAIL_G, tail);
    let gi = select(BESSEL_OUTER_I, BESSEL_TAIL_H, tail);
    let upper_growth = ge + w * (gf + w * (gg + w * (gh + w * gi)));
    let growth = ga + w * (gb + w * (gc + w * (gd + w * upper_growth)));
    let far = root + root * (q + (growth + q * growth));
    let finite = select(near, far, y >= BESSEL_FOURTH_END);
    return select(finite, 0.0f, bitcast<u32>(y) == 0x7f800000u);
}

// Returns ln I0(x), to 2 units of the last place.
//
// Any x; even; x^2/4 near 0, |x| - ln(2 pi |x|)/2 far from it.
fn log_bessel_izero(x: f32) -> f32 {
    let y = abs(x);
    let bounded = min(y, BESSEL_HEAD_END);
    let u = bounded * bounded;
    let bend = BESSEL_LOG_HEAD_A + u * (BESSEL_LOG_HEAD_B + u * (BESSEL_LOG_HEAD_C + u *
        (BESSEL_LOG_HEAD_D + u * BESSEL_LOG_HEAD_E)));
    let head = u * (0.25f + u * bend);
    let middle_y = min(y, BESSEL_BORDER);
    let second = middle_y >= BESSEL_LOG_FIRST_END;
    let third = middle_y >= BESSEL_LOG_SECOND_END;
    let centre_low = select(BESSEL_LOG_FIRST_CENTRE, BESSEL_LOG_SECOND_CENTRE, second);
    let centre = select(centre_low, BESSEL_LOG_THIRD_CENTRE, third);
    let value_low = select(BESSEL_LOG_FIRST_VALUE, BESSEL_LOG_SECOND_VALUE, second);
    let value = select(value_low, BESSEL_LOG_THIRD_VALUE, third);
    let pa_low = select(BESSEL_LOG_FIRST_A, BESSEL_LOG_SECOND_A, second);
    let pa = select(pa_low, BESSEL_LOG_THIRD_A, third);
    let pb_low = select(BESSEL_LOG_FIRST_B, BESSEL_LOG_SECOND_B, second);
    let pb = select(pb_low, BESSEL_LOG_THIRD_B, third);
    let pc_low = select(BESSEL_LOG_FIRST_C, BESSEL_LOG_SECOND_C, second);
    let pc = select(pc_low, BESSEL_LOG_THIRD_C, third);
    let pd_low = select(BESSEL_LOG_FIRST_D, BESSEL_LOG_SECOND_D, second);
    let pd = select(pd_low, BESSEL_LOG_THIRD_D, third);
    let pe_low = select(BESSEL_LOG_FIRST_E, BESSEL_LOG_SECOND_E, second);
    let pe = select(pe_low, BESSEL_LOG_THIRD_E, third);
    let pf_low = select(BESSEL_LOG_FIRST_F, BESSEL_LOG_SECOND_F, second);
    let pf = select(pf_low, BESSEL_LOG_THIRD_F, third);
    let pg_high = select(BESSEL_LOG_SECOND_G, BESSEL_LOG_THIRD_G, third);
    let pg = select(0.0f, pg_high, second);
    let d = middle_y - centre;
    let upper = pd + d * (pe + d * (pf + d * pg));
    let middle = value + d * (pa + d * (pb + d * (pc + d * upper)));
    let powers = bessel_powers(max(y, BESSEL_BORDER));
    let t = powers.rest;
    let upper_log = BESSEL_LN_E + t * (BESSEL_LN_F + t * BESSEL_LN_G);
    let logarithm = t * (BESSEL_LN_A + t * (BESSEL_LN_B + t * (BESSEL_LN_C + t * (BESSEL_LN_D + t *
        upper_log))));
    let v = 1.0f / max(y, BESSEL_BORDER);
    let upper_growth = BESSEL_LOG_TAIL_E + v * (BESSEL_LOG_TAIL_F + v * (BESSEL_LOG_TAIL_G + v *
        BESSEL_LOG_TAIL_H));
    let lower_growth = BESSEL_LOG_TAIL_B + v * (BESSEL_LOG_TAIL_C + v * (BESSEL_LOG_TAIL_D + v *
        upper_growth));
    let growth = v * (BESSEL_LOG_TAIL_A + v * lower_growth);
    let constant = select(BESSEL_LOW_LOG, BESSEL_HIGH_LOG, powers.high);
    let exponent = f32((powers.exponent - 127u));
    let half_log = exponent * BESSEL_HALF_LN_TWO + (constant + (logarithm - growth));
    let near = select(head, middle, y >= BESSEL_HEAD_END);
    return select(near, y - half_log, y >= BESSEL_BORDER);
}

// Returns I1(x)/I0(x), to 2 units of the last place.
//
// Any x; odd; x/2 near 0, 1 - 1/(2x) far from it. The derivative of [`log_bessel_izero`].
fn bessel_ratio(x: f32) -> f32 {
    let y = abs(x);
    let bounded = min(y, BESSEL_HEAD_END);
    let u = bounded * bounded;
    let bend = BESSEL_RATIO_HEAD_A + u * (BESSEL_RATIO_HEAD_B + u * (BESSEL_RATIO_HEAD_C + u *
        (BESSEL_RATIO_HEAD_D + u * BESSEL_RATIO_HEAD_E)));
    let head = bounded * (0.5f + u * bend);
    let middle_y = min(y, BESSEL_BORDER);
    let second = middle_y >= BESSEL_RATIO_FIRST_END;
    let centre = select(BESSEL_RATIO_FIRST_CENTRE, BESSEL_RATIO_SECOND_CENTRE, second);
    let value = select(BESSEL_RATIO_FIRST_VALUE, BESSEL_RATIO_SECOND_VALUE, second);
    let pa = select(BESSEL_RATIO_FIRST_A, BESSEL_RATIO_SECOND_A, second);
    let pb = select(BESSEL_RATIO_FIRST_B, BESSEL_RATIO_SECOND_B, second);
    let pc = select(BESSEL_RATIO_FIRST_C, BESSEL_RATIO_SECOND_C, second);
    let pd = select(BESSEL_RATIO_FIRST_D, BESSEL_RATIO_SECOND_D, second);
    let pe = select(BESSEL_RATIO_FIRST_E, BESSEL_RATIO_SECOND_E, second);
    let pf = select(BESSEL_RATIO_FIRST_F, BESSEL_RATIO_SECOND_F, second);
    let pg = select(BESSEL_RATIO_FIRST_G, BESSEL_RATIO_SECOND_G, second);
    let ph = select(0.0f, BESSEL_RATIO_SECOND_H, second);
    let d = middle_y - centre;
    let upper = pd + d * (pe + d * (pf + d * (pg + d * ph)));
    let middle = value + d * (pa + d * (pb + d * (pc + d * upper)));
    let v = 1.0f / max(y, BESSEL_BORDER);
    let top = BESSEL_RATIO_TAIL_H + v * (BESSEL_RATIO_TAIL_I + v * BESSEL_RATIO_TAIL_J);
    let upper_tail = BESSEL_RATIO_TAIL_E + v * (BESSEL_RATIO_TAIL_F + v * (BESSEL_RATIO_TAIL_G + v *
        top));
    let lower_tail = BESSEL_RATIO_TAIL_B + v * (BESSEL_RATIO_TAIL_C + v * (BESSEL_RATIO_TAIL_D + v *
        upper_tail));
    let tail = 1.0f - v * (BESSEL_RATIO_TAIL_A + v * lower_tail);
    let near = select(head, middle, y >= BESSEL_HEAD_END);
    return odd_continuation(x, select(near, tail, y >= BESSEL_BORDER));
}

// ---- faddeeva_coefficients ----
// Coefficients of the f32 Faddeeva function; the letters count powers upward.

// |z|^2 where the two fits meet.
const FADDEEVA_BORDER: f32 = 4.0f;
// zeta about which both fits are made.
const FADDEEVA_CENTRE: f32 = 2.0f;
// Minus the zeta of the pole of the near fit.
const FADDEEVA_NEAR_POLE: f32 = 2.0f;
// Minus the zeta of the pole of the far fit.
const FADDEEVA_FAR_POLE: f32 = 3.0f;
// w at the centre.
const FADDEEVA_AT_CENTRE: f32 = 0.25539568f;
// L of the coarse tier.
const FADDEEVA_COARSE_POLE: f32 = 2.5f;
// (w - w(2i))/(zeta - 2) in (zeta - 2)/(zeta + 2); w within 1.0e-08.
const FADDEEVA_NEAR_A: f32 = -0.106796466f;
const FADDEEVA_NEAR_B: f32 = 0.16721098f;
const FADDEEVA_NEAR_C: f32 = -0.080159344f;
const FADDEEVA_NEAR_D: f32 = 0.020677371f;
const FADDEEVA_NEAR_E: f32 = 0.0008148871f;
const FADDEEVA_NEAR_F: f32 = -0.0019636583f;
const FADDEEVA_NEAR_G: f32 = -3.7765014e-05f;
const FADDEEVA_NEAR_H: f32 = 0.00025102615f;
const FADDEEVA_NEAR_I: f32 = 2.6974167e-05f;
const FADDEEVA_NEAR_J: f32 = -4.1503077e-05f;
const FADDEEVA_NEAR_K: f32 = -1.6607877e-05f;
const FADDEEVA_NEAR_L: f32 = 2.7369815e-06f;
const FADDEEVA_NEAR_M: f32 = 4.669254e-06f;
const FADDEEVA_NEAR_N: f32 = 1.8796283e-06f;
const FADDEEVA_NEAR_O: f32 = 3.2530315e-07f;
// (zeta + 3)^2 (sqrt(pi) zeta w - 1) in (zeta - 2)/(zeta + 3); w within 9.1e-08.
const FADDEEVA_FAR_A: f32 = -2.3661494f;
const FADDEEVA_FAR_B: f32 = 4.529406f;
const FADDEEVA_FAR_C: f32 = -5.0040684f;
const FADDEEVA_FAR_D: f32 = 3.61526f;
const FADDEEVA_FAR_E: f32 = -1.5806278f;
const FADDEEVA_FAR_F: f32 = 0.20925954f;
const FADDEEVA_FAR_G: f32 = 0.1795237f;
const FADDEEVA_FAR_H: f32 = -0.075746216f;
const FADDEEVA_FAR_I: f32 = -0.03169403f;
const FADDEEVA_FAR_J: f32 = 0.03326945f;
const FADDEEVA_FAR_K: f32 = -0.01147905f;
const FADDEEVA_FAR_L: f32 = 0.008491194f;
const FADDEEVA_FAR_M: f32 = -0.009628222f;
const FADDEEVA_FAR_N: f32 = 0.0053928373f;
const FADDEEVA_FAR_O: f32 = -0.0011878925f;
// w (L + zeta) in (L - zeta)/(L + zeta); w within 2.4e-05.
const FADDEEVA_COARSE_A: f32 = 1.0540318f;
const FADDEEVA_COARSE_B: f32 = 0.80465186f;
const FADDEEVA_COARSE_C: f32 = 0.4539141f;
const FADDEEVA_COARSE_D: f32 = 0.17125115f;
const FADDEEVA_COARSE_E: f32 = 0.028361548f;
const FADDEEVA_COARSE_F: f32 = -0.00839299f;
const FADDEEVA_COARSE_G: f32 = -0.004818751f;
const FADDEEVA_COARSE_H: f32 = 0.00043853337f;
const FADDEEVA_COARSE_I: f32 = 0.0006994823f;
const FADDEEVA_COARSE_J: f32 = -6.722101e-05f;
const FADDEEVA_COARSE_K: f32 = -0.00012964732f;

// ---- faddeeva ----
// The Faddeeva function w in f32, for the whole plane.

// From 2^60 on coordinates are scaled, so that their squares stay finite.
const FADDEEVA_SQUARE_LIMIT: f32 = 1152921504606846976.0f;
// 2^-66.
const FADDEEVA_SHRINK: f32 = 1.3552527e-20f;
// A larger number counts as infinite.
const INFINITE_LIMIT: f32 = 3.0e38f;
// 1/sqrt(pi).
const INVERSE_ROOT_PI: f32 = 0.5641896f;
// An exponent that leaves nothing.
const EXPONENT_LOWEST: f32 = -110.0f;
// An exponent whose power is beyond the range of f32, times 1e-30 too.
const EXPONENT_HIGHEST: f32 = 176.0f;
// Up to here squares are split on a common grid.
const GRID_UPPER_LIMIT: f32 = 512.0f;
// The finest grid is that of this number.
const GRID_LOWER_LIMIT: f32 = 0.0001f;

// A complex number.
struct Complex {
    // The real part.
    re: f32,
    // The imaginary part.
    im: f32,
}

// A power of e as a product that is formed last, so that a factor can come between.
struct PowerOfE {
    // A number near 1.
    mantissa: f32,
    // A power of two.
    first: f32,
    // Another one.
    second: f32,
}

// Returns e to the sum of a leading part from -110 to 176 and a small rest.
//
// The leading part may carry all its digits: it is reduced before the rest is added.
fn power_of_e(leading: f32, rest: f32) -> PowerOfE {
    let n = round((leading + rest) * LOG_TWO_E);
    let r = (leading - n * LN_TWO_HIGH) + (rest - n * LN_TWO_LOW);
    let e = EXPONENTIAL_A + r * (EXPONENTIAL_B + r * (EXPONENTIAL_C + r * (EXPONENTIAL_D + r *
        EXPONENTIAL_E)));
    let halved = round(n * 0.5f);
    return PowerOfE(1.0f + r * (1.0f + r * e), bitcast<f32>(bitcast<u32>(halved + EXPONENT_BIAS) <<
        23u), bitcast<f32>(bitcast<u32>((n - halved) + EXPONENT_BIAS) << 23u));
}

// Returns the twelve leading bits of x: the product of two such numbers is exact.
fn leading_bits(x: f32) -> f32 {
    return bitcast<f32>(bitcast<u32>(x) & 0xfffff000u);
}

// Returns x y/pi less the nearest integer, for x y in radians.
fn product_turns(x: f32, y: f32) -> f32 {
    let x_high = leading_bits(x);
    let y_high = leading_bits(y);
    let leading = min(max(x_high * y_high, -PHASE_LIMIT), PHASE_LIMIT);
    let rest = x_high * (y - y_high) + (x - x_high) * y;
    let bounded = min(max(rest, -PHASE_LIMIT), PHASE_LIMIT);
    let n = round(leading * INVERSE_PI);
    let turns = ((leading - n * PI_HIGH) - n * PI_LOW) * INVERSE_PI;
    let small = bounded * INVERSE_PI;
    let sum = turns + (small - round(small));
    return sum - round(sum);
}

// Returns the polynomial of the near or of the far fit at v, in the upper half plane.
fn faddeeva_polynomial(v: Complex, near: bool) -> Complex {
    let s = v.re + v.re;
    let t = v.re * v.re + v.im * v.im;
    let p_o = select(FADDEEVA_FAR_O, FADDEEVA_NEAR_O, near);
    let p_n = select(FADDEEVA_FAR_N, FADDEEVA_NEAR_N, near) + s * p_o;
    let p_m = (select(FADDEEVA_FAR_M, FADDEEVA_NEAR_M, near) - t * p_o) + s * p_n;
    let p_l = (select(FADDEEVA_FAR_L, FADDEEVA_NEAR_L, near) - t * p_n) + s * p_m;
    let p_k = (select(FADDEEVA_FAR_K, FADDEEVA_NEAR_K, near) - t * p_m) + s * p_l;
    let p_j = (select(FADDEEVA_FAR_J, FADDEEVA_NEAR_J, near) - t * p_l) + s * p_k;
    let p_i = (select(FADDEEVA_FAR_I, FADDEEVA_NEAR_I, near) - t * p_k) + s * p_j;
    let p_h = (select(FADDEEVA_FAR_H, FADDEEVA_NEAR_H, near) - t * p_j) + s * p_i;
    let p_g = (select(FADDEEVA_FAR_G, FADDEEVA_NEAR_G, near) - t * p_i) + s * p_h;
    let p_f = (select(FADDEEVA_FAR_F, FADDEEVA_NEAR_F, near) - t * p_h) + s * p_g;
    let p_e = (select(FADDEEVA_FAR_E, FADDEEVA_NEAR_E, near) - t * p_g) + s * p_f;
    let p_d = (select(FADDEEVA_FAR_D, FADDEEVA_NEAR_D, near) - t * p_f) + s * p_e;
    let p_c = (select(FADDEEVA_FAR_C, FADDEEVA_NEAR_C, near) - t * p_e) + s * p_d;
    let p_b = (select(FADDEEVA_FAR_B, FADDEEVA_NEAR_B, near) - t * p_d) + s * p_c;
    let re = (select(FADDEEVA_FAR_A, FADDEEVA_NEAR_A, near) - t * p_c) + v.re * p_b;
    let im = v.im * p_b;
    return Complex(re, im);
}

// Returns w(x + i y) for x >= 0 and y >= 0.
fn faddeeva_quadrant(x: f32, y: f32) -> Complex {
    let largest = max(x, y);
    let huge = largest > FADDEEVA_SQUARE_LIMIT;
    let scale = select(1.0f, FADDEEVA_SHRINK, huge);
    let xs = min(x, INFINITE_LIMIT) * scale;
    let ys = min(y, INFINITE_LIMIT) * scale;
    let square = xs * xs;
    let size = square + ys * ys;
    let near = size < select(FADDEEVA_BORDER, 0.0f, huge);
    let pole = select(FADDEEVA_FAR_POLE, FADDEEVA_NEAR_POLE, near);
    let across = ys + pole;
    let inverse = 1.0f / (across * across + square);
    let along = ys - FADDEEVA_CENTRE;
    let v = Complex((along * across + square) * inverse, -((pole + FADDEEVA_CENTRE) * (xs *
        inverse)));
    let p = faddeeva_polynomial(v, near);
    let near_re = FADDEEVA_AT_CENTRE + (along * p.re + xs * p.im);
    let near_im = along * p.im - xs * p.re;
    let inverse_square = inverse * inverse;
    let q_square = ((across - xs) * (across + xs)) * inverse_square;
    let q_twice = ((across + across) * xs) * inverse_square;
    let f_re = select(q_square * p.re - q_twice * p.im, 0.0f, huge);
    let f_im = select(q_square * p.im + q_twice * p.re, 0.0f, huge);
    let shrink = INVERSE_ROOT_PI / size;
    let far_re = (ys + (ys * f_re - xs * f_im)) * shrink;
    let far_im = (xs + (xs * f_re + ys * f_im)) * shrink;
    let unscale = select(scale, 0.0f, largest > INFINITE_LIMIT);
    return Complex(select(far_re, near_re, near) * unscale, select(far_im, near_im, near) *
        unscale);
}

// Returns 2 exp(-z^2) at z = x - i y for x >= 0 and y > 0.
fn faddeeva_gaussian(x: f32, y: f32) -> Complex {
    let halved = (y - x) * (0.5f * y + 0.5f * x);
    let rough = halved + halved;
    let largest = max(x, y);
    let bits = bitcast<u32>(max(min(largest, GRID_UPPER_LIMIT), GRID_LOWER_LIMIT)) & 0x7f800000u;
    let grid = bitcast<f32>(bits) * 0.00048828125f;
    let inverse_grid = bitcast<f32>(bits ^ 0x7f800000u) * 1024.0f;
    let x_high = round(x * inverse_grid) * grid;
    let y_high = round(y * inverse_grid) * grid;
    let exact = y_high * y_high - x_high * x_high;
    let small = (y - y_high) * (y + y_high) - (x - x_high) * (x + x_high);
    let plain = largest > GRID_UPPER_LIMIT || abs(rough) > 104.0f;
    let bounded = min(max(rough, EXPONENT_LOWEST), EXPONENT_HIGHEST);
    let power = power_of_e(select(exact, bounded, plain), select(small, 0.0f, plain));
    let nothing = x == 0.0f || rough < EXPONENT_LOWEST;
    let phase = sine_cosine_turns(select(product_turns(x, y) + 0.0f * y, 0.0f, nothing));
    let re = (power.mantissa * phase.cosine) * power.first;
    let im = (power.mantissa * phase.sine) * power.first;
    return Complex((re + re) * power.second, (im + im) * power.second);
}

// Returns w(re + i im) from its value at |re| + i |im|, by w(z) = 2 exp(-z^2) - w(-z) below the
// real axis.
fn faddeeva_in_plane(re: f32, im: f32, above: Complex) -> Complex {
    var w_re = above.re;
    var w_im = above.im;
    if im < 0.0f {
        let gaussian = faddeeva_gaussian(abs(re), abs(im));
        w_re = gaussian.re - above.re;
        w_im = gaussian.im + above.im;
    }
    return Complex(w_re, odd_continuation(re, w_im));
}

// Returns w(z) = exp(-z^2) erfc(-i z) at z = re + i im, to f32 grade in the upper half plane.
//
// The error counts against |w(z)| above the real axis and on it, and against |2 exp(-z^2)| +
// |w(-z)| below, where
// exponent and phase keep their digits for |z| to 100. w(-conj z) = conj w(z) holds exactly. An
// infinite z gives 0 in
// the upper half plane and on horizontal lines below it; straight down w tends to infinity.
fn faddeeva_w(re: f32, im: f32) -> Complex {
    return faddeeva_in_plane(re, im, faddeeva_quadrant(abs(re), abs(im)));
}

// Returns the polynomial of the coarse tier at v.
fn faddeeva_polynomial_coarse(v: Complex) -> Complex {
    let s = v.re + v.re;
    let t = v.re * v.re + v.im * v.im;
    let p_k = FADDEEVA_COARSE_K;
    let p_j = FADDEEVA_COARSE_J + s * p_k;
    let p_i = (FADDEEVA_COARSE_I - t * p_k) + s * p_j;
    let p_h = (FADDEEVA_COARSE_H - t * p_j) + s * p_i;
    let p_g = (FADDEEVA_COARSE_G - t * p_i) + s * p_h;
    let p_f = (FADDEEVA_COARSE_F - t * p_h) + s * p_g;
    let p_e = (FADDEEVA_COARSE_E - t * p_g) + s * p_f;
    let p_d = (FADDEEVA_COARSE_D - t * p_f) + s * p_e;
    let p_c = (FADDEEVA_COARSE_C - t * p_e) + s * p_d;
    let p_b = (FADDEEVA_COARSE_B - t * p_d) + s * p_c;
    let re = (FADDEEVA_COARSE_A - t * p_c) + v.re * p_b;
    let im = v.im * p_b;
    return Complex(re, im);
}

// Returns w(x + i y) for x >= 0 and y >= 0, to 5e-5.
fn faddeeva_quadrant_coarse(x: f32, y: f32) -> Complex {
    let largest = max(x, y);
    let huge = largest > FADDEEVA_SQUARE_LIMIT;
    let scale = select(1.0f, FADDEEVA_SHRINK, huge);
    let xs = min(x, INFINITE_LIMIT) * scale;
    let across = min(y, INFINITE_LIMIT) * scale + select(FADDEEVA_COARSE_POLE, 0.0f, huge);
    let inverse = 1.0f / (across * across + xs * xs);
    let q_re = across * inverse;
    let q_im = xs * inverse;
    let double_pole = select(FADDEEVA_COARSE_POLE + FADDEEVA_COARSE_POLE, 0.0f, huge);
    let v = Complex(double_pole * q_re - 1.0f, double_pole * q_im);
    let p = faddeeva_polynomial_coarse(v);
    let unscale = select(scale, 0.0f, largest > INFINITE_LIMIT);
    return Complex((q_re * p.re - q_im * p.im) * unscale, (q_re * p.im + q_im * p.re) * unscale);
}

// Returns w(z) of [`faddeeva_w`] to 5e-5.
fn faddeeva_w_coarse(re: f32, im: f32) -> Complex {
    return faddeeva_in_plane(re, im, faddeeva_quadrant_coarse(abs(re), abs(im)));
}

// ---- erf_difference ----
// The difference of two complex error functions on a horizontal line, scaled, in f32.
// Sources named: VWH18 Eq. 5.

// Nothing is left of exp(-a^2) from here on.
const ERF_END_LARGEST: f32 = 12.0f;
// Half lengths up to this are short, if the next bound holds too.
const ERF_SHORT: f32 = 0.5f;
// Largest square of the half length times the distance of the middle from 0, of short segments.
const ERF_SHORT_SQUARE: f32 = 0.0625f;
// 2/sqrt(pi).
const TWO_INVERSE_ROOT_PI: f32 = 1.1283792f;

// Returns exp(-a^2 - rest) for a from 0 to 12, or what is left of it.
fn erf_gaussian(a: f32, rest: f32) -> f32 {
    let high = leading_bits(a);
    let square = high * high;
    let low = (a - high) * (a + high) + rest;
    let power = power_of_e(max(-square, EXPONENT_LOWEST), select(-low, 0.0f, square >
        -EXPONENT_LOWEST));
    return (power.mantissa * power.first) * power.second;
}

// Returns P(a), for a >= 0, and its conjugate continuation for a < 0.
fn erf_end(a: f32, b: f32, turns: f32) -> Complex {
    let size = abs(a);
    let height = abs(b);
    let nothing = size > ERF_END_LARGEST || height > INFINITE_LIMIT;
    let phase = sine_cosine_turns(select(turns, 0.0f, nothing));
    let gaussian = erf_gaussian(min(size, ERF_END_LARGEST), 0.0f);
    let w = faddeeva_quadrant(height, size);
    let im = select(-w.im, w.im, (a < 0.0f) != (b < 0.0f));
    return Complex(gaussian * (w.re * phase.cosine + im * phase.sine), gaussian * (im * phase.cosine
        - w.re * phase.sine));
}

// Returns the integral of exp(-s^2 - 2 (m + i b) s) over |s| <= d as a multiple of 2 d, for short
// segments.
//
// The Taylor series in q = (m + i b)^2 d^2 and d^2.
fn erf_short_series(middle: f32, b: f32, halved: f32) -> Complex {
    let d = halved * halved;
    let across = halved * middle;
    let along = halved * b;
    let q_re = (across - along) * (across + along);
    let q_im = (across + across) * along;
    let k = 1.0f + d * (-0.33333334f + d * (0.1f + d * (-0.023809524f + d * (0.0046296297f - d *
        0.00075757576f))));
    let l = 0.6666667f + d * (-0.4f + d * (0.14285715f + d * (-0.037037037f + d * 0.007575758f)));
    let m = 0.13333334f + d * (-0.0952381f + d * 0.037037037f);
    let n = 0.012698413f - d * 0.009876543f;
    let first_re = m + q_re * n;
    let first_im = q_im * n;
    let second_re = l + (q_re * first_re - q_im * first_im);
    let second_im = q_re * first_im + q_im * first_re;
    return Complex(k + (q_re * second_re - q_im * second_im), q_re * second_im + q_im * second_re);
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
fn erf_difference_scaled_turns(a_from: f32, a_to: f32, b: f32, turns_from: f32, turns_to: f32) ->
    Complex {
    let extent = a_to - a_from;
    let halved = 0.5f * extent;
    let nearer_to = abs(a_to) < abs(a_from);
    let base = select(a_from, a_to, nearer_to);
    let stride = select(halved, -halved, nearer_to);
    let middle = base + stride;
    let across = halved * middle;
    let along = halved * b;
    let is_short = abs(halved) <= ERF_SHORT && across * across + along * along <= ERF_SHORT_SQUARE;
    let apart = select(turns_to - turns_from, turns_from - turns_to, nearer_to);
    let turns = select(turns_from, turns_to, nearer_to) + 0.5f * (apart - round(apart));
    let phase = sine_cosine_turns(turns);
    let rest = stride * ((base + base) + stride);
    let scale = (TWO_INVERSE_ROOT_PI * extent) * erf_gaussian(min(abs(base), ERF_END_LARGEST),
        rest);
    let series = erf_short_series(middle, b, halved);
    let short_re = scale * (series.re * phase.cosine + series.im * phase.sine);
    let short_im = scale * (series.im * phase.cosine - series.re * phase.sine);
    let first = erf_end(a_from, b, turns_from);
    let last = erf_end(a_to, b, turns_to);
    let side_from = select(1.0f, -1.0f, a_from < 0.0f);
    let side_to = select(1.0f, -1.0f, a_to < 0.0f);
    let between = (side_to - side_from) * erf_gaussian(min(abs(b), ERF_END_LARGEST), 0.0f);
    let long_re = between + (side_from * first.re - side_to * last.re);
    let long_im = side_from * first.im - side_to * last.im;
    let is_empty = a_from == a_to && abs(b) >= 0.0f;
    return Complex(select(select(long_re, short_re, is_short), 0.0f, is_empty),
        select(select(long_im, short_im, is_short), 0.0f, is_empty));
}

// Returns exp(-b^2) (erf(`a_to` + i b) - erf(`a_from` + i b)), the three dimensionless.
//
// As [`erf_difference_scaled_turns`], with the phases formed from exact partial products: they hold
// to 1e-6 for |a b| to
// 1e4, and lose digits in proportion beyond.
fn erf_difference_scaled(a_from: f32, a_to: f32, b: f32) -> Complex {
    return erf_difference_scaled_turns(a_from, a_to, b, product_turns(a_from, b),
        product_turns(a_to, b));
}

// ---- turns ----
// Phases as ratios of lengths: a b/c in turns, whole turns apart, in f32.

// Up to this many turns a sinc is 1 in f32.
const SINC_TURNS_LIMIT: f32 = 0.00001f;

// A number of turns in two parts, whose sum it is.
struct Turns {
    // Whole turns.
    whole: f32,
    // What is left of them, half a turn at most but for rounding.
    rest: f32,
}

// Returns a b/c in turns.
//
// The partial products are exact for |a b/c| to 4096; beyond, the error of the rest grows as 2^-35
// |a b/c|.
fn ratio_turns(a: f32, b: f32, c: f32) -> Turns {
    let whole = round(a * b / c);
    let a_high = leading_bits(a);
    let b_high = leading_bits(b);
    let c_high = leading_bits(c);
    let whole_high = leading_bits(whole);
    let leading = min(max(a_high * b_high - whole_high * c_high, -PHASE_LIMIT), PHASE_LIMIT);
    let given = a_high * (b - b_high) + (a - a_high) * b;
    let taken = whole_high * (c - c_high) + (whole - whole_high) * c;
    return Turns(whole, (leading + (given - taken)) / c);
}

// Returns sin(2 pi t)/(2 pi t) from t and from its sine.
fn sinc_turns(turns: Turns, sine: f32) -> f32 {
    let total = turns.whole + turns.rest;
    return select(sine / (TWO_PI * total), 1.0f, abs(total) < SINC_TURNS_LIMIT);
}

// ---- profile ----
// Profiles across a scratch in f32: the transforms of rectangle and triangle, and the depth term.
// Sources named: VWH18 Eq. 3, WVJH17 Eq. 20, WVJH17 Eq. 29, WVJH17 Eqs. 9.

// Half phases of depth and width, in turns and together, up to which a triangle is shallow: phases
// of 1.75 radians.
const TRIANGLE_SHALLOW_LIMIT: f32 = 0.13926058f;

// Returns W sinc(pi W xi/lambda), in the unit of the width (VWH18 Eq. 3).
fn width_term(width: f32, xi_b: f32, wavelength: f32) -> f32 {
    let halves = ratio_turns(width, xi_b, wavelength + wavelength);
    return width * sinc_turns(halves, sine_cosine_turns(halves.rest).sine);
}

// Returns the sine and cosine of half the phase of the depth, pi gamma D/lambda; both may have the
// other sign.
fn depth_half_phase(depth: f32, gamma_sum: f32, wavelength: f32) -> SineCosine {
    return sine_cosine_turns(0.5f * ratio_turns(depth, gamma_sum, wavelength).rest);
}

// Returns 1 - exp(2 pi i (gamma_i + gamma_o) D/lambda), dimensionless (WVJH17 Eq. 20).
fn depth_term(depth: f32, gamma_sum: f32, wavelength: f32) -> Complex {
    let phase = depth_half_phase(depth, gamma_sum, wavelength);
    let twice = phase.sine + phase.sine;
    return Complex(twice * phase.sine, -(twice * phase.cosine));
}

// Returns |1 - exp(2 pi i (gamma_i + gamma_o) D/lambda)|^2, from 0 to 4.
fn depth_term_squared(depth: f32, gamma_sum: f32, wavelength: f32) -> f32 {
    let phase = depth_half_phase(depth, gamma_sum, wavelength);
    let twice = phase.sine + phase.sine;
    return twice * twice;
}

// Returns W sinc(pi W xi/lambda) (1 - exp(2 pi i (gamma_i + gamma_o) D/lambda)), in the unit of the
// width: mask less
// scratch of a rectangle (VWH18 Eq. 3).
fn profile_rectangle(width: f32, depth: f32, xi_b: f32, gamma_sum: f32, wavelength: f32) -> Complex
    {
    let across = width_term(width, xi_b, wavelength);
    let deep = depth_term(depth, gamma_sum, wavelength);
    return Complex(across * deep.re, across * deep.im);
}

// The two sinc of a triangle, at the half sum a and the half difference b of the phases of depth
// and width.
struct TriangleFlanks {
    // sinc a, times half the width.
    sinc_a: f32,
    // sinc b, times half the width.
    sinc_b: f32,
    // Sine and cosine of a.
    a: SineCosine,
    // Sine and cosine of b.
    b: SineCosine,
    // Half the phase of the depth, (a + b)/2, in turns.
    deep: f32,
    // Half the phase of the width, (a - b)/2, in turns.
    across: f32,
}

// Returns the two sinc of a triangle.
fn triangle_flanks(width: f32, depth: f32, xi_b: f32, gamma_sum: f32, wavelength: f32) ->
    TriangleFlanks {
    let twice = wavelength + wavelength;
    let deep = ratio_turns(depth, gamma_sum, twice);
    let across = ratio_turns(width, xi_b, twice + twice);
    let sum = Turns(deep.whole + across.whole, deep.rest + across.rest);
    let difference = Turns(deep.whole - across.whole, deep.rest - across.rest);
    let a = sine_cosine_turns(sum.rest);
    let b = sine_cosine_turns(difference.rest);
    let halved = 0.5f * width;
    return TriangleFlanks(halved * sinc_turns(sum, a.sine), halved * sinc_turns(difference, b.sine),
        a, b, deep.whole + deep.rest, across.whole + across.rest);
}

// Returns the transform of a triangular groove alone, without its mask, in the unit of the width
// (WVJH17 Eq. 29).
//
// Two sinc, each the other's phase: no poles.
fn profile_triangle(width: f32, depth: f32, xi_b: f32, gamma_sum: f32, wavelength: f32) -> Complex {
    let flanks = triangle_flanks(width, depth, xi_b, gamma_sum, wavelength);
    return Complex(flanks.sinc_a * flanks.b.cosine + flanks.sinc_b * flanks.a.cosine, flanks.sinc_a
        * flanks.b.sine + flanks.sinc_b * flanks.a.sine);
}

// Returns (1 - exp(i p (1 - u))) cos(w u) at one u, for half phases p/2 and w/2.
fn triangle_shallow_node(deep: f32, across: f32, u: f32) -> Complex {
    let phase = sine_cosine_near(deep * (1.0f - u));
    let height = 2.0f * (phase.sine * sine_cosine_near((across + across) * u).cosine);
    return Complex(height * phase.sine, -(height * phase.cosine));
}

// Returns the response of a triangular groove, mask less scratch, in the unit of the width (WVJH17
// Eqs. 9 and 29).
//
// The difference of mask and [`profile_triangle`] in a deep groove, its own two sinc in a wide one,
// and a Gauss rule of
// four points where both phases are small: a shallow groove keeps its digits.
fn response_triangle(width: f32, depth: f32, xi_b: f32, gamma_sum: f32, wavelength: f32) -> Complex
    {
    let flanks = triangle_flanks(width, depth, xi_b, gamma_sum, wavelength);
    let mask = width_term(width, xi_b, wavelength);
    let slope = flanks.deep / flanks.across;
    let is_wide = abs(flanks.deep) <= abs(flanks.across);
    let a_re = flanks.sinc_a * flanks.b.cosine;
    let a_im = flanks.sinc_a * flanks.b.sine;
    let b_re = flanks.sinc_b * flanks.a.cosine;
    let b_im = flanks.sinc_b * flanks.a.sine;
    let re = select(mask - (a_re + b_re), slope * (a_re - b_re), is_wide);
    let im = select(-(a_im + b_im), slope * (a_im - b_im), is_wide);
    let deep = min(max(TWO_PI * flanks.deep, -0.875f), 0.875f);
    let across = min(max(TWO_PI * flanks.across, -0.875f), 0.875f);
    let is_shallow = abs(flanks.deep) + abs(flanks.across) <= TRIANGLE_SHALLOW_LIMIT;
    let n = triangle_shallow_node(deep, across, 0.06943184f);
    let o = triangle_shallow_node(deep, across, 0.33000946f);
    let p = triangle_shallow_node(deep, across, 0.66999054f);
    let q = triangle_shallow_node(deep, across, 0.93056816f);
    let outer_re = 0.17392743f * (n.re + q.re);
    let outer_im = 0.17392743f * (n.im + q.im);
    let inner_re = 0.32607257f * (o.re + p.re);
    let inner_im = 0.32607257f * (o.im + p.im);
    return Complex(select(re, width * (outer_re + inner_re), is_shallow), select(im, width *
        (outer_im + inner_im), is_shallow));
}

// ---- spatial_phase ----
// The spatial phase eta of a scratch, the coherence window and the base response, in f32.
// Sources named: VWH18 Eq. 17, VWH18 Eq. 5, VWH18 Eq. 8, VWH18 Eq. 9, WVJH17 Eq. 13, WVJH17 Eq. 16.

// 1/sqrt(2).
const INVERSE_ROOT_TWO: f32 = 0.70710677f;
// sqrt(2) pi.
const ROOT_TWO_TIMES_PI: f32 = 4.442883f;
// 1/sqrt(2 pi).
const INVERSE_ROOT_TWO_PI: f32 = 0.3989423f;
// sqrt(pi/2).
const ROOT_HALF_PI: f32 = 1.2533141f;
// sqrt(2 pi).
const ROOT_TWO_PI: f32 = 2.5066283f;

// Returns a place over a radius, 0 of 0.
fn in_radii(place: f32, radius: f32) -> f32 {
    return select(place / radius, place, place == 0.0f);
}

// Returns exp(-r^2/(2 sigma^2)), the coherence window at a distance (WVJH17 Eq. 13).
fn coherence_window(offset: f32, radius: f32) -> f32 {
    let r = in_radii(offset, radius);
    return exponential(-0.5f * (r * r));
}

// Returns the share of the window's amplitude on one infinite scratch at a distance: 1 for a full
// coverage (VWH18 Eq. 17,
// normalised). [`area_density`](super::area_density) is the share of its energy.
fn area_density_amplitude(width: f32, offset: f32, radius: f32) -> f32 {
    let r = offset / radius;
    return (INVERSE_ROOT_TWO_PI * (width / radius)) * exponential(-0.5f * (r * r));
}

// Returns sigma k xi, the direction cosine in widths of the transformed window.
fn window_cosine(radius: f32, wavelength: f32, xi: f32) -> f32 {
    return (TWO_PI * radius) * (xi / wavelength);
}

// Returns a modulus times exp(-2 pi i a b/c), 0 where the modulus is 0.
fn turned_back(modulus: f32, a: f32, b: f32, c: f32) -> Complex {
    let phase = sine_cosine_turns(select(ratio_turns(a, b, c).rest, 0.0f, modulus == 0.0f));
    return Complex(modulus * phase.cosine, -(modulus * phase.sine));
}

// Returns eta of a finite scratch, in the unit of the lengths (VWH18 Eq. 5).
//
// `radius` is sigma, `s_t` and `s_b` the scratch's origin along and across it from the shaded
// point, `l_from` and `l_to`
// its ends from the origin, infinite ones allowed; `xi_t` and `xi_b` the scattering vector along
// and across.
fn spatial_phase(radius: f32, wavelength: f32, xi_t: f32, xi_b: f32, s_t: f32, s_b: f32, l_from:
    f32, l_to: f32) -> Complex {
    let height = (ROOT_TWO_TIMES_PI * radius) * (xi_t / wavelength);
    let origin = ratio_turns(s_t, xi_t, wavelength).rest;
    let along = erf_difference_scaled_turns(INVERSE_ROOT_TWO * in_radii(s_t + l_from, radius),
        INVERSE_ROOT_TWO * in_radii(s_t + l_to, radius), height, origin + ratio_turns(l_from, xi_t,
        wavelength).rest, origin + ratio_turns(l_to, xi_t, wavelength).rest);
    let across = turned_back((ROOT_HALF_PI * radius) * coherence_window(s_b, radius), s_b, xi_b,
        wavelength);
    return Complex(along.re * across.re - along.im * across.im, along.re * across.im + along.im *
        across.re);
}

// Returns eta of an infinite scratch at the distance `s_b` (VWH18 Eq. 8).
fn spatial_phase_infinite(radius: f32, wavelength: f32, xi_t: f32, xi_b: f32, s_b: f32) -> Complex {
    let r = in_radii(s_b, radius);
    let q = window_cosine(radius, wavelength, xi_t);
    let modulus = (ROOT_TWO_PI * radius) * exponential(-0.5f * (r * r + q * q));
    return turned_back(modulus, s_b, xi_b, wavelength);
}

// Returns |eta|^2 of an infinite scratch at the distance `s_b` (VWH18 Eq. 9).
fn spatial_phase_infinite_squared(radius: f32, wavelength: f32, xi_t: f32, s_b: f32) -> f32 {
    let r = in_radii(s_b, radius);
    let q = window_cosine(radius, wavelength, xi_t);
    return ((TWO_PI * radius) * radius) * exponential(-(r * r + q * q));
}

// Returns 2 pi sigma^2 exp(-(sigma k |xi|)^2/2), the transform of the window (WVJH17 Eq. 16).
fn base_response(radius: f32, wavelength: f32, xi_t: f32, xi_b: f32) -> f32 {
    let along = window_cosine(radius, wavelength, xi_t);
    let across = window_cosine(radius, wavelength, xi_b);
    return ((TWO_PI * radius) * radius) * exponential(-0.5f * (along * along + across * across));
}

// ---- reflectance ----
// From the responses of scratches to a reflectance, in f32: coherent, incoherent, blended with the
// base.
// Sources named: VWH18 Eqs. 6, VWH18 Eq. 1, VWH18 Eqs. 9.


// Returns the share of the window's energy on one infinite scratch at a distance: 1 for a full
// coverage.
fn area_density(width: f32, offset: f32, radius: f32) -> f32 {
    let r = offset / radius;
    return (INVERSE_ROOT_PI * (width / radius)) * exponential(-(r * r));
}

// Returns 1 - rho, the factor of the scratches' incoherent reflectance; a density above 1 counts as
// 1.
fn energy_blend_scratches(density: f32) -> f32 {
    return select(1.0f - density, 0.0f, density > 1.0f);
}

// Returns rho (1 - rho) times the squared depth term, the energy that scratches of an area density
// rho scatter: no factor.
//
// A density above 1 counts as 1.
fn energy_blend_scattered(density: f32, depth_squared: f32) -> f32 {
    return (density * energy_blend_scratches(density)) * depth_squared;
}

// Returns 1 - rho (1 - rho) times the squared depth term of the mirror direction, the factor of the
// base's reflectance.
fn energy_blend_base(density: f32, depth_squared: f32) -> f32 {
    return 1.0f - energy_blend_scattered(density, depth_squared);
}

// Returns the sum of |S|^2 over A_C lambda^2, in 1/sr (VWH18 Eqs. 6 and 7).
fn reflectance_incoherent(radius: f32, wavelength: f32, squared_sum: f32) -> f32 {
    let size = radius * wavelength;
    return squared_sum / (ARC_PI * (size * size));
}

// Returns |B - S|^2/(A_C lambda^2), in 1/sr (VWH18 Eq. 1; Fresnel factor apart).
fn reflectance_coherent(radius: f32, wavelength: f32, base: f32, scratches_re: f32, scratches_im:
    f32) -> f32 {
    let re = base - scratches_re;
    return reflectance_incoherent(radius, wavelength, re * re + scratches_im * scratches_im);
}

// Returns the mean |S|^2 of an infinite rectangular scratch over a footprint, in the fourth power
// of the lengths' unit.
//
// `mean` is that of the footprint, `footprint_mean`, or exp(-s_b^2/sigma^2) at a point (VWH18 Eqs.
// 9 and 16).
fn scratch_squared(radius: f32, wavelength: f32, width: f32, depth: f32, xi_t: f32, xi_b: f32,
    gamma_sum: f32, mean: f32) -> f32 {
    let across = width_term(width, xi_b, wavelength);
    let deep = depth_term_squared(depth, gamma_sum, wavelength);
    let q = window_cosine(radius, wavelength, xi_t);
    let along = ((TWO_PI * radius) * radius) * exponential(-(q * q));
    return ((across * across) * deep) * (along * mean);
}

// ---- interference ----
// What the sum of squares leaves out, in f32: the interference of scratches with the base, and
// their crossings.
// Sources named: VWH18 Eq. 6, WVJH17 4.2.


// Returns -2 Re(B S), the interference of base and scratches: |B - S|^2 less |B|^2 + |S|^2 (VWH18
// Eq. 6, corrected).
//
// `base` is B, which is real in the frame of the shaded point, `scratches_re` the real part of the
// sum of all S.
fn base_interference(base: f32, scratches_re: f32) -> f32 {
    return -2.0f * (base * scratches_re);
}

// Returns a product of two complex numbers.
fn complex_product(a: Complex, b: Complex) -> Complex {
    return Complex(a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re);
}

// Returns what two crossing rectangular scratches lack in B - S1 - S2, in the square of the
// lengths' unit: the product of
// the depth terms times the transform of the overlap. No paper has it; WVJH17 4.2 neglects it.
//
// Width, depth and unit tangent of the two scratches, the place where their centre lines meet
// relative to the shaded
// point, and the scattering vector, all in the same axes of the surface. No result for parallel
// scratches.
fn crossing_response(radius: f32, wavelength: f32, first_width: f32, first_depth: f32, second_width:
    f32, second_depth: f32, first_x: f32, first_y: f32, second_x: f32, second_y: f32, crossing_x:
    f32, crossing_y: f32, xi_x: f32, xi_y: f32, gamma_sum: f32) -> Complex {
    let sine = first_x * second_y - first_y * second_x;
    let p = (xi_x * second_x + xi_y * second_y) / sine;
    let q = -(xi_x * first_x + xi_y * first_y) / sine;
    let overlap = width_term(first_width, p, wavelength) * (width_term(second_width, q, wavelength)
        / abs(sine));
    let x = in_radii(crossing_x, radius);
    let y = in_radii(crossing_y, radius);
    let window = exponential(-0.5f * (x * x + y * y));
    let along = turned_back(overlap * window, crossing_x, xi_x, wavelength);
    let across = turned_back(1.0f, crossing_y, xi_y, wavelength);
    let deep = complex_product(depth_term(first_depth, gamma_sum, wavelength),
        depth_term(second_depth, gamma_sum, wavelength));
    return complex_product(deep, complex_product(along, across));
}

// ---- footprint_coefficients ----
// Nodes and coefficients of the f32 mean over a footprint; the letters of nodes count from the near
// end.

// sin^2 of half the angle of a node; that of its mirror is 1 minus it.
const FOOTPRINT_NODE_A: f32 = 0.0019026509f;
// The sine of the angle.
const FOOTPRINT_NODE_SINE_A: f32 = 0.087155744f;
// sin^2 of half the angle of a node; that of its mirror is 1 minus it.
const FOOTPRINT_NODE_B: f32 = 0.017037086f;
// The sine of the angle.
const FOOTPRINT_NODE_SINE_B: f32 = 0.25881904f;
// sin^2 of half the angle of a node; that of its mirror is 1 minus it.
const FOOTPRINT_NODE_C: f32 = 0.046846107f;
// The sine of the angle.
const FOOTPRINT_NODE_SINE_C: f32 = 0.42261827f;
// sin^2 of half the angle of a node; that of its mirror is 1 minus it.
const FOOTPRINT_NODE_D: f32 = 0.09042398f;
// The sine of the angle.
const FOOTPRINT_NODE_SINE_D: f32 = 0.57357645f;
// sin^2 of half the angle of a node; that of its mirror is 1 minus it.
const FOOTPRINT_NODE_E: f32 = 0.14644662f;
// The sine of the angle.
const FOOTPRINT_NODE_SINE_E: f32 = 0.70710677f;
// sin^2 of half the angle of a node; that of its mirror is 1 minus it.
const FOOTPRINT_NODE_F: f32 = 0.21321177f;
// The sine of the angle.
const FOOTPRINT_NODE_SINE_F: f32 = 0.81915206f;
// sin^2 of half the angle of a node; that of its mirror is 1 minus it.
const FOOTPRINT_NODE_G: f32 = 0.28869087f;
// The sine of the angle.
const FOOTPRINT_NODE_SINE_G: f32 = 0.9063078f;
// sin^2 of half the angle of a node; that of its mirror is 1 minus it.
const FOOTPRINT_NODE_H: f32 = 0.37059048f;
// The sine of the angle.
const FOOTPRINT_NODE_SINE_H: f32 = 0.9659258f;
// sin^2 of half the angle of a node; that of its mirror is 1 minus it.
const FOOTPRINT_NODE_I: f32 = 0.45642212f;
// The sine of the angle.
const FOOTPRINT_NODE_SINE_I: f32 = 0.9961947f;
// (2^r - 1)/r in powers of r, to 3.2e-7.
const HALVING_A: f32 = 0.6931472f;
const HALVING_B: f32 = 0.2402235f;
const HALVING_C: f32 = 0.05550381f;
const HALVING_D: f32 = 0.009666368f;
const HALVING_E: f32 = 0.0013381302f;
// Exponent for H < 3, v^2, v^4, v^6 times powers 0 to 5 of w, to 0.00028 of M(H, 0).
const FOOTPRINT_NARROW_A: f32 = 0.13825849f;
const FOOTPRINT_NARROW_B: f32 = -0.25333163f;
const FOOTPRINT_NARROW_C: f32 = -0.00026723035f;
const FOOTPRINT_NARROW_D: f32 = 0.01970528f;
const FOOTPRINT_NARROW_E: f32 = -0.0026913143f;
const FOOTPRINT_NARROW_F: f32 = 0.00012525705f;
const FOOTPRINT_NARROW_G: f32 = 0.26582924f;
const FOOTPRINT_NARROW_H: f32 = -1.1349578f;
const FOOTPRINT_NARROW_I: f32 = 0.7839661f;
const FOOTPRINT_NARROW_J: f32 = -0.20106f;
const FOOTPRINT_NARROW_K: f32 = 0.022316214f;
const FOOTPRINT_NARROW_L: f32 = -0.00094284577f;
const FOOTPRINT_NARROW_M: f32 = -0.18790737f;
const FOOTPRINT_NARROW_N: f32 = 1.1706403f;
const FOOTPRINT_NARROW_O: f32 = -1.039597f;
const FOOTPRINT_NARROW_P: f32 = 0.30889568f;
const FOOTPRINT_NARROW_Q: f32 = -0.03554422f;
const FOOTPRINT_NARROW_R: f32 = 0.0015310182f;
// Exponent beside the edge in powers of d, and its slope in 1/e, to 0.00057 of M(H, 0).
const FOOTPRINT_EDGE_A: f32 = 0.94492203f;
const FOOTPRINT_EDGE_B: f32 = -1.4870366f;
const FOOTPRINT_EDGE_C: f32 = 0.60066104f;
const FOOTPRINT_EDGE_D: f32 = -0.10374308f;
const FOOTPRINT_EDGE_E: f32 = -0.004889445f;
const FOOTPRINT_EDGE_F: f32 = 0.00267118f;
const FOOTPRINT_EDGE_SLOPE_A: f32 = 0.36916718f;
const FOOTPRINT_EDGE_SLOPE_B: f32 = -0.24061514f;
const FOOTPRINT_EDGE_SLOPE_C: f32 = 0.049636792f;

// ---- footprint ----
// The mean of the window's square over the footprint of a pixel, in f32.

// Half widths below are next to none.
const FOOTPRINT_LEAST_LIMIT: f32 = 0.00048828125f;
// Half widths above see nothing.
const FOOTPRINT_MOST_LIMIT: f32 = 1e18f;
// Where the window ends, in radii.
const FOOTPRINT_REACH: f32 = 3.95f;
// 1 over the nodes.
const FOOTPRINT_SHARE: f32 = 0.055555556f;
// sqrt(log2 e): squares of lengths in this unit are powers of 2.
const FOOTPRINT_BINARY: f32 = 1.2011224f;
// Half widths from here on see one edge at a time.
const FOOTPRINT_WIDE_LIMIT: f32 = 3.0f;
// So far inside the edge the window does not see it.
const FOOTPRINT_INTERIOR_LIMIT: f32 = 2.5f;
// Farther outside the edge the coarse form is 0.
const FOOTPRINT_OUTSIDE_LIMIT: f32 = -3.0f;

// The part of the ellipse that the window reaches.
struct FootprintWindow {
    // From the near edge of the ellipse, over H.
    near: f32,
    // From the far edge of the ellipse, over H.
    far: f32,
    // The beginning, from the line, in units of [`FOOTPRINT_BINARY`].
    start: f32,
    // The length, in the same unit.
    span: f32,
    // The length over H.
    share: f32,
}

// Returns the part of the ellipse within reach of the line.
fn footprint_window(half_width: f32, edge: f32) -> FootprintWindow {
    let width = min(max(half_width, FOOTPRINT_LEAST_LIMIT), FOOTPRINT_MOST_LIMIT);
    let near_edge = edge + (width - half_width);
    let far_edge = (width - near_edge) + width;
    let inverse = 1.0f / width;
    let start = max(-near_edge, -FOOTPRINT_REACH);
    let whole = max(near_edge, far_edge) <= FOOTPRINT_REACH;
    let seen = max(min(far_edge, FOOTPRINT_REACH) - start, 0.0f);
    let span = select(seen, width + width, whole);
    return FootprintWindow(max(near_edge - FOOTPRINT_REACH, 0.0f) * inverse, max(far_edge -
        FOOTPRINT_REACH, 0.0f) * inverse, FOOTPRINT_BINARY * start, FOOTPRINT_BINARY * span, span *
        inverse);
}

// Returns 2^(-x^2), to f32 grade of 1, for |x| up to 11.
fn halving_square(x: f32) -> f32 {
    let y = x * x;
    let n = round(y);
    let r = n - y;
    let series = HALVING_A + r * (HALVING_B + r * (HALVING_C + r * (HALVING_D + r * HALVING_E)));
    return (1.0f + r * series) * bitcast<f32>(bitcast<u32>(EXPONENT_BIAS - n) << 23u);
}

// Returns two nodes of the rule, mirror images within the window.
fn footprint_pair(window: FootprintWindow, part: f32, sine: f32) -> f32 {
    let rest = 1.0f - part;
    let low = window.start + window.span * part;
    let high = window.start + window.span * rest;
    let lesser = window.share * part;
    let greater = window.share * rest;
    let first = sqrt((window.near + lesser) * (window.far + greater)) * halving_square(low);
    let second = sqrt((window.near + greater) * (window.far + lesser)) * halving_square(high);
    return sine * (first + second);
}

// Returns the half width of an ellipse across the tangent; half axes, cosine of the angle from the
// first to the tangent.
//
// For |cos_phi| up to 1.
fn footprint_half_width(a_first: f32, a_second: f32, cos_phi: f32) -> f32 {
    let sine_squared = max((1.0f - cos_phi) * (1.0f + cos_phi), 0.0f);
    let along = a_second * cos_phi;
    return sqrt((a_first * a_first) * sine_squared + along * along);
}

// Returns the mean over an ellipse of exp(-s_b^2/sigma^2) for an infinite scratch, to f32 grade of
// its largest value.
//
// Half width H of the ellipse across the scratch and `edge` = H - |C| with C the scratch's offset
// from the centre, both
// over sigma: the caller may know the edge better than the difference of two rounded numbers. Any H
// >= 0.
fn footprint_mean_reduced(half_width: f32, edge: f32) -> f32 {
    let window = footprint_window(half_width, edge);
    let a = footprint_pair(window, FOOTPRINT_NODE_A, FOOTPRINT_NODE_SINE_A);
    let b = footprint_pair(window, FOOTPRINT_NODE_B, FOOTPRINT_NODE_SINE_B);
    let c = footprint_pair(window, FOOTPRINT_NODE_C, FOOTPRINT_NODE_SINE_C);
    let d = footprint_pair(window, FOOTPRINT_NODE_D, FOOTPRINT_NODE_SINE_D);
    let e = footprint_pair(window, FOOTPRINT_NODE_E, FOOTPRINT_NODE_SINE_E);
    let f = footprint_pair(window, FOOTPRINT_NODE_F, FOOTPRINT_NODE_SINE_F);
    let g = footprint_pair(window, FOOTPRINT_NODE_G, FOOTPRINT_NODE_SINE_G);
    let h = footprint_pair(window, FOOTPRINT_NODE_H, FOOTPRINT_NODE_SINE_H);
    let i = footprint_pair(window, FOOTPRINT_NODE_I, FOOTPRINT_NODE_SINE_I);
    let outer = (a + b) + (c + d);
    let inner = ((i + h) + (g + f)) + e;
    return (window.share * FOOTPRINT_SHARE) * (outer + inner);
}

// Returns a polynomial of degree 5.
fn footprint_quintic(w: f32, a: f32, b: f32, c: f32, d: f32, e: f32, f: f32) -> f32 {
    let upper = c + w * (d + w * (e + w * f));
    return a + w * (b + w * upper);
}

// Returns [`footprint_mean_reduced`] to 1e-3.
//
// One exponential and one root: of a narrow ellipse, of one edge, or of the middle of a wide
// ellipse.
fn footprint_mean_reduced_coarse(half_width: f32, edge: f32) -> f32 {
    let d = max(edge, -3.05f);
    let is_narrow = half_width < FOOTPRINT_WIDE_LIMIT;
    let is_interior = edge >= FOOTPRINT_INTERIOR_LIMIT;
    let narrow = min(half_width, FOOTPRINT_WIDE_LIMIT);
    let offset = narrow - d;
    let spread = 2.0f / (2.0f + narrow * narrow);
    let v = 0.5f * ((narrow * narrow) * spread);
    let u = v * v;
    let w = 2.0f * ((offset * offset) * spread);
    let second = footprint_quintic(w, FOOTPRINT_NARROW_A, FOOTPRINT_NARROW_B, FOOTPRINT_NARROW_C,
        FOOTPRINT_NARROW_D, FOOTPRINT_NARROW_E, FOOTPRINT_NARROW_F);
    let fourth = footprint_quintic(w, FOOTPRINT_NARROW_G, FOOTPRINT_NARROW_H, FOOTPRINT_NARROW_I,
        FOOTPRINT_NARROW_J, FOOTPRINT_NARROW_K, FOOTPRINT_NARROW_L);
    let sixth = footprint_quintic(w, FOOTPRINT_NARROW_M, FOOTPRINT_NARROW_N, FOOTPRINT_NARROW_O,
        FOOTPRINT_NARROW_P, FOOTPRINT_NARROW_Q, FOOTPRINT_NARROW_R);
    let excess = 0.5f * w + u * (second + u * (fourth + u * sixth));
    let wide = min(max(half_width, FOOTPRINT_WIDE_LIMIT), FOOTPRINT_MOST_LIMIT);
    let inverse = 1.0f / wide;
    let far = ((wide - d) + wide) * inverse;
    let near = d * inverse;
    let t = min(d, FOOTPRINT_INTERIOR_LIMIT);
    let upper = FOOTPRINT_EDGE_C + t * (FOOTPRINT_EDGE_D + t * (FOOTPRINT_EDGE_E + t *
        FOOTPRINT_EDGE_F));
    let decay = FOOTPRINT_EDGE_A + t * (FOOTPRINT_EDGE_B + t * upper);
    let slope = FOOTPRINT_EDGE_SLOPE_A + t * (FOOTPRINT_EDGE_SLOPE_B + t * FOOTPRINT_EDGE_SLOPE_C);
    let edged = decay + slope * (inverse / far);
    let exponent = select(select(edged, 0.0f, is_interior), excess, is_narrow);
    let under_root = select(select(far * inverse, near * far, is_interior), spread, is_narrow);
    let bend = 1.0f / (d * far);
    let z = bend * bend;
    let middle = inverse * (1.1283792f - z * (0.2820948f + 0.1410474f * z));
    let height = select(select(inverse, middle, is_interior), 1.0f, is_narrow);
    let value = (sqrt(under_root) * height) * exponential(-exponent);
    return select(value, 0.0f, edge < FOOTPRINT_OUTSIDE_LIMIT);
}

// Returns the mean over an ellipse of exp(-s_b^2/sigma^2) for an infinite scratch at an offset;
// lengths in one unit.
//
// Half axes and angle as in [`footprint_half_width`]. Wide ellipses lose what the rounding of the
// half width costs the
// distance of the edge.
fn footprint_mean(a_first: f32, a_second: f32, cos_phi: f32, offset: f32, radius: f32) -> f32 {
    let half_width = footprint_half_width(a_first, a_second, cos_phi);
    let inverse = 1.0f / radius;
    return footprint_mean_reduced(half_width * inverse, (half_width - abs(offset)) * inverse);
}

// Returns [`footprint_mean`] to 1e-3.
fn footprint_mean_coarse(a_first: f32, a_second: f32, cos_phi: f32, offset: f32, radius: f32) -> f32
    {
    let half_width = footprint_half_width(a_first, a_second, cos_phi);
    let inverse = 1.0f / radius;
    return footprint_mean_reduced_coarse(half_width * inverse, (half_width - abs(offset)) *
        inverse);
}

// ---- inverse ----
// Inverse elementary functions of the f32 kernels: logarithms, and the angle of a point.

// pi/4.
const QUARTER_PI: f32 = 0.7853982f;
// tan(pi/8).
const TANGENT_SPLIT: f32 = 0.41421357f;
// The smallest random number that counts, 2^-25.
const SHARE_SMALLEST_LIMIT: f32 = 2.9802322e-8f;

// Returns 2 artanh s, for |s| <= 0.172, to f32 grade.
fn artanh_twice(s: f32) -> f32 {
    let u = s * s;
    let series = u * (ARTANH_A + u * (ARTANH_B + u * ARTANH_C));
    return (s + s) + s * series;
}

// Returns ln x for a normal x > 0, to f32 grade.
fn natural_log(x: f32) -> f32 {
    let bits = bitcast<u32>(x);
    let fraction = bitcast<f32>((bits & 0x7fffffu) | 0x3f000000u);
    let small = fraction < INVERSE_ROOT_TWO;
    let m = select(fraction, fraction + fraction, small);
    let e = f32((bits >> 23u)) - select(126.0f, 127.0f, small);
    return e * LN_TWO_HIGH + (e * LN_TWO_LOW + artanh_twice((m - 1.0f) / (m + 1.0f)));
}

// Returns ln(1 - a) for 0 <= a < 1, to f32 grade also for the smallest a.
fn log_one_minus(a: f32) -> f32 {
    let bounded = min(a, 0.29f);
    let near = artanh_twice(-bounded / (2.0f - bounded));
    return select(natural_log(max(1.0f - a, SHARE_SMALLEST_LIMIT)), near, a < 0.29f);
}

// Returns the angle of (x, y) from the first axis, for y >= 0: from 0 to pi, to f32 grade.
fn angle_from_axis(x: f32, y: f32) -> f32 {
    let size = abs(x);
    let low = min(size, y);
    let high = max(size, y);
    let split = low > TANGENT_SPLIT * high;
    let t = select(low, low - high, split) / select(high, low + high, split);
    let u = t * t;
    let series = u * (ARCTANGENT_A + u * (ARCTANGENT_B + u * (ARCTANGENT_C + u * ARCTANGENT_D)));
    let eighth = (t - t * series) + select(0.0f, QUARTER_PI, split);
    let quarter = select(eighth, HALF_PI - eighth, y > size);
    return select(quarter, ARC_PI - quarter, x < 0.0f);
}

// ---- sampling ----
// Densities and samples of the lobes of a scratched surface, in f32: the base lobe, the lobe of a
// scratch, the
// published cone, and the balance of two strategies.

// Narrower scratches, in pi W/lambda, have a flat lobe.
const LOBE_NARROW_LIMIT: f32 = 0.000001f;
// Less concentrated cones are uniform.
const LOBE_UNIFORM_LIMIT: f32 = 1.0e-7f;

// A sampled direction.
struct SampledDirection {
    // The component along the tangent.
    x: f32,
    // The component along the bitangent.
    y: f32,
    // The component along the normal.
    z: f32,
    // The density, in 1/sr; 0 where the draw gives no direction and counts as zero.
    pdf: f32,
}

// Returns the y at which int_-inf^y exp(-t^2) dt/sqrt(pi) is `u`, for 0 <= u < 1.
//
// Below 2^-25 it stays. The polynomials are those of Giles 2010, "Approximating the erfinv
// function", Table 5.
fn gaussian_inverse(u: f32) -> f32 {
    let share = max(u, SHARE_SMALLEST_LIMIT);
    let x = (share + share) - 1.0f;
    let tail = min(share, 1.0f - share);
    let middle = -log_one_minus(x * x);
    let outer = -(natural_log(tail) + (1.3862944f + log_one_minus(tail)));
    let v = select(middle, outer, abs(x) > 0.5f);
    let c = v - 2.5f;
    let upper_centre = 0.00021858087f + c * (-4.3915065e-6f + c * (-3.5233877e-6f + c *
        (3.4327394e-7f + c * 2.8102264e-8f)));
    let centre = 1.5014094f + c * (0.24664073f + c * (-0.0041776816f + c * (-0.001253725f + c *
        upper_centre)));
    let d = sqrt(max(v, 0.0f)) - 3.0f;
    let upper_far = -0.0036734284f + d * (0.0013493432f + d * (0.00010095056f + d *
        -0.00020021426f));
    let far = 2.8329768f + d * (1.001674f + d * (0.00943887f + d * (-0.007622461f + d *
        (0.0057395077f + d * upper_far))));
    return x * select(centre, far, v >= 5.0f);
}

// Returns k sigma.
fn lobe_reduced_radius(radius: f32, wavelength: f32) -> f32 {
    return TWO_PI * (radius / wavelength);
}

// Returns the density of the base lobe, in 1/sr: a Gaussian of direction cosines.
//
// Radius of the coherence window and wavelength in um; incident and outgoing direction by
// components along tangent (t),
// bitangent (b) and normal (n), away from the surface; the incident one above it. 0 for an outgoing
// one below it.
fn base_lobe_pdf(radius: f32, wavelength: f32, incident_t: f32, incident_b: f32, outgoing_t: f32,
    outgoing_b: f32, outgoing_n: f32) -> f32 {
    let q = lobe_reduced_radius(radius, wavelength);
    let x = q * (incident_t + outgoing_t);
    let y = q * (incident_b + outgoing_b);
    let height = exponential(-(x * x + y * y)) * INVERSE_PI;
    return select(q * (q * (height * outgoing_n)), 0.0f, outgoing_n <= 0.0f);
}

// Returns a direction of the base lobe from two random numbers of \[0, 1); density 0 for an
// evanescent draw.
fn base_lobe_sample(radius: f32, wavelength: f32, incident_t: f32, incident_b: f32, first: f32,
    second: f32) -> SampledDirection {
    let q = lobe_reduced_radius(radius, wavelength);
    let size = sqrt(-log_one_minus(first)) / q;
    let turn = sine_cosine_turns(second);
    let x = size * turn.cosine - incident_t;
    let y = size * turn.sine - incident_b;
    let z = sqrt(max((1.0f - x) * (1.0f + x) - y * y, 0.0f));
    return SampledDirection(x, y, z, base_lobe_pdf(radius, wavelength, incident_t, incident_b, x, y,
        z));
}

// Returns the Lorentzian's angle over the directions that propagate, from c (b - g) to c (b + g).
fn lobe_lorentz_angle(c: f32, b: f32, g: f32) -> f32 {
    let low = c * (b - g);
    let high = c * (b + g);
    return angle_from_axis(1.0f + low * high, c * (g + g));
}

// Returns the length of (b, n) without underflow at grazing angles: the squares are taken of 2^40
// times each.
fn lobe_reach(b: f32, n: f32) -> f32 {
    let wide = b * 1099511627776.0f;
    let high = n * 1099511627776.0f;
    return sqrt(wide * wide + high * high) * 9.094947e-13f;
}

// Returns the density of the lobe of a scratch, in 1/sr: a Gaussian along it, a Lorentzian across.
//
// Radius, wavelength and width in um; directions as in [`base_lobe_pdf`].
fn scratch_lobe_pdf(radius: f32, wavelength: f32, width: f32, incident_t: f32, incident_b: f32,
    outgoing_t: f32, outgoing_b: f32, outgoing_n: f32) -> f32 {
    let q = lobe_reduced_radius(radius, wavelength);
    let c = ARC_PI * (width / wavelength);
    let along = q * (incident_t + outgoing_t);
    let x = c * (incident_b + outgoing_b);
    let g = lobe_reach(outgoing_b, outgoing_n);
    let curved = c / (lobe_lorentz_angle(c, incident_b, g) * (1.0f + x * x));
    let across = select(curved, 0.5f / g, c < LOBE_NARROW_LIMIT);
    let gaussian = q * (exponential(-(along * along)) * INVERSE_ROOT_PI);
    return select(gaussian * (across * outgoing_n), 0.0f, outgoing_n <= 0.0f);
}

// Returns a direction of the lobe of a scratch from two random numbers of \[0, 1); density 0 for an
// evanescent draw.
fn scratch_lobe_sample(radius: f32, wavelength: f32, width: f32, incident_t: f32, incident_b: f32,
    first: f32, second: f32) -> SampledDirection {
    let q = lobe_reduced_radius(radius, wavelength);
    let c = ARC_PI * (width / wavelength);
    let x = gaussian_inverse(first) / q - incident_t;
    let g = sqrt(max((1.0f - x) * (1.0f + x), 0.0f));
    let b = abs(incident_b);
    let mirrored = incident_b < 0.0f;
    let u = select(1.0f - second, second, mirrored);
    let far = c * (b + g);
    let turn = sine_cosine(u * lobe_lorentz_angle(c, b, g));
    let curved = turn.sine * (1.0f + far * far) / (c * (turn.cosine + far * turn.sine));
    let from_end = select(curved, u * (g + g), c < LOBE_NARROW_LIMIT);
    let beta = g - from_end;
    let y = select(beta, -beta, mirrored);
    let z = sqrt(max(from_end * ((g + g) - from_end), 0.0f));
    return SampledDirection(x, y, z, scratch_lobe_pdf(radius, wavelength, width, incident_t,
        incident_b, x, y, z));
}

// Returns 1 - e^(-2 kappa), relatively accurate, for kappa >= 0.
fn cone_mass(concentration: f32) -> f32 {
    let z = concentration + concentration;
    let upper = 0.008333334f - z * (0.0013888889f - z * (0.0001984127f - z * 0.000024801588f));
    let series = z * (0.5f - z * (0.16666667f - z * (0.041666668f - z * upper)));
    return select(1.0f - exponential(-z), z - z * series, z < 0.5f);
}

// Returns the density of the published cone of a scratch, in 1/sr (WVJH17 section 5), for a
// concentration >= 0.
//
// Directions as in [`base_lobe_pdf`].
fn scratch_cone_pdf(concentration: f32, incident_t: f32, incident_b: f32, incident_n: f32,
    outgoing_t: f32, outgoing_b: f32, outgoing_n: f32) -> f32 {
    let across_in = sqrt(incident_b * incident_b + incident_n * incident_n);
    let across_out = sqrt(outgoing_b * outgoing_b + outgoing_n * outgoing_n);
    let sum = incident_t + outgoing_t;
    let difference = across_in - across_out;
    let decay = (0.5f * concentration) * (sum * sum + difference * difference);
    let peak = select(concentration / cone_mass(concentration), 0.5f, concentration <
        LOBE_UNIFORM_LIMIT);
    let rise = bessel_i0_scaled(concentration * (across_in * across_out));
    let density = peak * ((exponential(-decay) * INVERSE_PI) * rise);
    return select(density, 0.0f, outgoing_n < 0.0f);
}

// Returns a direction of the published cone from three random numbers of \[0, 1).
fn scratch_cone_sample(concentration: f32, incident_t: f32, incident_b: f32, incident_n: f32, first:
    f32, second: f32, third: f32) -> SampledDirection {
    let curved = -log_one_minus(first * cone_mass(concentration)) / concentration;
    let versine = min(select(curved, first + first, concentration < LOBE_UNIFORM_LIMIT), 2.0f);
    let cosine = 1.0f - versine;
    let sine = sqrt(versine * (2.0f - versine));
    let offset = sine_cosine_turns(second);
    let s = sqrt(incident_b * incident_b + incident_n * incident_n);
    let turned = sine * offset.cosine;
    let x = -(incident_t * cosine) - s * turned;
    let across = s * cosine - incident_t * turned;
    let beside = sine * offset.sine;
    let reach = sqrt(across * across + beside * beside);
    let azimuth = sine_cosine_turns(0.5f * third);
    let y = reach * azimuth.cosine;
    let z = reach * azimuth.sine;
    return SampledDirection(x, y, z, scratch_cone_pdf(concentration, incident_t, incident_b,
        incident_n, x, y, z));
}

// Returns the balance weight of a strategy with the density `own` beside `others`, for finite
// densities >= 0.
//
// 0 where both are 0.
fn balance_weight(own: f32, others: f32) -> f32 {
    let ratio = min(own, others) / max(own, others);
    let larger = 1.0f / (1.0f + ratio);
    return select(select(ratio * larger, larger, own >= others), 0.0f, own == 0.0f);
}

// ---- light ----
// Area lights over the lobe of an infinite scratch, one chord each, in f32.
// Sources named: VWH18 Eq. 27, VWH18 3.4.1, VWH18 3.4.2.

// 1/(2 sqrt(pi)).
const LIGHT_HALF_INVERSE_ROOT_PI: f32 = 0.2820948f;

// A point or a direction relative to the shaded point: tangent, bitangent, normal.
struct LightPoint {
    // Along the tangent.
    x: f32,
    // Along the bitangent.
    y: f32,
    // Along the normal.
    z: f32,
}

// The line xi_t = 0 across a light, and what counts along it.
struct LightLine {
    // The tangent component of the light's direction on the line.
    x: f32,
    // 1 - x^2.
    rest: f32,
    // The view's bitangent component.
    view: f32,
    // k W/2.
    width: f32,
}

// The chords of a polygon met so far.
struct LightChords {
    // The integral over the complete ones.
    sum: f32,
    // Where the last one begins, if it has no end yet: the bitangent component of the direction.
    begin_b: f32,
    // The normal component.
    begin_n: f32,
    // Whether it has none: then 1, else 0.
    open: f32,
    // Where the outline went below the horizon, if it has not come back.
    setting: LightPoint,
    // 1 if it has not, else 0.
    below: f32,
    // Where the outline came up first.
    rise: LightPoint,
    // 1 if it came up before it went down, else 0.
    risen: f32,
}

// Returns the line xi_t = 0 for a view and a scratch.
fn light_line(wavelength: f32, width: f32, view_t: f32, view_b: f32) -> LightLine {
    return LightLine(-view_t, max((1.0f - view_t) * (1.0f + view_t), 0.0f), view_b, ARC_PI * (width
        / wavelength));
}

// Returns the band's Gaussian integral over k W/2: what turns an arc of sinc^2 into the integral
// over a light.
fn light_scale(radius: f32, wavelength: f32, width: f32) -> f32 {
    return LIGHT_HALF_INVERSE_ROOT_PI * (wavelength / radius) * (wavelength / (ARC_PI * width));
}

// Returns the integral of exp(-(sigma k xi_t)^2) sinc^2(k W xi_b/2) over a sphere that covers the
// band, by the chord at
// xi_t = 0, dimensionless (VWH18 3.4.1 with the true tangent cone).
//
// `x`, `y`, `z` is the sphere's centre. A sphere that the line misses gives 0; one that contains
// the shaded point has
// no chord.
fn sphere_light_chord(radius: f32, wavelength: f32, width: f32, view_t: f32, view_b: f32, x: f32, y:
    f32, z: f32, sphere_radius: f32) -> f32 {
    let cut = light_line(wavelength, width, view_t, view_b);
    let tilt = y * y + z * z;
    let square = x * x + tilt;
    let tangent = sqrt(max(square - sphere_radius * sphere_radius, 0.0f));
    let per_square = 1.0f / square;
    let per_tilt = 1.0f / tilt;
    let p = cut.x - (tangent * per_square) * x;
    let sine = sphere_radius * per_square;
    let discriminant = (sine * sine) * tilt - p * p;
    let root = sqrt(max(discriminant, 0.0f) * square) * per_tilt;
    let level = tangent * per_square - (p * per_tilt) * x;
    let centre_b = y * level;
    let reach_b = z * root;
    let left_z = z * level + y * root;
    let right_z = z * level - y * root;
    let met = discriminant > 0.0f;
    let left_up = left_z >= 0.0f && met;
    let right_up = right_z >= 0.0f && met;
    let above = left_up && right_up;
    var left = centre_b - reach_b;
    var right = centre_b + reach_b;
    var extent = abs(reach_b + reach_b);
    var gap = 0.0f;
    var seen = true;
    if !above || reach_b < 0.0f {
        let edge = sqrt(cut.rest);
        let depth = level * tilt;
        let inside = select(depth, depth + abs(y) * edge, met) < 0.0f;
        seen = left_up || right_up || inside;
        left = select(-edge, min(max(left, -edge), edge), left_up);
        right = select(edge, min(max(right, -edge), edge), right_up);
        extent = select(abs(right - left), extent, above);
        if above {
            gap = arc_of_extent(cut.width * (cut.view - edge), cut.width * (cut.view + edge),
                cut.width * (edge + edge));
        }
    }
    let arc = arc_of_extent(cut.width * (left + cut.view), cut.width * (right + cut.view), cut.width
        * extent);
    let value = select(0.0f, gap + arc, seen);
    return light_scale(radius, wavelength, width) * max(value, 0.0f);
}

// Returns where an outline has met the line once more, at a direction of these two components: the
// chord it ends, or
// the beginning of the next.
fn light_crossing(chords: LightChords, cut: LightLine, b: f32, n: f32, direction: f32) ->
    LightChords {
    var next = chords;
    if chords.open > 0.0f {
        next.begin_b = b;
        next.begin_n = n;
        next.open = 0.0f;
    } else {
        let sum_b = abs(b + chords.begin_b);
        let sum_n = abs(n + chords.begin_n);
        let by_normals = abs(n - chords.begin_n) * sum_n / sum_b;
        let extent = select(abs(b - chords.begin_b), by_normals, sum_n < sum_b);
        let arc = arc_of_extent(cut.width * (chords.begin_b + cut.view), cut.width * (b + cut.view),
            cut.width * extent);
        next.sum = chords.sum + direction * arc;
        next.open = 1.0f;
    }
    return next;
}

// Returns on which side of the line a point is: 1 or -1.
fn light_side(cut: LightLine, p: LightPoint) -> f32 {
    return select(-1.0f, 1.0f, p.x - cut.x * sqrt((p.x * p.x + p.y * p.y) + p.z * p.z) >= 0.0f);
}

// Returns the chords after the visible arc from one point to another, whose sides are known.
fn light_arc(chords: LightChords, cut: LightLine, start: LightPoint, stop: LightPoint, start_side:
    f32, stop_side: f32) -> LightChords {
    var next = chords;
    let dx = stop.x - start.x;
    let dy = stop.y - start.y;
    let dz = stop.z - start.z;
    let nx = start.y * dz - start.z * dy;
    let ny = start.z * dx - start.x * dz;
    let nz = start.x * dy - start.y * dx;
    let tilt = ny * ny + nz * nz;
    let offset = cut.x * nx;
    let discriminant = tilt * cut.rest - offset * offset;
    let leaving = start_side * (nz * start.y - ny * start.z);
    let returning = start_side * (nz * stop.y - ny * stop.z);
    let twice = start_side == stop_side && discriminant > 0.0f && leaving > 0.0f && returning <
        0.0f;
    if twice || start_side != stop_side {
        let root = sqrt(max(discriminant, 0.0f));
        let inverse = 1.0f / tilt;
        let base_b = -(offset * ny);
        let base_n = -(offset * nz);
        let move_b = start_side * (nz * root);
        let move_n = start_side * (ny * root);
        let no_plane = tilt == 0.0f;
        let b = select((base_b + move_b) * inverse, start.y, no_plane);
        let n = select((base_n - move_n) * inverse, start.z, no_plane);
        next = light_crossing(next, cut, b, n, start_side);
        if twice {
            next = light_crossing(next, cut, (base_b - move_b) * inverse, (base_n + move_n) *
                inverse, -start_side);
        }
    }
    return next;
}

// Returns the point of an edge at the horizon: between its ends, and of their size.
fn light_horizon(start: LightPoint, stop: LightPoint) -> LightPoint {
    let whole = abs(stop.z) + abs(start.z);
    let a = abs(stop.z) / whole;
    let b = abs(start.z) / whole;
    return LightPoint(start.x * a + stop.x * b, start.y * a + stop.y * b, 0.0f);
}

// Returns the chords after one more edge of a polygon.
fn light_edge(chords: LightChords, cut: LightLine, start: LightPoint, stop: LightPoint, start_side:
    f32, stop_side: f32) -> LightChords {
    var next = chords;
    if start.z >= 0.0f && stop.z >= 0.0f {
        next = light_arc(next, cut, start, stop, start_side, stop_side);
    } else if start.z >= 0.0f {
        let setting = light_horizon(start, stop);
        next = light_arc(next, cut, start, setting, start_side, light_side(cut, setting));
        next.setting = setting;
        next.below = 1.0f;
    } else if stop.z >= 0.0f {
        let rise = light_horizon(start, stop);
        let side = light_side(cut, rise);
        if next.below > 0.0f {
            next = light_arc(next, cut, next.setting, rise, light_side(cut, next.setting), side);
            next.below = 0.0f;
        } else {
            next.rise = rise;
            next.risen = 1.0f;
        }
        next = light_arc(next, cut, rise, stop, side, stop_side);
    }
    return next;
}

// Returns no chords.
fn light_chords() -> LightChords {
    let none = LightPoint(0.0f, 0.0f, 0.0f);
    return LightChords(0.0f, 0.0f, 0.0f, 1.0f, none, 0.0f, none, 0.0f);
}

// Returns the integral over all chords of a closed outline.
fn light_closed(chords: LightChords, cut: LightLine) -> f32 {
    var inside = chords;
    if inside.below > 0.0f && inside.risen > 0.0f {
        inside = light_arc(inside, cut, inside.setting, inside.rise, light_side(cut,
            inside.setting), light_side(cut, inside.rise));
    }
    return abs(inside.sum);
}

// Returns the integral of exp(-(sigma k xi_t)^2) sinc^2(k W xi_b/2) over a triangle that covers the
// band, by the chord at
// xi_t = 0, dimensionless (VWH18 3.4.2).
//
// The three vertices follow, either way round. A triangle that the line misses gives 0.
fn triangle_light_chord(radius: f32, wavelength: f32, width: f32, view_t: f32, view_b: f32, ax: f32,
    ay: f32, az: f32, bx: f32, by: f32, bz: f32, cx: f32, cy: f32, cz: f32) -> f32 {
    let cut = light_line(wavelength, width, view_t, view_b);
    let a = LightPoint(ax, ay, az);
    let b = LightPoint(bx, by, bz);
    let c = LightPoint(cx, cy, cz);
    let side_a = light_side(cut, a);
    let side_b = light_side(cut, b);
    let side_c = light_side(cut, c);
    let first = light_edge(light_chords(), cut, a, b, side_a, side_b);
    let second = light_edge(first, cut, b, c, side_b, side_c);
    let third = light_edge(second, cut, c, a, side_c, side_a);
    return light_scale(radius, wavelength, width) * light_closed(third, cut);
}

// Returns the integral of exp(-(sigma k xi_t)^2) sinc^2(k W xi_b/2) over a quadrilateral that
// covers the band, by the
// chords at xi_t = 0, dimensionless (VWH18 3.4.2).
//
// The four vertices follow in order, either way round, convex or not. A quadrilateral that the line
// misses gives 0.
fn quad_light_chord(radius: f32, wavelength: f32, width: f32, view_t: f32, view_b: f32, ax: f32, ay:
    f32, az: f32, bx: f32, by: f32, bz: f32, cx: f32, cy: f32, cz: f32, dx: f32, dy: f32, dz: f32)
    -> f32 {
    let cut = light_line(wavelength, width, view_t, view_b);
    let a = LightPoint(ax, ay, az);
    let b = LightPoint(bx, by, bz);
    let c = LightPoint(cx, cy, cz);
    let d = LightPoint(dx, dy, dz);
    let side_a = light_side(cut, a);
    let side_b = light_side(cut, b);
    let side_c = light_side(cut, c);
    let side_d = light_side(cut, d);
    let first = light_edge(light_chords(), cut, a, b, side_a, side_b);
    let second = light_edge(first, cut, b, c, side_b, side_c);
    let third = light_edge(second, cut, c, d, side_c, side_d);
    let fourth = light_edge(third, cut, d, a, side_d, side_a);
    return light_scale(radius, wavelength, width) * light_closed(fourth, cut);
}

// Returns the integral of exp(-(sigma k xi_t)^2) sinc^2(k W xi_b/2) over a polygon of three to
// eight vertices that covers
// the band, by the chords at xi_t = 0, dimensionless (VWH18 3.4.2).
//
// `count` is the number of vertices; the vertices follow in order, either way round, convex or not;
// those beyond the
// count are not read. A polygon that the line misses gives 0.
fn polygon_light_chord(radius: f32, wavelength: f32, width: f32, view_t: f32, view_b: f32, count:
    f32, ax: f32, ay: f32, az: f32, bx: f32, by: f32, bz: f32, cx: f32, cy: f32, cz: f32, dx: f32,
    dy: f32, dz: f32, ex: f32, ey: f32, ez: f32, fx: f32, fy: f32, fz: f32, gx: f32, gy: f32, gz:
    f32, hx: f32, hy: f32, hz: f32) -> f32 {
    let cut = light_line(wavelength, width, view_t, view_b);
    let a = LightPoint(ax, ay, az);
    let first_side = light_side(cut, a);
    var chords = light_chords();
    var last = a;
    var last_side = first_side;
    for (var i: u32 = 1; i < 8u; i++) {
        if (f32(i)) < count {
            let x = select(select(select(bx, cx, i == 2u), select(dx, ex, i == 4u), i > 2u),
                select(fx, select(gx, hx, i == 7u), i > 5u), i > 4u);
            let y = select(select(select(by, cy, i == 2u), select(dy, ey, i == 4u), i > 2u),
                select(fy, select(gy, hy, i == 7u), i > 5u), i > 4u);
            let z = select(select(select(bz, cz, i == 2u), select(dz, ez, i == 4u), i > 2u),
                select(fz, select(gz, hz, i == 7u), i > 5u), i > 4u);
            let place = LightPoint(x, y, z);
            let side = light_side(cut, place);
            chords = light_edge(chords, cut, last, place, last_side, side);
            last = place;
            last_side = side;
        }
    }
    chords = light_edge(chords, cut, last, a, last_side, first_side);
    return light_scale(radius, wavelength, width) * light_closed(chords, cut);
}

// ---- area_light ----
// Area lights over the lobe of an infinite scratch, whatever part of the band they cover, in f32.
// Sources named: VWH18 3.4.1, VWH18 3.4.2.

// |sigma k xi_t| at the end of the band.
const BAND_END: f32 = 3.5f;
// Measure of a panel of 8 nodes.
const BAND_PANEL_LIMIT: f32 = 4.0f;
// Gauss-Legendre, 8 points: nodes and weights from the middle out.
const BAND_NODE_A: f32 = 0.18343464f;
// The second node.
const BAND_NODE_B: f32 = 0.52553242f;
// The third node.
const BAND_NODE_C: f32 = 0.7966665f;
// The outer node.
const BAND_NODE_D: f32 = 0.96028984f;
// Weight of the first node.
const BAND_WEIGHT_A: f32 = 0.36268377f;
// Weight of the second node.
const BAND_WEIGHT_B: f32 = 0.31370664f;
// Weight of the third node.
const BAND_WEIGHT_C: f32 = 0.22238104f;
// Weight of the outer node.
const BAND_WEIGHT_D: f32 = 0.101228535f;

// The lobe in the units of its two factors.
struct LightBand {
    // sigma k.
    along: f32,
    // k W/2.
    width: f32,
    // The view's tangent component.
    view_t: f32,
    // The view's bitangent component.
    view_b: f32,
    // The bitangent cosine from which the integral of sinc^2 counts.
    reference: f32,
}

// A circle on the unit sphere, projected: t = t0 + reach cos, b = b0 + cosine cos + sine sin of an
// angle.
struct LightCircle {
    // t0.
    centre_t: f32,
    // b0.
    centre_b: f32,
    // Half the extent along the tangent.
    reach: f32,
    // The coefficient of the cosine in b.
    across_cosine: f32,
    // The coefficient of the sine in b.
    across_sine: f32,
}

// Cosine and sine of an angle on such a circle.
struct LightAngle {
    // Cosine.
    c: f32,
    // Sine.
    s: f32,
}

// Returns the band of a view and a scratch, its reference at the direction of these bitangent
// components.
fn light_band(radius: f32, wavelength: f32, width: f32, view_t: f32, view_b: f32, reference: f32) ->
    LightBand {
    return LightBand(TWO_PI * (radius / wavelength), ARC_PI * (width / wavelength), view_t, view_b,
        reference + view_b);
}

// Returns the factor from sums along an outline to the integral over the light, 1 over k W/2.
fn light_band_scale(wavelength: f32, width: f32) -> f32 {
    return wavelength / (ARC_PI * width);
}

// Returns -exp(-t^2) Phi dt for one node of a panel, at the half-angle tangent v from the middle of
// a piece.
fn light_band_node(band: LightBand, circle: LightCircle, middle: LightAngle, v: f32) -> f32 {
    let inverse = 1.0f / (1.0f + v * v);
    let cosine = (1.0f - v * v) * inverse;
    let sine = (v + v) * inverse;
    let c = middle.c * cosine - middle.s * sine;
    let s = middle.s * cosine + middle.c * sine;
    let t = band.along * ((circle.centre_t + band.view_t) + circle.reach * c);
    let b = (circle.centre_b + band.view_b) + (circle.across_cosine * c + circle.across_sine * s);
    let way = b - band.reference;
    let phi = arc_of_extent(band.width * band.reference, band.width * b, band.width * abs(way));
    return ((circle.reach * s) * (inverse + inverse)) * (exponential(-(t * t)) * phi);
}

// Returns the integral of -exp(-t^2) Phi dt over the part in the band of a piece whose ends lie on
// one half turn.
fn light_band_piece(band: LightBand, circle: LightCircle, start: LightAngle, stop: LightAngle) ->
    f32 {
    let offset = circle.centre_t + band.view_t;
    let t_start = band.along * (offset + circle.reach * start.c);
    let t_stop = band.along * (offset + circle.reach * stop.c);
    if min(t_start, t_stop) >= BAND_END || max(t_start, t_stop) <= -BAND_END {
        return 0.0f;
    }
    let height = start.s + stop.s;
    let upper = height > 0.0f || (height == 0.0f && start.c > stop.c);
    let high = min(max((BAND_END / band.along - offset) / circle.reach, -1.0f), 1.0f);
    let low = min(max((-BAND_END / band.along - offset) / circle.reach, -1.0f), 1.0f);
    let high_s = sqrt((1.0f - high) * (1.0f + high));
    let low_s = sqrt((1.0f - low) * (1.0f + low));
    let a_c = select(select(start.c, high, t_start > BAND_END), low, t_start < -BAND_END);
    let a_size = select(select(abs(start.s), high_s, t_start > BAND_END), low_s, t_start <
        -BAND_END);
    let z_c = select(select(stop.c, high, t_stop > BAND_END), low, t_stop < -BAND_END);
    let z_size = select(select(abs(stop.s), high_s, t_stop > BAND_END), low_s, t_stop < -BAND_END);
    let a_s = select(-a_size, a_size, upper);
    let z_s = select(-z_size, z_size, upper);
    let sum_c = a_c + z_c;
    let sum_s = a_s + z_s;
    let way_c = z_c - a_c;
    let way_s = z_s - a_s;
    let length_sum = sqrt(sum_c * sum_c + sum_s * sum_s);
    let length_way = sqrt(way_c * way_c + way_s * way_s);
    let by_sum = length_sum > length_way;
    let size = 1.0f / select(length_way, length_sum, by_sum);
    let middle = LightAngle(size * select(way_s, sum_c, by_sum), size * select(-way_c, sum_s,
        by_sum));
    let reach_v = length_way / (2.0f + length_sum);
    let angle = 4.0f * reach_v;
    let steepest = select(max(a_size, z_size), 1.0f, a_c * z_c < 0.0f);
    let swing = sqrt(circle.across_cosine * circle.across_cosine + circle.across_sine *
        circle.across_sine);
    let slope = min(swing, abs(circle.across_sine * middle.c - circle.across_cosine * middle.s) +
        swing * reach_v);
    let measure = 1.5f * ((band.along * circle.reach) * (steepest * angle)) + 0.5f * (band.width *
        (slope * angle));
    let panels = min(max(ceil(measure / BAND_PANEL_LIMIT), 1.0f), 16.0f);
    let panel = reach_v / panels;
    var sum = 0.0f;
    for (var i: u32 = 0; i < 16u; i++) {
        if (f32(i)) < panels {
            let centre = (2.0f * (f32(i)) + (1.0f - panels)) * panel;
            sum += BAND_WEIGHT_A * (light_band_node(band, circle, middle, centre - BAND_NODE_A *
                panel) + light_band_node(band, circle, middle, centre + BAND_NODE_A * panel));
            sum += BAND_WEIGHT_B * (light_band_node(band, circle, middle, centre - BAND_NODE_B *
                panel) + light_band_node(band, circle, middle, centre + BAND_NODE_B * panel));
            sum += BAND_WEIGHT_C * (light_band_node(band, circle, middle, centre - BAND_NODE_C *
                panel) + light_band_node(band, circle, middle, centre + BAND_NODE_C * panel));
            sum += BAND_WEIGHT_D * (light_band_node(band, circle, middle, centre - BAND_NODE_D *
                panel) + light_band_node(band, circle, middle, centre + BAND_NODE_D * panel));
        }
    }
    return sum * panel;
}

// Returns the integral of -exp(-t^2) Phi dt over an arc run through in the direction of growing
// angles; `reflex` is 1 for an
// arc longer than half a turn, else 0.
fn light_band_arc(band: LightBand, circle: LightCircle, start: LightAngle, stop: LightAngle, reflex:
    f32) -> f32 {
    let turn = start.c * stop.s - start.s * stop.c;
    let along = start.c * stop.c + start.s * stop.s;
    var sum = 0.0f;
    var at = start;
    let all_round = reflex > 0.0f;
    var falling = start.s > 0.0f || (start.s == 0.0f && start.c > 0.0f);
    let stop_falling = stop.s > 0.0f || (stop.s == 0.0f && stop.c < 0.0f);
    let back = falling == stop_falling && select(stop.c - start.c, start.c - stop.c, falling) <
        0.0f;
    var open = all_round || along <= 0.0f || (turn > 0.0f && !back);
    var ends = !all_round && !back;
    for (var k: u32 = 0; k < 3u; k++) {
        if open && k < 3u {
            let last = falling == stop_falling && ends;
            let corner = LightAngle(select(1.0f, -1.0f, falling), 0.0f);
            let next = LightAngle(select(corner.c, stop.c, last), select(corner.s, stop.s, last));
            sum += light_band_piece(band, circle, at, next);
            at = next;
            falling = !falling;
            ends = true;
            open = !last;
        }
    }
    return sum;
}

// Returns an angle of this cosine and sine, which share a factor.
fn light_angle(c: f32, s: f32) -> LightAngle {
    let size = 1.0f / sqrt(c * c + s * s);
    return LightAngle(c * size, s * size);
}

// Returns the angle of one turned by another, which share a factor.
fn light_turned(c: f32, s: f32, along: f32, aside: f32) -> LightAngle {
    return light_angle(c * along - s * aside, s * along + c * aside);
}

// Returns the integral of exp(-(sigma k xi_t)^2) sinc^2(k W xi_b/2) over the visible part of a
// sphere, dimensionless
// (VWH18 3.4.1, for any place of the light).
//
// `x`, `y`, `z` is the sphere's centre, outside which the shaded point lies.
fn sphere_light(radius: f32, wavelength: f32, width: f32, view_t: f32, view_b: f32, x: f32, y: f32,
    z: f32, sphere_radius: f32) -> f32 {
    let far = sqrt((x * x + y * y) + z * z);
    let sine = min(sphere_radius / far, 1.0f);
    let cosine = sqrt((1.0f - sine) * (1.0f + sine));
    let cx = x / far;
    let cy = y / far;
    let cz = z / far;
    let tilt = sqrt(cy * cy + cz * cz);
    let level = sqrt(cx * cx + cy * cy);
    let flat_b = select(-(cx * cy) / tilt, cx, tilt == 0.0f);
    let flat_n = select(-(cx * cz) / tilt, 0.0f, tilt == 0.0f);
    let side_b = select(cz / tilt, 0.0f, tilt == 0.0f);
    let side_n = select(-cy / tilt, 1.0f, tilt == 0.0f);
    let circle = LightCircle(cosine * cx, cosine * cy, sine * tilt, sine * flat_b, sine * side_b);
    let band = light_band(radius, wavelength, width, view_t, view_b, cosine * cy);
    let highest = sine * level + cosine * cz;
    let lowest = cosine * cz - sine * level;
    let root = sqrt(max(-(lowest * highest), 0.0f));
    let whole = lowest >= 0.0f;
    let down = -(cosine * cz);
    let left = LightAngle(-1.0f, 0.0f);
    let right = LightAngle(1.0f, 0.0f);
    let rise = light_turned(flat_n, side_n, down, -root);
    let setting = light_turned(flat_n, side_n, down, root);
    var sum = 0.0f;
    if whole {
        sum = light_band_piece(band, circle, right, left) + light_band_piece(band, circle, left,
            right);
    } else if highest > 0.0f {
        let horizon = LightCircle(0.0f, 0.0f, 1.0f, 0.0f, 1.0f);
        sum = light_band_arc(band, circle, rise, setting, select(0.0f, 1.0f, down < 0.0f)) +
            light_band_arc(band, horizon, light_turned(cx, cy, cosine, -root), light_turned(cx, cy,
            cosine, root), 0.0f);
    }
    return light_band_scale(wavelength, width) * max(sum, 0.0f);
}

// The outline of a polygon met so far.
struct LightOutline {
    // The integral along it.
    sum: f32,
    // Where it went below the horizon, if it has not come back.
    setting: LightPoint,
    // 1 if it has not, else 0.
    below: f32,
    // Where it came up first.
    rise: LightPoint,
    // 1 if it came up before it went down, else 0.
    risen: f32,
}

// Returns the integral of -exp(-t^2) Phi dt along the visible arc from one point to another.
fn light_outline_arc(band: LightBand, start: LightPoint, stop: LightPoint) -> f32 {
    let dx = stop.x - start.x;
    let dy = stop.y - start.y;
    let dz = stop.z - start.z;
    let nx = start.y * dz - start.z * dy;
    let ny = start.z * dx - start.x * dz;
    let nz = start.x * dy - start.y * dx;
    let tilt = sqrt(ny * ny + nz * nz);
    let size = sqrt((nx * nx + ny * ny) + nz * nz);
    var sum = 0.0f;
    if tilt > 0.0f {
        let circle = LightCircle(0.0f, 0.0f, tilt / size, -(nx / size) * (ny / tilt), nz / tilt);
        let first = light_angle(start.x * size, nz * start.y - ny * start.z);
        let last = light_angle(stop.x * size, nz * stop.y - ny * stop.z);
        sum = light_band_arc(band, circle, first, last, 0.0f);
    }
    return sum;
}

// Returns the outline after one more edge of a polygon.
fn light_outline_edge(outline: LightOutline, band: LightBand, start: LightPoint, stop: LightPoint)
    -> LightOutline {
    var next = outline;
    let crossing = light_horizon(start, stop);
    let up = start.z >= 0.0f;
    let stays = stop.z >= 0.0f;
    let first = LightPoint(select(crossing.x, start.x, up), select(crossing.y, start.y, up),
        select(crossing.z, start.z, up));
    let last = LightPoint(select(crossing.x, stop.x, stays), select(crossing.y, stop.y, stays),
        select(crossing.z, stop.z, stays));
    if up || stays {
        next.sum += light_outline_arc(band, first, last);
    }
    if stays && !up {
        if next.below > 0.0f {
            next.sum += light_outline_arc(band, next.setting, crossing);
            next.below = 0.0f;
        } else {
            next.rise = crossing;
            next.risen = 1.0f;
        }
    }
    if up && !stays {
        next.setting = crossing;
        next.below = 1.0f;
    }
    return next;
}

// Returns an empty outline.
fn light_outline() -> LightOutline {
    let none = LightPoint(0.0f, 0.0f, 0.0f);
    return LightOutline(0.0f, none, 0.0f, none, 0.0f);
}

// Returns the integral along a closed outline.
fn light_outline_closed(outline: LightOutline, band: LightBand) -> f32 {
    var sum = outline.sum;
    if outline.below > 0.0f && outline.risen > 0.0f {
        sum += light_outline_arc(band, outline.setting, outline.rise);
    }
    return abs(sum);
}

// Returns the bitangent component of the direction of a point, or of its projection where it is
// below the horizon.
fn light_bitangent(p: LightPoint) -> f32 {
    let far = sqrt((p.x * p.x + p.y * p.y) + p.z * p.z);
    return select(p.y / far, 0.0f, far == 0.0f);
}

// Returns the integral of exp(-(sigma k xi_t)^2) sinc^2(k W xi_b/2) over the visible part of a
// triangle, dimensionless
// (VWH18 3.4.2, for any place of the light).
//
// The three vertices follow, either way round.
fn triangle_light(radius: f32, wavelength: f32, width: f32, view_t: f32, view_b: f32, ax: f32, ay:
    f32, az: f32, bx: f32, by: f32, bz: f32, cx: f32, cy: f32, cz: f32) -> f32 {
    let a = LightPoint(ax, ay, az);
    let b = LightPoint(bx, by, bz);
    let c = LightPoint(cx, cy, cz);
    let reference = light_bitangent(LightPoint((ax + bx) + cx, (ay + by) + cy, (az + bz) + cz));
    let band = light_band(radius, wavelength, width, view_t, view_b, reference);
    var outline = light_outline_edge(light_outline(), band, a, b);
    outline = light_outline_edge(outline, band, b, c);
    outline = light_outline_edge(outline, band, c, a);
    return light_band_scale(wavelength, width) * light_outline_closed(outline, band);
}

// Returns the integral of exp(-(sigma k xi_t)^2) sinc^2(k W xi_b/2) over the visible part of a
// quadrilateral,
// dimensionless (VWH18 3.4.2, for any place of the light).
//
// The four vertices follow in order, either way round, convex or not.
fn quad_light(radius: f32, wavelength: f32, width: f32, view_t: f32, view_b: f32, ax: f32, ay: f32,
    az: f32, bx: f32, by: f32, bz: f32, cx: f32, cy: f32, cz: f32, dx: f32, dy: f32, dz: f32) -> f32
    {
    let a = LightPoint(ax, ay, az);
    let b = LightPoint(bx, by, bz);
    let c = LightPoint(cx, cy, cz);
    let d = LightPoint(dx, dy, dz);
    let reference = light_bitangent(LightPoint((ax + bx) + (cx + dx), (ay + by) + (cy + dy), (az +
        bz) + (cz + dz)));
    let band = light_band(radius, wavelength, width, view_t, view_b, reference);
    var outline = light_outline_edge(light_outline(), band, a, b);
    outline = light_outline_edge(outline, band, b, c);
    outline = light_outline_edge(outline, band, c, d);
    outline = light_outline_edge(outline, band, d, a);
    return light_band_scale(wavelength, width) * light_outline_closed(outline, band);
}

// Returns the integral of exp(-(sigma k xi_t)^2) sinc^2(k W xi_b/2) over the visible part of a
// polygon of three to eight
// vertices, dimensionless (VWH18 3.4.2, for any place of the light).
//
// `count` is the number of vertices; the vertices follow in order, either way round, convex or not;
// those beyond the
// count are not read.
fn polygon_light(radius: f32, wavelength: f32, width: f32, view_t: f32, view_b: f32, count: f32, ax:
    f32, ay: f32, az: f32, bx: f32, by: f32, bz: f32, cx: f32, cy: f32, cz: f32, dx: f32, dy: f32,
    dz: f32, ex: f32, ey: f32, ez: f32, fx: f32, fy: f32, fz: f32, gx: f32, gy: f32, gz: f32, hx:
    f32, hy: f32, hz: f32) -> f32 {
    let a = LightPoint(ax, ay, az);
    let band = light_band(radius, wavelength, width, view_t, view_b, light_bitangent(a));
    var outline = light_outline();
    var last = a;
    for (var i: u32 = 1; i < 8u; i++) {
        if (f32(i)) < count {
            let x = select(select(select(bx, cx, i == 2u), select(dx, ex, i == 4u), i > 2u),
                select(fx, select(gx, hx, i == 7u), i > 5u), i > 4u);
            let y = select(select(select(by, cy, i == 2u), select(dy, ey, i == 4u), i > 2u),
                select(fy, select(gy, hy, i == 7u), i > 5u), i > 4u);
            let z = select(select(select(bz, cz, i == 2u), select(dz, ez, i == 4u), i > 2u),
                select(fz, select(gz, hz, i == 7u), i > 5u), i > 4u);
            let place = LightPoint(x, y, z);
            outline = light_outline_edge(outline, band, last, place);
            last = place;
        }
    }
    outline = light_outline_edge(outline, band, last, a);
    return light_band_scale(wavelength, width) * light_outline_closed(outline, band);
}
