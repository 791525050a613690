//! The sums over all elements, against finite differences and dense matrices.

mod fixture;
mod iterative;

use exact_ccd_mesh::Point;
use nalgebra::{DMatrix, DVector, Matrix3, Vector3};

use super::linear::LinearSolver;
use super::pattern::{Pattern, key};
use fixture::Fixture;

/// The dense form of a symmetric matrix with a stored lower triangle.
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

/// The derivatives of a function by all coordinates, as columns, from differences of fourth order.
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
    let found = flat(&potential.gradient(&fixture.points, collisions.as_slice()));
    let value = |points: &[Point]| {
        DVector::from_element(1, potential.value(points, fixture.collisions(points).as_slice()))
    };
    let expected = differences(&fixture.points, 1e-5, value).transpose();
    let error = (&found - &expected).amax();
    assert!(error < 1e-6 * expected.amax(), "{error} of {}", expected.amax());
    // The gradient of the quadratic model is the same.
    let quadratic = fixture.quadratic(&collisions, &fixture.unknowns());
    let error = (flat(&quadratic.gradient) - &found).amax();
    assert!(error < 1e-12 * found.amax(), "{error} of {}", found.amax());
}

#[test]
fn the_sparse_hessian_is_the_sum_of_the_elements() {
    let mut fixture = Fixture::new(1.0, 0.02);
    assert_sum(&fixture);
    // Without friction, the contacts alone determine the pattern.
    fixture.terms.friction.clear();
    assert_sum(&fixture);
}

fn assert_sum(fixture: &Fixture) {
    let unknowns = fixture.unknowns();
    let collisions = fixture.collisions(&fixture.points);
    let quadratic = fixture.quadratic(&collisions, &unknowns);
    let dense = fixture.dense(&collisions);
    let [rows, places] = fixture.rows();

    let found = expanded(&quadratic.pattern, &quadratic.values);
    // Known coordinates are eliminated.
    for known in (0..found.nrows()).filter(|place| !places.contains(place)) {
        assert!(found[(known, known)] > 0.0);
        assert_eq!(found.row(known).iter().filter(|&&value| value != 0.0).count(), 1);
    }
    assert!(places.len() < found.nrows());
    let found = found.select_rows(&places).select_columns(&places);
    let expected = dense.select_rows(&rows).select_columns(&rows);
    let error = (&found - &expected).amax();
    assert!(error < 1e-12 * expected.amax(), "{error} of {}", expected.amax());
    // The test detects transposed blocks only if blocks are not symmetric.
    let block = expected.view((3, 0), (3, 3));
    assert!((block - block.transpose()).amax() > 1e-3 * expected.amax());

    // The change of the gradient by the prescribed displacements.
    let expected = (&dense * flat(&fixture.prescribed())).select_rows(&rows);
    let found = flat(&quadratic.prescribed).select_rows(&rows);
    let error = (&found - &expected).amax();
    assert!(
        expected.amax() > 0.0 && error < 1e-12 * expected.amax(),
        "{error} of {}",
        expected.amax()
    );
}

/// In tension, the elements are convex, so that projection does not change the Hessian.
#[test]
fn the_hessian_is_the_slope_of_the_gradient() {
    let fixture = Fixture::new(1.1, 0.0);
    assert!(!fixture.terms.friction.is_empty());
    let none = fixture.no_collisions();
    let unknowns = fixture.unknowns();
    let quadratic = fixture.quadratic(&none, &unknowns);
    let potential = fixture.potential();
    let slopes = differences(&fixture.points, 1e-5, |points| {
        flat(&potential.gradient(points, none.as_slice()))
    });
    let [rows, places] = fixture.rows();

    let found = expanded(&quadratic.pattern, &quadratic.values);
    let found = found.select_rows(&places).select_columns(&places);
    let expected = slopes.select_rows(&rows).select_columns(&rows);
    let error = (&found - &expected).amax();
    assert!(error < 1e-6 * expected.amax(), "{error} of {}", expected.amax());
    let expected = (slopes * flat(&fixture.prescribed())).select_rows(&rows);
    let error = (flat(&quadratic.prescribed).select_rows(&rows) - &expected).amax();
    assert!(error < 1e-6 * expected.amax(), "{error} of {}", expected.amax());
}

#[test]
fn the_sparse_solution_is_the_dense_one() {
    let fixture = Fixture::new(1.0, 0.02);
    let unknowns = fixture.unknowns();
    let quadratic = fixture.quadratic(&fixture.collisions(&fixture.points), &unknowns);
    let dense = expanded(&quadratic.pattern, &quadratic.values);
    let right = quadratic.right(&unknowns);
    let expected = dense
        .cholesky()
        .unwrap()
        .solve(&DVector::from_column_slice(&right));
    let solution = LinearSolver::default().solve(quadratic.pattern, quadratic.values, &right);
    let solution = DVector::from_vec(solution.unwrap());
    let known = unknowns.known().unwrap().as_flattened();
    let of_known = || known.iter().zip(&solution).filter(|(is_known, _)| **is_known);
    assert!(of_known().next().is_some() && of_known().all(|(_, &value)| value == 0.0));
    let error = (solution - &expected).amax();
    assert!(error < 1e-8 * expected.amax(), "{error} of {}", expected.amax());
}

/// After a model with all pairs of contacts, the model without contacts has its pattern, the same matrix and
/// the same solution. The other way round, it has its own pattern.
#[test]
fn a_pattern_that_has_all_pairs_is_kept() {
    let mut fixture = Fixture::new(1.0, 0.02);
    let unknowns = fixture.unknowns();
    let collisions = fixture.collisions(&fixture.points);
    let many = fixture.quadratic(&collisions, &unknowns);
    fixture.terms.friction.clear();
    let none = fixture.no_collisions();
    let few = fixture.quadratic(&none, &unknowns);
    assert!(few.pattern.len() < many.pattern.len());

    let kept = fixture.quadratic_after(Some(&many.pattern), &none, &unknowns);
    assert_eq!(kept.pattern, many.pattern);
    let dense = expanded(&few.pattern, &few.values);
    assert_eq!(expanded(&kept.pattern, &kept.values), dense);
    let right = few.right(&unknowns);
    assert_eq!(kept.right(&unknowns), right);
    let solve = |pattern, values| LinearSolver::default().solve(pattern, values, &right).unwrap();
    let [found, expected] = [kept, few].map(|model| DVector::from_vec(solve(model.pattern, model.values)));
    let error = (found - &expected).amax();
    assert!(error < 1e-10 * expected.amax(), "{error} of {}", expected.amax());

    let own = Pattern::new(unknowns.len(), Vec::new());
    let grown = fixture.quadratic_after(Some(&own), &collisions, &unknowns);
    assert_eq!(grown.pattern, fixture.quadratic(&collisions, &unknowns).pattern);
}

/// A pattern to which pairs are added equals the pattern of all pairs, and its blocks are at the places of
/// their pairs.
#[test]
fn a_pattern_with_more_pairs_is_that_of_all() {
    let mut random = fastrand::Rng::with_seed(12);
    for _ in 0..50 {
        let mut pairs = |count: u32| {
            let mut pair = || [0; 2].map(|_| random.u32(..9));
            (0..count).map(|_| pair()).collect::<Vec<_>>()
        };
        let (few, more) = (pairs(8), pairs(12));
        let keys = |pairs: &[[u32; 2]]| pairs.iter().map(|&[a, b]| key(a, b)).collect::<Vec<_>>();
        let pattern = Pattern::new(9, keys(&few));
        let found = pattern.with(keys(&more));
        assert_eq!(found, Pattern::new(9, keys(&[few.clone(), more].concat())));
        let places = pattern.places_in(&found).unwrap();
        assert_eq!(places.len(), pattern.len());
        for [a, b] in few.into_iter().chain((0..9).map(|a| [a, a])) {
            let place = places[pattern.place(a, b).unwrap()] as usize;
            assert_eq!(found.place(b, a), Some(place));
        }
        // A pattern with more blocks is in none with less.
        assert_eq!(found.places_in(&pattern).is_some(), found.len() == pattern.len());
    }
}

/// The scalars are the entries of the blocks of the lower triangle.
#[test]
fn the_values_are_those_of_the_blocks() {
    let pattern = Pattern::new(3, vec![key(2, 0), key(0, 2)]);
    assert_eq!(pattern.len(), 4);
    let block = |place: usize| std::array::from_fn(|entry| (9 * place + entry) as f64);
    let blocks: Vec<[f64; 9]> = (0..4).map(block).collect();
    let mut expected = DMatrix::zeros(9, 9);
    for [row, column] in [[0, 0], [2, 0], [1, 1], [2, 2]] {
        let block = blocks[pattern.place(row, column).unwrap()];
        let place = (3 * row as usize, 3 * column as usize);
        expected
            .view_mut(place, (3, 3))
            .copy_from(&Matrix3::from_column_slice(&block));
    }
    expected.fill_upper_triangle_with_lower_triangle();
    assert_eq!(expanded(&pattern, &pattern.values(&blocks)), expected);
}
