//! The output folder of a simulation.

use std::fs::{self, File};
use std::io::{self, BufReader};
use std::path::{Path, PathBuf};

use exact_ccd_files::{write_ply, write_pvd};
use exact_ccd_sim::scene::Scene;
use exact_ccd_sim::{Checkpoint, Simulation, Statistics};

use super::grid::Grid;
use super::log::Log;
use super::path::Path as PathWriter;
use super::statistics::Row;
use super::steps;
use crate::failure::Failure;
use crate::output::{draft_of, remove_files, write_file};

const CHECKPOINT: &str = "checkpoint.json";
const STATISTICS: &str = "statistics.csv";
const COLLECTION: &str = "motion.pvd";
pub(super) const ANIMATION: &str = "motion.png";
pub(super) const ENERGIES: &str = "energies.svg";
pub(super) const DISTANCE: &str = "minimal-distance.svg";
const FILES: [&str; 6] = [CHECKPOINT, STATISTICS, COLLECTION, ANIMATION, ENERGIES, DISTANCE];

/// The subfolders, which have one or more files for each time step.
const FRAMES: &str = "frames";
const GRIDS: &str = "vtu";
const PATH: &str = "path";
pub(super) const PICTURES: &str = "pictures";

/// An output folder with the results up to a time step.
pub(super) struct OutputFolder {
    folder: PathBuf,
    log: Log<Row>,
    grid: Grid,
}

impl OutputFolder {
    /// The simulation of a scene, resumed from the checkpoint in a folder.
    pub(super) fn simulation(folder: &Path, scene: &Scene) -> Result<Simulation, Failure> {
        let file = folder.join(CHECKPOINT);
        let failed = |message: String| Failure::Checkpoint {
            file: file.clone(),
            message,
        };
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
                "{error}; the file is damaged or not a checkpoint: start a new run without --resume"
            ))
        })?;
        scene
            .resume(checkpoint)
            .map_err(|error| failed(error.to_string()))
    }

    /// Removes the results of an earlier run, and writes the initial state.
    pub(super) fn begin(folder: &Path, simulation: &Simulation) -> Result<Self, Failure> {
        make_folder(&folder.join(FRAMES))?;
        make_folder(&folder.join(GRIDS))?;
        // These files refer to those in the subfolders, so they are removed first.
        for file in FILES.map(|name| folder.join(name)) {
            match fs::remove_file(&file) {
                Err(error) if error.kind() != io::ErrorKind::NotFound => {
                    return Err(Failure::write(&file, error));
                }
                _ => {}
            }
        }
        remove_after(folder, None)?;
        let this = Self {
            folder: folder.to_owned(),
            log: Log::begin(folder.join(STATISTICS))?,
            grid: Grid::new(simulation.system()),
        };
        this.write_frame(simulation)?;
        this.write_checkpoint(simulation)?;
        Ok(this)
    }

    /// Continues after the state of a resumed simulation. Removes everything that the earlier run wrote after
    /// its last checkpoint.
    pub(super) fn resume(folder: &Path, simulation: &Simulation) -> Result<Self, Failure> {
        let last = simulation.state().step;
        let grid = grid_file(folder, last);
        if !grid.is_file() {
            return Err(Failure::Checkpoint {
                file: folder.join(CHECKPOINT),
                message: format!(
                    "the checkpoint has time step {last}, expected the file {} of this step: \
                     start a new run without --resume",
                    grid.display()
                ),
            });
        }
        let this = Self {
            folder: folder.to_owned(),
            log: Log::resume(folder.join(STATISTICS), last)?,
            grid: Grid::new(simulation.system()),
        };
        // The collection is written first, so that it never names a removed file.
        this.write_collection(simulation)?;
        remove_after(folder, Some(last))?;
        Ok(this)
    }

    /// Adds a time step. The checkpoint is written last, so that all files of its time step exist.
    pub(super) fn add(&mut self, simulation: &Simulation, statistics: &Statistics) -> Result<(), Failure> {
        self.write_frame(simulation)?;
        self.log.add(&statistics.into())?;
        self.write_checkpoint(simulation)
    }

    /// The writer for the path of the next time step, which starts at the current state.
    pub(super) fn path(&self, simulation: &Simulation) -> PathWriter {
        let state = simulation.state();
        let mut path = PathWriter::new(self.file(PATH), simulation.system().clone(), state.step + 1);
        path.add(&state.positions);
        path
    }

    fn write_frame(&self, simulation: &Simulation) -> Result<(), Failure> {
        let state = simulation.state();
        let frame = simulation.system().surface_frame(&state.positions);
        write_file(&self.frame(state.step), |writer| {
            write_ply(writer, &frame.map_err(io::Error::other)?)
        })?;
        write_file(&grid_file(&self.folder, state.step), |writer| {
            self.grid.write(state, writer)
        })?;
        self.write_collection(simulation)
    }

    fn write_collection(&self, simulation: &Simulation) -> Result<(), Failure> {
        let time_step = simulation.settings().time_step;
        let frame = |step: u64| {
            (
                step as f64 * time_step,
                format!("{GRIDS}/{}", steps::name(step, "vtu")),
            )
        };
        let frames = (0..=simulation.state().step).map(frame);
        write_file(&self.file(COLLECTION), |writer| write_pvd(writer, frames))
    }

    fn write_checkpoint(&self, simulation: &Simulation) -> Result<(), Failure> {
        write_file(&self.file(CHECKPOINT), |writer| {
            Ok(serde_json::to_writer(writer, &simulation.checkpoint())?)
        })
    }

    /// The statistics of all time steps.
    pub(super) fn statistics(&self) -> Result<Vec<Row>, Failure> {
        self.log.rows()
    }

    /// The file of the surface at the end of a time step.
    pub(super) fn frame(&self, step: u64) -> PathBuf {
        self.file(FRAMES).join(steps::name(step, "ply"))
    }

    /// The path of a file in the folder.
    pub(super) fn file(&self, name: &str) -> PathBuf {
        self.folder.join(name)
    }
}

fn grid_file(folder: &Path, step: u64) -> PathBuf {
    folder.join(GRIDS).join(steps::name(step, "vtu"))
}

pub(super) fn make_folder(folder: &Path) -> Result<(), Failure> {
    fs::create_dir_all(folder).map_err(|source| Failure::write(folder, source))
}

/// Removes the files of all time steps after `last`, or of all time steps for `None`, and unfinished files.
fn remove_after(folder: &Path, last: Option<u64>) -> Result<(), Failure> {
    for inner in [FRAMES, GRIDS, PATH, PICTURES] {
        steps::remove_after(&folder.join(inner), last)?;
    }
    let is_draft = |name: &str| draft_of(name).is_some_and(|file| FILES.contains(&file));
    remove_files(folder, is_draft).map_err(|source| Failure::write(folder, source))
}
