//! The legacy format, versions 1 to 5.1, as text and binary: unstructured grids and surfaces.
//!
//! Binary numbers are big-endian. Version 5 writes cells as offsets and corners, earlier ones as
//! the number of corners before the corners of each cell.

use super::super::budget::Budget;
use super::super::cells::Cells;
use super::super::scalar::{ByteOrder, Scalar};
use super::super::tokens::{Encoding, Syntax, Tokens};
use super::cell::{POLY_LINE, POLY_VERTEX, POLYGON, TRIANGLE_STRIP, WARP, is_displacement};
use super::list::CellList;
use crate::error::{Fault, ParseError, Place};
use crate::note::Fact;

pub(in super::super) fn read(bytes: &[u8], budget: &Budget) -> Result<Cells, ParseError> {
    let mut tokens = Tokens::text(bytes, Syntax::Free, budget);
    read_header(&mut tokens)?;
    tokens.keyword("DATASET")?;
    let kind = tokens.expect_word("the kind of the data set")?;
    match kind.to_ascii_uppercase().as_slice() {
        b"UNSTRUCTURED_GRID" | b"POLYDATA" => {}
        b"STRUCTURED_GRID" | b"STRUCTURED_POINTS" | b"RECTILINEAR_GRID" | b"FIELD" => {
            let expected = "`UNSTRUCTURED_GRID` or `POLYDATA` (in pyvista: extract_surface())";
            return Err(tokens.unexpected(expected, kind));
        }
        _ => return Err(tokens.unexpected("`UNSTRUCTURED_GRID` or `POLYDATA`", kind)),
    }
    let mut sections = Sections {
        tokens,
        cells: Cells::default(),
        lists: Vec::new(),
        types: None,
    };
    while sections.read_next()? {}
    sections.finish()
}

/// Reads the first three lines: the version, a title, and the encoding.
fn read_header(tokens: &mut Tokens) -> Result<(), ParseError> {
    let version = tokens.whole_line();
    let major = version
        .strip_prefix(b"# vtk DataFile Version ")
        .and_then(|version| version.trim_ascii_start().first().copied());
    if !matches!(major, Some(b'1'..=b'5')) {
        return Err(tokens.unexpected("`# vtk DataFile Version` 1 to 5.1", version));
    }
    tokens.whole_line();
    let encoding = tokens.whole_line();
    match encoding.to_ascii_uppercase().as_slice() {
        b"ASCII" => {}
        b"BINARY" => tokens.set_encoding(Encoding::Binary(ByteOrder::BigEndian)),
        _ => return Err(tokens.unexpected("`ASCII` or `BINARY`", encoding)),
    }
    Ok(())
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
    tokens: Tokens<'a>,
    cells: Cells,
    lists: Vec<List>,
    types: Option<Vec<i64>>,
}

impl Sections<'_> {
    /// Reads the next section. Returns false at the end, and where data of points or cells begin.
    fn read_next(&mut self) -> Result<bool, ParseError> {
        let Some(word) = self.tokens.word() else {
            return Ok(false);
        };
        match word.to_ascii_uppercase().as_slice() {
            b"POINTS" => self.read_points()?,
            b"CELLS" => self.read_list(None)?,
            b"VERTICES" => self.read_list(Some(POLY_VERTEX))?,
            b"LINES" => self.read_list(Some(POLY_LINE))?,
            b"TRIANGLE_STRIPS" => self.read_list(Some(TRIANGLE_STRIP))?,
            b"POLYGONS" => self.read_list(Some(POLYGON))?,
            b"CELL_TYPES" => {
                let count = self.tokens.count("the number of cells")?;
                self.types = Some(self.tokens.integers(count, Scalar::I32)?);
            }
            b"FIELD" => self.skip_field()?,
            b"METADATA" => skip_paragraph(&mut self.tokens),
            b"POINT_DATA" | b"CELL_DATA" => {
                self.note_displacements();
                return Ok(false);
            }
            _ => {
                let expected = "a section such as `POINTS`, `CELLS` or `POLYGONS`";
                return Err(self.tokens.unexpected(expected, word));
            }
        }
        Ok(true)
    }

    /// Adds a note about displacements among the data of points, which are not read: `VECTORS NAME TYPE`.
    fn note_displacements(&mut self) {
        const VECTORS: &[u8] = b"VECTORS ";
        let rest = self.tokens.rest();
        self.tokens.budget().step(rest.len() as u64);
        let mut windows = rest.windows(VECTORS.len() + 4);
        let found =
            windows.any(|window| window.starts_with(VECTORS) && is_displacement(&window[VECTORS.len()..]));
        if found {
            let place = self.tokens.place();
            self.cells
                .note(Fact::not_read("displacements among the data", WARP).at(place));
        }
    }

    fn read_points(&mut self) -> Result<(), ParseError> {
        let place = self.tokens.place();
        let count = self.tokens.count("the number of points")?;
        let scalar = scalar(&mut self.tokens)?;
        let coordinates = self.tokens.reals(count.saturating_mul(3), scalar)?;
        if !self.cells.positions.is_empty() {
            return Err(Fault::expected("one section `POINTS`", "another one").at(place));
        }
        self.cells.positions = coordinates.as_chunks().0.to_vec();
        Ok(())
    }

    fn read_list(&mut self, kind: Option<i64>) -> Result<(), ParseError> {
        let place = self.tokens.place();
        let count = self.tokens.count("the number of cells")?;
        let size = self.tokens.count("the number of integers")?;
        let (corners, ends) = if self.tokens.next_is("OFFSETS") {
            let mut ends = integers(&mut self.tokens, count)?;
            // The first offset is that of cell 0.
            if !ends.is_empty() && ends.remove(0) != 0 {
                return Err(Fault::expected("offset 0", "another one").at(place));
            }
            self.tokens.keyword("CONNECTIVITY")?;
            (integers(&mut self.tokens, size)?, ends)
        } else {
            split(&self.tokens.integers(size, Scalar::I32)?, count).map_err(|fault| fault.at(place))?
        };
        self.tokens.budget().hold::<List>(1);
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
        self.tokens.expect_word("the name of a field")?;
        for _ in 0..self.tokens.count("the number of arrays")? {
            let name = self.tokens.expect_word("the name of an array")?;
            if name.eq_ignore_ascii_case(b"METADATA") {
                skip_paragraph(&mut self.tokens);
                self.tokens.expect_word("the name of an array")?;
            }
            let components = self.tokens.count("the number of components")?;
            let tuples = self.tokens.count("the number of tuples")?;
            let count = components.saturating_mul(tuples);
            if self.tokens.next_is("string") {
                (0..count).try_for_each(|_| skip_string(&mut self.tokens))?;
            } else {
                let scalar = scalar(&mut self.tokens)?;
                self.tokens.skip(count, scalar)?;
            }
        }
        Ok(())
    }

    fn finish(mut self) -> Result<Cells, ParseError> {
        for list in &self.lists {
            let types = match (list.kind, &self.types) {
                (Some(kind), _) => &vec![kind; list.ends.len()],
                (None, Some(types)) => types,
                (None, None) => return Err(self.tokens.ends("`CELL_TYPES`")),
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

/// The type of the numbers that follow.
fn scalar(tokens: &mut Tokens) -> Result<Scalar, ParseError> {
    const TYPE: &str = "a type of numbers such as `float` or `vtktypeint64`";
    let name = tokens.expect_word(TYPE)?;
    Scalar::named(&name.to_ascii_lowercase()).ok_or_else(|| tokens.unexpected(TYPE, name))
}

/// So many integers, after their type.
fn integers(tokens: &mut Tokens, count: u64) -> Result<Vec<i64>, ParseError> {
    const TYPE: &str = "a type of integers such as `vtktypeint64`";
    let name = tokens.expect_word(TYPE)?;
    let scalar = Scalar::named(&name.to_ascii_lowercase()).filter(|scalar| scalar.is_integer());
    let scalar = scalar.ok_or_else(|| tokens.unexpected(TYPE, name))?;
    tokens.integers(count, scalar)
}

/// Skips a text: a line of a text file. In a binary file, its length comes first, in 1, 2, 4 or 8 bytes, of
/// which the first two bits are 3, 2, 1 or 0.
fn skip_string(tokens: &mut Tokens) -> Result<(), ParseError> {
    if !tokens.is_binary() {
        if tokens.is_at_end() {
            return Err(tokens.ends("a text"));
        }
        tokens.whole_line();
        return Ok(());
    }
    let expected = || "a text and its length".to_owned();
    let [first] = tokens.array(expected)?;
    let more = [7, 3, 1, 0][usize::from(first >> 6)];
    let rest = tokens.bytes(more, expected)?;
    let length = rest.iter().fold(u64::from(first & 0x3f), |length, &byte| {
        length << 8 | u64::from(byte)
    });
    tokens.bytes(length, expected).map(drop)
}

/// Skips the lines up to an empty one.
fn skip_paragraph(tokens: &mut Tokens) {
    while !tokens.whole_line().is_empty() {}
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
