//! Rigid displacements that are polynomials in t, as in `exact/displacement.rs`, without integers.
//!
//! A polynomial of degree n has the coefficients of tⁱ sⁿ⁻ⁱ, s = 1 − t: products are convolutions, without
//! binomial coefficients.

use core::ops::Div;

use arrayvec::ArrayVec;

use super::motion::Motion;
use super::polynomial::{Coefficient, Function, Polynomial, bezier, to_bernstein};
use super::twice::{Twice, on_curve};

/// A quaternion, the scalar first. All components have one degree.
type Quaternion<P> = [P; 4];

/// The motion of a body in a step, as in `exact/turn.rs`. A rotation that does not change has one quaternion,
/// a place at rest has one control point.
#[derive(Clone, Debug)]
pub(super) struct Turning<T> {
    pub(super) quaternions: ArrayVec<[T; 4], 2>,
    pub(super) places: ArrayVec<[T; 3], 4>,
}

impl Turning<f64> {
    /// The motion in other numbers.
    pub(super) fn map<T>(&self, number: impl Fn(f64) -> T + Copy) -> Turning<T> {
        Turning {
            quaternions: self.quaternions.iter().map(|q| q.map(number)).collect(),
            places: self.places.iter().map(|place| place.map(number)).collect(),
        }
    }
}

/// The displacement that takes v to (Q v + R) Q* / |Q|².
pub(super) struct Displacement<P> {
    turn: Quaternion<P>,
    shift: Quaternion<P>,
}

impl<T: Coefficient> Displacement<Polynomial<T>> {
    /// The displacement of a motion in the step.
    pub(super) fn of_turn(motion: &Turning<T>) -> Self {
        let turn = [0, 1, 2, 3].map(|i: usize| bezier(motion.quaternions.iter().map(|q| q[i]).collect()));
        let place = [0, 1, 2].map(|axis: usize| bezier(motion.places.iter().map(|p| p[axis]).collect()));
        Self::of(place, turn)
    }
}

impl Displacement<Twice> {
    /// The displacement of a motion at a time.
    pub(super) fn at(motion: &Turning<f64>, time: [Twice; 2]) -> Self {
        Self::of(
            on_curve(&motion.places, time),
            on_curve(&motion.quaternions, time),
        )
    }
}

impl<P: Function> Displacement<P> {
    /// The displacement of a body in the coordinates of another one, if one of them has a motion.
    ///
    /// The degrees of all polynomials are below [`MOST`](super::polynomial::MOST).
    pub(super) fn between(
        first: impl Iterator<Item = Self>,
        second: impl Iterator<Item = Self>,
    ) -> Option<Self> {
        let first = first.reduce(|all, next| all.after(&next));
        match (first, second.reduce(|all, next| all.after(&next))) {
            (Some(first), Some(second)) => Some(second.inverse().after(&first)),
            (first, second) => first.or_else(|| second.map(Self::inverse)),
        }
    }

    fn of(place: [P; 3], turn: Quaternion<P>) -> Self {
        Self {
            shift: vector_times(&place, &turn),
            turn,
        }
    }

    /// (Q₁ Q₂, Q₁ R₂ + R₁ Q₂).
    fn after(&self, other: &Self) -> Self {
        let [mut left, mut right] = [times(&self.turn, &other.shift), times(&self.shift, &other.turn)];
        let count = left[0].count().max(right[0].count());
        for component in left.iter_mut().chain(&mut right) {
            component.elevate(count);
        }
        Self {
            turn: times(&self.turn, &other.turn),
            shift: [0, 1, 2, 3].map(|i: usize| left[i].sum(&right[i])),
        }
    }

    /// (Q*, R*).
    fn inverse(self) -> Self {
        Self {
            turn: conjugate(self.turn),
            shift: conjugate(self.shift),
        }
    }

    /// M, c and w: M v and c are the vectors of Q v Q* and R Q*, and w = |Q|².
    pub(super) fn motion(&self) -> Motion<P> {
        let [a, b, c, d] = &self.turn;
        let [aa, bb, cc, dd] = [a, b, c, d].map(|x| x.product(x));
        let [bc, ad, bd, ac, cd, ab] =
            [(b, c), (a, d), (b, d), (a, c), (c, d), (a, b)].map(|(x, y)| x.product(y).doubled());
        let [plus, minus] = [aa.sum(&bb), aa.difference(&bb)];
        let [outer, inner] = [cc.sum(&dd), cc.difference(&dd)];
        let mut turn = [
            [plus.difference(&outer), bc.difference(&ad), bd.sum(&ac)],
            [bc.sum(&ad), minus.sum(&inner), cd.difference(&ab)],
            [bd.difference(&ac), cd.sum(&ab), minus.difference(&inner)],
        ];
        let mut weight = plus.sum(&outer);
        let [_, mut x, mut y, mut z] = times(&self.shift, &conjugate(self.turn.clone()));
        let count = x.count().max(weight.count());
        let all = turn.iter_mut().flatten();
        for function in all.chain([&mut weight, &mut x, &mut y, &mut z]) {
            function.elevate(count);
        }
        Motion {
            turn,
            shift: [x, y, z],
            weight,
        }
    }
}

impl<T: Coefficient + Div<f64, Output = T>> Motion<Polynomial<T>> {
    /// The control points of the polynomials in place of their coefficients.
    pub(super) fn into_bernstein(mut self) -> Self {
        let all = self.turn.iter_mut().flatten().chain(&mut self.shift);
        for polynomial in all.chain([&mut self.weight]) {
            to_bernstein(polynomial);
        }
        self
    }
}

fn conjugate<P: Function>([a, b, c, d]: Quaternion<P>) -> Quaternion<P> {
    [a, b.negated(), c.negated(), d.negated()]
}

fn times<P: Function>([a, b, c, d]: &Quaternion<P>, other: &Quaternion<P>) -> Quaternion<P> {
    let [scalar, x, y, z] = vector_times(&[b.clone(), c.clone(), d.clone()], other);
    let [e, f, g, h] = other;
    [
        a.product(e).sum(&scalar),
        a.product(f).sum(&x),
        a.product(g).sum(&y),
        a.product(h).sum(&z),
    ]
}

/// The product of a quaternion without a scalar part and another one.
fn vector_times<P: Function>([b, c, d]: &[P; 3], other: &Quaternion<P>) -> Quaternion<P> {
    let [e, f, g, h] = other;
    let triple = |x: [&P; 2], y: [&P; 2], less: [&P; 2]| {
        let [x, y, less] = [x, y, less].map(|[p, q]| p.product(q));
        x.sum(&y).difference(&less)
    };
    let scalar = b.product(f).sum(&c.product(g)).sum(&d.product(h));
    [
        scalar.negated(),
        triple([b, e], [c, h], [d, g]),
        triple([c, e], [d, f], [b, h]),
        triple([d, e], [b, g], [c, f]),
    ]
}
