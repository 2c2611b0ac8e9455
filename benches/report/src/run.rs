//! The four ways to run `report`: full, quick, check, render.

use crate::ledger::{self, COLUMNS, Entry};
use crate::map_grid::{self, Panel};
use crate::measured::{self, FULL, QUICK};
use crate::render::{self, File, Numbers};
use crate::{digit_map, error_map, fourier_figures, light_figures, names, number_table, series, summary};
use reference::registry::Origin;
use std::path::{Path, PathBuf};

/// Path of the ledger below the root.
pub const LEDGER: &str = "data/accuracy.csv";
/// Path of the ulp plot's numbers.
pub const ULP: &str = "data/charts/sine_integral_ulp.csv";
/// Path of the failure map's numbers.
pub const MAP: &str = "data/charts/sinc_squared_integral_failures.csv";

/// Path of the numbers of the scaled Bessel function's ulp plot.
pub const BESSEL_ULP: &str = "data/charts/bessel_i0_scaled_ulp.csv";
/// Path of the map of w over the complex plane.
pub const PLANE: &str = "data/charts/faddeeva_w_digits.csv";
/// Path of the map of the spatial phase over the hemisphere.
pub const PHASE: &str = "data/charts/spatial_phase_digits.csv";
/// Path of the map of the mean over a footprint.
pub const FOOTPRINT: &str = "data/charts/footprint_mean_errors.csv";
/// Path of the map of the triangle's transform.
pub const TRIANGLE: &str = "data/charts/profile_triangle_errors.csv";

/// Path of the map of ten scratches over the hemisphere.
pub const TEN: &str = "data/charts/ten_scratches.csv";
/// Path of the map of a sphere's light.
pub const LIGHT: &str = "data/charts/sphere_light_errors.csv";
/// Path of the samples that Monte Carlo needs, by the size of a light.
pub const SIZES: &str = "data/charts/sphere_light_samples.csv";
/// Path of the cuts of one scratch's lobe.
pub const ONE: &str = "data/charts/one_scratch.csv";

/// What measures a map.
type Measurement = fn() -> Result<Vec<Panel>, String>;
/// The maps of panels: where each lies and what measures it.
const MAPS: [(&str, Measurement); 6] = [
    (PLANE, digit_map::faddeeva_w),
    (PHASE, digit_map::spatial_phase),
    (FOOTPRINT, error_map::footprint),
    (TRIANGLE, error_map::triangle),
    (TEN, fourier_figures::ten_scratches),
    (LIGHT, error_map::light),
];

/// What to do.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Mode {
    /// Measure all, write into the tree.
    Full,
    /// Measure little, write elsewhere.
    Quick,
    /// Measure errors again and compare; write nothing.
    Check,
    /// Draw again from the committed numbers.
    Render,
}

/// What a run has to say.
pub struct Report {
    /// Summary in words.
    pub text: String,
    /// False where a check found stale files, or a budget of the ledger is broken in a check.
    pub passed: bool,
}

/// The root of the repository.
pub fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR"))
        .ancestors()
        .nth(2)
        .unwrap_or(Path::new("."))
        .to_path_buf()
}

/// Runs; `out` is where files go instead of the tree.
pub fn run(mode: Mode, out: Option<PathBuf>) -> Result<Report, String> {
    match mode {
        Mode::Full => measure(measured::FULL, out.unwrap_or_else(root)),
        Mode::Quick => measure(
            QUICK,
            out.unwrap_or_else(|| std::env::temp_dir().join("iridescence-report")),
        ),
        Mode::Check => check(),
        Mode::Render => {
            let numbers = committed()?;
            let mut files = render::charts(&numbers)?;
            files.extend(render::renewed_pages(&root(), &numbers)?);
            let target = out.unwrap_or_else(root);
            write(&target, &files)?;
            Ok(Report {
                text: format!("drawn from {LEDGER}:\n{}", listed(&files)),
                passed: true,
            })
        }
    }
}

fn measure(effort: measured::Effort, target: PathBuf) -> Result<Report, String> {
    let mut entries = measured::accuracies(effort);
    measured::times(&mut entries, effort);
    let numbers = Numbers {
        ulp: measured::ulp(measured::best_peer("sine_integral", &entries)?, effort)?,
        map: measured::map()?,
        bessel_ulp: measured::best_peer("bessel_i0_scaled", &entries)
            .and_then(|peer| measured::ulp(peer, effort))
            .ok(),
        panels: MAPS
            .iter()
            .map(|(path, measure)| Ok((*path, map_grid::write(&measure()?))))
            .collect::<Result<_, String>>()?,
        one_scratch: Some(fourier_figures::one_scratch()),
        light_sizes: Some(light_figures::write(&light_figures::sizes())),
        entries,
    };
    let mut files = vec![
        (PathBuf::from(LEDGER), ledger::write(&numbers.entries)),
        (PathBuf::from(ULP), numbers.ulp.clone()),
        (PathBuf::from(MAP), numbers.map.clone()),
    ];
    let lines = numbers.bessel_ulp.iter().map(|text| (BESSEL_ULP, text));
    let lines = lines.chain(numbers.one_scratch.iter().map(|text| (ONE, text)));
    let lines = lines.chain(numbers.light_sizes.iter().map(|text| (SIZES, text)));
    let maps = numbers.panels.iter().map(|(path, text)| (*path, text));
    files.extend(
        lines
            .chain(maps)
            .map(|(path, text)| (PathBuf::from(path), text.clone())),
    );
    // The ledger keeps five digits; what is drawn must follow from what is written.
    let numbers = Numbers {
        entries: ledger::read(&files[0].1)?,
        ..numbers
    };
    files.extend(render::charts(&numbers)?);
    files.extend(render::renewed_pages(&root(), &numbers)?);
    write(&target, &files)?;
    let text = format!(
        "{}written below {}:\n{}",
        summary::text(&numbers.entries),
        target.display(),
        listed(&files)
    );
    Ok(Report { text, passed: true })
}

fn listed(files: &[File]) -> String {
    files
        .iter()
        .map(|(path, _)| format!("  {}\n", path.display()))
        .collect()
}

fn write(target: &Path, files: &[File]) -> Result<(), String> {
    for (path, text) in files {
        let full = target.join(path);
        if std::fs::read_to_string(&full).is_ok_and(|old| old == *text) {
            continue;
        }
        if let Some(folder) = full.parent() {
            std::fs::create_dir_all(folder).map_err(|e| format!("{}: {e}", folder.display()))?;
        }
        std::fs::write(&full, text).map_err(|e| format!("{}: {e}", full.display()))?;
    }
    Ok(())
}

fn read(path: &str) -> Result<String, String> {
    std::fs::read_to_string(root().join(path)).map_err(|e| format!("{path}: {e}"))
}

/// The committed numbers.
pub fn committed() -> Result<Numbers, String> {
    Ok(Numbers {
        entries: ledger::read(&read(LEDGER)?)?,
        ulp: read(ULP)?,
        map: read(MAP)?,
        bessel_ulp: read(BESSEL_ULP).ok(),
        one_scratch: read(ONE).ok(),
        light_sizes: read(SIZES).ok(),
        panels: MAPS
            .iter()
            .filter_map(|(path, _)| Some((*path, read(path).ok()?)))
            .collect(),
    })
}

/// Where charts and pages drawn from the committed numbers differ from the committed files.
pub fn stale_drawings(numbers: &Numbers) -> Result<Vec<String>, String> {
    let mut files = render::charts(numbers)?;
    files.extend(render::renewed_pages(&root(), numbers)?);
    Ok(files.iter().filter_map(|(path, text)| stale(path, text)).collect())
}

fn stale(path: &Path, text: &str) -> Option<String> {
    let committed = std::fs::read_to_string(root().join(path)).unwrap_or_default();
    if committed == text {
        return None;
    }
    let line = committed.lines().zip(text.lines()).position(|(a, b)| a != b);
    let place = line.map_or("length".to_string(), |l| format!("line {}", l + 1));
    Some(format!("{} is stale ({place})", path.display()))
}

/// Columns that come from a clock or name the machine.
const CLOCK: [&str; 4] = ["device", "ns", "cost", "baseline"];
/// Error columns, which may differ by a tenth for methods on the platform's maths.
const ERRORS: [&str; 8] = [
    "max_abs",
    "max_rel",
    "p999_rel",
    "max_ulp",
    "max_eps",
    "max_peak",
    "wrong_sign",
    "non_finite",
];

/// Where a committed row and a fresh one disagree. Our own rows are the same to the last character on every machine;
/// peers and printed formulas use the platform's maths, so their errors may differ by a tenth and their worst input freely.
pub fn row_difference(committed: &Entry, fresh: &Entry) -> Option<String> {
    let (a, b) = (committed.record(), fresh.record());
    let own = fresh.origin == Origin::Ours;
    for (i, name) in COLUMNS.iter().enumerate() {
        let free = CLOCK.contains(name) || (!own && *name == "worst_input");
        let close = !own && ERRORS.contains(name) && number_table::near(&a[i], &b[i]);
        if !free && !close && a[i] != b[i] {
            return Some(format!(
                "{LEDGER}: {} / {} ({} {}): {name} is {} and measures {}",
                fresh.function,
                fresh.method,
                names::precision(fresh.precision),
                fresh.call,
                a[i],
                b[i]
            ));
        }
    }
    None
}

/// How the methods of optional peers begin.
const OPTIONAL: [&str; 2] = ["gsl", "libcerf"];

/// Whether a row's method is registered only where a feature asks for it, and so not in every build.
fn behind_feature(entry: &Entry) -> bool {
    entry.origin == Origin::Peer && OPTIONAL.iter().any(|name| entry.method.starts_with(name))
}

/// Measures the ulp plot again with the committed peer. A peer that this build lacks is replaced by the best it has, and
/// its column is not compared.
fn ulp_difference(function: &str, committed: &str, fresh: &[Entry]) -> Result<Option<String>, String> {
    let (_, name) = series::read_ulp(committed)?;
    let best = measured::best_peer(function, fresh)?;
    let registered = fresh.iter().any(|e| e.function == function && e.method == name);
    if registered && best.method != name && !OPTIONAL.iter().any(|o| best.method.starts_with(o)) {
        return Ok(Some(format!("the best peer is {}, the file has {name}", best.method)));
    }
    let measured = measured::ulp(best, FULL)?;
    let same_peer = best.method == name;
    let measured = measured.replacen(best.method, &name, 1);
    let (loose, free): (&[&str], &[&str]) = if same_peer { (&[&name], &[]) } else { (&[], &[&name]) };
    Ok(number_table::same_table(committed, &measured, loose, free).err())
}

fn check() -> Result<Report, String> {
    let numbers = committed()?;
    let fresh = measured::accuracies(FULL);
    let mut found = Vec::new();
    for e in &fresh {
        match numbers.entries.iter().find(|c| c.is_row_of(e)) {
            Some(c) => found.extend(row_difference(c, e)),
            None if behind_feature(e) => {}
            None => found.push(format!("{LEDGER}: {} / {} is missing", e.function, e.method)),
        }
    }
    for c in &numbers.entries {
        if !behind_feature(c) && !fresh.iter().any(|e| e.is_row_of(c)) {
            found.push(format!(
                "{LEDGER}: {} / {} is no longer registered",
                c.function, c.method
            ));
        }
    }
    found.extend(ulp_difference("sine_integral", &numbers.ulp, &fresh)?.map(|e| format!("{ULP}: {e}")));
    if let Some(committed) = &numbers.bessel_ulp {
        let difference = ulp_difference("bessel_i0_scaled", committed, &fresh)?;
        found.extend(difference.map(|e| format!("{BESSEL_ULP}: {e}")));
    }
    if let Some(committed) = &numbers.one_scratch {
        let difference = fourier_figures::difference(committed, &fourier_figures::one_scratch())?;
        found.extend(difference.map(|e| format!("{ONE}: {e}")));
    }
    if let Some(committed) = &numbers.light_sizes {
        let measured = light_figures::write(&light_figures::sizes());
        let difference = number_table::same_table(committed, &measured, &light_figures::COLUMNS, &[]);
        found.extend(difference.err().map(|e| format!("{SIZES}: {e}")));
    }
    for (path, measure) in MAPS {
        match numbers.map_of(path) {
            Some(committed) => {
                found.extend(map_grid::difference(committed, &measure()?)?.map(|e| format!("{path}: {e}")));
            }
            None => found.push(format!("{path} is missing")),
        }
    }
    found.extend(
        number_table::same_table(&numbers.map, &measured::map()?, &[], &[])
            .err()
            .map(|e| format!("{MAP}: {e}")),
    );
    found.extend(stale_drawings(&numbers)?);
    found.extend(fresh.iter().filter_map(crate::promise::complaint));
    let passed = found.is_empty();
    let text = if passed {
        format!(
            "ledger, charts and tables are current; {} methods measured again\n",
            fresh.len()
        )
    } else {
        let lines: String = found.iter().map(|f| format!("  {f}\n")).collect();
        format!(
            "{} differences; a full run of report renews the files:\n{lines}",
            found.len()
        )
    };
    Ok(Report { text, passed })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ledger::sample;
    use reference::registry::Precision;

    #[test]
    fn own_rows_must_agree_exactly_and_clock_columns_are_free() {
        let a = sample("accurate", Origin::Ours, Precision::F64, 10.0, 1e-16);
        let mut b = a.clone();
        b.ns = 99.0;
        b.device = "another".to_string();
        assert_eq!(row_difference(&a, &b), None);
        b.max_ulp = 0.70001;
        assert!(row_difference(&a, &b).expect("differs").contains("max_ulp"));
        let a = sample("cephes", Origin::Peer, Precision::F64, 10.0, 1e-16);
        let mut b = a.clone();
        (b.max_ulp, b.worst) = (0.72, vec![1.0]);
        assert_eq!(row_difference(&a, &b), None);
        b.max_ulp = 0.9;
        assert!(row_difference(&a, &b).is_some());
    }
}
