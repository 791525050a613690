//! Changes of a query that leave its contact times as they are, bit for bit.

use crate::primitives::{Points, Primitives};

/// Other names for the points, and other axes.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Symmetry {
    /// Picks one of the orders of the points that leave the primitives what they are.
    pub(crate) renaming: usize,
    /// For each axis, the one that takes its place.
    pub(crate) axes: [usize; 3],
    /// Which axes are mirrored.
    pub(crate) mirrored: [bool; 3],
    /// By which power of two an axis is stretched, unless that would round.
    pub(crate) exponents: [i32; 3],
}

impl Symmetry {
    pub(crate) fn apply<K: Primitives>(&self, points: &Points) -> Points {
        let order = K::RENAMINGS[self.renaming % K::RENAMINGS.len()];
        let factors = [0, 1, 2].map(|axis: usize| self.factor(points, axis));
        points.map(|now| order.map(|point| self.axes.map(|axis| now[point][axis] * factors[axis])))
    }

    fn factor(&self, points: &Points, axis: usize) -> f64 {
        let sign = if self.mirrored[axis] { -1.0 } else { 1.0 };
        let power = 2f64.powi(self.exponents[axis]);
        let is_exact = |x: f64| (x * power).is_finite() && x * power / power == x;
        let all_exact = points.as_flattened().iter().all(|point| is_exact(point[axis]));
        if all_exact { sign * power } else { sign }
    }
}
