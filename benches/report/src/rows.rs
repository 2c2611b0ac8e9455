//! Rows of numbers in text: comma or blank separated columns, `#` comments, blank lines skipped.

use crate::hex_float;
use std::io::{self, BufRead};

/// Longest accepted line in bytes; a longer one is refused without being held in memory.
pub const LONGEST_LINE: usize = 1 << 20;

/// Why a line is no row.
#[derive(Debug, PartialEq, Eq)]
pub struct Refusal {
    /// Line number, from 1.
    pub line: u64,
    /// Column number, from 1, where one column is at fault.
    pub column: Option<usize>,
    /// The reason in words.
    pub reason: String,
}

impl std::fmt::Display for Refusal {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "line {}", self.line)?;
        if let Some(column) = self.column {
            write!(f, ", column {column}")?;
        }
        write!(f, ": {}", self.reason)
    }
}

/// What the reader found next.
#[derive(Debug, PartialEq, Eq)]
pub enum Next {
    /// A row stands in the buffer.
    Row,
    /// The input has ended.
    End,
    /// The line is no row.
    Bad(Refusal),
}

/// Reads rows of a fixed number of columns, or of a least number and some more at a time.
pub struct Rows<R> {
    input: R,
    least: usize,
    step: usize,
    names: String,
    line: u64,
    bytes: Vec<u8>,
    single: bool,
}

impl<R: BufRead> Rows<R> {
    /// A reader of rows with the named columns; `single` also refuses what binary32 cannot hold.
    pub fn new(input: R, names: &[&str], single: bool) -> Self {
        Self::open(input, names, [names.len(), 0], single)
    }

    /// A reader of rows of at least so many columns, and so many more at a time (0: no more); the names are those of the
    /// first ones.
    pub fn open(input: R, names: &[&str], [least, step]: [usize; 2], single: bool) -> Self {
        let mut shown = names[..least.min(names.len())].join(" ");
        if step > 0 {
            shown.push_str(" ...");
        }
        Self {
            input,
            least,
            step,
            names: shown,
            line: 0,
            bytes: Vec::new(),
            single,
        }
    }

    /// Reads up to the next row and writes its numbers into `row`; `refuse` says which column is out of place, from 0, and
    /// why. For `single` it sees the numbers rounded to f32.
    pub fn next(
        &mut self,
        row: &mut Vec<f64>,
        refuse: impl Fn(&[f64]) -> Option<(usize, &'static str)>,
    ) -> io::Result<Next> {
        loop {
            self.bytes.clear();
            let limit = LONGEST_LINE as u64 + 1;
            let count = io::Read::take(&mut self.input, limit).read_until(b'\n', &mut self.bytes)?;
            if count == 0 {
                return Ok(Next::End);
            }
            self.line += 1;
            if count > LONGEST_LINE && self.bytes.last() != Some(&b'\n') {
                return Ok(Next::Bad(
                    self.bad(None, format!("the line is longer than {LONGEST_LINE} bytes")),
                ));
            }
            let mut bytes = self.bytes.as_slice();
            if self.line == 1 {
                bytes = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes);
            }
            let end = bytes.iter().position(|&b| b == b'#').unwrap_or(bytes.len());
            let Ok(text) = std::str::from_utf8(&bytes[..end]) else {
                return Ok(Next::Bad(self.bad(None, "the line is not UTF-8 text".to_string())));
            };
            let text = text.trim_matches(|c: char| c.is_ascii_whitespace());
            if text.is_empty() {
                continue;
            }
            row.clear();
            if let Err((column, reason)) = self.numbers(text, row) {
                return Ok(Next::Bad(self.bad(column, reason)));
            }
            if self.single {
                row.iter_mut().for_each(|x| *x = f64::from(*x as f32));
            }
            return Ok(match refuse(row) {
                None => Next::Row,
                Some((column, reason)) => Next::Bad(self.bad(Some(column + 1), reason.to_string())),
            });
        }
    }

    /// The refusal of the line read last.
    pub fn bad(&self, column: Option<usize>, reason: String) -> Refusal {
        Refusal {
            line: self.line,
            column,
            reason,
        }
    }

    fn numbers(&self, text: &str, row: &mut Vec<f64>) -> Result<(), (Option<usize>, String)> {
        for field in text.split(',') {
            let field = field.trim_matches(|c: char| c.is_ascii_whitespace());
            if field.is_empty() {
                return Err((Some(row.len() + 1), "the column is empty".to_string()));
            }
            for word in field.split_ascii_whitespace() {
                if row.len() < self.least || self.step > 0 {
                    let value = number(word, self.single).map_err(|reason| (Some(row.len() + 1), reason))?;
                    row.push(value);
                } else {
                    return Err((
                        None,
                        self.count(text.split([',', ' ', '\t']).filter(|w| !w.is_empty()).count()),
                    ));
                }
            }
        }
        let fits = match self.step {
            0 => row.len() == self.least,
            step => row.len() >= self.least && (row.len() - self.least).is_multiple_of(step),
        };
        if fits {
            Ok(())
        } else {
            Err((None, self.count(row.len())))
        }
    }

    fn count(&self, found: usize) -> String {
        let plural = if self.least == 1 { "" } else { "s" };
        let more = match self.step {
            0 => String::new(),
            step => format!(" or {step} more at a time"),
        };
        format!(
            "{} column{plural}{more} expected ({}), {found} found",
            self.least, self.names
        )
    }
}

/// The number a word writes: decimal, hexadecimal (`0x1.8p+1`), `inf` or `nan`. Finite text too large for the
/// precision is refused rather than read as an infinity.
fn number(word: &str, single: bool) -> Result<f64, String> {
    let shown = || {
        let mut short: String = word.chars().take(40).flat_map(char::escape_default).collect();
        if word.chars().nth(40).is_some() {
            short.push_str("...");
        }
        short
    };
    let value = match word.parse::<f64>() {
        Ok(v) => v,
        Err(_) => hex_float::parse(word).ok_or_else(|| {
            let digits = word.trim_start_matches(['+', '-']);
            if digits.starts_with("0x") || digits.starts_with("0X") {
                format!(
                    "\"{}\" is not a number: hexadecimal ones have at most 53 bits and lie in the range of f64",
                    shown()
                )
            } else {
                format!("\"{}\" is not a number", shown())
            }
        })?,
    };
    let finite_text = word.bytes().any(|b| b.is_ascii_digit());
    if finite_text && value.is_infinite() {
        return Err(format!("\"{}\" is beyond the range of f64", shown()));
    }
    if single && value.is_finite() && (value as f32).is_infinite() {
        return Err(format!("\"{}\" is beyond the range of f32", shown()));
    }
    Ok(value)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn not_minus_seven(row: &[f64]) -> Option<(usize, &'static str)> {
        (row[0] == -7.0).then_some((0, "a is -7"))
    }

    fn read(text: &str, names: &[&str]) -> (Vec<Vec<f64>>, Option<Refusal>) {
        let mut rows = Rows::new(text.as_bytes(), names, false);
        let (mut all, mut row) = (Vec::new(), Vec::new());
        loop {
            match rows.next(&mut row, not_minus_seven).expect("reading from memory") {
                Next::Row => all.push(row.clone()),
                Next::End => return (all, None),
                Next::Bad(refusal) => return (all, Some(refusal)),
            }
        }
    }

    #[test]
    fn separators_comments_blank_lines_and_line_ends_are_read() {
        let text = "\u{feff}# head\r\n1,2\r\n\r\n  3\t4 # tail\n5 , 6\n-inf 0x1.8p+1";
        let expected = vec![
            vec![1.0, 2.0],
            vec![3.0, 4.0],
            vec![5.0, 6.0],
            vec![f64::NEG_INFINITY, 3.0],
        ];
        assert_eq!(read(text, &["a", "b"]), (expected, None));
    }

    #[test]
    fn a_bad_line_is_named_with_its_column_and_reason() {
        for (text, line, column, reason) in [
            ("1 2\n1\n", 2, None, "2 columns expected (a b), 1 found"),
            ("1 2 3", 1, None, "2 columns expected (a b), 3 found"),
            ("1,,2", 1, Some(2), "the column is empty"),
            ("1,2,", 1, Some(3), "the column is empty"),
            ("\n\n1 x7", 3, Some(2), "\"x7\" is not a number"),
            (
                "1 0x1p1024",
                1,
                Some(2),
                "\"0x1p1024\" is not a number: hexadecimal ones have at most 53 bits and lie in the range of f64",
            ),
            ("1 1e999", 1, Some(2), "\"1e999\" is beyond the range of f64"),
            ("1;2 3", 1, Some(1), "\"1;2\" is not a number"),
            ("1 2\n-7 2", 2, Some(1), "a is -7"),
        ] {
            let refusal = read(text, &["a", "b"]).1.expect(text);
            assert_eq!(
                (refusal.line, refusal.column, refusal.reason.as_str()),
                (line, column, reason),
                "{text}"
            );
        }
    }

    #[test]
    fn an_open_row_has_a_least_length_and_grows_in_steps() {
        let read = |text: &str| {
            let mut rows = Rows::open(text.as_bytes(), &["a", "b", "c"], [2, 3], false);
            let mut row = Vec::new();
            match rows.next(&mut row, |_| None).expect("reading from memory") {
                Next::Bad(refusal) => Err(refusal.reason),
                _ => Ok(row.len()),
            }
        };
        assert_eq!(
            (read("1 2"), read("1 2 3 4 5"), read("1,2,3,4,5,6,7,8")),
            (Ok(2), Ok(5), Ok(8))
        );
        for wrong in ["1", "1 2 3", "1 2 3 4", "1 2 3 4 5 6"] {
            let reason = read(wrong).expect_err(wrong);
            assert!(
                reason.starts_with("2 columns or 3 more at a time expected (a b ...), "),
                "{reason}"
            );
        }
    }

    #[test]
    fn a_huge_line_is_refused_by_its_length() {
        let text = format!("1 2\n{}\n", "9".repeat(3 * LONGEST_LINE));
        let refusal = read(&text, &["a", "b"]).1.expect("too long");
        assert_eq!(refusal.line, 2);
        assert!(refusal.reason.contains("longer than"), "{}", refusal.reason);
    }

    #[test]
    fn single_precision_refuses_what_it_cannot_hold() {
        assert!(number("1e39", true).is_err() && number("1e39", false).is_ok());
        assert_eq!(number("inf", true), Ok(f64::INFINITY));
    }
}
