//! Scenes: one time step of a simulation, the pairs that were queried, and what is known about them.

use std::path::PathBuf;

use ccd_mesh::{Motion, Step, TriangleMesh};

use crate::data_folder::list;
use crate::error::DataError;
use crate::json::{read_pairs, read_verdicts};
use crate::kind::DataKind;
use crate::queries::Sample;

/// The folder of a scene.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Scene {
    folder: PathBuf,
}

impl Scene {
    /// The scene in a folder.
    #[must_use]
    pub fn new(folder: PathBuf) -> Self {
        Self { folder }
    }

    /// The name of the scene.
    #[must_use]
    pub fn name(&self) -> String {
        self.folder
            .file_name()
            .unwrap_or_default()
            .to_string_lossy()
            .into_owned()
    }

    /// The mesh files of the two times.
    ///
    /// # Errors
    /// If there are not two of them.
    pub fn frames(&self) -> Result<[PathBuf; 2], DataError> {
        let folder = self.folder.join("frames");
        let mut files = list(&folder)?;
        // Frame 99 comes before frame 100.
        files.sort_by_key(|file| (file.as_os_str().len(), file.clone()));
        files.try_into().map_err(|files: Vec<_>| DataError::Folder {
            folder,
            expected: "two frames".to_owned(),
            found: files.len(),
        })
    }

    /// The motion between the two frames.
    ///
    /// # Errors
    /// If a frame is missing or cannot be read.
    pub fn motion(&self) -> Result<Motion, DataError> {
        let [start, end] = self.frames()?;
        Ok(Motion::read(&start, &end)?)
    }

    /// The pairs of a kind that were queried, as indices of the mesh: a vertex and a face, or two edges.
    ///
    /// # Errors
    /// If the file is missing or wrong.
    pub fn pairs<K: DataKind>(&self, mesh: &TriangleMesh) -> Result<Vec<[u32; 2]>, DataError> {
        read_pairs::<K>(&self.file("boxes", K::SHORT, "json")?, mesh)
    }

    /// The queries of a kind, rebuilt from the motion and the pairs, with the verdicts on them.
    ///
    /// # Errors
    /// If a file is missing or wrong, or if there are more pairs or fewer than verdicts.
    pub fn samples<K: DataKind>(&self, step: &Step<'_>) -> Result<Vec<Sample<K>>, DataError> {
        let pairs = self.pairs::<K>(step.mesh())?;
        let verdict_file = self.file("mma_bool", &format!("{}_mma_bool", K::SHORT), "json")?;
        let verdicts = read_verdicts(&verdict_file)?;
        if verdicts.len() != pairs.len() {
            return Err(DataError::VerdictCount {
                file: verdict_file,
                expected: pairs.len(),
                found: verdicts.len(),
            });
        }
        let sample = |(indices, truth)| Sample {
            query: K::query(step, indices),
            truth: Some(truth),
        };
        Ok(pairs.into_iter().zip(verdicts).map(sample).collect())
    }

    /// The file with the same queries as coordinates, if it was published.
    ///
    /// # Errors
    /// If the folder cannot be read or has more than one such file.
    pub fn queries<K: DataKind>(&self) -> Result<Option<PathBuf>, DataError> {
        self.optional_file("queries", K::SHORT, "csv")
    }

    /// The file with the contact times of the colliding queries, if it was published.
    ///
    /// # Errors
    /// If the folder cannot be read or has more than one such file.
    pub fn roots<K: DataKind>(&self) -> Result<Option<PathBuf>, DataError> {
        self.optional_file("roots", K::SHORT, "csv")
    }

    fn optional_file(
        &self,
        folder: &str,
        ending: &str,
        extension: &str,
    ) -> Result<Option<PathBuf>, DataError> {
        if self.folder.join(folder).exists() {
            self.file(folder, ending, extension).map(Some)
        } else {
            Ok(None)
        }
    }

    /// The only file in a folder whose name ends like this.
    fn file(&self, folder: &str, ending: &str, extension: &str) -> Result<PathBuf, DataError> {
        let folder = self.folder.join(folder);
        let name = format!("{ending}.{extension}");
        let named = |file: &PathBuf| file.to_string_lossy().ends_with(&name);
        let files: Vec<_> = list(&folder)?.into_iter().filter(named).collect();
        <[PathBuf; 1]>::try_from(files)
            .map(|[file]| file)
            .map_err(|files| DataError::Folder {
                folder,
                expected: format!("one file *{name}"),
                found: files.len(),
            })
    }
}
