//! The queries of a simulation as a data set.

use std::path::{Path, PathBuf};

use exact_ccd::{EdgeEdge, VertexFace};
use exact_ccd_compare::Subjects;
use exact_ccd_data::{DataKind, Record, Sample, Seventh};
use exact_ccd_sim::Simulation;
use serde::{Deserialize, Serialize};

use super::log::{self, Log};
use super::recorder::Recording;
use super::steps;
use crate::failure::Failure;
use crate::output::make_folder;
use crate::queries::query_files;

/// A folder with query files, a file for each time step and kind, and `counts.csv`.
pub(super) struct QueryFolder {
    folder: PathBuf,
    recording: Recording,
    log: Log<Row>,
    total: Counts<[usize; 3]>,
}

/// For each kind: the numbers of queries, of queries in contact, and of queries written.
#[derive(Default)]
pub(super) struct Counts<T> {
    pub(super) vertex_face: T,
    pub(super) edge_edge: T,
}

/// A row of `counts.csv`: the queries of a time step, and those of them that were written.
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

impl log::Row for Row {
    fn step(&self) -> u64 {
        self.step
    }
}

impl QueryFolder {
    /// Opens the folder for a simulation in its current state. Queries of later time steps are removed.
    pub(super) fn open(
        folder: &Path,
        simulation: Simulation,
        most: usize,
    ) -> Result<(Simulation, Self), Failure> {
        let last = simulation.state().step;
        for kind in [VertexFace::FOLDER, EdgeEdge::FOLDER] {
            make_folder(&folder.join(kind))?;
            steps::remove_after(&folder.join(kind), Some(last))?;
        }
        let log = Log::resume(folder.join("counts.csv"), last)?;
        let (simulation, recording) = Recording::of(simulation, most)?;
        let this = Self {
            folder: folder.to_owned(),
            recording,
            log,
            total: Counts::default(),
        };
        Ok((simulation, this))
    }

    /// Writes the queries of a time step.
    pub(super) fn add(&mut self, step: u64) -> Result<(), Failure> {
        let samples = self.recording.take();
        let counts = Counts {
            vertex_face: self.write(step, &samples.vertex_face)?,
            edge_edge: self.write(step, &samples.edge_edge)?,
        };
        for (total, counts) in [
            (&mut self.total.vertex_face, counts.vertex_face),
            (&mut self.total.edge_edge, counts.edge_edge),
        ] {
            total
                .iter_mut()
                .zip(counts)
                .for_each(|(total, count)| *total += count);
        }
        let [vertex_face, vertex_face_in_contact, vertex_face_kept] = counts.vertex_face;
        let [edge_edge, edge_edge_in_contact, edge_edge_kept] = counts.edge_edge;
        self.log.add(&Row {
            step,
            vertex_face,
            vertex_face_in_contact,
            vertex_face_kept,
            edge_edge,
            edge_edge_in_contact,
            edge_edge_kept,
        })?;
        self.log.sync()
    }

    /// Writes a sample unless it is empty, and returns the counts.
    fn write<K: DataKind>(&self, step: u64, sample: &Subjects<K>) -> Result<[usize; 3], Failure> {
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
            query_files::write(&file, Seventh::Contact, records)?;
        }
        Ok([free + colliding, colliding, kept.len()])
    }

    /// The numbers of queries of all time steps.
    pub(super) fn total(&self) -> &Counts<[usize; 3]> {
        &self.total
    }
}
