//! Scenes of this program and of others.

use std::path::Path;

use exact_ccd_scene::{FilterByName, Scene, SceneError};

use crate::{ImportError, Imported, Note, import};

/// An error in a scene of this program or of another one.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum ReadError {
    /// A scene of another program cannot be imported.
    #[error(transparent)]
    Import(#[from] ImportError),
    /// A value of the scene, or of the TOML file of an imported one, is missing or invalid.
    #[error(transparent)]
    Scene(#[from] SceneError),
}

/// Reads a scene file as [`Scene::read`], or one of another program as of [`import`], with notes on its
/// entries that are ignored.
///
/// # Errors
/// [`ReadError`] names the file and the place.
pub fn read(
    file: impl AsRef<Path>,
    meshes: Option<&Path>,
    filter_by_name: &FilterByName<'_>,
) -> Result<(Scene, Vec<Note>), ReadError> {
    let file = file.as_ref();
    let Some(Imported { toml, meshes, notes }) = import(file, meshes)? else {
        return Ok((Scene::read(file, meshes, filter_by_name)?, Vec::new()));
    };
    let mut label = file.as_os_str().to_owned();
    label.push(" as TOML");
    let scene = Scene::parse(&toml, Path::new(&label), Some(&meshes), filter_by_name)?;
    Ok((scene, notes))
}
