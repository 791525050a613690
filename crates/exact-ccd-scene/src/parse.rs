//! From the text of a scene file to its contents.

use toml::de::{DeTable, DeValue};

use super::description::Description;
use super::document::{Document, SceneError};
use super::field_error::FieldError;

/// The contents of a scene file.
pub(super) fn parse(document: &Document<'_>) -> Result<Description, SceneError> {
    if let Some(path) = table_for_array(document.text) {
        let keys = path.split('.').filter(|key| key.parse::<usize>().is_err());
        let name = keys.collect::<Vec<_>>().join(".");
        let message = format!("found the table `[{name}]`, expected an array of tables: write `[[{name}]]`");
        return Err(document.error_of(FieldError::new(path, message)));
    }
    toml::from_str(document.text).map_err(|error| {
        let message = error.message();
        match error.span() {
            Some(span) => document.error_at(span.start, |field| readable(message, field)),
            None => document.error_of(FieldError::new("", readable(message, ""))),
        }
    })
}

/// The path of `[body]`, or of one of its tables as `[body.script]`, in single brackets, if there is one.
fn table_for_array(text: &str) -> Option<String> {
    let table = DeTable::parse(text).ok()?;
    let bodies = match table.get_ref().get("body")?.get_ref() {
        DeValue::Table(_) => return Some("body".to_owned()),
        bodies => bodies.as_array()?,
    };
    bodies.iter().enumerate().find_map(|(index, body)| {
        let body = body.get_ref().as_table()?;
        let is_single = |name: &&str| body.get(*name).is_some_and(|value| value.get_ref().is_table());
        let single = ["script", "load", "region"].into_iter().find(is_single)?;
        Some(format!("body.{index}.{single}"))
    })
}

/// Numeric types in messages of the TOML parser, with their names for users.
const NUMBERS: [(&str, &str); 4] = [
    ("expected usize", "expected an integer not below 0"),
    ("expected u16", "expected an integer from 0 to 65535"),
    ("expected u8", "expected an integer from 0 to 255"),
    ("expected f64", "expected a number"),
];

/// The message of the TOML parser for a field, in terms of the scene file.
fn readable(message: &str, field: &str) -> String {
    if message.starts_with("wanted string or table") {
        let expected = match field.rsplit('.').next() {
            Some("contact-distance" | "tolerance" | "static-velocity") => {
                "expected a length, `{ absolute = METERS }` or `{ relative = FRACTION }`"
            }
            _ => "expected a string or a table",
        };
        return expected.to_owned();
    }
    let number = NUMBERS.into_iter().find_map(|(from, to)| {
        let start = message.strip_suffix(from)?;
        Some(format!("{start}{to}"))
    });
    number.unwrap_or_else(|| message.to_owned())
}
