//! The earliest contact of a step.

use std::cmp::Ordering;

use exact_ccd::{ContactTime, Impact};

use crate::broad_phase::BroadPhase;
use crate::detector::Detector;
use crate::pair::Pair;
use crate::step::Step;

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

impl Step<'_> {
    /// The earliest contact, or `None` if the step is free of contact: [`Detector::earliest_contact`] for one step.
    #[must_use]
    pub fn earliest_contact(&self, broad_phase: &impl BroadPhase) -> Option<EarliestContact> {
        Detector::with_broad_phase(self.mesh(), broad_phase).earliest_contact_of(self)
    }

    /// Whether no two primitives touch during the step: [`Detector::is_free`] for one step.
    #[must_use]
    pub fn is_free(&self, broad_phase: &impl BroadPhase) -> bool {
        Detector::with_broad_phase(self.mesh(), broad_phase).is_step_free(self)
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
