//! The path of one time step: the surface after each Newton step.

use std::io;
use std::path::PathBuf;

use exact_ccd_files::{NamedPart, write_ply_with_parts};
use exact_ccd_mesh::Point;
use exact_ccd_sim::System;

use crate::files::outputs::write_file_soon;
use crate::messages::failure::Failure;

/// Writes the surface after each Newton step of a time step.
pub(crate) struct NewtonPath<'a> {
    folder: PathBuf,
    system: &'a System,
    parts: Vec<NamedPart>,
    step: u64,
    increments: usize,
    files: Vec<PathBuf>,
    result: Result<(), Failure>,
}

impl<'a> NewtonPath<'a> {
    /// The writer for a time step, in a folder.
    pub(crate) fn new(folder: PathBuf, system: &'a System, step: u64) -> Self {
        Self {
            folder,
            parts: named_parts(system),
            system,
            step,
            increments: 0,
            files: Vec::new(),
            result: Ok(()),
        }
    }

    /// Writes the surface for these positions of the vertices. Does nothing after an error.
    pub(crate) fn add(&mut self, positions: &[Point]) {
        if self.result.is_ok() {
            let file = self
                .folder
                .join(format!("{:06}-{:03}.ply", self.step, self.increments));
            let frame = self.system.surface_frame(positions);
            self.result = write_file_soon(&file, |writer| {
                write_ply_with_parts(writer, &frame.map_err(io::Error::other)?, &self.parts)
            });
            self.files.push(file);
            self.increments += 1;
        }
    }

    /// Returns the files that have been written, or the first error.
    pub(crate) fn finish(self) -> Result<Vec<PathBuf>, Failure> {
        self.result.map(|()| self.files)
    }
}

/// The bodies of the surface of a system, for the files of the surface.
pub(crate) fn named_parts(system: &System) -> Vec<NamedPart> {
    let part = |(name, vertices)| NamedPart { name, vertices };
    system.surface_bodies().into_iter().map(part).collect()
}
