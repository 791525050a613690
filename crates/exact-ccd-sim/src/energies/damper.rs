//! Damping in proportion to the stiffness.

use exact_ccd_mesh::Point;
use nalgebra::{DMatrix, DVector};

use super::term::{Block, Energy, Projection, write_blocks};

/// The energy ½ c (x − x₀)ᵀ K (x − x₀) of the vertices of an element, with the projected Hessian K of its
/// energy at the start of a time step, and the positions x₀ at zero velocity. With c = β h, its force is −β
/// K v as a part of the incremental potential: Rayleigh's damping. Rigid translations have no such force; a
/// rotation has, of the second order in the angle of a time step.
#[derive(Debug)]
pub(crate) struct Damper {
    vertices: Vec<u32>,
    origin: DVector<f64>,
    hessian: DMatrix<f64>,
}

impl Damper {
    /// The damper of an element, from the positions at the start of the time step, the positions x₀, and c.
    pub(crate) fn new(element: &dyn Energy, points: &[Point], origin: &[Point], factor: f64) -> Self {
        Self {
            vertices: element.vertices().to_vec(),
            origin: gathered(element.vertices(), origin),
            hessian: element.hessian(points, Projection::SemiDefinite) * factor,
        }
    }

    fn displacement(&self, points: &[Point]) -> DVector<f64> {
        gathered(&self.vertices, points) - &self.origin
    }
}

fn gathered(vertices: &[u32], points: &[Point]) -> DVector<f64> {
    let coordinates = vertices.iter().flat_map(|&vertex| points[vertex as usize]);
    DVector::from_iterator(3 * vertices.len(), coordinates)
}

impl Energy for Damper {
    fn vertices(&self) -> &[u32] {
        &self.vertices
    }

    fn value(&self, points: &[Point]) -> f64 {
        let displacement = self.displacement(points);
        0.5 * displacement.dot(&(&self.hessian * &displacement))
    }

    fn write_gradient(&self, points: &[Point], gradient: &mut [f64]) {
        let force = &self.hessian * self.displacement(points);
        gradient.copy_from_slice(force.as_slice());
    }

    fn write_hessian(&self, _: &[Point], _: Projection, hessian: &mut [Block]) {
        write_blocks(&self.hessian, self.vertices.len(), hessian);
    }
}
