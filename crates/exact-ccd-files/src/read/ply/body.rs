//! The body of a PLY file: vertices, faces, strips of triangles and edges. Other elements are skipped.

use exact_ccd_mesh::Point;

use super::super::cells::{Cells, vertex_index};
use super::super::group::Group;
use super::super::polygons::strip;
use super::super::record::Record;
use super::super::scalar::Scalar;
use super::super::tokens::Tokens;
use super::header::{Element, Header, Property, PropertyType};
use crate::error::{Fault, ParseError, Place, quoted};
use crate::named_part::NamedPart;
use crate::note::{Fact, Note};

/// Reads all rows of all elements, in the order of the header.
pub(super) fn read<'a>(header: &'a Header<'a>, mut tokens: Tokens<'a>) -> Result<Cells, ParseError> {
    let vertex_count = find(header, "vertex")?.count;
    let mut cells = Cells::default();
    for element in header
        .elements
        .iter()
        .filter(|element| may_be_unread_mesh(element))
    {
        // A file of rods or of points may have no faces.
        if !header
            .elements
            .iter()
            .any(|element| matches!(element.name, b"face" | b"tristrips"))
        {
            find(header, "face")?;
        }
        if element.count > 0 {
            let part = format!("the element {}", quoted(element.name));
            let remedy = "export the mesh with its vertices and faces";
            cells.notes.push(Fact::not_read(part, remedy).at(element.place));
        }
    }
    for element in &header.elements {
        let mut rows = Rows {
            element,
            vertex_count,
            tokens: &mut tokens,
            longer: None,
        };
        match (element.name, end_points(element)) {
            (b"vertex", _) => cells.positions = rows.read_vertices()?,
            (b"face", _) => {
                rows.read_lists("face", |corners, place| cells.faces.add(corners, || place))?;
            }
            (b"tristrips", _) => rows.read_lists("strip", |corners, place| {
                strip(corners).try_for_each(|triangle| cells.faces.add(&triangle, || place))
            })?,
            (b"edge", Some(ends)) => cells.lines = rows.read_edges(ends)?,
            _ => rows.skip()?,
        }
        cells.notes.extend(rows.longer);
    }
    tokens.expect_end()?;
    if NamedPart::cover(&header.parts, cells.positions.len()) {
        let group = |part: &NamedPart| Group::named(part.name.clone(), part.vertices.clone().collect());
        let parts = header.parts.iter().filter(|part| !part.vertices.is_empty());
        cells.groups = parts.map(group).collect();
    }
    Ok(cells)
}

/// The number before the items of a list.
const COUNT: &str = "the length of a list";

fn find<'a>(header: &'a Header<'a>, name: &str) -> Result<&'a Element<'a>, ParseError> {
    let mut elements = header.elements.iter();
    let missing = || {
        let expected = format!("an element `{name}` in the header");
        Fault::expected(expected, "none; export the mesh with its vertices and faces").at(header.end)
    };
    elements
        .find(|element| element.name == name.as_bytes())
        .ok_or_else(missing)
}

/// Returns true for an element that is not read and may have vertices: one with lists of integers, or edges.
fn may_be_unread_mesh(element: &Element) -> bool {
    let is_list =
        |property: &Property| matches!(property.kind, PropertyType::List { item, .. } if item.is_integer());
    match element.name {
        b"vertex" | b"face" | b"tristrips" => false,
        b"edge" => end_points(element).is_none(),
        _ => element.properties.iter().any(is_list),
    }
}

/// The types of the properties `vertex1` and `vertex2` of an edge. Without both, as integers, an
/// edge names no vertices.
fn end_points(element: &Element) -> Option<[Scalar; 2]> {
    let integer = |name: &[u8]| {
        let mut properties = element.properties.iter();
        match properties.find(|property| property.name == name)?.kind {
            PropertyType::One(integer) if integer.is_integer() => Some(integer),
            _ => None,
        }
    };
    Some([integer(b"vertex1")?, integer(b"vertex2")?])
}

/// The rows of an element.
struct Rows<'t, 'a> {
    element: &'a Element<'a>,
    vertex_count: u64,
    tokens: &'t mut Tokens<'a>,
    /// The first row with more values than the header declares, which only text can have.
    longer: Option<Note>,
}

impl<'a> Rows<'_, 'a> {
    fn begin(&mut self, number: u64) -> Result<(), ParseError> {
        let row = Record::of("row", number, self.element.count);
        self.tokens.begin(row.of_element(self.element.name))
    }

    /// Ends a row. More values than declared are left out, as by other programs.
    fn end(&mut self) {
        if self.longer.is_none() && self.tokens.end().is_err() {
            let part = format!(
                "values beyond those that the header declares, in rows of {}",
                quoted(self.element.name)
            );
            let remedy = "declare them as properties";
            self.longer = Some(Fact::not_read(part, remedy).at(self.tokens.place()));
        }
    }

    fn read_vertices(&mut self) -> Result<Vec<Point>, ParseError> {
        let element = self.element;
        let axes = [b"x", b"y", b"z"];
        for axis in axes {
            let is_coordinate =
                |property: &Property| property.name == axis && matches!(property.kind, PropertyType::One(_));
            if !element.properties.iter().any(is_coordinate) {
                let expected = format!("a property {} of element `vertex`, a number", quoted(axis));
                return Err(Fault::expected(expected, "none").at(element.place));
            }
        }
        let mut positions = Vec::new();
        for number in 0..element.count {
            self.begin(number)?;
            let mut position = [0.0; 3];
            for property in &element.properties {
                match (axes.iter().position(|axis| property.name == *axis), property.kind) {
                    (Some(axis), PropertyType::One(scalar)) => {
                        position[axis] = self.tokens.real(scalar, "a number")?;
                    }
                    _ => skip(property, self.tokens)?,
                }
            }
            self.end();
            positions.push(position);
        }
        Ok(positions)
    }

    /// Passes the corners in each row and their place to a function. Strips, in contrast to faces, may have
    /// −1 between the corners, where another strip begins.
    fn read_lists(
        &mut self,
        kind: &'static str,
        mut add: impl FnMut(&[u32], Place) -> Result<(), ParseError>,
    ) -> Result<(), ParseError> {
        let element = self.element;
        let corner_list = |property: &Property| match property.kind {
            PropertyType::List { count, item }
                if item.is_integer() && matches!(property.name, b"vertex_indices" | b"vertex_index") =>
            {
                Some((count, item))
            }
            _ => None,
        };
        let mut properties = element.properties.iter();
        let Some(corners_at) = properties.position(|property| corner_list(property).is_some()) else {
            let name = quoted(element.name);
            let expected = format!("a property `vertex_indices` of element {name}, a list of integers");
            return Err(Fault::expected(expected, "none").at(element.place));
        };
        let mut corners = Vec::new();
        for number in 0..element.count {
            let face = number as usize;
            self.begin(number)?;
            for (at, property) in element.properties.iter().enumerate() {
                match corner_list(property) {
                    Some((count, item)) if at == corners_at => {
                        corners.clear();
                        let count = self.tokens.integer(count, COUNT)?;
                        let place = self.tokens.place();
                        if count < 0 {
                            return Err(Fault::Corners { face, corners: count }.at(place));
                        }
                        for _ in 0..count {
                            let index = self.tokens.integer(item, "an integer")?;
                            if index == -1 && kind == "strip" {
                                add(&corners, place)?;
                                corners.clear();
                                continue;
                            }
                            corners.push(self.vertex((kind, face), index)?);
                        }
                        add(&corners, place)?;
                    }
                    _ => skip(property, self.tokens)?,
                }
            }
            self.end();
        }
        Ok(())
    }

    fn read_edges(&mut self, [first, second]: [Scalar; 2]) -> Result<Vec<[u32; 2]>, ParseError> {
        let element = self.element;
        let mut edges = Vec::new();
        for number in 0..element.count {
            self.begin(number)?;
            let mut edge = [0; 2];
            for property in &element.properties {
                let (end, integer) = match property.name {
                    b"vertex1" => (0, first),
                    b"vertex2" => (1, second),
                    _ => {
                        skip(property, self.tokens)?;
                        continue;
                    }
                };
                let index = self.tokens.integer(integer, "an integer")?;
                edge[end] = self.vertex(("edge", edges.len()), index)?;
            }
            self.end();
            edges.push(edge);
        }
        Ok(edges)
    }

    fn vertex(&self, of: (&'static str, usize), index: i64) -> Result<u32, ParseError> {
        vertex_index(of, index, self.vertex_count, self.tokens.place())
    }

    fn skip(&mut self) -> Result<(), ParseError> {
        let element = self.element;
        // Such rows take no bytes, so their number is not bounded by the size of the file.
        if element.properties.is_empty() {
            return Ok(());
        }
        for number in 0..element.count {
            self.begin(number)?;
            for property in &element.properties {
                skip(property, self.tokens)?;
            }
            self.end();
        }
        Ok(())
    }
}

fn skip(property: &Property, tokens: &mut Tokens) -> Result<(), ParseError> {
    match property.kind {
        PropertyType::One(scalar) => tokens.skip(1, scalar),
        PropertyType::List { count, item } => {
            let count = tokens.integer(count, COUNT)?;
            let negative = |_| Fault::expected(COUNT, format!("`{count}`")).at(tokens.place());
            let count = u64::try_from(count).map_err(negative)?;
            tokens.skip(count, item)
        }
    }
}
