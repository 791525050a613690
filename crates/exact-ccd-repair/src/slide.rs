//! Displacements that keep near pairs apart, so that vertices slide along near primitives, not into them.

use exact_ccd_mesh::Point;
use exact_ccd_mesh::vector::dot;

use crate::near::Near;
use crate::problem::Problem;
use crate::system::Unknowns;

/// The number of passes over all near pairs.
const PASSES: usize = 30;

/// Gaps above this count as this, relative to the mean length of edges.
const WIDE: f64 = 0.02;

/// A near pair and the least change of its distance that is allowed.
struct Kept<'a> {
    near: &'a Near,
    least: f64,
}

/// Changes displacements so that each near pair keeps `kept` times its gap beyond the minimum distance, to
/// first order: projected Gauss-Seidel for the nearest displacements with this property. It proves nothing;
/// the certified step that follows decides.
pub(crate) fn slide(problem: &Problem<'_>, near: &[Near], kept: f64, displacements: &mut [Point]) {
    let pair = |near| {
        let gap = near_gap(problem, near);
        let least = kept * gap.min(WIDE * problem.size.mean_edge) - gap;
        Kept { near, least }
    };
    let pairs: Vec<Kept<'_>> = near.iter().map(pair).collect();
    let mut pushes = vec![0.0; pairs.len()];
    for _ in 0..PASSES {
        for (pair, push) in pairs.iter().zip(&mut pushes) {
            pair.resolve(&problem.unknowns, push, displacements);
        }
    }
}

/// The distance of a pair beyond the minimum distance.
fn near_gap(problem: &Problem<'_>, near: &Near) -> f64 {
    near.distance - problem.options.min_distance.get()
}

/// Displacements that move the primitives of each near pair apart, to a distance `wanted` to first order; the
/// mean of all pairs of a vertex.
pub(crate) fn part(problem: &Problem<'_>, near: &[Near], wanted: f64) -> Vec<Point> {
    let mut sums = vec![([0.0; 3], 0.0); problem.given.len()];
    for near in near {
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
    /// The vertices that can move, with their weights.
    fn free<'a>(&'a self, unknowns: &'a Unknowns) -> impl Iterator<Item = (u32, f64)> {
        let weights = self.vertices.iter().copied().zip(self.weights);
        weights.filter(|&(vertex, _)| !unknowns.is_pinned(vertex as usize))
    }
}

impl Kept<'_> {
    /// Moves the vertices along the normal by as much as the distance lacks, and back by as much as earlier
    /// pushes were too many.
    fn resolve(&self, unknowns: &Unknowns, push: &mut f64, displacements: &mut [Point]) {
        let near = self.near;
        let mass: f64 = near.free(unknowns).map(|(_, weight)| weight * weight).sum();
        if mass <= 0.0 {
            return;
        }
        let part =
            |(&vertex, weight): (&u32, &f64)| weight * dot(near.normal, displacements[vertex as usize]);
        let change: f64 = near.vertices.iter().zip(&near.weights).map(part).sum();
        let wanted = (*push + (self.least - change) / mass).max(0.0);
        for (vertex, weight) in near.free(unknowns) {
            for (axis, place) in displacements[vertex as usize].iter_mut().enumerate() {
                *place += (wanted - *push) * weight * near.normal[axis];
            }
        }
        *push = wanted;
    }
}
