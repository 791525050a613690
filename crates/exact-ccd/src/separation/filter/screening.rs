//! The filters of many queries side by side: each one proves that the distance is above d.

use super::nearest::nearest;
use super::turning::{Moment, limit};
use crate::filter::{Coplanarity, Hull, LARGEST, Lanes, Points, add, scaled};
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
    pub(crate) fn is_out_of_range(&self) -> T::Mask {
        self.hull.is_out_of_range() | self.d.gt(self.d.splat(LARGEST))
    }

    /// True where the normal of the primitives at one end of the step proves it, or the distance of
    /// their planes.
    #[inline(always)]
    pub(crate) fn planes_are_beyond<K: Kind>(&self, points: &Points<T>) -> T::Mask {
        let coplanarity = Coplanarity::new::<K>(points);
        let [start, end] = coplanarity.normals;
        self.hull.is_beyond(start, self.d)
            | self.hull.is_beyond(end, self.d)
            | coplanarity.are_planes_beyond(self.d)
    }

    /// True where a direction proves it that turns with the closest points at t = 0, 1/2 and 1.
    ///
    /// A corner at t = 1/2 results from two roundings more than those at the ends.
    #[inline(always)]
    pub(crate) fn turning_is_beyond<K: Kind>(&self) -> T::Mask {
        let (start, end) = (self.hull.corners(0), self.hull.corners(1));
        let half = self.d.splat(0.5);
        let mut middle = start;
        for (corner, last) in middle.iter_mut().zip(&end) {
            *corner = scaled(add(*corner, *last), half);
        }
        let (a, b, c) = (moment::<K, T>(start), moment::<K, T>(middle), moment::<K, T>(end));
        let limit = limit(self.d, self.hull.reaches());
        a.are_beyond_until::<K>(&b, limit) & b.are_beyond_until::<K>(&c, limit)
    }
}

#[inline(always)]
fn moment<K: Kind, T: Lanes>(corners: [[T; 3]; 4]) -> Moment<T> {
    Moment::new(corners, nearest::<K, T>(&corners))
}
