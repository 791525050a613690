//! The boxes of a mesh's primitives during a step.

use exact_ccd::Point;
use rayon::prelude::*;

use crate::bounds::Bounds;
use crate::broad_phase::{Boxes, MovingBox, order};
use crate::step::Step;

/// The boxes of the vertices, faces and edges.
///
/// All of them are in the order of the vertices along a curve that fills space: a face and an edge come where the first of
/// their vertices does.
#[derive(Clone, Debug)]
pub(crate) struct StepBoxes {
    pub(crate) vertices: Boxes,
    pub(crate) faces: Boxes,
    pub(crate) edges: Boxes,
    /// Near the mesh, so that single precision is spent on differences.
    origin: Point,
    /// Until when they move.
    time: f64,
}

/// Boxes are not made anew for less than this.
const SHRINKAGE: f64 = 0.5;

impl StepBoxes {
    /// Boxes that rest, each around all of a primitive's way.
    pub(crate) fn swept(step: &Step<'_>) -> Self {
        Self::new(step, |x0, x1| {
            let all = Bounds::of(x0).union(&Bounds::of(x1));
            [all, all]
        })
    }

    /// Boxes that move as the primitives do.
    pub(crate) fn moving(step: &Step<'_>) -> Self {
        Self::new(step, |x0, x1| until(1.0, x0, x1))
    }

    /// The same for an earlier `time`, in the same order, if that is worth while.
    pub(crate) fn shrink(&mut self, step: &Step<'_>, time: f64) {
        if time > SHRINKAGE * self.time {
            return;
        }
        let vertices = vertex_boxes(step, self.origin, |x0, x1| until(time, x0, x1));
        let mesh = step.mesh();
        self.vertices.refit(|id| vertices[id as usize]);
        self.faces
            .refit(|id| around(&vertices, &mesh.faces()[id as usize]));
        self.edges
            .refit(|id| around(&vertices, &mesh.edges()[id as usize]));
        self.time = time;
    }

    fn new(step: &Step<'_>, ends: impl Fn(Point, Point) -> [Bounds; 2] + Sync) -> Self {
        let [x0, _] = step.positions();
        let mesh = step.mesh();
        let Bounds { lower, upper } = x0.iter().copied().collect();
        let origin = match x0 {
            [] => [0.0; 3],
            _ => [0, 1, 2].map(|axis: usize| 0.5 * lower[axis] + 0.5 * upper[axis]),
        };
        let vertices = vertex_boxes(step, origin, ends);
        let ids = order(x0);
        let mut rank = vec![0; ids.len()];
        for (place, &id) in (0..).zip(&ids) {
            rank[id as usize] = place;
        }
        Self {
            faces: Boxes::ordered(by_first_vertex(&rank, mesh.faces()), |id| {
                around(&vertices, &mesh.faces()[id as usize])
            }),
            edges: Boxes::ordered(by_first_vertex(&rank, mesh.edges()), |id| {
                around(&vertices, &mesh.edges()[id as usize])
            }),
            vertices: Boxes::ordered(ids, |id| vertices[id as usize]),
            origin,
            time: 1.0,
        }
    }
}

/// A vertex at t = 0, and a box around where it is at `time`.
///
/// (1 − t) x₀ + t x₁ has at most three roundings on the way from x₀ and x₁, and products that may underflow; and no value
/// between x₀ and x₁ overflows.
fn until(time: f64, x0: Point, x1: Point) -> [Bounds; 2] {
    let mut end = Bounds::EMPTY;
    for axis in 0..3 {
        let (a, b) = (x0[axis], x1[axis]);
        let (lower, upper) = if a < b { (a, b) } else { (b, a) };
        let near = ((1.0 - time) * a + time * b).clamp(lower, upper);
        let error = 2.0 * f64::EPSILON * a.abs() + 2.0 * f64::EPSILON * b.abs() + f64::MIN_POSITIVE;
        end.lower[axis] = near - error;
        end.upper[axis] = near + error;
    }
    [Bounds::of(x0), end]
}

fn vertex_boxes(
    step: &Step<'_>,
    origin: Point,
    ends: impl Fn(Point, Point) -> [Bounds; 2] + Sync,
) -> Vec<MovingBox> {
    let [x0, x1] = step.positions();
    let vertices = x0.par_iter().zip(x1).with_min_len(512);
    vertices
        .map(|(&x0, &x1)| MovingBox::new(ends(x0, x1), origin))
        .collect()
}

#[inline(always)]
fn around<const N: usize>(boxes: &[MovingBox], vertices: &[u32; N]) -> MovingBox {
    vertices.iter().fold(MovingBox::EMPTY, |all, &vertex| {
        all.union(&boxes[vertex as usize])
    })
}

/// The indices of primitives, in the order of the ranks of their first vertices.
fn by_first_vertex<const N: usize>(rank: &[u32], primitives: &[[u32; N]]) -> Vec<u32> {
    let first = |vertices: &[u32; N]| vertices.iter().map(|&v| rank[v as usize]).min().unwrap_or(0);
    // Counted, not compared: where those of each rank begin.
    let mut begin = vec![0u32; rank.len() + 1];
    for vertices in primitives {
        begin[first(vertices) as usize + 1] += 1;
    }
    let mut sum = 0;
    for count in &mut begin {
        sum += *count;
        *count = sum;
    }
    let mut ids = vec![0; primitives.len()];
    for (id, vertices) in (0..).zip(primitives) {
        let place = &mut begin[first(vertices) as usize];
        ids[*place as usize] = id;
        *place += 1;
    }
    ids
}
