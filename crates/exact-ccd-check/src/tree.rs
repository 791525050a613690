//! All pairs of primitives that boxes do not separate.
//!
//! The box of a primitive has the least and the largest coordinates of its vertices at t = 0 and at t =
//! T. A node of the tree has the union of the boxes below it. Two nodes are pruned only if one axis
//! separates them by more than the distance at both times, in the same order: then every coordinate of
//! one side minus any of the other is beyond the distance at both times, so at all times between,
//! because it is linear. Nothing else is left out.

use std::array::from_fn;
use std::slice::from_ref;

use crate::grid::Grid;
use crate::mesh::{Kind, Mesh};

/// The least x and the least −x of the rounded coordinates x, on each axis and at both times.
#[derive(Clone, Copy)]
struct Extent([[[i64; 2]; 3]; 2]);

impl Extent {
    fn of(grid: &Grid, vertices: [u32; 3], ends: [usize; 2]) -> Self {
        let of_vertex = |vertex| Self(ends.map(|end| grid.at[end][vertex as usize].map(|x| [x, -x])));
        let [a, b, c] = vertices.map(of_vertex);
        a.union(&b).union(&c)
    }

    fn union(&self, other: &Self) -> Self {
        let least =
            |end: usize, axis: usize, side: usize| self.0[end][axis][side].min(other.0[end][axis][side]);
        Self(from_fn(|end| from_fn(|axis| from_fn(|side| least(end, axis, side)))))
    }

    /// The least x on one side plus the least −x on the other is the gap between them. The exact coordinates
    /// are less than 1 above the rounded ones. A gap between rounded coordinates that exceeds the distance
    /// exceeds it by at least 1, so the gap between the exact coordinates exceeds the distance too.
    fn is_separate(&self, other: &Self, distance: i64) -> bool {
        let gap =
            |end: usize, axis: usize, side: usize| self.0[end][axis][side] + other.0[end][axis][1 - side];
        (0..6).any(|k| (0..2).all(|end| gap(end, k / 2, k % 2) > distance))
    }
}

/// A primitive, or two trees, and the box around all that is below.
struct Tree {
    extent: Extent,
    below: Below,
}

enum Below {
    Leaf(u32),
    Two(Box<[Tree; 2]>),
}

impl Tree {
    /// The tree of some primitives. The recursion halves their number, so its depth is at most 32.
    fn new(leaves: &mut [(u32, Extent)]) -> Option<Self> {
        if let [(id, extent)] = *leaves {
            return Some(Self { extent, below: Below::Leaf(id) });
        }
        let extent = leaves.iter().map(|leaf| leaf.1).reduce(|a, b| a.union(&b))?;
        // The longest axis has the least sum, and the middle of a box on it is half of the difference.
        let axis = (0..3).min_by_key(|&axis: &usize| extent.0[0][axis].iter().sum::<i64>())?;
        let middle = leaves.len() / 2;
        let key = |(id, extent): &(u32, Extent)| (extent.0[0][axis][0] - extent.0[0][axis][1], *id);
        let _ = leaves.select_nth_unstable_by_key(middle, key);
        let (first, second) = leaves.split_at_mut(middle);
        Some(Self { extent, below: Below::Two(Box::new([Self::new(first)?, Self::new(second)?])) })
    }

    /// Both trees below, or the primitive itself.
    fn parts(&self) -> &[Self] {
        match &self.below {
            Below::Leaf(_) => from_ref(self),
            Below::Two(both) => &both[..],
        }
    }
}

/// Emits all pairs of two trees that boxes do not separate. Returns false if the search has ended early.
fn between(p: &Tree, q: &Tree, distance: i64, emit: &mut dyn FnMut([u32; 2]) -> bool) -> bool {
    if p.extent.is_separate(&q.extent, distance) {
        return true;
    }
    if let (Below::Leaf(a), Below::Leaf(b)) = (&p.below, &q.below) {
        return emit([*a, *b]);
    }
    p.parts().iter().all(|p| q.parts().iter().all(|q| between(p, q, distance, emit)))
}

/// Passes each pair of a kind that counts and that the boxes do not separate to a function, until it
/// returns false. Of two primitives of one kind, both orders are found, and one counts.
pub fn pairs(mesh: &Mesh, grid: &Grid, kind: Kind, mut emit: impl FnMut([u32; 2]) -> bool) {
    // The statement about edges and faces is about contact at t = 0.
    let (ends, distance) = if kind == Kind::EdgeFace { ([0, 0], 0) } else { ([0, 1], grid.distance) };
    let trees = [false, true].map(|is_second| {
        let primitives = mesh.primitives(kind, is_second).into_iter();
        let leaf = |(id, vertices)| (id, Extent::of(grid, vertices, ends));
        Tree::new(&mut primitives.map(leaf).collect::<Vec<_>>())
    });
    if let [Some(p), Some(q)] = trees {
        let _ = between(&p, &q, distance, &mut |ids| mesh.pair(kind, &ids).is_none() || emit(ids));
    }
}
