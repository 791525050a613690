//! Unstructured grids of points, lines, triangles and tetrahedra.

use roxmltree::Node;

use super::super::cells::Cells;
use super::array::Encoding;
use super::xml::{File, parse_xml};
use crate::error::{ParseError, quoted};

/// VTK's numbers of the supported types of cells.
const VERTEX: i64 = 1;
const POLY_VERTEX: i64 = 2;
const LINE: i64 = 3;
const POLY_LINE: i64 = 4;
const TRIANGLE: i64 = 5;
const TETRAHEDRON: i64 = 10;

const SUPPORTED: &str = "points (type 1 or 2), lines (3 or 4), triangles (5) or tetrahedra (10)";

pub(in super::super) fn read(bytes: &[u8]) -> Result<Cells, ParseError> {
    let document = parse_xml(bytes)?;
    let file = File::new(&document, "UnstructuredGrid")?;
    let encoding = Encoding::of(&file)?;
    let piece = file.child(file.child(file.root, "UnstructuredGrid")?, "Piece")?;
    let points = file.child(file.child(piece, "Points")?, "DataArray")?;
    let coordinates = encoding.reals(&file, points)?;
    let (positions, rest) = coordinates.as_chunks::<3>();
    if !rest.is_empty() {
        let found = format!("{} numbers", coordinates.len());
        return Err(file.fault(points, "three coordinates for each point", found));
    }
    let mut cells = Cells {
        positions: positions.to_vec(),
        ..Cells::default()
    };
    read_cells(&file, &encoding, file.child(piece, "Cells")?, &mut cells)?;
    Ok(cells)
}

fn read_cells<'a>(
    file: &File<'a>,
    encoding: &Encoding,
    parent: Node<'a, 'a>,
    cells: &mut Cells,
) -> Result<(), ParseError> {
    let array = |name: &str| {
        let mut arrays = parent
            .children()
            .filter(|child| child.attribute("Name") == Some(name));
        let node = arrays
            .next()
            .ok_or_else(|| file.fault(parent, format!("an array `{name}`"), "none"))?;
        encoding.integers(file, node)
    };
    let (corners, ends, types) = (array("connectivity")?, array("offsets")?, array("types")?);
    if ends.len() != types.len() {
        let found = format!("{} offsets and {} types", ends.len(), types.len());
        return Err(file.fault(parent, "as many offsets as types", found));
    }
    let vertex_count = cells.positions.len();
    let mut rest = corners.as_slice();
    let mut start = 0;
    for (cell, (end, kind)) in ends.into_iter().zip(types).enumerate() {
        let cell_corners = usize::try_from(end.saturating_sub(start))
            .ok()
            .and_then(|count| rest.split_off(..count))
            .ok_or_else(|| file.fault(parent, format!("the end of cell {cell}"), format!("offset {end}")))?;
        start = end;
        let numbered: Option<Vec<u32>> = cell_corners
            .iter()
            .map(|&corner| corner.try_into().ok())
            .collect();
        let in_range = |&corner: &u32| (corner as usize) < vertex_count;
        let numbered = numbered
            .filter(|corners| corners.iter().all(in_range))
            .ok_or_else(|| {
                let expected = format!("corners of cell {cell} among the {vertex_count} points");
                file.fault(parent, expected, quoted(format!("{cell_corners:?}").as_bytes()))
            })?;
        match (kind, numbered.as_slice()) {
            (VERTEX, [_]) | (POLY_VERTEX, _) => cells.points.extend(numbered),
            (LINE, [_, _]) | (POLY_LINE, [_, _, ..]) => cells.add_polyline(&numbered),
            (TRIANGLE, &[a, b, c]) => cells.triangles.push([a, b, c]),
            (TETRAHEDRON, &[a, b, c, d]) => cells.tetrahedra.push([a, b, c, d]),
            _ => {
                let found = format!("cell {cell} of type {kind} with {} corners", numbered.len());
                return Err(file.fault(parent, SUPPORTED, found));
            }
        }
    }
    if rest.is_empty() {
        return Ok(());
    }
    Err(file.fault(parent, format!("{start} corners"), corners.len().to_string()))
}
