//! Stretching of rods.

use exact_ccd_mesh::Point;
use nalgebra::{Matrix3, Vector3};

use crate::energies::term::{Block, Energy, Projection, gather, write_products};

/// An edge of a rod, with the energy ½ E A L (l/L − 1)² of the length l, the length L at rest, and the cross
/// section A.
///
/// Source: M. Bergou, B. Audoly, E. Vouga, M. Wardetzky, E. Grinspun, *Discrete viscous threads*, ACM
/// Transactions on Graphics 29(4), 2010.
#[derive(Debug)]
pub(crate) struct Stretch {
    vertices: [u32; 2],
    length: f64,
    /// E A, in N.
    stiffness: f64,
}

/// The weights of both vertices in the vector of the edge.
const SIGNS: [f64; 2] = [-1.0, 1.0];

impl Stretch {
    /// The edge of two vertices, with the positions of all vertices at rest and the axial stiffness E A in N.
    /// `None` if it has no length at rest.
    pub(crate) fn new(vertices: [u32; 2], rest: &[Point], stiffness: f64) -> Option<Self> {
        let [a, b] = gather(rest, &vertices);
        let length = (b - a).norm();
        (length > 0.0).then_some(Self {
            vertices,
            length,
            stiffness,
        })
    }

    /// The length at rest, in m.
    pub(crate) fn length(&self) -> f64 {
        self.length
    }

    fn edge(&self, points: &[Point]) -> Vector3<f64> {
        let [a, b] = gather(points, &self.vertices);
        b - a
    }

    /// l/L − 1.
    fn strain(&self, edge: &Vector3<f64>) -> f64 {
        (edge.norm() - self.length) / self.length
    }
}

impl Energy for Stretch {
    fn vertices(&self) -> &[u32] {
        &self.vertices
    }

    fn value(&self, points: &[Point]) -> f64 {
        let strain = self.strain(&self.edge(points));
        0.5 * self.stiffness * self.length * strain * strain
    }

    /// An edge of length 0 has no gradient.
    fn write_gradient(&self, points: &[Point], gradient: &mut [f64]) {
        let edge = self.edge(points);
        let direction = edge.try_normalize(0.0).unwrap_or_else(Vector3::zeros);
        let force = direction * (self.stiffness * self.strain(&edge));
        for (rows, sign) in gradient.chunks_exact_mut(3).zip(SIGNS) {
            rows.copy_from_slice((force * sign).as_slice());
        }
    }

    /// With the direction t of the edge, the second derivative by the edge is E A (t tᵀ / L + (1/L − 1/l)
    /// (1 − t tᵀ)). Its eigenvalue across the edge is negative for a compressed edge.
    fn write_hessian(&self, points: &[Point], projection: Projection, hessian: &mut [Block]) {
        let edge = self.edge(points);
        let along = edge.try_normalize(0.0).unwrap_or_else(Vector3::zeros);
        let across = projection.of_value(self.strain(&edge) / edge.norm());
        // An edge of length 0 has no direction.
        let across = if across.is_finite() { across } else { 0.0 };
        let outer = along * along.transpose();
        let block = (outer / self.length + (Matrix3::identity() - outer) * across) * self.stiffness;
        write_products(&SIGNS, &block, hessian);
    }
}
