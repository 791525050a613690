//! Errors in mesh files: the file, the place in it, and what was expected there.

use std::path::PathBuf;
use std::{fmt, io};

use exact_ccd_mesh::{FrameError, TetMeshError};

use crate::format::Format;
use crate::unsupported::Unsupported;

/// The reason why a mesh file could not be read.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum ReadError {
    /// The file is missing or cannot be read.
    #[error("{}: {source}", path.display())]
    Io {
        /// The file.
        path: PathBuf,
        /// The error of the operating system.
        source: io::Error,
    },
    /// The extension belongs to no format.
    #[error("{}: unknown extension, expected {}, also with .gz", path.display(), Format::extensions())]
    Extension {
        /// The file.
        path: PathBuf,
    },
    /// The extension belongs to a known format for which there is no reader.
    #[error("{}: {format}", path.display())]
    Unsupported {
        /// The file.
        path: PathBuf,
        /// The format, and the export to use instead.
        format: Unsupported,
    },
    /// The contents do not follow the format.
    #[error("{}: {source}", path.display())]
    Parse {
        /// The file.
        path: PathBuf,
        /// The error and its place.
        source: ParseError,
    },
}

/// An error in the contents of a mesh file, and its place.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[error("{place}{fault}")]
pub struct ParseError {
    /// The place in the file.
    pub place: Place,
    /// The error there.
    pub fault: Fault,
}

/// A place in a file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Place {
    /// A line of text, from 1.
    Line(usize),
    /// An offset in bytes from the beginning.
    Byte(usize),
    /// A frame of a recording, from 0.
    Frame(usize),
    /// The file as a whole.
    File,
}

impl fmt::Display for Place {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Line(line) => write!(f, "line {line}: "),
            Self::Byte(offset) => write!(f, "byte {offset}: "),
            Self::Frame(frame) => write!(f, "frame {frame}: "),
            Self::File => Ok(()),
        }
    }
}

/// An error at a place in a mesh file. Elements and vertices are counted as in the format: from 1 in OBJ,
/// from 0 in all others.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum Fault {
    /// One thing is in the place of another.
    #[error("expected {expected}, found {found}")]
    Expected {
        /// The thing that should be there.
        expected: String,
        /// The thing that is there.
        found: String,
    },
    /// The file ends too early.
    #[error("the file ends, expected {expected}")]
    Ends {
        /// The thing that should follow.
        expected: String,
    },
    /// A face has fewer than three corners.
    #[error("face {face} has {corners} corners, expected at least 3")]
    Corners {
        /// The number of the face.
        face: usize,
        /// The number of its corners.
        corners: i64,
    },
    /// A face is not a triangle, where [`Polygons::Refuse`](crate::Polygons::Refuse) allows only
    /// triangles.
    #[error("face {face} has {corners} corners, but only triangles are allowed")]
    Polygon {
        /// The number of the face in the file, or of the side of a cell.
        face: usize,
        /// The number of its corners.
        corners: usize,
    },
    /// More than two cells have the same side.
    #[error("cells {} share one side, expected at most two", list(cells))]
    SharedSide {
        /// The first three of these cells.
        cells: Vec<usize>,
    },
    /// The contents have another format than the name of the file says.
    #[error("the contents are {found}, expected {expected}; {advice}")]
    Contents {
        /// The contents.
        found: &'static str,
        /// The format.
        expected: &'static str,
        /// The remedy.
        advice: String,
    },
    /// Data that are compressed or repeated expand to far more than a mesh does.
    #[error(
        "the data expand to more than {limit} bytes, the most for a file of this size; \
         write the file without compression and without repeated data"
    )]
    Expansion {
        /// The limit, which follows from the size of the file.
        limit: u64,
    },
    /// The file, or the data that it expands to, are larger than the reader allows.
    #[error(
        "more than {limit} bytes, the size that is allowed; allow more with `ReadOptions::with_max_size`"
    )]
    Size {
        /// The size that is allowed.
        limit: u64,
    },
    /// The file has no face, no edge and no point.
    #[error("no face, no edge and no point: the file has {read}; choose a file with a mesh")]
    Empty {
        /// The contents of the file.
        read: String,
    },
    /// A face, an edge or a point names a vertex that the file does not have.
    #[error(
        "{element} {number} names vertex {index}, but there are {vertex_count} vertices, counted from {first}"
    )]
    Index {
        /// `face`, `edge`, `polyline` or `point`.
        element: &'static str,
        /// The number of that element.
        number: usize,
        /// The vertex, with the numbering of the file.
        index: i64,
        /// The number of the first vertex in the file: 0 or 1.
        first: i64,
        /// The number of vertices.
        vertex_count: u64,
    },
    /// The file has more vertices than 32-bit indices can number.
    #[error("more than 2^32 - 1 vertices")]
    TooManyVertices,
    /// The contents follow the format but are not a valid frame.
    #[error(transparent)]
    Frame(FrameError),
    /// The contents follow the format but are not a valid mesh of tetrahedra.
    #[error(transparent)]
    TetMesh(TetMeshError),
    /// A file of cells with volume has a face that is not a side of any of them.
    #[error("face {face} is no side of a cell with volume")]
    Sheet {
        /// The number of the face in the file.
        face: u32,
    },
}

impl Fault {
    pub(crate) fn expected(expected: impl Into<String>, found: impl Into<String>) -> Self {
        Self::Expected {
            expected: expected.into(),
            found: found.into(),
        }
    }

    pub(crate) fn ends(expected: impl Into<String>) -> Self {
        Self::Ends {
            expected: expected.into(),
        }
    }

    /// The error of a reader, which may be one of the budget.
    pub(crate) fn of_io(expected: &str, error: &io::Error) -> Self {
        let inner = error.get_ref().and_then(|inner| inner.downcast_ref::<Self>());
        let other = || Self::expected(expected, quoted(error.to_string().as_bytes()));
        inner.cloned().unwrap_or_else(other)
    }

    pub(crate) fn at(self, place: Place) -> ParseError {
        ParseError { place, fault: self }
    }
}

/// Numbers as `0, 1 and 2`.
fn list(numbers: &[usize]) -> String {
    let words: Vec<String> = numbers.iter().map(usize::to_string).collect();
    match words.split_last() {
        Some((last, rest)) if !rest.is_empty() => format!("{} and {last}", rest.join(", ")),
        _ => words.concat(),
    }
}

/// An [`excerpt`] in quotes.
pub(crate) fn quoted(piece: &[u8]) -> String {
    format!("`{}`", excerpt(piece))
}

/// A piece of a file, shortened and escaped for a message of one line.
#[must_use]
pub fn excerpt(piece: &[u8]) -> String {
    const LONGEST: usize = 40;
    let mut text: String = String::from_utf8_lossy(&piece[..piece.len().min(4 * LONGEST)])
        .chars()
        .flat_map(char::escape_debug)
        .collect();
    if let Some((end, _)) = text.char_indices().nth(LONGEST) {
        text.truncate(end);
        text.push('…');
    }
    text
}
