//! The stages of a decision.

/// The stage at which a query was settled, from the cheapest to the costliest.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
#[non_exhaustive]
pub enum Stage {
    /// The bounding box of F at the corners of its domain does not contain the origin.
    BoundingBox,
    /// A plane through the origin and an axis, at 45° to the other two, separates.
    Diagonals,
    /// The normal of the primitives' plane at t = 0 or t = 1 separates.
    Normals,
    /// The coplanarity cubic has no root in the step.
    Coplanarity,
    /// The roots of the coplanarity cubic, and the position of the primitives at each.
    Roots,
    /// A vertex of each primitive in one place, or all points on one line along an axis: comparisons
    /// prove contact.
    Coincident,
    /// A plane through an edge and the relative velocity, or a direction found by iteration, separates.
    Direction,
    /// All points move in one plane across an axis, and the sides of the edges' lines on which the
    /// vertices lie decide.
    Planar,
    /// The signs that decide are those of integers of fixed width: contact at rest at t = 0, or at the roots
    /// of the coplanarity cubic from its exact coefficients.
    FixedWidth,
    /// No filter decides: [`exact`](crate::exact).
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
        Self::Exact,
    ];
}
