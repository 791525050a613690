//! F, one coordinate at a time, in floating-point or interval arithmetic.

use exact_ccd::{EdgeEdge, Kind, Point, VertexFace};

use super::cell::Cell;
use crate::ring::Ring;

/// The coordinates of the four points of a query over time.
pub(crate) struct Coordinates<T> {
    /// The points at t = 0, by axis.
    start: [[T; 4]; 3],
    /// Their displacements until t = 1.
    displacement: [[T; 4]; 3],
}

impl<T: Ring + Copy + From<f64>> Coordinates<T> {
    pub(crate) fn new(points: &[[Point; 4]; 2]) -> Self {
        let [start, end]: [[[T; 4]; 3]; 2] =
            points.map(|points| [0, 1, 2].map(|axis| points.map(|point| point[axis].into())));
        let displacement =
            [0, 1, 2].map(|axis| [0, 1, 2, 3].map(|point| end[axis][point] - start[axis][point]));
        Self { start, displacement }
    }

    /// A coordinate of the points at the time t.
    #[inline]
    pub(crate) fn at(&self, axis: usize, t: T) -> [T; 4] {
        let (x, d) = (&self.start[axis], &self.displacement[axis]);
        [d[0] * t + x[0], d[1] * t + x[1], d[2] * t + x[2], d[3] * t + x[3]]
    }
}

/// F for a kind of query.
pub(crate) trait Gap: Kind<Points = [Point; 4]> {
    /// The edges along which u and v run, as the points they lead from and to.
    const EDGES: [[usize; 2]; 2];

    /// A coordinate of F, from that coordinate of the four points.
    fn gap<T: Ring + Copy>(points: [T; 4], u: T, v: T) -> T;

    /// Returns true if a part of the box lies in the domain.
    fn meets_domain(cell: &Cell<3>) -> bool;
}

impl Gap for VertexFace {
    const EDGES: [[usize; 2]; 2] = [[1, 2], [1, 3]];

    #[inline]
    fn gap<T: Ring + Copy>([p, v1, v2, v3]: [T; 4], u: T, v: T) -> T {
        p - ((v2 - v1) * u + (v3 - v1) * v + v1)
    }

    /// u + v ≤ 1 at the lower ends, whose sum is exact: they are multiples of ε, and it is at most 2.
    #[inline]
    fn meets_domain(cell: &Cell<3>) -> bool {
        let [_, u, v] = cell.lower;
        u + v <= 1.0
    }
}

impl Gap for EdgeEdge {
    const EDGES: [[usize; 2]; 2] = [[0, 1], [2, 3]];

    #[inline]
    fn gap<T: Ring + Copy>([a0, a1, b0, b1]: [T; 4], u: T, v: T) -> T {
        ((a1 - a0) * u + a0) - ((b1 - b0) * v + b0)
    }

    #[inline]
    fn meets_domain(_: &Cell<3>) -> bool {
        true
    }
}
