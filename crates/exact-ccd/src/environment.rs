//! The floating-point environment.
//!
//! The error bounds of the filters assume gradual underflow, as in IEEE 754. Processors can be
//! switched, thread by thread, to replace subnormal results by zero (FTZ) and to read subnormal
//! operands as zero (DAZ); a program linked with `-ffast-math` does so at its start. Then the
//! filters are skipped. The exact path converts f64 to integers by their bit patterns, and does not
//! depend on the environment.

use core::hint::black_box;

/// Returns true if subnormal results become zero, or subnormal operands are read as zero, in this
/// thread.
///
/// The operations are a comparison and a subtraction, because many processors take a hundred cycles
/// or more for a multiplication with subnormal numbers.
#[inline]
pub(crate) fn flushes_subnormals() -> bool {
    let reads_as_zero = black_box(f64::from_bits(1)) <= 0.0;
    // 1.5 · 2⁻¹⁰²² − 2⁻¹⁰²² = 2⁻¹⁰²³.
    let difference = black_box(1.5 * f64::MIN_POSITIVE) - black_box(f64::MIN_POSITIVE);
    reads_as_zero | (difference.to_bits() == 0)
}
