//! Time of every registered way to compute the light of a polygon, on the 4096 inputs that `report` uses.
//!
//! On a shared machine read a low percentile of `times[i]/iters[i]` in `target/criterion/*/new/sample.json`, not the slope.
#[path = "criterion/registered.rs"]
mod registered;

fn main() {
    registered::bench("polygon_light");
}
