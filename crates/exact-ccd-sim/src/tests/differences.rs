//! Finite differences of functions of four points.

use exact_ccd_mesh::Point;
use nalgebra::{DMatrix, Rotation3, Vector3};

use crate::energies::distance::{Matrix12, Vector12};
use crate::energies::term::{Energy, Projection};

pub(crate) type Points = [Vector3<f64>; 4];

/// The points as positions.
pub(crate) fn at(points: &Points) -> [Point; 4] {
    points.map(Point::from)
}

/// The gradient of an energy by the four points.
pub(crate) fn slope(energy: &dyn Energy, points: &Points) -> Vector12 {
    let mut gradient = Vector12::zeros();
    let found = energy.gradient(&at(points));
    for (place, &vertex) in energy.vertices().iter().enumerate() {
        let rows = found.fixed_rows::<3>(3 * place);
        gradient.fixed_rows_mut::<3>(3 * vertex as usize).copy_from(&rows);
    }
    gradient
}

/// The Hessian of an energy by the four points.
pub(crate) fn curvature(energy: &dyn Energy, points: &Points, projection: Projection) -> Matrix12 {
    let mut hessian = Matrix12::zeros();
    let found: DMatrix<f64> = energy.hessian(&at(points), projection);
    for (row, &a) in energy.vertices().iter().enumerate() {
        for (column, &b) in energy.vertices().iter().enumerate() {
            let block = found.fixed_view::<3, 3>(3 * row, 3 * column);
            let place = (3 * a as usize, 3 * b as usize);
            hessian.fixed_view_mut::<3, 3>(place.0, place.1).copy_from(&block);
        }
    }
    hessian
}

/// Asserts that the derivatives of an energy match differences with steps of this size, up to the tolerances
/// of gradient and Hessian, and that its projected Hessian is semi-definite. Returns the least eigenvalue of
/// its Hessian.
pub(crate) fn check(
    energy: &dyn Energy,
    points: &Points,
    step: f64,
    tolerances: [f64; 2],
    what: &str,
) -> f64 {
    let expected = gradient(points, step, |x| energy.value(&at(x)));
    assert_gradient(&slope(energy, points), &expected, tolerances[0], what);
    let expected = jacobian(points, step, |x| slope(energy, x));
    let found = curvature(energy, points, Projection::None);
    assert_hessian(&found, &expected, tolerances[1], what);
    assert_semi_definite(&curvature(energy, points, Projection::SemiDefinite), what);
    found.symmetric_eigenvalues().min()
}

/// Central differences of fourth order: the error is near 1e-11 for well-scaled functions.
const STENCIL: [(f64, f64); 4] = [(1.0, 8.0), (-1.0, -8.0), (2.0, -1.0), (-2.0, 1.0)];

fn moved(points: &Points, row: usize, by: f64) -> Points {
    let mut moved = *points;
    moved[row / 3][row % 3] += by;
    moved
}

/// The gradient of a function, with steps of this size.
pub(crate) fn gradient(points: &Points, step: f64, value: impl Fn(&Points) -> f64) -> Vector12 {
    Vector12::from_fn(|row, _| {
        let terms = STENCIL.map(|(at, weight)| weight * value(&moved(points, row, at * step)));
        terms.iter().sum::<f64>() / (12.0 * step)
    })
}

/// The Jacobian of a gradient, with steps of this size.
pub(crate) fn jacobian(points: &Points, step: f64, gradient: impl Fn(&Points) -> Vector12) -> Matrix12 {
    let column = |row: usize| {
        let terms = STENCIL.map(|(at, weight)| gradient(&moved(points, row, at * step)) * weight);
        terms.iter().sum::<Vector12>() / (12.0 * step)
    };
    Matrix12::from_columns(&core::array::from_fn::<_, 12, _>(column))
}

/// Asserts that two gradients agree, relative to the larger.
pub(crate) fn assert_gradient(found: &Vector12, expected: &Vector12, tolerance: f64, what: &str) {
    let error = (found - expected).norm() / expected.norm().max(1e-30);
    assert!(
        error < tolerance,
        "{what}: relative error {error} of the gradient\n{found}{expected}"
    );
}

/// Asserts that two Hessians agree, relative to the larger.
pub(crate) fn assert_hessian(found: &Matrix12, expected: &Matrix12, tolerance: f64, what: &str) {
    let error = (found - expected).norm() / expected.norm().max(1e-30);
    assert!(
        error < tolerance,
        "{what}: relative error {error} of the Hessian\n{found}{expected}"
    );
}

/// Asserts that a matrix is symmetric and has no eigenvalue below zero, up to rounding.
pub(crate) fn assert_semi_definite(matrix: &Matrix12, what: &str) {
    let asymmetry = (matrix - matrix.transpose()).norm();
    assert!(
        asymmetry <= 1e-13 * matrix.norm(),
        "{what}: asymmetry {asymmetry}"
    );
    let eigenvalues = matrix.symmetric_eigenvalues();
    let least = eigenvalues.min();
    assert!(
        least >= -1e-12 * eigenvalues.amax(),
        "{what}: eigenvalue {least} of {eigenvalues}"
    );
}

/// Random points, in a cube of side 2 about the origin.
pub(crate) fn random_points(random: &mut fastrand::Rng) -> Points {
    core::array::from_fn(|_| random_vector(random))
}

pub(crate) fn random_vector(random: &mut fastrand::Rng) -> Vector3<f64> {
    Vector3::from_fn(|_, _| 2.0 * random.f64() - 1.0)
}

pub(crate) fn random_rotation(random: &mut fastrand::Rng) -> Rotation3<f64> {
    Rotation3::new(random_vector(random) * 3.0)
}
