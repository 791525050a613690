//! Finite differences of functions of four points.

use exact_ccd_sim::{Matrix12, Vector12};
use nalgebra::{Rotation3, Vector3};

pub(crate) type Points = [Vector3<f64>; 4];

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
