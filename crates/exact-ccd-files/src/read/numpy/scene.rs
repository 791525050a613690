//! Positions, faces and edges among arrays.

use exact_ccd_mesh::Point;

use super::super::cells::{Cells, vertex_index};
use super::archive::Archive;
use super::array::Array;
use super::header::Header;
use crate::error::{Fault, ParseError, Place};

/// Names of arrays, the first ones before the others.
const POSITIONS: [&str; 8] = [
    "positions",
    "vertices",
    "verts",
    "points",
    "particle_q",
    "x",
    "q",
    "v",
];
const FACES: [&str; 7] = ["faces", "triangles", "tris", "tri_indices", "indices", "f", "t"];
const EDGES: [&str; 4] = ["edges", "lines", "rods", "e"];

/// The positions of all frames, and the elements that all frames share.
pub(in super::super) struct Arrays {
    positions: Array,
    pub(in super::super) frame_count: usize,
    vertex_count: usize,
    faces: Option<Array>,
    edges: Option<Array>,
}

/// The positions in a `.npy` file: (T, N, 3) for T frames, or (N, 3).
pub(in super::super) fn read_npy(bytes: &[u8]) -> Result<Arrays, ParseError> {
    Arrays::new(Array::read(bytes)?, None, None)
}

/// The arrays in a `.npz` file: positions (T, N, 3) or (N, 3), faces (F, 3) or (F, k), and edges
/// (E, 2). Without a known name, the only array that can be positions or faces.
pub(in super::super) fn read_npz(bytes: &[u8]) -> Result<Arrays, ParseError> {
    let mut archive = Archive::open(bytes)?;
    let may_be_positions = |header: &Header| !header.scalar.is_integer() && is_positions(header);
    let positions = find(&archive, &POSITIONS, is_positions).or_else(|| only(&archive, may_be_positions));
    let faces = find(&archive, &FACES, is_faces).or_else(|| only(&archive, may_be_faces));
    let edges = find(&archive, &EDGES, is_edges);
    let positions = positions.ok_or_else(|| {
        let expected = "an array `positions` of shape (T, N, 3) or (N, 3)";
        Fault::expected(expected, archive.describe()).at(Place::File)
    })?;
    let positions = archive.read(positions)?;
    let faces = faces.map(|index| archive.read(index)).transpose()?;
    let edges = edges.map(|index| archive.read(index)).transpose()?;
    Arrays::new(positions, faces, edges)
}

fn is_positions(header: &Header) -> bool {
    matches!(header.shape[..], [_, 3] | [_, _, 3])
}

/// Returns true for one row of corners for each face, and for one list of the corners of triangles.
fn is_faces(header: &Header) -> bool {
    let size = match header.shape[..] {
        [_, size] => size,
        [_] => 3,
        _ => 0,
    };
    header.scalar.is_integer() && size >= 3
}

fn may_be_faces(header: &Header) -> bool {
    header.scalar.is_integer() && matches!(header.shape[..], [_, 3 | 4])
}

fn is_edges(header: &Header) -> bool {
    header.scalar.is_integer() && matches!(header.shape[..], [_, 2])
}

/// The array with the first of these names that fits.
fn find(archive: &Archive, names: &[&str], fits: impl Fn(&Header) -> bool) -> Option<usize> {
    let with_name = |name: &&str| {
        let mut arrays = archive.arrays.iter();
        let found = arrays.find(|(_, array, header)| array.eq_ignore_ascii_case(name) && fits(header));
        found.map(|(index, ..)| *index)
    };
    names.iter().find_map(with_name)
}

/// The array that fits, if there is only one.
fn only(archive: &Archive, fits: impl Fn(&Header) -> bool) -> Option<usize> {
    let mut arrays = archive.arrays.iter().filter(|(.., header)| fits(header));
    match (arrays.next(), arrays.next()) {
        (Some((index, ..)), None) => Some(*index),
        _ => None,
    }
}

impl Arrays {
    fn new(positions: Array, faces: Option<Array>, edges: Option<Array>) -> Result<Self, ParseError> {
        let (frame_count, vertex_count) = match positions.shape[..] {
            [frames, vertices, 3] if frames > 0 && vertices > 0 => (frames, vertices),
            [vertices, 3] if vertices > 0 => (1, vertices),
            _ => {
                let expected = "positions of shape (T, N, 3) or (N, 3), not empty";
                let found = format!("shape {:?}", positions.shape);
                return Err(Fault::expected(expected, found).at(Place::File));
            }
        };
        Ok(Self {
            positions,
            frame_count,
            vertex_count,
            faces,
            edges,
        })
    }

    /// The positions of a frame, from 0.
    pub(in super::super) fn positions(&self, frame: usize) -> Vec<Point> {
        let count = 3 * self.vertex_count;
        let numbers = self.positions.reals(frame.saturating_mul(count), count);
        numbers.as_chunks().0.to_vec()
    }

    /// The contents at a frame, from 0.
    pub(in super::super) fn cells(&self, frame: usize) -> Result<Cells, ParseError> {
        let mut cells = Cells {
            positions: self.positions(frame),
            ..Cells::default()
        };
        let vertex = |of: (&'static str, usize), &index: &i64| {
            vertex_index(of, index, self.vertex_count as u64, Place::File)
        };
        if let Some(faces) = &self.faces {
            let corners = faces.integers().unwrap_or_default();
            // One list of all corners, of triangles, or one row for each face.
            let size = match faces.shape[..] {
                [_, size] => size,
                _ => 3,
            };
            if corners.len() % size != 0 {
                let found = format!("{} corners", corners.len());
                return Err(Fault::expected("three corners for each face", found).at(Place::File));
            }
            let mut face = Vec::new();
            for (number, corners) in corners.chunks(size).enumerate() {
                face.clear();
                for corner in corners {
                    face.push(vertex(("face", number), corner)?);
                }
                cells.faces.add(&face, || Place::File)?;
            }
        }
        if let Some(edges) = &self.edges {
            let ends = edges.integers().unwrap_or_default();
            for (number, [a, b]) in ends.as_chunks().0.iter().enumerate() {
                let of = ("edge", number);
                cells.lines.push([vertex(of, a)?, vertex(of, b)?]);
            }
        }
        Ok(cells)
    }

    /// The contents, if there is one frame only.
    pub(in super::super) fn into_single(self) -> Result<Cells, ParseError> {
        match self.frame_count {
            1 => self.cells(0),
            count => {
                let expected = "one frame (read a file of several as a sequence)";
                Err(Fault::expected(expected, format!("{count} frames")).at(Place::File))
            }
        }
    }
}
