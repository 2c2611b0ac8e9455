//! Why a source cannot be translated, and where.

use std::fmt;

/// A construct outside the subset: the file, the place and the reason.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Refusal {
    /// File as it was named to the translator.
    pub file: String,
    /// Line, counted from 1.
    pub line: usize,
    /// Column, counted from 1.
    pub column: usize,
    /// What was met and what to write instead.
    pub reason: String,
}

impl Refusal {
    /// Refusal at the start of `span`.
    pub(crate) fn at(file: &str, span: proc_macro2::Span, reason: impl Into<String>) -> Self {
        let start = span.start();
        Refusal {
            file: file.to_owned(),
            line: start.line,
            column: start.column + 1,
            reason: reason.into(),
        }
    }
}

impl fmt::Display for Refusal {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}:{}:{}: {}", self.file, self.line, self.column, self.reason)
    }
}

impl std::error::Error for Refusal {}
