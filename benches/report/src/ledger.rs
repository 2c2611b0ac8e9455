//! The ledger `data/accuracy.csv`: one row a method and domain, with its error there, its promise and its cost.
//!
//! Error columns are functions of the code and the seed. The columns `device`, `ns` and `cost` come from a clock
//! and are rewritten by a full run only.

use crate::budget_text::{budget_text, parse_budget};
use crate::{hex_float, names};
use reference::registry::{Budget, Metric, Origin, Precision, function};

/// One row of the ledger.
#[derive(Clone, Debug)]
pub struct Entry {
    /// Name of the function.
    pub function: String,
    /// Name of the method.
    pub method: String,
    /// Precision it computes in.
    pub precision: Precision,
    /// Whose it is.
    pub origin: Origin,
    /// `scalar` or `slice`.
    pub call: String,
    /// The scalar method of which this is the slice form.
    pub slice_of: String,
    /// What it is, in words.
    pub label: String,
    /// Machine of the timing.
    pub device: String,
    /// Inputs on which the error was measured.
    pub domain: String,
    /// Number of those inputs.
    pub points: u64,
    /// Whether they are all inputs there are.
    pub exhaustive: bool,
    /// The promise, if one is made.
    pub budget: Option<Budget>,
    /// Largest absolute error.
    pub max_abs: f64,
    /// Largest relative error.
    pub max_rel: f64,
    /// 99.9th percentile of the relative error.
    pub p999_rel: f64,
    /// Largest error in units in the last place of the method's precision.
    pub max_ulp: f64,
    /// Largest relative error in units of the method's epsilon.
    pub max_eps: f64,
    /// Largest error as a multiple of the function's own scale; not a number where it has none.
    pub max_peak: f64,
    /// Share of results with the wrong sign, or of complex ones that point away from the truth.
    pub wrong_sign: f64,
    /// Number of results that are not finite where the truth is.
    pub non_finite: u64,
    /// Input of the largest error in the budget's measure.
    pub worst: Vec<f64>,
    /// What the error was measured against.
    pub reference: String,
    /// Nanoseconds per row of inputs.
    pub ns: f64,
    /// Time as a ratio to the baseline in the same run.
    pub cost: f64,
    /// Method that the ratio refers to.
    pub baseline: String,
}

/// Column titles, in order.
pub const COLUMNS: [&str; 25] = [
    "function",
    "method",
    "precision",
    "origin",
    "call",
    "slice_of",
    "label",
    "device",
    "domain",
    "points",
    "exhaustive",
    "budget",
    "max_abs",
    "max_rel",
    "p999_rel",
    "max_ulp",
    "max_eps",
    "max_peak",
    "wrong_sign",
    "non_finite",
    "worst_input",
    "reference",
    "ns",
    "cost",
    "baseline",
];

/// The number a text writes.
pub fn parse<T: std::str::FromStr>(text: &str) -> Result<T, String> {
    text.parse().map_err(|_| format!("\"{text}\" is not a number"))
}

/// Five significant digits, enough to compare with a budget and the same on every machine.
pub fn error_text(value: f64) -> String {
    if value == 0.0 {
        "0".to_string()
    } else {
        format!("{value:.4e}")
    }
}

/// What [`Entry::charted`] is for a function, in words.
pub fn charted_error(name: &str) -> String {
    let plain = match name {
        "sinc_squared_integral" | "sinc_squared_integral_turns" => "99.9th percentile of the relative error",
        "sine" | "cosine" => "largest absolute error",
        "faddeeva_w" => "largest norm-wise error, upper half plane",
        _ => "largest relative error",
    };
    let peak = function(name).and_then(|f| f.peak);
    peak.map_or(plain.to_string(), |peak| {
        format!("largest error as a multiple of {}", peak.words)
    })
}

impl Entry {
    /// What names the method: function, method, precision and call. Of the rows of one method the first is that of its
    /// main domain; it alone has a time.
    pub fn key(&self) -> (&str, &str, Precision, &str) {
        (&self.function, &self.method, self.precision, &self.call)
    }

    /// Whether it is the row of the same method on the same domain, with a promise of the same kind.
    pub fn is_row_of(&self, other: &Entry) -> bool {
        let metric = |e: &Entry| e.budget.map(|b| b.metric);
        self.key() == other.key() && self.domain == other.domain && metric(self) == metric(other)
    }

    /// The measured error in the budget's measure.
    pub fn measured(&self, metric: Metric) -> f64 {
        match metric {
            Metric::Ulp => self.max_ulp,
            Metric::Eps => self.max_eps,
            Metric::Absolute => self.max_abs,
            Metric::Relative => self.max_rel,
            Metric::Peak => self.max_peak,
        }
    }

    /// The error that charts and fronts show; [`charted_error`] names it.
    ///
    /// A relative error has no bound where a function vanishes: beside the double zeros of sinc^2 the largest one tells
    /// of the last place of the input alone, so an arc shows what 99.9 % of its errors keep, and a sine or cosine its
    /// absolute error. A function with a scale of its own shows the error as a multiple of it.
    pub fn charted(&self) -> f64 {
        match self.function.as_str() {
            "sinc_squared_integral" | "sinc_squared_integral_turns" => self.p999_rel,
            "sine" | "cosine" => self.max_abs,
            name if function(name).is_some_and(|f| f.peak.is_some()) => self.max_peak,
            _ => self.max_rel,
        }
    }

    /// The texts of the columns.
    pub fn record(&self) -> Vec<String> {
        let worst: Vec<String> = self.worst.iter().map(|&x| hex_float::format(x)).collect();
        vec![
            self.function.clone(),
            self.method.clone(),
            names::precision(self.precision).to_string(),
            names::origin(self.origin).to_string(),
            self.call.clone(),
            self.slice_of.clone(),
            self.label.clone(),
            self.device.clone(),
            self.domain.clone(),
            self.points.to_string(),
            if self.exhaustive { "yes" } else { "no" }.to_string(),
            budget_text(self.budget),
            error_text(self.max_abs),
            error_text(self.max_rel),
            error_text(self.p999_rel),
            error_text(self.max_ulp),
            error_text(self.max_eps),
            if self.max_peak.is_nan() {
                String::new()
            } else {
                error_text(self.max_peak)
            },
            error_text(self.wrong_sign),
            self.non_finite.to_string(),
            worst.join(" "),
            self.reference.clone(),
            format!("{:.4}", self.ns),
            format!("{:.3}", self.cost),
            self.baseline.clone(),
        ]
    }

    fn from_record(r: &csv::StringRecord) -> Result<Self, String> {
        let mut columns = r.iter();
        let mut next = || columns.next().ok_or("a column is missing".to_string());
        let choose = |text: &str, yes: &str, no: &str| match text {
            t if t == yes => Ok(true),
            t if t == no => Ok(false),
            t => Err(format!("\"{t}\" is neither {yes} nor {no}")),
        };
        Ok(Self {
            function: next()?.to_string(),
            method: next()?.to_string(),
            precision: if choose(next()?, "f64", "f32")? {
                Precision::F64
            } else {
                Precision::F32
            },
            origin: match next()? {
                "ours" => Origin::Ours,
                "published" => Origin::Published,
                "peer" => Origin::Peer,
                other => return Err(format!("unknown origin \"{other}\"")),
            },
            call: next()?.to_string(),
            slice_of: next()?.to_string(),
            label: next()?.to_string(),
            device: next()?.to_string(),
            domain: next()?.to_string(),
            points: parse(next()?)?,
            exhaustive: choose(next()?, "yes", "no")?,
            budget: parse_budget(next()?)?,
            max_abs: parse(next()?)?,
            max_rel: parse(next()?)?,
            p999_rel: parse(next()?)?,
            max_ulp: parse(next()?)?,
            max_eps: parse(next()?)?,
            max_peak: match next()? {
                "" => f64::NAN,
                text => parse(text)?,
            },
            wrong_sign: parse(next()?)?,
            non_finite: parse(next()?)?,
            worst: next()?
                .split_ascii_whitespace()
                .map(|w| hex_float::parse(w).map_or_else(|| parse(w), Ok))
                .collect::<Result<_, _>>()?,
            reference: next()?.to_string(),
            ns: parse(next()?)?,
            cost: parse(next()?)?,
            baseline: next()?.to_string(),
        })
    }
}

/// The ledger as CSV text.
pub fn write(entries: &[Entry]) -> String {
    let mut writer = csv::Writer::from_writer(Vec::new());
    writer.write_record(COLUMNS).expect("writing to memory");
    for entry in entries {
        writer.write_record(entry.record()).expect("writing to memory");
    }
    String::from_utf8(writer.into_inner().expect("writing to memory")).expect("columns are UTF-8")
}

/// The rows of a CSV text, or what is wrong with it and where.
pub fn read(text: &str) -> Result<Vec<Entry>, String> {
    let mut reader = csv::Reader::from_reader(text.as_bytes());
    let header = reader.headers().map_err(|e| e.to_string())?;
    if !header.iter().eq(COLUMNS) {
        return Err("the ledger's columns are not those of this program".to_string());
    }
    let mut entries = Vec::new();
    for (i, record) in reader.records().enumerate() {
        let record = record.map_err(|e| e.to_string())?;
        entries.push(Entry::from_record(&record).map_err(|e| format!("ledger row {}: {e}", i + 2))?);
    }
    Ok(entries)
}

#[cfg(test)]
pub(crate) fn sample(method: &str, origin: Origin, precision: Precision, ns: f64, max_rel: f64) -> Entry {
    Entry {
        function: "sine_integral".to_string(),
        method: method.to_string(),
        precision,
        origin,
        call: "scalar".to_string(),
        slice_of: String::new(),
        label: format!("{method}, in words"),
        device: "a machine".to_string(),
        domain: "all of f64, with edges".to_string(),
        points: 1000,
        exhaustive: false,
        budget: (origin == Origin::Ours).then_some(Budget {
            metric: Metric::Relative,
            bound: 2.0 * max_rel,
        }),
        max_abs: max_rel,
        max_rel,
        p999_rel: 0.9 * max_rel,
        max_ulp: 0.7,
        max_eps: 0.7,
        max_peak: f64::NAN,
        wrong_sign: 0.0,
        non_finite: 0,
        worst: vec![-3.5],
        reference: "an oracle".to_string(),
        ns,
        cost: 1.0,
        baseline: "cephes".to_string(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_ledger_survives_writing_and_reading() {
        let mut entries = vec![
            sample("accurate", Origin::Ours, Precision::F64, 12.5, 1.5e-16),
            sample("fit", Origin::Published, Precision::F32, 0.25, 3.0e-2),
        ];
        entries[1].worst = vec![f64::INFINITY, -0.0];
        entries[1].max_peak = 0.5;
        let text = write(&entries);
        let again = read(&text).expect("what was written can be read");
        assert!(again.iter().map(Entry::record).eq(entries.iter().map(Entry::record)));
        assert!(text.contains("\"all of f64, with edges\""));
        assert!(
            read(&text.replace("relative", "parsec"))
                .expect_err("unknown unit")
                .contains("parsec")
        );
        assert!(read(&text.replace("max_abs", "max")).is_err());
    }
}
