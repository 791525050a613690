//! Stretching of rods.

use nalgebra::{Matrix3, Vector3};

use crate::element::{Element, Matrix12, Vector12};

/// An edge of a rod, with the energy ½ E A L (l/L − 1)² of the length l, the length L at rest, and the cross
/// section A.
///
/// Source: M. Bergou, B. Audoly, E. Vouga, M. Wardetzky, E. Grinspun, *Discrete viscous threads*, ACM
/// Transactions on Graphics 29(4), 2010.
#[derive(Clone, Debug)]
pub struct Stretch {
    vertices: [u32; 2],
    length: f64,
    /// E A, in N.
    stiffness: f64,
}

impl Stretch {
    /// The edge of two vertices, with its rest shape and the axial stiffness E A in N. `None` if it has no
    /// length at rest.
    #[must_use]
    pub fn new(vertices: [u32; 2], rest: &[Vector3<f64>; 2], stiffness: f64) -> Option<Self> {
        let length = (rest[1] - rest[0]).norm();
        (length > 0.0).then_some(Self {
            vertices,
            length,
            stiffness,
        })
    }

    /// The vertices.
    #[must_use]
    pub fn vertices(&self) -> [u32; 2] {
        self.vertices
    }

    /// The length at rest, in m.
    #[must_use]
    pub fn length(&self) -> f64 {
        self.length
    }

    /// The energy in J, for these positions of the vertices.
    #[must_use]
    pub fn value(&self, points: &[Vector3<f64>; 2]) -> f64 {
        let strain = self.strain((points[1] - points[0]).norm());
        0.5 * self.stiffness * self.length * strain * strain
    }

    /// The gradient of the energy. An edge of length 0 has none.
    #[must_use]
    pub fn gradient(&self, points: &[Vector3<f64>; 2]) -> Vector12 {
        let edge = points[1] - points[0];
        let direction = edge.try_normalize(0.0).unwrap_or_else(Vector3::zeros);
        let force = direction * (self.stiffness * self.strain(edge.norm()));
        let mut gradient = Vector12::zeros();
        gradient.fixed_rows_mut::<3>(0).copy_from(&-force);
        gradient.fixed_rows_mut::<3>(3).copy_from(&force);
        gradient
    }

    /// The gradient and the Hessian of the energy. If `projected`, the Hessian is positive semi-definite.
    ///
    /// With the direction t of the edge, the second derivative by the edge is E A (t tᵀ / L + (1/L − 1/l)
    /// (1 − t tᵀ)). Its eigenvalue across the edge is negative for a compressed edge.
    #[must_use]
    pub fn derivatives(&self, points: &[Vector3<f64>; 2], projected: bool) -> Element {
        let edge = points[1] - points[0];
        let along = edge.try_normalize(0.0).unwrap_or_else(Vector3::zeros);
        let across = match self.strain(edge.norm()) / edge.norm() {
            across if across < 0.0 && projected => 0.0,
            across if across.is_finite() => across,
            // An edge of length 0 has no direction.
            _ => 0.0,
        };
        let outer = along * along.transpose();
        let block = (outer / self.length + (Matrix3::identity() - outer) * across) * self.stiffness;
        let mut hessian = Matrix12::zeros();
        for (row, column, sign) in [(0, 0, 1.0), (3, 3, 1.0), (0, 3, -1.0), (3, 0, -1.0)] {
            hessian
                .fixed_view_mut::<3, 3>(row, column)
                .copy_from(&(block * sign));
        }
        Element {
            vertices: self.vertices.into_iter().collect(),
            gradient: self.gradient(points),
            hessian,
        }
    }

    /// l/L − 1.
    fn strain(&self, length: f64) -> f64 {
        (length - self.length) / self.length
    }
}
