//! Counts and judges: how many rows agree to the bit, how far the others are, and whether WGSL allows it.

use crate::trace::Program;

/// The comparison of one function on one device.
#[derive(Clone, Debug, Default)]
pub struct Comparison {
    /// Function.
    pub name: String,
    /// Whether it divides or takes roots.
    pub divides: bool,
    /// Rows compared.
    pub rows: usize,
    /// Rows with the same bits; a NaN equals a NaN, whatever its payload.
    pub bit_equal: usize,
    /// Rows that differ where WGSL promises nothing (see [`crate::trace`]).
    pub outside: usize,
    /// Rows that differ where a decision hangs on less than the allowed error.
    pub undecided: usize,
    /// Largest difference, in units in the last place, over the rows that WGSL promises.
    pub max_ulp: u64,
    /// The row of the largest difference.
    pub worst: Vec<f32>,
    /// Rows that differ by more than WGSL allows: the row, ours, the device's, the bound.
    pub failures: Vec<(Vec<f32>, f32, f32, f64)>,
}

/// Distance of two finite numbers in units in the last place; both zeros are one number.
fn distance(a: f32, b: f32) -> u64 {
    let rank = |x: f32| {
        let size = i64::from(x.to_bits() & 0x7fff_ffff);
        if x.is_sign_negative() { -size } else { size }
    };
    rank(a).abs_diff(rank(b))
}

/// What a result may differ by where a decision hangs on less than the allowed error: the bound of a row, for functions
/// whose decisions only choose between forms of one value.
pub type Continuous = fn(&[f32]) -> f64;

/// Compares results of the device with those of Rust, row by row.
pub fn compare(
    program: &Program,
    name: &str,
    arguments: usize,
    rows: &[f32],
    rust: &[f32],
    device: &[f32],
) -> Result<Comparison, String> {
    compare_continuous(program, name, arguments, rows, rust, device, None)
}

/// [`compare`], of a function that may be continuous across its decisions.
pub fn compare_continuous(
    program: &Program,
    name: &str,
    arguments: usize,
    rows: &[f32],
    rust: &[f32],
    device: &[f32],
    continuous: Option<Continuous>,
) -> Result<Comparison, String> {
    let count = rows.len() / arguments;
    let width = rust.len() / count.max(1);
    if rust.len() != device.len() || rust.len() != count * width {
        return Err(format!(
            "{name}: {} results of Rust, {} of the device",
            rust.len(),
            device.len()
        ));
    }
    let mut found = Comparison {
        name: name.to_owned(),
        divides: program.divides(name)?,
        rows: count,
        ..Default::default()
    };
    for ((row, ours), theirs) in rows
        .chunks_exact(arguments)
        .zip(rust.chunks_exact(width))
        .zip(device.chunks_exact(width))
    {
        if ours
            .iter()
            .zip(theirs)
            .all(|(a, b)| a.to_bits() == b.to_bits() || (a.is_nan() && b.is_nan()))
        {
            found.bit_equal += 1;
            continue;
        }
        let trace = program.evaluate(name, row)?;
        if trace.outside {
            found.outside += 1;
            continue;
        }
        if trace.undecided {
            let Some(allowed) = continuous else {
                found.undecided += 1;
                continue;
            };
            let bound = allowed(row);
            for (&a, &b) in ours.iter().zip(theirs) {
                let difference = (f64::from(a) - f64::from(b)).abs();
                if difference.is_nan() || difference > bound {
                    found.failures.push((row.to_vec(), a, b, bound));
                }
            }
            continue;
        }
        for ((&a, &b), allowed) in ours.iter().zip(theirs).zip(&trace.results) {
            let ulps = if b.is_finite() { distance(a, b) } else { u64::MAX };
            if ulps > found.max_ulp {
                found.max_ulp = ulps;
                found.worst = row.to_vec();
            }
            let difference = (f64::from(a) - f64::from(b)).abs();
            if difference.is_nan() || difference > allowed.bound {
                found.failures.push((row.to_vec(), a, b, allowed.bound));
            }
        }
    }
    Ok(found)
}

impl Comparison {
    /// Share of the rows with the same bits.
    pub fn share(&self) -> f64 {
        self.bit_equal as f64 / self.rows.max(1) as f64
    }

    /// Row of the table that the test prints.
    pub fn line(&self) -> String {
        format!(
            "{:<34} {:>4} {:>8} {:>10.4}% {:>8} {:>8} {:>9} {:>8}  {}",
            self.name,
            if self.divides { "yes" } else { "no" },
            self.rows,
            100.0 * self.share(),
            self.max_ulp,
            self.outside,
            self.undecided,
            self.failures.len(),
            self.worst
                .iter()
                .map(|x| format!("{x:e}"))
                .collect::<Vec<_>>()
                .join(" ")
        )
    }

    /// Head of the table.
    pub fn head() -> String {
        format!(
            "{:<34} {:>4} {:>8} {:>11} {:>8} {:>8} {:>9} {:>8}  worst input",
            "function", "/", "rows", "bit-equal", "max ulp", "outside", "undecided", "failures"
        )
    }

    /// Head of the rows for the ledger.
    pub const CSV_HEAD: &str = "function,device,rows,bit_equal_share,max_ulp,worst_input_bits,outside,undecided";

    /// Row for the ledger; the worst input as the bits of its f32, in hexadecimal.
    pub fn csv(&self, device: &str) -> String {
        let worst: Vec<String> = self.worst.iter().map(|x| format!("0x{:08x}", x.to_bits())).collect();
        format!(
            "{},\"{}\",{},{},{},{},{},{}",
            self.name,
            device.replace('"', "'"),
            self.rows,
            self.share(),
            self.max_ulp,
            worst.join(" "),
            self.outside,
            self.undecided
        )
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn differences_are_judged_by_the_bound_of_their_row() {
        let program = Program::parse("fn f(x: f32) -> f32 { return x / 3.0; }").expect("valid WGSL");
        let rows = [1.0f32, 2.0, 1e-44, 4.0];
        let rust: Vec<f32> = rows.iter().map(|x| x / 3.0).collect();
        let up = |x: f32, n: u32| f32::from_bits(x.to_bits() + n);
        let device = [rust[0], up(rust[1], 2), 0.0, up(rust[3], 4)];
        let found = compare(&program, "f", 1, &rows, &rust, &device).expect("comparable");
        assert_eq!(
            (found.rows, found.bit_equal, found.outside, found.max_ulp),
            (4, 1, 1, 4)
        );
        assert_eq!(found.failures.len(), 1);
        assert_eq!(found.failures[0].0, [4.0]);
        assert_eq!(found.worst, [4.0]);
    }

    #[test]
    fn a_function_that_is_continuous_across_its_decisions_is_judged_on_both_sides_of_them() {
        let text = "fn f(x: f32) -> f32 { if x / 3.0 > 1.0 { return x; } return 3.0; }";
        let program = Program::parse(text).expect("valid WGSL");
        let rows = [3.0f32];
        let judged = |device: f32| {
            let found = compare_continuous(&program, "f", 1, &rows, &[3.0], &[device], Some(|_| 1e-3));
            found.expect("comparable").failures.len()
        };
        assert_eq!((judged(3.0005), judged(3.1), judged(f32::NAN)), (0, 1, 1));
    }

    #[test]
    fn distance_counts_across_zero() {
        assert_eq!(distance(0.0, -0.0), 0);
        assert_eq!(distance(f32::from_bits(1), -f32::from_bits(1)), 2);
        assert_eq!(distance(1.0, 1.0 + f32::EPSILON), 1);
    }
}
