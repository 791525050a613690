//! The body of a PLY file: vertices, faces and edges. Other elements are skipped.

use exact_ccd_mesh::Point;

use super::super::cells::{Cells, vertex_index};
use super::super::group::Group;
use super::super::polygons::Faces;
use super::super::record::Record;
use super::super::scalar::Scalar;
use super::super::tokens::Tokens;
use super::header::{Element, Header, Kind, Property};
use crate::error::{Fault, ParseError, quoted};
use crate::named_part::NamedPart;

/// Reads all rows of all elements, in the order of the header.
pub(super) fn read<'a>(header: &'a Header<'a>, mut tokens: Tokens<'a>) -> Result<Cells, ParseError> {
    let vertex_count = find(header, "vertex")?.count;
    // A file of rods or of points may have no faces. Elements with lists, as strips of triangles, are others.
    let is_read = |element: &Element| match element.name {
        b"vertex" | b"face" => true,
        b"edge" => end_points(element).is_some(),
        _ => !element
            .properties
            .iter()
            .any(|property| matches!(property.kind, Kind::List { .. })),
    };
    if !header.elements.iter().all(is_read) && !header.elements.iter().any(|element| element.name == b"face")
    {
        find(header, "face")?;
    }
    let mut cells = Cells::default();
    for element in &header.elements {
        match (element.name, end_points(element)) {
            (b"vertex", _) => cells.positions = read_vertices(element, &mut tokens)?,
            (b"face", _) => cells.faces = read_faces(element, vertex_count, &mut tokens)?,
            (b"edge", Some(ends)) => cells.lines = read_edges(element, ends, vertex_count, &mut tokens)?,
            _ => skip_rows(element, &mut tokens)?,
        }
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

fn row<'a>(element: &Element<'a>, number: u64) -> Record<'a> {
    Record::of("row", number, element.count).of_element(element.name)
}

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

fn read_vertices<'a>(element: &'a Element<'a>, tokens: &mut Tokens<'a>) -> Result<Vec<Point>, ParseError> {
    let axes = [b"x", b"y", b"z"];
    for axis in axes {
        let is_coordinate =
            |property: &Property| property.name == axis && matches!(property.kind, Kind::One(_));
        if !element.properties.iter().any(is_coordinate) {
            let expected = format!("a property {} of element `vertex`, a number", quoted(axis));
            return Err(Fault::expected(expected, "none").at(element.place));
        }
    }
    let mut positions = Vec::new();
    for number in 0..element.count {
        tokens.begin(row(element, number))?;
        let mut position = [0.0; 3];
        for property in &element.properties {
            match (axes.iter().position(|axis| property.name == *axis), property.kind) {
                (Some(axis), Kind::One(scalar)) => position[axis] = tokens.real(scalar, "a number")?,
                _ => skip(property, tokens)?,
            }
        }
        tokens.end()?;
        positions.push(position);
    }
    Ok(positions)
}

fn read_faces<'a>(
    element: &'a Element<'a>,
    vertex_count: u64,
    tokens: &mut Tokens<'a>,
) -> Result<Faces, ParseError> {
    let corner_list = |property: &Property| match property.kind {
        Kind::List { count, item }
            if item.is_integer() && matches!(property.name, b"vertex_indices" | b"vertex_index") =>
        {
            Some((count, item))
        }
        _ => None,
    };
    let Some(corners_at) = element
        .properties
        .iter()
        .position(|property| corner_list(property).is_some())
    else {
        let expected = "a property `vertex_indices` of element `face`, a list of integers";
        return Err(Fault::expected(expected, "none").at(element.place));
    };
    let mut faces = Faces::default();
    let mut corners = Vec::new();
    for number in 0..element.count {
        tokens.begin(row(element, number))?;
        for (at, property) in element.properties.iter().enumerate() {
            match corner_list(property) {
                Some((count, item)) if at == corners_at => {
                    corners.clear();
                    let count = tokens.integer(count, COUNT)?;
                    let place = tokens.place();
                    if count < 0 {
                        let face = faces.count;
                        return Err(Fault::Corners { face, corners: count }.at(place));
                    }
                    for _ in 0..count {
                        corners.push(read_index(("face", faces.count), vertex_count, item, tokens)?);
                    }
                    faces.add(&corners, || place)?;
                }
                _ => skip(property, tokens)?,
            }
        }
        tokens.end()?;
    }
    Ok(faces)
}

/// The types of the properties `vertex1` and `vertex2` of an edge. Without both, as integers, an
/// edge names no vertices.
fn end_points(element: &Element) -> Option<[Scalar; 2]> {
    let integer = |name: &[u8]| {
        let mut properties = element.properties.iter();
        match properties.find(|property| property.name == name)?.kind {
            Kind::One(integer) if integer.is_integer() => Some(integer),
            _ => None,
        }
    };
    Some([integer(b"vertex1")?, integer(b"vertex2")?])
}

fn read_edges<'a>(
    element: &'a Element<'a>,
    [first, second]: [Scalar; 2],
    vertex_count: u64,
    tokens: &mut Tokens<'a>,
) -> Result<Vec<[u32; 2]>, ParseError> {
    let mut edges = Vec::new();
    for number in 0..element.count {
        tokens.begin(row(element, number))?;
        let vertex =
            |integer, tokens: &mut _| read_index(("edge", edges.len()), vertex_count, integer, tokens);
        let mut edge = [0; 2];
        for property in &element.properties {
            match property.name {
                b"vertex1" => edge[0] = vertex(first, tokens)?,
                b"vertex2" => edge[1] = vertex(second, tokens)?,
                _ => skip(property, tokens)?,
            }
        }
        tokens.end()?;
        edges.push(edge);
    }
    Ok(edges)
}

fn read_index<'a>(
    of: (&'static str, usize),
    vertex_count: u64,
    integer: Scalar,
    tokens: &mut Tokens<'a>,
) -> Result<u32, ParseError> {
    let index = tokens.integer(integer, "an integer")?;
    vertex_index(of, index, vertex_count, tokens.place())
}

fn skip_rows<'a>(element: &Element<'a>, tokens: &mut Tokens<'a>) -> Result<(), ParseError> {
    // Such rows take no bytes, so their number is not bounded by the size of the file.
    if element.properties.is_empty() {
        return Ok(());
    }
    for number in 0..element.count {
        tokens.begin(row(element, number))?;
        element
            .properties
            .iter()
            .try_for_each(|property| skip(property, tokens))?;
        tokens.end()?;
    }
    Ok(())
}

fn skip(property: &Property, tokens: &mut Tokens) -> Result<(), ParseError> {
    match property.kind {
        Kind::One(scalar) => tokens.skip(1, scalar),
        Kind::List { count, item } => {
            let count = tokens.integer(count, COUNT)?;
            let negative = |_| Fault::expected(COUNT, format!("`{count}`")).at(tokens.place());
            let count = u64::try_from(count).map_err(negative)?;
            tokens.skip(count, item)
        }
    }
}
