//! Mesh files.

use std::ffi::CString;
use std::io::ErrorKind;
use std::path::{Path, PathBuf};

use exact_ccd_files::{Format, FrameOrder, MeshFile, ParseError, Polygons, ReadError};
use exact_ccd_mesh::Frame;
use numpy::{PyArray1, PyReadonlyArray2};
use pyo3::exceptions::{PyFileNotFoundError, PyOSError, PyPermissionError, PyUserWarning};
use pyo3::prelude::*;

use crate::error::refused;
use crate::mesh::{List, Mesh, Table, rows};
use crate::positions::points;

/// Vertices, faces and loose edges.
type Arrays<'py> = (Table<'py, f64>, Table<'py, u32>, Table<'py, u32>);

/// The arrays of a mesh file, with a warning for each note of its reader.
fn arrays<'py>(py: Python<'py>, name: &Path, file: MeshFile) -> PyResult<Arrays<'py>> {
    for note in &file.notes {
        // A text with a zero byte is no text of C.
        let text = CString::new(format!("{}: {note}", name.display()).replace('\0', "\u{fffd}"))?;
        PyErr::warn(py, &py.get_type::<PyUserWarning>(), &text, 2)?;
    }
    let Frame { mesh, positions } = file.frame;
    Ok((
        rows(py, positions)?,
        rows(py, mesh.faces().iter().copied())?,
        rows(py, mesh.loose_edges().iter().copied())?,
    ))
}

fn unread(error: &ReadError) -> PyErr {
    match error {
        ReadError::Io { source, .. } => match source.kind() {
            ErrorKind::NotFound => PyFileNotFoundError::new_err(error.to_string()),
            ErrorKind::PermissionDenied => PyPermissionError::new_err(error.to_string()),
            _ => PyOSError::new_err(error.to_string()),
        },
        // A file that is missing has no format either.
        ReadError::Extension { path } if !path.exists() => {
            PyFileNotFoundError::new_err(format!("{}: there is no such file", path.display()))
        }
        _ => refused(error),
    }
}

/// The mesh in a file.
#[pyfunction]
pub(crate) fn read_mesh(py: Python<'_>, path: PathBuf) -> PyResult<Arrays<'_>> {
    let file = py.detach(|| MeshFile::read(&path, Polygons::Triangulate));
    arrays(py, &path, file.map_err(|error| unread(&error))?)
}

/// The mesh in the contents of a file, whose name has the format.
#[pyfunction]
pub(crate) fn parse_mesh<'py>(py: Python<'py>, contents: &[u8], name: PathBuf) -> PyResult<Arrays<'py>> {
    let at = |error: ParseError| refused(format_args!("{}: {error}", name.display()));
    let unknown = || refused(format_args!("{}: no known format of meshes", name.display()));
    let format = Format::of_path(&name).ok_or_else(unknown)?;
    let file = py.detach(|| MeshFile::parse(contents, format, Polygons::Triangulate));
    arrays(py, &name, file.map_err(at)?)
}

/// The format of mesh files that the extension of a path names, if it names one.
#[pyfunction]
pub(crate) fn mesh_format(path: PathBuf) -> Option<String> {
    Format::of_path(&path).map(|format| format!("{format:?}"))
}

/// Paths in the order of the numbers in them.
#[pyfunction]
pub(crate) fn in_order(paths: Vec<PathBuf>) -> Vec<PathBuf> {
    FrameOrder::of(paths).files
}

/// The frames in one file.
#[pyclass(frozen, module = "exact_ccd._native")]
pub(crate) struct FrameSequence(exact_ccd_files::FrameSequence);

#[pymethods]
impl FrameSequence {
    /// The frames in a file; with a cache of positions, the frames in it of the mesh in the file.
    #[new]
    #[pyo3(signature = (path, cache=None))]
    fn new(py: Python<'_>, path: PathBuf, cache: Option<PathBuf>) -> PyResult<Self> {
        let sequence = py.detach(|| match cache {
            Some(cache) => exact_ccd_files::FrameSequence::open_cache(path, cache, Polygons::Triangulate),
            None => exact_ccd_files::FrameSequence::open(path, Polygons::Triangulate),
        });
        Ok(Self(sequence.map_err(|error| unread(&error))?))
    }

    /// Returns true for the name of a cache of positions.
    #[staticmethod]
    fn is_cache(path: PathBuf) -> bool {
        exact_ccd_files::FrameSequence::is_cache(&path)
    }

    fn __len__(&self) -> usize {
        self.0.len()
    }

    /// The file of a frame.
    fn file(&self, frame: usize) -> &Path {
        self.0.file(frame)
    }

    /// The mesh of a frame.
    fn read<'py>(&self, py: Python<'py>, frame: usize) -> PyResult<Arrays<'py>> {
        let file = py.detach(|| self.0.read(frame));
        arrays(py, self.0.file(frame), file.map_err(|error| unread(&error))?)
    }
}

/// One vertex in place of all that coincide in every frame.
#[pyclass(module = "exact_ccd._native")]
#[derive(Default)]
pub(crate) struct Welding(exact_ccd_mesh::Welding);

#[pymethods]
impl Welding {
    #[new]
    fn new() -> Self {
        Self::default()
    }

    /// Separates the vertices that do not coincide in a frame.
    fn restrict(&mut self, py: Python<'_>, positions: PyReadonlyArray2<'_, f64>) -> PyResult<()> {
        let positions = points(&positions)?;
        py.detach(|| self.0.restrict(positions));
        Ok(())
    }

    /// Keeps apart the vertices that are not ends of coinciding edges of a mesh.
    fn along_edges(&mut self, py: Python<'_>, mesh: &Mesh) {
        let welding = std::mem::take(&mut self.0);
        self.0 = py.detach(|| welding.along_edges(mesh.mesh()));
    }

    /// The first of the vertices that each new vertex replaces.
    fn first_vertices<'py>(&self, py: Python<'py>) -> List<'py, i64> {
        PyArray1::from_iter(py, self.0.first_vertices().iter().map(|&vertex| vertex as i64))
    }

    /// The faces and loose edges of a mesh with the new vertices.
    fn primitives<'py>(&self, py: Python<'py>, mesh: &Mesh) -> PyResult<(Table<'py, u32>, Table<'py, u32>)> {
        let welded = py.detach(|| self.0.mesh(mesh.mesh())).map_err(refused)?;
        Ok((
            rows(py, welded.faces().iter().copied())?,
            rows(py, welded.loose_edges().iter().copied())?,
        ))
    }
}
