//! The bending about a vertex, from differences of its gradient at rest and of angles.

use std::f64::consts::TAU;

use exact_ccd_mesh::Point;
use nalgebra::{DMatrix, DVector, Vector3};

use super::differences::random_vector;
use crate::energies::elasticity::bending;
use crate::energies::term::{Energy, Projection, pair_count};

/// The change of the angle at the edge of two vertices, and its sign, by the half angle between both unit
/// normals.
fn angle(points: &[Point], [a, b, c, d]: [usize; 4]) -> f64 {
    let [a, b, c, d] = [a, b, c, d].map(|vertex| Vector3::from(points[vertex]));
    let [n, m] = [(b - a).cross(&(c - a)), (d - a).cross(&(b - a))].map(|normal| normal.normalize());
    let size = 2.0 * (n - m).norm().atan2((n + m).norm());
    size * n.cross(&m).dot(&(b - a)).signum()
}

/// Differences of fourth order of a function of all coordinates, as columns.
fn differences(points: &[Point], f: impl Fn(&[Point]) -> DVector<f64>) -> DMatrix<f64> {
    const STEP: f64 = 1e-4;
    let column = |place: usize| {
        let at = |by: f64| {
            let mut points = points.to_vec();
            points[place / 3][place % 3] += by * STEP;
            f(&points)
        };
        ((at(1.0) - at(-1.0)) * 8.0 - (at(2.0) - at(-2.0))) / (12.0 * STEP)
    };
    DMatrix::from_columns(&(0..3 * points.len()).map(column).collect::<Vec<_>>())
}

/// A vertex of some faces, and its neighbours about it. If it is closed, the last face ends at the first
/// neighbour.
struct Fan {
    faces: Vec<[u32; 3]>,
    /// The vertices of each hinge.
    hinges: Vec<[usize; 4]>,
    center: usize,
}

impl Fan {
    /// The index of the center is in the middle of its neighbours' indices.
    fn new(neighbours: usize, is_closed: bool) -> Self {
        let center = neighbours / 2;
        let at = |place: usize| {
            let place = place % neighbours;
            if place < center { place } else { place + 1 }
        };
        let count = if is_closed { neighbours } else { neighbours - 1 };
        let face = |place: usize| [center, at(place), at(place + 1)].map(|vertex| vertex as u32);
        let first = usize::from(!is_closed);
        let hinge = |place: usize| [center, at(place), at(place + 1), at(place + neighbours - 1)];
        Self {
            faces: (0..count).map(face).collect(),
            hinges: (first..count).map(hinge).collect(),
            center,
        }
    }

    /// A shape without sharp or flat angles.
    fn points(&self, random: &mut fastrand::Rng) -> Vec<Point> {
        let neighbours = (self
            .faces
            .as_flattened()
            .iter()
            .max()
            .map_or(0, |&last| last as usize)) as f64;
        let mut points: Vec<Point> = (0..=neighbours as usize)
            .map(|vertex| {
                let turn = TAU * (vertex as f64 - f64::from(u8::from(vertex > self.center))) / neighbours;
                let radius = 0.8 + 0.4 * random.f64();
                let height = if vertex % 2 == 0 { 0.5 } else { 0.1 } + 0.2 * random.f64();
                [radius * turn.cos(), height, radius * turn.sin()]
            })
            .collect();
        points[self.center] = (random_vector(random) * 0.1).into();
        points
    }

    fn angles(&self, points: &[Point]) -> DVector<f64> {
        DVector::from_iterator(
            self.hinges.len(),
            self.hinges.iter().map(|&hinge| angle(points, hinge)),
        )
    }
}

fn assert_equal(found: &DMatrix<f64>, expected: &DMatrix<f64>, tolerance: f64, what: &str) {
    let error = (found - expected).amax() / expected.amax();
    assert!(
        error < tolerance,
        "{what}: relative error {error}\n{found}{expected}"
    );
}

/// At rest, no angle differs from its angle at rest, so that the Hessian H is J K Jᵀ with the derivatives J
/// of angles. With J from differences, K = J⁺ H J⁺ᵀ. In another shape, the changes b of the angles have the
/// energy
/// ½ bᵀ K b, its gradient, and the Hessian J K Jᵀ. The vertices have from 4 to 14 edges.
#[test]
fn the_energy_about_a_vertex_is_quadratic_in_the_angles() {
    let mut random = fastrand::Rng::with_seed(19);
    for neighbours in 4..15 {
        for is_closed in [true, false] {
            let what = format!("{neighbours} neighbours, {is_closed}");
            let fan = Fan::new(neighbours, is_closed);
            let (rest, points) = (fan.points(&mut random), fan.points(&mut random));
            let elements = bending(&rest, &fan.faces, 0.7, 0.3);
            let about = |element: &&std::sync::Arc<dyn Energy>| element.vertices().len() == rest.len();
            let element = elements.iter().find(about).unwrap();

            // Both derivatives, in the order of all vertices.
            let rows: Vec<usize> = (0..rest.len() as u32)
                .map(|vertex| {
                    element
                        .vertices()
                        .iter()
                        .position(|&other| other == vertex)
                        .unwrap()
                })
                .flat_map(|place| [0, 1, 2].map(|axis| 3 * place + axis))
                .collect();
            let gradient = |points: &[Point]| element.gradient(points).select_rows(&rows);
            let hessian = |points: &[Point]| {
                let hessian = element.hessian(points, Projection::SemiDefinite);
                hessian.select_rows(&rows).select_columns(&rows)
            };
            let slopes = |points: &[Point]| differences(points, |points| fan.angles(points)).transpose();

            let expected = differences(&rest, gradient);
            assert_equal(&hessian(&rest), &expected, 1e-7, &what);
            let inverse = slopes(&rest).pseudo_inverse(1e-9).unwrap();
            let stiffness = &inverse * expected * inverse.transpose();

            let bends = fan.angles(&points) - fan.angles(&rest);
            let moments = &stiffness * &bends;
            let value = element.value(&points);
            let error = (value / (0.5 * bends.dot(&moments)) - 1.0).abs();
            assert!(value > 0.0 && error < 1e-6, "{what}: {error}");
            let slopes = slopes(&points);
            let column = |vector: DVector<f64>| DMatrix::from_columns(&[vector]);
            let expected = column(&slopes * moments);
            assert_equal(&column(gradient(&points)), &expected, 1e-6, &what);
            let expected = &slopes * stiffness * slopes.transpose();
            assert_equal(&hessian(&points), &expected, 1e-6, &what);
        }
    }
}

/// The gradient alone and beside the Hessian have the same bits.
#[test]
fn the_gradient_does_not_depend_on_the_hessian() {
    let mut random = fastrand::Rng::with_seed(20);
    for neighbours in [4, 6, 14] {
        let fan = Fan::new(neighbours, true);
        let (rest, points) = (fan.points(&mut random), fan.points(&mut random));
        for element in bending(&rest, &fan.faces, 0.7, 0.3) {
            let count = element.vertices().len();
            let (mut gradient, mut hessian) = (vec![0.0; 3 * count], vec![[0.0; 9]; pair_count(count)]);
            let projection = Projection::SemiDefinite;
            element.write_derivatives(&points, projection, &mut gradient, &mut hessian);
            assert_eq!(element.gradient(&points).as_slice(), gradient);
        }
    }
}

/// Two faces of the same three vertices have the constant angle π between them: all derivatives are zero.
#[test]
fn faces_with_the_same_corners_do_not_bend() {
    let mut random = fastrand::Rng::with_seed(21);
    let mut points = || [0; 3].map(|_| Point::from(random_vector(&mut random)));
    let (rest, points) = (points(), points());
    let elements = bending(&rest, &[[0, 1, 2], [1, 0, 2]], 0.7, 0.3);
    assert_eq!(elements.len(), 3);
    for element in elements {
        assert!(element.gradient(&points).amax() < 1e-12);
        assert!(element.hessian(&points, Projection::SemiDefinite).amax() < 1e-12);
    }
}
