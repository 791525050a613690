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
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct ReadOptions {
    /// The treatment of faces with more than three corners.
    pub polygons: Polygons,
    /// The most bytes that a file may have, with all files that it refers to, and that their data may expand
    /// to. Without another limit, it is `u64::MAX`.
    ///
    /// It bounds the memory of a reading: see [the limits](crate#limits).
    pub max_size: u64,
    /// The name of the array of positions in `.npz` files that are read as a
    /// [`FrameSequence`](crate::FrameSequence).
    pub positions: Option<String>,
    /// The name of the array of faces in these files; or a file `.npy` with the faces, which `.npy` files of
    /// positions need. A name that ends in `.npy` is that of a file.
    pub faces: Option<String>,
}

impl ReadOptions {
    /// The same options with names of the arrays of positions and faces, see [`ReadOptions::positions`] and
    /// [`ReadOptions::faces`].
    #[must_use]
    pub fn with_arrays(self, positions: Option<String>, faces: Option<String>) -> Self {
        Self {
            positions,
            faces,
            ..self
        }
    }

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

impl From<&Self> for ReadOptions {
    fn from(options: &Self) -> Self {
        options.clone()
    }
}

impl From<Polygons> for ReadOptions {
    fn from(polygons: Polygons) -> Self {
        Self {
            polygons,
            max_size: u64::MAX,
            positions: None,
            faces: None,
        }
    }
}
