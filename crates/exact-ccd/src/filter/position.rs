//! The position of the primitives in their common plane, at a time in a bracket.

use core::cmp::Ordering;

use crate::numbers::cubic::Root;
use crate::numbers::roundoff::{UNDERFLOW, UNIT, certain_sign, margin};
use crate::numbers::vector::{cross_along, cross_magnitude_along, interpolate};
use crate::tables::{Difference, Point, Points, Tables};

/// The position of two coplanar primitives.
#[derive(Clone, Copy, PartialEq)]
pub(super) enum Position {
    /// They touch.
    Inside,
    /// They do not touch.
    Outside,
}

/// The difference of two points at any time in a bracket.
pub(super) struct VectorEstimate {
    /// The difference near the middle of the bracket.
    value: Point,
    /// The larger magnitude of each coordinate at t = 0 and t = 1.
    magnitude: Point,
}

/// A number at any time in a bracket, to within an error. If the error is zero, so is the number.
pub(super) struct Estimate {
    pub(super) value: f64,
    pub(super) error: f64,
}

impl Estimate {
    /// The sign, if it is certain in the whole bracket.
    fn sign(&self) -> Option<Ordering> {
        certain_sign(self.value, self.error).or((self.error == 0.0).then_some(Ordering::Equal))
    }
}

/// The position of the primitives at a root, if it is certain, by the same tests as in the exact
/// path.
pub(super) fn at<K: Tables>(points: &Points<f64>, root: &Root) -> Option<Position> {
    let bracket = NearRoot::new(points, root);
    let [_, e1, e2] = K::SPAN.map(|difference| bracket.vector(difference));
    let normal = bracket.cross(&e1, &e2);
    let corners = K::CORNERS.map(|difference| bracket.vector(difference));
    let axis = longest(&normal);
    let mut position = Some(Position::Inside);
    for side in K::SIDES {
        let [x, y] = side.corners.map(|corner| &corners[corner]);
        // In one plane, the components of both cross products have the same ratio: one certain
        // component is enough.
        let verdict = |axis: usize| match (normal[axis].sign()?, bracket.cross_along(axis, x, y).sign()?) {
            (Ordering::Equal, _) => None,
            (_, Ordering::Equal) => Some(Position::Inside),
            (normal, area) if (normal == area) == side.along => Some(Position::Inside),
            _ => Some(Position::Outside),
        };
        match verdict(axis).or_else(|| (0..3).find_map(verdict)) {
            Some(Position::Inside) => {}
            Some(Position::Outside) => return Some(Position::Outside),
            None => position = None,
        }
    }
    position
}

/// The axis of the component with the largest magnitude.
pub(super) fn longest(vector: &[Estimate; 3]) -> usize {
    let magnitude = |axis: usize| vector[axis].value.abs();
    (1..3).fold(0, |best, axis| {
        if magnitude(axis) > magnitude(best) {
            axis
        } else {
            best
        }
    })
}

/// A query in a bracket of time around a root.
pub(super) struct NearRoot<'a> {
    points: &'a Points<f64>,
    near: f64,
    /// A bound of the error of a difference, relative to its magnitude: two ends rounded once, (1 −
    /// t), a product and a sum, n = 4; and |d₁ − d₀| ≤ 2 max(|d₀|, |d₁|) times the distance of the
    /// time from `near`.
    slack: f64,
}

impl<'a> NearRoot<'a> {
    pub(super) fn new(points: &'a Points<f64>, root: &Root) -> Self {
        Self {
            points,
            near: root.near,
            slack: margin(4) * UNIT + 4.0 * root.radius(),
        }
    }

    pub(super) fn vector(&self, (i, j): Difference) -> VectorEstimate {
        let [start, end] = self.points;
        let mut vector = VectorEstimate {
            value: [0.0; 3],
            magnitude: [0.0; 3],
        };
        for axis in 0..3 {
            let (start, end) = (start[i][axis] - start[j][axis], end[i][axis] - end[j][axis]);
            vector.value[axis] = interpolate(start, end, self.near);
            let (start, end) = (start.abs(), end.abs());
            vector.magnitude[axis] = if start > end { start } else { end };
        }
        vector
    }

    /// A component of a difference.
    pub(super) fn component(&self, vector: &VectorEstimate, axis: usize) -> Estimate {
        Estimate {
            value: vector.value[axis],
            error: self.slack * vector.magnitude[axis] + UNDERFLOW,
        }
    }

    /// The components of a × b.
    pub(super) fn cross(&self, a: &VectorEstimate, b: &VectorEstimate) -> [Estimate; 3] {
        [0, 1, 2].map(|axis| self.cross_along(axis, a, b))
    }

    /// A component of a × b. Each factor is off by `slack` of its magnitude, each product by 2
    /// slack + slack² and n = 2 more roundings. Zero is certain where each product has a factor that
    /// is zero at both ends of the step, as happens when a vertex and an edge share a coordinate.
    pub(super) fn cross_along(&self, axis: usize, a: &VectorEstimate, b: &VectorEstimate) -> Estimate {
        let [next, last] = [[1, 2], [2, 0], [0, 1]][axis];
        let relative = 2.0 * self.slack + self.slack * self.slack + margin(2) * UNIT;
        let vanishes = |i: usize, j: usize| a.magnitude[i] == 0.0 || b.magnitude[j] == 0.0;
        let magnitude = cross_magnitude_along(axis, a.magnitude, b.magnitude);
        Estimate {
            value: cross_along(axis, a.value, b.value),
            error: if vanishes(next, last) && vanishes(last, next) {
                0.0
            } else {
                relative * magnitude + UNDERFLOW
            },
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_sign_is_certain_beyond_its_error() {
        let sign = |value, error| Estimate { value, error }.sign();
        assert_eq!(sign(0.5, 1.0), None);
        assert_eq!(sign(0.0, 1.0), None);
        assert_eq!(sign(0.0, 0.0), Some(Ordering::Equal));
        assert_eq!(sign(-2.0, 1.0), Some(Ordering::Less));
    }
}
