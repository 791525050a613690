//! Advancement: stretches of time, from the left, in which a direction, constant or turning, keeps the
//! primitives farther than d apart. For one query, or for many side by side.

use super::nearest::nearest;
use super::scaled::Scaled;
use super::turning::{Heading, limit};
use crate::filter::gap::Within;
use crate::filter::hull::Hull;
use crate::filter::number::Lanes;
use crate::filter::vector::{add, scaled};
use crate::kind::Kind;

/// The time before which the distance is certainly above d, in each lane: `until`, above 0, if it is so at
/// all times until then. It is 0 where the coordinates or d are out of range.
#[inline(always)]
pub(crate) fn free_until<K: Kind, T: Lanes>(hull: &Hull<T>, d: T, until: f64) -> T {
    /// A proof is tried in stretches that are longer than this fraction of the time until which it is tried.
    const SHORTEST: f64 = 1.0 / 64.0;
    let advancement = Advancement::new([hull.corners(0), hull.corners(1)], d, hull.reaches());
    let [zero, half, whole] = [0.0, 0.5 * until, until].map(|t| d.splat(t));
    let to = T::select(hull.is_out_of_range(Within(d)), zero, whole);
    advancement.free_until::<K>(zero, to, half, d.splat(SHORTEST * until))
}

/// The corners of F at t = 0 and at t = 1, and d with all errors.
pub(super) struct Advancement<T> {
    start: [[T; 3]; 4],
    end: [[T; 3]; 4],
    limit: T,
}

impl Advancement<f64> {
    pub(super) fn of(corners: &Scaled) -> Self {
        let [start, end] = corners.at;
        Self::new([start, end], corners.d, corners.reach)
    }

    /// The time before which the distance is certainly above d, from one time to at most a later one,
    /// in stretches of at least a 4096th of the time between them.
    pub(super) fn free_after<K: Kind>(&self, from: f64, to: f64) -> f64 {
        let length = to - from;
        self.free_until::<K>(from, to, length, length / 8192.0)
    }
}

impl<T: Lanes> Advancement<T> {
    /// From corners that are rounded once, and the largest magnitude of a component on each axis.
    #[inline(always)]
    pub(super) fn new([start, end]: [[[T; 3]; 4]; 2], d: T, reach: [T; 3]) -> Self {
        let limit = limit(d, reach);
        Self { start, end, limit }
    }

    /// The time before which the distance is certainly above d, from one time to at most a later one.
    ///
    /// The direction at the beginning mostly suffices for all of it: g · x is linear in t for a constant g,
    /// so that it is above d |g| at all times if it is at both ends. Otherwise directions turn.
    ///
    /// A stretch has the length `first` at first. The next one is twice as long if the directions at
    /// its ends prove it free; otherwise it begins at the same time, and is half as long. All
    /// are longer than `shortest`, unless other lanes need more. There is none if the distance may be d
    /// from the beginning.
    #[inline(always)]
    pub(super) fn free_until<K: Kind>(&self, from: T, to: T, first: T, shortest: T) -> T {
        let corners = K::FEATURES.vertices.len();
        let mut now = self.at::<K>(from);
        let is_beyond = now.is_beyond(corners, self.limit);
        let is_free = is_beyond & now.is_beyond_at(&self.corners(to), corners, self.limit);
        let mut time = T::select(is_free, to, from);
        let mut length = T::select(is_beyond, first, first.splat(0.0));
        while T::any(to.gt(time) & length.gt(shortest)) {
            let end = (time + length).min(to);
            let then = self.at::<K>(end);
            let is_beyond = then.is_beyond(corners, self.limit);
            let across = now.is_beyond_across(&then, corners, self.limit);
            let is_free = is_beyond & across & end.gt(time);
            time = T::select(is_free, end, time);
            now = Heading::select(is_free, &then, &now);
            length = length * T::select(is_free, length.splat(2.0), length.splat(0.5));
        }
        time
    }

    #[inline(always)]
    pub(super) fn at<K: Kind>(&self, t: T) -> Heading<T> {
        let corners = self.corners(t);
        Heading::new(corners, nearest::<K, T>(&corners))
    }

    /// A corner results from that of the query, 1 − t, a product and a sum: four roundings.
    #[inline(always)]
    fn corners(&self, t: T) -> [[T; 3]; 4] {
        let mut corners = self.start;
        for (corner, end) in corners.iter_mut().zip(&self.end) {
            *corner = add(scaled(*corner, -t + 1.0), scaled(*end, t));
        }
        corners
    }
}
