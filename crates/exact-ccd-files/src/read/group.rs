//! Named groups of a mesh file.

/// A named group of elements: an object or a group of OBJ, or the named parts of PLY.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Group {
    /// Its name.
    pub name: String,
    /// The vertices of its faces, lines and points, increasing. Groups may have vertices in common.
    pub vertices: Vec<u32>,
}
