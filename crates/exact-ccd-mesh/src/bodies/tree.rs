//! A tree of balls around the primitives of a body, in its coordinates.

use std::ops::Range;

use exact_ccd::Point;

use super::shape::{Primitive, Shape};
use super::sphere::Sphere;
use crate::mesh::Frame;

/// The most primitives of a leaf.
const LEAF: usize = 6;

/// A binary tree of balls, which holds for all motions of the body.
#[derive(Clone, Debug)]
pub(super) struct Tree {
    /// The root is the first, if there are primitives.
    nodes: Vec<Node>,
    primitives: Vec<Primitive>,
}

/// A ball around some primitives.
#[derive(Clone, Debug)]
pub(super) struct Node {
    pub(super) sphere: Sphere,
    pub(super) parts: Parts,
}

/// The parts of a node.
#[derive(Clone, Debug)]
pub(super) enum Parts {
    Nodes([u32; 2]),
    Primitives(Range<u32>),
}

impl Tree {
    pub(super) fn new(frame: &Frame) -> Self {
        let sphere = |shape: Shape, id: u32| {
            let points: arrayvec::ArrayVec<Point, 3> = points(frame, shape, id).collect();
            Sphere::of_primitive(&points)
        };
        let mut primitives: Vec<_> = Primitive::all(&frame.mesh, sphere).collect();
        let mut nodes = Vec::with_capacity(primitives.len());
        if !primitives.is_empty() {
            add(&mut nodes, &mut primitives, 0, frame);
        }
        Self { nodes, primitives }
    }

    /// The ball around all, if there are primitives.
    pub(super) fn root(&self) -> Option<&Node> {
        self.nodes.first()
    }

    pub(super) fn node(&self, index: u32) -> &Node {
        &self.nodes[index as usize]
    }

    pub(super) fn primitives(&self, range: &Range<u32>) -> &[Primitive] {
        &self.primitives[range.start as usize..range.end as usize]
    }
}

/// The positions of the vertices of a primitive.
fn points(frame: &Frame, shape: Shape, id: u32) -> impl Iterator<Item = Point> + Clone {
    let vertices = shape.vertices(&frame.mesh, id).into_iter();
    vertices.map(|vertex| frame.positions[vertex as usize])
}

/// Adds the node of some primitives, which begin at a place among all: halves along the longest side of the
/// box of their centers, so that the depth is logarithmic.
fn add(nodes: &mut Vec<Node>, primitives: &mut [Primitive], first: u32, frame: &Frame) -> u32 {
    let index = nodes.len();
    let all = primitives.iter().flat_map(|p| points(frame, p.shape, p.id));
    let count = primitives.len();
    nodes.push(Node {
        sphere: Sphere::around(all),
        parts: Parts::Primitives(first..first + count as u32),
    });
    if count > LEAF {
        let axis = longest_side(primitives);
        let middle = count / 2;
        primitives.select_nth_unstable_by(middle, |a, b| {
            let order = a.sphere.center[axis].total_cmp(&b.sphere.center[axis]);
            order.then_with(|| (a.shape as u8, a.id).cmp(&(b.shape as u8, b.id)))
        });
        let (lower, upper) = primitives.split_at_mut(middle);
        let lower = add(nodes, lower, first, frame);
        let upper = add(nodes, upper, first + middle as u32, frame);
        nodes[index].parts = Parts::Nodes([lower, upper]);
    }
    index as u32
}

/// The axis along which the centers extend farthest.
fn longest_side(primitives: &[Primitive]) -> usize {
    let extent = |axis: usize| {
        let centers = primitives.iter().map(|p| p.sphere.center[axis]);
        let [least, most] = centers.fold([f64::INFINITY, f64::NEG_INFINITY], |[least, most], x| {
            [least.min(x), most.max(x)]
        });
        most - least
    };
    let extents = [0, 1, 2].map(extent);
    (0..3).fold(0, |longest, axis| {
        if extents[axis] > extents[longest] {
            axis
        } else {
            longest
        }
    })
}
