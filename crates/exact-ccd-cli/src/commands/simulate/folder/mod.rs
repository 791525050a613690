//! The output folder of a simulation.

mod bodies;
mod contact_points;
mod grid;
pub(super) mod layout;
pub(super) mod log;
pub(super) mod path;
mod removal;
pub(super) mod statistics;
pub(super) mod steps;

use std::fs::{self, File};
use std::io::{self, BufReader};
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

use exact_ccd_files::{write_ply_with_parts, write_pvd};
use exact_ccd_sim::{Checkpoint, Simulation, Statistics, System};

use super::arguments::Arguments;
use crate::files::outputs::{make_folder, write_file, write_file_soon};
use crate::messages::failure::Failure;
use grid::Grid;
use layout::{
    BODIES, CHECKPOINT, COLLECTION, CONTACT_COLLECTION, CONTACTS, FRAMES, GRIDS, PATH, STATISTICS, files,
    frames_until, missing, missing_in_path, remove_after, remove_index_files,
};
use log::Log;
use path::{NewtonPath, named_parts};
use statistics::Row;

/// The time between two checkpoints. Flushing files to disk can take longer than a time step.
const INTERVAL: Duration = Duration::from_secs(1);

/// An output folder with the results up to a time step.
///
/// Results are written without waiting for the disk. A checkpoint follows at intervals: first all results are
/// flushed, then the checkpoint replaces the previous one. So the results to which a checkpoint refers are
/// complete, also after a crash of the system.
pub(crate) struct OutputFolder {
    folder: PathBuf,
    log: Log<Row>,
    grid: Grid,
    /// The time steps with files.
    frames: Vec<u64>,
    /// The number of time steps from one with files to the next.
    every: u64,
    /// The system, if the path is written: the folder has a subfolder for it.
    path_of: Option<System>,
    /// The files that have been written since the last checkpoint.
    pending: Vec<PathBuf>,
    saved: Instant,
}

impl OutputFolder {
    /// The simulation, resumed from the checkpoint in a folder.
    pub(crate) fn resumed(folder: &Path, simulation: &Simulation) -> Result<Simulation, Failure> {
        let file = folder.join(CHECKPOINT);
        let failed = |message: String| Failure::of(&file, message);
        let reader = File::open(&file).map_err(|error| {
            failed(match error.kind() {
                io::ErrorKind::NotFound => {
                    "the file does not exist, expected the checkpoint of an earlier run: \
                     start a new run without --resume"
                        .to_owned()
                }
                _ => error.to_string(),
            })
        })?;
        let checkpoint: Checkpoint = serde_json::from_reader(BufReader::new(reader)).map_err(|error| {
            failed(format!(
                "{error}; the file is damaged or not a checkpoint: start a new run with --overwrite"
            ))
        })?;
        let (system, settings) = (simulation.system().clone(), simulation.settings().clone());
        let resumed = checkpoint.resume(system, settings, simulation.filter().clone());
        resumed.map_err(|error| failed(error.to_string()))
    }

    /// Writes the initial state. If `overwrite`, the results of an earlier run are removed; otherwise they
    /// are an error.
    pub(crate) fn begin(
        folder: &Path,
        simulation: &Simulation,
        arguments: &Arguments,
    ) -> Result<Self, Failure> {
        if !arguments.overwrite
            && [CHECKPOINT, STATISTICS]
                .iter()
                .any(|name| folder.join(name).exists())
        {
            return Err(Failure::of(
                folder,
                "the folder has the results of an earlier run: \
                 continue it with --resume, or replace it with --overwrite",
            ));
        }
        make_folder(&folder.join(FRAMES))?;
        make_folder(&folder.join(GRIDS))?;
        make_folder(&folder.join(CONTACTS))?;
        remove_index_files(folder)?;
        remove_after(folder, None)?;
        if !arguments.path {
            // Files of other origin stay, with their folder.
            let _ = fs::remove_dir(folder.join(PATH));
        }
        let log = Log::begin(folder.join(STATISTICS))?;
        bodies::write(&folder.join(BODIES), simulation.system())?;
        let mut this = Self::with(folder, simulation, log, Vec::new(), arguments)?;
        this.write_frame(simulation)?;
        this.save(simulation)?;
        Ok(this)
    }

    /// The folder, which has the results up to the state of a simulation.
    fn with(
        folder: &Path,
        simulation: &Simulation,
        log: Log<Row>,
        frames: Vec<u64>,
        arguments: &Arguments,
    ) -> Result<Self, Failure> {
        let path = folder.join(PATH);
        if arguments.path {
            make_folder(&path)?;
        }
        Ok(Self {
            folder: folder.to_owned(),
            log,
            grid: Grid::new(simulation.system()),
            frames,
            every: arguments.every,
            path_of: path.is_dir().then(|| simulation.system().clone()),
            pending: Vec::new(),
            saved: Instant::now(),
        })
    }

    /// Continues after the state of a resumed simulation. Removes everything that the earlier run wrote after
    /// its last checkpoint.
    pub(crate) fn resume(
        folder: &Path,
        simulation: &Simulation,
        arguments: &Arguments,
    ) -> Result<Self, Failure> {
        let last = simulation.state().step;
        let [_, grid, _] = files(folder, last);
        if !grid.is_file() {
            return Err(Failure::of(
                &folder.join(CHECKPOINT),
                format_args!(
                    "the checkpoint has time step {last}, expected the file {} of this step: \
                     start a new run with --overwrite",
                    grid.display()
                ),
            ));
        }
        let log = Log::resume(folder.join(STATISTICS), last, |row: &Row| row.step)?;
        let frames = frames_until(folder, last);
        let missing = missing(folder, &frames, &log.rows()?, last);
        if let Some(missing) = missing {
            return Err(Failure::of(
                &folder.join(CHECKPOINT),
                format_args!(
                    "the checkpoint has time step {last}, but {missing} is missing: \
                     restore it, or start a new run with --overwrite"
                ),
            ));
        }
        if let Some(step) = missing_in_path(folder, last) {
            return Err(Failure::of(
                &folder.join(PATH),
                format_args!(
                    "the checkpoint has time step {last}, but the path has none of the files of time step {step}: \
                     restore them, or remove this folder to continue without the path"
                ),
            ));
        }
        bodies::write(&folder.join(BODIES), simulation.system())?;
        let mut this = Self::with(folder, simulation, log, frames, arguments)?;
        // The collections are written first, so that they never name a removed file.
        this.write_collections(simulation)?;
        remove_after(folder, Some(last))?;
        Ok(this)
    }

    /// Adds a time step, with the files of its path. The results of the last one get files in any case.
    pub(crate) fn add(
        &mut self,
        simulation: &Simulation,
        statistics: &Statistics,
        path: Vec<PathBuf>,
        is_last: bool,
    ) -> Result<(), Failure> {
        self.pending.extend(path);
        self.log.add(&statistics.into())?;
        if is_last || simulation.state().step.is_multiple_of(self.every) {
            self.write_frame(simulation)?;
            if is_last || self.saved.elapsed() >= INTERVAL {
                self.save(simulation)?;
            }
        }
        Ok(())
    }

    /// Saves the current state, after which the run ends early: the files of a time step that was not
    /// completed are removed.
    pub(crate) fn finish(&mut self, simulation: &Simulation) -> Result<(), Failure> {
        let step = simulation.state().step;
        remove_after(&self.folder, Some(step))?;
        if self.frames.last() != Some(&step) {
            self.write_frame(simulation)?;
        }
        self.save(simulation)
    }

    /// Flushes all results to disk, then writes the checkpoint.
    fn save(&mut self, simulation: &Simulation) -> Result<(), Failure> {
        for file in self.pending.drain(..) {
            let synced = File::open(&file).and_then(|open| open.sync_all());
            synced.map_err(|source| Failure::write(&file, source))?;
        }
        self.log.sync()?;
        self.write_checkpoint(simulation)?;
        self.saved = Instant::now();
        Ok(())
    }

    /// The writer for the path of the next time step, if the folder has a path.
    pub(crate) fn path(&self, simulation: &Simulation) -> Option<NewtonPath<'_>> {
        let (system, state) = (self.path_of.as_ref()?, simulation.state());
        let mut path = NewtonPath::new(self.file(PATH), system, state.step + 1);
        path.add(&state.positions);
        Some(path)
    }

    fn write_frame(&mut self, simulation: &Simulation) -> Result<(), Failure> {
        let state = simulation.state();
        let frame = simulation.system().surface_frame(&state.positions);
        let parts = named_parts(simulation.system());
        let files = files(&self.folder, state.step);
        write_file_soon(&files[0], |writer| {
            write_ply_with_parts(writer, &frame.map_err(io::Error::other)?, &parts)
        })?;
        write_file_soon(&files[1], |writer| self.grid.write(state, writer))?;
        write_file_soon(&files[2], |writer| contact_points::write(simulation, writer))?;
        self.pending.extend(files);
        self.frames.push(state.step);
        self.write_collections(simulation)
    }

    fn write_collections(&mut self, simulation: &Simulation) -> Result<(), Failure> {
        let time_step = simulation.settings().time_step;
        for (collection, folder, extension) in
            [(COLLECTION, GRIDS, "vtu"), (CONTACT_COLLECTION, CONTACTS, "vtp")]
        {
            let frame = |&step: &u64| {
                let name = format!("{folder}/{}", steps::name(step, extension));
                (step as f64 * time_step, name)
            };
            let file = self.file(collection);
            write_file_soon(&file, |writer| write_pvd(writer, self.frames.iter().map(frame)))?;
            if !self.pending.contains(&file) {
                self.pending.push(file);
            }
        }
        Ok(())
    }

    fn write_checkpoint(&self, simulation: &Simulation) -> Result<(), Failure> {
        write_file(&self.file(CHECKPOINT), |writer| {
            Ok(serde_json::to_writer(writer, &simulation.checkpoint())?)
        })
    }

    /// The statistics of all time steps.
    pub(crate) fn statistics(&self) -> Result<Vec<Row>, Failure> {
        self.log.rows()
    }

    /// The time steps with files, increasing.
    pub(crate) fn frames(&self) -> &[u64] {
        &self.frames
    }

    /// The file of the surface at the end of a time step.
    pub(crate) fn frame(&self, step: u64) -> PathBuf {
        let [frame, ..] = files(&self.folder, step);
        frame
    }

    /// The path of a file in the folder.
    pub(crate) fn file(&self, name: &str) -> PathBuf {
        self.folder.join(name)
    }
}
