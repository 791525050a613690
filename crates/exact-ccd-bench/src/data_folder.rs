//! The folder of published data sets.

use std::path::{Path, PathBuf};
use std::{fs, io};

use crate::error::DataError;
use crate::kind::DataKind;
use crate::location;
use crate::scene::Scene;

/// The folder of published data sets: handcrafted queries and simulated scenes.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct DataFolder(PathBuf);

impl DataFolder {
    /// The data in a folder.
    #[must_use]
    pub fn new(folder: PathBuf) -> Self {
        Self(folder)
    }

    /// The folder that the environment variable `EXACT_CCD_DATA` names, or else `../shared/data` as seen from the root
    /// of the repository.
    ///
    /// # Errors
    /// If there is no such folder.
    pub fn find(repository: &Path) -> Result<Self, DataError> {
        let folder = location::data_folder(repository);
        list(&folder).map(|_| Self(folder))
    }

    /// All files of handcrafted queries of a kind.
    ///
    /// # Errors
    /// If a folder cannot be read.
    pub fn handcrafted<K: DataKind>(&self) -> Result<Vec<PathBuf>, DataError> {
        let mut files = Vec::new();
        for scene in list(&self.0.join("handcrafted"))? {
            files.extend(list(&scene.join(K::FOLDER))?);
        }
        files.retain(|file| file.extension().is_some_and(|extension| extension == "csv"));
        Ok(files)
    }

    /// All meshes, of bodies at rest.
    ///
    /// # Errors
    /// If the folder cannot be read.
    pub fn meshes(&self) -> Result<Vec<PathBuf>, DataError> {
        list(&self.0.join("meshes"))
    }

    /// All files of queries with the times within a distance.
    ///
    /// # Errors
    /// If the folder cannot be read.
    pub fn separation(&self) -> Result<Vec<PathBuf>, DataError> {
        list(&self.0.join("separation"))
    }

    /// All scenes.
    ///
    /// # Errors
    /// If the folder cannot be read.
    pub fn scenes(&self) -> Result<Vec<Scene>, DataError> {
        Ok(list(&self.0.join("scenes"))?
            .into_iter()
            .map(Scene::new)
            .collect())
    }
}

/// What is in a folder, sorted by name.
pub(crate) fn list(folder: &Path) -> Result<Vec<PathBuf>, DataError> {
    let error = |source| DataError::io(folder, source);
    let entries = fs::read_dir(folder).map_err(error)?;
    let path = |entry: io::Result<fs::DirEntry>| entry.map(|entry| entry.path()).map_err(error);
    let mut paths = entries.map(path).collect::<Result<Vec<_>, _>>()?;
    paths.sort();
    Ok(paths)
}
