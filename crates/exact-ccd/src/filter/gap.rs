//! The distance of a filter: none for contact, so that its terms cost nothing, or one above 0.

use crate::numbers::number::Lanes;

/// The distance at which primitives touch, for one query or for several side by side.
pub(crate) trait Gap<T: Lanes>: Copy {
    /// False for contact: the terms of the distance vanish.
    const IS_POSITIVE: bool;

    /// The distance, in as many lanes as another number.
    fn value(self, like: T) -> T;
}

/// Contact: the distance 0.
#[derive(Clone, Copy)]
pub(crate) struct Touching;

impl<T: Lanes> Gap<T> for Touching {
    const IS_POSITIVE: bool = false;

    #[inline(always)]
    fn value(self, like: T) -> T {
        like.splat(0.0)
    }
}

/// A distance above 0.
#[derive(Clone, Copy)]
pub(crate) struct Within<T>(pub(crate) T);

impl<T: Lanes> Gap<T> for Within<T> {
    const IS_POSITIVE: bool = true;

    #[inline(always)]
    fn value(self, _: T) -> T {
        self.0
    }
}
