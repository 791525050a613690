//! Wavefront OBJ.

use std::fmt::Write;
use std::io;

use exact_ccd_mesh::Frame;

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

fn push(text: &mut String, line: std::fmt::Arguments<'_>) {
    text.write_fmt(line).expect("a `String` accepts any text");
}
