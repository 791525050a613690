//! Minimum distances on the command line.

use exact_ccd::Separation;

/// The minimum distance that is the f64 nearest to a decimal number.
///
/// # Errors
/// The reason, if the text is no number, or if the number is negative, infinite or NaN.
pub(crate) fn parse(text: &str) -> Result<Separation, String> {
    let d: f64 = text.parse().map_err(|_| "expected a number".to_owned())?;
    Separation::new(d).map_err(|error| error.to_string())
}

#[cfg(test)]
mod tests {
    use super::parse;

    #[test]
    fn finite_numbers_of_at_least_0_are_distances() {
        for (text, d) in [
            ("0", 0.0),
            ("-0", 0.0),
            ("1e-3", 1e-3),
            ("5e-324", 5e-324),
            ("0.1", 0.1),
            ("1.7976931348623157e308", f64::MAX),
        ] {
            assert_eq!(parse(text).unwrap().get().to_bits(), d.to_bits(), "{text}");
        }
        for text in ["-1", "-5e-324", "inf", "-inf", "NaN", "1e309", "", "1mm", "1,5"] {
            assert!(parse(text).is_err(), "{text}");
        }
    }
}
