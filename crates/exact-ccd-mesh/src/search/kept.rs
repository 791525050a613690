//! The candidates of a search, kept for a search in a part of the same step.

use std::sync::atomic::{AtomicUsize, Ordering};

use super::candidates::Candidates;
use crate::gathered::Gathered;
use crate::mesh::TriangleMesh;
use crate::pairs::{ByKind, Searched};

/// A limit for the number of kept pairs: this many for each vertex. They take as much memory as the boxes.
const MOST_PER_VERTEX: usize = 64;

/// The pairs that pass the [`Screen`](super::screen::Screen), unless they are too many.
pub(super) struct Kept {
    pairs: ByKind<Gathered<[u32; 2]>>,
    count: AtomicUsize,
    most: usize,
}

impl Kept {
    /// No pairs of a mesh yet, in the memory of others.
    pub(super) fn new(mesh: &TriangleMesh, memory: Candidates) -> Self {
        let cleared = |mut pairs: Vec<_>| {
            pairs.clear();
            Gathered::new(pairs)
        };
        Self {
            pairs: memory.into_lists().map(cleared),
            count: AtomicUsize::new(0),
            most: MOST_PER_VERTEX * mesh.vertex_count(),
        }
    }

    /// Keeps some more pairs.
    pub(super) fn add<K: Searched>(&self, pairs: &[[u32; 2]]) {
        if self.count.fetch_add(pairs.len(), Ordering::Relaxed) + pairs.len() <= self.most {
            self.pairs[K::KIND].append(pairs.to_vec());
        }
    }

    /// All pairs, if they are complete.
    pub(super) fn into_candidates(self) -> Option<Candidates> {
        let is_complete = self.count.into_inner() <= self.most;
        is_complete.then(|| Candidates::from_lists(self.pairs.map(Gathered::into_list)))
    }
}

#[cfg(test)]
mod tests {
    use exact_ccd::{AnyKind, VertexFace};

    use super::*;

    #[test]
    fn more_pairs_than_the_limit_are_incomplete() {
        let mesh = TriangleMesh::new(2, Vec::new()).expect("there are no faces");
        let most = 2 * MOST_PER_VERTEX;
        let kept = |parts: &[usize]| {
            let kept = Kept::new(&mesh, Candidates::default());
            for &part in parts {
                kept.add::<VertexFace>(&vec![[0, 0]; part]);
            }
            kept.into_candidates()
                .map(|kept| kept.of_kind(AnyKind::VertexFace).len())
        };
        assert_eq!(kept(&[]), Some(0));
        assert_eq!(kept(&[1, most - 1]), Some(most));
        assert_eq!(kept(&[most, 1]), None);
        assert_eq!(kept(&[most + 1]), None);
    }
}
