//! The queries of a simulation as a data set.

mod recorder;

use std::fs;
use std::path::{Path, PathBuf};

use exact_ccd::{EdgeEdge, VertexFace};
use exact_ccd_compare::Subjects;
use exact_ccd_data::{DataKind, Record, Sample, Seventh};
use exact_ccd_sim::Simulation;
use serde::{Deserialize, Serialize};

use crate::commands::simulate::folder::log::Log;
use crate::commands::simulate::folder::steps;
use crate::files::outputs::make_folder;
use crate::messages::failure::Failure;
use crate::query_files::rows;
use recorder::Recording;

/// The table of the numbers of queries.
const COUNTS: &str = "counts.csv";

/// A folder with query files, a file for each time step and kind, and `counts.csv`.
pub(crate) struct QueryFolder {
    folder: PathBuf,
    recording: Recording,
    log: Log<Row>,
    total: Counts,
}

/// The numbers of queries of each kind, in the shape of the JSON object.
#[derive(Default, Serialize)]
pub(crate) struct Counts {
    pub(crate) vertex_face: Numbers,
    pub(crate) edge_edge: Numbers,
}

/// The numbers of queries of a kind: in total, in contact, and written.
#[derive(Default, Serialize)]
pub(crate) struct Numbers {
    pub(crate) total: usize,
    pub(crate) in_contact: usize,
    pub(crate) kept: usize,
}

impl Counts {
    fn add(&mut self, row: &Row) {
        let Self {
            vertex_face,
            edge_edge,
        } = self;
        vertex_face.add([row.vertex_face, row.vertex_face_in_contact, row.vertex_face_kept]);
        edge_edge.add([row.edge_edge, row.edge_edge_in_contact, row.edge_edge_kept]);
    }
}

impl Numbers {
    fn add(&mut self, [total, in_contact, kept]: [usize; 3]) {
        self.total += total;
        self.in_contact += in_contact;
        self.kept += kept;
    }
}

/// A row of `counts.csv`: the numbers of queries of a time step, and of the queries that were written.
#[derive(Serialize, Deserialize)]
struct Row {
    step: u64,
    vertex_face: usize,
    vertex_face_in_contact: usize,
    vertex_face_kept: usize,
    edge_edge: usize,
    edge_edge_in_contact: usize,
    edge_edge_kept: usize,
}

impl QueryFolder {
    /// Checks that a folder has no queries of an earlier run.
    pub(crate) fn check_is_new(folder: &Path) -> Result<(), Failure> {
        let is_empty =
            |kind: &str| fs::read_dir(folder.join(kind)).map_or(true, |mut files| files.next().is_none());
        if !folder.join(COUNTS).exists() && [VertexFace::FOLDER, EdgeEdge::FOLDER].into_iter().all(is_empty) {
            return Ok(());
        }
        Err(Failure::of(
            folder,
            "the folder has the queries of an earlier run: remove it, name another one, or replace the run and its \
             queries with --output and --overwrite",
        ))
    }

    /// Opens the folder for a simulation in its current state. Queries of later time steps are removed.
    pub(crate) fn open(
        folder: &Path,
        simulation: Simulation,
        most: usize,
    ) -> Result<(Simulation, Self), Failure> {
        let last = simulation.state().step;
        for kind in [VertexFace::FOLDER, EdgeEdge::FOLDER] {
            make_folder(&folder.join(kind))?;
            steps::remove_after(&folder.join(kind), Some(last))?;
        }
        let log = Log::resume(folder.join(COUNTS), last, |row: &Row| row.step)?;
        let mut total = Counts::default();
        log.rows()?.iter().for_each(|row| total.add(row));
        let (simulation, recording) = Recording::of(simulation, most)?;
        let this = Self {
            folder: folder.to_owned(),
            recording,
            log,
            total,
        };
        Ok((simulation, this))
    }

    /// Writes the queries of a time step.
    pub(crate) fn add(&mut self, step: u64) -> Result<(), Failure> {
        let samples = self.recording.take();
        let [vertex_face, edge_edge] = [
            self.write(step, &samples.vertex_face)?,
            self.write(step, &samples.edge_edge)?,
        ];
        let row = Row {
            step,
            vertex_face: vertex_face.total,
            vertex_face_in_contact: vertex_face.in_contact,
            vertex_face_kept: vertex_face.kept,
            edge_edge: edge_edge.total,
            edge_edge_in_contact: edge_edge.in_contact,
            edge_edge_kept: edge_edge.kept,
        };
        self.log.add(&row)?;
        self.total.add(&row);
        self.log.sync()
    }

    /// Writes a sample unless it is empty, and returns the counts.
    fn write<K: DataKind>(&self, step: u64, sample: &Subjects<K>) -> Result<Numbers, Failure> {
        let [free, colliding] = sample.population();
        let kept = sample.sample();
        if !kept.is_empty() {
            let file = self.folder.join(K::FOLDER).join(steps::name(step, "csv"));
            let records = kept.iter().map(|subject| {
                Ok(Record::from(Sample {
                    query: subject.query,
                    truth: Some(subject.collides),
                }))
            });
            rows::write(&file, Seventh::Contact, records)?;
        }
        Ok(Numbers {
            total: free + colliding,
            in_contact: colliding,
            kept: kept.len(),
        })
    }

    /// The numbers of queries of all time steps.
    pub(crate) fn total(&self) -> &Counts {
        &self.total
    }
}
