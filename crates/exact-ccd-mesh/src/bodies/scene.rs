//! Two bodies in a part of the step.

use std::sync::OnceLock;

use exact_ccd::Point;

use super::approach::{Limit, TINY, approach};
use super::part::Part;
use super::placed::Placed;
use super::sphere::Sphere;

/// Both bodies in a part of the step.
pub(super) struct Scene {
    pub(super) part: Part,
    pub(super) placed: [Placed; 2],
    /// The distance at which primitives touch, the deviation, and the errors of all places.
    pub(super) slab: f64,
    /// The same with the errors of distances between places.
    pub(super) margin: f64,
    pub(super) deviation: f64,
    error: f64,
    /// The quarters of the part, as soon as they are needed.
    pub(super) quarters: OnceLock<Vec<Self>>,
}

impl Scene {
    pub(super) fn new(part: Part, placed: [Placed; 2], separation: f64) -> Self {
        let error = placed[0].error + placed[1].error + TINY;
        let deviation = placed[0].deviation + placed[1].deviation;
        let slab = separation + deviation + error;
        Self {
            part,
            placed,
            slab,
            margin: (slab + error) * (1.0 + 1e-12),
            deviation,
            error,
            quarters: OnceLock::new(),
        }
    }

    /// Returns true if halves of the part are needed to compare balls with this sum of their radii: the
    /// deviation is more than a quarter of it and of the errors, which no part is without.
    pub(super) fn is_too_long(&self, radii: f64) -> bool {
        self.deviation > 0.25 * (radii + self.error) && self.part.halves().is_some()
    }

    /// Returns true unless two balls, one of each body, are apart in the whole part.
    pub(super) fn come_near(&self, [first, second]: [Sphere; 2]) -> bool {
        let places = [
            self.placed[0].at_ends(first.center),
            self.placed[1].at_ends(second.center),
        ];
        self.first_within(places, first.radius + second.radius).is_some()
    }

    /// A time of the step before which two points are farther apart than a distance and the margin; `None` if
    /// they are in the whole part.
    #[inline]
    pub(super) fn first_within(&self, [first, second]: [[Point; 2]; 2], radius: f64) -> Option<f64> {
        let limit = Limit {
            distance: radius + self.margin,
            error: self.error,
        };
        let time = approach(first, second, limit)?;
        Some((self.part.start + time * self.part.length()).next_down())
    }
}
