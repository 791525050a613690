//! Meshes of tetrahedra from Gmsh files.

use std::path::Path;

use exact_ccd_mesh::TetMesh;

use super::file::parse_file;
use super::msh;
use crate::error::{ParseError, ReadError};

/// Reads the tetrahedra in a Gmsh file, `.msh`, version 2.2 or 4.1, text or binary.
///
/// Vertices and tetrahedra keep their order in the file and are counted from 0, whatever their
/// tags. Triangles are allowed if they are faces of tetrahedra. Points and lines are skipped.
///
/// # Errors
/// [`ReadError`] names the file, the place in it, and what was expected there.
pub fn read_tet_mesh(path: impl AsRef<Path>) -> Result<TetMesh, ReadError> {
    parse_file(path.as_ref(), parse_tet_mesh)
}

/// Parses the contents of a Gmsh file, with the same result as [`read_tet_mesh`].
///
/// # Errors
/// [`ParseError`] names the place and what was expected there.
pub fn parse_tet_mesh(bytes: &[u8]) -> Result<TetMesh, ParseError> {
    msh::read(bytes)?.into_tet_mesh()
}
