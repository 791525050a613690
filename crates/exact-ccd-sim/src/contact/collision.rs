//! Two features within the activation distance of the barrier.

use arrayvec::ArrayVec;
use nalgebra::Vector3;

use super::barrier::Barrier;
use crate::distance::{Factors, Feature, FeatureKind, Mollifier, Separation};
use crate::element::{Element, Vector12};
use crate::psd;

/// Two features within the activation distance of the barrier.
#[derive(Clone, Debug, PartialEq)]
pub struct Collision {
    vertices: ArrayVec<u32, 4>,
    feature: Feature,
    mollifier: Option<Mollifier>,
    /// ξ: the sum of the offsets of both surfaces, in m.
    thickness: f64,
    /// The number of pairs of primitives that share these features.
    multiplicity: f64,
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
            feature,
            mollifier: None,
            thickness: 0.0,
            multiplicity: 1.0,
        }
    }

    /// The same collision of surfaces with a thickness ξ, in m.
    #[must_use]
    pub fn with_thickness(self, thickness: f64) -> Self {
        Self { thickness, ..self }
    }

    /// The collision of two edges that are nearly parallel.
    #[must_use]
    pub fn mollified(vertices: [u32; 4], feature: Feature, mollifier: Mollifier) -> Self {
        Self {
            vertices: ArrayVec::from(vertices),
            feature,
            mollifier: Some(mollifier),
            thickness: 0.0,
            multiplicity: 1.0,
        }
    }

    /// The vertices on which the barrier depends.
    #[must_use]
    pub fn vertices(&self) -> &ArrayVec<u32, 4> {
        &self.vertices
    }

    /// True if two collisions are between the same features.
    #[must_use]
    pub fn is_same(&self, other: &Self) -> bool {
        self.vertices == other.vertices
            && self.feature == other.feature
            && self.mollifier == other.mollifier
            && self.thickness == other.thickness
    }

    /// Adds the pairs of primitives of another collision between the same features.
    pub fn merge(&mut self, other: &Self) {
        self.multiplicity += other.multiplicity;
    }

    /// The closest points of the features, for these positions of the vertices.
    #[must_use]
    pub fn separation(&self, points: &[Vector3<f64>; 4]) -> Separation {
        self.feature.separation(points)
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

    /// The gradient and the Hessian of the barrier. If `projected`, the Hessian is positive semi-definite.
    #[must_use]
    pub fn derivatives(&self, points: &[Vector3<f64>; 4], barrier: &Barrier, projected: bool) -> Element {
        let barrier = barrier.with_thickness(self.thickness);
        let squared = self.separation(points).squared();
        let (slope, curvature) = (barrier.slope(squared), barrier.curvature(squared));
        let Factors {
            change,
            first,
            second,
        } = self.feature.factors(points);
        let second = first * first.transpose() * curvature + second * slope;
        let mut gradient = change * first * slope;
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
            hessian = hessian * fade + mixed + mixed.transpose() + fade2 * value;
            gradient = gradient * fade + fade1 * value;
            if projected {
                hessian = psd::project(hessian);
            }
        }
        Element {
            vertices: self.vertices.clone(),
            gradient: gradient * self.multiplicity,
            hessian: hessian * self.multiplicity,
        }
    }
}
