//! A tree of balls around the primitives of a body, in its coordinates.

use std::ops::Range;

use exact_ccd::Point;

use super::shape::{Primitive, Shape};
use super::sphere::Sphere;
use crate::mesh::Frame;
use crate::vector::dot;

/// The most primitives of a leaf.
const LEAF: usize = 6;

/// A binary tree of balls, which holds for all motions of the body.
#[derive(Clone, Debug)]
pub(super) struct Tree {
    /// The root is the first, if there are primitives.
    nodes: Vec<Node>,
    primitives: Vec<Primitive>,
    /// The positions of the vertices of each leaf, each once.
    vertices: Vec<Point>,
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
    Leaf(Leaf),
}

/// The ranges of a leaf among all primitives, and among the vertices of leaves.
#[derive(Clone, Debug)]
pub(super) struct Leaf {
    primitives: Range<u32>,
    vertices: Range<u32>,
}

impl Tree {
    pub(super) fn new(frame: &Frame) -> Self {
        let sphere = |shape: Shape, id: u32| {
            let points: arrayvec::ArrayVec<Point, 3> = points(frame, shape, id).collect();
            Sphere::of_primitive(&points)
        };
        let mut primitives: Vec<_> = Primitive::all(&frame.mesh, sphere).collect();
        let mut tree = Self {
            nodes: Vec::with_capacity(primitives.len()),
            primitives: Vec::new(),
            vertices: Vec::new(),
        };
        if !primitives.is_empty() {
            tree.add(&mut primitives, 0, frame);
        }
        tree.primitives = primitives;
        tree
    }

    /// The ball around all, if there are primitives.
    pub(super) fn root(&self) -> Option<&Node> {
        self.nodes.first()
    }

    pub(super) fn node(&self, index: u32) -> &Node {
        &self.nodes[index as usize]
    }

    /// The vertex of the primitives below a node that is farthest in a direction of length 1, up to rounding.
    pub(super) fn farthest(&self, node: u32, direction: Point) -> Point {
        let mut farthest = (f64::NEG_INFINITY, [0.0; 3]);
        self.move_farther(&mut farthest, node, direction);
        farthest.1
    }

    /// Replaces a point, with its place along a direction, by a vertex below a node that is farther.
    fn move_farther(&self, farthest: &mut (f64, Point), node: u32, direction: Point) {
        let most = |sphere: Sphere| dot(direction, sphere.center) + sphere.radius * (1.0 + 1e-12);
        match &self.node(node).parts {
            Parts::Nodes(parts) => {
                let mut parts = parts.map(|part| (most(self.node(part).sphere), part));
                parts.sort_by(|(a, _), (b, _)| b.total_cmp(a));
                for (most, part) in parts {
                    // Also if it is not a number.
                    let is_nearer = most <= farthest.0;
                    if !is_nearer {
                        self.move_farther(farthest, part, direction);
                    }
                }
            }
            Parts::Leaf(leaf) => {
                let range = leaf.vertices.start as usize..leaf.vertices.end as usize;
                for &vertex in &self.vertices[range] {
                    let along = dot(direction, vertex);
                    if along > farthest.0 {
                        *farthest = (along, vertex);
                    }
                }
            }
        }
    }

    pub(super) fn primitives(&self, leaf: &Leaf) -> &[Primitive] {
        &self.primitives[leaf.primitives.start as usize..leaf.primitives.end as usize]
    }

    /// Adds the node of some primitives, which begin at a place among all: halves along the longest side of
    /// the box of their centers, so that the depth is logarithmic.
    fn add(&mut self, primitives: &mut [Primitive], first: u32, frame: &Frame) -> u32 {
        let index = self.nodes.len();
        let all = primitives.iter().flat_map(|p| points(frame, p.shape, p.id));
        let count = primitives.len();
        self.nodes.push(Node {
            sphere: Sphere::around(all),
            parts: Parts::Nodes([0; 2]),
        });
        self.nodes[index].parts = if count > LEAF {
            let axis = longest_side(primitives);
            let middle = count / 2;
            primitives.select_nth_unstable_by(middle, |a, b| {
                let order = a.sphere.center[axis].total_cmp(&b.sphere.center[axis]);
                order.then_with(|| (a.shape as u8, a.id).cmp(&(b.shape as u8, b.id)))
            });
            let (lower, upper) = primitives.split_at_mut(middle);
            let lower = self.add(lower, first, frame);
            Parts::Nodes([lower, self.add(upper, first + middle as u32, frame)])
        } else {
            Parts::Leaf(Leaf {
                primitives: first..first + count as u32,
                vertices: self.add_vertices(primitives, frame),
            })
        };
        index as u32
    }

    /// Adds the vertices of a leaf.
    fn add_vertices(&mut self, primitives: &[Primitive], frame: &Frame) -> Range<u32> {
        let vertices = primitives
            .iter()
            .flat_map(|p| p.shape.vertices(&frame.mesh, p.id));
        let mut vertices: Vec<_> = vertices.collect();
        vertices.sort_unstable();
        vertices.dedup();
        let start = self.vertices.len() as u32;
        let positions = vertices.iter().map(|&vertex| frame.positions[vertex as usize]);
        self.vertices.extend(positions);
        start..self.vertices.len() as u32
    }
}

/// The positions of the vertices of a primitive.
fn points(frame: &Frame, shape: Shape, id: u32) -> impl Iterator<Item = Point> + Clone {
    let vertices = shape.vertices(&frame.mesh, id).into_iter();
    vertices.map(|vertex| frame.positions[vertex as usize])
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
