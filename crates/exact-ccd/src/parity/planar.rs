//! A bilinear patch in a plane through the origin, or on a line through it.

use alloc::vec;

use super::corner::{Corner, Integers};
use super::ray::Passage;
use crate::exact::{Polynomial, Vector, cross, dot, roots};

/// Whether a patch, all of whose corners and the origin lie in one plane, contains the origin.
///
/// The patch is swept by a segment from P(s) on the side q₀ q₁ to Q(s) on the side q₃ q₂, both linear in s. The origin is on
/// the segment if P × Q = 0 and P · Q ≤ 0. As in [`exact`](crate::exact), that is the sign of one polynomial at the roots of
/// another: of the components of P × Q, or, if these vanish for all s, at the roots of P · Q itself, where it may change
/// its sign.
pub(super) fn contains_origin<C: Corner>(corners: [&C; 4]) -> bool {
    // Seen along an axis, the origin may plainly be outside of the corners' hull.
    if (0..3).any(|axis| Passage::new(corners, |a, b| C::turn(axis, a, b)).is_none()) {
        return false;
    }
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
    roots(vec![turn.square_free()])
        .iter()
        .any(|s| s.sign(&along).is_le())
}

fn between(start: &Integers, end: &Integers) -> Vector {
    [0, 1, 2].map(|axis: usize| Polynomial::between(&start[axis], &end[axis]))
}
