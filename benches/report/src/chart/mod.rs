//! Charts, as deterministic SVG text drawn from the committed CSV files alone.
pub mod axis;
pub mod cuts;
pub mod digits;
pub mod error_time;
pub mod failures;
pub mod key;
pub mod labels;
pub mod light_sizes;
pub mod marker;
pub mod palette;
pub mod svg;
pub mod ulp;
