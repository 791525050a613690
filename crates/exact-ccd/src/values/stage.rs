//! The stages of a decision.

use core::fmt;

/// The stage at which a query was settled, for contact from the cheapest to the costliest.
///
/// The first four are the same for contact and for a separation above 0, d: contact is d = 0. For d,
/// [`Direction`](Self::Direction) comes before [`Coplanarity`](Self::Coplanarity).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
#[non_exhaustive]
pub enum Stage {
    /// The primitives are farther than d apart along an axis.
    BoundingBox,
    /// The primitives are farther than d apart along a diagonal of two axes.
    Diagonals,
    /// The primitives are farther than d apart along the normal of their planes at t = 0 or t = 1.
    Normals,
    /// The planes of the primitives are farther than d apart at all times: for contact, the coplanarity
    /// cubic has no root in the step.
    Coplanarity,
    /// Contact: the roots of the coplanarity cubic, and the position of the primitives at each.
    Roots,
    /// Contact: a vertex of each primitive in one place, or all points on one line along an axis.
    /// Comparisons prove it.
    Coincident,
    /// The primitives are farther than d apart along a direction found by iteration or, for contact, along
    /// the normal of a plane through an edge and the relative velocity.
    Direction,
    /// Contact: all points move in one plane across an axis, and the sides of the edges' lines on which
    /// the vertices lie decide.
    Planar,
    /// Contact: signs of integers of fixed width decide, at rest at t = 0, at the roots of the coplanarity
    /// cubic from its exact coefficients, or at all times of motion in one plane.
    FixedWidth,
    /// The primitives are within d > 0 at t = 0.
    Start,
    /// Directions, one stretch of time after the other, prove that the primitives do not come within d > 0
    /// until the last time that counts.
    Advancement,
    /// The distance falls below d > 0 between two adjacent f64, or is proved to stay above d until the last
    /// time that counts.
    Crossing,
    /// No filter decides: the exact path does.
    Exact,
}

impl Stage {
    /// All stages, in order.
    pub const ALL: &'static [Self] = &[
        Self::BoundingBox,
        Self::Diagonals,
        Self::Normals,
        Self::Coplanarity,
        Self::Roots,
        Self::Coincident,
        Self::Direction,
        Self::Planar,
        Self::FixedWidth,
        Self::Start,
        Self::Advancement,
        Self::Crossing,
        Self::Exact,
    ];
}

impl fmt::Display for Stage {
    /// Writes the name, as in `BoundingBox`.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Debug::fmt(self, f)
    }
}
