//! The filters of many queries side by side: each one proves that the distance is above d.

use super::advance::Advancement;
use crate::filter::{Coplanarity, Hull, LARGEST, Lanes, Points};
use crate::kind::Kind;

/// Queries side by side, whose coordinates and distances are at most [`LARGEST`].
pub(crate) struct Screening<T> {
    hull: Hull<T>,
    d: T,
}

impl<T: Lanes> Screening<T> {
    #[inline(always)]
    pub(crate) fn new<K: Kind>(points: &Points<T>, d: T) -> Self {
        let hull = Hull::new::<K>(points);
        Self { hull, d }
    }

    /// True where the filters cannot compute.
    #[inline(always)]
    fn is_out_of_range(&self) -> T::Mask {
        self.hull.is_out_of_range() | self.d.gt(self.d.splat(LARGEST))
    }

    /// True where the normal of the primitives at one end of the step proves it, or the distance of
    /// their planes.
    #[inline(always)]
    pub(crate) fn planes_are_beyond<K: Kind>(&self, points: &Points<T>) -> T::Mask {
        let coplanarity = Coplanarity::new::<K>(points);
        let [start, end] = coplanarity.normals;
        (self.hull.is_beyond(start, self.d)
            | self.hull.is_beyond(end, self.d)
            | coplanarity.are_planes_beyond(self.d))
            & !self.is_out_of_range()
    }

    /// The time before which [advancement](super::advance) proves it, in each lane: `until`, above 0, if it
    /// is proved at all times until then.
    #[inline(always)]
    pub(crate) fn free_until<K: Kind>(&self, until: f64) -> T {
        let corners = [self.hull.corners(0), self.hull.corners(1)];
        let advancement = Advancement::new(corners, self.d, self.hull.reaches());
        let [zero, half, whole] = [0.0, 0.5 * until, until].map(|t| self.d.splat(t));
        let to = T::select(self.is_out_of_range(), zero, whole);
        advancement.free_until::<K>(zero, to, half, self.d.splat(SHORTEST * until))
    }
}

/// A proof is tried in stretches that are longer than this fraction of the time until which it is tried.
const SHORTEST: f64 = 1.0 / 64.0;
