//! The functions, their columns and their truths.

use super::{Function, Oracle, Peak, erf_difference, error_function};
use crate::generate::points;
use crate::oracle;

const NONE: &str = "dimensionless";
const PLANE: &[(&str, &str)] = &[("re", NONE), ("im", NONE)];
const RADIANS: &str = "rad";
const ELEMENTARY: &str = "double-double, about 30 digits, held against arbitrary precision";
const ORACLE: &str = "double-double, about 30 digits, held against arbitrary precision and Arb";

/// A function of nothing in particular, for the fields that most functions share.
pub(super) const PLAIN: Function = Function {
    name: "",
    summary: "",
    inputs: &[],
    outputs: &[],
    oracle: Oracle::Real(|_| crate::metrics::Reference::exact(f64::NAN)),
    oracle_name: "",
    peak: None,
    refuse: |_| None,
    timed: None,
    thinning: 1,
};

pub(super) const FUNCTIONS: [Function; 17] = [
    Function {
        name: "sine_integral",
        summary: "Si(x), the integral of sin t/t from 0 to x",
        inputs: &[("x", RADIANS)],
        outputs: &[("Si", NONE)],
        oracle: Oracle::Real(|row| oracle::sine_integral(row[0])),
        oracle_name: ORACLE,
        ..PLAIN
    },
    Function {
        name: "sinc_squared_integral",
        summary: "the integral of (sin t/t)^2 from q0 to q1",
        inputs: &[("q0", RADIANS), ("q1", RADIANS)],
        outputs: &[("integral", NONE)],
        oracle: Oracle::Real(|row| oracle::sinc_squared_integral(row[0], row[1])),
        oracle_name: ORACLE,
        ..PLAIN
    },
    Function {
        name: "sinc",
        summary: "sin x/x",
        inputs: &[("x", RADIANS)],
        outputs: &[("sinc", NONE)],
        oracle: Oracle::Real(|row| oracle::sinc(row[0])),
        oracle_name: ORACLE,
        ..PLAIN
    },
    Function {
        name: "sinc_squared_integral_turns",
        summary: "the integral of (sin t/t)^2 from pi width xi0 to pi width xi1",
        inputs: &[
            ("width", "wavelengths"),
            ("xi0", "direction cosine"),
            ("xi1", "direction cosine"),
        ],
        outputs: &[("integral", NONE)],
        oracle: Oracle::Real(|row| oracle::sinc_squared_integral_turns(row[0], row[1], row[2])),
        oracle_name: ELEMENTARY,
        ..PLAIN
    },
    Function {
        name: "sine",
        summary: "sin x",
        inputs: &[("x", RADIANS)],
        outputs: &[("sine", NONE)],
        oracle: Oracle::Real(|row| oracle::sine(row[0])),
        oracle_name: ELEMENTARY,
        ..PLAIN
    },
    Function {
        name: "cosine",
        summary: "cos x",
        inputs: &[("x", RADIANS)],
        outputs: &[("cosine", NONE)],
        oracle: Oracle::Real(|row| oracle::cosine(row[0])),
        oracle_name: ELEMENTARY,
        ..PLAIN
    },
    Function {
        name: "exponential",
        summary: "e to the x",
        inputs: &[("x", NONE)],
        outputs: &[("exponential", NONE)],
        oracle: Oracle::Real(|row| oracle::exponential(row[0])),
        oracle_name: ELEMENTARY,
        ..PLAIN
    },
    Function {
        name: "faddeeva_w",
        summary: "w(z) = exp(-z^2) erfc(-iz), z = re + i im",
        inputs: PLANE,
        outputs: PLANE,
        oracle: Oracle::Complex(|z| oracle::faddeeva_w(z[0], z[1])),
        oracle_name: ORACLE,
        thinning: 10,
        ..PLAIN
    },
    Function {
        name: "erf_complex",
        summary: "erf(z), z = re + i im",
        inputs: PLANE,
        outputs: PLANE,
        oracle: Oracle::Complex(|z| oracle::erf_complex(z[0], z[1])),
        oracle_name: ORACLE,
        thinning: 10,
        ..PLAIN
    },
    Function {
        name: "erf_difference_scaled",
        summary: "exp(-b^2) [erf(a2 + ib) - erf(a1 + ib)]",
        inputs: &[("a1", NONE), ("a2", NONE), ("b", NONE)],
        outputs: PLANE,
        oracle: Oracle::Complex(|a| oracle::erf_difference_scaled(a[0], a[1], a[2])),
        oracle_name: ORACLE,
        peak: Some(Peak {
            of: erf_difference::peak,
            words: "the value at b = 0",
            largest: Some(2.0),
        }),
        thinning: 10,
        ..PLAIN
    },
    Function {
        name: "bessel_i0_scaled",
        summary: "exp(-|x|) I0(x)",
        inputs: &[("x", NONE)],
        outputs: &[("I0e", NONE)],
        oracle: Oracle::Real(|row| oracle::bessel_i0_scaled(row[0])),
        oracle_name: ORACLE,
        timed: Some(points::BESSEL_LINE_F32),
        thinning: 4,
        ..PLAIN
    },
    Function {
        name: "erf",
        summary: "erf(x) of a real argument",
        inputs: &[("x", NONE)],
        outputs: &[("erf", NONE)],
        oracle: Oracle::Real(|row| oracle::erf_complex(row[0], 0.0)[0]),
        oracle_name: ORACLE,
        timed: Some(error_function::ERF_TIMING),
        thinning: 10,
        ..PLAIN
    },
    Function {
        name: "erfc_complex",
        summary: "erfc(z) = 1 - erf(z), z = re + i im",
        inputs: PLANE,
        outputs: PLANE,
        oracle: Oracle::Complex(|z| oracle::erfc_complex(z[0], z[1])),
        oracle_name: ORACLE,
        thinning: 20,
        ..PLAIN
    },
    Function {
        name: "erfcx",
        summary: "exp(x^2) erfc(x)",
        inputs: &[("x", NONE)],
        outputs: &[("erfcx", NONE)],
        oracle: Oracle::Real(|row| oracle::erfcx(row[0])),
        oracle_name: ORACLE,
        timed: Some(points::BESSEL_LINE_F32),
        thinning: 20,
        ..PLAIN
    },
    Function {
        name: "faddeeva_w_derivative",
        summary: "w'(z) = 2i/sqrt(pi) - 2 z w(z), z = re + i im",
        inputs: PLANE,
        outputs: PLANE,
        oracle: Oracle::Complex(|z| oracle::faddeeva_w_derivative(z[0], z[1])),
        oracle_name: ORACLE,
        thinning: 20,
        ..PLAIN
    },
    Function {
        name: "log_bessel_i0",
        summary: "log I0(x)",
        inputs: &[("x", NONE)],
        outputs: &[("log I0", NONE)],
        oracle: Oracle::Real(|row| oracle::log_bessel_i0(row[0])),
        oracle_name: ORACLE,
        timed: Some(points::BESSEL_LINE_F32),
        thinning: 20,
        ..PLAIN
    },
    Function {
        name: "bessel_i1_i0_ratio",
        summary: "I1(x)/I0(x)",
        inputs: &[("x", NONE)],
        outputs: &[("ratio", NONE)],
        oracle: Oracle::Real(|row| oracle::bessel_i1_i0_ratio(row[0])),
        oracle_name: ORACLE,
        timed: Some(points::BESSEL_LINE_F32),
        thinning: 20,
        ..PLAIN
    },
];
