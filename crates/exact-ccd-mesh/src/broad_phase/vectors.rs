//! The vector instructions for tests of blocks.

/// Evaluates an expression with the vector instructions of this processor: on x86 AVX2 or else SSE2.
///
/// The vectors of AVX2 have eight places, as blocks do, and it combines comparisons in half of the time that
/// the mask registers of AVX-512 take. SSE4.2 has nothing to add to SSE2 here. No code is compiled for them.
#[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
macro_rules! vectorized {
    ($simd:ident => $operation:expr) => {{
        let level = fearless_simd::Level::new();
        if let Some($simd) = level.as_avx2() {
            fearless_simd::Simd::vectorize(
                $simd,
                #[inline(always)]
                || $operation,
            )
        } else if let Some($simd) = level.as_sse2() {
            fearless_simd::Simd::vectorize(
                $simd,
                #[inline(always)]
                || $operation,
            )
        } else {
            unreachable!("the kernel does not compile without SSE2")
        }
    }};
}

/// Evaluates an expression with the vector instructions that the program is compiled for.
#[cfg(not(any(target_arch = "x86", target_arch = "x86_64")))]
macro_rules! vectorized {
    ($simd:ident => $operation:expr) => {
        fearless_simd::dispatch!(fearless_simd::Level::new(), $simd => $operation)
    };
}

pub(super) use vectorized;
