//! The springs of a scene, from the names of bodies.

use exact_ccd_sim::{Spring, SpringEnd};

use super::description::{Description, SpringDescription};
use super::field_error::FieldError;

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
