//! From a scene file to a simulation.

use std::path::Path;

use super::body::load;
use super::description::Axis;
use super::document::{Document, Key, SceneError};
use super::import::{Imported, Note, import};
use super::locate::{of_simulation, of_system};
use super::parse::parse;
use super::region;
use super::rendering::Rendering;
use super::selection::select;
use exact_ccd_sim::Checkpoint;
use exact_ccd_sim::Load;
use exact_ccd_sim::Scripted;
use exact_ccd_sim::Settings;
use exact_ccd_sim::StepFilter;
use exact_ccd_sim::System;
use exact_ccd_sim::{Simulation, SimulationError};

use Key::{Index, Name};

/// The filter of a CCD method, by its name in a scene file and the system of the scene; or a message with
/// the names that there are.
pub type FilterByName<'a> = dyn Fn(&str, &System) -> Result<StepFilter, String> + 'a;

/// The system, the settings and the duration of a scene file.
#[derive(Clone, Debug)]
pub struct Scene {
    /// The bodies and their scripts.
    pub system: System,
    /// The settings.
    pub settings: Settings,
    /// The filter of the CCD method that the scene names.
    pub filter: StepFilter,
    /// The duration, as a number of time steps.
    pub steps: u64,
    /// The settings of the pictures.
    pub rendering: Rendering,
    /// The entries of a scene of another program that are ignored.
    pub notes: Vec<Note>,
}

impl Scene {
    /// Reads a scene file, or one of another program as of [`import`]. Mesh files are read from the folder
    /// `meshes`, or from that of the scene file.
    ///
    /// # Errors
    /// [`SceneError`] names the file, the line and the field.
    pub fn read(
        file: impl AsRef<Path>,
        meshes: Option<&Path>,
        filter_by_name: &FilterByName<'_>,
    ) -> Result<Self, SceneError> {
        let file = file.as_ref();
        if let Some(Imported { toml, meshes, notes }) = import(file, meshes)? {
            let mut label = file.as_os_str().to_owned();
            label.push(" as TOML");
            let scene = Self::parse(&toml, Path::new(&label), Some(&meshes), filter_by_name)?;
            return Ok(Self { notes, ..scene });
        }
        let bytes = std::fs::read(file).map_err(|source| SceneError::Io {
            file: file.to_owned(),
            source,
        })?;
        let text = String::from_utf8(bytes).map_err(|error| {
            let valid = error.utf8_error().valid_up_to();
            let text = String::from_utf8_lossy(&error.as_bytes()[..valid]);
            let message = "found bytes that are no text in UTF-8, expected a scene in TOML";
            Document { file, text: &text }.error_at(valid, |_| message.to_owned())
        })?;
        Self::parse(&text, file, meshes, filter_by_name)
    }

    /// Parses the text of a scene file. `file` is its path, for messages and for the folder of mesh files.
    ///
    /// # Errors
    /// As [`Scene::read`].
    pub fn parse(
        text: &str,
        file: &Path,
        meshes: Option<&Path>,
        filter_by_name: &FilterByName<'_>,
    ) -> Result<Self, SceneError> {
        let document = Document { file, text };
        let description = parse(&document)?;
        let Some(duration) = description.duration else {
            let message = "the key `duration` is missing, expected a number of seconds";
            return Err(document.error_of(&[], message));
        };
        let checked = description.render.check();
        checked.map_err(|(field, message)| document.error_of(&[Name("render"), Name(field)], &message))?;
        let settings = description.settings.clone();
        let folder = meshes.or_else(|| file.parent()).unwrap_or(Path::new(""));

        if description.body.is_empty() {
            let message = "the scene has no body, expected at least one `[[body]]`";
            return Err(document.error_of(&[Name("body")], message));
        }
        let mut bodies = Vec::new();
        let mut scripts = Vec::new();
        let mut loads = Vec::new();
        let mut first = 0;
        for (index, described) in description.body.iter().enumerate() {
            let (mut body, groups) = load(described, folder).map_err(|(field, message)| {
                document.error_of(&[Name("body"), Index(index), Name(field)], &message)
            })?;
            region::add(&described.region, &groups, &mut body).map_err(|(number, message)| {
                let path = [
                    Name("body"),
                    Index(index),
                    Name("region"),
                    Index(number),
                    Name("group"),
                ];
                document.error_of(&path, &message)
            })?;
            for (number, script) in described.script.iter().enumerate() {
                let of_script = |field| {
                    [
                        Name("body"),
                        Index(index),
                        Name("script"),
                        Index(number),
                        Name(field),
                    ]
                };
                let selected = select(&script.vertices, &body.points, &groups, first)
                    .map_err(|message| document.error_of(&of_script("vertices"), &message))?;
                let scripted = Scripted {
                    vertices: selected,
                    script: script.motion.clone(),
                    axes: [Axis::X, Axis::Y, Axis::Z].map(|axis| script.axes.contains(&axis)),
                    from: script.from,
                    release: script.release,
                };
                scripted.check().map_err(|error| {
                    let names = error.field.split('.').map(Name);
                    let motion = error.field.contains('.').then_some(Name("motion"));
                    let path = [Name("body"), Index(index), Name("script"), Index(number)];
                    let path: Vec<Key<'_>> = path.into_iter().chain(motion).chain(names).collect();
                    document.error_of(&path, &error.to_string())
                })?;
                scripts.push(scripted);
            }
            for (number, load) in described.load.iter().enumerate() {
                let of_load = |field| {
                    [
                        Name("body"),
                        Index(index),
                        Name("load"),
                        Index(number),
                        Name(field),
                    ]
                };
                let vertices = select(&load.vertices, &body.points, &groups, first)
                    .map_err(|message| document.error_of(&of_load("vertices"), &message))?;
                let load = Load {
                    vertices,
                    force: load.force,
                    from: load.from,
                    until: load.until,
                };
                load.check()
                    .map_err(|error| document.error_of(&of_load(error.field), &error.to_string()))?;
                loads.push(load);
            }
            first += body.points.len() as u32;
            bodies.push(body);
        }
        let system = System::new(&bodies, &scripts)
            .and_then(|system| system.with_half_spaces(description.half_space.clone()))
            .and_then(|system| system.with_loads(loads))
            .map_err(|error| of_system(&document, &description, &error))?;
        let filter = filter_by_name(&settings.ccd, &system)
            .map_err(|message| document.error_of(&[Name("settings"), Name("ccd")], &message))?;
        let mut scene = Self {
            system,
            settings,
            filter,
            steps: 0,
            rendering: description.render,
            notes: Vec::new(),
        };
        // A simulation checks the settings, of which the number of steps needs a positive time step.
        scene
            .simulation()
            .map_err(|error| of_simulation(&document, &scene.system, &error))?;
        scene.steps = steps(&document, duration, scene.settings.time_step)?;
        Ok(scene)
    }

    /// The simulation from its start.
    ///
    /// # Errors
    /// As [`Simulation::new`].
    pub fn simulation(&self) -> Result<Simulation, SimulationError> {
        let settings = Settings {
            ccd: StepFilter::default().name().to_owned(),
            ..self.settings.clone()
        };
        Simulation::new(self.system.clone(), settings)?.with_filter(self.filter.clone())
    }

    /// The simulation from a checkpoint of this scene.
    ///
    /// # Errors
    /// As [`Checkpoint::resume`].
    pub fn resume(&self, checkpoint: Checkpoint) -> Result<Simulation, SimulationError> {
        checkpoint.resume(self.system.clone(), self.settings.clone(), self.filter.clone())
    }
}

/// The duration as a number of time steps.
fn steps(document: &Document<'_>, duration: f64, time_step: f64) -> Result<u64, SceneError> {
    // Bounded so that the cast to u64 is exact.
    let steps = (duration / time_step).round();
    if duration >= 0.0 && steps < 1e15 {
        Ok(steps as u64)
    } else {
        let message = format!(
            "the duration is {duration} s, expected a number not below 0, of fewer than 10¹⁵ time steps"
        );
        Err(document.error_of(&[Name("duration")], &message))
    }
}
