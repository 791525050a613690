//! The contacts among the candidates of a step.

use std::cmp::Ordering;

use exact_ccd::{ContactTime, Impact, Kind, Query};
use rayon::prelude::*;

use crate::candidates::Candidates;
use crate::pair::{Pair, PairCounts};
use crate::step::Step;

/// How many candidates a thread takes at a time.
const CHUNK: usize = 1024;

/// What happens in a step of a mesh.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StepReport {
    /// How many pairs of primitives were examined.
    pub candidates: PairCounts,
    /// How many of them are in contact at some time of the step.
    pub colliding: PairCounts,
    /// How many of them are in contact at t = 0 already.
    pub touching: PairCounts,
    /// The earliest contact, or `None` if the step is free of contact.
    pub earliest: Option<EarliestContact>,
}

/// The earliest contact of a step.
///
/// Among contacts whose times lie between the same two adjacent f64, or are the same f64, it is that of the least [`Pair`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct EarliestContact {
    /// What touches.
    pub pair: Pair,
    /// When and where.
    pub impact: Impact,
}

impl StepReport {
    /// Examines the candidates of a step.
    ///
    /// Calls `progress`, on any thread, with the number of candidates that it has finished since the last call there.
    #[must_use]
    pub fn new(candidates: &Candidates<'_>, progress: &(dyn Fn(usize) + Sync)) -> Self {
        let step = candidates.step();
        let vertex_face = Contacts::among(
            candidates.vertex_face(),
            |[vertex, face]| step.vertex_face(vertex, face),
            |[vertex, face]| Pair::VertexFace { vertex, face },
            progress,
        );
        let edge_edge = Contacts::among(
            candidates.edge_edge(),
            |[a, b]| step.edge_edge(a, b),
            |[a, b]| Pair::EdgeEdge { a, b },
            progress,
        );
        let counts = |count: fn(&Contacts) -> usize| PairCounts {
            vertex_face: count(&vertex_face),
            edge_edge: count(&edge_edge),
        };
        Self {
            candidates: candidates.counts(),
            colliding: counts(|contacts| contacts.colliding),
            touching: counts(|contacts| contacts.touching),
            earliest: earlier(vertex_face.earliest, edge_edge.earliest)
                .and_then(|(_, pair)| impact(&step, pair).map(|impact| EarliestContact { pair, impact })),
        }
    }

    /// Whether no two primitives touch during the step.
    #[must_use]
    pub fn is_free(&self) -> bool {
        self.earliest.is_none()
    }

    /// The largest f64 not above the earliest contact time, if there is contact.
    #[must_use]
    pub fn time_of_impact(&self) -> Option<f64> {
        self.earliest.map(|contact| contact.impact.time.lower())
    }
}

/// The contacts among some candidates of one kind.
#[derive(Clone, Copy, Default)]
struct Contacts {
    colliding: usize,
    touching: usize,
    earliest: Option<(ContactTime, Pair)>,
}

impl Contacts {
    fn among<K: Kind>(
        candidates: &[[u32; 2]],
        query: impl Fn([u32; 2]) -> Option<Query<K>> + Sync,
        pair: impl Fn([u32; 2]) -> Pair + Sync,
        progress: &(dyn Fn(usize) + Sync),
    ) -> Self {
        candidates
            .par_chunks(CHUNK)
            .map(|chunk| {
                let mut contacts = Self::default();
                for &ids in chunk {
                    // Most candidates are not in contact, and to decide that is cheaper than to look for times.
                    let Some(query) = query(ids).filter(Query::collides) else {
                        continue;
                    };
                    contacts.colliding += 1;
                    if let Some(time) = query.contact_times().first() {
                        contacts.touching += usize::from(time.is_exact() && time.lower() == 0.0);
                        contacts.earliest = earlier(contacts.earliest, Some((time, pair(ids))));
                    }
                }
                progress(chunk.len());
                contacts
            })
            .reduce(Self::default, Self::merge)
    }

    fn merge(self, other: Self) -> Self {
        Self {
            colliding: self.colliding + other.colliding,
            touching: self.touching + other.touching,
            earliest: earlier(self.earliest, other.earliest),
        }
    }
}

fn earlier(a: Option<(ContactTime, Pair)>, b: Option<(ContactTime, Pair)>) -> Option<(ContactTime, Pair)> {
    a.into_iter()
        .chain(b)
        .min_by(|(s, p), (t, q)| s.partial_cmp(t).unwrap_or(Ordering::Equal).then(p.cmp(q)))
}

fn impact(step: &Step<'_>, pair: Pair) -> Option<Impact> {
    match pair {
        Pair::VertexFace { vertex, face } => step.vertex_face(vertex, face)?.impact(),
        Pair::EdgeEdge { a, b } => step.edge_edge(a, b)?.impact(),
    }
}
