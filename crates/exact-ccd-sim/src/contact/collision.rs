//! Two features within the activation distance of the barrier, or a vertex and a half space.

use arrayvec::ArrayVec;
use nalgebra::{SMatrix, SVector, Vector3};

use super::barrier::Barrier;
use crate::distance::{Factors, Feature, FeatureKind, Mollifier, Separation};
use crate::element::{Element, Vector12};
use crate::half_space::Plane;
use crate::psd;

/// Two features within the activation distance of the barrier, or a vertex and a half space.
#[derive(Clone, Debug, PartialEq)]
pub struct Collision {
    vertices: ArrayVec<u32, 4>,
    between: Between,
    mollifier: Option<Mollifier>,
    /// ξ: the sum of the offsets of both surfaces, in m.
    thickness: f64,
    /// The sum of the weights of all terms that share these features. It can be negative.
    multiplicity: f64,
    /// The sum of their absolute values.
    total: f64,
    /// True for the vertices that never move.
    fixed: [bool; 4],
}

/// The sum of weights, relative to that of their absolute values, up to which it is a rounding error.
const CANCELLED: f64 = 1e-12;

/// That between which a collision is: two features of its vertices, or its only vertex and a plane.
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
    fn separation(&self, points: &[Vector3<f64>; 4]) -> Separation {
        match self {
            Self::Features(feature) => feature.separation(points),
            // Rounding may put a vertex that is barely apart on the other side.
            Self::VertexAndPlane { plane, .. } => Separation {
                weights: [1.0, 0.0, 0.0, 0.0],
                vector: plane.normal * plane.height(&points[0]).max(0.0),
            },
        }
    }

    fn factors(&self, points: &[Vector3<f64>; 4]) -> Factors {
        match self {
            Self::Features(feature) => feature.factors(points),
            // The squared distance is that of one linear combination of the coordinates.
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
    #[must_use]
    pub fn new(vertices: [u32; 4], feature: Feature) -> Self {
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
        Self {
            vertices,
            between: Between::Features(feature),
            mollifier: None,
            thickness: 0.0,
            multiplicity: 1.0,
            total: 1.0,
            fixed: [false; 4],
        }
    }

    /// The collision of a vertex and a half space, by its number.
    #[must_use]
    pub fn with_half_space(vertex: u32, half_space: u32, plane: Plane) -> Self {
        Self {
            vertices: [vertex].into_iter().collect(),
            between: Between::VertexAndPlane { plane, half_space },
            mollifier: None,
            thickness: 0.0,
            multiplicity: 1.0,
            total: 1.0,
            fixed: [false; 4],
        }
    }

    /// The same collision of surfaces with a thickness ξ, in m.
    #[must_use]
    pub fn with_thickness(self, thickness: f64) -> Self {
        Self { thickness, ..self }
    }

    /// The same collision with second derivatives by those vertices only for which `is_fixed` is false.
    ///
    /// The projection of the full Hessian would add stiffness along the plane of a triangle that does not
    /// move, and with it forces along the plane wherever Newton's method stops.
    #[must_use]
    pub fn with_fixed(mut self, is_fixed: impl Fn(u32) -> bool) -> Self {
        for (fixed, &vertex) in self.fixed.iter_mut().zip(&self.vertices) {
            *fixed = is_fixed(vertex);
        }
        self
    }

    /// The same collision with all of its terms multiplied by a weight, which may be negative.
    #[must_use]
    pub fn weighted(self, weight: f64) -> Self {
        Self {
            multiplicity: weight * self.multiplicity,
            total: weight.abs() * self.total,
            ..self
        }
    }

    /// True if its terms cancel, up to rounding.
    #[must_use]
    pub fn is_cancelled(&self) -> bool {
        self.multiplicity.abs() <= CANCELLED * self.total
    }

    /// True if its terms repel the features from each other, and do not correct the sum of others.
    #[must_use]
    pub fn is_repulsive(&self) -> bool {
        self.multiplicity > 0.0
    }

    /// The collision of two edges that are nearly parallel.
    #[must_use]
    pub fn mollified(vertices: [u32; 4], feature: Feature, mollifier: Mollifier) -> Self {
        Self {
            vertices: ArrayVec::from(vertices),
            between: Between::Features(feature),
            mollifier: Some(mollifier),
            thickness: 0.0,
            multiplicity: 1.0,
            total: 1.0,
            fixed: [false; 4],
        }
    }

    /// The vertices on which the barrier depends.
    #[must_use]
    pub fn vertices(&self) -> &ArrayVec<u32, 4> {
        &self.vertices
    }

    /// The number of the half space, if it is with one.
    #[must_use]
    pub fn half_space(&self) -> Option<u32> {
        match self.between {
            Between::Features(_) => None,
            Between::VertexAndPlane { half_space, .. } => Some(half_space),
        }
    }

    /// True if two collisions are between the same features.
    #[must_use]
    pub fn is_same(&self, other: &Self) -> bool {
        self.vertices == other.vertices
            && self.between == other.between
            && self.mollifier == other.mollifier
            && self.thickness == other.thickness
    }

    /// Adds the terms of another collision between the same features.
    pub fn merge(&mut self, other: &Self) {
        self.multiplicity += other.multiplicity;
        self.total += other.total;
    }

    /// The closest points of the features, for these positions of the vertices.
    #[must_use]
    pub fn separation(&self, points: &[Vector3<f64>; 4]) -> Separation {
        self.between.separation(points)
    }

    /// The distance between the surfaces, in m: that of the features minus the thickness.
    #[must_use]
    pub fn gap(&self, points: &[Vector3<f64>; 4], barrier: &Barrier) -> f64 {
        let barrier = barrier.with_thickness(self.thickness);
        barrier.gap(self.separation(points).squared())
    }

    /// The value of the barrier, in m⁴. `barrier` is that of surfaces without thickness, here and below.
    #[must_use]
    pub fn value(&self, points: &[Vector3<f64>; 4], barrier: &Barrier) -> f64 {
        let barrier = barrier.with_thickness(self.thickness);
        let fade = self.mollifier.map_or(1.0, |mollifier| mollifier.value(points));
        let value = barrier.value(self.separation(points).squared());
        // Parallel edges have no barrier, even if they touch: this avoids 0 · ∞.
        if fade == 0.0 {
            0.0
        } else {
            self.multiplicity * fade * value
        }
    }

    /// The magnitude of the normal force for κ = 1: minus the derivative of the barrier by the distance.
    #[must_use]
    pub fn normal_force(&self, points: &[Vector3<f64>; 4], barrier: &Barrier) -> f64 {
        let barrier = barrier.with_thickness(self.thickness);
        let fade = self.mollifier.map_or(1.0, |mollifier| mollifier.value(points));
        let squared = self.separation(points).squared();
        -2.0 * self.multiplicity * fade * barrier.slope(squared) * squared.sqrt()
    }

    /// The gradient of the barrier.
    #[must_use]
    pub fn gradient(&self, points: &[Vector3<f64>; 4], barrier: &Barrier) -> Vector12 {
        let barrier = barrier.with_thickness(self.thickness);
        let separation = self.separation(points);
        let squared = separation.squared();
        let distance = Vector12::from_fn(|row, _| {
            2.0 * separation.weights[row / 3] * separation.vector[row % 3] * barrier.slope(squared)
        });
        let gradient = match self.mollifier {
            None => distance,
            Some(mollifier) => {
                let (fade, _) = mollifier.derivatives(points);
                distance * mollifier.value(points) + fade * barrier.value(squared)
            }
        };
        gradient * self.multiplicity
    }

    /// The gradient of the barrier, and its Hessian by the vertices that are not fixed. If `projected`, the
    /// Hessian is positive semi-definite.
    #[must_use]
    pub fn derivatives(&self, points: &[Vector3<f64>; 4], barrier: &Barrier, projected: bool) -> Element {
        let barrier = barrier.with_thickness(self.thickness);
        let squared = self.separation(points).squared();
        let (slope, curvature) = (barrier.slope(squared), barrier.curvature(squared));
        let Factors {
            mut change,
            first,
            second,
        } = self.between.factors(points);
        let mut gradient = change * first * slope;
        let fixed = || (0..4).filter(|&place| self.fixed[place]);
        fixed().for_each(|place| change.fixed_rows_mut::<3>(3 * place).fill(0.0));
        // The Hessian of a negative term is projected with its sign.
        let (sign, size) = (self.multiplicity.signum(), self.multiplicity.abs());
        let second = (first * first.transpose() * curvature + second * slope) * sign;
        let mut hessian = if projected && self.mollifier.is_none() {
            // The projection acts in an orthonormal basis of the five directions of the factors.
            let (basis, factor) = change.qr().unpack();
            basis * psd::project(factor * second * factor.transpose()) * basis.transpose()
        } else {
            change * second * change.transpose()
        };
        if let Some(mollifier) = self.mollifier {
            let (fade, value) = (mollifier.value(points), barrier.value(squared));
            let (fade1, fade2) = mollifier.derivatives(points);
            let mixed = fade1 * gradient.transpose();
            hessian = hessian * fade + (mixed + mixed.transpose() + fade2 * value) * sign;
            gradient = gradient * fade + fade1 * value;
            for place in fixed() {
                hessian.fixed_rows_mut::<3>(3 * place).fill(0.0);
                hessian.fixed_columns_mut::<3>(3 * place).fill(0.0);
            }
            if projected {
                hessian = psd::project(hessian);
            }
        }
        Element {
            vertices: self.vertices.clone(),
            gradient: gradient * self.multiplicity,
            hessian: hessian * size,
        }
    }
}
