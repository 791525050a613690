//! Numbers with few digits.

/// A number with this many significant digits, without zeros at the end: `1.118`, `0.00112`. Numbers below
/// 10⁻⁴ and from 10⁶ on have an exponent: `2.5e-7`.
pub(crate) fn significant(value: f64, digits: usize) -> String {
    let rounded: f64 = format!("{value:.*e}", digits.saturating_sub(1))
        .parse()
        .unwrap_or(value);
    if rounded == 0.0 || (1e-4..1e6).contains(&rounded.abs()) {
        rounded.to_string()
    } else {
        format!("{rounded:e}")
    }
}

#[cfg(test)]
mod tests {
    use super::significant;

    #[test]
    fn significant_digits_are_plain_where_they_can_be() {
        let texts = [1.1180339887, 0.00112, 120.0, 0.0, -0.5, 999_999.7, 2.5e-7, 1e300];
        assert_eq!(
            texts.map(|value| significant(value, 4)),
            ["1.118", "0.00112", "120", "0", "-0.5", "1e6", "2.5e-7", "1e300"]
        );
        assert_eq!(significant(f64::INFINITY, 3), "inf");
    }
}
