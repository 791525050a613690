//! XML files: unstructured grids, and surfaces as lists of points, lines, polygons and strips.

use roxmltree::Node;

use super::super::cells::Cells;
use super::appended;
use super::array::Encoding;
use super::cell::{POLY_LINE, POLY_VERTEX, POLYGON, TRIANGLE_STRIP};
use super::list::CellList;
use super::xml::{File, parse_xml};
use crate::error::ParseError;

/// The lists of a surface, and the type of their cells.
const LISTS: [(&str, i64); 4] = [
    ("Verts", POLY_VERTEX),
    ("Lines", POLY_LINE),
    ("Strips", TRIANGLE_STRIP),
    ("Polys", POLYGON),
];

/// The root of a file, which has this type: `UnstructuredGrid` or `PolyData`.
pub(in super::super) fn read(bytes: &[u8], kind: &str) -> Result<Cells, ParseError> {
    let parts = appended::split(bytes);
    let document = parse_xml(&parts.xml)?;
    let file = File::new(&document, kind)?;
    let encoding = Encoding::of(&file, parts.appended, bytes.len())?;
    let mut reader = Reader {
        file: &file,
        encoding,
        cells: Cells::default(),
    };
    let data = file.child(file.root, kind)?;
    for piece in data.children().filter(|child| child.has_tag_name("Piece")) {
        reader.read_piece(piece)?;
    }
    Ok(reader.cells)
}

struct Reader<'f, 'a> {
    file: &'f File<'a>,
    encoding: Encoding<'f>,
    cells: Cells,
}

impl<'a> Reader<'_, 'a> {
    /// Appends the points and cells of a piece.
    fn read_piece(&mut self, piece: Node<'a, 'a>) -> Result<(), ParseError> {
        let first = self.cells.positions.len();
        self.read_points(piece)?;
        if let Some(list) = piece.children().find(|child| child.has_tag_name("Cells")) {
            let types = self.integers(list, "types")?;
            return self.read_list(list, first, |_| types);
        }
        for (name, kind) in LISTS {
            let list = piece.children().find(|child| child.has_tag_name(name));
            // A list without cells may have no arrays.
            if let Some(list) = list.filter(|list| list.first_element_child().is_some()) {
                self.read_list(list, first, |count| vec![kind; count])?;
            }
        }
        Ok(())
    }

    fn read_points(&mut self, piece: Node<'a, 'a>) -> Result<(), ParseError> {
        let points = self.file.child(piece, "Points")?;
        if piece.attribute("NumberOfPoints") == Some("0") {
            return Ok(());
        }
        let coordinates = self
            .encoding
            .reals(self.file, self.file.child(points, "DataArray")?)?;
        let (positions, rest) = coordinates.as_chunks::<3>();
        if !rest.is_empty() {
            let found = format!("{} numbers", coordinates.len());
            return Err(self.file.fault(points, "three coordinates for each point", found));
        }
        self.cells.positions.extend(positions);
        Ok(())
    }

    /// Appends the cells of a list, with the types that belong to their number. Corners are counted
    /// from the vertex `first`.
    fn read_list(
        &mut self,
        list: Node<'a, 'a>,
        first: usize,
        types: impl FnOnce(usize) -> Vec<i64>,
    ) -> Result<(), ParseError> {
        let (corners, ends) = (
            self.integers(list, "connectivity")?,
            self.integers(list, "offsets")?,
        );
        let list = CellList {
            corners: &corners,
            ends: &ends,
            types: &types(ends.len()),
            place: &|| self.file.place(list),
        };
        let points = first..self.cells.positions.len();
        list.add_to(&mut self.cells, points)
    }

    /// The array of integers with this name.
    fn integers(&self, list: Node<'a, 'a>, name: &str) -> Result<Vec<i64>, ParseError> {
        let mut arrays = list
            .children()
            .filter(|child| child.attribute("Name") == Some(name));
        let node = arrays
            .next()
            .ok_or_else(|| self.file.fault(list, format!("an array `{name}`"), "none"))?;
        self.encoding.integers(self.file, node)
    }
}
