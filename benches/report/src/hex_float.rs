//! Hexadecimal floating-point text, exact both ways: `0x1.8p+1` is 3.

/// The exact hexadecimal text of a number; `inf`, `-inf` and `NaN` for what has no digits.
pub fn format(value: f64) -> String {
    if !value.is_finite() {
        return format!("{value}");
    }
    let sign = if value.is_sign_negative() { "-" } else { "" };
    let bits = value.to_bits();
    let (exponent, fraction) = ((bits >> 52 & 0x7ff) as i32, bits & ((1 << 52) - 1));
    if exponent == 0 && fraction == 0 {
        return format!("{sign}0x0p+0");
    }
    let (lead, power) = if exponent == 0 {
        (0, -1022)
    } else {
        (1, exponent - 1023)
    };
    let digits = format!("{fraction:013x}");
    let digits = digits.trim_end_matches('0');
    let point = if digits.is_empty() { "" } else { "." };
    format!("{sign}0x{lead}{point}{digits}p{power:+}")
}

/// The number written by a hexadecimal text of at most 53 significant bits, or `None` where the text is not
/// one or its value is not a binary64 number.
pub fn parse(text: &str) -> Option<f64> {
    let (negative, rest) = match text.strip_prefix('-') {
        Some(rest) => (true, rest),
        None => (false, text.strip_prefix('+').unwrap_or(text)),
    };
    let rest = rest.strip_prefix("0x").or_else(|| rest.strip_prefix("0X"))?;
    let (digits, power) = rest.split_once(['p', 'P']).unwrap_or((rest, "0"));
    let power: i32 = power.parse().ok()?;
    let (whole, fraction) = digits.split_once('.').unwrap_or((digits, ""));
    if whole.len() + fraction.len() == 0 {
        return None;
    }
    let mut mantissa = 0_u64;
    for c in whole.chars().chain(fraction.chars()) {
        mantissa = mantissa.checked_mul(16)?.checked_add(u64::from(c.to_digit(16)?))?;
    }
    let mut power = power.checked_sub(4 * i32::try_from(fraction.len()).ok()?)?;
    if mantissa == 0 {
        return Some(if negative { -0.0 } else { 0.0 });
    }
    let trailing = mantissa.trailing_zeros();
    mantissa >>= trailing;
    power = power.checked_add(trailing as i32)?;
    let width = 64 - mantissa.leading_zeros() as i32;
    if width > 53 || power < -1074 || power.checked_add(width)? > 1024 {
        return None;
    }
    // Two exact steps: the first factor is a normal power of two, the second cannot round (power >= -1074).
    let half = power / 2;
    let value = mantissa as f64 * libm::ldexp(1.0, half) * libm::ldexp(1.0, power - half);
    Some(if negative { -value } else { value })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_kind_of_number_survives_the_round_trip() {
        let mut bits = 0x9e37_79b9_7f4a_7c15_u64;
        let mut values = vec![0.0, -0.0, 1.0, -1.5, f64::MIN_POSITIVE, 5e-324, f64::MAX, 1e-310, 0.1];
        for _ in 0..10_000 {
            bits = bits.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
            values.push(f64::from_bits(bits));
        }
        for v in values {
            if v.is_finite() {
                assert_eq!(
                    parse(&format(v)).map(f64::to_bits),
                    Some(v.to_bits()),
                    "{v:e} {}",
                    format(v)
                );
            }
        }
    }

    #[test]
    fn texts_are_as_in_c() {
        assert_eq!(format(3.0), "0x1.8p+1");
        assert_eq!(format(-0.0), "-0x0p+0");
        assert_eq!(format(5e-324), "0x0.0000000000001p-1022");
        assert_eq!(parse("0x1p-1074"), Some(5e-324));
    }

    #[test]
    fn what_is_no_binary64_number_is_refused() {
        for text in [
            "1.0",
            "0x",
            "0x1p",
            "0x1p1024",
            "0x1p-1075",
            "0x1.00000000000001p0",
            "0xg",
            "0x1.8.0p0",
        ] {
            assert_eq!(parse(text), None, "{text}");
        }
    }
}
