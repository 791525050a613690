//! Contacts of a step.

use std::cmp::Ordering;

use exact_ccd::{ContactTime, Impact};

use crate::pair::Pair;
use crate::step::Step;

/// A pair of primitives that touch in a step, and the first time at which they do.
///
/// Contacts are in the order of their times. Among contacts whose times lie between the same two
/// adjacent f64, or are the same f64, the lesser [`Pair`] comes first.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Contact {
    /// The pair.
    pub pair: Pair,
    /// The time and the place of its first contact.
    pub impact: Impact,
}

impl Contact {
    /// The contact of a pair; `None` if the pair does not touch in the step.
    pub(crate) fn of(step: &Step<'_>, pair: Pair) -> Option<Self> {
        let impact = match pair {
            Pair::VertexFace { vertex, face } => step.vertex_face(vertex, face)?.impact(),
            Pair::EdgeEdge { a, b } => step.edge_edge(a, b)?.impact(),
        };
        impact.map(|impact| Self { pair, impact })
    }

    /// The order of contacts.
    pub(crate) fn compare(&self, other: &Self) -> Ordering {
        compare((self.impact.time, self.pair), (other.impact.time, other.pair))
    }
}

/// The earlier of two contacts.
pub(crate) fn earlier(
    a: Option<(ContactTime, Pair)>,
    b: Option<(ContactTime, Pair)>,
) -> Option<(ContactTime, Pair)> {
    a.into_iter().chain(b).min_by(|&a, &b| compare(a, b))
}

fn compare((s, p): (ContactTime, Pair), (t, q): (ContactTime, Pair)) -> Ordering {
    // No time is NaN.
    s.partial_cmp(&t).unwrap_or(Ordering::Equal).then(p.cmp(&q))
}
