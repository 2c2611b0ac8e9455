//! The largest error of a sweep, held from both sides.

/// The largest error of a sweep and where it stands.
pub struct Worst {
    name: &'static str,
    error: f64,
    row: Vec<f32>,
    rows: usize,
}

impl Worst {
    pub fn of(name: &'static str) -> Worst {
        Worst {
            name,
            error: 0.0,
            row: Vec::new(),
            rows: 0,
        }
    }

    pub fn add(&mut self, error: f64, row: &[f32]) {
        self.rows += 1;
        // A NaN counts as the worst.
        if error.is_nan() || error > self.error {
            self.error = if error.is_nan() { f64::INFINITY } else { error };
            self.row = row.to_vec();
        }
    }

    /// Fails beyond the bound, and where the bound is more than four times what was found.
    pub fn hold(&self, bound: f64) {
        println!(
            "{}: {:.2e} of {bound:.1e} in {} rows, at {:?}",
            self.name, self.error, self.rows, self.row
        );
        assert!(self.error <= bound, "{}: {:e} at {:?}", self.name, self.error, self.row);
        assert!(
            bound <= 4.0 * self.error,
            "{}: only {:e}: tighten the bound",
            self.name,
            self.error
        );
    }
}
