//! Triangles and tetrahedra over the same vertices, as some formats have them.

use exact_ccd::Point;

use super::error::{Fault, ParseError, Place};
use crate::boundary::Sides;
use crate::frame::Frame;
use crate::tet_mesh::{TetMesh, TetMeshError};

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

    /// The surface of the tetrahedra, and the triangles that are no faces of them, as shells beside solids. Tetrahedra count
    /// as positive in the order of their corners: of a body that is deformed, inside out or not, the surface stays the same.
    pub(super) fn into_scene(self) -> Result<Frame, ParseError> {
        if self.tetrahedra.is_empty() {
            return self.into_frame();
        }
        let at_file = |error| Fault::TetMesh(error).at(Place::File);
        if let Some(tetrahedron) = self.tetrahedra.iter().position(|corners| !are_distinct(corners)) {
            return Err(at_file(TetMeshError::Flat { tetrahedron }));
        }
        let sides = Sides::of(self.tetrahedra);
        sides.check().map_err(at_file)?;
        let shells = self
            .triangles
            .into_iter()
            .filter(|&triangle| !sides.contain(triangle));
        let faces: Vec<[u32; 3]> = sides.boundary().into_iter().chain(shells).collect();
        let frame = Frame::new(self.positions, faces).map_err(|error| Fault::Frame(error).at(Place::File))?;
        Ok(frame.without_loose_vertices().0)
    }

    /// Triangles may be listed, but each must be a face of a tetrahedron: what else is it to be?
    pub(super) fn into_tet_mesh(self) -> Result<TetMesh, ParseError> {
        let at_file = |fault: Fault| fault.at(Place::File);
        let mesh =
            TetMesh::new(self.positions, self.tetrahedra).map_err(|error| at_file(Fault::TetMesh(error)))?;
        if self.triangles.is_empty() {
            return Ok(mesh);
        }
        let sides = Sides::of(mesh.tetrahedra().iter().copied());
        let is_sheet = |&triangle: &[u32; 3]| !sides.contain(triangle);
        match self.triangles.iter().position(is_sheet) {
            None => Ok(mesh),
            Some(triangle) => Err(at_file(Fault::Sheet { triangle })),
        }
    }
}

fn are_distinct(corners: &[u32; 4]) -> bool {
    (1..4).all(|k| !corners[..k].contains(&corners[k]))
}
