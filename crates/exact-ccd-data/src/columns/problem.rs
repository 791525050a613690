//! Problems with Parquet files.

use exact_ccd::NonFinite;
use parquet::errors::ParquetError;

/// A problem with a Parquet file.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum ColumnProblem {
    /// The file is damaged, or not a Parquet file.
    #[error("{0}")]
    Parquet(String),
    /// A column is missing or has another type.
    #[error("column {column} should have {expected}, found {found}")]
    Column {
        /// The name of the column.
        column: &'static str,
        /// The expected type.
        expected: &'static str,
        /// The contents found.
        found: String,
    },
    /// The compression is not supported.
    #[error("columns should be plain or compressed with GZIP or SNAPPY, found {0}")]
    Compression(String),
}

/// A problem with a row of a Parquet file.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum RecordProblem {
    /// A field has another value than expected.
    #[error("expected {expected} as {column}, found {found}")]
    Field {
        /// The name of the column.
        column: &'static str,
        /// The expected contents.
        expected: &'static str,
        /// The contents found.
        found: String,
    },
    /// The list of coordinates is missing or has another length than expected.
    #[error("expected {expected} coordinates as points, found null or another number")]
    Points {
        /// The number of coordinates of a query.
        expected: usize,
    },
    /// A coordinate is infinite or not a number.
    #[error(transparent)]
    NonFinite(#[from] NonFinite),
}

impl ColumnProblem {
    pub(crate) fn parquet(problem: impl Into<String>) -> Self {
        Self::Parquet(problem.into())
    }
}

impl From<ParquetError> for ColumnProblem {
    fn from(error: ParquetError) -> Self {
        Self::Parquet(match error {
            ParquetError::General(text) | ParquetError::EOF(text) | ParquetError::NYI(text) => text,
            ParquetError::External(source) => source.to_string(),
            error => error.to_string(),
        })
    }
}

impl RecordProblem {
    pub(crate) fn field(column: &'static str, expected: &'static str, found: impl ToString) -> Self {
        let found = found.to_string();
        Self::Field {
            column,
            expected,
            found,
        }
    }
}
