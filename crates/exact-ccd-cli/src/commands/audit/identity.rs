//! The identity of an audit: two processes with one identity have the same results.

use std::path::PathBuf;

use serde::Serialize;

use super::arguments::Arguments;
use crate::assembly::Assembly;
use crate::messages::failure::Failure;

/// The first line of a file of results. The version of the program is in it, as another one may describe a
/// violation in another way.
#[derive(Serialize)]
struct Identity {
    /// The version of the format of results.
    results: u32,
    program: &'static str,
    frames: usize,
    /// The hash of the names, sizes and times of change of the files.
    files: String,
    /// The options on which results depend, as text.
    options: String,
}

/// The identity of an audit, on one line.
pub(super) fn identity(arguments: &Arguments, scene: &Assembly) -> Result<String, Failure> {
    let mesh = &arguments.mesh;
    let inputs: Vec<PathBuf> = mesh.scene.inputs(&arguments.frames);
    let (options, half_spaces, distance) = (&mesh.scene, &mesh.half_spaces, mesh.min_distance.get());
    let all = mesh.all.is_some();
    let identity = Identity {
        results: 1,
        program: env!("CARGO_PKG_VERSION"),
        frames: scene.frame_count(),
        files: scene.identity(inputs.iter().map(PathBuf::as_path))?,
        options: format!("{options:?} {half_spaces:?} distance: {distance:?} all: {all}"),
    };
    Ok(serde_json::to_string(&identity)?)
}
