//! Quaternions whose components are polynomials.

use core::ops::Mul;

use dashu_int::IBig;

use super::polynomial::{Polynomial, Vector};

/// A quaternion, the scalar first. All components have one degree.
#[derive(Clone, Debug)]
pub(super) struct Quaternion([Polynomial; 4]);

impl Quaternion {
    pub(super) fn new(components: [Polynomial; 4]) -> Self {
        Self(components)
    }

    /// The quaternion 1.
    pub(super) fn one() -> Self {
        Self([1, 0, 0, 0].map(|x: i32| Polynomial::constant(x.into())))
    }

    /// A vector as a quaternion without a scalar part.
    pub(super) fn pure(vector: &Vector) -> Self {
        let [x, y, z] = vector.clone();
        let zero = Polynomial::constant(IBig::ZERO).elevated(x.degree());
        Self([zero, x, y, z])
    }

    pub(super) fn degree(&self) -> usize {
        self.0[0].degree()
    }

    pub(super) fn conjugate(self) -> Self {
        let [w, x, y, z] = self.0;
        Self([w, -x, -y, -z])
    }

    /// The sum of two quaternions, in the higher one of both degrees.
    pub(super) fn plus(self, other: Self) -> Self {
        let degree = self.degree().max(other.degree());
        let [a, b] = [self, other].map(|quaternion| quaternion.elevated_to(degree));
        Self([0, 1, 2, 3].map(|i: usize| &a.0[i] + &b.0[i]))
    }

    fn elevated_to(self, degree: usize) -> Self {
        let by = degree.saturating_sub(self.degree());
        Self(self.0.map(|component| component.elevated(by)))
    }

    /// The same quaternion in the next lower degree, if it has one.
    pub(super) fn lowered(&self) -> Option<Self> {
        let [w, x, y, z] = [0, 1, 2, 3].map(|i: usize| self.0[i].lowered());
        Some(Self([w?, x?, y?, z?]))
    }

    /// The square of the length.
    pub(super) fn squared_length(&self) -> Polynomial {
        let [w, x, y, z] = [0, 1, 2, 3].map(|i: usize| self.0[i].squared());
        &(&(&w + &x) + &y) + &z
    }

    /// The vector of the product with the conjugate of another one. Its scalar is not computed.
    pub(super) fn vector_with_conjugate(&self, other: &Self) -> Vector {
        let ([a, b, c, d], [e, f, g, h]) = (&self.0, &other.0);
        let sum = |[p, q]: [Polynomial; 2], [r, s]: [Polynomial; 2]| &(&p + &q) - &(&r + &s);
        [
            sum([b * e, d * g], [a * f, c * h]),
            sum([b * h, c * e], [a * g, d * f]),
            sum([c * f, d * e], [a * h, b * g]),
        ]
    }
}

impl Mul for &Quaternion {
    type Output = Quaternion;

    fn mul(self, other: &Quaternion) -> Quaternion {
        let ([a, b, c, d], [e, f, g, h]) = (&self.0, &other.0);
        let sum = |[p, q, r, s]: [Polynomial; 4]| &(&(&p + &q) + &r) + &s;
        Quaternion([
            sum([a * e, -(b * f), -(c * g), -(d * h)]),
            sum([a * f, b * e, c * h, -(d * g)]),
            sum([a * g, -(b * h), c * e, d * f]),
            sum([a * h, b * g, -(c * f), d * e]),
        ])
    }
}
