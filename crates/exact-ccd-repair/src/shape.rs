//! The given shape, and the energy of the deviation from it.

use exact_ccd_mesh::vector::minus;
use exact_ccd_mesh::{Point, TriangleMesh};
use nalgebra::{Matrix3, Rotation3, Vector3};

use crate::error::RepairError;
use crate::system::{System, Unknowns};

/// The given positions s, and the energy
///
/// E(x) = α Σ |xᵢ − sᵢ|² + Σ wᵢⱼ |(xᵢ − xⱼ) − R (sᵢ − sⱼ)|²,
///
/// the second sum over edges. R is the mean of the rotations at the ends of the edge, each the best fit to
/// the edges of its vertex (as rigid as possible, Sorkine and Alexa 2007), and w the square of the
/// [closeness](crate::closeness) of the ends, so that an edge of any length is stretched by the same factor
/// for the same energy. The minimum of E is s.
pub(crate) struct Shape<'a> {
    mesh: &'a TriangleMesh,
    given: &'a [Point],
    weights: Vec<f64>,
    system: System,
}

/// The attraction α of E.
const ATTRACTION: f64 = 0.01;

/// The weight of the displacement in a step. It lets a step change little where nothing is deformed within a
/// few edges: a dent is smoothed in a few steps, and the whole moves towards s in many.
const INERTIA: f64 = 0.29;

impl<'a> Shape<'a> {
    pub(crate) fn new(
        mesh: &'a TriangleMesh,
        unknowns: &Unknowns,
        given: &'a [Point],
        closeness: &[f64],
    ) -> Result<Self, RepairError> {
        let weights: Vec<f64> = closeness.iter().map(|closeness| closeness * closeness).collect();
        let edges = mesh.edges().iter().copied().zip(weights.iter().copied());
        Ok(Self {
            mesh,
            given,
            system: unknowns.system(ATTRACTION + INERTIA, edges)?,
            weights,
        })
    }

    /// The positions y after a step of the descent of E from `x`: the minimum of E(y) + β Σ |yᵢ − xᵢ|² with
    /// the rotations that fit `x`, and β the inertia.
    pub(crate) fn nearer(&self, unknowns: &Unknowns, x: &[Point]) -> Vec<Point> {
        let rotations = self.rotations(x);
        let towards = |(given, x): (&Point, &Point)| {
            [0, 1, 2].map(|axis: usize| ATTRACTION * given[axis] + INERTIA * x[axis])
        };
        let mut right: Vec<Point> = self.given.iter().zip(x).map(towards).collect();
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

/// The angle and the number of rounds at which the fit of a rotation ends.
const ROTATION_ERROR: f64 = 1e-9;
const ROTATION_ROUNDS: usize = 50;
