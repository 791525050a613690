//! Displacements that keep near pairs apart, so that vertices slide along near primitives, not into them.

use exact_ccd::{Impact, with_kind};
use exact_ccd_mesh::vector::dot;
use exact_ccd_mesh::{Contact, Pair, Point};

use crate::problem::Problem;
use crate::system::Unknowns;

/// The number of passes over all near pairs.
const PASSES: usize = 30;

/// The fraction of its gap that a pair keeps.
const KEPT: f64 = 0.5;

/// Gaps above this count as this, relative to the mean length of edges.
const WIDE: f64 = 0.02;

/// A near pair: its distance changes by n · Σ wᵢ uᵢ to first order, if its vertices move by uᵢ.
struct Near {
    vertices: [u32; 4],
    weights: [f64; 4],
    normal: Point,
    distance: f64,
    /// The least change of the distance that is allowed, at most 0 for a pair beyond the minimum distance.
    least: f64,
}

/// Changes displacements so that each near pair keeps a part of its gap beyond the minimum distance, to first
/// order: projected Gauss-Seidel for the nearest displacements with this property. It proves nothing; the
/// certified step that follows decides.
pub(crate) fn slide(problem: &Problem<'_>, contacts: &[Contact], displacements: &mut [Point]) {
    let near: Vec<Near> = contacts
        .iter()
        .filter_map(|contact| Near::new(problem, contact))
        .collect();
    let mut pushes = vec![0.0; near.len()];
    for _ in 0..PASSES {
        for (pair, push) in near.iter().zip(&mut pushes) {
            pair.resolve(&problem.unknowns, push, displacements);
        }
    }
}

/// Displacements that move the primitives of each near pair apart, to a distance `wanted` to first order; the
/// mean of all pairs of a vertex.
pub(crate) fn part(problem: &Problem<'_>, contacts: &[Contact], wanted: f64) -> Vec<Point> {
    let mut sums = vec![([0.0; 3], 0.0); problem.given.len()];
    for near in contacts.iter().filter_map(|contact| Near::new(problem, contact)) {
        let mass: f64 = near
            .free(&problem.unknowns)
            .map(|(_, weight)| weight * weight)
            .sum();
        for (vertex, weight) in near.free(&problem.unknowns).filter(|_| mass > 0.0) {
            let (sum, count) = &mut sums[vertex as usize];
            let length = (wanted - near.distance).max(0.0) * weight / mass;
            *sum = [0, 1, 2].map(|axis: usize| sum[axis] + weight.abs() * length * near.normal[axis]);
            *count += weight.abs();
        }
    }
    let mean = |(sum, count): (Point, f64)| {
        if count > 0.0 {
            sum.map(|part| part / count)
        } else {
            sum
        }
    };
    sums.into_iter().map(mean).collect()
}

impl Near {
    fn new(problem: &Problem<'_>, contact: &Contact) -> Option<Self> {
        let normal = contact.impact.normal?;
        let distance = contact.distance.lower;
        let gap = distance - problem.options.min_distance.get();
        let mut vertices = [0; 4];
        let named = contact.pair.vertices(problem.mesh)?;
        vertices[..named.len()].copy_from_slice(&named);
        Some(Self {
            vertices,
            weights: weights(contact.pair, &contact.impact),
            normal,
            distance,
            least: KEPT * gap.min(WIDE * problem.size.mean_edge) - gap,
        })
    }

    /// The vertices that can move, with their weights.
    fn free<'a>(&'a self, unknowns: &'a Unknowns) -> impl Iterator<Item = (u32, f64)> {
        let weights = self.vertices.iter().copied().zip(self.weights);
        weights.filter(|&(vertex, _)| !unknowns.is_pinned(vertex as usize))
    }

    /// Moves the vertices along the normal by as much as the distance lacks, and back by as much as earlier
    /// pushes were too many.
    fn resolve(&self, unknowns: &Unknowns, push: &mut f64, displacements: &mut [Point]) {
        let mass: f64 = self.free(unknowns).map(|(_, weight)| weight * weight).sum();
        if mass <= 0.0 {
            return;
        }
        let part =
            |(&vertex, weight): (&u32, &f64)| weight * dot(self.normal, displacements[vertex as usize]);
        let change: f64 = self.vertices.iter().zip(&self.weights).map(part).sum();
        let wanted = (*push + (self.least - change) / mass).max(0.0);
        for (vertex, weight) in self.free(unknowns) {
            for (axis, place) in displacements[vertex as usize].iter_mut().enumerate() {
                *place += (wanted - *push) * weight * self.normal[axis];
            }
        }
        *push = wanted;
    }
}

fn weights(pair: Pair, impact: &Impact) -> [f64; 4] {
    with_kind!(pair.kind(), K => impact.weights::<K>())
}
