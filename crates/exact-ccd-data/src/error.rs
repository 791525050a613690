//! Errors of data files.

use std::io;
use std::path::{Path, PathBuf};

use exact_ccd_files::ReadMotionError;

#[cfg(feature = "parquet")]
use crate::columns::{ColumnProblem, RecordProblem};
use crate::curved::CurvedProblem;
use crate::rational::CoordinateError;

/// A data file that cannot be read.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum DataError {
    /// The file is missing or cannot be read.
    #[error("{}: {source}", file.display())]
    Io {
        /// The file.
        file: PathBuf,
        /// The error of the system.
        source: io::Error,
    },
    /// The two frames of a scene are not a step.
    #[error(transparent)]
    Step(#[from] exact_ccd_mesh::StepError),
    /// A line of a CSV file is wrong.
    #[error("{}, line {line}: {problem}", file.display())]
    Line {
        /// The file.
        file: PathBuf,
        /// The line, from 1.
        line: u64,
        /// The problem.
        problem: Problem,
    },
    /// A line of a file of curved motion is wrong.
    #[error("{}, line {line}: {problem}", file.display())]
    Curved {
        /// The file.
        file: PathBuf,
        /// The line, from 1.
        line: u64,
        /// The problem.
        problem: CurvedProblem,
    },
    /// A Parquet file is wrong.
    #[cfg(feature = "parquet")]
    #[error("{}: expected a Parquet file of queries: {problem}", file.display())]
    Columns {
        /// The file.
        file: PathBuf,
        /// The problem.
        problem: ColumnProblem,
    },
    /// A row of a Parquet file is wrong.
    #[cfg(feature = "parquet")]
    #[error("{}, query {query}: {problem}", file.display())]
    Record {
        /// The file.
        file: PathBuf,
        /// The index of the row, from 0.
        query: usize,
        /// The problem.
        problem: RecordProblem,
    },
    /// A Parquet file, which this build cannot read.
    #[error("{}: this build reads no Parquet files: it lacks the feature `parquet` of exact-ccd-data", file.display())]
    NoParquet {
        /// The file.
        file: PathBuf,
    },
    /// A JSON file has another shape than expected; the source names line and column.
    #[error("{}: expected {expected}: {source}", file.display())]
    Json {
        /// The file.
        file: PathBuf,
        /// The expected contents.
        expected: &'static str,
        /// The error of the parser.
        source: serde_json::Error,
    },
    /// An id of a pair does not name a primitive of its kind.
    #[error("{}: pair {index}, {ids:?}, is no {kind} pair of this mesh", file.display())]
    Ids {
        /// The file.
        file: PathBuf,
        /// The index of the pair, from 0.
        index: usize,
        /// The two ids.
        ids: [usize; 2],
        /// The name of the kind.
        kind: &'static str,
    },
    /// The number of verdicts differs from the number of pairs.
    #[error("{}: expected a verdict on each of {expected} pairs, found {found}", file.display())]
    VerdictCount {
        /// The file with the verdicts.
        file: PathBuf,
        /// The number of pairs.
        expected: usize,
        /// The number of verdicts.
        found: usize,
    },
    /// A root file has the index of a query that the scene does not have.
    #[error("{}: there is no query {query} among {queries}", file.display())]
    NoQuery {
        /// The root file.
        file: PathBuf,
        /// The index of the query, from 0.
        query: usize,
        /// The number of queries in the scene.
        queries: usize,
    },
    /// A mesh file is wrong.
    #[error(transparent)]
    Motion(#[from] ReadMotionError),
    /// A folder lacks a file.
    #[error("{}: expected {expected}, found {found}", folder.display())]
    Folder {
        /// The folder.
        folder: PathBuf,
        /// The expected contents.
        expected: String,
        /// The number of such files.
        found: usize,
    },
}

/// A problem with a line of a CSV file.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum Problem {
    /// The line has more or fewer fields than the format, or than the first line.
    #[error("expected {expected}, found {found}")]
    Fields {
        /// The expected numbers.
        expected: String,
        /// The number in this line.
        found: usize,
    },
    /// The line is longer than any row of numbers.
    #[error("more than {longest} bytes, expected a row of a few numbers")]
    LongLine {
        /// The most bytes of a line.
        longest: usize,
    },
    /// A coordinate is wrong.
    #[error("{axis} of {point} at t = {time}: {source}")]
    Coordinate {
        /// x, y or z.
        axis: char,
        /// The name of the point in its query.
        point: &'static str,
        /// The end of the time step, 0 or 1.
        time: usize,
        /// The problem with it.
        source: CoordinateError,
    },
    /// The ground truth is neither 0 nor 1.
    #[error("expected 0 or 1 as the ground truth, found \"{0}\"")]
    Truth(String),
    /// The number of contacts is not a number, or below −1.
    #[error("expected a number of contacts, or -1 for infinitely many, found \"{0}\"")]
    Count(String),
    /// The ground truth differs between the rows of a query.
    #[error("the ground truth is {found}, expected {expected} as in the first row of the query")]
    TruthDiffers {
        /// The truth in the first row of the query: 0 or 1, or a number of contacts.
        expected: i64,
        /// The truth in this row.
        found: i64,
    },
    /// The file ends before the query does.
    #[error("the file ends after {found} of the {expected} rows of a query")]
    CutShort {
        /// The number of rows of a query.
        expected: usize,
        /// The number of rows of the last query in the file.
        found: usize,
    },
    /// A field is not the expected number.
    #[error("expected {expected} as {column}, found \"{found}\"")]
    Field {
        /// The name of the column.
        column: &'static str,
        /// The expected contents.
        expected: &'static str,
        /// The contents found.
        found: String,
    },
}

impl DataError {
    #[cfg(feature = "parquet")]
    pub(crate) fn columns(file: &Path, problem: ColumnProblem) -> Self {
        Self::Columns {
            file: file.to_owned(),
            problem,
        }
    }

    pub(crate) fn io(file: &Path, source: io::Error) -> Self {
        Self::Io {
            file: file.to_owned(),
            source,
        }
    }

    pub(crate) fn line(file: &Path, line: u64, problem: Problem) -> Self {
        Self::Line {
            file: file.to_owned(),
            line,
            problem,
        }
    }
}
