//! Sequences of frames: a list of files, or one file of several frames.

use std::path::{Path, PathBuf};

use super::file::parse_file;
use super::mesh_file::{MeshFile, assemble_cells};
use super::numpy::Arrays;
use super::options::{Polygons, ReadOptions};
use super::series::{read_pvd_within, read_series_within};
use super::{content, numpy};
use crate::error::{Fault, ParseError, Place, ReadError};
use crate::format::{Format, extension};

/// The frames in one file: of a ParaView collection (`.pvd`) or series (`.series`), of numpy arrays
/// (`.npz`, `.npy`), or the single frame of a mesh file.
///
/// Frames are read one at a time, in any order.
///
/// ```no_run
/// use exact_ccd_files::{FrameSequence, Polygons};
///
/// let sequence = FrameSequence::open("cloth.npz", Polygons::Triangulate)?;
/// for index in 0..sequence.len() {
///     let file = sequence.read(index)?;
///     println!("{}: {}", sequence.name(index), file.contents);
/// }
/// # Ok::<(), exact_ccd_files::ReadError>(())
/// ```
#[derive(Debug)]
pub struct FrameSequence {
    path: PathBuf,
    options: ReadOptions,
    source: Source,
}

#[derive(Debug)]
enum Source {
    Files(Vec<(Option<f64>, PathBuf)>),
    Arrays(Box<Recording>),
}

/// Positions of all frames, and the first frame, with the mesh that all share.
#[derive(Debug)]
struct Recording {
    arrays: Arrays,
    first: MeshFile,
}

impl FrameSequence {
    /// Opens a sequence. Arrays are read now, listed files later.
    ///
    /// # Errors
    /// [`ReadError`] names the file, the place in it, and what was expected there.
    pub fn open(path: impl AsRef<Path>, options: impl Into<ReadOptions>) -> Result<Self, ReadError> {
        let (path, options) = (path.as_ref(), options.into());
        let ReadOptions { polygons, max_size } = options;
        let timed = |files: Vec<(f64, PathBuf)>| {
            let files = files.into_iter();
            Source::Files(files.map(|(time, file)| (Some(time), file)).collect())
        };
        let source = match (extension(path).as_deref(), Format::of_path(path)) {
            (Some("pvd"), _) => timed(read_pvd_within(path, max_size)?),
            (Some("series"), _) => timed(read_series_within(path, max_size)?),
            (_, Some(format @ (Format::Npz | Format::Npy))) => {
                parse_file(path, max_size, |bytes, budget| {
                    content::check(bytes, format)?;
                    let arrays = match format {
                        Format::Npz => numpy::read_npz(bytes, budget),
                        _ => numpy::read_npy(bytes, budget),
                    };
                    with_mesh(arrays?, polygons)
                })?
            }
            _ => Source::Files(vec![(None, path.to_owned())]),
        };
        let path = path.to_owned();
        Ok(Self {
            path,
            options,
            source,
        })
    }

    /// The number of frames.
    #[must_use]
    pub fn len(&self) -> usize {
        match &self.source {
            Source::Files(files) => files.len(),
            Source::Arrays(recording) => recording.arrays.frame_count,
        }
    }

    /// Returns true for a list without files.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// The file of a frame, counted from 0: a listed one, or the sequence itself.
    #[must_use]
    pub fn file(&self, frame: usize) -> &Path {
        match &self.source {
            Source::Files(files) => files.get(frame).map_or(&self.path, |(_, file)| file),
            Source::Arrays(_) => &self.path,
        }
    }

    /// The name of a frame, counted from 0, for messages: its file, or the file of the sequence and
    /// the number.
    #[must_use]
    pub fn name(&self, frame: usize) -> String {
        let file = self.file(frame).display();
        match &self.source {
            Source::Files(_) => file.to_string(),
            Source::Arrays(_) => format!("{file}, frame {frame}"),
        }
    }

    /// The time of a frame, counted from 0, if the sequence has times.
    #[must_use]
    pub fn time(&self, frame: usize) -> Option<f64> {
        match &self.source {
            Source::Files(files) => files.get(frame)?.0,
            Source::Arrays(_) => None,
        }
    }

    /// Reads a frame, counted from 0.
    ///
    /// # Errors
    /// [`ReadError`] names the file and what was expected there; also for a frame that the sequence
    /// does not have.
    pub fn read(&self, frame: usize) -> Result<MeshFile, ReadError> {
        let at_path = |source: ParseError| ReadError::Parse {
            path: self.path.clone(),
            source,
        };
        if frame >= self.len() {
            let expected = format!("a frame below {}", self.len());
            return Err(at_path(
                Fault::expected(expected, frame.to_string()).at(Place::File),
            ));
        }
        match &self.source {
            Source::Files(_) => MeshFile::read(self.file(frame), self.options),
            Source::Arrays(recording) => {
                let mut file = recording.first.clone();
                let all = recording.arrays.positions(frame);
                let checked = exact_ccd_mesh::check_positions(all.len(), &all);
                checked.map_err(|error| at_path(Fault::Frame(error.into()).at(Place::Frame(frame))))?;
                let kept = file.ids.vertices.iter();
                file.frame.positions = kept.map(|&vertex| all[vertex as usize]).collect();
                Ok(file)
            }
        }
    }

    /// All frames in order.
    pub fn iter(&self) -> impl Iterator<Item = Result<MeshFile, ReadError>> {
        (0..self.len()).map(|frame| self.read(frame))
    }
}

/// Arrays with the mesh of their first frame, which is that of all.
fn with_mesh(arrays: Arrays, polygons: Polygons) -> Result<Source, ParseError> {
    let first = MeshFile::assembled(assemble_cells(arrays.cells()?, Format::Npz)?, polygons)?;
    Ok(Source::Arrays(Box::new(Recording { arrays, first })))
}
