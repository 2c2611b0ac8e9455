//! Panels of a map as CSV, and the comparison of two.

use super::{CELLS, Panel};
use crate::number_table;
use std::fmt::Write;

/// The panels as CSV: one line a row of cells, before them row -1 with the share of the panel without a digit.
pub fn write(panels: &[Panel]) -> String {
    let mut text = "panel,row".to_string();
    (0..CELLS[0]).for_each(|i| {
        let _ = write!(text, ",c{i}");
    });
    text.push('\n');
    for panel in panels {
        let _ = writeln!(
            text,
            "{},-1,{:.1}{}",
            panel.number,
            panel.hopeless,
            ",0".repeat(CELLS[0] - 1)
        );
        for (row, cells) in panel.cells.chunks_exact(CELLS[0]).enumerate() {
            let _ = write!(text, "{},{row}", panel.number);
            for value in cells {
                let word = if *value == value.trunc() {
                    format!(",{value:.0}")
                } else {
                    format!(",{value:.1}")
                };
                text.push_str(&word);
            }
            text.push('\n');
        }
    }
    text
}

/// Reads what [`write()`] wrote.
pub fn read(text: &str) -> Result<Vec<Panel>, String> {
    let (header, rows) = number_table::read(text)?;
    if header.len() != CELLS[0] + 2 || rows.len() % (CELLS[1] + 1) != 0 {
        return Err("the map has another grid".to_string());
    }
    let panels = rows.chunks_exact(CELLS[1] + 1).map(|rows| Panel {
        number: rows[0][0] as usize,
        cells: rows[1..].iter().flat_map(|row| row[2..].iter().copied()).collect(),
        hopeless: rows[0][2],
    });
    Ok(panels.collect())
}

/// Where a committed map and a fresh one disagree by half a digit or more, among the panels that both have: peers use the
/// platform's maths, so the last digit of a cell is free.
pub fn difference(committed: &str, fresh: &[Panel]) -> Result<Option<String>, String> {
    let committed = read(committed)?;
    for panel in fresh {
        let Some(old) = committed.iter().find(|p| p.number == panel.number) else {
            return Ok(Some(format!("panel {} is missing", panel.number)));
        };
        let apart = |(a, b): (&f64, &f64)| !((a - b).abs() < 0.5 || (a.is_nan() && b.is_nan()));
        let count = old.cells.iter().zip(&panel.cells).filter(|&pair| apart(pair)).count();
        // Beside a zero or at the edge of overflow a cell may turn on one rounding.
        if count * 100 > panel.cells.len() {
            return Ok(Some(format!("panel {}: {count} cells differ", panel.number)));
        }
    }
    Ok(None)
}

#[cfg(test)]
mod tests {
    use super::super::NOT_FINITE;
    use super::*;

    #[test]
    fn maps_survive_writing_and_reading_and_a_changed_one_is_found() {
        let count = CELLS[0] * CELLS[1];
        let mut cells = vec![0.0; count];
        (cells[0], cells[1], cells[2]) = (NOT_FINITE, f64::NAN, 3.5);
        let panel = Panel {
            number: 5,
            cells,
            hopeless: 12.5,
        };
        let text = write(std::slice::from_ref(&panel));
        let again = read(&text).expect("well formed");
        assert_eq!(again.len(), 1);
        assert_eq!(
            (again[0].number, again[0].cells[0], again[0].cells[2]),
            (5, NOT_FINITE, 3.5)
        );
        assert!(again[0].cells[1].is_nan());
        assert_eq!(again[0].hopeless, 12.5);
        assert_eq!(panel.most(), 3.5);
        assert_eq!(difference(&text, &again), Ok(None));
        let mut other = panel.clone();
        other.cells.iter_mut().take(200).for_each(|c| *c = 7.0);
        assert!(difference(&text, &[other]).expect("read").is_some());
    }
}
