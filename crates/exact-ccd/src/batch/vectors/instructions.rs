//! Sets of vector instructions.

use fearless_simd::Level;
#[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
use fearless_simd::Simd;

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
            best.as_sse4_2().map(Simd::level),
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
