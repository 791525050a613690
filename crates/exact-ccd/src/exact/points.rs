//! The four moving points of a query in integers.

use super::dyadic::to_integers;
use super::polynomial::{Polynomial, Vector};
use crate::tables::{Difference, Points};

/// The points of a query as polynomials in t. The coordinates on an axis are integers of a unit of its own,
/// a power of two: contact is invariant under scalings of an axis.
#[derive(Clone, Debug)]
pub(crate) struct MovingPoints {
    points: [Vector; 4],
    /// The exponent of the unit of each axis; none if all coordinates are 0.
    units: [Option<i32>; 3],
}

impl MovingPoints {
    pub(crate) fn new(points: &Points<f64>) -> Self {
        let mut units = [None; 3];
        let axes = [0, 1, 2].map(|axis: usize| {
            let at = |i: usize| points[i / 4][i % 4][axis];
            let (integers, unit) = to_integers([0, 1, 2, 3, 4, 5, 6, 7].map(at));
            units[axis] = unit;
            [0, 1, 2, 3].map(|point| Polynomial::between(&integers[point], &integers[point + 4]))
        });
        let points = [0, 1, 2, 3].map(|point| [0, 1, 2].map(|axis: usize| axes[axis][point].clone()));
        Self { points, units }
    }

    /// The difference of two points.
    pub(crate) fn difference(&self, (i, j): Difference) -> Vector {
        [0, 1, 2].map(|axis: usize| &self.points[i][axis] - &self.points[j][axis])
    }

    /// The least exponent of a unit; none if all coordinates are 0.
    pub(super) fn least_unit(&self) -> Option<i32> {
        self.units.into_iter().flatten().min()
    }

    /// A vector of such coordinates with one unit for all axes, as lengths and angles need it: the least
    /// one.
    pub(super) fn to_scale(&self, vector: Vector) -> Vector {
        self.in_unit(vector, self.least_unit().unwrap_or_default())
    }

    /// A vector of such coordinates in a unit that is not above the least one.
    fn in_unit(&self, vector: Vector, unit: i32) -> Vector {
        [0, 1, 2].map(|axis: usize| {
            let shift = self.units[axis].map_or(0, |own| own - unit);
            vector[axis].shifted(shift.unsigned_abs() as usize)
        })
    }

    /// The same points with this unit, not above the least one, for all axes.
    pub(super) fn scaled_to(&self, unit: i32) -> Self {
        Self {
            points: self.points.clone().map(|point| self.in_unit(point, unit)),
            units: [Some(unit); 3],
        }
    }

    /// The same points with other coordinates.
    pub(super) fn map(&self, mut change: impl FnMut(&Polynomial) -> Polynomial) -> Self {
        let mut change = |vector: &Vector| [0, 1, 2].map(|axis: usize| change(&vector[axis]));
        Self {
            points: [0, 1, 2, 3].map(|point: usize| change(&self.points[point])),
            units: self.units,
        }
    }
}
