//! The body of a PLY file: vertices, faces, and whatever else the header declares.

use exact_ccd::Point;

use super::super::error::{Fault, ParseError, Place, quoted};
use super::super::{Contents, vertex_index};
use super::header::{Element, Header, Integer, Kind, Property, Scalar};
use super::rows::{Row, Rows};

/// Reads all rows of all elements, in the order of the header.
pub(super) fn read<'a>(header: &'a Header<'a>, mut rows: impl Rows<'a>) -> Result<Contents, ParseError> {
    let vertex_count = find(header, "vertex")?.count;
    find(header, "face")?;
    let mut positions = Vec::new();
    let mut faces = Vec::new();
    for element in &header.elements {
        match element.name {
            b"vertex" => positions = read_vertices(element, &mut rows)?,
            b"face" => faces = read_faces(element, vertex_count, &mut rows)?,
            _ => skip_rows(element, &mut rows)?,
        }
    }
    rows.finish()?;
    Ok((positions, faces))
}

fn find<'a>(header: &'a Header<'a>, name: &str) -> Result<&'a Element<'a>, ParseError> {
    let mut elements = header.elements.iter();
    let missing = || Fault::expected(format!("an element `{name}`"), "none").at(Place::File);
    elements
        .find(|element| element.name == name.as_bytes())
        .ok_or_else(missing)
}

fn read_vertices<'a>(element: &'a Element<'a>, rows: &mut impl Rows<'a>) -> Result<Vec<Point>, ParseError> {
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
        rows.begin(Row { element, number })?;
        let mut position = [0.0; 3];
        for property in &element.properties {
            match (axes.iter().position(|axis| property.name == *axis), property.kind) {
                (Some(axis), Kind::One(scalar)) => position[axis] = rows.number(scalar)?,
                _ => skip(property, rows)?,
            }
        }
        rows.end()?;
        positions.push(position);
    }
    Ok(positions)
}

fn read_faces<'a>(
    element: &'a Element<'a>,
    vertex_count: u64,
    rows: &mut impl Rows<'a>,
) -> Result<Vec<[u32; 3]>, ParseError> {
    let corner_list = |property: &Property| match property.kind {
        Kind::List {
            count,
            item: Scalar::Integer(item),
        } if matches!(property.name, b"vertex_indices" | b"vertex_index") => Some((count, item)),
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
    let mut faces = Vec::new();
    for number in 0..element.count {
        rows.begin(Row { element, number })?;
        let mut face = [0; 3];
        for (at, property) in element.properties.iter().enumerate() {
            match corner_list(property) {
                Some((count, item)) if at == corners_at => {
                    face = read_corners(faces.len(), vertex_count, count, item, rows)?;
                }
                _ => skip(property, rows)?,
            }
        }
        rows.end()?;
        faces.push(face);
    }
    Ok(faces)
}

fn read_corners<'a>(
    face: usize,
    vertex_count: u64,
    count: Integer,
    item: Integer,
    rows: &mut impl Rows<'a>,
) -> Result<[u32; 3], ParseError> {
    let place = rows.place();
    let corners = rows.integer(count)?;
    if corners != 3 {
        return Err(Fault::Corners { face, corners }.at(place));
    }
    let mut corner = || {
        let place = rows.place();
        vertex_index(face, rows.integer(item)?, vertex_count, place)
    };
    Ok([corner()?, corner()?, corner()?])
}

fn skip_rows<'a>(element: &'a Element<'a>, rows: &mut impl Rows<'a>) -> Result<(), ParseError> {
    // Such rows hold nothing, and there may be any number of them.
    if element.properties.is_empty() {
        return Ok(());
    }
    for number in 0..element.count {
        rows.begin(Row { element, number })?;
        element
            .properties
            .iter()
            .try_for_each(|property| skip(property, rows))?;
        rows.end()?;
    }
    Ok(())
}

fn skip<'a>(property: &Property, rows: &mut impl Rows<'a>) -> Result<(), ParseError> {
    match property.kind {
        Kind::One(scalar) => rows.skip(scalar, 1),
        Kind::List { count, item } => {
            let place = rows.place();
            let count = rows.integer(count)?;
            let negative = |_| Fault::expected("the length of a list", format!("`{count}`")).at(place);
            rows.skip(item, u64::try_from(count).map_err(negative)?)
        }
    }
}
