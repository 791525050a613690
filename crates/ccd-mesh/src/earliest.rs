//! The earliest contact of a step, without a look at every candidate.

use std::cmp::Ordering;
use std::ops::ControlFlow;
use std::sync::atomic::{self, AtomicBool, AtomicU64};
use std::sync::{Mutex, PoisonError};

use exact_ccd::{ContactTime, Impact, PointTriangle, SegmentSegment};

use crate::broad_phase::BroadPhase;
use crate::kind::PairKind;
use crate::narrow_phase::NarrowPhase;
use crate::pair::Pair;
use crate::step::Step;
use crate::step_boxes::StepBoxes;

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

/// One block of primitives in so many is looked at first: enough of them to find a contact that comes early among many.
const SAMPLE: usize = 64;

impl Step<'_> {
    /// The earliest contact, or `None` if the step is free of contact.
    ///
    /// The contacts of some primitives come first. The earliest of these bounds the time until which all others are
    /// looked at, and each contact found there lowers the bound; so most candidates are never examined, nor counted as
    /// [`StepReport`](crate::StepReport) does. The answer is the same, on any number of threads.
    #[must_use]
    pub fn earliest_contact(&self, broad_phase: &impl BroadPhase) -> Option<EarliestContact> {
        // All of it on a thread of the pool: to come from outside costs a switch each time.
        rayon::scope(|_| self.first(broad_phase)).contact(self)
    }

    fn first(&self, broad_phase: &impl BroadPhase) -> First {
        let narrow_phase = NarrowPhase::new(self);
        let first = First::new();
        let vertex_face = |pairs: &[_]| first.look::<PointTriangle>(&narrow_phase, pairs);
        let edge_edge = |pairs: &[_]| first.look::<SegmentSegment>(&narrow_phase, pairs);
        let mut boxes = StepBoxes::moving(self);
        let _ = broad_phase.between(&boxes.vertices.sample(SAMPLE), &boxes.faces, vertex_face);
        let _ = broad_phase.between(&boxes.edges.sample(SAMPLE), &boxes.edges, edge_edge);
        boxes.shrink(self, first.time());
        let _ = broad_phase.between(&boxes.vertices, &boxes.faces, vertex_face);
        boxes.shrink(self, first.time());
        let _ = broad_phase.within(&boxes.edges, edge_edge);
        first
    }

    /// Whether no two primitives touch during the step. Ends at the first contact that it comes across.
    #[must_use]
    pub fn is_free(&self, broad_phase: &impl BroadPhase) -> bool {
        rayon::scope(|_| self.is_free_of_contact(broad_phase))
    }

    fn is_free_of_contact(&self, broad_phase: &impl BroadPhase) -> bool {
        let narrow_phase = NarrowPhase::new(self);
        let boxes = StepBoxes::moving(self);
        let is_free = AtomicBool::new(true);
        fn look<K: PairKind>(
            narrow_phase: &NarrowPhase<'_>,
            is_free: &AtomicBool,
            pairs: &[[u32; 2]],
        ) -> ControlFlow<()> {
            narrow_phase.collisions::<K>(pairs, |_, _| is_free.store(false, atomic::Ordering::Relaxed));
            if is_free.load(atomic::Ordering::Relaxed) {
                ControlFlow::Continue(())
            } else {
                ControlFlow::Break(())
            }
        }
        let vertex_face = |pairs: &[_]| look::<PointTriangle>(&narrow_phase, &is_free, pairs);
        let edge_edge = |pairs: &[_]| look::<SegmentSegment>(&narrow_phase, &is_free, pairs);
        let is_not_found = || {
            broad_phase.between(&boxes.vertices.sample(SAMPLE), &boxes.faces, vertex_face)?;
            broad_phase.between(&boxes.edges.sample(SAMPLE), &boxes.edges, edge_edge)?;
            broad_phase.between(&boxes.vertices, &boxes.faces, vertex_face)?;
            broad_phase.within(&boxes.edges, edge_edge)
        };
        is_not_found().is_continue()
    }
}

/// The first contact that any thread has found.
struct First {
    /// The bits of the least f64 that is not below its time: those of times have the order of the times.
    limit: AtomicU64,
    contact: Mutex<Option<(ContactTime, Pair)>>,
}

impl First {
    fn new() -> Self {
        Self {
            limit: AtomicU64::new(f64::INFINITY.to_bits()),
            contact: Mutex::new(None),
        }
    }

    fn time(&self) -> f64 {
        f64::from_bits(self.limit.load(atomic::Ordering::Relaxed))
    }

    fn look<K: PairKind>(&self, narrow_phase: &NarrowPhase<'_>, pairs: &[[u32; 2]]) -> ControlFlow<()> {
        narrow_phase.collisions::<K>(pairs, |ids, query| {
            if let Some(time) = query.contact_times().first()
                && time.lower() <= self.time()
            {
                self.add(time, K::pair(ids));
            }
        });
        ControlFlow::Continue(())
    }

    fn add(&self, time: ContactTime, pair: Pair) {
        let mut contact = self.contact.lock().unwrap_or_else(PoisonError::into_inner);
        *contact = earlier(*contact, Some((time, pair)));
        if let Some((time, _)) = *contact {
            self.limit
                .store(time.upper().to_bits(), atomic::Ordering::Relaxed);
        }
    }

    fn contact(self, step: &Step<'_>) -> Option<EarliestContact> {
        let contact = self.contact.into_inner().unwrap_or_else(PoisonError::into_inner);
        contact.and_then(|(_, pair)| EarliestContact::of(step, pair))
    }
}

/// The earlier of two contacts.
pub(crate) fn earlier(
    a: Option<(ContactTime, Pair)>,
    b: Option<(ContactTime, Pair)>,
) -> Option<(ContactTime, Pair)> {
    a.into_iter()
        .chain(b)
        .min_by(|(s, p), (t, q)| s.partial_cmp(t).unwrap_or(Ordering::Equal).then(p.cmp(q)))
}

impl EarliestContact {
    /// The contact of a pair that is known to touch.
    pub(crate) fn of(step: &Step<'_>, pair: Pair) -> Option<Self> {
        let impact = match pair {
            Pair::VertexFace { vertex, face } => step.vertex_face(vertex, face)?.impact(),
            Pair::EdgeEdge { a, b } => step.edge_edge(a, b)?.impact(),
        };
        impact.map(|impact| Self { pair, impact })
    }
}
