//! The sums over all elements, against finite differences and dense matrices.

use exact_ccd_mesh::Point;
use fastrand::Rng;
use nalgebra::{DMatrix, DVector, Matrix3, Vector3};

use super::linear::LinearSolver;
use super::pattern::{Pattern, key};
use super::potential::{Potential, Spring};
use super::quadratic::Quadratic;
use super::unknowns::Unknowns;
use crate::contact::{Barrier, Collisions, Pairs};
use crate::element::Element;
use crate::friction::{FrictionContact, Smoothing};
use crate::gather::gather_some;
use crate::integrator::Scheme;
use crate::shapes;
use crate::system::System;

const DISTANCE: f64 = 0.2;

const SMOOTHING: Smoothing = Smoothing { threshold: 0.05 };

/// A vertex that a spring pulls.
const PULLED: u32 = 9;

/// A cloth between a floor and a box, so that all kinds of elements are there, on vertices whose numbers are mixed.
struct Fixture {
    system: System,
    scheme: Scheme,
    points: Vec<Point>,
    barrier: Barrier,
    friction: Vec<FrictionContact>,
    springs: Vec<Spring>,
}

impl Fixture {
    /// All stretched by a factor, and moved at random by at most a length along each axis.
    fn new(stretch: f64, noise: f64) -> Self {
        let mut random = Rng::with_seed(11);
        let floor = shapes::floor([1, 1], [1.3, 1.2]);
        let cloth = shapes::cloth([1, 1], [1.0, 1.1]).placed(|[x, _, z]| [x + 0.2, 0.1, z + 0.1]);
        let solid =
            shapes::solid_box([1, 1, 1], [0.7, 0.6, 0.8]).placed(|[x, y, z]| [x + 0.3, y + 0.2, z + 0.2]);
        let system = System::new(&[floor, cloth, solid], &[]).unwrap();
        let mut moved = |point: &Point, by: f64| point.map(|x| x + by * (2.0 * random.f64() - 1.0));
        let stretched = |point: &Point| point.map(|x| stretch * x);
        let points: Vec<Point> = system
            .start
            .iter()
            .map(|point| moved(&stretched(point), noise))
            .collect();
        let scheme = Scheme {
            duration: 0.1,
            origin: points.iter().map(|point| moved(point, 0.04)).collect(),
            predicted: points.iter().map(|point| moved(point, 0.3)).collect(),
        };
        let spring = Spring {
            vertex: PULLED,
            target: [1.0, 2.0, 3.0],
            stiffness: 50.0,
        };
        let mut fixture = Self {
            system,
            scheme,
            points,
            barrier: Barrier::new(DISTANCE),
            friction: Vec::new(),
            springs: vec![spring],
        };
        let collisions = fixture.collisions(&fixture.points);
        let friction = collisions.as_slice().iter().map(|collision| {
            let separation = collision.separation(&gather_some(&fixture.points, collision.vertices()));
            FrictionContact::new(collision.vertices().clone(), &separation, 1e3)
        });
        fixture.friction = friction.collect();
        fixture
    }

    fn potential(&self) -> Potential<'_> {
        Potential {
            system: &self.system,
            scheme: &self.scheme,
            stiffness: 1e7,
            friction: &self.friction,
            smoothing: SMOOTHING,
            springs: &self.springs,
        }
    }

    fn collisions(&self, points: &[Point]) -> Collisions {
        let System { surface, start, .. } = &self.system;
        let pairs = Pairs::near(surface, points, points, DISTANCE);
        Collisions::new(surface, &pairs, points, start, self.barrier)
    }

    /// Nothing near.
    fn no_collisions(&self) -> Collisions {
        let System { surface, start, .. } = &self.system;
        Collisions::new(surface, &Pairs::default(), &self.points, start, self.barrier)
    }

    /// All vertices but the fixed ones of the floor, and of the others every fifth.
    fn unknowns(&self) -> Unknowns {
        let unknown: Vec<bool> = (0..self.points.len())
            .map(|vertex| self.system.is_free(vertex) && vertex % 5 != 0)
            .collect();
        Unknowns::new(&unknown)
    }

    /// How the vertices that are not unknown are displaced.
    fn given(&self, unknowns: &Unknowns) -> Vec<Vector3<f64>> {
        let given = |vertex: usize| match unknowns.number(vertex as u32) {
            Some(_) => Vector3::zeros(),
            None => Vector3::new(1.0, -2.0, 0.5) * (1.0 + vertex as f64),
        };
        (0..self.points.len()).map(given).collect()
    }

    fn quadratic(&self, collisions: &Collisions, unknowns: &Unknowns) -> Quadratic {
        let potential = self.potential();
        let keys = potential.elastic_keys(unknowns);
        potential.quadratic(&self.points, collisions, unknowns, &keys, &self.given(unknowns))
    }

    /// The projected Hessian of all vertices.
    fn dense(&self, collisions: &Collisions) -> DMatrix<f64> {
        let points = &self.points;
        let mut dense = DMatrix::zeros(3 * points.len(), 3 * points.len());
        let mut add = |element: &Element, scale: f64| {
            for (row, &a) in element.vertices.iter().enumerate() {
                for (column, &b) in element.vertices.iter().enumerate() {
                    let mut block = dense.fixed_view_mut::<3, 3>(3 * a as usize, 3 * b as usize);
                    block += element.block(row, column) * scale;
                }
            }
        };
        let potential = self.potential();
        let scale = self.scheme.duration * self.scheme.duration;
        for element in &self.system.elements {
            add(&element.derivatives(points, true), scale);
        }
        for c in collisions.as_slice() {
            let corners = gather_some(points, c.vertices());
            add(&c.derivatives(&corners, &self.barrier, true), potential.stiffness);
        }
        for f in &self.friction {
            add(
                &f.derivatives(&potential.displacements(points, f), SMOOTHING),
                1.0,
            );
        }
        for vertex in 0..points.len() {
            let springs = self
                .springs
                .iter()
                .filter(|spring| spring.vertex as usize == vertex);
            let inertia = if self.system.is_free(vertex) {
                self.system.masses[vertex]
            } else {
                0.0
            };
            let sum = inertia + springs.map(|spring| spring.stiffness).sum::<f64>();
            for axis in 0..3 {
                dense[(3 * vertex + axis, 3 * vertex + axis)] += sum;
            }
        }
        dense
    }
}

/// The rows of some vertices.
fn places(vertices: &[u32]) -> Vec<usize> {
    vertices
        .iter()
        .flat_map(|&vertex| [0, 1, 2].map(|axis: usize| 3 * vertex as usize + axis))
        .collect()
}

/// The whole of a symmetric matrix of which the lower triangle is stored.
fn expanded(pattern: &Pattern, values: &[f64]) -> DMatrix<f64> {
    let scalars = pattern.scalars();
    let size = scalars.ncols();
    let mut dense = DMatrix::zeros(size, size);
    for column in 0..size {
        let places = scalars.col_ptr()[column]..scalars.col_ptr()[column + 1];
        for (&row, &value) in scalars.row_idx()[places.clone()].iter().zip(&values[places]) {
            assert!(row >= column);
            dense[(row, column)] = value;
            dense[(column, row)] = value;
        }
    }
    dense
}

fn flat(vectors: &[Vector3<f64>]) -> DVector<f64> {
    DVector::from_iterator(3 * vectors.len(), vectors.iter().flat_map(|v| v.iter().copied()))
}

/// The derivatives of a function of all coordinates, as columns, by differences of fourth order.
fn differences(points: &[Point], step: f64, f: impl Fn(&[Point]) -> DVector<f64>) -> DMatrix<f64> {
    let columns: Vec<DVector<f64>> = (0..3 * points.len())
        .map(|place| {
            let at = |by: f64| {
                let mut points = points.to_vec();
                points[place / 3][place % 3] += by * step;
                f(&points)
            };
            ((at(1.0) - at(-1.0)) * 8.0 - (at(2.0) - at(-2.0))) / (12.0 * step)
        })
        .collect();
    DMatrix::from_columns(&columns)
}

#[test]
fn the_gradient_is_the_slope_of_the_value() {
    let fixture = Fixture::new(1.0, 0.02);
    let potential = fixture.potential();
    let collisions = fixture.collisions(&fixture.points);
    assert!(collisions.as_slice().len() > 20);
    let found = flat(&potential.gradient(&fixture.points, &collisions));
    let value =
        |points: &[Point]| DVector::from_element(1, potential.value(points, &fixture.collisions(points)));
    let expected = differences(&fixture.points, 1e-5, value).transpose();
    let error = (&found - &expected).amax();
    assert!(error < 1e-6 * expected.amax(), "{error} of {}", expected.amax());
    // And so is the one that comes with the Hessian.
    let quadratic = fixture.quadratic(&collisions, &fixture.unknowns());
    let error = (flat(&quadratic.gradient) - &found).amax();
    assert!(error < 1e-12 * found.amax(), "{error} of {}", found.amax());
}

#[test]
fn the_sparse_hessian_is_the_sum_of_the_elements() {
    let mut fixture = Fixture::new(1.0, 0.02);
    assert_sum(&fixture);
    // Without friction, which is where the contacts are.
    fixture.friction.clear();
    assert_sum(&fixture);
}

fn assert_sum(fixture: &Fixture) {
    let unknowns = fixture.unknowns();
    let collisions = fixture.collisions(&fixture.points);
    let quadratic = fixture.quadratic(&collisions, &unknowns);
    let dense = fixture.dense(&collisions);
    let rows = places(unknowns.vertices());

    let found = expanded(&quadratic.pattern, &quadratic.values);
    let expected = dense.select_rows(&rows).select_columns(&rows);
    let error = (&found - &expected).amax();
    assert!(error < 1e-12 * expected.amax(), "{error} of {}", expected.amax());
    // Blocks that are not symmetric: a transposed one would show.
    let block = expected.view((3, 0), (3, 3));
    assert!((block - block.transpose()).amax() > 1e-3 * expected.amax());

    // What the given displacements of the others do to the unknowns.
    let expected = (&dense * flat(&fixture.given(&unknowns))).select_rows(&rows);
    let found = flat(&quadratic.given).select_rows(&rows);
    let error = (&found - &expected).amax();
    assert!(
        expected.amax() > 0.0 && error < 1e-12 * expected.amax(),
        "{error} of {}",
        expected.amax()
    );
}

/// In tension nothing is projected.
#[test]
fn the_hessian_is_the_slope_of_the_gradient() {
    let fixture = Fixture::new(1.1, 0.0);
    assert!(!fixture.friction.is_empty());
    let none = fixture.no_collisions();
    let unknowns = fixture.unknowns();
    let quadratic = fixture.quadratic(&none, &unknowns);
    let potential = fixture.potential();
    let slopes = differences(&fixture.points, 1e-5, |points| {
        flat(&potential.gradient(points, &none))
    });
    let rows = places(unknowns.vertices());

    let found = expanded(&quadratic.pattern, &quadratic.values);
    let expected = slopes.select_rows(&rows).select_columns(&rows);
    let error = (&found - &expected).amax();
    assert!(error < 1e-6 * expected.amax(), "{error} of {}", expected.amax());
    let expected = (slopes * flat(&fixture.given(&unknowns))).select_rows(&rows);
    let error = (flat(&quadratic.given).select_rows(&rows) - &expected).amax();
    assert!(error < 1e-6 * expected.amax(), "{error} of {}", expected.amax());
}

#[test]
fn the_sparse_solution_is_the_dense_one() {
    let fixture = Fixture::new(1.0, 0.02);
    let unknowns = fixture.unknowns();
    let quadratic = fixture.quadratic(&fixture.collisions(&fixture.points), &unknowns);
    let dense = expanded(&quadratic.pattern, &quadratic.values);
    let right = flat(&quadratic.gradient).select_rows(&places(unknowns.vertices()));
    let expected = dense.cholesky().unwrap().solve(&right);
    let solution = LinearSolver::default().solve(quadratic.pattern, quadratic.values, right.as_slice());
    let error = (DVector::from_vec(solution.unwrap()) - &expected).amax();
    assert!(error < 1e-8 * expected.amax(), "{error} of {}", expected.amax());
}

/// A block may be given for either triangle, and is added to what is there.
#[test]
fn a_block_and_its_transpose_across_the_diagonal_are_the_same() {
    let pattern = Pattern::new(3, vec![key(2, 0), key(0, 1), key(0, 2)]);
    let block = Matrix3::from_fn(|row, column| (3 * row + column) as f64);
    let mut values = vec![0.0; pattern.scalar_count()];
    pattern.add(&mut values, 2, 0, &block);
    pattern.add(&mut values, 0, 2, &block.transpose());
    pattern.add(&mut values, 1, 1, &(block + block.transpose()));
    let mut expected = DMatrix::zeros(9, 9);
    expected.view_mut((6, 0), (3, 3)).copy_from(&(block * 2.0));
    expected
        .view_mut((0, 6), (3, 3))
        .copy_from(&(block.transpose() * 2.0));
    expected
        .view_mut((3, 3), (3, 3))
        .copy_from(&(block + block.transpose()));
    assert_eq!(expanded(&pattern, &values), expected);
}
