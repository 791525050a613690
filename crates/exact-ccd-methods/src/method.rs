//! What all methods have in common.

use exact_ccd::{EdgeEdge, Query, VertexFace};

/// A method of continuous collision detection.
///
/// An implementation outside this crate takes part in every comparison: a name, a promise, and an answer for each kind
/// of query.
pub trait Method: Send + Sync {
    /// The name in tables: short, and different from all others.
    fn name(&self) -> &str;

    /// What its answers are worth.
    fn promise(&self) -> Promise;

    /// Whether a vertex and a face collide.
    fn vertex_face(&self, query: &Query<VertexFace>) -> Answer;

    /// Whether two edges collide.
    fn edge_edge(&self, query: &Query<EdgeEdge>) -> Answer;
}

/// What a method says of a query.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Answer {
    /// The primitives do not touch.
    Free,
    /// They touch.
    Contact {
        /// When first, from the methods that tell.
        time: Option<f64>,
    },
}

impl Answer {
    /// Contact or not, without a time.
    #[must_use]
    pub fn from_decision(collides: bool) -> Self {
        if collides {
            Self::Contact { time: None }
        } else {
            Self::Free
        }
    }

    /// Contact at a time, if there is one.
    #[must_use]
    pub fn from_time(time: Option<f64>) -> Self {
        time.map_or(Self::Free, |time| Self::Contact { time: Some(time) })
    }

    /// Whether this says that the primitives touch.
    #[must_use]
    pub fn is_contact(self) -> bool {
        self != Self::Free
    }

    /// The time of contact, if this tells one.
    #[must_use]
    pub fn time(self) -> Option<f64> {
        match self {
            Self::Free => None,
            Self::Contact { time } => time,
        }
    }
}

/// What the answers of a method are worth, for any finite input.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Promise {
    /// It may say [`Answer::Free`] though the primitives touch: a false negative.
    pub may_miss: bool,
    /// It may say [`Answer::Contact`] though they do not: a false positive.
    pub may_invent: bool,
    /// When, if at all, it says that they touch.
    pub time: Time,
}

/// The time that a method tells.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Time {
    /// None.
    Absent,
    /// An approximation, on either side of the earliest contact.
    Approximate,
    /// At or before the earliest contact.
    Conservative,
    /// The earliest contact, rounded down to the next f64.
    Exact,
}
