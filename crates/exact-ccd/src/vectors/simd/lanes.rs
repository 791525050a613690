//! The filters' arithmetic on eight f64 side by side.

use fearless_simd::prelude::*;
use fearless_simd::{f64x8, mask64x8};

use crate::numbers::number::Lanes;

impl<S: Simd> Lanes for f64x8<S> {
    type Mask = mask64x8<S>;

    #[inline(always)]
    fn splat(self, value: f64) -> Self {
        <Self as SimdBase<S>>::splat(self.simd, value)
    }

    #[inline(always)]
    fn gt(self, other: Self) -> Self::Mask {
        self.simd_gt(other)
    }

    #[inline(always)]
    fn any(mask: Self::Mask) -> bool {
        mask.any_true()
    }

    #[inline(always)]
    fn abs(self) -> Self {
        <Self as SimdBase<S>>::abs(self)
    }

    #[inline(always)]
    fn sqrt(self) -> Self {
        <Self as SimdFloat<S>>::sqrt(self)
    }

    #[inline(always)]
    fn select(mask: Self::Mask, yes: Self, no: Self) -> Self {
        mask.select(yes, no)
    }

    #[inline(always)]
    fn min(self, other: Self) -> Self {
        <Self as SimdBase<S>>::min(self, other)
    }

    #[inline(always)]
    fn max(self, other: Self) -> Self {
        <Self as SimdBase<S>>::max(self, other)
    }
}
