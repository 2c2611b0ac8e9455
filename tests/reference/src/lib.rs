//! Independent oracles, error metrics, input generators, published formulas as printed, and the registry of methods.
//!
//! Nothing here is shared with the crate under test: the oracles, the generators and the formulas have their own source.

pub mod as_printed;
pub mod fourier;
pub mod gauss;
pub mod generate;
pub mod golden;
pub mod hexadecimal;
pub mod measure;
pub mod metrics;
pub mod oracle;
pub mod peers;
pub mod registry;
pub mod simpson;
