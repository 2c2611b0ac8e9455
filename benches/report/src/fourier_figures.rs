//! The figures of WVJH17 remade, kept as CSV in `data/charts`: closed forms against the Fourier transform of the rasterised
//! transfer function, for one scratch and for ten (Figs. 13 and 14).

use crate::error_map::SHIFT;
use crate::map_grid::{CELLS, Panel};
use crate::number_table;
use reference::fourier::{Plane, figure_13, figure_14};
use std::fmt::Write;

/// One of so many directions of a cut is kept.
const THINNING: usize = 4;

/// A direction of a cut: the direction cosine, and the radiance there by each way.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Direction {
    /// Which cut: 0 along the scratch, 1 across it.
    pub cut: usize,
    /// The direction cosine.
    pub xi: f64,
    /// Closed form of the papers.
    pub analytic: f64,
    /// Closed form with the window across the width as well.
    pub exact: f64,
    /// By transform.
    pub fourier: f64,
}

/// One scratch, cut along and across it, as CSV.
pub fn one_scratch() -> String {
    let mut text = "cut,xi,analytic,exact,fourier\n".to_string();
    for (cut, slice) in figure_13().iter().enumerate() {
        for i in (0..slice.xi.len()).step_by(THINNING) {
            let values = [slice.analytic[i], slice.exact[i], slice.fourier[i]].map(|x| format!("{x:.9e}"));
            let _ = writeln!(text, "{cut},{:.5},{}", slice.xi[i], values.join(","));
        }
    }
    text
}

/// Reads what [`one_scratch`] wrote.
pub fn read(text: &str) -> Result<Vec<Direction>, String> {
    let (header, rows) = number_table::read(text)?;
    if header.len() != 5 {
        return Err(format!("5 columns expected, {} found", header.len()));
    }
    let direction = |r: &Vec<f64>| Direction {
        cut: r[0] as usize,
        xi: r[1],
        analytic: r[2],
        exact: r[3],
        fourier: r[4],
    };
    Ok(rows.iter().map(direction).collect())
}

/// Where two files of cuts differ by more than a millionth of the peak: the platform's mathematics is in both.
pub fn difference(committed: &str, fresh: &str) -> Result<Option<String>, String> {
    let (a, b) = (read(committed)?, read(fresh)?);
    if a.len() != b.len() {
        return Ok(Some(format!("{} directions, {} expected", a.len(), b.len())));
    }
    let peak = b.iter().map(|d| d.fourier).fold(0.0, f64::max);
    let apart = |(a, b): (&Direction, &Direction)| {
        let values = |d: &Direction| [d.analytic, d.exact, d.fourier];
        let near = |(x, y): (f64, f64)| (x - y).abs() <= 1e-6 * peak;
        a.xi != b.xi || !values(a).into_iter().zip(values(b)).all(near)
    };
    Ok(a.iter()
        .zip(&b)
        .position(apart)
        .map(|i| format!("line {} differs", i + 2)))
}

/// Ten scratches over the hemisphere: radiance by the closed form and by transform, and the error of the closed form without
/// and with the crossings, all as multiples of the transform's peak. A cell holds the mean radiance, or the largest error.
pub fn ten_scratches() -> Result<Vec<Panel>, String> {
    let plane = figure_14();
    let peak = plane.fourier.iter().copied().fold(0.0, f64::max);
    let errors = |form: &[f64]| -> Vec<f64> { form.iter().zip(&plane.fourier).map(|(a, b)| (a - b).abs()).collect() };
    let (papers, crossed) = (errors(&plane.analytic), errors(&plane.crossings));
    let mean = |values: &[f64]| values.iter().sum::<f64>() / values.len() as f64;
    let largest = |values: &[f64]| values.iter().copied().fold(0.0, f64::max);
    type Gather<'a> = &'a dyn Fn(&[f64]) -> f64;
    let parts: [(&[f64], Gather); 4] = [
        (&plane.analytic, &mean),
        (&plane.fourier, &mean),
        (&papers, &largest),
        (&crossed, &largest),
    ];
    let panel = |(number, (values, gather)): (usize, (&[f64], Gather))| {
        let cell = |index: usize| match gathered(&plane, values, index) {
            found if found.is_empty() => f64::NAN,
            found => level(gather(&found) / peak),
        };
        Panel {
            number,
            cells: (0..CELLS[0] * CELLS[1]).map(cell).collect(),
            hopeless: 0.0,
        }
    };
    Ok(parts.into_iter().enumerate().map(panel).collect())
}

/// 16 + log10, not below 0.
fn level(value: f64) -> f64 {
    if value == 0.0 {
        0.0
    } else {
        (SHIFT + libm::log10(value)).clamp(0.0, 98.0)
    }
}

/// The values within a cell of the square of direction cosines, those below the horizon left out.
fn gathered(plane: &Plane, values: &[f64], index: usize) -> Vec<f64> {
    let [columns, rows] = CELLS;
    let part = |k: usize, count: usize| [k, k + 1].map(|k| 2.0 * k as f64 / count as f64 - 1.0);
    let within = |[lo, hi]: [f64; 2]| {
        let from = plane.xi.partition_point(|&x| x < lo);
        from..plane.xi.partition_point(|&x| x < hi)
    };
    let (across, down) = (
        within(part(index % columns, columns)),
        within(part(index / columns, rows)),
    );
    let inside = |&(row, column): &(usize, usize)| plane.xi[row].powi(2) + plane.xi[column].powi(2) < 1.0;
    let places = down.flat_map(|row| across.clone().map(move |column| (row, column)));
    let found = places
        .filter(inside)
        .map(|(row, column)| values[row * plane.xi.len() + column]);
    found.collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_cuts_survive_writing_and_reading_and_a_changed_one_is_found() {
        let text = "cut,xi,analytic,exact,fourier\n0,0.1,1.0,1.0,1.0\n1,0.2,0.5,0.4,0.4\n";
        let cuts = read(text).expect("well formed");
        assert_eq!((cuts[1].cut, cuts[1].xi, cuts[1].exact), (1, 0.2, 0.4));
        assert_eq!(difference(text, text), Ok(None));
        let changed = text.replace("0.5,0.4,0.4", "0.5,0.4,0.41");
        assert_eq!(difference(&changed, text), Ok(Some("line 3 differs".to_string())));
        assert!(read("a,b\n1,2\n").is_err());
    }

    #[test]
    fn cells_gather_every_direction_of_the_hemisphere_once() {
        let xi: Vec<f64> = (-100..=100).map(|i| f64::from(i) / 101.0).collect();
        let count = xi.len();
        let values = vec![1.0; count * count];
        let plane = Plane {
            xi: xi.clone(),
            analytic: vec![],
            crossings: vec![],
            fourier: vec![],
        };
        let all: usize = (0..CELLS[0] * CELLS[1])
            .map(|i| gathered(&plane, &values, i).len())
            .sum();
        let inside = xi
            .iter()
            .flat_map(|x| xi.iter().map(move |y| x * x + y * y))
            .filter(|r| *r < 1.0);
        assert_eq!(all, inside.count());
        assert!(gathered(&plane, &values, 0).is_empty());
    }
}
