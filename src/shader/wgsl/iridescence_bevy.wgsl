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

// Returns the integral of (sin t / t)^2 from q0 to q1 (radians), to f32 grade.
//
// Never negative for q0 <= q1, antisymmetric in its bounds, even in their signs. The phase is exact
// to 1e-7 for
// |q| to 1e4. VWH18 Eq. 27.
fn sinc_squared_integral(first: f32, last: f32) -> f32 {
    let ends = arc_ends(first, last);
    let near = reduce_half_turns(min(ends.near, ARC_PHASE_LIMIT));
    let far = reduce_half_turns(min(ends.far, ARC_PHASE_LIMIT));
    let value = arc_of_phases(ends, ends.far - ends.near, near.rest, far.rest);
    let signed = select(value, -value, last < first);
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
