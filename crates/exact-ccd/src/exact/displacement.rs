//! Rigid displacements that are polynomials in t, and their products.

use dashu_int::IBig;

use super::dyadic::in_unit;
use super::polynomial::{Polynomial, Vector};
use super::quaternion::Quaternion;
use super::turn::{Turn, are_parallel, in_integers};

/// A rotation and a translation, which take the point v to o + Q v Q* / |Q|², with R = o Q in place of the
/// translation o. All are polynomials: o Q* / |Q|² is not.
///
/// If Q is a product of m linear quaternions and o has degree p, R has degree m + p.
#[derive(Clone, Debug)]
pub(super) struct Displacement {
    turn: Quaternion,
    shift: Quaternion,
}

impl Displacement {
    /// A body at rest in the coordinates of the world.
    fn identity() -> Self {
        let turn = Quaternion::one();
        let zero = Polynomial::constant(IBig::ZERO);
        Self {
            shift: Quaternion::new([0; 4].map(|_: i32| zero.clone())),
            turn,
        }
    }

    /// The product of the motions of a chain, which apply from the last to the first.
    pub(super) fn of_chain(chain: &[Turn<'_>], unit: Option<i32>) -> Self {
        let each = chain.iter().map(|turn| Self::of_turn(turn, unit));
        each.reduce(|all, next| all.after(&next))
            .unwrap_or_else(Self::identity)
    }

    /// Quaternions of any length are the same rotations: their unit does not matter. A constant rotation and
    /// a place at rest have degree 0.
    fn of_turn(turn: &Turn<'_>, unit: Option<i32>) -> Self {
        let quaternions = in_integers(turn.quaternions);
        let is_constant = are_parallel(&quaternions);
        let [start, end] = quaternions;
        let components = [0, 1, 2, 3].map(|i: usize| {
            if is_constant {
                Polynomial::constant(start[i].clone())
            } else {
                Polynomial::between(&start[i], &end[i])
            }
        });
        let rotation = Quaternion::new(components);
        let place = [0, 1, 2].map(|axis: usize| {
            let coordinates = turn.places.iter().map(|place| in_unit(place[axis], unit));
            Polynomial::bezier(coordinates.collect())
        });
        let mut place = Quaternion::pure(&place);
        while let Some(lowered) = place.lowered() {
            place = lowered;
        }
        Self {
            shift: &place * &rotation,
            turn: rotation,
        }
    }

    /// The product: another displacement, then this one: Q = Q₁ Q₂, and
    /// R Q* = Q₁ R₂ Q₂* Q₁* + R₁ Q₁* |Q₂|² = (Q₁ R₂ + R₁ Q₂) Q*.
    fn after(&self, other: &Self) -> Self {
        Self {
            turn: &self.turn * &other.turn,
            shift: (&self.turn * &other.shift).plus(&self.shift * &other.turn),
        }
    }

    /// The inverse takes v to Q* (v − o) Q / |Q|², and −Q* o = (o Q)*, as o* = −o.
    fn inverse(self) -> Self {
        Self {
            turn: self.turn.conjugate(),
            shift: self.shift.conjugate(),
        }
    }

    /// The displacement of a body in the coordinates of another one.
    ///
    /// For bodies with R = o Q each, Q = Q_B* Q_A and R = Q_B* (o_A − o_B) Q_A: the factor |Q_B|² of a
    /// product of matrices does not occur. R has a lower degree where both translations have parts in common.
    pub(super) fn seen_from(&self, other: Self) -> Self {
        let mut relative = other.inverse().after(self);
        while relative.shift.degree() > relative.turn.degree()
            && let Some(lowered) = relative.shift.lowered()
        {
            relative.shift = lowered;
        }
        relative
    }

    /// The rotation of a vector, times |Q|².
    pub(super) fn turned(&self, vector: &Vector) -> Vector {
        let product = &self.turn * &Quaternion::pure(vector);
        product.vector_with_conjugate(&self.turn)
    }

    /// w = |Q|², in the degree of the points.
    pub(super) fn weight(&self) -> Polynomial {
        let weight = self.turn.squared_length();
        weight.elevated(self.shift.degree() - self.turn.degree())
    }

    /// The place of a point times w: the vector of (Q v + R) Q*.
    pub(super) fn point(&self, place: &Vector) -> Vector {
        let turned = &self.turn * &Quaternion::pure(place);
        let sum = turned.plus(self.shift.clone());
        sum.vector_with_conjugate(&self.turn)
    }

    /// The moment a × b of the line through two points, times w, given their moment μ and difference d in the
    /// body: the vector of (Q μ + R d) Q*.
    ///
    /// The direction becomes D = Q d Q* / w, and the moment, as for any line, Q μ Q* / w + o × D. Times w,
    /// the last term is (o Q d Q* − Q d Q* o) / 2. The first product is r = R d Q*. The second one is its
    /// conjugate: r* = Q d* R* = −Q d (o Q)* = Q d Q* o. So the term is (r − r*) / 2, the vector of r.
    pub(super) fn moment(&self, moment: &Vector, direction: &Vector) -> Vector {
        let turned = &self.turn * &Quaternion::pure(moment);
        let sum = turned.plus(&self.shift * &Quaternion::pure(direction));
        sum.vector_with_conjugate(&self.turn)
    }
}
