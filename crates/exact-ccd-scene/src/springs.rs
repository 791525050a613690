//! Springs as tables of a scene file, `[[spring]]`.

use exact_ccd_mesh::Point;
use exact_ccd_sim::{Spring, SpringEnd};
use serde::{Deserialize, Serialize};

use super::description::Description;
use super::field_error::FieldError;

/// A spring between two bodies, or a body and a place.
#[derive(Clone, Debug, Serialize, Deserialize)]
#[serde(deny_unknown_fields, rename_all = "kebab-case")]
pub(super) struct SpringDescription {
    /// The names of two bodies, or of one, which a place that never moves holds.
    pub(super) between: Vec<String>,
    /// The positions of both ends at the start, or one for both.
    pub(super) at: Vec<Point>,
    /// The stiffness, in N/m.
    pub(super) stiffness: f64,
    /// The length without forces, in m. If not given, it is that at the start.
    pub(super) length: Option<f64>,
}

/// The springs of a scene.
pub(super) fn springs(description: &Description) -> Result<Vec<Spring>, FieldError> {
    let numbered = description.spring.iter().enumerate();
    numbered
        .map(|(number, described)| {
            spring(description, described).map_err(|error| error.below(&format!("spring.{number}")))
        })
        .collect()
}

fn spring(description: &Description, described: &SpringDescription) -> Result<Spring, FieldError> {
    let ends = match described.at[..] {
        [both] => [both; 2],
        [first, second] => [first, second],
        _ => {
            let message = format!("found {} positions, expected one or two", described.at.len());
            return Err(FieldError::new("at", message));
        }
    };
    let bodies = match &described.between[..] {
        [one] => [Some(body(description, one)?), None],
        [one, other] => [Some(body(description, one)?), Some(body(description, other)?)],
        names => {
            let message = format!("found {} names, expected those of one or two bodies", names.len());
            return Err(FieldError::new("between", message));
        }
    };
    let [a, b] = [0, 1].map(|end: usize| SpringEnd {
        body: bodies[end],
        at: ends[end],
    });
    Ok(Spring {
        ends: [a, b],
        stiffness: described.stiffness,
        length: described.length,
    })
}

/// The place of the only body with a name.
fn body(description: &Description, name: &str) -> Result<usize, FieldError> {
    let mut places = (0..).zip(&description.body).filter(|(_, body)| body.name == name);
    match (places.next(), places.next()) {
        (Some((place, _)), None) => Ok(place),
        (None, _) => Err(format!(
            "no body has the name `{name}`, expected the name of one body"
        )),
        (Some(_), Some(_)) => Err(format!(
            "several bodies have the name `{name}`, expected that of one body"
        )),
    }
    .map_err(|message| FieldError::new("between", message))
}
