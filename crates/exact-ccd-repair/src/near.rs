//! Pairs that are near each other, in rounded numbers: for displacements that exact decisions follow.

use exact_ccd_mesh::vector::{dot, minus, unit};
use exact_ccd_mesh::{Bvh, CandidateOptions, Candidates, Pair, Point, Step};

use crate::closest::{closest_in_face, closest_of_edges};
use crate::error::RepairError;
use crate::problem::Problem;

/// A near pair: its distance changes by n · Σ wᵢ uᵢ to first order, if its vertices move by uᵢ.
pub(crate) struct Near {
    /// The vertices. Those beyond the vertices of the pair have the weight 0.
    pub(crate) vertices: [u32; 4],
    pub(crate) weights: [f64; 4],
    /// The unit vector from the second primitive to the first one.
    pub(crate) normal: Point,
    pub(crate) distance: f64,
}

/// The pairs within a distance that are not in contact.
pub(crate) fn near_pairs(
    problem: &Problem<'_>,
    x: &[Point],
    distance: f64,
) -> Result<Vec<Near>, RepairError> {
    let options = CandidateOptions::default()
        .with_distance(distance)
        .with_can_collide(problem.options.can_collide.clone());
    let candidates = Candidates::with_options(Step::new(problem.mesh, x, x)?, &Bvh, &options)?;
    let near = |pair: Pair| Near::new(&pair.vertices(problem.mesh)?, pair.kind().sizes()[0], x);
    let is_within = |near: &Near| near.distance <= distance;
    Ok(candidates.pairs().filter_map(near).filter(is_within).collect())
}

impl Near {
    /// The pair of a primitive, the first `split` vertices, and another one, the other vertices; `None` if it
    /// has no normal.
    fn new(pair: &[u32], split: usize, x: &[Point]) -> Option<Self> {
        let at = |vertex: u32| x[vertex as usize];
        let mut vertices = [*pair.first()?; 4];
        vertices[..pair.len()].copy_from_slice(pair);
        let points = vertices.map(at);
        let weights = match (split, pair.len()) {
            (1, 4) => {
                let [u, v, w] = closest_in_face(points[0], [points[1], points[2], points[3]]);
                [1.0, -u, -v, -w]
            }
            (2, 4) => {
                let [s, t] = closest_of_edges([points[0], points[1]], [points[2], points[3]]);
                [1.0 - s, s, t - 1.0, -t]
            }
            (1, 3) => {
                let [_, t] = closest_of_edges([points[0]; 2], [points[1], points[2]]);
                [1.0, t - 1.0, -t, 0.0]
            }
            _ => [1.0, -1.0, 0.0, 0.0],
        };
        // Relative to one vertex, for the weights add up to 0.
        let mut apart = [0.0; 3];
        for (weight, point) in weights.iter().zip(points) {
            let from = minus(point, points[0]);
            apart = [0, 1, 2].map(|axis: usize| apart[axis] + weight * from[axis]);
        }
        Some(Self {
            vertices,
            weights,
            normal: unit(apart)?,
            distance: dot(apart, apart).sqrt(),
        })
    }
}
