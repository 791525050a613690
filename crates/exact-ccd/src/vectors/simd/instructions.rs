//! Sets of vector instructions.

use fearless_simd::Level;
#[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
use fearless_simd::Simd;

/// Evaluates an expression with the vector instructions of a level: on x86 AVX-512, AVX2 or else SSE2.
///
/// SSE4.2 would add a quarter to the time in which the kernel compiles. A batch on a processor without AVX2,
/// of 2008 to 2013, would take a tenth less time.
#[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
macro_rules! dispatch {
    ($level:expr, $simd:ident => $operation:expr) => {
        if let Some($simd) = $level.as_avx512() {
            fearless_simd::Simd::vectorize(
                $simd,
                #[inline(always)]
                || $operation,
            )
        } else if let Some($simd) = $level.as_avx2() {
            fearless_simd::Simd::vectorize(
                $simd,
                #[inline(always)]
                || $operation,
            )
        } else if let Some($simd) = $level.as_sse2() {
            fearless_simd::Simd::vectorize(
                $simd,
                #[inline(always)]
                || $operation,
            )
        } else {
            unreachable!("the crate does not compile without SSE2")
        }
    };
}
#[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
pub(super) use dispatch;
#[cfg(not(any(target_arch = "x86", target_arch = "x86_64")))]
pub(super) use fearless_simd::dispatch;

/// A set of vector instructions of this processor.
///
/// No answer depends on it. A choice is useful for tests and measurements only.
#[derive(Clone, Copy, Debug)]
pub struct Instructions(Level);

impl Instructions {
    /// The widest set of this processor, detected at run time on x86 with the feature `std`;
    /// otherwise, the widest set that the program is compiled for.
    #[must_use]
    pub fn best() -> Self {
        Self(Level::try_detect().unwrap_or(Level::baseline()))
    }

    /// All sets of this processor, from the narrowest to the widest.
    pub fn available() -> impl Iterator<Item = Self> {
        let Self(best) = Self::best();
        #[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
        let levels = [
            best.as_sse2().map(Simd::level),
            best.as_avx2().map(Simd::level),
            best.as_avx512().map(Simd::level),
        ];
        #[cfg(not(any(target_arch = "x86", target_arch = "x86_64")))]
        let levels = [Some(best)];
        levels.into_iter().flatten().map(Self)
    }

    pub(super) fn level(self) -> Level {
        self.0
    }
}

impl Default for Instructions {
    fn default() -> Self {
        Self::best()
    }
}
