//! Numbers that keep their bits: every emitted `f32` literal parses to the bits that rustc gives it.

use crate::kind::Kind;

/// WGSL text of a float literal with its `f` suffix, or the reason why it has none.
///
/// The Rust digits stay where decimal to f64 to f32 and decimal to f32 agree, since a WGSL compiler may
/// take either way; otherwise the exact decimal expansion of the f32 is written, which both read alike.
pub(crate) fn float(digits: &str, suffix: &str) -> Result<String, String> {
    if !matches!(suffix, "" | "f32") {
        return Err(format!("literal suffix `{suffix}`: only f32 is in the subset"));
    }
    let parse = |text: &str| text.parse::<f32>().map_err(|e| format!("float literal: {e}"));
    let value = parse(digits)?;
    if value.is_infinite() {
        return Err("the literal overflows f32".into());
    }
    if value.is_subnormal() || (value == 0.0 && !zero_mantissa(digits)) {
        return Err("a subnormal literal: a GPU may flush it to zero".into());
    }
    let mut text = digits.to_owned();
    if twice_rounded(&text) != value.to_bits() {
        text = format!("{:.150}", f64::from(value));
        text.truncate(text.trim_end_matches('0').len());
    }
    if text.ends_with('.') {
        text.push('0');
    }
    Ok(text + "f")
}

/// Whether all digits before the exponent are zero.
fn zero_mantissa(digits: &str) -> bool {
    digits
        .bytes()
        .take_while(|b| !b.eq_ignore_ascii_case(&b'e'))
        .all(|b| matches!(b, b'0' | b'.' | b'-'))
}

/// Bits of the text read as f64 and then rounded to f32.
pub(crate) fn twice_rounded(text: &str) -> u32 {
    text.parse::<f64>().map_or(u32::MAX, |v| (v as f32).to_bits())
}

/// WGSL text and type of an integer literal.
pub(crate) fn integer(token: &str, digits: &str, suffix: &str) -> Result<(String, Kind), String> {
    let value: u64 = digits.parse().map_err(|e| format!("integer literal: {e}"))?;
    let hexadecimal = token.starts_with("0x");
    let text = if hexadecimal {
        format!("0x{value:x}")
    } else {
        value.to_string()
    };
    let (limit, kind, mark) = match suffix {
        "" => (u64::from(u32::MAX), Kind::Whole, ""),
        "i32" => (i32::MAX as u64, Kind::I32, "i"),
        "u32" => (u64::from(u32::MAX), Kind::U32, "u"),
        other => {
            return Err(format!("literal suffix `{other}`: only i32 and u32 are in the subset"));
        }
    };
    if value > limit {
        return Err("the literal overflows its type".into());
    }
    Ok((text + mark, kind))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn digits_are_kept_where_both_ways_of_reading_agree() {
        assert_eq!(float("0.5", ""), Ok("0.5f".into()));
        assert_eq!(float("1.", ""), Ok("1.0f".into()));
        assert_eq!(float("1e-3", "f32"), Ok("1e-3f".into()));
        assert_eq!(float("-0.0", ""), Ok("-0.0f".into()));
    }

    #[test]
    fn a_literal_that_rounds_differently_through_f64_is_written_out_exactly() {
        // 1 + 2^-24 lies half way between two f32; a digit far behind decides, and f64 loses it.
        let digits = "1.00000005960464477539062500000001";
        let value = digits.parse::<f32>().expect("a float");
        assert_ne!(twice_rounded(digits), value.to_bits());
        let text = float(digits, "").expect("in the subset");
        let text = text.trim_end_matches('f');
        assert_eq!(twice_rounded(text), value.to_bits());
        assert_eq!(text.parse::<f32>().map(f32::to_bits), Ok(value.to_bits()));
    }

    #[test]
    fn subnormal_and_overflowing_literals_are_refused() {
        assert!(float("1e-40", "").is_err());
        assert!(float("1e-60", "").is_err());
        assert!(float("1e39", "").is_err());
        assert!(float("1.0", "f64").is_err());
        assert_eq!(float("0.0e5", ""), Ok("0.0e5f".into()));
    }

    #[test]
    fn integers_keep_their_base_and_suffix() {
        assert_eq!(integer("0x7fffu32", "32767", "u32"), Ok(("0x7fffu".into(), Kind::U32)));
        assert_eq!(integer("6", "6", ""), Ok(("6".into(), Kind::Whole)));
        assert!(integer("3_000_000_000i32", "3000000000", "i32").is_err());
        assert!(integer("1u64", "1", "u64").is_err());
    }
}
