//! The queries that a simulation asks: a sample of them for each time step.

use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

use exact_ccd::{EdgeEdge, Query, VertexFace};
use exact_ccd_bench::comparison::{Subject, Subjects};
use exact_ccd_data::DataKind;
use exact_ccd_mesh::{Aabb, Point, Step};
use exact_ccd_sim::Simulation;
use exact_ccd_sim::filter::{Increment, StepFilter};
use rayon::prelude::*;

/// How many queries are decided at a time.
const CHUNK: usize = 1 << 16;

/// Random samples of the queries of a time step: of each kind, of those in contact and of the others.
pub(super) struct Samples {
    pub(super) vertex_face: Subjects<VertexFace>,
    pub(super) edge_edge: Subjects<EdgeEdge>,
}

impl Samples {
    fn new(most: usize) -> Self {
        Self {
            vertex_face: Subjects::new(most),
            edge_edge: Subjects::new(most),
        }
    }
}

/// What a simulation with this filter has asked it since the samples were taken last.
#[derive(Clone)]
pub(super) struct Recording {
    samples: Arc<Mutex<Samples>>,
    most: usize,
}

impl Recording {
    /// The simulation, whose filter is observed, and what is seen: at most so many queries of each sample.
    pub(super) fn of(simulation: Simulation, most: usize) -> (Simulation, Self) {
        let samples = Arc::new(Mutex::new(Samples::new(most)));
        let recording = Self { samples, most };
        let recorder = |filter| -> Box<dyn StepFilter> {
            Box::new(Recorder {
                filter,
                recording: recording.clone(),
            })
        };
        (simulation.map_filter(recorder), recording)
    }

    /// The samples; those of the next time step begin empty.
    pub(super) fn take(&self) -> Samples {
        std::mem::replace(&mut *self.lock(), Samples::new(self.most))
    }

    /// Samples the queries of the step to these positions whose boxes overlap, the others being free at a glance.
    fn record(&self, increment: &Increment<'_>, end: &[Point]) {
        let (mesh, pairs) = (increment.surface().mesh(), increment.pairs());
        // There are no queries about positions that are not finite.
        if let Ok(step) = Step::new(mesh, increment.start(), end) {
            let samples = &mut *self.lock();
            add(&step, &pairs.vertex_face, 1, &mut samples.vertex_face);
            add(&step, &pairs.edge_edge, 2, &mut samples.edge_edge);
        }
    }

    fn lock(&self) -> MutexGuard<'_, Samples> {
        self.samples.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

/// A filter that is observed: its answers are those of the filter inside.
struct Recorder {
    filter: Box<dyn StepFilter>,
    recording: Recording,
}

impl StepFilter for Recorder {
    fn name(&self) -> &str {
        self.filter.name()
    }

    fn largest(&self, increment: &Increment<'_>) -> f64 {
        self.recording.record(increment, increment.end());
        self.filter.largest(increment)
    }

    fn is_free(&self, increment: &Increment<'_>, end: &[Point]) -> bool {
        self.recording.record(increment, end);
        self.filter.is_free(increment, end)
    }
}

/// Adds those of some pairs whose boxes overlap to a sample, in order; `first` is how many points belong to the first primitive.
fn add<K: DataKind>(step: &Step<'_>, pairs: &[[u32; 2]], first: usize, sample: &mut Subjects<K>) {
    for pairs in pairs.chunks(CHUNK) {
        let subject = |&pair: &[u32; 2]| {
            let query = K::query(step, pair);
            do_boxes_overlap(&query, first).then(|| Subject {
                query,
                collides: query.collides(),
                first: None,
            })
        };
        let subjects: Vec<_> = pairs.par_iter().filter_map(subject).collect();
        subjects.into_iter().for_each(|subject| sample.add(subject));
    }
}

/// Whether the boxes around the ways of two primitives overlap.
fn do_boxes_overlap<K: DataKind>(query: &Query<K>, first: usize) -> bool {
    let [start, end] = query.points();
    let around = |range: std::ops::Range<usize>| -> Aabb {
        let points = start[range.clone()].iter().chain(&end[range]);
        points.copied().collect()
    };
    around(0..first).overlaps(&around(first..4))
}
