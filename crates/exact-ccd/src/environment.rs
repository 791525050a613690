//! The floating-point environment of a thread.
//!
//! The error bounds of the filters assume the arithmetic that IEEE 754 has by default: results rounded
//! to nearest, and gradual underflow. Processors can be switched, thread by thread, to round up, down or
//! towards zero (`fesetround` in C, as in interval arithmetic), to replace subnormal results by zero (FTZ)
//! and to read subnormal operands as zero (DAZ, which a program linked with `-ffast-math` does at its
//! start). No filter is used then. The exact path converts f64 to integers by their bit patterns, and
//! does not depend on the environment.
//!
//! The environment belongs to the thread that computes. So each entry to the filters tests it: a query, a
//! batch, and each answer that continues from a [`Collision`](crate::Collision), which may have been
//! decided on another thread.

use core::hint::black_box;

/// Returns true if this thread has the default arithmetic of IEEE 754: rounding to nearest with ties to
/// even, and gradual underflow.
///
/// Code that proves a statement by floating-point error bounds calls it on the thread that computes, and
/// decides in another way if it is false. It costs three additions.
///
/// - Rounding. 1 + 2⁻⁵³ and 1 − 2⁻⁵⁴ are ties: each lies in the middle of 1 and an adjacent f64. To nearest
///   with ties to even, both are 1. Upwards, and with ties away from zero, the first one is above 1.
///   Downwards and towards zero, the second one is below 1.
/// - Underflow. The sum of two subnormal numbers is another number if subnormal results become zero, or
///   if subnormal operands are read as zero. On many processors a sum with subnormal operands is fast,
///   whereas a subnormal difference of normal numbers, or a product, takes a hundred cycles.
///
/// The compiler assumes the default environment: the operands are hidden from it. Bits are compared,
/// because a comparison of numbers may read subnormal ones as zero.
///
/// ```
/// assert!(exact_ccd::environment::is_default());
/// ```
#[must_use]
#[inline(always)]
pub fn is_default() -> bool {
    let [one, smallest] = [black_box(1.0_f64), black_box(f64::from_bits(1))];
    let [above, below] = [one + f64::EPSILON / 2.0, one - f64::EPSILON / 4.0];
    let is_to_nearest = above.to_bits() == below.to_bits();
    let is_gradual = (smallest + smallest).to_bits() == 2;
    is_to_nearest & is_gradual
}
