//! Worst inputs found so far, from `data/worst/<function>.csv`: every mixture begins with them.

use crate::hexadecimal;

/// Name and text of each file: one header line, then one row of hexadecimal floats a line, `#` comments.
const FILES: [(&str, usize, &str); 36] = [
    (
        "sine_integral",
        1,
        include_str!("../../../../data/worst/sine_integral.csv"),
    ),
    ("sinc", 1, include_str!("../../../../data/worst/sinc.csv")),
    (
        "sinc_squared_integral",
        2,
        include_str!("../../../../data/worst/sinc_squared_integral.csv"),
    ),
    (
        "sinc_squared_integral_turns",
        3,
        include_str!("../../../../data/worst/sinc_squared_integral_turns.csv"),
    ),
    ("sine", 1, include_str!("../../../../data/worst/sine.csv")),
    ("cosine", 1, include_str!("../../../../data/worst/cosine.csv")),
    ("exponential", 1, include_str!("../../../../data/worst/exponential.csv")),
    ("faddeeva_w", 2, include_str!("../../../../data/worst/faddeeva_w.csv")),
    (
        "faddeeva_w_derivative",
        2,
        include_str!("../../../../data/worst/faddeeva_w_derivative.csv"),
    ),
    ("erf", 1, include_str!("../../../../data/worst/erf.csv")),
    ("erf_complex", 2, include_str!("../../../../data/worst/erf_complex.csv")),
    (
        "erfc_complex",
        2,
        include_str!("../../../../data/worst/erfc_complex.csv"),
    ),
    ("erfcx", 1, include_str!("../../../../data/worst/erfcx.csv")),
    (
        "erf_difference_scaled",
        3,
        include_str!("../../../../data/worst/erf_difference_scaled.csv"),
    ),
    (
        "bessel_i0_scaled",
        1,
        include_str!("../../../../data/worst/bessel_i0_scaled.csv"),
    ),
    (
        "log_bessel_i0",
        1,
        include_str!("../../../../data/worst/log_bessel_i0.csv"),
    ),
    (
        "bessel_i1_i0_ratio",
        1,
        include_str!("../../../../data/worst/bessel_i1_i0_ratio.csv"),
    ),
    (
        "spatial_phase",
        8,
        include_str!("../../../../data/worst/spatial_phase.csv"),
    ),
    (
        "profile_rectangle",
        5,
        include_str!("../../../../data/worst/profile_rectangle.csv"),
    ),
    (
        "profile_triangle",
        5,
        include_str!("../../../../data/worst/profile_triangle.csv"),
    ),
    (
        "footprint_mean",
        5,
        include_str!("../../../../data/worst/footprint_mean.csv"),
    ),
    (
        "polygon_light",
        17,
        include_str!("../../../../data/worst/polygon_light.csv"),
    ),
    (
        "quad_light_chord",
        17,
        include_str!("../../../../data/worst/quad_light_chord.csv"),
    ),
    (
        "footprint_mean_reduced",
        2,
        include_str!("../../../../data/worst/footprint_mean_reduced.csv"),
    ),
    (
        "footprint_mean_reduced_edge",
        2,
        include_str!("../../../../data/worst/footprint_mean_reduced_edge.csv"),
    ),
    (
        "segment_energy",
        4,
        include_str!("../../../../data/worst/segment_energy.csv"),
    ),
    (
        "sinc_squared_inverse",
        1,
        include_str!("../../../../data/worst/sinc_squared_inverse.csv"),
    ),
    (
        "spatial_phase_infinite",
        5,
        include_str!("../../../../data/worst/spatial_phase_infinite.csv"),
    ),
    (
        "response_triangle",
        5,
        include_str!("../../../../data/worst/response_triangle.csv"),
    ),
    (
        "response_rectangle_windowed",
        11,
        include_str!("../../../../data/worst/response_rectangle_windowed.csv"),
    ),
    ("depth_term", 3, include_str!("../../../../data/worst/depth_term.csv")),
    (
        "base_response",
        4,
        include_str!("../../../../data/worst/base_response.csv"),
    ),
    (
        "scratch_squared",
        8,
        include_str!("../../../../data/worst/scratch_squared.csv"),
    ),
    (
        "area_density",
        3,
        include_str!("../../../../data/worst/area_density.csv"),
    ),
    (
        "gaussian_inverse",
        1,
        include_str!("../../../../data/worst/gaussian_inverse.csv"),
    ),
    (
        "von_mises_fisher_pdf",
        2,
        include_str!("../../../../data/worst/von_mises_fisher_pdf.csv"),
    ),
];

/// Rows of these functions are complex numbers, erf differences, half widths, lengths or shares, which [`recorded`] leaves out.
const APART: [&str; 14] = [
    "faddeeva_w",
    "faddeeva_w_derivative",
    "erf_complex",
    "erfc_complex",
    "erf_difference_scaled",
    "footprint_mean_reduced",
    "footprint_mean_reduced_edge",
    "sinc_squared_inverse",
    "depth_term",
    "base_response",
    "area_density",
    "gaussian_inverse",
    "von_mises_fisher_pdf",
    "scratch_squared",
];

/// All recorded rows with this number of columns: real numbers, arcs, or arcs after a width.
pub fn recorded(columns: usize) -> Vec<Vec<f64>> {
    let files = FILES
        .iter()
        .filter(|file| file.1 == columns && !APART.contains(&file.0));
    files.flat_map(|&(name, _, text)| parse(name, columns, text)).collect()
}

/// All rows recorded for these functions.
pub fn recorded_for(functions: &[&str]) -> Vec<Vec<f64>> {
    let files = FILES.iter().filter(|file| functions.contains(&file.0));
    files
        .flat_map(|&(name, columns, text)| parse(name, columns, text))
        .collect()
}

fn parse(name: &str, columns: usize, text: &str) -> Vec<Vec<f64>> {
    let lines = text
        .lines()
        .enumerate()
        .filter(|(_, line)| !line.trim().is_empty() && !line.starts_with('#'));
    let rows = lines.skip(1).map(|(number, line)| {
        let row: Vec<f64> = line
            .split(',')
            .map(|word| {
                hexadecimal::parse(word)
                    .unwrap_or_else(|_| panic!("data/worst/{name}.csv, line {}: {word:?}", number + 1))
            })
            .collect();
        assert_eq!(row.len(), columns, "data/worst/{name}.csv, line {}", number + 1);
        row
    });
    rows.collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_recorded_row_is_read_and_comments_are_not() {
        let rows = parse(
            "test",
            2,
            "# found by hand\nq0,q1\n0x1.8p+1,0x1.0p+2\n\n# another\n-0x1.0p+0,0x0.0p+0\n",
        );
        assert_eq!(rows, [vec![3.0, 4.0], vec![-1.0, 0.0]]);
        assert!(!recorded(1).is_empty() && !recorded(2).is_empty());
    }
}
