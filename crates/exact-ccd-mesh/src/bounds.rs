//! Axis-aligned boxes around moving points.

use exact_ccd::Point;

/// A closed axis-aligned box.
///
/// Boxes are made by comparisons alone: no coordinate is rounded or inflated. A point that moves in a straight line
/// stays in the box of its two ends, and an edge or a face in the box of its vertices' boxes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bounds {
    /// The least coordinates.
    pub lower: Point,
    /// The greatest coordinates.
    pub upper: Point,
}

impl Bounds {
    /// The box of nothing: the neutral element of [`union`](Self::union).
    pub const EMPTY: Self = Self {
        lower: [f64::INFINITY; 3],
        upper: [f64::NEG_INFINITY; 3],
    };

    /// The box of one point.
    #[must_use]
    pub fn of(point: Point) -> Self {
        Self {
            lower: point,
            upper: point,
        }
    }

    /// The smallest box around two boxes.
    #[must_use]
    pub fn union(&self, other: &Self) -> Self {
        // Not f64::min and max: their care for NaN costs, and there is none here.
        let lesser = |a: f64, b: f64| if b < a { b } else { a };
        let greater = |a: f64, b: f64| if b > a { b } else { a };
        Self {
            lower: core::array::from_fn(|axis| lesser(self.lower[axis], other.lower[axis])),
            upper: core::array::from_fn(|axis| greater(self.upper[axis], other.upper[axis])),
        }
    }

    /// Whether the boxes have a common point. Boxes that touch have.
    #[must_use]
    #[inline]
    pub fn overlaps(&self, other: &Self) -> bool {
        // Without short circuit: six comparisons cost less than a branch that is hard to predict.
        (0..3).fold(true, |all, axis| {
            all & (self.lower[axis] <= other.upper[axis]) & (other.lower[axis] <= self.upper[axis])
        })
    }
}

/// The smallest box around some points.
impl FromIterator<Point> for Bounds {
    fn from_iter<T: IntoIterator<Item = Point>>(points: T) -> Self {
        points
            .into_iter()
            .fold(Self::EMPTY, |bounds, point| bounds.union(&Self::of(point)))
    }
}
