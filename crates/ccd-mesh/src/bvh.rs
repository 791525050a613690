//! A bounding volume hierarchy.

use rayon::prelude::*;

use crate::bounds::Bounds;
use crate::broad_phase::BroadPhase;

/// Finds the overlapping pairs with a hierarchy of boxes.
#[derive(Clone, Copy, Debug, Default)]
pub struct Bvh;

/// How many boxes a thread looks up at a time.
const CHUNK: usize = 256;

impl BroadPhase for Bvh {
    fn between(&self, a: &[Bounds], b: &[Bounds], keep: impl Fn(u32, u32) -> bool + Sync) -> Vec<[u32; 2]> {
        let tree = Tree::new(b);
        let pairs: Vec<Vec<[u32; 2]>> = a
            .par_chunks(CHUNK)
            .enumerate()
            .map(|(chunk, queries)| {
                let mut pairs = Vec::new();
                for (i, query) in ((chunk * CHUNK) as u32..).zip(queries) {
                    let start = pairs.len();
                    tree.visit(query, |j| {
                        if keep(i, j) {
                            pairs.push([i, j]);
                        }
                    });
                    pairs[start..].sort_unstable();
                }
                pairs
            })
            .collect();
        pairs.concat()
    }
}

/// How many boxes a leaf holds: every leaf but the last is full.
const LEAF: usize = 8;

/// A balanced binary tree of boxes.
///
/// Boxes are split at the median of their centres along the longest extent of these. Halves of equal size keep the
/// tree shallow whatever the coordinates are, be they all the same or out of all proportion, and fix its shape in
/// advance: a tree of m leaves has 2m − 1 nodes.
struct Tree {
    /// In the order of a depth-first walk.
    nodes: Vec<Node>,
    /// The boxes and their indices, leaf by leaf.
    boxes: Vec<(Bounds, u32)>,
}

#[derive(Clone, Copy)]
struct Node {
    bounds: Bounds,
    /// The first node after this one and all below it.
    next: u32,
    /// Where the boxes of a leaf begin.
    leaf: Option<u32>,
}

#[derive(Clone, Copy)]
struct Centre {
    point: [f64; 3],
    id: u32,
}

impl Tree {
    fn new(boxes: &[Bounds]) -> Self {
        // Halved before they are added: the sum of two finite numbers may overflow.
        let middle = |b: &Bounds| core::array::from_fn(|k| 0.5 * b.lower[k] + 0.5 * b.upper[k]);
        let mut centres: Vec<Centre> = (0..)
            .zip(boxes)
            .map(|(id, b)| Centre { point: middle(b), id })
            .collect();
        let leaves = boxes.len().div_ceil(LEAF);
        let nowhere = Node {
            bounds: Bounds::EMPTY,
            next: 0,
            leaf: None,
        };
        let mut nodes = vec![nowhere; (2 * leaves).saturating_sub(1)];
        if leaves > 0 {
            build(&mut nodes, &mut centres, boxes, 0, 0);
        }
        let boxes = centres.iter().map(|c| (boxes[c.id as usize], c.id)).collect();
        Self { nodes, boxes }
    }

    /// Calls `found` with the index of each box that overlaps `query`, in no particular order.
    #[inline]
    fn visit(&self, query: &Bounds, mut found: impl FnMut(u32)) {
        let mut index = 0;
        while let Some(node) = self.nodes.get(index) {
            if !node.bounds.overlaps(query) {
                index = node.next as usize;
                continue;
            }
            index += 1;
            if let Some(leaf) = node.leaf {
                let first = leaf as usize;
                for (bounds, id) in &self.boxes[first..(first + LEAF).min(self.boxes.len())] {
                    if bounds.overlaps(query) {
                        found(*id);
                    }
                }
            }
        }
    }
}

fn build(
    nodes: &mut [Node],
    centres: &mut [Centre],
    boxes: &[Bounds],
    offset: usize,
    first: usize,
) -> Bounds {
    let count = nodes.len();
    let (bounds, leaf) = if centres.len() <= LEAF {
        let bounds = centres
            .iter()
            .fold(Bounds::EMPTY, |b, c| b.union(&boxes[c.id as usize]));
        (bounds, Some(first as u32))
    } else {
        let extent = centres
            .iter()
            .fold(Bounds::EMPTY, |b, c| b.union(&Bounds::of(c.point)));
        let length = |k: &usize| 0.5 * extent.upper[*k] - 0.5 * extent.lower[*k];
        let axis = (0..3).max_by(|a, b| length(a).total_cmp(&length(b))).unwrap_or(0);
        let left_leaves = centres.len().div_ceil(LEAF) / 2;
        let split = left_leaves * LEAF;
        centres.select_nth_unstable_by(split, |a, b| a.point[axis].total_cmp(&b.point[axis]));
        let (cl, cr) = centres.split_at_mut(split);
        let (nl, nr) = nodes[1..].split_at_mut(2 * left_leaves - 1);
        let right = offset + 1 + nl.len();
        let (a, b) = rayon::join(
            || build(nl, cl, boxes, offset + 1, first),
            || build(nr, cr, boxes, right, first + split),
        );
        (a.union(&b), None)
    };
    nodes[0] = Node {
        bounds,
        next: (offset + count) as u32,
        leaf,
    };
    bounds
}
