//! Pairs, kept.

use std::ops::ControlFlow;
use std::sync::{Mutex, PoisonError};

use rayon::prelude::*;

/// The visitor of a broad phase who keeps all pairs, or some.
///
/// ```
/// use exact_ccd_mesh::{Bounds, Boxes, BroadPhase, Bvh, Found};
///
/// let points = Boxes::new(&[1.0, 4.0, 1.0, 1.0].map(|x| [Bounds::of([x, 0.0, 0.0])]));
/// let found = Found::default();
/// let _ = Bvh.within(&points, &|pairs| found.keep(pairs.iter().copied().filter(|&pair| pair != [0, 2])));
/// assert_eq!(found.sorted(), [[0, 3], [2, 3]]);
/// ```
#[derive(Debug, Default)]
pub struct Found(Mutex<Vec<[u32; 2]>>);

impl Found {
    /// Keeps some pairs, and asks for more.
    pub fn keep(&self, pairs: impl IntoIterator<Item = [u32; 2]>) -> ControlFlow<()> {
        // What decides which pairs to keep is done before the others have to wait.
        let pairs: Vec<[u32; 2]> = pairs.into_iter().collect();
        let mut all = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        all.extend(pairs);
        ControlFlow::Continue(())
    }

    /// The pairs in increasing order, whichever the order in which they were found.
    #[must_use]
    pub fn sorted(self) -> Vec<[u32; 2]> {
        let mut pairs = self.0.into_inner().unwrap_or_else(PoisonError::into_inner);
        pairs.par_sort_unstable();
        pairs
    }
}
