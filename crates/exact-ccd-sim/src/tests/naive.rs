//! The sum of the barriers over all pairs of primitives: the reference for the constraint set.

use exact_ccd::{EdgeEdge, VertexFace};
use exact_ccd_mesh::{PairKind, Point, TriangleMesh};
use nalgebra::Vector3;

use super::differences::Points;
use crate::energies::contact::Barrier;
use crate::energies::distance::{Mollifier, Vector12};

/// The weights of four points in the shortest vector between two primitives, computed without the features
/// of the library.
type Weights = [f64; 4];

fn vector(points: &Points, weights: &Weights) -> Vector3<f64> {
    points
        .iter()
        .zip(weights)
        .map(|(point, weight)| point * *weight)
        .sum()
}

fn shortest(points: &Points, choices: impl IntoIterator<Item = Weights>) -> Weights {
    let length = |weights: &Weights| vector(points, weights).norm();
    choices
        .into_iter()
        .min_by(|a, b| length(a).total_cmp(&length(b)))
        .unwrap()
}

fn to_segment(points: &Points, point: usize, [a, b]: [usize; 2]) -> Weights {
    let edge = points[b] - points[a];
    let share = (edge.dot(&(points[point] - points[a])) / edge.norm_squared()).clamp(0.0, 1.0);
    let mut weights = [0.0; 4];
    (weights[point], weights[a], weights[b]) = (1.0, share - 1.0, -share);
    weights
}

/// The shortest vector between a point and a triangle: to its plane if the foot is inside, else to a side.
fn to_triangle(points: &Points) -> Weights {
    let [p, a, b, c] = *points;
    let normal = (b - a).cross(&(c - a));
    let share = |from: Vector3<f64>, to: Vector3<f64>| {
        (to - from).cross(&(p - from)).dot(&normal) / normal.norm_squared()
    };
    let shares = [share(b, c), share(c, a), share(a, b)];
    if shares.iter().all(|&share| share >= 0.0) {
        return [1.0, -shares[0], -shares[1], -shares[2]];
    }
    shortest(
        points,
        [[1, 2], [2, 3], [3, 1]].map(|side| to_segment(points, 0, side)),
    )
}

/// The shortest vector between two edges: between the lines if both feet are inside, else from an end.
fn between_edges(points: &Points) -> Weights {
    let [a, b, c, d] = *points;
    let (u, v) = (b - a, d - c);
    let normal = u.cross(&v);
    let s = (c - a).cross(&v).dot(&normal) / normal.norm_squared();
    let t = (c - a).cross(&u).dot(&normal) / normal.norm_squared();
    if (0.0..=1.0).contains(&s) && (0.0..=1.0).contains(&t) {
        return [1.0 - s, s, t - 1.0, -t];
    }
    let ends = [(0, [2, 3]), (1, [2, 3]), (2, [0, 1]), (3, [0, 1])];
    shortest(points, ends.map(|(end, edge)| to_segment(points, end, edge)))
}

/// The sum of the barriers over all pairs.
pub(crate) struct Naive {
    pub(crate) value: f64,
    pub(crate) gradient: Vec<Vector3<f64>>,
    pub(crate) minimum: f64,
    /// The number of near pairs, and among them the number of pairs of nearly parallel edges.
    pub(crate) count: [usize; 2],
}

impl Naive {
    /// The sum over all pairs of a surface. `obstacle` has the vertices of obstacles.
    pub(crate) fn new(
        mesh: &TriangleMesh,
        obstacle: &[bool],
        points: &[Point],
        rest: &[Point],
        barrier: Barrier,
    ) -> Self {
        let mut sum = Self {
            value: 0.0,
            gradient: vec![Vector3::zeros(); points.len()],
            minimum: f64::INFINITY,
            count: [0; 2],
        };
        let is_of_concern = |vertices: [u32; 4], first: usize| {
            let (a, b) = vertices.split_at(first);
            a.iter().all(|vertex| !b.contains(vertex))
                && !vertices.into_iter().all(|vertex| obstacle[vertex as usize])
        };
        let counts = [mesh.faces().len() as u32, mesh.edges().len() as u32];
        for vertex in 0..points.len() as u32 {
            for face in 0..counts[0] {
                let vertices = VertexFace::vertices(mesh, [vertex, face]).unwrap();
                if is_of_concern(vertices, 1) {
                    let corners = at(points, vertices);
                    sum.add(vertices, &corners, &to_triangle(&corners), None, barrier);
                }
            }
        }
        for a in 0..counts[1] {
            for b in a + 1..counts[1] {
                let vertices = EdgeEdge::vertices(mesh, [a, b]).unwrap();
                if is_of_concern(vertices, 2) {
                    let [p, q, r, s] = at(rest, vertices);
                    let mollifier = Mollifier::new([(q - p).norm_squared(), (s - r).norm_squared()]);
                    let corners = at(points, vertices);
                    sum.add(
                        vertices,
                        &corners,
                        &between_edges(&corners),
                        Some(mollifier),
                        barrier,
                    );
                }
            }
        }
        sum
    }

    /// Adds m b(|r|²), whose gradient is m b′ 2 wᵢ r + b ∇m.
    fn add(
        &mut self,
        vertices: [u32; 4],
        corners: &Points,
        weights: &Weights,
        mollifier: Option<Mollifier>,
        barrier: Barrier,
    ) {
        let vector = vector(corners, weights);
        let squared = vector.norm_squared();
        if !barrier.is_active(squared) {
            return;
        }
        let fade = mollifier.map_or(1.0, |mollifier| mollifier.value(corners));
        let fades = mollifier.map_or_else(Vector12::zeros, |mollifier| mollifier.derivatives(corners).0);
        self.value += fade * barrier.value(squared);
        for (place, &vertex) in vertices.iter().enumerate() {
            let force = vector * (2.0 * weights[place] * barrier.slope(squared) * fade);
            self.gradient[vertex as usize] +=
                force + fades.fixed_rows::<3>(3 * place) * barrier.value(squared);
        }
        self.minimum = self.minimum.min(vector.norm());
        self.count[0] += 1;
        self.count[1] += usize::from(fade < 1.0);
    }
}

fn at(points: &[Point], vertices: [u32; 4]) -> Points {
    vertices.map(|vertex| Vector3::from(points[vertex as usize]))
}
