//! Advancement: stretches of time, from the left, in which a direction, constant or turning, keeps the
//! primitives farther than d apart. For one query, or for many side by side.

use arrayvec::ArrayVec;

use super::nearest::nearest;
use super::scaled::Scaled;
use super::turning::{Heading, limit};
use crate::filter::gap::Within;
use crate::filter::hull::Hull;
use crate::numbers::number::Lanes;
use crate::numbers::vector::{add, scaled};
use crate::tables::Tables;

/// The time before which the distance is certainly above d, in each lane: `until`, above 0, if it is so at
/// all times until then. It is 0 where the coordinates or d are out of range.
#[inline(always)]
pub(crate) fn free_until<K: Tables, T: Lanes>(hull: &Hull<T>, d: T, until: f64) -> T {
    /// A proof is tried in stretches that are longer than this fraction of the time until which it is tried.
    const SHORTEST: f64 = 1.0 / 64.0;
    let advancement = Advancement::new([hull.corners(0), hull.corners(1)], d, hull.reaches());
    let free = advancement.free_until::<K>([0.0, until], SHORTEST * until);
    T::select(hull.is_out_of_range(Within(d)), d.splat(0.0), free)
}

/// The most ends of stretches that wait: a stretch is halved at most 13 times, from the whole of it.
const MOST_AHEAD: usize = 16;

/// An end of a stretch.
struct Stop<T: Lanes> {
    time: f64,
    heading: Heading<T>,
    /// True where the distance is certainly above d at this time.
    is_beyond: T::Mask,
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
    pub(super) fn free_after<K: Tables>(&self, from: f64, to: f64) -> f64 {
        self.free_until::<K>([from, to], (to - from) / 8192.0)
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
    /// The first stretch is all of the time. A stretch that the directions at its ends do not prove free is
    /// halved, if both halves are longer than `shortest`, so that a direction is computed once for each time.
    /// All lanes have the same times. A lane waits while a stretch is halved that is proved for it.
    #[inline(always)]
    pub(super) fn free_until<K: Tables>(&self, [from, to]: [f64; 2], shortest: f64) -> T {
        let corners = K::FEATURES.vertices.len();
        let limit = self.limit;
        let [start, end] = [from, to].map(|time| limit.splat(time));
        let mut now = self.stop::<K>(from);
        let is_free = now.is_beyond & now.heading.is_beyond_at(&self.corners(end), corners, limit);
        let mut time = T::select(is_free, end, start);
        // True in the lanes in which all time until now is proved.
        let mut proved = now.is_beyond;
        let mut ahead = ArrayVec::<Stop<T>, MOST_AHEAD>::new();
        if T::any(proved & !is_free) {
            ahead.push(self.stop::<K>(to));
        }
        while let Some(then) = ahead.last() {
            let waits = proved & !time.gt(limit.splat(now.time));
            let across = now.heading.is_beyond_across(&then.heading, corners, limit);
            let is_free = waits & then.is_beyond & across;
            time = T::select(is_free, limit.splat(then.time), time);
            let is_left = waits & !is_free;
            if T::any(is_left) {
                let (middle, half) = (0.5 * (now.time + then.time), 0.5 * (then.time - now.time));
                if half > shortest && middle > now.time && middle < then.time && !ahead.is_full() {
                    ahead.push(self.stop::<K>(middle));
                    continue;
                }
                proved = proved & !is_left;
                if !T::any(proved & end.gt(time)) {
                    break;
                }
            }
            if let Some(then) = ahead.pop() {
                now = then;
            }
        }
        time
    }

    #[inline(always)]
    fn stop<K: Tables>(&self, time: f64) -> Stop<T> {
        let heading = self.at::<K>(self.limit.splat(time));
        Stop {
            time,
            is_beyond: heading.is_beyond(K::FEATURES.vertices.len(), self.limit),
            heading,
        }
    }

    #[inline(always)]
    pub(super) fn at<K: Tables>(&self, t: T) -> Heading<T> {
        let corners = self.corners(t);
        Heading::new(corners, nearest::<K, T>(&corners))
    }

    /// A corner has four roundings: the query's corner, 1 − t, a product and a sum.
    #[inline(always)]
    fn corners(&self, t: T) -> [[T; 3]; 4] {
        let mut corners = self.start;
        for (corner, end) in corners.iter_mut().zip(&self.end) {
            *corner = add(scaled(*corner, -t + 1.0), scaled(*end, t));
        }
        corners
    }
}
