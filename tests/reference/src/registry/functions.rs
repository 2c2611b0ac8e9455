//! The functions, their columns and their truths.

use super::Function;
use crate::oracle;

const NONE: &str = "dimensionless";
const RADIANS: &str = "rad";
const ELEMENTARY: &str = "double-double, about 30 digits, held against arbitrary precision";
const ORACLE: &str = "double-double, about 30 digits, held against arbitrary precision and Arb";

pub(super) static FUNCTIONS: [Function; 7] = [
    Function {
        name: "sine_integral",
        summary: "Si(x), the integral of sin t/t from 0 to x",
        inputs: &[("x", RADIANS)],
        outputs: &[("Si", NONE)],
        oracle: |row| oracle::sine_integral(row[0]),
        oracle_name: ORACLE,
    },
    Function {
        name: "sinc_squared_integral",
        summary: "the integral of (sin t/t)^2 from q0 to q1",
        inputs: &[("q0", RADIANS), ("q1", RADIANS)],
        outputs: &[("integral", NONE)],
        oracle: |row| oracle::sinc_squared_integral(row[0], row[1]),
        oracle_name: ORACLE,
    },
    Function {
        name: "sinc",
        summary: "sin x/x",
        inputs: &[("x", RADIANS)],
        outputs: &[("sinc", NONE)],
        oracle: |row| oracle::sinc(row[0]),
        oracle_name: ORACLE,
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
        oracle: |row| oracle::sinc_squared_integral_turns(row[0], row[1], row[2]),
        oracle_name: ELEMENTARY,
    },
    Function {
        name: "sine",
        summary: "sin x",
        inputs: &[("x", RADIANS)],
        outputs: &[("sine", NONE)],
        oracle: |row| oracle::sine(row[0]),
        oracle_name: ELEMENTARY,
    },
    Function {
        name: "cosine",
        summary: "cos x",
        inputs: &[("x", RADIANS)],
        outputs: &[("cosine", NONE)],
        oracle: |row| oracle::cosine(row[0]),
        oracle_name: ELEMENTARY,
    },
    Function {
        name: "exponential",
        summary: "e to the x",
        inputs: &[("x", NONE)],
        outputs: &[("exponential", NONE)],
        oracle: |row| oracle::exponential(row[0]),
        oracle_name: ELEMENTARY,
    },
];
