//! A bilinear patch in a plane through the origin, or on a line through it.

use alloc::vec;

use super::corner::{Corner, seen_along};
use super::ray::Passage;
use crate::exact::{Polynomial, Vector, cross, dot, roots};
use crate::predicates::Integers;

/// Returns true if a patch contains the origin, given that the origin and all corners lie in one
/// plane.
///
/// If the closed curve q₀ q₁ q₂ q₃ winds around the origin an odd number of times, the patch, which
/// fills it, covers the origin. It does not if the origin is outside of the corners' hull. The
/// remaining case is that of patches that fold over.
pub(super) fn contains_origin<C: Corner>(corners: [&C; 4]) -> bool {
    let mut open = None;
    for axis in 0..3 {
        let Some(passage) = Passage::of_axis(axis, corners) else {
            return false;
        };
        if open.is_none() && passage.turns() {
            open = Some(axis);
        }
    }
    // The projection along such an axis is one-to-one on the plane. If there is none, the corners
    // lie on a line through the origin, on both sides of it.
    open.is_none_or(|axis| winds_around_origin(corners, axis) || folds_over_origin(corners))
}

/// Returns true if the closed curve through the corners, as seen along an axis, passes through the
/// origin, or winds around it an odd number of times: it crosses a ray from the origin an odd
/// number of times then.
fn winds_around_origin<C: Corner>([q0, q1, q2, q3]: [&C; 4], axis: usize) -> bool {
    let [_, up] = seen_along(axis);
    let mut is_odd = false;
    for [a, b] in [[q0, q1], [q1, q2], [q2, q3], [q3, q0]] {
        let turn = C::turn(axis, a, b);
        if turn.is_eq() && !C::are_on_one_ray(axis, a, b) {
            return true;
        }
        let (from_below, to_below) = (a.is_negative(up), b.is_negative(up));
        is_odd ^= from_below != to_below && turn.is_gt() == from_below;
    }
    is_odd
}

/// Returns true if the patch covers the origin. The patch is swept by a segment from P(s) on the
/// side q₀ q₁ to Q(s) on the side q₃ q₂, both linear in s. The origin is on the segment if P × Q =
/// 0 and P · Q ≤ 0. As in [`exact`](crate::exact), that is the sign of one polynomial at the roots
/// of another: of the components of P × Q, or, if these vanish for all s, at the roots of P · Q
/// itself, where it may change its sign.
fn folds_over_origin<C: Corner>(corners: [&C; 4]) -> bool {
    let [q0, q1, q2, q3] = C::integers(corners);
    let (p, q) = (between(&q0, &q1), between(&q3, &q2));
    let along = dot(&p, &q);
    let [x, y, z] = cross(&p, &q);
    let mut turn = x.gcd(y).gcd(z);
    if turn.is_zero() {
        turn = &along * &Polynomial::ends();
    }
    if turn.is_zero() {
        turn = Polynomial::ends();
    }
    roots(vec![turn]).iter().any(|s| s.sign(&along).is_le())
}

fn between(start: &Integers, end: &Integers) -> Vector {
    [0, 1, 2].map(|axis: usize| Polynomial::between(&start[axis], &end[axis]))
}
