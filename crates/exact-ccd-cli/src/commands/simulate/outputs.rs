//! The files of a run, by the options that name them.

use std::path::{Path, PathBuf};

use exact_ccd_scene::Rendering;
use exact_ccd_sim::{Simulation, Statistics};

use super::arguments::Arguments;
use super::drawings::pictures::Pictures;
use super::drawings::plots;
use super::folder::OutputFolder;
use super::folder::path::NewtonPath;
use super::lines::text;
use super::queries::{Counts, QueryFolder};
use crate::messages::failure::Failure;
use crate::view::SimulationPage;

/// The files of `--output`, `--render`, `--dump-queries` and `--view`.
pub(super) struct Outputs {
    folder: Option<OutputFolder>,
    pictures: Option<Pictures>,
    queries: Option<QueryFolder>,
    /// The page, and the description of the scene on it.
    page: Option<(SimulationPage, String)>,
}

impl Outputs {
    /// The simulation in its state at the start, or in the state of the checkpoint in the folder of --output,
    /// and its files up to this state. `last` is the number of the last time step.
    pub(super) fn open(
        arguments: &Arguments,
        simulation: Simulation,
        rendering: &Rendering,
        last: u64,
    ) -> Result<(Simulation, Self), Failure> {
        let (mut simulation, folder) = open_folder(arguments, simulation)?;
        let mut queries = None;
        if let Some(folder) = &arguments.dump_queries {
            let opened = QueryFolder::open(folder, simulation, arguments.dump_most as usize)?;
            (simulation, queries) = (opened.0, Some(opened.1));
        }
        let mut page = None;
        if arguments.view.file().is_some() {
            let view = &arguments.view;
            let mut recording = view.simulation(&arguments.scene, &simulation, rendering);
            recording.add_state(&simulation, None)?;
            page = Some((recording, text::description(&simulation, last)));
        }
        let drawn = folder.as_ref().filter(|_| arguments.render);
        let pictures = drawn.map(|folder| Pictures::begin(folder, &simulation, *rendering));
        let outputs = Self {
            pictures: pictures.transpose()?,
            folder,
            queries,
            page,
        };
        Ok((simulation, outputs))
    }

    /// The writer for the Newton steps of the next time step, if they are written.
    pub(super) fn path(&self, simulation: &Simulation) -> Option<NewtonPath<'_>> {
        self.folder.as_ref()?.path(simulation)
    }

    /// Adds a time step, with the files of its path.
    pub(super) fn add(
        &mut self,
        simulation: &Simulation,
        statistics: &Statistics,
        path: Vec<PathBuf>,
        is_last: bool,
    ) -> Result<(), Failure> {
        if let Some(queries) = &mut self.queries {
            queries.add(statistics.step)?;
        }
        if let Some((recording, _)) = &mut self.page {
            recording.add_state(simulation, Some(statistics))?;
        }
        if let Some(folder) = &mut self.folder {
            folder.add(simulation, statistics, path, is_last)?;
            if let Some(pictures) = &mut self.pictures {
                pictures.add(folder)?;
            }
        }
        Ok(())
    }

    /// Writes the page, with a verdict about all time steps. Before that, saves the current state if the run
    /// ends early.
    pub(super) fn finish(
        &mut self,
        simulation: &Simulation,
        is_complete: bool,
        verdict: &str,
    ) -> Result<(), Failure> {
        if let Some(folder) = self.folder.as_mut().filter(|_| !is_complete) {
            folder.finish(simulation)?;
        }
        match self.page.take() {
            Some((recording, description)) => {
                recording.finish(verdict, &description, contact_distance(simulation))
            }
            None => Ok(()),
        }
    }

    /// The numbers of queries of all time steps, if they are written.
    pub(super) fn query_counts(&self) -> Option<&Counts> {
        self.queries.as_ref().map(QueryFolder::total)
    }

    /// Draws the plots and animations of the whole motion, if there are pictures.
    pub(super) fn draw(self, scene: &Path, simulation: &Simulation) -> Result<(), Failure> {
        let (Some(folder), Some(pictures)) = (&self.folder, self.pictures) else {
            return Ok(());
        };
        let name = scene.file_stem().unwrap_or_default().to_string_lossy();
        plots::draw(folder, &name, contact_distance(simulation))?;
        pictures.finish(folder)
    }
}

/// The distance d̂ in m.
fn contact_distance(simulation: &Simulation) -> f64 {
    let distance = simulation.settings().contact_distance;
    distance.meters(simulation.system().size())
}

/// The simulation at its start, or from the checkpoint in the folder of --output, with the opened folder.
fn open_folder(
    arguments: &Arguments,
    simulation: Simulation,
) -> Result<(Simulation, Option<OutputFolder>), Failure> {
    let folder = arguments.output.as_deref();
    if let Some(folder) = folder.filter(|_| arguments.resume) {
        let simulation = OutputFolder::resumed(folder, &simulation)?;
        let folder = OutputFolder::resume(folder, &simulation, arguments)?;
        return Ok((simulation, Some(folder)));
    }
    let folder = folder.map(|folder| OutputFolder::begin(folder, &simulation, arguments));
    Ok((simulation, folder.transpose()?))
}
