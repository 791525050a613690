//! The frames of a part: their files in order, and the reading of them.

use std::fs;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use exact_ccd_files::{Format, FrameOrder, FrameSequence, MeshFile, ReadError, ReadOptions};

use crate::files::inputs::{check_path, name};
use crate::messages::failure::{Failure, listed};
use crate::messages::notes::Notes;

/// Frames in the order of time. A file has one frame or several.
pub(crate) struct Frames(Vec<(Arc<FrameSequence>, usize)>);

impl Frames {
    /// All frames in a file: of a mesh, of arrays, or of a list of files.
    pub(super) fn of_file(file: &Path, options: &ReadOptions) -> Result<Self, Failure> {
        let mut parts = Self::parts_of_file(file, options)?;
        match (parts.pop(), parts.len()) {
            (Some((_, frames)), 0) => Ok(frames),
            (_, others) => Err(Failure::of(
                file,
                format_args!(
                    "{} parts, expected one; give the file alone, or a list for each part",
                    others + 1
                ),
            )),
        }
    }

    /// All frames of each part in a file, and the names of the parts if there are several, as in a
    /// collection of ParaView.
    pub(super) fn parts_of_file(
        file: &Path,
        options: &ReadOptions,
    ) -> Result<Vec<(Option<String>, Self)>, Failure> {
        check_path(file, "a mesh file")?;
        if file.is_dir() {
            let reason =
                "this is a folder, expected a mesh file; `exact-ccd audit` examines the frames in a folder";
            return Err(Failure::of(file, reason));
        }
        let mut parts = Vec::new();
        for sequence in FrameSequence::open_parts(file, options)? {
            if sequence.is_empty() {
                return Err(Failure::of(file, "no frame, expected at least one"));
            }
            let name = sequence.part().map(str::to_owned);
            parts.push((name, Self::of_sequence(sequence)));
        }
        Ok(parts)
    }

    fn of_sequence(sequence: FrameSequence) -> Self {
        let sequence = Arc::new(sequence);
        let frames = (0..sequence.len()).map(|frame| (sequence.clone(), frame));
        Self(frames.collect())
    }

    /// The frames in files, folders and lists of files, as [`Frames::of_paths`]; of one file, the frames of
    /// each part; of a mesh and a cache of its positions, the frames in the cache.
    pub(super) fn parts_of_paths(
        paths: &[PathBuf],
        as_given: bool,
        options: &ReadOptions,
        notes: &mut Notes,
    ) -> Result<Vec<(Option<String>, Self)>, Failure> {
        match paths {
            [file] if file.is_file() => Self::parts_of_file(file, options),
            [mesh, cache] if FrameSequence::is_cache(cache) => {
                check_path(mesh, "a mesh file")?;
                check_path(cache, "a cache of positions")?;
                let sequence = FrameSequence::open_cache(mesh, cache, options)?;
                Ok(vec![(None, Self::of_sequence(sequence))])
            }
            _ => Ok(vec![(None, Self::of_paths(paths, as_given, options, notes)?)]),
        }
    }

    /// The start and the end of a step, each the only frame in a file.
    pub(super) fn of_pair(start: &Path, end: &Path, options: &ReadOptions) -> Result<Self, Failure> {
        let mut frames = Vec::new();
        for file in [start, end] {
            let Self(found) = Self::of_file(file, options)?;
            if found.len() != 1 {
                return Err(frame_count(file, found.len(), 1));
            }
            frames.extend(found);
        }
        Ok(Self(frames))
    }

    /// The frames in files, folders and lists of files. Numbered files are taken in the order of their
    /// numbers, unless `as_given`.
    pub(super) fn of_paths(
        paths: &[PathBuf],
        as_given: bool,
        options: &ReadOptions,
        notes: &mut Notes,
    ) -> Result<Self, Failure> {
        for path in paths {
            check_path(path, "a mesh file, or a folder or a list of them")?;
        }
        let order = FrameOrder::of_row(paths.to_vec());
        let is_row = !as_given && paths.len() > 1;
        if is_row {
            check_certain(&order)?;
            if order.is_changed {
                notes.note(
                    "the frames are sorted by the numbers in their names; --as-given keeps the order given"
                        .to_owned(),
                );
            }
            warn_of_missing(&order, notes);
        }
        let is_numbered = |file: &PathBuf| name(file).contains(|c: char| c.is_ascii_digit());
        if !as_given && let Some(pair) = order.unlike.as_ref().filter(|pair| pair.iter().any(is_numbered)) {
            warn_of_unlike(pair, "; --as-given omits this warning", notes);
        }
        let paths = if is_row { &order.files } else { paths };
        let mut frames = Vec::new();
        for path in paths {
            if path.is_dir() {
                if as_given {
                    return Err(Failure::of(
                        path,
                        "--as-given needs files: those of a folder are not given in an order",
                    ));
                }
                for file in meshes_in(path, notes)? {
                    frames.extend(Self::of_file(&file, options)?.0);
                }
            } else {
                frames.extend(Self::of_file(path, options)?.0);
            }
        }
        Ok(Self(frames))
    }

    pub(crate) fn count(&self) -> usize {
        self.0.len()
    }

    /// The name of a frame for messages.
    pub(super) fn name(&self, index: usize) -> String {
        let (sequence, frame) = &self.0[index];
        sequence.name(*frame)
    }

    /// The file of a frame.
    pub(super) fn file(&self, index: usize) -> &Path {
        let (sequence, frame) = &self.0[index];
        sequence.file(*frame)
    }

    /// The file with the mesh of a frame.
    pub(super) fn mesh_file(&self, index: usize) -> &Path {
        let (sequence, frame) = &self.0[index];
        sequence.mesh_file(*frame)
    }

    /// The time of a frame, if its file or its list of files has times.
    pub(super) fn time(&self, index: usize) -> Option<f64> {
        let (sequence, frame) = self.0.get(index)?;
        sequence.time(*frame)
    }

    pub(super) fn read(&self, index: usize) -> Result<MeshFile, ReadError> {
        let (sequence, frame) = &self.0[index];
        sequence.read(*frame)
    }

    /// The files of two frames, for errors about both.
    pub(super) fn files(&self, frames: [usize; 2]) -> [PathBuf; 2] {
        frames.map(|frame| PathBuf::from(self.name(frame)))
    }

    /// Returns true if all files are STL, which has no shared vertices.
    pub(super) fn are_stl(&self) -> bool {
        let is_stl = |(sequence, frame): &(Arc<FrameSequence>, usize)| {
            Format::of_path(sequence.file(*frame)) == Some(Format::Stl)
        };
        self.0.iter().all(is_stl)
    }
}

/// The meshes in a folder, in the order of the numbers in their names. Other files are skipped.
fn meshes_in(folder: &Path, notes: &mut Notes) -> Result<Vec<PathBuf>, Failure> {
    let failed = |source| {
        let path = folder.to_owned();
        Failure::from(ReadError::Io { path, source })
    };
    let mut files = Vec::new();
    for entry in fs::read_dir(folder).map_err(failed)? {
        let path = entry.map_err(failed)?.path();
        if Format::of_path(&path).is_some() {
            files.push(path);
        }
    }
    let order = FrameOrder::of(files);
    check_certain(&order)?;
    warn_of_missing(&order, notes);
    if let Some(pair) = &order.unlike {
        warn_of_unlike(pair, "", notes);
    }
    let formats = order
        .files
        .iter()
        .filter_map(|file| Some((Format::of_path(file)?, file)));
    let mut formats = formats.map(|(format, file)| (format, file.display()));
    let Some((first, file)) = formats.next() else {
        return Err(Failure::of(
            folder,
            format_args!("no mesh file in the folder, expected {}", Format::extensions()),
        ));
    };
    if let Some((second, other)) = formats.find(|(format, _)| *format != first) {
        return Err(Failure::of(
            folder,
            format_args!(
                "meshes of several formats, {} ({file}) and {} ({other}), expected one: name the files of one of \
                 them in place of the folder",
                first.name(),
                second.name()
            ),
        ));
    }
    Ok(order.files)
}

/// Refuses names whose order depends on the meaning of a point between digits.
fn check_certain(order: &FrameOrder) -> Result<(), Failure> {
    match &order.uncertain {
        None => Ok(()),
        Some([a, b]) => Err(Failure::new(format_args!(
            "the order of {} and {} is not certain: the point in their numbers may be that of a decimal, or between \
             two numbers; give the files in order with --as-given, or give all numbers the same number of digits",
            a.display(),
            b.display()
        ))),
    }
}

/// The failure of a number of frames that a step cannot have.
pub(super) fn frame_count(file: &Path, count: usize, expected: usize) -> Failure {
    let remedy = if count < expected {
        "add the file of the end"
    } else {
        "`exact-ccd audit` examines longer motions"
    };
    let plural = if count == 1 { "" } else { "s" };
    Failure::of(
        file,
        format_args!("{count} frame{plural}, expected {expected}; {remedy}"),
    )
}

/// A warning about two files, one behind the other, that may belong to two motions.
fn warn_of_unlike([a, b]: &[PathBuf; 2], remedy: &str, notes: &mut Notes) {
    notes.warn(format!(
        "the names of the frames differ in more than numbers: {} follows {}, as if both were of one motion{remedy}",
        b.display(),
        a.display()
    ));
}

fn warn_of_missing(order: &FrameOrder, notes: &mut Notes) {
    if order.missing.is_empty() {
        return;
    }
    let gaps = listed(order.missing.iter().map(ToString::to_string), 5);
    notes.warn(format!(
        "numbers are missing in the names of the frames: {gaps}; the frames around a gap are one step"
    ));
}
