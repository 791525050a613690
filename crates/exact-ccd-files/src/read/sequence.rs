//! Sequences of frames: a list of files, or one file of several frames.

use std::path::{Path, PathBuf};

use super::cells::Cells;
use super::file::parse_file;
use super::mesh_file::{MeshFile, assemble_cells};
use super::numpy::Names;
use super::options::{Polygons, ReadOptions};
use super::point_cache::PointCache;
use super::recording::{Positions, Recording, in_file};
use super::series::{read_pvd_parts, read_pvd_within, read_series_within};
use super::{gltf, numpy, recognise};
use crate::error::{Fault, ParseError, Place, ReadError};
use crate::format::{Format, extension};

/// The frames in one file: of a ParaView collection (`.pvd`) or series (`.series`), of numpy arrays
/// (`.npz`, `.npy`), of a glTF file with an animation of translations, or the single frame of a mesh file;
/// also the frames in a cache of positions (`.pc2`, `.mdd`), beside its mesh.
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
    part: Option<String>,
    options: ReadOptions,
    source: Source,
}

#[derive(Debug)]
enum Source {
    Files(Vec<(Option<f64>, PathBuf)>),
    Recording(Box<Recording>),
}

impl FrameSequence {
    /// Opens the sequences of all parts of a file: of a collection of ParaView, one for each part that it
    /// lists; of any other file, one.
    ///
    /// # Errors
    /// As [`FrameSequence::open`]; also if the parts of a collection have different times.
    pub fn open_parts(
        path: impl AsRef<Path>,
        options: impl Into<ReadOptions>,
    ) -> Result<Vec<Self>, ReadError> {
        let (path, options) = (path.as_ref(), options.into());
        if extension(path).as_deref() != Some("pvd") {
            return Ok(vec![Self::open(path, options)?]);
        }
        let parts = read_pvd_parts(path, options.max_size)?;
        let is_one = parts.len() == 1;
        let sequence = |(part, files)| Self {
            path: path.to_owned(),
            part: (!is_one).then_some(part),
            options: options.clone(),
            source: timed(files),
        };
        Ok(parts.into_iter().map(sequence).collect())
    }

    /// The part of a collection of several parts.
    #[must_use]
    pub fn part(&self) -> Option<&str> {
        self.part.as_deref()
    }

    /// Opens a sequence. Arrays are read now, listed files later.
    ///
    /// # Errors
    /// [`ReadError`] names the file, the place in it, and what was expected there. A collection of several
    /// parts is an error.
    pub fn open(path: impl AsRef<Path>, options: impl Into<ReadOptions>) -> Result<Self, ReadError> {
        let (path, options) = (path.as_ref(), options.into());
        let ReadOptions {
            polygons, max_size, ..
        } = options;
        let source = match (extension(path).as_deref(), Format::of_path(path)) {
            (Some("pvd"), _) => timed(read_pvd_within(path, max_size)?),
            (Some("series"), _) => timed(read_series_within(path, max_size)?),
            (_, Some(format @ (Format::Npz | Format::Npy))) => read_arrays(path, format, &options)?,
            (_, Some(Format::Gltf)) => {
                let folder = path.parent();
                let recording = parse_file(path, max_size, |bytes, budget| {
                    if !gltf::has_animations(bytes, budget)? {
                        return Ok(None);
                    }
                    recognise::check(bytes, Format::Gltf)?;
                    let (meshes, cells) = gltf::read_moving(bytes, folder, budget)?;
                    cells.charge(budget);
                    with_mesh(Positions::Placed(meshes), cells, polygons).map(Some)
                })?;
                recording.unwrap_or_else(|| Source::Files(vec![(None, path.to_owned())]))
            }
            _ => Source::Files(vec![(None, path.to_owned())]),
        };
        let path = path.to_owned();
        Ok(Self {
            path,
            part: None,
            options,
            source,
        })
    }

    /// Returns true for the name of a cache of positions, which [`open_cache`](Self::open_cache) reads.
    #[must_use]
    pub fn is_cache(path: &Path) -> bool {
        PointCache::has_name(path)
    }

    /// Opens the frames in a cache of positions, PC2 or MDD, of the mesh in another file. Of the mesh, the
    /// positions are not used. A frame of the cache is read when it is needed.
    ///
    /// The times are numbers of frames in PC2, and seconds in MDD.
    ///
    /// # Errors
    /// [`ReadError`] names the file, the place in it, and what was expected there: also for a cache of
    /// another number of vertices than the mesh file has, and for one that is cut off.
    pub fn open_cache(
        mesh: impl AsRef<Path>,
        cache: impl AsRef<Path>,
        options: impl Into<ReadOptions>,
    ) -> Result<Self, ReadError> {
        let (mesh, path, options) = (mesh.as_ref(), cache.as_ref(), options.into());
        let first = MeshFile::read(mesh, &options)?;
        let cache = PointCache::open(path)?;
        let [own, expected] = [cache.vertex_count(), first.ids.vertex_count as u64];
        if own != expected {
            let expected = format!("{expected} vertices, as of {}", mesh.display());
            let fault = Fault::expected(expected, format!("{own} vertices"));
            return Err(in_file(path, fault.at(Place::File)));
        }
        let recording = Recording {
            positions: Positions::Cached(cache),
            first,
            mesh: Some(mesh.to_owned()),
        };
        Ok(Self {
            path: path.to_owned(),
            part: None,
            options,
            source: Source::Recording(Box::new(recording)),
        })
    }

    /// The number of frames.
    #[must_use]
    pub fn len(&self) -> usize {
        match &self.source {
            Source::Files(files) => files.len(),
            Source::Recording(recording) => recording.positions.frame_count(),
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
            Source::Recording(_) => &self.path,
        }
    }

    /// The file with the mesh of a frame, which is not [the file](Self::file) of the frame for a cache.
    #[must_use]
    pub fn mesh_file(&self, frame: usize) -> &Path {
        let mesh = match &self.source {
            Source::Files(_) => None,
            Source::Recording(recording) => recording.mesh.as_deref(),
        };
        mesh.unwrap_or_else(|| self.file(frame))
    }

    /// The name of a frame, counted from 0, for messages: its file, or the file of the sequence and
    /// the number.
    #[must_use]
    pub fn name(&self, frame: usize) -> String {
        let file = self.file(frame).display();
        match &self.source {
            Source::Files(_) => file.to_string(),
            Source::Recording(_) => format!("{file}, frame {frame}"),
        }
    }

    /// The time of a frame, counted from 0, if the sequence has times.
    #[must_use]
    pub fn time(&self, frame: usize) -> Option<f64> {
        match &self.source {
            Source::Files(files) => files.get(frame)?.0,
            Source::Recording(recording) => recording.positions.time(frame),
        }
    }

    /// Reads a frame, counted from 0.
    ///
    /// # Errors
    /// [`ReadError`] names the file and what was expected there; also for a frame that the sequence
    /// does not have.
    pub fn read(&self, frame: usize) -> Result<MeshFile, ReadError> {
        let at_path = |source: ParseError| in_file(&self.path, source);
        if frame >= self.len() {
            let expected = format!("a frame below {}", self.len());
            return Err(at_path(
                Fault::expected(expected, frame.to_string()).at(Place::File),
            ));
        }
        match &self.source {
            Source::Files(_) => MeshFile::read(self.file(frame), &self.options),
            Source::Recording(recording) => recording.read(frame, &self.path),
        }
    }

    /// All frames in order.
    pub fn iter(&self) -> impl Iterator<Item = Result<MeshFile, ReadError>> {
        (0..self.len()).map(|frame| self.read(frame))
    }
}

/// The files of a list with times.
fn timed(files: Vec<(f64, PathBuf)>) -> Source {
    let files = files.into_iter();
    Source::Files(files.map(|(time, file)| (Some(time), file)).collect())
}

/// The recording in a file of arrays, with the faces of another file if the options name one.
fn read_arrays(path: &Path, format: Format, options: &ReadOptions) -> Result<Source, ReadError> {
    let is_file = |name: &&str| name.ends_with(".npy");
    let faces_file = options.faces.as_deref().filter(is_file);
    let names = Names {
        positions: options.positions.as_deref(),
        faces: options.faces.as_deref().filter(|name| !is_file(name)),
        has_faces_file: faces_file.is_some(),
    };
    if format == Format::Npy && (names.positions.is_some() || names.faces.is_some()) {
        let expected = "a file .npy for --faces and no name for --positions: this file has one array";
        let fault = Fault::expected(expected, "the name of an array");
        return Err(in_file(path, fault.at(Place::File)));
    }
    let read_faces = |file| parse_file(Path::new(file), options.max_size, numpy::read_faces);
    let faces = faces_file.map(read_faces).transpose()?;
    parse_file(path, options.max_size, |bytes, budget| {
        recognise::check(bytes, format)?;
        let mut arrays = match format {
            Format::Npz => numpy::read_npz(bytes, &names, budget)?,
            _ => numpy::read_npy(bytes, budget)?,
        };
        if let Some(faces) = faces {
            arrays = arrays.with_faces(faces)?;
        }
        let cells = arrays.cells()?;
        with_mesh(Positions::Arrays(arrays), cells, options.polygons)
    })
}

/// Positions of all frames with the mesh of the first one, which all frames share.
fn with_mesh(positions: Positions, first: Cells, polygons: Polygons) -> Result<Source, ParseError> {
    let first = MeshFile::assembled(assemble_cells(first, Format::Npz)?, polygons)?;
    Ok(Source::Recording(Box::new(Recording {
        positions,
        first,
        mesh: None,
    })))
}
