//! A direction that turns from one time to another and keeps the primitives farther than d apart.

use crate::filter::number::Lanes;
use crate::filter::roundoff::{UNDERFLOW, UNIT};
use crate::filter::vector::{dot, scaled, select};
use crate::kind::Kind;

/// The corners of F at one time, each component off by at most 5 u times the reach on its axis, and a
/// direction: a vector of length at most 1 + 8 u.
#[derive(Clone, Copy)]
pub(super) struct Heading<T> {
    corners: [[T; 3]; 4],
    direction: [T; 3],
}

/// d and all errors of [`Heading::are_beyond_until`].
///
/// Let r be the sum of the reaches on the three axes. The sum gₐ · x_b + g_b · xₐ results from nine
/// roundings, five of them those of a corner, of terms of at most 2 r (1 + 8 u): it is off by less than
/// 32 u r, and compared with twice the limit. d times the lengths is at most 2 d (1 + 8 u).
#[inline(always)]
pub(super) fn limit<T: Lanes>(d: T, reach: [T; 3]) -> T {
    d * (1.0 + 16.0 * UNIT) + (reach[0] + reach[1] + reach[2]) * (32.0 * UNIT) + UNDERFLOW
}

impl<T: Lanes> Heading<T> {
    /// The direction of any vector. It is zero, which proves nothing, for one that is so short that its
    /// square may underflow.
    ///
    /// The square, its root, the quotient and the product have less than eight roundings.
    #[inline(always)]
    pub(super) fn new(corners: [[T; 3]; 4], across: [T; 3]) -> Self {
        let square = dot(across, across);
        let is_long = square.gt(square.splat(UNDERFLOW));
        let scale = T::select(is_long, square.splat(1.0) / square.sqrt(), square.splat(0.0));
        Self {
            corners,
            direction: scaled(across, scale),
        }
    }

    /// One heading in the lanes of a mask, another one elsewhere.
    #[inline(always)]
    pub(super) fn select(mask: T::Mask, yes: &Self, no: &Self) -> Self {
        let mut chosen = *no;
        for (corner, yes) in chosen.corners.iter_mut().zip(&yes.corners) {
            *corner = select(mask, *yes, *corner);
        }
        chosen.direction = select(mask, yes.direction, no.direction);
        chosen
    }

    /// True where the distance is certainly above d at this time, at another one, and at all times
    /// between.
    ///
    /// Let g change linearly from one direction to the other, and a corner x from its place at one
    /// time to that at the other. Then g · x is quadratic, with the Bernstein coefficients gₐ · xₐ,
    /// (gₐ · x_b + g_b · xₐ) / 2 and g_b · x_b, and |g| is at most its linear interpolant, with the
    /// coefficients |gₐ|, (|gₐ| + |g_b|) / 2 and |g_b|. So g · x > d |g| at all these times if each
    /// coefficient is above d times the other: and if that is so for all corners, then it is for F.
    #[inline(always)]
    pub(super) fn are_beyond_until<K: Kind>(&self, later: &Self, limit: T) -> T::Mask {
        let mut all = self.corner_is_beyond(later, 0, limit);
        for i in 1..K::FEATURES.vertices.len() {
            all = all & self.corner_is_beyond(later, i, limit);
        }
        all
    }

    #[inline(always)]
    fn corner_is_beyond(&self, later: &Self, i: usize, limit: T) -> T::Mask {
        let (a, b) = (self.corners[i], later.corners[i]);
        let across = dot(self.direction, b) + dot(later.direction, a);
        dot(self.direction, a).gt(limit) & dot(later.direction, b).gt(limit) & across.gt(limit + limit)
    }
}
