//! The folder of a simulation's results.

use std::fs::{self, File, OpenOptions};
use std::io::{self, BufReader, Write};
use std::path::{Path, PathBuf};

use ccd_sim::{Simulation, State, Statistics};

use super::path::Path as PathWriter;
use crate::failure::Failure;
use crate::output::write_file;

/// A folder with `frames`, `statistics.jsonl` and `checkpoint.json`.
pub(super) struct OutputFolder {
    folder: PathBuf,
}

impl OutputFolder {
    /// The folder, which is made if there is none.
    pub(super) fn create(folder: &Path) -> Result<Self, Failure> {
        let frames = folder.join("frames");
        fs::create_dir_all(&frames).map_err(|source| Failure::write(&frames, source))?;
        let folder = folder.to_owned();
        Ok(Self { folder })
    }

    /// The state after the last time step that is here.
    pub(super) fn checkpoint(&self) -> Result<State, Failure> {
        let file = self.file("checkpoint.json");
        let failed = |message: String| Failure::Checkpoint {
            file: file.clone(),
            message,
        };
        let reader = File::open(&file).map_err(|error| failed(error.to_string()))?;
        serde_json::from_reader(BufReader::new(reader)).map_err(|error| failed(error.to_string()))
    }

    /// Writes the start, in place of what was there.
    pub(super) fn begin(&self, simulation: &Simulation) -> Result<(), Failure> {
        self.write_frame(simulation)?;
        write_file(&self.file("statistics.jsonl"), |_| Ok(()))?;
        self.write_checkpoint(simulation)
    }

    /// Adds a time step: the checkpoint last, so that what it stands for is there.
    pub(super) fn add(&self, simulation: &Simulation, statistics: &Statistics) -> Result<(), Failure> {
        self.write_frame(simulation)?;
        let file = self.file("statistics.jsonl");
        let append = || -> io::Result<()> {
            let mut line = serde_json::to_string(statistics)?;
            line.push('\n');
            OpenOptions::new()
                .create(true)
                .append(true)
                .open(&file)?
                .write_all(line.as_bytes())
        };
        append().map_err(|source| Failure::write(&file, source))?;
        self.write_checkpoint(simulation)
    }

    /// Where the way of the next time step goes, from where the simulation is.
    pub(super) fn path(&self, simulation: &Simulation) -> PathWriter {
        let state = simulation.state();
        let mut path = PathWriter::new(self.file("path"), simulation.system().clone(), state.step + 1);
        path.add(&state.positions);
        path
    }

    fn write_frame(&self, simulation: &Simulation) -> Result<(), Failure> {
        let state = simulation.state();
        let file = self.frame(state.step);
        let frame = simulation.system().surface_frame(&state.positions);
        write_file(&file, |writer| frame.map_err(io::Error::other)?.write_ply(writer))
    }

    fn write_checkpoint(&self, simulation: &Simulation) -> Result<(), Failure> {
        write_file(&self.file("checkpoint.json"), |writer| {
            Ok(serde_json::to_writer(writer, simulation.state())?)
        })
    }

    /// The file of the surface after a time step.
    pub(super) fn frame(&self, step: u64) -> PathBuf {
        self.folder.join("frames").join(format!("{step:06}.ply"))
    }

    /// A file in the folder.
    pub(super) fn file(&self, name: &str) -> PathBuf {
        self.folder.join(name)
    }
}
