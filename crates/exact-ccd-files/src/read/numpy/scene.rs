//! Positions, faces and edges among arrays.

use exact_ccd_mesh::Point;

use super::super::budget::Budget;
use super::super::cells::{Cells, vertex_index};
use super::super::solids::Solid;
use super::archive::Archive;
use super::array::Array;
use super::elements::Elements;
use super::roles::{Form, Names, Roles};
use crate::error::{Fault, ParseError, Place};
use crate::note::Fact;

/// The positions of all frames, and the elements that all frames share.
#[derive(Debug)]
pub(in super::super) struct Arrays {
    positions: Array,
    pub(in super::super) frame_count: usize,
    vertex_count: usize,
    faces: Option<Elements>,
    edges: Option<Elements>,
    tetrahedra: Option<Elements>,
    /// The names of the arrays that were read, and of those that were not.
    description: Option<String>,
}

/// The positions in a `.npy` file: (T, N, 3) for T frames, or (N, 3).
pub(in super::super) fn read_npy(bytes: &[u8], budget: &Budget) -> Result<Arrays, ParseError> {
    let array = Array::read(bytes, budget)?;
    if array.is_table_of_integers() {
        let expected = "positions of shape (T, N, 3) or (N, 3), as floats (name an array of faces with --faces \
                        FILE.npy beside that of positions, or write both with numpy.savez)";
        let found = format!("integers of shape {:?}", array.shape);
        return Err(Fault::expected(expected, found).at(Place::File));
    }
    Arrays::new(array)
}

/// The arrays in a `.npz` file by their names: positions (T, N, 3) or (N, 3), faces (F, 3) or (F, k), edges
/// (E, 2) and tetrahedra (K, 4).
pub(in super::super) fn read_npz(bytes: &[u8], names: &Names, budget: &Budget) -> Result<Arrays, ParseError> {
    let mut archive = Archive::open(bytes, budget)?;
    let roles = Roles::of(&archive, names)?;
    let mut elements = |role: Option<(usize, Form)>| {
        let read = |(number, form): (usize, Form)| {
            let array = archive.read(number)?;
            budget.hold::<i64>(array.count());
            Elements::read(&array, &archive.arrays[number].name, form)
        };
        role.map(read).transpose()
    };
    let (faces, edges) = (elements(roles.faces)?, elements(roles.edges)?);
    let tetrahedra = elements(roles.tetrahedra)?;
    let description = Some(roles.describe(&archive));
    Ok(Arrays {
        faces,
        edges,
        tetrahedra,
        description,
        ..Arrays::new(archive.read(roles.positions)?)?
    })
}

/// The faces in a `.npy` file.
pub(in super::super) fn read_faces(bytes: &[u8], budget: &Budget) -> Result<Elements, ParseError> {
    let array = Array::read(bytes, budget)?;
    let form = match array.shape[..] {
        [_, size] if size >= 3 && array.is_integer() => Form::Rows(size),
        [_] if array.is_integer() => Form::Counts,
        _ => {
            let expected = "faces: integers of shape (F, k) with three or more corners";
            let found = format!("shape {:?}", array.shape);
            return Err(Fault::expected(expected, found).at(Place::File));
        }
    };
    budget.hold::<i64>(array.count());
    Elements::read(&array, "the array of faces", form)
}

impl Arrays {
    fn new(positions: Array) -> Result<Self, ParseError> {
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
            faces: None,
            edges: None,
            tetrahedra: None,
            description: None,
        })
    }

    /// The arrays with the faces of another file.
    ///
    /// # Errors
    /// If there are faces in the file itself.
    pub(in super::super) fn with_faces(self, faces: Elements) -> Result<Self, ParseError> {
        if self.faces.is_some() {
            let expected = "no faces beside those of --faces";
            return Err(Fault::expected(expected, "an array of faces").at(Place::File));
        }
        Ok(Self {
            faces: Some(faces),
            ..self
        })
    }

    /// The positions of a frame, from 0.
    pub(in super::super) fn positions(&self, frame: usize) -> Vec<Point> {
        let count = 3 * self.vertex_count;
        let numbers = self.positions.reals(frame.saturating_mul(count), count);
        numbers.as_chunks().0.to_vec()
    }

    /// The contents at the first frame.
    pub(in super::super) fn cells(&self) -> Result<Cells, ParseError> {
        let mut cells = Cells {
            positions: self.positions(0),
            arrays: self.description.clone(),
            ..Cells::default()
        };
        let numbered = |element: &'static str, number: usize, indices: &[i64]| {
            let count = self.vertex_count as u64;
            let vertex = |&index: &i64| vertex_index((element, number), index, count, Place::File);
            indices.iter().map(vertex).collect::<Result<Vec<u32>, _>>()
        };
        for (number, face) in self.faces.iter().flat_map(Elements::iter).enumerate() {
            cells
                .faces
                .add(&numbered("face", number, face)?, || Place::File)?;
        }
        for (number, edge) in self.edges.iter().flat_map(Elements::iter).enumerate() {
            cells.add_polyline(&numbered("edge", number, edge)?);
        }
        for (number, corners) in self.tetrahedra.iter().flat_map(Elements::iter).enumerate() {
            let corners = numbered("tetrahedron", number, corners)?;
            cells
                .solids
                .extend(corners.as_chunks().0.iter().map(|&c| Solid::Tetrahedron(c)));
        }
        if self.description.is_none() && self.faces.is_none() {
            let remedy = "--faces FILE.npy has them, or numpy.savez(\"motion.npz\", positions=x, faces=f)";
            cells.note(
                Fact::not_read("faces, which an array of positions does not have", remedy).at(Place::File),
            );
        }
        // Vertices of no element are points beside tetrahedra, too.
        if self.tetrahedra.is_some() {
            cells.points = (0..self.vertex_count).map(|vertex| vertex as u32).collect();
        }
        Ok(cells)
    }

    /// The contents, if there is one frame only.
    pub(in super::super) fn into_single(self) -> Result<Cells, ParseError> {
        match self.frame_count {
            1 => self.cells(),
            count => {
                let expected = "one frame (read a file of several as a sequence)";
                Err(Fault::expected(expected, format!("{count} frames")).at(Place::File))
            }
        }
    }
}
