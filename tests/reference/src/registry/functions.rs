//! The functions, their columns and their truths.

use super::Function;
use crate::oracle;

const NONE: &str = "dimensionless";
const RADIANS: &str = "rad";
const ORACLE: &str = "double-double, about 30 digits, held against arbitrary precision and Arb";

pub(super) static FUNCTIONS: [Function; 3] = [
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
];
