//! The boxes of a mesh's primitives during a step.

use exact_ccd::Point;
use rayon::prelude::*;

use crate::bounds::Bounds;
use crate::broad_phase::{Boxes, MovingBox, extent, order};
use crate::mesh::TriangleMesh;
use crate::step::Step;

/// The boxes of the vertices, faces and edges, in step after step of a mesh: boxes that move as these do (T = 2), or that
/// rest, each around all of a primitive's way (T = 1).
///
/// All of them are in the order of the vertices along a curve that fills space: a face and an edge come where the first of
/// their vertices does. That order stays as long as it is good.
#[derive(Clone, Debug)]
pub(crate) struct StepBoxes<'a, const T: usize> {
    mesh: &'a TriangleMesh,
    pub(crate) vertices: Boxes<T>,
    pub(crate) faces: Boxes<T>,
    pub(crate) edges: Boxes<T>,
    /// The boxes of the vertices, in the order of the mesh.
    moving: Vec<MovingBox<T>>,
    /// A vertex among many, so that single precision is spent on differences.
    origin: Point,
    /// Until when these move, or NaN.
    time: f64,
    /// How far apart successive vertices have been at least since they were ordered.
    extent: f64,
}

/// Vertices are ordered anew when they are so much farther from their successors than they once were.
const WEAR: f64 = 1.5;

impl<'a, const T: usize> StepBoxes<'a, T> {
    /// No boxes yet.
    pub(crate) fn new(mesh: &'a TriangleMesh) -> Self {
        let none = || Boxes::in_order(Vec::new());
        Self {
            mesh,
            vertices: none(),
            faces: none(),
            edges: none(),
            moving: Vec::new(),
            origin: [0.0; 3],
            time: f64::NAN,
            extent: 0.0,
        }
    }

    /// Takes another step of the mesh: which boxes are near each other in it, not yet where they are.
    pub(crate) fn begin(&mut self, step: &Step<'_>) {
        let [x0, _] = step.positions();
        self.time = f64::NAN;
        let now = extent(x0, self.vertices.ids());
        if self.vertices.len() != x0.len() || now > WEAR * self.extent {
            self.order(x0);
        } else {
            self.extent = self.extent.min(now);
        }
        // That of most vertices is as near as it can be, however far away some are.
        let middle = self.vertices.ids().get(x0.len() / 2);
        self.origin = middle.map_or([0.0; 3], |&vertex| x0[vertex as usize]);
    }

    fn order(&mut self, x0: &[Point]) {
        let ids = order(x0);
        self.extent = extent(x0, &ids);
        let mut rank = vec![0; ids.len()];
        for (place, &id) in (0..).zip(&ids) {
            rank[id as usize] = place;
        }
        self.vertices = Boxes::in_order(ids);
        self.faces = Boxes::in_order(by_first_vertex(&rank, self.mesh.faces()));
        self.edges = Boxes::in_order(by_first_vertex(&rank, self.mesh.edges()));
    }

    /// Places vertices and faces as they are until `time`.
    pub(crate) fn vertices_and_faces_until(&mut self, step: &Step<'_>, time: f64) {
        self.move_vertices(step, time);
        let Self { mesh, moving, .. } = self;
        self.vertices.set(|id| moving[id as usize]);
        self.faces.set(|id| around(moving, &mesh.faces()[id as usize]));
    }

    /// Places edges as they are until `time`.
    pub(crate) fn edges_until(&mut self, step: &Step<'_>, time: f64) {
        self.move_vertices(step, time);
        let Self { mesh, moving, .. } = self;
        self.edges.set(|id| around(moving, &mesh.edges()[id as usize]));
    }

    fn move_vertices(&mut self, step: &Step<'_>, time: f64) {
        if self.time == time {
            return;
        }
        self.time = time;
        let [x0, x1] = step.positions();
        let origin = self.origin;
        x0.par_iter()
            .zip(x1)
            .with_min_len(512)
            .map(|(&x0, &x1)| MovingBox::new(until(time, x0, x1), origin))
            .collect_into_vec(&mut self.moving);
    }
}

/// Boxes of a vertex: at t = 0 and at `time`, or around all of the way between.
///
/// (1 − t) x₀ + t x₁ has at most three roundings on the way from x₀ and x₁, and products that may underflow; and no value
/// between x₀ and x₁ overflows.
fn until<const T: usize>(time: f64, x0: Point, x1: Point) -> [Bounds; T] {
    let mut end = Bounds::EMPTY;
    for axis in 0..3 {
        let (a, b) = (x0[axis], x1[axis]);
        let (lower, upper) = if a < b { (a, b) } else { (b, a) };
        let near = ((1.0 - time) * a + time * b).clamp(lower, upper);
        let error = 2.0 * f64::EPSILON * a.abs() + 2.0 * f64::EPSILON * b.abs() + f64::MIN_POSITIVE;
        end.lower[axis] = near - error;
        end.upper[axis] = near + error;
    }
    let start = Bounds::of(x0);
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
