//! Errors of queries of curved motion.

use exact_ccd::motion::InvalidMotion;

/// A problem with a query of curved motion.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum CurvedProblem {
    /// The line is not JSON.
    #[error("column {column}: {message}; expected a JSON object on one line")]
    Json {
        /// The column, from 1.
        column: usize,
        /// The message of the parser.
        message: String,
    },
    /// A field has another value than expected.
    #[error("{field}: expected {expected}, found {found}")]
    Field {
        /// The path of the field, such as `first[0].q1`.
        field: String,
        /// The expected value.
        expected: String,
        /// An excerpt of the value.
        found: String,
    },
    /// A field is missing.
    #[error("{field} is missing; expected {expected}")]
    Missing {
        /// The path of the field.
        field: String,
        /// The expected value.
        expected: &'static str,
    },
    /// A field is not one of the format, or not beside the others.
    #[error("{field} is unknown here; remove it, or correct its name to one of {known}")]
    Unknown {
        /// The path of the field.
        field: String,
        /// The fields of the format.
        known: String,
    },
    /// A motion is refused.
    #[error("{field}: {source}")]
    Motion {
        /// The path of the field with the motion.
        field: String,
        /// The reason.
        source: InvalidMotion,
    },
}
