//! All contacts of a step, counted.

use std::ops::ControlFlow;
use std::sync::{Mutex, PoisonError};

use exact_ccd::{ContactTime, EdgeEdge, VertexFace};

use crate::broad_phase::BroadPhase;
use crate::candidates::Overlaps;
use crate::earliest::{EarliestContact, earlier};
use crate::kind::PairKind;
use crate::narrow_phase::NarrowPhase;
use crate::pair::{Pair, PairCounts};
use crate::step::Step;

/// What happens in a step of a mesh.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StepReport {
    /// How many pairs of primitives came near each other; see [`Candidates`](crate::Candidates).
    pub candidates: PairCounts,
    /// How many of them are in contact at some time of the step.
    pub colliding: PairCounts,
    /// How many of them are in contact at t = 0 already.
    pub touching: PairCounts,
    /// The earliest contact, or `None` if the step is free of contact.
    pub earliest: Option<EarliestContact>,
}

impl StepReport {
    /// Examines all candidates of a step, as the broad phase finds them: no list of them is kept.
    ///
    /// Calls `progress`, on any thread, with the number of candidates that it has finished since the last call there.
    #[must_use]
    pub fn new(step: Step<'_>, broad_phase: &impl BroadPhase, progress: &(dyn Fn(usize) + Sync)) -> Self {
        let overlaps = Overlaps::new(step);
        let mut narrow_phase = NarrowPhase::new(step.mesh());
        narrow_phase.begin(&step);
        let [vertex_face, edge_edge] = [Mutex::default(), Mutex::default()];
        let _ = overlaps.visit(
            broad_phase,
            &|pairs| Contacts::among::<VertexFace>(&narrow_phase, pairs, &vertex_face, progress),
            &|pairs| Contacts::among::<EdgeEdge>(&narrow_phase, pairs, &edge_edge, progress),
        );
        let [vertex_face, edge_edge] = [vertex_face, edge_edge]
            .map(|contacts: Mutex<Contacts>| contacts.into_inner().unwrap_or_else(PoisonError::into_inner));
        let counts = |count: fn(&Contacts) -> usize| PairCounts {
            vertex_face: count(&vertex_face),
            edge_edge: count(&edge_edge),
        };
        Self {
            candidates: counts(|contacts| contacts.candidates),
            colliding: counts(|contacts| contacts.colliding),
            touching: counts(|contacts| contacts.touching),
            earliest: earlier(vertex_face.earliest, edge_edge.earliest)
                .and_then(|(_, pair)| EarliestContact::of(&step, pair)),
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
    candidates: usize,
    colliding: usize,
    touching: usize,
    earliest: Option<(ContactTime, Pair)>,
}

impl Contacts {
    fn among<K: PairKind>(
        narrow_phase: &NarrowPhase<'_>,
        candidates: &[[u32; 2]],
        all: &Mutex<Self>,
        progress: &(dyn Fn(usize) + Sync),
    ) -> ControlFlow<()> {
        if candidates.is_empty() {
            return ControlFlow::Continue(());
        }
        let mut contacts = Self {
            candidates: candidates.len(),
            ..Self::default()
        };
        narrow_phase.collisions::<K>(candidates, |ids, collision| {
            let time = collision.first_contact_time();
            contacts.colliding += 1;
            contacts.touching += usize::from(time.is_exact() && time.lower() == 0.0);
            contacts.earliest = earlier(contacts.earliest, Some((time, K::pair(ids))));
        });
        {
            let mut all = all.lock().unwrap_or_else(PoisonError::into_inner);
            *all = all.merge(contacts);
        }
        // Without the lock, for what it does is not known: it may even wait for other threads.
        progress(candidates.len());
        ControlFlow::Continue(())
    }

    fn merge(self, other: Self) -> Self {
        Self {
            candidates: self.candidates + other.candidates,
            colliding: self.colliding + other.colliding,
            touching: self.touching + other.touching,
            earliest: earlier(self.earliest, other.earliest),
        }
    }
}
