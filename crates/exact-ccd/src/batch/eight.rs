//! Eight f64 side by side.

use fearless_simd::prelude::*;
use fearless_simd::{f64x8, mask64x8};

use crate::filter::Lanes;

impl<S: Simd> Lanes for f64x8<S> {
    type Mask = mask64x8<S>;

    #[inline(always)]
    fn splat(self, value: f64) -> Self {
        <Self as SimdBase<S>>::splat(self.simd, value)
    }

    #[inline(always)]
    fn exceeds(self, other: Self) -> Self::Mask {
        self.simd_gt(other)
    }

    #[inline(always)]
    fn magnitude(self) -> Self {
        self.abs()
    }

    #[inline(always)]
    fn lesser(self, other: Self) -> Self {
        self.min(other)
    }

    #[inline(always)]
    fn greater(self, other: Self) -> Self {
        self.max(other)
    }
}
