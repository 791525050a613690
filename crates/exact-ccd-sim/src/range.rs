//! Values out of their range.

use std::fmt::Display;

use exact_ccd_mesh::vector::{DIRECTION, has_direction};

/// A value that is out of its range.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("`{field}` is {found}, expected {expected}")]
pub struct OutOfRange {
    /// The name of the value, as in a scene file: a path of fields with dots, and hyphens for underscores.
    pub field: &'static str,
    /// The value.
    pub found: String,
    /// The values that are allowed.
    pub expected: String,
}

/// The range of most lengths, times and materials.
pub(crate) const POSITIVE: &str = "a positive number";

/// The range of coefficients.
pub(crate) const NOT_NEGATIVE: &str = "a number not below 0";

/// The range of vectors.
const FINITE: &str = "finite numbers";

/// Checks that a value is in its range.
pub(crate) fn check(
    is_in_range: bool,
    field: &'static str,
    found: impl Display,
    expected: impl Display,
) -> Result<(), OutOfRange> {
    if is_in_range {
        return Ok(());
    }
    Err(OutOfRange {
        field,
        found: found.to_string(),
        expected: expected.to_string(),
    })
}

/// Checks that a number is positive and finite.
pub(crate) fn check_positive(field: &'static str, value: f64) -> Result<(), OutOfRange> {
    check(value > 0.0 && value.is_finite(), field, value, POSITIVE)
}

/// Checks that a number is finite and not negative.
pub(crate) fn check_not_negative(field: &'static str, value: f64) -> Result<(), OutOfRange> {
    check(value >= 0.0 && value.is_finite(), field, value, NOT_NEGATIVE)
}

/// Checks that all components of a vector are finite.
pub(crate) fn check_finite(field: &'static str, vector: &[f64; 3]) -> Result<(), OutOfRange> {
    let is_finite = vector.iter().all(|x| x.is_finite());
    check(is_finite, field, format_args!("{vector:?}"), FINITE)
}

/// Checks that a vector has a direction.
pub(crate) fn check_direction(field: &'static str, vector: &[f64; 3]) -> Result<(), OutOfRange> {
    check(
        has_direction(*vector),
        field,
        format_args!("{vector:?}"),
        DIRECTION,
    )
}
