//! The published scenes.

use std::path::Path;

use exact_ccd_data::{DataError, DataFolder};
use exact_ccd_mesh::Motion;

/// The names and the motions of the scenes that the command line names, or of all.
pub(crate) fn motions() -> Result<Vec<(String, Motion)>, DataError> {
    let arguments = std::env::args().skip(1);
    let names: Vec<String> = arguments.filter(|argument| !argument.starts_with('-')).collect();
    let repository = Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../.."));
    let scenes = DataFolder::find(repository)?.scenes()?.into_iter();
    let wanted = scenes.filter(|scene| names.is_empty() || names.contains(&scene.name()));
    wanted.map(|scene| Ok((scene.name(), scene.motion()?))).collect()
}
