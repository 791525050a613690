//! The texts of numbers.

/// The shortest decimal that reads back to the same f64, with or without an exponent: `0.25`,
/// `1e-3`, `5e-324`.
pub(crate) fn shortest(value: f64) -> String {
    let (plain, scientific) = (format!("{value}"), format!("{value:e}"));
    if scientific.len() < plain.len() {
        scientific
    } else {
        plain
    }
}

/// The numbers in a text, with commas or blanks between them, if there are N.
pub(crate) fn numbers<const N: usize>(text: &str) -> Option<[f64; N]> {
    let words = text.split([' ', ',']).filter(|word| !word.is_empty());
    let numbers: Vec<f64> = words.map(|word| word.parse().ok()).collect::<Option<_>>()?;
    numbers.try_into().ok()
}

#[cfg(test)]
mod tests {
    use super::shortest;

    #[test]
    fn the_shorter_form_wins() {
        for (value, text) in [
            (0.0, "0"),
            (1.0, "1"),
            (0.25, "0.25"),
            (0.001, "1e-3"),
            (1.0 / 3.0, "0.3333333333333333"),
            (5e-324, "5e-324"),
            (f64::MIN_POSITIVE, "2.2250738585072014e-308"),
        ] {
            assert_eq!(shortest(value), text);
            assert_eq!(text.parse(), Ok(value));
        }
    }
}
