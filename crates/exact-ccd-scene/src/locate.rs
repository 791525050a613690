//! The fields of a scene file to which errors of systems and simulations belong.

use exact_ccd_sim::{BodyError, Selecting, SimulationError, SpringError, SystemError};

use super::description::{BodyDescription, Description};
use super::field_error::FieldError;

/// The error of a system, at its field. The path of the field names the body, the half space or the spring.
pub(super) fn of_system(description: &Description, error: &SystemError) -> FieldError {
    match error {
        SystemError::Body { body, source } => {
            let path = format!("body.{}", body.place());
            of_body(description, body.place(), source).below(&path)
        }
        SystemError::HalfSpace { half_space, source } => {
            let path = format!("half-space.{}.{}", half_space.place(), source.what);
            FieldError::new(path, source)
        }
        SystemError::Spring { spring, source } => {
            let field = match source {
                SpringError::Parameter(source) => source.field,
                SpringError::Body { .. } => "between",
                _ => "at",
            };
            FieldError::new(format!("spring.{spring}.{field}"), source)
        }
        _ => FieldError::new("body", error),
    }
}

/// The error of a body, at a field of the body.
fn of_body(description: &Description, place: usize, error: &BodyError) -> FieldError {
    let described = description.body.get(place);
    let material = described.map_or("solid", BodyDescription::material);
    let field = match error {
        BodyError::Parameter(source) => {
            let is_of_body = ["velocity", "angular-velocity", "offset"].contains(&source.field);
            let table = if is_of_body { "" } else { material };
            format!("{table}.{}", source.field)
        }
        BodyError::Material { region, source } => {
            return FieldError::new(format!("region.{region}.solid.{}", source.field), source);
        }
        BodyError::Mass { .. } => format!("{material}.density"),
        BodyError::Partly {
            what,
            found,
            expected,
        } => {
            let before = || description.body.iter().take(place);
            let (key, own) = match what {
                Selecting::Script(number) => {
                    let others: usize = before().map(|body| body.script.len()).sum();
                    ("script", number.saturating_sub(others))
                }
                Selecting::Load(number) => {
                    let others: usize = before().map(|body| body.load.len()).sum();
                    ("load", number.saturating_sub(others))
                }
            };
            let message = format!(
                "{found} of the {expected} vertices are selected, expected none or all: \
                 an affine body moves as a whole"
            );
            return FieldError::new(format!("{key}.{own}.vertices"), message);
        }
        // The points of a mesh are finite: the placement overflows.
        BodyError::NotFinite { .. } => String::new(),
        _ if described.is_some_and(|described| described.shape.is_some()) => "shape".to_owned(),
        _ => "mesh".to_owned(),
    };
    FieldError::new(field, error)
}

/// The error of a simulation, at the setting or at the second of two touching bodies.
pub(super) fn of_simulation(error: &SimulationError) -> FieldError {
    let setting = match error {
        SimulationError::Start { primitives, .. } | SimulationError::Close { primitives, .. } => {
            return FieldError::new(format!("body.{}", primitives[1].body.place()), error);
        }
        SimulationError::Grounded { vertex, .. } => {
            return FieldError::new(format!("body.{}", vertex.body.place()), error);
        }
        SimulationError::FrictionPair { pair, source } => {
            return FieldError::new(format!("settings.friction.pair.{pair}.{}", source.field), source);
        }
        SimulationError::Setting(setting) => setting.field,
        SimulationError::ByVertex { .. } | SimulationError::AffineByVertex { .. } => "line-search",
        SimulationError::Method { .. } | SimulationError::Offset { .. } => "ccd",
        _ => "",
    };
    FieldError::new(format!("settings.{setting}"), error)
}
