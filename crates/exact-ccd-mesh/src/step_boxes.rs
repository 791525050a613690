//! The boxes of a mesh's primitives during a step.

use exact_ccd::Point;
use rayon::prelude::*;

use crate::aabb::Aabb;
use crate::broad_phase::{Boxes, MovingBox, extent, order};
use crate::can_collide::CanCollide;
use crate::mesh::TriangleMesh;
use crate::step::Step;

/// The boxes of the vertices, faces and edges, in successive steps of one mesh: boxes that move (T =
/// 2), or boxes at rest, each around the whole path of a primitive (T = 1).
///
/// All boxes are in the order of the vertices along a space-filling curve: a face and an edge come
/// where the first of their vertices does. The order is kept from step to step until it has become
/// too long.
#[derive(Clone, Debug)]
pub(crate) struct StepBoxes<const T: usize> {
    pub(crate) vertices: Boxes<T>,
    pub(crate) faces: Boxes<T>,
    pub(crate) edges: Boxes<T>,
    /// The boxes of the vertices, in the order of the mesh.
    moving: Vec<MovingBox<T>>,
    /// The amount by which all boxes are larger on each side.
    margin: f64,
    /// The start of a vertex amid many others: coordinates are relative to it, so that single
    /// precision is fine.
    origin: Point,
    /// The time until which the boxes of `moving` hold, or NaN.
    time: f64,
    /// The number of vertices of the mesh for which the order was made, if it was made.
    ordered: Option<usize>,
    /// The shortest extent of the order since it was made.
    extent: f64,
}

/// Vertices are ordered anew when the extent of their order has grown by this factor.
const MAX_GROWTH: f64 = 1.5;

impl<const T: usize> StepBoxes<T> {
    /// No boxes yet.
    pub(crate) fn new(margin: f64) -> Self {
        let none = || Boxes::in_order(Vec::new());
        Self {
            vertices: none(),
            faces: none(),
            edges: none(),
            moving: Vec::new(),
            margin,
            origin: [0.0; 3],
            time: f64::NAN,
            ordered: None,
            extent: 0.0,
        }
    }

    /// Begins another step of the same mesh with the same predicate: orders the primitives, but
    /// places no boxes.
    pub(crate) fn begin(&mut self, step: &Step<'_>, can_collide: &CanCollide) {
        let [x0, _] = step.positions();
        self.time = f64::NAN;
        let now = extent(x0, self.vertices.ids());
        if self.ordered != Some(x0.len()) || now > MAX_GROWTH * self.extent {
            self.order(step.mesh(), x0, can_collide);
        } else {
            self.extent = self.extent.min(now);
        }
        // A vertex in the middle of the order is amid many others, even if some vertices are far
        // away.
        let ids = self.vertices.ids();
        let middle = ids.get(ids.len() / 2);
        self.origin = middle.map_or([0.0; 3], |&vertex| x0[vertex as usize]);
    }

    fn order(&mut self, mesh: &TriangleMesh, x0: &[Point], can_collide: &CanCollide) {
        let ids = (0..x0.len() as u32).filter(|&vertex| can_collide.takes_part(&[vertex]));
        let ids = order(x0, ids.collect());
        self.extent = extent(x0, &ids);
        let mut rank = vec![0; x0.len()];
        for (place, &id) in (0..).zip(&ids) {
            rank[id as usize] = place;
        }
        self.vertices = Boxes::in_order(ids);
        self.faces = Boxes::in_order(by_first_vertex(&rank, mesh.faces(), can_collide));
        self.edges = Boxes::in_order(by_first_vertex(&rank, mesh.edges(), can_collide));
        self.ordered = Some(x0.len());
    }

    /// Places the boxes of vertices and faces for the step until `time`.
    pub(crate) fn vertices_and_faces_until(&mut self, step: &Step<'_>, time: f64) {
        self.move_vertices(step, time);
        let (moving, faces) = (&self.moving, step.mesh().faces());
        self.vertices.set(|id| moving[id as usize]);
        self.faces.set(|id| around(moving, &faces[id as usize]));
    }

    /// Places the boxes of edges for the step until `time`.
    pub(crate) fn edges_until(&mut self, step: &Step<'_>, time: f64) {
        self.move_vertices(step, time);
        let (moving, edges) = (&self.moving, step.mesh().edges());
        self.edges.set(|id| around(moving, &edges[id as usize]));
    }

    fn move_vertices(&mut self, step: &Step<'_>, time: f64) {
        if self.time == time {
            return;
        }
        self.time = time;
        let [x0, x1] = step.positions();
        let (origin, margin) = (self.origin, self.margin);
        let ends = x0.par_iter().zip(x1).with_min_len(512);
        let moving = &mut self.moving;
        // Two copies of the loop: the usual one does not inflate.
        if margin == 0.0 {
            ends.map(|(&x0, &x1)| MovingBox::new(until(time, x0, x1), origin))
                .collect_into_vec(moving);
        } else {
            ends.map(|(&x0, &x1)| {
                let places = until(time, x0, x1).map(|aabb| aabb.inflated(margin));
                MovingBox::new(places, origin)
            })
            .collect_into_vec(moving);
        }
    }
}

/// The boxes of a vertex at t = 0 and at `time` (T = 2), or the box around its path in between (T =
/// 1).
///
/// (1 − t) x₀ + t x₁ is computed with at most three roundings of each summand, and with products
/// that may underflow; no value between x₀ and x₁ overflows.
fn until<const T: usize>(time: f64, x0: Point, x1: Point) -> [Aabb; T] {
    let mut end = Aabb::EMPTY;
    for axis in 0..3 {
        let (a, b) = (x0[axis], x1[axis]);
        let (lower, upper) = if a < b { (a, b) } else { (b, a) };
        let near = ((1.0 - time) * a + time * b).clamp(lower, upper);
        let error = 2.0 * f64::EPSILON * a.abs() + 2.0 * f64::EPSILON * b.abs() + f64::MIN_POSITIVE;
        end.lower[axis] = near - error;
        end.upper[axis] = near + error;
    }
    let start = Aabb::of(x0);
    match T {
        1 => [start.union(&end); T],
        _ => core::array::from_fn(|time| if time == 0 { start } else { end }),
    }
}

#[inline(always)]
fn around<const T: usize, const N: usize>(boxes: &[MovingBox<T>], vertices: &[u32; N]) -> MovingBox<T> {
    vertices.iter().fold(MovingBox::EMPTY, |all, &vertex| {
        all.union(&boxes[vertex as usize])
    })
}

/// The indices of the primitives that take part, in the order of the ranks of their first vertices.
fn by_first_vertex<const N: usize>(
    rank: &[u32],
    primitives: &[[u32; N]],
    can_collide: &CanCollide,
) -> Vec<u32> {
    let first = |vertices: &[u32; N]| vertices.iter().map(|&v| rank[v as usize]).min().unwrap_or(0);
    let taking_part = || {
        (0..)
            .zip(primitives)
            .filter(|(_, vertices)| can_collide.takes_part(*vertices))
    };
    // A counting sort: `begin` has the first place of each rank.
    let mut begin = vec![0u32; rank.len() + 1];
    let mut sum = 0;
    for (_, vertices) in taking_part() {
        begin[first(vertices) as usize + 1] += 1;
        sum += 1;
    }
    let mut ids = vec![0; sum];
    let mut sum = 0;
    for count in &mut begin {
        sum += *count;
        *count = sum;
    }
    for (id, vertices) in taking_part() {
        let place = &mut begin[first(vertices) as usize];
        ids[*place as usize] = id;
        *place += 1;
    }
    ids
}
