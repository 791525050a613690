//! Two features within the activation distance of the barrier, or a vertex and a half space.

use arrayvec::ArrayVec;
use exact_ccd_mesh::Point;
use nalgebra::{SMatrix, SVector, Vector3};

use super::barrier::Barrier;
use crate::energies::distance::{
    Factors, Feature, FeatureKind, Matrix12, Mollifier, ShortestVector, Vector12,
};
use crate::energies::term::{Block, Energy, Projection, gather_some, write_blocks, write_rows};
use crate::half_space::Plane;

/// Two features within the activation distance of the barrier, or a vertex and a half space.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Collision {
    vertices: ArrayVec<u32, 4>,
    between: Between,
    mollifier: Option<Mollifier>,
    /// The barrier of both surfaces, with their thickness.
    barrier: Barrier,
    /// The sum of the weights of all terms that share these features. It can be negative.
    multiplicity: f64,
    /// The sum of their absolute values.
    total: f64,
    /// True for the vertices that never move.
    fixed: [bool; 4],
}

/// The sum of weights, relative to the sum of their absolute values, up to which it is a rounding error.
const CANCELLED: f64 = 1e-12;

/// The two sides of a collision: two features of its vertices, or its only vertex and a plane.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Between {
    Features(Feature),
    VertexAndPlane {
        plane: Plane,
        /// The number of the half space with this boundary.
        half_space: u32,
    },
}

impl Between {
    fn shortest_vector(&self, points: &[Vector3<f64>; 4]) -> ShortestVector {
        match self {
            Self::Features(feature) => feature.shortest_vector(points),
            // Rounding may put a vertex that is barely apart on the other side.
            Self::VertexAndPlane { plane, .. } => ShortestVector {
                weights: [1.0, 0.0, 0.0, 0.0],
                vector: plane.normal * plane.height(&points[0]).max(0.0),
            },
        }
    }

    fn factors(&self, points: &[Vector3<f64>; 4]) -> Factors {
        match self {
            Self::Features(feature) => feature.factors(points),
            // The squared distance is the square of one linear combination of the coordinates.
            Self::VertexAndPlane { plane, .. } => {
                let mut change = SMatrix::<f64, 12, 5>::zeros();
                change.fixed_view_mut::<3, 1>(0, 0).copy_from(&plane.normal);
                let mut first = SVector::<f64, 5>::zeros();
                first[0] = 2.0 * plane.height(&points[0]).max(0.0);
                let mut second = SMatrix::<f64, 5, 5>::zeros();
                second[(0, 0)] = 2.0;
                Factors {
                    change,
                    first,
                    second,
                }
            }
        }
    }
}

impl Collision {
    /// The collision of two features of these vertices, in canonical form. It has only the vertices on which
    /// the distance depends, in an order that does not depend on the primitives that share the features.
    /// The vertices of the first feature come first and have positive weights.
    pub(crate) fn new(vertices: [u32; 4], feature: Feature, barrier: Barrier) -> Self {
        let used = (0..4)
            .filter(|&place| feature.uses(place))
            .map(|place| vertices[place]);
        let mut vertices: ArrayVec<u32, 4> = used.collect();
        let feature = match feature.kind() {
            FeatureKind::PointPoint => {
                vertices.sort_unstable();
                Feature::point_point(0, 1)
            }
            FeatureKind::PointLine => {
                // The point is the vertex with constant weight.
                let point = feature.point();
                let place = (0..point).filter(|&place| feature.uses(place)).count();
                vertices[..=place].rotate_right(1);
                vertices[1..].sort_unstable();
                Feature::point_line(0, 1, 2)
            }
            FeatureKind::PointPlane | FeatureKind::LineLine => feature,
        };
        Self::between(vertices, Between::Features(feature), barrier)
    }

    /// The collision of a vertex and a half space, by its number.
    pub(crate) fn with_half_space(vertex: u32, half_space: u32, plane: Plane, barrier: Barrier) -> Self {
        let vertices = [vertex].into_iter().collect();
        Self::between(vertices, Between::VertexAndPlane { plane, half_space }, barrier)
    }

    /// The collision of two edges that are nearly parallel, in canonical form: the closest point of the first
    /// two vertices has the positive weights.
    pub(crate) fn mollified(
        mut vertices: [u32; 4],
        mut feature: Feature,
        mollifier: Mollifier,
        barrier: Barrier,
    ) -> Self {
        if feature.point() >= 2 {
            vertices.rotate_left(2);
            feature = feature.swapped();
        }
        Self {
            mollifier: Some(mollifier),
            ..Self::between(vertices.into(), Between::Features(feature), barrier)
        }
    }

    fn between(vertices: ArrayVec<u32, 4>, between: Between, barrier: Barrier) -> Self {
        Self {
            vertices,
            between,
            mollifier: None,
            barrier,
            multiplicity: 1.0,
            total: 1.0,
            fixed: [false; 4],
        }
    }

    /// The same collision, with second derivatives only by vertices for which `is_fixed` is false.
    ///
    /// The projection of the full Hessian would add stiffness along the plane of a triangle that does not
    /// move, and with it forces along the plane wherever Newton's method stops.
    pub(crate) fn with_fixed(mut self, is_fixed: impl Fn(u32) -> bool) -> Self {
        for (fixed, &vertex) in self.fixed.iter_mut().zip(&self.vertices) {
            *fixed = is_fixed(vertex);
        }
        self
    }

    /// The same collision with all of its terms multiplied by a weight, which may be negative.
    pub(crate) fn weighted(self, weight: f64) -> Self {
        Self {
            multiplicity: weight * self.multiplicity,
            total: weight.abs() * self.total,
            ..self
        }
    }

    /// Returns true if its terms cancel, up to rounding.
    pub(crate) fn is_cancelled(&self) -> bool {
        self.multiplicity.abs() <= CANCELLED * self.total
    }

    /// Returns true if its terms repel the features from each other, and do not correct the sum of others.
    pub(crate) fn is_repulsive(&self) -> bool {
        self.multiplicity > 0.0
    }

    /// The number of the half space, if it is with one.
    pub(crate) fn half_space(&self) -> Option<u32> {
        match self.between {
            Between::Features(_) => None,
            Between::VertexAndPlane { half_space, .. } => Some(half_space),
        }
    }

    /// Returns true if two collisions are between the same features.
    pub(crate) fn is_same(&self, other: &Self) -> bool {
        self.vertices == other.vertices
            && self.between == other.between
            && self.mollifier == other.mollifier
            && self.barrier == other.barrier
    }

    /// Adds the terms of another collision between the same features.
    pub(crate) fn merge(&mut self, other: &Self) {
        self.multiplicity += other.multiplicity;
        self.total += other.total;
    }

    /// The closest points of the features.
    pub(crate) fn shortest_vector(&self, points: &[Point]) -> ShortestVector {
        self.between.shortest_vector(&gather_some(points, &self.vertices))
    }

    /// The distance between the surfaces, in m: the distance of the features minus the thickness.
    pub(crate) fn gap(&self, points: &[Point]) -> f64 {
        self.barrier.gap(self.shortest_vector(points).squared())
    }

    /// The magnitude of the normal force for κ = 1: minus the derivative of the barrier by the distance.
    pub(crate) fn normal_force(&self, points: &[Point]) -> f64 {
        let squared = self.shortest_vector(points).squared();
        match self.fade(points) {
            0.0 => 0.0,
            fade => -2.0 * self.multiplicity * fade * self.barrier.slope(squared) * squared.sqrt(),
        }
    }

    /// The factor of the barrier, between 0 and 1. Where it is 0, value, gradient and force are 0, even if
    /// the barrier is infinite: parallel edges have no barrier.
    fn fade(&self, points: &[Point]) -> f64 {
        let corners = gather_some(points, &self.vertices);
        self.mollifier.map_or(1.0, |mollifier| mollifier.value(&corners))
    }

    /// The Hessian of a mollified barrier m b, m ∇²b + ∇m ∇bᵀ + ∇b ∇mᵀ + b ∇²m. Where m = 0, only the last
    /// term is left. It counts as zero where b is infinite.
    fn mollified_hessian(
        &self,
        mollifier: Mollifier,
        corners: &[Vector3<f64>; 4],
        [value, fade]: [f64; 2],
        gradient: &Vector12,
        hessian: &Matrix12,
    ) -> Matrix12 {
        let (fade1, fade2) = mollifier.derivatives(corners);
        if fade == 0.0 {
            return if value.is_finite() {
                fade2 * value
            } else {
                Matrix12::zeros()
            };
        }
        let mixed = fade1 * gradient.transpose();
        hessian * fade + mixed + mixed.transpose() + fade2 * value
    }
}

impl Energy for Collision {
    fn vertices(&self) -> &[u32] {
        &self.vertices
    }

    /// The value of the barrier, in m⁴.
    fn value(&self, points: &[Point]) -> f64 {
        match self.fade(points) {
            0.0 => 0.0,
            fade => self.multiplicity * fade * self.barrier.value(self.shortest_vector(points).squared()),
        }
    }

    fn write_gradient(&self, points: &[Point], gradient: &mut [f64]) {
        let fade = self.fade(points);
        if fade == 0.0 {
            return gradient.fill(0.0);
        }
        let shortest = self.shortest_vector(points);
        let squared = shortest.squared();
        let slope = 2.0 * self.barrier.slope(squared);
        let mut sum =
            Vector12::from_fn(|row, _| shortest.weights[row / 3] * shortest.vector[row % 3] * slope * fade);
        if let Some(mollifier) = self.mollifier {
            let corners = gather_some(points, &self.vertices);
            sum += mollifier.derivatives(&corners).0 * self.barrier.value(squared);
        }
        write_rows(&(sum * self.multiplicity), gradient);
    }

    /// The Hessian by the vertices that are not fixed.
    fn write_hessian(&self, points: &[Point], projection: Projection, hessian: &mut [Block]) {
        let corners = gather_some(points, &self.vertices);
        let squared = self.between.shortest_vector(&corners).squared();
        let (slope, curvature) = (self.barrier.slope(squared), self.barrier.curvature(squared));
        let Factors {
            mut change,
            first,
            second,
        } = self.between.factors(&corners);
        let gradient = change * first * slope;
        let fixed = || (0..4).filter(|&place| self.fixed[place]);
        fixed().for_each(|place| change.fixed_rows_mut::<3>(3 * place).fill(0.0));
        // The Hessian of a negative term is projected with its sign.
        let (sign, size) = (self.multiplicity.signum(), self.multiplicity.abs());
        let second = first * first.transpose() * curvature + second * slope;
        let projected = match self.mollifier {
            None => {
                // The projection acts in an orthonormal basis of the five directions of the factors.
                let (basis, factor) = change.qr().unpack();
                basis * projection.of(factor * second * factor.transpose() * sign) * basis.transpose()
            }
            Some(mollifier) => {
                let terms = [self.barrier.value(squared), mollifier.value(&corners)];
                let hessian = change * second * change.transpose();
                let mut hessian = self.mollified_hessian(mollifier, &corners, terms, &gradient, &hessian);
                for place in fixed() {
                    hessian.fixed_rows_mut::<3>(3 * place).fill(0.0);
                    hessian.fixed_columns_mut::<3>(3 * place).fill(0.0);
                }
                projection.of(hessian * sign)
            }
        };
        write_blocks(&(projected * size), self.vertices.len(), hessian);
    }
}
