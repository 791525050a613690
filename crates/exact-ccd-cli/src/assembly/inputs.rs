//! The parts that move, from the files of the command line.

use std::path::PathBuf;

use exact_ccd_files::{FrameSequence, ReadOptions};

use super::frames::{self, Frames};
use super::named_file::named;
use super::part::part_name;
use super::{Assembly, AssemblyOptions};
use crate::messages::failure::Failure;
use crate::messages::notes::Notes;

impl Assembly {
    /// The meshes in files of one frame each, as parts.
    pub(crate) fn of_meshes(
        files: &[PathBuf],
        options: &AssemblyOptions,
        notes: &mut Notes,
    ) -> Result<Self, Failure> {
        let mut meshes = Vec::new();
        for file in files {
            let (name, file) = named(file);
            let frames = Frames::of_file(&file, &options.read_options())?;
            if frames.count() != 1 {
                return Err(frames::frame_count(&file, frames.count(), 1));
            }
            meshes.push((name, frames));
        }
        Self::open(meshes, options, notes)
    }

    /// The frames of pairs of files, each the start and the end of a part; or of one file of two frames, or
    /// of a mesh and a cache of two frames.
    pub(crate) fn of_pairs(
        files: &[PathBuf],
        options: &AssemblyOptions,
        notes: &mut Notes,
    ) -> Result<Self, Failure> {
        let read_options = options.read_options();
        let mut moving = Vec::new();
        let is_one = match files {
            [_] => true,
            [_, end] => FrameSequence::is_cache(end),
            _ => false,
        };
        if is_one && let Some(last) = files.last() {
            for (name, frames) in Self::sequence(files, false, &read_options, notes)? {
                if frames.count() != 2 {
                    return Err(frames::frame_count(last, frames.count(), 2));
                }
                moving.push((name, frames));
            }
        } else {
            let (pairs, rest) = files.as_chunks::<2>();
            if let [file] = rest {
                return Err(Failure::of(
                    file,
                    "there is no end to this start: expected pairs of files, START END",
                ));
            }
            for [start, end] in pairs {
                let ((name, start), (_, end)) = (named(start), named(end));
                moving.push((name, Frames::of_pair(&start, &end, &read_options)?));
            }
        }
        Self::open(moving, options, notes)
    }

    /// The frames of one part that moves, in the files, folders and lists of files.
    pub(crate) fn of_sequence(
        paths: &[PathBuf],
        as_given: bool,
        options: &AssemblyOptions,
        notes: &mut Notes,
    ) -> Result<Self, Failure> {
        let moving = Self::sequence(paths, as_given, &options.read_options(), notes)?;
        Self::open(moving, options, notes)
    }

    /// The parts that move in the files, folders and lists of files, by their names.
    fn sequence(
        paths: &[PathBuf],
        as_given: bool,
        options: &ReadOptions,
        notes: &mut Notes,
    ) -> Result<Vec<(String, Frames)>, Failure> {
        let (names, files): (Vec<_>, Vec<_>) = paths.iter().map(|path| named(path)).unzip();
        let parts = Frames::parts_of_paths(&files, as_given, options, notes)?;
        let name = names.into_iter().next().unwrap_or_default();
        let parts = parts.into_iter();
        Ok(parts
            .map(|(part, frames)| (part_name(&name, part), frames))
            .collect())
    }
}
