//! The data sets in a folder.

use std::fs;
use std::path::{Path, PathBuf};

use exact_ccd::{EdgeEdge, VertexFace};
use exact_ccd_data::{DataError, DataKind, RecordedStep, Rounding, Sample, Seventh, is_parquet, list, open};
use exact_ccd_mesh::{BoxKind, Bvh, CandidateOptions, Candidates};
use exact_ccd_methods::parity::Rounded;

use crate::sampling::{Subject, Subjects};

/// A data set in a folder, before it is read.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Source {
    name: String,
    queries: Queries,
}

#[derive(Clone, Debug, PartialEq, Eq)]
enum Queries {
    /// The query files in some folders, as they are or with each query shifted and rounded by itself.
    Files { folders: Vec<PathBuf>, rounded: bool },
    /// The queried pairs of a scene, with verdicts.
    Pairs(RecordedStep),
    /// The candidates of the broad phase in a scene.
    Candidates(RecordedStep),
}

/// The depth of the search for data sets below the folder.
const DEPTH: usize = 3;

impl Source {
    /// All data sets in a folder, or in folders inside of it.
    ///
    /// Folders with query files, .csv or .parquet, in `edge-edge` or `vertex-face` are two data
    /// sets: as they are, and rounded. Such folders side by side are taken together. Scenes, which
    /// have a folder `frames`, are up to two data sets: the queried pairs, and the candidates of
    /// the broad phase.
    ///
    /// # Errors
    /// If a folder cannot be read.
    pub fn all(folder: &Path) -> Result<Vec<Self>, DataError> {
        let mut sources = Vec::new();
        collect(folder, DEPTH, &mut sources)?;
        for index in 1..sources.len() {
            let (earlier, [source, ..]) = sources.split_at_mut(index) else {
                break;
            };
            let name = source.name.clone();
            let is_taken = |name: &str| earlier.iter().any(|other| other.name == name);
            let mut number = 2;
            while is_taken(&source.name) {
                source.name = format!("{name} ({number})");
                number += 1;
            }
        }
        Ok(sources)
    }

    /// The name in tables, different from the names of the other data sets.
    #[must_use]
    pub fn name(&self) -> &str {
        &self.name
    }

    /// Reads the queries of a kind, and keeps a random sample: up to `most` queries that collide, and as
    /// many that do not. The exact method replaces ground truth that is missing.
    ///
    /// # Errors
    /// If a file is missing or wrong.
    pub fn read<K: DataKind>(&self, most: usize) -> Result<Subjects<K>, DataError> {
        let mut subjects = Subjects::new(most);
        match &self.queries {
            Queries::Files { folders, rounded } => {
                for folder in folders.iter().map(|folder| folder.join(K::FOLDER)) {
                    for file in query_files(&folder)? {
                        for record in open::<K>(&file, Rounding::Refuse, Seventh::Contact)? {
                            let Sample { query, truth } = record?.sample;
                            if !rounded {
                                subjects.add(Subject::new(query, truth));
                            } else if let Ok(rounded) = Rounded::shift(&query) {
                                // A query that cannot be rounded is left out.
                                subjects.add(Subject::new(*rounded.query(), None));
                            }
                        }
                    }
                }
            }
            Queries::Pairs(scene) => {
                let motion = scene.motion()?;
                for sample in scene.samples::<K>(&motion.step()?)? {
                    subjects.add(Subject::new(sample.query, sample.truth));
                }
            }
            Queries::Candidates(scene) => {
                let motion = scene.motion()?;
                let step = motion.step()?;
                // As other software has them.
                let options = CandidateOptions::default().with_boxes(BoxKind::Swept);
                let candidates = Candidates::with_options(step, &Bvh, &options);
                let candidates = candidates.expect("the default distances are 0");
                let pairs = candidates.of_kind(K::KIND).iter();
                for query in pairs.filter_map(|&pair| step.query(pair)) {
                    subjects.add(Subject::new(query, None));
                }
            }
        }
        Ok(subjects)
    }
}

fn collect(folder: &Path, depth: usize, sources: &mut Vec<Source>) -> Result<(), DataError> {
    if folder.join("frames").is_dir() {
        let folder = fs::canonicalize(folder).map_err(|source| DataError::Io {
            file: folder.to_owned(),
            source,
        })?;
        for scene in RecordedStep::steps(&folder)? {
            let name = scene.name();
            if scene.has_pairs() {
                sources.push(Source {
                    name: format!("{name}, queried pairs"),
                    queries: Queries::Pairs(scene.clone()),
                });
            }
            sources.push(Source {
                name: format!("{name}, candidates"),
                queries: Queries::Candidates(scene),
            });
        }
        return Ok(());
    }
    if has_query_files(folder) {
        sources.extend(query_sources(folder, vec![folder.to_owned()]));
        return Ok(());
    }
    let inner: Vec<PathBuf> = list(folder)?.into_iter().filter(|path| path.is_dir()).collect();
    let (folders, others): (Vec<_>, Vec<_>) = inner.into_iter().partition(|path| has_query_files(path));
    if !folders.is_empty() {
        sources.extend(query_sources(folder, folders));
    }
    if depth > 0 {
        for other in others {
            collect(&other, depth - 1, sources)?;
        }
    }
    Ok(())
}

/// The query files in some folders, as they are and rounded.
fn query_sources(parent: &Path, folders: Vec<PathBuf>) -> [Source; 2] {
    let name = name_of(parent);
    [(false, name.clone()), (true, format!("{name}, rounded"))].map(|(rounded, name)| Source {
        name,
        queries: Queries::Files {
            folders: folders.clone(),
            rounded,
        },
    })
}

fn has_query_files(folder: &Path) -> bool {
    [VertexFace::FOLDER, EdgeEdge::FOLDER]
        .iter()
        .any(|kind| folder.join(kind).is_dir())
}

/// The files in a folder of queries, none if there is no such folder.
fn query_files(folder: &Path) -> Result<Vec<PathBuf>, DataError> {
    if !folder.is_dir() {
        return Ok(Vec::new());
    }
    let mut files = list(folder)?;
    files.retain(|file| is_parquet(file) || file.extension().is_some_and(|extension| extension == "csv"));
    Ok(files)
}

fn name_of(folder: &Path) -> String {
    let folder = fs::canonicalize(folder).unwrap_or_else(|_| folder.to_owned());
    folder
        .file_name()
        .map_or("queries".to_owned(), |name| name.to_string_lossy().into_owned())
}
