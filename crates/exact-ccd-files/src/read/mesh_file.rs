//! Mesh files as frames, with the facts about the file that a frame does not have.

use std::path::Path;

use exact_ccd_mesh::Frame;

use super::budget::Budget;
use super::cells::{Assembled, Cells};
use super::file::{format_of, parse_bytes, parse_file};
use super::group::Group;
use super::options::{Polygons, ReadOptions};
use super::{read_cells, recognise};
use crate::contents::Contents;
use crate::error::{Fault, ParseError, Place, ReadError};
use crate::file_ids::FileIds;
use crate::format::Format;
use crate::note::Note;

/// A mesh file that was read: its frame, and its contents in numbers.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct MeshFile {
    /// The mesh and its positions.
    pub frame: Frame,
    /// The numbers of its elements.
    pub contents: Contents,
    /// Groups with names and with vertices of the frame: the objects and groups of an OBJ file, the named
    /// parts of a PLY file, see [`NamedPart`](crate::NamedPart), and the physical groups of a .msh file. In
    /// OBJ, an element belongs to the last statement `o` or `g` before it. Several statements, parts or
    /// physical groups of one name are one group.
    pub groups: Vec<Group>,
    /// The ids of its vertices and faces in the file.
    pub ids: FileIds,
    /// For a file of several arrays of numpy: the names of the arrays that were read, and of the other ones.
    pub arrays: Option<String>,
    /// Facts about the file that could change an answer, such as parts of it that are not read.
    pub notes: Vec<Note>,
}

impl MeshFile {
    /// Reads a mesh file. The extension determines the format, see [`Format::of_path`]; `.gz` after
    /// it stands for compression by gzip.
    ///
    /// Vertices and triangles keep their order in the file, and are counted from 0; polygons are
    /// triangulated in place. Each coordinate is the `f64` nearest to the decimal text, or exactly
    /// the binary number; nodes of [`Format::Gltf`] place meshes in `f64` arithmetic. An STL file
    /// has no shared vertices: it reads as three vertices for each face.
    ///
    /// Files of cells with volume (tetrahedra, hexahedra, wedges, pyramids) read as the surface:
    /// the sides that belong to one cell only. A .msh file reads as the surface and the loose
    /// edges alone. A VTK file reads as the surface, and other faces, lines and points beside it.
    /// Cells count as positive in the order of their corners.
    ///
    /// # Errors
    /// [`ReadError`] names the file, the place in it, and what was expected there. A file without a
    /// face, an edge or a point is an error.
    pub fn read(path: impl AsRef<Path>, options: impl Into<ReadOptions>) -> Result<Self, ReadError> {
        let (path, options) = (path.as_ref(), options.into());
        let format = format_of(path)?;
        parse_file(path, options.max_size, |bytes, budget| {
            Self::assembled(assemble(bytes, format, path.parent(), budget)?, options.polygons)
        })
    }

    /// Parses the contents of a file, with the same result as [`MeshFile::read`].
    ///
    /// # Errors
    /// [`ParseError`] names the place and what was expected there.
    pub fn parse(bytes: &[u8], format: Format, options: impl Into<ReadOptions>) -> Result<Self, ParseError> {
        let options = options.into();
        parse_bytes(bytes, options.max_size, |bytes, budget| {
            Self::assembled(assemble(bytes, format, None, budget)?, options.polygons)
        })
    }

    pub(super) fn assembled(assembled: Assembled, polygons: Polygons) -> Result<Self, ParseError> {
        match assembled.first_polygon {
            Some(error) if polygons == Polygons::Refuse => return Err(error),
            _ => {}
        }
        let contents = Contents {
            polygons: assembled.polygons,
            solids: assembled.solids,
            ..Contents::of(&assembled.frame)
        };
        Ok(Self {
            frame: assembled.frame,
            contents,
            groups: assembled.groups,
            ids: assembled.ids,
            arrays: assembled.arrays,
            notes: assembled.notes,
        })
    }
}

/// The frame in a file, which must not be empty. The files that it refers to are in `folder`.
pub(super) fn assemble(
    bytes: &[u8],
    format: Format,
    folder: Option<&Path>,
    budget: &Budget,
) -> Result<Assembled, ParseError> {
    recognise::check(bytes, format)?;
    let cells = read_cells(bytes, format, folder, budget)?;
    cells.charge(budget);
    assemble_cells(cells, format)
}

/// The frame of the contents of a file, which must not be empty.
pub(super) fn assemble_cells(cells: Cells, format: Format) -> Result<Assembled, ParseError> {
    let read = cells.to_string();
    let assembled = match format {
        Format::Msh => cells.into_surface()?,
        _ => cells.into_scene()?,
    };
    if assembled.frame.positions.is_empty() {
        return Err(Fault::Empty { read }.at(Place::File));
    }
    Ok(assembled)
}
