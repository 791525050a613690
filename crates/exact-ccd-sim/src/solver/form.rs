//! Sums of terms of one kind.

use exact_ccd_mesh::Point;
use nalgebra::Vector3;
use rayon::prelude::*;

use crate::energies::term::Energy;
use crate::system::System;

/// A sum of terms of one kind, times a factor. Terms are computed in parallel and added in order.
pub(crate) struct Form<'a> {
    pub(super) terms: Vec<&'a dyn Energy>,
    pub(super) factor: f64,
}

/// The number of terms whose derivatives are in memory at a time.
const CHUNK: usize = 64;

impl<'a> Form<'a> {
    /// The sum of these terms.
    pub(crate) fn of<E: Energy>(terms: &'a [E], factor: f64) -> Self {
        let terms = terms.iter().map(|term| term as &dyn Energy).collect();
        Self { terms, factor }
    }

    /// The elastic elements of a system.
    pub(crate) fn elastic(system: &'a System, factor: f64) -> Self {
        let terms = system.elastic.elements.iter().map(|element| &**element);
        Self {
            terms: terms.map(|element| element as &dyn Energy).collect(),
            factor,
        }
    }

    /// The value.
    pub(crate) fn value(&self, points: &[Point]) -> f64 {
        let values: Vec<f64> = self.terms.par_iter().map(|term| term.value(points)).collect();
        self.factor * values.iter().sum::<f64>()
    }

    /// Adds the gradient to the gradient of other sums.
    pub(crate) fn add_gradient(&self, points: &[Point], sum: &mut [Vector3<f64>]) {
        self.each(
            |term| 3 * term.vertices().len(),
            |term, forces| term.write_gradient(points, forces),
            |term, forces| self.add_forces(term, forces, sum),
        );
    }

    /// Adds the gradient of a term.
    pub(super) fn add_forces(&self, term: &dyn Energy, forces: &[f64], sum: &mut [Vector3<f64>]) {
        for (&vertex, force) in term.vertices().iter().zip(forces.chunks_exact(3)) {
            sum[vertex as usize] += Vector3::from_column_slice(force) * self.factor;
        }
    }

    /// The gradient, for each vertex.
    pub(crate) fn gradient(&self, points: &[Point]) -> Vec<Vector3<f64>> {
        let mut sum = vec![Vector3::zeros(); points.len()];
        self.add_gradient(points, &mut sum);
        sum
    }

    /// Calls `write` for all terms in parallel, with memory for as many numbers as `length` returns. Calls
    /// `add` in order, with the written numbers.
    pub(super) fn each(
        &self,
        length: impl Fn(&dyn Energy) -> usize,
        write: impl Fn(&dyn Energy, &mut [f64]) + Sync,
        mut add: impl FnMut(&dyn Energy, &[f64]),
    ) {
        let mut memory = Vec::new();
        for chunk in self.terms.chunks(CHUNK) {
            let lengths: Vec<usize> = chunk.iter().map(|&term| length(term)).collect();
            memory.resize(lengths.iter().sum(), 0.0);
            let mut rest = memory.as_mut_slice();
            let mut parts: Vec<(&dyn Energy, &mut [f64])> = Vec::with_capacity(chunk.len());
            for (&term, length) in chunk.iter().zip(lengths) {
                let (part, others) = rest.split_at_mut(length);
                parts.push((term, part));
                rest = others;
            }
            parts.par_iter_mut().for_each(|(term, part)| write(*term, part));
            parts.iter().for_each(|(term, part)| add(*term, part));
        }
    }
}
