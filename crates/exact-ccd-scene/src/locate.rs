//! The fields of a scene file to which errors of systems and simulations belong.

use exact_ccd_mesh::Point;

use super::description::{BodyDescription, Description};
use super::document::{Document, Key, SceneError};
use exact_ccd_sim::{HalfSpaceError, Primitive, SimulationError, System, SystemError};

use Key::{Index, Name};

/// The error of a system, at the body and its field.
pub(super) fn of_system(
    document: &Document<'_>,
    description: &Description,
    error: &SystemError,
) -> SceneError {
    let of_body = |body: usize, path: &[Key<'_>], message: &str| {
        let path: Vec<Key<'_>> = [Name("body"), Index(body)]
            .into_iter()
            .chain(path.iter().copied())
            .collect();
        document.error_of(&path, message)
    };
    let described = |body: usize| description.body.get(body);
    let material = |body| described(body).map_or("solid", BodyDescription::material);
    match error {
        SystemError::Body { body, source } => {
            let of_motion = ["velocity", "angular-velocity", "offset"].contains(&source.field);
            let material = (!of_motion).then(|| Name(material(*body)));
            let path: Vec<Key<'_>> = material.into_iter().chain([Name(source.field)]).collect();
            of_body(*body, &path, &source.to_string())
        }
        SystemError::Material { body, region, source } => {
            let path = [Name("region"), Index(*region), Name("solid"), Name(source.field)];
            of_body(*body, &path, &source.to_string())
        }
        SystemError::Mass { body, .. } => {
            let path = [Name(material(*body)), Name("density")];
            of_body(*body, &path, &without_body(*body, error))
        }
        // The points of a mesh are finite: the placement overflows.
        SystemError::NotFinite { body, .. } => of_body(*body, &[], &without_body(*body, error)),
        SystemError::HalfSpace(HalfSpaceError { half_space, what, .. }) => {
            let path = [Name("half-space"), Index(*half_space), Name(what)];
            document.error_of(&path, &error.to_string())
        }
        SystemError::Index { body, .. }
        | SystemError::Empty { body }
        | SystemError::Solid { body, .. }
        | SystemError::Folded { body, .. }
        | SystemError::Region { body, .. }
        | SystemError::Flat { body, .. } => {
            let has_shape = described(*body).is_some_and(|described| described.shape.is_some());
            let source = if has_shape { "shape" } else { "mesh" };
            of_body(*body, &[Name(source)], &without_body(*body, error))
        }
        _ => document.error_of(&[Name("body")], &error.to_string()),
    }
}

/// The message without the number of the body, which the path of the field has already.
fn without_body(body: usize, error: &SystemError) -> String {
    let message = error.to_string();
    let rest = message.strip_prefix(&format!("body {body}: ")).map(str::to_owned);
    rest.unwrap_or(message)
}

/// The error of a simulation, at the setting or at the second of two touching bodies.
pub(super) fn of_simulation(document: &Document<'_>, system: &System, error: &SimulationError) -> SceneError {
    let field = match error {
        SimulationError::Start { primitives, near } => {
            let what = ["intersect or touch at the start", "a positive"];
            return of_start(document, system, *primitives, *near, what);
        }
        SimulationError::Close {
            primitives,
            near,
            thickness,
        } => {
            let what = format!("are within the sum of their offsets, {thickness} m, at the start");
            return of_start(document, system, *primitives, *near, [&what, "a larger"]);
        }
        SimulationError::Grounded {
            vertex,
            half_space,
            near,
        } => {
            let body = system.body_of(*vertex);
            let half_space = system.designation(system.body_names().len() + half_space);
            let message = format!(
                "a vertex at {near:?} touches {half_space} at the start, or is inside of it, \
                 expected a positive distance above the offset of the body"
            );
            return document.error_of(&[Name("body"), Index(body)], &message);
        }
        SimulationError::Setting(setting) => setting.field,
        SimulationError::UnknownBody { .. } => "friction.pair",
        SimulationError::Method { .. } | SimulationError::Separation { .. } => "ccd",
        _ => "",
    };
    let names = field.split('.').filter(|name| !name.is_empty()).map(Name);
    let path: Vec<Key<'_>> = std::iter::once(Name("settings")).chain(names).collect();
    document.error_of(&path, &error.to_string())
}

/// The error of two primitives that are too near, with the vertex indices of their bodies.
fn of_start(
    document: &Document<'_>,
    system: &System,
    primitives: [Primitive; 2],
    near: Point,
    [what, expected]: [&str; 2],
) -> SceneError {
    // A primitive has a vertex, and each vertex belongs to a body.
    let [(a, first), (b, second)] = primitives.map(|primitive| {
        let body = system.body_of(primitive.vertices()[0]);
        let start = system.body_vertices()[body].start;
        (body, primitive.map(|vertex| vertex - start))
    });
    let [of_a, of_b] = [a, b].map(|body| system.designation(body));
    let message = format!(
        "{second} of {of_b} and {first} of {of_a} {what}, near {near:?}, \
         expected {expected} distance between them"
    );
    document.error_of(&[Name("body"), Index(b)], &message)
}
