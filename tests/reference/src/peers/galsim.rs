//! Si by the Pade approximants of Rowe et al., GalSim: the modular galaxy image simulation toolkit, Astronomy and
//! Computing 10 (2015), arXiv:1407.7676, appendix B: x R(x^2) up to 4, pi/2 - f cos x - g sin x beyond, with rational
//! f and g in 1/x^2. Constants as printed there.
#![allow(clippy::excessive_precision, reason = "the digits as printed")]

macro_rules! pade_form {
    ($name:ident, $real:ident, $half_pi:expr) => {
        /// Si(x) in this precision.
        pub fn $name(x: $real) -> $real {
            let horner = |c: &[f64], z: $real| c.iter().rev().fold(0.0, |sum: $real, &c| c as $real + z * sum);
            let size = x.abs();
            let value = if size <= 4.0 {
                let z = size * size;
                return x * horner(&SI_ABOVE, z) / horner(&SI_BELOW, z);
            } else if size.is_infinite() {
                $half_pi
            } else {
                let z = 1.0 / (size * size);
                let f = horner(&F_ABOVE, z) / horner(&F_BELOW, z) / size;
                let g = z * horner(&G_ABOVE, z) / horner(&G_BELOW, z);
                $half_pi - f * size.cos() - g * size.sin()
            };
            if x < 0.0 { -value } else { value }
        }
    };
}

pade_form!(sine_integral, f64, std::f64::consts::FRAC_PI_2);
pade_form!(sine_integral_f32, f32, std::f32::consts::FRAC_PI_2);

const SI_ABOVE: [f64; 8] = [
    1.0,
    -4.54393409816329991e-2,
    1.15457225751016682e-3,
    -1.41018536821330254e-5,
    9.43280809438713025e-8,
    -3.53201978997168357e-10,
    7.08240282274875911e-13,
    -6.05338212010422477e-16,
];
const SI_BELOW: [f64; 7] = [
    1.0,
    1.01162145739225565e-2,
    4.99175116169755106e-5,
    1.55654986308745614e-7,
    3.28067571055789734e-10,
    4.5049097575386581e-13,
    3.21107051193712168e-16,
];
const F_ABOVE: [f64; 11] = [
    1.0,
    7.44437068161936700618e2,
    1.96396372895146869801e5,
    2.37750310125431834034e7,
    1.43073403821274636888e9,
    4.33736238870432522765e10,
    6.40533830574022022911e11,
    4.20968180571076940208e12,
    1.00795182980368574617e13,
    4.94816688199951963482e12,
    -4.94701168645415959931e11,
];
const F_BELOW: [f64; 10] = [
    1.0,
    7.46437068161927678031e2,
    1.97865247031583951450e5,
    2.41535670165126845144e7,
    1.47478952192985464958e9,
    4.58595115847765779830e10,
    7.08501308149515401563e11,
    5.06084464593475076774e12,
    1.43468549171581016479e13,
    1.11535493509914254097e13,
];
const G_ABOVE: [f64; 11] = [
    1.0,
    8.1359520115168615e2,
    2.35239181626478200e5,
    3.12557570795778731e7,
    2.06297595146763354e9,
    6.83052205423625007e10,
    1.09049528450362786e12,
    7.57664583257834349e12,
    1.81004487464664575e13,
    6.43291613143049485e12,
    -1.36517137670871689e12,
];
const G_BELOW: [f64; 10] = [
    1.0,
    8.19595201151451564e2,
    2.40036752835578777e5,
    3.26026661647090822e7,
    2.23355543278099360e9,
    7.87465017341829930e10,
    1.39866710696414565e12,
    1.17164723371736605e13,
    4.01839087307656620e13,
    3.99653257887490811e13,
];
