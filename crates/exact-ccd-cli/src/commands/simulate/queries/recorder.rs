//! Samples of the queries of a simulation for each time step.

use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

use exact_ccd::{AnyKind, CONTACT, EdgeEdge, Query, VertexFace};
use exact_ccd_compare::{Subject, Subjects};
use exact_ccd_data::DataKind;
use exact_ccd_mesh::{Aabb, Candidates, Step};
use exact_ccd_sim::{Simulation, SimulationError};
use rayon::prelude::*;

/// The number of queries that are decided at a time.
const CHUNK: usize = 1 << 16;

/// Random samples of the queries of a time step: for each kind, of queries in contact and of the others.
pub(crate) struct Samples {
    pub(crate) vertex_face: Subjects<VertexFace>,
    pub(crate) edge_edge: Subjects<EdgeEdge>,
}

impl Samples {
    fn new(most: usize) -> Self {
        Self {
            vertex_face: Subjects::new(most),
            edge_edge: Subjects::new(most),
        }
    }
}

/// Samples of the queries of a simulation since they were last taken.
#[derive(Clone)]
pub(crate) struct Recording {
    samples: Arc<Mutex<Samples>>,
    most: usize,
}

impl Recording {
    /// The simulation with an observed filter, and the samples: at most `most` queries each.
    ///
    /// # Errors
    /// The errors of [`Simulation::with_filter`].
    pub(crate) fn of(simulation: Simulation, most: usize) -> Result<(Simulation, Self), SimulationError> {
        let samples = Arc::new(Mutex::new(Samples::new(most)));
        let recording = Self { samples, most };
        let observer = recording.clone();
        let filter = simulation.filter().clone();
        let filter = filter.observed(move |candidates, step| observer.record(candidates, step));
        Ok((simulation.with_filter(filter)?, recording))
    }

    /// Takes the samples, and starts the samples of the next time step.
    pub(crate) fn take(&self) -> Samples {
        std::mem::replace(&mut *self.lock(), Samples::new(self.most))
    }

    /// Samples the queries of a step whose boxes overlap.
    fn record(&self, candidates: &Candidates, step: Step<'_>) {
        let samples = &mut *self.lock();
        add(
            &step,
            candidates.of_kind(AnyKind::VertexFace),
            1,
            &mut samples.vertex_face,
        );
        add(
            &step,
            candidates.of_kind(AnyKind::EdgeEdge),
            2,
            &mut samples.edge_edge,
        );
    }

    fn lock(&self) -> MutexGuard<'_, Samples> {
        self.samples.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

/// Adds the pairs whose boxes overlap to a sample, in order. `first` is the number of points of the first
/// primitive.
fn add<K: DataKind>(step: &Step<'_>, pairs: &[[u32; 2]], first: usize, sample: &mut Subjects<K>) {
    for pairs in pairs.chunks(CHUNK) {
        let subject = |&pair: &[u32; 2]| {
            let query = step.query::<K>(pair)?;
            do_boxes_overlap(&query, first).then(|| Subject {
                query,
                collides: query.collides(CONTACT),
                first: None,
            })
        };
        let subjects: Vec<_> = pairs.par_iter().filter_map(subject).collect();
        subjects.into_iter().for_each(|subject| sample.add(subject));
    }
}

/// Returns true if the boxes around the paths of two primitives overlap.
fn do_boxes_overlap<K: DataKind>(query: &Query<K>, first: usize) -> bool {
    let [start, end] = query.points();
    let around = |range: std::ops::Range<usize>| -> Aabb {
        let points = start[range.clone()].iter().chain(&end[range]);
        points.copied().collect()
    };
    around(0..first).overlaps(&around(first..4))
}
