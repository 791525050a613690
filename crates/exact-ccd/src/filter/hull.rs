//! Separating directions: F(t, u, v) stays in the convex hull of its values at the corners of the domain, so that
//! a plane through the origin with all corners strictly on one side proves that F has no root.

use super::{LARGEST, UNDERFLOW, UNIT};
use crate::kind::Kind;
use crate::query::{Point, Query};

/// The eight values of F at the corners of its domain, by axis. (A vertex-face query has six; two are repeated.)
pub(super) struct Hull {
    corners: [[f64; 8]; 3],
    low: Point,
    high: Point,
}

impl Hull {
    #[inline]
    pub(super) fn new<K: Kind>(query: &Query<K>) -> Self {
        let mut corners = [[0.0; 8]; 3];
        let (mut low, mut high) = ([0.0; 3], [0.0; 3]);
        for axis in 0..3 {
            let row = &mut corners[axis];
            for (time, points) in query.points().iter().enumerate() {
                for (corner, &(i, j)) in K::CORNERS.iter().enumerate() {
                    row[4 * time + corner] = points[i][axis] - points[j][axis];
                }
            }
            (low[axis], high[axis]) = row.iter().fold((row[0], row[0]), |(low, high), &x| {
                (if x < low { x } else { low }, if x > high { x } else { high })
            });
        }
        Self { corners, low, high }
    }

    /// Whether the bounding box of the corners leaves out the origin. Exact: the sign of a difference of two f64 is
    /// right even when the difference is rounded, overflows or is subnormal.
    #[inline]
    pub(super) fn box_excludes_origin(&self) -> bool {
        (0..3).any(|axis| self.low[axis] > 0.0 || self.high[axis] < 0.0)
    }

    /// Whether all corners are strictly on one side of a plane x = ±y, y = ±z or z = ±x. Exact: rounding is monotone, so
    /// that what is less after it was less before.
    #[inline]
    pub(super) fn is_beyond_diagonal(&self) -> bool {
        [[0, 1], [1, 2], [2, 0]]
            .into_iter()
            .any(|[i, j]| are_beyond_diagonal(self.corners[i].into_iter().zip(self.corners[j])))
    }

    /// The largest magnitude of the corners along an axis.
    #[inline]
    fn reach(&self, axis: usize) -> f64 {
        if self.high[axis] > -self.low[axis] {
            self.high[axis]
        } else {
            -self.low[axis]
        }
    }

    /// Whether no corner is farther from the origin along any axis than the filters can take.
    #[inline]
    pub(super) fn is_in_range(&self) -> bool {
        (0..3).all(|axis| self.reach(axis) <= LARGEST)
    }

    /// The mean of the corners, to within rounding: as a direction it needs no accuracy.
    fn centroid(&self) -> Point {
        [0, 1, 2].map(|axis: usize| self.corners[axis].iter().sum::<f64>() / 8.0)
    }

    #[inline]
    fn along(&self, direction: Point) -> [f64; 8] {
        let [x, y, z] = &self.corners;
        core::array::from_fn(|i| direction[0] * x[i] + direction[1] * y[i] + direction[2] * z[i])
    }

    /// The error of a scalar product: a corner is rounded once, then there are one product and two sums, n = 4.
    #[inline]
    fn error_along(&self, direction: Point) -> f64 {
        let terms = [0, 1, 2].map(|axis: usize| direction[axis].abs() * self.reach(axis));
        8.0 * UNIT * (terms[0] + terms[1] + terms[2]) + UNDERFLOW
    }

    /// Whether all corners certainly lie strictly on the same side of the plane through the origin across a direction.
    #[inline]
    pub(super) fn is_beyond(&self, direction: Point) -> bool {
        let error = self.error_along(direction);
        let values = self.along(direction);
        let above = values.iter().fold(true, |all, &value| all & (value > error));
        let below = values.iter().fold(true, |all, &value| all & (value < -error));
        above | below
    }

    /// Whether a few steps of Gilbert's iteration (An iterative procedure for computing the minimum of a quadratic form
    /// on a convex set, 1966), from the centroid towards the point of the hull next to the origin, find a separating direction.
    pub(super) fn is_beyond_some_direction(&self) -> bool {
        const STEPS: usize = 6;
        let mut nearest = self.centroid();
        for _ in 0..STEPS {
            if self.is_beyond(nearest) {
                return true;
            }
            let values = self.along(nearest);
            let lowest = (1..8).fold(0, |best, i| if values[i] < values[best] { i } else { best });
            // The point next to the origin on the segment from here to the lowest corner.
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

/// Whether some points of a plane are all strictly on one side of one of its diagonals, x = y or x = −y.
#[inline]
pub(crate) fn are_beyond_diagonal(points: impl Iterator<Item = (f64, f64)>) -> bool {
    let mut sides = [true; 4];
    for (x, y) in points {
        sides[0] &= x > y;
        sides[1] &= x < y;
        sides[2] &= x > -y;
        sides[3] &= x < -y;
    }
    sides != [false; 4]
}

fn dot(a: Point, b: Point) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}
