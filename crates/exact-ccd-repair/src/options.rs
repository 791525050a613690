//! Options of a repair.

use std::fmt;

use exact_ccd_mesh::{CanCollide, Separation};

use crate::progress::Progress;

/// Options of [`repair`](crate::repair).
#[derive(Clone)]
#[non_exhaustive]
pub struct RepairOptions<'a> {
    /// The distance at which primitives touch: the repaired positions have no pair within it. The default is
    /// 0, which is contact.
    pub min_distance: Separation,
    /// The vertices that stay where they are, such as the vertices of obstacles. The default is none.
    pub pinned: Vec<u32>,
    /// The pairs that may not intersect. The default is all.
    pub can_collide: CanCollide,
    /// The number of rounds after which a phase ends: loosening and separation are given up then. The default
    /// is 2,000.
    pub max_rounds: usize,
    /// Called before each round, and before each frame of a recording; true ends the repair as it stands.
    pub stop: Option<&'a (dyn Fn(Progress) -> bool + Sync)>,
}

impl Default for RepairOptions<'_> {
    fn default() -> Self {
        Self {
            min_distance: Separation::default(),
            pinned: Vec::new(),
            can_collide: CanCollide::all(),
            max_rounds: 2000,
            stop: None,
        }
    }
}

impl<'a> RepairOptions<'a> {
    /// The same options with another distance at which primitives touch.
    #[must_use]
    pub fn with_min_distance(self, min_distance: Separation) -> Self {
        Self { min_distance, ..self }
    }

    /// The same options with other pinned vertices.
    #[must_use]
    pub fn with_pinned(self, pinned: Vec<u32>) -> Self {
        Self { pinned, ..self }
    }

    /// The same options with other pairs that may not intersect.
    #[must_use]
    pub fn with_can_collide(self, can_collide: CanCollide) -> Self {
        Self { can_collide, ..self }
    }

    /// The same options with another limit of rounds.
    #[must_use]
    pub fn with_max_rounds(self, max_rounds: usize) -> Self {
        Self { max_rounds, ..self }
    }

    /// The same options with a function that is told of each round, and may end the repair.
    #[must_use]
    pub fn with_stop(self, stop: &'a (dyn Fn(Progress) -> bool + Sync)) -> Self {
        let stop = Some(stop);
        Self { stop, ..self }
    }
}

impl fmt::Debug for RepairOptions<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("RepairOptions")
            .field("min_distance", &self.min_distance)
            .field("pinned", &self.pinned)
            .field("can_collide", &self.can_collide)
            .field("max_rounds", &self.max_rounds)
            .field("has_stop", &self.stop.is_some())
            .finish()
    }
}
