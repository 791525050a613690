//! The given shape, and the energy of the deviation from it.

use exact_ccd_mesh::vector::{dot, minus};
use exact_ccd_mesh::{Point, TriangleMesh};
use nalgebra::{Matrix3, Rotation3, Vector3};

use crate::error::RepairError;
use crate::size::Size;
use crate::system::{System, Unknowns};

/// The given positions s, and the energy
///
/// E(x) = α Σ |xᵢ − sᵢ|² + Σ wᵢⱼ |(xᵢ − xⱼ) − R (sᵢ − sⱼ)|²,
///
/// the second sum over edges. R is the mean of the rotations at the ends of the edge, each the best fit to
/// the edges of its vertex (as rigid as possible, Sorkine and Alexa 2007), and w the mean length of edges
/// divided by the length of the edge, so that short edges keep their lengths. The minimum of E is s. The
/// attraction α is relative to an edge of mean length.
pub(crate) struct Shape<'a> {
    mesh: &'a TriangleMesh,
    given: &'a [Point],
    weights: Vec<f64>,
    attraction: f64,
    system: System,
}

/// The largest weight of an edge, and the inverse of the least one.
const MOST_WEIGHT: f64 = 100.0;

impl<'a> Shape<'a> {
    pub(crate) fn new(
        mesh: &'a TriangleMesh,
        unknowns: &Unknowns,
        given: &'a [Point],
        size: &Size,
        attraction: f64,
    ) -> Result<Self, RepairError> {
        let weight = |&[a, b]: &[u32; 2]| {
            let edge = minus(given[a as usize], given[b as usize]);
            // An edge of length 0 has the largest weight.
            (size.mean_edge / dot(edge, edge).sqrt()).clamp(1.0 / MOST_WEIGHT, MOST_WEIGHT)
        };
        let weights: Vec<f64> = mesh.edges().iter().map(weight).collect();
        Ok(Self {
            mesh,
            given,
            system: factorised(mesh, unknowns, &weights, attraction)?,
            attraction,
            weights,
        })
    }

    /// Replaces the attraction.
    pub(crate) fn set_attraction(&mut self, unknowns: &Unknowns, attraction: f64) -> Result<(), RepairError> {
        self.attraction = attraction;
        self.system = factorised(self.mesh, unknowns, &self.weights, attraction)?;
        Ok(())
    }

    /// The positions after a step of the descent of E: its minimum with the rotations that fit `x`.
    pub(crate) fn nearer(&self, unknowns: &Unknowns, x: &[Point]) -> Vec<Point> {
        let rotations = self.rotations(x);
        let mut right: Vec<Point> = self
            .given
            .iter()
            .map(|place| place.map(|c| self.attraction * c))
            .collect();
        for ([a, b], weight) in self.edges() {
            let edge = Vector3::from(minus(self.given[a], self.given[b]));
            let turned = (rotations[a] + rotations[b]) * edge * (0.5 * weight);
            for axis in 0..3 {
                right[a][axis] += turned[axis];
                right[b][axis] -= turned[axis];
                // A pinned vertex is no unknown: its term is on the right side.
                for (free, other) in [(a, b), (b, a)] {
                    if unknowns.is_pinned(other) {
                        right[free][axis] += weight * self.given[other][axis];
                    }
                }
            }
        }
        unknowns.solve(&self.system, &right, |vertex| self.given[vertex as usize])
    }

    /// The rotation at each vertex that fits its edges best.
    fn rotations(&self, x: &[Point]) -> Vec<Matrix3<f64>> {
        let mut sums = vec![Matrix3::zeros(); x.len()];
        for ([a, b], weight) in self.edges() {
            let before = Vector3::from(minus(self.given[a], self.given[b]));
            let now = Vector3::from(minus(x[a], x[b]));
            let product = now * before.transpose() * weight;
            sums[a] += product;
            sums[b] += product;
        }
        let rotation = |sum: &Matrix3<f64>| {
            Rotation3::from_matrix_eps(sum, ROTATION_ERROR, ROTATION_ROUNDS, Rotation3::identity())
                .into_inner()
        };
        sums.iter().map(rotation).collect()
    }

    fn edges(&self) -> impl Iterator<Item = ([usize; 2], f64)> {
        let edges = self
            .mesh
            .edges()
            .iter()
            .map(|edge| edge.map(|vertex| vertex as usize));
        edges.zip(self.weights.iter().copied())
    }
}

/// The system of the energy, with given rotations.
fn factorised(
    mesh: &TriangleMesh,
    unknowns: &Unknowns,
    weights: &[f64],
    attraction: f64,
) -> Result<System, RepairError> {
    let edges = mesh.edges().iter().copied().zip(weights.iter().copied());
    unknowns.system(attraction, edges)
}

/// The angle and the number of rounds at which the fit of a rotation ends.
const ROTATION_ERROR: f64 = 1e-9;
const ROTATION_ROUNDS: usize = 50;
