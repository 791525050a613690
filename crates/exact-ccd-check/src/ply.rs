//! Mesh files: PLY, as text or binary, with the elements `vertex`, `face` and `edge` and nothing else.
//!
//! Coordinates are `float` or `double`; in text, any decimal number, read as the nearest f64. A face
//! with more than three corners becomes a fan of triangles from its lowest vertex. Properties beside
//! these are skipped.

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

#[derive(Clone, Copy, PartialEq)]
enum Encoding {
    Text,
    Little,
    Big,
}

/// A property: its name, the type of its values, and that of the number of values if it is a list.
type Property<'a> = (&'a str, &'a str, Option<&'a str>);

/// The name of an element, the number of its rows, and its properties.
type Element<'a> = (&'a str, usize, Vec<Property<'a>>);

/// A value of a property.
#[derive(Clone, Copy)]
enum Value {
    Integer(i64),
    Real(f64),
}

/// Reads a file.
///
/// # Errors
/// For all that is not described above.
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
        for _ in 0..rows {
            let row = properties.iter().map(|property| values(&mut bytes, encoding, property));
            let row = row.collect::<Result<Vec<_>, _>>()?;
            let values: Vec<Value> = columns.iter().flat_map(|&column| row[column].iter().copied()).collect();
            match (element, &values[..]) {
                ("vertex", &[Value::Real(x), Value::Real(y), Value::Real(z)]) => positions.push([x, y, z]),
                ("vertex", _) => return unreadable("a coordinate is not of type float or double"),
                ("edge", [a, b]) => edges.push([index(a)?, index(b)?]),
                _ => faces.extend(triangles(&values.iter().map(index).collect::<Result<Vec<_>, _>>()?)?),
            }
        }
    }
    if !bytes.0.trim_ascii_start().is_empty() {
        return unreadable("there is more in a PLY file than its header says");
    }
    Ok(Frame { mesh: Mesh::new(positions.len(), faces, &edges)?, positions })
}

fn header<'a>(bytes: &mut Bytes<'a>) -> Result<(Encoding, Vec<Element<'a>>), Failure> {
    let (mut encoding, mut elements, mut lines) = (None, Vec::<Element<'a>>::new(), 0);
    loop {
        let Some(length) = bytes.0.iter().position(|&byte| byte == b'\n') else {
            return unreadable("a PLY header has no end");
        };
        let Ok(line) = std::str::from_utf8(bytes.take(length + 1)?) else {
            return unreadable("a PLY header is not text");
        };
        lines += 1;
        let words: Vec<&str> = line.split_ascii_whitespace().collect();
        let property: Property<'a> = match *words {
            ["ply"] if lines == 1 => continue,
            _ if lines == 1 => return unreadable("the first line of a mesh file is not `ply`"),
            ["comment" | "obj_info", ..] => continue,
            ["format", format, "1.0"] => {
                encoding = match format {
                    "ascii" => Some(Encoding::Text),
                    "binary_little_endian" => Some(Encoding::Little),
                    "binary_big_endian" => Some(Encoding::Big),
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
            ["end_header"] if encoding.is_some() => break,
            _ => return unreadable(format!("a line of a PLY header is not covered: {}", line.trim())),
        };
        match elements.last_mut() {
            Some((_, _, properties)) if properties.iter().all(|other| other.0 != property.0) => {
                properties.push(property);
            }
            _ => return unreadable(format!("the property `{}` has no place", property.0)),
        }
    }
    Ok((encoding.unwrap_or(Encoding::Text), elements))
}

/// The values of a property in a row: one, or those of a list. A list that is longer than the file ends
/// with it.
fn values(
    bytes: &mut Bytes<'_>,
    encoding: Encoding,
    (_, kind, count): &Property<'_>,
) -> Result<Vec<Value>, Failure> {
    let count = match count.map(|kind| value(bytes, encoding, kind)).transpose()? {
        None => 1,
        Some(Value::Integer(count)) if count >= 0 => count,
        _ => return unreadable("the length of a list is not a number"),
    };
    (0..count).map(|_| value(bytes, encoding, kind)).collect()
}

fn value(bytes: &mut Bytes<'_>, encoding: Encoding, kind: &str) -> Result<Value, Failure> {
    let (size, is_real) = match kind {
        "char" | "int8" | "uchar" | "uint8" => (1, false),
        "short" | "int16" | "ushort" | "uint16" => (2, false),
        "int" | "int32" | "uint" | "uint32" => (4, false),
        "float" | "float32" => (4, true),
        "double" | "float64" => (8, true),
        _ => return unreadable(format!("the type `{kind}` is not covered")),
    };
    if encoding == Encoding::Text {
        let rest = bytes.0.trim_ascii_start();
        let length = rest.iter().position(u8::is_ascii_whitespace).unwrap_or(rest.len());
        bytes.0 = &rest[length..];
        let word = std::str::from_utf8(&rest[..length]).unwrap_or_default();
        let real = || word.parse().ok().map(Value::Real);
        let parsed = if is_real { real() } else { word.parse().ok().map(Value::Integer) };
        return parsed.map_or_else(|| unreadable(format!("`{word}` is not a number")), Ok);
    }
    let mut number = [0; 8];
    number[..size].copy_from_slice(bytes.take(size)?);
    if encoding == Encoding::Big {
        number[..size].reverse();
    }
    let (bits, unused) = (u64::from_le_bytes(number), 64 - 8 * size);
    Ok(match (is_real, size) {
        (true, 4) => Value::Real(f64::from(f32::from_bits(bits as u32))),
        (true, _) => Value::Real(f64::from_bits(bits)),
        (false, _) if kind.starts_with('u') => Value::Integer(bits as i64),
        // The highest bit is a sign.
        (false, _) => Value::Integer((bits << unused) as i64 >> unused),
    })
}

fn index(value: &Value) -> Result<u32, Failure> {
    match value {
        Value::Integer(index) => {
            u32::try_from(*index).or_else(|_| unreadable("the index of a vertex is negative"))
        }
        Value::Real(_) => unreadable("the index of a vertex is not an integer"),
    }
}

/// The triangle, or the fan of triangles from the lowest vertex.
fn triangles(corners: &[u32]) -> Result<Vec<[u32; 3]>, Failure> {
    if let &[a, b, c] = corners {
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
