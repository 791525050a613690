//! A description as a TOML file.

use std::path::Path;

use super::fault::{Fault, Place, Problem};
use crate::description::Description;

/// The TOML file of a description that comes from a scene file of another program.
pub(super) fn toml(description: &Description, program: &str, file: &Path) -> Result<String, Fault> {
    let text = toml::to_string(description).map_err(|error| Fault {
        place: Place::Pointer(String::new()),
        problem: Problem::File(error.to_string()),
    })?;
    let name = file.file_name().unwrap_or_default().to_string_lossy();
    let name: String = name.chars().filter(|character| !character.is_control()).collect();
    Ok(format!("# Imported from {name}, a scene of {program}.\n{text}"))
}
