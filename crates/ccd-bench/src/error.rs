//! What can be wrong with a data file.

use std::io;
use std::path::{Path, PathBuf};

use ccd_mesh::ReadMotionError;

use crate::rational::CoordinateError;

/// A data file that cannot be read.
#[derive(Debug, thiserror::Error)]
pub enum DataError {
    /// The file is missing or cannot be read.
    #[error("{}: {source}", file.display())]
    Io {
        /// The file.
        file: PathBuf,
        /// What the system says.
        source: io::Error,
    },
    /// A line of a CSV file is wrong.
    #[error("{}, line {line}: {problem}", file.display())]
    Line {
        /// The file.
        file: PathBuf,
        /// The line, from 1.
        line: u64,
        /// What is wrong.
        problem: Problem,
    },
    /// A JSON file has another shape than expected; the source names line and column.
    #[error("{}: expected {expected}: {source}", file.display())]
    Json {
        /// The file.
        file: PathBuf,
        /// What should be there.
        expected: &'static str,
        /// What the parser says.
        source: serde_json::Error,
    },
    /// A pair names something that is no primitive of its kind.
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
    /// There is not one verdict for each pair.
    #[error("{}: expected a verdict on each of {expected} pairs, found {found}", file.display())]
    VerdictCount {
        /// The file with the verdicts.
        file: PathBuf,
        /// How many pairs there are.
        expected: usize,
        /// How many verdicts there are.
        found: usize,
    },
    /// A mesh file is wrong.
    #[error(transparent)]
    Motion(#[from] ReadMotionError),
    /// A folder does not hold the file that belongs there.
    #[error("{}: expected {expected}, found {found}", folder.display())]
    Folder {
        /// The folder.
        folder: PathBuf,
        /// What should be there.
        expected: String,
        /// How many such files there are.
        found: usize,
    },
}

/// What is wrong with a line of a CSV file.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum Problem {
    /// The line has another number of fields than the file's format or its first line.
    #[error("expected {expected}, found {found}")]
    Fields {
        /// The right numbers.
        expected: &'static str,
        /// The number in this line.
        found: usize,
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
        /// What is wrong with it.
        source: CoordinateError,
    },
    /// The ground truth is neither 0 nor 1.
    #[error("expected 0 or 1 as the ground truth, found \"{0}\"")]
    Truth(String),
    /// The ground truth differs between the rows of a query.
    #[error("the ground truth is {found}, but {expected} in the rows of the same query before")]
    TruthDiffers {
        /// The truth in the first row of the query, 0 or 1.
        expected: u8,
        /// The truth in this row.
        found: u8,
    },
    /// The file ends before the query does.
    #[error("the file ends after {0} of the 8 rows of a query")]
    CutShort(usize),
    /// A field is not the number that it should be.
    #[error("expected {expected} as {column}, found \"{found}\"")]
    Field {
        /// The name of the column.
        column: &'static str,
        /// What should be there.
        expected: &'static str,
        /// What is there.
        found: String,
    },
}

impl DataError {
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
