//! Pairs of features, and the squared distance between them.

use nalgebra::{Matrix2, Matrix2x3, SMatrix, SVector, Vector2, Vector3};

/// The kind of a pair of features.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum FeatureKind {
    /// Two points.
    PointPoint,
    /// A point and the line of an edge.
    PointLine,
    /// A point and the plane of a triangle.
    PointPlane,
    /// The lines of two edges.
    LineLine,
}

/// A pair of features of four points. The vector r between two points of the features is the combination
/// of the four points with the weights w + λ₁ d₁ + λ₂ d₂.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Feature {
    kind: FeatureKind,
    /// w.
    weights: [f64; 4],
    /// d₁ and d₂.
    along: [[f64; 4]; 2],
}

/// The shortest vector between two features.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct ShortestVector {
    /// The weights of the four points in the vector.
    pub(crate) weights: [f64; 4],
    /// The vector between the closest points.
    pub(crate) vector: Vector3<f64>,
}

/// The gradient C g and the Hessian C H Cᵀ of a squared distance, in factored form: it depends on the
/// twelve coordinates by five linear combinations only.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Factors {
    /// C: the derivatives by the four points of the vector between the closest points (three columns) and of
    /// half the derivatives of its square by λ₁ and λ₂ (two columns).
    pub(crate) change: SMatrix<f64, 12, 5>,
    /// g.
    pub(crate) first: SVector<f64, 5>,
    /// H.
    pub(crate) second: SMatrix<f64, 5, 5>,
}

impl ShortestVector {
    /// The squared distance.
    pub(crate) fn squared(&self) -> f64 {
        self.vector.norm_squared()
    }
}

impl Feature {
    /// Two points, given by their indices among the four.
    pub(crate) fn point_point(a: usize, b: usize) -> Self {
        Self {
            kind: FeatureKind::PointPoint,
            weights: weights(&[(a, 1.0), (b, -1.0)]),
            along: [[0.0; 4]; 2],
        }
    }

    /// A point and the line through two others.
    pub(crate) fn point_line(point: usize, a: usize, b: usize) -> Self {
        Self {
            kind: FeatureKind::PointLine,
            weights: weights(&[(point, 1.0), (a, -1.0)]),
            along: [weights(&[(a, 1.0), (b, -1.0)]), [0.0; 4]],
        }
    }

    /// The first point and the plane through the others.
    pub(crate) fn point_plane() -> Self {
        Self {
            kind: FeatureKind::PointPlane,
            weights: [1.0, -1.0, 0.0, 0.0],
            along: [[0.0, 1.0, -1.0, 0.0], [0.0, 1.0, 0.0, -1.0]],
        }
    }

    /// The line through the first two points and the line through the last two.
    pub(crate) fn line_line() -> Self {
        Self {
            kind: FeatureKind::LineLine,
            weights: [1.0, 0.0, -1.0, 0.0],
            along: [[-1.0, 1.0, 0.0, 0.0], [0.0, 0.0, 1.0, -1.0]],
        }
    }

    /// The same pair of features of points in another order: the last two before the first two.
    pub(crate) fn swapped(mut self) -> Self {
        self.weights.rotate_left(2);
        self.along.iter_mut().for_each(|along| along.rotate_left(2));
        self
    }

    /// The kind of the pair.
    pub(crate) fn kind(&self) -> FeatureKind {
        self.kind
    }

    /// The index of the point in a pair of a point and another feature. Its weight is always 1.
    pub(crate) fn point(&self) -> usize {
        let is_point = |&place: &usize| self.weights[place] == 1.0 && self.along[0][place] == 0.0;
        (0..4).find(is_point).unwrap_or(0)
    }

    /// Returns true if the distance depends on the point with this index.
    pub(crate) fn uses(&self, point: usize) -> bool {
        self.weights[point] != 0.0 || self.along.iter().any(|along| along[point] != 0.0)
    }

    /// The vector between the closest points. If a line or a plane is degenerate, the closest points are
    /// not unique, and the vector joins one such pair.
    pub(crate) fn shortest_vector(&self, points: &[Vector3<f64>; 4]) -> ShortestVector {
        let (parameters, ..) = self.closest(points);
        let mut weights = self.weights;
        for (along, parameter) in self.along.iter().zip(parameters.iter()) {
            for (weight, change) in weights.iter_mut().zip(along) {
                *weight += parameter * change;
            }
        }
        let vector = combine(points, &weights);
        ShortestVector { weights, vector }
    }

    /// The gradient and the Hessian of the squared distance, in factored form.
    pub(crate) fn factors(&self, points: &[Vector3<f64>; 4]) -> Factors {
        let (_, inverse, tangents) = self.closest(points);
        let ShortestVector { weights, vector } = self.shortest_vector(points);
        let change = SMatrix::<f64, 12, 5>::from_fn(|row, column| {
            let (point, axis) = (row / 3, row % 3);
            match column.checked_sub(3) {
                // ½ ∂²|r|²/∂x∂λₖ.
                Some(k) => self.along[k][point] * vector[axis] + weights[point] * tangents[(k, axis)],
                None if column == axis => weights[point],
                None => 0.0,
            }
        });
        let mut first = SVector::<f64, 5>::zeros();
        first.fixed_rows_mut::<3>(0).copy_from(&(vector * 2.0));
        // The block of λ is the Schur complement of half of ∂²|r|²/∂λ².
        let mut second = SMatrix::<f64, 5, 5>::from_diagonal_element(2.0);
        second.fixed_view_mut::<2, 2>(3, 3).copy_from(&(inverse * -2.0));
        Factors {
            change,
            first,
            second,
        }
    }

    /// The parameters λ of the closest points, the (pseudo-)inverse of the normal equations, and ∂r/∂λₖ as
    /// rows.
    fn closest(&self, points: &[Vector3<f64>; 4]) -> (Vector2<f64>, Matrix2<f64>, Matrix2x3<f64>) {
        let vector = combine(points, &self.weights);
        let tangents = Matrix2x3::from_rows(&[
            combine(points, &self.along[0]).transpose(),
            combine(points, &self.along[1]).transpose(),
        ]);
        let inverse = pseudo_inverse(&(tangents * tangents.transpose()));
        (-(inverse * (tangents * vector)), inverse, tangents)
    }
}

fn weights(entries: &[(usize, f64)]) -> [f64; 4] {
    let mut weights = [0.0; 4];
    for &(place, weight) in entries {
        weights[place] = weight;
    }
    weights
}

/// Σ wᵢ xᵢ for weights that sum to zero, from differences of points. The result does not lose digits far
/// from the origin.
fn combine(points: &[Vector3<f64>; 4], weights: &[f64; 4]) -> Vector3<f64> {
    let origin = points[0];
    let term = |place: usize| (points[place] - origin) * weights[place];
    term(1) + term(2) + term(3)
}

/// The inverse of a Gram matrix. If the matrix is singular, the inverse of its larger diagonal entry alone.
fn pseudo_inverse(gram: &Matrix2<f64>) -> Matrix2<f64> {
    let determinant = gram.determinant();
    if determinant > f64::EPSILON * gram[(0, 0)] * gram[(1, 1)] {
        return Matrix2::new(gram[(1, 1)], -gram[(0, 1)], -gram[(1, 0)], gram[(0, 0)]) / determinant;
    }
    let larger = usize::from(gram[(1, 1)] > gram[(0, 0)]);
    let mut inverse = Matrix2::zeros();
    if gram[(larger, larger)] > 0.0 {
        inverse[(larger, larger)] = 1.0 / gram[(larger, larger)];
    }
    inverse
}
