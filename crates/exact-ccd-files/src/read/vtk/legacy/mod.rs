//! The legacy format, versions 1 to 5.1, as text and binary: unstructured grids and surfaces.
//!
//! Binary numbers are big-endian. Version 5 writes cells as offsets and corners, earlier ones as
//! the number of corners before the corners of each cell.

mod values;

use super::super::budget::Budget;
use super::super::cells::Cells;
use super::cell::{POLY_LINE, POLY_VERTEX, POLYGON, TRIANGLE_STRIP};
use super::list::CellList;
use crate::error::{Fault, ParseError, Place, quoted};
use values::Values;

pub(in super::super) fn read(bytes: &[u8], budget: &Budget) -> Result<Cells, ParseError> {
    let mut values = Values::new(bytes, budget)?;
    values.keyword("DATASET")?;
    let (place, kind) = values.word("the kind of the data set")?;
    match kind.to_ascii_uppercase().as_slice() {
        b"UNSTRUCTURED_GRID" | b"POLYDATA" => {}
        b"STRUCTURED_GRID" | b"STRUCTURED_POINTS" | b"RECTILINEAR_GRID" | b"FIELD" => {
            let expected = "`UNSTRUCTURED_GRID` or `POLYDATA` (in pyvista: extract_surface())";
            return Err(Fault::expected(expected, quoted(kind)).at(place));
        }
        _ => return Err(Fault::expected("`UNSTRUCTURED_GRID` or `POLYDATA`", quoted(kind)).at(place)),
    }
    let mut sections = Sections {
        values,
        cells: Cells::default(),
        lists: Vec::new(),
        types: None,
    };
    while sections.read_next()? {}
    sections.finish()
}

/// A list of cells in the file.
struct List {
    place: Place,
    /// The type of all cells, or none for the list with the types of a grid.
    kind: Option<i64>,
    corners: Vec<i64>,
    ends: Vec<i64>,
}

/// The sections that were read. Cells may come before points.
struct Sections<'a> {
    values: Values<'a>,
    cells: Cells,
    lists: Vec<List>,
    types: Option<Vec<i64>>,
}

impl Sections<'_> {
    /// Reads the next section. Returns false at the end, and where data of points or cells begin.
    fn read_next(&mut self) -> Result<bool, ParseError> {
        let Some((place, word)) = self.values.next_word() else {
            return Ok(false);
        };
        match word.to_ascii_uppercase().as_slice() {
            b"POINTS" => self.read_points()?,
            b"CELLS" => self.read_list(place, None)?,
            b"VERTICES" => self.read_list(place, Some(POLY_VERTEX))?,
            b"LINES" => self.read_list(place, Some(POLY_LINE))?,
            b"TRIANGLE_STRIPS" => self.read_list(place, Some(TRIANGLE_STRIP))?,
            b"POLYGONS" => self.read_list(place, Some(POLYGON))?,
            b"CELL_TYPES" => {
                let count = self.values.count("the number of cells")?;
                self.types = Some(self.values.integers(count, b"int")?);
            }
            b"FIELD" => self.skip_field()?,
            b"METADATA" => self.values.skip_paragraph(),
            b"POINT_DATA" | b"CELL_DATA" => return Ok(false),
            _ => {
                let expected = "a section such as `POINTS`, `CELLS` or `POLYGONS`";
                return Err(Fault::expected(expected, quoted(word)).at(place));
            }
        }
        Ok(true)
    }

    fn read_points(&mut self) -> Result<(), ParseError> {
        let place = self.values.place();
        let count = self.values.count("the number of points")?;
        let (_, kind) = self.values.word("a type such as `float`")?;
        let coordinates = self.values.reals(count.saturating_mul(3), kind)?;
        if !self.cells.positions.is_empty() {
            return Err(Fault::expected("one section `POINTS`", "another one").at(place));
        }
        self.cells.positions = coordinates.as_chunks().0.to_vec();
        Ok(())
    }

    fn read_list(&mut self, place: Place, kind: Option<i64>) -> Result<(), ParseError> {
        let count = self.values.count("the number of cells")?;
        let size = self.values.count("the number of integers")?;
        let (corners, ends) = if self.values.next_is(b"OFFSETS") {
            let (_, kind) = self.values.word("a type of integers")?;
            let mut ends = self.values.integers(count, kind)?;
            // The first offset is that of cell 0.
            if !ends.is_empty() && ends.remove(0) != 0 {
                return Err(Fault::expected("offset 0", "another one").at(place));
            }
            self.values.keyword("CONNECTIVITY")?;
            let (_, kind) = self.values.word("a type of integers")?;
            (self.values.integers(size, kind)?, ends)
        } else {
            split(&self.values.integers(size, b"int")?, count).map_err(|fault| fault.at(place))?
        };
        self.values.budget().hold::<List>(1);
        self.lists.push(List {
            place,
            kind,
            corners,
            ends,
        });
        Ok(())
    }

    /// Skips arrays that belong to the file as a whole.
    fn skip_field(&mut self) -> Result<(), ParseError> {
        self.values.word("the name of a field")?;
        for _ in 0..self.values.count("the number of arrays")? {
            let (_, name) = self.values.word("the name of an array")?;
            if name.eq_ignore_ascii_case(b"METADATA") {
                self.values.skip_paragraph();
                self.values.word("the name of an array")?;
            }
            let components = self.values.count("the number of components")?;
            let tuples = self.values.count("the number of tuples")?;
            let (_, kind) = self.values.word("a type such as `float`")?;
            self.values.skip(components.saturating_mul(tuples), kind)?;
        }
        Ok(())
    }

    fn finish(mut self) -> Result<Cells, ParseError> {
        for list in &self.lists {
            let types = match (list.kind, &self.types) {
                (Some(kind), _) => &vec![kind; list.ends.len()],
                (None, Some(types)) => types,
                (None, None) => return Err(Fault::ends("`CELL_TYPES`").at(self.values.place())),
            };
            let list = CellList {
                corners: &list.corners,
                ends: &list.ends,
                types,
                place: &|| list.place,
            };
            let points = 0..self.cells.positions.len();
            list.add_to(&mut self.cells, points)?;
        }
        Ok(self.cells)
    }
}

/// The corners of cells, and their number up to the end of each cell, from a list with the number
/// of corners before each cell.
fn split(list: &[i64], count: u64) -> Result<(Vec<i64>, Vec<i64>), Fault> {
    let (mut corners, mut ends) = (Vec::new(), Vec::new());
    let mut rest = list;
    for cell in 0..count {
        let length = rest
            .split_off_first()
            .and_then(|&length| usize::try_from(length).ok());
        let cell_corners = length.and_then(|length| rest.split_off(..length));
        corners.extend(cell_corners.ok_or_else(|| Fault::ends(format!("cell {cell} of {count}")))?);
        ends.push(corners.len() as i64);
    }
    match rest {
        [] => Ok((corners, ends)),
        _ => Err(Fault::expected(
            format!("{} integers for {count} cells", list.len() - rest.len()),
            list.len().to_string(),
        )),
    }
}
