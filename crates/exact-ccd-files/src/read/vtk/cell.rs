//! Cells of VTK by the number of their type.

use super::super::cells::Cells;
use super::super::polygons::strip;
use super::super::solids::Solid;
use crate::error::{Fault, ParseError, Place};

/// The types of the lists of a surface.
pub(super) const POLY_VERTEX: i64 = 2;
pub(super) const POLY_LINE: i64 = 4;
pub(super) const TRIANGLE_STRIP: i64 = 6;
pub(super) const POLYGON: i64 = 7;

/// The remedy for displacements that are not read.
pub(super) const WARP: &str = "if the points do not have the displacement, apply it before the export (in ParaView: Warp By Vector, in \
     pyvista: warp_by_vector())";

/// Returns true for the name of an array of points that may be a displacement.
pub(super) fn is_displacement(name: &[u8]) -> bool {
    name.get(..4)
        .is_some_and(|beginning| beginning.eq_ignore_ascii_case(b"disp"))
}

/// Adds cell number `cell` of a file: its type by VTK's number, and its corners.
///
/// # Errors
/// For types that are not supported and wrong numbers of corners.
pub(super) fn add(
    cells: &mut Cells,
    cell: usize,
    kind: i64,
    corners: &[u32],
    place: impl Fn() -> Place,
) -> Result<(), ParseError> {
    match (kind, corners) {
        // An empty cell.
        (0, []) => {}
        (1, [_]) | (POLY_VERTEX, _) => cells.points.extend(corners),
        (3, [_, _]) | (POLY_LINE, [_, _, ..]) => cells.add_polyline(corners),
        (5, [_, _, _]) | (POLYGON, _) | (9, [_, _, _, _]) => cells.faces.add(corners, place)?,
        (TRIANGLE_STRIP, [_, _, _, ..]) => {
            for triangle in strip(corners) {
                cells.faces.add(&triangle, &place)?;
            }
        }
        // The corners of a pixel and of a voxel are ordered by their coordinates.
        (8, &[a, b, c, d]) => cells.faces.add(&[a, b, d, c], place)?,
        (11, &[a, b, c, d, e, f, g, h]) => cells.solids.push(Solid::Hexahedron([a, b, d, c, e, f, h, g])),
        (10, [_, _, _, _])
        | (12, [_, _, _, _, _, _, _, _])
        | (13, [_, _, _, _, _, _])
        | (14, [_, _, _, _, _]) => {
            cells.solids.extend(Solid::of(corners));
        }
        _ => {
            let found = format!(
                "cell {cell} of type {kind}{} with {} corners",
                name(kind),
                corners.len()
            );
            return Err(Fault::expected("a linear cell (types 1 to 14)", found).at(place()));
        }
    }
    Ok(())
}

/// The name of a type that is not supported and the remedy, for messages.
fn name(kind: i64) -> &'static str {
    match kind {
        15 | 16 => " (a prism; in ParaView: Extract Surface)",
        21..=37 => " (a quadratic cell; in ParaView: Tessellate, in pyvista: linear_copy())",
        42 => " (a polyhedron; in ParaView: Extract Surface, in pyvista: extract_surface())",
        60..=81 => " (a cell of higher order; in ParaView: Tessellate)",
        _ => "",
    }
}
