//! Everything that is drawn from committed numbers: charts and the generated parts of pages. No measurement, no clock.

use crate::chart::{error_time, failures, ulp};
use crate::ledger::Entry;
use crate::{pages, series, tables};
use std::path::{Path, PathBuf};

/// A file's path below the root and its text.
pub type File = (PathBuf, String);

/// Numbers behind charts and tables.
pub struct Numbers {
    /// The ledger.
    pub entries: Vec<Entry>,
    /// CSV of the ulp plot.
    pub ulp: String,
    /// CSV of the failure map.
    pub map: String,
}

/// Why the published arc loses its digits and its sign; the caption of the failure map.
const CAUSE: [&str; 2] = [
    "Cause: cancellation. The published fit of Si is off by a bias that does not cancel between the two ends of an arc,",
    "and its antiderivative is not monotone; away from the peak the difference is smaller than the bias, or negative.",
];

/// All charts.
pub fn charts(numbers: &Numbers) -> Result<Vec<File>, String> {
    let entries = &numbers.entries;
    let mut files = Vec::new();
    for (function, title) in [
        ("sine_integral", "Sine integral: error against time"),
        (
            "sinc_squared_integral",
            "Integral of sinc\u{b2} over an arc: error against time",
        ),
    ] {
        let text = error_time::draw(function, title, entries)?;
        files.push((PathBuf::from(format!("docs/charts/{function}_error_time.svg")), text));
    }
    let (bins, peer) = series::read_ulp(&numbers.ulp)?;
    let words = entries
        .iter()
        .find(|e| e.function == "sine_integral" && e.method == peer)
        .map_or(peer.clone(), |e| e.label.clone());
    let text = ulp::draw("sine_integral in f64: error over x", &bins, &words);
    files.push((PathBuf::from("docs/charts/sine_integral_ulp.svg"), text));
    let cells = series::read_map(&numbers.map)?;
    let title = "Relative error of the sinc\u{b2} arc: the published fit and ours";
    let text = failures::draw(title, CAUSE, &cells);
    files.push((PathBuf::from("docs/failures/sinc_squared_integral_vwh18.svg"), text));
    Ok(files)
}

/// All pages below the root that carry generated parts, renewed.
pub fn renewed_pages(root: &Path, entries: &[Entry]) -> Result<Vec<File>, String> {
    let mut files = Vec::new();
    for path in pages::files(root).map_err(|e| e.to_string())? {
        let text = std::fs::read_to_string(root.join(&path)).map_err(|e| format!("{}: {e}", path.display()))?;
        if text.contains("<!-- report:") {
            let new = pages::renew(&text, |name| tables::table(name, entries))
                .map_err(|e| format!("{}: {e}", path.display()))?;
            files.push((path, new));
        }
    }
    Ok(files)
}
