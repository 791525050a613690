//! All pairs of primitives that boxes do not separate.
//!
//! The box of a primitive has the least and the largest coordinates of its vertices at t = 0 and at t =
//! T. A node of the tree has the union of the boxes below it. Two nodes are pruned only if one axis
//! separates them by more than the distance at both times, in the same order: then every coordinate of
//! one side minus any of the other is beyond the distance at both times, so at all times between,
//! because it is linear. Nothing else is left out.

use std::array::from_fn;

use crate::grid::Grid;
use crate::mesh::{Kind, Mesh};

/// The least x and the least −x of the rounded coordinates x, on each axis and at both times.
#[derive(Clone, Copy, Debug)]
struct Extent([[[i64; 2]; 3]; 2]);

impl Extent {
    fn of(grid: &Grid, vertices: [u32; 3], ends: [usize; 2]) -> Self {
        let of_vertex = |vertex| Self(ends.map(|end| grid.point(end, vertex).map(|x| [x, -x])));
        let [a, b, c] = vertices.map(of_vertex);
        a.union(&b).union(&c)
    }

    fn union(&self, other: &Self) -> Self {
        let least =
            |end: usize, axis: usize, side: usize| self.0[end][axis][side].min(other.0[end][axis][side]);
        Self(from_fn(|end| from_fn(|axis| from_fn(|side| least(end, axis, side)))))
    }

    /// The least x on one side plus the least −x on the other is the gap between them. The exact
    /// coordinates are less than 1 above the rounded ones, so a gap of more than the distance between
    /// rounded coordinates, which is at least 1 more, is one between exact coordinates.
    fn is_separate(&self, other: &Self, distance: i64) -> bool {
        let gap =
            |end: usize, axis: usize, side: usize| self.0[end][axis][side] + other.0[end][axis][1 - side];
        (0..6).any(|k| (0..2).all(|end| gap(end, k / 2, k % 2) > distance))
    }
}

/// A binary tree: a node with n primitives is followed by the nodes of its first n / 2, then those of
/// the others.
#[derive(Debug)]
struct Tree {
    nodes: Vec<Extent>,
    ids: Vec<u32>,
}

/// A node: its place, and the range of its primitives.
#[derive(Clone, Copy)]
struct Node {
    place: usize,
    begin: usize,
    end: usize,
}

impl Node {
    fn count(&self) -> usize {
        self.end - self.begin
    }

    fn children(&self) -> [Self; 2] {
        let middle = self.begin + self.count() / 2;
        let first = Self { place: self.place + 1, begin: self.begin, end: middle };
        let second = Self { place: self.place + 2 * first.count(), begin: middle, end: self.end };
        [first, second]
    }
}

impl Tree {
    fn new(mut leaves: Vec<(u32, Extent)>) -> Self {
        let mut nodes = Vec::with_capacity(2 * leaves.len());
        build(&mut leaves, &mut nodes);
        Self { nodes, ids: leaves.into_iter().map(|(id, _)| id).collect() }
    }

    fn root(&self) -> Option<Node> {
        let end = self.ids.len();
        (end > 0).then_some(Node { place: 0, begin: 0, end })
    }
}

/// The recursion halves the number of leaves, so its depth is at most 32.
fn build(leaves: &mut [(u32, Extent)], nodes: &mut Vec<Extent>) {
    let Some(all) = leaves.iter().map(|leaf| leaf.1).reduce(|a, b| a.union(&b)) else {
        return;
    };
    nodes.push(all);
    if leaves.len() > 1 {
        // The longest axis has the least sum, and the middle of a box on it is half of the difference.
        let axis = (0..3).min_by_key(|&axis: &usize| all.0[0][axis][0] + all.0[0][axis][1]).unwrap_or(0);
        let middle = leaves.len() / 2;
        leaves.select_nth_unstable_by_key(middle, |(id, extent)| {
            (extent.0[0][axis][0] - extent.0[0][axis][1], *id)
        });
        let (first, second) = leaves.split_at_mut(middle);
        build(first, nodes);
        build(second, nodes);
    }
}

/// The search in two trees for pairs that count.
struct Search<'a> {
    trees: [&'a Tree; 2],
    distance: i64,
    emit: &'a mut dyn FnMut([u32; 2]) -> bool,
}

impl Search<'_> {
    /// Returns false if the search has ended early.
    fn between(&mut self, a: Node, b: Node) -> bool {
        let [p, q] = self.trees;
        if p.nodes[a.place].is_separate(&q.nodes[b.place], self.distance) {
            return true;
        }
        if a.count() == 1 && b.count() == 1 {
            return (self.emit)([p.ids[a.begin], q.ids[b.begin]]);
        }
        if a.count() >= b.count() {
            a.children().into_iter().all(|a| self.between(a, b))
        } else {
            b.children().into_iter().all(|b| self.between(a, b))
        }
    }

    fn within(&mut self, node: Node) -> bool {
        if node.count() == 1 {
            return true;
        }
        let [a, b] = node.children();
        self.within(a) && self.within(b) && self.between(a, b)
    }
}

/// Passes each pair of a kind that counts and that the boxes do not separate to a function, until it
/// returns false.
pub fn pairs(mesh: &Mesh, grid: &Grid, kind: Kind, mut emit: impl FnMut([u32; 2]) -> bool) {
    // The statement about edges and faces is about contact at t = 0.
    let (ends, distance) = if kind == Kind::EdgeFace { ([0, 0], 0) } else { ([0, 1], grid.distance()) };
    let tree = |is_second| {
        let primitives = mesh.primitives(kind, is_second).into_iter();
        Tree::new(primitives.map(|(id, vertices)| (id, Extent::of(grid, vertices, ends))).collect())
    };
    let is_one_set = matches!(kind, Kind::EdgeEdge | Kind::VertexVertex);
    let emit: &mut dyn FnMut([u32; 2]) -> bool = &mut |[a, b]| {
        let ids = if is_one_set { [a.min(b), a.max(b)] } else { [a, b] };
        mesh.pair(kind, ids).is_none() || emit(ids)
    };
    let first = tree(false);
    if is_one_set {
        let mut search = Search { trees: [&first, &first], distance, emit };
        first.root().map(|root| search.within(root));
    } else {
        let second = tree(true);
        let mut search = Search { trees: [&first, &second], distance, emit };
        first.root().zip(second.root()).map(|(a, b)| search.between(a, b));
    }
}
