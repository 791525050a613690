//! Pairs of boxes that overlap.

use rayon::prelude::*;

use crate::bounds::Bounds;

/// A way to find the pairs of boxes that overlap.
///
/// Whichever way it is, the pairs are the same and come in the same order, sorted by their first index, then by their
/// second, on any number of threads. Boxes are numbered with 32 bits, so there must not be more of them than that.
///
/// ```
/// use ccd_mesh::{AllPairs, Bounds, BroadPhase, Bvh};
///
/// let cube = |x: f64| Bounds::of([x, 0.0, 0.0]).union(&Bounds::of([x + 1.0, 1.0, 1.0]));
/// let cubes = [0.0, 1.0, 2.5, 2.0].map(cube);
/// let pairs = Bvh.within(&cubes, |_, _| true);
/// assert_eq!(pairs, [[0, 1], [1, 3], [2, 3]]);
/// assert_eq!(pairs, AllPairs.within(&cubes, |_, _| true));
/// ```
pub trait BroadPhase {
    /// The pairs [i, j] such that `a[i]` overlaps `b[j]` and `keep(i, j)`.
    fn between(&self, a: &[Bounds], b: &[Bounds], keep: impl Fn(u32, u32) -> bool + Sync) -> Vec<[u32; 2]>;

    /// The pairs [i, j], i < j, such that `boxes[i]` overlaps `boxes[j]` and `keep(i, j)`.
    fn within(&self, boxes: &[Bounds], keep: impl Fn(u32, u32) -> bool + Sync) -> Vec<[u32; 2]> {
        self.between(boxes, boxes, |i, j| i < j && keep(i, j))
    }
}

/// Every box against every other: the definition, and the reference for the tests of the others.
#[derive(Clone, Copy, Debug, Default)]
pub struct AllPairs;

impl BroadPhase for AllPairs {
    fn between(&self, a: &[Bounds], b: &[Bounds], keep: impl Fn(u32, u32) -> bool + Sync) -> Vec<[u32; 2]> {
        let keep = &keep;
        a.par_iter()
            .enumerate()
            .flat_map_iter(|(i, query)| {
                let i = i as u32;
                let meets = move |&(j, other): &(u32, &Bounds)| query.overlaps(other) && keep(i, j);
                (0..).zip(b).filter(meets).map(move |(j, _)| [i, j])
            })
            .collect()
    }
}
