//! Rational numbers in text, as f64.

use dashu_int::{IBig, UBig};
use dashu_ratio::RBig;
use exact_ccd_files::excerpt;

/// The most digits of a number in exact arithmetic, whose time grows with the square of this number.
/// Numerator and denominator of a finite f64 have at most 324 digits when the fraction is in lowest terms.
pub(crate) const LONGEST: usize = 4096;

/// The treatment of a coordinate that is not exactly an f64.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Rounding {
    /// It is an error: the exact answer to a rounded query would mislead.
    #[default]
    Refuse,
    /// It is rounded to the nearest f64, ties to even. Rounding to infinity is an error.
    ToNearest,
}

/// Fields that are not a coordinate with an f64 as its value.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum CoordinateError {
    /// A field is not a decimal integer.
    #[error("expected an integer, found \"{0}\"")]
    NotAnInteger(String),
    /// A field is not a number.
    #[error("expected a decimal, a hexadecimal float or a fraction, found \"{0}\"")]
    NotANumber(String),
    /// An integer or a hexadecimal float has so many digits that exact arithmetic with it takes long. A
    /// finite f64 needs fewer.
    #[error("{0} has more than {LONGEST} digits; reduce the fraction")]
    TooLong(String),
    /// The denominator is zero.
    #[error("the denominator of {0} is zero")]
    ZeroDenominator(String),
    /// The number lies between two f64.
    #[error("{0} is not exactly an f64")]
    Inexact(String),
    /// The number would round to infinity.
    #[error("{0} is out of the range of f64")]
    OutOfRange(String),
}

/// The value of a fraction, whose numerator and denominator have either sign, as a finite f64.
pub(crate) fn parse(
    numerator: &[u8],
    denominator: &[u8],
    rounding: Rounding,
) -> Result<f64, CoordinateError> {
    if let Some(value) = parse_small(numerator, denominator) {
        return Ok(value);
    }
    let fraction = || format!("{}/{}", excerpt(numerator), excerpt(denominator));
    let (sign, divisor) = integer(denominator)?.into_parts();
    let dividend = integer(numerator)? * sign;
    if divisor == UBig::ZERO {
        return Err(CoordinateError::ZeroDenominator(fraction()));
    }
    rounded(RBig::from_parts(dividend, divisor), rounding, fraction)
}

/// The nearest f64, if `rounding` allows it or it is the number; `shown` is the number in errors.
pub(crate) fn rounded(
    number: RBig,
    rounding: Rounding,
    shown: impl Fn() -> String,
) -> Result<f64, CoordinateError> {
    match number.to_f64().value_with_exact() {
        (nearest, _) if nearest.is_infinite() => Err(CoordinateError::OutOfRange(shown())),
        (nearest, exact) if exact || rounding == Rounding::ToNearest => Ok(nearest),
        _ => Err(CoordinateError::Inexact(shown())),
    }
}

/// The value of n / 2ᵏ with |n| ≤ 2⁵³ and 2ᵏ an i64, which nearly all coordinates are. Both convert
/// exactly, and the quotient is exact.
fn parse_small(numerator: &[u8], denominator: &[u8]) -> Option<f64> {
    let small = |text: &[u8]| str::from_utf8(text).ok()?.parse::<i64>().ok();
    let (n, d) = (small(numerator)?, small(denominator)?);
    (n.unsigned_abs() <= 1 << 53 && d > 0 && d.count_ones() == 1).then(|| n as f64 / d as f64)
}

fn integer(text: &[u8]) -> Result<IBig, CoordinateError> {
    let digits = text
        .strip_prefix(b"-")
        .or(text.strip_prefix(b"+"))
        .unwrap_or(text);
    if digits.len() > LONGEST {
        return Err(CoordinateError::TooLong(excerpt(text)));
    }
    digits
        .iter()
        .all(u8::is_ascii_digit)
        .then(|| str::from_utf8(text).ok()?.parse().ok())
        .flatten()
        .ok_or_else(|| CoordinateError::NotAnInteger(excerpt(text)))
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    fn exactly(numerator: &str, denominator: &str) -> Result<f64, CoordinateError> {
        parse(numerator.as_bytes(), denominator.as_bytes(), Rounding::Refuse)
    }

    fn nearest(numerator: &str, denominator: &str) -> Result<f64, CoordinateError> {
        parse(numerator.as_bytes(), denominator.as_bytes(), Rounding::ToNearest)
    }

    fn power(exponent: usize) -> String {
        (UBig::ONE << exponent).to_string()
    }

    #[test]
    fn fractions_that_are_f64_are_read_exactly() {
        assert_eq!(exactly("3", "4"), Ok(0.75));
        assert_eq!(exactly("-3", "-4"), Ok(0.75));
        assert_eq!(exactly("+3", "-4"), Ok(-0.75));
        assert_eq!(exactly("21", "28"), Ok(0.75));
        assert_eq!(exactly("1", &power(1074)), Ok(5e-324));
        assert_eq!(exactly(&power(1023), "1"), Ok(2f64.powi(1023)));
        assert_eq!(exactly(&power(5000), &power(5001)), Ok(0.5));
        for zero in ["0", "-0"] {
            assert!(exactly(zero, "-7").is_ok_and(|value| value == 0.0 && value.is_sign_positive()));
        }
    }

    #[test]
    fn a_number_that_is_no_f64_is_refused_or_rounded() {
        assert_eq!(exactly("1", "3"), Err(CoordinateError::Inexact("1/3".into())));
        assert_eq!(nearest("1", "3"), Ok(1.0 / 3.0));
        assert_eq!(
            exactly("9007199254740993", "1"),
            Err(CoordinateError::Inexact("9007199254740993/1".into()))
        );
        assert_eq!(nearest("9007199254740993", "1"), Ok(9007199254740992.0));
        assert!(matches!(
            exactly("1", &power(1075)),
            Err(CoordinateError::Inexact(_))
        ));
        assert_eq!(nearest("1", &power(1075)), Ok(0.0));
        assert!(matches!(
            nearest(&power(1024), "1"),
            Err(CoordinateError::OutOfRange(_))
        ));
        assert!(matches!(
            exactly(&power(1024), "-1"),
            Err(CoordinateError::OutOfRange(_))
        ));
    }

    #[test]
    fn a_field_that_is_no_fraction_is_an_error() {
        for text in ["", "-", "+-1", "1.5", "1e3", "1_000", "0x1", "nan", "1 2", "١"] {
            assert!(
                matches!(nearest(text, "1"), Err(CoordinateError::NotAnInteger(_))),
                "{text:?}"
            );
            assert!(
                matches!(nearest("1", text), Err(CoordinateError::NotAnInteger(_))),
                "{text:?}"
            );
        }
        assert_eq!(
            nearest("5", "-0"),
            Err(CoordinateError::ZeroDenominator("5/-0".into()))
        );
    }

    proptest! {
        #[test]
        fn every_finite_f64_survives(value in prop::num::f64::ANY) {
            prop_assume!(value.is_finite());
            let ratio = RBig::try_from(value).unwrap();
            let (numerator, denominator) = (ratio.numerator().to_string(), ratio.denominator().to_string());
            prop_assert_eq!(exactly(&numerator, &denominator), Ok(value));
        }

        /// No f64 is nearer, not even among the subnormals.
        #[test]
        fn rounding_is_to_the_nearest(numerator: i64, denominator in 1u64.., shift in 0usize..1140) {
            let ratio = RBig::from_parts(numerator.into(), UBig::from(denominator) << shift);
            let (numerator, denominator) = (ratio.numerator().to_string(), ratio.denominator().to_string());
            let value = nearest(&numerator, &denominator).unwrap();
            let distance = |value| {
                let difference = RBig::try_from(value).unwrap() - &ratio;
                if difference < RBig::ZERO { -difference } else { difference }
            };
            prop_assert!(distance(value) <= distance(value.next_up()));
            prop_assert!(distance(value) <= distance(value.next_down()));
        }
    }
}
