//! The elements of a primitive.

use super::super::cells::Cells;
use super::super::polygons::strip;
use super::document::{Mode, Primitive};
use crate::error::Fault;

/// A primitive and its place in its mesh.
pub(super) struct Part<'a> {
    pub(super) number: usize,
    pub(super) primitive: &'a Primitive,
}

/// Adds the elements of a list of vertices.
pub(super) fn add(cells: &mut Cells, mode: Mode, vertices: &[u32]) {
    let triangles = &mut cells.faces.triangles;
    match mode {
        Mode::Points => cells.points.extend(vertices),
        Mode::Lines => cells.lines.extend(vertices.as_chunks::<2>().0),
        Mode::LineStrip => cells.add_polyline(vertices),
        Mode::LineLoop => {
            cells.add_polyline(vertices);
            if let [first, .., last] = vertices {
                cells.lines.push([*last, *first]);
            }
        }
        Mode::Triangles => triangles.extend(vertices.as_chunks::<3>().0),
        Mode::TriangleStrip => triangles.extend(strip(vertices)),
        Mode::TriangleFan => {
            if let Some((&center, around)) = vertices.split_first() {
                triangles.extend(around.windows(2).map(|pair| [center, pair[0], pair[1]]));
            }
        }
    }
    cells.faces.count = cells.faces.triangles.len();
}

/// Refuses a number of vertices with which the last element of a primitive is not whole.
pub(super) fn check_count(part: &Part, count: usize) -> Result<(), Fault> {
    let (is_whole, expected) = match part.primitive.mode {
        Mode::Points => (true, ""),
        Mode::Lines => (count.is_multiple_of(2), "two vertices for each line"),
        Mode::Triangles => (count.is_multiple_of(3), "three vertices for each triangle"),
        Mode::LineStrip | Mode::LineLoop => (count != 1, "two or more vertices of a strip of lines"),
        Mode::TriangleStrip | Mode::TriangleFan => {
            let is_whole = !matches!(count, 1 | 2);
            (is_whole, "three or more vertices of a strip or fan of triangles")
        }
    };
    if is_whole {
        return Ok(());
    }
    let place = match part.primitive.indices {
        Some(accessor) => format!("accessor {accessor}"),
        None => format!("primitive {} without indices", part.number),
    };
    Err(Fault::expected(
        format!("{expected} in {place}"),
        count.to_string(),
    ))
}
