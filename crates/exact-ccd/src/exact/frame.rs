//! Two rigid bodies in the coordinates of the second one.
//!
//! There, the second primitive is at rest, and a point of the first one is X / w, on a rational curve. The
//! polynomials of contact and distance are products of vectors with known positive factors |Q|², which are
//! left out by construction: the normal of a face at rest is constant, and the line of a moving edge is given
//! by its Plücker coordinates, direction and moment, both of which are w times those at rest, displaced.
//! `docs/curved-motion.md` has the degrees.

use super::displacement::Displacement;
use super::polynomial::{Polynomial, Vector};

/// The weight of the points of the first body in the coordinates of the second one.
#[derive(Clone, Debug)]
pub(crate) struct Frame {
    /// The number of the four points that belong to the first body.
    count: usize,
    /// w, in the degree of the points.
    weight: Polynomial,
    /// x₀ × x₁, times w. It is used where both are of the first body.
    pub(super) moment: Vector,
    /// The motion of the second body.
    second: Displacement,
}

impl Frame {
    /// The frame of a displacement of the first body relative to the second one, given the moment and the
    /// direction of the line through x₀ and x₁, and the motion of the second body.
    pub(super) fn new(
        count: usize,
        relative: &Displacement,
        [moment, direction]: [&Vector; 2],
        second: Displacement,
    ) -> Self {
        Self {
            count,
            weight: relative.weight(),
            moment: relative.moment(moment, direction),
            second,
        }
    }

    pub(super) fn is_of_first(&self, point: usize) -> bool {
        point < self.count
    }

    /// A vector times w.
    pub(super) fn weighted(&self, vector: &Vector) -> Vector {
        [0, 1, 2].map(|axis: usize| &self.weight * &vector[axis])
    }

    pub(super) fn weight(&self) -> &Polynomial {
        &self.weight
    }

    /// A vector in the coordinates of the world, times a positive factor.
    pub(super) fn to_world(&self, vector: &Vector) -> Vector {
        self.second.turned(vector)
    }

    /// The same for coordinates times 2ᵏ: a moment is a product of two.
    pub(super) fn scaled_by(&self, exponent: usize) -> Self {
        Self {
            moment: [0, 1, 2].map(|axis: usize| self.moment[axis].shifted(2 * exponent)),
            ..self.clone()
        }
    }
}
