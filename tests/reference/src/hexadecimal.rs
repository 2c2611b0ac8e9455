//! Hexadecimal floats, `0x1.8p+1`: the exact text of a number in the data files and in the ledger.

/// Why a text is no number.
#[derive(Debug, PartialEq, Eq)]
pub struct NotANumber(pub String);

/// The number that `text` writes in hexadecimal (`-0x1.8p+1`, `inf`, `nan`). At most 53 significant bits.
pub fn parse(text: &str) -> Result<f64, NotANumber> {
    let refuse = || NotANumber(text.to_owned());
    let (sign, rest) = match text.trim().strip_prefix('-') {
        Some(rest) => (-1.0, rest),
        None => (1.0, text.trim().trim_start_matches('+')),
    };
    match rest {
        "inf" => return Ok(sign * f64::INFINITY),
        "nan" => return Ok(f64::NAN),
        _ => {}
    }
    let (digits, exponent) = rest
        .strip_prefix("0x")
        .and_then(|r| r.split_once('p'))
        .ok_or_else(refuse)?;
    let (whole, fraction) = digits.split_once('.').unwrap_or((digits, ""));
    let significand = u64::from_str_radix(&format!("{whole}{fraction}"), 16).map_err(|_| refuse())?;
    let mut exponent: i32 = exponent.parse().map_err(|_| refuse())?;
    exponent -= 4 * fraction.len() as i32;
    if significand >> 53 != 0 && significand.trailing_zeros() < 11 {
        return Err(refuse());
    }
    // Two exact steps where one would leave the range on the way.
    let half = exponent / 2;
    Ok(sign * significand as f64 * 2f64.powi(half) * 2f64.powi(exponent - half))
}

/// `x` in hexadecimal, as [`parse`] and Python's `float.fromhex` read it.
pub fn format(x: f64) -> String {
    let sign = if x.is_sign_negative() { "-" } else { "" };
    if x.is_nan() {
        return "nan".to_owned();
    }
    if x.is_infinite() {
        return format!("{sign}inf");
    }
    if x == 0.0 {
        return format!("{sign}0x0.0p+0");
    }
    let bits = x.to_bits() & !(1 << 63);
    let (biased, fraction) = (bits >> 52, bits & ((1 << 52) - 1));
    let (whole, exponent) = if biased == 0 {
        (0, -1022)
    } else {
        (1, biased as i32 - 1023)
    };
    format!("{sign}0x{whole}.{fraction:013x}p{exponent:+}")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_class_of_number_survives_a_round_trip() {
        let numbers = [
            0.0,
            -0.0,
            1.0,
            -1.5,
            0.1,
            f64::MAX,
            f64::MIN_POSITIVE,
            5e-324,
            -3e-310,
            f64::INFINITY,
        ];
        for x in numbers {
            assert_eq!(
                parse(&format(x)).unwrap().to_bits(),
                x.to_bits(),
                "{x:e} as {}",
                format(x)
            );
        }
        assert!(parse("nan").unwrap().is_nan());
        assert_eq!(parse("0x1.8p+1"), Ok(3.0));
        assert_eq!(parse("-0x0.0000000000001p-1022"), Ok(-5e-324));
    }

    #[test]
    fn what_is_no_hexadecimal_float_is_refused() {
        for text in ["", "1.5", "0x1.8", "0x1.zp+1", "0x1.fffffffffffffffp+0"] {
            assert!(parse(text).is_err(), "{text}");
        }
    }
}
