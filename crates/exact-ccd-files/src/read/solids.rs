//! Cells with volume, and the surface of all of them.

use arrayvec::ArrayVec;
use exact_ccd_mesh::TetMeshError;

use super::polygons::{Faces, fan};
use crate::error::{Fault, ParseError, Place};

/// A cell with volume, with its corners in the order of VTK and Gmsh.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Solid {
    Tetrahedron([u32; 4]),
    /// A quadrilateral and an apex.
    Pyramid([u32; 5]),
    /// Two triangles; a prism.
    Wedge([u32; 6]),
    /// Two opposite quadrilaterals.
    Hexahedron([u32; 8]),
}

impl Solid {
    /// The cell with these corners, whose number determines its kind.
    pub(super) fn of(corners: &[u32]) -> Option<Self> {
        match *corners {
            [a, b, c, d] => Some(Self::Tetrahedron([a, b, c, d])),
            [a, b, c, d, e] => Some(Self::Pyramid([a, b, c, d, e])),
            [a, b, c, d, e, f] => Some(Self::Wedge([a, b, c, d, e, f])),
            [a, b, c, d, e, f, g, h] => Some(Self::Hexahedron([a, b, c, d, e, f, g, h])),
            _ => None,
        }
    }

    fn corners(&self) -> &[u32] {
        match self {
            Self::Tetrahedron(corners) => corners,
            Self::Pyramid(corners) => corners,
            Self::Wedge(corners) => corners,
            Self::Hexahedron(corners) => corners,
        }
    }

    /// The sides as indices into the corners, outward for a cell of positive volume.
    fn numbers(&self) -> &'static [&'static [usize]] {
        match self {
            Self::Tetrahedron(_) => &[&[0, 2, 1], &[0, 1, 3], &[0, 3, 2], &[1, 2, 3]],
            Self::Pyramid(_) => &[&[0, 3, 2, 1], &[0, 1, 4], &[1, 2, 4], &[2, 3, 4], &[3, 0, 4]],
            Self::Wedge(_) => &[
                &[0, 2, 1],
                &[3, 4, 5],
                &[0, 1, 4, 3],
                &[1, 2, 5, 4],
                &[2, 0, 3, 5],
            ],
            Self::Hexahedron(_) => &[
                &[0, 3, 2, 1],
                &[4, 5, 6, 7],
                &[0, 1, 5, 4],
                &[1, 2, 6, 5],
                &[2, 3, 7, 6],
                &[3, 0, 4, 7],
            ],
        }
    }

    /// The sides, each with a corner that follows itself only once. A cell in which corners
    /// coincide has sides of fewer corners, or of no area.
    pub(super) fn sides(&self) -> impl Iterator<Item = ArrayVec<u32, 4>> {
        let sides = self.numbers().iter().map(|side| {
            let corners = side.iter().map(|&k| self.corners()[k]);
            let mut kept = ArrayVec::new();
            for corner in corners {
                if kept.last() != Some(&corner) {
                    kept.push(corner);
                }
            }
            while kept.len() > 1 && kept.first() == kept.last() {
                kept.pop();
            }
            kept
        });
        sides.filter(|side| side.len() >= 3)
    }
}

/// A side of one cell. The order of the fields is the order in which sides are sorted.
#[derive(PartialEq, Eq, PartialOrd, Ord)]
struct Side {
    /// The vertices in increasing order, each once; of three vertices the last one twice.
    vertices: [u32; 4],
    cell: usize,
    /// The index among the sides of the cell.
    number: usize,
}

/// The sides that belong to one cell only, in the order of the cells, as triangles.
///
/// Their orientation is that of the cells and does not depend on positions.
///
/// # Errors
/// If more than two cells share a side, or a tetrahedron has a corner twice.
pub(super) fn surface(cells: &[Solid]) -> Result<Faces, ParseError> {
    let mut sides = Vec::new();
    for (cell, solid) in cells.iter().enumerate() {
        if let Solid::Tetrahedron(corners) = solid
            && (1..4).any(|k| corners[..k].contains(&corners[k]))
        {
            return Err(Fault::TetMesh(TetMeshError::Flat { tetrahedron: cell }).at(Place::File));
        }
        for (number, side) in solid.sides().enumerate() {
            let vertices = vertex_set(side);
            sides.push(Side {
                vertices,
                cell,
                number,
            });
        }
    }
    sides.sort_unstable();
    let mut outer = Vec::new();
    for shared in sides.chunk_by(|a, b| a.vertices == b.vertices) {
        match shared {
            [side] => outer.push((side.cell, side.number)),
            [_, _] => {}
            _ => {
                let cells = shared.iter().take(3).map(|side| side.cell).collect();
                return Err(Fault::SharedSide { cells }.at(Place::File));
            }
        }
    }
    outer.sort_unstable();
    let mut faces = Faces::default();
    for (cell, number) in outer {
        if let Some(mut side) = cells[cell].sides().nth(number) {
            // As the fan of a side with more corners.
            let least = (0..side.len()).min_by_key(|&k| side[k]);
            side.rotate_left(least.unwrap_or(0));
            faces.add(&side, || Place::File)?;
        }
    }
    Ok(faces)
}

/// The triangles of all sides, each with its vertices in increasing order, sorted.
pub(super) fn all_triangles(cells: &[Solid]) -> Vec<[u32; 3]> {
    let mut triangles = Vec::new();
    for side in cells.iter().flat_map(Solid::sides) {
        triangles.extend(fan(&side).map(increasing));
    }
    triangles.sort_unstable();
    triangles
}

/// The vertices in increasing order.
pub(super) fn increasing<const N: usize>(mut vertices: [u32; N]) -> [u32; N] {
    vertices.sort_unstable();
    vertices
}

/// The distinct vertices in increasing order, the last one repeated.
fn vertex_set(mut side: ArrayVec<u32, 4>) -> [u32; 4] {
    side.sort_unstable();
    let mut last = None;
    side.retain(|vertex| last.replace(*vertex) != Some(*vertex));
    let last = last.unwrap_or_default();
    std::array::from_fn(|k| side.get(k).copied().unwrap_or(last))
}
