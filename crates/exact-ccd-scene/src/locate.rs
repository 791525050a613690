//! The fields of a scene file to which errors of systems and simulations belong.

use exact_ccd_mesh::Point;
use exact_ccd_sim::{HalfSpaceError, Primitive, SimulationError, System, SystemError};

use super::description::{BodyDescription, Description};
use super::field_error::FieldError;

/// The error of a system, at the body and its field.
pub(super) fn of_system(description: &Description, error: &SystemError) -> FieldError {
    let described = |body: usize| description.body.get(body);
    let material = |body: usize| described(body).map_or("solid", BodyDescription::material);
    let (body, field) = match error {
        SystemError::Body { body, source } => {
            let is_of_body = ["velocity", "angular-velocity", "offset"].contains(&source.field);
            let table = if is_of_body { "" } else { material(*body) };
            (*body, format!("{table}.{}", source.field))
        }
        SystemError::Material { body, region, source } => {
            (*body, format!("region.{region}.solid.{}", source.field))
        }
        SystemError::Mass { body, .. } => (*body, format!("{}.density", material(*body))),
        // The points of a mesh are finite: the placement overflows.
        SystemError::NotFinite { body, .. } => (*body, String::new()),
        SystemError::Index { body, .. }
        | SystemError::Empty { body }
        | SystemError::Solid { body, .. }
        | SystemError::Folded { body, .. }
        | SystemError::Open { body }
        | SystemError::Region { body, .. }
        | SystemError::Flat { body, .. } => {
            let has_shape = described(*body).is_some_and(|described| described.shape.is_some());
            (*body, if has_shape { "shape" } else { "mesh" }.to_owned())
        }
        SystemError::HalfSpace(HalfSpaceError { half_space, what, .. }) => {
            return FieldError::new(format!("half-space.{half_space}.{what}"), error);
        }
        SystemError::Partly { body, .. } => (*body, String::new()),
        SystemError::Spring { spring, source } => {
            return FieldError::new(format!("spring.{spring}.{}", source.field), source);
        }
        SystemError::SpringEnd { spring, body, .. } => {
            return FieldError::new(format!("spring.{spring}.at"), named(description, error, *body));
        }
        _ => return FieldError::new("body", error),
    };
    // The path of the field has the number of the body already.
    let message = named(description, error, body);
    let short = message.strip_prefix(&format!("body {body}: "));
    FieldError::new(format!("body.{body}.{field}"), short.unwrap_or(&message))
}

/// The message of an error, with the name of a body in place of its number, if it has one. The number at the
/// beginning stays.
fn named(description: &Description, error: &SystemError, body: usize) -> String {
    let message = error.to_string();
    let name = description.body.get(body).map_or("", |body| body.name.as_str());
    match message.split_once(": ") {
        Some((start, rest)) if !name.is_empty() => {
            let named = rest.replace(&format!("body {body}"), &format!("body `{name}`"));
            format!("{start}: {named}")
        }
        _ => message,
    }
}

/// The error of a simulation, at the setting or at the second of two touching bodies.
pub(super) fn of_simulation(system: &System, error: &SimulationError) -> FieldError {
    let setting = match error {
        SimulationError::Start { primitives, near } => {
            let what = ["intersect or touch at the start", "a positive"];
            return of_start(system, *primitives, *near, what);
        }
        SimulationError::Close {
            primitives,
            near,
            thickness,
        } => {
            let what = format!("are within the sum of their offsets, {thickness} m, at the start");
            return of_start(system, *primitives, *near, [&what, "a larger"]);
        }
        SimulationError::Grounded {
            vertex,
            half_space,
            near,
        } => {
            let half_space = system.designation(system.body_vertices().len() + half_space);
            let message = format!(
                "a vertex at {near:?} touches {half_space} at the start, or is inside of it, \
                 expected a positive distance above the offset of the body"
            );
            return FieldError::new(format!("body.{}", system.body_of(*vertex)), message);
        }
        SimulationError::Setting(setting) => setting.field,
        SimulationError::UnknownBody { .. } => "friction.pair",
        SimulationError::ByVertex { .. } | SimulationError::AffineByVertex { .. } => "line-search",
        SimulationError::Method { .. } | SimulationError::Separation { .. } => "ccd",
        _ => "",
    };
    FieldError::new(format!("settings.{setting}"), error)
}

/// The error of two primitives that are too near, with the vertex indices of their bodies.
fn of_start(
    system: &System,
    primitives: [Primitive; 2],
    near: Point,
    [what, expected]: [&str; 2],
) -> FieldError {
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
    FieldError::new(format!("body.{b}"), message)
}
