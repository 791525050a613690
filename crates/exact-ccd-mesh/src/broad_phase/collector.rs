//! A sink that stores pairs.

use std::ops::ControlFlow;

use rayon::prelude::*;

use crate::gathered::Gathered;

/// A collector of pairs, from any thread.
///
/// ```
/// use exact_ccd_mesh::{Aabb, BoxPairs, Boxes, Bvh, PairCollector};
///
/// let points = Boxes::new(&[1.0, 4.0, 1.0, 1.0].map(|x| [Aabb::of([x, 0.0, 0.0])]))?;
/// let collector = PairCollector::default();
/// let _ = Bvh.within(&points, &|pairs| {
///     collector.add(pairs.iter().copied().filter(|&pair| pair != [0, 2]))
/// });
/// assert_eq!(collector.into_sorted(), [[0, 3], [2, 3]]);
/// # Ok::<(), exact_ccd_mesh::TooManyPrimitives>(())
/// ```
#[derive(Debug, Default)]
pub struct PairCollector(Gathered<[u32; 2]>);

impl PairCollector {
    /// Adds some pairs. Returns `Continue`, so that a sink can end with it.
    pub fn add(&self, pairs: impl IntoIterator<Item = [u32; 2]>) -> ControlFlow<()> {
        // The iterator may be slow: it runs before the list is locked.
        self.0.append(pairs.into_iter().collect());
        ControlFlow::Continue(())
    }

    /// The pairs in increasing order, whatever the order in which they were added.
    #[must_use]
    pub fn into_sorted(self) -> Vec<[u32; 2]> {
        let mut pairs = self.0.into_list();
        pairs.par_sort_unstable();
        pairs
    }
}
