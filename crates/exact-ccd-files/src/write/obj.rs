//! Wavefront OBJ.

use std::fmt::Write;
use std::io;

use exact_ccd_mesh::{Frame, Point};

use super::check::check_frame;

/// Writes a frame as an OBJ file, which reads back as the same frame, bit for bit.
///
/// Each coordinate is the shortest decimal that reads back as the same `f64`. Loose edges are
/// statements `l`.
///
/// # Errors
/// The errors of the writer; and [`InvalidInput`](io::ErrorKind::InvalidInput) if there is no vertex,
/// or, with the [`PositionsError`](exact_ccd_mesh::PositionsError), if the positions do not fit the
/// mesh.
pub fn write_obj(mut writer: impl io::Write, frame: &Frame) -> io::Result<()> {
    check_frame(frame)?;
    let mut text = String::new();
    for [x, y, z] in &frame.positions {
        push(&mut text, format_args!("v {x:?} {y:?} {z:?}\n"));
    }
    // Indices are from 1, and 2³² does not fit into 32 bits.
    let number = |vertex: u32| u64::from(vertex) + 1;
    for face in frame.mesh.faces() {
        let [a, b, c] = face.map(number);
        push(&mut text, format_args!("f {a} {b} {c}\n"));
    }
    for edge in frame.mesh.loose_edges() {
        let [a, b] = edge.map(number);
        push(&mut text, format_args!("l {a} {b}\n"));
    }
    writer.write_all(text.as_bytes())
}

/// The text of an OBJ file with other coordinates of its vertices, and otherwise the same.
///
/// Returns `None` if the file has another number of vertices, or one with two coordinates or in several
/// lines. Weights, colors and comments behind the coordinates stay. Each coordinate is the shortest decimal
/// that reads back as the same `f64`.
///
/// ```
/// use exact_ccd_files::with_obj_positions;
///
/// let text = "# A point.\nv 0 0 0 1 0.5 0 # red\np 1\n";
/// let moved = with_obj_positions(text, &[[0.1, 0.0, 2.0]]);
/// assert_eq!(moved.as_deref(), Some("# A point.\nv 0.1 0.0 2.0 1 0.5 0 # red\np 1\n"));
/// assert_eq!(with_obj_positions(text, &[]), None);
/// assert_eq!(with_obj_positions("v 0 0 0\\\nf 1 1 1\n", &[[0.0; 3]]), None);
/// ```
#[must_use]
pub fn with_obj_positions(text: &str, positions: &[Point]) -> Option<String> {
    let mut places = positions.iter();
    let mut changed = String::with_capacity(text.len());
    for line in text.split_inclusive('\n') {
        let mut words = line.split_whitespace();
        if words.next() != Some("v") {
            changed.push_str(line);
            continue;
        }
        if line.trim_end().ends_with('\\') {
            return None;
        }
        // The text behind the third coordinate.
        let z = words.nth(2)?.split('#').next().filter(|z| !z.is_empty())?;
        let end = z.as_ptr().addr() - line.as_ptr().addr() + z.len();
        let [x, y, z] = places.next()?;
        push(&mut changed, format_args!("v {x:?} {y:?} {z:?}{}", &line[end..]));
    }
    places.next().is_none().then_some(changed)
}

fn push(text: &mut String, line: std::fmt::Arguments<'_>) {
    text.write_fmt(line).expect("a `String` accepts any text");
}
