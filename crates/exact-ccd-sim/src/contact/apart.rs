//! Pairs of primitives that stay apart in a step.

use exact_ccd::separation::{Separations, Thickness};
use exact_ccd::{Kind, Point};
use exact_ccd_mesh::{PairKind, Step};
use rayon::prelude::*;

/// The test of pairs, by their own thickness: candidates are those of the greatest thickness in a scene.
pub(super) struct Apart<'a> {
    step: Step<'a>,
    thickness: &'a Thickness,
    /// The distance between surfaces, in m, and a bound on the rounding of positions in the step.
    reach: f64,
    /// The greatest thickness of a pair.
    pub(super) greatest: f64,
}

/// Rounded positions in a step are off by at most this times the largest coordinate, see [`Step::at`].
const ROUNDING: f64 = 8.0 * f64::EPSILON;

impl<'a> Apart<'a> {
    /// The test for a distance `reach` between surfaces.
    pub(super) fn new(step: Step<'a>, thickness: &'a Thickness, reach: f64) -> Self {
        let coordinates = step.positions().into_iter().flatten().flatten();
        let largest = coordinates.fold(0.0_f64, |largest, x| largest.max(x.abs()));
        let vertices = 0..thickness.vertex_count() as u32;
        let greatest = vertices.fold(0.0, |greatest: f64, vertex| {
            greatest.max(thickness.of(&[vertex]).get())
        });
        Self {
            step,
            thickness,
            reach: reach + ROUNDING * largest,
            greatest: 2.0 * greatest,
        }
    }

    /// The pairs that no axis keeps apart.
    pub(super) fn kept<K: PairKind>(&self, pairs: &[[u32; 2]]) -> Vec<[u32; 2]> {
        let is_near = |pair: &&[u32; 2]| {
            K::vertices(self.step.mesh(), **pair)
                .is_some_and(|vertices| !self.are_apart(&vertices, <K as Kind>::FIRST))
        };
        pairs.par_iter().filter(is_near).copied().collect()
    }

    /// True if an axis separates two primitives by more than the distance, in the same order at both ends of the
    /// step, and so at all times: a gap along an axis is the least of differences that are linear in time. The
    /// rounding of a difference is monotone: one that is above the distance after rounding is so before.
    fn are_apart(&self, vertices: &[u32; 4], first: usize) -> bool {
        let (a, b) = vertices.split_at(first);
        let thickness = Separations::Thickness(self.thickness).between(a, b).get();
        let distance = (thickness + self.reach).next_up();
        let [x0, x1] = self.step.positions();
        let range = |positions: &[Point], vertices: &[u32], axis: usize| {
            let coordinates = vertices.iter().map(|&vertex| positions[vertex as usize][axis]);
            coordinates.fold((f64::INFINITY, f64::NEG_INFINITY), |(lower, upper), x| {
                (lower.min(x), upper.max(x))
            })
        };
        (0..3).any(|axis| {
            let gaps = [x0, x1].map(|positions| {
                let (a, b) = (range(positions, a, axis), range(positions, b, axis));
                [b.0 - a.1, a.0 - b.1]
            });
            [0, 1]
                .into_iter()
                .any(|order: usize| gaps.iter().all(|gap| gap[order] > distance))
        })
    }
}
