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
/// The sum of two subnormal numbers detects both. On many processors a sum with subnormal operands is
/// fast, whereas a subnormal difference of normal numbers, or a product, takes a hundred cycles.
#[inline(always)]
pub(crate) fn flushes_subnormals() -> bool {
    let smallest = black_box(f64::from_bits(1));
    (smallest + smallest).to_bits() == 0
}
