//! A part of the step, and the tests of it.

use core::cmp::Ordering;

use arrayvec::ArrayVec;

use super::corners::{Corners, Curves};
use super::polynomial::{MOST, binomial};
use crate::filter::coplanarity::length_bound;
use crate::filter::gap::Gap;
use crate::filter::hull::approach_origin;
use crate::numbers::number::Lanes;
use crate::numbers::roundoff::{UNDERFLOW, UNIT, certain_sign, margin};
use crate::numbers::vector::{cross, cross_along, dot, minus};
use crate::tables::{Point, Tables};

/// A part of the step: F w lies in the hull of the control points of the corners there.
pub(super) struct Piece<'a> {
    corners: &'a Corners,
    curves: Curves,
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
    fn roundings(&self) -> u32 {
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
    /// diagonal of two, the normal of the planes at one end, or one of a few steps of Gilbert's iteration
    /// (see [`approach_origin`]). That of another part is tried first.
    pub(super) fn separating_direction<G: Gap<f64>>(&self, hint: Point, gap: G) -> Option<Point> {
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
            .or_else(|| self.iterated_direction(gap))
    }

    fn iterated_direction<G: Gap<f64>>(&self, gap: G) -> Option<Point> {
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
    fn normal(&self, end: usize) -> Point {
        let [a, b, c] = self
            .first_corners()
            .map(|corner| self.curves.corners[corner][end]);
        cross(minus(a, b), minus(a, c))
    }

    /// The first three corners, if there are as many; others are repeated.
    fn first_corners(&self) -> [usize; 3] {
        let last = self.curves.count - 1;
        [0, 1.min(last), 2.min(last)]
    }

    /// Returns true if the primitives certainly touch in this part, and only where they are coplanar.
    ///
    /// The volume c = x₀ · (x₁ × x₂) of the first three corners equals the volume of w, e₁ and e₂ in
    /// `exact/motion.rs`: the differences of the corners are the edges. Its signs at both ends of the part
    /// are opposite, so that it vanishes in between. The normal has one sign on an axis, and each side the
    /// required one, in all of the part: then `touches` holds there. A component of a cross product of two
    /// curves is a mean of those of their control points, of each with each, with the Bernstein polynomials
    /// as positive weights.
    pub(super) fn is_crossed<K: Tables>(&self) -> bool {
        if K::FEATURES.inner.is_none() {
            return false;
        }
        let last = self.curves.points - 1;
        let ends = [self.volume_sign(0), self.volume_sign(last)];
        if !matches!(ends, [Some(start), Some(end)] if start == end.reverse() && start.is_ne()) {
            return false;
        }
        let middle = self.normal(last / 2);
        let axis = (1..3).fold(0, |best, axis| {
            if middle[axis].abs() > middle[best].abs() {
                axis
            } else {
                best
            }
        });
        let Some(facing) = self.facing(axis) else {
            return false;
        };
        K::SIDES.iter().all(|side| {
            let [x, y] = side.corners.map(|corner| self.curves.corner(corner));
            let sign = self.constant_sign(axis, x, y, 0);
            sign == Some(if side.along { facing } else { facing.reverse() })
        })
    }

    /// Returns true if the volume of the first three corners certainly has one root in this part, at whose
    /// ends it has opposite signs.
    ///
    /// Its Bernstein coefficients of degree 3 n are means of volumes of control points, with products of
    /// binomial coefficients as weights, which are integers below 2⁵³. With one change of sign among the
    /// coefficients there is one root (Descartes' rule), whatever the sign of one between them that is not
    /// certain.
    pub(super) fn has_one_root(&self) -> bool {
        let points = self.curves.points;
        let [a, b, c] = self.first_corners().map(|corner| self.curves.corner(corner));
        let weights: [f64; MOST] = core::array::from_fn(|k| binomial(points - 1, k));
        let mut coefficients = [0.0; 3 * MOST];
        for (j, &y) in b.iter().enumerate() {
            for (k, &z) in c.iter().enumerate() {
                let normal = cross(y, z);
                for (i, &x) in a.iter().enumerate() {
                    coefficients[i + j + k] += dot(x, normal) * (weights[i] * weights[j] * weights[k]);
                }
            }
        }
        let [x, y, z] = self.corners.magnitude;
        let n = of_mean(self.corners.roundings + self.roundings(), points as u32);
        let error = x * y * z * (6.0 * margin(n) * UNIT) + UNDERFLOW;
        let degree = 3 * (points - 1);
        let coefficients = coefficients[..=degree].iter().enumerate();
        let signs = coefficients.map(|(m, &value)| certain_sign(value, error * binomial(degree, m)));
        let signs: ArrayVec<Option<Ordering>, { 3 * MOST }> = signs.collect();
        // Certain ones at the beginning and at the end, and at most one between them that is not.
        let start = signs.iter().take_while(|&&sign| sign == signs[0]).count();
        let end = signs
            .iter()
            .rev()
            .take_while(|&&sign| sign == signs[degree])
            .count();
        signs[0].is_some() && signs[degree] == signs[0].map(Ordering::reverse) && start + end >= degree
    }

    /// The sign of a component of e₁ × e₂, if it is constant. An edge is a difference of corners, one more
    /// rounding of twice the magnitude.
    fn facing(&self, axis: usize) -> Option<Ordering> {
        let [a, b, c] = self.first_corners().map(|corner| &self.curves.corners[corner]);
        let mut edges = [[[0.0; 3]; MOST]; 2];
        for k in 0..self.curves.points {
            edges[0][k] = minus(b[k], a[k]);
            edges[1][k] = minus(c[k], a[k]);
        }
        let [one, other] = [&edges[0][..self.curves.points], &edges[1][..self.curves.points]];
        // (b − a) × (c − a) is e₁ × e₂, of a vertex and a face and of two edges.
        self.constant_sign(axis, one, other, 1)
    }

    /// The sign of a component of the cross product of two curves, if it is constant in this part. Their
    /// control points are sums of 2ᵏ corners, with k more roundings.
    fn constant_sign(&self, axis: usize, x: &[Point], y: &[Point], k: u32) -> Option<Ordering> {
        let [next, last] = [[1, 2], [2, 0], [0, 1]][axis];
        let magnitude = self.corners.magnitude;
        let n = of_area(self.corners.roundings + self.roundings() + k);
        let scale = f64::from(1_u32 << (2 * k)) * (2.0 * margin(n) * UNIT);
        let error = magnitude[next] * magnitude[last] * scale + UNDERFLOW;
        let mut products = x
            .iter()
            .flat_map(|&x| y.iter().map(move |&y| cross_along(axis, x, y)));
        let sign = certain_sign(products.next()?, error)?;
        products
            .all(|product| certain_sign(product, error) == Some(sign))
            .then_some(sign)
    }

    /// The sign of the volume of the first three corners at one end, if it is certain: six terms.
    fn volume_sign(&self, end: usize) -> Option<Ordering> {
        let [a, b, c] = self
            .first_corners()
            .map(|corner| self.curves.corners[corner][end]);
        let [x, y, z] = self.corners.magnitude;
        let n = of_volume(self.corners.roundings + self.roundings());
        let error = x * y * z * (6.0 * margin(n) * UNIT) + UNDERFLOW;
        certain_sign(dot(a, cross(b, c)), error)
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
