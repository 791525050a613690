//! Options of reading.

/// The treatment of faces with more than three corners.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Polygons {
    /// Each becomes a fan of triangles from its lowest vertex.
    ///
    /// The fan is the same in all frames, whichever corner comes first in the file. It covers a
    /// convex plane polygon; another polygon has no surface of its own, and its fan is one choice.
    #[default]
    Triangulate,
    /// The first one is an error.
    Refuse,
}

/// Options of reading.
///
/// ```
/// use exact_ccd_files::{Format, MeshFile, Polygons, ReadOptions};
///
/// let options = ReadOptions::from(Polygons::Refuse).with_max_size(1 << 20);
/// let error = MeshFile::parse(&vec![b'#'; 2 << 20], Format::Obj, options).unwrap_err();
/// assert!(error.to_string().starts_with("more than 1048576 bytes, the size that is allowed"));
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct ReadOptions {
    /// The treatment of faces with more than three corners.
    pub polygons: Polygons,
    /// The most bytes that a file may have, with all files that it refers to, and that their data may expand
    /// to. Without another limit, it is `u64::MAX`.
    ///
    /// It bounds the memory of a reading: see [the limits](crate#limits).
    pub max_size: u64,
}

impl ReadOptions {
    /// The same options with another limit on the size.
    #[must_use]
    pub fn with_max_size(self, bytes: u64) -> Self {
        Self {
            max_size: bytes,
            ..self
        }
    }
}

impl Default for ReadOptions {
    fn default() -> Self {
        Polygons::default().into()
    }
}

impl From<Polygons> for ReadOptions {
    fn from(polygons: Polygons) -> Self {
        Self {
            polygons,
            max_size: u64::MAX,
        }
    }
}
