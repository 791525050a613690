//! The energy of plates with prescribed deflections of some vertices.

use exact_ccd_mesh::Point;
use nalgebra::{DMatrix, DVector};

use super::mesh::Mesh;
use crate::elasticity::bending;
use crate::energy::Projection;

/// The least bending energy of a plate in the plane y = 0 for small deflections, a flexural rigidity of 1 and a
/// Poisson's ratio. `deflection` is that of a vertex, or `None` where the vertex is free.
pub(super) fn least_energy(mesh: &Mesh, poisson: f64, deflection: impl Fn(&Point) -> Option<f64>) -> f64 {
    let count = mesh.points.len();
    let mut stiffness = DMatrix::zeros(count, count);
    for element in bending(&mesh.points, &mesh.faces, 1.0, poisson) {
        let hessian = element.hessian(&mesh.points, Projection::None);
        for (row, &a) in element.vertices().iter().enumerate() {
            for (column, &b) in element.vertices().iter().enumerate() {
                stiffness[(a as usize, b as usize)] += hessian[(3 * row + 1, 3 * column + 1)];
            }
        }
    }
    let given: Vec<Option<f64>> = mesh.points.iter().map(deflection).collect();
    let free: Vec<usize> = (0..count).filter(|&vertex| given[vertex].is_none()).collect();
    let mut deflections = DVector::from_iterator(count, given.iter().map(|given| given.unwrap_or(0.0)));
    let forces = -(&stiffness * &deflections);
    let (matrix, forces) = (
        stiffness.select_rows(&free).select_columns(&free),
        forces.select_rows(&free),
    );
    let solved = matrix.cholesky().unwrap().solve(&forces);
    for (&vertex, value) in free.iter().zip(solved.iter()) {
        deflections[vertex] = *value;
    }
    0.5 * deflections.dot(&(&stiffness * &deflections))
}
