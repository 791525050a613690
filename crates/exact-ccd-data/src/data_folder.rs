//! The folder of published data sets.

use std::env;
use std::path::{Path, PathBuf};

use exact_ccd::Kind;

use crate::error::DataError;
use crate::kind::DataKind;
use crate::list::list;
use crate::recorded_step::RecordedStep;
use crate::separation::SeparationFile;

/// The environment variable that names the folder.
const VARIABLE: &str = "EXACT_CCD_DATA";

/// The folder without the variable, relative to the root of the repository.
const DEFAULT: &str = "../shared/data";

/// The folder of published data sets: handcrafted queries, simulated scenes, times within a distance.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct DataFolder(PathBuf);

impl DataFolder {
    /// The data in a folder.
    #[must_use]
    pub fn new(folder: PathBuf) -> Self {
        Self(folder)
    }

    /// The folder that the environment variable `EXACT_CCD_DATA` names, or else `../shared/data` as
    /// seen from the root of the repository.
    ///
    /// # Errors
    /// If the folder does not exist.
    pub fn find(repository: &Path) -> Result<Self, DataError> {
        let folder = env::var_os(VARIABLE).map_or_else(|| repository.join(DEFAULT), PathBuf::from);
        list(&folder).map(|_| Self(folder))
    }

    /// All files of handcrafted queries of a kind, sorted by scene and name.
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

    /// All mesh files of bodies at rest.
    ///
    /// # Errors
    /// If the folder cannot be read.
    pub fn meshes(&self) -> Result<Vec<PathBuf>, DataError> {
        list(&self.0.join("meshes"))
    }

    /// All files of queries of a kind with the times within a distance, sorted by name.
    ///
    /// # Errors
    /// If the folder cannot be read.
    pub fn separation<K: Kind>(&self) -> Result<Vec<SeparationFile>, DataError> {
        let files = list(&self.0.join("separation"))?;
        Ok(files
            .into_iter()
            .filter_map(SeparationFile::of_kind::<K>)
            .collect())
    }

    /// All files of queries of curved motion, one a line, sorted by name.
    ///
    /// # Errors
    /// If the folder cannot be read.
    pub fn nonlinear(&self) -> Result<Vec<PathBuf>, DataError> {
        list(&self.0.join("nonlinear"))
    }

    /// The files of a simulation in which a shell is thrown through its centre: arrays of queries, `ee.npy`
    /// and `vf.npy`.
    ///
    /// # Errors
    /// If the folder cannot be read.
    pub fn implosion(&self) -> Result<Vec<PathBuf>, DataError> {
        list(&self.0.join("implosion"))
    }

    /// All scenes.
    ///
    /// # Errors
    /// If the folder cannot be read.
    pub fn scenes(&self) -> Result<Vec<RecordedStep>, DataError> {
        Ok(list(&self.0.join("scenes"))?
            .into_iter()
            .map(RecordedStep::new)
            .collect())
    }
}
