//! Scenes: one time step of a simulation, the queried pairs, and the ground truth about them.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use exact_ccd::{CONTACT, EdgeEdge, Kind, VertexFace};
use exact_ccd_files::read_motion;
use exact_ccd_mesh::{Motion, Step, TriangleMesh};

use crate::error::DataError;
use crate::json::{read_pairs, read_verdicts};
use crate::kind::DataKind;
use crate::list::list;
use crate::record::{Record, Sample, number};
use crate::roots::{Roots, read_roots};

/// A time step of a simulation in the folder of a scene.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct RecordedStep {
    folder: PathBuf,
    /// The frame at which the step starts, in a folder with more than two of them.
    start: Option<usize>,
}

impl RecordedStep {
    /// The step in a folder with two frames.
    #[must_use]
    pub fn new(folder: PathBuf) -> Self {
        Self { folder, start: None }
    }

    /// The steps from each frame in a folder to the next one.
    ///
    /// # Errors
    /// If there is no folder of frames.
    pub fn steps(folder: &Path) -> Result<Vec<Self>, DataError> {
        let frames = frames(folder)?.len();
        let step = |start| Self {
            folder: folder.to_owned(),
            start: (frames > 2).then_some(start),
        };
        Ok((0..frames.saturating_sub(1)).map(step).collect())
    }

    /// The name of the scene, with the number of the frame at which the step starts, if there are several.
    #[must_use]
    pub fn name(&self) -> String {
        let name = self.folder.file_name().unwrap_or_default().to_string_lossy();
        match self.number() {
            Some(number) => format!("{name} {number}"),
            None => name.into_owned(),
        }
    }

    /// The number in the name of the frame at which the step starts, in a folder with several steps.
    fn number(&self) -> Option<String> {
        let frame = frames(&self.folder).ok()?.into_iter().nth(self.start?)?;
        let stem = frame.file_stem()?.to_string_lossy().into_owned();
        let digits = stem.trim_start_matches(|c: char| !c.is_ascii_digit());
        Some(digits.to_owned())
    }

    /// The mesh files of the two times.
    ///
    /// # Errors
    /// If there are not two of them.
    pub fn frames(&self) -> Result<[PathBuf; 2], DataError> {
        let mut files = frames(&self.folder)?;
        if let Some(start) = self.start {
            files = files.into_iter().skip(start).take(2).collect();
        }
        files.try_into().map_err(|files: Vec<_>| DataError::Folder {
            folder: self.folder.join("frames"),
            expected: "two frames".to_owned(),
            found: files.len(),
        })
    }

    /// Returns true if there are files with the queried pairs and with verdicts on them, for both kinds.
    #[must_use]
    pub fn has_pairs(&self) -> bool {
        let has = |kind: &str| {
            self.file("boxes", kind, "json").is_ok()
                && self.file("mma_bool", &format!("{kind}_mma_bool"), "json").is_ok()
        };
        has(VertexFace::KIND.short()) && has(EdgeEdge::KIND.short())
    }

    /// The motion between the two frames.
    ///
    /// # Errors
    /// If a frame is missing or cannot be read.
    pub fn motion(&self) -> Result<Motion, DataError> {
        let [start, end] = self.frames()?;
        Ok(read_motion(&start, &end)?)
    }

    /// The queried pairs of a kind, as indices of the mesh: a vertex and a face, or two edges.
    ///
    /// # Errors
    /// If the file is missing or wrong.
    pub fn pairs<K: DataKind>(&self, mesh: &TriangleMesh) -> Result<Vec<[u32; 2]>, DataError> {
        read_pairs::<K>(&self.file("boxes", K::KIND.short(), "json")?, mesh)
    }

    /// The queries of a kind, rebuilt from the motion and the pairs, with the verdicts on them.
    ///
    /// # Errors
    /// If a file is missing or wrong, or if the numbers of pairs and of verdicts differ.
    pub fn samples<K: DataKind>(&self, step: &Step<'_>) -> Result<Vec<Sample<K>>, DataError> {
        let pairs = self.pairs::<K>(step.mesh())?;
        let verdict_file = self.file("mma_bool", &format!("{}_mma_bool", K::KIND.short()), "json")?;
        let verdicts = read_verdicts(&verdict_file)?;
        if verdicts.len() != pairs.len() {
            return Err(DataError::VerdictCount {
                file: verdict_file,
                expected: pairs.len(),
                found: verdicts.len(),
            });
        }
        let sample = |(indices, truth)| {
            let query = step.query(indices)?;
            Some(Sample {
                query,
                truth: Some(truth),
            })
        };
        Ok(pairs.into_iter().zip(verdicts).filter_map(sample).collect())
    }

    /// The queries of [`samples`](Self::samples) with all data of the scene: its name, the ids of
    /// the pair, and, if they were published, the count and the time of impact.
    ///
    /// The published count of an interval of contact is 1. Here it is −1, computed by the exact
    /// method.
    ///
    /// # Errors
    /// As [`samples`](Self::samples), and if the file with the contact times is wrong.
    pub fn records<K: DataKind>(&self, step: &Step<'_>) -> Result<Vec<Record<K>>, DataError> {
        let name: Arc<str> = self.name().into();
        let pairs = self.pairs::<K>(step.mesh())?;
        let record = |(sample, indices)| Record {
            scene: Some(name.clone()),
            ids: Some(K::ids(indices, step.mesh())),
            ..Record::from(sample)
        };
        let mut records: Vec<_> = self.samples(step)?.into_iter().zip(pairs).map(record).collect();
        if let Some(file) = self.roots::<K>()? {
            for record in &mut records {
                record.count = (record.sample.truth == Some(false)).then_some(0);
            }
            let queries = records.len();
            for Roots {
                query, count, toi, ..
            } in read_roots(&file)?
            {
                let record = records.get_mut(query).ok_or_else(|| DataError::NoQuery {
                    file: file.clone(),
                    query,
                    queries,
                })?;
                let is_interval = || record.sample.query.intervals(CONTACT).count().is_none();
                record.count = Some(number(Some(count).filter(|&count| count != 1 || !is_interval())));
                record.toi = Some(toi);
            }
        }
        Ok(records)
    }

    /// The file with the same queries as coordinates, if it was published.
    ///
    /// # Errors
    /// If the folder cannot be read or has more than one such file.
    pub fn queries<K: DataKind>(&self) -> Result<Option<PathBuf>, DataError> {
        self.optional_file("queries", K::KIND.short(), "csv")
    }

    /// The file with the contact times of the colliding queries, if it was published.
    ///
    /// # Errors
    /// If the folder cannot be read or has more than one such file.
    pub fn roots<K: DataKind>(&self) -> Result<Option<PathBuf>, DataError> {
        self.optional_file("roots", K::KIND.short(), "csv")
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

    /// The only file in a folder whose name has this ending and extension.
    fn file(&self, folder: &str, ending: &str, extension: &str) -> Result<PathBuf, DataError> {
        let folder = self.folder.join(folder);
        let number = self.number();
        let name = format!("{}{ending}.{extension}", number.as_deref().unwrap_or_default());
        let named = |file: &PathBuf| {
            let file = file.file_name().unwrap_or_default().to_string_lossy();
            file.strip_suffix(&name)
                .is_some_and(|rest| number.is_none() || !rest.ends_with(|c: char| c.is_ascii_digit()))
        };
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

/// The mesh files in the folder of a scene, in the order of time.
fn frames(folder: &Path) -> Result<Vec<PathBuf>, DataError> {
    let mut files = list(&folder.join("frames"))?;
    // Frame 99 comes before frame 100.
    files.sort_by_key(|file| (file.as_os_str().len(), file.clone()));
    Ok(files)
}
