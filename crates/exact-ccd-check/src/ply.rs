//! Mesh files: PLY, as text or binary, with the elements `vertex`, `face` and `edge` and nothing else.
//!
//! Coordinates are `float` or `double`; in text, any decimal number, read as the nearest f64. A face with more than
//! three corners becomes a fan of triangles from its lowest vertex. Properties beside these are skipped.

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
struct Property<'a> {
    name: &'a str,
    kind: &'a str,
    count: Option<&'a str>,
}

struct Element<'a> {
    name: &'a str,
    rows: usize,
    properties: Vec<Property<'a>>,
}

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
    for element in &elements {
        let named = |name: &str| {
            element
                .properties
                .iter()
                .position(|property| property.name == name)
        };
        let required =
            |name: &str| named(name).map_or_else(|| unreadable(format!("no property `{name}`")), Ok);
        let columns = match element.name {
            "vertex" => vec![required("x")?, required("y")?, required("z")?],
            "edge" => vec![required("vertex1")?, required("vertex2")?],
            _ => vec![named("vertex_index").map_or_else(|| required("vertex_indices"), Ok)?],
        };
        for _ in 0..element.rows {
            let row = element
                .properties
                .iter()
                .map(|property| values(&mut bytes, encoding, property));
            let row = row.collect::<Result<Vec<_>, _>>()?;
            let values: Vec<Value> = columns
                .iter()
                .flat_map(|&column| row[column].iter().copied())
                .collect();
            match element.name {
                "vertex" => positions.push(point(&values)?),
                "edge" => edges.push(
                    indices(&values)?
                        .try_into()
                        .or_else(|_| unreadable("an edge is a list"))?,
                ),
                _ => faces.extend(triangles(&indices(&values)?)?),
            }
        }
    }
    let is_done = match encoding {
        Encoding::Text => word(&mut bytes).is_err(),
        _ => bytes.0.is_empty(),
    };
    if !is_done {
        return unreadable("there is more in a PLY file than its header says");
    }
    Ok(Frame {
        mesh: Mesh::new(positions.len(), faces, &edges)?,
        positions,
    })
}

fn header<'a>(bytes: &mut Bytes<'a>) -> Result<(Encoding, Vec<Element<'a>>), Failure> {
    if line(bytes)?.trim_end() != "ply" {
        return unreadable("the first line of a mesh file is not `ply`");
    }
    let (mut encoding, mut elements) = (None, Vec::<Element<'a>>::new());
    loop {
        let words: Vec<&str> = line(bytes)?.split_ascii_whitespace().collect();
        match *words {
            ["comment" | "obj_info", ..] => {}
            ["format", "ascii", "1.0"] => encoding = Some(Encoding::Text),
            ["format", "binary_little_endian", "1.0"] => encoding = Some(Encoding::Little),
            ["format", "binary_big_endian", "1.0"] => encoding = Some(Encoding::Big),
            ["element", name @ ("vertex" | "face" | "edge"), rows]
                if elements.iter().all(|element| element.name != name) =>
            {
                let Ok(rows) = rows.parse() else {
                    return unreadable("a number of rows is none");
                };
                elements.push(Element {
                    name,
                    rows,
                    properties: Vec::new(),
                });
            }
            ["property", "list", count, kind, name] => add(
                &mut elements,
                Property {
                    name,
                    kind,
                    count: Some(count),
                },
            )?,
            ["property", kind, name] => add(
                &mut elements,
                Property {
                    name,
                    kind,
                    count: None,
                },
            )?,
            ["end_header"] => match encoding {
                Some(encoding) => return Ok((encoding, elements)),
                None => return unreadable("a PLY file has no format"),
            },
            _ => {
                return unreadable(format!(
                    "a PLY header has a line that is not covered: {}",
                    words.join(" ")
                ));
            }
        }
    }
}

fn add<'a>(elements: &mut [Element<'a>], property: Property<'a>) -> Result<(), Failure> {
    let Some(element) = elements.last_mut() else {
        return unreadable("a property has no element");
    };
    // The vertices of a face are the only list.
    let is_list = matches!(property.name, "vertex_index" | "vertex_indices") && element.name == "face";
    if is_list != property.count.is_some()
        || element.properties.iter().any(|other| other.name == property.name)
    {
        return unreadable(format!("the property `{}` is not covered", property.name));
    }
    element.properties.push(property);
    Ok(())
}

/// The line up to its end, and the bytes after it.
fn line<'a>(bytes: &mut Bytes<'a>) -> Result<&'a str, Failure> {
    let Some(length) = bytes.0.iter().position(|&byte| byte == b'\n') else {
        return unreadable("a PLY header has no end");
    };
    let line = bytes.take(length + 1)?;
    std::str::from_utf8(line).or_else(|_| unreadable("a PLY header is not text"))
}

/// The values of a property in a row: one, or those of a list.
fn values(bytes: &mut Bytes<'_>, encoding: Encoding, property: &Property<'_>) -> Result<Vec<Value>, Failure> {
    let count = match property
        .count
        .map(|kind| value(bytes, encoding, kind))
        .transpose()?
    {
        None => 1,
        Some(Value::Integer(count)) if count >= 0 => count,
        _ => return unreadable("the length of a list is not a number"),
    };
    // A list that is longer than the file ends with it.
    (0..count)
        .map(|_| value(bytes, encoding, property.kind))
        .collect()
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
        let word = word(bytes)?;
        let parsed = if is_real {
            word.parse().ok().map(Value::Real)
        } else {
            word.parse().ok().map(Value::Integer)
        };
        return parsed.map_or_else(|| unreadable(format!("`{word}` is not a number")), Ok);
    }
    let mut number = [0; 8];
    number[..size].copy_from_slice(bytes.take(size)?);
    if encoding == Encoding::Big {
        number[..size].reverse();
    }
    let bits = u64::from_le_bytes(number);
    Ok(match (is_real, size) {
        (true, 4) => Value::Real(f64::from(f32::from_bits(bits as u32))),
        (true, _) => Value::Real(f64::from_bits(bits)),
        // The highest bit is a sign, if the type has one.
        (false, _) if kind.starts_with('u') => Value::Integer(bits as i64),
        (false, _) => Value::Integer((bits << (64 - 8 * size)) as i64 >> (64 - 8 * size)),
    })
}

fn word<'a>(bytes: &mut Bytes<'a>) -> Result<&'a str, Failure> {
    let rest = bytes.0.trim_ascii_start();
    let length = rest
        .iter()
        .position(u8::is_ascii_whitespace)
        .unwrap_or(rest.len());
    bytes.0 = &rest[length..];
    match std::str::from_utf8(&rest[..length]) {
        Ok(word) if !word.is_empty() => Ok(word),
        _ => unreadable("a PLY file ends too early, or is not text"),
    }
}

fn point(values: &[Value]) -> Result<[f64; 3], Failure> {
    match *values {
        [Value::Real(x), Value::Real(y), Value::Real(z)] => Ok([x, y, z]),
        _ => unreadable("a coordinate is not of type float or double"),
    }
}

fn indices(values: &[Value]) -> Result<Vec<u32>, Failure> {
    let index = |value: &Value| match value {
        Value::Integer(index) => {
            u32::try_from(*index).or_else(|_| unreadable("the index of a vertex is negative"))
        }
        Value::Real(_) => unreadable("the index of a vertex is not an integer"),
    };
    values.iter().map(index).collect()
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
    Ok((2..corners.len())
        .map(|k| [corner(0), corner(k - 1), corner(k)])
        .collect())
}
