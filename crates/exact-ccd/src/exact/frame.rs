//! Two rigid bodies in the coordinates of the second one.
//!
//! There, the second primitive is at rest, and a point of the first one is X / w, on a rational curve. The
//! polynomials of contact and distance are products of vectors with known positive factors |Q|², which are
//! left out by construction: the normal of a face at rest is constant, and the line of a moving edge is given by its
//! Plücker coordinates, direction and moment, both of which are w times those at rest, displaced.
//! `docs/curved-motion.md` has the degrees.

use super::displacement::Displacement;
use super::dyadic::{in_unit, unit_of};
use super::points::MovingPoints;
use super::polynomial::{Polynomial, Vector, cross};
use super::turn::Turn;
use crate::tables::{Point, Tables};

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

impl MovingPoints {
    /// The points of two bodies, each in the coordinates of its own, with the motions of both. The motions of
    /// a body apply from the last to the first, as those of a chain of joints.
    pub(crate) fn of_bodies<K: Tables>(points: &[Point; 4], chains: [&[Turn<'_>]; 2]) -> Self {
        let places = chains.iter().flat_map(|chain| chain.iter());
        let places = places.flat_map(|turn| turn.places);
        let unit = unit_of(points.iter().chain(places).flatten().copied());
        // A motion of both bodies changes nothing.
        let [first, second] = chains;
        let shared = first.iter().zip(second).take_while(|(one, other)| one == other);
        let shared = shared.count();
        let whole = Displacement::of_chain(second, unit);
        let [first, second] = chains.map(|chain| Displacement::of_chain(&chain[shared..], unit));
        let relative = first.seen_from(second);

        let local = points.map(|point| point.map(|x| Polynomial::constant(in_unit(x, unit))));
        let count = K::SPAN[0].1;
        let direction = [0, 1, 2].map(|axis: usize| &local[1][axis] - &local[0][axis]);
        let frame = Frame {
            count,
            weight: relative.weight(),
            moment: relative.moment(&cross(&local[0], &local[1]), &direction),
            second: whole,
        };
        let mut moving = local;
        for point in &mut moving[..count] {
            *point = relative.point(point);
        }
        Self::in_frame(moving, unit, frame)
    }
}

#[cfg(test)]
mod tests;
