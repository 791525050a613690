//! The constraint set: all collisions of one configuration.

use exact_ccd::{EdgeEdge, VertexFace};
use exact_ccd_mesh::{Candidates, PairKind, Point, TriangleMesh};
use nalgebra::Vector3;
use rayon::prelude::*;

use super::barrier::Barrier;
use super::collision::Collision;
use crate::distance::{Mollifier, edge_edge, point_triangle};
use crate::gather::{gather, gather_some};

/// The constraint set of one configuration: all pairs of features within the activation distance.
#[derive(Clone, Debug)]
pub struct Collisions {
    barrier: Barrier,
    collisions: Vec<Collision>,
    minimum: f64,
}

impl Collisions {
    /// The collisions among the candidate pairs, with the vertices at `points`. `rest` has the positions at
    /// rest, from which the mollifier takes the lengths of edges.
    ///
    /// # Panics
    /// If a vertex of a pair has no position.
    #[must_use]
    pub fn new(
        mesh: &TriangleMesh,
        candidates: &Candidates,
        points: &[Point],
        rest: &[Point],
        barrier: Barrier,
    ) -> Self {
        let d_hat = barrier.activation_distance_squared();
        let distance = d_hat.sqrt();
        let faces = candidates.vertex_face().par_iter().filter_map(|&pair| {
            let vertices = VertexFace::vertices(mesh, pair)?;
            let corners = gather(points, &vertices);
            if are_apart(&corners[..1], &corners[1..], distance) {
                return None;
            }
            let feature = point_triangle(&corners);
            let squared = feature.separation(&corners).squared();
            (squared < d_hat).then(|| (squared, Collision::new(vertices, feature)))
        });
        let edges = candidates.edge_edge().par_iter().filter_map(|&pair| {
            let vertices = EdgeEdge::vertices(mesh, pair)?;
            let corners = gather(points, &vertices);
            if are_apart(&corners[..2], &corners[2..], distance) {
                return None;
            }
            let feature = edge_edge(&corners);
            let squared = feature.separation(&corners).squared();
            (squared < d_hat).then(|| {
                let [a, b, c, d] = gather(rest, &vertices);
                let mollifier = Mollifier::new([(b - a).norm_squared(), (d - c).norm_squared()]);
                let collision = if mollifier.is_active(&corners) {
                    Collision::mollified(vertices, feature, mollifier)
                } else {
                    Collision::new(vertices, feature)
                };
                (squared, collision)
            })
        });
        let mut all: Vec<(f64, Collision)> = faces.collect();
        all.par_extend(edges);

        let minimum = all
            .iter()
            .fold(f64::INFINITY, |least, (squared, _)| least.min(*squared));
        let mut collisions: Vec<Collision> = all.into_iter().map(|(_, collision)| collision).collect();
        // The sort is stable, so that the order does not depend on threads.
        collisions.sort_by(|a, b| a.vertices().cmp(b.vertices()));
        collisions.dedup_by(|next, kept| {
            let same = next.is_same(kept);
            if same {
                kept.merge(next);
            }
            same
        });
        Self {
            barrier,
            collisions,
            minimum: minimum.sqrt(),
        }
    }

    /// The distinct collisions, sorted by their vertices.
    #[must_use]
    pub fn as_slice(&self) -> &[Collision] {
        &self.collisions
    }

    /// The least distance, in m. Infinite if there is no collision.
    #[must_use]
    pub fn minimal_distance(&self) -> f64 {
        self.minimum
    }

    /// The sum of the barriers, in m⁴.
    #[must_use]
    pub fn value(&self, points: &[Point]) -> f64 {
        let values: Vec<f64> = self
            .collisions
            .par_iter()
            .map(|collision| collision.value(&gather_some(points, collision.vertices()), &self.barrier))
            .collect();
        values.iter().sum()
    }

    /// The gradient of the sum of the barriers, with one entry for each vertex.
    #[must_use]
    pub fn gradient(&self, points: &[Point]) -> Vec<Vector3<f64>> {
        let mut gradient = vec![Vector3::zeros(); points.len()];
        for collision in &self.collisions {
            let forces = collision.gradient(&gather_some(points, collision.vertices()), &self.barrier);
            for (place, &vertex) in collision.vertices().iter().enumerate() {
                gradient[vertex as usize] += forces.fixed_rows::<3>(3 * place);
            }
        }
        gradient
    }

    /// The barrier function.
    #[must_use]
    pub fn barrier(&self) -> &Barrier {
        &self.barrier
    }
}

/// True if the bounding boxes of two sets of points are more than a distance apart along an axis. This
/// cheap test rejects most pairs.
#[inline]
fn are_apart(a: &[Vector3<f64>], b: &[Vector3<f64>], distance: f64) -> bool {
    (0..3).any(|axis| {
        let range = |points: &[Vector3<f64>]| {
            points
                .iter()
                .fold((f64::INFINITY, f64::NEG_INFINITY), |(lower, upper), point| {
                    (lower.min(point[axis]), upper.max(point[axis]))
                })
        };
        let ((a_lower, a_upper), (b_lower, b_upper)) = (range(a), range(b));
        b_lower - a_upper > distance || a_lower - b_upper > distance
    })
}
