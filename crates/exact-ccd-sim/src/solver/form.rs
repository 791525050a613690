//! Sums of terms of one kind.

use exact_ccd_mesh::Point;
use nalgebra::Vector3;
use rayon::prelude::*;

use crate::energy::Energy;

/// A sum of terms of one kind, times a factor. Terms are computed in parallel and added in order.
pub(crate) struct Form<'a> {
    pub(super) terms: Vec<&'a dyn Energy>,
    pub(super) factor: f64,
}

/// The number of terms whose derivatives are in memory at a time.
const CHUNK: usize = 1024;

impl<'a> Form<'a> {
    /// The sum of these terms.
    pub(crate) fn of<E: Energy>(terms: &'a [E], factor: f64) -> Self {
        let terms = terms.iter().map(|term| term as &dyn Energy).collect();
        Self { terms, factor }
    }

    /// The value.
    pub(crate) fn value(&self, points: &[Point]) -> f64 {
        let values: Vec<f64> = self.terms.par_iter().map(|term| term.value(points)).collect();
        self.factor * values.iter().sum::<f64>()
    }

    /// Adds the gradient to that of other sums.
    pub(crate) fn add_gradient(&self, points: &[Point], sum: &mut [Vector3<f64>]) {
        self.each(
            |term| term.gradient(points),
            |term, forces| {
                for (place, &vertex) in term.vertices().iter().enumerate() {
                    sum[vertex as usize] += forces.fixed_rows::<3>(3 * place) * self.factor;
                }
            },
        );
    }

    /// The gradient, for each vertex.
    pub(crate) fn gradient(&self, points: &[Point]) -> Vec<Vector3<f64>> {
        let mut sum = vec![Vector3::zeros(); points.len()];
        self.add_gradient(points, &mut sum);
        sum
    }

    /// Derives the terms in parallel, and calls `add` for them in order.
    pub(super) fn each<D: Send>(
        &self,
        derive: impl Fn(&dyn Energy) -> D + Sync,
        mut add: impl FnMut(&dyn Energy, &D),
    ) {
        for chunk in self.terms.chunks(CHUNK) {
            let derived: Vec<D> = chunk.par_iter().map(|&term| derive(term)).collect();
            let pairs = chunk.iter().zip(&derived);
            pairs.for_each(|(&term, derived)| add(term, derived));
        }
    }
}
