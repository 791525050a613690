//! Pairs of primitives of a mesh: their kinds and vertices, the pairs for which contact counts, and the
//! distance that they keep.

mod by_kind;
mod can_collide;
mod group_matrix;
mod kind;
mod min_distance;
mod other_ends;
mod pair;
mod receive;

pub use by_kind::PairCounts;
pub use can_collide::CanCollide;
pub use group_matrix::{GroupError, GroupMatrix};
pub use kind::PairKind;
pub use min_distance::{MinDistance, ThicknessCount};
pub use pair::Pair;

pub(crate) use by_kind::ByKind;
pub(crate) use kind::{PrimitiveSet, Searched};
pub(crate) use other_ends::OtherEnds;
pub(crate) use receive::Receive;
