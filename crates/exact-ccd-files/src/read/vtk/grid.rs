//! XML files: unstructured grids, and surfaces as lists of points, lines, polygons and strips.

use roxmltree::Node;

use super::super::budget::Budget;
use super::super::cells::Cells;
use super::appended;
use super::array::Encoding;
use super::cell::{POLY_LINE, POLY_VERTEX, POLYGON, TRIANGLE_STRIP, WARP, is_displacement};
use super::list::CellList;
use super::xml::{File, parse_xml};
use crate::error::{ParseError, quoted};
use crate::note::Fact;

/// The lists of a surface, the attributes with the numbers of their cells, and the type of these.
const LISTS: [(&str, &str, i64); 4] = [
    ("Verts", "NumberOfVerts", POLY_VERTEX),
    ("Lines", "NumberOfLines", POLY_LINE),
    ("Strips", "NumberOfStrips", TRIANGLE_STRIP),
    ("Polys", "NumberOfPolys", POLYGON),
];

/// The root of a file, which has this type: `UnstructuredGrid` or `PolyData`.
pub(in super::super) fn read(bytes: &[u8], kind: &str, budget: &Budget) -> Result<Cells, ParseError> {
    let parts = appended::split(bytes, budget);
    let document = parse_xml(&parts.xml, budget)?;
    let file = File::new(&document, kind)?;
    let encoding = Encoding::of(&file, parts.appended, budget)?;
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
        for data in piece.children() {
            for array in data.children() {
                self.note_unread(data, array);
            }
        }
        if let Some(list) = piece.children().find(|child| child.has_tag_name("Cells")) {
            let types = self.integers(list, "types")?;
            let count = self.read_list(list, first, |_| types)?;
            return self.check_count(piece, "NumberOfCells", count);
        }
        for (name, number, kind) in LISTS {
            let list = piece.children().find(|child| child.has_tag_name(name));
            // A list without cells may have no arrays.
            let list = list.filter(|list| list.first_element_child().is_some());
            let count = match list {
                Some(list) => self.read_list(list, first, |count| vec![kind; count])?,
                None => 0,
            };
            self.check_count(piece, number, count)?;
        }
        Ok(())
    }

    /// Adds a note about an array with data that change the meaning of points or cells.
    fn note_unread(&mut self, data: Node<'a, 'a>, array: Node<'a, 'a>) {
        let name = array.attribute("Name").unwrap_or_default();
        let remedy = match data.tag_name().name() {
            "PointData" if is_displacement(name.as_bytes()) => WARP,
            "PointData" | "CellData" if name == "vtkGhostType" => {
                "remove the cells that it marks (in ParaView: Remove Ghost Information)"
            }
            _ => return,
        };
        let part = format!("the array {}", quoted(name.as_bytes()));
        self.cells
            .note(Fact::not_read(part, remedy).at(self.file.place(array)));
    }

    fn read_points(&mut self, piece: Node<'a, 'a>) -> Result<(), ParseError> {
        let points = self.file.child(piece, "Points")?;
        if piece.attribute("NumberOfPoints") == Some("0") {
            return Ok(());
        }
        let array = self.file.child(points, "DataArray")?;
        let components = array.attribute("NumberOfComponents").unwrap_or("3");
        if components != "3" {
            let found = quoted(components.as_bytes());
            return Err(self.file.fault(array, "three components of each point", found));
        }
        let coordinates = self.encoding.reals(self.file, array)?;
        let (positions, rest) = coordinates.as_chunks::<3>();
        if !rest.is_empty() {
            let found = format!("{} numbers", coordinates.len());
            return Err(self.file.fault(points, "three coordinates for each point", found));
        }
        self.cells.positions.extend(positions);
        self.check_count(piece, "NumberOfPoints", positions.len())
    }

    /// Compares a number that an attribute of a piece declares with that of its arrays.
    fn check_count(&self, piece: Node<'a, 'a>, name: &str, count: usize) -> Result<(), ParseError> {
        match piece.attribute(name) {
            Some(declared) if declared.parse() != Ok(count) => {
                let declared = quoted(declared.as_bytes());
                let expected = format!("as many elements as `{name}` says, {declared}");
                Err(self.file.fault(piece, expected, count.to_string()))
            }
            _ => Ok(()),
        }
    }

    /// Appends the cells of a list, with the types that belong to their number, and returns this number.
    /// Corners are counted from the vertex `first`.
    fn read_list(
        &mut self,
        list: Node<'a, 'a>,
        first: usize,
        types: impl FnOnce(usize) -> Vec<i64>,
    ) -> Result<usize, ParseError> {
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
        list.add_to(&mut self.cells, points)?;
        Ok(ends.len())
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
