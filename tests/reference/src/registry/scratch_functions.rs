//! The functions of scratches: columns, truths, scales, and what rows are refused.

use super::functions::PLAIN;
use super::{Function, Oracle, Peak};
use crate::generate::{footprints, scratches as rows};
use crate::oracle;
use crate::peers::bessel::{bessel_i0_scaled_cephes, bessel_i1_i0_ratio_cephes};
use std::f64::consts::{PI, TAU};

pub(super) const UM: &str = "um";
pub(super) const COSINE: &str = "direction cosine";
pub(super) const NONE: &str = "dimensionless";
pub(super) const LENGTH: &[(&str, &str)] = &[("re", UM), ("im", UM)];
pub(super) const PROFILE: &[(&str, &str)] = &[
    ("width", UM),
    ("depth", UM),
    ("xi2", COSINE),
    ("gamma_sum", COSINE),
    ("lambda", UM),
];
pub(super) const ORACLE: &str = "double-double, 20 to 28 digits, held against arbitrary precision";

/// What is wrong with a row.
pub(super) type Refusal = Option<(usize, &'static str)>;

/// Refuses a column that fails a test; not a number passes.
pub(super) fn refuse(row: &[f64], column: usize, holds: fn(f64) -> bool, reason: &'static str) -> Refusal {
    (!row[column].is_nan() && !holds(row[column])).then_some((column, reason))
}

pub(super) fn positive(row: &[f64], column: usize, reason: &'static str) -> Refusal {
    refuse(row, column, |x| x > 0.0 && x < f64::INFINITY, reason)
}

pub(super) fn not_negative(row: &[f64], column: usize, reason: &'static str) -> Refusal {
    refuse(row, column, |x| x >= 0.0, reason)
}

pub(super) const SIGMA: &str = "the coherence radius sigma is not a positive length";
pub(super) const LAMBDA: &str = "the wavelength lambda is not a positive length";

pub(super) fn finite(row: &[f64], columns: std::ops::Range<usize>, reason: &'static str) -> Refusal {
    let infinite = columns.clone().find(|&i| row[i].is_infinite());
    infinite.map(|column| (column, reason))
}

pub(super) fn refuse_profile(row: &[f64]) -> Refusal {
    let width = refuse(
        row,
        0,
        |x| (0.0..f64::INFINITY).contains(&x),
        "the width is not a length",
    );
    width
        .or_else(|| finite(row, 1..4, "the number is not finite"))
        .or_else(|| positive(row, 4, LAMBDA))
}

fn refuse_phase(row: &[f64]) -> Refusal {
    positive(row, 0, SIGMA)
        .or_else(|| positive(row, 1, LAMBDA))
        .or_else(|| {
            finite(
                row,
                2..6,
                "the number is not finite: only the ends l1 and l2 may be infinite",
            )
        })
}

fn refuse_footprint(row: &[f64]) -> Refusal {
    not_negative(row, 0, "the half axis a1 is negative")
        .or_else(|| not_negative(row, 1, "the half axis a2 is negative"))
        .or_else(|| refuse(row, 2, |x| x.abs() <= 1.0, "the cosine is beyond 1"))
        .or_else(|| positive(row, 4, SIGMA))
}

fn refuse_energy(row: &[f64]) -> Refusal {
    positive(row, 0, SIGMA)
        .or_else(|| positive(row, 1, LAMBDA))
        .or_else(|| finite(row, 2..3, "the number is not finite"))
        .or_else(|| not_negative(row, 3, "the length is negative"))
}

/// M(H, 0) = exp(-x) (I0 + I1)(x), x = H^2/2: the largest mean of a half width.
pub(super) fn mean_at_centre(half_width: f64) -> f64 {
    let x = 0.5 * half_width * half_width;
    if x > 1e8 {
        return 2.0 / (PI.sqrt() * half_width);
    }
    bessel_i0_scaled_cephes(x) * (1.0 + bessel_i1_i0_ratio_cephes(x))
}

/// H of a footprint: a1, a2, cos_phi, offset, sigma.
fn half_width(row: &[f64]) -> f64 {
    let sine = ((1.0 - row[2]) * (1.0 + row[2])).max(0.0).sqrt();
    (row[0] * sine).hypot(row[1] * row[2]) / row[4]
}

/// pi sigma^2 L min(L, 2 sqrt(pi) sigma): the energy at xi1 = 0 of short and of long segments.
fn energy_scale(row: &[f64]) -> f64 {
    PI * row[0] * row[0] * row[3] * row[3].min(2.0 * PI.sqrt() * row[0])
}

/// The width of a profile.
const WIDTH: Option<Peak> = Some(Peak {
    of: |row| row[0],
    words: "the width",
    largest: None,
});

pub(super) const FUNCTIONS: [Function; 8] = [
    Function {
        name: "spatial_phase",
        summary: "eta of a scratch from l1 to l2 whose origin lies at (s_t, s_b), VWH18 Eq. 5",
        inputs: &[
            ("sigma", UM),
            ("lambda", UM),
            ("xi1", COSINE),
            ("xi2", COSINE),
            ("s_t", UM),
            ("s_b", UM),
            ("l1", UM),
            ("l2", UM),
        ],
        outputs: LENGTH,
        oracle: Oracle::Complex(oracle::spatial_phase),
        oracle_name: ORACLE,
        peak: Some(Peak {
            of: |row| TAU.sqrt() * row[0],
            words: "sqrt(2 pi) sigma",
            largest: None,
        }),
        refuse: refuse_phase,
        timed: Some(rows::SPATIAL_PHASE_F32),
        thinning: 20,
    },
    Function {
        name: "profile_rectangle",
        summary: "W sinc(pi W xi2/lambda) (1 - exp(2 pi i gamma_sum D/lambda))",
        inputs: PROFILE,
        outputs: LENGTH,
        oracle: Oracle::Complex(oracle::profile_rectangle),
        oracle_name: ORACLE,
        peak: WIDTH,
        refuse: refuse_profile,
        timed: Some(rows::PROFILE_F32),
        thinning: 10,
    },
    Function {
        name: "profile_triangle",
        summary: "the integral of exp(2 pi i gamma_sum (D/lambda)(1 - 2|b|/W) - 2 pi i b xi2/lambda) over |b| <= W/2",
        inputs: PROFILE,
        outputs: LENGTH,
        oracle: Oracle::Complex(oracle::profile_triangle),
        oracle_name: ORACLE,
        peak: WIDTH,
        refuse: refuse_profile,
        timed: Some(rows::PROFILE_F32),
        thinning: 10,
    },
    Function {
        name: "footprint_mean",
        summary: "the mean over an ellipse of exp(-s_b^2/sigma^2), cos_phi between a1 and the scratch",
        inputs: &[("a1", UM), ("a2", UM), ("cos_phi", NONE), ("offset", UM), ("sigma", UM)],
        outputs: &[("mean", NONE)],
        oracle: Oracle::Real(oracle::footprint_mean),
        oracle_name: ORACLE,
        peak: Some(Peak {
            of: |row| mean_at_centre(half_width(row)),
            words: "the mean at the centre",
            largest: Some(1.0),
        }),
        refuse: refuse_footprint,
        timed: Some(footprints::FOOTPRINT),
        thinning: 20,
    },
    Function {
        name: "footprint_mean_reduced",
        summary: "M(H, C), the integral of (2/pi) sqrt(1 - t^2) exp(-(H t - C)^2) from -1 to 1",
        inputs: &[("half_width", "coherence radii"), ("offset", "coherence radii")],
        outputs: &[("mean", NONE)],
        oracle: Oracle::Real(oracle::footprint_mean_reduced),
        oracle_name: ORACLE,
        peak: Some(Peak {
            of: |row| mean_at_centre(row[0]),
            words: "the mean at the centre",
            largest: Some(1.0),
        }),
        refuse: |row| not_negative(row, 0, "the half width is negative"),
        timed: Some(footprints::FOOTPRINT_REDUCED),
        thinning: 20,
    },
    Function {
        name: "footprint_mean_reduced_edge",
        summary: "M(H, C) by the half width and the distance H - |C| from the edge",
        inputs: &[("half_width", "coherence radii"), ("edge", "coherence radii")],
        outputs: &[("mean", NONE)],
        oracle: Oracle::Real(oracle::footprint_mean_reduced_edge),
        oracle_name: ORACLE,
        peak: Some(Peak {
            of: |row| mean_at_centre(row[0]),
            words: "the mean at the centre",
            largest: Some(1.0),
        }),
        refuse: |row| {
            not_negative(row, 0, "the half width is negative").or_else(|| {
                let beyond = row[1] > row[0];
                beyond.then_some((1, "the distance from the edge is larger than the half width"))
            })
        },
        timed: Some(footprints::FOOTPRINT_REDUCED_F32),
        thinning: 20,
    },
    Function {
        name: "segment_energy",
        summary: "the integral of |eta|^2 over all places of the window, of a segment of a length",
        inputs: &[("sigma", UM), ("lambda", UM), ("xi1", COSINE), ("length", UM)],
        outputs: &[("energy", "um^4")],
        oracle: Oracle::Real(oracle::segment_energy),
        oracle_name: ORACLE,
        peak: Some(Peak {
            of: energy_scale,
            words: "pi sigma^2 L min(L, 2 sqrt(pi) sigma)",
            largest: None,
        }),
        refuse: refuse_energy,
        timed: Some(rows::SEGMENT_ENERGY),
        thinning: 20,
    },
    Function {
        name: "sinc_squared_inverse",
        summary: "the x at which the integral of sinc^2/pi from -infinity to x is u",
        inputs: &[("u", NONE)],
        outputs: &[("x", "rad")],
        oracle: Oracle::Real(|row| oracle::sinc_squared_inverse(row[0])),
        oracle_name: ORACLE,
        refuse: |row| refuse(row, 0, |u| (0.0..=1.0).contains(&u), "u is not a probability"),
        timed: Some(super::scratches::PROBABILITIES),
        thinning: 100,
        ..PLAIN
    },
];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_mean_at_the_centre_has_its_limits() {
        assert_eq!(mean_at_centre(0.0), 1.0);
        for h in [1.0, 30.0, 1.41e4, 1.42e4, 1e9] {
            let truth = oracle::footprint_mean_reduced(&[h, 0.0]).value();
            assert!((mean_at_centre(h) / truth - 1.0).abs() < 1e-6, "{h}: {truth}");
        }
    }

    #[test]
    fn the_scale_of_the_energy_is_its_value_at_normal_for_short_and_long_segments() {
        for length in [1e-3, 1e5] {
            let row = [10.0, 0.5, 0.0, length];
            let ratio = oracle::segment_energy(&row).value() / energy_scale(&row);
            assert!((ratio - 1.0).abs() < 1e-3, "{length}: {ratio}");
        }
    }

    #[test]
    fn rows_out_of_the_domain_are_refused_by_column_and_not_a_number_passes() {
        let nan = f64::NAN;
        let inf = f64::INFINITY;
        assert_eq!(refuse_phase(&[60.0, 0.5, 0.1, 0.1, 0.0, 0.0, -inf, inf]), None);
        assert_eq!(refuse_phase(&[nan; 8]), None);
        for (row, column) in [
            ([0.0, 0.5, 0.1, 0.1, 0.0, 0.0, -1.0, 1.0], 0),
            ([1.0, -0.5, 0.1, 0.1, 0.0, 0.0, -1.0, 1.0], 1),
            ([1.0, 0.5, 0.1, inf, 0.0, 0.0, -1.0, 1.0], 3),
        ] {
            assert_eq!(refuse_phase(&row).map(|r| r.0), Some(column), "{row:?}");
        }
        assert_eq!(refuse_footprint(&[1.0, 1.0, 1.0000001, 0.0, 1.0]).map(|r| r.0), Some(2));
        assert_eq!(refuse_profile(&[-1.0, 0.1, 0.0, 2.0, 0.5]).map(|r| r.0), Some(0));
        assert_eq!(refuse_profile(&[0.0, 0.0, 0.0, 2.0, 0.5]), None);
    }
}
