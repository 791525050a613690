//! Coordinates in one field: decimals, hexadecimal floats and fractions.

use dashu_int::{IBig, UBig};
use dashu_ratio::RBig;
use exact_ccd_files::excerpt;

use crate::rational::{self, CoordinateError, Rounding};

/// The value of a coordinate in one field, as a finite f64:
///
/// - a decimal, `0.1` or `-1e-3`: the f64 nearest to it, as everywhere where f64 are written so;
/// - a hexadecimal float, `0x1.8p-3`, or a fraction, `3/16`: exactly the number, or the nearest f64 if
///   `rounding` allows it.
pub(crate) fn parse(field: &[u8], rounding: Rounding) -> Result<f64, CoordinateError> {
    if let Some(slash) = field.iter().position(|&byte| byte == b'/') {
        let (numerator, denominator) = (&field[..slash], &field[slash + 1..]);
        return rational::parse(numerator.trim_ascii(), denominator.trim_ascii(), rounding);
    }
    let not_a_number = || CoordinateError::NotANumber(excerpt(field));
    let text = str::from_utf8(field).map_err(|_| not_a_number())?;
    let (is_negative, magnitude) = match text.as_bytes() {
        [b'-', ..] => (true, &text[1..]),
        [b'+', ..] => (false, &text[1..]),
        _ => (false, text),
    };
    let value = if let Some(digits) = magnitude.strip_prefix("0x").or(magnitude.strip_prefix("0X")) {
        hexadecimal(digits, rounding).ok_or_else(not_a_number)??
    } else {
        let is_decimal = magnitude.starts_with(|first: char| first.is_ascii_digit() || first == '.');
        let value = is_decimal.then(|| magnitude.parse().ok()).flatten();
        value.ok_or_else(not_a_number)?
    };
    if f64::is_infinite(value) {
        return Err(CoordinateError::OutOfRange(excerpt(field)));
    }
    Ok(if is_negative { -value } else { value })
}

/// The value of the digits and the exponent of a hexadecimal float, `1.8p-3`; `None` for other text.
fn hexadecimal(text: &str, rounding: Rounding) -> Option<Result<f64, CoordinateError>> {
    let (digits, exponent) = match text.split_once(['p', 'P']) {
        Some((digits, exponent)) => (digits, exponent.parse::<i64>().ok()?),
        None => (text, 0),
    };
    let (whole, fraction) = digits.split_once('.').unwrap_or((digits, ""));
    let digits = [whole, fraction].concat();
    if digits.is_empty() || !digits.bytes().all(|digit| digit.is_ascii_hexdigit()) {
        return None;
    }
    if digits.len() > rational::LONGEST {
        return Some(Err(CoordinateError::TooLong(excerpt(text.as_bytes()))));
    }
    let number = UBig::from_str_radix(&digits, 16).ok()?;
    if number == UBig::ZERO {
        return Some(Ok(0.0));
    }
    let shift = exponent.saturating_sub(4 * i64::try_from(fraction.len()).ok()?);
    // The number is at least 1 and below 16ⁿ. Beyond these shifts, the value is infinite, or below the least
    // f64 and not 0, whatever the shift is.
    let lowest = 4 * i64::try_from(digits.len()).ok()? + 1200;
    let shift = shift.clamp(-lowest, 1100);
    let (numerator, denominator) = if shift >= 0 {
        (number << shift as usize, UBig::ONE)
    } else {
        (number, UBig::ONE << shift.unsigned_abs() as usize)
    };
    let shown = || format!("0x{}", excerpt(text.as_bytes()));
    let number = RBig::from_parts(IBig::from(numerator), denominator);
    Some(rational::rounded(number, rounding, shown))
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    fn exactly(text: &str) -> Result<f64, CoordinateError> {
        parse(text.as_bytes(), Rounding::Refuse)
    }

    #[test]
    fn each_form_is_read() {
        for (text, value) in [
            ("0.1", 0.1),
            ("-1e-3", -1e-3),
            ("+.5", 0.5),
            ("5", 5.0),
            ("4.9e-324", 5e-324),
            ("1e-999", 0.0),
            ("0x1.8p-3", 0.1875),
            ("-0X.8P+1", -1.0),
            ("0x10", 16.0),
            ("0x1p-1074", 5e-324),
            ("0x0.0000000000001p1023", 2f64.powi(971)),
            ("0x1.fffffffffffffp1023", f64::MAX),
            ("3/16", 0.1875),
            ("-3 / -4", 0.75),
        ] {
            assert_eq!(exactly(text).map(f64::to_bits), Ok(value.to_bits()), "{text}");
        }
        assert_eq!(
            exactly("-0x0p99999999999").map(f64::to_bits),
            Ok((-0.0f64).to_bits())
        );
    }

    #[test]
    fn exact_forms_are_not_rounded_unless_allowed() {
        for (text, nearest) in [
            ("0x1.00000000000008p0", 1.0),
            ("0x1p-1075", 0.0),
            ("0x1.8p-1074", 1e-323),
            ("0x1p-9223372036854775808", 0.0),
            ("1/3", 1.0 / 3.0),
        ] {
            assert!(
                matches!(exactly(text), Err(CoordinateError::Inexact(_))),
                "{text}"
            );
            assert_eq!(parse(text.as_bytes(), Rounding::ToNearest), Ok(nearest), "{text}");
        }
        for text in [
            "1e309",
            "-1e309",
            "0x1p1024",
            "0x1p9223372036854775807",
            "0x1.fffffffffffff8p1023",
        ] {
            let found = parse(text.as_bytes(), Rounding::ToNearest);
            assert!(
                matches!(found, Err(CoordinateError::OutOfRange(_))),
                "{text}: {found:?}"
            );
        }
    }

    #[test]
    fn other_text_is_an_error() {
        for text in [
            "",
            "-",
            "nan",
            "inf",
            "-infinity",
            "0x",
            "0x.",
            "0x1p",
            "0x1pf",
            "0xg",
            "--1",
            "1e",
            "1_0",
            "0x1.2.3",
            "٣",
        ] {
            assert!(
                matches!(exactly(text), Err(CoordinateError::NotANumber(_))),
                "{text}"
            );
        }
        assert!(matches!(
            parse(b"\xff", Rounding::ToNearest),
            Err(CoordinateError::NotANumber(_))
        ));
        assert!(matches!(exactly("1/0"), Err(CoordinateError::ZeroDenominator(_))));
        assert!(matches!(exactly("1.5/2"), Err(CoordinateError::NotAnInteger(_))));
    }

    proptest! {
        #[test]
        fn every_finite_f64_survives(bits: u64) {
            let value = f64::from_bits(bits);
            prop_assume!(value.is_finite());
            prop_assert_eq!(exactly(&format!("{value:e}")).map(f64::to_bits), Ok(bits));
            let sign = if value.is_sign_negative() { "-" } else { "" };
            let (mantissa, exponent) = match (bits >> 52) & 0x7ff {
                0 => (bits & ((1 << 52) - 1), -1074),
                exponent => (bits & ((1 << 52) - 1) | 1 << 52, exponent as i64 - 1075),
            };
            let text = format!("{sign}0x{mantissa:x}p{exponent}");
            prop_assert_eq!(exactly(&text).map(f64::to_bits), Ok(bits), "{}", text);
            let point = format!("{sign}0x{:x}.{:013x}p{}", mantissa >> 52, mantissa & ((1 << 52) - 1), exponent + 52);
            prop_assert_eq!(exactly(&point).map(f64::to_bits), Ok(bits), "{}", point);
        }
    }
}
