//! Changes of a query that do not change its contact times, bit for bit.

use crate::primitives::{Points, Primitives};

/// A permutation of the points and of the axes, with mirrored and stretched axes.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Symmetry {
    /// The index of an order of the points that describes the same primitives.
    pub(crate) renaming: usize,
    /// For each axis, the axis that replaces it.
    pub(crate) axes: [usize; 3],
    /// True for each mirrored axis.
    pub(crate) mirrored: [bool; 3],
    /// The exponents of the powers of two by which the axes are stretched, unless that would round.
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
