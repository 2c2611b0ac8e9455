//! The functions of a scratched surface and of its sampling: columns, truths, scales, and what rows are refused.

use super::functions::PLAIN;
use super::scratch_functions::{
    COSINE, LAMBDA, LENGTH, NONE, ORACLE, PROFILE, Refusal, SIGMA, UM, finite, not_negative, positive, refuse,
    refuse_profile,
};
use super::{Function, Oracle, Peak};
use crate::generate::{scratches, surfaces as rows};
use crate::oracle;
use std::f64::consts::{PI, TAU};

const AREA: &str = "um^2";
const WIDTH: &str = "the width is negative";
const INFINITE: &str = "the number is not finite";

/// Radius and wavelength first, the rest finite.
fn refuse_light(row: &[f64]) -> Refusal {
    positive(row, 0, SIGMA)
        .or_else(|| positive(row, 1, LAMBDA))
        .or_else(|| finite(row, 2..row.len(), INFINITE))
}

fn refuse_windowed(row: &[f64]) -> Refusal {
    refuse_light(&row[..9]).or_else(|| not_negative(row, 2, WIDTH))
}

/// The phase of the depth, from width, depth, xi2, gamma_sum, lambda.
fn depth_phase(row: &[f64]) -> f64 {
    TAU * (row[3] * row[1] / row[4]).abs()
}

pub(super) const FUNCTIONS: [Function; 9] = [
    Function {
        name: "spatial_phase_infinite",
        summary: "eta of an infinite scratch at the distance s_b, VWH18 Eq. 8",
        inputs: &[
            ("sigma", UM),
            ("lambda", UM),
            ("xi1", COSINE),
            ("xi2", COSINE),
            ("s_b", UM),
        ],
        outputs: LENGTH,
        oracle: Oracle::Complex(oracle::spatial_phase_infinite),
        oracle_name: ORACLE,
        peak: Some(Peak {
            of: |row| TAU.sqrt() * row[0],
            words: "sqrt(2 pi) sigma",
            largest: None,
        }),
        refuse: refuse_light,
        timed: Some(rows::INFINITE_PHASE_F32),
        thinning: 10,
    },
    Function {
        name: "depth_term",
        summary: "1 - exp(2 pi i gamma_sum D/lambda), WVJH17 Eq. 20",
        inputs: &[("depth", UM), ("gamma_sum", COSINE), ("lambda", UM)],
        outputs: &[("re", NONE), ("im", NONE)],
        oracle: Oracle::Complex(oracle::depth_term),
        oracle_name: ORACLE,
        refuse: |row| finite(row, 0..2, INFINITE).or_else(|| positive(row, 2, LAMBDA)),
        timed: Some(rows::DEPTH_F32),
        thinning: 10,
        ..PLAIN
    },
    Function {
        name: "response_triangle",
        summary: "W sinc(pi W xi2/lambda) less the transform of a triangular groove",
        inputs: PROFILE,
        outputs: LENGTH,
        oracle: Oracle::Complex(oracle::response_triangle),
        oracle_name: ORACLE,
        peak: Some(Peak {
            of: |row| row[0] * depth_phase(row).min(1.0),
            words: "the width times the depth's phase, at most 1",
            largest: None,
        }),
        refuse: refuse_profile,
        timed: Some(scratches::PROFILE_F32),
        thinning: 10,
    },
    Function {
        name: "response_rectangle_windowed",
        summary: "the response of a rectangular scratch with the window across it as well",
        inputs: &[
            ("sigma", UM),
            ("lambda", UM),
            ("width", UM),
            ("depth", UM),
            ("xi1", COSINE),
            ("xi2", COSINE),
            ("gamma_sum", COSINE),
            ("s_t", UM),
            ("s_b", UM),
            ("l1", UM),
            ("l2", UM),
        ],
        outputs: &[("re", AREA), ("im", AREA)],
        oracle: Oracle::Complex(oracle::response_rectangle_windowed),
        oracle_name: ORACLE,
        peak: Some(Peak {
            of: |row| 2.0 * TAU * row[0] * row[0],
            words: "4 pi sigma^2",
            largest: None,
        }),
        refuse: refuse_windowed,
        timed: Some(rows::WINDOWED),
        thinning: 20,
    },
    Function {
        name: "base_response",
        summary: "2 pi sigma^2 exp(-(sigma k |xi|)^2/2), WVJH17 Eq. 16",
        inputs: &[("sigma", UM), ("lambda", UM), ("xi1", COSINE), ("xi2", COSINE)],
        outputs: &[("response", AREA)],
        oracle: Oracle::Real(oracle::base_response),
        oracle_name: ORACLE,
        peak: Some(Peak {
            of: |row| TAU * row[0] * row[0],
            words: "2 pi sigma^2",
            largest: None,
        }),
        refuse: refuse_light,
        timed: Some(rows::BASE_F32),
        thinning: 10,
    },
    Function {
        name: "scratch_squared",
        summary: "the mean |S|^2 of an infinite rectangular scratch over a footprint of this mean, VWH18 Eqs. 9 to 11",
        inputs: &[
            ("sigma", UM),
            ("lambda", UM),
            ("width", UM),
            ("depth", UM),
            ("xi1", COSINE),
            ("xi2", COSINE),
            ("gamma_sum", COSINE),
            ("mean", NONE),
        ],
        outputs: &[("squared", "um^4")],
        oracle: Oracle::Real(oracle::scratch_squared),
        oracle_name: ORACLE,
        peak: Some(Peak {
            of: |row| 4.0 * TAU * (row[0] * row[2]).powi(2) * row[7],
            words: "8 pi sigma^2 W^2 times the mean",
            largest: None,
        }),
        refuse: |row| refuse_light(row).or_else(|| not_negative(row, 2, WIDTH)),
        timed: Some(rows::SCRATCH_F32),
        thinning: 10,
    },
    Function {
        name: "area_density",
        summary: "W/(sqrt(pi) sigma) exp(-(s_b/sigma)^2), the share of one scratch with the kernel of the energy",
        inputs: &[("width", UM), ("offset", UM), ("sigma", UM)],
        outputs: &[("share", NONE)],
        oracle: Oracle::Real(oracle::area_density),
        oracle_name: ORACLE,
        peak: Some(Peak {
            of: |row| row[0] / (PI.sqrt() * row[2]),
            words: "the share at the window's centre",
            largest: None,
        }),
        refuse: |row| {
            not_negative(row, 0, WIDTH)
                .or_else(|| finite(row, 0..2, INFINITE))
                .or_else(|| positive(row, 2, SIGMA))
        },
        timed: Some(rows::DENSITY_F32),
        thinning: 10,
    },
    Function {
        name: "gaussian_inverse",
        summary: "the y at which the integral of exp(-t^2)/sqrt(pi) from -infinity to y is u",
        inputs: &[("u", NONE)],
        outputs: &[("y", NONE)],
        oracle: Oracle::Real(|row| oracle::gaussian_inverse(row[0])),
        oracle_name: ORACLE,
        refuse: |row| refuse(row, 0, |u| (0.0..=1.0).contains(&u), "u is not a probability"),
        timed: Some(rows::GAUSSIAN_U_F32),
        thinning: 20,
        ..PLAIN
    },
    Function {
        name: "von_mises_fisher_pdf",
        summary: "kappa/(4 pi sinh kappa) exp(kappa cos), a density on the sphere",
        inputs: &[("concentration", NONE), ("cosine", NONE)],
        outputs: &[("density", "1/sr")],
        oracle: Oracle::Real(oracle::von_mises_fisher_pdf),
        oracle_name: ORACLE,
        peak: Some(Peak {
            of: |row| oracle::von_mises_fisher_pdf(&[row[0], 1.0]).value(),
            words: "the density on the axis",
            largest: None,
        }),
        refuse: |row| {
            let concentration = |x: f64| (0.0..f64::INFINITY).contains(&x);
            refuse(row, 0, concentration, "the concentration is negative or infinite")
                .or_else(|| refuse(row, 1, |x| x.abs() <= 1.0, "the cosine is beyond 1"))
        },
        timed: Some(rows::CONE),
        thinning: 10,
    },
];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rows_out_of_the_domain_are_refused_by_column_and_ends_may_be_infinite() {
        let inf = f64::INFINITY;
        let windowed = [60.0, 0.5, 3.0, 0.2, 0.1, 0.1, 1.8, 0.0, 0.0, -inf, inf];
        assert_eq!(refuse_windowed(&windowed), None);
        for (column, wrong) in [(0, 0.0), (1, -0.5), (2, -1.0), (5, inf), (8, inf)] {
            let mut row = windowed;
            row[column] = wrong;
            assert_eq!(refuse_windowed(&row).map(|r| r.0), Some(column));
        }
        assert_eq!(refuse_light(&[f64::NAN; 5]), None);
    }
}
