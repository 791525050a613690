//! The stages of a decision.

/// The stage at which a query within a distance was settled, from the cheapest to the costliest.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
#[non_exhaustive]
pub enum SeparationStage {
    /// d = 0: the query was one of contact.
    Contact,
    /// The primitives are farther than d apart along an axis.
    BoundingBox,
    /// The primitives are farther than d apart along a diagonal of two axes.
    Diagonals,
    /// The primitives are farther than d apart along the normal of their planes at one end of the step,
    /// or their planes are at all times.
    Planes,
    /// The primitives are within d at t = 0.
    Start,
    /// Directions, one stretch of time after the other, prove that the primitives never come within
    /// d.
    Advancement,
    /// The distance falls below d between two adjacent f64, or is proved to stay above d to the end.
    Crossing,
    /// The filters have no answer: [`exact`](crate::exact::separation).
    Exact,
}

impl SeparationStage {
    /// All stages, in order.
    pub const ALL: [Self; 8] = [
        Self::Contact,
        Self::BoundingBox,
        Self::Diagonals,
        Self::Planes,
        Self::Start,
        Self::Advancement,
        Self::Crossing,
        Self::Exact,
    ];
}
