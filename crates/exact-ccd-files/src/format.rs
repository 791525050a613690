//! Formats of mesh files.

use std::path::Path;

/// A format of mesh files.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Format {
    /// The Stanford polygon format: text, or binary of either byte order.
    Ply,
    /// Wavefront OBJ.
    Obj,
    /// Stereolithography: text or binary.
    Stl,
    /// The Object File Format of Geomview, as text.
    Off,
    /// Gmsh's MSH, version 2.2 or 4.1: text, or binary of either byte order. Tetrahedra read as
    /// their surface.
    Msh,
    /// VTK's XML format of unstructured grids: data inline, as text or in base64, not compressed.
    /// Tetrahedra read as their surface, and other triangles beside them as they are.
    Vtu,
}

impl Format {
    /// The format that belongs to the extension of a path, in upper or lower case.
    #[must_use]
    pub fn of_path(path: &Path) -> Option<Self> {
        match path.extension()?.to_str()?.to_ascii_lowercase().as_str() {
            "ply" => Some(Self::Ply),
            "obj" => Some(Self::Obj),
            "stl" => Some(Self::Stl),
            "off" => Some(Self::Off),
            "msh" => Some(Self::Msh),
            "vtu" => Some(Self::Vtu),
            _ => None,
        }
    }
}
