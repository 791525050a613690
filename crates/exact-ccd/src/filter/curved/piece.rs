//! A part of the step, and the tests of it.

use super::corners::{Corners, Curves};
use crate::filter::coplanarity::length_bound;
use crate::filter::gap::Gap;
use crate::filter::hull::approach_origin;
use crate::numbers::number::Lanes;
use crate::numbers::roundoff::{UNDERFLOW, UNIT, margin};
use crate::numbers::vector::{cross, dot, minus};
use crate::tables::Point;

/// A part of the step: F w lies in the hull of the control points of the corners there.
#[derive(Clone)]
pub(super) struct Piece<'a> {
    pub(super) corners: &'a Corners,
    pub(super) curves: Curves,
    /// The part is from k 2⁻ⁿ to (k + 1) 2⁻ⁿ.
    index: u32,
    level: u32,
}

impl<'a> Piece<'a> {
    pub(super) fn whole(corners: &'a Corners) -> Self {
        Self {
            corners,
            curves: corners.curves,
            index: 0,
            level: 0,
        }
    }

    pub(super) fn level(&self) -> u32 {
        self.level
    }

    /// The times of both ends, which are exact.
    pub(super) fn times(&self) -> [f64; 2] {
        let unit = f64::from_bits((1023 - u64::from(self.level)) << 52);
        [0, 1].map(|end| f64::from(self.index + end) * unit)
    }

    pub(super) fn halves(&self) -> [Self; 2] {
        let [first, second] = self.curves.halves();
        let half = |curves: Curves, end: u32| Self {
            corners: self.corners,
            curves,
            index: 2 * self.index + end,
            level: self.level + 1,
        };
        [half(first, 0), half(second, 1)]
    }

    /// The roundings of each halving: one for each degree.
    pub(super) fn roundings(&self) -> u32 {
        self.level * (self.curves.points as u32 - 1)
    }

    /// The bound of d w, all errors included.
    fn gap(&self, gap: impl Gap<f64>) -> f64 {
        let weights = self.curves.weight[..self.curves.points].iter();
        let weight = weights.fold(0.0, |most: f64, &w| most.max(w));
        let error = self.corners.weight_magnitude * self.corners.error(self.roundings());
        weighted(gap.value(0.0), weight + error)
    }

    /// The bound of scalar products with a direction, which proves a distance above the gap.
    fn limit<G: Gap<f64>>(&self, direction: Point, gap: G) -> f64 {
        let error = self.corners.error(self.roundings() + ALONG);
        let limit = dot(direction.map(f64::abs), self.corners.magnitude) * error + UNDERFLOW;
        if G::IS_POSITIVE {
            limit + across(self.gap(gap), direction)
        } else {
            limit
        }
    }

    /// Returns true if all control points are certainly farther than the gap from the plane through the
    /// origin with this normal, on one side.
    pub(super) fn is_beyond<G: Gap<f64>>(&self, direction: Point, gap: G) -> bool {
        let limit = self.limit(direction, gap);
        let mut values = self.curves.all().map(|&point| dot(direction, point));
        let Some(first) = values.next() else {
            return false;
        };
        if first > limit {
            values.all(|value| value > limit)
        } else {
            first < -limit && values.all(|value| value < -limit)
        }
    }

    /// A direction along which the primitives are farther apart than the gap in the whole part: an axis, a
    /// diagonal of two, or the normal of the planes at one end. The direction of another part is tried first.
    pub(super) fn plain_direction<G: Gap<f64>>(&self, hint: Point, gap: G) -> Option<Point> {
        const PLANES: [Point; 9] = [
            [1.0, 0.0, 0.0],
            [0.0, 1.0, 0.0],
            [0.0, 0.0, 1.0],
            [1.0, 1.0, 0.0],
            [1.0, -1.0, 0.0],
            [0.0, 1.0, 1.0],
            [0.0, 1.0, -1.0],
            [1.0, 0.0, 1.0],
            [-1.0, 0.0, 1.0],
        ];
        let is_beyond = |direction: &Point| self.is_beyond(*direction, gap);
        let ends = [0, self.curves.points - 1];
        core::iter::once(hint)
            .chain(PLANES)
            .find(is_beyond)
            .or_else(|| ends.map(|end| self.normal(end)).into_iter().find(is_beyond))
    }

    /// Such a direction from a few steps of Gilbert's iteration (see [`approach_origin`]).
    pub(super) fn iterated_direction<G: Gap<f64>>(&self, gap: G) -> Option<Point> {
        let lowest_along = |direction: Point| {
            let values = self.curves.all().map(|&point| (point, dot(direction, point)));
            values.fold(([0.0; 3], f64::INFINITY), |lowest, next| {
                if next.1 < lowest.1 { next } else { lowest }
            })
        };
        let nearest = self.curves.all().fold([f64::INFINITY; 3], |best, &point| {
            if dot(point, point) < dot(best, best) {
                point
            } else {
                best
            }
        });
        approach_origin(nearest, self.gap(gap), lowest_along, |direction| {
            self.limit(direction, gap)
        })
    }

    /// c₁ × c₂ of the first three corners at one end, times a positive factor: the edges of F's image there
    /// are differences of them.
    pub(super) fn normal(&self, end: usize) -> Point {
        let [a, b, c] = self
            .first_corners()
            .map(|corner| self.curves.corners[corner][end]);
        cross(minus(a, b), minus(a, c))
    }

    /// The first three corners, if there are as many; others are repeated.
    pub(super) fn first_corners(&self) -> [usize; 3] {
        let last = self.curves.count - 1;
        [0, 1.min(last), 2.min(last)]
    }
}

/// The roundings of a scalar product with a direction: a product and two sums.
pub(super) const ALONG: u32 = 3;

/// The roundings of a component of a cross product of vectors with n: n for each factor, a product and a
/// difference.
pub(super) const fn of_area(n: u32) -> u32 {
    2 * n + 2
}

/// The roundings of a volume of vectors with n: n for each factor, two products, a difference and two
/// sums.
pub(super) const fn of_volume(n: u32) -> u32 {
    3 * n + 5
}

/// The roundings of a mean of volumes of vectors with n, by curves with some number of control points: a
/// product, and fewer sums than there are pairs of control points.
pub(super) const fn of_mean(n: u32, points: u32) -> u32 {
    of_volume(n) + 1 + points * points
}

/// d w, not rounded down, for a weight that is rounded once.
pub(super) fn weighted<T: Lanes>(d: T, weight: T) -> T {
    d * weight * (1.0 + margin(3) * UNIT)
}

/// The least scalar product with a direction that proves a distance, not rounded down. The length has five
/// roundings; there are two products, and the sum that follows.
pub(super) fn across<T: Lanes>(distance: T, direction: [T; 3]) -> T {
    distance * (length_bound(direction) * (1.0 + margin(8) * UNIT))
}
