//! Triangles and tetrahedra over the same vertices, as some formats have them.

use exact_ccd::Point;

use super::error::{Fault, ParseError, Place};
use crate::frame::Frame;
use crate::tet_mesh::TetMesh;

#[derive(Default)]
pub(super) struct Cells {
    pub(super) positions: Vec<Point>,
    pub(super) triangles: Vec<[u32; 3]>,
    pub(super) tetrahedra: Vec<[u32; 4]>,
}

impl Cells {
    /// The surface of the tetrahedra, or, if there are none, the triangles as they are.
    pub(super) fn into_frame(self) -> Result<Frame, ParseError> {
        if self.tetrahedra.is_empty() {
            let frame = Frame::new(self.positions, self.triangles);
            return frame.map_err(|error| Fault::Frame(error).at(Place::File));
        }
        Ok(self.into_tet_mesh()?.surface_frame().0)
    }

    /// The surface of the tetrahedra, and the triangles that are no faces of them, as shells beside solids.
    pub(super) fn into_scene(mut self) -> Result<Frame, ParseError> {
        if self.tetrahedra.is_empty() {
            return self.into_frame();
        }
        let triangles = std::mem::take(&mut self.triangles);
        Ok(self.into_tet_mesh()?.surface_with_shells(&triangles))
    }

    /// Triangles may be listed, but each must be a face of a tetrahedron: what else is it to be?
    pub(super) fn into_tet_mesh(self) -> Result<TetMesh, ParseError> {
        let at_file = |fault: Fault| fault.at(Place::File);
        let mesh =
            TetMesh::new(self.positions, self.tetrahedra).map_err(|error| at_file(Fault::TetMesh(error)))?;
        let sheet = mesh.no_faces(&self.triangles).next();
        match sheet {
            None => Ok(mesh),
            Some(triangle) => Err(at_file(Fault::Sheet { triangle })),
        }
    }
}
