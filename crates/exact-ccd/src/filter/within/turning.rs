//! A direction that turns from one time to another and keeps the primitives farther than d apart.

use crate::numbers::double_double::DoubleDouble;
use crate::numbers::number::{Lanes, Number};
use crate::numbers::roundoff::{UNDERFLOW, UNIT, margin};
use crate::numbers::vector::{dot, scaled};

/// The corners of F at one time, each component the result of four roundings of terms of at most the reach,
/// and a direction: a vector of length at most 1 + 8 u.
#[derive(Clone, Copy)]
pub(super) struct Heading<T> {
    pub(super) corners: [[T; 3]; 4],
    pub(super) direction: [T; 3],
}

/// d and all errors of [`Heading::is_beyond_across`].
///
/// Let r be the sum of the reaches on the three axes. The sum gₐ · x_b + g_b · xₐ results from n = 8
/// roundings, four of them in a corner, of terms of at most 2 r (1 + 8 u), and is compared with twice the
/// limit. With corners and direction of twice the precision, rounded, at one of the times, n = 9, with the
/// same margin. d times the lengths is at most 2 d (1 + 8 u), and the limit has four more roundings: n = 12.
#[inline(always)]
pub(super) fn limit<T: Lanes>(d: T, reach: [T; 3]) -> T {
    d * (1.0 + margin(12) * UNIT) + (reach[0] + reach[1] + reach[2]) * (margin(8) * UNIT) + UNDERFLOW
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

    /// True where the distance is certainly above d at this time. The first `corners` corners are all
    /// different ones.
    #[inline(always)]
    pub(super) fn is_beyond(&self, corners: usize, limit: T) -> T::Mask {
        self.is_beyond_at(&self.corners, corners, limit)
    }

    /// The same for the corners at another time: g · x > d |g| for all of them.
    #[inline(always)]
    pub(super) fn is_beyond_at(&self, places: &[[T; 3]; 4], corners: usize, limit: T) -> T::Mask {
        let mut all = self.along_to(&places[0]).gt(limit);
        for place in &places[1..corners] {
            all = all & self.along_to(place).gt(limit);
        }
        all
    }

    /// g · x for a place of a corner.
    #[inline(always)]
    pub(super) fn along_to(&self, place: &[T; 3]) -> T {
        dot(self.direction, *place)
    }

    /// True where the distance is certainly above d at all times between this one and another one, given that
    /// it is at both.
    ///
    /// Let g change linearly from one direction to the other, and a corner x from its place at one
    /// time to its place at the other. Then g · x is quadratic, with the Bernstein coefficients gₐ · xₐ,
    /// (gₐ · x_b + g_b · xₐ) / 2 and g_b · x_b, and |g| is at most its linear interpolant, with the
    /// coefficients |gₐ|, (|gₐ| + |g_b|) / 2 and |g_b|. So g · x > d |g| at all these times if each
    /// coefficient is above d times the other: and if that is so for all corners, then it is for F.
    #[inline(always)]
    pub(super) fn is_beyond_across(&self, other: &Self, corners: usize, limit: T) -> T::Mask {
        let twice = limit + limit;
        let mut all = self.across(other, 0).gt(twice);
        for i in 1..corners {
            all = all & self.across(other, i).gt(twice);
        }
        all
    }

    /// gₐ · x_b + g_b · xₐ for a corner x.
    #[inline(always)]
    pub(super) fn across(&self, other: &Self, i: usize) -> T {
        self.along_to(&other.corners[i]) + other.along_to(&self.corners[i])
    }
}

impl Heading<f64> {
    /// The same in twice the precision, each component rounded. The direction is NaN, which proves nothing,
    /// if it may be longer than 1 + 8 u before the rounding.
    ///
    /// The square of its length is computed from rounded components, with three roundings: it differs by at
    /// most 5 u, and the length by less than 3 u. So a square of at most 1 + 8 u suffices. The two roundings,
    /// of a corner and of a direction, and the four of [`Heading::across`] make n = 6; the errors of corners
    /// in twice the precision, 8 ε, are less than another u r.
    pub(super) fn rounded(corners: &[[DoubleDouble; 3]; 4], direction: [DoubleDouble; 3]) -> Self {
        let direction = direction.map(Number::value);
        let is_short = dot(direction, direction) <= 1.0 + 8.0 * UNIT;
        Self {
            corners: corners.map(|corner| corner.map(Number::value)),
            direction: if is_short { direction } else { [f64::NAN; 3] },
        }
    }
}
