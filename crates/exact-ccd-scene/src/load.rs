//! From a scene file to a simulation.

use std::path::Path;

use exact_ccd_sim::{Body, Load, ScriptedVertices, Settings, Simulation, StepFilter, System};

use super::body::{Loaded, check_name, load};
use super::description::{Axis, BodyDescription, Description, Selection};
use super::document::{Document, SceneError};
use super::field_error::FieldError;
use super::locate::{of_simulation, of_system};
use super::parse::parse;
use super::rendering::Rendering;
use super::springs::springs;

/// The filter of the CCD method that the settings of a scene file name, for the system of the scene; or a
/// message with the names that there are. It may replace settings, which are checked after it.
pub type FilterByName<'a> = dyn Fn(&mut Settings, &System) -> Result<StepFilter, String> + 'a;

/// A scene file as a simulation.
#[derive(Debug)]
pub struct Scene {
    /// The simulation from its start, with the settings and the CCD method of the scene.
    pub simulation: Simulation,
    /// The duration, as a number of time steps.
    pub steps: u64,
    /// The settings of the pictures.
    pub rendering: Rendering,
    /// Facts about the mesh files that could change the result, each with its file.
    pub notes: Vec<String>,
}

impl Scene {
    /// Reads a scene file. Mesh files are read from the folder `meshes`, or from the folder of the scene
    /// file.
    ///
    /// # Errors
    /// [`SceneError`] names the file, the line and the field.
    pub fn read(
        file: impl AsRef<Path>,
        meshes: Option<&Path>,
        filter_by_name: &FilterByName<'_>,
    ) -> Result<Self, SceneError> {
        let file = file.as_ref();
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
        let folder = meshes.or_else(|| file.parent()).unwrap_or(Path::new(""));
        let scene = Self::of(description, folder, filter_by_name);
        scene.map_err(|error| document.error_of(error))
    }

    /// The described scene, with mesh files in a folder.
    fn of(
        description: Description,
        folder: &Path,
        filter_by_name: &FilterByName<'_>,
    ) -> Result<Self, FieldError> {
        let Some(duration) = description.duration else {
            let message = "the key `duration` is missing, expected a number of seconds";
            return Err(FieldError::new("", message));
        };
        description
            .render
            .check()
            .map_err(|error| error.below("render"))?;
        if description.body.is_empty() {
            let message = "the scene has no body, expected at least one `[[body]]`";
            return Err(FieldError::new("body", message));
        }
        let mut parts = Parts::default();
        for (index, described) in description.body.iter().enumerate() {
            let added = parts.add(described, folder);
            added.map_err(|error| error.below(&format!("body.{index}")))?;
        }
        for (index, described) in description.half_space.iter().enumerate() {
            check_name(&described.name).map_err(|error| error.below(&format!("half-space.{index}")))?;
        }
        let springs = springs(&description)?;
        let system = System::new(&parts.bodies, &parts.scripts)
            .and_then(|system| system.with_springs(springs))
            .and_then(|system| system.with_half_spaces(description.half_space.clone()))
            .and_then(|system| system.with_loads(parts.loads))
            .map_err(|error| of_system(&description, &error))?;
        let mut settings = description.settings;
        let filter = filter_by_name(&mut settings, &system)
            .map_err(|message| FieldError::new("settings.ccd", message))?;
        let simulation = Simulation::with_method(system, settings, filter);
        let simulation = simulation.map_err(|error| of_simulation(&error))?;
        // The simulation has checked that the time step is positive.
        let steps = steps(duration, simulation.settings().time_step)?;
        Ok(Self {
            simulation,
            steps,
            rendering: description.render,
            notes: parts.notes,
        })
    }
}

/// The bodies of a scene with their scripts and loads.
#[derive(Default)]
struct Parts {
    bodies: Vec<Body>,
    scripts: Vec<ScriptedVertices>,
    loads: Vec<Load>,
    vertex_count: u32,
    notes: Vec<String>,
}

impl Parts {
    fn add(&mut self, described: &BodyDescription, folder: &Path) -> Result<(), FieldError> {
        let Loaded {
            body,
            groups,
            mut notes,
        } = load(described, folder)?;
        self.notes.append(&mut notes);
        let selected = |selection: &Selection, number| {
            let selected = selection.vertices(&body.points, &groups, self.vertex_count);
            selected.map_err(|message| FieldError::new(format!("{number}.vertices"), message))
        };
        for (number, script) in described.script.iter().enumerate() {
            let scripted = ScriptedVertices {
                vertices: selected(&script.vertices, number).map_err(|error| error.below("script"))?,
                script: script.motion.clone(),
                axes: [Axis::X, Axis::Y, Axis::Z].map(|axis| script.axes.contains(&axis)),
                from: script.from,
                release: script.release,
            };
            scripted.check().map_err(|error| {
                let motion = if error.field.contains('.') { "motion" } else { "" };
                FieldError::new(format!("script.{number}.{motion}.{}", error.field), error)
            })?;
            self.scripts.push(scripted);
        }
        for (number, load) in described.load.iter().enumerate() {
            let load = Load {
                vertices: selected(&load.vertices, number).map_err(|error| error.below("load"))?,
                force: load.force,
                from: load.from,
                until: load.until,
            };
            let checked = load.check();
            checked.map_err(|error| FieldError::new(format!("load.{number}.{}", error.field), error))?;
            self.loads.push(load);
        }
        self.vertex_count += body.vertex_count() as u32;
        self.bodies.push(body);
        Ok(())
    }
}

/// The duration as a number of time steps.
fn steps(duration: f64, time_step: f64) -> Result<u64, FieldError> {
    // Bounded so that the cast to u64 is exact.
    let steps = (duration / time_step).round();
    if duration > 0.0 && steps == 0.0 {
        let message = format!(
            "the duration is {duration} s, less than half of the time step of {time_step} s, expected at least one \
             time step: set a longer `duration`, or a shorter `settings.time-step`"
        );
        return Err(FieldError::new("duration", message));
    }
    if duration >= 0.0 && steps < 1e15 {
        return Ok(steps as u64);
    }
    let message =
        format!("the duration is {duration} s, expected a number not below 0, of fewer than 10¹⁵ time steps");
    Err(FieldError::new("duration", message))
}
