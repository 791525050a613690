//! Cells of all kinds over the same vertices.

use std::io;

use exact_ccd_mesh::{Frame, Point, TetMesh, check_positions};

use super::check::invalid;

/// Tetrahedra, triangles, lines and points over the same vertices: solids, shells, rods and points
/// in one VTK file.
///
/// ```
/// use exact_ccd_files::{UnstructuredGrid, write_vtu};
///
/// let grid = UnstructuredGrid {
///     positions: &[[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
///     tetrahedra: &[[0, 1, 2, 3]],
///     ..UnstructuredGrid::default()
/// };
/// let mut vtu = Vec::new();
/// write_vtu(&mut vtu, grid)?;
/// assert!(String::from_utf8_lossy(&vtu).contains(r#"<Piece NumberOfPoints="4" NumberOfCells="1">"#));
/// # Ok::<(), std::io::Error>(())
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct UnstructuredGrid<'a> {
    /// The position of each vertex.
    pub positions: &'a [Point],
    /// Tetrahedra, the first cells.
    pub tetrahedra: &'a [[u32; 4]],
    /// Triangles, the cells after the tetrahedra.
    pub triangles: &'a [[u32; 3]],
    /// Lines, the cells after the triangles.
    pub lines: &'a [[u32; 2]],
    /// Vertices that are points, the last cells. Beside tetrahedra, only listed points are read back.
    pub points: &'a [u32],
    /// The velocity of each vertex, written as point data `velocity`; none to write no velocities.
    pub velocities: Option<&'a [Point]>,
    /// The number of the body of each vertex, written as point data and cell data `body`; none to write no
    /// bodies. A cell belongs to the body of its first corner.
    pub bodies: Option<&'a [u32]>,
    /// The id of each vertex, written as point data `id`; none to write no ids.
    pub ids: Option<&'a [u32]>,
}

/// The faces and loose edges of a frame.
impl<'a> From<&'a Frame> for UnstructuredGrid<'a> {
    fn from(frame: &'a Frame) -> Self {
        Self {
            positions: &frame.positions,
            triangles: frame.mesh.faces(),
            lines: frame.mesh.loose_edges(),
            ..Self::default()
        }
    }
}

/// The tetrahedra of a mesh.
impl<'a> From<&'a TetMesh> for UnstructuredGrid<'a> {
    fn from(mesh: &'a TetMesh) -> Self {
        Self {
            positions: mesh.positions(),
            tetrahedra: mesh.tetrahedra(),
            ..Self::default()
        }
    }
}

impl UnstructuredGrid<'_> {
    /// Checks that coordinates and velocities are finite, corners are vertices, and each vertex has
    /// a velocity, a body and an id, where they are given.
    pub(super) fn check(&self) -> io::Result<()> {
        let count = self.positions.len();
        check_positions(count, self.positions).map_err(invalid)?;
        let cells = [
            self.tetrahedra.as_flattened(),
            self.triangles.as_flattened(),
            self.lines.as_flattened(),
            self.points,
        ];
        let mut corners = cells.into_iter().flatten();
        if let Some(corner) = corners.find(|&&corner| corner as usize >= count) {
            return Err(invalid(format!(
                "a cell names vertex {corner}, but there are only {count} vertices"
            )));
        }
        let velocities = self.velocities.unwrap_or_default();
        for (name, found) in [
            ("bodies of vertices", self.bodies.map(<[_]>::len)),
            ("ids", self.ids.map(<[_]>::len)),
            ("velocities", self.velocities.map(<[_]>::len)),
        ] {
            if let Some(found) = found.filter(|&found| found != count) {
                return Err(invalid(format!(
                    "{found} {name}, expected one for each of {count} vertices"
                )));
            }
        }
        match velocities.as_flattened().iter().find(|v| !v.is_finite()) {
            None => Ok(()),
            Some(v) => Err(invalid(format!(
                "a velocity has the component {v}, expected a finite number"
            ))),
        }
    }
}
