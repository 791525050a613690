//! Meshes, from files and of shapes.

use std::path::Path;

use ccd_mesh::{Format, Frame, Point, TetMesh};

use super::description::Shape;
use crate::body::{Body, BodyKind};
use crate::shapes;

/// What there is of a mesh.
pub(super) struct Mesh {
    pub(super) points: Vec<Point>,
    pub(super) faces: Vec<[u32; 3]>,
    pub(super) tetrahedra: Vec<[u32; 4]>,
}

impl Mesh {
    /// The mesh in a file.
    pub(super) fn read(path: &Path) -> Result<Self, String> {
        if Format::of_path(path) == Some(Format::Msh) {
            let mesh = TetMesh::read(path).map_err(|error| error.to_string())?;
            return Ok(Self {
                points: mesh.positions().to_vec(),
                faces: mesh.surface().to_vec(),
                tetrahedra: mesh.tetrahedra().to_vec(),
            });
        }
        let frame = Frame::read(path).map_err(|error| error.to_string())?;
        Ok(Self {
            faces: frame.mesh.faces().to_vec(),
            points: frame.positions,
            tetrahedra: Vec::new(),
        })
    }

    /// The mesh of a shape.
    pub(super) fn generate(shape: Shape) -> Result<Self, String> {
        let cells: u64 = match shape {
            Shape::Box { cells, .. } => cells.map(u64::from).iter().product(),
            Shape::Grid { cells, .. } => cells.map(u64::from).iter().product(),
            Shape::Sphere { .. } => 0,
        };
        if cells > shapes::MOST_CELLS {
            return Err(format!("{cells} cells, expected at most {}", shapes::MOST_CELLS));
        }
        let Body { points, kind, .. } = match shape {
            Shape::Box { cells, size } => shapes::solid_box(cells, size),
            Shape::Grid { cells, size } => shapes::cloth(cells, size),
            Shape::Sphere { subdivisions, .. } if subdivisions > shapes::FINEST_SPHERE => {
                let finest = shapes::FINEST_SPHERE;
                return Err(format!("{subdivisions} subdivisions, expected at most {finest}"));
            }
            Shape::Sphere { subdivisions, radius } => shapes::sphere(subdivisions, radius),
        };
        let (faces, tetrahedra) = match kind {
            BodyKind::Shell { faces, .. } | BodyKind::Obstacle { faces } => (faces, Vec::new()),
            BodyKind::Solid { tetrahedra, .. } => {
                let surface =
                    TetMesh::new(points.clone(), tetrahedra.clone()).map(|mesh| mesh.surface().to_vec());
                (surface.unwrap_or_default(), tetrahedra)
            }
        };
        Ok(Self {
            points,
            faces,
            tetrahedra,
        })
    }
}
