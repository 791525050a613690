//! From the text of a scene file to its contents.

use serde::Deserialize;
use toml::de::{DeTable, Deserializer};

use super::description::Description;
use super::document::{Document, SceneError};
use super::field_error::FieldError;

/// The contents of a scene file.
pub(super) fn parse(document: &Document<'_>) -> Result<Description, SceneError> {
    let error = |error: toml::de::Error| {
        let message = error.message();
        match error.span() {
            Some(span) => document.error_at(span.start, |field| readable(message, field)),
            None => document.error_of(FieldError::new("", readable(message, ""))),
        }
    };
    let table = DeTable::parse(document.text).map_err(error)?;
    if let Some(path) = table_for_array(table.get_ref()) {
        let keys = path.split('.').filter(|key| key.parse::<usize>().is_err());
        let name = keys.collect::<Vec<_>>().join(".");
        let message = format!("found the table `[{name}]`, expected an array of tables: write `[[{name}]]`");
        return Err(document.error_of(FieldError::new(path, message)));
    }
    Description::deserialize(Deserializer::from(table)).map_err(error)
}

/// The path of the first table in single brackets, as `[body]`, where an array of tables is expected, if
/// there is one.
fn table_for_array(root: &DeTable<'_>) -> Option<String> {
    let single = |table: &DeTable<'_>, names: &[&str]| {
        let is_table = |name: &&&str| table.get(**name).is_some_and(|value| value.get_ref().is_table());
        names.iter().find(is_table).map(|name| (*name).to_owned())
    };
    if let Some(name) = single(root, &["body", "half-space", "spring"]) {
        return Some(name);
    }
    let friction = root
        .get("settings")
        .and_then(|settings| settings.get_ref().get("friction"));
    let friction = friction.and_then(|friction| friction.get_ref().as_table());
    if let Some(name) = friction.and_then(|friction| single(friction, &["pair"])) {
        return Some(format!("settings.friction.{name}"));
    }
    let bodies = root.get("body")?.get_ref().as_array()?;
    bodies.iter().enumerate().find_map(|(index, body)| {
        let body = body.get_ref().as_table()?;
        let name = single(body, &["script", "load", "region"])?;
        Some(format!("body.{index}.{name}"))
    })
}

/// Numeric types in messages of the TOML parser, with their names for users.
const NUMBERS: [(&str, &str); 5] = [
    ("expected usize", "expected an integer not below 0"),
    ("expected u32", "expected an integer from 0 to 4294967295"),
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
    if let Some((start, _)) = message.split_once("expected struct ") {
        return format!("{start}expected a table");
    }
    let number = NUMBERS.into_iter().find_map(|(from, to)| {
        let start = message.strip_suffix(from)?;
        Some(format!("{start}{to}"))
    });
    number.unwrap_or_else(|| message.to_owned())
}
