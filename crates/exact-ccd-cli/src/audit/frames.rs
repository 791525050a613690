//! The frames of a sequence: their files in order, and the reading of them.

use std::cmp::Ordering;
use std::fs;
use std::path::{Path, PathBuf};

use exact_ccd_files::{Format, ReadError, ReadMotionError, read_frame, read_pvd};
use exact_ccd_mesh::{Frame, MotionError, TriangleMesh, Welding};

use crate::failure::Failure;

/// Mesh files in the order of time.
pub(super) struct Frames {
    files: Vec<PathBuf>,
    /// STL files have no shared vertices: vertices that coincide in all frames become one.
    welding: Option<(Welding, TriangleMesh)>,
}

impl Frames {
    /// The files, and those in the folders and collections. STL files are read once here, to find
    /// the vertices to weld.
    pub(super) fn find(paths: &[PathBuf]) -> Result<Self, Failure> {
        let mut files = Vec::new();
        for path in paths {
            if path.is_dir() {
                files.extend(meshes_in(path)?);
            } else if is_collection(path) {
                files.extend(read_pvd(path)?.into_iter().map(|(_, file)| file));
            } else {
                files.push(path.clone());
            }
        }
        if files.is_empty() {
            return Err(Failure::NoFrames(paths.first().cloned().unwrap_or_default()));
        }
        let mut frames = Self { files, welding: None };
        let is_stl = |file: &PathBuf| Format::of_path(file) == Some(Format::Stl);
        if frames.files.iter().all(is_stl) {
            frames.welding = Some(frames.weld()?);
        }
        Ok(frames)
    }

    fn weld(&self) -> Result<(Welding, TriangleMesh), Failure> {
        let mut welding = Welding::default();
        let mut first: Option<Frame> = None;
        for (index, file) in self.files.iter().enumerate() {
            let frame = read_frame(file)?;
            if let Some(first) = &first {
                first
                    .mesh
                    .check_same(&frame.mesh)
                    .map_err(|error| self.mismatch(index, error))?;
            }
            welding.restrict(&frame.positions);
            first.get_or_insert(frame);
        }
        let mesh = first.map_or(TriangleMesh::default(), |frame| frame.mesh);
        let welded = welding.mesh(&mesh).map_err(|error| self.mismatch(0, error))?;
        Ok((welding, welded))
    }

    pub(super) fn count(&self) -> usize {
        self.files.len()
    }

    pub(super) fn file(&self, index: usize) -> &Path {
        &self.files[index]
    }

    pub(super) fn read(&self, index: usize) -> Result<Frame, Failure> {
        let frame = read_frame(self.file(index))?;
        Ok(match &self.welding {
            None => frame,
            Some((welding, mesh)) => Frame {
                mesh: mesh.clone(),
                positions: welding.positions(&frame.positions),
            },
        })
    }

    /// The error for a frame that does not belong to the frames before it.
    pub(super) fn mismatch(&self, index: usize, source: MotionError) -> Failure {
        Failure::Motion(ReadMotionError::Motion {
            start: self.file(index.saturating_sub(1)).to_owned(),
            end: self.file(index).to_owned(),
            source,
        })
    }
}

fn is_collection(path: &Path) -> bool {
    path.extension()
        .is_some_and(|extension| extension.eq_ignore_ascii_case("pvd"))
}

/// The meshes in a folder, in the order of the numbers in their names. Other files are skipped.
fn meshes_in(folder: &Path) -> Result<Vec<PathBuf>, Failure> {
    let failed = |source| {
        let path = folder.to_owned();
        Failure::Mesh(ReadError::Io { path, source })
    };
    let mut files = Vec::new();
    for entry in fs::read_dir(folder).map_err(failed)? {
        let path = entry.map_err(failed)?.path();
        if Format::of_path(&path).is_some() {
            files.push(path);
        }
    }
    files.sort_by(|a, b| by_number(&name(a), &name(b)));
    let one_format = files
        .windows(2)
        .all(|pair| Format::of_path(&pair[0]) == Format::of_path(&pair[1]));
    if files.is_empty() || !one_format {
        return Err(Failure::NoFrames(folder.to_owned()));
    }
    Ok(files)
}

fn name(path: &Path) -> String {
    path.file_name()
        .unwrap_or_default()
        .to_string_lossy()
        .into_owned()
}

/// A piece of a name. Numbers are compared by the number of their digits, then by the digits.
#[derive(PartialEq, Eq, PartialOrd, Ord)]
enum Piece<'a> {
    Number(usize, &'a [u8]),
    Text(&'a [u8]),
}

/// The order of names in which `frame2` is before `frame10`.
fn by_number(a: &str, b: &str) -> Ordering {
    pieces_of(a).cmp(pieces_of(b)).then_with(|| a.cmp(b))
}

fn pieces_of(name: &str) -> impl Iterator<Item = Piece<'_>> {
    let runs = name
        .as_bytes()
        .chunk_by(|a, b| a.is_ascii_digit() == b.is_ascii_digit());
    runs.map(|run| {
        if !run[0].is_ascii_digit() {
            return Piece::Text(run);
        }
        let zeros = run.iter().take_while(|&&digit| digit == b'0').count();
        Piece::Number(run.len() - zeros, &run[zeros..])
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_ordered_by_the_numbers_in_them() {
        let order = [
            "2.ply",
            "10.ply",
            "a1b2.ply",
            "a1b10.ply",
            "a02.ply",
            "a2.ply",
            "a10.ply",
            "a.ply",
            "b0.ply",
        ];
        let mut names = order;
        names.reverse();
        names.sort_by(|a, b| by_number(a, b));
        assert_eq!(names, order);
    }
}
