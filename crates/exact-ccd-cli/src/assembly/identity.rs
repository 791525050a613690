//! The identity of the files of a scene: two runs with one identity read the same frames.

use std::fs;
use std::hash::{DefaultHasher, Hash, Hasher};
use std::path::Path;

use super::Assembly;
use super::part::Part;
use crate::messages::failure::Failure;

impl Assembly {
    /// A hash of the names of all frames, and of the sizes and times of change of their files and of other
    /// inputs, as 16 hexadecimal digits.
    pub(crate) fn identity<'a>(&self, others: impl Iterator<Item = &'a Path>) -> Result<String, Failure> {
        let mut hasher = DefaultHasher::new();
        for part in &self.parts {
            part.name.hash(&mut hasher);
            let mut last = None;
            for index in 0..part.frame_count() {
                part.frame_name(index).hash(&mut hasher);
                let files = part.files(index);
                // Most frames of one file are side by side.
                if last.replace(files) != Some(files) {
                    files.iter().try_for_each(|file| add_state(&mut hasher, file))?;
                }
            }
        }
        for file in others.filter(|file| file.is_file()) {
            add_state(&mut hasher, file)?;
        }
        Ok(format!("{:016x}", hasher.finish()))
    }
}

impl Part {
    fn frame_count(&self) -> usize {
        self.frames.count()
    }

    /// The files with the mesh and with the positions of a frame.
    fn files(&self, index: usize) -> [&Path; 2] {
        [self.frames.mesh_file(index), self.frames.file(index)]
    }
}

/// Adds the size and the time of change of a file.
fn add_state(hasher: &mut DefaultHasher, file: &Path) -> Result<(), Failure> {
    let failed = |source| Failure::of(file, format_args!("cannot read its size and time: {source}"));
    let state = fs::metadata(file).map_err(failed)?;
    file.hash(hasher);
    state.len().hash(hasher);
    // Some systems have no times.
    state.modified().ok().hash(hasher);
    Ok(())
}
