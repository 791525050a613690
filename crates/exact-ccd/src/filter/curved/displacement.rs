//! Rigid displacements that are polynomials in t, as in `exact/displacement.rs`, without integers.
//!
//! A polynomial of degree n has the coefficients of tⁱ sⁿ⁻ⁱ, s = 1 − t: products are convolutions, without
//! binomial coefficients.

use core::ops::Div;

use arrayvec::ArrayVec;

use super::polynomial::{
    Coefficient, Polynomial, bezier, difference, elevate, map, product, sum, to_bernstein,
};
use super::twice::{Twice, on_curve};

/// A quaternion, the scalar first. All components have one degree.
type Quaternion<T> = [Polynomial<T>; 4];

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

    /// The quaternion and the place at a time.
    pub(super) fn at(&self, time: [Twice; 2]) -> Turning<Twice> {
        Turning {
            quaternions: [on_curve(&self.quaternions, time)].into_iter().collect(),
            places: [on_curve(&self.places, time)].into_iter().collect(),
        }
    }
}

/// The displacement that takes v to (Q v + R) Q* / |Q|².
pub(super) struct Displacement<T> {
    turn: Quaternion<T>,
    shift: Quaternion<T>,
}

/// The place of v in a body's coordinates is (M v + c) / w. The polynomials M, c and w have one degree.
pub(super) struct Affine<T> {
    pub(super) turn: [[Polynomial<T>; 3]; 3],
    pub(super) shift: [Polynomial<T>; 3],
    pub(super) weight: Polynomial<T>,
}

impl<T: Coefficient> Displacement<T> {
    /// The displacement of a body in the coordinates of another one, if one of them has a motion.
    ///
    /// The degrees of all polynomials are below [`MOST`].
    pub(super) fn between(first: &[Turning<T>], second: &[Turning<T>]) -> Option<Self> {
        let of_chain = |chain: &[Turning<T>]| {
            let each = chain.iter().map(Self::of_turn);
            each.reduce(|all, next| all.after(&next))
        };
        match (of_chain(first), of_chain(second)) {
            (Some(first), Some(second)) => Some(second.inverse().after(&first)),
            (first, second) => first.or_else(|| second.map(Self::inverse)),
        }
    }

    fn of_turn(motion: &Turning<T>) -> Self {
        let turn = [0, 1, 2, 3].map(|i: usize| bezier(motion.quaternions.iter().map(|q| q[i]).collect()));
        let place = [0, 1, 2].map(|axis: usize| bezier(motion.places.iter().map(|p| p[axis]).collect()));
        Self {
            shift: vector_times(&place, &turn),
            turn,
        }
    }

    /// (Q₁ Q₂, Q₁ R₂ + R₁ Q₂).
    fn after(&self, other: &Self) -> Self {
        let [mut left, mut right] = [times(&self.turn, &other.shift), times(&self.shift, &other.turn)];
        let degree = left[0].len().max(right[0].len());
        for component in left.iter_mut().chain(&mut right) {
            elevate(component, degree);
        }
        Self {
            turn: times(&self.turn, &other.turn),
            shift: [0, 1, 2, 3].map(|i: usize| sum(&left[i], &right[i])),
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
    pub(super) fn affine(&self) -> Affine<T> {
        let [a, b, c, d] = &self.turn;
        let [aa, bb, cc, dd] = [a, b, c, d].map(|x| product(x, x));
        let twice = |x: &Polynomial<T>, y: &Polynomial<T>| map(&product(x, y), |x| x * 2.0);
        let [bc, ad, bd, ac, cd, ab] =
            [(b, c), (a, d), (b, d), (a, c), (c, d), (a, b)].map(|(x, y)| twice(x, y));
        let [plus, minus] = [sum(&aa, &bb), difference(&aa, &bb)];
        let [outer, inner] = [sum(&cc, &dd), difference(&cc, &dd)];
        let mut turn = [
            [difference(&plus, &outer), difference(&bc, &ad), sum(&bd, &ac)],
            [sum(&bc, &ad), sum(&minus, &inner), difference(&cd, &ab)],
            [difference(&bd, &ac), sum(&cd, &ab), difference(&minus, &inner)],
        ];
        let mut weight = sum(&plus, &outer);
        let [_, mut x, mut y, mut z] = times(&self.shift, &conjugate(self.turn.clone()));
        let count = x.len().max(weight.len());
        let all = turn
            .iter_mut()
            .flatten()
            .chain([&mut weight, &mut x, &mut y, &mut z]);
        for polynomial in all {
            elevate(polynomial, count);
        }
        Affine {
            turn,
            shift: [x, y, z],
            weight,
        }
    }
}

impl<T: Coefficient + Div<f64, Output = T>> Affine<T> {
    /// The control points of the polynomials in place of their coefficients.
    pub(super) fn into_bernstein(mut self) -> Self {
        let all = self.turn.iter_mut().flatten().chain(&mut self.shift);
        for polynomial in all.chain([&mut self.weight]) {
            to_bernstein(polynomial);
        }
        self
    }
}

fn conjugate<T: Coefficient>([a, b, c, d]: Quaternion<T>) -> Quaternion<T> {
    [a, map(&b, |x| -x), map(&c, |x| -x), map(&d, |x| -x)]
}

fn times<T: Coefficient>([a, b, c, d]: &Quaternion<T>, other: &Quaternion<T>) -> Quaternion<T> {
    let [scalar, x, y, z] = vector_times(&[b.clone(), c.clone(), d.clone()], other);
    let [e, f, g, h] = other;
    [
        sum(&product(a, e), &scalar),
        sum(&product(a, f), &x),
        sum(&product(a, g), &y),
        sum(&product(a, h), &z),
    ]
}

/// The product of a quaternion without a scalar part and another one.
fn vector_times<T: Coefficient>([b, c, d]: &[Polynomial<T>; 3], other: &Quaternion<T>) -> Quaternion<T> {
    let [e, f, g, h] = other;
    let triple = |x: [&Polynomial<T>; 2], y: [&Polynomial<T>; 2], less: [&Polynomial<T>; 2]| {
        let [x, y, less] = [x, y, less].map(|[p, q]| product(p, q));
        difference(&sum(&x, &y), &less)
    };
    let scalar = sum(&sum(&product(b, f), &product(c, g)), &product(d, h));
    [
        map(&scalar, |x| -x),
        triple([b, e], [c, h], [d, g]),
        triple([c, e], [d, f], [b, h]),
        triple([d, e], [b, g], [c, f]),
    ]
}
