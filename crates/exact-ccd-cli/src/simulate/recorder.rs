//! The queries that a simulation asks: a sample of them for each time step.

use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

use ccd_bench::DataKind;
use ccd_bench::comparison::{Subject, Subjects};
use ccd_mesh::{Bvh, Candidates, Point, Step, TriangleMesh};
use ccd_sim::filter::{Increment, StepFilter};
use ccd_sim::{Simulation, System};
use exact_ccd::{PointTriangle, SegmentSegment};
use rayon::prelude::*;

/// How many queries are decided at a time.
const CHUNK: usize = 1 << 16;

/// Random samples of the queries of a time step: of each kind, of those in contact and of the others.
pub(super) struct Samples {
    pub(super) vertex_face: Subjects<PointTriangle>,
    pub(super) edge_edge: Subjects<SegmentSegment>,
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
        let surface = Surface::of(simulation.system());
        let recorder = |filter| -> Box<dyn StepFilter> {
            Box::new(Recorder {
                filter,
                surface,
                recording: recording.clone(),
            })
        };
        (simulation.map_filter(recorder), recording)
    }

    /// The samples; those of the next time step begin empty.
    pub(super) fn take(&self) -> Samples {
        std::mem::replace(&mut *self.lock(), Samples::new(self.most))
    }

    fn lock(&self) -> MutexGuard<'_, Samples> {
        self.samples.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

/// A filter that is observed: its answers are those of the filter inside.
struct Recorder {
    filter: Box<dyn StepFilter>,
    surface: Surface,
    recording: Recording,
}

impl StepFilter for Recorder {
    fn name(&self) -> &str {
        self.filter.name()
    }

    fn largest(&self, increment: &Increment<'_>) -> f64 {
        self.surface
            .record(increment.start(), increment.end(), &mut self.recording.lock());
        self.filter.largest(increment)
    }

    fn is_free(&self, increment: &Increment<'_>, end: &[Point]) -> bool {
        self.surface
            .record(increment.start(), end, &mut self.recording.lock());
        self.filter.is_free(increment, end)
    }
}

/// The surface of a system, without the vertices inside of solids.
struct Surface {
    mesh: TriangleMesh,
    /// The number that each vertex has among those of the system.
    vertices: Vec<u32>,
    is_obstacle: Vec<bool>,
}

impl Surface {
    fn of(system: &System) -> Self {
        let faces = system.surface().faces();
        let mut vertices = faces.as_flattened().to_vec();
        vertices.sort_unstable();
        vertices.dedup();
        // All of them are there.
        let number = |vertex: u32| vertices.binary_search(&vertex).unwrap_or_default() as u32;
        let faces = faces.iter().map(|face| face.map(number)).collect();
        Self {
            mesh: TriangleMesh::new(vertices.len(), faces).expect("every corner has its vertex"),
            is_obstacle: vertices
                .iter()
                .map(|&vertex| system.masses()[vertex as usize] == 0.0)
                .collect(),
            vertices,
        }
    }

    /// Records the queries of a step: those whose boxes overlap, the others being free at a glance. There is no query
    /// between obstacles.
    fn record(&self, start: &[Point], end: &[Point], samples: &mut Samples) {
        let on_surface = |points: &[Point]| -> Vec<Point> {
            let points = self.vertices.iter().map(|&vertex| points[vertex as usize]);
            points.collect()
        };
        let (start, end) = (on_surface(start), on_surface(end));
        // There are no queries about positions that are not finite.
        let Ok(step) = Step::new(&self.mesh, &start, &end) else {
            return;
        };
        let candidates = Candidates::new(step, &Bvh);
        // All corners of a primitive belong to one body.
        let face = |face: u32| self.is_obstacle[self.mesh.faces()[face as usize][0] as usize];
        let edge = |edge: u32| self.is_obstacle[self.mesh.edges()[edge as usize][0] as usize];
        record(&candidates, &mut samples.vertex_face, |[v, f]| {
            self.is_obstacle[v as usize] && face(f)
        });
        record(&candidates, &mut samples.edge_edge, |[a, b]| edge(a) && edge(b));
    }
}

/// Adds the candidates of a kind to a sample, in order.
fn record<K: DataKind>(
    candidates: &Candidates<'_>,
    sample: &mut Subjects<K>,
    is_between_obstacles: impl Fn([u32; 2]) -> bool + Sync,
) {
    for pairs in K::candidates(candidates).chunks(CHUNK) {
        let subject = |&pair: &[u32; 2]| {
            let query = K::query(&candidates.step(), pair);
            (!is_between_obstacles(pair)).then(|| Subject {
                query,
                collides: query.collides(),
                first: None,
            })
        };
        let subjects: Vec<_> = pairs.par_iter().filter_map(subject).collect();
        subjects.into_iter().for_each(|subject| sample.add(subject));
    }
}
