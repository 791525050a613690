//! The pairs of primitives that come near each other in a step.

use std::ops::ControlFlow;

use exact_ccd::batch::Trajectories;
use exact_ccd::{Ccd, Decide, EdgeEdge, VertexFace};
use rayon::prelude::*;

use crate::broad_phase::{BroadPhase, PairCollector, PairSink};
use crate::candidate_options::{CandidateOptions, DistanceError};
use crate::collect::{AnyContact, Collect, ContactsUntil, Earliest};
use crate::contact::Contact;
use crate::mesh::TriangleMesh;
use crate::narrow_phase::NarrowPhase;
use crate::overlaps;
use crate::pair::{PairCounts, PairKind};
use crate::step::Step;

/// Pairs of primitives that come near each other in a step, by their indices.
///
/// Pairs that share a vertex are never among them. The pairs of a step hold for every step of the
/// same mesh from the same start to positions in between, such as [`Step::at`] returns: so one
/// broad phase suffices for a whole line search.
///
/// ```
/// use exact_ccd::Exact;
/// use exact_ccd_mesh::{Bvh, Candidates, Step, TriangleMesh};
///
/// let mesh = TriangleMesh::new(4, vec![[0, 1, 2]])?;
/// let start = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.25, 0.25, 1.0]];
/// let mut end = start;
/// end[3][2] = -1.0;
///
/// let step = Step::new(&mesh, &start, &end)?;
/// let candidates = Candidates::new(step, &Bvh);
/// assert_eq!(candidates.vertex_face(), [[3, 0]]);
/// assert_eq!(candidates.earliest_contact(step).map(|contact| contact.impact.time.lower()), Some(0.5));
///
/// let shorter = step.at(0.25);
/// assert!(candidates.is_free(Step::new(&mesh, &start, &shorter)?));
/// assert!(!candidates.is_free_by(step, &Exact));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Candidates {
    vertex_face: Vec<[u32; 2]>,
    edge_edge: Vec<[u32; 2]>,
}

/// The number of pairs that a thread examines exactly between two checks for the end of the search.
const GRAIN: usize = 2048;

/// The same for methods that may be a thousand times slower.
const GRAIN_OF_METHODS: usize = 64;

impl Candidates {
    /// All pairs whose boxes over the step overlap: all contacts of the step are among them.
    #[must_use]
    pub fn new(step: Step<'_>, broad_phase: &impl BroadPhase) -> Self {
        // The default distance is 0.
        Self::with_options(step, broad_phase, &CandidateOptions::default()).unwrap_or_default()
    }

    /// The candidates of a step, with options.
    ///
    /// # Errors
    /// [`DistanceError`], if the distance is negative or not a number.
    pub fn with_options(
        step: Step<'_>,
        broad_phase: &impl BroadPhase,
        options: &CandidateOptions,
    ) -> Result<Self, DistanceError> {
        let [vertex_face, edge_edge] = [PairCollector::default(), PairCollector::default()];
        let _ = overlaps::stream(
            step,
            broad_phase,
            options,
            &|pairs| vertex_face.add(pairs.iter().copied()),
            &|pairs| edge_edge.add(pairs.iter().copied()),
        )?;
        Ok(Self {
            vertex_face: vertex_face.into_sorted(),
            edge_edge: edge_edge.into_sorted(),
        })
    }

    /// Passes the candidates of a step on as they are found, in batches, from any thread, without
    /// storing them.
    ///
    /// The order of batches and of pairs in them may differ from run to run. Returns `Break` if a
    /// sink did.
    ///
    /// # Errors
    /// [`DistanceError`], if the distance is negative or not a number.
    pub fn stream(
        step: Step<'_>,
        broad_phase: &impl BroadPhase,
        options: &CandidateOptions,
        vertex_face: &PairSink<'_>,
        edge_edge: &PairSink<'_>,
    ) -> Result<ControlFlow<()>, DistanceError> {
        overlaps::stream(step, broad_phase, options, vertex_face, edge_edge)
    }

    /// Candidates from another source: pairs of a vertex and a face, and pairs of two edges.
    ///
    /// They are sorted, and each is kept once. Pairs that a mesh does not have are no contacts.
    #[must_use]
    pub fn from_ids(mut vertex_face: Vec<[u32; 2]>, mut edge_edge: Vec<[u32; 2]>) -> Self {
        edge_edge.iter_mut().for_each(|pair| pair.sort_unstable());
        for pairs in [&mut vertex_face, &mut edge_edge] {
            pairs.par_sort_unstable();
            pairs.dedup();
        }
        Self {
            vertex_face,
            edge_edge,
        }
    }

    /// Pairs of a vertex and a face that it is no corner of, sorted.
    #[must_use]
    pub fn vertex_face(&self) -> &[[u32; 2]] {
        &self.vertex_face
    }

    /// Pairs of two edges, the smaller index first, without a common vertex, sorted.
    #[must_use]
    pub fn edge_edge(&self) -> &[[u32; 2]] {
        &self.edge_edge
    }

    /// The numbers of pairs of each kind.
    #[must_use]
    pub fn counts(&self) -> PairCounts {
        PairCounts {
            vertex_face: self.vertex_face.len(),
            edge_edge: self.edge_edge.len(),
        }
    }

    /// Returns true if there are no pairs.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.counts().total() == 0
    }

    /// Returns true if none of the pairs touches in the step, exactly. Ends soon after the first
    /// contact found.
    #[must_use]
    pub fn is_free(&self, step: Step<'_>) -> bool {
        let contact = AnyContact::default();
        self.examine(step, &contact);
        !contact.is_found()
    }

    /// The earliest contact of the pairs in the step, exactly, or `None` if the step is free of
    /// contact.
    #[must_use]
    pub fn earliest_contact(&self, step: Step<'_>) -> Option<Contact> {
        let earliest = Earliest::new();
        self.examine(step, &earliest);
        earliest.contact(&step)
    }

    /// All contacts of the pairs in the step, exactly, the earliest first.
    #[must_use]
    pub fn contacts(&self, step: Step<'_>) -> Vec<Contact> {
        self.contacts_until(step, 1.0)
    }

    /// The contacts whose first time is not after `time`, exactly, the earliest first.
    #[must_use]
    pub fn contacts_until(&self, step: Step<'_>, time: f64) -> Vec<Contact> {
        let Some(contacts) = ContactsUntil::new(time) else {
            return Vec::new();
        };
        self.examine(step, &contacts);
        contacts.sorted()
    }

    /// Returns true if none of the pairs touches in the step, according to a method.
    #[must_use]
    pub fn is_free_by(&self, step: Step<'_>, method: &dyn Ccd) -> bool {
        let narrow_phase = NarrowPhase::of(&step);
        let (mesh, trajectories) = (step.mesh(), narrow_phase.trajectories());
        !has_collision::<VertexFace, _>(method, mesh, trajectories, &self.vertex_face)
            && !has_collision::<EdgeEdge, _>(method, mesh, trajectories, &self.edge_edge)
    }

    /// The earliest time of impact of the pairs in the step, according to a method, or `None` if
    /// the step is free of contact.
    ///
    /// It is in \[0, 1\]. A time of the method that is not a number counts as 0.
    #[must_use]
    pub fn earliest_time_by(&self, step: Step<'_>, method: &dyn Ccd) -> Option<f64> {
        let narrow_phase = NarrowPhase::of(&step);
        let (mesh, trajectories) = (step.mesh(), narrow_phase.trajectories());
        let faces = earliest_time::<VertexFace, _>(method, mesh, trajectories, &self.vertex_face);
        let edges = earliest_time::<EdgeEdge, _>(method, mesh, trajectories, &self.edge_edge);
        faces.into_iter().chain(edges).reduce(f64::min)
    }

    fn examine(&self, step: Step<'_>, collector: &impl Collect) {
        let mesh = step.mesh();
        // All on threads of the pool: entering it from outside costs a context switch each time.
        let _ = rayon::scope(|_| {
            let narrow_phase = &NarrowPhase::of(&step);
            let faces = self.vertex_face.par_chunks(GRAIN);
            faces.try_for_each(|pairs| collector.examine::<VertexFace>(narrow_phase, mesh, pairs))?;
            let edges = self.edge_edge.par_chunks(GRAIN);
            edges.try_for_each(|pairs| collector.examine::<EdgeEdge>(narrow_phase, mesh, pairs))
        });
    }
}

/// Returns true if a method decides that any of the pairs collides.
fn has_collision<K: PairKind, M: Decide<K> + ?Sized>(
    method: &M,
    mesh: &TriangleMesh,
    trajectories: &Trajectories,
    pairs: &[[u32; 2]],
) -> bool {
    pairs.par_chunks(GRAIN_OF_METHODS).any(|pairs| {
        let mut collides = false;
        let queries = queries::<K>(mesh, pairs);
        let outcome = method.collisions(trajectories, &queries, &mut |_| collides = true);
        // A method that does not accept the queries decides nothing.
        outcome.is_err() || collides
    })
}

/// The earliest time of impact of the pairs according to a method.
fn earliest_time<K: PairKind, M: Decide<K> + ?Sized>(
    method: &M,
    mesh: &TriangleMesh,
    trajectories: &Trajectories,
    pairs: &[[u32; 2]],
) -> Option<f64> {
    let earliest = |pairs: &[[u32; 2]]| {
        let mut earliest: Option<f64> = None;
        let queries = queries::<K>(mesh, pairs);
        let outcome = method.times_of_impact(trajectories, &queries, &mut |_, time| {
            let time = if time > 0.0 { time.min(1.0) } else { 0.0 };
            earliest = Some(earliest.map_or(time, |earliest| earliest.min(time)));
        });
        // A method that does not accept the queries has no later time.
        outcome.map_or(Some(0.0), |()| earliest)
    };
    pairs
        .par_chunks(GRAIN_OF_METHODS)
        .filter_map(earliest)
        .reduce_with(f64::min)
}

fn queries<K: PairKind>(mesh: &TriangleMesh, pairs: &[[u32; 2]]) -> Vec<[u32; 4]> {
    pairs.iter().filter_map(|&ids| K::vertices(mesh, ids)).collect()
}
