//! Measured series behind the plots, kept as CSV in `data/charts`: the errors of functions of one variable in ulp over x,
//! and the map of errors of the arc integral over its start and length. All points follow from the grid alone; no clock.

use crate::axis_points::logarithmic;
use crate::number_table;
use reference::metrics::{Reference, Truth, relative_error, ulp_error, wrong_sign};
use reference::registry::{Call, Function, Method, Precision};
use std::fmt::Write;

/// Bins of the ulp plot.
pub const BINS: usize = 420;
/// Range of x of the ulp plot.
pub const X_RANGE: [f64; 2] = [1e-2, 1e4];
/// Columns and rows of the failure map.
pub const MAP: [usize; 2] = [130, 64];
/// Range of the arc's start.
pub const START_RANGE: [f64; 2] = [0.1, 500.0];
/// Range of the arc's length.
pub const LENGTH_RANGE: [f64; 2] = [1e-4, 1e2];
/// Points measured in each cell of the map.
const CELL_POINTS: usize = 5;

/// Largest error in one bin of x, and the conditioning there.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct UlpBin {
    /// Start and end of the bin.
    pub x: [f64; 2],
    /// Largest error of ours in ulp.
    pub ours: f64,
    /// Largest error of the best peer in ulp.
    pub peer: f64,
    /// Largest `|x f'(x)/f(x)|/2 + 1/2`: the error of a correctly rounded result of an input that was itself rounded.
    pub envelope: f64,
}

/// Errors of two methods in one cell of start and length.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cell {
    /// Largest relative error, and whether a result has the wrong sign, of the published method.
    pub published: (f64, bool),
    /// The same of ours.
    pub ours: (f64, bool),
}

/// The truth of a real function.
fn real(truth: Truth) -> Reference {
    match truth {
        Truth::Real(x) | Truth::Complex([x, _]) => x,
    }
}

/// x f'(x)/f(x) of a function with an ulp plot, where `value` is f(x).
fn conditioning(function: &Function, x: f64, value: f64) -> f64 {
    match function.name {
        "bessel_i0_scaled" => x * (reference::oracle::bessel_i1_i0_ratio(x).hi - 1.0),
        _ => libm::sin(x) / value,
    }
}

/// Measures the ulp plot with `samples` points a bin.
pub fn ulp_bins(function: &Function, ours: &Method, peer: &Method, samples: usize) -> Vec<UlpBin> {
    (0..BINS)
        .map(|i| {
            let edge = |k: f64| logarithmic(X_RANGE, k / BINS as f64);
            let mut bin = UlpBin {
                x: [edge(i as f64), edge(i as f64 + 1.0)],
                ours: 0.0,
                peer: 0.0,
                envelope: 0.0,
            };
            for j in 0..samples {
                let x = edge(i as f64 + (j as f64 + 0.5) / samples as f64);
                let truth = real(function.truth(&[x]));
                let error = |m: &Method| ulp_error(m.call.evaluate(&[x])[0], &truth, Precision::F64);
                bin.ours = bin.ours.max(error(ours));
                bin.peer = bin.peer.max(error(peer));
                bin.envelope = bin
                    .envelope
                    .max(0.5 * libm::fabs(conditioning(function, x, truth.hi)) + 0.5);
            }
            bin
        })
        .collect()
}

/// The ulp plot as CSV; `peer` names the peer in the title row.
pub fn write_ulp(bins: &[UlpBin], peer: &str) -> String {
    let mut text = format!("x_from,x_to,accurate,{peer},envelope\n");
    for b in bins {
        let [from, to] = b.x;
        let _ = writeln!(
            text,
            "{from:.6e},{to:.6e},{:.4},{:.4},{:.4}",
            b.ours, b.peer, b.envelope
        );
    }
    text
}

/// Reads what [`write_ulp`] wrote, with the peer's name.
pub fn read_ulp(text: &str) -> Result<(Vec<UlpBin>, String), String> {
    let (header, rows) = number_table::read(text)?;
    let bins = rows
        .iter()
        .map(|r| UlpBin {
            x: [r[0], r[1]],
            ours: r[2],
            peer: r[3],
            envelope: r[4],
        })
        .collect();
    Ok((bins, header.get(3).cloned().ok_or("a column is missing")?))
}

/// The start and the length at a place of the map, in cells.
pub fn arc_at(column: f64, row: f64) -> [f64; 2] {
    [
        logarithmic(START_RANGE, column / MAP[0] as f64),
        logarithmic(LENGTH_RANGE, row / MAP[1] as f64),
    ]
}

/// Measures the map, row by row from the shortest length, on both cores.
pub fn failure_map(function: &Function, published: &Method, ours: &Method) -> Vec<Cell> {
    let calls = [published.call, ours.call];
    let count = MAP[0] * MAP[1];
    let mut cells = vec![
        Cell {
            published: (0.0, false),
            ours: (0.0, false)
        };
        count
    ];
    let threads = std::thread::available_parallelism().map_or(1, usize::from);
    let share = count.div_ceil(threads);
    std::thread::scope(|scope| {
        for (part, slot) in cells.chunks_mut(share).enumerate() {
            scope.spawn(move || {
                for (k, cell) in slot.iter_mut().enumerate() {
                    *cell = measure_cell(part * share + k, function, &calls);
                }
            });
        }
    });
    cells
}

fn measure_cell(index: usize, function: &Function, calls: &[Call; 2]) -> Cell {
    let (column, row) = (index % MAP[0], index / MAP[0]);
    let mut found = [(0.0_f64, false); 2];
    for j in 0..CELL_POINTS {
        let part = (j as f64 + 0.5) / CELL_POINTS as f64;
        // A lattice over the cell: the second coordinate steps by 2/5 turns of the first.
        let [start, length] = arc_at(column as f64 + part, row as f64 + (2.0 * part + 0.1) % 1.0);
        let arc = [start, start + length];
        let truth = real(function.truth(&arc));
        for (slot, call) in found.iter_mut().zip(calls) {
            let result = call.evaluate(&arc)[0];
            slot.0 = slot.0.max(relative_error(result, &truth, Precision::F64));
            slot.1 |= wrong_sign(result, &truth);
        }
    }
    Cell {
        published: found[0],
        ours: found[1],
    }
}

/// The map as CSV.
pub fn write_map(cells: &[Cell]) -> String {
    let mut text = "q0,length,vwh18,vwh18_negative,accurate,accurate_negative\n".to_string();
    for (i, c) in cells.iter().enumerate() {
        let [start, length] = arc_at((i % MAP[0]) as f64 + 0.5, (i / MAP[0]) as f64 + 0.5);
        let error = |e: f64| {
            if e == 0.0 { "0".to_string() } else { format!("{e:.1e}") }
        };
        let _ = writeln!(
            text,
            "{start:.3},{length:.2e},{},{},{},{}",
            error(c.published.0),
            u8::from(c.published.1),
            error(c.ours.0),
            u8::from(c.ours.1)
        );
    }
    text
}

/// Reads what [`write_map`] wrote.
pub fn read_map(text: &str) -> Result<Vec<Cell>, String> {
    let (_, rows) = number_table::read(text)?;
    if rows.len() != MAP[0] * MAP[1] {
        return Err(format!("{} cells expected, {} found", MAP[0] * MAP[1], rows.len()));
    }
    Ok(rows
        .iter()
        .map(|r| Cell {
            published: (r[2], r[3] != 0.0),
            ours: (r[4], r[5] != 0.0),
        })
        .collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_ulp_table_survives_writing_and_reading() {
        let bins = vec![UlpBin {
            x: [0.5, 1.0],
            ours: 0.25,
            peer: 1.5,
            envelope: 0.75,
        }];
        let text = write_ulp(&bins, "cephes");
        assert_eq!(read_ulp(&text), Ok((bins, "cephes".to_string())));
        assert!(read_ulp("a,b\n1\n").is_err());
    }
}
