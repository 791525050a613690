//! From a scene file to a simulation.

use std::path::Path;

use exact_ccd_mesh::{Bounds, Point};

use super::description::{BodyDescription, Description, Selection};
use super::document::{Document, Key, SceneError};
use super::mesh::Mesh;
use crate::body::{Body, BodyKind};
use crate::checkpoint::Checkpoint;
use crate::settings::Settings;
use crate::simulation::{Primitive, Simulation, SimulationError};
use crate::system::{System, SystemError};

use Key::{Index, Name};

/// A scene that is ready to be simulated.
#[derive(Clone, Debug)]
pub struct Scene {
    /// The bodies and what moves them.
    pub system: System,
    /// The numbers.
    pub settings: Settings,
    /// How many time steps its duration is.
    pub steps: u64,
}

impl Scene {
    /// The scene in a file. Mesh files are sought in the folder `meshes`, or else in that of the scene file.
    ///
    /// # Errors
    /// [`SceneError`] names the file, the line and the field.
    pub fn read(file: impl AsRef<Path>, meshes: Option<&Path>) -> Result<Self, SceneError> {
        let file = file.as_ref();
        let text = std::fs::read_to_string(file).map_err(|source| SceneError::Io {
            file: file.to_owned(),
            source,
        })?;
        Self::parse(&text, file, meshes)
    }

    /// The scene in a text, which is said to be that of a file.
    ///
    /// # Errors
    /// As [`Scene::read`].
    pub fn parse(text: &str, file: &Path, meshes: Option<&Path>) -> Result<Self, SceneError> {
        let document = Document { file, text };
        let description: Description = toml::from_str(text).map_err(|error| {
            let byte = error.span().map_or(0, |span| span.start);
            document.error_at(byte, error.message())
        })?;
        let settings = description.settings.clone();
        let folder = meshes.or_else(|| file.parent()).unwrap_or(Path::new(""));

        if description.body.is_empty() {
            return Err(document.error_of(&[Name("body")], "there is none, expected at least one `[[body]]`"));
        }
        let mut bodies = Vec::new();
        let mut scripts = Vec::new();
        let mut first = 0;
        for (index, described) in description.body.iter().enumerate() {
            let body = load(described, folder).map_err(|(field, message)| {
                document.error_of(&[Name("body"), Index(index), Name(field)], &message)
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
                let selected = select(script.vertices, &body.points, first)
                    .map_err(|message| document.error_of(&of_script("vertices"), &message))?;
                script.motion.check().map_err(|error| {
                    let of_motion = error.field.split('.').map(Name);
                    let path: Vec<Key<'_>> = of_script("motion").into_iter().chain(of_motion).collect();
                    document.error_of(&path, &error.to_string())
                })?;
                scripts.push((selected, script.motion));
            }
            first += body.points.len() as u32;
            bodies.push(body);
        }
        let system =
            System::new(&bodies, &scripts).map_err(|error| locate(&document, &description, &error))?;
        let mut scene = Self {
            system,
            settings,
            steps: 0,
        };
        scene
            .simulation()
            .map_err(|error| in_simulation(&document, &bodies, &error))?;
        // Only now is the time step known to be positive.
        scene.steps = steps(&document, description.duration, scene.settings.time_step)?;
        Ok(scene)
    }

    /// The simulation from the start.
    ///
    /// # Errors
    /// As [`Simulation::new`].
    pub fn simulation(&self) -> Result<Simulation, SimulationError> {
        Simulation::new(self.system.clone(), self.settings.clone())
    }

    /// The simulation from a checkpoint of it.
    ///
    /// # Errors
    /// As [`Checkpoint::resume`].
    pub fn resume(&self, checkpoint: Checkpoint) -> Result<Simulation, SimulationError> {
        checkpoint.resume(self.system.clone(), self.settings.clone())
    }
}

/// A body, or the field that is wrong and why.
fn load(described: &BodyDescription, folder: &Path) -> Result<Body, (&'static str, String)> {
    let mesh = match (&described.mesh, described.shape) {
        (Some(path), None) => {
            let path = folder.join(path);
            if !path.is_file() {
                let file = path.display();
                let message = format!(
                    "there is no file {file}: meshes are sought beside the scene, or in the folder of --meshes"
                );
                return Err(("mesh", message));
            }
            Mesh::read(&path).map_err(|message| ("mesh", message))?
        }
        (None, Some(shape)) => Mesh::generate(shape).map_err(|message| ("shape", message))?,
        (Some(_), Some(_)) => {
            return Err((
                "shape",
                "there is a mesh already, expected one of the two".to_owned(),
            ));
        }
        (None, None) => return Err(("mesh", "missing, expected a mesh file or a shape".to_owned())),
    };
    let Mesh {
        points,
        faces,
        tetrahedra,
    } = mesh;
    let kind = match (described.solid, described.shell) {
        (Some(_), None) if tetrahedra.is_empty() => {
            return Err((
                "solid",
                "the mesh has no tetrahedra, expected a .msh file or a box".to_owned(),
            ));
        }
        (Some(material), None) => BodyKind::Solid { tetrahedra, material },
        (None, Some(material)) => BodyKind::Shell { faces, material },
        (None, None) => BodyKind::Obstacle { faces },
        (Some(_), Some(_)) => {
            return Err(("shell", "it is solid already, expected one of the two".to_owned()));
        }
    };
    if !described.scale.is_sound() {
        return Err(("scale", "expected finite factors that are not zero".to_owned()));
    }
    if described.rotate.is_some_and(|rotation| !rotation.has_axis()) {
        return Err(("rotate", "the axis has no direction, expected one".to_owned()));
    }
    let points = points.into_iter().map(|point| described.place(point)).collect();
    let velocity = described.velocity;
    Ok(Body {
        points,
        kind,
        velocity,
    })
}

/// The selected vertices of a body whose vertices are numbered from `first` on, or why there are none.
fn select(selection: Selection, points: &[Point], first: u32) -> Result<Vec<u32>, String> {
    let all = (first..).zip(points);
    let Selection::Box { lower, upper } = selection else {
        return Ok(all.map(|(vertex, _)| vertex).collect());
    };
    if (0..3).any(|axis| lower[axis] > upper[axis]) {
        return Err(format!(
            "the box from {lower:?} to {upper:?} is empty, expected `lower` not above `upper`"
        ));
    }
    let is_selected = |point: &Point| (0..3).all(|axis| (lower[axis]..=upper[axis]).contains(&point[axis]));
    let selected: Vec<u32> = all
        .filter(|(_, point)| is_selected(point))
        .map(|(vertex, _)| vertex)
        .collect();
    if selected.is_empty() {
        let body: Bounds = points.iter().copied().collect();
        return Err(format!(
            "no vertex of the body is there: placed, it goes from {:?} to {:?}",
            body.lower, body.upper
        ));
    }
    Ok(selected)
}

fn steps(document: &Document<'_>, duration: f64, time_step: f64) -> Result<u64, SceneError> {
    // Longer than that nobody waits; and then it fits.
    let steps = (duration / time_step).round();
    if duration >= 0.0 && steps < 1e15 {
        Ok(steps as u64)
    } else {
        let message = format!(
            "{duration}, expected a number of seconds, not below 0 and of fewer than 10¹⁵ time steps"
        );
        Err(document.error_of(&[Name("duration")], &message))
    }
}

/// The error of a system, at the body.
fn locate(document: &Document<'_>, description: &Description, error: &SystemError) -> SceneError {
    // The field says of which body it is.
    let message = |body: usize| {
        let message = error.to_string();
        let rest = message.strip_prefix(&format!("body {body}: ")).map(str::to_owned);
        rest.unwrap_or(message)
    };
    let (body, field) = match error {
        SystemError::NotPositive { body, what, .. } => (*body, Some(*what)),
        SystemError::Moduli { body, source } => (*body, Some(source.field())),
        SystemError::Mass { body, .. } => (*body, Some("density")),
        SystemError::Velocity { body, .. } => {
            let path = [Name("body"), Index(*body), Name("velocity")];
            return document.error_of(&path, &message(*body));
        }
        SystemError::Index { body, .. }
        | SystemError::Empty { body }
        | SystemError::NotFinite { body, .. }
        | SystemError::Solid { body, .. }
        | SystemError::Flat { body, .. } => (*body, None),
        SystemError::Script { .. } | SystemError::Motion { .. } | SystemError::Mesh(_) => {
            return document.error_of(&[Name("body")], &error.to_string());
        }
    };
    let is_solid = description
        .body
        .get(body)
        .is_some_and(|body| body.solid.is_some());
    let material = if is_solid { "solid" } else { "shell" };
    let path = [
        Name("body"),
        Index(body),
        Name(field.map_or("mesh", |_| material)),
        Name(field.unwrap_or("")),
    ];
    let depth = if field.is_some() { 4 } else { 3 };
    document.error_of(&path[..depth], &message(body))
}

/// The error of a simulation, at the setting that is wrong, or at the second of two bodies that meet.
fn in_simulation(document: &Document<'_>, bodies: &[Body], error: &SimulationError) -> SceneError {
    let field = match error {
        SimulationError::Start { primitives, near } => return in_start(document, bodies, *primitives, *near),
        SimulationError::Setting(setting) => setting.what,
        SimulationError::Filter(_) => "ccd",
        SimulationError::State { .. }
        | SimulationError::NotFinite { .. }
        | SimulationError::Late { .. }
        | SimulationError::OtherSetting { .. }
        | SimulationError::OtherSystem { .. }
        | SimulationError::Singular { .. }
        | SimulationError::Blocked { .. } => "",
    };
    let names = field.split('.').filter(|name| !name.is_empty()).map(Name);
    let path: Vec<Key<'_>> = std::iter::once(Name("settings")).chain(names).collect();
    document.error_of(&path, &error.to_string())
}

/// The error of two primitives that meet, with the numbers that vertices have in their bodies.
fn in_start(document: &Document<'_>, bodies: &[Body], primitives: [Primitive; 2], near: Point) -> SceneError {
    let ranges = System::ranges(bodies);
    // Both have vertices, and each is that of a body.
    let [(a, first), (b, second)] = primitives.map(|primitive| {
        let vertex = primitive.vertices()[0];
        let body = ranges.partition_point(|range| range.end <= vertex);
        (body, primitive.map(|vertex| vertex - ranges[body].start))
    });
    let message = format!(
        "{second} of body[{b}] and {first} of body[{a}], near {near:?}, meet at the start, expected a distance between them"
    );
    document.error_of(&[Name("body"), Index(b)], &message)
}
