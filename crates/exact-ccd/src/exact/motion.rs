//! The four moving points of a query in integers, and the predicates of contact at an instant.

use alloc::vec;
use alloc::vec::Vec;
use core::cmp::Ordering;
use core::marker::PhantomData;

use super::instant::Instant;
use super::narrowing::Narrowing;
use super::points::MovingPoints;
use super::polynomial::{Polynomial, Vector, dot};
use crate::tables::{Side, Tables};

/// The points of a query, and the normal of their plane when they are coplanar.
#[derive(Clone, Debug)]
pub(crate) struct Motion<K> {
    pub(super) points: MovingPoints,
    /// w · (e₁ × e₂), times a positive weight: it vanishes when the four points are coplanar.
    pub(super) volume: Polynomial,
    /// e₁ × e₂, times the same weight.
    pub(super) normal: Vector,
    kind: PhantomData<K>,
}

impl<K: Tables> Motion<K> {
    pub(crate) fn new(points: MovingPoints) -> Self {
        let (volume, normal) = points.plane::<K>();
        Self {
            volume,
            points,
            normal,
            kind: PhantomData,
        }
    }

    /// Returns true if the primitives touch at an instant at which the four points are coplanar.
    pub(crate) fn touches(&self, instant: &Instant) -> bool {
        let instant = &Narrowing::new(instant.clone());
        let Some((axis, facing)) = self.facing(instant) else {
            // Parallel edges touch if and only if an end of one lies on the other. A flat face is
            // the union of its edges.
            return K::SIDES.iter().any(|side| self.lies_on(side, instant));
        };
        K::SIDES.iter().all(|side| {
            let sign = instant.sign(&self.side(side, axis));
            sign.is_eq() || sign == if side.along { facing } else { facing.reverse() }
        })
    }

    /// A component of the normal that is not zero at an instant, and its sign; `None` if the normal
    /// vanishes.
    pub(super) fn facing(&self, instant: &Narrowing) -> Option<(usize, Ordering)> {
        (0..3)
            .map(|axis| (axis, instant.sign(&self.normal[axis])))
            .find(|(_, sign)| sign.is_ne())
    }

    /// Polynomials, not zero, among whose roots are all times at which contact begins or ends. The
    /// four points are coplanar at every root.
    ///
    /// The primitives meet only while they are coplanar. If they always are, then contact begins or
    /// ends with the step, or with a vertex on an edge: a vertex inside the face, or edges that
    /// cross inside each other, stay so for a while. So does a vertex inside an edge whose line it
    /// never leaves; it can only enter or leave over an end.
    pub(crate) fn events(&self) -> Vec<Polynomial> {
        if !self.is_always_coplanar() {
            return vec![self.volume.clone()];
        }
        let mut events = vec![Polynomial::ends()];
        for side in K::SIDES {
            let on_line = common(self.points.areas(side));
            if on_line.is_zero() {
                let at_ends = self.points.seen_from_vertex(side).map(common);
                events.extend(at_ends.into_iter().filter(|p| !p.is_zero()));
            } else {
                events.push(on_line);
            }
        }
        events
    }

    /// Returns true if the four points are coplanar at all times.
    pub(crate) fn is_always_coplanar(&self) -> bool {
        self.volume.is_zero()
    }

    /// One component of (x − q) × (y − q) for a vertex q and an edge from x to y, times a positive weight.
    pub(super) fn side(&self, side: &Side, axis: usize) -> Polynomial {
        let seen = self.points.seen_from_vertex(side);
        self.points.area(side, &seen, axis)
    }

    /// Returns true if a vertex lies on an edge: on its line and between its ends.
    pub(super) fn lies_on(&self, side: &Side, instant: &Narrowing) -> bool {
        let seen = self.points.seen_from_vertex(side);
        (0..3).all(|axis| instant.sign(&self.points.area(side, &seen, axis)).is_eq())
            && instant.sign(&dot(&seen[0], &seen[1])).is_le()
    }
}

/// A polynomial whose roots are the common roots of all components; zero if these are all zero.
pub(super) fn common([x, y, z]: Vector) -> Polynomial {
    x.gcd(y).gcd(z)
}
