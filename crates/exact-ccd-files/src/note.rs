//! Facts about a mesh file that could change an answer.

use std::fmt;

use crate::error::Place;

/// A fact about a mesh file that could change an answer, and its place. Its text is one line.
///
/// A reader reads everything in a file that could change an answer, or returns a note about it, or
/// refuses the file.
///
/// ```
/// use exact_ccd_files::{Format, MeshFile, Polygons};
///
/// let file = MeshFile::parse(b"v 0 0\nv 1 0\nv 0 1\nf 1 2 3\n", Format::Obj, Polygons::default())?;
/// assert_eq!(file.frame.positions[1], [1.0, 0.0, 0.0]);
/// let [note] = &file.notes[..] else { panic!() };
/// assert_eq!(note.to_string(), "line 1: the vertices have two coordinates, and the third one is 0");
/// # Ok::<(), exact_ccd_files::ParseError>(())
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Note {
    /// The place in the file.
    pub place: Place,
    /// The fact.
    pub fact: Fact,
}

impl fmt::Display for Note {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}{}", self.place, self.fact)
    }
}

/// A fact about a mesh file that could change an answer.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Fact {
    /// A part of the file is not read.
    NotRead {
        /// The part.
        part: String,
        /// The remedy, for a user who needs the part.
        remedy: String,
    },
    /// The vertices have two coordinates, and are read with z = 0.
    TwoCoordinates,
    /// Tetrahedra of both signs of volume: their corners are in two orders, or some are inverted. The surface
    /// is the same.
    Inverted {
        /// The number of tetrahedra with the rarer sign.
        count: usize,
        /// The number of all tetrahedra.
        of: usize,
    },
    /// Tetrahedra whose four corners lie in one plane, exactly.
    Flat {
        /// The number of them.
        count: usize,
        /// The number of all tetrahedra.
        of: usize,
    },
    /// A motion between two frames that is not straight in the file: a jump.
    Jumps,
}

impl Fact {
    pub(crate) fn not_read(part: impl Into<String>, remedy: impl Into<String>) -> Self {
        Self::NotRead {
            part: part.into(),
            remedy: remedy.into(),
        }
    }

    pub(crate) fn at(self, place: Place) -> Note {
        Note { place, fact: self }
    }

    /// Returns true for a fact that is probably a fault of the input.
    #[must_use]
    pub fn is_warning(&self) -> bool {
        matches!(self, Self::NotRead { .. })
    }
}

impl fmt::Display for Fact {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NotRead { part, remedy } => write!(f, "not read: {part}; {remedy}"),
            Self::TwoCoordinates => {
                f.write_str("the vertices have two coordinates, and the third one is 0")
            }
            Self::Inverted { count, of } => write!(
                f,
                "{count} of {of} tetrahedra have the other sign of volume: their corners are in another order, or \
                 they are inverted; the surface is that of all"
            ),
            Self::Flat { count, of } => {
                write!(f, "{count} of {of} tetrahedra have no volume; the surface is that of all")
            }
            Self::Jumps => f.write_str(
                "positions jump at keys of interpolation STEP; each jump is examined as a straight motion in no time",
            ),
        }
    }
}
