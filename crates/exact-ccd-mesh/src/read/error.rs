//! What can be wrong with a mesh file.

use std::fmt;
use std::io;
use std::path::PathBuf;

use crate::frame::FrameError;
use crate::tet_mesh::TetMeshError;

/// Why a mesh file could not be read.
#[derive(Debug, thiserror::Error)]
pub enum ReadError {
    /// The file is missing or cannot be read.
    #[error("{}: {source}", path.display())]
    Io {
        /// The file.
        path: PathBuf,
        /// What the system says.
        source: io::Error,
    },
    /// The extension tells no format.
    #[error("{}: unknown extension, expected .ply, .obj, .stl, .off, .msh or .vtu", path.display())]
    Extension {
        /// The file.
        path: PathBuf,
    },
    /// The contents are not what the format asks for.
    #[error("{}: {source}", path.display())]
    Parse {
        /// The file.
        path: PathBuf,
        /// What is wrong, and where.
        source: ParseError,
    },
}

/// What is wrong with the contents of a mesh file, and where.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[error("{place}{fault}")]
pub struct ParseError {
    /// Where in the file.
    pub place: Place,
    /// What is wrong there.
    pub fault: Fault,
}

/// A place in a file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Place {
    /// A line of text, from 1.
    Line(usize),
    /// An offset in bytes from the beginning.
    Byte(usize),
    /// The file as a whole.
    File,
}

impl fmt::Display for Place {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Line(line) => write!(f, "line {line}: "),
            Self::Byte(offset) => write!(f, "byte {offset}: "),
            Self::File => Ok(()),
        }
    }
}

/// What is wrong at a place in a mesh file. Faces and vertices are counted from 0, unless said otherwise.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum Fault {
    /// One thing stands where another should.
    #[error("expected {expected}, found {found}")]
    Expected {
        /// What should stand there.
        expected: String,
        /// What does.
        found: String,
    },
    /// The file ends too early.
    #[error("the file ends, expected {expected}")]
    Ends {
        /// What should follow.
        expected: String,
    },
    /// A face is not a triangle.
    #[error("face {face} has {corners} corners, expected a triangle")]
    Corners {
        /// The face.
        face: usize,
        /// How many corners it has.
        corners: i64,
    },
    /// A face names a vertex that the file does not have.
    #[error("face {face} names vertex {index}, but there are {vertex_count} vertices, counted from {first}")]
    Index {
        /// The face.
        face: usize,
        /// The vertex, as the file counts them.
        index: i64,
        /// What the file calls its first vertex: 0 or 1.
        first: i64,
        /// How many vertices there are.
        vertex_count: u64,
    },
    /// More vertices than 32 bits can number.
    #[error("more than 2^32 vertices")]
    TooManyVertices,
    /// The contents read well and are not a sound frame.
    #[error(transparent)]
    Frame(FrameError),
    /// The contents read well and are not a sound mesh of tetrahedra.
    #[error(transparent)]
    TetMesh(TetMeshError),
    /// A file of tetrahedra has a triangle that is not a face of any.
    #[error("triangle {triangle} is no face of a tetrahedron")]
    Sheet {
        /// The triangle.
        triangle: usize,
    },
}

impl Fault {
    pub(super) fn expected(expected: impl Into<String>, found: impl Into<String>) -> Self {
        Self::Expected {
            expected: expected.into(),
            found: found.into(),
        }
    }

    pub(super) fn ends(expected: impl Into<String>) -> Self {
        Self::Ends {
            expected: expected.into(),
        }
    }

    pub(super) fn at(self, place: Place) -> ParseError {
        ParseError { place, fault: self }
    }
}

/// A piece of a file as it can stand in a message: on one line, and not long.
pub(super) fn quoted(piece: &[u8]) -> String {
    const LONGEST: usize = 40;
    let mut text: String = String::from_utf8_lossy(&piece[..piece.len().min(4 * LONGEST)])
        .chars()
        .flat_map(char::escape_debug)
        .collect();
    if let Some((end, _)) = text.char_indices().nth(LONGEST) {
        text.truncate(end);
        text.push('…');
    }
    format!("`{text}`")
}
