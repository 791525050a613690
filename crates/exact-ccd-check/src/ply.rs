//! Mesh files: PLY, as text or binary, with the elements `vertex`, `face` and `edge` and nothing else.
//!
//! Coordinates are of any type but integers of 64 bits; in text, decimal numbers, read as the nearest
//! f64. A face with more than three corners becomes a fan of triangles from its lowest vertex. Properties
//! beside these are skipped.

use crate::bytes::Bytes;
use crate::failure::{Failure, unreadable};
use crate::mesh::Mesh;

/// A mesh at one time.
#[derive(Clone, Debug, PartialEq)]
pub struct Frame {
    /// The connectivity.
    pub mesh: Mesh,
    /// The positions of the vertices.
    pub positions: Vec<[f64; 3]>,
}

/// The encoding of numbers. In a binary file, the function makes the bytes of a number little-endian.
#[derive(Clone, Copy)]
enum Encoding {
    Text,
    Binary(fn(&mut [u8])),
}

/// A property: its name, the type of its values, and for a list the type of the number of values.
type Property<'a> = (&'a str, &'a str, Option<&'a str>);

/// The name of an element, the number of its rows, and its properties.
type Element<'a> = (&'a str, usize, Vec<Property<'a>>);

/// Reads a file.
///
/// # Errors
/// If the file has anything that the documentation of this module does not list.
pub fn read(file: &[u8]) -> Result<Frame, Failure> {
    let mut bytes = Bytes(file);
    let (encoding, elements) = header(&mut bytes)?;
    let (mut positions, mut faces, mut edges) = (Vec::new(), Vec::new(), Vec::new());
    for (element, rows, properties) in elements {
        let names: &[&str] = match element {
            "vertex" => &["x", "y", "z"],
            "edge" => &["vertex1", "vertex2"],
            _ => &["vertex_indices"],
        };
        let column = |name: &&str| properties.iter().position(|property| property.0 == *name);
        let Some(columns) = names.iter().map(column).collect::<Option<Vec<_>>>() else {
            return unreadable(format!("the element `{element}` lacks one of the properties {names:?}"));
        };
        let mut read_row = || {
            let row = properties.iter().map(|property| values(&mut bytes, encoding, property));
            let row = row.collect::<Result<Vec<_>, _>>()?;
            let values: Vec<f64> = columns.iter().flat_map(|&column| row[column].iter().copied()).collect();
            match (element, &values[..]) {
                ("vertex", &[x, y, z]) => positions.push([x, y, z]),
                ("edge", &[a, b]) => edges.push([index(a)?, index(b)?]),
                (_, corners) => faces.extend(triangles(corners)?),
            }
            Ok(())
        };
        for number in 1..=rows {
            read_row()
                .map_err(|failure: Failure| failure.at(format_args!("{element} {number} of {rows}")))?;
        }
    }
    if !bytes.0.trim_ascii_start().is_empty() {
        return unreadable("there is more in a PLY file than its header says");
    }
    Ok(Frame { mesh: Mesh::new(positions.len(), faces, &edges)?, positions })
}

fn header<'a>(bytes: &mut Bytes<'a>) -> Result<(Encoding, Vec<Element<'a>>), Failure> {
    let (mut encoding, mut elements) = (None, Vec::<Element<'a>>::new());
    if bytes.line()? != "ply" {
        return unreadable("the first line of a mesh file is not `ply`");
    }
    loop {
        let line = bytes.line()?;
        let property: Property<'a> = match *line.split_ascii_whitespace().collect::<Vec<_>>() {
            ["comment" | "obj_info", ..] => continue,
            ["format", format, "1.0"] => {
                encoding = match format {
                    "ascii" => Some(Encoding::Text),
                    "binary_little_endian" => Some(Encoding::Binary(|_| {})),
                    "binary_big_endian" => Some(Encoding::Binary(<[u8]>::reverse)),
                    _ => return unreadable(format!("the format `{format}` is not covered")),
                };
                continue;
            }
            ["element", name @ ("vertex" | "face" | "edge"), rows]
                if elements.iter().all(|element| element.0 != name) =>
            {
                let Ok(rows) = rows.parse() else { return unreadable("a number of rows is none") };
                elements.push((name, rows, Vec::new()));
                continue;
            }
            // The vertices of a face are the only list.
            ["property", "list", count, kind, "vertex_index" | "vertex_indices"] => {
                ("vertex_indices", kind, Some(count))
            }
            ["property", kind, name] if name != "vertex_indices" => (name, kind, None),
            ["end_header"] => break,
            _ => return unreadable(format!("a line of a PLY header is not covered: {line}")),
        };
        match elements.last_mut() {
            Some((_, _, properties)) if properties.iter().all(|other| other.0 != property.0) => {
                properties.push(property);
            }
            _ => return unreadable(format!("the property `{}` has no place", property.0)),
        }
    }
    encoding.map_or_else(|| unreadable("a PLY header has no format"), |encoding| Ok((encoding, elements)))
}

/// The values of a property in a row: one, or all values of a list. A list with more values than the rest of
/// the file has is an error.
fn values(
    bytes: &mut Bytes<'_>,
    encoding: Encoding,
    (_, kind, count): &Property<'_>,
) -> Result<Vec<f64>, Failure> {
    let count = count.map_or(Ok(1.0), |kind| value(bytes, encoding, kind))?;
    (0..index(count)?).map(|_| value(bytes, encoding, kind)).collect()
}

/// A number. Integers have at most 32 bits, so that f64 has all values of each type; in text, a number that
/// its type does not have is read nevertheless.
fn value(bytes: &mut Bytes<'_>, encoding: Encoding, kind: &str) -> Result<f64, Failure> {
    let (size, is_real) = match kind {
        "char" | "int8" | "uchar" | "uint8" => (1, false),
        "short" | "int16" | "ushort" | "uint16" => (2, false),
        "int" | "int32" | "uint" | "uint32" => (4, false),
        "float" | "float32" => (4, true),
        "double" | "float64" => (8, true),
        _ => return unreadable(format!("the type `{kind}` is not covered")),
    };
    let Encoding::Binary(order) = encoding else {
        let rest = bytes.0.trim_ascii_start();
        let length = rest.iter().position(u8::is_ascii_whitespace).unwrap_or(rest.len());
        bytes.0 = &rest[length..];
        let word = std::str::from_utf8(&rest[..length]).unwrap_or_default();
        let is_valid = is_real || word.parse::<i64>().is_ok();
        let number = word.parse().ok().filter(|_| is_valid);
        return number.map_or_else(|| unreadable(format!("a number is expected, not `{word}`")), Ok);
    };
    let mut number = [0; 8];
    number[..size].copy_from_slice(bytes.take(size)?);
    order(&mut number[..size]);
    let (bits, unused) = (u64::from_le_bytes(number), 64 - 8 * size);
    Ok(match (is_real, size) {
        (true, 4) => f64::from(f32::from_bits(bits as u32)),
        (true, _) => f64::from_bits(bits),
        (false, _) if kind.starts_with('u') => bits as f64,
        // The highest bit is a sign.
        (false, _) => ((bits << unused) as i64 >> unused) as f64,
    })
}

fn index(value: f64) -> Result<u32, Failure> {
    let index = value as u32;
    if f64::from(index) == value { Ok(index) } else { unreadable(format!("{value} is not an index")) }
}

/// The triangle, or the fan of triangles from the lowest vertex.
fn triangles(corners: &[f64]) -> Result<Vec<[u32; 3]>, Failure> {
    let corners = corners.iter().copied().map(index).collect::<Result<Vec<_>, _>>()?;
    if let [a, b, c] = corners[..] {
        return Ok(vec![[a, b, c]]);
    }
    let lowest = corners.iter().min();
    let mut places = (0..corners.len()).filter(|&place| corners.get(place) == lowest);
    let (Some(start), None, true) = (places.next(), places.next(), corners.len() > 3) else {
        return unreadable("a face has fewer than three corners, or its lowest vertex twice");
    };
    let corner = |k: usize| corners[(start + k) % corners.len()];
    Ok((2..corners.len()).map(|k| [corner(0), corner(k - 1), corner(k)]).collect())
}
