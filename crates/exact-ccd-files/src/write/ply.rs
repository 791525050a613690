//! The Stanford polygon format, binary.

use std::io;

use exact_ccd_mesh::Frame;

use super::check::{check_frame, invalid};
use crate::named_part::NamedPart;

/// Writes a frame as a binary little-endian PLY file, which reads back as the same frame, bit for bit.
///
/// Coordinates take 8 bytes each, or 4 if all of them are exactly an `f32`. Loose edges are the
/// element `edge`.
///
/// # Errors
/// The errors of the writer; and [`InvalidInput`](io::ErrorKind::InvalidInput) if there is no vertex,
/// or, with the [`PositionsError`](exact_ccd_mesh::PositionsError), if the positions do not fit the
/// mesh.
pub fn write_ply(writer: impl io::Write, frame: &Frame) -> io::Result<()> {
    write_ply_with_parts(writer, frame, &[])
}

/// Writes a frame as [`write_ply`], with the names of its parts as comments, which
/// [`MeshFile::groups`](crate::MeshFile) has.
///
/// # Errors
/// The errors of [`write_ply`]; and [`InvalidInput`](io::ErrorKind::InvalidInput) for a name that is empty or
/// has a control character, or parts that do not cover all vertices, in their order.
pub fn write_ply_with_parts(
    mut writer: impl io::Write,
    frame: &Frame,
    parts: &[NamedPart],
) -> io::Result<()> {
    check_frame(frame)?;
    if !parts.is_empty() && !NamedPart::cover(parts, frame.positions.len()) {
        return Err(invalid("the parts do not cover all vertices in their order"));
    }
    if parts.iter().any(|part| part.name.is_empty()) {
        return Err(invalid("the name of a part is empty"));
    }
    if let Some(part) = parts.iter().find(|part| part.name.contains(char::is_control)) {
        return Err(invalid(format!(
            "the name {:?} has a control character",
            part.name
        )));
    }
    let coordinates = frame.positions.as_flattened();
    let single = coordinates
        .iter()
        .all(|&x| f64::from(x as f32).to_bits() == x.to_bits());
    let mut bytes = header(frame, parts, if single { "float" } else { "double" }).into_bytes();
    for &x in coordinates {
        if single {
            bytes.extend((x as f32).to_le_bytes());
        } else {
            bytes.extend(x.to_le_bytes());
        }
    }
    for face in frame.mesh.faces() {
        bytes.push(3);
        bytes.extend(face.iter().flat_map(|corner| corner.to_le_bytes()));
    }
    let ends = frame.mesh.loose_edges().as_flattened();
    bytes.extend(ends.iter().flat_map(|end| end.to_le_bytes()));
    writer.write_all(&bytes)
}

fn header(frame: &Frame, parts: &[NamedPart], coordinate: &str) -> String {
    let comments: String = parts.iter().map(|part| format!("comment {part}\n")).collect();
    let vertex_count = frame.positions.len();
    let face_count = frame.mesh.faces().len();
    // Some readers do not support unsigned indices.
    let index = if vertex_count <= i32::MAX as usize {
        "int"
    } else {
        "uint"
    };
    let edges = match frame.mesh.loose_edges().len() {
        0 => String::new(),
        count => format!("element edge {count}\nproperty {index} vertex1\nproperty {index} vertex2\n"),
    };
    format!(
        "ply\n\
         format binary_little_endian 1.0\n\
         {comments}\
         element vertex {vertex_count}\n\
         property {coordinate} x\n\
         property {coordinate} y\n\
         property {coordinate} z\n\
         element face {face_count}\n\
         property list uchar {index} vertex_indices\n\
         {edges}\
         end_header\n"
    )
}
