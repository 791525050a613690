//! Meshes of tetrahedra from Gmsh files, with their groups.

use std::path::Path;

use exact_ccd_mesh::TetMesh;

use super::budget::Budget;
use super::file::{parse_bytes, parse_file};
use super::group::Group;
use super::msh;
use crate::error::{ParseError, ReadError};

/// Reads the tetrahedra in a Gmsh file, `.msh`, version 1 to 2.2, 4 or 4.1, text or binary; and its
/// physical groups, by increasing dimension and tag.
///
/// Vertices and tetrahedra keep their order in the file and are counted from 0, whatever their
/// tags. Triangles are allowed if they are faces of tetrahedra. Points and lines are skipped.
///
/// An element belongs to the group of its first tag before version 4, and to those of its entity from then
/// on.
/// Groups without elements are left out. In a partitioned mesh of version 4, elements belong to none.
///
/// # Errors
/// [`ReadError`] names the file, the place in it, and what was expected there.
pub fn read_tet_mesh(path: impl AsRef<Path>) -> Result<(TetMesh, Vec<Group>), ReadError> {
    parse_file(path.as_ref(), u64::MAX, tet_mesh)
}

/// Parses the contents of a Gmsh file, with the same result as [`read_tet_mesh`].
///
/// # Errors
/// [`ParseError`] names the place and what was expected there.
pub fn parse_tet_mesh(bytes: &[u8]) -> Result<(TetMesh, Vec<Group>), ParseError> {
    parse_bytes(bytes, u64::MAX, tet_mesh)
}

fn tet_mesh(bytes: &[u8], budget: &Budget) -> Result<(TetMesh, Vec<Group>), ParseError> {
    let mut cells = msh::read(bytes, budget)?;
    let groups = std::mem::take(&mut cells.groups);
    Ok((cells.into_tet_mesh()?, groups))
}
