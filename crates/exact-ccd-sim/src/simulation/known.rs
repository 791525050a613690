//! The collisions of the last positions for which they were computed.

use exact_ccd_mesh::Point;

use crate::energies::contact::CollisionSet;

/// The collisions of some positions. They are computed again where these are others: no result depends on it.
pub(super) struct KnownCollisions {
    pub(super) positions: Vec<Point>,
    pub(super) collisions: CollisionSet,
}
