//! The depth-first search of the interval root finders.

use std::iter;

use super::cell::Cell;

/// A search for the earliest root in [0, 1]ᴺ.
pub(crate) struct Bisection<const N: usize> {
    /// A box that is not wider than this is not divided.
    pub(crate) tolerances: [f64; N],
    /// The largest number of boxes that are tested.
    pub(crate) max_iterations: usize,
}

impl<const N: usize> Bisection<N> {
    /// The beginning of the earliest undivided box that may contain a root and is accepted.
    ///
    /// Boxes are divided along the axes in rotation. At the limit of iterations, all remaining boxes
    /// count as boxes that may contain roots.
    pub(crate) fn earliest(
        &self,
        may_contain_root: impl Fn(&Cell<N>) -> bool,
        accepts: impl Fn(&Cell<N>) -> bool,
    ) -> Option<f64> {
        let mut earliest = None;
        let mut iterations = 0;
        let mut stack = vec![(Cell::WHOLE, N - 1)];
        while let Some((cell, last_axis)) = stack.pop() {
            if earliest.is_some_and(|earliest| cell.time() >= earliest) {
                continue;
            }
            if iterations == self.max_iterations {
                let left = stack.iter().map(|(cell, _)| cell.time());
                return left.chain(iter::once(cell.time())).reduce(f64::min);
            }
            iterations += 1;
            if !may_contain_root(&cell) {
                continue;
            }
            let mut axes = (1..=N).map(|turn| (last_axis + turn) % N);
            if let Some(axis) =
                axes.find(|&axis| cell.width[axis] > self.tolerances[axis].max(Cell::<N>::MIN_WIDTH))
            {
                let [lower, upper] = cell.halves(axis);
                stack.extend([(upper, axis), (lower, axis)]);
            } else if accepts(&cell) {
                earliest = Some(cell.time());
            }
        }
        earliest
    }
}
