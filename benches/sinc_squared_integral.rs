//! Time of every registered way to integrate sinc^2 over an arc, on the 4096 scratch arcs that `report` uses.
//!
//! On a shared machine read a low percentile of `times[i]/iters[i]` in `target/criterion/*/new/sample.json`, not the slope.
#[path = "criterion/registered.rs"]
mod registered;

fn main() {
    registered::bench("sinc_squared_integral");
}
