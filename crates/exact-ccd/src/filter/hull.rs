//! Separating directions: F(t, u, v) lies in the convex hull of its values at the corners of the
//! domain. So F has no root if all these values lie strictly on one side of a plane through the
//! origin.

use super::coplanarity::length_bound;
use super::number::{Lanes, Points, subtract};
use super::roundoff::{LARGEST, UNDERFLOW, UNIT};
use super::vector::dot;
use crate::kind::Kind;
use crate::point::Point;

/// The eight values of F at the corners of its domain, by axis. A vertex-face query has six
/// corners, two of which are repeated.
pub(crate) struct Hull<T> {
    corners: [[T; 8]; 3],
    low: [T; 3],
    high: [T; 3],
}

impl<T: Lanes> Hull<T> {
    #[inline(always)]
    pub(crate) fn new<K: Kind>(points: &Points<T>) -> Self {
        let mut corners = points[0][0].map(|x| [x; 8]);
        for (corner, &difference) in K::CORNERS.iter().enumerate() {
            for (time, at_time) in subtract::<T>(points, difference).iter().enumerate() {
                for axis in 0..3 {
                    corners[axis][4 * time + corner] = at_time[axis];
                }
            }
        }
        let (mut low, mut high) = (corners.map(|row| row[0]), corners.map(|row| row[0]));
        for axis in 0..3 {
            for &x in &corners[axis][1..] {
                low[axis] = x.min(low[axis]);
                high[axis] = x.max(high[axis]);
            }
        }
        Self { corners, low, high }
    }

    /// The largest magnitude of the corners along an axis.
    #[inline(always)]
    fn reach(&self, axis: usize) -> T {
        self.high[axis].max(-self.low[axis])
    }

    /// The same of all axes.
    #[inline(always)]
    pub(crate) fn reaches(&self) -> [T; 3] {
        [self.reach(0), self.reach(1), self.reach(2)]
    }

    /// True where a coordinate of a corner exceeds [`LARGEST`].
    #[inline(always)]
    pub(crate) fn is_out_of_range(&self) -> T::Mask {
        let largest = self.low[0].splat(LARGEST);
        self.reach(0).gt(largest) | self.reach(1).gt(largest) | self.reach(2).gt(largest)
    }

    /// The corners at t = 0 or at t = 1.
    #[inline(always)]
    pub(crate) fn corners(&self, time: usize) -> [[T; 3]; 4] {
        let [x, y, z] = &self.corners;
        let i = 4 * time;
        [
            [x[i], y[i], z[i]],
            [x[i + 1], y[i + 1], z[i + 1]],
            [x[i + 2], y[i + 2], z[i + 2]],
            [x[i + 3], y[i + 3], z[i + 3]],
        ]
    }

    #[inline(always)]
    fn along(&self, direction: [T; 3]) -> [T; 8] {
        let [x, y, z] = &self.corners;
        let mut along = *x;
        for i in 0..8 {
            along[i] = direction[0] * x[i] + direction[1] * y[i] + direction[2] * z[i];
        }
        along
    }

    /// The error bound of a scalar product. Its roundings are that of the corner, one product and two
    /// sums: n = 4.
    #[inline(always)]
    fn error_along(&self, direction: [T; 3]) -> T {
        let [x, y, z] = direction.map(Lanes::abs);
        (x * self.reach(0) + y * self.reach(1) + z * self.reach(2)) * (8.0 * UNIT) + UNDERFLOW
    }

    /// True where all corners certainly lie strictly on the same side of the plane through the
    /// origin with this normal.
    #[inline(always)]
    pub(super) fn separates(&self, direction: [T; 3]) -> T::Mask {
        self.separates_by(direction, direction[0].splat(0.0))
    }

    /// True where all corners are certainly farther than d from the plane through the origin with this
    /// normal, on the same side. The product of d and the length has six roundings.
    #[inline(always)]
    pub(crate) fn is_beyond(&self, direction: [T; 3], d: T) -> T::Mask {
        self.separates_by(direction, d * (length_bound(direction) * (1.0 + 16.0 * UNIT)))
    }

    #[inline(always)]
    fn separates_by(&self, direction: [T; 3], least: T) -> T::Mask {
        let error = self.error_along(direction) + least;
        let [first, rest @ ..] = self.along(direction);
        let (mut above, mut below) = (first.gt(error), (-first).gt(error));
        for value in rest {
            above = above & value.gt(error);
            below = below & (-value).gt(error);
        }
        above | below
    }
}

impl Hull<f64> {
    /// Returns true if the bounding box of the corners does not contain the origin. Exact: the sign
    /// of a difference of two f64 is right even when the difference is rounded, overflows or is
    /// subnormal.
    #[inline]
    pub(super) fn box_excludes_origin(&self) -> bool {
        (0..3).any(|axis| self.low[axis] > 0.0 || self.high[axis] < 0.0)
    }

    /// Returns true if all corners are strictly on one side of a plane x = ±y, y = ±z or z = ±x.
    /// Exact: rounding is monotone, so that the exact differences are in strict order if the rounded
    /// ones are.
    #[inline]
    pub(super) fn diagonal_separates(&self) -> bool {
        [[0, 1], [1, 2], [2, 0]]
            .into_iter()
            .any(|[i, j]| diagonal_separates(self.corners[i].into_iter().zip(self.corners[j])))
    }

    /// The mean of the corners, a direction that need not be accurate.
    fn centroid(&self) -> Point {
        [0, 1, 2].map(|axis: usize| self.corners[axis].iter().sum::<f64>() / 8.0)
    }

    /// Returns true if Gilbert's iteration (An iterative procedure for computing the minimum of a
    /// quadratic form on a convex set, 1966) finds a separating direction in a few steps. It
    /// starts at the centroid and approaches the point of the hull nearest to the origin.
    pub(super) fn some_direction_separates(&self) -> bool {
        const STEPS: usize = 6;
        let mut nearest = self.centroid();
        for _ in 0..STEPS {
            if self.separates(nearest) {
                return true;
            }
            let values = self.along(nearest);
            let lowest = (1..8).fold(0, |best, i| if values[i] < values[best] { i } else { best });
            // The point nearest to the origin on the segment from `nearest` to the corner `lowest`.
            let back = [0, 1, 2].map(|axis: usize| nearest[axis] - self.corners[axis][lowest]);
            let squared_length = dot(back, back);
            let step = dot(back, nearest) / squared_length;
            if step.is_nan() || step <= 0.0 {
                return false;
            }
            nearest = [0, 1, 2].map(|axis: usize| nearest[axis] - step.min(1.0) * back[axis]);
        }
        false
    }
}

/// Returns true if all points (x, y) are strictly on one side of one of the diagonals x = y and x =
/// −y.
#[inline]
fn diagonal_separates(points: impl Iterator<Item = (f64, f64)>) -> bool {
    let mut sides = [true; 4];
    for (x, y) in points {
        sides[0] &= x > y;
        sides[1] &= x < y;
        sides[2] &= x > -y;
        sides[3] &= x < -y;
    }
    sides != [false; 4]
}
