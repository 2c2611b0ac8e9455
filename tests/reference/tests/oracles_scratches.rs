//! The oracles of the scratch functions against certified digits, and their limits and symmetries.

use reference::generate::scratches;
use reference::golden::{self, ComplexRow, Row};
use reference::metrics::Reference;
use reference::oracle;
use reference::oracle::double_double::Dd;

/// Difference of an oracle from a certified value, over the larger of that value and the row's own scale.
fn real_error(value: &Reference, truth: &Reference) -> f64 {
    if value.hi == truth.hi && value.exponent == truth.exponent && value.lo == truth.lo {
        return 0.0;
    }
    if truth.hi == 0.0 || truth.hi.is_infinite() || !value.hi.is_finite() {
        return f64::INFINITY;
    }
    value.relative_difference(truth)
}

/// |value - truth| over `size`, or over |truth| where no size is given.
fn complex_error(value: &[Reference; 2], truth: &[Reference; 2], size: Option<f64>) -> f64 {
    if value.iter().chain(truth).all(is_nothing) {
        return 0.0;
    }
    let top = truth.iter().filter(|part| part.hi != 0.0).map(binade).max();
    let Some(top) = top else {
        let worst = value.iter().map(|part| part.value().abs()).fold(0.0, f64::max);
        return if worst == 0.0 { 0.0 } else { worst / size.unwrap_or(0.0) };
    };
    let part = |k: usize| {
        let (a, b) = (&value[k], &truth[k]);
        let move_to = |x: f64, exponent: i32| x * 2f64.powi((exponent - top).clamp(-1000, 1000));
        let high = move_to(a.hi, a.exponent) - move_to(b.hi, b.exponent);
        high + (move_to(a.lo, a.exponent) - move_to(b.lo, b.exponent))
    };
    let difference = part(0).hypot(part(1));
    match size {
        Some(size) => difference * 2f64.powi(top) / size,
        None => difference,
    }
}

/// Whether a number is zero or far below every format.
fn is_nothing(part: &Reference) -> bool {
    part.hi == 0.0 || part.exponent < -20_000
}

fn binade(part: &Reference) -> i32 {
    part.exponent + ((part.hi.to_bits() >> 52) & 0x7FF) as i32 - 1023
}

fn hold_real(name: &str, rows: Vec<Row>, oracle: fn(&[f64]) -> Reference, agreement: f64) {
    assert!(rows.len() >= 80, "{name}");
    let mut worst = (0.0, vec![]);
    for Row { inputs, truth, .. } in rows {
        let value = oracle(&inputs);
        let error = real_error(&value, &truth);
        if error > worst.0 {
            worst = (error, inputs.clone());
        }
        assert!(
            error < agreement,
            "{name} {inputs:?}: {value:?}, certified {truth:?}, {error:e}"
        );
    }
    println!("{name}: {:.1e} at {:?}", worst.0, worst.1);
}

fn hold_complex(
    name: &str,
    rows: Vec<ComplexRow>,
    oracle: fn(&[f64]) -> [Reference; 2],
    size: fn(&[f64]) -> Option<f64>,
    agreement: f64,
) {
    assert!(rows.len() >= 200, "{name}");
    let mut worst = (0.0, vec![]);
    for ComplexRow { inputs, truth } in rows {
        let value = oracle(&inputs);
        let error = complex_error(&value, &truth, size(&inputs));
        if error > worst.0 {
            worst = (error, inputs.clone());
        }
        assert!(
            error < agreement,
            "{name} {inputs:?}: {value:?}, certified {truth:?}, {error:e}"
        );
    }
    println!("{name}: {:.1e} at {:?}", worst.0, worst.1);
}

#[test]
fn the_oracle_of_the_spatial_phase_gives_the_certified_digits() {
    hold_complex(
        "spatial phase",
        golden::spatial_phase(),
        oracle::spatial_phase,
        |_| None,
        1e-25,
    );
}

#[test]
fn the_oracles_of_the_profiles_give_the_certified_digits() {
    hold_complex(
        "rectangle",
        golden::profile_rectangle(),
        oracle::profile_rectangle,
        |row| Some(row[0]),
        1e-30,
    );
    hold_complex(
        "triangle",
        golden::profile_triangle(),
        oracle::profile_triangle,
        |row| Some(row[0]),
        1e-30,
    );
}

#[test]
fn the_oracles_of_the_footprint_mean_give_the_certified_digits() {
    hold_real(
        "footprint, reduced",
        golden::footprint_mean_reduced(),
        oracle::footprint_mean_reduced,
        1e-23,
    );
    hold_real("footprint", golden::footprint_mean(), oracle::footprint_mean, 1e-27);
}

#[test]
fn the_oracle_of_a_segments_energy_gives_the_certified_digits() {
    hold_real(
        "segment energy",
        golden::segment_energy(),
        oracle::segment_energy,
        1e-22,
    );
}

#[test]
fn the_oracle_of_the_inverse_of_the_sinc_squared_integral_gives_the_certified_digits() {
    let rows = golden::sinc_squared_inverse();
    assert!(rows.len() > 150);
    let mut worst: (f64, f64) = (0.0, 0.0);
    for Row { inputs, truth, .. } in rows {
        let value = oracle::sinc_squared_inverse(inputs[0]);
        let error = real_error(&value, &truth);
        // The last digits of the integral, over x sinc^2: beside a zero of sinc they move x by much.
        let x = truth.value().abs();
        let sinc = if x == 0.0 || x.is_infinite() { 1.0 } else { x.sin() / x };
        let lost = if x > 1.0 && x < 1e100 {
            1.0 / (x * sinc).powi(2)
        } else {
            1.0
        };
        worst = if error / lost > worst.0 {
            (error / lost, inputs[0])
        } else {
            worst
        };
        assert!(
            error < 1e-28 * lost,
            "{inputs:?}: {value:?}, certified {truth:?}, {error:e}"
        );
    }
    println!("inverse: {:.1e} at {:?}", worst.0, worst.1);
}

fn number(value: Reference) -> f64 {
    value.value()
}

#[test]
fn the_oracles_give_their_limits_and_nan_outside_the_domain() {
    let (inf, nan) = (f64::INFINITY, f64::NAN);
    let phase = [10.0, 0.55, 0.01, 0.2, 3.0, 4.0, -20.0, 30.0];
    let profile = [6.0, 0.4, 0.1, 1.2, 0.55];
    let ellipse = [50.0, 20.0, 0.6, 10.0, 10.0];
    let energy = [10.0, 0.55, 0.01, 40.0];
    type Real = fn(&[f64]) -> Reference;
    for (row, oracle) in [
        (&phase[..], (|r| oracle::spatial_phase(r)[1]) as Real),
        (&profile, |r| oracle::profile_rectangle(r)[1]),
        (&profile, |r| oracle::profile_triangle(r)[1]),
        (&ellipse, oracle::footprint_mean),
        (&[2.0, 1.0], oracle::footprint_mean_reduced),
        (&[2.0, 1.0], oracle::footprint_mean_reduced_edge),
        (&energy, oracle::segment_energy),
    ] {
        let with = |column: usize, x: f64| {
            let mut row = row.to_vec();
            row[column] = x;
            number(oracle(&row))
        };
        assert!(number(oracle(row)).is_finite());
        assert!((0..row.len()).all(|column| with(column, nan).is_nan()), "{row:?}");
    }
    assert!(number(oracle::spatial_phase(&[0.0, 0.55, 0.01, 0.2, 3.0, 4.0, -20.0, 30.0])[0]).is_nan());
    assert!(number(oracle::profile_triangle(&[6.0, 0.4, 0.1, 1.2, 0.0])[0]).is_nan());
    assert!(number(oracle::profile_rectangle(&[-6.0, 0.4, 0.1, 1.2, 0.5])[0]).is_nan());
    assert!(number(oracle::footprint_mean(&[50.0, 20.0, 1.5, 10.0, 10.0])).is_nan());
    assert!(number(oracle::footprint_mean_reduced_edge(&[2.0, 2.1])).is_nan());
    assert!(number(oracle::segment_energy(&[10.0, 0.55, 0.01, -1.0])).is_nan());
    assert_eq!(number(oracle::footprint_mean_reduced(&[2.0, inf])), 0.0);
    assert_eq!(number(oracle::footprint_mean_reduced_edge(&[2.0, -inf])), 0.0);
    assert_eq!(number(oracle::segment_energy(&[10.0, 0.55, 0.01, 0.0])), 0.0);
    assert_eq!(number(oracle::segment_energy(&[10.0, 0.55, 0.01, inf])), inf);
    assert_eq!(number(oracle::sinc_squared_inverse(0.0)), -inf);
    assert_eq!(number(oracle::sinc_squared_inverse(0.5)), 0.0);
    assert_eq!(number(oracle::sinc_squared_inverse(1.0)), inf);
    assert!(
        [-0.1, 1.1, nan]
            .iter()
            .all(|&u| number(oracle::sinc_squared_inverse(u)).is_nan())
    );
}

#[test]
fn without_width_or_depth_or_length_nothing_is_left_and_a_whole_wave_of_depth_hides_the_rectangle() {
    let zero = |value: [Reference; 2]| value.iter().all(|part| part.hi == 0.0 && part.lo == 0.0);
    assert!(zero(oracle::profile_rectangle(&[0.0, 0.4, 0.1, 1.2, 0.55])));
    assert!(zero(oracle::profile_triangle(&[0.0, 0.4, 0.1, 1.2, 0.55])));
    assert!(zero(oracle::profile_rectangle(&[6.0, 0.0, 0.1, 1.2, 0.55])));
    // 2 x 0.275 um is the wavelength to the last bit, at one turn and at a million.
    assert!(zero(oracle::profile_rectangle(&[6.0, 0.275, 0.1, 2.0, 0.55])));
    assert!(zero(oracle::profile_rectangle(&[
        6.0,
        0.275 * 1048576.0,
        0.1,
        2.0,
        0.55
    ])));
    assert!(zero(oracle::spatial_phase(&[10.0, 0.55, 0.3, 0.1, 1.0, 2.0, 5.0, 5.0])));
}

#[test]
fn a_triangle_without_depth_is_the_mask_and_both_profiles_are_even_in_the_direction() {
    for row in (scratches::PROFILE.rows)(31, 2000).chunks_exact(5) {
        let &[width, depth, xi2, gamma_sum, lambda] = row else {
            unreachable!()
        };
        let mirrored = [width, depth, -xi2, gamma_sum, lambda];
        assert_eq!(
            oracle::profile_rectangle(row),
            oracle::profile_rectangle(&mirrored),
            "{row:?}"
        );
        let (a, b) = (oracle::profile_triangle(row), oracle::profile_triangle(&mirrored));
        assert!(complex_error(&a, &b, Some(width.max(1e-300))) < 1e-30, "{row:?}");
        // A depth of half a wave doubles the mask.
        let flat = oracle::profile_triangle(&[width, 0.0, xi2, gamma_sum, lambda]);
        let doubled = oracle::profile_rectangle(&[width, lambda, xi2, 0.5, lambda]).map(|part| Reference {
            exponent: part.exponent - 1,
            ..part
        });
        assert!(
            complex_error(&flat, &doubled, Some(width.max(1e-300))) < 1e-30,
            "{row:?}"
        );
    }
}

#[test]
fn the_spatial_phase_turns_conjugate_with_the_direction_and_adds_up_over_the_segment() {
    for row in (scratches::SPATIAL_PHASE.rows)(32, 600).chunks_exact(8) {
        let &[sigma, lambda, xi1, xi2, s_t, s_b, l1, l2] = row else {
            unreachable!()
        };
        let whole = oracle::spatial_phase(row);
        let [re, im] = oracle::spatial_phase(&[sigma, lambda, -xi1, -xi2, s_t, s_b, l1, l2]);
        assert!(complex_error(&[re, -im], &whole, None) < 1e-26, "{row:?}");
        let [re, im] = oracle::spatial_phase(&[sigma, lambda, xi1, xi2, s_t, s_b, l2, l1]);
        assert!(complex_error(&[-re, -im], &whole, None) < 1e-26, "{row:?}");
        let parts = [[l1, -s_t], [-s_t, l2]].map(|[l1, l2]| {
            let value = oracle::spatial_phase(&[sigma, lambda, xi1, xi2, s_t, s_b, l1, l2]);
            value.map(|part| Dd::new(part.hi, part.lo).scale(2f64.powi(part.exponent.max(-1000))))
        });
        let peak = sigma * (-0.5 * (s_b / sigma).powi(2)).exp();
        let sum = [0, 1].map(|k| Reference::from(parts[0][k] + parts[1][k]));
        if peak > 1e-200 {
            assert!(
                complex_error(&sum, &whole, Some(peak)) < 1e-26,
                "{row:?} {sum:?} {whole:?}"
            );
        }
    }
}

#[test]
fn the_footprint_mean_is_even_in_the_offset_and_along_each_axis_the_reduced_one() {
    for row in (scratches::FOOTPRINT_REDUCED.rows)(33, 2000).chunks_exact(2) {
        let &[h, c] = row else { unreachable!() };
        let truth = oracle::footprint_mean_reduced(row);
        assert_eq!(oracle::footprint_mean_reduced(&[h, -c]), truth, "{row:?}");
        for row in [
            [h, 3.0, 0.0, c, 1.0],
            [3.0, h, 1.0, -c, 1.0],
            [3.0, h, -1.0, c, 1.0],
            [h, h, 0.0, c, 1.0],
        ] {
            let error = real_error(&oracle::footprint_mean(&row), &truth);
            assert!(error < 1e-22, "{row:?}: {error:e}");
        }
        // A scale of lengths, exact by powers of two.
        let error = real_error(&oracle::footprint_mean(&[8.0 * h, 3.0, 0.0, 8.0 * c, 8.0]), &truth);
        assert!(error < 1e-22, "{row:?}: {error:e}");
        // The edge, where its distance is an f64.
        if h - (h - c.abs()) == c.abs() {
            let edge = oracle::footprint_mean_reduced_edge(&[h, h - c.abs()]);
            assert!(real_error(&edge, &truth) < 1e-11, "{row:?} {edge:?} {truth:?}");
        }
    }
}
