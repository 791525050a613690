//! The distances within which pairs touch: on the command line, and in reports.

use std::fmt;

use exact_ccd::Separation;
use exact_ccd_mesh::MinDistance;
use serde::Serialize;

use crate::text::numbers::shortest;

/// The distances within which pairs touch, as a part of a JSON object.
#[derive(Clone, Copy, Serialize)]
pub(crate) struct Distances {
    min_distance: f64,
    /// The distance of pairs that start within the minimum distance, if it is another one.
    #[serde(skip_serializing_if = "Option::is_none")]
    inner_distance: Option<f64>,
}

impl Distances {
    pub(crate) fn new(min_distance: Separation, inner_distance: Option<Separation>) -> Self {
        Self {
            min_distance: min_distance.get(),
            inner_distance: inner_distance.map(Separation::get),
        }
    }

    /// The words for primitives that touch at the start of a step.
    pub(crate) fn touching(&self) -> &'static str {
        if self.min_distance == 0.0 {
            "that touch"
        } else {
            "within the minimum distance"
        }
    }
}

/// The minimum distance of all pairs of a mesh, and another one, if given, for pairs that start within it.
pub(crate) fn kept(min_distance: Separation, inner_distance: Option<Separation>) -> MinDistance {
    let kept = MinDistance::uniform(min_distance);
    match inner_distance {
        Some(inner) => kept.with_inner(inner),
        None => kept,
    }
}

/// The minimum distance that is the f64 nearest to a decimal number.
///
/// # Errors
/// The reason, if the text is no number, or if the number is negative, infinite or NaN.
pub(crate) fn parse(text: &str) -> Result<Separation, String> {
    let d: f64 = text.parse().map_err(|_| "expected a number".to_owned())?;
    Separation::new(d).map_err(|error| error.to_string())
}

/// A line of text; empty for contact.
impl fmt::Display for Distances {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.min_distance == 0.0 {
            return Ok(());
        }
        write!(f, "minimum distance: {}", shortest(self.min_distance))?;
        if let Some(inner) = self.inner_distance {
            write!(f, ", and {} for pairs that start within it", shortest(inner))?;
        }
        writeln!(f)
    }
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
