//! Mesh files.

use std::fmt::Display;

use exact_ccd_files::write_ply;
use exact_ccd_mesh::Frame;

use crate::folder::Folder;

/// A square of two faces in the plane z = 0, and a triangle that stands on its tip at (3/4, 1/2, `height`).
///
/// The vertices are numbered in the order in which they appear in the faces, as STL has it.
pub(crate) fn tip_above_square(height: f64) -> Frame {
    let positions = vec![
        [0.0, 0.0, 0.0],
        [1.0, 0.0, 0.0],
        [0.0, 1.0, 0.0],
        [1.0, 1.0, 0.0],
        [0.75, 0.5, height],
        [1.0, 0.5, height + 2.0],
        [0.5, 0.5, height + 2.0],
    ];
    Frame::new(positions, vec![[0, 1, 2], [2, 1, 3], [4, 5, 6]]).unwrap()
}

/// A folder with `start.ply` and `end.ply`, between which the tip moves.
pub(crate) fn fall(from: f64, to: f64) -> Folder {
    let folder = Folder::new();
    folder.write("start.ply", ply(&tip_above_square(from)));
    folder.write("end.ply", ply(&tip_above_square(to)));
    folder
}

pub(crate) fn ply(frame: &Frame) -> Vec<u8> {
    let mut bytes = Vec::new();
    write_ply(&mut bytes, frame).unwrap();
    bytes
}

pub(crate) fn text_ply(frame: &Frame) -> String {
    format!(
        "ply\nformat ascii 1.0\nelement vertex {}\nproperty double x\nproperty double y\nproperty double z\n\
         element face {}\nproperty list uchar int vertex_indices\nend_header\n{}{}",
        frame.positions.len(),
        frame.mesh.faces().len(),
        lines("", &frame.positions),
        lines("3 ", frame.mesh.faces())
    )
}

pub(crate) fn obj(frame: &Frame) -> String {
    let from_one: Vec<_> = frame
        .mesh
        .faces()
        .iter()
        .map(|face| face.map(|corner| corner + 1))
        .collect();
    lines("v ", &frame.positions) + &lines("f ", &from_one)
}

pub(crate) fn off(frame: &Frame) -> String {
    format!(
        "OFF\n{} {} 0\n{}{}",
        frame.positions.len(),
        frame.mesh.faces().len(),
        lines("", &frame.positions),
        lines("3 ", frame.mesh.faces())
    )
}

pub(crate) fn stl(frame: &Frame) -> String {
    let facet = |face: &[u32; 3]| {
        let corners = face.map(|corner| frame.positions[corner as usize]);
        format!(
            "facet normal 0 0 0\nouter loop\n{}endloop\nendfacet\n",
            lines("vertex ", &corners)
        )
    };
    let facets: String = frame.mesh.faces().iter().map(facet).collect();
    format!("solid s\n{facets}endsolid s\n")
}

/// One line a row: its numbers between blanks, after a prefix.
fn lines<T: Display>(prefix: &str, rows: &[[T; 3]]) -> String {
    let line = |[x, y, z]: &[T; 3]| format!("{prefix}{x} {y} {z}\n");
    rows.iter().map(line).collect()
}
