//! The parts of the program `report`.
//!
//! Measuring (`measured`, `timing`, `series`) writes numbers: `data/accuracy.csv` and `data/charts/*.csv`. Drawing
//! (`render`, `chart`, `tables`, `overview`, `goals`, `pages`) reads only those numbers, so it can be repeated and checked
//! anywhere; `exact` and `integrals` alone count anew, on fixed rows.

pub mod axis_points;
pub mod budget_text;
pub mod chart;
pub mod digit_map;
pub mod error_map;
pub mod eval;
pub mod exact;
pub mod fourier_figures;
pub mod front;
pub mod goals;
pub mod hex_float;
pub mod integrals;
pub mod ledger;
pub mod light_figures;
pub mod map_grid;
pub mod measured;
pub mod names;
pub mod number_table;
pub mod overview;
pub mod pages;
pub mod promise;
pub mod render;
pub mod rows;
pub mod run;
pub mod series;
pub mod summary;
pub mod tables;
pub mod timing;
